// Sobol' points of the unit square, plain and scrambled. Every coordinate is in [0,1), whatever the index.
#pragma once

#include <lobe/sampling/sample_mean.hpp>

namespace lobe {

namespace detail {

/// Pascal's triangle modulo 2 times the bits of i: bit k of the result is the sum of the bits j of i whose index, in
/// binary, has all of k's digits (Lucas 1878). It is what the second coordinate of Sobol's points mirrors. Steps of 1,
/// 2, 4, 8, 16: Ahmed 2024, "An Implementation Algorithm of 2D Sobol Sequence Fast, Elegant, and Compact".
constexpr std::uint32_t times_pascal(std::uint32_t i) {
    i ^= (i >> 1) & 0x55555555u;
    i ^= (i >> 2) & 0x33333333u;
    i ^= (i >> 4) & 0x0f0f0f0fu;
    i ^= (i >> 8) & 0x00ff00ffu;
    return i ^ (i >> 16);
}

/// Owen's scrambling of a number whose digits stand in reverse: each bit is flipped, or not, by a hash of the bits
/// below it and of the seed. Laine & Karras 2011, "Stratified Sampling for Stochastic Transparency"; constants and
/// order of Vegdahl 2021, "Building a Better LK Hash". Seeds have to be well mixed.
constexpr std::uint32_t scrambled_from_below(std::uint32_t bits, std::uint32_t seed) {
    bits ^= bits * 0x3d20adeau;
    bits += seed;
    bits *= (seed >> 16) | 1u;
    bits ^= bits * 0x05526c56u;
    return bits ^ (bits * 0x53a22864u);
}

}  // namespace detail

/// Point i of Sobol's sequence, its first two dimensions. (Sobol' 1967; a (0,2)-sequence: each 2^m points from a
/// multiple of 2^m have one point in every box of area 2^-m and sides that are powers of 2.)
/// Starts at (0,0), so that means are biased: `scrambled_sobol` are not.
/// Domain: every 32-bit i. Error: exact in double, truncated to 24 bits in float.
template <scalar T = float>
constexpr vec2<T> sobol(std::uint32_t i) {
    return {detail::fraction<T>(detail::reverse_bits(i)),
            detail::fraction<T>(detail::reverse_bits(detail::times_pascal(i)))};
}

/// Point i of Sobol's sequence, scrambled by `seed`: Owen 1995, "Randomly Permuted (t,m,s)-Nets and (t,s)-Sequences",
/// by hashing, as in Burley 2020, "Practical Hash-based Owen Scrambling". As even as `sobol`, each point uniform over
/// seeds, and 2^m points err by 2^(-3m/2) on smooth integrands.
/// Domain: every 32-bit i, every seed. In float truncated to 24 bits.
template <scalar T = float>
constexpr vec2<T> owen_sobol(std::uint32_t i, std::uint64_t seed) {
    const std::uint64_t keys = detail::mixed_bits(seed);  // the same for all points: loops hoist it
    const auto x = static_cast<std::uint32_t>(keys), y = static_cast<std::uint32_t>(keys >> 32);
    return {detail::fraction<T>(detail::reverse_bits(detail::scrambled_from_below(i, x))),
            detail::fraction<T>(detail::reverse_bits(detail::scrambled_from_below(detail::times_pascal(i), y)))};
}

/// The first `count` points of `owen_sobol`, scrambled anew in each of `rounds`. Each point is uniform, so means are
/// unbiased; rounds are independent, so their spread tells the error. Best where count is a power of 2.
/// Called with (round, i, k): k tells the draws of one sample apart. Each k has scrambles and an order of its own, so
/// that draws of one sample are not correlated (Burley 2020, section 3).
template <scalar T = float>
class scrambled_sobol : public sample_counts {
public:
    constexpr explicit scrambled_sobol(std::uint32_t points_a_round, std::uint32_t number_of_rounds = 32,
                                       std::uint64_t random_seed = 0)
        : sample_counts{points_a_round, number_of_rounds}, seed(random_seed) {}

    // (Inlined by force: clang would call it, and a loop with a call does not vectorise.)
    [[gnu::always_inline]] constexpr vec2<T> operator()(std::uint32_t round, std::uint32_t i,
                                                        std::uint32_t k = 0) const {
        const std::uint64_t key = detail::seed_of(seed, round, k);
        const auto order = static_cast<std::uint32_t>(key >> 32);
        // permutes the first 2^m indices among themselves, but for bits above m that all of them share
        const std::uint32_t j = detail::reverse_bits(detail::scrambled_from_below(detail::reverse_bits(i), order));
        return owen_sobol<T>(j, key);
    }

private:
    std::uint64_t seed;
};

}  // namespace lobe
