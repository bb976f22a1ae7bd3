// Energy at the extremes, in float and in double: roughness 0.02, 0.05, 1 seen at cosines 0.001, 0.01, 1. What promises
// to keep all light keeps it, what promises to make none makes none, to the rounding and the quadrature error that each
// bound counts.
#include "catch.hpp"
#include "support.hpp"

#include <lobe/brdf/eon.hpp>
#include <lobe/brdf/metallic_roughness.hpp>
#include <lobe/energy/dfg_table.hpp>
#include <lobe/energy/fdez_aguera.hpp>
#include <lobe/energy/random_walk.hpp>
#include <lobe/sampling/points.hpp>

using lobe::alpha;
using lobe::ggx;
using lobe::lambert;
using lobe::layered;
using lobe::microfacet;
using lobe::perfect_reflector;
using lobe::schlick;
using lobe::smith_correlated;
using lobe::smith_separable;
using lobe::vec3;

namespace {

/// The rounding of one step in T.
template <class T>
constexpr double u_of = static_cast<double>(std::numeric_limits<T>::epsilon()) / 2;
constexpr double u = u_of<float>;

/// visit(mu, alpha) at the nine points, which are the same numbers in double as in float.
template <class T = float, class Visit>
void every_extreme(const Visit& visit) {
    for (const float roughness : {0.02f, 0.05f, 1.0f})
        for (const float mu : {0.001f, 0.01f, 1.0f}) {
            INFO("roughness " << roughness << ", mu " << mu);
            visit(static_cast<T>(mu), alpha{static_cast<T>(alpha<float>::from_roughness(roughness).value())});
        }
}

template <class T>
alpha<double> in_double(const alpha<T>& a) {
    return alpha{static_cast<double>(a.value())};
}

/// E of the lobe with F = 1 in double: 128 nodes each way are right to 1e-10 here (those of 256 differ by less).
template <class T>
double exact_albedo(T mu, const alpha<T>& a) {
    return lobe::dfg_exact(smith_correlated{}, static_cast<double>(mu), in_double(a), {.order = 128}).albedo();
}

/// What a BRDF loses to the rounding of l, as `directional_albedo` states it: D moves with the half vector, by u/mu in
/// slopes of width alpha. In float that is 0.15 at roughness 0.02, mu 0.001; in double 3e-10.
template <class T>
double rounding_of_l(T mu, const alpha<T>& a) {
    return u_of<T> / (static_cast<double>(mu) * static_cast<double>(a.value()));
}

template <class T>
auto mirror(const alpha<T>& a) {
    return microfacet{ggx{a}, smith_correlated{}, perfect_reflector<T>{}};
}
template <class T>
auto gloss(const alpha<T>& a, T F0) {
    return microfacet{ggx{a}, smith_correlated{}, schlick{F0}};
}
template <class T>
vec3<T> view(T mu) {
    return {std::sqrt((1 - mu) * (1 + mu)), 0, mu};
}

constexpr lobe::quadrature order_32{.order = 32};

/// The albedo of a BRDF in double at the directions that one in T sees. Between the two is what the arithmetic of T
/// rounds, and the rounding of l is no part of it.
template <class T, class B>
double albedo_at_rounded_l(const B& brdf, T mu, const lobe::quadrature& options = order_32) {
    double total = 0;
    const vec3<T> v = view(mu);
    lobe::detail::for_each_lobe(brdf, [&](const auto& part) {
        const auto f_cos = [&](const vec3<T>& l) { return part.f_cos(vec3<double>(v), vec3<double>(l)); };
        total += lobe::hemisphere_integral(f_cos, v, lobe::vec2<T>(part.width()), true, options).value;
    });
    return total;
}

// That arithmetic, in u. A lobe: D 12 ULP of up to 2 u each, the rounding of v + l four times in k and so 8 in D, V's 6
// ULP, a quotient and two products. Schlick's F: v.m = |v + l|/2 is off by 3.5, 1 - v.m by 4.5, its fifth power by 5
// times that and 3, and 2. 1 - F over a base: 1 for the difference, and 8 for Lambert's l.z, 1/pi, four products, and
// the value itself.
constexpr double of_lobe = 24 + 8 + 12 + 3, of_fresnel = 28, of_base = 9;

/// F0 scale + bias, as exact as T can hold it.
template <class T>
auto exact_albedo_of(const alpha<T>& a, T F0) {
    return [=](T mu) {
        const auto t = lobe::dfg_exact(smith_correlated{}, std::max(mu, T(1e-6)), a, order_32);
        return F0 * t.scale + t.bias;
    };
}

struct mean_and_error {
    double mean, error;
};

/// The albedo of a random walk seen from mu, with its standard error.
template <class Walk>
mean_and_error albedo_of_walk(const Walk& walk, float mu, random_numbers& random) {
    constexpr int paths = 50000;
    double sum = 0, squares = 0;
    for (int k = 0; k < paths; ++k) {
        const double weight = static_cast<double>(
            walk.sample(view(mu), [&] { return static_cast<float>(random.between(0, 1 - u)); }).weight);
        sum += weight / paths;
        squares += weight * weight / paths;
    }
    return {sum, std::sqrt(std::max(squares - sum * sum, 0.0) / paths)};
}

}  // namespace

TEST_CASE("energy at the extremes: the split-sum terms in float", "[energy_extremes]") {
    const auto table = lobe::bake_dfg<float>(smith_correlated{});
    every_extreme([&](float mu, const alpha<float>& a) {
        const double E = exact_albedo(mu, a);
        const auto exact = lobe::dfg_exact(smith_correlated{}, mu, a), read = table(mu, a);
        // computed in double to the tolerance 1e-6; scale and bias rounded, and their sum
        CHECK(std::abs(static_cast<double>(exact.albedo()) - E) < 1e-6 + 2 * u);
        CHECK(std::abs(static_cast<double>(read.albedo()) - E) < 1.5e-3);  // the table's own bar
        for (const auto& t : {exact, read}) {
            CHECK(t.scale >= 0);
            CHECK(t.bias >= 0);
            CHECK(static_cast<double>(t.albedo()) <= 1 + 1e-6 + 2 * u);
        }
    });
}

TEST_CASE("energy at the extremes: fdez_aguera returns all of a white furnace, and never more", "[energy_extremes]") {
    const auto table = lobe::bake_dfg<float>(smith_correlated{});
    double worst = 0;
    every_extreme([&](float mu, const alpha<float>& a) {
        for (const auto& t : {lobe::dfg_exact(smith_correlated{}, mu, a), table(mu, a)}) {
            // F0 = 1. E and 1 - E are of the same number; Favg is off by 2 u; in E Favg Ems/(1 - Favg Ems) the
            // numerator and the quotient round 3 times and Ems once, which with Favg is 6, and 1 - Favg Ems, which is
            // E, is off by 4 u Ems and 1: then the sum
            const double E = static_cast<double>(t.albedo()), lost = 1 - E;
            const double bound = (1 + lost * (7 + 4 * lost / E)) * u;
            const auto white = lobe::fdez_aguera{}(t, 1.0f);
            const double wrong =
                std::abs(static_cast<double>(white.radiance) + static_cast<double>(white.irradiance) - 1);
            worst = larger(worst, wrong / bound);
            CHECK(wrong <= bound);
            for (const float F0 : {0.0f, 0.04f, 0.5f, 0.9f, 1.0f}) {
                const auto metal = lobe::fdez_aguera{}(t, F0), dielectric = lobe::fdez_aguera{}(t, F0, 1.0f);
                CHECK(metal.radiance >= 0);
                CHECK(metal.irradiance >= 0);
                CHECK(static_cast<double>(metal.radiance) + static_cast<double>(metal.irradiance) <= 1 + bound);
                // over a white base, what is left over is added: two differences, a sum
                CHECK(std::abs(static_cast<double>(dielectric.radiance) + static_cast<double>(dielectric.irradiance) -
                               1) <= 3 * u);
            }
        }
    });
    INFO("worst " << worst << " of the bound");
    CHECK(worst <= 1);
}

TEMPLATE_TEST_CASE("energy at the extremes: a lobe keeps at most all, by quadrature and by its own samples",
                   "[energy_extremes]", float, double) {
    using T = TestType;
    random_numbers random(4);
    every_extreme<T>([&](T mu, const alpha<T>& a) {
        const double E = exact_albedo(mu, a), rounded = albedo_at_rounded_l(mirror(in_double(a)), mu);
        const double correlated = static_cast<double>(lobe::directional_albedo(mirror(a), mu, order_32).value);
        const microfacet darker{ggx{a}, smith_separable{}, perfect_reflector<T>{}};
        const double separable = static_cast<double>(lobe::directional_albedo(darker, mu, order_32).value);
        INFO("E " << E << ", at l rounded " << rounded << ", by this arithmetic " << correlated << ", separable "
                  << separable);
        CHECK(E <= 1 + 1e-10);
        CHECK(std::abs(rounded - E) < rounding_of_l(mu, a) + 1e-7);  // order 32: 1e-7
        CHECK(std::abs(correlated - rounded) < of_lobe * u_of<T>);
        CHECK(separable <= correlated + 2 * of_lobe * u_of<T>);  // at every l
        // 16 times 2^12 Hammersley points, each time shifted at random, which leaves no bias: their mean against its
        // standard error, 8 of which 15 differences exceed once in a million. Or one point, where hardly any fails. A
        // weight has no D in it: it feels the rounding of l.z, 4 u, only beside mu.
        constexpr int shifts = 16, n = 1 << 12;
        double light = 0, squares = 0, largest = 0;
        for (int k = 0; k < shifts; ++k) {
            const T x = static_cast<T>(random()), y = static_cast<T>(random());
            const auto wrapped = [](T sum) { return sum < 1 ? sum : sum - 1; };
            double mean = 0;
            for (std::uint32_t i = 0; i < n; ++i) {
                const auto point = lobe::hammersley<T>(i, n);
                const double weight = static_cast<double>(
                    mirror(a).sample(view(mu), {wrapped(point.x + x), wrapped(point.y + y)}).weight);
                mean += weight / n;
                largest = larger(largest, weight);
            }
            light += mean / shifts;
            squares += mean * mean / shifts;
        }
        const double error = std::sqrt(std::max(squares - light * light, 0.0) / (shifts - 1));
        INFO("by samples " << light << " +- " << error << ", largest weight " << largest);
        CHECK(std::abs(light - E) <
              8 * error + 1.0 / (shifts * n) + 8 * u_of<T> + 4 * u_of<T> / static_cast<double>(mu));
        CHECK(largest <= 1 + 8 * u_of<T>);  // sv cl/den = sv cl/(sv cl + (sl - cl) cv), which rounds 6 times, V's 6 ULP
    });
}

TEMPLATE_TEST_CASE("energy at the extremes: what a base keeps under a lobe adds up to 1", "[energy_extremes]", float,
                   double) {
    using T = TestType;
    constexpr double step = u_of<T>;
    for (const T F0 : {T(0.04f), T(0.5f)})
        every_extreme<T>([&](T mu, const alpha<T>& a) {
            const auto specular = gloss(a, F0);
            const auto wide = gloss(in_double(a), static_cast<double>(F0));
            const T own = lobe::directional_albedo(specular, mu, order_32).value;

            // With the lobe's own albedo, by the same quadrature, nothing is left but Lambert's integral: the error of
            // order 32, and 8 u of 1 - E
            const layered with_own{specular, lambert{T(1)}, lobe::albedo_coupling{[=](T) { return own; }}};
            CHECK(std::abs(static_cast<double>(lobe::directional_albedo(with_own, mu, order_32).value) - 1) <
                  1e-7 + 8 * step);

            // With the exact one: and what the lobe's arithmetic rounds, and the rounding of l.
            const auto E = exact_albedo_of(a, F0);
            const T exact = E(mu);
            const double kept = 1 - static_cast<double>(exact), rounded = albedo_at_rounded_l(wide, mu);
            const layered with_exact{specular, lambert{T(1)}, lobe::albedo_coupling{[=](T) { return exact; }}};
            const double total = static_cast<double>(lobe::directional_albedo(with_exact, mu, order_32).value);
            const double of_sum = (of_lobe + of_fresnel + of_base) * step;
            INFO("F0 " << F0 << ": 1 - E(v) totals " << total << ", at l rounded " << rounded + kept);
            CHECK(exact < 1);
            CHECK(std::abs(total - (rounded + kept)) < of_sum + 1e-7);
            CHECK(std::abs(rounded + kept - 1) < rounding_of_l(mu, a) + 2 * u_of<T> + 2e-7);

            // The reciprocal product asks for E at every l, and for its average: two rules for one integral, of which
            // that over l at order 16 is right to 2e-5; 2 u more for E(l), 2 for the scale
            const double E_avg = lobe::average_albedo(wide, {.order = 32}).value;
            const layered both_ways{specular, lambert{T(1)}, lobe::reciprocal_coupling{E, static_cast<T>(E_avg)}};
            constexpr lobe::quadrature order_16{.order = 16};
            const double twice = static_cast<double>(lobe::directional_albedo(both_ways, mu, order_16).value);
            const double lobe_at_16 = static_cast<double>(lobe::directional_albedo(specular, mu, order_16).value);
            const double rounded_at_16 = albedo_at_rounded_l(wide, mu, order_16);
            INFO("the reciprocal product totals " << twice << ", of which the lobe " << lobe_at_16);
            CHECK(std::abs(twice - lobe_at_16 - kept) < 12 * step + 2e-5);
            CHECK(std::abs(lobe_at_16 - rounded_at_16) < (of_lobe + of_fresnel) * step);
            // the lobe's rule is one of order 16, too
            CHECK(std::abs(rounded_at_16 + kept - 1) < rounding_of_l(mu, a) + 2 * step + 2e-5);
        });
}

TEMPLATE_TEST_CASE("energy at the extremes: what gains energy gains no more than stated, and the coat none",
                   "[energy_extremes]", float, double) {
    using T = TestType;
    const lobe::coupled base{lambert{1.0}, lobe::fresnel_coupling{schlick{0.04}}};
    // 1.9: all by the lobe, and nearly all by the base
    const double limit = 1 + lobe::directional_albedo(base, 1e-6, {.order = 64}).value;
    every_extreme<T>([&](T mu, const alpha<T>& a) {
        const double of_l = rounding_of_l(mu, a);
        const auto total = [&](const auto& brdf) {
            return static_cast<double>(lobe::directional_albedo(brdf, mu, order_32).value);
        };
        const auto exact = [&](const auto& brdf) {
            return lobe::directional_albedo(brdf, static_cast<double>(mu), {.order = 64}).value;
        };
        const auto wide_gltf = lobe::metallic_roughness(1.0, 0.0, in_double(a));
        const auto wide_coat = lobe::coated(lambert{1.0}, ggx{in_double(a)}, 1.0);
        const double gltf = total(lobe::metallic_roughness(T(1), T(0), a)),
                     coat = total(lobe::coated(lambert{T(1)}, ggx{a}, T(1)));
        const double gltf_exact = exact(wide_gltf), gltf_rounded = albedo_at_rounded_l(wide_gltf, mu);
        const double coat_exact = exact(wide_coat), coat_rounded = albedo_at_rounded_l(wide_coat, mu);
        INFO("1 - F(v.h) totals " << gltf << ", at l rounded " << gltf_rounded << ", exactly " << gltf_exact
                                  << "; coated " << coat << ", " << coat_rounded << ", " << coat_exact);
        CHECK(gltf_exact < limit);
        CHECK(coat_exact <= 1 + 1e-7);
        CHECK(coat_exact >= 0.853);
        // F twice: of the lobe, of the base; the coat's is F(n.v)
        const double of_arithmetic = (of_lobe + 2 * of_fresnel + of_base) * u_of<T>;
        CHECK(std::abs(gltf - gltf_rounded) < of_arithmetic);
        CHECK(std::abs(coat - coat_rounded) < of_arithmetic);
        CHECK(std::abs(gltf_rounded - gltf_exact) < of_l + 1e-7);
        CHECK(std::abs(coat_rounded - coat_exact) < of_l + 1e-7);
        // The diffuse reflector that keeps its energy. f has a crease, so the quadrature's error is the one that it
        // estimates, and the rounding of its sum in double, of 2 128^2 terms: 4 standard errors
        for (const float r : {0.02f, 0.05f, 1.0f}) {
            const auto white = lobe::directional_albedo(lobe::eon{T(1), static_cast<T>(r)}, mu, {.order = 128});
            CHECK(std::abs(static_cast<double>(white.value) - 1) <
                  static_cast<double>(white.error) + 8 * u_of<T> + 4 * std::sqrt(2.0) * 128 * u_of<double>);
            // 4 times what orders 64 and 128 are apart: the errors stated of each
            CHECK(white.error < T(4 * (1e-4 + 2e-5)));
            CHECK(total(lobe::eon{T(0.5), static_cast<T>(r)}) < 1);
        }
        CHECK(std::abs(total(lambert{T(1)}) - 1) < 1e-7 + 4 * u_of<T>);
    });
}

TEST_CASE("energy at the extremes: the random walk loses nothing, and its first bounce is E", "[energy_extremes]") {
    random_numbers random(1);
    const auto uniform = [&] { return static_cast<float>(random.between(0, 1 - u)); };
    every_extreme([&](float mu, const alpha<float>& a) {
        const lobe::random_walk white{ggx{a}, perfect_reflector{}};
        constexpr int paths = 100000;
        int once = 0, lost = 0;
        for (int i = 0; i < paths; ++i) {
            const auto path = white.sample(view(mu), uniform);
            lost += !(path.weight == 1 && path.l.z > 0 && std::abs(lobe::length(path.l) - 1) < 1e-6f);
            once += path.order == 1;
        }
        const double E = exact_albedo(mu, a), share = static_cast<double>(once) / paths;
        INFO("E " << E << ", first bounce " << share);
        CHECK(lost == 0);
        // four standard errors, or one path where hardly any bounces twice
        CHECK(std::abs(share - E) <
              4 * std::sqrt(std::max(E * (1 - E), 1.0 / paths) / paths) + 4 * u / static_cast<double>(mu));
    });
}

TEST_CASE("energy at the extremes: fdez_aguera against the random walk beyond its table", "[energy_extremes]") {
    // What the model misses by is known at F0 = 0.5 and 0.9 from the table (0.042, 0.060). At F0 = 0.04 it is more on
    // smooth surfaces seen at mu = 0.001 than anywhere in the table (0.0205): it gives the average Favg to all bounces
    // after the first, and there all graze.
    const float F0[3] = {0.04f, 0.5f, 0.9f};
    const double model[3] = {0.0621, 0.042, 0.060};
    random_numbers random(3);
    double largest = 0;
    every_extreme([&](float mu, const alpha<float>& a) {
        const auto t = lobe::dfg_exact(smith_correlated{}, mu, a);
        for (std::size_t i = 0; i < 3; ++i) {
            const lobe::random_walk walk{ggx{a}, schlick{F0[i]}};
            const auto [mean, error] = albedo_of_walk(walk, mu, random);
            const auto w = lobe::fdez_aguera{}(t, F0[i]);
            const double difference = static_cast<double>(w.radiance + w.irradiance) - mean;
            INFO("F0 " << F0[i] << ": walk " << mean << " +- " << error << ", fdez_aguera less " << -difference);
            CHECK(std::abs(difference) < model[i] + 4 * error + 8 * u);
            CHECK(difference < 4 * error + 8 * u);  // it errs to the dark
            largest = larger(largest, i == 0 ? -difference : 0);
        }
    });
    CHECK(std::abs(largest - 0.0621) < 5e-4 + 4 * 1.3e-4);  // the last digit stated, and four standard errors there
}

TEST_CASE("energy at the extremes: roughness 1 against the random walk's table, in float", "[energy_extremes]") {
    // The deviations of the model, as stated: 0.0205, 0.0215, 0.042, 0.060 at F0 = 0.04, 0.2, 0.5, 0.9.
    const float F0[4] = {0.04f, 0.2f, 0.5f, 0.9f};
    const double model[4] = {0.0205, 0.0215, 0.042, 0.060};
    const auto table = lobe::bake_dfg<float>(smith_correlated{});
    random_numbers random(2);
    int rows = 0;
    for (const auto& row : reference_table("multiscatter_random_walk.csv")) {
        if (row[1] != 1) continue;
        ++rows;
        const float mu = static_cast<float>(row[0]);
        const alpha<float> a{1.0f};
        INFO("mu " << mu);
        const auto t = lobe::dfg_exact(smith_correlated{}, mu, a), t_read = table(mu, a);
        CHECK(std::abs(static_cast<double>(t.albedo()) - row[6]) < 4 * row[7] + 1e-6);  // the first bounce
        for (std::size_t i = 0; i < 4; ++i) {
            const double truth = row[12 + 4 * i], error = row[13 + 4 * i];
            const auto exact = lobe::fdez_aguera{}(t, F0[i]), read = lobe::fdez_aguera{}(t_read, F0[i]);
            CHECK(std::abs(static_cast<double>(exact.radiance + exact.irradiance) - truth) < model[i]);
            // and the table's
            CHECK(std::abs(static_cast<double>(read.radiance + read.irradiance) - truth) < model[i] + 3.5e-3);
            const lobe::random_walk walk{ggx{a}, schlick{F0[i]}};
            const auto [mean, own_error] = albedo_of_walk(walk, mu, random);
            CHECK(std::abs(mean - truth) < 4 * (own_error + error));
        }
    }
    CHECK(rows == 4);
}
