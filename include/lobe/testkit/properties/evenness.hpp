// Points of the unit square: inside, distinct, and more even than random ones.
#pragma once

#include <lobe/testkit/measure/discrepancy.hpp>
#include <lobe/testkit/measure/numbers.hpp>
#include <lobe/testkit/measure/random.hpp>
#include <lobe/testkit/measure/text.hpp>
#include <lobe/testkit/verdict/report.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace lobe::testkit {

namespace id {
inline constexpr property_id points_inside{"points_inside", "points are in [0,1)"};
inline constexpr property_id points_enough{"points_enough", "at least 64 points"};
inline constexpr property_id points_distinct{"points_distinct", "points are distinct"};
inline constexpr property_id x_spread{"x_spread", "x is evenly spread"};
inline constexpr property_id y_spread{"y_spread", "y is evenly spread"};
inline constexpr property_id discrepancy{"discrepancy", "discrepancy is below random"};
}  // namespace id

namespace detail {

using points = std::vector<vec2<double>>;

template <class T>
void inside(const points& p, report& r) {
    for (std::size_t i = 0; i < p.size(); ++i)
        for (const double x : {p[i].x, p[i].y})
            if (!is_finite(x) || !(x >= 0 && x < 1)) {
                r.add(id::points_inside,
                      {.passed = false,
                       .measured = x,
                       .input = "point " + std::to_string(i) + ": " + literal("u", vec2<T>(p[i])),
                       .meaning = same(x, 1) ? "rounding or i/(n-1) reaches 1: what takes u in [0,1) breaks there"
                                             : "a coordinate is outside the unit square"});
                return;
            }
    r.add(id::points_inside, {});
}

template <class T>
void distinct(points p, report& r) {
    std::sort(p.begin(), p.end(),
              [](const auto& a, const auto& b) { return a.x < b.x || (!(b.x < a.x) && a.y < b.y); });
    const auto twice = std::adjacent_find(p.begin(), p.end(), [](const auto& a, const auto& b) { return a == b; });
    const bool none = twice == p.end();
    r.add(id::points_distinct, {.passed = none,
                                .measured = none ? 0.0 : 1.0,
                                .input = none ? "" : literal("u", vec2<T>(*twice)),
                                .meaning = "a point comes twice: the index loses bits, or the sequence repeats"});
}

/// Of random points it is 0.87/sqrt(n) on average (Kolmogorov).
inline void spread(const property_id& of, const std::vector<double>& x, report& r) {
    const double found = star_discrepancy(x), allowed = 0.87 / std::sqrt(static_cast<double>(x.size())) / 2;
    r.add(of,
          {.passed = found <= allowed,
           .measured = found,
           .tolerance = allowed,
           .meaning = "the coordinate alone is no evener than random numbers: bits are lost or in the wrong order"});
}

inline void evenness(const points& p, report& r) {
    // root of the expected square
    const double random = std::sqrt((1.0 / 4 - 1.0 / 9) / static_cast<double>(p.size()));
    const double found = std::sqrt((std::max)(0.0, squared_l2_star_discrepancy(p)));
    r.add(id::discrepancy, {.passed = found <= random / 2,
                            .measured = found,
                            .tolerance = random / 2,
                            .meaning = "the L2 star discrepancy is no better than that of random points: the two "
                                       "coordinates are correlated, or badly seeded"});
}

}  // namespace detail

}  // namespace lobe::testkit
