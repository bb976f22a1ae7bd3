#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

/// Well mixed bits of x, for seeds: the finaliser of splitmix64 (Steele, Lea, Flood 2014).
inline std::uint64_t mixed_bits(std::uint64_t x) {
    x += 0x9e3779b97f4a7c15u;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
}

/// The uniform numbers of one batch of samples: a callable, as lobe::random_walk takes it. The first seven numbers of
/// sample 0, 1, 2... are an additive recurrence (Roberts 2018: the powers of 1/g, g^8 = g + 1) with a random shift of
/// its own, so that the samples of a batch spread evenly and different batches are independent; what follows is PCG32
/// (O'Neill 2014).
class sample_stream {
public:
    explicit sample_stream(std::uint64_t seed) : state(mixed_bits(seed)) {
        for (auto& x : point) x = pcg32();
    }

    void next_sample() {
        for (std::size_t i = 0; i < point.size(); ++i) point[i] += steps[i];
        used = 0;
    }

    float operator()() {
        const std::uint32_t bits = used < point.size() ? point[used++] : pcg32();
        return static_cast<float>(bits >> 8) * 0x1p-24f;
    }

private:
    static constexpr std::array<std::uint32_t, 7> steps{0xe95e1dd1u, 0xd4bc74e1u, 0xc1edbc5bu, 0xb0c8ac50u,
                                                        0xa127a31cu, 0x92e852c8u, 0x85eb75c3u};
    std::array<std::uint32_t, 7> point{};
    std::size_t used = 0;
    std::uint64_t state;

    std::uint32_t pcg32() {
        const std::uint64_t old = state;
        state = old * 6364136223846793005u + 1442695040888963407u;
        const auto shifted = static_cast<std::uint32_t>(((old >> 18) ^ old) >> 27);
        const auto turn = static_cast<std::uint32_t>(old >> 59);
        return (shifted >> turn) | (shifted << ((32 - turn) & 31));
    }
};
