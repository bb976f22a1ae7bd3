// The sum of BRDFs, each with a weight: two specular lobes, a diffuse base under a coat.
// Sampled by a one-sample mixture.
#pragma once

#include <lobe/brdf/scaled.hpp>
#include <lobe/core/spectrum.hpp>

#include <array>
#include <cassert>
#include <tuple>
#include <utility>

namespace lobe {

namespace detail {

/// The mean of a spectrum's components; 1 for a type of the user's own without begin() and end().
template <scalar T, class S>
constexpr T mean(const S& s) {
    if constexpr (std::same_as<S, T>) {
        return s;
    } else if constexpr (std::same_as<S, vec3<T>>) {
        return (s.x + s.y + s.z) / T(3);
    } else if constexpr (requires {
                             T(*s.begin());
                             s.end();
                         }) {
        T total(0), count(0);
        for (const auto& component : s) total = total + T(component), count = count + T(1);
        return total / count;
    } else {
        return T(1);
    }
}

}  // namespace detail

/// f1 + f2 + ... Nothing is shared between the lobes: what one takes from another is for its weight to say.
/// Two specular lobes, each with a masking of its own: `sum{weighted{1 - t, a}, weighted{t, b}}`.
/// A lobe may be grey, of one number, beside the others' colours: its Fresnel reflectance is asked once.
/// `for_each_lobe(g)` calls g with each: quadrature integrates them separately, each on its own width.
///
/// Sampled, where all lobes are, by a one-sample mixture (Veach 1997, "Robust Monte Carlo Methods for Light Transport
/// Simulation", section 9.2.4, with the balance heuristic):
///   pdf = sum p_i pdf_i,  weight = sum f_i cos / pdf,  p_i in proportion to the mean of lobe i's `albedo_estimate(v)`.
/// u.x chooses, and is rescaled to [0,1). Branch-free, so it draws from every lobe and keeps one; the weight
/// stays below max_i(weight_i / p_i). Fails where the chosen lobe does. A lobe whose estimate is 0 is left to the
/// samples of the others.
template <brdf First, brdf... Rest>
class sum : exact_vectors<sum<First, Rest...>> {
    using T = typename First::scalar;
    using S = typename detail::mixed<T, typename First::spectrum, typename Rest::spectrum...>::type;
    using exact = exact_vectors<sum>;
    template <class X>
    static constexpr bool one_of = std::same_as<X, S> || std::same_as<X, T>;
    static_assert((std::same_as<T, typename Rest::scalar> && ...), "the lobes of a sum share one scalar type");
    static_assert(one_of<typename First::spectrum> && (one_of<typename Rest::spectrum> && ...),
                  "the lobes of a sum share one spectrum type, or are grey: of one number");

public:
    using scalar = T;
    using spectrum = S;
    using exact::f, exact::f_cos, exact::pdf, exact::evaluate, exact::sample;
    static constexpr bool isotropic = First::isotropic && (Rest::isotropic && ...);
    static constexpr bool samplable = samplable_brdf<First> && (samplable_brdf<Rest> && ...);

    constexpr explicit sum(const First& first, const Rest&... rest) : lobes(first, rest...) {}

    // (Inlined by force, and without std::apply: docs/design.md.)
    [[gnu::always_inline]] constexpr S f(const vec3<T>& v, const vec3<T>& l) const { return f(v, l, every_lobe); }
    [[gnu::always_inline]] constexpr S f_cos(const vec3<T>& v, const vec3<T>& l) const {
        return f_cos(v, l, every_lobe);
    }

    [[gnu::always_inline]] constexpr T pdf(const vec3<T>& v, const vec3<T>& l) const requires samplable {
        return pdf(v, l, every_lobe);
    }

    [[gnu::always_inline]] constexpr evaluation<S, T> evaluate(const vec3<T>& v,
                                                               const vec3<T>& l) const requires samplable {
        return evaluate(given_none_before(v, every_lobe), v, l, every_lobe);
    }

    [[gnu::always_inline]] constexpr direction_sample<S, T> sample(const vec3<T>& v,
                                                                   const vec2<T>& u) const requires samplable {
        return sample(v, u, every_lobe);
    }

    [[gnu::always_inline]] constexpr S albedo_estimate(const vec3<T>& v) const {
        return albedo_estimate(v, every_lobe);
    }

    /// The narrowest along each axis.
    constexpr vec2<T> width() const {
        vec2<T> narrowest = std::get<0>(lobes).width();
        for_each_lobe([&](const auto& lobe) {
            const vec2<T> w = lobe.width();
            narrowest = {smaller(narrowest.x, w.x), smaller(narrowest.y, w.y)};
        });
        return narrowest;
    }

    template <class G>
    constexpr void for_each_lobe(const G& g) const {
        for_each_lobe(g, every_lobe);
    }

private:
    static constexpr std::size_t count = 1 + sizeof...(Rest);
    static constexpr auto every_lobe = std::make_index_sequence<count>{};
    using probabilities = std::array<T, count>;

    template <class G, std::size_t... i>
    constexpr void for_each_lobe(const G& g, std::index_sequence<i...>) const {
        (g(std::get<i>(lobes)), ...);
    }

    template <std::size_t... i>
    [[gnu::always_inline]] constexpr S f(const vec3<T>& v, const vec3<T>& l, std::index_sequence<i...>) const {
        return (S(std::get<i>(lobes).f(v, l)) + ...);
    }
    template <std::size_t... i>
    [[gnu::always_inline]] constexpr S f_cos(const vec3<T>& v, const vec3<T>& l, std::index_sequence<i...>) const {
        return (S(std::get<i>(lobes).f_cos(v, l)) + ...);
    }
    template <std::size_t... i>
    [[gnu::always_inline]] constexpr S albedo_estimate(const vec3<T>& v, std::index_sequence<i...>) const {
        return (S(detail::albedo_estimate(std::get<i>(lobes), v)) + ...);
    }

    /// The probability of each lobe given that none before it was chosen: its part of what is left. So `reached`, the
    /// product of 1 - p over those before it, is exactly how often a lobe has its turn, whatever was rounded here; the
    /// last has 1. All black: even parts.
    template <std::size_t... i>
    [[gnu::always_inline]] constexpr probabilities given_none_before(const vec3<T>& v,
                                                                     std::index_sequence<i...>) const {
        probabilities p{detail::mean<T>(detail::albedo_estimate(std::get<i>(lobes), v))...};
        T left(0);
        for (std::size_t k = count; k-- > 0;) {
            left = left + p[k];
            const auto lit = left > T(0);
            p[k] = select(lit, p[k] / select(lit, left, T(1)), T(1) / T(static_cast<int>(count - k)));
        }
        return p;
    }

    template <std::size_t... i>
    [[gnu::always_inline]] constexpr T pdf(const vec3<T>& v, const vec3<T>& l, std::index_sequence<i...>) const {
        const auto p = given_none_before(v, every_lobe);
        T density(0), reached(1);
        ((density = density + reached * p[i] * std::get<i>(lobes).pdf(v, l), reached = reached * (T(1) - p[i])), ...);
        return density;
    }

    template <std::size_t... i>
    [[gnu::always_inline]] constexpr evaluation<S, T> evaluate(const probabilities& p, const vec3<T>& v,
                                                               const vec3<T>& l, std::index_sequence<i...>) const {
        evaluation<S, T> total{S(T(0)), T(0)};
        T reached(1);
        const auto add = [&](const auto& e, const T& chosen) {
            total = {total.f_cos + S(e.f_cos), total.pdf + reached * chosen * e.pdf};
            reached = reached * (T(1) - chosen);
        };
        (add(std::get<i>(lobes).evaluate(v, l), p[i]), ...);
        return total;
    }

    template <std::size_t... i>
    [[gnu::always_inline]] constexpr direction_sample<S, T> sample(const vec3<T>& v, const vec2<T>& u,
                                                                   std::index_sequence<i...>) const {
        const vec3<T> n{T(0), T(0), T(1)};
        const auto p = given_none_before(v, every_lobe);
        vec3<T> l = n;
        T x = u.x, chosen_pdf(0);  // x = 2: a lobe was chosen
        const auto stretched = [&](const T& chance) { return quotient(x < chance, x, chance); };
        const auto keep = [&](const auto& s, const T& chance) {
            const auto here = x < chance;
            l = select(here, s.l, l);
            chosen_pdf = select(here, s.pdf, chosen_pdf);
            const T others = select(chance < T(1), T(1) - chance, T(1));
            x = select(here, T(2), T(1) - (T(1) - x) / others);  // (x - chance)/(1 - chance), which may round to 1
        };
        (keep(std::get<i>(lobes).sample(v, {stretched(p[i]), u.y}), p[i]), ...);
        // A failed sample is evaluated at n: a view that is NaN would give 0 * NaN. (v.v > 0 is false for it.)
        const auto drawn = chosen_pdf > T(0) && dot(v, v) > T(0);
        const auto e = evaluate(p, select(drawn, v, n), select(drawn, l, n), every_lobe);
        const auto valid = drawn && e.pdf > detail::smallest<T>();
        return {select(valid, l, n), e.f_cos * quotient(valid, T(1), e.pdf), select(valid, e.pdf, T(0))};
    }

    std::tuple<First, Rest...> lobes;
};

}  // namespace lobe
