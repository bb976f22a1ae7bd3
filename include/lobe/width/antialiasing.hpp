// Specular anti-aliasing: the variance of normals within a pixel or a texel becomes a wider distribution.
#pragma once

#include <lobe/width/alpha.hpp>

#include <cassert>

namespace lobe {

// All of it rests on one fact: the slopes that a pixel sees are those of its mean surface plus those of the detail,
// so their covariances add. A Beckmann distribution of width alpha has the slope variance alpha^2/2 along each axis,
// and stays Beckmann when Gaussian slopes are added: exactly alpha'^2 = alpha^2 + 2 variance.
// GGX has no variance; the same rule is an approximation there, too narrow at the core:
// at variance = alpha^2/2 its peak of D is 24 % above that of the average.

/// alpha' = sqrt(alpha^2 + 2 variance); `variance` of the slopes along each axis, at least 0.
/// Olano & Baker 2010, "LEAN Mapping"; exact for Beckmann. Error: 2 ULP.
template <scalar T>
constexpr alpha<T> widened(const alpha<T>& a, const T& variance) {
    using std::sqrt;
    assert(all(variance >= T(0)) && "widened: a variance must not be negative");
    return alpha<T>(sqrt(a.value() * a.value() + T(2) * variance));
}

template <scalar T>
constexpr alpha_xy<T> widened(const alpha_xy<T>& a, const T& variance) {
    using std::sqrt;
    assert(all(variance >= T(0)) && "widened: a variance must not be negative");
    return {sqrt(a.x() * a.x() + T(2) * variance), sqrt(a.y() * a.y() + T(2) * variance)};
}

/// A symmetric matrix of slopes: their covariance, or a second moment.
template <scalar T>
struct slope_matrix {
    T xx, xy, yy;
};

/// The widths of a distribution along axes of its own: `tangent` is the direction of `width.x()`, a unit vector in the
/// tangent plane of the old frame. Shade in `frame{n, at.to_world({tangent.x, tangent.y, 0})}`.
template <scalar T>
struct oriented_width {
    alpha_xy<T> width;
    vec2<T> tangent;
};

namespace detail {

/// The principal axes of a matrix of alpha^2, whose smaller eigenvalue is known to be at least `floor`; the wider axis
/// is x. l1 = mean + r, l2 = det/l1, r^2 = ((xx - yy)/2)^2 + xy^2.
/// Error of the narrower width: 4 ULP times (l1/l2).
template <scalar T>
constexpr oriented_width<T> principal_axes(const slope_matrix<T>& m, const T& floor) {
    using std::sqrt;
    const T d = (m.xx - m.yy) / T(2), r = sqrt(d * d + m.xy * m.xy);
    const T wide = (m.xx + m.yy) / T(2) + r;
    const T narrow = larger((m.xx * m.yy - m.xy * m.xy) / wide, floor);
    const T along = select(r > T(0), r + absolute(d), T(1)), across = m.xy;  // one is a sum, so that nothing cancels
    const T length = sqrt(along * along + across * across);
    return {{sqrt(wide), sqrt(narrow)},
            {select(d < T(0), across, along) / length, select(d < T(0), along, across) / length}};
}

}  // namespace detail

/// The matrix alpha'^2 = diag(ax^2, ay^2) + 2 covariance, along its own axes.
/// Olano & Baker 2010, "LEAN Mapping", section 3.
/// Precondition: `covariance` is positive semidefinite but for rounding.
template <scalar T>
constexpr oriented_width<T> widened(const alpha_xy<T>& a, const slope_matrix<T>& covariance) {
    const T x2 = a.x() * a.x(), y2 = a.y() * a.y();
    return detail::principal_axes(
        slope_matrix<T>{x2 + T(2) * covariance.xx, T(2) * covariance.xy, y2 + T(2) * covariance.yy}, smaller(x2, y2));
}

/// What a texel of a LEAN map holds: the mean b and the second moment M of the slopes.
/// Texels are averaged (mip-mapped, filtered) by adding them and scaling. Olano & Baker 2010.
/// Error: the covariance is a difference, so it is off by ULPs of the second moment: 8 after one averaging.
template <scalar T>
struct lean_moments {
    vec2<T> b;
    slope_matrix<T> M;

    /// Of one normal, any positive multiple of it, above the horizon: slope (-x/z, -y/z).
    static constexpr lean_moments of(const vec3<T>& n) {
        const T x = -n.x / n.z, y = -n.y / n.z;
        return {{x, y}, {x * x, x * y, y * y}};
    }

    friend constexpr lean_moments operator+(const lean_moments& p, const lean_moments& q) {
        return {{p.b.x + q.b.x, p.b.y + q.b.y}, {p.M.xx + q.M.xx, p.M.xy + q.M.xy, p.M.yy + q.M.yy}};
    }
    friend constexpr lean_moments operator*(const lean_moments& p, const T& w) {
        return {{p.b.x * w, p.b.y * w}, {p.M.xx * w, p.M.xy * w, p.M.yy * w}};
    }

    constexpr vec3<T> normal() const { return normalize(vec3<T>{-b.x, -b.y, T(1)}); }

    /// M - b b^T; a variance that rounding would make negative is 0.
    constexpr slope_matrix<T> covariance() const {
        return {larger(M.xx - b.x * b.x, T(0)), M.xy - b.x * b.y, larger(M.yy - b.y * b.y, T(0))};
    }
};

/// The same for isotropic shading, one number less: M is the mean squared length of the slope.
/// Baker 2011, "CLEAN Mapping" (Firaxis).
template <scalar T>
struct clean_moments {
    vec2<T> b;
    T M;

    static constexpr clean_moments of(const vec3<T>& n) {
        const T x = -n.x / n.z, y = -n.y / n.z;
        return {{x, y}, x * x + y * y};
    }

    friend constexpr clean_moments operator+(const clean_moments& p, const clean_moments& q) {
        return {{p.b.x + q.b.x, p.b.y + q.b.y}, p.M + q.M};
    }
    friend constexpr clean_moments operator*(const clean_moments& p, const T& w) {
        return {{p.b.x * w, p.b.y * w}, p.M * w};
    }

    constexpr vec3<T> normal() const { return normalize(vec3<T>{-b.x, -b.y, T(1)}); }

    /// Along each axis: half the trace of the covariance.
    constexpr T variance() const { return larger(M - dot(b, b), T(0)) / T(2); }
};

/// The slope variance that an averaged normal's length tells: (1 - |N|)/|N|. No map but the normals is needed. Lengths
/// above 1, which rounding and 8-bit maps produce, count as 1. Toksvig 2005, "Mipmapping Normal Maps".
/// Too small by 0.2 %, 1.9 %, 8 %, 22 % for Gaussian slopes of variance 0.001, 0.01, 0.05, 0.2.
/// Domain: |N| > 0.
template <scalar T>
constexpr T toksvig_variance(const T& length_of_mean_normal) {
    assert(all(length_of_mean_normal > T(0)) && "toksvig_variance: the mean normal must have a length above 0");
    return larger(T(1) - length_of_mean_normal, T(0)) / length_of_mean_normal;
}

/// Toksvig's own form, for a Phong exponent p: p' = p |N|/(|N| + p (1 - |N|)), and so 1/p' = 1/p + variance.
template <scalar T>
constexpr T toksvig_exponent(const T& p, const T& length_of_mean_normal) {
    assert(all(p >= T(0)) && "toksvig_exponent: an exponent must not be negative");
    return p / (T(1) + p * toksvig_variance(length_of_mean_normal));
}

/// The variance, along each axis, of the unit normal over a pixel whose filter is a Gaussian of variance 1/(2 pi)
/// pixels^2: (|dn/dx|^2 + |dn/dy|^2)/(4 pi). Kaplanyan, Hill, Patney, Lefohn 2016, "Filtering Distributions of Normals
/// for Shading Antialiasing". dn/dx, dn/dy: derivatives of the shading normal, per pixel, in any space.
template <scalar T>
constexpr T pixel_variance(const vec3<T>& dn_dx, const vec3<T>& dn_dy) {
    return (dot(dn_dx, dn_dx) + dot(dn_dy, dn_dy)) * (inv_pi<T>() / T(4));
}

/// alpha'^2 = min(alpha^2 + min(2 pixel_variance, kappa), max(1, alpha^2)), kappa = 0.18:
/// what a deferred renderer can afford. Tokuyoshi & Kaplanyan 2021, "Stable Geometric Specular Antialiasing
/// with Projected-Space NDF Filtering", listing 5. kappa keeps edges, where derivatives mean nothing,
/// from going matte. (Filament: 0.2 and 2 * 0.15 (|dn/dx|^2 + |dn/dy|^2).)
template <scalar T>
constexpr alpha<T> widened_by_pixel(const alpha<T>& a, const vec3<T>& dn_dx, const vec3<T>& dn_dy,
                                    const T& kappa = T(9) / T(50)) {
    using std::sqrt;
    const T a2 = a.value() * a.value();
    return alpha<T>(sqrt(smaller(a2 + smaller(T(2) * pixel_variance(dn_dx, dn_dy), kappa), larger(a2, T(1)))));
}

template <scalar T>
constexpr alpha_xy<T> widened_by_pixel(const alpha_xy<T>& a, const vec3<T>& dn_dx, const vec3<T>& dn_dy,
                                       const T& kappa = T(9) / T(50)) {
    using std::sqrt;
    const T k2 = smaller(T(2) * pixel_variance(dn_dx, dn_dy), kappa), x2 = a.x() * a.x(), y2 = a.y() * a.y();
    return {sqrt(smaller(x2 + k2, larger(x2, T(1)))), sqrt(smaller(y2 + k2, larger(y2, T(1))))};
}

/// The full filter: the half vector's footprint as a matrix.
/// GGX seen from above is, in the disk of (m.x, m.y), a distribution of the squared width W = A/(1 - A), A = alpha^2;
/// there W' = W + K with K = (dh_dx dh_dx^T + dh_dy dh_dy^T)/pi, and A' = W'/(1 + W').
/// Written without W, which is infinite at alpha = 1, B = 1 - A:   A' = (A + K B)(1 + K B)^-1.
/// Tokuyoshi & Kaplanyan 2021, section 4. dh/dx, dh/dy: derivatives of the unit half vector's (x, y)
/// in tangent space, per pixel.
/// Domain: alpha <= 1; so is the result.
template <scalar T>
constexpr oriented_width<T> widened_by_half_vector(const alpha_xy<T>& a, const vec2<T>& dh_dx, const vec2<T>& dh_dy) {
    const T x2 = a.x() * a.x(), y2 = a.y() * a.y();
    assert(all(x2 <= T(1)) && all(y2 <= T(1)) && "widened_by_half_vector: alpha must be at most 1");
    const T bx = (T(1) - a.x()) * (T(1) + a.x()), by = (T(1) - a.y()) * (T(1) + a.y()), s = inv_pi<T>();
    const T xx = s * (dh_dx.x * dh_dx.x + dh_dy.x * dh_dy.x) * bx,
            yy = s * (dh_dx.y * dh_dx.y + dh_dy.y * dh_dy.y) * by;
    const T xy = s * (dh_dx.x * dh_dx.y + dh_dy.x * dh_dy.y) * bx * by;
    const T area = s * (dh_dx.x * dh_dy.y - dh_dx.y * dh_dy.x), det_KB = area * area * bx * by;
    const T det = T(1) + xx + yy + det_KB;
    return detail::principal_axes(
        slope_matrix<T>{(x2 * (T(1) + yy) + xx + det_KB) / det, xy / det, (y2 * (T(1) + xx) + yy + det_KB) / det},
        smaller(x2, y2));
}

}  // namespace lobe
