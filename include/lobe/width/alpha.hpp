// The width of a distribution of normals, as types: a bare number is never taken for a width or for a roughness.
#pragma once

#include <lobe/core/vector.hpp>

#include <cassert>

namespace lobe {

/// The width alpha of an isotropic distribution (Walter et al. 2007): the scale of its slopes.
/// Precondition: alpha > 0, finite. Artists' roughness is converted by name, and a floor is written
/// where the number is born.
template <scalar T>
class alpha {
public:
    using scalar = T;
    static constexpr bool isotropic = true;

    constexpr explicit alpha(const T& value) : a(value) {
        assert(all(a > T(0)) && all(detail::finite(a)) && "alpha must be above 0 and finite");
    }

    /// Not chosen by `alpha{0.3f}`, nor by any other direct initialisation: reached where a bare number is given for a
    /// width, as in `ggx<float>{0.3f}`, and says what to write.
    template <std::same_as<T> N>
    constexpr alpha(const N&) : a(1) {
        static_assert(!lobe::scalar<N>,
                      "a bare number is no width: write alpha{0.3f}, or alpha<float>::from_roughness(r)");
    }

    /// alpha = r^2 (Burley 2012, "Physically-Based Shading at Disney", section 5.4),
    /// at least `floor`: textures contain 0.
    static constexpr alpha from_roughness(const T& r, const T& floor = T(0)) { return at_least(r * r, floor); }
    static constexpr alpha at_least(const T& value, const T& floor) { return alpha(larger(value, floor)); }

    constexpr T value() const { return a; }
    constexpr T x() const { return a; }
    constexpr T y() const { return a; }

    /// A direction of the microsurface of width 1 and what it becomes when the surface is stretched, (a x, a y, z):
    /// the map of normals from width 1 to this width, and of views from this width to width 1. Not normalised.
    constexpr vec3<T> stretch(const vec3<T>& w) const { return {a * w.x, a * w.y, w.z}; }

    /// A positive multiple of the normal that `stretch` maps to m.
    constexpr vec3<T> unstretch(const vec3<T>& m) const { return {m.x, m.y, a * m.z}; }

    /// D(m) of the stretched distribution over D of the one of width 1 at `unstretch(m)`, for any positive multiple of
    /// m: ( a (m.m) / (x^2 + y^2 + a^2 z^2) )^2. Components, because 1 - z^2 cancels; no square of a^2.
    constexpr T density_ratio(const vec3<T>& m) const {
        const vec3<T> s = unstretch(m);
        const T q = dot(s, s), k = quotient(q > T(0), a * dot(m, m), q);
        return k * k;
    }

private:
    T a;
};

/// The widths of an anisotropic distribution along the tangent and the bitangent.
/// Precondition: both > 0, finite. The makers below take the artists' roughness r in [0,1] and a degree of anisotropy,
/// 0 for none; r = 0 and the far end of two of the degrees mean a width of 0: a floor takes both from textures.
template <scalar T>
class alpha_xy {
public:
    using scalar = T;
    static constexpr bool isotropic = false;

    constexpr alpha_xy(const T& along_x, const T& along_y) : ax(along_x), ay(along_y) {
        assert(all(ax > T(0)) && all(detail::finite(ax)) && "alpha_xy: both widths must be above 0 and finite");
        assert(all(ay > T(0)) && all(detail::finite(ay)) && "alpha_xy: both widths must be above 0 and finite");
    }

    static constexpr alpha_xy at_least(const T& along_x, const T& along_y, const T& floor) {
        return alpha_xy(larger(along_x, floor), larger(along_y, floor));
    }

    /// x = r^2/aspect, y = r^2 aspect, aspect = sqrt(1 - 0.9 a), a in [0,1]: x y = r^4, x/y at most 10.
    /// Burley 2012, "Physically-Based Shading at Disney", section 5.4. Error: 6 ULP.
    static constexpr alpha_xy from_disney(const T& r, const T& a, const T& floor = T(0)) {
        using std::sqrt;
        assert(all(a >= T(0)) && all(a <= T(1)) && "from_disney: the anisotropy must be in [0,1]");
        const T aspect = sqrt(T(1) - T(9) / T(10) * a);
        return at_least(r * r / aspect, r * r * aspect, floor);
    }

    /// x = r^2 (1 + k), y = r^2 (1 - k), k in [-1,1]: x + y = 2 r^2; needs a floor at k = +-1,
    /// which have a width of 0. Kulla & Conty 2017, "Revisiting Physically Based Shading at Imageworks". Error: 2 ULP.
    static constexpr alpha_xy from_imageworks(const T& r, const T& k, const T& floor = T(0)) {
        assert(all(k >= T(-1)) && all(k <= T(1)) && "from_imageworks: the anisotropy must be in [-1,1]");
        return at_least(r * r * (T(1) + k), r * r * (T(1) - k), floor);
    }

    /// x = r^2 sqrt(2/(1 + (1-a)^2)), y = (1-a) x, a in [0,1]: x^2 + y^2 = 2 r^4; needs a floor at a = 1, which has a
    /// width of 0. OpenPBR 1.1 (2024), "Microfacet model".
    /// Error: 4 ULP.
    static constexpr alpha_xy from_openpbr(const T& r, const T& a, const T& floor = T(0)) {
        using std::sqrt;
        assert(all(a >= T(0)) && all(a <= T(1)) && "from_openpbr: the anisotropy must be in [0,1]");
        const T narrow = T(1) - a, x = r * r * sqrt(T(2) / (T(1) + narrow * narrow));
        return at_least(x, narrow * x, floor);
    }

    constexpr T x() const { return ax; }
    constexpr T y() const { return ay; }

    constexpr vec3<T> stretch(const vec3<T>& w) const { return {ax * w.x, ay * w.y, w.z}; }
    constexpr vec3<T> unstretch(const vec3<T>& m) const { return {ay * m.x, ax * m.y, ax * ay * m.z}; }

    /// (m.m)^2 / (ax ay ((x/ax)^2 + (y/ay)^2 + z^2)^2). Numerator and denominator share the squares,
    /// so what rounding does to them cancels.
    constexpr T density_ratio(const vec3<T>& m) const {
        const T xx = m.x * m.x, yy = m.y * m.y, zz = m.z * m.z, p = ax * ay;
        const T q = ay / ax * xx + ax / ay * yy + p * zz, k = quotient(q > T(0), xx + yy + zz, q);
        return k * k * p;
    }

private:
    T ax, ay;
};

namespace detail {

/// `alpha` and `alpha_xy`.
template <class W>
concept width_type = scalar<typename W::scalar> && requires(const W width, const vec3<typename W::scalar> w) {
    { W::isotropic } -> std::convertible_to<bool>;
    { width.x() } -> std::same_as<typename W::scalar>;
    { width.y() } -> std::same_as<typename W::scalar>;
    { width.stretch(w) } -> std::same_as<vec3<typename W::scalar>>;
    { width.unstretch(w) } -> std::same_as<vec3<typename W::scalar>>;
    { width.density_ratio(w) } -> std::same_as<typename W::scalar>;
};
template <class W, class T>
concept width_of = width_type<W> && std::same_as<typename W::scalar, T>;
template <class W, class T>
concept one_width_of = width_of<W, T> && W::isotropic;
template <class N>
concept number_type = scalar<N> || std::integral<N>;

/// The width of a distribution of T that is written with what is none for it: an error that says what to write. (Each
/// is of a function, so that the class itself is sound, and nothing that is made of it adds another error.)
template <scalar T>
struct refused_width : alpha<T> {
    constexpr refused_width(const alpha<T>& width) : alpha<T>(width) {}

    template <number_type N>
    constexpr refused_width(const N&) : alpha<T>(T(1)) {
        static_assert(!scalar<T>, "a bare number is no width: write alpha{0.3f}, or alpha<float>::from_roughness(r)");
    }
    constexpr refused_width(const alpha_xy<T>&) : alpha<T>(T(1)) {
        static_assert(!scalar<T>,
                      "this family of distributions is not shape-invariant: it has one width, alpha, and no alpha_xy");
    }
    template <width_type W>
    constexpr refused_width(const W&) : alpha<T>(T(1)) {
        static_assert(!scalar<T>, "the numbers of a distribution are of one type: gtr{alpha{0.3f}, 1.5f}, not 1.5");
    }
};

}  // namespace detail

}  // namespace lobe
