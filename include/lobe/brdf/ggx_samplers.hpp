// Samplers of visible normals that exist for GGX alone: the hemisphere of 2018 and the bounded caps of 2023.
#pragma once

#include <lobe/brdf/samplers.hpp>
#include <lobe/ndf/ggx.hpp>

#include <limits>

namespace lobe {

// (Inlined by force: docs/design.md.)

namespace detail {

/// The view that the surface of width 1 has of `v`, unit.
template <scalar T>
constexpr vec3<T> stretched_view(const vec2<T>& width, const vec3<T>& v) {
    return normalize(vec3<T>{width.x * v.x, width.y * v.y, v.z});
}

/// The normal of the stretched surface that (x, y, z) was on that of width 1; both of any length.
template <scalar T>
constexpr vec3<T> stretched_normal(const vec2<T>& width, const T& x, const T& y, const T& z) {
    return {width.x * x, width.y * y, z};
}

/// 1 - k of the bounded caps: k = (1 - a^2) s^2/(s^2 + a^2 v.z^2), a = min(ax, ay, 1), s = 1 + sin(theta_v).
template <scalar T>
constexpr T cap_cut(const vec2<T>& width, const vec3<T>& v) {
    using std::sqrt;
    const T a = smaller(smaller(width.x, width.y), T(1)), s = T(1) + sqrt(v.x * v.x + v.y * v.y);
    const T a2 = a * a, s2 = s * s, z2 = v.z * v.z;
    return a2 * (s2 + z2) / (s2 + a2 * z2);
}

}  // namespace detail

/// Visible normals by the projected hemisphere: a point of the disk that faces the view, half of which is squashed,
/// lifted to the hemisphere. Heitz 2018, "Sampling the GGX Distribution of Visible Normals", appendix A. The density of
/// `visible_normals`, pdf = D/(4 sv), from another map of the square: u.x is the squared radius on the disk.
/// Domain: v unit, above the horizon; u in [0,1)^2. GGX only.
/// With t1 and q^2 = 1 - t1^2, t2 in [-q, q] on the disk, all is written in q + t2 and q - t2,
/// whose product is 1 - u.x: no term cancels. Error of m in float: 4e-7 radian. (As printed: 4e-5.)
struct visible_heitz2018 {
    template <scalar T, class Width>
    [[gnu::always_inline]] constexpr vec3<T> sample(const ggx<T, Width>& ndf, const vec3<T>& v,
                                                    const vec2<T>& u) const {
        using std::sqrt;
        const vec2<T> a = ndf.width();
        const vec3<T> w = detail::stretched_view(a, v);
        // the disk's axes are (-y, x, 0) and (-z x, -z y, sine), where (x, y) is the azimuth of w;
        // any will do at the normal
        const T sine2 = w.x * w.x + w.y * w.y, sine = sqrt(sine2);
        // below it the square has lost its digits
        const auto tilted = sine2 > T((std::numeric_limits<lane_t<T>>::min)());
        const T x = quotient(tilted, w.x, sine), y = select(tilted, quotient(tilted, w.y, sine), T(-1));

        const auto [sin_phi, cos_phi] = sincos_2pi(u.y);
        const T r = sqrt(u.x), rest = T(1) - u.x;
        const T t1 = r * cos_phi, t2 = r * sin_phi;
        const T q = sqrt(rest + t2 * t2);                        // sqrt(1 - t1^2): t2 is in [-q, q]
        const T outer = q + absolute(t2), inner = rest / outer;  // 0/0 at u.x = 1 alone
        const T below = select(t2 < T(0), inner, outer), above = select(t2 < T(0), outer, inner);  // q + t2, q - t2

        const T s = (T(1) + w.z) / T(2), t = sine2 / (T(2) * (T(1) + w.z));  // t = 1 - s
        const T p2 = s * below - q * w.z;                                    // t2, squashed from [-q, q] to [-q w.z, q]
        const T up = sqrt(s * (s * rest + T(2) * t * q * above));            // sqrt(1 - t1^2 - p2^2)
        const T sum = up * w.z + absolute(p2) * sine;
        const T z = select(p2 < T(0), s * below * (q * w.z - p2) / sum, sum);  // up w.z + p2 sine
        return detail::stretched_normal(a, up * w.x - t1 * y - p2 * w.z * x, up * w.y + t1 * x - p2 * w.z * y, z);
    }
    template <scalar T, class Width>
    constexpr T area(const ggx<T, Width>&, const vec3<T>&, const T&, const T&, const T& sv) const {
        return sv;
    }
};

/// Visible normals by spherical caps that are cut where all facets reflect v below the horizon, so that fewer samples
/// fail. Eto & Tokuyoshi 2023, "Bounded VNDF Sampling for Smith-GGX Reflections". The cap ends at the height -k V.z
/// instead of -V.z, V the view of the surface of width 1, and what is left shares the probability:
///   area = (k v.z + S)/2 = sv - (1 - k) v.z/2,  pdf = D/(2 (k v.z + S)),  S = sqrt(ax^2 v.x^2 + ay^2 v.y^2 + v.z^2)
/// For reflection only: m is not distributed as visible normals are. Weight = F G2/G1 area/sv:
/// never above that of `visible_normals`.
/// Domain: v unit, above the horizon; u in [0,1)^2; every alpha > 0. GGX only. At alpha = 1 no sample fails.
/// Error of m: as `stretched::sample_visible` says.
struct visible_bounded_caps {
    template <scalar T, class Width>
    [[gnu::always_inline]] constexpr vec3<T> sample(const ggx<T, Width>& ndf, const vec3<T>& v,
                                                    const vec2<T>& u) const {
        using std::sqrt;
        const vec2<T> a = ndf.width();
        const vec3<T> w = detail::stretched_view(a, v);
        const T cut = detail::cap_cut(a, v) * w.z;                     // V.z - b, where b = k V.z
        const T above = T(1) + (w.z - cut);                            // 1 + b
        const T below = (w.x * w.x + w.y * w.y) / (T(1) + w.z) + cut;  // 1 - b
        // of the point on the cap: z - b, from its edge up
        const T z = (T(1) - u.x) * above;
        const T r = sqrt(u.x * above * (z + below));
        const auto [s, c] = sincos_2pi(u.y);
        return detail::stretched_normal(a, r * c + w.x, r * s + w.y, z + cut);
    }
    template <scalar T, class Width>
    [[gnu::always_inline]] constexpr T area(const ggx<T, Width>& ndf, const vec3<T>& v, const T&, const T&,
                                            const T& sv) const {
        return sv - detail::cap_cut(ndf.width(), v) * v.z / T(2);
    }
};

}  // namespace lobe
