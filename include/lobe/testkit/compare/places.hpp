// Where two functions are compared.
#pragma once

#include <lobe/testkit/compare/compare_options.hpp>
#include <lobe/testkit/measure/random.hpp>

#include <cmath>

namespace lobe::testkit::detail {

inline int places_of(effort e) { return e == effort::quick ? 1 << 17 : 1 << 20; }

/// Even in solid angle, or with cosines of all scales down to the horizon.
template <class T>
vec3<T> random_direction(generator& random, bool even, bool below) {
    const double z = even ? random() : random.log_between(1e-6, 1), azimuth = tau * random();
    return direction<T>(below ? -z : z, azimuth);
}

/// Pairs of directions: half of them even in solid angle, a quarter mirrored at a normal of any slope, a quarter near
/// grazing. see(v, l, counts).
template <class T, class See>
void for_each_pair(const compare_options& o, const See& see) {
    generator random(o.seed, 11);
    for (int i = 0, n = places_of(o.effort); i < n; ++i) {
        const bool even = i % 2 == 0;
        const bool v_below = o.whole_sphere && random() < 0.5, l_below = o.whole_sphere && random() < 0.5;
        const vec3<T> v = random_direction<T>(random, even || i % 4 == 1, v_below);
        if (i % 4 != 1) {
            see(v, random_direction<T>(random, even, l_below), even);
            continue;
        }
        const double slope = random.log_between(1e-5, 10), turn = tau * random();
        const vec3<double> w(v), m = normalize(vec3<double>(slope * std::cos(turn), slope * std::sin(turn), 1)),
                                 l = 2 * dot(w, m) * m - w;
        if (o.whole_sphere || l.z > 0) see(v, vec3<T>(normalize(l)), false);
    }
}

}  // namespace lobe::testkit::detail
