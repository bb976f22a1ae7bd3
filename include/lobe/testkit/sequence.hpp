// The verdict on a set of points of the unit square: `verify_sequence(points)`.
#pragma once

#include <lobe/testkit/checks.hpp>

namespace lobe::testkit {

namespace detail {

/// The mean square over all boxes [0,x) of (share of the points in the box - its area). Warnock 1972, O(n^2).
inline double squared_l2_star_discrepancy(const std::vector<vec2<double>>& p) {
    const double n = static_cast<double>(p.size());
    double single = 0, pairs = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
        single += (1 - p[i].x * p[i].x) * (1 - p[i].y * p[i].y) / 4;
        pairs += (1 - p[i].x) * (1 - p[i].y);
        for (std::size_t j = 0; j < i; ++j) pairs += 2 * (1 - (std::max)(p[i].x, p[j].x)) * (1 - (std::max)(p[i].y, p[j].y));
    }
    return 1.0 / 9 - 2 * single / n + pairs / (n * n);
}

/// The largest difference between the share of points below x and x.
inline double star_discrepancy(std::vector<double> x) {
    std::sort(x.begin(), x.end());
    const double n = static_cast<double>(x.size());
    double worst = 0;
    for (std::size_t i = 0; i < x.size(); ++i)
        worst = (std::max)({worst, x[i] - static_cast<double>(i) / n, (static_cast<double>(i) + 1) / n - x[i]});
    return worst;
}

}  // namespace detail

/// Judges points of the unit square: a range of them (at least 64; of more than 16384 each coordinate alone). With
/// `low_discrepancy`, the default, they must be twice as even as random points are.
template <class Points>
    requires requires(const Points p) {
        p.begin()->x;
        p.end();
    }
[[nodiscard]] report verify_sequence(const Points& points, const options& o = {}) {
    using T = std::remove_cvref_t<decltype(points.begin()->x)>;
    report r(o.name);
    std::vector<vec2<double>> p;
    std::string worst;
    double outside = 0;
    std::size_t index = 0;
    for (const auto& u : points) {
        p.push_back({static_cast<double>(u.x), static_cast<double>(u.y)});
        for (const double x : {p.back().x, p.back().y})
            if (!(x >= 0 && x < 1) && worst.empty())
                outside = x, worst = "point " + std::to_string(index) + ": " + detail::literal("u", vec2<T>(u.x, u.y));
        ++index;
    }
    r.add({{"points are in [0,1)", outside, 0, 0, worst,
            equal(outside, 1.0) ? "rounding or i/(n-1) reaches 1: what takes u in [0,1) breaks there"
                                : "a coordinate is outside the unit square"},
           worst.empty()});
    r.add({{"at least 64 points", static_cast<double>(p.size()), 64, 0, "", "too few to say more"}, p.size() >= 64});
    if (p.size() < 64 || !worst.empty()) return r;

    std::vector<vec2<double>> sorted = p;
    std::sort(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) { return a.x < b.x || (equal(a.x, b.x) && a.y < b.y); });
    const auto twice =
        std::adjacent_find(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) { return equal(a.x, b.x) && equal(a.y, b.y); });
    r.add({{"points are distinct", twice == sorted.end() ? 0.0 : 1.0, 0, 0,
            twice == sorted.end() ? "" : detail::literal("u", vec2<T>(static_cast<T>(twice->x), static_cast<T>(twice->y))),
            "a point comes twice: the index loses bits, or the sequence repeats"},
           twice == sorted.end()});
    if (!o.low_discrepancy) return r;

    const double n = static_cast<double>(p.size());
    for (const bool is_x : {true, false}) {
        std::vector<double> x;
        for (const auto& u : p) x.push_back(is_x ? u.x : u.y);
        // Of random points it is 0.87/sqrt(n) on average (Kolmogorov).
        const double found = detail::star_discrepancy(x), allowed = 0.87 / std::sqrt(n) / 2;
        r.add({{is_x ? "x is evenly spread" : "y is evenly spread", found, 0, allowed, "",
                "the coordinate alone is no evener than random numbers: bits are lost or in the wrong order"},
               found <= allowed});
    }
    if (p.size() > 16384) return r;                                                        // too many pairs
    const double random = std::sqrt((1.0 / 4 - 1.0 / 9) / static_cast<double>(p.size()));  // root of the expected square
    const double found = std::sqrt((std::max)(0.0, detail::squared_l2_star_discrepancy(p)));
    r.add({{"discrepancy is below random", found, 0, random / 2, "",
            "the L2 star discrepancy is no better than that of random points: the two coordinates are correlated, or badly seeded"},
           found <= random / 2});
    return r;
}

}  // namespace lobe::testkit
