// The diffuse models, widths and lights on 50 digits: what rounding costs them in float and double.
#include "../catch.hpp"
#include "digits50.hpp"

#include <lobe/brdf/burley.hpp>
#include <lobe/brdf/eon.hpp>
#include <lobe/brdf/lambert.hpp>
#include <lobe/brdf/oren_nayar.hpp>
#include <lobe/lights/punctual.hpp>
#include <lobe/width/antialiasing.hpp>

using lobe::vec3;

TEMPLATE_TEST_CASE("what FON loses, against the paper's form on 50 digits", "[multiprecision]", float, double) {
    using T = TestType;
    random_numbers random(1);
    double worst = 0;
    const digits50 pi = lobe::pi<digits50>(), third = digits50(1) / 3, c1 = digits50(1) / 2 - 2 * third / pi;
    for (int i = 0; i < 20000; ++i) {
        const vec3<T> w = i % 2 ? random.grazing_direction<T>(1e-6)
                                : lobe::normalize(vec3<T>{static_cast<T>(random.log_between(1e-6, 1)), 0, 1});
        // w is unit to rounding only: the angle that both sides mean is the one of its direction
        const digits50 h = sqrt(digits50(w.x) * w.x + digits50(w.y) * w.y), length = sqrt(h * h + digits50(w.z) * w.z),
                       mu = w.z / length, S = h / length;
        const digits50 G = S * (acos(mu) - S * mu) + 2 * third * (S / mu * (1 - S * S * S) - S);
        worst = larger(worst, ulps(lobe::fon_loss{}(w), c1 - G / pi));
    }
    INFO(worst << " ULP");
    CHECK(worst <= 8);
}

TEMPLATE_TEST_CASE("rounding errors of the diffuse models", "[multiprecision]", float, double) {
    using T = TestType;
    random_numbers random(2);
    double oren_nayar = 0, fon = 0, eon = 0, eon_fit = 0, burley = 0, frostbite = 0;
    for (int i = 0; i < 20000; ++i) {
        const T rho = static_cast<T>(random.between(0.01, 1)), r = static_cast<T>(random());
        const digits50 rho_exact(rho), r_exact(r);
        const vec3<T> v = random.grazing_direction<T>(1e-6), l = random.grazing_direction<T>(1e-6);
        const auto look = [&](double& worst, const auto& brdf, const auto& truth, const digits50& unit) {
            const digits50 f = truth.f(exact(v), exact(l)), f_cos = truth.f_cos(exact(v), exact(l));
            worst = larger(worst, ulps(brdf.f(v, l), f, lobe::larger(f, unit)));
            worst = larger(worst, ulps(brdf.f_cos(v, l), f_cos, lobe::larger(f_cos, digits50(unit * digits50(l.z)))));
        };
        // s = v.x l.x + v.y l.y cancels where the azimuths are a quarter turn apart: it is right to the ULP of its
        // terms, which f multiplies by r rho A/(pi max(mu)); A >= 0.56, B <= r
        const digits50 unit = rho_exact / 5,
                       s = abs(digits50(v.x) * digits50(l.x)) + abs(digits50(v.y) * digits50(l.y));
        const digits50 rough = unit * (1 + r_exact * s / lobe::larger(digits50(v.z), digits50(l.z)));
        look(oren_nayar, lobe::oren_nayar{rho, r}, lobe::oren_nayar{rho_exact, r_exact}, rough);
        look(fon, lobe::fon{rho, r}, lobe::fon{rho_exact, r_exact}, rough);
        look(eon, lobe::eon{rho, r}, lobe::eon{rho_exact, r_exact}, rough);
        look(eon_fit, lobe::eon{rho, r, lobe::fon_loss_fit{}}, lobe::eon{rho_exact, r_exact, lobe::fon_loss_fit{}},
             rough);
        look(burley, lobe::burley{rho, r}, lobe::burley{rho_exact, r_exact}, unit);
        look(frostbite, lobe::burley_frostbite{rho, r}, lobe::burley_frostbite{rho_exact, r_exact}, unit);
    }
    INFO("Oren-Nayar " << oren_nayar << ", FON " << fon << ", EON " << eon << ", with the fit " << eon_fit
                       << "; Burley " << burley << ", Frostbite " << frostbite);
    CHECK(oren_nayar <= 8);
    CHECK(fon <= 8);
    CHECK(eon <= 8);
    CHECK(eon_fit <= 8);
    CHECK(burley <= 12);
    CHECK(frostbite <= 12);
}

TEMPLATE_TEST_CASE("rounding errors of the rough diffuse samplers' pdf and weight", "[multiprecision]", float, double) {
    using T = TestType;
    random_numbers random(4);
    double pdf = 0, weight = 0, length = 0;
    for (int i = 0; i < 5000; ++i) {
        const T r = static_cast<T>(random()), rho(1);
        const vec3<T> v = random.grazing_direction<T>(1e-6), l = random.grazing_direction<T>(1e-6);
        const lobe::vec2<T> u{static_cast<T>(random()) * T(0.999f), static_cast<T>(random()) * T(0.999f)};
        const auto look = [&](const auto& brdf, const auto& truth) {
            // s is right to the ULP of its terms, which the second lobe multiplies by peak/(sin(theta_l) max(mu))
            const digits50 terms = abs(digits50(v.x) * digits50(l.x)) + abs(digits50(v.y) * digits50(l.y));
            const digits50 sine = sqrt(digits50(l.x) * digits50(l.x) + digits50(l.y) * digits50(l.y));
            const digits50 peak = truth.backscattered().peak, higher = lobe::larger(digits50(v.z), digits50(l.z));
            const digits50 second = digits50(l.z) / 4 * peak * terms / (sine * higher);
            const digits50 density = truth.pdf(exact(v), exact(l));
            pdf = larger(pdf, ulps(brdf.pdf(v, l), density, lobe::larger(density, second)));
            const auto s = brdf.sample(v, u);
            const auto e = truth.evaluate(exact(v), exact(s.l));
            weight = larger(weight, ulps(s.weight, e.f_cos / e.pdf, digits50(1)));
            length = larger(length, ulps(T(1), sqrt(lobe::dot(exact(s.l), exact(s.l)))));
            const auto t = truth.sample(exact(v), {digits50(u.x), digits50(u.y)});  // unit, on 50 digits
            const vec3<digits50> view = exact(v);
            CHECK(abs(lobe::dot(t.l, t.l) - 1) < 20 * abs(lobe::dot(view, view) - 1) + digits50("1e-45"));
        };
        look(lobe::oren_nayar{rho, r}, lobe::oren_nayar{digits50(rho), digits50(r)});
        look(lobe::fon{rho, r}, lobe::fon{digits50(rho), digits50(r)});
        look(lobe::eon{rho, r}, lobe::eon{digits50(rho), digits50(r)});
    }
    INFO("pdf " << pdf << ", weight " << weight << ", length of l " << length << " ULP");
    CHECK(pdf <= 8);
    CHECK(weight <= 8);
    CHECK(length <= 4);
}

TEMPLATE_TEST_CASE("rounding errors of widths and lights", "[multiprecision]", float, double) {
    using T = TestType;
    using D = digits50;
    random_numbers random(3);
    double disney = 0, imageworks = 0, openpbr = 0, widened = 0, window = 0;
    for (int i = 0; i < 20000; ++i) {
        const T r = static_cast<T>(random.log_between(1e-2, 1)), a = static_cast<T>(random()), k = T(2) * a - T(1);
        const auto compare = [](double& worst, const lobe::alpha_xy<T>& width, const lobe::alpha_xy<D>& truth) {
            worst = larger({worst, ulps(width.x(), truth.x()), ulps(width.y(), truth.y())});
        };
        compare(disney, lobe::alpha_xy<T>::from_disney(r, a), lobe::alpha_xy<D>::from_disney(D(r), D(a)));
        compare(imageworks, lobe::alpha_xy<T>::from_imageworks(r, k), lobe::alpha_xy<D>::from_imageworks(D(r), D(k)));
        compare(openpbr, lobe::alpha_xy<T>::from_openpbr(r, a), lobe::alpha_xy<D>::from_openpbr(D(r), D(a)));
        widened = larger(widened, ulps(lobe::widened(lobe::alpha<T>(r), a).value(),
                                       lobe::widened(lobe::alpha<D>(D(r)), D(a)).value()));
        const T range = static_cast<T>(random.log_between(0.1, 100)),
                d2 = range * range * static_cast<T>(random.between(0.01, 0.9));
        window =
            larger(window, ulps(lobe::inverse_square_within{range}(d2), lobe::inverse_square_within{D(range)}(D(d2))) *
                               (1 - static_cast<double>(d2 / (range * range))));
    }
    INFO("Disney " << disney << ", Imageworks " << imageworks << ", OpenPBR " << openpbr << "; widened " << widened
                   << "; window " << window);
    CHECK(disney <= 5);
    CHECK(imageworks <= 2);
    CHECK(openpbr <= 4);
    CHECK(widened <= 2);
    CHECK(window <= 8);
}

TEST_CASE("lights and lambert on 50 digits", "[multiprecision]") {
    const lobe::spot_light lamp{vec3<digits50>{digits50(0), digits50(0), digits50(2)},
                                vec3<digits50>{digits50(0), digits50(0), digits50(-1)}, digits50(5),
                                lobe::cone{digits50("0.3"), digits50("0.6")}};
    const auto incident = lamp({digits50(1), digits50(0), digits50(0)});  // atan(1/2) = 0.4636 from the axis
    const digits50 cosine = 2 / sqrt(digits50(5)),
                   t = (cosine - cos(digits50("0.6"))) / (cos(digits50("0.3")) - cos(digits50("0.6")));
    CHECK(abs(incident.illuminance - t * t) < digits50("1e-47"));
    const lobe::lambert white{digits50(1)};
    const vec3<digits50> n{digits50(0), digits50(0), digits50(1)};
    CHECK(abs(lobe::reflected_radiance(white, n, incident) - t * t * cosine / lobe::pi<digits50>()) <
          digits50("1e-47"));
}
