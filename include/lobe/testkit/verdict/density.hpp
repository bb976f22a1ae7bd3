// A density over directions against the sampler that is said to follow it.
#pragma once

#include <lobe/testkit/measure/chi_squared.hpp>
#include <lobe/testkit/measure/expectation.hpp>
#include <lobe/testkit/measure/over_directions.hpp>
#include <lobe/testkit/measure/rounding.hpp>
#include <lobe/testkit/measure/second_opinion.hpp>
#include <lobe/testkit/options.hpp>
#include <lobe/testkit/verdict/per_view.hpp>
#include <lobe/testkit/verdict/report.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace lobe::testkit::detail {

/// The three checks of a density.
struct density_ids {
    property_id integral, means, follow;
};

/// A density over directions against the sampler that is said to follow it, for one view after another: its integral is
/// the fraction of samples that succeed; five means are the same over both; the counts in the cells of its mesh follow
/// it.
template <class T>
class density_check {
public:
    density_check(const density_ids& of, const options& o, int views)
        : total(of.integral, "it is not the density of these samples: a factor or a Jacobian is wrong, or samples fail "
                             "that it counts"),
          means(of.means, "the samples are wider, narrower, more tilted or more to one side than the density says"),
          follow(of.follow), effort(budget_of(o.effort)), tolerance(o.tolerance), tests(2 * views) {}

    /// `density(view, l)` on a chart from the square to directions, and the sampler's numbers; `moments` are five
    /// smooth numbers of a direction.
    template <class Chart, class Density, class Moments>
    void add(const Chart& chart, const Density& density, const expectation<T>& over_u, const Moments& moments_of,
             const vec3<T>& view, std::uint64_t seed) {
        const vec3<double> v = normalize(vec3<double>(view));
        const std::string at = literal("v", view);
        const std::vector<vec3<double>> samples = draw_strata(over_u, effort.strata, seed);
        hints some;
        for (std::size_t k = 0; k < samples.size(); k += std::max<std::size_t>(1, samples.size() / 512))
            some.push_back(chart.find(samples[k]));

        using values = mesh<6>::values;
        const auto over_l = std::make_shared<mesh<6>>(
            [&](double x, double y) {
                const auto p = chart(x, y);
                const double d = density(view, vec3<T>(p.l)) * p.area;
                const auto t = moments_of(p.l);
                return values{d, d * t[0], d * t[1], d * t[2], d * t[3], d * t[4]};
            },
            chart.columns, 16, 4);
        integrate(*over_l, chart, v, some, effort, 1);
        const auto sampled = over_u.template of<6>(
            [&](const vec3<T>& u) {
                const std::optional<vec3<T>> l = over_u.draw(u);
                if (!l) return values{};
                const auto t = moments_of(vec3<double>(*l));
                return values{1, t[0], t[1], t[2], t[3], t[4]};
            },
            effort, 4, 1);

        const double allowed = tolerance + relative_rounding<T>(*over_l, chart, view, density);
        const auto expected = doubtable_integral<6>(over_l);
        total.add([&](bool doubted) -> view_result {
            const auto &by_l = expected(doubted), &by_u = sampled(doubted);
            return {.measured = by_l.value[0],
                    .expected = by_u.value[0],
                    .allowed = allowed * by_u.value[0] + by_l.error[0] + by_u.error[0] + least_that_counts,
                    .v = v,
                    .input = at};
        });
        const double hardly = 10 * least_that_counts;  // a sample succeeds
        if (!(expected(false).value[0] > hardly) || !(sampled(false).value[0] > hardly)) return;
        for (std::size_t k = 1; k < 6; ++k)
            means.add([&](bool doubted) -> view_result {
                const auto& [l, e] = expected(doubted);
                const auto& [u, eu] = sampled(doubted);
                const double size = (k < 4 ? l[k] : l[k - 3]) / l[0];
                return {.measured = u[k] / u[0],
                        .expected = l[k] / l[0],
                        .allowed = allowed * size + (e[k] + e[0] * size) / l[0] + (eu[k] + eu[0] * size) / u[0],
                        .v = v,
                        .input = at};
            });

        // A small probability is asked for again, twice, with four times as many samples; not where the fault is found
        // already.
        opinion<6> first{{over_l->integral(), {}}, {}, {}};
        for (const std::size_t leaf : over_l->leaves()) first.leaf.push_back(over_l->cells()[leaf].integral[0]);
        double chance = probability(*over_l, first, chart, samples);
        const auto doubted = [&] { return chance < significance() && total.holds() && means.holds(); };
        std::vector<vec3<double>> more;
        for (std::uint64_t again = 1; again <= 2 && doubted(); ++again) {
            more = draw_strata(over_u, 2 * effort.strata, seed + 500 * again);
            chance = (std::max)(chance, probability(*over_l, first, chart, more));
        }
        if (doubted()) chance = (std::max)(chance, probability(*over_l, second_opinion(*over_l), chart, more));
        if (chance < least) least = chance, least_at = at;
    }

    void report_to(report& r) const {
        total.report_to(r);
        means.report_to(r);
        r.add(follow, {.passed = least >= significance(),
                       .measured = least,
                       .expected = 1,
                       .tolerance = significance(),
                       .input = least_at,
                       .meaning = "the samples are distributed otherwise than the density says: the two differ in "
                                  "roughness, axes or measure"});
    }

private:
    /// n^2 samples, one at random in each of the n^2 squares; those that succeed.
    static std::vector<vec3<double>> draw_strata(const expectation<T>& over_u, int n, std::uint64_t seed) {
        const auto drawn = [&] {
            generator random(seed);
            std::vector<vec3<double>> out;
            for (int j = 0; j < n; ++j)
                for (int i = 0; i < n; ++i)
                    if (const auto l = over_u.draw(random_u<T>(random, over_u.numbers, i, j, n)))
                        out.push_back(vec3<double>(*l));
            return out;
        };
        rehearse(drawn);
        return drawn();
    }

    /// Fine bins see a narrow fault, coarse ones a faint and wide one.
    template <class Chart>
    static double probability(const mesh<6>& over_l, const opinion<6>& density, const Chart& chart,
                              const std::vector<vec3<double>>& samples) {
        if (samples.empty()) return 1;
        std::vector<double> count(over_l.cells().size());
        for (const vec3<double>& l : samples) {
            const auto p = chart.find(l);
            ++count[over_l.find(p[0], p[1])];
        }
        const double n = static_cast<double>(samples.size());
        std::vector<bin> bins;
        const std::vector<std::size_t> leaves = over_l.leaves();
        for (std::size_t i = 0; i < leaves.size(); ++i) {
            const double share = n / density.all.value[0];
            bins.push_back({share * (std::max)(density.leaf[i], 0.0), count[leaves[i]],
                            density.variance.empty() ? 0 : share * share * density.variance[i]});
        }
        return (std::min)(chi_squared_probability(merged(bins, 10)), chi_squared_probability(merged(bins, n / 24)));
    }

    /// 1 % for all tests together (Sidak).
    double significance() const { return -std::expm1(std::log(0.99) / tests); }

    per_view total, means;
    property_id follow;
    budget effort;
    double tolerance;
    int tests;
    double least = 1;
    std::string least_at;
};

}  // namespace lobe::testkit::detail
