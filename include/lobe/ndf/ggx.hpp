// GGX, the distribution of Trowbridge and Reitz.
#pragma once

#include <lobe/ndf/stretched.hpp>

namespace lobe {

/// GGX at alpha = 1: the normals of a hemisphere, and so of half an ellipsoid once it is stretched.
template <scalar T>
struct ggx_profile {
    constexpr T D(const vec3<T>&) const { return inv_pi<T>(); }

    /// (|w| + w.z)/2 above the horizon; the same without cancellation below, (w.x^2 + w.y^2)/(2 (|w| - w.z)).
    constexpr T projected_area(const vec3<T>& w) const {
        using std::sqrt;
        const T q = w.x * w.x + w.y * w.y;
        const T sum = sqrt(q + w.z * w.z) + absolute(w.z);
        return select(w.z < T(0), q / sum, sum) / T(2);
    }

    /// The same where w is known to be above the horizon: no division.
    constexpr T projected_area_above(const vec3<T>& w) const {
        using std::sqrt;
        return (sqrt(w.x * w.x + w.y * w.y + w.z * w.z) + w.z) / T(2);
    }

    /// The area seen from w and that seen from -w: |w|.
    constexpr T projected_area_both(const vec3<T>& w) const {
        using std::sqrt;
        return sqrt(w.x * w.x + w.y * w.y + w.z * w.z);
    }

    /// (|w|/w.z - 1)/2; above the horizon as (w.x^2 + w.y^2)/(2 w.z (|w| + w.z)).
    constexpr T lambda(const vec3<T>& w) const {
        using std::sqrt;
        const T q = w.x * w.x + w.y * w.y;
        const T sum = sqrt(q + w.z * w.z) + absolute(w.z);
        return select(w.z < T(0), sum, q / sum) / (T(2) * w.z);
    }

    /// Inverse CDF (Walter et al. 2007, eq. 35-36): the cosine hemisphere.
    constexpr vec3<T> sample(const vec2<T>& u) const {
        using std::sqrt;
        const auto [s, c] = sincos_2pi(u.y);
        const T r = sqrt(u.x);
        return {r * c, r * s, sqrt(T(1) - u.x)};
    }

    /// Spherical caps: w plus a vector of its length, uniform on the cap that w's mirror image sees. Dupuy & Benyoub
    /// 2023, "Sampling Visible GGX Normals with Spherical Caps", listing 3, here for w of any length, and with the sine
    /// of the cap from components: its sqrt(1 - z^2) is wrong by up to 17 times for small u.x in float.
    constexpr vec3<T> sample_visible(const vec3<T>& w, const vec2<T>& u) const {
        using std::sqrt;
        const T q = w.x * w.x + w.y * w.y;
        const T sum = sqrt(q + w.z * w.z) + absolute(w.z);
        const T height = select(w.z < T(0), q / sum, sum);  // |w| + w.z
        const T z = (T(1) - u.x) * height;
        const T r = sqrt(u.x * (height * z + q));
        const auto [s, c] = sincos_2pi(u.y);
        return {r * c + w.x, r * s + w.y, z};
    }
};

/// GGX: D = alpha^2 / (pi (alpha^2 cos^2 + sin^2)^2), isotropic from `alpha`, anisotropic from `alpha_xy`.
/// Trowbridge & Reitz 1975; Walter et al. 2007, eq. 33; anisotropic: Burley 2012, eq. 13. Projected area and Lambda:
/// Heitz 2014, eq. 72, 86, in the form (S + cos)/2, S^2 = ax^2 x^2 + ay^2 y^2 + z^2.
/// Domain: alpha >= 1e-6, where the errors hold (D along the normal is finite from 1.2e-19 in float, 1.5e-153 in
/// double; of `alpha_xy` the product); m of any length from 1e-12 to 1e12; cosines of 1e-6 and more, and the whole
/// sphere for the projected area. D in 1/sr.
/// Error: D 12 ULP, projected area 4 (5 below the horizon), Lambda 8: no term cancels.
template <scalar T, detail::width_of<T> Width = alpha<T>>
class ggx : public stretched<ggx_profile<T>, Width> {
public:
    constexpr explicit ggx(const Width& width) : stretched<ggx_profile<T>, Width>({}, width) {}

private:
    static_assert(samplable_distribution<stretched<ggx_profile<T>, Width>>);
    static_assert(visibly_samplable_distribution<stretched<ggx_profile<T>, Width>>);
};
template <class W>
ggx(W) -> ggx<detail::number_t<W>, detail::width_t<W>>;

}  // namespace lobe
