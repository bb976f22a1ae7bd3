// The verdict on a BRDF: `verify(brdf)`.
#pragma once

#include <lobe/testkit/properties/evaluate.hpp>
#include <lobe/testkit/properties/finite.hpp>
#include <lobe/testkit/properties/furnace.hpp>
#include <lobe/testkit/properties/isotropy.hpp>
#include <lobe/testkit/properties/reciprocity.hpp>
#include <lobe/testkit/properties/sampling.hpp>
#include <lobe/testkit/properties/steady.hpp>
#include <lobe/testkit/verdict/attempt.hpp>
#include <lobe/testkit/verdict/places.hpp>
#include <lobe/testkit/verdict/stray_samples.hpp>

namespace lobe::testkit {

namespace detail {

template <class T, std::size_t N>
report verdict_on(const brdf_functions<T, N>& brdf, const options& o) {
    report r = opened(o);
    if (!r.passed()) return r;
    subject<T, N> b(brdf, o);
    const std::vector<vec3<T>> from = views(b);

    stray_samples<T, N> strays(b);
    callable<T, N> can_be_called(b);
    values_of_f<T, N> numbers(b);
    steady<T, N> same_twice(b);
    values_of_sampling<T, N> samples(b);
    reciprocity<T, N> reciprocal(b);
    isotropy<T, N> turned(b);
    evaluate<T, N> together(b);
    furnace<T, N> of_view(b);
    furnace_of_light<T, N> of_light(b);
    density_of_samples<T, N> density(b, static_cast<int>(from.size()));
    unbiased<T, N> mean(b);
    weights<T, N> weight(b);
    // In the order of the report.
    brdf_property<T, N>* const all[] = {&strays,   &can_be_called, &numbers, &same_twice, &samples, &reciprocal, &turned,
                                        &together, &of_view,       &of_light, &density,   &mean,    &weight};

    report thrown("");
    const auto part = [&](const auto& f) { attempt(thrown, [&] { return b.last.text(); }, f); };
    const auto at_sample = [&](const vec3<T>& v, const vec3<T>& u, const drawn<T, N>& s) {
        if (!s.ok) return;
        const sample_from<T, N> one{
            .v = v, .u = u, .s = s, .f = b.f_cos(v, s.l), .at = {.v = v, .l = s.l, .u = u, .numbers = b.raw.numbers}};
        for (auto* p : all) p->at_sample(one);
    };
    part([&] { sweep(b); });
    part([&] {
        generator random(o.seed), of_u(o.seed);
        for (int i = 0; i < b.effort.pairs; ++i) {
            const auto [v, l] = random_pair<T>(random, i);
            if (!(v.z > T(0)) || !(l.z > T(0))) continue;
            const pair_of_directions<T, N> pair{.v = v, .l = l, .f = b.f_cos(v, l)};
            for (auto* p : all) p->at_pair(pair);
            if (!b.has_sample()) continue;
            const vec3<T> u = random_u<T>(of_u, b.raw.numbers);
            at_sample(v, u, b.sample(v, u));
        }
    });
    part([&] {
        for (std::size_t i = 0; i < from.size(); ++i) {
            view<T, N> one(b, from[i], o.seed * 1000 + i);
            one.draw([&](const vec3<T>& u, const drawn<T, N>& s) { at_sample(one.v, u, s); });
            one.integrate();
            for (auto* p : all) p->at_view(one);
        }
    });

    report found("");
    for (auto* p : all) part([&] { p->report_to(found); });
    for (const check& c : thrown.checks()) r.add(c);
    const std::string clue = strays.clue();
    for (check c : found.checks()) {
        if (!clue.empty() && c.id.about_samples && !c.passed) c.meaning = clue;
        r.add(c);
    }
    return r;
}

}  // namespace detail

/// Judges any type with `f_cos(v, l)`, or a function of (v, l) that returns it: f(v,l) cos(theta_l), in tangent space, directions pointing
/// away from the surface. A scalar or rgb (or any spectrum that [] reads), in float or double. `sample(v, u)`, which returns l, weight and
/// pdf of two random numbers, or of three where it takes no two, and `pdf(v, l)` are verified where they exist, each on its own.
template <class B>
[[nodiscard]] report (verify)(const B& brdf, const options& o = {}) {
    using detail::has_any_f_cos, detail::returns_spectrum;
    constexpr bool callable = has_any_f_cos<B, vec3<double>> || has_any_f_cos<B, vec3<float>>;
    static_assert(callable, "no f_cos(v, l), nor a call (v, l), that is const and takes glm::vec3 or glm::dvec3");
    constexpr bool fits = returns_spectrum<B, vec3<double>> || returns_spectrum<B, vec3<float>>;
    static_assert(fits || !callable, "f_cos returns no spectrum: a number, a GLM vector, what has begin() and end(), or r, g, b");
    if constexpr (fits)
        return detail::verdict_on(detail::interface_of(brdf), o);
    else
        return report(o.name);
}

}  // namespace lobe::testkit
