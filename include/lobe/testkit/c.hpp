// The functions of <lobe/testkit/c.h>: to be included in one file of a program, or of a library.
#pragma once

#include <lobe/testkit/c.h>
#include <lobe/testkit/subject/many_at_once.hpp>
#include <lobe/testkit/verify.hpp>

#include <cstddef>
#include <exception>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

/// A report, and its texts.
struct lobe_report {
    bool passed;
    std::string text, json, junit;
};

namespace lobe::testkit::detail {

inline thread_local std::string error_of_c;

/// A function's status that is not 0 ends what asked for it.
inline void expect_zero(int status, const char* function) {
    if (status != 0) throw std::runtime_error(std::string(function) + " returned " + std::to_string(status));
}

/// As many numbers as a spectrum of unknown size is given; the functions know of `channels`, and the rest is 0.
inline constexpr std::size_t channels_of_c = 16;
inline std::vector<double> padded(const std::vector<double>& values, std::size_t channels) {
    std::vector<double> out(values.size() / channels * channels_of_c);
    for (std::size_t i = 0; i < values.size(); ++i) out[i / channels * channels_of_c + i % channels] = values[i];
    return out;
}

inline array_functions functions_of(const lobe_brdf& brdf) {
    const auto channels = static_cast<std::size_t>(brdf.channels), numbers = static_cast<std::size_t>(brdf.numbers);
    array_functions out;
    out.f_cos = [=](const questions& q, answers& a) {
        std::vector<double> values(q.count() * channels);
        expect_zero(brdf.f_cos(brdf.data, q.count(), q.v.data(), q.w.data(), values.data()), "f_cos");
        a.values = padded(values, channels);
    };
    if (brdf.pdf)
        out.pdf = [=](const questions& q, answers& a) {
            expect_zero(brdf.pdf(brdf.data, q.count(), q.v.data(), q.w.data(), a.pdf.data()), "pdf");
        };
    if (brdf.sample)
        out.sample = [=](const questions& q, answers& a) {
            std::vector<double> u, weight(q.count() * channels);
            for (std::size_t i = 0; i < q.w.size(); ++i)
                if (i % 3 < numbers) u.push_back(q.w[i]);
            expect_zero(
                brdf.sample(brdf.data, q.count(), q.v.data(), u.data(), a.l.data(), weight.data(), a.pdf.data()),
                "sample");
            a.values = padded(weight, channels);
        };
    return out;
}

template <class T>
report verdict_on(const lobe_brdf& brdf, const options& o) {
    many_at_once<T, channels_of_c> all(functions_of(brdf));
    brdf_functions<T, channels_of_c> one = all.one_at_a_time();
    one.numbers = brdf.numbers;
    return verdict_on(one, o);
}

inline options options_of(const lobe_options& c) {
    options o;
    o.effort = c.thorough ? effort::thorough : effort::quick;
    o.seed = c.seed, o.tolerance = c.tolerance, o.name = c.name ? c.name : "";
    o.reciprocal = c.reciprocal != 0, o.lossless = c.lossless != 0, o.isotropic = c.isotropic != 0;
    o.zero_below = c.zero_below != 0, o.transmits = c.transmits != 0, o.eta = c.eta, o.radiance = c.radiance != 0;
    return o;
}

}  // namespace lobe::testkit::detail

extern "C" {

lobe_options lobe_default_options() {
    const lobe::testkit::options o;
    return {.name = nullptr,
            .tolerance = o.tolerance,
            .seed = o.seed,
            .thorough = 0,
            .single_precision = 0,
            .reciprocal = o.reciprocal,
            .lossless = o.lossless,
            .isotropic = 0,
            .zero_below = o.zero_below,
            .transmits = 0,
            .eta = 1,
            .radiance = 1};
}

lobe_report* lobe_verify(const lobe_brdf* brdf, const lobe_options* options) {
    namespace kit = lobe::testkit;
    try {
        if (!brdf || !brdf->f_cos) throw std::invalid_argument("there is no f_cos");
        if (brdf->channels < 1 || brdf->channels > 16) throw std::invalid_argument("channels: 1 to 16");
        if (brdf->numbers < 2 || brdf->numbers > 3) throw std::invalid_argument("numbers of u: 2 or 3");
        const lobe_options c = options ? *options : lobe_default_options();
        const kit::options o = kit::detail::options_of(c);
        const kit::report r =
            c.single_precision ? kit::detail::verdict_on<float>(*brdf, o) : kit::detail::verdict_on<double>(*brdf, o);
        return std::make_unique<lobe_report>(lobe_report{r.passed(), r.text(), r.json(), r.junit()}).release();
    } catch (const std::exception& e) {
        kit::detail::error_of_c = e.what();
    } catch (...) {
        kit::detail::error_of_c = "an exception that is no std::exception";
    }
    return nullptr;
}

int lobe_passed(const lobe_report* report) { return report->passed; }
const char* lobe_text(const lobe_report* report) { return report->text.c_str(); }
const char* lobe_json(const lobe_report* report) { return report->json.c_str(); }
const char* lobe_junit(const lobe_report* report) { return report->junit.c_str(); }
void lobe_free(lobe_report* report) { delete report; }
const char* lobe_error() { return lobe::testkit::detail::error_of_c.c_str(); }

}  // extern "C"
