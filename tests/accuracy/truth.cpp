// Compiled without any of the flags.
#include "evaluate.hpp"
#include "rows.hpp"

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <cmath>
#include <limits>

namespace accuracy {

namespace {

using digits50 = boost::multiprecision::cpp_bin_float_50;

constexpr double out_of_range = -1, infinity = std::numeric_limits<double>::infinity();

/// 1 + a |Sv| |S^-1 m|^2/(2 v.m) = 1 + a/|S (c + Sv/|Sv|)|: a visible normal has the direction of S (c + Sv/|Sv|) with
/// c on the sphere, which nearly cancel where facets close; what rounds there is stretched by a at most.
double conditioning_of_seen(const digits50* x, const vec3<digits50>& m) {
    const vec3<digits50> v = at(x + 4), wide{x[0] * v.x, x[1] * v.y, v.z}, narrow{m.x / x[0], m.y / x[1], m.z};
    const digits50 a = lobe::larger(x[0], x[1]);
    return 1 + static_cast<double>(a * lobe::length(wide) * lobe::dot(narrow, narrow) / (2 * lobe::dot(v, m)));
}

/// The angle; infinite for what is not unit to 16 units of the last place.
template <class T>
double angle(const vec3<digits50>& w, const vec3<digits50>& truth) {
    const double size = static_cast<double>(lobe::length(w));
    if (!(std::abs(size - 1) <= 16 * std::numeric_limits<T>::epsilon())) return infinity;
    return static_cast<double>(atan2(lobe::length(lobe::cross(w, truth)), lobe::dot(w, truth)));
}

/// In units of the last place of a number like `scale`.
template <class T>
double in_ulp(const digits50& off, const digits50& scale) {
    constexpr int digits = std::numeric_limits<T>::digits, lowest = std::numeric_limits<T>::min_exponent;
    int exponent = lowest;  // of [1/2, 1)
    if (scale != 0) frexp(scale, &exponent);
    return static_cast<double>(ldexp(abs(off), digits - std::max(exponent, lowest)));
}

template <class T>
double error(int row, const double* x, const result& of) {
    static const auto all = rows<digits50>();
    const auto& r = all[static_cast<std::size_t>(row)];
    for (const double component : of)
        if (!std::isfinite(component)) return infinity;
    digits50 in[8];
    for (int i = 0; i < 8; ++i) in[i] = x[i];
    if (r.direction) {
        const vec3<digits50> truth = r.direction(in), w{of[0], of[1], of[2]};
        if (r.in == unit::radius) return static_cast<double>(lobe::length(w - truth));
        return angle<T>(w, truth) / (r.in == unit::radian_seen ? conditioning_of_seen(in, truth) : 1);
    }
    const digits50 truth = r.value(in), off = of[0] - truth;
    if (r.in == unit::ulp) return in_ulp<T>(off, truth);
    if (r.in == unit::ulp_of_1) return in_ulp<T>(off, 1);
    // D of the surface of width 1 may underflow
    const digits50 share = truth * in[0] * in[1], least = std::numeric_limits<T>::min();
    if (share < least) return of[0] >= 0 && of[0] * in[0] * in[1] <= 2 * least ? out_of_range : infinity;
    digits50 power = share * lobe::pi<digits50>();
    if (r.in == unit::ulp_of_power) {
        const vec3<digits50> m = at(in + 2);
        const digits50 cos2 = m.z * m.z / lobe::dot(m, m);
        power *= cos2 * cos2;
    }
    return in_ulp<T>(off, truth) / (1 + std::abs(static_cast<double>(log(power))));
}

}  // namespace

double error_of_float(int row, const double* x, const result& of) { return error<float>(row, x, of); }
double error_of_double(int row, const double* x, const result& of) { return error<double>(row, x, of); }

void sweep_errors(int function, const float* u, const float* values, double* errors, std::size_t n) {
    const auto r = functions_of_one_number<double>()[static_cast<std::size_t>(function)];
    for (std::size_t i = 0; i < n; ++i) {
        const double x = static_cast<double>(u[i]), truth = r.value(&x);
        int exponent = r.in == unit::ulp ? -125 : 1;
        if (r.in == unit::ulp && truth != 0) std::frexp(truth, &exponent);
        errors[i] = std::abs(static_cast<double>(values[i]) - truth) / std::ldexp(1.0, std::max(exponent, -125) - 24);
        if (!std::isfinite(errors[i])) errors[i] = infinity;
    }
}

}  // namespace accuracy
