// Compiled without any of the flags.
#include "evaluate.hpp"
#include "rows.hpp"

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <cmath>
#include <limits>

namespace accuracy {

namespace {

using digits50 = boost::multiprecision::cpp_bin_float_50;

template <class T>
double error(int row, const double* x, const result& of) {
    static const auto all = rows<digits50>();
    const auto& r = all[static_cast<std::size_t>(row)];
    digits50 in[8];
    for (int i = 0; i < 8; ++i) in[i] = x[i];
    if (r.direction) {
        const vec3<digits50> truth = r.direction(in), w{of[0], of[1], of[2]};
        if (r.in == unit::radius) return static_cast<double>(lobe::length(w - truth));
        return static_cast<double>(atan2(lobe::length(lobe::cross(w, truth)), lobe::dot(w, truth)));
    }
    const digits50 truth = r.value(in);
    int exponent = 0;  // of [1/2, 1)
    if (r.in != unit::ulp_of_1) frexp(truth, &exponent);
    constexpr int digits = std::numeric_limits<T>::digits, lowest = std::numeric_limits<T>::min_exponent;
    const digits50 off = of[0] - truth;
    double conditioning = 1;
    if (r.in == unit::ulp_of_exponential) {
        if (truth * in[0] * in[1] < std::numeric_limits<T>::min()) return 0;  // the tail underflows
        conditioning += std::abs(static_cast<double>(log(truth * lobe::pi<digits50>() * in[0] * in[1])));
    }
    return static_cast<double>(ldexp(abs(off), digits - std::max(exponent, lowest))) / conditioning;
}

}  // namespace

double error_of_float(int row, const double* x, const result& of) { return error<float>(row, x, of); }
double error_of_double(int row, const double* x, const result& of) { return error<double>(row, x, of); }

void sweep_errors(int function, const float* u, const float* values, double* errors, std::size_t n) {
    const auto r = functions_of_one_number<double>()[static_cast<std::size_t>(function)];
    for (std::size_t i = 0; i < n; ++i) {
        const double x = static_cast<double>(u[i]), truth = r.value(&x);
        int exponent = 0;
        if (r.in == unit::ulp) std::frexp(truth, &exponent);
        errors[i] = std::abs(static_cast<double>(values[i]) - truth) / std::ldexp(1.0, std::max(exponent, -125) - 24);
    }
}

}  // namespace accuracy
