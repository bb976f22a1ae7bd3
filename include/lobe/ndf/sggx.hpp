// SGGX, the microflakes of Heitz, Dupuy, Crassin and Dachsbacher.
#pragma once

#include <lobe/core/frame.hpp>
#include <lobe/ndf/concepts.hpp>
#include <lobe/sampling/warp.hpp>

#include <cassert>

namespace lobe {

/// The six numbers of a symmetric 3x3 matrix.
template <scalar T>
struct symmetric_matrix {
    T xx, yy, zz, xy, xz, yz;
};

/// SGGX: flakes oriented like the surface of an ellipsoid, S = A A^T,
///   D(m) = 1 / (pi |S|^(1/2) (m^T S^-1 m)^2),   sigma(w) = sqrt(w^T S w).
/// Heitz, Dupuy, Crassin & Dachsbacher 2015, "The SGGX Microflake Distribution", eq. 10 and 13. Kept as A, whose
/// columns are the axes of the ellipsoid or any that give the same S, so that nothing is squared: sigma = |A^T w|, m^T
/// S^-1 m = |A^-1 m|^2. A volume, not a surface: flakes have two sides, D is symmetric and lives on the whole sphere,
/// int D(m) |w.m| dm = 2 sigma(w), and there is no Lambda; so it is no `distribution` for `microfacet`. Above the
/// horizon its D is that of GGX.
/// Domain: S positive definite (axes may be left-handed, as frames of mirrored UVs are); any direction; D in 1/sr.
/// Error of D: 16 ULP, of sigma: 4 ULP, for axes along x, y and z; in other orthogonal ones up to the ratio
/// of the largest area to the smallest times that, where w is across the larger axes, m across the smaller ones:
/// areas of 1 and 0.001, 782 and 122 ULP.
template <scalar T>
class sggx {
public:
    using scalar = T;

    /// Flakes of a surface around n = (0,0,1): S = diag(alpha^2, alpha^2, 1).
    template <detail::width_of<T> Width>
    constexpr explicit sggx(const Width& width)
        : sggx(vec3<T>{width.x(), T(0), T(0)}, {T(0), width.y(), T(0)}, {T(0), T(0), T(1)}) {}
    template <detail::number_type N>
    constexpr explicit sggx(const N& bare) : sggx(detail::refused_width<T>(bare)) {}

    /// From the eigenvectors of S and the roots of its eigenvalues: the projected areas along them, all > 0.
    constexpr sggx(const frame<T>& axes, const vec3<T>& areas)
        : sggx(areas.x * axes.t, areas.y * axes.b, areas.z * axes.n) {}

    /// Flakes around a fibre along `axes.n`: areas 1, 1, alpha.
    static constexpr sggx fiber(const frame<T>& axes, const alpha<T>& width) {
        return sggx(axes, {T(1), T(1), width.value()});
    }

    /// From S itself, by Cholesky: textures of S are filtered as matrices. Precondition: positive definite.
    static constexpr sggx from_matrix(const symmetric_matrix<T>& S) {
        using std::sqrt;
        assert(all(S.xx > T(0)) && "sggx: S must be positive definite");
        const T a = sqrt(S.xx), b = S.xy / a, c = S.xz / a;
        assert(all(S.yy - b * b > T(0)) && "sggx: S must be positive definite");
        const T d = sqrt(S.yy - b * b), e = (S.yz - b * c) / d;
        assert(all(S.zz - c * c - e * e > T(0)) && "sggx: S must be positive definite");
        return sggx({a, b, c}, {T(0), d, e}, {T(0), T(0), sqrt(S.zz - c * c - e * e)});
    }
    constexpr symmetric_matrix<T> matrix() const {
        const auto entry = [&](int i, int j) { return x[i] * x[j] + y[i] * y[j] + z[i] * z[j]; };
        return {entry(0, 0), entry(1, 1), entry(2, 2), entry(0, 1), entry(0, 2), entry(1, 2)};
    }

    /// 1/sr, any positive or negative multiple of m.
    constexpr T D(const vec3<T>& m) const {
        const vec3<T> yz = cross(y, z), zx = cross(z, x), xy = cross(x, y);
        const vec3<T> cofactor{dot(yz, m), dot(zx, m), dot(xy, m)};  // |A| A^-1 m
        const T det = absolute(dot(x, yz)), k = det * dot(m, m) / dot(cofactor, cofactor);
        return det * k * k * inv_pi<T>();
    }

    /// sigma(w) of unit w: the projected area of the flakes, equal from both sides.
    constexpr T projected_area(const vec3<T>& w) const { return length(seen(w)); }

    /// Flakes facing v, with density max(0, v.m) D(m) / sigma(v): the facing half of a sphere by cosine, stretched with
    /// the ellipsoid. Unit v, anywhere; u in [0,1)^2.
    constexpr vec3<T> sample_visible(const vec3<T>& v, const vec2<T>& u) const {
        const vec3<T> h = frame<T>(normalize(seen(v))).to_world(square_to_cosine_hemisphere(u));
        return normalize(h.x * x + h.y * y + h.z * z);
    }
    constexpr T pdf_visible(const vec3<T>& v, const vec3<T>& m) const {
        return larger(dot(v, m), T(0)) * D(m) / projected_area(v);
    }

private:
    constexpr sggx(const vec3<T>& column_x, const vec3<T>& column_y, const vec3<T>& column_z)
        : x(column_x), y(column_y), z(column_z) {
        assert(all(absolute(dot(x, cross(y, z))) > T(0)) && "sggx: the axes must span space and the areas be above 0");
    }
    constexpr vec3<T> seen(const vec3<T>& w) const { return {dot(x, w), dot(y, w), dot(z, w)}; }

    vec3<T> x, y, z;
};
template <class W>
sggx(W) -> sggx<detail::number_t<W>>;

}  // namespace lobe
