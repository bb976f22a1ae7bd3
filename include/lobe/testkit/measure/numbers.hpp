// What kind of number it is, read off the bits: -ffast-math lets a compiler assume that there is no NaN and no
// infinity, and then no comparison finds one.
#pragma once

#include <lobe/core/cpp20.hpp>

#include <bit>
#include <cstdint>

namespace lobe::testkit::detail {

/// Neither NaN nor infinite. (Through memory: a compiler that assumes finite numbers may carry that over to their
/// bits.)
inline bool is_finite(double x) {
    const volatile double stored = x;
    constexpr std::uint64_t exponent = 0x7ff0'0000'0000'0000u;
    return (std::bit_cast<std::uint64_t>(static_cast<double>(stored)) & exponent) != exponent;
}
inline bool is_nan(double x) {
    const volatile double stored = x;
    constexpr std::uint64_t infinity = 0x7ff0'0000'0000'0000u;
    return (std::bit_cast<std::uint64_t>(static_cast<double>(stored)) << 1) > (infinity << 1);
}
inline bool is_negative(double x) {
    const volatile double stored = x;
    return (std::bit_cast<std::uint64_t>(static_cast<double>(stored)) >> 63) != 0;
}

/// The number that the kit computes with in the place of x: 0 for what is none, and no larger than what it can square
/// and add up.
inline double computable(double x) {
    constexpr double most = 1e75;
    return !is_finite(x) ? 0 : x > most ? most : x < -most ? -most : x;
}

}  // namespace lobe::testkit::detail
