// Fifty digits, and how far float and double are from them.
#pragma once

#include "../support.hpp"

#include <boost/multiprecision/cpp_bin_float.hpp>

using digits50 = boost::multiprecision::cpp_bin_float_50;

template <class T>
lobe::vec3<digits50> exact(const lobe::vec3<T>& w) {
    return {digits50(w.x), digits50(w.y), digits50(w.z)};
}

/// |value - truth| in units of the last place at `scale`, which is the truth unless the formula is stated to cancel.
template <class T>
double ulps(const T& value, const digits50& truth, const digits50& scale) {
    int exponent = 0;
    std::frexp(static_cast<double>(scale), &exponent);
    return static_cast<double>(abs(digits50(value) - truth) /
                               digits50(std::ldexp(1.0, exponent - std::numeric_limits<T>::digits)));
}
template <class T>
double ulps(const T& value, const digits50& truth) {
    return ulps(value, truth, truth);
}
