#include "catch.hpp"
#include "ndf_support.hpp"

#include <lobe/brdf/burley.hpp>
#include <lobe/brdf/eon.hpp>
#include <lobe/brdf/metallic_roughness.hpp>
#include <lobe/energy/dfg_table.hpp>
#include <lobe/ndf/gtr.hpp>
#include <lobe/ndf/masked_by.hpp>
#include <lobe/sampling/points.hpp>

#include <lobe/energy/albedo.hpp>

#include <xsimd/xsimd.hpp>

using lobe::alpha;
using lobe::alpha_xy;
using lobe::ggx;
using lobe::lambert;
using lobe::layered;
using lobe::microfacet;
using lobe::schlick;
using lobe::smith_correlated;
using lobe::sum;
using lobe::vec2;
using lobe::vec3;
using lobe::weighted;

namespace {

constexpr double pi = 3.141592653589793;

/// The view at a cosine and an azimuth of its own.
vec3<double> view(double mu) {
    const double sine = std::sqrt((1 - mu) * (1 + mu));
    return {0.6 * sine, 0.8 * sine, mu};
}

auto gloss(double a, double F0 = 0.04) { return microfacet{ggx{alpha{a}}, smith_correlated{}, schlick{F0}}; }

/// The specular lobe's albedo by quadrature, without a table: 4e-7 at order 32.
auto albedo_of(double a, double F0 = 0.04) {
    return [lobe = gloss(a, F0)](double mu) {
        return lobe::directional_albedo(lobe, std::max(mu, 1e-6), {.order = 32}).value;
    };
}

double fresnel_total(double a, double mu) {
    return lobe::directional_albedo(layered{gloss(a), lambert{1.0}, lobe::fresnel_coupling{schlick{0.04}}}, mu,
                                    {.order = 64});
}

}  // namespace

TEST_CASE("the price of 1 - F(v.h): a white base gains energy", "[layered]") {
    CHECK(std::abs(fresnel_total(0.05, 0.01) - 1.49) < 0.005);  // independently computed to two decimals
    CHECK(std::abs(fresnel_total(0.1, 0.1) - 1.26) < 0.005);
    double largest = 0;
    for (double a : {0.001, 0.01, 0.02, 0.05, 0.1, 0.3, 1.0})
        for (double mu : {0.001, 0.01, 0.03, 0.1, 0.3, 1.0}) largest = larger(largest, fresnel_total(a, mu));
    // At grazing views of a smooth surface the lobe returns all and the base nearly all as well: the limit is 1 + what
    // it returns at mu = 0.
    const lobe::coupled base{lambert{1.0}, lobe::fresnel_coupling{schlick{0.04}}};
    CHECK(largest < 1 + lobe::directional_albedo(base, 1e-6, {.order = 64}).value);
    CHECK(largest > 1.85);
    CHECK(fresnel_total(0.1, 1.0) == Catch::Approx(1).margin(0.01));  // and hardly any face on
}

TEST_CASE("1 - E(v) totals exactly 1 over a white base, and is not reciprocal", "[layered]") {
    for (double a : {0.02, 0.1, 1.0})
        for (double mu : {0.01, 0.1, 1.0}) {
            INFO("alpha " << a << " mu " << mu);
            const layered brdf{gloss(a), lambert{1.0}, lobe::albedo_coupling{albedo_of(a)}};
            // the same lobe at the same order on both sides: only Lambert's own quadrature is left, which is exact to
            // rounding
            CHECK(std::abs(lobe::directional_albedo(brdf, mu, {.order = 32}).value - 1) < 1e-9);
        }
    const auto E = albedo_of(0.3);
    const layered brdf{gloss(0.3), lambert{1.0}, lobe::albedo_coupling{E}};
    const auto v = view(0.2), l = lobe::vec3<double>{0, 0.6, 0.8};
    const double base_vl = brdf.f(v, l) - gloss(0.3).f(v, l), base_lv = brdf.f(l, v) - gloss(0.3).f(l, v);
    CHECK(base_vl / base_lv == Catch::Approx((1 - E(0.2)) / (1 - E(0.8))));
    CHECK(std::abs(base_vl / base_lv - 1) > 0.05);
}

TEST_CASE("the reciprocal product totals exactly 1 over a white Lambertian base", "[layered]") {
    for (double a : {0.1, 1.0}) {
        const double E_avg = lobe::average_albedo(gloss(a), {.order = 32});
        const layered brdf{gloss(a), lambert{1.0}, lobe::reciprocal_coupling{albedo_of(a), E_avg}};
        for (double mu : {0.05, 1.0}) {
            INFO("alpha " << a << " mu " << mu);
            // two rules for 2 int E mu dmu, average_albedo's and the one over l: each good to 1e-8 where E bends, at mu
            // ~ alpha
            CHECK(std::abs(lobe::directional_albedo(brdf, mu, {.order = 32}).value - 1) < 2e-8);
        }
    }
    // With colour: what is missing is absorbed by the base, (1 - rho)(1 - E(v)).
    const double E_avg = lobe::average_albedo(gloss(0.5), {.order = 32});
    const layered grey{gloss(0.5), lambert{0.3}, lobe::reciprocal_coupling{albedo_of(0.5), E_avg}};
    CHECK(std::abs(lobe::directional_albedo(grey, 0.4, {.order = 32}).value - (1 - 0.7 * (1 - albedo_of(0.5)(0.4)))) <
          2e-8);
    CHECK(aborts([] { (void)lobe::reciprocal_coupling{albedo_of(0.5), 1.0}; }));
    CHECK(aborts([] { (void)lobe::reciprocal_coupling{albedo_of(0.5), std::numeric_limits<double>::quiet_NaN()}; }));
}

TEST_CASE("E from a baked table, in colour: the total is as good as the table", "[layered]") {
    const auto table = lobe::bake_dfg<float>(smith_correlated{});
    const alpha<float> a{0.3f};
    const vec3<float> f0{0.04f, 0.2f, 0.6f};
    const auto E = [&](float mu) {
        const auto t = table(mu, a);
        return f0 * t.scale + t.bias;
    };
    const microfacet lobe{ggx{a}, smith_correlated{}, schlick{f0}};
    const layered by_view{lobe, lambert{vec3<float>{1}}, lobe::albedo_coupling{E}};
    const layered both_ways{lobe, lambert{vec3<float>{1}},
                            lobe::reciprocal_coupling{E, lobe::average_albedo(lobe).value}};
    for (float mu : {0.1f, 0.5f, 0.95f}) {
        const vec3<float> once = lobe::directional_albedo(by_view, mu), twice = lobe::directional_albedo(both_ways, mu);
        for (int c = 0; c < 3; ++c) {
            // scale and bias err by up to 3.5e-3 in opposite directions, their sum by 1.5e-3, so E by less than 3.5e-3;
            // then that of E(l), 4e-4 rms on average, over 1 - E_avg >= 0.3
            CHECK(std::abs(once[c] - 1) < 3.5e-3f);
            CHECK(std::abs(twice[c] - 1) < 3.5e-3f + 2e-3f);
        }
    }
}

namespace {

template <class B>
double worst_reciprocity(const B& brdf, std::uint64_t seed) {
    random_numbers random(seed);
    double worst = 0;
    for (int i = 0; i < 20000; ++i) {
        const auto v = random.grazing_direction(1e-3), l = random.grazing_direction(1e-3);
        worst = larger(worst, std::abs(brdf.f(v, l) / brdf.f(l, v) - 1));
    }
    return worst;
}

}  // namespace

TEST_CASE("what claims to be reciprocal is, to rounding", "[layered]") {
    const auto some_E = [](double mu) { return 0.04 + 0.4 * (1 - mu); };  // any E will do
    CHECK(worst_reciprocity(layered{gloss(0.2), lambert{0.8}, lobe::fresnel_coupling{schlick{0.04}}}, 1) <
          16 * 1.1e-16);
    CHECK(worst_reciprocity(layered{gloss(0.2), lambert{0.8}, lobe::reciprocal_coupling{some_E, 0.2}}, 2) <
          16 * 1.1e-16);
    CHECK(worst_reciprocity(lobe::metallic_roughness(0.8, 0.3, alpha{0.1}), 3) < 16 * 1.1e-16);
    CHECK(worst_reciprocity(layered{gloss(0.2), lambert{0.8}, lobe::albedo_coupling{some_E}}, 4) > 0.1);
    CHECK(worst_reciprocity(lobe::coated(lambert{0.8}, ggx{alpha{0.1}}, 1.0), 5) > 0.1);
}

TEST_CASE("f is the sum that the comment prints", "[layered]") {
    random_numbers random(6);
    const auto some_E = [](double mu) { return 0.04 + 0.4 * (1 - mu); };
    const lobe::burley base{0.7, 0.5};
    const layered fresnel{gloss(0.2, 0.1), base, lobe::fresnel_coupling{schlick{0.1}}};
    const layered albedo{gloss(0.2, 0.1), base, lobe::albedo_coupling{some_E}};
    const layered reciprocal{gloss(0.2, 0.1), base, lobe::reciprocal_coupling{some_E, 0.25}};
    const auto coat = lobe::coated(base, ggx{alpha{0.2}}, 0.75);
    double worst = 0;
    for (int i = 0; i < 1000; ++i) {
        const auto v = random.grazing_direction(1e-2), l = random.grazing_direction(1e-2);
        const auto compare = [&](double value, double specular, double share) {
            worst = larger(worst, std::abs(value / (specular + share * base.f(v, l)) - 1));
        };
        const double specular = gloss(0.2, 0.1).f(v, l), v_h = lobe::dot(v, lobe::half_vector(v, l));
        compare(fresnel.f(v, l), specular, 0.9 * (1 - std::pow(1 - v_h, 5.0)));
        compare(albedo.f(v, l), specular, 1 - some_E(v.z));
        compare(reciprocal.f(v, l), specular, (1 - some_E(v.z)) * (1 - some_E(l.z)) / 0.75);
        const double share = 0.75 * (0.04 + 0.96 * std::pow(1 - v.z, 5.0));
        compare(coat.f(v, l), share * gloss(0.2, 1).f(v, l), 1 - share);
        for (const double by_f : {fresnel.f(v, l) * l.z / fresnel.f_cos(v, l), coat.f(v, l) * l.z / coat.f_cos(v, l)})
            worst = larger(worst, std::abs(by_f - 1));
    }
    CHECK(worst < 100 * 1.1e-16);  // ten roundings; 1 - F(v.h) amplifies those of v.h five times
}

namespace {

/// weight * pdf = f_cos, pdf(v, sample.l) = sample.pdf, evaluate = (f_cos, pdf), E[weight] = albedo, no weight is
/// large.
template <class B>
void expect_consistent_sampling(const B& brdf, const vec3<double>& v, double tolerance) {
    static_assert(lobe::samplable_brdf<B>);
    constexpr std::uint32_t count = 1u << 17;
    double mean_weight = 0, worst = 0, largest = 0;
    for (std::uint32_t i = 0; i < count; ++i) {
        const auto s = brdf.sample(v, lobe::hammersley<double>(i, count));
        mean_weight += s.weight / count;
        largest = larger(largest, s.weight);
        if (s.pdf == 0) continue;
        const auto e = brdf.evaluate(v, s.l);
        worst =
            larger({worst, std::abs(s.weight * s.pdf / brdf.f_cos(v, s.l) - 1), std::abs(s.pdf / brdf.pdf(v, s.l) - 1),
                    std::abs(e.f_cos / brdf.f_cos(v, s.l) - 1), std::abs(e.pdf / s.pdf - 1)});
    }
    const double albedo = lobe::directional_albedo(brdf, v).value;
    INFO("mean weight " << mean_weight << " albedo " << albedo << " largest weight " << largest);
    CHECK(std::abs(mean_weight - albedo) < tolerance);
    CHECK(worst < 32 * 1.1e-16);
    CHECK(largest < 8);  // weight <= max_i(weight_i/p_i); the estimates are good enough to keep that small
}

}  // namespace

TEST_CASE("compositions: weight * pdf is f_cos, and weights add up to the albedo", "[layered]") {
    // 2^17 Hammersley points: error of order log(n)/n = 9e-5 times the variation of the weight over the square, which
    // is about 2, and as much again for the jump between the lobes.
    const auto some_E = [](double mu) { return 0.04 + 0.4 * (1 - mu); };
    for (double a : {0.001, 0.05, 1.0})
        for (double mu : {0.05, 0.5, 1.0}) {
            INFO("alpha " << a << " mu " << mu);
            const auto v = view(mu);
            const lobe::burley base{0.7, 0.5};
            expect_consistent_sampling(weighted{0.3, base}, v, 5e-4);
            expect_consistent_sampling(lobe::coupled{base, lobe::fresnel_coupling{schlick{0.04}}}, v, 5e-4);
            expect_consistent_sampling(layered{gloss(a), base, lobe::fresnel_coupling{schlick{0.04}}}, v, 5e-4);
            expect_consistent_sampling(layered{gloss(a), base, lobe::albedo_coupling{some_E}}, v, 5e-4);
            expect_consistent_sampling(layered{gloss(a), base, lobe::reciprocal_coupling{some_E, 0.2}}, v, 5e-4);
            expect_consistent_sampling(lobe::metallic_roughness(0.6, 0.4, alpha_xy{a, 0.3}), v, 5e-4);
            expect_consistent_sampling(sum{weighted{0.3, gloss(a, 0.5)}, weighted{0.7, gloss(0.4, 0.5)}, lambert{0.2}},
                                       v, 5e-4);
            expect_consistent_sampling(lobe::coated(lobe::metallic_roughness(0.6, 0.4, alpha{0.3}), ggx{alpha{a}}, 0.8),
                                       v, 5e-4);
        }
    expect_consistent_sampling(lobe::coated(lobe::eon{0.8, 0.5}, lobe::tabulated{lobe::gtr{alpha{0.1}, 1.0}}, 0.25),
                               view(0.4), 5e-4);
}

TEST_CASE("compositions: each lobe's part of the square has its share of the pdf as Jacobian", "[layered]") {
    // Where u.x chooses lobe i, 1/|dl/du| is p_i pdf_i, and the shares add up to the pdf.
    const auto compare = [](const auto& brdf, const vec3<double>& v, std::uint64_t seed) {
        std::vector<double> p;
        brdf.for_each_lobe([&](const auto& lobe) { p.push_back(lobe.albedo_estimate(v)); });
        double all = 0;
        for (const double share : p) all += share;
        random_numbers random(seed);
        double worst = 0, total = 0;
        int tried = 0;
        for (int k = 0; k < 300; ++k) {
            double low = 0;
            for (std::size_t chosen = 0; chosen < p.size(); low += p[chosen++] / all) {
                const double share = p[chosen] / all, margin = 0.03 * share;
                // the error of jacobian() as a share of this lobe's part: (4e-4/margin)^6
                if (margin < 4e-3) continue;
                const vec2<double> u{low + random.between(margin, share - margin), random.between(0.01, 0.99)};
                const auto light = [&](const vec2<double>& at) { return brdf.sample(v, at).l; };
                const auto s = brdf.sample(v, u);
                if (!(s.pdf > 0 && s.l.z > 0.05)) continue;
                ++tried;
                std::size_t i = 0;
                double pdf = 0;
                brdf.for_each_lobe([&](const auto& lobe) {
                    const double part = p[i] / all * lobe.pdf(v, s.l);
                    if (i++ == chosen) worst = larger(worst, std::abs(part * jacobian(light, u) - 1));
                    pdf += part;
                });
                total = larger(total, std::abs(s.pdf / pdf - 1));
            }
        }
        INFO(worst << ' ' << total << " of " << tried);
        CHECK(tried > 100);
        CHECK(worst < 1e-5);
        CHECK(total < 32 * 1.1e-16);
    };
    const auto some_E = [](double mu) { return 0.04 + 0.4 * (1 - mu); };
    const lobe::burley base{0.7, 0.5};
    for (const double mu : {0.3, 0.9}) {
        INFO("mu " << mu);
        compare(lobe::metallic_roughness(0.5, 0.5, alpha{0.3}), view(mu), 61);
        compare(sum{weighted{0.4, gloss(0.25, 0.6)}, weighted{0.6, gloss(0.8, 0.6)}, lambert{0.5}}, view(mu), 62);
        compare(layered{gloss(0.2, 0.5), base, lobe::fresnel_coupling{schlick{0.5}}}, view(mu), 63);
        compare(layered{gloss(0.2, 0.5), base, lobe::albedo_coupling{some_E}}, view(mu), 64);
        compare(layered{gloss(0.2, 0.5), base, lobe::reciprocal_coupling{some_E, 0.25}}, view(mu), 65);
    }
}

TEST_CASE("samples are shared by albedo, and none go to a black lobe", "[layered]") {
    const sum ordinary{lambert{0.2}, lambert{0.6}, lambert{0.0}};
    const auto v = view(0.5);
    CHECK(ordinary.albedo_estimate(v) == Catch::Approx(0.8));
    // three densities that differ: lambert's, and two of microfacets with F0 = F90, whose shares are 0.25 and 0.75
    // exactly
    const auto flat = [](double a, double F) { return microfacet{ggx{alpha{a}}, smith_correlated{}, schlick{F, F}}; };
    const sum two{flat(0.1, 0.2), flat(0.5, 0.6), lambert{0.0}};
    const vec3<double> l{-0.2, -0.3, std::sqrt(0.87)};
    CHECK(two.pdf(v, l) == Catch::Approx(0.25 * flat(0.1, 0.2).pdf(v, l) + 0.75 * flat(0.5, 0.6).pdf(v, l)));
    const sum black{lambert{0.0}, lambert{0.0}};
    CHECK(black.sample(v, {0.7, 0.2}).weight == 0);
    CHECK(black.pdf(v, l) == lambert{0.5}.pdf(v, l));
    // colours count by their mean
    const sum coloured{lambert{vec3<float>{0.9f, 0.0f, 0.0f}},
                       microfacet{ggx{alpha{0.5f}}, smith_correlated{}, schlick{vec3<float>{0.1f}, vec3<float>{0.1f}}}};
    const vec3<float> w{0.6f, 0, 0.8f}, k{0, 0.6f, 0.8f};
    CHECK(coloured.pdf(w, k) ==
          Catch::Approx(0.75f * 0.8f / pi +
                        0.25f * microfacet{ggx{alpha{0.5f}}, smith_correlated{}, schlick{0.5f}}.pdf(w, k)));
}

namespace {

/// A lobe that tells which u it was given, as its pdf.
struct spy {
    using scalar = float;
    using spectrum = float;
    static constexpr bool isotropic = true;
    float share, *largest, *least;
    float f_cos(const vec3<float>&, const vec3<float>&) const { return 1; }
    vec2<float> width() const { return {1, 1}; }
    float pdf(const vec3<float>&, const vec3<float>&) const { return 1; }
    lobe::evaluation<float, float> evaluate(const vec3<float>&, const vec3<float>&) const { return {1, 1}; }
    lobe::direction_sample<float, float> sample(const vec3<float>&, const vec2<float>& u) const {
        *largest = std::max(*largest, u.x);
        *least = std::min(*least, u.x);
        return {{0, 0, 1}, 1, 1};
    }
    float albedo_estimate(const vec3<float>&) const { return share; }
};

}  // namespace

TEST_CASE("u.x at the border between lobes stays in [0,1) for each", "[layered]") {
    random_numbers random(21);
    float largest = 0, least = 1;
    int failed = 0;
    for (int i = 0; i < 20000; ++i) {
        const auto any = [&] { return spy{static_cast<float>(random.log_between(1e-6, 1)), &largest, &least}; };
        const spy a = any(), b = any(), c = any();
        const float border = a.share / (a.share + b.share + c.share);
        for (float u : {0.0f, border, std::nextafter(border, 0.0f), std::nextafter(border, 1.0f), 1 - 0x1p-24f,
                        static_cast<float>(random()) * 0.9999f})
            if (u < 1) failed += sum{a, b, c}.sample({0, 0, 1}, {u, 0.5f}).pdf == 0;
    }
    CHECK(failed == 0);
    CHECK(least >= 0);
    CHECK(largest < 1);
    CHECK(largest > 0.999f);
}

TEST_CASE("glTF: metallic 1 is the bare metal, metallic 0 the dielectric", "[layered]") {
    const vec3<float> gold{1.0f, 0.71f, 0.29f};
    const auto metal = lobe::metallic_roughness(gold, 1.0f, alpha{0.2f});
    const microfacet bare{ggx{alpha{0.2f}}, smith_correlated{}, schlick{gold}};
    const auto plastic = lobe::metallic_roughness(gold, 0.0f, alpha{0.2f});
    const microfacet polish{ggx{alpha{0.2f}}, smith_correlated{}, schlick{vec3<float>{0.04f}}};
    random_numbers random(31);
    bool same = true;
    double worst = 0;
    for (int i = 0; i < 10000; ++i) {
        const auto v = random.grazing_direction<float>(1e-3), l = random.grazing_direction<float>(1e-3);
        same = same && metal.f(v, l) == bare.f(v, l) && metal.f_cos(v, l) == bare.f_cos(v, l) &&
               metal.pdf(v, l) == bare.pdf(v, l);
        const vec2<float> u{static_cast<float>(random()) * 0.9999f, static_cast<float>(random()) * 0.9999f};
        same = same && metal.sample(v, u).l == bare.sample(v, u).l;
        const float v_h = lobe::dot(v, lobe::half_vector(v, l)), Fc = std::pow(1 - v_h, 5.0f);
        const vec3<float> expected = polish.f(v, l) + gold * (0.96f * (1 - Fc) / static_cast<float>(pi)),
                          got = plastic.f(v, l);
        for (int c = 0; c < 3; ++c)
            worst = larger(worst, std::abs(static_cast<double>(got[c]) / static_cast<double>(expected[c]) - 1));
    }
    CHECK(same);
    CHECK(worst < 100 * 6e-8);
    // half way: F0 = lerp(0.04, base, metallic), c_diff = base (1 - metallic), by appendix B's own words
    const vec3<double> v = view(0.6), l{0, 0.6, 0.8};
    const double F0 = 0.5 * 0.04 + 0.5 * 0.8,
                 F = F0 + (1 - F0) * std::pow(1 - lobe::dot(v, lobe::half_vector(v, l)), 5.0);
    CHECK(lobe::metallic_roughness(0.8, 0.5, alpha{0.25}).f(v, l) ==
          Catch::Approx(gloss(0.25, F0).f(v, l) + (1 - F) * 0.4 / pi));
    CHECK(lobe::metallic_roughness(0.8, 0.5, 0.5, 1e-4).f(v, l) ==
          lobe::metallic_roughness(0.8, 0.5, alpha{0.25}).f(v, l));
    CHECK(lobe::metallic_roughness(0.8, 0.5, 0.0, 1e-4).width() == vec2<double>{1e-4, 1e-4});
    static_assert(!decltype(lobe::metallic_roughness(0.8, 0.5, alpha_xy{0.1, 0.2}))::isotropic);
    CHECK(aborts([] { (void)lobe::metallic_roughness(0.8, 1.5, alpha{0.25}); }));
    CHECK(aborts([] { (void)lobe::metallic_roughness(-0.1, 0.5, alpha{0.25}); }));
    CHECK(aborts([] { (void)lobe::metallic_roughness(0.8, std::numeric_limits<double>::quiet_NaN(), alpha{0.25}); }));
}

TEST_CASE("Disney's clear coat", "[layered]") {
    // The F = 1 furnace of GTR1 under a GGX masking of alpha 0.25 gains energy; GTR1 under its own does not
    const lobe::gtr gtr1{alpha{0.1}, 1.0};
    const microfacet disney{lobe::masked_by{gtr1, ggx{alpha{0.25}}}, lobe::smith_separable{},
                            lobe::perfect_reflector{}};
    const microfacet smith{lobe::tabulated{gtr1}, smith_correlated{}, lobe::perfect_reflector{}};
    const double printed[][2] = {{1, 0.81}, {0.5, 0.85}, {0.1, 1.14}};
    for (const auto& [mu, E] : printed) {
        CHECK(std::abs(lobe::directional_albedo(disney, mu).value - E) < 0.006);
        CHECK(lobe::directional_albedo(smith, mu).value < 1);
    }
}

TEST_CASE("two specular lobes lose no more than the duller", "[layered]") {
    const microfacet sharp{ggx{alpha{0.1}}, smith_correlated{}, lobe::perfect_reflector{}};
    const microfacet dull{ggx{alpha{0.8}}, smith_correlated{}, lobe::perfect_reflector{}};
    const sum both{weighted{0.7, sharp}, weighted{0.3, dull}};
    for (double mu : {0.05, 0.5, 1.0})
        CHECK(lobe::directional_albedo(both, mu).value ==
              Catch::Approx(0.7 * lobe::directional_albedo(sharp, mu) + 0.3 * lobe::directional_albedo(dull, mu))
                  .epsilon(1e-9));
    CHECK(aborts([] { (void)weighted{-0.1, lambert{0.5}}; }));
}

TEST_CASE("a grey lobe beside colours gives what its colour would to the bit", "[layered]") {
    using V = vec3<float>;
    const V base{0.8F, 0.4F, 0.2F};
    const auto with = [&](const auto& F0, const auto& weight_of_second) {
        const schlick F{F0};
        const microfacet lobe{ggx{alpha{0.3F}}, smith_correlated{}, F};
        return sum{layered{lobe, lambert{base}, lobe::fresnel_coupling{F}}, weighted{weight_of_second, lobe}};
    };
    const auto grey = with(0.04F, 0.5F);
    const auto coloured = with(V(0.04F), 0.5F);
    static_assert(std::same_as<decltype(grey)::spectrum, V>);
    static_assert(std::same_as<decltype(coloured)::spectrum, V>);
    random_numbers random(11);
    for (int i = 0; i < 2000; ++i) {
        const V v = random.grazing_direction<float>(1e-3), l = random.grazing_direction<float>(1e-3);
        const auto e = grey.evaluate(v, l), same = coloured.evaluate(v, l);
        REQUIRE(e.f_cos == same.f_cos);
        REQUIRE(e.pdf == Catch::Approx(same.pdf).epsilon(1e-6));  // the mean of three is rounded
        REQUIRE(grey.f(v, l) == coloured.f(v, l));
        const auto s = grey.sample(v, {random(), random()});
        if (s.pdf > 1e-20F) REQUIRE(s.weight.x == Catch::Approx(grey.f_cos(v, s.l).x / s.pdf).epsilon(1e-3));
    }
    CHECK(lobe::directional_albedo(grey, 0.5F).value == lobe::directional_albedo(coloured, 0.5F).value);
    CHECK(lobe::average_albedo(grey).value == lobe::average_albedo(coloured).value);

    // a grey base under a coloured metal's share, and colours under a grey one
    const layered under{microfacet{ggx{alpha{0.3F}}, smith_correlated{}, schlick{base}}, lambert{0.5F},
                        lobe::fresnel_coupling{schlick{base}}};
    const layered same{microfacet{ggx{alpha{0.3F}}, smith_correlated{}, schlick{base}}, lambert{V(0.5F)},
                       lobe::fresnel_coupling{schlick{base}}};
    const V v = lobe::normalize(V{0.3F, 0.1F, 0.6F}), l = lobe::normalize(V{-0.2F, 0.5F, 0.4F});
    CHECK(under.f(v, l) == same.f(v, l));
    CHECK(under.albedo_estimate(v) == same.albedo_estimate(v));
}

TEST_CASE("compositions: below the horizon all is zero, and nothing is ever NaN", "[layered]") {
    const vec3<float> colour{1, 0.5f, 0};
    const auto E = [](float mu) { return vec3<float>{0.04f, 0.1f, 0.2f} + (1 - mu) * 0.3f; };
    const microfacet lobe{ggx{alpha{0.01f}}, smith_correlated{}, schlick{vec3<float>{0.04f, 0.1f, 0.2f}}};
    const float tiny = 1e-6f, wide = std::sqrt(1 - tiny * tiny);
    const vec3<float> directions[] = {
        {0, 0, 1},  {0, 0, -1},       {1, 0, 0},       {-1, 0, 0},       {0.6f, 0, 0.8f},      {-0.6f, 0, -0.8f},
        {0, -1, 0}, {0.6f, 0, -0.8f}, {wide, 0, tiny}, {-wide, 0, tiny}, {0, wide, 0x1p-120f}, {-0.6f, 0, 0.8f}};
    int bad = 0;
    const auto verify = [&](const auto& b) {
        for (const auto& v : directions) {
            for (const auto& l : directions) {
                const bool above = v.z > 0 && l.z > 0;
                const auto e = b.evaluate(v, l);
                for (const auto value : {b.f(v, l), b.f_cos(v, l), e.f_cos, vec3<float>{b.pdf(v, l), e.pdf, 0}})
                    for (const float c : {value.x, value.y, value.z}) bad += above ? !(c >= 0) : c != 0;
            }
            for (const float x : {0.0f, 0.3f, 0.8f, 1 - 0x1p-24f}) {
                const auto s = b.sample(v, {x, 0.4f});
                for (const float c : {s.pdf, s.weight.x, s.weight.y, s.weight.z})
                    bad += s.pdf > 0 ? !(c >= 0) || v.z <= 0 : c != 0;
                if (!(s.pdf > 0)) bad += s.l != vec3<float>(0, 0, 1);
            }
        }
    };
    verify(layered{lobe, lambert{colour}, lobe::fresnel_coupling{schlick{vec3<float>{0.04f}}}});
    verify(layered{lobe, lambert{colour}, lobe::albedo_coupling{E}});
    verify(layered{lobe, lambert{colour}, lobe::reciprocal_coupling{E, vec3<float>{0.1f, 0.2f, 0.3f}}});
    verify(lobe::metallic_roughness(colour, 0.5f, 0.0f, 1e-4f));
    verify(lobe::coated(lobe::metallic_roughness(colour, 0.5f, alpha{0.3f}), ggx{alpha{0.01f}}, 1.0f));
    verify(sum{weighted{0.5f, lobe}, weighted{0.0f, lobe}});
    CHECK(bad == 0);
}

TEST_CASE("compositions on packs: lane by lane what one number gives", "[layered]") {
    using pack = xsimd::batch<double>;
    const auto coated = [](const auto& half, const auto& a) {
        return lobe::coated(lobe::metallic_roughness(half, half, alpha{a}), ggx{alpha{a * half}}, half);
    };
    const auto wide = coated(pack(0.5), pack(0.3));
    const auto narrow = coated(0.5, 0.3);
    random_numbers random(41);
    double worst = 0;
    for (int i = 0; i < 500; ++i) {
        double in[5][pack::size];
        for (std::size_t lane = 0; lane < pack::size; ++lane) {
            const auto v = random.direction();  // half of them below the horizon
            const double values[] = {v.x, v.y, v.z, random(), random()};
            for (int k = 0; k < 5; ++k) in[k][lane] = values[k];
        }
        const auto load = [&](int k) { return pack::load_unaligned(in[k]); };
        const vec3<pack> v{load(0), load(1), load(2)};
        const auto s = wide.sample(v, vec2<pack>{load(3), load(4)});
        const auto e = wide.evaluate(v, s.l);
        for (std::size_t lane = 0; lane < pack::size; ++lane) {
            const vec3<double> vi{in[0][lane], in[1][lane], in[2][lane]};
            const auto one = narrow.sample(vi, {in[3][lane], in[4][lane]});
            const auto at = narrow.evaluate(vi, one.l);
            worst = larger({worst, std::abs(s.l.x.get(lane) - one.l.x), std::abs(s.weight.get(lane) - one.weight),
                            std::abs(s.pdf.get(lane) - one.pdf), std::abs(e.pdf.get(lane) - at.pdf),
                            std::abs(e.f_cos.get(lane) - at.f_cos)});
        }
    }
    CHECK(worst < 1e-11);  // rounding, times the slope of a lobe of alpha 0.15: pdf up to 14
}

namespace {

struct unsampled {
    using scalar = double;
    using spectrum = double;
    static constexpr bool isotropic = true;
    double f(const vec3<double>&, const vec3<double>&) const { return 1; }
    double f_cos(const vec3<double>&, const vec3<double>& l) const { return l.z; }
    vec2<double> width() const { return {1, 1}; }
};

}  // namespace

TEST_CASE("a composition takes no more room than its parts", "[layered]") {
    const auto gltf = lobe::metallic_roughness(vec3<float>{0.5f}, 0.0f, alpha{0.3f});
    static_assert(sizeof(microfacet{ggx{alpha{0.3f}}, smith_correlated{}, schlick{vec3<float>{0.5f}}}) == 16);
    // lobe, base, the coupling's own F, a word that keeps the sum and a lobe apart
    static_assert(sizeof(gltf) <= 16 + 12 + 12 + 4);
    CHECK(gltf.width() == vec2<float>{0.3f, 0.3f});
    // parts that cannot be sampled make a sum that cannot, and says so
    static_assert(lobe::brdf<sum<unsampled, lambert<double>>> &&
                  !lobe::samplable_brdf<sum<unsampled, lambert<double>>>);
    static_assert(lobe::samplable_brdf<decltype(gltf)>);
}
