// The two numbers of the split sum, exactly.
#pragma once

#include <lobe/brdf/microfacet.hpp>
#include <lobe/energy/albedo.hpp>
#include <lobe/ndf/ggx.hpp>

namespace lobe {

/// The directional albedo of a GGX lobe with Schlick's Fresnel is F0 * scale + F90 * bias: Karis 2013, "Real Shading in
/// Unreal Engine 4". scale = int f (1 - Fc) cos dl, bias = int f Fc cos dl, Fc = (1 - v.m)^5, with F = 1 in f.
template <scalar T>
struct dfg_terms {
    T scale, bias;

    /// E: the albedo of the same lobe at F = 1.
    constexpr T albedo() const { return scale + bias; }
};

namespace detail {

/// Schlick's Fresnel with F0 and F90 taken out: (1 - Fc, Fc) is its spectrum.
struct schlick_terms {
    template <scalar T>
    constexpr vec2<T> operator()(const T& u) const {
        const T w = T(1) - u;
        const T w2 = w * w, Fc = w2 * w2 * w;
        return {T(1) - Fc, Fc};
    }
    constexpr double average() const { return 1; }
};

}  // namespace detail

/// The split-sum terms of isotropic GGX by quadrature.
/// Domain: mu = cos(theta_v) in (0,1], alpha mu >= 1e-13 (alpha from 1e-10 for mu from 1e-3): there within 4e-6 of the
/// limit alpha = 0; below, the rounding of l in double is too much for D, and soon makes a NaN. Computed in double for
/// float. `options` may ask for an order instead of a tolerance: 2 order^2 evaluations.
/// Error: 5e-6 at order 16, 2e-8 at 32, for mu and alpha in [0.001,1].
template <scalar T, class Masking>
dfg_terms<T> dfg_exact(const Masking& masking_model, const T& mu, const alpha<T>& a, const quadrature& options = {}) {
    using W = detail::wide_t<T>;
    assert(mu > T(0) && mu <= T(1) && "dfg_exact: the cosine must be in (0,1]");
    const microfacet lobe{ggx{alpha<W>(W(a.value()))}, masking_model, detail::schlick_terms{}};
    const vec3<W> v = detail::view_at(W(mu));
    const auto f_cos = [&](const vec3<W>& l) { return lobe.f_cos(v, l); };
    const vec2<W> terms = options.order ? detail::hemisphere_integral_at(f_cos, v, lobe.width(), true, options.order)
                                        : hemisphere_integral(f_cos, v, lobe.width(), true, options).value;
    return {T(terms.x), T(terms.y)};
}

}  // namespace lobe
