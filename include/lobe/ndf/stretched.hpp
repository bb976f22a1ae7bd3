// A shape-invariant distribution: a profile at alpha = 1 and the width that stretches it.
#pragma once

#include <lobe/ndf/concepts.hpp>

namespace lobe {

/// Stretching a microsurface of width 1 by `Width` (alpha or alpha_xy) stretches its distribution of normals, its
/// projected area and its samples: Heitz 2014, "Understanding the Masking-Shadowing Function", section 5.3.
///
///   D(m)     = D1(unstretch m) * density_ratio(m)      sigma(w) = sigma1(stretch w)
///   normal   = normalize(stretch(normal of width 1))   visible normal: the same, seen from stretch(v)
///
/// A `Profile` says what its surface of width 1 does:
/// - `D(m)` of any positive multiple of m, or `D(m, width)` of the stretched surface where that rounds less;
/// and, where it can,
/// - `projected_area(w)`, homogeneous: the area seen from w/|w|, times |w|;
/// - `lambda(w)` of any positive multiple of w;
/// - `sample(u)`, `sample_visible(w, u)` (any positive multiple of w): any positive multiple of the normal.
template <class Profile, class Width>
class stretched {
    using T = typename Width::scalar;

public:
    using scalar = T;
    static constexpr bool isotropic = Width::isotropic;

    constexpr stretched(const Profile& profile_of_width_1, const Width& widths)
        : profile_(profile_of_width_1), widths_(widths) {}

    /// For `tabulated`, and for `shared`, which wants the distribution kept.
    constexpr const Profile& profile() const& { return profile_; }
    constexpr const Profile& profile() const&& = delete;
    constexpr const Width& widths() const { return widths_; }

    /// 1/sr; zero below the horizon, the limit from above at it. Any positive multiple of m.
    constexpr T D(const vec3<T>& m) const {
        if constexpr (requires { profile_.D(m, widths_); })
            return select(m.z < T(0), T(0), profile_.D(m, widths_));
        else
            return select(m.z < T(0), T(0), profile_.D(widths_.unstretch(m)) * widths_.density_ratio(m));
    }

    /// Unit w, anywhere on the sphere.
    constexpr T projected_area(const vec3<T>& w) const requires(requires(const Profile p) { p.projected_area(w); }) {
        return profile_.projected_area(widths_.stretch(w));
    }

    /// The same where w is known to be above the horizon, for profiles that are cheaper there.
    constexpr T projected_area_above(const vec3<T>& w) const
        requires(requires(const Profile p) { p.projected_area_above(w); }) {
        return profile_.projected_area_above(widths_.stretch(w));
    }

    /// The area seen from w and that seen from -w, sigma(w) + sigma(-w) = 2 sigma(w) - cos(theta_w), for profiles that
    /// have it without a difference. Unit w.
    constexpr T projected_area_both(const vec3<T>& w) const
        requires(requires(const Profile p) { p.projected_area_both(w); }) {
        return profile_.projected_area_both(widths_.stretch(w));
    }

    /// Unit w; negative, at most -1, below the horizon, infinite at the horizon.
    constexpr T lambda(const vec3<T>& w) const requires(requires(const Profile p) { p.lambda(w); }) {
        return profile_.lambda(widths_.stretch(w));
    }

    constexpr vec2<T> width() const { return {widths_.x(), widths_.y()}; }

    /// A normal with density D(m) cos(theta_m); u in [0,1)^2. Error, for GGX and Beckmann: 3e-7 radian in float,
    /// 6e-16 in double. (Inlined by force, as is `sample_visible`: docs/design.md.)
    [[gnu::always_inline]] constexpr vec3<T> sample(const vec2<T>& u) const
        requires(requires(const Profile p) { p.sample(u); }) {
        return normalize(sample_multiple(u));
    }
    /// The same times a positive number, for those who need no unit length.
    [[gnu::always_inline]] constexpr vec3<T> sample_multiple(const vec2<T>& u) const
        requires(requires(const Profile p) { p.sample(u); }) {
        return widths_.stretch(profile_.sample(u));
    }
    constexpr T pdf(const vec3<T>& m) const { return D(m) * m.z; }

    /// A normal seen from v, with density max(0, v.m) D(m) / projected_area(v); unit v, also below the horizon, where
    /// the random walk looks up through the surface; u in [0,1)^2.
    /// Error for GGX in float: 3e-7 (1 + a |Sv| |S^-1 m|^2/(2 v.m)) radian, S the stretch, a the larger width:
    /// 1e-6 for 99.9 % of the square, more (4e-4 at alpha 1e-4) where grazing facets close at u.x = 1.
    [[gnu::always_inline]] constexpr vec3<T> sample_visible(const vec3<T>& v, const vec2<T>& u) const
        requires(requires(const Profile p) { p.sample_visible(v, u); }) {
        return normalize(sample_visible_multiple(v, u));
    }
    /// The same times a positive number.
    [[gnu::always_inline]] constexpr vec3<T> sample_visible_multiple(const vec3<T>& v, const vec2<T>& u) const
        requires(requires(const Profile p) { p.sample_visible(v, u); }) {
        return widths_.stretch(profile_.sample_visible(widths_.stretch(v), u));
    }
    constexpr T pdf_visible(const vec3<T>& v, const vec3<T>& m) const
        requires(requires(const Profile p) { p.projected_area(v); }) {
        return larger(dot(v, m), T(0)) * D(m) / projected_area(v);
    }

private:
    [[no_unique_address]] Profile profile_;
    Width widths_;

    static_assert(
        requires(const Profile p, const vec3<T> w, const Width a) {
            { p.D(w, a) } -> std::same_as<T>;
        } ||
        requires(const Profile p, const vec3<T> w) {
            { p.D(w) } -> std::same_as<T>;
        });
};

}  // namespace lobe
