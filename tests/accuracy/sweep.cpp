// Every float of [0,1], or every n-th: sweep [n]. Prints name | points | worst | mean | bound | worst input; exit 1 if
// a bound is exceeded. Also the radical inverse of every (n-th) 32-bit index, exact to its 24 bits and below 1.
#include "evaluate.hpp"
#include "rows.hpp"

#include <lobe/sampling/points.hpp>

#include <bit>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <thread>

namespace {

struct found {
    double worst = 0, sum = 0;
    float at = 0;
    long points = 0;
};

found sweep(int function, std::uint32_t first, std::uint32_t last, std::uint32_t stride) {
    constexpr std::size_t block = 4096;
    std::vector<float> u(block), values(block);
    std::vector<double> errors(block);
    found all;
    for (std::uint64_t bits = first; bits <= last;) {
        std::size_t n = 0;
        for (; n < block && bits <= last; ++n, bits += stride)
            u[n] = std::bit_cast<float>(static_cast<std::uint32_t>(bits));
        accuracy::sweep_values(function, u.data(), values.data(), n);
        accuracy::sweep_errors(function, u.data(), values.data(), errors.data(), n);
        for (std::size_t i = 0; i < n; ++i) {
            all.sum += errors[i];
            if (errors[i] > all.worst) all.worst = errors[i], all.at = u[i];  // never a NaN
        }
        all.points += static_cast<long>(n);
    }
    return all;
}

}  // namespace

int main(int argc, char** argv) {
    const std::uint32_t stride = argc > 1 ? static_cast<std::uint32_t>(std::atol(argv[1])) : 1;
    if (stride == 0) return std::fprintf(stderr, "usage: sweep [every n-th float]\n"), 2;
    const std::uint32_t one = std::bit_cast<std::uint32_t>(1.0f),
                        middle = std::bit_cast<std::uint32_t>(0x1p-63f) / stride * stride;
    const auto functions = accuracy::functions_of_one_number<float>();
    int failed = 0;
    for (std::size_t f = 0; f < functions.size(); ++f) {
        found low, high;
        std::thread other([&] { low = sweep(static_cast<int>(f), 0, middle - 1, stride); });
        high = sweep(static_cast<int>(f), middle, one, stride);
        other.join();
        const found& worse = low.worst > high.worst ? low : high;
        const long points = low.points + high.points;
        std::printf("%s | %ld | %.3g | %.2g | %g | %.9g\n", functions[f].name, points, worse.worst,
                    (low.sum + high.sum) / static_cast<double>(points), functions[f].bound,
                    static_cast<double>(worse.at));
        if (!(worse.worst <= functions[f].bound))
            ++failed,
                std::fprintf(stderr, "%s: %.3g, promised %g\n", functions[f].name, worse.worst, functions[f].bound);
    }

    long wrong = 0, points = 0;
    for (std::uint64_t i = 0; i <= 0xffffffffu; i += stride, ++points) {
        std::uint32_t mirrored = 0;
        for (std::uint32_t rest = static_cast<std::uint32_t>(i), bit = 0x80000000u; rest; rest >>= 1, bit >>= 1)
            mirrored |= rest & 1u ? bit : 0;
        const float x = lobe::radical_inverse<float>(static_cast<std::uint32_t>(i));
        wrong += !(x < 1) || static_cast<double>(x) != static_cast<double>(mirrored >> 8) * 0x1p-24;
    }
    std::printf("radical_inverse, not the upper 24 bits | %ld | %ld | 0 | 0 |\n", points, wrong);
    return failed || wrong ? 1 : 0;
}
