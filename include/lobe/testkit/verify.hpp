// The verdict on a BRDF: `verify(brdf)`.
#pragma once

#include <lobe/testkit/checks.hpp>
#include <lobe/testkit/half_vector_chart.hpp>

namespace lobe::testkit {

namespace detail {

template <class T, std::size_t channels>
class judge {
    using V = vec3<T>;
    using values = std::array<double, channels>;

public:
    judge(const brdf_functions<T, channels>& brdf, const options& o)
        : options_(o), budget_(budget_of(o.effort)), b(brdf, o.zero_below), isotropic(o.isotropic.value_or(brdf.isotropic)) {}

    report verdict() {
        report all = opened(options_);
        if (!all.passed()) return all;
        attempt([&] { sweep(); });
        attempt([&] { pairs(); });
        attempt([&] { views(); });
        misfits(all);
        values_of_calls(all);
        const std::string clue = clue_of_samples();
        for (check c : r.checks()) {
            if (!clue.empty() && about_samples(c)) c.meaning = clue;
            all.add(c);
        }
        return all;
    }

private:
    // ---- every value is watched; here only the places are chosen

    void sweep() {
        std::vector<V> w;
        for (const double z : {1.0, 1 - 1e-7, 0.999, 0.7, 0.3, 0.1, 1e-2, 1e-3, 1e-4, 1e-6, 0.0, -1e-6, -0.3, -1.0})
            for (const double azimuth : {0.0, 1.0, tau / 4, tau / 2, -2.0}) w.push_back(direction<T>(z, azimuth));
        const T tiny = std::numeric_limits<T>::denorm_min() * T(100);
        w.push_back({tiny, T(0), T(1)});
        w.push_back({-tiny, tiny, T(1)});
        const std::size_t usual = w.size();
        w.push_back({T(1), T(0), std::sqrt((std::numeric_limits<T>::min)())});  // a light nearly on the horizon
        const auto look = [&](const V& v, const V& l) {
            b.f_cos(v, l);
            if (b.has_pdf()) b.pdf(v, l);
        };
        for (std::size_t i = 0; i < usual; ++i) {
            for (const V& l : w) look(w[i], l);
            look(w[i], -w[i]);
            for (double step = 1e-8; step < 0.3; step *= 10)  // near the mirror direction, and near v itself
                for (const double side : {-1.0, 1.0}) {
                    const V mirror{-w[i].x, -w[i].y, w[i].z};
                    look(w[i], unit(vec3<double>(mirror) + vec3<double>(side * step, step / 2, 0)));
                    look(w[i], unit(vec3<double>(w[i]) + vec3<double>(side * step, -step / 2, 0)));
                }
        }
        if (b.has_sample()) {
            const T u[] = {T(0),   tiny,    static_cast<T>(1e-6),           T(0.25),
                           T(0.5), T(0.75), T(1) - static_cast<T>(0x1p-24), T(1) - std::numeric_limits<T>::epsilon() / T(2)};
            for (std::size_t i = 0; i < usual; ++i)
                for (const T x : u)
                    for (const T y : u)
                        if (w[i].z > T(0)) b.sample(w[i], {x, y});
        }
    }

    /// Members that cannot be called the way the kit calls them: a verdict without them is not the one that was asked for.
    void misfits(report& all) const {
        const auto misfit = [&](const char* property, const std::string& why) {
            const std::string meaning = "the member is there, but not verified: it is not const, " + why +
                                        "; to verify f_cos alone, pass a lambda that calls it";
            all.add({{property, 0, 1, 0, "", meaning}, false});
        };
        if (b.b.misfit_sample)
            misfit("sample(v, u) can be called", "does not take two vectors of 3 and 2 numbers, or does not return l, weight and pdf");
        if (b.b.misfit_pdf) misfit("pdf(v, l) can be called", "does not take two vectors of 3 numbers, or does not return a number");
    }

    /// Samples that go where they cannot be right: it explains whatever else is found of them.
    std::string clue_of_samples() const {
        if (one_direction > 0.1)
            return number(100 * one_direction, 3) +
                   " % of the samples from one v are one and the same direction: a perfect mirror, or a lobe without width, which no "
                   "density describes; give it a small roughness, or leave it out";
        if (most_are_lost()) return lost;
        for (std::size_t i = 0; i < std::size(turns); ++i)
            if (turned_samples >= 20 && 10 * turned_right[i] > 9 * turned_samples)
                return std::string("the weights fit l = ") + turns[i].name +
                       " of the samples returned: they are reflected about another axis";
        return "";
    }
    bool most_are_lost() const { return b.lost_samples > 4 * b.good_samples; }
    static constexpr const char* lost = "most samples fail or point below the horizon: -l in the place of l (the reflect(i, m) of GLSL and "
                                        "GLM wants i = -v), or light that "
                                        "is transmitted, which is not judged here";
    static bool about_samples(const check& c) {
        return !c.passed && (c.property.find("sample") != std::string::npos || c.property.find("weight") != std::string::npos ||
                             c.property.find("pdf = successes") != std::string::npos);
    }

    /// What every call of every part has shown.
    void values_of_calls(report& all) const {
        all.add({{"f_cos is not always 0", b.largest, b.largest, 0, "",
                  "the BRDF returned 0 for every pair of directions: nothing can be verified"},
                 b.largest > 0});
        b.of_f.report_to(all);
        all.add({{"the same input, the same value", double(unsteady), 0, 0, unsteady ? unsteady_at.text() : "",
                  "a random generator inside: all randomness comes from u"},
                 unsteady == 0});
        if (b.has_pdf()) b.of_pdf.report_to(all, false);
        if (b.has_sample()) {
            b.of_sample.report_to(all, true, most_are_lost() ? lost : "a sample below the horizon carries light: its weight must be 0");
            const bool unit = std::abs(b.worst_length - 1) <= unit_tolerance;
            all.add({{"sampled directions are unit", b.worst_length, 1, unit_tolerance, unit ? "" : b.length_place.text(),
                      "a half vector that is not normalised, or a basis that is not orthonormal"},
                     unit});
            all.add(
                {{"no light without a density", double(b.light_without_pdf), 0, 0, b.light_without_pdf ? b.light_place.text() : "",
                  equal(b.largest, 0.0) ? "pdf is 0 and the weight is not: a perfect mirror, whose f_cos is a delta that no density "
                                          "describes; verify it with a small roughness, or leave it out"
                                        : "a sample with pdf 0 has failed: its weight must be 0"},
                 b.light_without_pdf == 0});
        }
    }

    // ---- two values that ought to be equal, at pairs of directions spread over all scales

    void pairs() {
        comparison<T> reciprocal("reciprocity", options_.tolerance,
                                 "f(v,l) is not f(l,v): a Fresnel term of n.v or n.l instead of v.h, a masking of one direction only, or a "
                                 "diffuse weight that looks at one side (if that is meant: options.reciprocal = false)");
        comparison<T> turned("isotropy", options_.tolerance,
                             "the value changes when v and l turn about the normal: it is anisotropic, or reads x or y alone");
        comparison<T> together("evaluate = {f_cos, pdf}", options_.tolerance, "evaluate and the separate functions are two formulas");
        generator random(options_.seed);
        const auto with_cosine = [&](const V& v, const V& l, std::size_t k) { return b.b.f_cos(v, l)[k] * static_cast<double>(v.z); };
        for (int i = 0; i < budget_.pairs; ++i) {
            const std::pair<V, V> directions = random_pair(random, i);
            const V &v = directions.first, &l = directions.second;
            if (!(v.z > T(0)) || !(l.z > T(0))) continue;
            const values f = b.f_cos(v, l);
            if (i < 256) repeat(v, l, f, {below_one<T>(random()), below_one<T>(random())});
            if (b.has_sample()) compare_sample(v, {below_one<T>(random()), below_one<T>(random())});
            if (options_.reciprocal) {
                const values g = b.f_cos(l, v);
                for (std::size_t k = 0; k < channels; ++k)
                    reciprocal.add(f[k] * static_cast<double>(v.z), g[k] * static_cast<double>(l.z), {v, l}, k);
            }
            if (isotropic) {
                const double angle = tau * random();
                const values g = b.f_cos(rotated(v, angle), rotated(l, angle));
                for (std::size_t k = 0; k < channels; ++k) turned.add(g[k], f[k], {v, l}, k);
            }
            if (b.has_pdf() && b.b.evaluate) {
                const auto [f_cos, pdf] = b.b.evaluate(v, l);
                for (std::size_t k = 0; k < channels; ++k) together.add(f_cos[k], f[k], {v, l}, k);
                together.add(pdf, b.pdf(v, l), {v, l}, channels);
            }
        }
        const auto noise_of = [&](const place<T>& at, std::size_t k) {
            return rounding_noise([&](const V& v, const V& l) { return with_cosine(v, l, k); }, at) +
                   rounding_noise([&](const V& v, const V& l) { return with_cosine(l, v, k); }, at);
        };
        if (options_.reciprocal) reciprocal.report_to(r, noise_of);
        const auto noise = [&](const place<T>& at, std::size_t k) {
            if (b.has_pdf())
                if (k == channels) return 2 * rounding_noise([&](const V& v, const V& l) { return b.b.pdf(v, l); }, at);
            return 2 * rounding_noise([&](const V& v, const V& l) { return b.b.f_cos(v, l)[k]; }, at);
        };
        if (isotropic) turned.report_to(r, noise);
        together.report_to(r, noise);
    }

    /// One in three: two independent directions; else l mirrored at a normal of any slope from 1e-4 to 10. One in four near grazing.
    std::pair<V, V> random_pair(generator& random, int i) const {
        const double z = i % 4 == 3 ? random.log_between(1e-6, 1e-1) : random(), azimuth = tau * random();
        const V v = direction<T>(z, azimuth);
        if (i % 3 == 0) return {v, direction<T>(i % 8 == 0 ? random.log_between(1e-6, 1) : random(), tau * random())};
        const double slope = random.log_between(1e-4, 10), turn = tau * random();
        const vec3<double> w(v), m = normalize(vec3<double>(slope * std::cos(turn), slope * std::sin(turn), 1));
        return {v, unit(2 * dot(w, m) * m - w)};
    }

    // ---- integrals over all directions, for a fixed one

    void views() {
        per_view furnace(
            options_.lossless ? "white furnace is 1" : "white furnace is at most 1",
            "energy is created: a missing 1/pi or 1/4, a D that is not normalised, a masking above 1, a diffuse part that does not "
            "give up what the specular part reflects, or a compensation with the wrong average",
            "energy is lost: single scattering only, a factor too many, or a compensation with the wrong average");
        per_view furnace_of_light(
            options_.lossless ? "white furnace of a light is 1" : "white furnace of a light is at most 1",
            "light from one direction is returned more than once: the compensation looks at the viewer only",
            "light from one direction is lost: single scattering only, or a compensation that looks at the viewer only");
        per_view pdf_at_most("integral of the pdf is at most 1", "it is no density: a factor or a Jacobian is wrong");
        per_view covered("pdf > 0 where f_cos > 0", "the sampler never goes where the BRDF reflects: that light is lost");
        per_view weighted_means(
            "weighted means of samples = of f_cos",
            "the estimator is biased: the samples are wider, narrower, more tilted or more to one side than their weights say");
        per_view mean_weight("mean weight = furnace", "the estimator is biased: the weight or the pdf does not belong to the samples");
        const std::vector<V> all = chosen_views();
        density_check<T> density("the pdf", "samples", options_, static_cast<int>(all.size()));

        for (std::size_t i = 0; i < all.size(); ++i) {
            const V v = all[i];
            const vec3<double> w = normalize(vec3<double>(v));
            const std::string at = literal("v", v);
            const half_vector_chart chart(w);
            const std::vector<std::array<double, 2>> hints = samples(v, chart, options_.seed * 1000 + i);

            // f_cos, its moments, and the part of it that the pdf does not reach.
            mesh<channels + 6> over_l(
                [&](double x, double y) {
                    const auto p = chart(x, y);
                    const V l(p.l);
                    const values f = b.f_cos(v, l);
                    typename mesh<channels + 6>::values out{};
                    double sum = 0;
                    for (std::size_t k = 0; k < channels; ++k) sum += out[k] = f[k] * p.area;
                    if (b.has_pdf())
                        if (sum > 0 && equal(b.pdf(v, l), 0.0)) out[channels + 5] = sum;
                    const auto t = numbers_of(w, p.l);
                    for (std::size_t k = 0; k < 5; ++k) out[channels + k] = sum * t[k];
                    return out;
                },
                8, 16, channels + 3);
            integrate(over_l, chart, w, hints);
            const auto &E = over_l.integral(), &e = over_l.error();
            const double allowed =
                options_.tolerance + relative_rounding<T>(over_l, chart, v, [&](const V& a, const V& c) { return total_of(a, c); });
            for (std::size_t k = 0; k < channels; ++k)
                if (!is_padding(k, E[k])) furnace.add(E[k], 1, allowed + e[k], w, at, !options_.lossless);
            if (options_.reciprocal) light_furnace(v, furnace_of_light);

            if (b.has_pdf()) {
                const double total = std::accumulate(E.begin(), E.begin() + channels, 0.0),
                             error = std::accumulate(e.begin(), e.begin() + channels, 0.0);
                if (total > 0) covered.add(total - E[channels + 5], total, options_.tolerance * total + error, w, at);
            }
            if (b.has_sample()) {
                const auto over_u = integral_over_u<T, channels + 5>(
                    [&](const vec2<T>& u) {
                        const auto s = b.sample(v, u);
                        std::array<double, channels + 5> out{};
                        if (!s.ok) return out;
                        double sum = 0;
                        for (std::size_t k = 0; k < channels; ++k) sum += out[k] = s.weight[k];
                        const auto t = numbers_of(w, vec3<double>(s.l));
                        for (std::size_t k = 0; k < 5; ++k) out[channels + k] = sum * t[k];
                        return out;
                    },
                    [&](const vec2<T>& u) { return b.sample(v, u).ok; }, budget_, channels + 3, channels);
                const auto &W = over_u.value, &we = over_u.error;
                for (std::size_t k = 0; k < channels; ++k)
                    if (!is_padding(k, E[k])) mean_weight.add(W[k], E[k], allowed * E[k] + e[k] + we[k] + least_that_counts, w, at);
                for (std::size_t k = 0; k < 5; ++k) {
                    const double size = E[channels + (k < 3 ? k : k - 3)];
                    if (*std::max_element(E.begin(), E.begin() + channels) > 10 * least_that_counts)
                        weighted_means.add(W[channels + k], E[channels + k], allowed * size + e[channels + k] + we[channels + k], w, at);
                }
            }
            if (b.has_sample() && b.has_pdf()) {
                const auto draw = [&](const vec2<T>& u) {
                    const auto s = b.sample(v, u);
                    return s.ok ? std::optional<V>(s.l) : std::nullopt;
                };
                density.add(
                    chart, [&](const V& a, const V& l) { return b.pdf(a, l); }, draw,
                    [&](const vec3<double>& l) { return numbers_of(w, l); }, v, options_.seed * 1000 + i);
            } else if (b.has_pdf()) {
                mesh<1> total(
                    [&](double x, double y) {
                        const auto p = chart(x, y);
                        return mesh<1>::values{b.pdf(v, V(p.l)) * p.area};
                    },
                    8, 16, 1);
                integrate(total, chart, w, hints);
                pdf_at_most.add(total.integral()[0], 1, options_.tolerance + total.error()[0], w, at, true);
            }
        }
        furnace.report_to(r);
        furnace_of_light.report_to(r);
        pdf_at_most.report_to(r);
        if (b.has_sample() && b.has_pdf()) density.report_to(r);
        covered.report_to(r);
        mean_weight.report_to(r);
        weighted_means.report_to(r);
        product.report_to(r, [&](const place<T>& where, std::size_t k) {
            return 2 * rounding_noise([&](const V& v, const V& l) { return b.b.f_cos(v, l)[k]; }, where);
        });
        if (b.has_pdf())
            same_pdf.report_to(r, [&](const place<T>& where, std::size_t) {
                return 2 * rounding_noise([&](const V& v, const V& l) { return b.b.pdf(v, l); }, where);
            });
    }

    /// Asked twice, a function answers twice the same.
    void repeat(const V& v, const V& l, const values& f, const vec2<T>& u) {
        bool same = b.f_cos(v, l) == f && (!b.has_pdf() || equal(b.pdf(v, l), b.pdf(v, l)));
        if (same && b.has_sample()) {
            const auto one = b.sample(v, u), two = b.sample(v, u);
            same = equal(one.pdf, two.pdf) && one.weight == two.weight && (!one.ok || one.l == two.l);
        }
        if (!same && !unsteady++) unsteady_at = {v, l, u, true, true};
    }

    /// Weight and density of a sample against the functions.
    drawn<T, channels> compare_sample(const V& v, const vec2<T>& u) {
        const drawn<T, channels> s = b.sample(v, u);
        if (!s.ok) return s;
        const place<T> at{v, s.l, u, true, true};
        const values f = b.f_cos(v, s.l);
        for (std::size_t k = 0; k < channels; ++k) product.add(s.weight[k] * s.pdf, f[k], at, k);
        try_turns(v, s, f);
        if (b.has_pdf()) same_pdf.add(b.pdf(v, s.l), s.pdf, at);
        return s;
    }

    /// Where the weight is another one: is it that of the direction turned, as by a wrong reflection?
    void try_turns(const V& v, const drawn<T, channels>& s, const values& f) {
        const auto is = [&](const values& g) {
            for (std::size_t k = 0; k < channels; ++k)
                if (!(std::abs(s.weight[k] * s.pdf - g[k]) <= 0.02 * g[k])) return false;
            return true;
        };
        if (turned_samples == 1000 || is(f)) return;
        ++turned_samples;
        for (std::size_t i = 0; i < std::size(turns); ++i)
            turned_right[i] += is(b.b.f_cos(v, {T(turns[i].x) * s.l.x, T(turns[i].y) * s.l.y, s.l.z}));
    }

    /// ... of n^2 of them, one at random in each of the n^2 squares. Returns where some lie in the chart.
    std::vector<std::array<double, 2>> samples(const V& v, const half_vector_chart& chart, std::uint64_t seed) {
        std::vector<std::array<double, 2>> some;
        if (!b.has_sample()) return some;
        generator random(seed);
        const int n = budget_.strata, stride = (std::max)(1, n * n / 512);
        for (int i = 0; i < n * n; ++i) {
            const double x = (i % n + random()) / n, y = (i / n + random()) / n;
            const auto s = compare_sample(v, {below_one<T>(x), below_one<T>(y)});
            if (s.ok && i % stride == 0) some.push_back(chart.find(vec3<double>(s.l)));
        }
        for (const auto& p : some)
            one_direction = (std::max)(one_direction, double(std::count(some.begin(), some.end(), p)) / static_cast<double>(n * n / stride));
        return some;
    }

    static std::array<double, 5> numbers_of(const vec3<double>& v, const vec3<double>& l) { return moments(normalize(v + l), l.z); }

    double total_of(const V& v, const V& l) const {
        double sum = 0;
        for (std::size_t k = 0; k < channels; ++k) sum += b.b.f_cos(v, l)[k];
        return sum;
    }

    template <std::size_t N>
    void integrate(mesh<N>& m, const half_vector_chart& chart, const vec3<double>& fixed,
                   const std::vector<std::array<double, 2>>& hints) const {
        for (const vec3<double>& w : {fixed, vec3<double>{0, 0, 1}}) {  // where light may come back, and about the normal
            const auto peak = chart.find(w);
            m.refine_at(peak[0], peak[1], 4);
        }
        m.refine_crowded(hints, 24, 12);
        m.refine(budget_.tolerance, N < channels ? N : channels, budget_.evaluations);
    }

    /// int f(v,l) cos(theta_v) dv for a fixed light.
    void light_furnace(const V& l, per_view& furnace) {
        const vec3<double> w = normalize(vec3<double>(l));
        const half_vector_chart chart(w);
        mesh<channels> over_v(
            [&](double x, double y) {
                const auto p = chart(x, y);
                const V v(p.l);
                values f = b.f_cos(v, l);
                for (double& x_k : f) x_k *= p.area * static_cast<double>(v.z) / static_cast<double>(l.z);
                return f;
            },
            8, 16, channels);
        integrate(over_v, chart, w, {});
        const double allowed =
            options_.tolerance + relative_rounding<T>(over_v, chart, l, [&](const V& a, const V& c) { return total_of(c, a); });
        for (std::size_t k = 0; k < channels; ++k) {
            if (!is_padding(k, over_v.integral()[k]))
                furnace.add(over_v.integral()[k], 1, allowed + over_v.error()[k], w, literal("l", l), !options_.lossless);
        }
    }

    // ---- where to look

    /// From the normal to cos = 0.01, moved by the seed within their gaps, and, unless the subject is isotropic, along both axes.
    std::vector<V> chosen_views() const {
        generator random(options_.seed);
        std::vector<V> all{direction<T>(1, 0), direction<T>(0.01, golden_angle)};
        const int inner = budget_.views - 2;
        for (int i = 0; i < inner; ++i) {
            const double t = (i + random()) / inner;  // closer to each other near grazing
            all.push_back(direction<T>(0.02 + 0.97 * t * (0.4 + 0.6 * t), golden_angle * (i + 2)));
        }
        if (!isotropic)
            for (const double mu : {0.7, 0.15})
                for (const double azimuth : {0.0, tau / 4}) all.push_back(direction<T>(mu, azimuth));
        return all;
    }

    static V unit(const vec3<double>& w) { return V(normalize(w)); }
    static V rotated(const V& w, double angle) {
        const double c = std::cos(angle), s = std::sin(angle), x = static_cast<double>(w.x), y = static_cast<double>(w.y);
        return {static_cast<T>(c * x - s * y), static_cast<T>(s * x + c * y), w.z};
    }
    /// A number that a spectrum of unknown size does not have.
    static bool is_padding(std::size_t k, double x) { return k > 0 && channels == 16 && equal(x, 0.0); }

    static constexpr double unit_tolerance = 64 * static_cast<double>(std::numeric_limits<T>::epsilon());

    /// A function that throws ends one part of the verdict, not the verdict.
    template <class F>
    void attempt(const F& f) {
        try {
            f();
        } catch (const std::exception& e) {
            r.add({{"no exception", 1, 0, 0, b.last.text(), std::string("it threw: ") + e.what()}, false});
        } catch (...) {
            r.add({{"no exception", 1, 0, 0, b.last.text(), "it threw something that is no std::exception"}, false});
        }
    }

    options options_;
    budget budget_;
    subject<T, channels> b;
    comparison<T> product{"weight * pdf = f_cos", options_.tolerance, "the weight of a sample is not f_cos / pdf"};
    comparison<T> same_pdf{"pdf(v, sample.l) = sample.pdf", options_.tolerance,
                           "sample and pdf are two formulas: another width, another measure, or another lobe"};
    double one_direction = 0;  // the largest share of samples from one view that are equal
    struct axis_change {
        const char* name;
        int x, y;
    };
    static constexpr axis_change turns[] = {{"(-x, -y, z)", -1, -1}, {"(-x, y, z)", -1, 1}, {"(x, -y, z)", 1, -1}};
    long turned_samples = 0, turned_right[std::size(turns)] = {};
    long unsteady = 0;
    place<T> unsteady_at{};
    report r{""};
    bool isotropic;
};

}  // namespace detail

/// Judges any type with `f_cos(v, l)`, or a function of (v, l) that returns it: f(v,l) cos(theta_l), in tangent space, directions pointing
/// away from the surface. A scalar or rgb (or any spectrum that [] reads), in float or double. `sample(v, u)`, which returns l, weight and
/// pdf, and `pdf(v, l)` are verified where they exist, each on its own.
template <class B>
[[nodiscard]] report (verify)(const B& brdf, const options& o = {}) {
    using detail::has_any_f_cos, detail::returns_spectrum;
    constexpr bool callable = has_any_f_cos<B, vec3<double>> || has_any_f_cos<B, vec3<float>>;
    static_assert(callable, "no f_cos(v, l), nor a call (v, l), that is const and takes glm::vec3 or glm::dvec3");
    constexpr bool fits = returns_spectrum<B, vec3<double>> || returns_spectrum<B, vec3<float>>;
    static_assert(fits || !callable, "f_cos returns no spectrum: a number, a GLM vector, what has begin() and end(), or r, g, b");
    if constexpr (fits)
        return detail::judge(detail::interface_of(brdf), o).verdict();
    else
        return report(o.name);
}

}  // namespace lobe::testkit
