// The hemisphere of directions as the unit square, by the half vector with a fixed direction: lobes of every width are
// wide in it.
#pragma once

#include <lobe/core/vector.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace lobe::testkit::detail {

/// l = reflect(v, m), m at the azimuth phi = 2 pi y (from near that of v: on it, ridges would run along the edges of
/// cells, unseen) and the slope r = r_max(phi) x^4: a peak of slope width 1e-4 about m = n is as wide in x as one of
/// width 1. r_max(phi) is the horizon of l, exactly: l.z = 0 where r = 1/(b + sqrt(b^2 + 1)), b = (v.x cos phi + v.y
/// sin phi)/v.z.
class half_vector_chart {
public:
    explicit half_vector_chart(const vec3<double>& fixed) : v(fixed), azimuth(std::atan2(fixed.y, fixed.x) + 0.3) {}

    /// The direction l at (x, y), and dl / (dx dy) in sr.
    struct point {
        vec3<double> l;
        double area;
    };
    point operator()(double x, double y) const {
        const double phi = azimuth + 2 * std::numbers::pi * y, cx = std::cos(phi), cy = std::sin(phi);
        const double limit = r_max(cx, cy), r = limit * x * x * x * x, sec2 = 1 + r * r;
        const double v_m = v.z - r * (cx * v.x + cy * v.y);  // times sqrt(sec2), m = (-r cx, -r cy, 1)/sqrt(sec2)
        const vec3<double> l{-2 * v_m * r * cx / sec2 - v.x, -2 * v_m * r * cy / sec2 - v.y, 2 * v_m / sec2 - v.z};
        const double dm = r / (sec2 * std::sqrt(sec2)) * 4 * limit * x * x * x * 2 * std::numbers::pi;
        return {l, 4 * v_m / std::sqrt(sec2) * dm};
    }

    /// Where a direction lies in the square.
    std::array<double, 2> find(const vec3<double>& l) const {
        const vec3<double> s = v + l;
        const double sine = std::hypot(s.x, s.y);
        if (!(sine > 0)) return {0, 0};
        const double phi = std::atan2(-s.y, -s.x), r = sine / s.z;
        double y = (phi - azimuth) / (2 * std::numbers::pi);
        y -= std::floor(y);
        const double x = std::sqrt(std::sqrt(r / r_max(-s.x / sine, -s.y / sine)));
        return {std::clamp(x, 0.0, 1.0), y};
    }

private:
    double r_max(double cx, double cy) const {
        const double b = (cx * v.x + cy * v.y) / v.z, root = std::sqrt(b * b + 1);
        return b > 0 ? 1 / (b + root) : root - b;
    }

    vec3<double> v;
    double azimuth;
};

}  // namespace lobe::testkit::detail
