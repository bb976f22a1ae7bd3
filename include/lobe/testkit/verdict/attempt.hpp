// A report's first line, and its last resort: options that make no sense, and functions that throw.
#pragma once

#include <lobe/testkit/options.hpp>
#include <lobe/testkit/verdict/report.hpp>

#include <cmath>
#include <exception>
#include <functional>
#include <string>

namespace lobe::testkit {

namespace id {
inline constexpr property_id tolerance{"tolerance", "options.tolerance is above 0, and a number"};
inline constexpr property_id no_exception{"no_exception", "no exception"};
}  // namespace id

namespace detail {

/// A report, already failed where the options make no sense.
inline report opened(const options& o) {
    report r(o.name);
    if (!(o.tolerance > 0 && std::isfinite(o.tolerance)))
        r.add(id::tolerance,
              {.passed = false,
               .measured = o.tolerance,
               .expected = 2e-3,
               .meaning = "it is the relative error that counts; with this one nothing can be verified"});
    return r;
}

/// A function that throws ends one part of the verdict, not the verdict. where(): the input that it was asked for.
inline void attempt(report& r, const std::function<std::string()>& where, const std::function<void()>& part) {
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
}

}  // namespace detail

}  // namespace lobe::testkit
