// A BRDF times a factor: one number, or what a layer above leaves of its light.
#pragma once

#include <lobe/brdf/concepts.hpp>
#include <lobe/core/spectrum.hpp>

#include <cassert>
#include <type_traits>

namespace lobe {

/// A factor of a BRDF: a callable of v and l, one number or a spectrum. It is asked below the horizon too, where the
/// BRDF is 0 and any finite answer will do.
template <class C, class T>
concept factor = requires(const C c, const vec3<T> w) {
    c(w, w);
};

namespace detail {

/// A BRDF's own estimate of its albedo, `albedo_estimate(v)`, or 1.
template <brdf B>
[[gnu::always_inline]] constexpr typename B::spectrum albedo_estimate(const B& b, const vec3<typename B::scalar>& v) {
    if constexpr (requires { b.albedo_estimate(v); })
        return b.albedo_estimate(v);
    else
        return typename B::spectrum(typename B::scalar(1));
}

}  // namespace detail

/// f = base f * share(v, l), in 1/sr. Sampled as the base is. Either may be grey, one number, beside the other's
/// colours.
template <brdf Base, class Factor>
class scaled : exact_vectors<scaled<Base, Factor>> {
    using T = typename Base::scalar;
    static_assert(factor<Factor, T>, "a factor, or a coupling, is a callable of v and l");
    using share_type = std::decay_t<std::invoke_result_t<const Factor&, const vec3<T>&, const vec3<T>&>>;
    using S = detail::mixed_t<T, typename Base::spectrum, share_type>;
    using exact = exact_vectors<scaled>;

public:
    using scalar = T;
    using spectrum = S;
    using exact::f, exact::f_cos, exact::pdf, exact::evaluate, exact::sample;
    static constexpr bool isotropic = Base::isotropic;

    constexpr scaled(const Base& whole, const Factor& part) : base(whole), share(part) {}

    // (Inlined by force, as the factors are: docs/design.md.)
    [[gnu::always_inline]] constexpr S f(const vec3<T>& v, const vec3<T>& l) const {
        return detail::product<T>(base.f(v, l), share(v, l));
    }
    [[gnu::always_inline]] constexpr S f_cos(const vec3<T>& v, const vec3<T>& l) const {
        return detail::product<T>(base.f_cos(v, l), share(v, l));
    }

    [[gnu::always_inline]] constexpr T pdf(const vec3<T>& v, const vec3<T>& l) const requires samplable_brdf<Base> {
        return base.pdf(v, l);
    }
    [[gnu::always_inline]] constexpr evaluation<S, T> evaluate(const vec3<T>& v,
                                                               const vec3<T>& l) const requires samplable_brdf<Base> {
        const auto e = base.evaluate(v, l);
        return {detail::product<T>(e.f_cos, share(v, l)), e.pdf};
    }
    /// A failed sample has weight 0, but its view may be a NaN: the factor is asked at n instead.
    [[gnu::always_inline]] constexpr direction_sample<S, T>
    sample(const vec3<T>& v, const vec2<T>& u) const requires samplable_brdf<Base> {
        const auto s = base.sample(v, u);
        return {s.l, detail::product<T>(s.weight, share(select(s.pdf > T(0), v, s.l), s.l)), s.pdf};
    }

    /// The base's, times the factor of light along the normal: for 1 - F(v.h) nearer to the truth than 1 - F(n.v).
    [[gnu::always_inline]] constexpr S albedo_estimate(const vec3<T>& v) const {
        return detail::product<T>(detail::albedo_estimate(base, v), share(v, vec3<T>{T(0), T(0), T(1)}));
    }
    constexpr vec2<T> width() const { return base.width(); }

    template <class G>
    constexpr void for_each_crease(const G& g) const {
        detail::for_each_crease(base, g);
        detail::for_each_crease(share, g);
    }
    template <class G>
        requires requires(const Base& parts, const G& g) { parts.for_each_lobe(g); }
    constexpr void for_each_lobe(const G& g) const {
        base.for_each_lobe([&](const auto& lobe) { g(scaled<std::decay_t<decltype(lobe)>, Factor>{lobe, share}); });
    }

private:
    Base base;
    [[no_unique_address]] Factor share;
};

/// The same number for all directions: the factor of `weighted`.
template <scalar T>
struct constant_factor {
    T value;
    constexpr T operator()(const vec3<T>&, const vec3<T>&) const { return value; }
};

/// weight * f. The weight is one number, not negative: colour belongs to the BRDF.
template <brdf B>
class weighted : public scaled<B, constant_factor<typename B::scalar>> {
    using T = typename B::scalar;

public:
    constexpr weighted(const T& weight, const B& lobe) : scaled<B, constant_factor<T>>(lobe, {weight}) {
        assert(all(weight >= T(0)) && "weighted: the weight must not be negative");
    }
};

/// What a base under a specular lobe reflects: base f * coupling(v, l). The couplings are in layered.hpp.
template <brdf Base, class Coupling>
class coupled : public scaled<Base, Coupling> {
public:
    constexpr coupled(const Base& below, const Coupling& left_by_the_lobe)
        : scaled<Base, Coupling>(below, left_by_the_lobe) {}
};

}  // namespace lobe
