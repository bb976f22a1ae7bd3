// The verdict on a distribution of normals: `verify_distribution(ndf)`.
#pragma once

#include <lobe/testkit/properties/area.hpp>
#include <lobe/testkit/properties/normalisation.hpp>
#include <lobe/testkit/properties/normals.hpp>
#include <lobe/testkit/verdict/attempt.hpp>
#include <lobe/testkit/verdict/last_words.hpp>

#include <array>
#include <cmath>
#include <limits>

namespace lobe::testkit {

namespace detail {

/// Every value is watched; here only the extremes are chosen.
template <class T>
void sweep(distribution<T>& n) {
    using V = vec3<T>;
    for (const double azimuth : {0.0, 1.0, tau / 4, tau / 2, -2.0}) {
        for (const double z : {1.0, 1 - 1e-7, 0.999, 0.7, 0.3, 0.1, 1e-2, 1e-4, 1e-6, 0.0, -1e-6, -0.3, -1.0}) {
            n.D(direction<T>(z, azimuth));
            if (n.raw.area && (z > 0 || n.area_everywhere)) n.area(direction<T>(z, azimuth));
        }
        for (double tilt = 1e-8; tilt < 0.3; tilt *= 10)
            n.D(V(std::sin(tilt) * std::cos(azimuth), std::sin(tilt) * std::sin(azimuth), std::cos(tilt)));
    }
    n.D(V{std::numeric_limits<T>::denorm_min(), T(0), T(1)});
    constexpr std::array<double, 5> edges{0, 1e-6, 0.25, 0.5, 1 - 0x1p-24};
    for (const double x : edges)
        for (const double y : edges) {
            const vec2<T> u{below_one<T>(x), below_one<T>(y)};
            if (n.raw.sample) n.sample(u);
            if (n.raw.sample_visible)
                for (const double z : {1.0, 0.5, 1e-2, 1e-6}) n.sample_visible(direction<T>(z, 1.0), u);
        }
}

template <class T>
report verdict_on(const distribution_functions<T>& ndf, const options& o) {
    report r = opened(o);
    if (!r.passed()) return r;
    distribution<T> n(ndf, o);
    report found("");
    last_words words([&](line& out) { n.last.write(out); });
    const auto part = [&](const auto& f) {
        attempt(
            found, [&] { return n.last.text(); }, f);
    };
    part([&] { sweep(n); });
    for (const auto& property : {normalisation<T>, isotropy_of_D<T>, areas<T>, all_normals<T>, visible_normals<T>})
        part([&] {
            property(n, found);
            words.so_far = found.text();
        });
    values_of_distribution(n, r);
    for (const check& c : found.checks()) r.add(c);
    return r;
}

}  // namespace detail

/// Judges any type with `D(m)`, or a function of m that returns it: the density of normals in 1/sr, m unit, in tangent
/// space. Verified where they exist: one of `projected_area(w)`, `lambda(w)`, `G1(w)` (Smith); `sample(u)` and
/// `pdf(m)`; `sample_visible(v, u)` and `pdf_visible(v, m)`.
template <class N>
[[nodiscard]] report verify_distribution(const N& ndf, const options& o = {}) {
    constexpr bool fits = detail::distribution_fits<N, double> || detail::distribution_fits<N, float>;
    static_assert(fits, "no D(m), nor a call (m), that is const, takes a glm::vec3 or glm::dvec3 and returns a number");
    if constexpr (fits)
        return detail::verdict_on(detail::interface_of_distribution(ndf), o);
    else
        return report(o.name);
}

}  // namespace lobe::testkit
