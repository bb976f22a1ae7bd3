// What a sampler and a density are compared by, beside their integrals.
#pragma once

#include <lobe/testkit/measure/sides.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace lobe::testkit::detail {

/// Smooth numbers of a direction l that a normal m (or a half vector) mirrors to: their means over samples tell a wrong
/// width, tilt or side. The first three are not negative; the others are at most as large as the first two.
inline std::array<double, 5> moments(const vec3<double>& m, double cosine) {
    return {std::abs(m.x), std::abs(m.y), cosine, m.x, m.y};
}
/// Of a light direction: by its half vector with v, of its mirror image where it lies on the other side.
inline std::array<double, 5> moments_of_light(const vec3<double>& v, const vec3<double>& l) {
    return moments(normalize(upward(v) + upward(l)), (std::max)(0.0, v.z < 0 ? -l.z : l.z));
}

}  // namespace lobe::testkit::detail
