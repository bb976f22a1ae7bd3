// A distribution of normals: its values, its integral, and whether it is isotropic.
#pragma once

#include <lobe/testkit/properties/finite.hpp>
#include <lobe/testkit/properties/isotropy.hpp>
#include <lobe/testkit/subject/distribution.hpp>
#include <lobe/testkit/verdict/comparison.hpp>
#include <lobe/testkit/verdict/per_view.hpp>

#include <array>
#include <cmath>
#include <limits>

namespace lobe::testkit {

namespace id {
inline constexpr of_values D{
    {"D_finite", "D is finite"}, {"D_not_negative", "D is not negative"}, {"D_vanishes_below", "D vanishes below"}};
inline constexpr of_values area{
    {"area_finite", "the projected area is finite"}, {"area_not_negative", "the projected area is not negative"}, {}};
inline constexpr property_id D_not_0{"D_not_always_0", "D is not always 0"};
inline constexpr property_id unit_normals{"unit_normals", "sampled normals are unit"};
inline constexpr property_id D_integral{"D_integral", "integral of D cos(theta) = 1"};
}  // namespace id

namespace detail {

/// What every call has shown.
template <class T>
void values_of_distribution(distribution<T>& n, report& r) {
    r.add(id::D_not_0, {.passed = n.largest > 0,
                        .measured = n.largest,
                        .expected = n.largest,
                        .meaning = "D returned 0 for every normal: nothing can be verified"});
    report_values(r, n.of_D, id::D,
                  "light from below the horizon is reflected: the sign of a cosine is lost (abs) or never looked at");
    if (n.raw.area) report_values(r, n.of_area, id::area);
    if (n.raw.sample || n.raw.sample_visible)
        r.add(id::unit_normals, {.passed = n.lengths.holds(),
                                 .measured = n.lengths.worst,
                                 .expected = 1,
                                 .tolerance = n.lengths.tolerance,
                                 .input = n.lengths.holds() ? "" : n.lengths.at.text(),
                                 .meaning = "a normal that is not normalised, or the root of a negative number"});
}

/// The projected areas of all normals add up to the surface.
template <class T>
void normalisation(distribution<T>& n, report& r) {
    per_view unit_area(id::D_integral, "the projected areas of the normals do not add up to the surface: a constant is "
                                       "wrong, a power is lost, or the cosine is");
    const auto whole = n.over_normals([&](const vec3<double>& m) { return n.D(vec3<T>(m)) * m.z; });
    unit_area.add([&](bool doubted) -> view_result {
        const auto [value, error] = whole(doubted);
        return {.measured = value[0], .expected = 1, .allowed = n.claims.tolerance + error[0], .v = {0, 0, 1}};
    });
    unit_area.report_to(r);
}

template <class T>
void isotropy_of_D(distribution<T>& n, report& r) {
    if (!n.isotropic) return;
    using V = vec3<T>;
    comparison<T> turned(id::isotropy, n.claims.tolerance,
                         "D changes when m turns about the normal: it is anisotropic, or reads x or y alone");
    generator random(n.claims.seed);
    for (int i = 0; i < n.effort.pairs; ++i) {
        const double tilt = random.log_between(1e-4, 1.5), a = tau * random(), b = tau * random();
        const V m = direction<T>(std::cos(tilt), a), other = direction<T>(std::cos(tilt), b);
        turned.add(n.D(other), n.D(m), {.v = m, .l = other, .first = "m"});
    }
    turned.report_to(r, [&](const place<T>& at, std::size_t) {
        return rounding_noise<T>([&](const V& one, const V&) { return n.raw.D(one); }, at) +
               rounding_noise<T>([&](const V&, const V& two) { return n.raw.D(two); }, at);
    });
}

}  // namespace detail

}  // namespace lobe::testkit
