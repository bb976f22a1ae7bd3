// The same templates on 50 digits: what rounding does to float and double, without the code's own formulas being in
// doubt (those are compared with independent tables elsewhere).
#include "../catch.hpp"
#include "digits50.hpp"

#include <lobe/lobe.hpp>

using lobe::vec2;
using lobe::vec3;

TEST_CASE("pi has 100 digits where T has room", "[multiprecision]") {
    CHECK(abs(lobe::pi<digits50>() - boost::math::constants::pi<digits50>()) < digits50("1e-49"));
    CHECK(lobe::pi<double>() == 3.141592653589793);
}

TEMPLATE_TEST_CASE("rounding errors over the whole domain", "[multiprecision]", float, double) {
    using T = TestType;
    random_numbers random(1);
    double D = 0, D_aniso = 0, area = 0, area_aniso = 0, lambda = 0, visibility = 0, schlick = 0, f_cos = 0;
    for (int i = 0; i < 20000; ++i) {
        const T ax = static_cast<T>(random.log_between(1e-4, 1)), ay = static_cast<T>(random.log_between(1e-4, 1));
        const lobe::ggx iso{lobe::alpha<T>(ax)};
        const lobe::ggx iso_exact{lobe::alpha<digits50>(digits50(ax))};
        const lobe::ggx aniso{lobe::alpha_xy<T>(ax, ay)};
        const lobe::ggx aniso_exact{lobe::alpha_xy<digits50>(digits50(ax), digits50(ay))};

        // m from 1e-8 off the normal to the horizon, of any length
        const double s = random.log_between(1e-8, 1), phi = random.between(0, 6.28), scale = random.log_between(0.1, 2);
        const vec3<T> m{static_cast<T>(scale * s * std::cos(phi)), static_cast<T>(scale * s * std::sin(phi)),
                        static_cast<T>(scale * std::sqrt((1 - s) * (1 + s)))};
        D = larger(D, ulps(iso.D(m), iso_exact.D(exact(m))));
        D_aniso = larger(D_aniso, ulps(aniso.D(m), aniso_exact.D(exact(m))));

        const vec3<T> v = random.grazing_direction<T>(1e-6), l = random.grazing_direction<T>(1e-6);
        for (const vec3<T>& w : {v, -v}) {
            area = larger(area, ulps(iso.projected_area(w), iso_exact.projected_area(exact(w))));
            area_aniso = larger(area_aniso, ulps(aniso.projected_area(w), aniso_exact.projected_area(exact(w))));
            lambda = larger(lambda, ulps(iso.lambda(w), iso_exact.lambda(exact(w))));
        }
        visibility = larger({visibility,
                             ulps(lobe::smith_correlated{}.visibility(iso, v, l),
                                  lobe::smith_correlated{}.visibility(iso_exact, exact(v), exact(l))),
                             ulps(lobe::smith_separable{}.visibility(iso, v, l),
                                  lobe::smith_separable{}.visibility(iso_exact, exact(v), exact(l)))});
        const T F0 = static_cast<T>(random()), u = static_cast<T>(random());
        schlick = larger(schlick, ulps(lobe::schlick{F0}(u), lobe::schlick{digits50(F0)}(digits50(u))));

        // The whole of f_cos where v + l does not cancel: v and l less than 120 degrees apart.
        if (lobe::dot(v, l) > T(-0.5)) {
            const lobe::microfacet brdf{iso, lobe::smith_correlated{}, lobe::schlick{F0}};
            const lobe::microfacet brdf_exact{iso_exact, lobe::smith_correlated{}, lobe::schlick{digits50(F0)}};
            const digits50 truth = brdf_exact.f_cos(exact(v), exact(l));
            // Adding v and l rounds each slope of s by half an ULP of its larger term: conditioned by |v_x|/|s_x|. D
            // sees that as long as the slope matters beside alpha.
            const digits50 conditioning =
                (abs(digits50(v.x)) + abs(digits50(v.y))) / (digits50(ax) * (digits50(v.z) + digits50(l.z)));
            f_cos = larger(f_cos, ulps(brdf.f_cos(v, l), truth) / (1 + static_cast<double>(conditioning) / 8));
        }
    }
    INFO("D " << D << ", anisotropic " << D_aniso << "; area " << area << ", " << area_aniso << "; Lambda " << lambda
              << "; visibility " << visibility << "; Schlick " << schlick << "; f_cos " << f_cos);
    CHECK(D <= 12);
    CHECK(D_aniso <= 12);
    CHECK(area <= 5);  // what the header states; a million points of both sides of the horizon are in ggx.cpp
    CHECK(area_aniso <= 5);
    CHECK(lambda <= 8);
    CHECK(visibility <= 8);
    CHECK(schlick <= 8);
    CHECK(f_cos <= 32);
}

TEST_CASE("fifty digits through sampling, and an albedo to the quadrature's limit", "[multiprecision]") {
    const lobe::microfacet brdf{lobe::ggx{lobe::alpha<digits50>(digits50(1))}, lobe::smith_correlated{},
                                lobe::perfect_reflector{}};
    const lobe::microfacet in_double{lobe::ggx{lobe::alpha<double>(1)}, lobe::smith_correlated{},
                                     lobe::perfect_reflector{}};
    const digits50 mu("0.5");
    const vec3<digits50> v{sqrt(digits50("0.75")), digits50(0), mu};
    const auto s = brdf.sample(v, vec2<digits50>{digits50("0.3"), digits50("0.7")});
    const auto d = in_double.sample(vec3<double>{std::sqrt(0.75), 0, 0.5}, vec2<double>{0.3, 0.7});
    CHECK(static_cast<double>(s.l.x) == Catch::Approx(d.l.x).epsilon(1e-14));
    CHECK(static_cast<double>(s.weight) == Catch::Approx(d.weight).epsilon(1e-14));
    CHECK(abs(s.pdf * s.weight / brdf.f_cos(v, s.l) - 1) < digits50("1e-47"));
    // E = 1 - mu ln(1 + 1/mu) at alpha 1
    const auto E = lobe::directional_albedo(brdf, mu, {.order = 24});
    CHECK(abs(E.value - (1 - mu * log(1 + 1 / mu))) < digits50("1e-9"));
}
