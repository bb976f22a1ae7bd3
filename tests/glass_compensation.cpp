// A rough interface that keeps its light: nothing lost, shared as the random walk shares it, reciprocal, sampled.
#include "catch.hpp"
#include "support.hpp"

#include <lobe/energy/compensated_dielectric.hpp>
#include <lobe/ndf/beckmann.hpp>
#include <lobe/ndf/ggx.hpp>

using lobe::alpha;
using lobe::compensated_dielectric;
using lobe::ggx;
using lobe::importance_transport;
using lobe::interface_energy;
using lobe::rough_dielectric;
using lobe::smith_joint;
using lobe::vec3;

namespace {

constexpr double pi = 3.141592653589793;

vec3<double> view(double mu) { return {std::sqrt((1 - mu) * (1 + mu)), 0, mu}; }

/// What `glass` has beyond its first facet, over the hemisphere above or below: it does not depend on the azimuth.
template <class G>
double later(const G& glass, double mu, bool above) {
    double sum = 0;
    constexpr int n = 4800;
    const vec3<double> v = view(mu);
    for (int i = 0; i < n; ++i) {
        const double y = (i + 0.5) / n, at = y * y;  // nodes are even in the root of the cosine
        const vec3<double> l{0, std::sqrt((1 - at) * (1 + at)), above ? at : -at};
        sum += 2 * pi * (glass.f(v, l) - glass.first_facet().f(v, l)) * at * 2 * y / n;
    }
    return sum;
}

}  // namespace

TEST_CASE("compensated glass returns all light", "[glass]") {
    double worst = 0;
    for (const double eta : {1.05, 1.5, 2.5})
        for (const double a : {0.01, 0.1, 1.0}) {
            const rough_dielectric glass{ggx{alpha{a}}, smith_joint{}, eta, importance_transport{}};
            const interface_energy energy{glass};
            const compensated_dielectric whole{glass, energy};
            for (const double mu : {0.01, 0.017, 0.03, 0.06, 0.11, 0.2, 0.35, 0.5, 0.65, 0.76, 0.87, 0.93, 1.0})
                for (const double at : {mu, -mu}) {
                    const auto first = directional_albedo(glass, at, {.order = 32});
                    const double total =
                        first.reflected + first.transmitted + later(whole, at, true) + later(whole, at, false);
                    INFO("eta " << eta << ", alpha " << a << ", mu " << at << ": " << total);
                    CHECK(std::abs(total - 1) < 0.004);
                    worst = larger(worst, std::abs(total - 1));
                }
        }
    CHECK(worst > 1e-6);  // it was asked
}

TEST_CASE("compensated glass shares the light as the random walk of another program does", "[glass]") {
    const auto rows = reference_table("glass_walk.csv");
    double worst = 0;
    int compared = 0;
    for (const double eta : {1.1, 1.5, 2.4})
        for (const double a : {0.1, 0.25, 0.5, 1.0}) {
            const rough_dielectric glass{ggx{alpha{a}}, smith_joint{}, eta, importance_transport{}};
            const interface_energy energy{glass};
            const compensated_dielectric whole{glass, energy};
            for (const auto& row : rows) {
                if (std::abs(row[1] - a) > 1e-9 || std::min(std::abs(row[0] - eta), std::abs(row[0] - 1 / eta)) > 1e-9)
                    continue;
                const bool above = std::abs(row[0] - eta) < 1e-9;
                const double mu = above ? row[2] : -row[2];
                const auto first = directional_albedo(glass, mu, {.order = 32});
                const double reflected = first.reflected + later(whole, mu, above),
                             through = first.transmitted + later(whole, mu, !above);
                INFO("eta " << eta << ", alpha " << a << ", mu " << mu << ": " << reflected << " for " << row[4]);
                CHECK(std::abs(reflected - row[4]) < 0.01);
                CHECK(std::abs(through - row[6]) < 0.01);
                worst = larger(worst, std::abs(reflected - row[4]));
                ++compared;
            }
        }
    CHECK(compared == 72);
    INFO("worst " << worst);
    CHECK(worst < 0.008);
}

TEST_CASE("compensated glass: reciprocal, both transports, samples and densities", "[glass]") {
    const auto test = [](const auto& ndf, double eta, double largest_weight) {
        const rough_dielectric first{ndf, smith_joint{}, eta, importance_transport{}};
        const rough_dielectric radiance_first{ndf, smith_joint{}, eta};
        const interface_energy energy{first}, same_energy{radiance_first};
        CHECK(energy.above.other.average == Catch::Approx(same_energy.above.other.average).epsilon(1e-9));
        const compensated_dielectric importance{first, energy};
        const compensated_dielectric radiance{radiance_first, energy};
        random_numbers random(1);
        constexpr int n = 200000;
        double by_samples = 0, by_sphere = 0;
        for (int i = 0; i < n; ++i) {
            const auto v = random.direction(), l = random.direction();
            const double there = importance.f(v, l) - first.f(v, l), back = radiance.f(l, v) - radiance_first.f(l, v);
            REQUIRE(there >= -1e-14 * first.f(v, l));
            REQUIRE(there == Catch::Approx(back).epsilon(1e-9).margin(1e-10 * first.f(v, l) + 1e-13));
            const auto e = importance.evaluate(v, l);
            REQUIRE(e.f_cos == Catch::Approx(importance.f(v, l) * std::abs(l.z)).epsilon(1e-12));
            REQUIRE(e.f_cos == importance.f_cos(v, l));
            REQUIRE(e.pdf == importance.pdf(v, l));
            const auto s = importance.sample(v, {random(), random(), random()});
            by_sphere += 4 * pi * e.pdf / (1 + 4 * pi * e.pdf) / n;
            if (!(s.pdf > 0)) continue;
            const auto at = importance.evaluate(v, s.l);
            REQUIRE(at.pdf == Catch::Approx(s.pdf).epsilon(1e-8));
            REQUIRE(at.f_cos == Catch::Approx(s.pdf * s.weight).epsilon(1e-8));
            REQUIRE(s.weight < largest_weight);
            by_samples += 1 / (1 + 4 * pi * s.pdf) / n;
        }
        // p the density of the samples, q that of an even sphere: int p q/(p + q) by samples of either
        CHECK(by_samples == Catch::Approx(by_sphere).margin(4 * 0.7 / std::sqrt(double(n))));
    };
    test(ggx{alpha{0.5}}, 1.5, 4);
    test(ggx{alpha{1.0}}, 1.05, 30);
    test(lobe::beckmann{alpha{0.3}}, 1.33, 6);
}
