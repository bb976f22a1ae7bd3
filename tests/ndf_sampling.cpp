// Samples of distributions of normals: their density, and the BRDFs that draw them. (Histograms: chi_squared.cpp.)
#include "catch.hpp"
#include "ndf_support.hpp"

#include <lobe/brdf/microfacet.hpp>
#include <lobe/energy/albedo.hpp>
#include <lobe/fresnel/schlick.hpp>
#include <lobe/sampling/points.hpp>

using lobe::alpha;
using lobe::alpha_xy;
using lobe::vec2;
using lobe::vec3;

namespace {

/// pdf * |d m / d u| - 1, worst over random u away from what is not smooth: the edges of the square, and the u.x in
/// `kinks`.
template <class Map, class Pdf>
double jacobian_error(Map map, Pdf pdf, std::uint64_t seed, int count, std::vector<double> kinks = {}) {
    random_numbers random(seed);
    double worst = 0;
    for (int k = 0; k < count; ++k) {
        const vec2<double> u{random.between(0.01, 0.99), random.between(0.01, 0.99)};
        bool smooth = true;
        for (double x : kinks) smooth = smooth && std::abs(u.x - x) > 0.01;
        if (!smooth) continue;
        worst = larger(worst, std::abs(pdf(map(u)) * jacobian(map, u) - 1));
    }
    return worst;
}

/// The share of visible normals less steep than the cotangent of v, all at unit width: there the CDF of u.x has a kink.
template <class N>
double share_below_cotangent(const N& ndf, double ax, double ay, const vec3<double>& v) {
    const double px = ax * v.x, py = ay * v.y, cot = std::abs(v.z) / std::hypot(px, py);
    double low = 0, high = 1;
    for (int i = 0; i < 40; ++i) {
        const double x = (low + high) / 2;
        const vec3<double> m = ndf.sample_visible(v, {x, 0.3});
        (std::hypot(m.x / ax, m.y / ay) < cot * m.z ? low : high) = x;
    }
    return low;
}

/// E[weight] = albedo <= 1 by an independent integral, and weight * pdf = f_cos.
template <class B>
void expect_energy(const B& brdf, const vec3<double>& v, std::uint32_t count, double tolerance, bool conserves = true) {
    double mean = 0, worst = 0;
    for (std::uint32_t i = 0; i < count; ++i) {
        const auto s = brdf.sample(v, lobe::hammersley<double>(i, count));
        mean += s.weight / count;
        if (s.pdf > 0) worst = larger(worst, std::abs(s.weight * s.pdf / brdf.f_cos(v, s.l) - 1));
    }
    const auto albedo = lobe::directional_albedo(brdf, v);
    INFO("mean weight " << mean << ", albedo " << albedo.value << " +- " << albedo.error);
    CHECK(std::abs(mean - albedo.value) < tolerance);
    if (conserves) CHECK(albedo.value <= 1 + 1e-6);
    CHECK(worst < 1e-7);  // the half vector is known to 1e-16/alpha in slopes, and D falls like an exponential
}

}  // namespace

TEST_CASE("samples of all normals have the density they state", "[ndf]") {
    for (double a : {0.001, 0.1, 1.0}) {
        every_isotropic(a, [&](const std::string& name, const auto& ndf, double) {
            INFO(name << ' ' << a);
            const std::vector<double> kinks = name == "mixture" ? std::vector<double>{0.7} : std::vector<double>{};
            CHECK(jacobian_error([&](vec2<double> u) { return ndf.sample(u); },
                                 [&](vec3<double> m) { return ndf.pdf(m); }, 1, 100, kinks) ==
                  // a mixture covers the sphere twice: see chi-squared
                  Catch::Approx(0).margin(name == "mixture" ? 1e300 : 1e-6));
        });
        every_anisotropic(a, 0.3, [&](const std::string& name, const auto& ndf, double) {
            INFO(name << ' ' << a << ", 0.3");
            if (name != "mixture")
                CHECK(jacobian_error([&](vec2<double> u) { return ndf.sample(u); },
                                     [&](vec3<double> m) { return ndf.pdf(m); }, 2, 100) < 1e-6);
        });
    }
}

TEST_CASE("samples of visible normals have the density they state", "[ndf]") {
    random_numbers random(3);
    const auto compare = [&](const auto& ndf, double ax, double ay, int count) {
        // 0.0017: 89.9 degrees; from below the horizon, as the random walk does
        for (double z : {0.9, 0.3, 0.0017, -0.2}) {
            const double phi = random.between(0, 6), s = std::sqrt((1 - z) * (1 + z));
            const vec3<double> v{s * std::cos(phi), s * std::sin(phi), z};
            if (z < 0 && ndf.projected_area(v) < 1e-6) continue;
            INFO("z " << z);
            const double kink = share_below_cotangent(ndf, ax, ay, v);
            CHECK(jacobian_error([&](vec2<double> u) { return ndf.sample_visible(v, u); },
                                 [&](vec3<double> m) { return ndf.pdf_visible(v, m); }, 4, count, {kink}) < 1e-6);
        }
    };
    for (double a : {0.001, 0.1, 0.7, 1.0}) {
        INFO("alpha " << a);
        compare(lobe::beckmann{alpha{a}}, a, a, 200);
        compare(lobe::beckmann{alpha_xy{a, 0.3}}, a, 0.3, 200);
        compare(lobe::student_t{alpha{a}, 1.75}, a, a, 20);
        compare(lobe::student_t{alpha_xy{a, 0.3}, 4.0}, a, 0.3, 20);
        compare(lobe::hyper_cauchy{alpha_xy{a, 0.3}, 2.5}, a / std::sqrt(1.5), 0.3 / std::sqrt(1.5), 20);
        compare(lobe::blinn_phong{alpha{a}}, a, a, 20);
        compare(lobe::tabulated{lobe::exponential_power{alpha{a}, 0.5}}, a, a, 20);
        compare(lobe::tabulated{lobe::exponential_power{alpha_xy{a, 0.3}, 2.0}}, a, 0.3, 20);
        compare(lobe::tabulated{lobe::gtr{alpha{a}, 1.0}}, a, a, 20);
        compare(lobe::tabulated{lobe::gtr{alpha{a}, 3.0}}, a, a, 20);
        compare(lobe::tabulated{lobe::abc{alpha{a}, 1.5}}, a, a, 20);
        compare(lobe::tabulated{lobe::sgd{alpha{a}, 1.5}}, a, a, 20);
        compare(lobe::tabulated{lobe::phong{alpha{a}}}, a, a, 20);
    }
    // SGGX, from anywhere
    for (int i = 0; i < 20; ++i) {
        const lobe::sggx flakes{
            lobe::frame<double>(random.direction()),
            vec3<double>{random.log_between(0.05, 1), random.log_between(0.05, 1), random.log_between(0.05, 1)}};
        const vec3<double> v = random.direction();
        CHECK(jacobian_error([&](vec2<double> u) { return flakes.sample_visible(v, u); },
                             [&](vec3<double> m) { return flakes.pdf_visible(v, m); }, 5, 100) < 1e-6);
    }
}

TEST_CASE("samples at the corners of the square are unit and face the viewer", "[ndf]") {
    const float last = 0x1.fffffep-1f;
    const auto expect_sound = [&](const auto& ndf) {
        for (float z : {1.0f, 0.5f, 1e-3f, 1e-6f})
            for (float x : {0.0f, 1e-30f, 1e-7f, 0.5f, last})
                for (float y : {0.0f, 1e-7f, 0.3f, last}) {
                    const vec3<float> v{std::sqrt((1 - z) * (1 + z)), 0, z}, m = ndf.sample_visible(v, {x, y}),
                                                                             all = ndf.sample({x, y});
                    INFO(z << ' ' << x << ' ' << y);
                    CHECK(std::abs(lobe::length(m) - 1) < 3e-7f);
                    CHECK(std::abs(lobe::length(all) - 1) < 3e-7f);
                    CHECK((m.z >= 0 && all.z >= 0));
                    CHECK(lobe::dot(v, m) >= -1e-6f);
                }
    };
    for (float a : {1e-4f, 0.1f, 1.0f}) {
        INFO("alpha " << a);
        expect_sound(lobe::beckmann{alpha{a}});
        expect_sound(lobe::student_t{alpha{a}, 1.75f});
        expect_sound(lobe::blinn_phong{alpha{std::max(a, 0.001f)}});
        expect_sound(lobe::tabulated{lobe::exponential_power{alpha{a}, 0.5f}});
        expect_sound(lobe::tabulated{lobe::exponential_power{alpha{a}, 3.0f}});
        expect_sound(lobe::tabulated{lobe::gtr{alpha{a}, 1.0f}});
        expect_sound(lobe::tabulated{lobe::gtr{alpha{a}, 4.0f}});
        expect_sound(lobe::tabulated{lobe::abc{alpha{a}, 0.7f}});
        expect_sound(lobe::tabulated{lobe::sgd{alpha{a}, 2.0f}});
        expect_sound(lobe::tabulated{lobe::phong{alpha{a}}});
        expect_sound(lobe::mixture{lobe::ggx{alpha{a}}, lobe::beckmann{alpha{a}}, 0.5f});
    }
}

TEST_CASE("a microfacet of any distribution returns at most what it receives, and its samples add up to it", "[ndf]") {
    const auto direction = [](double mu) {
        const double s = std::sqrt((1 - mu) * (1 + mu));
        return vec3<double>{0.6 * s, 0.8 * s, mu};
    };
    const auto with = [](const auto& ndf) {
        return lobe::microfacet{ndf, lobe::smith_correlated{}, lobe::perfect_reflector{}};
    };
    const auto all_of = [](const auto& ndf) {
        return lobe::microfacet{ndf, lobe::smith_correlated{}, lobe::perfect_reflector{}, lobe::all_normals{}};
    };
    for (double a : {0.1, 0.5})
        for (double mu : {0.1, 0.6}) {
            INFO("alpha " << a << " mu " << mu);
            const vec3<double> v = direction(mu);
            // 2^16 Hammersley points for closed samplers, 2^11 for numeric ones: the error of a smooth integrand is of
            // order log(n)/n, 2e-4 and 4e-3, times its variation
            expect_energy(with(lobe::beckmann{alpha{a}}), v, 1u << 16, 3e-4);
            expect_energy(with(lobe::beckmann{alpha_xy{a, 0.3}}), v, 1u << 16, 3e-4);
            expect_energy(with(lobe::mixture{lobe::ggx{alpha{a}}, lobe::beckmann{alpha{a / 2}}, 0.3}), v, 1u << 16,
                          3e-4);
            expect_energy(with(lobe::student_t{alpha{a}, 3.0}), v, 1u << 11, 5e-3);
            expect_energy(with(lobe::hyper_cauchy{alpha_xy{a, 0.3}, 3.0}), v, 1u << 11, 5e-3);
            expect_energy(with(lobe::tabulated{lobe::exponential_power{alpha{a}, 0.5}}), v, 1u << 11, 5e-3);
            expect_energy(with(lobe::blinn_phong{alpha{a}}), v, 1u << 11, 5e-3);
            expect_energy(with(lobe::tabulated{lobe::gtr{alpha{a}, 1.0}}), v, 1u << 11, 5e-3);
            expect_energy(with(lobe::tabulated{lobe::abc{alpha{a}, 1.5}}), v, 1u << 11, 5e-3);
            expect_energy(with(lobe::tabulated{lobe::sgd{alpha{a}, 1.5}}), v, 1u << 11, 5e-3);
            expect_energy(with(lobe::tabulated{lobe::phong{alpha{a}}}), v, 1u << 11, 5e-3);
            // all normals: weights grow towards grazing angles
            if (mu > 0.5) {
                expect_energy(all_of(lobe::tabulated{lobe::gtr{alpha{a}, 1.0}}), v, 1u << 16, 2e-3);
                expect_energy(all_of(lobe::beckmann_walter{alpha{a}}), v, 1u << 16, 2e-3, false);
                expect_energy(all_of(lobe::masked_by{lobe::phong{alpha{a}}, lobe::ggx{alpha{a}}}), v, 1u << 16, 2e-3,
                              false);
                expect_energy(all_of(lobe::masked_by{lobe::blinn_phong{alpha{a}}, lobe::beckmann{alpha{a}}}), v,
                              1u << 16, 2e-3, false);
            }
        }
}

TEST_CASE("a mixture hands its parts numbers below 1", "[ndf]") {
    // (u - p)/(1 - p) rounds to 1 for many p; spherical caps then give a normal at the horizon
    int at_the_horizon = 0;
    for (int i = 1; i < 1000; ++i) {
        const lobe::mixture both{lobe::ggx{lobe::alpha{0.3f}}, lobe::ggx{lobe::alpha{0.9f}},
                                 static_cast<float>(i) / 1000.0f};
        if (!(both.sample_visible(lobe::vec3<float>{0.6f, 0.0f, 0.8f}, {0x1.fffffep-1f, 0.0f}).z > 0)) ++at_the_horizon;
    }
    CHECK(at_the_horizon == 0);
}
