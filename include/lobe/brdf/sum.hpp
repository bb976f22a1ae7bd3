// The sum of BRDFs, each with a weight: two specular lobes, a diffuse base under a coat. Sampled by a one-sample mixture.
#pragma once

#include <lobe/brdf/concepts.hpp>
#include <lobe/core/spectrum.hpp>

#include <array>
#include <cassert>
#include <tuple>
#include <utility>

namespace lobe {

namespace detail {

/// The mean of a spectrum's components; 1 for a type of the user's own that cannot be walked through.
template <scalar T, class S>
constexpr T mean(const S& s) {
    if constexpr (std::same_as<S, T>) {
        return s;
    } else if constexpr (std::same_as<S, vec3<T>>) {
        return (s.x + s.y + s.z) / T(3);
    } else if constexpr (requires { T(*s.begin()); s.end(); }) {
        T total(0), count(0);
        for (const auto& component : s) total = total + T(component), count = count + T(1);
        return total / count;
    } else {
        return T(1);
    }
}

/// A BRDF's own estimate of its albedo, `albedo_estimate(v)`, or 1.
template <brdf B>
[[gnu::always_inline]] constexpr typename B::spectrum albedo_estimate(const B& b, const vec3<typename B::scalar>& v) {
    if constexpr (requires { b.albedo_estimate(v); })
        return b.albedo_estimate(v);
    else
        return typename B::spectrum(typename B::scalar(1));
}

}  // namespace detail

/// weight * f. The weight is one number, not negative: colour belongs to the BRDF. Sampled as f is.
template <brdf B>
class weighted : exact_vectors {
    using T = typename B::scalar;
    using S = typename B::spectrum;

public:
    using scalar = T;
    using spectrum = S;
    using exact_vectors::f, exact_vectors::f_cos, exact_vectors::pdf, exact_vectors::evaluate, exact_vectors::sample;
    static constexpr bool isotropic = B::isotropic;

    constexpr weighted(const T& weight, const B& lobe) : w(weight), b(lobe) {
        assert(all(w >= T(0)) && "weighted: the weight must not be negative");
    }

    // (Inlined by force: see `sum`.)
    [[gnu::always_inline]] constexpr S f(const vec3<T>& v, const vec3<T>& l) const { return b.f(v, l) * w; }
    [[gnu::always_inline]] constexpr S f_cos(const vec3<T>& v, const vec3<T>& l) const { return b.f_cos(v, l) * w; }

    [[gnu::always_inline]] constexpr T pdf(const vec3<T>& v, const vec3<T>& l) const
        requires samplable_brdf<B>
    {
        return b.pdf(v, l);
    }
    [[gnu::always_inline]] constexpr evaluation<S, T> evaluate(const vec3<T>& v, const vec3<T>& l) const
        requires samplable_brdf<B>
    {
        const auto e = b.evaluate(v, l);
        return {e.f_cos * w, e.pdf};
    }
    [[gnu::always_inline]] constexpr direction_sample<S, T> sample(const vec3<T>& v, const vec2<T>& u) const
        requires samplable_brdf<B>
    {
        const auto s = b.sample(v, u);
        return {s.l, s.weight * w, s.pdf};
    }

    [[gnu::always_inline]] constexpr S albedo_estimate(const vec3<T>& v) const { return detail::albedo_estimate(b, v) * w; }
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
/// Two specular lobes, each with a masking of its own: `sum{weighted{1 - t, a}, weighted{t, b}}`.
/// `for_each_lobe(g)` calls g with each: quadrature integrates them separately, each on its own width.
///
/// Sampled, where all lobes are, by a one-sample mixture (Veach 1997, "Robust Monte Carlo Methods for Light Transport Simulation",
/// section 9.2.4, with the balance heuristic):
///   pdf = sum p_i pdf_i,  weight = sum f_i cos / pdf,  p_i in proportion to the mean of lobe i's `albedo_estimate(v)`.
/// u.x chooses and is stretched over [0,1) again. Branch-free, so it draws from every lobe and keeps one; the weight stays below
/// max_i(weight_i / p_i). Fails where the chosen lobe does. A lobe whose estimate is 0 is left to the samples of the others.
template <brdf First, brdf... Rest>
class sum : exact_vectors {
    using T = typename First::scalar;
    using S = typename First::spectrum;
    static_assert((std::same_as<T, typename Rest::scalar> && ...), "the lobes of a sum share one scalar type");
    static_assert((std::same_as<S, typename Rest::spectrum> && ...), "the lobes of a sum share one spectrum type");

public:
    using scalar = T;
    using spectrum = S;
    using exact_vectors::f, exact_vectors::f_cos, exact_vectors::pdf, exact_vectors::evaluate, exact_vectors::sample;
    static constexpr bool isotropic = First::isotropic && (Rest::isotropic && ...);
    static constexpr bool samplable = samplable_brdf<First> && (samplable_brdf<Rest> && ...);

    constexpr explicit sum(const First& first, const Rest&... rest) : lobes(first, rest...) {}

    // (Inlined by force, and without std::apply: compilers would call it, and a loop with a call does not vectorise.)
    [[gnu::always_inline]] constexpr S f(const vec3<T>& v, const vec3<T>& l) const { return f(v, l, every_lobe); }
    [[gnu::always_inline]] constexpr S f_cos(const vec3<T>& v, const vec3<T>& l) const { return f_cos(v, l, every_lobe); }

    [[gnu::always_inline]] constexpr T pdf(const vec3<T>& v, const vec3<T>& l) const
        requires samplable
    {
        return pdf(v, l, every_lobe);
    }

    [[gnu::always_inline]] constexpr evaluation<S, T> evaluate(const vec3<T>& v, const vec3<T>& l) const
        requires samplable
    {
        return evaluate(choices(v, every_lobe), v, l, every_lobe);
    }

    [[gnu::always_inline]] constexpr direction_sample<S, T> sample(const vec3<T>& v, const vec2<T>& u) const
        requires samplable
    {
        return sample(v, u, every_lobe);
    }

    [[gnu::always_inline]] constexpr S albedo_estimate(const vec3<T>& v) const { return albedo_estimate(v, every_lobe); }

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
        return (std::get<i>(lobes).f(v, l) + ...);
    }
    template <std::size_t... i>
    [[gnu::always_inline]] constexpr S f_cos(const vec3<T>& v, const vec3<T>& l, std::index_sequence<i...>) const {
        return (std::get<i>(lobes).f_cos(v, l) + ...);
    }
    template <std::size_t... i>
    [[gnu::always_inline]] constexpr S albedo_estimate(const vec3<T>& v, std::index_sequence<i...>) const {
        return (detail::albedo_estimate(std::get<i>(lobes), v) + ...);
    }

    /// The probability of each lobe, given that none before it was chosen: its share of what is left. So `rest`, the product of
    /// 1 - q, is exactly how often the others come to their turn, whatever was rounded here; the last has 1. All black: even shares.
    template <std::size_t... i>
    [[gnu::always_inline]] constexpr probabilities choices(const vec3<T>& v, std::index_sequence<i...>) const {
        probabilities q{detail::mean<T>(detail::albedo_estimate(std::get<i>(lobes), v))...};
        T left(0);
        for (std::size_t k = count; k-- > 0;) {
            left = left + q[k];
            const auto lit = left > T(0);
            q[k] = select(lit, q[k] / select(lit, left, T(1)), T(1) / T(static_cast<int>(count - k)));
        }
        return q;
    }

    template <std::size_t... i>
    [[gnu::always_inline]] constexpr T pdf(const vec3<T>& v, const vec3<T>& l, std::index_sequence<i...>) const {
        const auto q = choices(v, every_lobe);
        T density(0), rest(1);
        ((density = density + rest * q[i] * std::get<i>(lobes).pdf(v, l), rest = rest * (T(1) - q[i])), ...);
        return density;
    }

    template <std::size_t... i>
    [[gnu::always_inline]] constexpr evaluation<S, T> evaluate(const probabilities& q, const vec3<T>& v, const vec3<T>& l,
                                                               std::index_sequence<i...>) const {
        evaluation<S, T> total{S(T(0)), T(0)};
        T rest(1);
        const auto add = [&](const evaluation<S, T>& e, const T& p) {
            total = {total.f_cos + e.f_cos, total.pdf + rest * p * e.pdf};
            rest = rest * (T(1) - p);
        };
        (add(std::get<i>(lobes).evaluate(v, l), q[i]), ...);
        return total;
    }

    template <std::size_t... i>
    [[gnu::always_inline]] constexpr direction_sample<S, T> sample(const vec3<T>& v, const vec2<T>& u, std::index_sequence<i...>) const {
        const vec3<T> n{T(0), T(0), T(1)};
        const auto q = choices(v, every_lobe);
        vec3<T> l = n;
        T x = u.x, chosen_pdf(0);  // x > 1, which it stays: one was chosen
        const auto stretched = [&](const T& p) { return select(x < p, x / select(x < p, p, T(1)), T(0)); };
        const auto keep = [&](const direction_sample<S, T>& s, const T& p) {
            const auto here = x < p;
            l = select(here, s.l, l);
            chosen_pdf = select(here, s.pdf, chosen_pdf);
            x = select(here, T(2), T(1) - (T(1) - x) / select(p < T(1), T(1) - p, T(1)));  // (x - p)/(1 - p), which may round to 1
        };
        (keep(std::get<i>(lobes).sample(v, {stretched(q[i]), u.y}), q[i]), ...);
        // A failed sample is looked at from n, as 0 times the NaN of a NaN view would be a NaN. (Of which v.v > 0 says that it is none.)
        const auto drawn = chosen_pdf > T(0) && dot(v, v) > T(0);
        const auto e = evaluate(q, select(drawn, v, n), select(drawn, l, n), every_lobe);
        const auto valid = drawn && e.pdf > detail::least<T>();
        return {select(valid, l, n), e.f_cos * quotient(valid, T(1), e.pdf), select(valid, e.pdf, T(0))};
    }

    std::tuple<First, Rest...> lobes;
};

}  // namespace lobe
