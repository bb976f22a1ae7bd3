// The clear coat against the text of KHR_materials_clearcoat.
#include "catch.hpp"
#include "support.hpp"

#include <lobe/brdf/metallic_roughness.hpp>
#include <lobe/energy/albedo.hpp>

using lobe::alpha;
using lobe::alpha_xy;
using lobe::coated;
using lobe::ggx;
using lobe::lambert;
using lobe::vec2;
using lobe::vec3;

namespace {

constexpr double pi = 3.141592653589793;

vec3<double> view(double mu) { return {std::sqrt((1 - mu) * (1 + mu)), 0, mu}; }

/// The extension's README, "Layering": mix(material, D G / (4 cos cos), clearcoat F(n.v)) with glTF's own D and V,
/// alpha the square of clearcoatRoughness, F(n.v) = 0.04 + 0.96 (1 - n.v)^5. Long double.
double printed_coat(double base, double weight, double roughness, const vec3<double>& v, const vec3<double>& l) {
    using real = long double;
    const real a2 = static_cast<real>(roughness) * roughness * roughness * roughness, NV = v.z, NL = l.z;
    const auto h = v + l;
    const real hx = h.x, hy = h.y, hz = h.z, NH2 = hz * hz / (hx * hx + hy * hy + hz * hz);
    const real bottom = NH2 * (a2 - 1) + 1;
    const real D = a2 / (static_cast<real>(pi) * bottom * bottom);
    const real V = 1 / (2 * (NL * std::sqrt(NV * NV * (1 - a2) + a2) + NV * std::sqrt(NL * NL * (1 - a2) + a2)));
    const real share = weight * (0.04L + 0.96L * std::pow(1 - NV, 5.0L));
    return static_cast<double>((1 - share) * base + share * D * V);
}

}  // namespace

TEST_CASE("a clear coat is KHR_materials_clearcoat's", "[coat]") {
    random_numbers random(1);
    double worst = 0;
    for (int i = 0; i < 20000; ++i) {
        const double roughness = random.between(0.1, 1), weight = random(), rho = random();
        const auto v = random.grazing_direction(1e-3), l = random.grazing_direction(1e-3);
        const auto brdf = coated(lambert{rho}, ggx{alpha{roughness * roughness}}, weight);
        const double expected = printed_coat(rho / pi, weight, roughness, v, l);
        worst = larger(worst, std::abs(brdf.f(v, l) / expected - 1));
        worst = larger(worst, std::abs(brdf.f_cos(v, l) / (expected * l.z) - 1));
    }
    CHECK(worst < 1e-12);  // the printed D loses 1/alpha^2 = 1e4 roundings of long double; the rest is a few of double

    // rgb over another composition, where the base is not simply a number
    const vec3<double> gold{1, 0.71, 0.29}, v = view(0.4), l{0, 0.8, 0.6};
    const auto base = lobe::metallic_roughness(gold, 0.3, alpha{0.5});
    for (int c = 0; c < 3; ++c)
        CHECK(coated(base, ggx{alpha{0.04}}, 0.7).f(v, l)[c] ==
              Catch::Approx(printed_coat(base.f(v, l)[c], 0.7, 0.2, v, l)).epsilon(1e-13));
}

TEST_CASE("a clear coat makes no light, and loses only what its facets lose", "[coat]") {
    const auto total = [](double a, double mu, double weight = 1) {
        return lobe::directional_albedo(coated(lambert{1.0}, ggx{alpha{a}}, weight), mu).value;
    };
    double largest = 0, least = 2, worst = 0;
    for (double a : {0.001, 0.01, 0.05, 0.08, 0.1, 0.3, 0.6, 1.0})
        for (double mu : {0.01, 0.03, 0.1, 0.12, 0.3, 0.57, 1.0}) {
            const double E = total(a, mu), F = 0.04 + 0.96 * std::pow(1 - mu, 5);
            largest = larger(largest, E), least = std::min(least, E);
            const double facets = lobe::directional_albedo(
                lobe::microfacet{ggx{alpha{a}}, lobe::smith_correlated{}, lobe::perfect_reflector{}}, mu);
            worst = larger(worst, std::abs(E - (1 - F * (1 - facets))));
            worst = larger(worst, std::abs(total(a, mu, 0.3) - (1 - 0.3 * F * (1 - facets))));
        }
    CHECK(worst < 1e-5);  // quadrature, asked for 1e-6 of each lobe
    CHECK(largest < 1 + 1e-5);
    CHECK(std::abs(least - 0.853) < 0.0005);  // as stated, at (alpha 1, mu 0.12)
    CHECK(least == total(1, 0.12));
    // smooth coats reflect F(n.v) and no more
    CHECK(std::abs(total(0.001, 1.0) - 1) < 1e-5);
}

TEST_CASE("a clear coat is sampled by what each part reflects", "[coat]") {
    for (double mu : {0.05, 0.3, 1.0})
        for (double a : {0.01, 0.1, 0.5})
            for (double weight : {0.0, 0.25, 1.0}) {
                const auto brdf = coated(lambert{1.0}, ggx{alpha{a}}, weight);
                const auto v = view(mu);
                constexpr int side = 256;
                double mean = 0, largest = 0, inconsistent = 0;
                for (int i = 0; i < side; ++i)
                    for (int j = 0; j < side; ++j) {
                        const auto s = brdf.sample(v, {(i + 0.5) / side, (j + 0.5) / side});
                        if (!(s.pdf > 0)) continue;
                        mean += s.weight / (side * side);
                        largest = larger(largest, s.weight);
                        const auto e = brdf.evaluate(v, s.l);
                        inconsistent = larger(
                            {inconsistent, std::abs(e.pdf / s.pdf - 1), std::abs(e.f_cos / (s.weight * s.pdf) - 1)});
                    }
                // Shares w and 1 - w of weights that are at most 1 each: a white base under a coat of F = 1
                CHECK(largest < 1 + 1e-12);
                CHECK(inconsistent < 1e-12);
                // the grid's error: one cell in `side` straddles the border between the lobes, whose weights differ by
                // at most 1
                CHECK(std::abs(mean - lobe::directional_albedo(brdf, mu).value) < 1.0 / side);
            }
}

TEST_CASE("a clear coat: weight 0, bad weights, two widths, a colour's type", "[coat]") {
    const vec3<double> v = view(0.3), l = view(0.7);
    CHECK(coated(lambert{0.5}, ggx{alpha{0.1}}, 0.0).f(v, l) == lambert{0.5}.f(v, l));
    for (const float bad : {-0.1f, 1.5f, std::numeric_limits<float>::quiet_NaN()})
        CHECK(aborts([&] { (void)coated(lambert{0.5f}, ggx{alpha{0.1f}}, bad); }));
    static_assert(!decltype(coated(lambert{0.5}, ggx{alpha_xy{0.1, 0.2}}, 1.0))::isotropic);
    const auto coloured = coated(lambert{vec3<float>{0.5f, 0.2f, 0.1f}}, ggx{alpha{0.1f}}, 1.0f);
    static_assert(std::same_as<decltype(coloured.f_cos({}, {})), vec3<float>> &&
                  lobe::samplable_brdf<decltype(coloured)>);
    CHECK(coloured.width() == vec2<float>{0.1f, 0.1f});
}
