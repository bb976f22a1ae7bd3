// A tinted interface: spectra as weights of its two parts.
#pragma once

#include <lobe/bsdf/smooth_dielectric.hpp>
#include <lobe/core/spectrum.hpp>

namespace lobe {

/// Any BSDF of one number, rough or smooth, times a spectrum S where it reflects and another where it transmits: an
/// artist's tints. (Coloured glass absorbs on the way: Beer's law, between its interfaces.) Sampled as the base is.
template <class B, class S>
class tinted : exact_vectors<tinted<B, S>> {
    using T = typename B::scalar;
    using exact = exact_vectors<tinted>;
    static_assert(std::same_as<typename B::spectrum, T>,
                  "tinted: a base of one number, which the tints make spectra of");

public:
    using scalar = T;
    using spectrum = S;
    using exact::f, exact::f_cos, exact::pdf, exact::evaluate, exact::sample;
    static constexpr bool transmits = true;

    constexpr tinted(const B& bsdf, const S& reflection, const S& transmission)
        : base(bsdf), reflected(reflection), transmitted(transmission) {
        assert(detail::in_unit_interval(reflection) && detail::in_unit_interval(transmission) &&
               "tinted: tints must be in [0,1]");
    }

    [[gnu::always_inline]] constexpr S f(const vec3<T>& v, const vec3<T>& l) const requires bsdf<B> {
        return tint(v, l, base.f(v, l));
    }
    [[gnu::always_inline]] constexpr S f_cos(const vec3<T>& v, const vec3<T>& l) const requires bsdf<B> {
        return tint(v, l, base.f_cos(v, l));
    }
    [[gnu::always_inline]] constexpr T pdf(const vec3<T>& v, const vec3<T>& l) const requires bsdf<B> {
        return base.pdf(v, l);
    }
    [[gnu::always_inline]] constexpr evaluation<S, T> evaluate(const vec3<T>& v,
                                                               const vec3<T>& l) const requires bsdf<B> {
        const auto e = base.evaluate(v, l);
        return {tint(v, l, e.f_cos), e.pdf};
    }

    [[gnu::always_inline]] constexpr direction_sample<S, T> sample(const vec3<T>& v,
                                                                   const vec3<T>& u) const requires bsdf<B> {
        const auto s = base.sample(v, u);
        return {s.l, tint(v, s.l, s.weight), s.pdf};
    }
    [[gnu::always_inline]] constexpr discrete_sample<S, T> sample(const vec3<T>& v, const T& u) const
        requires(!bsdf<B>) {
        const auto s = base.sample(v, u);
        return {s.l, tint(v, s.l, s.weight), s.probability};
    }

    constexpr vec2<T> width() const requires bsdf<B> { return base.width(); }

private:
    [[gnu::always_inline]] constexpr S tint(const vec3<T>& v, const vec3<T>& l, const T& value) const {
        const auto reflects = select(v.z < T(0), -l.z, l.z) > T(0);
        return reflected * select(reflects, value, T(0)) + transmitted * select(reflects, T(0), value);
    }

    B base;
    S reflected, transmitted;
};

}  // namespace lobe
