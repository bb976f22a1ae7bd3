#include "catch.hpp"
#include "support.hpp"

#include <lobe/brdf/lambert.hpp>
#include <lobe/brdf/microfacet.hpp>
#include <lobe/energy/quadrature.hpp>
#include <lobe/fresnel/schlick.hpp>
#include <lobe/lights/punctual.hpp>
#include <lobe/ndf/ggx.hpp>

#include <xsimd/xsimd.hpp>

using lobe::cone;
using lobe::directional_light;
using lobe::inverse_square;
using lobe::inverse_square_within;
using lobe::point_light;
using lobe::spot_light;
using lobe::vec3;

namespace {

constexpr double pi = 3.141592653589793;

/// The listings of KHR_lights_punctual's README, in long double, without its floor of 0.001.
long double printed_window(long double distance, long double range) {
    const long double x = distance / range;
    return std::max(std::min(1 - x * x * x * x, 1.0L), 0.0L) / (distance * distance);
}
long double printed_spot(long double angle, long double inner, long double outer) {
    const long double scale = 1 / (std::cos(inner) - std::cos(outer)), offset = -std::cos(outer) * scale;
    const long double a = std::clamp(std::cos(angle) * scale + offset, 0.0L, 1.0L);
    return a * a;
}

}  // namespace

TEST_CASE("units: a white Lambertian surface shows E/pi", "[lights]") {
    const lobe::lambert white{1.0};
    const vec3<double> n{0, 0, 1};
    const directional_light sun{n, 100000.0};                                                 // lux
    CHECK(lobe::reflected_radiance(white, n, sun({1, 2, 3})) == Catch::Approx(100000 / pi));  // cd/m^2
    const point_light bulb{vec3<double>{0, 0, 2}, 800 / (4 * pi)};                            // 800 lm
    CHECK(lobe::reflected_radiance(white, n, bulb({0, 0, 0})) == Catch::Approx(800 / (4 * pi) / 4 / pi));
    // A light from 60 degrees: half of it arrives; one from below: none
    CHECK(lobe::reflected_radiance(white, n, directional_light{vec3<double>{std::sqrt(0.75), 0, 0.5}, 2.0}(n)) ==
          Catch::Approx(1 / pi));
    CHECK(lobe::reflected_radiance(white, n, directional_light{-n, 2.0}(n)) == 0);
}

TEST_CASE("the reflectance equation is f E cos, in any space", "[lights]") {
    random_numbers random(1);
    const lobe::microfacet brdf{lobe::ggx{lobe::alpha_xy{0.3, 0.6}}, lobe::smith_correlated{},
                                lobe::schlick{vec3<double>{1, 0.7, 0.3}}};
    double worst = 0;
    for (int i = 0; i < 1000; ++i) {
        const lobe::frame<double> at(random.direction(), random.direction());
        const vec3<double> v = random.grazing_direction(0.01),
                           position = at.to_world(random.grazing_direction(0.1)) * random.between(1, 5);
        const point_light light{position, vec3<double>{1, 2, 3}};
        const auto incident = light({0, 0, 0});
        const vec3<double> l = at.to_local(incident.l);
        const vec3<double> Lo = lobe::reflected_radiance(brdf, at, at.to_world(v), incident);
        const vec3<double> expected = brdf.f(v, l) * vec3<double>{1, 2, 3} * (l.z / lobe::dot(position, position));
        // two changes of frame move v and l by 1e-15, which D feels through 1/alpha = 3 and slopes up to 1/0.1
        worst = larger(worst, lobe::length(Lo - expected) / (lobe::length(expected) + 1e-9));
    }
    CHECK(worst < 1e-11);
    // one number times a colour, either way round
    const vec3<double> n{0, 0, 1};
    CHECK(lobe::reflected_radiance(lobe::lambert{0.5}, n, directional_light{n, vec3<double>{1, 2, 3}}(n)).z ==
          Catch::Approx(1.5 / pi));
    CHECK(lobe::reflected_radiance(lobe::lambert{vec3<double>{0.1, 0.2, 0.5}}, n, directional_light{n, 3.0}(n)).z ==
          Catch::Approx(1.5 / pi));
}

TEST_CASE("a point light's flux: 2 pi I through a plane, 4 pi I in all", "[lights]") {
    const double height = 0.7;
    const point_light light{vec3<double>{0, 0, height}, 3.0};
    const lobe::gauss_legendre<double> rule(64);
    double flux = 0;
    for (std::size_t i = 0; i < rule.x.size(); ++i) {  // rings of radius h tan(t), t to a right angle
        const double t = pi / 2 * rule.x[i], r = height * std::tan(t);
        const auto incident = light({r, 0, 0});
        flux += rule.w[i] * pi / 2 * height / (std::cos(t) * std::cos(t)) * 2 * pi * r * incident.illuminance *
                incident.l.z;
    }
    CHECK(flux == Catch::Approx(2 * pi * 3).epsilon(1e-12));
    const auto incident = light({1, 2, height + 2});
    CHECK(lobe::length(incident.l - vec3<double>{-1, -2, -2} / 3.0) < 1e-15);
    CHECK(incident.illuminance == Catch::Approx(3.0 / 9));
}

TEST_CASE("the range window is KHR_lights_punctual's", "[lights]") {
    random_numbers random(2);
    double worst = 0;
    for (int i = 0; i < 100000; ++i) {
        const float range = static_cast<float>(random.log_between(0.1, 100)), d = range * static_cast<float>(random());
        const float d2 = d * d;
        if (d == 0) continue;
        const float ratio = std::sqrt(d2) / range;
        // 1 - x magnifies the roundings of x = d2/range^2, 3 of them, by 1/(1-x)
        const double magnified = 1 + 1.0 / std::max(1e-7, 1 - static_cast<double>(ratio) * ratio);
        worst = larger(worst, ulp_error(inverse_square_within{range}(d2),
                                        printed_window(std::sqrt(static_cast<long double>(d2)), range)) /
                                  magnified);
    }
    INFO(worst << " ULP / (1 - x)");
    CHECK(worst < 4);
    for (float d : {10.0f, 10.5f, 1e3f}) CHECK(inverse_square_within{10.0f}(d * d) == 0);
    CHECK(inverse_square_within{1e6f}(4.0f) == Catch::Approx(inverse_square{}(4.0f)));
    CHECK(point_light{vec3<float>{0, 0, 3}, 2.0f, inverse_square_within{2.0f}}({0, 0, 0}).illuminance == 0);
    CHECK(point_light{vec3<float>{0, 0, 1}, 2.0f, inverse_square_within{2.0f}}({0, 0, 0}).illuminance ==
          Catch::Approx(2 * 15.0 / 16));
}

TEST_CASE("the spot falloff is KHR_lights_punctual's", "[lights]") {
    random_numbers random(3);
    double worst = 0;
    for (int i = 0; i < 100000; ++i) {
        const double outer = random.log_between(1e-3, pi / 2), inner = outer * random.between(0, 0.95),
                     angle = outer * random.between(0, 1.2);
        const vec3<double> axis = random.direction();
        const lobe::frame<double> at(axis);
        const double phi = random.between(0, 6.28);
        const vec3<double> w =
            at.to_world({std::sin(angle) * std::cos(phi), std::sin(angle) * std::sin(phi), std::cos(angle)});
        // w is known to 1e-16, its angle from the axis to 4e-16/outer: so is t, over the width of the penumbra, (1 -
        // 0.95^2)/2 of outer^2
        worst = larger(worst,
                       std::abs(cone{inner, outer}(axis, w) - static_cast<double>(printed_spot(angle, inner, outer))) *
                           outer);
    }
    INFO(worst);
    CHECK(worst < 2 * 2 * 20 * 4e-16);

    const vec3<double> down{0, 0, -1};
    const spot_light lamp{vec3<double>{0, 0, 2}, down, 5.0, cone{0.3, 0.6}};
    const auto at_angle = [&](double angle) { return lamp({2 * std::tan(angle), 0, 0}); };
    const auto plain = [](double angle) { return 5.0 * std::cos(angle) * std::cos(angle) / 4; };
    for (double angle : {0.0, 0.1, 0.29}) CHECK(at_angle(angle).illuminance == Catch::Approx(plain(angle)));
    CHECK(at_angle(0.45).illuminance == Catch::Approx(plain(0.45) * static_cast<double>(printed_spot(0.45, 0.3, 0.6))));
    CHECK(at_angle(0.61).illuminance == 0);
    CHECK(lamp({0, 0, 5}).illuminance == 0);  // behind
    CHECK(lobe::length(at_angle(0.45).l - lobe::normalize(vec3<double>{-std::tan(0.45), 0, 1})) < 1e-15);
    const spot_light short_lamp{vec3<double>{0, 0, 2}, down, 5.0, cone{0.3, 0.6}, inverse_square_within{2.5}};
    CHECK(short_lamp({0, 0, 0}).illuminance == Catch::Approx(5.0 / 4 * (1 - std::pow(0.8, 4))));
}

TEST_CASE("a narrow beam keeps its digits in float", "[lights]") {
    // 0.01 rad: cosines differ from 1 by 5e-5, 800 ULP of float; the printed listing is off by 1e-3 there, and floors
    // 1/scale.
    const cone<float> beam(0.005f, 0.01f);
    double worst = 0;
    for (int i = 0; i <= 1000; ++i) {
        const float angle = 0.012f * static_cast<float>(i) / 1000;
        const vec3<float> w{std::sin(angle), 0, std::cos(angle)};
        const long double actual = std::atan2(static_cast<long double>(w.x), static_cast<long double>(w.z));
        worst = larger(worst, std::abs(static_cast<double>(beam({0, 0, 1}, w)) -
                                       static_cast<double>(printed_spot(actual, 0.005f, 0.01f))));
    }
    INFO(worst);
    CHECK(worst < 2e-6);  // x = |w - a|^2/2 is known to 3e-7 of itself, t to 4/3 of that, t^2 to twice
}

TEMPLATE_TEST_CASE("a cone of equal angles has a hard edge", "[lights]", float, double) {
    using T = TestType;
    const T nearly = std::nextafter(T(0.3), T(1));
    // angles of glTF files: the first two are one float; a right angle as a file of floats writes it
    for (const auto& [inner, outer] :
         {std::pair{0.08968102931976317, 0.08968102931976318}, std::pair{0.3, 0.3}, std::pair{0.0, 0.0},
          std::pair{1e-6, 1e-6}, std::pair{pi / 2, pi / 2}, std::pair{1.5707963705062866, 1.5707963705062866}}) {
        const cone<T> angles{static_cast<T>(inner), static_cast<T>(outer)};
        INFO(inner << ' ' << outer);
        const T edge = static_cast<T>(outer);
        for (int i = -2000; i <= 2000; ++i) {
            const T angle = edge + T(i) * (std::max)(edge, T(1e-30)) * std::numeric_limits<T>::epsilon() / 20;
            const T lit = angles({0, 0, -1}, {std::sin(angle), 0, -std::cos(angle)});
            REQUIRE((lit == 0 || lit == 1 || static_cast<T>(inner) < edge));
            REQUIRE((lit >= 0 && lit <= 1));
        }
        for (const double part : {0.0, 0.5, 0.999})
            CHECK(angles({0, 0, 1}, {static_cast<T>(std::sin(part * outer)), 0,
                                     static_cast<T>(std::cos(part * outer))}) == (outer > 0 ? 1 : 0));
        for (const double part : {1.001, 1.5})
            if (outer > 0)
                CHECK(angles({0, 0, 1},
                             {static_cast<T>(std::sin(part * outer)), 0, static_cast<T>(std::cos(part * outer))}) == 0);
        CHECK(static_cast<double>(angles.solid_angle()) ==
              Catch::Approx(2 * pi * (1 - std::cos((std::min)(outer, pi / 2)))).epsilon(1e-6).margin(1e-15));
    }
    CHECK((cone<T>{T(0.3), nearly}({0, 0, 1}, {0, 0, 1}) == 1));
    CHECK(cone<double>{0, 1.5707963705062866}.solid_angle() == cone<double>{0, pi / 2}.solid_angle());
}

TEST_CASE("a cone's solid angle turns lumens into candela", "[lights]") {
    for (const auto& [inner, outer] : {std::pair{0.0, pi / 2}, std::pair{0.3, 0.6}, std::pair{0.001, 0.002}}) {
        const cone<double> angles(inner, outer);
        const lobe::gauss_legendre<double> rule(32);
        double integral = 0;
        for (const auto& [from, to] : {std::pair{0.0, inner}, std::pair{inner, outer}})
            for (std::size_t i = 0; i < rule.x.size(); ++i) {
                const double t = from + (to - from) * rule.x[i];
                integral +=
                    rule.w[i] * (to - from) * 2 * pi * std::sin(t) * angles({0, 0, 1}, {std::sin(t), 0, std::cos(t)});
            }
        CHECK(angles.solid_angle() == Catch::Approx(integral).epsilon(1e-9));
    }
}

TEST_CASE("lights of packs: eight points at once", "[lights]") {
    using pack = xsimd::batch<float>;
    const spot_light lamp{vec3<pack>{pack(0.0f), pack(0.0f), pack(2.0f)},
                          vec3<pack>{pack(0.0f), pack(0.0f), pack(-1.0f)}, pack(5.0f),
                          cone<pack>(pack(0.3f), pack(0.6f)), inverse_square_within<pack>(pack(10.0f))};
    const spot_light one{vec3<float>{0, 0, 2}, vec3<float>{0, 0, -1}, 5.0f, cone{0.3f, 0.6f},
                         inverse_square_within{10.0f}};
    std::vector<float> x;
    for (std::size_t i = 0; i < pack::size; ++i) x.push_back(0.3f * static_cast<float>(i));
    const auto E = lamp({pack::load_unaligned(x.data()), pack(0.1f), pack(0.0f)}).illuminance;
    for (std::size_t i = 0; i < pack::size; ++i)
        CHECK(E.get(i) == Catch::Approx(one({x[i], 0.1f, 0}).illuminance).margin(1e-6));
}

TEST_CASE("lights take no vectors of another precision", "[lights]") {
    const auto shades = []<class B, class V, class L>(const B& brdf, const V& v, const L& light) {
        return requires { lobe::reflected_radiance(brdf, v, light); };
    };
    const auto lights = []<class L, class P>(const L& light, const P& point) {
        return requires { light(point); };
    };
    const lobe::lambert brdf{0.5f};
    const vec3<float> n{0, 0, 1};
    const vec3<double> wide{0, 0, 1};
    const directional_light sun{n, 1.0f};
    const point_light bulb{n, 1.0f};
    const spot_light lamp{n, -n, 1.0f, cone{0.3f, 0.6f}};
    CHECK((lights(sun, n) && lights(bulb, n) && lights(lamp, n)));
    CHECK((!lights(sun, wide) && !lights(bulb, wide) && !lights(lamp, wide)));
    CHECK(shades(brdf, n, sun(n)));
    CHECK((!shades(brdf, wide, sun(n)) && !shades(brdf, n, directional_light{wide, 1.0}(wide)) &&
           !shades(lobe::lambert{0.5}, n, sun(n))));
    const lobe::frame<float> at(n);
    const auto shades_at = []<class B, class A, class V, class L>(const B& b, const A& frame, const V& v,
                                                                  const L& light) {
        return requires { lobe::reflected_radiance(b, frame, v, light); };
    };
    CHECK(shades_at(brdf, at, n, sun(n)));
    CHECK((!shades_at(brdf, at, wide, sun(n)) && !shades_at(brdf, lobe::frame<double>(wide), n, sun(n))));
}

TEST_CASE("lights: sizes, and bad parameters end in an assert", "[lights]") {
    static_assert(sizeof(point_light<float, float>) == 16);
    static_assert(sizeof(spot_light<vec3<float>, float>) == 48);
    const float nan = std::numeric_limits<float>::quiet_NaN();
    CHECK_FALSE(aborts([] { (void)cone(0.0f, 1.57f); }));
    for (const float bad : {0.0f, -1.0f, nan}) CHECK(aborts([&] { (void)inverse_square_within(bad); }));
    for (const float bad : {-1.0f, nan}) CHECK(aborts([&] { (void)cone(0.0f, bad); }));
    CHECK_FALSE(aborts([] { (void)cone(0.5f, 0.5f); }));
    CHECK(aborts([] { (void)cone(0.5f, 0.4f); }));
    CHECK(aborts([] { (void)cone(0.0, 1.570797); }));
    CHECK(aborts([] { (void)cone(-0.1f, 0.5f); }));
    CHECK(aborts([] { (void)cone(0.1f, 1.6f); }));
    CHECK(aborts([&] { (void)cone(nan, 0.5f); }));
}
