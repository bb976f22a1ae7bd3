// The directions that a subject may scatter to as the unit square: a hemisphere, or both, side by side.
#pragma once

#include <lobe/testkit/measure/half_vector_chart.hpp>
#include <lobe/testkit/measure/sides.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace lobe::testkit::detail {

/// Where v goes straight through a smooth interface, l = -v refracted, mirrored to the side of v with x and y turned:
/// the light that mirrors to it. Beyond the critical angle, near the horizon.
inline vec3<double> straight_through(const vec3<double>& v, double n) {
    constexpr double most = 0.9995;
    const double sine = std::hypot(v.x, v.y), bent = (std::min)(sine / n, most), by = sine > 0 ? bent / sine : 0;
    return {v.x * by, v.y * by, std::sqrt((1 - bent) * (1 + bent))};
}

/// The side of v by its half vectors. The other side, where light is refracted, by those with the direction that is the
/// mirror image of what a smooth interface refracts to: lobes of every width are wide about that direction, too.
class light_chart {
public:
    light_chart(const vec3<double>& v, const sides& of)
        : whole_sphere(of.both), columns(of.both ? 16 : 8), below(v.z < 0), same_side(upward(v)),
          other_side(straight_through(upward(v), of.index(v, -v))) {}

    using point = half_vector_chart::point;
    point operator()(double x, double y) const {
        if (!whole_sphere) return same_side(x, y);
        const bool crosses = !(x < 0.5);
        point p = crosses ? other_side(2 * x - 1, y) : same_side(2 * x, y);
        if (crosses != below) p.l.z = -p.l.z;
        p.area *= 2;
        return p;
    }

    std::array<double, 2> find(const vec3<double>& l) const {
        if (!whole_sphere) return same_side.find(l);
        const bool crosses = (l.z < 0) != below;
        const auto p = crosses ? other_side.find(upward(l)) : same_side.find(upward(l));
        return {crosses ? 0.5 + p[0] / 2 : (std::min)(p[0] / 2, std::nextafter(0.5, 0.0)), p[1]};
    }

    bool whole_sphere;
    int columns;  // of a mesh

private:
    bool below;
    half_vector_chart same_side, other_side;
};

}  // namespace lobe::testkit::detail
