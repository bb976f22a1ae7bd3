// Compensated BRDFs against the random walk, quadrature and the white furnace.
#include "catch.hpp"
#include "support.hpp"

#include <lobe/lobe.hpp>
#include <lobe/testkit.hpp>

using lobe::alpha, lobe::compensated, lobe::ggx, lobe::microfacet, lobe::schlick, lobe::smith_correlated,
    lobe::smith_multiscatter, lobe::vec2, lobe::vec3;

namespace {

/// The columns of random_walk_grid.csv: mu, alpha, scale, bias, then T of these F0.
constexpr double reflectances[] = {0, .02, .04, .08, .15, .25, .35, .45, .55, .65, .75, .85, .95, 1};

vec3<double> view(double mu) { return {std::sqrt((1 - mu) * (1 + mu)), 0, mu}; }

/// The terms that one row of the grid gives, exact to 1e-15.
struct terms_of_row {
    lobe::dfg_terms<double> t;
    lobe::dfg_terms<double> operator()(double, const alpha<double>&) const { return t; }
    lobe::dfg_terms<double> average(const alpha<double>&) const { return t; }
};

template <class F>
auto metal(const F& fresnel, double a) {
    return microfacet{ggx{alpha{a}}, smith_correlated{}, fresnel};
}

/// The mean of a random walk's weights and its standard error.
template <class F>
auto walked(const F& fresnel, double a, double mu, int paths, random_numbers& random) {
    const lobe::random_walk walk{ggx{alpha{a}}, fresnel};
    const vec3<double> v = view(mu);
    return lobe::sample_mean({static_cast<std::uint32_t>(paths) / 32, 32},
                             [&](std::uint32_t, std::uint32_t) { return walk.sample(v, random).weight; });
}

}  // namespace

TEST_CASE("the closed form has the energy of the random walk", "[compensation]") {
    double worst = 0, at_1 = 0, of_table = 0;
    for (const auto& row : reference_table("random_walk_grid.csv")) {
        const double mu = row[0], a = row[1];
        if (mu < 0.02 || a < 0.05) continue;
        for (std::size_t i = 0; i < 14; ++i) {
            const schlick F{reflectances[i]};
            const double later = smith_multiscatter{terms_of_row{{row[2], row[3]}}}.energy(F, alpha{a})(mu);
            worst = larger(worst, std::abs(later - row[4 + i]));
            if (i == 13) at_1 = larger(at_1, std::abs(later + row[2] + row[3] - 1));
            const double total = smith_multiscatter{}.energy(F, alpha{a}).total(mu);
            of_table = larger(of_table, std::abs(total - (F.F0() * row[2] + row[3] + row[4 + i])));
        }
    }
    INFO("with exact terms " << worst << ", with the default table " << of_table << ", lossless to " << at_1);
    CHECK(worst < 0.0017);  // 0.00165 on the grid it was fitted to
    CHECK(of_table < 0.002);
    CHECK(at_1 < 1e-15);
}

TEST_CASE("... at points that are nobody's grid, for the whole BRDF", "[compensation]") {
    random_numbers random(31);
    double closed = 0, averaged = 0, forward = 0;
    for (int i = 0; i < 24; ++i) {
        const double mu = random.log_between(0.02, 1), a = random.log_between(0.05, 1);
        const schlick F{vec3<double>{random(), random(), random()}};
        const auto truth = walked(F, a, mu, 320000, random);
        const auto albedo = [&](const auto& model) {
            return lobe::directional_albedo(compensated{metal(F, a), model}, mu, {.order = 64}).value;
        };
        const auto off = [&](const vec3<double>& E) {
            double largest = 0;
            for (int k = 0; k < 3; ++k)
                largest = larger(largest, std::abs(E[k] - truth.value[k]) - 4 * truth.standard_error[k]);
            return largest;
        };
        INFO("mu " << mu << " alpha " << a);
        closed = larger(closed, off(albedo(smith_multiscatter{})));
        averaged = larger(averaged, off(albedo(smith_multiscatter{}.averaged_by_quadrature())));
        if (a > 0.1) forward = larger(forward, off(albedo(smith_multiscatter{}.forward())));
    }
    INFO("closed " << closed << ", by quadrature " << averaged << ", forward " << forward);
    CHECK(closed < 0.0025);
    CHECK(averaged < 0.002);
    CHECK(forward < 0.0025);
}

TEST_CASE("the white furnace of each model", "[compensation]") {
    // F = 1: what is missing is the error of the table, 4e-4, and of the quadrature, 1e-5
    const auto beckmann_terms =
        lobe::bake_dfg<double>(smith_correlated{}, {.size = 64}, [](auto a) { return lobe::beckmann{a}; });
    for (double a : {0.02, 0.1, 0.3, 0.6, 1.0})
        for (double mu : {0.02, 0.1, 0.4, 0.7, 1.0}) {
            const auto lobe_1 = metal(schlick{1.0}, a);
            const auto E = [&](const auto& model) {
                return lobe::directional_albedo(compensated{lobe_1, model}, mu, {.order = 96}).value;
            };
            INFO("mu " << mu << " alpha " << a);
            CHECK(std::abs(E(smith_multiscatter{}) - 1) < 5e-4);
            CHECK(std::abs(E(smith_multiscatter{}.averaged_by_quadrature()) - 1) < 5e-4);
            CHECK(std::abs(E(lobe::kulla_conty{}) - 1) < 5e-4);
            CHECK(std::abs(E(lobe::turquin{}) - 1) < 5e-4 / 0.3);  // of E, relative
            const auto beckmann = microfacet{lobe::beckmann{alpha{a}}, smith_correlated{}, schlick{1.0}};
            const double B =
                lobe::directional_albedo(compensated{beckmann, lobe::kulla_conty{beckmann_terms}}, mu, {.order = 96});
            CHECK(std::abs(B - 1) < 2e-3);
        }
}

TEST_CASE("weights of image-based light add up", "[compensation]") {
    // in float: F = 1, and a white base under any interface
    random_numbers random(5);
    double worst = 0;
    const auto check = [&](const auto& model, float mu, const alpha<float>& a) {
        const auto sum = [](const auto& w) { return static_cast<double>(w.radiance + w.irradiance); };
        const auto F0 = static_cast<float>(random()), F90 = static_cast<float>(random.between(F0, 1));
        worst = larger({worst, std::abs(sum(model.weights(schlick{1.0f}, mu, a)) - 1),
                        std::abs(sum(model.weights(schlick{F0}, mu, a, 1.0f)) - 1),
                        std::abs(sum(model.weights(schlick{F0, F90}, mu, a, 1.0f)) - 1)});
    };
    for (int i = 0; i < 20000; ++i) {
        const auto mu = static_cast<float>(random.log_between(1e-3, 1));
        const alpha<float> a(static_cast<float>(random.log_between(1e-3, 1)));
        check(smith_multiscatter{}, mu, a);
        check(lobe::kulla_conty{}, mu, a);
        check(lobe::turquin{}, mu, a);
        check(smith_multiscatter{lobe::dfg_fit_cheap{}}, mu, a);
    }
    CHECK(worst < 1e-5);
}

TEST_CASE("other Fresnel reflectances: the later bounces of metals", "[compensation]") {
    random_numbers random(6);
    const auto check = [&](const auto& F, double bound) {
        const double places[][2] = {{0.9, 0.9}, {0.4, 0.5}, {0.1, 0.2}, {0.5, 1.0}};
        for (const auto& [mu, a] : places) {
            const auto truth = walked(F, a, mu, 320000, random);
            const auto b = compensated{metal(F, a), smith_multiscatter{}};
            const auto E = lobe::directional_albedo(b, mu, {.order = 64}).value;
            for (int k = 0; k < 3; ++k) {
                INFO("mu " << mu << " alpha " << a << ": " << E[k] << " for " << truth.value[k]);
                // and what the default table is off by
                CHECK(std::abs(E[k] - truth.value[k]) < bound + 4e-4 + 4 * truth.standard_error[k]);
            }
        }
    };
    check(lobe::materials::gold<double>(), 0.005);
    check(lobe::materials::iron<double>(), 0.004);
    check(lobe::f82_tint{vec3<double>{0.9, 0.6, 0.9}, vec3<double>{0.8, 0.6, 1.0}}, 0.006);
}

TEST_CASE("compensated BRDFs before the judge", "[compensation]") {
    lobe::testkit::options reciprocal, lossless, one_sided;
    reciprocal.reciprocal = lossless.reciprocal = lossless.lossless = true;
    one_sided.reciprocal = false;
    const schlick gold{vec3<double>{1.0, 0.71, 0.29}};
    for (double a : {0.05, 0.3, 1.0}) {
        CHECK(lobe::testkit::verify(compensated{metal(gold, a)}, reciprocal));
        CHECK(lobe::testkit::verify(compensated{metal(gold, a), smith_multiscatter{}.forward()}, reciprocal));
        CHECK(lobe::testkit::verify(compensated{metal(gold, a), lobe::kulla_conty{}}, reciprocal));
        CHECK(lobe::testkit::verify(compensated{metal(schlick{1.0}, a)}, lossless));
    }
    // turquin's gains energy for lights at grazing angles: it looks at the view alone
    const auto r = lobe::testkit::verify(compensated{metal(gold, 0.5), lobe::turquin{}}, one_sided);
    for (const auto& finding : r.findings()) CHECK(finding.id.key == lobe::testkit::id::furnace_of_light.key);
}

TEST_CASE("a metal and a dielectric mixed keep their energy", "[compensation]") {
    double closed = 0, averaged = 0;
    for (double metallic : {0.0, 0.25, 0.5, 0.75, 1.0})
        for (double a : {0.03, 0.1, 0.3, 0.6, 1.0})
            for (double mu : {0.03, 0.1, 0.4, 0.7, 1.0}) {
                const auto furnace = [&](const auto& model) {
                    return std::abs(lobe::directional_albedo(lobe::metallic_roughness(1.0, metallic, alpha{a}, model),
                                                             mu, {.order = 96}) -
                                    1);
                };
                closed = larger(closed, furnace(smith_multiscatter{}));
                averaged = larger(averaged, furnace(smith_multiscatter{}.averaged_by_quadrature()));
            }
    INFO("closed " << closed << ", by quadrature " << averaged);
    CHECK(closed < 1e-3 + 4e-4);
    CHECK(averaged < 5e-4);

    const vec3<double> base{0.9, 0.5, 0.1};
    lobe::testkit::options reciprocal;
    reciprocal.reciprocal = true;
    for (double metallic : {0.0, 0.4, 1.0})
        CHECK(lobe::testkit::verify(lobe::metallic_roughness(base, metallic, alpha{0.3}, smith_multiscatter{}),
                                    reciprocal));
    const vec3<double> v = view(0.3), l = lobe::normalize(vec3<double>{-0.3, 0.5, 0.4});
    const vec3<double> metal_alone = compensated{metal(schlick{base}, 0.3)}.f(v, l);
    CHECK(lobe::length(lobe::metallic_roughness(base, 1.0, alpha{0.3}, smith_multiscatter{}).f(v, l) - metal_alone) <
          1e-14);
}

TEST_CASE("weights of samples of a compensated BRDF", "[compensation]") {
    random_numbers random(9);
    for (double F0 : {0.5, 0.8, 1.0})
        for (double a : {0.05, 0.1, 0.3, 0.6, 1.0}) {
            double worst = 0;
            const auto plain = compensated{metal(schlick{F0}, a)};
            const auto forward = compensated{metal(schlick{F0}, a), smith_multiscatter{}.forward()};
            for (int i = 0; i < 100000; ++i) {
                const vec3<double> v = view(random.log_between(1e-3, 1));
                const vec2<double> u{random(), random()};
                worst = larger({worst, plain.sample(v, u).weight, forward.sample(v, u).weight});
            }
            INFO("F0 " << F0 << " alpha " << a << ": " << worst);
            CHECK(worst < 2.1);
        }
}

TEST_CASE("compensated BRDFs at the ends of alpha", "[compensation]") {
    // in float, from a mirror to alpha 1, at grazing and along the normal: numbers, not below 0, no more than all light
    random_numbers random(12);
    for (float a : {1e-6f, 1e-4f, 4e-4f, 1e-3f, 0.02f, 1.0f}) {
        const auto b = microfacet{ggx{alpha<float>(a)}, smith_correlated{}, schlick{vec3<float>{1.0f, 0.5f, 0.0f}}};
        const auto plain = compensated{b};
        const auto forward = compensated{b, smith_multiscatter{}.forward()};
        const auto kulla = compensated{b, lobe::kulla_conty{}};
        for (int i = 0; i < 3000; ++i) {
            vec3<float> v(random.direction()), l(random.direction());
            if (i % 3 == 0) v.z = static_cast<float>(random.log_between(1e-18, 1e-3));
            if (i % 5 == 0) l.z = static_cast<float>(random.log_between(1e-18, 1e-3));
            const vec2<float> u{static_cast<float>(random()), static_cast<float>(random())};
            const auto check = [&](const auto& brdf) {
                const auto e = brdf.evaluate(v, l);
                const auto s = brdf.sample(v, u);
                REQUIRE((e.f_cos.x >= 0 && e.f_cos.y >= 0 && e.f_cos.z >= 0 && std::isfinite(e.pdf)));
                REQUIRE((s.weight.x >= 0 && s.weight.x < 10 && std::isfinite(s.weight.x)));
            };
            check(plain);
            check(forward);
            check(kulla);
        }
    }
    // where the lobe ends, it held less than 1e-6
    const auto mirror = metal(schlick{1.0}, 2e-4);
    CHECK(std::abs(lobe::directional_albedo(compensated{mirror}, 0.5, {.order = 64}).value - 1) < 1e-5);
}
