// Sobol' points, plain and scrambled, R2 and the Fibonacci lattice.
#include "catch.hpp"
#include "support.hpp"

#include <lobe/brdf/lambert.hpp>
#include <lobe/ibl/reflected_radiance.hpp>
#include <lobe/sampling/lattices.hpp>
#include <lobe/sampling/sobol.hpp>
#include <lobe/testkit/verify_sequence.hpp>

#include <algorithm>
#include <set>
#include <vector>

using lobe::vec2;
using lobe::vec3;

namespace {

template <class Point>
auto points_of(std::uint32_t n, const Point& point) {
    std::vector<decltype(point(0u))> points;
    for (std::uint32_t i = 0; i < n; ++i) points.push_back(point(i));
    return points;
}

/// Has every box of area 2^-m whose sides are powers of 2 exactly one of these 2^m points?
template <class Points>
bool stratified(const Points& points, int m) {
    bool good = true;
    for (int columns = 0; columns <= m; ++columns) {
        std::set<std::pair<int, int>> boxes;
        for (const auto& u : points)
            boxes.insert({static_cast<int>(static_cast<double>(u.x) * std::ldexp(1, columns)),
                          static_cast<int>(static_cast<double>(u.y) * std::ldexp(1, m - columns))});
        good = good && boxes.size() == points.size();
    }
    return good;
}

/// Warnock's formula for the root mean square, over boxes [0,x) x [0,y), of the share of points in a box less its area.
template <class Points>
double l2_discrepancy(const Points& points) {
    const double n = static_cast<double>(points.size());
    double pairs = 0, single = 0;
    for (const auto& p : points) {
        single += (1 - p.x * p.x) * (1 - p.y * p.y) / 4;
        for (const auto& q : points) pairs += (1 - larger({p.x, q.x})) * (1 - larger({p.y, q.y}));
    }
    return std::sqrt(1.0 / 9 - 2 * single / n + pairs / (n * n));
}

/// Owen's scrambling as he defines it: a bit is flipped or not by a random number of its own for each string of bits
/// above it.
std::uint32_t nested_scramble(std::uint32_t bits, std::uint64_t seed) {
    std::uint32_t scrambled = 0;
    for (int bit = 31; bit >= 0; --bit) {
        const std::uint64_t above = (std::uint64_t{bits} >> bit >> 1) | (std::uint64_t{1} << (31 - bit));
        const auto flip = static_cast<std::uint32_t>(lobe::detail::mixed_bits(seed ^ lobe::detail::mixed_bits(above)));
        scrambled |= ((bits >> bit ^ flip) & 1u) << bit;
    }
    return scrambled;
}

double smooth(const vec2<double>& u) { return std::exp(u.x) * std::sin(3 * u.y + u.x); }

}  // namespace

TEST_CASE("Sobol': the direction numbers of Sobol' 1967", "[sampling]") {
    // second dimension, primitive polynomial x + 1: v_1 = 1/2, v_(j+1) = v_j xor v_j/2
    std::uint32_t v = 0x80000000u;
    std::vector<std::uint32_t> directions;
    for (int j = 0; j < 32; ++j) directions.push_back(v), v ^= v >> 1;
    random_numbers random(3);
    for (int k = 0; k < 10000; ++k) {
        const auto i = static_cast<std::uint32_t>(random() * 4294967296.0);
        std::uint32_t y = 0;
        for (std::size_t j = 0; j < 32; ++j)
            if (i >> j & 1u) y ^= directions[j];
        const auto u = lobe::sobol<double>(i);
        REQUIRE(u.x == lobe::radical_inverse<double>(i));
        REQUIRE(u.y == y / 4294967296.0);
    }
}

TEST_CASE("Sobol', scrambled or not: every elementary box has its point", "[sampling]") {
    for (int m = 0; m <= 10; ++m) {
        const std::uint32_t n = 1u << m;
        for (const std::uint32_t block : {0u, 1u, 5u, 1000u}) {
            CHECK(stratified(points_of(n, [&](std::uint32_t i) { return lobe::sobol<double>(block * n + i); }), m));
            CHECK(stratified(points_of(n, [&](std::uint32_t i) { return lobe::owen_sobol<float>(block * n + i, 7); }),
                             m));
        }
        const lobe::scrambled_sobol<double> rounds(n, 2, 5);
        for (std::uint32_t k : {0u, 1u})
            CHECK(stratified(points_of(n, [&](std::uint32_t i) { return rounds(1, i, k); }), m));
    }
}

TEST_CASE("sequences: in [0,1) for every index", "[sampling]") {
    random_numbers random(4);
    const auto inside = [](const auto& u) { return u.x >= 0 && u.x < 1 && u.y >= 0 && u.y < 1; };
    const auto check = [&]<class T>(T, std::uint32_t i, std::uint32_t n) {
        return inside(lobe::sobol<T>(i)) && inside(lobe::owen_sobol<T>(i, n)) && inside(lobe::r2<T>(i)) &&
               inside(lobe::fibonacci<T>(i, n)) && inside(lobe::scrambled_sobol<T>(n)(n, i, 1));
    };
    bool good = true;
    for (int k = 0; k < 1000000; ++k) {
        const auto n = static_cast<std::uint32_t>(random.log_between(1, 4294967295.0));
        const auto i = static_cast<std::uint32_t>(random() * n);
        good = good && check(0.0f, i, n) && check(0.0, i, n) && check(0.0f, n - 1, n) && check(0.0, n - 1, n);
    }
    CHECK(good);
    CHECK(check(0.0f, 0xfffffffeu, 0xffffffffu));
}

TEST_CASE("lattices stand where the definition says, far along too", "[sampling]") {
    const long double g = 1.32471795724474602596090885447809734L, phi = (1 + std::sqrt(5.0L)) / 2;
    const auto whole_less = [](long double x) { return static_cast<double>(x - std::floor(x)); };
    random_numbers random(5);
    for (int k = 0; k < 10000; ++k) {
        const auto i = static_cast<std::uint32_t>(random.log_between(1, 4294967295.0));
        const long double at = i + 0.5L;
        // of the 64 bits of long double 32 are gone at i = 2^32
        const auto near = [](double x, double y, double error) {
            const double off = std::abs(x - y);
            return smaller(off, 1 - off) <= error;
        };
        const auto r = lobe::r2<double>(i), f = lobe::fibonacci<double>(i, 0xffffffffu);
        REQUIRE(near(r.x, whole_less(at / g), 0x1p-31));
        REQUIRE(near(r.y, whole_less(at / (g * g)), 0x1p-31));
        REQUIRE(near(f.x, static_cast<double>(at / 0xffffffffu), 0x1p-31));
        REQUIRE(near(f.y, whole_less(at / phi), 0x1p-31));
        REQUIRE(near(lobe::r2<float>(i).x, r.x, 0x1.01p-24));
        REQUIRE(near(lobe::fibonacci<float>(i, 0xffffffffu).y, f.y, 0x1.01p-24));
    }
}

TEMPLATE_TEST_CASE("the kit on sequences", "[sampling]", float, double) {
    using T = TestType;
    for (const std::uint32_t n : {64u, 1000u, 4096u}) {
        const lobe::scrambled_sobol<T> rounds(n);
        const auto judged = [&](const auto& points) {
            const auto report = lobe::testkit::verify_sequence(points);
            INFO(report);
            CHECK(report.passed());
        };
        judged(points_of(n, [](std::uint32_t i) { return lobe::sobol<T>(i); }));
        judged(points_of(n, [](std::uint32_t i) { return lobe::owen_sobol<T>(i, 1); }));
        judged(points_of(n, [&](std::uint32_t i) { return rounds(3, i, 1); }));
        judged(points_of(n, [](std::uint32_t i) { return lobe::r2<T>(i); }));
        judged(points_of(n, [&](std::uint32_t i) { return lobe::fibonacci<T>(i, n); }));
    }
}

TEST_CASE("discrepancy falls like 1/n, apart from logarithms", "[sampling]") {
    // Random points: sqrt(5/36/n), 0.0116 at n = 1024. A (0,10,2)-net: at most (10/3 + 19/9)/n = 5.3e-3 for the largest
    // deviation (Niederreiter 1992, section 4.1), so less for the root mean square.
    const std::uint32_t n = 1024;
    const auto measure = [&](const auto& point) { return l2_discrepancy(points_of(n, point)); };
    CHECK(measure([](std::uint32_t i) { return lobe::sobol<double>(i); }) < 5.3e-3);
    CHECK(measure([](std::uint32_t i) { return lobe::owen_sobol<double>(i, 11); }) < 5.3e-3);
    CHECK(measure([](std::uint32_t i) { return lobe::r2<double>(i); }) < 5.3e-3);
    CHECK(measure([&](std::uint32_t i) { return lobe::fibonacci<double>(i, n); }) < 5.3e-3);
}

TEST_CASE("scrambled points are uniform over seeds, each and in pairs", "[sampling]") {
    // chi squared of 16 x 16 cells, 255 degrees of freedom: mean 255, deviation 22.6; bounds at 5 deviations
    constexpr int seeds = 1 << 16;
    const auto chi_squared = [&](const auto& cell) {
        std::vector<int> hits(256);
        for (std::uint64_t seed = 0; seed < seeds; ++seed) ++hits[cell(seed)];
        double total = 0;
        for (const int h : hits) total += (h - seeds / 256.0) * (h - seeds / 256.0) / (seeds / 256.0);
        return total;
    };
    const auto both = [](double a, double b) {
        return static_cast<std::size_t>(a * 16) * 16 + static_cast<std::size_t>(b * 16);
    };
    for (const std::uint32_t i : {0u, 1u, 2u, 77u, 4095u, 0x12345678u}) {
        const double point = chi_squared([&](std::uint64_t seed) {
            const auto u = lobe::owen_sobol<double>(i, seed);
            return both(u.x, u.y);
        });
        CHECK(point < 255 + 5 * 22.6);
        CHECK(point > 255 - 5 * 22.6);
        // draws of one sample know nothing of each other
        const double draws = chi_squared([&](std::uint64_t seed) {
            const lobe::scrambled_sobol<double> rounds(16, 2, seed);
            return both(rounds(0, i, 0).x, rounds(0, i, 1).x);
        });
        CHECK(draws < 255 + 5 * 22.6);
        CHECK(draws > 255 - 5 * 22.6);
    }
}

TEST_CASE("the hash errs as little as Owen's own scrambling", "[sampling]") {
    // The variance of a mean over 2^m points, over 2000 seeds each: known to sqrt(2/2000) = 3.2 % for Gaussian errors,
    // so that the ratio of two is 1 within 4.5 %; 5 deviations and a kurtosis of up to 4 more make 0.65 to 1.5.
    const double exact = [] {
        double total = 0;
        constexpr int n = 2000;  // midpoints: error h^2/24 times second derivatives of 30, 3e-7
        for (int i = 0; i < n; ++i)
            for (int j = 0; j < n; ++j) total += smooth({(i + 0.5) / n, (j + 0.5) / n});
        return total / n / n;
    }();
    const auto variance = [&](std::uint32_t n, const auto& point) {
        double total = 0;
        for (std::uint64_t seed = 0; seed < 2000; ++seed) {
            double mean = 0;
            for (std::uint32_t i = 0; i < n; ++i) mean += smooth(point(i, seed)) / n;
            total += (mean - exact) * (mean - exact) / 2000;
        }
        return total;
    };
    const auto by_hash = [](std::uint32_t i, std::uint64_t seed) { return lobe::owen_sobol<double>(i, seed); };
    const auto by_definition = [](std::uint32_t i, std::uint64_t seed) {
        const auto u = lobe::sobol<double>(i);
        const auto scrambled = [&](double x, std::uint64_t s) {
            return (nested_scramble(static_cast<std::uint32_t>(x * 4294967296.0), s) + 0.5) / 4294967296.0;
        };
        return vec2<double>{scrambled(u.x, lobe::detail::mixed_bits(2 * seed)),
                            scrambled(u.y, lobe::detail::mixed_bits(2 * seed + 1))};
    };
    double before = 0;
    for (const std::uint32_t n : {16u, 64u, 256u}) {
        const double hash = variance(n, by_hash), owen = variance(n, by_definition);
        CAPTURE(n, hash, owen);
        CHECK(hash / owen > 0.65);
        CHECK(hash / owen < 1.5);
        // n^-3: 64 from one to the next, but for the statistics of both and a logarithm; random points have 4
        if (before > 0) CHECK(before / hash > 30);
        before = hash;
    }
}

TEST_CASE("scrambled Sobol' points in the reflectance equation: right, and its standard error too", "[sampling]") {
    const lobe::lambert base{0.5};
    const vec3<double> v{0, 0, 1};
    const auto sky = [](const vec3<double>& l) { return l.x * l.x + 2 * l.z; };
    const double exact = 0.5 * (1.0 / 4 + 4.0 / 3);  // 1/pi int x^2 z = 1/4, 2/pi int z^2 = 4/3
    double squares = 0;
    constexpr int runs = 200;
    for (int run = 0; run < runs; ++run) {
        const lobe::scrambled_sobol<double> points(64, 16, static_cast<std::uint64_t>(run));
        const auto r = lobe::reflected_radiance(base, v, sky, points);
        const double off = (r.value - exact) / r.standard_error;
        squares += off * off / runs;
        CHECK(r.standard_error < 1.5e-3);  // a quarter of that of 1024 random points: 0.19/32
    }
    // Student's t of 15 degrees of freedom: variance 15/13 = 1.15, its mean over 200 runs known to 0.13
    CHECK(squares > 0.5);
    CHECK(squares < 1.8);
}
