// Numbers and directions to try: the same for the same seed, on every platform.
#pragma once

#include <lobe/core/vector.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

namespace lobe::testkit::detail {

/// Uniform in [0,1), the same on every platform. Each user has a stream of its own: none changes what another one
/// draws.
class generator {
public:
    explicit generator(std::uint64_t seed, std::uint64_t stream = 0) : engine(seed + stream * 0x9e3779b97f4a7c15u) {}
    double operator()() { return static_cast<double>(engine() >> 11) * 0x1p-53; }
    double log_between(double low, double high) { return low * std::exp((*this)() * std::log(high / low)); }

private:
    std::mt19937_64 engine;
};

/// A number of [0,1) in T: rounding may not turn it into 1.
template <class T>
T below_one(double u) {
    return (std::min)(static_cast<T>(u), T(1) - std::numeric_limits<T>::epsilon() / 2);
}

/// The numbers of one sample: two of them, or three.
template <class T>
vec3<T> random_u(generator& random, int numbers) {
    vec3<T> u{};
    for (int i = 0; i < numbers; ++i) u[i] = below_one<T>(random());
    return u;
}
/// The same, in the square (i, j) of n times n.
template <class T>
vec3<T> random_u(generator& random, int numbers, int i, int j, int n) {
    const double x = (i + random()) / n, y = (j + random()) / n, z = numbers == 3 ? random() : 0;
    return {below_one<T>(x), below_one<T>(y), below_one<T>(z)};
}

template <class T>
vec3<T> direction(double cosine, double azimuth) {
    const double sine = std::sqrt((1 - cosine) * (1 + cosine));
    return {static_cast<T>(sine * std::cos(azimuth)), static_cast<T>(sine * std::sin(azimuth)), static_cast<T>(cosine)};
}

inline constexpr double tau = 6.283185307179586;
inline constexpr double golden_angle = 2.399963229728653;

/// Equal, and meant so.
constexpr bool same(double a, double b) { return a <= b && a >= b; }

}  // namespace lobe::testkit::detail
