// Samples of distributions of normals: their density, their histogram, and the BRDFs that draw them.
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

constexpr double pi = 3.141592653589793;

/// pdf * |d m / d u| - 1 by Richardson-extrapolated central differences, worst over random u. The error of the difference is
/// (h/distance)^6, h = 4e-4, to whatever is not smooth: the edges of the square, and the u.x in `kinks`.
template <class Map, class Pdf>
double jacobian_error(Map map, Pdf pdf, std::uint64_t seed, int count, std::vector<double> kinks = {}) {
    random_numbers random(seed);
    double worst = 0;
    for (int k = 0; k < count; ++k) {
        const vec2<double> u{random.between(0.01, 0.99), random.between(0.01, 0.99)};
        bool smooth = true;
        for (double x : kinks) smooth = smooth && std::abs(u.x - x) > 0.01;
        if (!smooth) continue;
        const auto derivative = [&](vec2<double> step) {
            const auto central = [&](double h) { return (map(u + h * step) - map(u - h * step)) / (2 * h); };
            const auto twice = [&](double h) { return (4.0 * central(h / 2) - central(h)) / 3.0; };
            return (16.0 * twice(2e-4) - twice(4e-4)) / 15.0;
        };
        const double area = lobe::length(lobe::cross(derivative({1, 0}), derivative({0, 1})));
        worst = std::max(worst, std::abs(pdf(map(u)) * area - 1));
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

/// Chi-squared of 1e6 samples over cells of slopes: 20 rings of r/(1+r), 16 azimuths, the density integrated over each by 12 x 12
/// Gauss points. Returns the chance that a right sampler is further off (Wilson & Hilferty).
template <class Sample, class Pdf>
double chi_squared_chance(Sample sample, Pdf pdf, double wx, double wy, std::uint64_t seed, int count = 1000000) {
    constexpr int rings = 20, sectors = 16;
    std::vector<double> expected(rings * sectors, 0), seen(rings * sectors, 0);
    const lobe::detail::gauss_legendre<double> rule(12);
    for (int ring = 0; ring < rings; ++ring)
        for (int sector = 0; sector < sectors; ++sector)
            for (std::size_t i = 0; i < 12; ++i)
                for (std::size_t j = 0; j < 12; ++j) {
                    // the last ring reaches to infinity, where the density may fall slowly: nodes crowd there, 1 - w = q^4
                    const bool last = ring == rings - 1;
                    const double q = 1 - rule.x[i], w = last ? 1 - q * q * q * q / rings : (ring + rule.x[i]) / rings, dw = last ? 4 * q * q * q : 1;
                    const double r = w / (1 - w), phi = (sector + rule.x[j]) * 2 * pi / sectors;
                    const double x = wx * r * std::cos(phi), y = wy * r * std::sin(phi), z = 1 / std::sqrt(1 + x * x + y * y);
                    const double dm = dw * wx * wy * r * z * z * z / ((1 - w) * (1 - w)) * 2 * pi / (rings * sectors) * rule.w[i] * rule.w[j];
                    expected[static_cast<std::size_t>(ring * sectors + sector)] += pdf(vec3<double>{x * z, y * z, z}) * dm * count;
                }
    random_numbers random(seed);
    for (int k = 0; k < count; ++k) {
        const double ux = random(), uy = random();
        const vec3<double> m = sample(vec2<double>{ux, uy});
        const double x = m.x / (wx * m.z), y = m.y / (wy * m.z), r = std::hypot(x, y), w = r / (1 + r);
        double turn = std::atan2(y, x) / (2 * pi);
        if (turn < 0) turn += 1;
        const int ring = std::min(static_cast<int>(w * rings), rings - 1), sector = std::min(static_cast<int>(turn * sectors), sectors - 1);
        ++seen[static_cast<std::size_t>(ring * sectors + sector)];
    }
    double chi2 = 0, rest_expected = 0, rest_seen = 0;
    int cells = 0;
    for (std::size_t c = 0; c < expected.size(); ++c) {
        if (expected[c] < 20) {  // pooled
            rest_expected += expected[c];
            rest_seen += seen[c];
            continue;
        }
        chi2 += (seen[c] - expected[c]) * (seen[c] - expected[c]) / expected[c];
        ++cells;
    }
    if (rest_expected > 5) {
        chi2 += (rest_seen - rest_expected) * (rest_seen - rest_expected) / rest_expected;
        ++cells;
    } else if (rest_seen > 40) {
        return 0;
    }
    const double dof = cells - 1, t = (std::cbrt(chi2 / dof) - (1 - 2 / (9 * dof))) / std::sqrt(2 / (9 * dof));
    return std::erfc(t / std::sqrt(2.0)) / 2;
}

/// E[weight] = albedo <= 1 by an independent integral, and weight * pdf = f_cos.
template <class B>
void expect_energy(const B& brdf, const vec3<double>& v, std::uint32_t count, double tolerance, bool conserves = true) {
    double mean = 0, worst = 0;
    for (std::uint32_t i = 0; i < count; ++i) {
        const auto s = brdf.sample(v, lobe::hammersley<double>(i, count));
        mean += s.weight / count;
        if (s.pdf > 0) worst = std::max(worst, std::abs(s.weight * s.pdf / brdf.f_cos(v, s.l) - 1));
    }
    const auto albedo = lobe::directional_albedo(brdf, v);
    INFO("mean weight " << mean << ", albedo " << albedo.value << " +- " << albedo.error);
    CHECK(std::abs(mean - albedo.value) < tolerance);
    if (conserves) CHECK(albedo.value <= 1 + 1e-6);
    CHECK(worst < 1e-7);  // the half vector is known to 1e-16/alpha in slopes, and D falls like an exponential
}

}  // namespace

TEST_CASE("samples of all normals have the density they state", "[ndf]") {
    for (double a : {0.001, 0.1, 0.69}) {
        every_isotropic(a, [&](const std::string& name, const auto& ndf, double) {
            INFO(name << ' ' << a);
            const std::vector<double> kinks = name == "mixture" ? std::vector<double>{0.7} : std::vector<double>{};
            CHECK(jacobian_error([&](vec2<double> u) { return ndf.sample(u); }, [&](vec3<double> m) { return ndf.pdf(m); }, 1, 100, kinks) ==
                  Catch::Approx(0).margin(name == "mixture" ? 1e300 : 1e-6));  // a mixture covers the sphere twice: see chi-squared
        });
        every_anisotropic(a, 0.3, [&](const std::string& name, const auto& ndf, double) {
            INFO(name << ' ' << a << ", 0.3");
            if (name != "mixture")
                CHECK(jacobian_error([&](vec2<double> u) { return ndf.sample(u); }, [&](vec3<double> m) { return ndf.pdf(m); }, 2, 100) < 1e-6);
        });
    }
}

TEST_CASE("samples of visible normals have the density they state", "[ndf]") {
    random_numbers random(3);
    const auto compare = [&](const auto& ndf, double ax, double ay, int count) {
        for (double z : {0.9, 0.3, 0.0017, -0.2}) {  // 0.0017: 89.9 degrees; from below the horizon, as the random walk does
            const double phi = random.between(0, 6), s = std::sqrt((1 - z) * (1 + z));
            const vec3<double> v{s * std::cos(phi), s * std::sin(phi), z};
            if (z < 0 && ndf.projected_area(v) < 1e-6) continue;
            INFO("z " << z);
            const double kink = share_below_cotangent(ndf, ax, ay, v);
            CHECK(jacobian_error([&](vec2<double> u) { return ndf.sample_visible(v, u); }, [&](vec3<double> m) { return ndf.pdf_visible(v, m); }, 4,
                                 count, {kink}) < 1e-6);
        }
    };
    for (double a : {0.001, 0.1, 0.69}) {
        INFO("alpha " << a);
        compare(lobe::beckmann{alpha{a}}, a, a, 200);
        compare(lobe::beckmann{alpha_xy{a, 0.3}}, a, 0.3, 200);
        compare(lobe::student_t{alpha{a}, 1.75}, a, a, 20);
        compare(lobe::student_t{alpha_xy{a, 0.3}, 4.0}, a, 0.3, 20);
        compare(lobe::hyper_cauchy{alpha_xy{a, 0.3}, 2.5}, a / std::sqrt(1.5), 0.3 / std::sqrt(1.5), 20);
        compare(lobe::blinn_phong{alpha{a}}, a, a, 20);
        compare(lobe::exponential_power{alpha{a}, 0.5}, a, a, 20);
        compare(lobe::exponential_power{alpha_xy{a, 0.3}, 2.0}, a, 0.3, 20);
        compare(lobe::gtr{alpha{a}, 1.0}, a, a, 20);
        compare(lobe::gtr{alpha{a}, 3.0}, a, a, 20);
        compare(lobe::abc{alpha{a}, 1.5}, a, a, 20);
        compare(lobe::sgd{alpha{a}, 1.5}, a, a, 20);
        compare(lobe::phong{alpha{a}}, a, a, 20);
    }
    // SGGX, from anywhere
    for (int i = 0; i < 20; ++i) {
        const lobe::sggx flakes{lobe::frame<double>(random.direction()),
                                vec3<double>{random.log_between(0.05, 1), random.log_between(0.05, 1), random.log_between(0.05, 1)}};
        const vec3<double> v = random.direction();
        CHECK(jacobian_error([&](vec2<double> u) { return flakes.sample_visible(v, u); }, [&](vec3<double> m) { return flakes.pdf_visible(v, m); }, 5,
                             100) < 1e-6);
    }
}

TEST_CASE("a million samples follow the density", "[ndf]") {
    // Each chance is uniform in [0,1] for a right sampler: below 1e-4 in one of ten thousand.
    const auto expect_all_normals = [](const auto& ndf, double wx, double wy, std::uint64_t seed) {
        INFO("case " << seed);
        CHECK(chi_squared_chance([&](vec2<double> u) { return ndf.sample(u); }, [&](vec3<double> m) { return ndf.pdf(m); }, wx, wy, seed) > 1e-4);
    };
    const auto expect_visible = [](const auto& ndf, double wx, double wy, double mu, std::uint64_t seed, int count) {
        const double s = std::sqrt((1 - mu) * (1 + mu));
        const vec3<double> v{s * 0.8, s * 0.6, mu};
        INFO("case " << seed);
        CHECK(chi_squared_chance([&](vec2<double> u) { return ndf.sample_visible(v, u); }, [&](vec3<double> m) { return ndf.pdf_visible(v, m); }, wx, wy,
                                 seed, count) > 1e-4);
    };
    expect_all_normals(lobe::beckmann{alpha_xy{0.3, 0.001}}, 0.3, 0.001, 1);
    expect_all_normals(lobe::student_t{alpha{0.2}, 1.6}, 0.2, 0.2, 2);
    expect_all_normals(lobe::blinn_phong{alpha{0.5}}, 0.5, 0.5, 3);
    expect_all_normals(lobe::gtr{alpha{0.1}, 1.0}, 0.1, 0.1, 4);
    expect_all_normals(lobe::phong{alpha{0.3}}, 0.3, 0.3, 5);
    expect_all_normals(lobe::mixture{lobe::ggx{alpha{0.5}}, lobe::beckmann{alpha{0.1}}, 0.4}, 0.3, 0.3, 6);
    expect_visible(lobe::beckmann{alpha_xy{0.3, 0.1}}, 0.3, 0.1, 0.5, 7, 1000000);
    expect_visible(lobe::beckmann{alpha{0.001}}, 0.001, 0.001, 0.0017, 8, 1000000);
    expect_visible(lobe::mixture{lobe::ggx{alpha{0.5}}, lobe::beckmann{alpha{0.1}}, 0.4}, 0.3, 0.3, 0.2, 9, 1000000);
    expect_visible(lobe::student_t{alpha{0.5}, 1.75}, 0.5, 0.5, 0.4, 10, 1000000);
    // numerically, at 20 microseconds each: fewer samples
    expect_visible(lobe::exponential_power{alpha_xy{0.6, 0.2}, 0.5}, 0.6, 0.2, 0.1, 11, 50000);
    expect_visible(lobe::gtr{alpha{0.3}, 1.0}, 0.3, 0.3, 0.3, 12, 50000);
    expect_visible(lobe::sgd{alpha{0.3}, 1.5}, 0.3, 0.3, 0.3, 13, 20000);
}

TEST_CASE("samples at the corners of the square are unit and face the viewer", "[ndf]") {
    const float last = 0x1.fffffep-1f;
    const auto expect_sound = [&](const auto& ndf) {
        for (float z : {1.0f, 0.5f, 1e-3f, 1e-6f})
            for (float x : {0.0f, 1e-30f, 1e-7f, 0.5f, last})
                for (float y : {0.0f, 1e-7f, 0.3f, last}) {
                    const vec3<float> v{std::sqrt((1 - z) * (1 + z)), 0, z}, m = ndf.sample_visible(v, {x, y}), all = ndf.sample({x, y});
                    INFO(z << ' ' << x << ' ' << y);
                    CHECK(std::abs(lobe::length(m) - 1) < 3e-7f);
                    CHECK(std::abs(lobe::length(all) - 1) < 3e-7f);
                    CHECK((m.z >= 0 && all.z >= 0));
                    CHECK(lobe::dot(v, m) >= -1e-6f);
                }
    };
    for (float a : {1e-4f, 0.1f, 0.7f}) {
        INFO("alpha " << a);
        expect_sound(lobe::beckmann{alpha{a}});
        expect_sound(lobe::student_t{alpha{a}, 1.75f});
        expect_sound(lobe::blinn_phong{alpha{std::max(a, 0.001f)}});
        expect_sound(lobe::exponential_power{alpha{a}, 0.5f});
        expect_sound(lobe::exponential_power{alpha{a}, 3.0f});
        expect_sound(lobe::gtr{alpha{a}, 1.0f});
        expect_sound(lobe::gtr{alpha{a}, 4.0f});
        expect_sound(lobe::abc{alpha{a}, 0.7f});
        expect_sound(lobe::sgd{alpha{a}, 2.0f});
        expect_sound(lobe::phong{alpha{a}});
        expect_sound(lobe::mixture{lobe::ggx{alpha{a}}, lobe::beckmann{alpha{a}}, 0.5f});
    }
}

TEST_CASE("a microfacet of any distribution returns at most what it receives, and its samples add up to it", "[ndf]") {
    const auto direction = [](double mu) {
        const double s = std::sqrt((1 - mu) * (1 + mu));
        return vec3<double>{0.6 * s, 0.8 * s, mu};
    };
    const auto with = [](const auto& ndf) { return lobe::microfacet{ndf, lobe::smith_correlated{}, lobe::perfect_reflector{}}; };
    const auto all_of = [](const auto& ndf) {
        return lobe::microfacet{ndf, lobe::smith_correlated{}, lobe::perfect_reflector{}, lobe::all_normals{}};
    };
    for (double a : {0.1, 0.5})
        for (double mu : {0.1, 0.6}) {
            INFO("alpha " << a << " mu " << mu);
            const vec3<double> v = direction(mu);
            // 2^16 Hammersley points for closed samplers, 2^11 for numeric ones: the error of a smooth integrand is of order
            // log(n)/n, 2e-4 and 4e-3, times its variation
            expect_energy(with(lobe::beckmann{alpha{a}}), v, 1u << 16, 3e-4);
            expect_energy(with(lobe::beckmann{alpha_xy{a, 0.3}}), v, 1u << 16, 3e-4);
            expect_energy(with(lobe::mixture{lobe::ggx{alpha{a}}, lobe::beckmann{alpha{a / 2}}, 0.3}), v, 1u << 16, 3e-4);
            expect_energy(with(lobe::student_t{alpha{a}, 3.0}), v, 1u << 11, 5e-3);
            expect_energy(with(lobe::hyper_cauchy{alpha_xy{a, 0.3}, 3.0}), v, 1u << 11, 5e-3);
            expect_energy(with(lobe::exponential_power{alpha{a}, 0.5}), v, 1u << 11, 5e-3);
            expect_energy(with(lobe::blinn_phong{alpha{a}}), v, 1u << 11, 5e-3);
            expect_energy(with(lobe::gtr{alpha{a}, 1.0}), v, 1u << 11, 5e-3);
            expect_energy(with(lobe::abc{alpha{a}, 1.5}), v, 1u << 11, 5e-3);
            expect_energy(with(lobe::sgd{alpha{a}, 1.5}), v, 1u << 11, 5e-3);
            expect_energy(with(lobe::phong{alpha{a}}), v, 1u << 11, 5e-3);
            // all normals: weights grow towards grazing angles
            if (mu > 0.5) {
                expect_energy(all_of(lobe::gtr{alpha{a}, 1.0}), v, 1u << 16, 2e-3);
                expect_energy(all_of(lobe::beckmann_walter{alpha{a}}), v, 1u << 16, 2e-3, false);
                expect_energy(all_of(lobe::masked_by{lobe::phong{alpha{a}}, lobe::ggx{alpha{a}}}), v, 1u << 16, 2e-3, false);
                expect_energy(all_of(lobe::masked_by{lobe::blinn_phong{alpha{a}}, lobe::beckmann{alpha{a}}}), v, 1u << 16, 2e-3, false);
            }
        }
}

TEST_CASE("a mixture hands its parts numbers below 1", "[ndf]") {
    // (u - p)/(1 - p) rounds to 1 for many p; spherical caps then give a normal at the horizon
    int at_the_horizon = 0;
    for (int i = 1; i < 1000; ++i) {
        const lobe::mixture both{lobe::ggx{lobe::alpha{0.3f}}, lobe::ggx{lobe::alpha{0.9f}}, static_cast<float>(i) / 1000.0f};
        if (!(both.sample_visible(lobe::vec3<float>{0.6f, 0.0f, 0.8f}, {0x1.fffffep-1f, 0.0f}).z > 0)) ++at_the_horizon;
    }
    CHECK(at_the_horizon == 0);
}
