// The hemisphere of normals as the unit square: peaks of every width about the normal are wide in it.
#pragma once

#include <lobe/core/vector.hpp>
#include <lobe/testkit/measure/random.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace lobe::testkit::detail {

/// theta = (pi/2) x^4, phi = 2 pi y.
struct normal_chart {
    static constexpr bool whole_sphere = false;
    static constexpr int columns = 8;  // of a mesh

    struct point {
        vec3<double> l;
        double area;  // in sr a unit of the square
    };
    point operator()(double x, double y) const {
        const double theta = tau / 4 * x * x * x * x, phi = tau * y, s = std::sin(theta);
        return {{s * std::cos(phi), s * std::sin(phi), std::cos(theta)}, s * tau * x * x * x * tau};
    }
    std::array<double, 2> find(const vec3<double>& m) const {
        const double turn = std::atan2(m.y, m.x) / tau;
        const double theta = std::atan2(std::hypot(m.x, m.y), m.z);
        return {(std::min)(1.0, std::sqrt(std::sqrt(theta / (tau / 4)))), turn - std::floor(turn)};
    }
};

}  // namespace lobe::testkit::detail
