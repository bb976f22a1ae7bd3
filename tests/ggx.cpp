#include "catch.hpp"
#include "support.hpp"

#include <lobe/brdf/masking.hpp>
#include <lobe/energy/quadrature.hpp>
#include <lobe/ndf/ggx.hpp>

#include <algorithm>
#include <set>

using lobe::alpha;
using lobe::alpha_xy;
using lobe::ggx;
using lobe::vec2;
using lobe::vec3;

namespace {

/// int g(m) dm over the upper hemisphere for a g that decays like a distribution of widths (wx, wy): slopes
/// r (wx cos phi, wy sin phi), r = tan(chi). Nodes and sums in double; g gets m in T.
template <class T, class G>
double normals_integral(const G& g, double wx, double wy) {
    const lobe::gauss_legendre<double> rule(64);
    double total = 0;
    const int azimuths = 64;
    for (int k = 0; k < azimuths; ++k) {
        const auto [s, c] = lobe::sincos_2pi((k + 0.5) / azimuths);
        for (std::size_t i = 0; i < rule.x.size(); ++i) {
            const double chi = rule.x[i] * 1.5707963267948966, r = std::tan(chi);
            const double x = r * wx * c, y = r * wy * s, z = 1 / std::sqrt(1 + x * x + y * y);
            const double dm =
                wx * wy * r * (1 + r * r) * z * z * z * rule.w[i] * 1.5707963267948966 * 6.283185307179586 / azimuths;
            total +=
                dm * static_cast<double>(g(vec3<T>{static_cast<T>(x * z), static_cast<T>(y * z), static_cast<T>(z)}));
        }
    }
    return total;
}

}  // namespace

TEST_CASE("D agrees with the 50-digit tables at the extremes", "[ggx]") {
    double isotropic = 0, anisotropic = 0, float_isotropic = 0, float_anisotropic = 0;
    for (const auto& row : reference_table("ndf_extreme_iso.csv")) {
        const double a = row[0], s = row[1];
        const vec3<double> m{s, 0, std::sqrt((1 - s) * (1 + s))};
        isotropic = larger(isotropic, ulp_error(ggx{alpha{a}}.D(m), row[2]));
        anisotropic = larger(anisotropic, ulp_error(ggx{alpha_xy{a, a}}.D(m), row[2]));
        // float: the same inputs rounded, so the error is conditioned by that rounding; 1e-6 bounds it in float's
        // digits
        const double in_float = static_cast<double>(ggx{alpha{static_cast<float>(a)}}.D(vec3<float>(m)));
        float_isotropic = larger(float_isotropic, std::abs(in_float / row[2] - 1));
    }
    for (const auto& row : reference_table("ndf_extreme_aniso.csv")) {
        const double s = row[2];
        // cos and sin of whole degrees in long double, as the table's are exact
        const long double phi = static_cast<long double>(row[3]) * 3.14159265358979323846264338L / 180;
        const bool right = row[3] == 90;
        const vec3<double> m{static_cast<double>(s * (right ? 0 : std::cos(phi))),
                             static_cast<double>(s * std::sin(phi)), std::sqrt((1 - s) * (1 + s))};
        const ggx distribution{alpha_xy{row[0], row[1]}};
        anisotropic = larger(anisotropic, ulp_error(distribution.D(m), row[4]));
        const ggx in_float{alpha_xy{static_cast<float>(row[0]), static_cast<float>(row[1])}};
        float_anisotropic =
            larger(float_anisotropic, std::abs(static_cast<double>(in_float.D(vec3<float>(m))) / row[4] - 1));
    }
    INFO(isotropic << " ULP, anisotropic " << anisotropic << " ULP; relative in float " << float_isotropic << ", "
                   << float_anisotropic);
    CHECK(isotropic <= 6);
    CHECK(anisotropic <= 12);
    CHECK(float_isotropic < 16 * 6e-8);
    CHECK(float_anisotropic < 16 * 6e-8);
}

TEST_CASE("D takes any positive multiple of m and is zero below the horizon", "[ggx]") {
    random_numbers random(1);
    for (int i = 0; i < 20000; ++i) {
        const ggx narrow{alpha{random.log_between(1e-4, 1)}};
        const ggx aniso{alpha_xy{random.log_between(1e-4, 1), random.log_between(1e-4, 1)}};
        const vec3<double> m = random.grazing_direction(1e-6);
        const double k = random.log_between(1e-6, 1e3);
        CHECK(std::abs(narrow.D(k * m) / narrow.D(m) - 1) < 20e-16);
        CHECK(std::abs(aniso.D(k * m) / aniso.D(m) - 1) < 20e-16);
        CHECK(narrow.D(-m) == 0);
        CHECK(aniso.D(-m) == 0);
    }
    // the limit at the horizon
    CHECK(ggx{alpha{0.1}}.D(vec3<double>{1, 0, 0}) == Catch::Approx(0.01 / 3.14159265358979));
    // the whole hemisphere alike
    CHECK(ggx{alpha{1.0}}.D(vec3<double>{0.6, 0, 0.8}) == Catch::Approx(1 / 3.14159265358979));
    CHECK(ggx{alpha{0.5}}.D(vec3<double>{0, 0, 1}) == Catch::Approx(4 / 3.14159265358979));  // 1/(pi alpha^2)
}

TEST_CASE("D is normalised: int D cos = 1, in float at alpha 1e-4 too", "[ggx]") {
    // Quadrature: exact to 1e-12 for GGX (the integrand is sin 2 chi). In float the error is the rounding of D, below
    // 1e-6.
    for (const double a : {1e-4, 1e-3, 0.01, 0.1, 0.5, 1.0}) {
        const auto cosine_weighted = [](const auto& ndf) { return [&](const auto& m) { return ndf.D(m) * m.z; }; };
        const ggx in_double{alpha{a}};
        const ggx in_float{alpha{static_cast<float>(a)}};
        const ggx aniso{alpha_xy{a, 0.3}};
        const ggx aniso_float{alpha_xy{static_cast<float>(a), 0.3f}};
        INFO("alpha " << a);
        CHECK(std::abs(normals_integral<double>(cosine_weighted(in_double), a, a) - 1) < 1e-12);
        CHECK(std::abs(normals_integral<double>(cosine_weighted(aniso), a, 0.3) - 1) < 1e-12);
        const double wide = static_cast<double>(static_cast<float>(a));
        CHECK(std::abs(normals_integral<float>(cosine_weighted(in_float), wide, wide) - 1) < 1e-6);
        CHECK(std::abs(normals_integral<float>(cosine_weighted(aniso_float), wide, static_cast<double>(0.3f)) - 1) <
              1e-6);
    }
    // The test can see: the textbook's float form, with 1 - cos^2 in it, is off by far more.
    const auto textbook = [](const vec3<float>& m) {
        const float a2 = 1e-4f * 1e-4f, d = m.z * m.z * (a2 - 1) + 1;
        return a2 / (3.14159265f * d * d) * m.z;
    };
    CHECK_FALSE(std::abs(normals_integral<float>(textbook, 1e-4, 1e-4) - 1) < 0.1);
}

TEST_CASE("projected_area is the area of the facets that face w", "[ggx]") {
    // The definition: int max(0, w.m) D(m) dm. In polar slopes around w's stretched azimuth, u = tan(theta), the
    // sign of w.m changes at a circle-free line, so integrate each azimuth exactly up to it.
    const auto by_definition = [](double ax, double ay, const vec3<double>& w) {
        const ggx ndf{alpha_xy{ax, ay}};
        const lobe::gauss_legendre<double> rule(48);
        double total = 0;
        const double px = ax * w.x, py = ay * w.y, p = std::hypot(px, py);
        for (int quarter = 0; quarter < 4; ++quarter)
            for (std::size_t k = 0; k < rule.x.size(); ++k) {
                // crowd towards the azimuths where the visible radius changes between finite and infinite
                const double x = rule.x[k], delta = 1.5707963267948966 * x * x * x;
                const double along = quarter % 2 ? -std::sin(delta) : std::sin(delta),
                             across = quarter / 2 ? -std::cos(delta) : std::cos(delta);
                const double dx = ax * (along * px - across * py) / p, dy = ay * (along * py + across * px) / p;
                const double slope = dx * w.x + dy * w.y;  // w.m = z (w.z + r slope), m = (r dx, r dy, 1) z
                double low = 0, high = 1.5707963267948966;
                if (w.z >= 0 && slope < 0) high = std::atan(-w.z / slope);
                if (w.z < 0) low = slope > 0 ? std::atan(-w.z / slope) : high;
                for (std::size_t i = 0; i < rule.x.size(); ++i) {
                    const double chi = low + (high - low) * rule.x[i], r = std::tan(chi);
                    const double z = 1 / std::sqrt(1 + r * r * (dx * dx + dy * dy));
                    const double w_m = z * (w.z + r * slope);
                    total += w_m * ndf.D({r * dx * z, r * dy * z, z}) * ax * ay * r * (1 + r * r) * z * z * z *
                             rule.w[i] * (high - low) * rule.w[k] * 1.5 * 3.141592653589793 * x * x;
                }
            }
        return total;
    };
    random_numbers random(2);
    double worst = 0;
    for (int i = 0; i < 200; ++i) {
        const double ax = random.log_between(1e-3, 1), ay = random.log_between(1e-3, 1);
        const vec3<double> w = random.direction();
        const double exact = by_definition(ax, ay, w);
        INFO(ax << ' ' << ay << ' ' << w.x << ' ' << w.y << ' ' << w.z);
        worst = larger(worst, std::abs(ggx{alpha_xy{ax, ay}}.projected_area(w) - exact));
        CHECK(std::abs(ggx{alpha_xy{ax, ay}}.projected_area(w) - exact) < 1e-8);
    }
    INFO(worst);
    // signed projection: what faces w minus what faces away is the macrosurface, cos(theta)
    for (int i = 0; i < 10000; ++i) {
        const ggx ndf{alpha_xy{random.log_between(1e-6, 1), random.log_between(1e-6, 1)}};
        const vec3<double> w = random.direction();
        CHECK(std::abs(ndf.projected_area(w) - ndf.projected_area(-w) - w.z) < 1e-15);
    }
}

TEST_CASE("Lambda agrees with the 60-digit table, and with the projected area", "[ggx]") {
    double worst = 0;
    for (const auto& row : reference_table("smith_lambda.csv")) {
        const double mu = row[0];
        const vec3<double> v{std::sqrt((1 - mu) * (1 + mu)), 0, mu};
        const ggx ndf{alpha{row[1]}};
        worst = larger(worst, ulp_error(ndf.lambda(v), row[2]));
        CHECK(ulp_error(mu / ndf.projected_area(v), row[3]) <= 6);
        if (row[2] > 0.1) CHECK(ndf.projected_area(-v) / -mu - 1 == Catch::Approx(ndf.lambda(-v)).epsilon(1e-13));
    }
    INFO(worst << " ULP");
    CHECK(worst <= 6);
}

TEST_CASE("projected area, Lambda and visibility round as stated, over a million views", "[ggx]") {
    // In units of 2^-24, which are at most an ULP: a x is off by 1, its square by 3, q by 4, the sum with z^2 by 5, the
    // root by 3.5; the rounding of S + z is half an ULP: 4. Below the horizon, in q/(S - z), half of what q is off
    // cancels where S is off with it; were all roundings at their worst at once, 6.5 would be left, and 5 is what is
    // stated.
    random_numbers random(4);
    double above = 0, below = 0, lambda = 0, visibility = 0;
    for (int i = 0; i < 1000000; ++i) {
        const float a = static_cast<float>(random.log_between(1e-4, 1));
        const ggx ndf{alpha{a}};
        const ggx exact{alpha{static_cast<long double>(a)}};
        const auto v = random.grazing_direction<float>(1e-6), l = random.grazing_direction<float>(1e-6);
        const vec3<long double> V(v), L(l);
        above = larger(above, ulp_error(ndf.projected_area(v), exact.projected_area(V)));
        above = larger(above, ulp_error(ndf.projected_area_above(v), exact.projected_area(V)));
        below = larger(below, ulp_error(ndf.projected_area(-v), exact.projected_area(-V)));
        lambda = larger(lambda, ulp_error(ndf.lambda(v), exact.lambda(V)));
        visibility = larger(visibility, ulp_error(lobe::smith_correlated{}.visibility(ndf, v, l),
                                                  lobe::smith_correlated{}.visibility(exact, V, L)));
    }
    INFO("area " << above << ", below the horizon " << below << ", Lambda " << lambda << ", visibility " << visibility);
    CHECK(above <= 4);
    CHECK(below <= 5);
    CHECK(lambda <= 8);
    CHECK(visibility <= 6);
}

TEST_CASE("sampled normals follow the inverse CDF continuously, in float at alpha 1e-4", "[ggx]") {
    const int n = 100000;
    const ggx ndf{alpha{1e-4f}};
    std::set<float> angles, textbook_angles;
    std::vector<double> cdf;
    random_numbers random(3);
    double worst_angle = 0;
    for (int i = 0; i < n; ++i) {
        const vec2<float> u{static_cast<float>((i + random()) / n), 0.0f};
        const vec3<float> m = ndf.sample(u);
        angles.insert(std::hypot(m.x, m.y));
        const float cosine = std::sqrt((1 - u.x) / (1 + (1e-8f - 1) * u.x));
        textbook_angles.insert(std::sqrt(1 - cosine * cosine));
        const double exact = std::atan(static_cast<double>(1e-4f) *
                                       std::sqrt(static_cast<double>(u.x) / (1 - static_cast<double>(u.x))));
        worst_angle =
            larger(worst_angle, std::abs(std::atan2(std::hypot(static_cast<double>(m.x), static_cast<double>(m.y)),
                                                    static_cast<double>(m.z)) -
                                         exact));
    }
    CHECK(static_cast<double>(angles.size()) > 0.95 * n);
    CHECK(textbook_angles.size() < 1000);
    INFO(worst_angle << " radian");
    CHECK(worst_angle < 1e-6);

    // Kolmogorov-Smirnov at 1e6 random samples: sqrt(n) D < 1.95 rejects one right sampler in a thousand.
    const int samples = 1000000;
    cdf.reserve(samples);
    for (int i = 0; i < samples; ++i) {
        const vec3<float> m =
            ndf.sample({static_cast<float>(random() * 0.99999997), static_cast<float>(random() * 0.99999997)});
        const double tan2 = (static_cast<double>(m.x) * static_cast<double>(m.x) +
                             static_cast<double>(m.y) * static_cast<double>(m.y)) /
                            (static_cast<double>(m.z) * static_cast<double>(m.z));
        // int D cos up to this angle
        cdf.push_back(tan2 / (tan2 + static_cast<double>(1e-4f) * static_cast<double>(1e-4f)));
    }
    std::sort(cdf.begin(), cdf.end());
    double distance = 0;
    for (int i = 0; i < samples; ++i) {
        const double F = cdf[static_cast<std::size_t>(i)];
        distance =
            larger({distance, std::abs(F - static_cast<double>(i) / samples), std::abs(F - (i + 1.0) / samples)});
    }
    CHECK(distance * std::sqrt(samples) < 1.95);
}

namespace {

/// pdf * |d m / d u| - 1 by Richardson-extrapolated central differences, worst over random u.
template <class Map, class Pdf>
double jacobian_error(Map map, Pdf pdf, std::uint64_t seed) {
    random_numbers random(seed);
    double worst = 0;
    for (int k = 0; k < 500; ++k) {
        const vec2<double> u{random.between(0.01, 0.99), random.between(0.01, 0.99)};
        const auto derivative = [&](vec2<double> step) {
            const auto central = [&](double h) { return (map(u + h * step) - map(u - h * step)) / (2 * h); };
            const auto twice = [&](double h) { return (4.0 * central(h / 2) - central(h)) / 3.0; };
            return (16.0 * twice(2e-4) - twice(4e-4)) / 15.0;  // error (h/distance to the edge)^6, 4e-9 at u = 0.01
        };
        const double area = lobe::length(lobe::cross(derivative({1, 0}), derivative({0, 1})));
        worst = larger(worst, std::abs(pdf(map(u)) * area - 1));
    }
    return worst;
}

}  // namespace

TEST_CASE("samplers have the density they state", "[ggx]") {
    random_numbers random(5);
    for (int i = 0; i < 40; ++i) {
        const double ax = random.log_between(0.001, 1), ay = i % 2 ? ax : random.log_between(0.001, 1);
        const ggx ndf{alpha_xy{ax, ay}};
        // also from below the horizon
        const vec3<double> v = i % 3 == 2 ? random.direction() : random.grazing_direction(1e-3);
        INFO(ax << ' ' << ay << " v " << v.x << ' ' << v.y << ' ' << v.z);
        CHECK(jacobian_error([&](vec2<double> u) { return ndf.sample(u); }, [&](vec3<double> m) { return ndf.pdf(m); },
                             11) < 1e-6);
        if (v.z > -0.9)
            CHECK(jacobian_error([&](vec2<double> u) { return ndf.sample_visible(v, u); },
                                 [&](vec3<double> m) { return ndf.pdf_visible(v, m); }, 12) < 1e-6);
    }
}

TEST_CASE("visible normals in float stand where those of double do", "[ggx]") {
    // The same v and u in both. Small u, where sqrt(1 - z^2) of the cap is off by up to 17 times, and views from below
    // the horizon are included. The map is ill-conditioned where the cap closes, so a quantile and a bound on the
    // worst.
    random_numbers random(9);
    std::vector<double> errors;
    double worst_area_below = 0;
    for (int i = 0; i < 200000; ++i) {
        const float a = static_cast<float>(i % 4 ? 1e-4 : random.log_between(1e-4, 1));
        const vec3<float> v = i % 8 == 7 ? random.direction<float>() : random.grazing_direction<float>(1e-4);
        const vec2<float> u{static_cast<float>(i % 2 ? random.log_between(1e-7, 0.5) : random() * 0.9999),
                            static_cast<float>(random() * 0.9999)};
        const ggx in_float{alpha{a}};
        const ggx in_double{alpha{static_cast<double>(a)}};
        const vec3<double> exact = in_double.sample_visible(vec3<double>(v), vec2<double>(u));
        // sine of the angle
        errors.push_back(lobe::length(lobe::cross(vec3<double>(in_float.sample_visible(v, u)), exact)));
        const double area = in_double.projected_area(-vec3<double>(v));
        if (v.z > 0.5f)
            worst_area_below =
                larger(worst_area_below, std::abs(static_cast<double>(in_float.projected_area(-v)) / area - 1));
    }
    std::sort(errors.begin(), errors.end());
    INFO("99.9 %: " << errors[errors.size() * 999 / 1000] << ", worst " << errors.back());
    CHECK(errors[errors.size() * 999 / 1000] < 1e-6);
    CHECK(errors.back() < 2e-3);
    CHECK(worst_area_below < 8 * 6e-8);
}

TEST_CASE("visible normals face the viewer and are unit, at the corners of the square too", "[ggx]") {
    const float last = 0x1.fffffep-1f;
    for (float a : {1e-4f, 0.01f, 1.0f})
        for (float z : {1.0f, 0.5f, 1e-3f, 1e-6f})
            for (float x : {0.0f, 1e-30f, 1e-7f, 0.5f, last})
                for (float y : {0.0f, 0.3f, last}) {
                    const vec3<float> v{std::sqrt((1 - z) * (1 + z)), 0, z};
                    const vec3<float> m = ggx{alpha{a}}.sample_visible(v, {x, y});
                    INFO(a << ' ' << z << ' ' << x << ' ' << y);
                    CHECK(std::abs(lobe::length(m) - 1) < 3e-7f);
                    CHECK(m.z >= 0);
                    CHECK(lobe::dot(v, m) >= -1e-6f);
                }
}

TEST_CASE("anisotropic with equal widths is isotropic", "[ggx]") {
    random_numbers random(6);
    for (int i = 0; i < 1000; ++i) {
        const double a = random.log_between(1e-4, 1);
        const ggx one{alpha{a}};
        const ggx two{alpha_xy{a, a}};
        const vec3<double> w = random.direction(), m = random.grazing_direction(1e-4);
        const vec2<double> u{random(), random()};
        CHECK(std::abs(one.D(m) / two.D(m) - 1) < 3e-15);
        CHECK(one.projected_area(w) == two.projected_area(w));
        CHECK(one.sample(u) == two.sample(u));
        CHECK(one.sample_visible(w, u) == two.sample_visible(w, u));
    }
}
