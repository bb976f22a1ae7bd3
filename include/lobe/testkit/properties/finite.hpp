// Every value of every call is a number, is not negative, and is zero below the horizon.
#pragma once

#include <lobe/testkit/subject/watch.hpp>
#include <lobe/testkit/verdict/property.hpp>
#include <lobe/testkit/verdict/stray_samples.hpp>

#include <algorithm>
#include <string>

namespace lobe::testkit {

namespace id {
/// What the values of one function are asked for.
struct of_values {
    property_id finite, not_negative, vanishes_below;
};
inline constexpr of_values f_cos{{"f_cos_finite", "f_cos is finite"},
                                 {"f_cos_not_negative", "f_cos is not negative"},
                                 {"f_cos_vanishes_below", "f_cos vanishes below"}};
inline constexpr of_values pdf{{"pdf_finite", "pdf is finite"}, {"pdf_not_negative", "pdf is not negative"}, {}};
inline constexpr of_values sample{{"sample_finite", "sample is finite"},
                                  {"sample_not_negative", "sample is not negative"},
                                  {"sample_vanishes_below", "sample vanishes below"}};
inline constexpr property_id f_cos_not_0{"f_cos_not_always_0", "f_cos is not always 0"};
inline constexpr property_id unit_samples{"unit_samples", "sampled directions are unit"};
inline constexpr property_id no_light_without_density{"no_light_without_density", "no light without a density"};
}  // namespace id

namespace detail {

/// Without a sentence for it, a function may be anything below the horizon.
template <class T>
void report_values(report& r, const watch<T>& seen, const id::of_values& of, const std::string& why_below = "") {
    const auto share = [&](long n) {
        return " (" + percent(static_cast<double>(n) / static_cast<double>((std::max)(seen.calls, 1L))) +
               " of the calls)";
    };
    const auto add = [&](const property_id& property, const typename watch<T>::fault& f, const std::string& meaning) {
        r.add(property, {.passed = f.count == 0,
                         .measured = f.value,
                         .input = f.count ? f.at.text() : "",
                         .meaning = f.count ? meaning : ""});
    };
    const auto extent = [&](const typename watch<T>::fault& f) {
        constexpr const char* where[] = {", below the horizon alone", ", at extremes alone", ", at grazing",
                                         ", at everyday directions"};
        return std::string(f.harm < 0 ? "" : where[f.harm]) + share(f.count);
    };
    add(of.finite, seen.not_finite,
        seen.not_finite.count == seen.calls ? "every value is NaN or infinite"
        : seen.not_finite.harm == 0
            ? "0/0 where v + l is 0, or the root or power of a cosine below 0: return 0 before" +
                  extent(seen.not_finite)
            : "a 0/0, an overflow, or the root or power of a negative number" + extent(seen.not_finite));
    add(of.not_negative, seen.negative,
        "a cosine that is not clamped or checked, or a weight that turns negative" + extent(seen.negative));
    if (!of.vanishes_below.key.empty()) add(of.vanishes_below, seen.below, why_below + share(seen.below.count));
}

template <class T, std::size_t N>
class values_of_f : public brdf_property<T, N> {
public:
    using brdf_property<T, N>::brdf_property;
    void report_to(report& r) override {
        const double largest = this->b.largest;
        if (this->b.of_f.not_finite.count < this->b.of_f.calls)
            r.add(id::f_cos_not_0,
                  {.passed = largest > 0,
                   .measured = largest,
                   .expected = largest,
                   .meaning = "the BRDF returned 0 for every pair of directions: nothing can be verified"});
        report_values(
            r, this->b.of_f, id::f_cos,
            this->b.seems_to_transmit()
                ? seems_to_transmit
                : "light from below the horizon is reflected: the sign of a cosine is lost (abs) or never looked at");
    }
};

template <class T, std::size_t N>
class values_of_sampling : public brdf_property<T, N> {
public:
    using brdf_property<T, N>::brdf_property;
    void report_to(report& r) override {
        const subject<T, N>& brdf = this->b;
        if (brdf.has_pdf()) report_values(r, brdf.of_pdf, id::pdf);
        if (!brdf.has_sample()) return;
        report_values(r, brdf.of_sample, id::sample,
                      brdf.seems_to_transmit() ? seems_to_transmit
                      : brdf.most_samples_are_lost()
                          ? most_are_lost
                          : "a sample below the horizon carries light: its weight must be 0");
        r.add(id::unit_samples,
              {.passed = brdf.lengths.holds(),
               .measured = brdf.lengths.worst,
               .expected = 1,
               .tolerance = brdf.lengths.tolerance,
               .input = brdf.lengths.holds() ? "" : brdf.lengths.at.text(),
               .meaning = "a half vector that is not normalised, or a basis that is not orthonormal"});
        r.add(id::no_light_without_density,
              {.passed = brdf.light_without_pdf == 0,
               .measured = static_cast<double>(brdf.light_without_pdf),
               .input = brdf.light_without_pdf ? brdf.light_place.text() : "",
               .meaning =
                   brdf.largest > 0
                       ? "a sample with pdf 0 has failed: its weight must be 0"
                       : "pdf is 0 and the weight is not: a perfect mirror, whose f_cos is a delta that no density "
                         "describes; verify it with a small roughness, or leave it out"});
    }
};

}  // namespace detail

}  // namespace lobe::testkit
