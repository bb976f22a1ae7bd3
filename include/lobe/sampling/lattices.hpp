// Lattices in the unit square, from multiples of irrational numbers. Every coordinate is in [0,1), whatever the index.
#pragma once

#include <lobe/sampling/points.hpp>

namespace lobe {

/// Point i of the R2 sequence: (i + 1/2) (1/g, 1/g^2) modulo 1, g = 1.3247... the root of g^3 = g + 1. Roberts 2018,
/// "The Unreasonable Effectiveness of Quasirandom Sequences". Any number of points, from 0 on, is even.
/// Domain: every 32-bit i. Error: 2^-24 in float, 2^-31 in double.
template <scalar T = float>
constexpr vec2<T> r2(std::uint32_t i) {
    return {detail::multiple_of<T>(0xc13fa9a902a6328fu, i), detail::multiple_of<T>(0x91e10da5c79e7b1du, i)};
}

/// Point i of n of the Fibonacci lattice: ((i + 1/2)/n, (i + 1/2)/phi modulo 1), phi = (1 + sqrt(5))/2. Any n; where n
/// is Fibonacci's F_k, it is his rank-1 lattice (1, F_(k-1))/n to within 1/n (Niederreiter 1992, "Random Number
/// Generation and Quasi-Monte Carlo Methods", section 5.1).
/// Domain: i < n. Error: 2^-24 in float, 2^-31 in double.
template <scalar T = float>
constexpr vec2<T> fibonacci(std::uint32_t i, std::uint32_t n) {
    return {detail::multiple_of<T>(~std::uint64_t{0} / n, i), detail::multiple_of<T>(0x9e3779b97f4a7c15u, i)};
}

}  // namespace lobe
