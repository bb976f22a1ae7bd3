// What rounding inside a function, or in its inputs, does to a value, and to an integral.
#pragma once

#include <lobe/testkit/measure/mesh.hpp>
#include <lobe/testkit/measure/numbers.hpp>
#include <lobe/testkit/measure/random.hpp>
#include <lobe/testkit/measure/rehearse.hpp>
#include <lobe/testkit/measure/text.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <type_traits>
#include <vector>

namespace lobe::testkit::detail {

/// A value that depends on v and l. (A std::function: what takes it is compiled once.)
template <class T>
using of_directions = std::function<double(const vec3<T>& v, const vec3<T>& l)>;

/// How far a value moves when every component of v and l moves by a few units of rounding: what rounding inside the
/// function, or in its inputs, does to it there.
template <class T>
double rounding_noise(const of_directions<T>& value, const place<T>& at, int steps = 32) {
    rehearse([&] { rounding_noise<T>(value, at, steps); });
    generator random(7);
    const double exact = value(at.v, at.l);
    double noise = 0;
    for (int i = 0; i < steps; ++i) {
        // Both a little longer or shorter, which changes no half vector but how its components round; then each
        // component.
        const T scale = T(1) + static_cast<T>(2 * random() - 1) * T(16) * std::numeric_limits<T>::epsilon();
        vec3<T> v = at.v * scale, l = at.l * scale;
        for (vec3<T>* w : {&v, &l})
            for (int k = 0; k < 3; ++k) {
                const double step = (2 * random() - 1) * 4 * static_cast<double>(std::numeric_limits<T>::epsilon());
                const T moved = static_cast<T>(static_cast<double>((*w)[k]) + step);
                // the horizon is not crossed
                (*w)[k] = k < 2 || (moved > T(0)) == ((*w)[k] > T(0)) ? moved : (*w)[k] / T(2);
            }
        if (const double moved = std::abs(value(v, l) - exact); is_finite(moved)) noise = (std::max)(noise, moved);
    }
    return noise;
}

/// What rounding inside the function does to an integral of it, relative: on average over the cells that matter. Narrow
/// lobes in float have a width that rounding alone changes: 1 - c*c and a*a - 1 keep 2^-24/alpha^2 of it. value(v, l):
/// the integrand.
template <class T, std::size_t N, class Chart>
double relative_rounding(const mesh<N>& m, const Chart& chart, const vec3<T>& v, const of_directions<T>& value) {
    if constexpr (!std::is_same_v<T, float>) return 0;
    std::vector<std::size_t> leaves = m.leaves();
    const std::size_t kept = std::min<std::size_t>(leaves.size(), 48);
    const auto size = [&](std::size_t at) { return std::abs(m.cells()[at].integral[0]); };
    std::partial_sort(leaves.begin(), leaves.begin() + static_cast<std::ptrdiff_t>(kept), leaves.end(),
                      [&](std::size_t a, std::size_t b) { return size(a) > size(b); });
    rehearse([&] {
        for (std::size_t i = 0; i < kept; ++i) {
            const auto& c = m.cells()[leaves[i]];
            rounding_noise<T>(value, {.v = v, .l = vec3<T>(chart(c.x0 + c.width / 2, c.y0 + c.height / 2).l)}, 8);
        }
    });
    double noise = 0, all = 0;
    for (std::size_t i = 0; i < kept; ++i) {
        const auto& c = m.cells()[leaves[i]];
        const place<T> at{.v = v, .l = vec3<T>(chart(c.x0 + c.width / 2, c.y0 + c.height / 2).l)};
        const double there = std::abs(value(at.v, at.l));
        if (!is_finite(there) || !(there > 0)) continue;
        noise += size(leaves[i]) * rounding_noise<T>(value, at, 8) / there;
        all += size(leaves[i]);
    }
    return all > 0 ? 2 * noise / all : 0;  // twice: the rounding of constants has a sign
}

}  // namespace lobe::testkit::detail
