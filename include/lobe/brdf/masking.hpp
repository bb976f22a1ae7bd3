// Smith's masking and shadowing, written on the projected area: one function a model, its denominator.
#pragma once

#include <lobe/ndf/concepts.hpp>

namespace lobe {

/// What follows from a masking model's denominator. `Model` supplies `denominator(ndf, v, l, sv)`, where sv is
/// ndf.projected_area(v), which callers usually have.
template <class Model>
struct masking_functions {
    template <distribution N, class T = typename N::scalar>
    constexpr T denominator(const N& ndf, const vec3<T>& v, const vec3<T>& l) const {
        return model().denominator(ndf, v, l, ndf.projected_area(v));
    }

    /// V = G2 / (4 cos(theta_v) cos(theta_l)): finite at grazing angles; v and l above the horizon.
    template <distribution N, class T = typename N::scalar>
    constexpr T visibility(const N& ndf, const vec3<T>& v, const vec3<T>& l) const {
        return T(1) / (T(4) * denominator(ndf, v, l));
    }

    /// The fraction of the microsurface facing both v and l that both see.
    template <distribution N, class T = typename N::scalar>
    constexpr T G2(const N& ndf, const vec3<T>& v, const vec3<T>& l) const {
        return v.z * l.z / denominator(ndf, v, l);
    }

    /// ... that v sees: cos(theta_v) / projected_area(v) = 1/(1 + Lambda(v)).
    template <distribution N, class T = typename N::scalar>
    constexpr T G1(const N& ndf, const vec3<T>& v) const {
        return v.z / ndf.projected_area(v);
    }

private:
    constexpr const Model& model() const { return static_cast<const Model&>(*this); }
};

/// Masking and shadowing independent of each other: G2 = G1(v) G1(l). Smith 1967; Walter et al. 2007, eq. 23.
/// Simpler than the correlated form and darker than a real height field, by up to 0.09.
struct smith_separable : masking_functions<smith_separable> {
    using masking_functions::denominator;
    template <distribution N, class T = typename N::scalar>
    constexpr T denominator(const N& ndf, const vec3<T>&, const vec3<T>& l, const T& sv) const {
        return sv * ndf.projected_area(l);
    }
};

/// Masking and shadowing correlated through the height: G2 = 1/(1 + Lambda(v) + Lambda(l)). Ross, Dion, Potvin 2005; Heitz
/// 2014, eq. 99. The consistent default: it is what the random walk's first bounce does.
/// den = sv cos_l + sl cos_v - cos_v cos_l, grouped so that it rounds least (4 ULP).
struct smith_correlated : masking_functions<smith_correlated> {
    using masking_functions::denominator;
    template <distribution N, class T = typename N::scalar>
    constexpr T denominator(const N& ndf, const vec3<T>& v, const vec3<T>& l, const T& sv) const {
        return sv * l.z + (ndf.projected_area(l) - l.z) * v.z;
    }
};

/// A masking model for the distribution N.
template <class M, class N>
concept masking = distribution<N> && requires(const M model, const N ndf, const vec3<typename N::scalar> w) {
    { model.denominator(ndf, w, w) } -> std::same_as<typename N::scalar>;
    { model.denominator(ndf, w, w, w.z) } -> std::same_as<typename N::scalar>;
};

}  // namespace lobe
