// The sum of BRDFs, each with a weight: two specular lobes, a diffuse base under a coat. Sampled by a one-sample mixture.
#pragma once

#include <lobe/brdf/concepts.hpp>
#include <lobe/core/spectrum.hpp>

#include <array>
#include <cassert>
#include <tuple>

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
constexpr typename B::spectrum albedo_estimate(const B& b, const vec3<typename B::scalar>& v) {
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

    constexpr weighted(const T& weight, const B& lobe) : w(weight), b(lobe) { assert(all(w >= T(0))); }

    constexpr S f(const vec3<T>& v, const vec3<T>& l) const { return b.f(v, l) * w; }
    constexpr S f_cos(const vec3<T>& v, const vec3<T>& l) const { return b.f_cos(v, l) * w; }

    constexpr T pdf(const vec3<T>& v, const vec3<T>& l) const
        requires samplable_brdf<B>
    {
        return b.pdf(v, l);
    }
    constexpr evaluation<S, T> evaluate(const vec3<T>& v, const vec3<T>& l) const
        requires samplable_brdf<B>
    {
        const auto e = b.evaluate(v, l);
        return {e.f_cos * w, e.pdf};
    }
    constexpr direction_sample<S, T> sample(const vec3<T>& v, const vec2<T>& u) const
        requires samplable_brdf<B>
    {
        const auto s = b.sample(v, u);
        return {s.l, s.weight * w, s.pdf};
    }

    constexpr S albedo_estimate(const vec3<T>& v) const { return detail::albedo_estimate(b, v) * w; }
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

    constexpr S f(const vec3<T>& v, const vec3<T>& l) const {
        return std::apply([&](const auto& first, const auto&... rest) { return (first.f(v, l) + ... + rest.f(v, l)); }, lobes);
    }
    constexpr S f_cos(const vec3<T>& v, const vec3<T>& l) const {
        return std::apply([&](const auto& first, const auto&... rest) { return (first.f_cos(v, l) + ... + rest.f_cos(v, l)); }, lobes);
    }

    constexpr T pdf(const vec3<T>& v, const vec3<T>& l) const
        requires samplable
    {
        const auto q = choices(v);
        T density(0), rest(1);
        std::size_t i = 0;
        for_each_lobe([&](const auto& lobe) {
            density = density + rest * q[i] * lobe.pdf(v, l);
            rest = rest * (T(1) - q[i++]);
        });
        return density;
    }

    constexpr evaluation<S, T> evaluate(const vec3<T>& v, const vec3<T>& l) const
        requires samplable
    {
        return evaluate(choices(v), v, l);
    }

    constexpr direction_sample<S, T> sample(const vec3<T>& v, const vec2<T>& u) const
        requires samplable
    {
        const vec3<T> n{T(0), T(0), T(1)};
        const auto q = choices(v);
        vec3<T> l = n;
        T x = u.x, chosen_pdf(0);  // x > 1, which it stays: one was chosen
        std::size_t i = 0;
        for_each_lobe([&](const auto& lobe) {
            const auto here = x < q[i];
            const auto s = lobe.sample(v, {select(here, x / select(here, q[i], T(1)), T(0)), u.y});
            l = select(here, s.l, l);
            chosen_pdf = select(here, s.pdf, chosen_pdf);
            x = select(here, T(2), T(1) - (T(1) - x) / select(q[i] < T(1), T(1) - q[i], T(1)));  // (x - q)/(1 - q), which may round to 1
            ++i;
        });
        const auto e = evaluate(q, v, l);
        const auto valid = chosen_pdf > T(0) && e.pdf > T(0);
        return {select(valid, l, n), e.f_cos * select(valid, T(1) / e.pdf, T(0)), select(valid, e.pdf, T(0))};
    }

    constexpr S albedo_estimate(const vec3<T>& v) const {
        const auto add = [&](const auto&... lobe) { return (detail::albedo_estimate(lobe, v) + ...); };
        return std::apply(add, lobes);
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
    static constexpr std::size_t count = 1 + sizeof...(Rest);
    using probabilities = std::array<T, count>;

    /// The probability of each lobe, given that none before it was chosen: its share of what is left. So `rest`, the product of
    /// 1 - q, is exactly how often the others come to their turn, whatever was rounded here; the last has 1. All black: even shares.
    constexpr probabilities choices(const vec3<T>& v) const {
        const auto estimates = [&](const auto&... lobe) { return probabilities{detail::mean<T>(detail::albedo_estimate(lobe, v))...}; };
        probabilities q = std::apply(estimates, lobes);
        T left(0);
        for (std::size_t i = count; i-- > 0;) {
            left = left + q[i];
            const auto lit = left > T(0);
            q[i] = select(lit, q[i] / select(lit, left, T(1)), T(1) / T(static_cast<int>(count - i)));
        }
        return q;
    }

    constexpr evaluation<S, T> evaluate(const probabilities& q, const vec3<T>& v, const vec3<T>& l) const {
        S f_cos(T(0));
        T density(0), rest(1);
        std::size_t i = 0;
        for_each_lobe([&](const auto& lobe) {
            const auto e = lobe.evaluate(v, l);
            f_cos = f_cos + e.f_cos;
            density = density + rest * q[i] * e.pdf;
            rest = rest * (T(1) - q[i++]);
        });
        return {f_cos, density};
    }

    std::tuple<First, Rest...> lobes;
};

}  // namespace lobe
