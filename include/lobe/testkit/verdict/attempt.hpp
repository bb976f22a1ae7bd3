// A report's first line, and its last resort: options that make no sense, and functions that throw.
#pragma once

#include <lobe/testkit/measure/numbers.hpp>
#include <lobe/testkit/options.hpp>
#include <lobe/testkit/verdict/report.hpp>

#include <exception>
#include <functional>
#include <string>

namespace lobe::testkit {

namespace id {
inline constexpr property_id tolerance{"tolerance", "options.tolerance is above 0, and a number"};
inline constexpr property_id eta{"eta", "options.eta is above 0, and a number"};
inline constexpr property_id few_numbers{"few_numbers", "a spectrum has at most 16 numbers"};
inline constexpr property_id no_exception{"no_exception", "no exception"};
}  // namespace id

namespace detail {

/// A report, already failed where the options make no sense.
inline report opened(const options& o) {
    report r(o.name);
    if (!is_finite(o.tolerance) || !(o.tolerance > 0))
        r.add(id::tolerance,
              {.passed = false,
               .measured = o.tolerance,
               .expected = 2e-3,
               .meaning = "it is the relative error that counts; with this one nothing can be verified"});
    if (const double eta = o.eta.value_or(1); !is_finite(eta) || !(eta > 0))
        r.add(id::eta, {.passed = false,
                        .measured = eta,
                        .expected = 1.5,
                        .meaning = "it is the index below the surface over the index above"});
    return r;
}

/// A spectrum of run-time size is read up to its 16th number: what is beyond has not been verified.
inline void report_length(report& r, std::size_t longest) {
    if (longest > 16)
        r.add(id::few_numbers, {.passed = false,
                                .measured = static_cast<double>(longest),
                                .expected = 16,
                                .meaning = "those beyond the 16th are not verified: return a std::array, whose size is "
                                           "known, or verify 16 at a time"});
}

/// A function that throws ends one part of the verdict, not the verdict. where(): the input that it was asked for.
/// Without exceptions (-fno-exceptions) there is nothing to catch.
inline void attempt([[maybe_unused]] report& r, [[maybe_unused]] const std::function<std::string()>& where,
                    const std::function<void()>& part) {
#if defined(__cpp_exceptions) || defined(_CPPUNWIND)
    const auto threw = [&](const std::string& what) {
        r.add(id::no_exception, {.passed = false, .measured = 1, .input = where(), .meaning = "it threw" + what});
    };
    try {
        part();
    } catch (const std::exception& e) {
        threw(std::string(": ") + e.what());
    } catch (...) {
        threw(" something that is no std::exception");
    }
#else
    part();
#endif
}

}  // namespace detail

}  // namespace lobe::testkit
