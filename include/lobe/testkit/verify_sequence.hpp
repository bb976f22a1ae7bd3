// The verdict on a set of points of the unit square: `verify_sequence(points)`.
#pragma once

#include <lobe/testkit/options.hpp>
#include <lobe/testkit/properties/evenness.hpp>

#include <type_traits>
#include <vector>

namespace lobe::testkit {

namespace detail {

template <class Points>
concept has_points = requires(const Points p) {
    static_cast<double>(p.begin()->x);
    static_cast<double>(p.begin()->y);
    p.end();
};

template <class T>
report verdict_on(const points& p, const options& o) {
    report r(o.name);
    inside<T>(p, r);
    r.add(id::points_enough, {.passed = p.size() >= 64,
                              .measured = static_cast<double>(p.size()),
                              .expected = 64,
                              .meaning = "too few to say more"});
    if (!r.passed()) return r;
    distinct<T>(p, r);
    if (!o.low_discrepancy) return r;
    std::vector<double> x, y;
    for (const auto& u : p) x.push_back(u.x), y.push_back(u.y);
    spread(id::x_spread, x, r);
    spread(id::y_spread, y, r);
    if (p.size() <= 16384) evenness(p, r);  // else too many pairs
    return r;
}

}  // namespace detail

/// Judges points of the unit square: a range of them (at least 64; of more than 16384 each coordinate alone). With
/// `low_discrepancy`, the default, they must be twice as even as random points are.
template <class Points>
[[nodiscard]] report verify_sequence(const Points& points, const options& o = {}) {
    constexpr bool fits = detail::has_points<Points>;
    static_assert(fits, "no range of points with x and y: begin() and end() of GLM vectors, or of the like");
    if constexpr (fits) {
        using T = std::remove_cvref_t<decltype(points.begin()->x)>;
        detail::points p;
        for (const auto& u : points) p.push_back({static_cast<double>(u.x), static_cast<double>(u.y)});
        return detail::verdict_on<T>(p, o);
    } else {
        return report(o.name);
    }
}

}  // namespace lobe::testkit
