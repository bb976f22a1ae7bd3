// What a rough interface reflects and transmits: quadrature against a table, the random walk against another, and both.
#include "catch.hpp"
#include "support.hpp"

#include <lobe/bsdf/rough_dielectric.hpp>
#include <lobe/energy/interface_albedo.hpp>
#include <lobe/energy/interface_walk.hpp>
#include <lobe/ndf/beckmann.hpp>
#include <lobe/ndf/ggx.hpp>

using lobe::alpha;
using lobe::alpha_xy;
using lobe::ggx;
using lobe::importance_transport;
using lobe::rough_dielectric;
using lobe::smith_joint;
using lobe::smith_joint_exact;
using lobe::smith_product;
using lobe::vec3;

namespace {

vec3<double> view(double mu) { return {std::sqrt((1 - mu) * (1 + mu)), 0, mu}; }

}  // namespace

TEST_CASE("albedo of an interface by quadrature, against a table of another method", "[glass]") {
    double at_32 = 0, by_itself = 0, overstated = 0;
    for (const auto& row : reference_table("glass_single.csv")) {
        const double eta = row[0], a = row[1], mu = row[2];
        const rough_dielectric joint{ggx{alpha{a}}, smith_joint_exact{}, eta, importance_transport{}};
        const rough_dielectric product{ggx{alpha{a}}, smith_product{}, 1 / eta, importance_transport{}};  // from below
        const auto j = directional_albedo(joint, mu, {.order = 32}),
                   p = directional_albedo(product, -mu, {.order = 32});
        at_32 = larger({at_32, std::abs(j.reflected - row[3]), std::abs(j.transmitted - row[5]),
                        std::abs(p.reflected - row[4]), std::abs(p.transmitted - row[6])});
        const auto e = directional_albedo(joint, mu, {.tolerance = 1e-6});
        by_itself = larger({by_itself, std::abs(e.reflected - row[3]), std::abs(e.transmitted - row[5])});
        overstated = larger({overstated, std::abs(e.reflected - row[3]) - e.reflected.error - row[7],
                             std::abs(e.transmitted - row[5]) - e.transmitted.error - row[7]});
    }
    CHECK(at_32 < 1e-7);
    CHECK(by_itself < 1e-6 + 2e-8);
    CHECK(overstated <= 0);
}

TEST_CASE("albedo of an interface: any azimuth, radiance, averages", "[glass]") {
    const auto shares = [](const auto& glass, const vec3<double>& v) {
        const auto e = directional_albedo(glass, v, {.order = 48});
        return std::pair<double, double>(e.reflected, e.transmitted);
    };
    const rough_dielectric round{ggx{alpha_xy{0.3, 0.3}}, smith_joint{}, 1.5, importance_transport{}};
    const rough_dielectric isotropic{ggx{alpha{0.3}}, smith_joint{}, 1.5, importance_transport{}};
    const rough_dielectric radiance{ggx{alpha{0.3}}, smith_joint{}, 1.5};
    const rough_dielectric brushed{ggx{alpha_xy{0.1, 0.4}}, smith_product{}, 1.5, importance_transport{}};
    for (const double mu : {0.9, 0.4, -0.9, -0.6, -0.2}) {
        const double s = std::sqrt((1 - mu) * (1 + mu));
        const auto along = directional_albedo(isotropic, mu, {.order = 48});
        const auto turned = shares(round, {s * 0.6, s * 0.8, mu});
        CHECK(turned.first == Catch::Approx(along.reflected.value).margin(1e-7));
        CHECK(turned.second == Catch::Approx(along.transmitted.value).margin(1e-7));
        const double n = mu > 0 ? 1.5 : 1 / 1.5;
        CHECK(directional_albedo(radiance, mu, {.order = 48}).transmitted ==
              Catch::Approx(along.transmitted / (n * n)).margin(1e-10));
        // of the anisotropic one: the mean weight of its samples
        const vec3<double> v{s * 0.6, s * 0.8, mu};
        random_numbers random(1);
        double sum[2] = {0, 0};
        constexpr int samples = 200000;
        for (int i = 0; i < samples; ++i) {
            const double x = random(), y = random(), z = random();
            const auto w = brushed.sample(v, {x, y, z});
            sum[(w.l.z > 0) == (mu > 0) ? 0 : 1] += w.weight;
        }
        const auto exact = shares(brushed, v);
        CHECK(std::abs(sum[0] / samples - exact.first) < 4 * 0.5 / std::sqrt(samples));
        CHECK(std::abs(sum[1] / samples - exact.second) < 4 * 0.5 / std::sqrt(samples));
    }
    // the light that goes through is the same both ways: T_avg(eta) = eta^2 T_avg(1/eta)
    for (const double a : {0.1, 0.5, 1.0})
        for (const double eta : {1.5, 2.4}) {
            const rough_dielectric glass{ggx{alpha{a}}, smith_joint_exact{}, eta, importance_transport{}};
            const auto outside = average_albedo(glass, false, {.order = 24}),
                       inside = average_albedo(glass, true, {.order = 24});
            CHECK(outside.transmitted == Catch::Approx(eta * eta * inside.transmitted).epsilon(2e-6));
            const auto finer = average_albedo(glass, true, {.order = 32});
            CHECK(std::abs(finer.transmitted - inside.transmitted) <= inside.transmitted.error);
            CHECK(std::abs(finer.reflected - inside.reflected) <= inside.reflected.error);
        }
}

TEST_CASE("the random walk through an interface, against a table of another program", "[glass]") {
    // totals and orders; all light comes back
    constexpr int n = 20000;
    double worst = 0, squares = 0;
    int compared = 0, row_number = 0;
    for (const auto& row : reference_table("glass_walk.csv")) {
        const bool above = ++row_number % 2 == 0;
        const double eta = row[0], a = row[1], mu = row[2];
        const lobe::interface_walk walk{ggx{alpha{a}}, above ? eta : 1 / eta};
        random_numbers random(static_cast<std::uint64_t>(row_number));
        double first[2] = {0, 0}, later[2] = {0, 0};
        for (int i = 0; i < n; ++i) {
            const auto p = walk.sample(view(above ? mu : -mu), random);
            REQUIRE(p.weight == 1);
            CHECK(p.order >= 1);
            (p.order == 1 ? first : later)[(p.l.z > 0) == above ? 0 : 1] += 1;
        }
        const auto compare = [&](double count, double share) {
            const double expected = share * n, z = (count - expected) / std::sqrt(expected * (1 - share) + 1);
            if (expected < 20) return;
            worst = larger(worst, std::abs(z));
            squares += z * z;
            ++compared;
        };
        compare(first[0], row[8]);
        compare(first[1], row[10]);
        compare(later[0], row[12]);
        compare(later[1], row[14]);
    }
    INFO(compared << " shares, the worst " << worst << " standard errors off, mean square " << squares / compared);
    CHECK(compared > 330);
    CHECK(worst < 4.2);
    CHECK(squares / compared < 1.25);
}

TEST_CASE("the walk's first facet is the interface, of any distribution, and its orders are reciprocal", "[glass]") {
    constexpr int n = 100000;
    const auto compare = [&](const auto& ndf, double eta, const vec3<double>& v) {
        const rough_dielectric glass{ndf, smith_joint_exact{}, eta, importance_transport{}};
        const auto exact = directional_albedo(glass, v, {.order = 48});
        const lobe::interface_walk walk{ndf, eta};
        random_numbers random(3);
        double counts[2] = {0, 0};
        for (int i = 0; i < n; ++i) {
            const auto p = walk.sample(v, random);
            if (p.order == 1) counts[(p.l.z > 0) == (v.z > 0) ? 0 : 1] += 1;
        }
        CHECK(std::abs(counts[0] / n - exact.reflected) <
              4 * std::sqrt(exact.reflected * (1 - exact.reflected) / n) + 1e-5);
        CHECK(std::abs(counts[1] / n - exact.transmitted) <
              4 * std::sqrt(exact.transmitted * (1 - exact.transmitted) / n) + 1e-5);
    };
    for (const double mu : {0.8, 0.2, -0.8, -0.4}) {
        compare(lobe::beckmann{alpha{0.6}}, 1.5, view(mu));
        compare(ggx{alpha_xy{0.8, 0.2}}, 1.33, {view(mu).x * 0.6, view(mu).x * 0.8, mu});
    }
    // Of light that comes from everywhere: eta^2 times what crosses from below crosses from above, in each order; the
    // variance of a count is at most the count.
    for (const double eta : {1.5, 2.4}) {
        const lobe::interface_walk walk{ggx{alpha{0.7}}, eta};
        random_numbers random(4);
        double crossed[2][3] = {};
        for (int below = 0; below < 2; ++below)
            for (int i = 0; i < n; ++i) {
                const double mu = std::sqrt(random());
                const auto p = walk.sample(view(below ? -mu : mu), random);
                if ((p.l.z > 0) == (below == 1)) crossed[below][std::min(p.order, 3) - 1] += 1;
            }
        for (int order = 0; order < 3; ++order) {
            const double from_above = crossed[0][order], from_below = crossed[1][order];
            REQUIRE(from_below > 100);
            CHECK(std::abs(from_above - eta * eta * from_below) <
                  4 * std::sqrt(from_above + eta * eta * eta * eta * from_below));
        }
    }
}

TEST_CASE("the walk's first facet against the quadrature, over the whole range of glasses", "[glass]") {
    constexpr int n = 4000;
    double worst = 0, squares = 0;
    int compared = 0;
    for (const double eta : {1.1, 1.33, 1.5, 2.4})
        for (const double a : {0.01, 0.1, 0.5, 1.0}) {
            const rough_dielectric glass{ggx{alpha{a}}, smith_joint_exact{}, eta, importance_transport{}};
            const lobe::interface_walk walk{ggx{alpha{a}}, eta};
            random_numbers random(static_cast<std::uint64_t>(compared + 1));
            for (const double mu : {1.0, 0.8, 0.5, 0.3, 0.1, 0.05, 0.02})
                for (const double at : {mu, -mu}) {
                    const auto exact = directional_albedo(glass, at, {.order = 24});
                    double count[2] = {0, 0};
                    for (int i = 0; i < n; ++i) {
                        const auto p = walk.sample(view(at), random);
                        if (p.order == 1) count[(p.l.z > 0) == (at > 0) ? 0 : 1] += 1;
                    }
                    const double shares[2] = {exact.reflected, exact.transmitted};
                    for (int k = 0; k < 2; ++k) {
                        const double variance = shares[k] * (1 - shares[k]) * n;
                        if (variance < 15) continue;  // too few of a kind to be normal
                        const double z = (count[k] - shares[k] * n) / std::sqrt(variance);
                        worst = larger(worst, std::abs(z));
                        squares += z * z;
                        ++compared;
                    }
                }
        }
    INFO(compared << " shares, the worst " << worst << " standard errors off, mean square " << squares / compared);
    CHECK(compared > 300);
    CHECK(worst < 4);
    CHECK(squares / compared < 1.25);
}
