#include "brdf_families.hpp"
#include "catch.hpp"

#include <algorithm>
#include <cstdio>
#include <map>

namespace {

using lobe::vec3;

/// How often `directional_albedo`'s estimate is below its error, among random cases of one model.
struct honesty {
    int cases = 0, below = 0;
    std::vector<double> ratio, evaluations;
};

/// For every model and each of `options`, random parameters and views: the albedo in T against the mesh in double.
template <class T>
auto honesty_of_every_model(std::uint64_t seed, int cases, const std::vector<lobe::quadrature>& options,
                            double tolerance, long mesh_evaluations) {
    std::vector<std::function<any_brdf<double>(drawn<double>&)>> in_double;
    every_family<double>([&](const char*, const char*, const auto& make) { in_double.push_back(make); });
    std::map<std::pair<std::string, std::string>, std::vector<honesty>> all;
    std::size_t model = 0;
    every_family<T>([&](const char* kind, const char* name, const auto& make) {
        auto& result = all[{kind, name}];
        result.resize(options.size());
        for (int i = 0; i < cases; ++i) {
            drawn<double> wide{random_numbers(seed + static_cast<std::uint64_t>(i))};
            drawn<T> narrow{random_numbers(seed + static_cast<std::uint64_t>(i))};
            const any_brdf<double> exact = in_double[model](wide);
            const any_brdf<T> brdf = make(narrow);
            const double mu = wide.log(1e-3, 1), azimuth = exact.isotropic ? 0 : wide.between(0, 6.28);
            const double sine = std::sqrt((1 - mu) * (1 + mu));
            const vec3<T> v(vec3<double>{sine * std::cos(azimuth), sine * std::sin(azimuth), mu});
            const auto truth = albedo_by_mesh(exact, vec3<double>(v), tolerance, mesh_evaluations);
            for (std::size_t k = 0; k < options.size(); ++k) {
                lobe::estimate<vec3<T>, T> E{vec3<T>(T(0)), T(0), 0};
                for (const auto& part : brdf.lobes) {
                    const auto e = lobe::detail::directional_albedo(part, v, exact.isotropic, options[k]);
                    E = {E.value + e.value, E.error + e.error, E.evaluations + e.evaluations};
                }
                double worst = 0, off = 0;
                for (int c = 0; c < 3; ++c) {
                    const double difference = std::abs(static_cast<double>(E.value[c]) - truth.value[c]);
                    worst = larger(worst, difference);
                    // the mesh's own estimate, measured: off by less than 3 times that
                    off = larger(off, difference - 3 * truth.error[c]);
                }
                result[k].cases += 1;
                result[k].below += !(off <= static_cast<double>(E.error));
                result[k].ratio.push_back(static_cast<double>(E.error) / larger(worst, 1e-16));
                result[k].evaluations.push_back(E.evaluations);
            }
        }
        ++model;
    });
    return all;
}

double median(std::vector<double> x) {
    std::nth_element(x.begin(), x.begin() + static_cast<std::ptrdiff_t>(x.size() / 2), x.end());
    return x[x.size() / 2];
}

}  // namespace

TEST_CASE("quadrature: glass from both sides agrees with every row of the table", "[quadrature]") {
    // The table has 12 digits, and its own error, 1.6e-8 at most, in its last column. From outside F is smooth, but has
    // a layer at grazing where eta is near 1.
    double inside[2] = {}, outside[2] = {};
    const int orders[2] = {16, 32};
    const double digits = 5e-13;
    int dishonest = 0, rows = 0;
    for (const auto& row : reference_table("glass_single.csv")) {
        const auto compare = [&](const auto& masking, double right) {
            const lobe::microfacet glass{lobe::ggx{lobe::alpha{row[1]}}, masking, lobe::dielectric{row[0]}};
            for (int k = 0; k < 2; ++k) {
                const auto E = lobe::directional_albedo(glass, row[2], {.order = orders[k]});
                double& worst = (row[0] < 1 ? inside : outside)[k];
                worst = larger(worst, std::abs(E.value - right));
                dishonest += !(std::abs(E.value - right) <= E.error + row[7] + digits);
            }
            const auto E = lobe::directional_albedo(glass, row[2]);
            CHECK(std::abs(E.value - right) <= 1e-6 + row[7]);
            dishonest += !(std::abs(E.value - right) <= E.error + row[7] + digits);
            ++rows;
        };
        compare(lobe::smith_correlated{}, row[3]);
        compare(lobe::smith_separable{}, row[4]);
    }
    INFO("inside " << inside[0] << ", " << inside[1] << ", outside " << outside[0] << ", " << outside[1]);
    CHECK(rows == 784);
    CHECK(inside[0] < 1e-6);
    CHECK(outside[0] < 2e-5);
    CHECK(inside[1] < 1e-7);
    CHECK(outside[1] < 1e-7);
    CHECK(dishonest == 0);
}

TEST_CASE("quadrature: the average albedo of glass from inside, cut at the critical cosine", "[quadrature]") {
    // Against panels of 8 Gauss points that halve towards 0 and towards the critical cosine from both sides: of a
    // smooth surface E has the root of F there. E by order 32, right to 1e-7.
    const lobe::gauss_legendre<double> rule(8);
    for (const double a : {1e-3, 0.02, 0.5})
        for (const double eta : {0.4, 0.75, 0.95}) {
            const lobe::microfacet glass{lobe::ggx{lobe::alpha{a}}, lobe::smith_correlated{}, lobe::dielectric{eta}};
            const double c = std::sqrt((1 - eta) * (1 + eta));
            std::vector<double> edges{0, c, 1};
            for (double h = 0.5; h > 1e-4; h /= 2)
                edges.insert(edges.end(), {c / 2 * h, c - c / 2 * h, c + (1 - c) * h});
            std::sort(edges.begin(), edges.end());
            double right = 0;
            for (std::size_t k = 0; k + 1 < edges.size(); ++k)
                for (std::size_t i = 0; i < 8; ++i) {
                    const double range = edges[k + 1] - edges[k], mu = edges[k] + range * rule.x[i];
                    const vec3<double> v{std::sqrt((1 - mu) * (1 + mu)), 0, mu};
                    const auto f_cos = [&](const vec3<double>& l) { return glass.f_cos(v, l); };
                    right += 2 * mu * range * rule.w[i] *
                             lobe::detail::hemisphere_integral_at(f_cos, v, glass.width(), true, 32, {c});
                }
            for (const int order : {0, 16}) {
                const auto E = lobe::average_albedo(glass, {.order = order});
                INFO("alpha " << a << ", eta " << eta << ", order " << order << ": off by " << E.value - right);
                CHECK(std::abs(E.value - right) <= E.error + 1e-7);
                CHECK(std::abs(E.value - right) <= (order ? 1e-4 : 1e-6));
            }
        }
}

TEMPLATE_TEST_CASE("quadrature: the estimate is at least the error in 99 of 100 cases of every kind of model",
                   "[quadrature]", float, double) {
    const std::vector<lobe::quadrature> options{{}, {.order = 16}, {.order = 32}};
    std::map<std::string, std::vector<honesty>> kinds;
    const int cases = std::same_as<TestType, double> ? 20 : 8;
    for (const auto& [model, result] : honesty_of_every_model<TestType>(1, cases, options, 1e-8, 200000)) {
        auto& kind = kinds[model.first];
        kind.resize(options.size());
        for (std::size_t k = 0; k < options.size(); ++k) {
            INFO(model.second << ", order " << options[k].order);
            CHECK(result[k].below <= 1);
            kind[k].cases += result[k].cases;
            kind[k].below += result[k].below;
        }
    }
    for (const auto& [kind, result] : kinds)
        for (std::size_t k = 0; k < options.size(); ++k) {
            INFO(kind << ", order " << options[k].order << ": below in " << result[k].below << " of "
                      << result[k].cases);
            CHECK(result[k].below * 100 <= result[k].cases);
        }
}

TEST_CASE("quadrature: only what says that it is smooth skips orders", "[quadrature]") {
    using lobe::detail::smooth;
    const lobe::ggx ndf{lobe::alpha{0.3}};
    const lobe::schlick F{0.04};
    CHECK(smooth(lobe::microfacet{ndf, lobe::smith_correlated{}, F}));
    CHECK(!smooth(lobe::microfacet{ndf, lobe::v_cavity{}, F}));
    CHECK(!smooth(lobe::microfacet{ndf, lobe::smith_direction_correlated{}, F}));
    CHECK(!smooth(lobe::oren_nayar{0.8, 0.5}));
    // a base under a lobe, whose share may come from a table
    bool any = false;
    lobe::detail::for_each_lobe(
        lobe::layered{lobe::microfacet{ndf, lobe::v_cavity{}, F}, lobe::lambert{0.8}, lobe::albedo_coupling{F}},
        [&](const auto& part) { any = any || smooth(part); });
    CHECK(!any);
    // and it does: 8, 12, 16 and 32, or the whole row of them
    const auto evaluations = [&](const auto& masking) {
        return lobe::directional_albedo(lobe::microfacet{ndf, masking, F}, 0.3).evaluations;
    };
    CHECK(evaluations(lobe::smith_correlated{}) == 128 + 288 + 512 + 2048);
    CHECK(evaluations(lobe::v_cavity{}) > 128 + 288 + 512 + 1152 + 2048);
}

// By hand: the table of all models, LOBE_CASES=200 each.
TEMPLATE_TEST_CASE("quadrature: table of estimates", "[.][estimates]", float, double) {
    const std::vector<lobe::quadrature> options{{}, {.order = 8}, {.order = 16}, {.order = 32}, {.order = 64}};
    const char* number = std::getenv("LOBE_CASES");
    const int cases = number ? std::atoi(number) : 200;
    for (const auto& [model, result] : honesty_of_every_model<TestType>(1000, cases, options, 1e-9, 400000)) {
        std::printf("%-13s %-50s", model.first.c_str(), model.second.c_str());
        for (const honesty& h : result) {
            double mean = 0;
            for (const double n : h.evaluations) mean += n / h.cases;
            CHECK(h.below * 100 <= h.cases);
            std::printf(" | %5.1f%% %6.0e %7.0f", 100.0 * h.below / h.cases, median(h.ratio), mean);
        }
        std::printf("\n");
        std::fflush(stdout);
    }
}
