#include "catch.hpp"
#include "support.hpp"

#include <lobe/brdf/lambert.hpp>
#include <lobe/brdf/microfacet.hpp>
#include <lobe/brdf/sum.hpp>
#include <lobe/energy/albedo.hpp>
#include <lobe/energy/random_walk.hpp>
#include <lobe/fresnel/schlick.hpp>
#include <lobe/fresnel/schlick_gaussian.hpp>
#include <lobe/fresnel/schlick_roughness.hpp>
#include <lobe/ndf/ggx.hpp>
#include <lobe/sampling/points.hpp>

using lobe::alpha;
using lobe::alpha_xy;
using lobe::ggx;
using lobe::microfacet;
using lobe::schlick;
using lobe::smith_correlated;
using lobe::smith_separable;
using lobe::vec2;
using lobe::vec3;

namespace {

constexpr double pi = 3.141592653589793;

/// The equation as papers print it, on a normalised half vector, in long double: an independent transcription.
long double printed_f(long double ax, long double ay, long double f0, bool correlated, const vec3<double>& v,
                      const vec3<double>& l) {
    using real = long double;
    const real sx = real(v.x) + real(l.x), sy = real(v.y) + real(l.y), sz = real(v.z) + real(l.z),
               s = std::sqrt(sx * sx + sy * sy + sz * sz);
    const real hx = sx / s, hy = sy / s, hz = sz / s, vh = hx * real(v.x) + hy * real(v.y) + hz * real(v.z);
    const real t = (hx / ax) * (hx / ax) + (hy / ay) * (hy / ay) + hz * hz;
    const real D = 1 / (3.14159265358979323846264338L * ax * ay * t * t);
    const auto Lambda = [&](const vec3<double>& w) {
        return (std::sqrt(1 + (ax * ax * real(w.x) * real(w.x) + ay * ay * real(w.y) * real(w.y)) /
                                  (real(w.z) * real(w.z))) -
                1) /
               2;
    };
    const real G = correlated ? 1 / (1 + Lambda(v) + Lambda(l)) : 1 / ((1 + Lambda(v)) * (1 + Lambda(l)));
    const real F = f0 + (1 - f0) * std::pow(1 - vh, real(5));
    return F * D * G / (4 * real(v.z) * real(l.z));
}

template <class B>
double worst_reciprocity(const B& brdf, std::uint64_t seed) {
    using T = typename B::scalar;
    random_numbers random(seed);
    double worst = 0;
    for (int i = 0; i < 100000; ++i) {
        const auto v = random.grazing_direction<T>(1e-3), l = random.grazing_direction<T>(1e-3);
        worst = larger(worst, static_cast<double>(std::abs(brdf.f(v, l) / brdf.f(l, v) - 1)));
    }
    return worst;
}

}  // namespace

TEST_CASE("f is the printed equation", "[microfacet]") {
    random_numbers random(1);
    double worst = 0;
    for (int i = 0; i < 20000; ++i) {
        const double ax = random.log_between(1e-3, 1), ay = random.log_between(1e-3, 1), f0 = random();
        const vec3<double> v = random.grazing_direction(1e-3), l = random.grazing_direction(1e-3);
        const microfacet correlated{ggx{alpha_xy{ax, ay}}, smith_correlated{}, schlick{f0}};
        const microfacet separable{ggx{alpha_xy{ax, ay}}, smith_separable{}, schlick{f0}};
        worst =
            larger(worst, std::abs(correlated.f(v, l) / static_cast<double>(printed_f(ax, ay, f0, true, v, l)) - 1));
        worst =
            larger(worst, std::abs(separable.f(v, l) / static_cast<double>(printed_f(ax, ay, f0, false, v, l)) - 1));
        CHECK(std::abs(correlated.f_cos(v, l) / (correlated.f(v, l) * l.z) - 1) < 1e-15);
    }
    // Both sides read v and l as given, whose rounding makes them 1e-16 off unit length; the printed v.h feels that
    // 1/(v.h) times over.
    INFO(worst);
    CHECK(worst < 1e-12);
}

TEST_CASE("masking: the orders and limits of G", "[microfacet]") {
    random_numbers random(2);
    const ggx ndf{alpha_xy{0.3, 0.7}};
    for (int i = 0; i < 10000; ++i) {
        const vec3<double> v = random.grazing_direction(1e-6), l = random.grazing_direction(1e-6);
        const double separable = smith_separable{}.G2(ndf, v, l), correlated = smith_correlated{}.G2(ndf, v, l);
        const double g1v = smith_correlated{}.G1(ndf, v), g1l = smith_correlated{}.G1(ndf, l), slack = 1e-15;
        CHECK(separable == Catch::Approx(g1v * g1l));
        CHECK(separable <= correlated * (1 + slack));
        CHECK(correlated <= std::min(g1v, g1l) * (1 + slack));
        CHECK(g1v == Catch::Approx(1 / (1 + ndf.lambda(v))));
        CHECK(correlated == Catch::Approx(1 / (1 + ndf.lambda(v) + ndf.lambda(l))));
        CHECK(smith_correlated{}.visibility(ndf, v, l) == Catch::Approx(correlated / (4 * v.z * l.z)));
    }
    const vec3<double> n{0, 0, 1};
    CHECK(smith_correlated{}.G2(ndf, n, n) == 1);
    CHECK(smith_separable{}.G2(ndf, n, n) == 1);
}

TEST_CASE("Schlick's Fresnel: ends, middle, average", "[fresnel]") {
    const schlick f{0.04};
    CHECK(f(1.0) == 0.04);
    CHECK(f(0.0) == 1);
    CHECK(f(0.5) == Catch::Approx(0.04 + 0.96 / 32));  // 0.970 if the power is misplaced
    CHECK(f(0.9) == Catch::Approx(0.0400096));
    CHECK(f.average() == Catch::Approx(0.0857142857142857));
    const schlick dim{vec3<double>{0.5, 0.3, 0.1}, vec3<double>{0.9, 0.8, 0.7}};
    const lobe::gauss_legendre<double> rule(8);  // exact: a polynomial of degree 6
    vec3<double> average(0);
    for (std::size_t i = 0; i < rule.x.size(); ++i) average += 2 * rule.w[i] * rule.x[i] * dim(rule.x[i]);
    CHECK(lobe::length(average - dim.average()) < 1e-15);
    CHECK(aborts([] { (void)schlick(1.5); }));
    CHECK(aborts([] { (void)schlick(vec3<float>{0.5f, -0.1f, 0.5f}); }));
    CHECK(aborts([] { (void)schlick(std::numeric_limits<float>::quiet_NaN()); }));
}

TEST_CASE("f is reciprocal to rounding", "[microfacet]") {
    for (double a : {0.01, 0.1, 1.0}) {
        CHECK(worst_reciprocity(microfacet{ggx{alpha{a}}, smith_correlated{}, schlick{0.5}}, 3) < 16 * 1.1e-16);
        CHECK(worst_reciprocity(microfacet{ggx{alpha_xy{a, 0.3}}, smith_separable{}, schlick{0.5}}, 4) < 16 * 1.1e-16);
        CHECK(worst_reciprocity(microfacet{ggx{alpha{static_cast<float>(a)}}, smith_correlated{}, schlick{0.5f}}, 5) <
              16 * 6e-8);
    }
}

TEST_CASE("below the horizon all is zero, and nothing is ever NaN", "[microfacet]") {
    const microfacet brdf{ggx{alpha{0.01f}}, smith_correlated{}, schlick{vec3<float>{1, 0.5f, 0}}};
    const lobe::lambert diffuse{vec3<float>{0.5f}};
    const float tiny = 1e-6f, wide = std::sqrt(1 - tiny * tiny);
    const vec3<float> directions[] = {
        {0, 0, 1},  {0, 0, -1},       {1, 0, 0},       {-1, 0, 0},       {0.6f, 0, 0.8f},      {-0.6f, 0, -0.8f},
        {0, -1, 0}, {0.6f, 0, -0.8f}, {wide, 0, tiny}, {-wide, 0, tiny}, {0, wide, 0x1p-120f}, {-0.6f, 0, 0.8f}};
    for (const auto& v : directions)
        for (const auto& l : directions) {
            const bool above = v.z > 0 && l.z > 0;
            INFO(v.x << ' ' << v.y << ' ' << v.z << "  " << l.x << ' ' << l.y << ' ' << l.z);
            const auto check = [&](const auto& b) {
                for (const auto value : {b.f(v, l), b.f_cos(v, l), b.evaluate(v, l).f_cos})
                    for (const float c : {value.x, value.y, value.z}) {
                        CHECK(c >= 0);  // so no NaN
                        if (!above) CHECK(c == 0);
                    }
                for (const float pdf : {b.pdf(v, l), b.evaluate(v, l).pdf}) {
                    CHECK(pdf >= 0);
                    if (!above) CHECK(pdf == 0);
                }
            };
            check(brdf);
            check(diffuse);
        }
}

TEST_CASE("a failed sample has pdf 0, weight 0 and l = n", "[microfacet]") {
    const microfacet brdf{ggx{alpha{1.0f}}, smith_correlated{}, schlick{vec3<float>{1, 0.5f, 0}}};
    const vec3<float> v = lobe::normalize(vec3<float>{1, 0, 0.1f});
    int failed = 0;
    for (std::uint32_t i = 0; i < 1000; ++i) {
        const auto s = brdf.sample(v, lobe::hammersley(i, 1000));
        if (s.pdf > 0) continue;
        ++failed;
        CHECK(s.weight == vec3<float>(0));
        CHECK(s.l == vec3<float>(0, 0, 1));
    }
    CHECK(failed > 0);
    for (const vec3<float>& under : {vec3<float>{0.6f, 0, -0.8f}, vec3<float>{0, 0, -1}}) {
        const auto below = brdf.sample(under, {0.3f, 0.3f});
        CHECK(below.pdf == 0);
        CHECK(below.weight == vec3<float>(0));
        CHECK(below.l == vec3<float>(0, 0, 1));
    }
}

TEST_CASE("a reflectance is never negative, though rounding takes v.m above 1", "[microfacet]") {
    const microfacet black{ggx{alpha{0.5f}}, smith_correlated{}, schlick{0.0f}};
    random_numbers random(9);
    float least = 1;
    for (int i = 0; i < 100000; ++i) {
        const auto v = random.grazing_direction<float>(1e-3);
        least = smaller(least, smaller(black.f_cos(v, v), black.sample(v, {0, 0}).weight));
    }
    CHECK(least >= 0);
}

namespace {

/// weight * pdf = f_cos, pdf(v, sample.l) = sample.pdf, evaluate = (f_cos, pdf), E[weight] = albedo, int pdf = success
/// rate.
template <class B>
void expect_consistent_sampling(const B& brdf, const vec3<double>& v, std::uint32_t count, double tolerance) {
    double mean_weight = 0, success = 0, worst = 0, shared = 0;
    for (std::uint32_t i = 0; i < count; ++i) {
        const auto s = brdf.sample(v, lobe::hammersley<double>(i, count));
        mean_weight += s.weight / count;
        if (s.pdf == 0) continue;
        success += 1.0 / count;
        const auto e = brdf.evaluate(v, s.l);
        shared = larger({shared, std::abs(e.pdf / brdf.pdf(v, s.l) - 1), std::abs(e.f_cos / brdf.f_cos(v, s.l) - 1)});
        worst = larger({worst, std::abs(s.weight * s.pdf / e.f_cos - 1), std::abs(s.pdf / e.pdf - 1)});
    }
    const auto albedo = lobe::directional_albedo(brdf, v);
    const auto pdf =
        lobe::hemisphere_integral([&](const vec3<double>& l) { return brdf.pdf(v, l); }, v, brdf.width(), false);
    INFO("mean weight " << mean_weight << " albedo " << albedo.value << "; pdf integrates to " << pdf.value
                        << ", successes " << success);
    CHECK(std::abs(mean_weight - albedo.value) < tolerance);
    CHECK(std::abs(success - pdf.value) < tolerance);
    CHECK(pdf.value <= 1 + 1e-9);
    CHECK(shared < 1e-14);
    CHECK(worst < 1e-8);  // s.l is known to 1e-16 in all, its half vector to 1e-16/alpha in slopes
}

}  // namespace

TEST_CASE("samples follow their density and weights add up to the albedo", "[microfacet]") {
    // 2^18 Hammersley points: their discrepancy is below (18/3 + 19/9)/n = 3.1e-5 (De Clerck 1986), times a
    // variation of about 3: weights are at most 1.
    for (double a : {0.001, 0.05, 0.5, 1.0})
        for (double mu : {0.05, 0.5, 1.0}) {
            INFO("alpha " << a << " mu " << mu);
            const vec3<double> v{std::sqrt((1 - mu) * (1 + mu)) * 0.6, std::sqrt((1 - mu) * (1 + mu)) * 0.8, mu};
            expect_consistent_sampling(microfacet{ggx{alpha{a}}, smith_correlated{}, schlick{0.5}}, v, 1u << 18, 1e-4);
            expect_consistent_sampling(microfacet{ggx{alpha_xy{a, 0.3}}, smith_separable{}, schlick{0.5}}, v, 1u << 18,
                                       1e-4);
            expect_consistent_sampling(microfacet{ggx{alpha_xy{0.3, a}}, smith_correlated{}, schlick{0.5}}, v, 1u << 18,
                                       1e-4);
            // all normals: heavy-tailed weights at grazing angles (up to 56 at mu = 0.05), so only away from them
            if (mu >= 0.5)
                expect_consistent_sampling(
                    microfacet{ggx{alpha{a}}, smith_correlated{}, schlick{0.5}, lobe::all_normals{}}, v, 1u << 18,
                    5e-4);
        }
    expect_consistent_sampling(lobe::lambert{0.7}, vec3<double>{0.6, 0, 0.8}, 1u << 10, 1e-12);
}

TEST_CASE("the success rate of visible normals is below 1 where facets reflect downwards", "[microfacet]") {
    const microfacet rough{ggx{alpha{1.0}}, smith_correlated{}, schlick{0.5}};
    const vec3<double> v{std::sqrt(0.75), 0, 0.5};
    const auto pdf =
        lobe::hemisphere_integral([&](const vec3<double>& l) { return rough.pdf(v, l); }, v, rough.width(), true);
    CHECK(pdf.value == Catch::Approx(2.0 / 3).epsilon(1e-6));  // rejection 0.333 at mu = 0.5, alpha = 1
}

TEST_CASE("the pdf of reflected visible normals integrates to 1 where none is lost", "[microfacet]") {
    const microfacet smooth{ggx{alpha{0.001}}, smith_correlated{}, schlick{0.5}};
    const auto pdf = lobe::hemisphere_integral(
        [&](const vec3<double>& l) {
            return smooth.pdf({0.6, 0, 0.8}, l);
        },
        vec3<double>{0.6, 0, 0.8}, smooth.width(), true);
    CHECK(std::abs(pdf.value - 1) < 2e-6);
}

TEST_CASE("Lambert and sums", "[microfacet]") {
    const vec3<double> v{0.6, 0, 0.8}, l{0, 0.8, 0.6};
    const lobe::lambert diffuse{0.5};
    CHECK(diffuse.f(v, l) == Catch::Approx(0.5 / pi));
    CHECK(diffuse.f_cos(v, l) == Catch::Approx(0.3 / pi));
    CHECK(diffuse.sample(v, {0.3, 0.4}).weight == 0.5);
    const microfacet gloss{ggx{alpha{0.1}}, smith_correlated{}, schlick{0.04}};
    const lobe::sum both{gloss, lobe::weighted{0.9, diffuse}};
    CHECK(both.f(v, l) == Catch::Approx(gloss.f(v, l) + 0.9 * diffuse.f(v, l)));
    CHECK(both.f_cos(v, l) == Catch::Approx(both.f(v, l) * l.z));
    CHECK(both.width() == vec2<double>{0.1, 0.1});
    static_assert(lobe::brdf<decltype(both)>);
    static_assert(both.isotropic);
}

TEST_CASE("v and l antiparallel, down to the smallest cosines", "[microfacet]") {
    const auto finite = [](auto smallest, auto a) {
        using T = decltype(a);
        const microfacet brdf{ggx{alpha{a}}, smith_correlated{}, schlick{T(0.04)}};
        int bad = 0;
        for (T z = smallest; z < T(1e-3); z *= T(7))
            for (const vec3<T>& v : {vec3<T>{1, 0, z}, vec3<T>{T(0.6), T(-0.8), z}}) {
                const vec3<T> l{-v.x, -v.y, z};
                const auto e = brdf.evaluate(v, l);
                for (const T x : {brdf.f(v, l), brdf.f_cos(v, l), brdf.pdf(v, l), e.f_cos, e.pdf})
                    bad += !(x >= 0 && std::isfinite(x));
            }
        return bad;
    };
    for (double a : {1e-4, 1e-2, 0.3, 1.0}) {
        CHECK(finite(1e-18f, static_cast<float>(a)) == 0);
        CHECK(finite(1e-150, a) == 0);
    }
}

TEST_CASE("a reflectance of another precision is none", "[microfacet]") {
    static_assert(lobe::fresnel<schlick<float>, float> && !lobe::fresnel<schlick<float>, double> &&
                  !lobe::fresnel<schlick<double>, float>);
    static_assert(!lobe::fresnel<schlick<vec3<float>>, double> &&
                  !lobe::fresnel<lobe::schlick_gaussian<vec3<float>>, double>);
    static_assert(!lobe::fresnel<lobe::schlick_roughness<float>, double> &&
                  !lobe::fresnel<lobe::perfect_reflector<float>, double>);
    static_assert(lobe::fresnel<lobe::perfect_reflector<>, double> && lobe::fresnel<lobe::perfect_reflector<>, float>);
    static_assert(std::same_as<decltype(lobe::perfect_reflector<vec3<float>>{}.average()), vec3<float>>);
    CHECK(lobe::perfect_reflector<vec3<float>>{}(0.3f) == vec3<float>(1));
}

namespace {

/// A spectrum of the user's own: five bands.
struct bands {
    double value[5];
    explicit bands(double x) : value{x, x, x, x, x} {}
    friend bands operator+(bands a, const bands& b) {
        for (int i = 0; i < 5; ++i) a.value[i] += b.value[i];
        return a;
    }
    friend bands operator-(bands a, const bands& b) {
        for (int i = 0; i < 5; ++i) a.value[i] -= b.value[i];
        return a;
    }
    friend bands operator*(bands a, const bands& b) {
        for (int i = 0; i < 5; ++i) a.value[i] *= b.value[i];
        return a;
    }
    friend bands operator*(bands a, double x) {
        for (double& y : a.value) y *= x;
        return a;
    }
};

}  // namespace

TEST_CASE("a spectrum may be the user's own type", "[microfacet]") {
    bands f0(0.04);
    f0.value[2] = 0.5;
    const microfacet brdf{ggx{alpha{0.3}}, smith_correlated{}, schlick{f0}};
    const microfacet band{ggx{alpha{0.3}}, smith_correlated{}, schlick{0.5}};
    const vec3<double> v{0.6, 0, 0.8}, l{0, 0.8, 0.6};
    CHECK(brdf.f_cos(v, l).value[2] == band.f_cos(v, l));
    CHECK(brdf.sample(v, {0.3, 0.4}).weight.value[2] == band.sample(v, {0.3, 0.4}).weight);
    CHECK((f0 * f0).value[2] == 0.25);
    random_numbers random(8), again(8);
    for (int i = 0; i < 100; ++i)
        CHECK(lobe::random_walk{ggx{alpha{0.9}}, schlick{f0}}.sample(v, random).weight.value[2] ==
              lobe::random_walk{ggx{alpha{0.9}}, schlick{0.5}}.sample(v, again).weight);
}
