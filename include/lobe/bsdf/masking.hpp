// Masking across an interface, where v and l see the microsurface from opposite sides.
#pragma once

#include <lobe/brdf/masking.hpp>
#include <lobe/numeric/beta_ratio.hpp>

namespace lobe {

/// A masking model of an interface for the distribution N is a masking model, for reflection, and for refraction
/// - `correlation(ndf, v, l, sv, sl)` = G2(v,l) / (G1(v) G1(l)): v and l both above the horizon, l mirrored there, with
///   their projected areas.
template <class M, class N>
concept interface_masking = masking<M, N> &&
    requires(const M model, const N ndf, const vec3<typename N::scalar> w, const typename N::scalar area) {
    { model.correlation(ndf, w, w, area, area) } -> std::same_as<typename N::scalar>;
};

namespace detail {

/// Lambda = sigma/cos - 1, to the digits of 1 + Lambda.
template <scalar T>
constexpr T lambda_of(const T& area, const T& cosine) {
    return larger(quotient(cosine > horizon<T>(), area - cosine, cosine), T(0));
}

}  // namespace detail

/// Heights and both directions correlated: reflection as `smith_correlated`, refraction
///   G2 = B(1 + Lambda(v), 1 + Lambda(l)), B the Beta function.
/// Heitz, Hanika, d'Eon, Dachsbacher 2016, section 5.2: what the random walk's first facet does. Up to 0.0873 below the
/// product form, at Lambda = 1.3 for both.
/// Branch-free: B/(G1 G1) by `detail::beta_ratio_fit`. Error of G2: absolute 1.5e-6 in float, 2.1e-7 in double.
struct smith_joint : smith_correlated {
    template <distribution N, class T = typename N::scalar>
    [[gnu::always_inline]] constexpr T correlation(const N&, const vec3<T>& v, const vec3<T>& l, const T& sv,
                                                   const T& sl) const {
        return detail::beta_ratio_fit(detail::lambda_of(sv, v.z), detail::lambda_of(sl, l.z));
    }
};

/// The same to rounding. Scalar types only.
struct smith_joint_exact : smith_correlated {
    template <distribution N, class T = typename N::scalar>
        requires(detail::one_lane<T>)
    constexpr T correlation(const N&, const vec3<T>& v, const vec3<T>& l, const T& sv, const T& sl) const {
        return detail::beta_ratio(detail::lambda_of(sv, v.z), detail::lambda_of(sl, l.z));
    }
};

/// Masking and shadowing independent of each other: G2 = G1(v) G1(l) for both. Walter et al. 2007, eq. 23.
struct smith_product : smith_separable {
    template <distribution N, class T = typename N::scalar>
    constexpr T correlation(const N&, const vec3<T>&, const vec3<T>&, const T&, const T&) const {
        return T(1);
    }
};

}  // namespace lobe
