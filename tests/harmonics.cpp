// Spherical harmonics: orthonormal, the published constants, irradiance, windows.
#include "catch.hpp"
#include "support.hpp"

#include <lobe/ibl/harmonics.hpp>
#include <lobe/ibl/irradiance.hpp>
#include <lobe/ibl/rotated.hpp>
#include <lobe/numeric/gauss_legendre.hpp>

using lobe::harmonics, lobe::vec2, lobe::vec3;

TEST_CASE("harmonics are orthonormal, up to degree 12", "[ibl]") {
    const int degree = 12, count = (degree + 1) * (degree + 1), azimuths = 32;
    const lobe::gauss_legendre<double> rule(16);
    std::vector<double> products(static_cast<std::size_t>(count * count)), values;
    for (std::size_t i = 0; i < rule.x.size(); ++i)
        for (int j = 0; j < azimuths; ++j) {
            const double z = 2 * rule.x[i] - 1, s = std::sqrt(1 - z * z), phi = 2 * lobe::pi<double>() * j / azimuths;
            values.clear();
            lobe::detail::for_each_harmonic(vec3<double>{s * std::cos(phi), s * std::sin(phi), z}, degree,
                                            [&](int, int, double Y) { values.push_back(Y); });
            const double weight = 2 * rule.w[i] * 2 * lobe::pi<double>() / azimuths;
            for (std::size_t a = 0; a < values.size(); ++a)
                for (std::size_t b = 0; b < values.size(); ++b)
                    products[a * values.size() + b] += weight * values[a] * values[b];
        }
    double worst = 0;
    for (int a = 0; a < count; ++a)
        for (int b = 0; b < count; ++b)
            worst = larger(worst, std::abs(products[static_cast<std::size_t>(a * count + b)] - (a == b ? 1 : 0)));
    CHECK(worst < 1e-12);
}

TEST_CASE("harmonics of degree 2 have the published constants", "[ibl]") {
    // Ramamoorthi & Hanrahan 2001, eq. 3
    const vec3<double> w = lobe::normalize(vec3<double>{0.3, -0.5, 0.8});
    const double x = w.x, y = w.y, z = w.z;
    const double exact[9] = {0.282095,
                             0.488603 * y,
                             0.488603 * z,
                             0.488603 * x,
                             1.092548 * x * y,
                             1.092548 * y * z,
                             0.315392 * (3 * z * z - 1),
                             1.092548 * x * z,
                             0.546274 * (x * x - y * y)};
    std::size_t i = 0;
    lobe::detail::for_each_harmonic(w, 2, [&](int, int, double Y) { CHECK(std::abs(Y - exact[i++]) < 1e-6); });
    // eq. 9: pi, 2 pi/3, pi/4, 0, -pi/24, 0, pi/64
    const double pi = lobe::pi<double>();
    const double cosine[7] = {pi, 2 * pi / 3, pi / 4, 0, -pi / 24, 0, pi / 64};
    for (int l = 0; l < 7; ++l) CHECK(std::abs(lobe::detail::cosine_harmonic<double>(l) - cosine[l]) < 1e-15);
}

namespace {

template <class F>
lobe::latlong<double> map_of(const F& f, int width, int height) {
    std::vector<vec3<double>> pixels;
    for (int row = 0; row < height; ++row)
        for (int column = 0; column < width; ++column)
            pixels.push_back(f(lobe::latlong_direction(vec2<double>{(column + 0.5) / width, (row + 0.5) / height})));
    return {width, height, pixels};
}

}  // namespace

TEST_CASE("irradiance by harmonics", "[ibl]") {
    const vec3<double> a = lobe::normalize(vec3<double>{0.3, 0.5, -0.8});
    const auto L = [&](const vec3<double>& w) {
        const double c = lobe::dot(w, a);
        return vec3<double>{1 + c, c * c, 1};
    };
    // of a texel of 1.4 degrees the midpoint is off by 1/24 of its square
    const harmonics<double> of_map(map_of(L, 256, 128), 2), of_cube(lobe::make_cube<double>(L, 64), 2);
    const auto E = of_map.irradiance(), E_cube = of_cube.irradiance();
    random_numbers random(1);
    for (int i = 0; i < 100; ++i) {
        const vec3<double> n = random.direction();
        const double c = lobe::dot(n, a);
        const vec3<double> exact{1 + 2 * c / 3, (1 + c * c) / 4, 1};
        CHECK(lobe::length(E(n) - exact) < 2e-4);
        CHECK(lobe::length(E_cube(n) - exact) < 2e-4);
        CHECK(std::abs(E(n).z - 1) < 1e-13);
        CHECK(std::abs(E_cube(n).z - 1) < 1e-13);
        CHECK(lobe::length(of_map(n) - L(n)) < 4e-4);
    }
    // a higher degree comes closer to the sum over all texels
    const auto glow = [&](const vec3<double>& w) { return vec3<double>(std::exp(20 * (lobe::dot(w, a) - 1))); };
    const auto sun = map_of(glow, 128, 64);
    double error[3] = {};
    for (int k = 0; k < 3; ++k) {
        const auto by_harmonics = harmonics<double>(sun, 2 + 2 * k).irradiance();
        for (int i = 0; i < 100; ++i) {
            const vec3<double> n = random.direction();
            error[k] = larger(error[k], std::abs(by_harmonics(n).x - lobe::irradiance(sun, n).x));
        }
    }
    const double peak = lobe::irradiance(sun, a).x;
    INFO(error[0] / peak << ' ' << error[1] / peak << ' ' << error[2] / peak);
    CHECK(error[0] < 0.094 * peak);  // of a directional light at degree 2
    CHECK(error[1] < 0.6 * error[0]);
    CHECK(error[2] < 0.6 * error[1]);
}

TEST_CASE("windows against ringing", "[ibl]") {
    const vec3<double> a{0, 1, 0};
    const auto disk = [&](const vec3<double>& w) { return vec3<double>(lobe::dot(w, a) > 0.99 ? 100 : 0); };
    const auto sun = map_of(disk, 128, 64);
    const harmonics<double> plain(sun, 4);
    const auto soft = plain.windowed_above_zero();
    double lowest_plain = 1, lowest = 1;
    random_numbers random(2);
    for (int i = 0; i < 20000; ++i) {
        const vec3<double> w = random.direction();
        lowest_plain = smaller(lowest_plain, plain(w).x);
        lowest = smaller(lowest, soft(w).x);
    }
    const double peak = plain(a).x;
    CHECK(lowest_plain < -0.05 * peak);
    CHECK(lowest > -2e-3 * peak);  // between the 4096 directions
    CHECK(soft.at(0, 0) == plain.at(0, 0));
    CHECK(soft(a).x > 0.1 * peak);
    CHECK(plain.windowed(0.0)(a).x == Catch::Approx(peak));
}

TEST_CASE("rotated environments, dimmed light", "[ibl]") {
    const auto L = [](const vec3<double>& w) { return w; };
    const auto turn = lobe::rotation<double>::about_up(0.25);
    CHECK(lobe::length(turn.forward({0, 0, 1}) - vec3<double>{1, 0, 0}) < 1e-15);
    const lobe::rotated environment{L, turn};
    CHECK(lobe::length(environment({1, 0, 0}) - vec3<double>{0, 0, 1}) < 1e-15);
    random_numbers random(3);
    const vec3<double> w = random.direction();
    CHECK(lobe::length(turn.back(turn.forward(w)) - w) < 1e-15);
    CHECK(lobe::length(lobe::dimmed(vec3<double>{30, 60, 90}, 6.0) - vec3<double>{3, 6, 9}) < 1e-14);
    CHECK(lobe::dimmed(vec3<double>{1, 2, 3}, 6.0) == vec3<double>{1, 2, 3});
}
