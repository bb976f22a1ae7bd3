// Low-discrepancy points of the unit square. Every coordinate is in [0,1), whatever the index.
#pragma once

#include <lobe/core/vector.hpp>

#include <cstdint>

namespace lobe {

namespace detail {

/// bits / 2^32, kept below 1: in float the last 128 codes would round to 1.
template <scalar T>
constexpr T fraction(std::uint32_t bits) {
    if constexpr (std::same_as<T, float>)
        return static_cast<float>(static_cast<std::int32_t>(bits >> 8)) * 0x1p-24f;  // signed: what SIMD converts
    else
        return T(bits) / T(4294967296.0);
}

constexpr std::uint32_t reverse_bits(std::uint32_t i) {
    i = (i << 16) | (i >> 16);
    i = ((i & 0x00ff00ffu) << 8) | ((i & 0xff00ff00u) >> 8);
    i = ((i & 0x0f0f0f0fu) << 4) | ((i & 0xf0f0f0f0u) >> 4);
    i = ((i & 0x33333333u) << 2) | ((i & 0xccccccccu) >> 2);
    return ((i & 0x55555555u) << 1) | ((i & 0xaaaaaaaau) >> 1);
}

/// (i + 1/2) step/2^64 without its whole part: in integers, so that large i lose nothing.
template <scalar T>
constexpr T multiple_of(std::uint64_t step, std::uint32_t i) {
    return fraction<T>(static_cast<std::uint32_t>((i * step + step / 2) >> 32));
}

}  // namespace detail

/// Van der Corput's radical inverse in base 2: the bits of i mirrored at the binary point (van der Corput 1935).
/// Domain: every 32-bit i; the result is in [0,1). Error: exact in double, truncated to 24 bits in float.
template <scalar T = float>
constexpr T radical_inverse(std::uint32_t i) {
    return detail::fraction<T>(detail::reverse_bits(i));
}

/// Point i of n of the Hammersley set, moved half a step off the origin: ((i + 1/2)/n, radical_inverse(i) + 1/(2n)).
/// (Hammersley 1960. The set that starts at (0,0) is biased: 4e-4 of a split-sum term at n = 1024, this one 2e-5.)
/// Domain: i < n. Error: 2^-24 in float, 2^-31 in double; both coordinates are below 1 for every n.
template <scalar T = float>
constexpr vec2<T> hammersley(std::uint32_t i, std::uint32_t n) {
    // 2^64/n: the same for all points, so compilers hoist the division
    const std::uint64_t step = ~std::uint64_t{0} / n;
    return {detail::multiple_of<T>(step, i),
            detail::fraction<T>(detail::reverse_bits(i) + static_cast<std::uint32_t>(step >> 33))};
}

}  // namespace lobe
