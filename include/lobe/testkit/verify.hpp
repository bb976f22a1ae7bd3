// The verdict on a BRDF: `verify(brdf)`.
#pragma once

#include <lobe/testkit/measure/rehearse.hpp>
#include <lobe/testkit/properties/evaluate.hpp>
#include <lobe/testkit/properties/finite.hpp>
#include <lobe/testkit/properties/furnace.hpp>
#include <lobe/testkit/properties/isotropy.hpp>
#include <lobe/testkit/properties/reciprocity.hpp>
#include <lobe/testkit/properties/sampling.hpp>
#include <lobe/testkit/properties/steady.hpp>
#include <lobe/testkit/verdict/attempt.hpp>
#include <lobe/testkit/verdict/last_words.hpp>
#include <lobe/testkit/verdict/places.hpp>
#include <lobe/testkit/verdict/stray_samples.hpp>

#include <string>
#include <vector>

namespace lobe::testkit {

namespace detail {

template <class T, std::size_t N, template <class, std::size_t> class... Property>
struct property_list : Property<T, N>... {
    explicit property_list(subject<T, N>& judged) : Property<T, N>(judged)... {}
    brdf_property<T, N>* const all[sizeof...(Property)] = {static_cast<Property<T, N>*>(this)...};
};
template <class T, std::size_t N>
using properties = property_list<T, N,  // in the order of the report
                                 callable, values_of_f, steady, values_of_sampling, reciprocity, isotropy, evaluate,
                                 furnace, furnace_of_light, density_of_samples, unbiased, weights, stray_samples>;

template <class T, std::size_t N>
report verdict_on(const brdf_functions<T, N>& brdf, const options& o) {
    report r = opened(o);
    if (!r.passed()) return r;
    subject<T, N> b(brdf, o);
    properties<T, N> list(b);
    report thrown("");
    longest_spectrum = 0;
    last_words words([&](line& out) { b.last.write(out); });
    const auto note = [&] {
        report until_now(o.name);
        for (auto* p : list.all) p->report_to(until_now);
        const std::string text = until_now.text();
        words.so_far = text.substr(text.find('\n'));  // without "passed"
    };
    const auto part = [&](const auto& f) {
        attempt(
            thrown, [&] { return b.last.text(); }, f);
    };
    const auto show_sample = [&](const vec3<T>& v, const vec3<T>& u, const drawn<T, N>& s) {
        if (!s.ok) return;
        const place<T> at{.v = v, .l = s.l, .u = u, .numbers = b.raw.numbers};
        const sample_from<T, N> one{.v = v, .u = u, .s = s, .f = b.f_cos(v, s.l), .at = at};
        for (auto* p : list.all) p->at_sample(one);
    };

    part([&] {
        rehearse([&] { sweep(b, [] {}); });
        sweep(b, note);
    });
    part(note);
    part([&] {
        generator random(o.seed), random_of_u(o.seed, 2);
        for (int i = 0; i < b.effort.pairs; ++i) {
            if (i % 1024 == 0) rehearse([&] { ask_pairs(b, i, i + 1024, random, random_of_u); });
            const auto [v, l] = random_pair<T>(random, i, b.scatters);
            if (!b.scatters.judged(v) || !b.scatters.judged(l)) continue;
            const pair_of_directions<T, N> pair{.v = v, .l = l, .f = b.f_cos(v, l)};
            for (auto* p : list.all) p->at_pair(pair);
            if (!b.has_sample()) continue;
            const vec3<T> u = random_u<T>(random_of_u, b.raw.numbers);
            const drawn<T, N> s = b.sample(v, u);
            show_sample(v, u, s);
            if (!s.ok || !b.scatters.both) continue;  // where a narrow lobe refracts to, only its samples know
            const pair_of_directions<T, N> sampled{.v = v, .l = s.l, .f = b.f_cos(v, s.l)};
            for (auto* p : list.all) p->at_pair(sampled);
        }
    });
    part(note);
    part([&] {
        const std::vector<vec3<T>> from = views(b);
        for (std::size_t i = 0; i < from.size(); ++i) {
            view<T, N> one(b, from[i], o.seed * 1000 + i);
            one.draw([&](const vec3<T>& u, const drawn<T, N>& s) { show_sample(one.v, u, s); });
            one.integrate();
            for (auto* p : list.all) p->at_view(one);
            note();
        }
    });

    report found("");
    for (auto* p : list.all) part([&] { p->report_to(found); });
    for (const check& c : thrown.checks()) r.add(c);
    report_length(r, longest_spectrum);
    const std::string clue = list.stray_samples<T, N>::clue();
    for (check c : found.checks()) {
        if (!clue.empty() && c.id.about_samples && !c.passed) c.meaning = clue;
        r.add(c);
    }
    return r;
}

}  // namespace detail

/// Judges any type with `f_cos(v, l)`, or a function of (v, l) that returns it: f(v,l) cos(theta_l), in tangent space,
/// directions pointing away from the surface. A scalar or rgb (or any spectrum that [] reads), in float or double.
/// A BSDF, which says `static constexpr bool transmits = true` (or options.transmits), on the whole sphere, f
/// |cos(theta_l)|.
/// `sample(v, u)`, which returns l, weight and pdf of two random numbers, or of three where it takes no two, and
/// `pdf(v, l)` are verified where they exist, each on its own.
template <class B>
[[nodiscard]] report(verify)(const B& brdf, const options& o = {}) {
    using detail::has_any_f_cos, detail::returns_spectrum;
    constexpr bool callable = has_any_f_cos<B, vec3<double>> || has_any_f_cos<B, vec3<float>>;
    static_assert(callable, "no f_cos(v, l), nor a call (v, l), that is const and takes glm::vec3 or glm::dvec3");
    constexpr bool fits = returns_spectrum<B, vec3<double>> || returns_spectrum<B, vec3<float>>;
    static_assert(fits || !callable,
                  "f_cos returns no spectrum: a number, a GLM vector, what has begin() and end(), or r, g, b");
    if constexpr (fits)
        return detail::verdict_on(detail::interface_of(brdf), o);
    else
        return report(o.name);
}

}  // namespace lobe::testkit
