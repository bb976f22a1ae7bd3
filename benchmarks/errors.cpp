#include "errors.hpp"

#include <algorithm>
#include <span>

namespace {

using truth::real;

real distance(unit_of_error unit, real x, real exact) {
    const real d = std::isnan(x) ? std::numeric_limits<real>::infinity() : std::abs(x - exact);
    switch (unit) {
        case unit_of_error::relative: return d == 0 ? 0 : d / std::abs(exact);
        case unit_of_error::weight: return d / std::max(real(1), std::abs(exact));
        default: return d;
    }
}

}  // namespace

error_summary error_of(const metric& m, exact_result exact, const inputs& in, const float* result) {
    if (m.unit == unit_of_error::points_at_1) {
        double points = 0;
        for (std::size_t i = 0; i < count; ++i) {
            bool at_1 = false;
            for (std::size_t k = m.first; k < m.first + m.size; ++k) at_1 |= !(result[k * stride + i] < 1);
            points += at_1;
        }
        return {std::numeric_limits<double>::quiet_NaN(), points};
    }
    std::vector<double> errors;
    for (std::size_t i = 0; i < count; ++i) {
        real components[9] = {};
        exact(in, i, components);
        if (std::ranges::any_of(components, [](real x) { return std::isnan(x); })) continue;
        real largest = 0, squares = 0;
        for (std::size_t k = m.first; k < m.first + m.size; ++k) {
            const real d = distance(m.unit, result[k * stride + i], components[k]);
            largest = std::max(largest, d);
            squares += d * d;
        }
        errors.push_back(static_cast<double>(m.unit == unit_of_error::direction ? std::sqrt(squares) / in.a[i] : largest));
    }
    if (errors.empty()) return {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN()};
    std::ranges::sort(errors);
    return {errors[errors.size() / 2], errors.back()};
}
