// The sum of BRDFs, each with a weight: two specular lobes, a diffuse base under a coat.
#pragma once

#include <lobe/brdf/concepts.hpp>

#include <tuple>

namespace lobe {

/// weight * f. The weight is one number: colour belongs to the BRDF.
template <brdf B>
class weighted : exact_vectors {
    using T = typename B::scalar;
    using S = typename B::spectrum;

public:
    using scalar = T;
    using spectrum = S;
    using exact_vectors::f, exact_vectors::f_cos;
    static constexpr bool isotropic = B::isotropic;

    constexpr weighted(const T& weight, const B& lobe) : w(weight), b(lobe) {}

    constexpr S f(const vec3<T>& v, const vec3<T>& l) const { return b.f(v, l) * w; }
    constexpr S f_cos(const vec3<T>& v, const vec3<T>& l) const { return b.f_cos(v, l) * w; }
    constexpr vec2<T> width() const { return b.width(); }

    template <class G>
        requires requires(const B& parts, const G& g) { parts.for_each_lobe(g); }
    constexpr void for_each_lobe(const G& g) const {
        b.for_each_lobe([&](const auto& lobe) { g(weighted<std::decay_t<decltype(lobe)>>{w, lobe}); });
    }

private:
    T w;
    B b;
};

/// f1 + f2 + ... Nothing is shared between the lobes: what one takes from another is the business of its weight.
/// `for_each_lobe(g)` calls g with each: quadrature integrates them separately, each on its own width.
template <brdf First, brdf... Rest>
class sum : exact_vectors {
    using T = typename First::scalar;
    using S = typename First::spectrum;
    static_assert((std::same_as<T, typename Rest::scalar> && ...), "the lobes of a sum share one scalar type");
    static_assert((std::same_as<S, typename Rest::spectrum> && ...), "the lobes of a sum share one spectrum type");

public:
    using scalar = T;
    using spectrum = S;
    using exact_vectors::f, exact_vectors::f_cos;
    static constexpr bool isotropic = First::isotropic && (Rest::isotropic && ...);

    constexpr explicit sum(const First& first, const Rest&... rest) : lobes(first, rest...) {}

    constexpr S f(const vec3<T>& v, const vec3<T>& l) const {
        return std::apply([&](const auto& first, const auto&... rest) { return (first.f(v, l) + ... + rest.f(v, l)); }, lobes);
    }
    constexpr S f_cos(const vec3<T>& v, const vec3<T>& l) const {
        return std::apply([&](const auto& first, const auto&... rest) { return (first.f_cos(v, l) + ... + rest.f_cos(v, l)); }, lobes);
    }

    /// The narrowest along each axis.
    constexpr vec2<T> width() const {
        vec2<T> narrowest = std::get<0>(lobes).width();
        for_each_lobe([&](const auto& lobe) {
            const vec2<T> w = lobe.width();
            narrowest = {min(narrowest.x, w.x), min(narrowest.y, w.y)};
        });
        return narrowest;
    }

    template <class G>
    constexpr void for_each_lobe(const G& g) const {
        std::apply([&](const auto&... lobe) { (g(lobe), ...); }, lobes);
    }

private:
    std::tuple<First, Rest...> lobes;
};

}  // namespace lobe
