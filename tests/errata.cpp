// The formulas that the five source documents print wrong, as printed, beside lobe's. Each check is written once,
// passes for lobe's and fails for the printed one; the numbers of docs/errata.md come out on the way. Section names are
// the ids of that page.
#include "catch.hpp"
#include "support.hpp"

#include <lobe/brdf/lambert.hpp>
#include <lobe/brdf/metallic_roughness.hpp>
#include <lobe/brdf/microfacet.hpp>
#include <lobe/brdf/schlick_ggx.hpp>
#include <lobe/energy/albedo.hpp>
#include <lobe/energy/dfg_table.hpp>
#include <lobe/energy/fdez_aguera.hpp>
#include <lobe/fresnel/dielectric.hpp>
#include <lobe/fresnel/materials.hpp>
#include <lobe/fresnel/schlick.hpp>
#include <lobe/fresnel/schlick_roughness.hpp>
#include <lobe/ibl/irradiance.hpp>
#include <lobe/ibl/prefilter.hpp>
#include <lobe/ndf/beckmann.hpp>
#include <lobe/ndf/blinn_phong.hpp>
#include <lobe/ndf/ggx.hpp>
#include <lobe/ndf/gtr.hpp>
#include <lobe/sampling/points.hpp>
#include <lobe/sampling/warp.hpp>

#include <algorithm>

using lobe::alpha;
using lobe::alpha_xy;
using lobe::dfg_terms;
using lobe::ggx;
using lobe::microfacet;
using lobe::schlick;
using lobe::smith_correlated;
using lobe::smith_separable;
using lobe::vec2;
using lobe::vec3;

namespace {

constexpr double pi = 3.141592653589793, half_pi = pi / 2;
const vec3<double> n{0, 0, 1};

/// x to so many decimals: what docs/errata.md prints. (The quotient is the double nearest to the decimal, as is the
/// literal.)
double rounded(double x, int decimals) {
    const double scale = std::round(std::exp(decimals * std::log(10.0)));
    return std::round(x * scale) / scale;
}

bool agree(double a, double b, double tolerance) { return std::abs(a - b) <= tolerance; }

vec3<double> at(double mu) { return lobe::detail::view_at(mu); }

double fifth_power(double x) { return x * x * x * x * x; }

// ---- distributions
// -------------------------------------------------------------------------------------------------------------------

/// int g(m) dm over the upper hemisphere, g even in the azimuth: double-exponential in theta, with theta and pi/2 -
/// theta carried apart.
template <class G>
double over_normals(const G& g) {
    double total = 0;
    constexpr double h = 1.0 / 64;
    for (int i = -320; i <= 320; ++i) {  // to 1e-101 off the horizon: there cos^-1.82, the worst below, is still finite
        const double t = i * h, e = std::exp(pi * std::sinh(t)), theta = half_pi * (e / (1 + e)),
                     rest = half_pi / (1 + e);
        const double s = std::sin(theta), d_theta = half_pi * pi * std::cosh(t) * (e / (1 + e)) / (1 + e) * h;
        total += 2 * pi * s * g(vec3<double>{s, 0, std::sin(rest)}) * d_theta;
    }
    return total;
}

template <class D>
double facet_area(const D& density) {
    return over_normals(density);
}
template <class D>
double projected_facets(const D& density) {
    return over_normals([&](const vec3<double>& m) { return density(m) * m.z; });
}

/// int D cos = 1: the threshold of the issue, 1e-9.
template <class D>
bool is_normalised(const D& density) {
    return agree(projected_facets(density), 1, 1e-9);
}

/// D(n) = 1/(pi alpha^2), to rounding.
template <class D>
bool has_its_peak(const D& density, double a) {
    return agree(density(n) * pi * a * a, 1, 1e-13);
}

template <class D>
bool falls_towards_grazing(const D& density) {
    for (int degree = 1; degree < 90; ++degree)
        if (density(at(std::cos(degree * pi / 180))) >= density(at(std::cos((degree - 1) * pi / 180)))) return false;
    return true;
}

/// D cos^4 alpha^2 depends on tan(theta)/alpha alone: the largest relative difference between two widths.
template <class Make>
double shape_deviation(const Make& density_of_width) {
    const auto wide = density_of_width(0.5), narrow = density_of_width(0.1);
    double worst = 0;
    for (double ratio = 0.05; ratio < 10; ratio *= 1.1) {
        const auto shape = [&](const auto& density, double a) {
            const double mu = 1 / std::sqrt(1 + ratio * ratio * a * a);
            return density({std::sqrt((1 - mu) * (1 + mu)), 0, mu}) * mu * mu * mu * mu * a * a;
        };
        worst = larger(worst, std::abs(shape(narrow, 0.1) / shape(wide, 0.5) - 1));
    }
    return worst;
}

// ---- Fresnel
// -------------------------------------------------------------------------------------------------------------------

/// The largest distance from Fresnel's equations at index 1.5. That of Schlick's approximation is 0.036.
template <class F>
bool is_near_fresnel(const F& reflectance) {
    const lobe::dielectric exact{1.5};
    double worst = 0;
    for (double u = 0; u <= 1; u += 1.0 / 256) worst = larger(worst, std::abs(reflectance(u) - exact(u)));
    return worst < 0.04;
}

/// 2 int F u du: exact for polynomials to degree 30.
template <class F>
double average(const F& reflectance) {
    const lobe::gauss_legendre<double> rule(16);
    double total = 0;
    for (std::size_t i = 0; i < rule.x.size(); ++i) total += 2 * rule.w[i] * rule.x[i] * reflectance(rule.x[i]);
    return total;
}

// ---- masking
// -------------------------------------------------------------------------------------------------------------------

/// The largest distance of G2(mu_v, mu_l, alpha) from 1/(1 + Lambda_v + Lambda_l) on the 60-digit table.
template <class G>
double masking_error(const G& G2) {
    const auto rows = reference_table("smith_lambda.csv");
    double worst = 0;
    for (const auto& v : rows)
        for (const auto& l : rows)
            if (v[1] == l[1]) worst = larger(worst, std::abs(G2(v[0], l[0], v[1]) - 1 / (1 + v[2] + l[2])));
    return worst;
}

template <class G>
bool is_one_at_normal(const G& G2) {
    return agree(G2(1, 1, 0.01), 1, 1e-15) && agree(G2(1, 1, 0.5), 1, 1e-15);
}

/// The largest distance of G1(mu, alpha) from Smith's on the same table.
template <class G>
double masking_error_of_one(const G& G1) {
    double worst = 0;
    for (const auto& row : reference_table("smith_lambda.csv"))
        // roughness >= 0.05
        if (row[0] >= 0.001 && row[1] >= 0.0025) worst = larger(worst, std::abs(G1(row[0], row[1]) - row[3]));
    return worst;
}

// ---- energy
// -------------------------------------------------------------------------------------------------------------------

dfg_terms<double> terms_at(double mu, double a) {
    return lobe::dfg_exact(smith_correlated{}, mu, alpha{a}, {.order = 64});
}

/// Split-sum terms against the table: 2e-8 is what `dfg_exact` states for order 32, and `terms_at` takes 64.
bool match_table(const dfg_terms<double>& t, double mu, double a) {
    for (const auto& row : reference_table("splitsum_ggx_AB.csv"))
        if (row[0] == mu && row[1] == a) return agree(t.scale, row[2], 2e-8) && agree(t.bias, row[3], 2e-8);
    throw std::runtime_error("no such row");
}

/// Total albedo(mu, alpha, F0) against the random walk: the largest distance over its 16 rows at F0 = 0.04, 0.2, 0.5 or
/// 0.9.
template <class Albedo>
double walk_error(const Albedo& albedo, double F0) {
    const std::size_t column = F0 == 0.04 ? 12 : F0 == 0.2 ? 16 : F0 == 0.5 ? 20 : 24;
    double worst = 0;
    for (const auto& row : reference_table("multiscatter_random_walk.csv"))
        worst = larger(worst, std::abs(albedo(row[0], row[1], F0) - row[column]));
    return worst;
}

/// The largest |f(v,l)/f(l,v) - 1|.
template <class F>
double irreciprocity(const F& f) {
    random_numbers random(1);
    double worst = 0;
    for (int i = 0; i < 10000; ++i) {
        const vec3<double> v = random.grazing_direction(0.05), l = random.grazing_direction(0.05);
        worst = larger(worst, std::abs(f(v, l) / f(l, v) - 1));
    }
    return worst;
}

/// A furnace of radiance L shows L for what reflects all: shown(radiance) / radiance, whatever the radiance.
template <class Shown>
bool passes_furnace(const Shown& shown, double tolerance = 1e-12) {
    return agree(shown(1.0), 1, tolerance) && agree(shown(0.2), 0.2, tolerance) && agree(shown(5.0), 5, 5 * tolerance);
}

}  // namespace

TEST_CASE("errata 000, image-based light: the printed formulas fail the checks", "[errata]") {
    const auto lobe_ggx = [](double a) { return [a](const vec3<double>& m) { return ggx{alpha{a}}.D(m); }; };
    const auto lobe_schlick = [](double u) { return schlick{0.04}(u); };

    SECTION("S0-1: GGX without the square") {
        const auto printed = [](double a) {
            return [a](const vec3<double>& h) { return a * a / (pi * (h.z * h.z * (a * a - 1) + 1)); };
        };
        for (double a : {0.1, 0.5}) {
            CHECK(is_normalised(lobe_ggx(a)));
            CHECK_FALSE(is_normalised(printed(a)));
            CHECK(has_its_peak(lobe_ggx(a), a));
            CHECK_FALSE(has_its_peak(printed(a), a));
        }
        CHECK(rounded(projected_facets(printed(0.1)), 4) == 0.0465);
        CHECK(rounded(projected_facets(printed(0.5)), 3) == 0.462);
        CHECK(rounded(printed(0.1)(n), 3) == 0.318);
        CHECK(rounded(lobe_ggx(0.1)(n), 2) == 31.83);
    }
    SECTION("S0-2: the exponent of Blinn-Phong") {
        const auto lobe_blinn = [](const vec3<double>& m) { return lobe::blinn_phong{alpha{0.3}}.D(m); };
        const auto printed = [](const vec3<double>& h) {
            const double exponent = 2 * 0.3 * 0.3 - 2;
            return (exponent + 2) / (2 * pi) * std::exp(exponent * std::log(h.z));
        };
        CHECK(is_normalised(lobe_blinn));
        CHECK(is_normalised(printed));  // which is why the other two checks exist
        CHECK(has_its_peak(lobe_blinn, 0.3));
        CHECK_FALSE(has_its_peak(printed, 0.3));
        CHECK(falls_towards_grazing(lobe_blinn));
        CHECK_FALSE(falls_towards_grazing(printed));
        const vec3<double> steep = at(std::cos(80 * pi / 180));
        CHECK(rounded(lobe::blinn_phong_exponent_from_alpha(alpha{0.3}), 2) == 20.22);
        CHECK(rounded(printed(n), 4) == 0.0286);
        CHECK(rounded(lobe_blinn(n), 3) == 3.537);
        CHECK(rounded(printed(steep) / printed(n), 1) == 24.2);
        CHECK(rounded(lobe_blinn(steep) / lobe_blinn(n) * 1e16, 1) == 4.2);
    }
    SECTION("S0-3: the power of Schlick") {
        const auto printed = [](double u) { return 0.04 + (1 - 0.04) * (1 - fifth_power(u)); };
        CHECK(printed(0) == lobe_schlick(0));
        CHECK(printed(1) == lobe_schlick(1));  // ends are not enough
        CHECK(is_near_fresnel(lobe_schlick));
        CHECK_FALSE(is_near_fresnel(printed));
        const double exact = lobe::dielectric{1.5}.average();
        CHECK(agree(average(lobe_schlick), exact, 0.01));
        CHECK_FALSE(agree(average(printed), exact, 0.01));
        CHECK(rounded(printed(0.5), 3) == 0.970);
        CHECK(rounded(lobe_schlick(0.5), 3) == 0.070);
        CHECK(rounded(printed(0.9), 3) == 0.433);
        CHECK(rounded(lobe_schlick(0.9), 4) == 0.0400);
        CHECK(rounded(average(printed), 4) == 0.7257);
        CHECK(rounded(average(lobe_schlick), 4) == 0.0857);
    }
    SECTION("S0-4: the height-correlated G") {
        const auto correlated = [](double v, double l, double a) {
            return smith_correlated{}.G2(ggx{alpha{a}}, at(v), at(l));
        };
        const auto separable = [](double v, double l, double a) {
            return smith_separable{}.G2(ggx{alpha{a}}, at(v), at(l));
        };
        const auto printed = [](double v, double l, double a) {
            const auto side = [&](double mu) { return 2 * mu / std::sqrt(mu + std::sqrt(a * a + (1 - a * a) * mu)); };
            return side(v) * side(l);
        };
        CHECK(is_one_at_normal(correlated));
        CHECK_FALSE(is_one_at_normal(printed));
        CHECK(masking_error(correlated) < 1e-12);
        CHECK(masking_error(printed) > 0.9);
        CHECK(masking_error(separable) > 0.08);  // correlated is another model, not another spelling
        CHECK(rounded(printed(1, 1, 0.01), 12) == 2);
        CHECK(rounded(printed(0.5, 0.5, 0.5), 4) == 0.7749);
        CHECK(rounded(correlated(0.5, 0.5, 0.5), 4) == 0.7559);
        CHECK(rounded(separable(0.5, 0.5, 0.5), 4) == 0.7413);
        CHECK(rounded(printed(0.1, 0.1, 0.5), 4) == 0.0597);
        CHECK(rounded(correlated(0.1, 0.1, 0.5), 4) == 0.1971);
    }
    SECTION("S0-5 and S0-6: a white surface by uniform samples, and their density") {
        const std::uint32_t count = 1024;
        const lobe::lambert white{1.0};
        const auto lobe_form = [&](double radiance) {
            double total = 0;
            for (std::uint32_t i = 0; i < count; ++i) {
                const vec3<double> l = lobe::square_to_uniform_hemisphere(lobe::hammersley<double>(i, count));
                total += white.f_cos(n, l) * radiance / lobe::uniform_hemisphere_pdf<double>();
            }
            return total / count;
        };
        const auto printed = [&](double radiance) {
            double total = 0;
            for (std::uint32_t i = 0; i < count; ++i) total += radiance;
            return total / (count * pi);
        };
        CHECK(passes_furnace(lobe_form, 1e-9));  // the point set knows its coordinates to 2^-31
        CHECK_FALSE(passes_furnace(printed, 1e-9));
        CHECK(rounded(printed(1), 4) == 0.3183);
        const double hemisphere = 2 * pi, sphere = 4 * pi;
        CHECK(agree(lobe::uniform_hemisphere_pdf<double>() * hemisphere, 1, 1e-15));
        CHECK_FALSE(agree(1 / (2 * pi) * sphere, 1, 1e-15));
    }
    SECTION("S0-7: the diffuse weight 1 - F(v.h) gains energy") {
        const auto printed = [](double mu, double a) {
            const schlick F{0.04};
            const auto t = terms_at(mu, a);
            const auto diffuse = [&](const vec3<double>& l) {
                return (1 - F(lobe::dot(at(mu), lobe::half_vector(at(mu), l)))) * l.z / pi;
            };
            return 0.04 * t.scale + t.bias +
                   lobe::hemisphere_integral(diffuse, at(mu), vec2<double>{1, 1}, true, {.order = 64}).value;
        };
        const auto lobe_form = [](double mu, double a) {
            const auto w = lobe::fdez_aguera{}(terms_at(mu, a), 0.04, 1.0);
            return w.radiance + w.irradiance;
        };
        CHECK(rounded(printed(0.01, 0.05), 3) == 1.495);
        CHECK(rounded(printed(0.1, 0.1), 3) == 1.264);
        CHECK(rounded(printed(0.5, 0.3), 3) == 1.006);
        CHECK(lobe_form(0.01, 0.05) <= 1 + 1e-15);
        CHECK(lobe_form(0.1, 0.1) <= 1 + 1e-15);
        CHECK(lobe_form(0.5, 0.3) <= 1 + 1e-15);
    }
    SECTION("S0-8: the split-sum terms") {
        struct printed_fresnel {
            vec2<double> operator()(double u) const { return {1 - (1 - fifth_power(u)), 1 - fifth_power(u)}; }
            double average() const { return 1; }
        };
        const auto printed = [](double mu, double a) {
            const microfacet wrong{ggx{alpha{a}}, smith_correlated{}, printed_fresnel{}};
            const auto f_cos = [&](const vec3<double>& l) { return wrong.f_cos(at(mu), l); };
            const vec2<double> t = lobe::hemisphere_integral(f_cos, at(mu), wrong.width(), true, {.order = 64}).value;
            return dfg_terms<double>{t.x, t.y};
        };
        for (const auto& [mu, a] : {std::pair{0.5, 0.3}, std::pair{0.1, 0.5}}) {
            CHECK(match_table(terms_at(mu, a), mu, a));
            CHECK_FALSE(match_table(printed(mu, a), mu, a));
            CHECK(agree(printed(mu, a).albedo(), terms_at(mu, a).albedo(), 1e-12));  // a furnace at F = 1 sees nothing
        }
        CHECK(rounded(printed(0.5, 0.3).scale, 3) == 0.138);
        CHECK(rounded(printed(0.5, 0.3).bias, 3) == 0.684);
        CHECK(rounded(terms_at(0.5, 0.3).scale, 4) == 0.8027);
        CHECK(rounded(terms_at(0.5, 0.3).bias, 4) == 0.0190);
        CHECK(rounded(printed(0.1, 0.5).scale, 3) == 0.155);
        CHECK(rounded(printed(0.1, 0.5).bias, 3) == 0.705);
        CHECK(rounded(terms_at(0.1, 0.5).scale, 3) == 0.799);
        CHECK(rounded(terms_at(0.1, 0.5).bias, 4) == 0.0614);
    }
    SECTION("S0-9: a sampling weight under the name of the visibility function") {
        const ggx ndf{alpha{0.3}};
        const double G = smith_correlated{}.G2(ndf, n, n), printed = G * 1 / (1 * 1),
                     V = smith_correlated{}.visibility(ndf, n, n);
        const double f = microfacet{ndf, smith_correlated{}, lobe::perfect_reflector{}}.f(n, n);
        CHECK(agree(ndf.D(n) * V, f, 1e-15));  // f = F D V
        CHECK_FALSE(agree(ndf.D(n) * printed, f, 1e-15));
        CHECK(printed == 1);
        CHECK(V == 0.25);
    }
    SECTION("S0-11: 1 - metallic twice") {
        const auto material = lobe::metallic_roughness(1.0, 0.5, alpha{0.3});
        const schlick F{0.52};
        const double diffuse =
            (material.f(n, n) - microfacet{ggx{alpha{0.3}}, smith_correlated{}, F}.f(n, n)) / (1 - F(1.0)) * pi;
        CHECK(agree(diffuse, 0.5, 1e-14));
        CHECK_FALSE(agree((1 - 0.5) * (1.0 * (1 - 0.5)), 0.5, 1e-14));
    }
    SECTION("S0-12: the sRGB column of F0") {
        // IEC 61966-2-1. Two decimals are worth 0.005; gold's blue, 0.5754 printed as 0.57, needs 0.0054.
        const auto srgb = [](double x) {
            return x <= 0.0031308 ? 12.92 * x : 1.055 * std::exp(std::log(x) / 2.4) - 0.055;
        };
        const auto agrees = [&](double linear, double printed) { return agree(srgb(linear), printed, 0.006); };
        namespace F0 = lobe::materials::F0;
        CHECK(agrees(F0::water<double>().x, 0.15));
        CHECK(agrees(F0::glass_high<double>().x, 0.31));
        CHECK(agrees(F0::diamond<double>().x, 0.45));
        CHECK(agrees(F0::gold<double>().z, 0.57));
        CHECK(agrees(F0::copper<double>().y, 0.82));
        CHECK_FALSE(agrees(F0::plastic_low<double>().x, 0.21));
        CHECK_FALSE(agrees(F0::plastic_high<double>().x, 0.24));
        CHECK_FALSE(agrees(F0::aluminium<double>().z, 0.97));
        CHECK(rounded(srgb(0.03), 3) == 0.190);
        CHECK(rounded(srgb(0.05), 3) == 0.248);
        CHECK(rounded(srgb(0.92), 3) == 0.964);
        CHECK(rounded(srgb(0.036), 2) == 0.21);
    }
    SECTION("S0-13: D is no probability density, D cos is") {
        CHECK(rounded(facet_area(lobe_ggx(0.1)), 3) == 1.030);
        CHECK(rounded(facet_area(lobe_ggx(0.5)), 3) == 1.380);
        CHECK(rounded(facet_area(lobe_ggx(1)), 12) == 2);
        const auto pdf = [](const vec3<double>& m) { return ggx{alpha{0.5}}.pdf(m); };
        CHECK(agree(over_normals(pdf), 1, 1e-9));
    }
    SECTION("S0-16: the axes of the table") {
        CHECK(match_table(terms_at(0.1, 0.5), 0.1, 0.5));
        CHECK_FALSE(match_table(terms_at(0.5, 0.1), 0.1, 0.5));
    }
}

namespace {

using multi_scattering = double (*)(const dfg_terms<double>& t, double FssEss, double Favg);

double lobe_Fms(const dfg_terms<double>& t, double FssEss, double Favg) {
    return FssEss * Favg / (1 - (1 - t.albedo()) * Favg);
}
// eq. 14
double printed_Fms(const dfg_terms<double>& t, double, double Favg) { return Favg / (1 - (1 - t.albedo()) * Favg); }

double lobe_total(double mu, double a, double F0) {
    const auto w = lobe::fdez_aguera{}(terms_at(mu, a), F0);
    return w.radiance + w.irradiance;
}

/// The listing: Schlick with roughness in the place of F0.
double listing_FssEss(double mu, double a, double F0) {
    const auto t = terms_at(mu, a);
    return lobe::schlick_roughness{F0, std::sqrt(a)}(mu)*t.scale + t.bias;
}
double listing_total(double mu, double a, double F0) {
    const auto t = terms_at(mu, a);
    const double FssEss = listing_FssEss(mu, a, F0), Favg = F0 + (1 - F0) / 21;
    return FssEss + lobe_Fms(t, FssEss, Favg) * (1 - t.albedo());
}

}  // namespace

TEST_CASE("errata 001, multiple scattering: the printed formulas fail the checks", "[errata]") {
    const auto t = terms_at(0.5, 0.5);
    const double E = t.albedo();

    SECTION("S1-1: a bracket around the wrong product") {
        const auto lobe_form = [&](double radiance, double irradiance) {
            const auto w = lobe::fdez_aguera{}(t, 1.0);
            return w.radiance * radiance + w.irradiance * irradiance;
        };
        const auto printed = [&](double radiance, double irradiance) { return E * radiance + (1 - E * irradiance); };
        CHECK(passes_furnace([&](double L) { return lobe_form(L, L); }));
        CHECK_FALSE(passes_furnace([&](double L) { return printed(L, L); }));
        CHECK(agree(printed(1, 1), 1, 1e-15));  // a furnace of radiance 1 sees nothing
        CHECK(rounded(printed(2, 0.2), 3) == 2.257);
        CHECK(rounded(lobe_form(2, 0.2), 3) == 1.457);
    }
    SECTION("S1-2: Fms without FssEss") {
        const auto total = [&](multi_scattering Fms) {
            return [&t, E, Fms](double L) { return (E + Fms(t, E, 1) * (1 - E)) * L; };
        };
        CHECK(passes_furnace(total(lobe_Fms)));
        CHECK_FALSE(passes_furnace(total(printed_Fms)));
        CHECK(rounded(total(printed_Fms)(1), 3) == 1.130);
        const double FssEss = 0.5 * t.scale + t.bias, Favg = schlick{0.5}.average();
        CHECK(rounded(printed_Fms(t, FssEss, Favg), 3) == 0.622);
        CHECK(rounded(lobe_Fms(t, FssEss, Favg), 3) == 0.220);
        // lobe's own, spelled out
        CHECK(agree(lobe_Fms(t, FssEss, Favg) * (1 - E), lobe::fdez_aguera{}(t, 0.5).irradiance, 1e-15));
    }
    SECTION("S1-3: Schlick with roughness in the split sum") {
        CHECK(walk_error(lobe_total, 0.04) < 0.0205);  // as energy.cpp has it
        CHECK(walk_error(listing_total, 0.04) > 0.0205);
        CHECK(agree(listing_total(0.5, 0.5, 1), 1, 1e-12));  // a furnace at F = 1 sees nothing
        const auto grazing = terms_at(0.05, 0.1);
        CHECK(rounded(listing_FssEss(0.05, 0.1, 0.04), 3) == 0.650);
        CHECK(rounded(0.04 * grazing.scale + grazing.bias, 3) == 0.368);
        CHECK(rounded(listing_total(0.05, 0.1, 0.04), 3) == 0.655);
        CHECK(rounded(walk_error(listing_total, 0.04), 3) == 0.264);
    }
    SECTION("S1-4: a coloured single-scattering lobe does not pass the furnace") {
        const microfacet gray{ggx{alpha{0.5}}, smith_correlated{}, schlick{0.5}};
        const double albedo = lobe::directional_albedo(gray, 0.5);
        CHECK_FALSE(agree(albedo, 1, 1e-6));
        CHECK(rounded(albedo, 3) == 0.354);
    }
    SECTION("S1-5: irradiance that is not divided by pi") {
        const auto white = [](double L) { return [L](const vec3<double>&) { return L; }; };
        const auto total = [&](double scale) {
            return [&, scale](double L) {
                const auto w = lobe::fdez_aguera{}(t, 1.0);
                return w.radiance * L + w.irradiance * scale * lobe::irradiance(white(L), n, 16);
            };
        };
        CHECK(passes_furnace(total(1)));
        CHECK_FALSE(passes_furnace(total(pi)));
        CHECK(rounded(total(pi)(1), 3) == 1.646);
    }
    SECTION("S1-7: the energy is right in a uniform environment and for white only, and the lobe is not reciprocal") {
        CHECK(rounded(walk_error(lobe_total, 0.04), 3) == 0.020);
        CHECK(rounded(walk_error(lobe_total, 0.2), 3) == 0.021);
        CHECK(rounded(walk_error(lobe_total, 0.5), 3) == 0.042);
        CHECK(rounded(walk_error(lobe_total, 0.9), 3) == 0.060);
        const microfacet single{ggx{alpha{0.5}}, smith_correlated{}, schlick{0.9}};
        const auto table = lobe::bake_dfg<double>(smith_correlated{}, {.size = 16, .order = 16});
        const auto f = [&](const vec3<double>& v, const vec3<double>& l) {
            return single.f(v, l) + lobe::fdez_aguera{}(table(v.z, alpha{0.5}), 0.9).irradiance / pi;
        };
        CHECK(irreciprocity([&](const vec3<double>& v, const vec3<double>& l) { return single.f(v, l); }) < 1e-14);
        CHECK(irreciprocity(f) > 0.2);  // 0.40 for cosines from 0.05, more towards grazing
    }
}

TEST_CASE("errata 002, direct light: the printed formulas fail the checks", "[errata]") {
    const schlick F{0.04};

    SECTION("S2-1: k for punctual lights") {
        const auto lobe_k = [](double r) { return lobe::k_ue4_direct(r).value(); };
        const auto printed = [](double r) { return (r + 1) / 2 / 2; };
        // Karis remaps the roughness, (r + 1)/2, and takes k = alpha/2 of that.
        const auto is_a_remapped_roughness = [](const auto& k) {
            for (double r : {0.0, 0.25, 0.5, 0.75, 1.0})
                if (!agree(k(r), lobe::k_from_alpha(alpha<double>::from_roughness((r + 1) / 2)).value(), 1e-15))
                    return false;
            return true;
        };
        CHECK(is_a_remapped_roughness(lobe_k));
        CHECK_FALSE(is_a_remapped_roughness(printed));
        CHECK(printed(0) == 0.25);
        CHECK(lobe_k(0) == 0.125);
        CHECK(rounded(printed(0.25), 4) == 0.3125);
        CHECK(rounded(lobe_k(0.25), 4) == 0.1953);
        CHECK(printed(0.5) == 0.375);
        CHECK(lobe_k(0.5) == 0.28125);
        CHECK(printed(1) == lobe_k(1));
        const ggx ndf{alpha<double>::from_roughness(0.25)};
        const auto G1 = [&](double k) { return lobe::schlick_ggx{lobe::schlick_k{k}}.G1(ndf, at(0.1)); };
        CHECK(rounded(G1(printed(0.25)), 3) == 0.262);
        CHECK(rounded(G1(lobe_k(0.25)), 3) == 0.363);
        CHECK(rounded(smith_correlated{}.G1(ndf, at(0.1)), 3) == 0.918);
    }
    SECTION("S2-3: F0 is the reflectance along the normal, not at 90 degrees from it") {
        const lobe::dielectric glass{1.5};
        CHECK(agree(glass(1.0), 0.04, 1e-15));
        CHECK_FALSE(agree(glass(0.0), 0.04, 1e-15));
        CHECK(F(1.0) == 0.04);
        CHECK(F(0.0) == 1);
    }
    SECTION("S2-4 and S3-4: Fresnel of n.v") {
        const microfacet white{ggx{alpha{0.3}}, smith_correlated{}, lobe::perfect_reflector{}};
        const microfacet right{ggx{alpha{0.3}}, smith_correlated{}, F};
        const auto lobe_form = [&](const vec3<double>& v, const vec3<double>& l) { return right.f(v, l); };
        const auto printed = [&](const vec3<double>& v, const vec3<double>& l) { return F(v.z) * white.f(v, l); };
        CHECK(irreciprocity(lobe_form) < 1e-14);
        CHECK(irreciprocity(printed) > 1);
        const vec3<double> v = at(std::cos(72.5 * pi / 180));
        CHECK(rounded(printed(v, v) / white.f(v, v), 3) == 0.201);
        CHECK(rounded(lobe_form(v, v) / white.f(v, v), 3) == 0.040);
    }
    SECTION("S2-5: k_d and k_s twice") {
        struct twice {
            double operator()(double u) const { return schlick{0.04}(u)*schlick{0.04}(u); }
            double average() const { return 0; }
        };
        // A smooth surface seen along its normal reflects F0, and passes 1 - F0 to a white base.
        const auto reflected = [](const auto& reflectance) {
            return lobe::directional_albedo(microfacet{ggx{alpha{0.001}}, smith_correlated{}, reflectance}, 1.0).value;
        };
        CHECK(agree(reflected(F), 0.04, 1e-6));
        CHECK_FALSE(agree(reflected(twice{}), 0.04, 1e-6));
        const auto base = lobe::fdez_aguera{}(terms_at(1, 0.001), 0.04, 1.0).irradiance;
        CHECK(agree(base, 0.96, 1e-6));
        CHECK_FALSE(agree((1 - 0.04) * (1 - 0.04), 0.96, 1e-6));
        CHECK(rounded(reflected(twice{}), 4) == 0.0016);
        CHECK(rounded((1 - 0.04) * (1 - 0.04), 4) == 0.9216);
    }
    SECTION("S2-8: separable and correlated") {
        double worst = 0;
        for (double a : {0.1, 0.2, 0.5})
            for (double v = 0.005; v < 1; v += 0.005) {
                const ggx ndf{alpha{a}};
                worst =
                    larger(worst, smith_correlated{}.G2(ndf, at(v), at(v)) - smith_separable{}.G2(ndf, at(v), at(v)));
            }
        CHECK(rounded(worst, 3) == 0.090);
    }
    SECTION("S2-9: a white surface shows irradiance/pi") {
        CHECK(rounded(lobe::lambert{1.0}.f_cos(n, n) * pi, 15) == 1);
    }
    // S2-10 is S0-7.
}

namespace {

/// The listing of the tutorial, in double: G by Schlick with k = r^2/2, Hammersley from (0,0), all normals. `epsilon`
/// is added where the listing adds 0.001; `guard`: is `if (NDotL > 0.0)` followed by its block, or by a semicolon?
vec2<double> listing_integrate_brdf(double NDotV, double roughness, double epsilon, bool guard) {
    const vec3<double> V{std::sqrt(1 - NDotV * NDotV), 0, NDotV};
    const double a = roughness * roughness, k = roughness * roughness / 2;
    const auto G1 = [&](double mu) { return mu / (mu * (1 - k) + k); };
    vec2<double> AB(0, 0);
    const std::uint32_t count = 1024;
    for (std::uint32_t i = 0; i < count; ++i) {
        const double x = static_cast<double>(i) / count, y = lobe::radical_inverse<double>(i);
        const double cos_theta = std::sqrt((1 - y) / (1 + (a * a - 1) * y)),
                     sin_theta = std::sqrt(1 - cos_theta * cos_theta);
        const vec3<double> H{std::cos(2 * pi * x) * sin_theta, std::sin(2 * pi * x) * sin_theta, cos_theta};
        const vec3<double> L = lobe::normalize(2 * lobe::dot(V, H) * H - V);
        const double NDotL = std::max(L.z, 0.0), NDotH = std::max(H.z, 0.0), VDotH = std::max(lobe::dot(V, H), 0.0);
        if (guard && !(NDotL > 0)) continue;
        const double G_Vis = G1(NDotL) * G1(NDotV) * VDotH / (NDotH * NDotV + epsilon),
                     Fc = fifth_power(1 - VDotH + epsilon);
        AB += vec2<double>{(1 - Fc) * G_Vis, Fc * G_Vis} / static_cast<double>(count);
    }
    return AB;
}

/// Irradiance/pi of an environment of (theta, phi) as the documents' loops have it.
template <class L>
double listing_irradiance(const L& radiance) {
    double total = 0;
    int count = 0;
    for (float phi = 0; phi < 2.0f * static_cast<float>(pi); phi += 0.025f)  // float, as in the listing: 252 steps
        for (float theta = 0; theta < 0.5f * static_cast<float>(pi); theta += 0.025f, ++count)
            total += radiance(static_cast<double>(theta), static_cast<double>(phi)) *
                     std::cos(static_cast<double>(theta)) * std::sin(static_cast<double>(theta));
    return pi * total / count;
}

}  // namespace

TEST_CASE("errata 003, image-based light tutorial: the printed formulas fail the checks", "[errata]") {
    SECTION("S3-1: a semicolon after the if") {
        const auto with = listing_integrate_brdf(0.3, 0.5, 0.001, true),
                   without = listing_integrate_brdf(0.3, 0.5, 0.001, false);
        CHECK(with == without);
        CHECK(rounded(with.x, 8) == 0.62562692);
        CHECK(rounded(with.y, 8) == 0.05076580);
        CHECK(std::isnan(listing_integrate_brdf(0, 0, 0.001, false).x));
        CHECK_FALSE(std::isnan(listing_integrate_brdf(0, 0, 0.001, true).x));
    }
    SECTION("S3-2: + 0.001") {
        const auto change = [](double mu, double r) {
            const auto printed = listing_integrate_brdf(mu, r, 0.001, true),
                       right = listing_integrate_brdf(mu, r, 0, true);
            return 100.0 * (printed / right - vec2<double>(1, 1));
        };
        const auto printed = listing_integrate_brdf(0.01, 0.1, 0.001, true),
                   right = listing_integrate_brdf(0.01, 0.1, 0, true);
        CHECK(rounded(printed.x, 4) == 0.0795);
        CHECK(rounded(printed.y, 4) == 0.4876);
        CHECK(rounded(right.x, 4) == 0.0903);
        CHECK(rounded(right.y, 4) == 0.5336);
        CHECK(rounded(change(0.01, 0.1).x, 1) == -11.9);
        CHECK(rounded(change(0.01, 0.1).y, 1) == -8.6);
        CHECK(rounded(change(0.01, 0.5).x, 1) == -14.4);
        CHECK(rounded(change(0.01, 0.5).y, 1) == -9.2);
        CHECK(rounded(change(0.1, 0.3).x, 1) == -1.5);
        CHECK(rounded(change(0.1, 0.3).y, 1) == -0.4);
        CHECK(rounded(fifth_power(1 - 0 + 0.001), 3) == 1.005);
    }
    SECTION("S3-6: k = alpha^2/2 with alpha = r^2") {
        const auto G1_of = [](const auto& k_of_roughness) {
            return [=](double mu, double a) {
                return lobe::schlick_ggx{lobe::schlick_k{k_of_roughness(std::sqrt(a))}}.G1(ggx{alpha{a}}, at(mu));
            };
        };
        const auto lobe_form = G1_of([](double r) { return lobe::k_ibl(r).value(); });
        const auto printed = G1_of([](double r) { return r * r * r * r / 2; });
        CHECK(masking_error_of_one(lobe_form) < 0.163);  // as schlick_ggx.hpp states
        CHECK(masking_error_of_one(printed) > 0.7);
        CHECK(rounded(lobe_form(0.1, 0.25), 4) == 0.4706);
        CHECK(rounded(printed(0.1, 0.25), 4) == 0.7805);
        CHECK(rounded(smith_correlated{}.G1(ggx{alpha{0.25}}, at(0.1)), 4) == 0.5433);
    }
    SECTION("S3-10: sums from 0 to n inclusive") {
        const auto white = [](int n1, int n2, bool inclusive) {
            double total = 0;
            for (int i = 0; i < n1 + inclusive; ++i)
                for (int j = 0; j < n2 + inclusive; ++j) {
                    const double theta = half_pi * j / n2;
                    total += std::cos(theta) * std::sin(theta);
                }
            return pi * total / (n1 * n2);
        };
        CHECK(agree(white(64, 256, false), 1, 1e-4));  // the left Riemann sum: 1 - (pi/256)^2/48
        CHECK_FALSE(agree(white(64, 256, true), 1, 1e-4));
        CHECK(agree(white(64, 256, true) / white(64, 256, false), 65.0 / 64, 1e-12));
    }
    SECTION("S3-11: steps of 0.025 that do not divide the circle") {
        const auto white = [](double, double) { return 1.0; };
        const auto tilted = [](double theta, double phi) { return 1 + std::sin(theta) * std::cos(phi); };
        const auto lobe_tilted = [](const vec3<double>& w) { return 1 + w.x; };
        CHECK(agree(lobe::irradiance([](const vec3<double>&) { return 1.0; }, n, 1024), 1, 1e-14));
        CHECK(agree(lobe::irradiance(lobe_tilted, n, 1024), 1, 1e-4));
        CHECK_FALSE(agree(listing_irradiance(white), 1, 1e-4));
        CHECK_FALSE(agree(listing_irradiance(tilted), 1, 1e-4));
        CHECK(rounded(listing_irradiance(white), 5) == 0.99721);
        CHECK(rounded(listing_irradiance(tilted), 5) == 0.99899);
    }
    SECTION("S3-13: Schlick with roughness in the split sum") {
        const auto lobe_form = [](double mu, double a) { return 0.04 * terms_at(mu, a).scale + terms_at(mu, a).bias; };
        CHECK(rounded(listing_FssEss(0.05, 0.1, 0.04), 3) == 0.650);
        CHECK(rounded(lobe_form(0.05, 0.1), 3) == 0.368);
        CHECK(rounded(listing_FssEss(0.3, 0.25, 0.04), 3) == 0.156);
        CHECK(rounded(lobe_form(0.3, 0.25), 4) == 0.0963);
        const microfacet brdf{ggx{alpha{0.25}}, smith_correlated{}, schlick{0.04}};
        const double albedo = lobe::directional_albedo(brdf, 0.3);
        CHECK(agree(lobe_form(0.3, 0.25), albedo, 1e-6));
        CHECK_FALSE(agree(listing_FssEss(0.3, 0.25, 0.04), albedo, 1e-6));
    }
    SECTION("S3-14 and S3-20: cancellation in the inverse CDF, in float") {
        const auto printed = [](float a, float u) {
            const float cos_theta = std::sqrt((1 - u) / (1 + (a * a - 1) * u));
            return vec2<float>{std::sqrt(1 - cos_theta * cos_theta), cos_theta};
        };
        const auto lobe_form = [](float a, float u) {
            const vec3<float> m = ggx{alpha{a}}.sample(vec2<float>{u, 0});
            return vec2<float>{m.x, m.z};
        };
        // tan(theta) = alpha sqrt(u/(1-u)), in double: a float of the right size is within 1e-6 of it
        const auto is_right = [](const auto& sample, float a, float u) {
            const double tangent =
                static_cast<double>(a) * std::sqrt(static_cast<double>(u) / (1 - static_cast<double>(u)));
            const vec2<float> m = sample(a, u);
            return std::abs(static_cast<double>(m.x) * std::sqrt(1 + tangent * tangent) / tangent - 1) < 1e-6 &&
                   std::abs(static_cast<double>(m.y) * std::sqrt(1 + tangent * tangent) - 1) < 1e-6;
        };
        const float almost_one = 1 - 0x1p-24f;
        CHECK(is_right(lobe_form, 0.01f, 1e-5f));
        CHECK_FALSE(is_right(printed, 0.01f, 1e-5f));
        CHECK(is_right(lobe_form, 0.001f, almost_one));
        CHECK_FALSE(is_right(printed, 0.001f, almost_one));
        CHECK(printed(0.01f, 1e-5f).x == 0);
        CHECK(rounded(static_cast<double>(lobe_form(0.01f, 1e-5f).x), 8) == 3.162e-5);
        CHECK(rounded(static_cast<double>(printed(0.001f, almost_one).y), 5) == 0.23570);
        CHECK(rounded(static_cast<double>(lobe_form(0.001f, almost_one).y), 5) == 0.23717);  // 0.2371746
    }
    SECTION("S3-15: 32 bits in a float") {
        const auto printed = [](std::uint32_t bits) { return static_cast<float>(bits) * 2.3283064365386963e-10f; };
        const std::uint32_t last = ~0u;
        CHECK(lobe::detail::fraction<float>(last) < 1);
        CHECK_FALSE(printed(last) < 1);
        CHECK(printed(last - 127) == 1);
        CHECK(printed(last - 128) < 1);  // so the last 128 codes
    }
    SECTION("S3-16: the prefiltered radiance is weighted with the cosine") {
        const auto cosine = [](const vec3<double>& w) { return std::max(w.z, 0.0); };
        const double weighted = lobe::prefiltered_radiance(cosine, n, alpha{0.5}, 1u << 14);
        double plain = 0;
        for (std::uint32_t i = 0; i < 1u << 14; ++i)
            plain +=
                cosine(lobe::reflect(n, ggx{alpha{0.5}}.sample(lobe::hammersley<double>(i, 1u << 14)))) / (1u << 14);
        CHECK(agree(weighted, 0.76356088, 1e-4));  // the reference value, by quadrature
        CHECK_FALSE(agree(plain, 0.76356088, 1e-4));
        CHECK(rounded(weighted, 4) == 0.7636);
    }
    SECTION("S3-21: Hammersley from (0,0)") {
        double bias[2] = {}, square[2] = {};
        int rows = 0;
        for (const auto& row : reference_table("multiscatter_random_walk.csv")) {
            const microfacet brdf{ggx{alpha{row[1]}}, smith_correlated{}, lobe::detail::schlick_terms{}};
            const auto exact = terms_at(row[0], row[1]);
            for (int half = 0; half < 2; ++half) {
                vec2<double> mean(0, 0);
                for (std::uint32_t i = 0; i < 1024; ++i) {
                    const vec2<double> first_at_zero{i / 1024.0, lobe::radical_inverse<double>(i)};
                    const vec2<double> u = half ? lobe::hammersley<double>(i, 1024) : first_at_zero;
                    mean += brdf.sample(at(row[0]), u).weight / 1024.0;
                }
                bias[half] += mean.x + mean.y - exact.albedo();
                square[half] +=
                    ((mean.x - exact.scale) * (mean.x - exact.scale) + (mean.y - exact.bias) * (mean.y - exact.bias)) /
                    2;
            }
            ++rows;
        }
        INFO(bias[0] / rows << ' ' << bias[1] / rows << ' ' << std::sqrt(square[0] / rows) << ' '
                            << std::sqrt(square[1] / rows));
        // half a step of the radial coordinate, 1/2048 = 4.9e-4, times the variation of the weight, which is of order 1
        CHECK(std::abs(bias[1] / rows) < 1e-4);
        CHECK_FALSE(std::abs(bias[0] / rows) < 1e-4);
        CHECK(square[1] < square[0]);
    }
}

namespace {

/// x rounded to the 11 bits of a half. Normal numbers only.
double half(double x) {
    int exponent = 0;
    const double mantissa = std::frexp(x, &exponent);
    return std::ldexp(std::nearbyint(std::ldexp(mantissa, 11)), exponent - 11);
}

/// int D cos over the hemisphere on a midpoint grid of theta and phi, where D is a number; and the part of the
/// hemisphere where it is not.
template <class D>
vec2<double> on_a_grid(const D& density, int size) {
    double total = 0, undefined = 0;
    std::vector<vec2<double>> azimuth;
    for (int j = 0; j < size; ++j)
        azimuth.push_back({std::cos(2 * pi * (j + 0.5) / size), std::sin(2 * pi * (j + 0.5) / size)});
    for (int i = 0; i < size; ++i) {
        const double theta = half_pi * (i + 0.5) / size, s = std::sin(theta), c = std::cos(theta);
        const double dm = s * (half_pi / size) * (2 * pi / size);
        for (const auto& toward : azimuth) {
            const double D_m = density(vec3<double>{s * toward.x, s * toward.y, c});
            if (std::isnan(D_m))
                undefined += dm / (2 * pi);
            else
                total += D_m * c * dm;
        }
    }
    return {total, undefined};
}

}  // namespace

TEST_CASE("errata 004, distributions of normals: the printed formulas fail the checks", "[errata]") {
    SECTION("S4-1: a minus between the slopes") {
        const double ax = 0.3, ay = 0.6;
        const auto printed = [&](const vec3<double>& m) {
            // g of GGX is 1/(pi (1 + x^2)^2)
            const double root = std::sqrt(m.x * m.x / (ax * ax) - m.y * m.y / (ay * ay)) / m.z;
            return 1 / (pi * ax * ay * m.z * m.z * m.z * m.z * (1 + root * root) * (1 + root * root));
        };
        const ggx ndf{alpha_xy{ax, ay}};
        const auto lobe_form = [&](const vec3<double>& m) { return ndf.D(m); };
        // midpoints: 5.3e-7, and a ninth of that at three times the size
        CHECK(agree(on_a_grid(lobe_form, 1500).x, 1, 1e-6));
        CHECK(on_a_grid(lobe_form, 1500).y == 0);
        const auto coarse = on_a_grid(printed, 500), fine = on_a_grid(printed, 1500);
        INFO(coarse.x << ' ' << fine.x << ' ' << fine.y);
        CHECK(rounded(fine.x, 2) == 1.97);
        CHECK(fine.x > coarse.x + 0.05);  // and no end to it
        // 29.5 %, to an azimuth at each of four borders
        CHECK(agree(fine.y, 1 - 2 / pi * std::atan(ay / ax), 4.0 / 1500));
    }
    SECTION("S4-2: the plain text lost the root of Disney's aspect") {
        const auto lobe_form = alpha_xy<double>::from_disney(1, 1);
        const double printed = 1 - 0.9 * 1;
        CHECK(agree(lobe_form.x() / lobe_form.y(), 10, 1e-13));  // 10:1, as the text itself says
        CHECK_FALSE(agree((1 / printed) / printed, 10, 1e-13));
        CHECK(rounded(printed, 12) == 0.1);
        CHECK(rounded(lobe_form.y(), 3) == 0.316);
    }
    SECTION("S4-3: gloss to exponent") {
        const auto lobe_form = [](double s) { return lobe::blinn_phong_exponent_from_gloss(s, 1000.0); };
        const auto printed = [](double s) { return 1000 * s; };
        // equal steps of gloss multiply the exponent equally, from 1 on
        const auto multiplies = [](const auto& exponent) {
            return agree(exponent(0), 1, 1e-12) &&
                   agree(exponent(0.5) / exponent(0), exponent(1) / exponent(0.5), 1e-12);
        };
        CHECK(multiplies(lobe_form));
        CHECK_FALSE(multiplies(printed));
        CHECK(printed(0.5) == 500);
        CHECK(rounded(lobe_form(0.5), 1) == 31.6);
    }
    SECTION("S4-4: the rms slope of Beckmann") {
        const lobe::beckmann ndf{alpha{0.3}};
        const double rms =
            std::sqrt(over_normals([&](const vec3<double>& m) { return m.x * m.x / m.z / 2 * ndf.D(m); }));
        const auto is_rms = [&](double sigma) { return agree(sigma, rms, 1e-9); };
        CHECK(is_rms(0.3 / std::sqrt(2.0)));
        CHECK_FALSE(is_rms(0.3 / 2));
        CHECK(rounded(rms, 4) == 0.2121);
    }
    SECTION("S4-5: widths of zero") {
        CHECK(aborts([] { (void)alpha_xy<double>::from_imageworks(0.5, 1); }));
        CHECK(aborts([] { (void)alpha_xy<double>::from_imageworks(0.5, -1); }));
        CHECK(alpha_xy<double>::from_imageworks(0.5, 1, 1e-4).y() == 1e-4);
        CHECK(alpha_xy<double>::from_disney(0.5, 1).y() > 0);
    }
    SECTION("S4-6 and S4-7: the mobile GGX has no pi, and a clamp") {
        const auto printed = [](double a, double largest) {
            return [=](const vec3<double>& m) {
                const double p = a / (m.x * m.x + m.z * a * m.z * a);
                return std::min(p * p, largest);
            };
        };
        const double unclamped = std::numeric_limits<double>::infinity();
        const auto lobe_form = [](double a) { return [a](const vec3<double>& m) { return ggx{alpha{a}}.D(m); }; };
        CHECK(is_normalised(lobe_form(0.25)));
        CHECK_FALSE(is_normalised(printed(0.25, unclamped)));
        CHECK(agree(projected_facets(printed(0.25, unclamped)), pi, 1e-9));
        CHECK(printed(0.25, unclamped)(n) == 16);
        CHECK(rounded(lobe_form(0.25)(n), 3) == 5.093);
        // the clamp bites once 1/alpha^2 = 1/r^4 (without pi) or 1/(pi r^4) passes 65504
        CHECK(has_its_peak(lobe_form(0.001), 0.001));
        CHECK_FALSE(has_its_peak([&](const vec3<double>& m) { return printed(0.001, 65504)(m) / pi; }, 0.001));
        CHECK(rounded(std::sqrt(std::sqrt(1 / 65504.0)), 4) == 0.0625);
        CHECK(rounded(std::sqrt(std::sqrt(1 / (pi * 65504))), 4) == 0.0470);
        CHECK(rounded(lobe_form(0.001)(n) / 1e5, 1) == 3.2);
    }
    SECTION("S4-8: cancellation where n.m is near 1, in half precision") {
        const double a = half(0.05), c = half(std::cos(0.05)), s = half(std::sin(0.05));
        const auto p2 = [&](double sine2) {
            const double na = half(c * a), p = half(a / half(sine2 + half(na * na)));
            return half(p * p);
        };
        const double exact = pi * ggx{alpha{0.05}}.D({std::sin(0.05), 0, std::cos(0.05)});
        const double from_cosine = p2(half(1 - half(c * c))), from_cross = p2(half(s * s));
        INFO(from_cosine << ' ' << from_cross);
        CHECK(rounded(exact, 2) == 100.33);
        CHECK(std::abs(from_cross / exact - 1) < 8 * 0x1p-11);  // eight roundings
        CHECK_FALSE(std::abs(from_cosine / exact - 1) < 8 * 0x1p-11);
        CHECK(std::abs(from_cosine / 84.99 - 1) < 8 * 0x1p-11);
    }
    SECTION("S4-9: the textbook form of GGX in float") {
        const auto printed = [](float a, float s, float c) {
            (void)s;
            const float a2 = a * a, d = (c * a2 - c) * c + 1;
            return a2 / (static_cast<float>(pi) * d * d);
        };
        const auto lobe_form = [](float a, float s, float c) { return ggx{alpha{a}}.D({s, 0, c}); };
        // the 50-digit table, where float holds the peak: alpha >= 1e-3
        const auto worst = [](const auto& D) {
            double largest = 0;
            for (const auto& row : reference_table("ndf_extreme_iso.csv")) {
                if (row[0] < 1e-3) continue;
                const float a = static_cast<float>(row[0]), s = static_cast<float>(row[1]);
                const double sine = static_cast<double>(s), q = static_cast<double>(a) * static_cast<double>(a);
                // of the rounded inputs
                const double k = static_cast<double>(a) / (q * (1 - sine * sine) + sine * sine);
                const float value = D(a, s, static_cast<float>(std::sqrt((1 - sine) * (1 + sine))));
                largest = larger(largest, std::abs(static_cast<double>(value) * pi / (k * k) - 1));
            }
            return largest;
        };
        INFO(worst(printed));
        CHECK(worst(lobe_form) < 16 * 0x1p-24);
        CHECK_FALSE(worst(printed) < 16 * 0x1p-24);
        double local = 0;
        for (double theta = 1e-5; theta < 0.1; theta *= 1.001) {
            const float sine = static_cast<float>(std::sin(theta));
            const double value = static_cast<double>(printed(1e-3f, sine, static_cast<float>(std::cos(theta))));
            local = larger(local, std::abs(value / ggx{alpha{1e-3}}.D({std::sin(theta), 0, std::cos(theta)}) - 1));
        }
        INFO(local);
        CHECK(rounded(100 * local, 1) == 12.5);
        const float s = static_cast<float>(std::sin(5e-4)), c = static_cast<float>(std::cos(5e-4));
        CHECK(rounded(static_cast<double>(printed(1e-3f, s, c)), 0) == 203166);
        CHECK(rounded(static_cast<double>(lobe_form(1e-3f, s, c)), 0) == 203718);
    }
    SECTION("S4-10 and S4-12: the constant of GTR, and its shape") {
        const lobe::gtr berry{alpha{0.1}, 1.0};
        CHECK(rounded(berry.D(n) * 0.1 * 0.1, 6) == 0.068429);
        CHECK(is_normalised([&](const vec3<double>& m) { return berry.D(m); }));
        const auto deviation = [](double gamma) {
            return shape_deviation([gamma](double a) {
                return [ndf = lobe::gtr{alpha{a}, gamma}](const vec3<double>& m) { return ndf.D(m); };
            });
        };
        INFO(deviation(1) << ' ' << deviation(1.5) << ' ' << deviation(3));
        CHECK(deviation(2) < 2e-13);
        for (double gamma : {1.0, 1.5, 3.0}) CHECK(deviation(gamma) > 0.1);
    }
    SECTION("S4-15: the exponent map above alpha = 1") {
        CHECK(lobe::blinn_phong_exponent_from_alpha(alpha{1.0}) == 0);
        CHECK(rounded(lobe::blinn_phong{alpha{1.0}}.D(at(0.3)), 12) == rounded(1 / pi, 12));
        const auto printed = [](const vec3<double>& m) {
            const double exponent = 2 / (1.2 * 1.2) - 2;
            return (exponent + 2) / (2 * pi) * std::exp(exponent * std::log(m.z));
        };
        CHECK(is_normalised(printed));
        CHECK_FALSE(falls_towards_grazing(printed));
        CHECK(aborts([] { (void)lobe::blinn_phong{alpha{1.2}}; }));
    }
}
