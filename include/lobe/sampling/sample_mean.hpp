// Means over samples, with the standard error that independent rounds show.
#pragma once

#include <lobe/core/spectrum.hpp>
#include <lobe/sampling/points.hpp>

#include <cassert>
#include <type_traits>

namespace lobe {

namespace detail {

/// Well mixed bits of x: the finaliser of splitmix64 (Steele, Lea, Flood 2014).
constexpr std::uint64_t mixed_bits(std::uint64_t x) {
    x += 0x9e3779b97f4a7c15u;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
}

/// A seed for the draws k of a round, well mixed.
constexpr std::uint64_t seed_of(std::uint64_t seed, std::uint32_t round, std::uint32_t k) {
    return mixed_bits(mixed_bits(seed) + (std::uint64_t{k} << 32) + round);
}

}  // namespace detail

/// How many samples: `count` in each of `rounds`, which are independent of each other.
struct sample_counts {
    std::uint32_t count, rounds;
};

/// The Hammersley set of `count` points, in `rounds` copies, each shifted around the unit square by two random numbers
/// of its own (Cranley & Patterson 1976). Each point is uniform, so means are unbiased; the points of a round spread
/// evenly; rounds are independent, so their spread tells the error.
/// Called with (round, i, k): k tells the draws of one sample apart, each k has shifts of its own.
template <scalar T = float>
class shifted_hammersley : public sample_counts {
public:
    constexpr explicit shifted_hammersley(std::uint32_t points_a_round, std::uint32_t number_of_rounds = 32,
                                          std::uint64_t random_seed = 0)
        : sample_counts{points_a_round, number_of_rounds}, seed(random_seed) {}

    constexpr vec2<T> operator()(std::uint32_t round, std::uint32_t i, std::uint32_t k = 0) const {
        const std::uint64_t bits = detail::seed_of(seed, round, k);
        const vec2<T> u = hammersley<T>(i, count);
        return {shifted(u.x, static_cast<std::uint32_t>(bits >> 32)), shifted(u.y, static_cast<std::uint32_t>(bits))};
    }

private:
    static constexpr T shifted(const T& x, std::uint32_t shift) {
        const T sum = x + detail::fraction<T>(shift);
        return select(sum < T(1), sum, sum - T(1));
    }

    std::uint64_t seed;
};

/// A mean over samples and its standard error, component by component. Converts to the value.
template <class S>
struct sampled {
    S value, standard_error;
    constexpr operator const S&() const { return value; }
};

/// The mean of g(round, i) over all samples. Its standard error is sqrt(sum (x - mean)^2/(rounds (rounds - 1))),
/// x the mean of a round: right for any points whose rounds are independent,
/// where the spread of single samples would overstate the error of points that are spread evenly.
/// It is itself known to 1/sqrt(2 rounds - 2) of it: 13 % at 32. g returns a number or an rgb. At least 2 rounds.
template <class G>
constexpr auto sample_mean(const sample_counts& samples, const G& g) {
    using S = std::decay_t<decltype(g(0u, 0u))>;
    using W = detail::wide_t<S>;
    using N = component_t<W>;
    assert(samples.count > 0 && samples.rounds > 1 && "sample_mean: at least one sample, and two rounds");
    W mean(N(0)), squares(N(0));
    for (std::uint32_t round = 0; round < samples.rounds; ++round) {
        W total(N(0));
        for (std::uint32_t i = 0; i < samples.count; ++i) total = total + W(g(round, i));
        // Welford 1962: no difference of large sums
        const W off = total * (N(1) / N(samples.count)) - mean;
        mean = mean + off * (N(1) / N(round + 1));
        squares = squares + off * off * (N(round) / N(round + 1));
    }
    const N scale = N(1) / (N(samples.rounds) * N(samples.rounds - 1));
    const auto root = [](const N& x) {
        using std::sqrt;
        return sqrt(x);
    };
    return sampled<S>{S(mean), S(detail::by_component(root, W(squares * scale)))};
}

}  // namespace lobe
