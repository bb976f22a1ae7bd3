// The forms that a check takes: pairs of numbers that ought to be equal, one number a view, and a density against its samples.
#pragma once

#include <lobe/testkit/cubature.hpp>
#include <lobe/testkit/diagnosis.hpp>
#include <lobe/testkit/statistics.hpp>
#include <lobe/testkit/subject.hpp>

namespace lobe::testkit::detail {

/// How much an effort is worth.
struct budget {
    int views, pairs, strata;  // strata^2 samples a view
    long evaluations;          // of one integral, at most
    double tolerance;          // of one integral, relative
};
inline budget budget_of(effort e) { return e == effort::quick ? budget{9, 4096, 96, 24000, 3e-4} : budget{32, 100000, 384, 200000, 5e-5}; }

/// A report, already failed where the options make no sense.
inline report opened(const options& o) {
    report r(o.name);
    if (!(o.tolerance > 0 && std::isfinite(o.tolerance)))
        r.add({{"options.tolerance is above 0, and a number", o.tolerance, 2e-3, 0, "",
                "it is the relative error that counts; with this one nothing can be verified"},
               false});
    return r;
}

/// Of a furnace, or of a share of samples: less than this is neither lost nor gained.
inline constexpr double least_that_counts = 1e-4;

/// Up to 2^14 of however many things, evenly spread over them: every second is dropped whenever they are too many.
template <class X>
class thinned {
public:
    void add(const X& x) {
        if (seen++ % stride) return;
        kept.push_back(x);
        if (kept.size() < (1u << 14)) return;
        for (std::size_t i = 0; i < kept.size() / 2; ++i) kept[i] = kept[2 * i];
        kept.resize(kept.size() / 2);
        stride *= 2;
    }
    std::vector<X> kept;

private:
    std::size_t seen = 0, stride = 1;
};

/// Pairs of numbers that ought to be equal. Each pair may differ by `tolerance` (relative) and by four times what rounding does there; the
/// median of all ratios by `tolerance` and what rounding does on average.
template <class T>
class comparison {
public:
    comparison(std::string of, double relative, std::string meaning)
        : property(std::move(of)), tolerance(relative), otherwise(std::move(meaning)) {}

    /// Values at which T begins to lose digits say nothing.
    static constexpr double smallest = 1e6 * static_cast<double>((std::numeric_limits<T>::min)());

    void add(double measured, double expected, const place<T>& at, std::size_t channel = 0) {
        const double size = (std::max)(std::abs(measured), std::abs(expected));
        if (!(size > smallest)) return;
        ++count;
        if (!equal(expected, 0.0)) ratios.add(measured / expected);
        const double deviation = std::abs(measured - expected) / size;
        if (deviation > closest) closest = deviation, close_at = {measured, expected, deviation, channel, at};
        if (!(deviation > tolerance)) return;
        const suspect one{measured, expected, deviation, channel, at};
        spread.add(one);
        largest.push_back(one);
        if (largest.size() == 4 * worst_kept) keep_largest();
    }

    /// noise(place, channel): what rounding does to the two values there.
    template <class Noise>
    void report_to(report& r, const Noise& noise) {
        if (!count) return;
        // The largest deviations, and as many spread over all: the largest may all be rounding.
        keep_largest();
        std::vector<suspect> looked_at;
        const std::size_t step = std::max<std::size_t>(1, spread.kept.size() / 128);
        for (std::size_t i = 0; i < spread.kept.size(); i += step) looked_at.push_back(spread.kept[i]);
        std::vector<double> noises, sorted;
        const auto relative_noise = [&](const suspect& s) {
            return noise(s.at, s.channel) / (std::max)(std::abs(s.measured), std::abs(s.expected));
        };
        for (const suspect& s : looked_at) noises.push_back(relative_noise(s));
        // At one place a function may round alike whatever is done to it: the noise is at least what three of four places have.
        sorted = noises;
        std::sort(sorted.begin(), sorted.end());
        const double typical = sorted.empty() ? 0 : sorted[sorted.size() / 4];
        for (const suspect& s : largest) looked_at.push_back(s), noises.push_back(relative_noise(s));

        double worst = 0, allowed = 0;
        suspect at = close_at;
        std::vector<ratio_at> wrong;
        for (std::size_t i = 0; i < looked_at.size(); ++i) {
            const suspect& s = looked_at[i];
            const double size = (std::max)(std::abs(s.measured), std::abs(s.expected));
            const double limit = (tolerance + 4 * (std::max)(noises[i], typical)) * size;
            const double excess = std::abs(s.measured - s.expected) / limit;
            if (excess > 1 && !equal(s.expected, 0.0))
                wrong.push_back({s.measured / s.expected, vec3<double>(s.at.v), vec3<double>(s.at.l)});
            if (excess > worst) {
                worst = excess;
                allowed = limit;
                at = s;
            }
        }
        if (worst > 1) {
            r.add({{property, at.measured, at.expected, allowed, at.at.text(), explain(wrong, otherwise)}, false});
            return;
        }
        if (ratios.kept.size() >= 64) {
            const auto middle = ratios.kept.begin() + static_cast<std::ptrdiff_t>(ratios.kept.size() / 2);
            std::nth_element(ratios.kept.begin(), middle, ratios.kept.end());
            if (std::abs(*middle - 1) > tolerance + typical) {
                r.add({{property + ", median ratio", *middle, 1, tolerance + typical, at.at.text(),
                        "the same factor on most values: a constant is wrong"},
                       false});
                return;
            }
        }
        r.add({{property, at.measured, at.expected, (std::max)(allowed, tolerance * std::abs(at.expected)), "", ""}, true});
    }

private:
    static constexpr std::size_t worst_kept = 64;

    void keep_largest() {
        std::sort(largest.begin(), largest.end(), [](const suspect& a, const suspect& b) { return a.deviation > b.deviation; });
        if (largest.size() > worst_kept) largest.resize(worst_kept);
    }

    struct suspect {
        double measured, expected, deviation;
        std::size_t channel;
        place<T> at;
    };
    std::string property;
    double tolerance;
    std::string otherwise;
    long count = 0;
    double closest = -1;
    suspect close_at{};
    std::vector<suspect> largest;
    thinned<suspect> spread;
    thinned<double> ratios;
};

/// One number a view that ought to be equal to, or at most, another.
class per_view {
public:
    per_view(std::string of, std::string meaning, std::string meaning_if_too_small = "")
        : property(std::move(of)), otherwise(std::move(meaning)), too_small(std::move(meaning_if_too_small)) {}

    void add(double measured, double expected, double allowed, const vec3<double>& v, const std::string& at, bool at_most = false) {
        upper_bound = at_most;
        const double off = at_most ? measured - expected : std::abs(measured - expected);
        const double excess = off / allowed;
        if (excess > 1) wrong.push_back({measured / expected, v, {0, 0, 1}});
        ++count;
        if (excess > worst) {
            worst = excess;
            result = {property, measured, expected, allowed, at, ""};
        }
    }
    bool holds() const { return wrong.empty(); }
    void report_to(report& r) const {
        if (!count) return;
        check c{result, holds()};
        if (!c.passed)
            c.meaning = lacks_one_over_pi() ? "the same albedo from everywhere, plausible once divided by pi: a missing 1/pi"
                                            : explain(wrong, c.measured < c.expected && !too_small.empty() ? too_small : otherwise);
        r.add(c);
    }

private:
    /// A furnace that may be anything up to 1: pi times an albedo, from every view.
    bool lacks_one_over_pi() const {
        if (!upper_bound || wrong.size() < static_cast<std::size_t>(count)) return false;
        const auto [low, high] =
            std::minmax_element(wrong.begin(), wrong.end(), [](const ratio_at& a, const ratio_at& b) { return a.ratio < b.ratio; });
        return high->ratio < 1.01 * low->ratio && low->ratio > 1.1 && high->ratio < 1.01 * std::numbers::pi;
    }

    std::string property, otherwise, too_small;
    finding result;
    bool upper_bound = false;
    double worst = -1e300;
    int count = 0;
    std::vector<ratio_at> wrong;
};

/// What rounding inside the function does to an integral of it, relative: on average over the cells that matter. Narrow lobes in float have
/// a width that rounding alone changes: 1 - c*c and a*a - 1 keep 2^-24/alpha^2 of it. value(v, l): the integrand.
template <class T, std::size_t N, class Chart, class Value>
double relative_rounding(const mesh<N>& m, const Chart& chart, const vec3<T>& v, const Value& value) {
    if constexpr (!std::is_same_v<T, float>) return 0;
    std::vector<std::size_t> leaves = m.leaves();
    const std::size_t kept = std::min<std::size_t>(leaves.size(), 48);
    const auto size = [&](std::size_t at) { return std::abs(m.cells()[at].integral[0]); };
    std::partial_sort(leaves.begin(), leaves.begin() + static_cast<std::ptrdiff_t>(kept), leaves.end(),
                      [&](std::size_t a, std::size_t b) { return size(a) > size(b); });
    double noise = 0, all = 0;
    for (std::size_t i = 0; i < kept; ++i) {
        const auto& c = m.cells()[leaves[i]];
        const place<T> at{v, vec3<T>(chart(c.x0 + c.width / 2, c.y0 + c.height / 2).l)};
        const double there = std::abs(value(at.v, at.l));
        if (!(there > 0)) continue;
        noise += size(leaves[i]) * rounding_noise(value, at, 8) / there;
        all += size(leaves[i]);
    }
    return all > 0 ? 2 * noise / all : 0;  // twice: the rounding of constants has a sign
}

/// Integrals over the square of a sampler's u. Its edges are magnified, u = t^2 (3 - 2 t): tails, and directions that reflection loses,
/// lie there. The mesh is fine from the start along the border between samples that succeed and that fail, which an adaptive rule alone
/// steps over where it has a narrow tongue. value(u): what to integrate; succeeds(u).
/// What lies beyond the last step of a float before 1, where heavy tails may hide, counts as error.
template <class T, std::size_t N>
struct integrals_over_u {
    std::array<double, N> value, error;
};
template <class T, std::size_t N, class Value, class Succeeds>
integrals_over_u<T, N> integral_over_u(const Value& value, const Succeeds& succeeds, const budget& b, std::size_t driving,
                                       std::size_t colours) {
    const auto magnified = [](double t) { return t * t * (3 - 2 * t); };
    const auto at_u = [&](double x, double y) { return value(vec2<T>{below_one<T>(x), below_one<T>(y)}); };
    mesh<N> m(
        [&](double x, double y) {
            std::array<double, N> out = at_u(magnified(x), magnified(y));
            for (double& k : out) k *= 36 * x * (1 - x) * y * (1 - y);
            return out;
        },
        16, 16, driving);
    constexpr int n = 64;
    std::vector<bool> ok(n * n);
    for (int i = 0; i < n * n; ++i)
        ok[static_cast<std::size_t>(i)] =
            succeeds(vec2<T>{below_one<T>(magnified((i % n + 0.5) / n)), below_one<T>(magnified((i / n + 0.5) / n))});
    for (int i = 0; i < n * (n - 1); ++i) {
        const auto at = static_cast<std::size_t>(i);
        if (ok[at] != ok[at + n] || (i % n < n - 1 && ok[at] != ok[at + 1])) m.refine_at((i % n + 1.0) / n, (i / n + 1.0) / n, 2);
    }
    m.refine(b.tolerance, colours, b.evaluations);

    integrals_over_u<T, N> out{m.integral(), m.error()};
    constexpr double step = 0x1p-24, last = 1 - step;
    for (int i = 0; i < 16 && std::is_same_v<T, float>; ++i) {
        const std::array<double, N> edge_x = at_u(last, (i + 0.5) / 16), edge_y = at_u((i + 0.5) / 16, last);
        for (std::size_t k = 0; k < N; ++k) out.error[k] += (std::abs(edge_x[k]) + std::abs(edge_y[k])) * 8 * step / 16;
    }
    return out;
}

/// Smooth numbers of a direction l that a normal m (or a half vector) mirrors to: their means over samples tell a wrong width, tilt or
/// side. The first three are not negative; the others are at most as large as the first two.
inline std::array<double, 5> moments(const vec3<double>& m, double cosine) { return {std::abs(m.x), std::abs(m.y), cosine, m.x, m.y}; }

/// A density over directions against the sampler that is said to follow it, for one view after another: its integral is the fraction of
/// samples that succeed; five means are the same over both; the counts in the cells of its mesh follow it.
template <class T>
class density_check {
public:
    /// `density(view, l)` and `draw(u)`, which returns a direction where it succeeds, on a chart from the square to directions; `moments`
    /// are three smooth numbers of a direction.
    template <class Chart, class Density, class Draw, class Moments>
    void add(const Chart& chart, const Density& density, const Draw& draw, const Moments& numbers, const vec3<T>& view,
             std::uint64_t seed) {
        const vec3<double> v = normalize(vec3<double>(view));
        const std::string at = literal("v", view);
        const std::vector<vec3<double>> samples = draw_strata(draw, budget_.strata, seed);
        std::vector<std::array<double, 2>> hints;
        for (std::size_t k = 0; k < samples.size(); k += std::max<std::size_t>(1, samples.size() / 512))
            hints.push_back(chart.find(samples[k]));

        using values = mesh<6>::values;
        mesh<6> over_l(
            [&](double x, double y) {
                const auto p = chart(x, y);
                const double d = density(view, vec3<T>(p.l)) * p.area;
                const auto t = numbers(p.l);
                return values{d, d * t[0], d * t[1], d * t[2], d * t[3], d * t[4]};
            },
            8, 16, 4);
        for (const vec3<double>& w : {v, vec3<double>{0, 0, 1}}) {
            const auto peak = chart.find(w);
            over_l.refine_at(peak[0], peak[1], 4);
        }
        over_l.refine_crowded(hints, 24, 12);
        over_l.refine(budget_.tolerance, 1, budget_.evaluations);

        const auto over_u = integral_over_u<T, 6>(
            [&](const vec2<T>& u) {
                const std::optional<vec3<T>> l = draw(u);
                if (!l) return values{};
                const auto t = numbers(vec3<double>(*l));
                return values{1, t[0], t[1], t[2], t[3], t[4]};
            },
            [&](const vec2<T>& u) { return draw(u).has_value(); }, budget_, 4, 1);

        const auto &by_l = over_l.integral(), &by_u = over_u.value, &e = over_l.error(), &eu = over_u.error;
        const double allowed = tolerance + relative_rounding<T>(over_l, chart, view, density);
        total.add(by_l[0], by_u[0], allowed * by_u[0] + e[0] + eu[0] + least_that_counts, v, at);
        if (!(by_l[0] > 10 * least_that_counts) || !(by_u[0] > 10 * least_that_counts)) return;  // hardly a sample succeeds
        for (std::size_t k = 1; k < 6; ++k) {
            const double size = k < 4 ? by_l[k] / by_l[0] : by_l[k - 3] / by_l[0];
            means.add(by_u[k] / by_u[0], by_l[k] / by_l[0], allowed * size + (e[k] + e[0] * size) / by_l[0] + (eu[k] + eu[0] * size) / by_u[0], v, at);
        }

        // A small probability is asked for again, twice, with four times as many samples; not where the fault is found already.
        double chance = probability(over_l, chart, samples);
        for (std::uint64_t again = 1; again <= 2 && chance < significance() && total.holds() && means.holds(); ++again)
            chance = (std::max)(chance, probability(over_l, chart, draw_strata(draw, 2 * budget_.strata, seed + 500 * again)));
        if (chance < least) {
            least = chance;
            least_at = at;
        }
    }

    void report_to(report& r) const {
        total.report_to(r);
        means.report_to(r);
        r.add({{samples_ + " follow " + pdf_ + " (chi-squared)", least, 1, significance(), least_at,
                "the samples are distributed otherwise than the density says: the two differ in roughness, axes or measure"},
               least >= significance()});
    }

    density_check(const std::string& pdf, const std::string& samples, const options& o, int views)
        : pdf_(pdf), samples_(samples),
          total("integral of " + pdf + " = successes",
                "it is not the density of these samples: a factor or a Jacobian is wrong, or samples fail that it counts"),
          means("means of " + samples + " = means of " + pdf,
                "the samples are wider, narrower, more tilted or more to one side than the density says"),
          budget_(budget_of(o.effort)), tolerance(o.tolerance), tests(2 * views) {}

private:
    /// n^2 samples, one at random in each of the n^2 squares; those that succeed.
    template <class Draw>
    static std::vector<vec3<double>> draw_strata(const Draw& draw, int n, std::uint64_t seed) {
        generator random(seed);
        std::vector<vec3<double>> out;
        for (int j = 0; j < n; ++j)
            for (int i = 0; i < n; ++i) {
                const double x = (i + random()) / n, y = (j + random()) / n;
                if (const auto l = draw(vec2<T>{below_one<T>(x), below_one<T>(y)})) out.push_back(vec3<double>(*l));
            }
        return out;
    }

    /// Fine bins see a narrow fault, coarse ones a faint and wide one.
    template <class Chart>
    static double probability(const mesh<6>& over_l, const Chart& chart, const std::vector<vec3<double>>& samples) {
        if (samples.empty()) return 1;
        std::vector<double> count(over_l.cells().size());
        for (const vec3<double>& l : samples) {
            const auto p = chart.find(l);
            ++count[over_l.find(p[0], p[1])];
        }
        const double n = static_cast<double>(samples.size());
        std::vector<bin> bins;
        for (const std::size_t at : over_l.leaves())
            bins.push_back({n * (std::max)(over_l.cells()[at].integral[0], 0.0) / over_l.integral()[0], count[at]});
        return (std::min)(chi_squared_probability(merged(bins, 10)), chi_squared_probability(merged(bins, n / 24)));
    }

    /// 1 % for all tests together (Sidak).
    double significance() const { return -std::expm1(std::log(0.99) / tests); }

    std::string pdf_, samples_;
    per_view total, means;
    budget budget_;
    double tolerance;
    int tests;
    double least = 1;
    std::string least_at;
};

}  // namespace lobe::testkit::detail
