#include "catch.hpp"
#include "support.hpp"

#include <lobe/brdf/lambert.hpp>
#include <lobe/brdf/sum.hpp>
#include <lobe/energy/dfg_table.hpp>
#include <lobe/energy/fdez_aguera.hpp>
#include <lobe/energy/random_walk.hpp>
#include <lobe/fresnel/schlick.hpp>
#include <lobe/sampling/points.hpp>

using lobe::alpha;
using lobe::alpha_xy;
using lobe::ggx;
using lobe::microfacet;
using lobe::perfect_reflector;
using lobe::schlick;
using lobe::smith_correlated;
using lobe::smith_separable;
using lobe::vec2;
using lobe::vec3;

TEST_CASE("albedo and split-sum terms agree with the tables on the whole grid", "[energy]") {
    // The bars: 2e-5 with 512 evaluations a point (2 x 16 x 16) and 2e-6 with 2048 for the correlated form, half as
    // much again for the separable one, whose albedo bends more at grazing angles.
    struct bar {
        int order;
        double correlated, separable;
    };
    for (const bar& b : {bar{16, 2e-5, 3e-5}, bar{32, 2e-6, 3e-6}}) {
        double correlated = 0, separable = 0;
        const lobe::quadrature options{.order = b.order};
        for (const auto& row : reference_table("albedo_ggx_F1.csv")) {
            const microfacet hc{ggx{alpha{row[1]}}, smith_correlated{}, perfect_reflector{}};
            const microfacet sep{ggx{alpha{row[1]}}, smith_separable{}, perfect_reflector{}};
            correlated = larger(correlated, std::abs(lobe::directional_albedo(hc, row[0], options).value - row[2]));
            separable = larger(separable, std::abs(lobe::directional_albedo(sep, row[0], options).value - row[3]));
        }
        for (const auto& row : reference_table("splitsum_ggx_AB.csv")) {
            const auto hc = lobe::dfg_exact(smith_correlated{}, row[0], alpha{row[1]}, options);
            const auto sep = lobe::dfg_exact(smith_separable{}, row[0], alpha{row[1]}, options);
            correlated = larger({correlated, std::abs(hc.scale - row[2]), std::abs(hc.bias - row[3])});
            separable = larger({separable, std::abs(sep.scale - row[4]), std::abs(sep.bias - row[5])});
        }
        INFO("order " << b.order << ": correlated " << correlated << ", separable " << separable);
        CHECK(correlated <= b.correlated);
        CHECK(separable <= b.separable);
    }
}

TEST_CASE("the quadrature raises its order until the error is small enough, and says so", "[energy]") {
    for (const auto& row : reference_table("albedo_ggx_F1.csv")) {
        const microfacet hc{ggx{alpha{row[1]}}, smith_correlated{}, perfect_reflector{}};
        const auto E = lobe::directional_albedo(hc, row[0], {.tolerance = 1e-6});
        INFO("mu " << row[0] << " alpha " << row[1]);
        CHECK(std::abs(E.value - row[2]) < 1e-6);
        CHECK(E.error <= 1e-6);
        CHECK(E.evaluations <= 128 + 288 + 512 + 2048);
    }
    const microfacet hc{ggx{alpha{0.3}}, smith_correlated{}, perfect_reflector{}};
    // itself, three quarters and half of it, for its error
    CHECK(lobe::directional_albedo(hc, 0.5, {.order = 16}).evaluations == 512 + 288 + 128);
}

TEST_CASE("the same accuracy between the table's points", "[energy]") {
    // At alpha 1 there is a closed form; elsewhere the rule is compared with four times its order, after the table has
    // vouched for the formula itself. Anisotropic widths up to 1000 apart have bars of their own.
    random_numbers random(6);
    double closed = 0, low = 0, high = 0, anisotropic = 0;
    for (int i = 0; i < 300; ++i) {
        const double mu = random.log_between(1e-3, 1), a = random.log_between(1e-3, 1);
        const microfacet one{ggx{alpha{1.0}}, smith_correlated{}, perfect_reflector{}};
        closed = larger(
            closed, std::abs(lobe::directional_albedo(one, mu, {.order = 16}).value - (1 - mu * std::log(1 + 1 / mu))));
        const auto compare = [&](const auto& masking) {
            const microfacet lobe{ggx{alpha{a}}, masking, perfect_reflector{}};
            const double fine = lobe::directional_albedo(lobe, mu, {.order = 128}).value;
            low = larger(low, std::abs(lobe::directional_albedo(lobe, mu, {.order = 16}).value - fine));
            high = larger(high, std::abs(lobe::directional_albedo(lobe, mu, {.order = 32}).value - fine));
        };
        compare(smith_correlated{});
        compare(smith_separable{});
        if (i % 10) continue;
        const microfacet lobe{ggx{alpha_xy{a, random.log_between(1e-3, 1)}}, smith_correlated{}, perfect_reflector{}};
        const auto v = random.grazing_direction(1e-3);
        anisotropic = larger(anisotropic, std::abs(lobe::directional_albedo(lobe, v, {.order = 32}).value -
                                                   lobe::directional_albedo(lobe, v, {.order = 128}).value));
    }
    INFO("closed form " << closed << ", order 16 " << low << ", order 32 " << high << ", anisotropic " << anisotropic);
    CHECK(closed < 2e-5);
    CHECK(low < 2e-5);
    CHECK(high < 1e-7);
    CHECK(anisotropic < 5e-5);
}

TEST_CASE("compositions reach the same accuracy through the same function", "[energy]") {
    for (const bool correlated : {true, false}) {
        const auto table = reference_table("albedo_ggx_F1.csv");
        const auto E = [&](double mu, double a) {
            for (const auto& row : table)
                if (row[0] == mu && row[1] == a) return row[correlated ? 2 : 3];
            throw std::runtime_error("not in the table");
        };
        const auto check = [&](const auto& masking) {
            for (double mu : {0.001, 0.01, 0.1, 0.5, 1.0}) {
                const microfacet sharp{ggx{alpha{0.01}}, masking, perfect_reflector{}};
                const microfacet rough{ggx{alpha{0.5}}, masking, perfect_reflector{}};
                const lobe::sum mixture{lobe::weighted{0.3, sharp}, lobe::weighted{0.7, rough}};
                const lobe::sum coated{rough, lobe::lambert{0.4}};
                const lobe::sum nested{rough, lobe::weighted{0.5, lobe::sum{mixture, lobe::lambert{0.4}}}};
                for (const auto& [order, bar] : {std::pair{16, 3e-5}, std::pair{32, 3e-6}}) {
                    INFO("mu " << mu << " order " << order);
                    CHECK(std::abs(lobe::directional_albedo(mixture, mu, {.order = order}).value -
                                   (0.3 * E(mu, 0.01) + 0.7 * E(mu, 0.5))) < bar);
                    CHECK(std::abs(lobe::directional_albedo(coated, mu, {.order = order}).value - (E(mu, 0.5) + 0.4)) <
                          bar);
                    CHECK(std::abs(lobe::directional_albedo(nested, mu, {.order = order}).value -
                                   (0.15 * E(mu, 0.01) + 1.35 * E(mu, 0.5) + 0.2)) < 1.5 * bar);
                }
            }
        };
        if (correlated)
            check(smith_correlated{});
        else
            check(smith_separable{});
    }
}

TEST_CASE("a view of any azimuth, isotropic or not", "[energy]") {
    random_numbers random(1);
    for (int i = 0; i < 50; ++i) {
        const double a = random.log_between(0.001, 1), mu = random.log_between(0.001, 1), phi = random.between(0, 6.28);
        const double s = std::sqrt((1 - mu) * (1 + mu));
        const microfacet one{ggx{alpha{a}}, smith_correlated{}, schlick{0.2}};
        const microfacet same{ggx{alpha_xy{a, a}}, smith_correlated{}, schlick{0.2}};
        const vec3<double> v{s * std::cos(phi), s * std::sin(phi), mu};
        CHECK(std::abs(lobe::directional_albedo(one, v).value - lobe::directional_albedo(one, mu).value) < 1e-6);
        CHECK(std::abs(lobe::directional_albedo(same, v).value - lobe::directional_albedo(one, mu).value) < 1e-6);
        // anisotropic against 65536 visible normals: their weights are bounded by 1, the error is of order log(n)/n
        const microfacet aniso{ggx{alpha_xy{a, 0.4}}, smith_correlated{}, perfect_reflector{}};
        double mean = 0;
        for (std::uint32_t k = 0; k < 65536; ++k)
            mean += aniso.sample(v, lobe::hammersley<double>(k, 65536)).weight / 65536;
        CHECK(std::abs(lobe::directional_albedo(aniso, v).value - mean) < 3e-4);
    }
}

TEST_CASE("average albedo agrees with the table", "[energy]") {
    for (const auto& row : reference_table("eavg_ggx.csv")) {
        const alpha a{row[0]};
        INFO("alpha " << row[0]);
        CHECK(std::abs(lobe::average_albedo(microfacet{ggx{a}, smith_correlated{}, perfect_reflector{}}).value -
                       row[1]) < 1e-6);
        CHECK(std::abs(lobe::average_albedo(microfacet{ggx{a}, smith_separable{}, perfect_reflector{}}).value -
                       row[4]) < 1e-6);
        // Schlick's F0 = 0.04 is A F0 + B
        CHECK(std::abs(lobe::average_albedo(microfacet{ggx{a}, smith_correlated{}, schlick{0.04}}).value -
                       (0.04 * row[2] + row[3])) < 1e-6);
    }
    CHECK(lobe::average_albedo(lobe::lambert{0.5}).value == Catch::Approx(0.5));
}

TEST_CASE("albedo in float is that of double to float's digits", "[energy]") {
    for (float a : {0.01f, 0.1f, 1.0f})
        for (float mu : {0.01f, 0.5f, 1.0f}) {
            const microfacet in_float{ggx{alpha{a}}, smith_correlated{}, schlick{vec3<float>{0.9f, 0.5f, 0.04f}}};
            const microfacet in_double{ggx{alpha{static_cast<double>(a)}}, smith_correlated{},
                                       schlick{vec3<double>{0.9f, 0.5f, 0.04f}}};
            const auto x = lobe::directional_albedo(in_float, mu);
            const auto y = lobe::directional_albedo(in_double, static_cast<double>(mu));
            // l rounded to 6e-8 shifts the half vector by 6e-8/mu slopes at most; the shifts are random and average out
            CHECK(lobe::length(vec3<double>(x.value) - y.value) < larger(2e-6, static_cast<double>(x.error) / 4));
        }
}

TEST_CASE("the baked table keeps its promise between and beyond its nodes", "[energy]") {
    const auto check = [](const auto& masking, double E_max, double E_rms, double A_max, double A_rms) {
        const auto table = lobe::bake_dfg<float>(masking, {.size = 32});
        double E_worst = 0, A_worst = 0, E_square = 0, A_square = 0;
        const int n = 40;
        for (int i = 0; i < n; ++i)
            for (int j = 0; j < n; ++j) {
                const double mu = std::pow((i + 0.37) / n, 3), r = 0.03 + 0.97 * (j + 0.41) / n;
                const auto exact = lobe::dfg_exact(masking, mu, alpha{r * r}, {.order = 32});
                const auto read = table(static_cast<float>(mu), alpha{static_cast<float>(r * r)});
                const double E = static_cast<double>(read.albedo()) - exact.albedo(),
                             A = static_cast<double>(read.scale) - exact.scale;
                E_worst = larger(E_worst, std::abs(E));
                A_worst = larger(A_worst, std::abs(A));
                E_square += E * E / (n * n);
                A_square += A * A / (n * n);
                CHECK(read.bias >= 0);
            }
        INFO("E " << E_worst << " / " << std::sqrt(E_square) << "  scale " << A_worst << " / " << std::sqrt(A_square));
        CHECK(E_worst < E_max);
        CHECK(std::sqrt(E_square) < E_rms);
        CHECK(A_worst < A_max);
        CHECK(std::sqrt(A_square) < A_rms);
        for (float mu : {0.0f, 1.0f})  // corners and edges: finite and in range
            for (float a : {1e-6f, 1e-3f, 1.0f}) {
                const auto t = table(mu, alpha{a});
                CHECK(t.scale >= 0);
                CHECK(t.bias >= 0);
                CHECK(t.albedo() <= 1.00001f);
            }
        const auto bent = table(0.0f, alpha{0.3f});  // a cosine below the horizon, or none at all, is answered at it
        CHECK(table(-0.01f, alpha{0.3f}).scale == bent.scale);
        CHECK(table(std::numeric_limits<float>::quiet_NaN(), alpha{0.3f}).bias == bent.bias);
        CHECK(table(std::numeric_limits<float>::infinity(), alpha{0.3f}).bias == table(1.0f, alpha{0.3f}).bias);
        CHECK(table(1.0f, alpha{1e-4f}).scale == Catch::Approx(1).margin(1e-5));
        CHECK(table(0.0f, alpha{1e-4f}).scale == Catch::Approx(0).margin(0.02));
    };
    check(smith_correlated{}, 1.5e-3, 4e-4, 3.5e-3, 8e-4);
    check(smith_separable{}, 1.5e-3, 4e-4, 3.5e-3, 8e-4);
}

TEST_CASE("dfg_exact goes to its limit as alpha goes to 0", "[energy]") {
    // E = 1, bias = (1 - mu)^5. 1e-6 of the tolerance, 2e-6 of l's rounding at alpha mu = 1e-13, and (alpha/mu)^2
    for (const double a : {1e-6, 1e-8, 1e-10})
        for (const double mu : {0.001, 0.03, 0.3, 1.0}) {
            const auto t = lobe::dfg_exact(smith_correlated{}, mu, alpha{a});
            const double Fc = std::pow(1 - mu, 5);
            INFO("alpha " << a << ", mu " << mu << ": " << t.scale << ' ' << t.bias);
            CHECK(std::abs(t.scale - (1 - Fc)) < 4e-6);
            CHECK(std::abs(t.bias - Fc) < 4e-6);
        }
}

TEST_CASE("fdez_aguera: white furnace, and coloured albedo against the random walk", "[energy]") {
    const auto table = lobe::bake_dfg<float>(smith_correlated{});
    for (float mu : {0.01f, 0.3f, 1.0f})
        for (float r : {0.05f, 0.5f, 1.0f}) {
            const auto t = table(mu, alpha<float>::from_roughness(r));
            const auto white = lobe::fdez_aguera{}(t, 1.0f);
            CHECK(std::abs(white.radiance + white.irradiance - 1) < 1e-6f);
            const auto dielectric = lobe::fdez_aguera{}(t, vec3<float>(0.04f), vec3<float>(1.0f));
            CHECK(lobe::length(dielectric.radiance + dielectric.irradiance - vec3<float>(1)) < 1e-6f);
            const auto black = lobe::fdez_aguera{}(t, 0.04f, 0.0f), metal = lobe::fdez_aguera{}(t, 0.04f);
            CHECK(black.irradiance == metal.irradiance);
        }
    // F90: the first bounce is the albedo of schlick{F0, F90}; the others are the geometric series, summed here term by
    // term
    for (const double mu : {0.1, 0.7})
        for (const double F90 : {0.0, 0.3, 0.8}) {
            const double F0 = 0.2;
            const auto t = lobe::dfg_exact(smith_correlated{}, mu, alpha{0.6});
            const auto w = lobe::fdez_aguera{F90}(t, F0);
            CHECK(std::abs(w.radiance -
                           lobe::directional_albedo(
                               lobe::microfacet{ggx{alpha{0.6}}, smith_correlated{}, schlick{F0, F90}}, mu)) < 2e-6);
            const double again = schlick{F0, F90}.average() * (1 - t.albedo());
            double later = 0;
            for (double bounce = w.radiance * again; bounce > 1e-17; bounce *= again) later += bounce;
            CHECK(std::abs(w.irradiance - later) < 1e-15);
            CHECK(std::abs(lobe::fdez_aguera{F90}(t, F0, 1.0).irradiance + w.radiance - 1) < 1e-15);
        }
    static_assert(std::is_empty_v<decltype(lobe::fdez_aguera{})>);
    // the largest deviation of the model itself, measured independently on this table
    double worst[4] = {};
    for (const auto& row : reference_table("multiscatter_random_walk.csv")) {
        const auto t = lobe::dfg_exact(smith_correlated{}, row[0], alpha{row[1]});
        const double F0[4] = {0.04, 0.2, 0.5, 0.9};
        for (int i = 0; i < 4; ++i) {
            const auto w = lobe::fdez_aguera{}(t, F0[i]);
            worst[i] =
                larger(worst[i], std::abs(w.radiance + w.irradiance - row[static_cast<std::size_t>(12 + 4 * i)]));
        }
    }
    INFO(worst[0] << ' ' << worst[1] << ' ' << worst[2] << ' ' << worst[3]);
    CHECK(worst[0] < 0.0205);
    CHECK(worst[1] < 0.0215);
    CHECK(worst[2] <= 0.042);
    CHECK(worst[3] <= 0.060);
    // and what the header states for smooth surfaces at grazing angles, mu = alpha: to four standard errors and the
    // last digit
    random_numbers random(7);
    const double stated[][3] = {{0.01, 0.04, 0.074}, {1e-4, 0.04, 0.099}, {1e-4, 0.2, 0.084}, {1e-4, 0.5, 0.054}};
    for (const auto& [a, F0, darker] : stated) {
        const int paths = 100000;
        const lobe::random_walk walk{ggx{alpha{a}}, schlick{F0}};
        const vec3<double> v{std::sqrt((1 - a) * (1 + a)), 0, a};
        double sum = 0, squares = 0;
        for (int i = 0; i < paths; ++i) {
            const double weight = walk.sample(v, random).weight;
            sum += weight / paths;
            squares += weight * weight / paths;
        }
        const auto w = lobe::fdez_aguera{}(lobe::dfg_exact(smith_correlated{}, a, alpha{a}), F0);
        INFO("alpha " << a << ", F0 " << F0 << ": darker by " << sum - w.radiance - w.irradiance);
        CHECK(std::abs(sum - w.radiance - w.irradiance - darker) < 4 * std::sqrt((squares - sum * sum) / paths) + 5e-4);
    }
}

TEST_CASE("the random walk agrees with every row of the table", "[energy]") {
    // Four standard errors, of both. (mu, alpha, N, F = 1: total, unfinished, longest, order 1, 2, 3+ with errors; then
    // F0.)
    const int paths = 150000;
    random_numbers random(2);
    double worst = 0;
    for (const auto& row : reference_table("multiscatter_random_walk.csv")) {
        const vec3<double> v{std::sqrt((1 - row[0]) * (1 + row[0])), 0, row[0]};
        const lobe::random_walk mirror{ggx{alpha{row[1]}}, perfect_reflector{}};
        double orders[3] = {}, energy = 0;
        const double F0[4] = {0.04, 0.2, 0.5, 0.9};
        double sum[4] = {}, squares[4] = {};
        // Schlick's spectrum has room for three F0; the fourth walks as one number
        const lobe::random_walk metal{ggx{alpha{row[1]}}, schlick{vec3<double>{F0[0], F0[1], F0[2]}}};
        const lobe::random_walk bright{ggx{alpha{row[1]}}, schlick{F0[3]}};
        for (int i = 0; i < paths; ++i) {
            const auto white = mirror.sample(v, random);
            orders[std::min(white.order, 3) - 1] += 1.0 / paths;
            energy += white.weight / paths;
            CHECK(white.l.z > 0);
            const auto path = metal.sample(v, random);
            const double weights[4] = {path.weight.x, path.weight.y, path.weight.z, bright.sample(v, random).weight};
            for (int k = 0; k < 4; ++k) {
                sum[k] += weights[k];
                squares[k] += weights[k] * weights[k];
            }
        }
        INFO("mu " << row[0] << " alpha " << row[1]);
        CHECK(energy == Catch::Approx(1).epsilon(1e-9));
        for (std::size_t k = 0; k < 3; ++k) {
            const double p = row[6 + 2 * k],
                         error = std::sqrt(std::max(p * (1 - p), 1.0 / paths) / paths) + row[7 + 2 * k];
            worst = larger(worst, std::abs(orders[k] - p) / error);
            CHECK(std::abs(orders[k] - p) < 4 * error);
        }
        for (std::size_t k = 0; k < 4; ++k) {
            const double mean = sum[k] / paths, variance = squares[k] / paths - mean * mean;
            const double error = std::sqrt(variance / paths) + row[13 + 4 * k];
            worst = larger(worst, std::abs(mean - row[12 + 4 * k]) / error);
            CHECK(std::abs(mean - row[12 + 4 * k]) < 4 * error);
        }
    }
    INFO("worst " << worst << " standard errors");
    CHECK(worst > 1);  // 112 comparisons that all agree within one would be no statistics
}

TEST_CASE("the random walk's first bounce is smith_correlated", "[energy]") {
    const ggx ndf{alpha{0.7}};
    const lobe::random_walk walk{ndf, schlick{0.3}};
    const microfacet single{ndf, smith_correlated{}, schlick{0.3}};
    const vec3<double> v{std::sqrt(1 - 0.09), 0, 0.3};
    random_numbers random(3);
    const int paths = 400000;
    double mean = 0, square = 0;
    for (int i = 0; i < paths; ++i) {
        const auto path = walk.sample(v, random);
        const double x = path.order == 1 ? path.weight * path.l.x : 0;  // a moment, so that directions are tested too
        mean += x / paths;
        square += x * x / paths;
    }
    const auto exact = lobe::hemisphere_integral([&](const vec3<double>& l) { return single.f_cos(v, l) * l.x; }, v,
                                                 single.width(), true);
    CHECK(std::abs(mean - exact.value) < 4 * std::sqrt((square - mean * mean) / paths));
}
