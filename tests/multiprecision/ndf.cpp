// Distributions on 50 digits: what rounding does to them in float and double, and closed areas against their own
// integrals.
#include "../catch.hpp"
#include "digits50.hpp"

#include <lobe/ndf/abc.hpp>
#include <lobe/ndf/beckmann.hpp>
#include <lobe/ndf/blinn_phong.hpp>
#include <lobe/ndf/exponential_power.hpp>
#include <lobe/ndf/gtr.hpp>
#include <lobe/ndf/mixture.hpp>
#include <lobe/ndf/phong.hpp>
#include <lobe/ndf/sgd.hpp>
#include <lobe/ndf/sggx.hpp>

#include <boost/math/special_functions.hpp>

using lobe::vec3;

namespace {

/// D of a radial shape under a width, without the table of its area.
template <class Shape, class Width>
auto density(const Shape& shape, const Width& width, const vec3<typename Width::scalar>& m) {
    return lobe::radial_profile<Shape, typename Width::scalar>(shape).D(m, width);
}

/// The worst error of D in units of 1 + |ln(D pi ax ay)| ULP, of the shapes that `make(a)` gives; on one width, or on
/// two.
template <class T, class MakeShape>
double worst_density(const MakeShape& make, std::uint64_t seed, int count, bool anisotropic = false) {
    random_numbers random(seed);
    double worst = 0;
    for (int i = 0; i < count; ++i) {
        const T a = static_cast<T>(random.log_between(1e-4, 1)),
                b = anisotropic ? static_cast<T>(random.log_between(1e-4, 1)) : a;
        const double s = random.log_between(1e-8, 1), phi = random.between(0, 6.28), scale = random.log_between(0.1, 2);
        const vec3<T> m{static_cast<T>(scale * s * std::cos(phi)), static_cast<T>(scale * s * std::sin(phi)),
                        static_cast<T>(scale * std::sqrt((1 - s) * (1 + s)))};
        const digits50 ax(a), ay(b), truth = density(make(ax), lobe::alpha_xy<digits50>(ax, ay), exact(m));
        // below the smallest number of the peak, D is zero or has few digits
        if (!(truth * ax * ay > std::numeric_limits<T>::min())) continue;
        const T value =
            anisotropic ? density(make(a), lobe::alpha_xy<T>(a, b), m) : density(make(a), lobe::alpha<T>(a), m);
        const double conditioning = 1 + std::abs(static_cast<double>(log(truth * lobe::pi<digits50>() * ax * ay)));
        worst = larger(worst, ulps(value, truth) / conditioning);
    }
    return worst;
}

struct bound_on_density {
    std::string name;
    double worst, stated;
};

}  // namespace

TEMPLATE_TEST_CASE("rounding errors of D", "[multiprecision][ndf]", float, double) {
    using T = TestType;
    // tau carries six roundings (two squares, a sum, a width that is squared, a quotient) and ln D feels each times
    // tau, or p tau, which is up to 2.5 more than |ln D| where cos^-4 moves D the other way
    std::vector<bound_on_density> all;
    // make(a, x): the shape of width a with the parameter x, which is exact in every type
    const auto add = [&](const std::string& name, double parameter, double stated, const auto& make, bool invariant,
                         int count = 1500) {
        const auto shape = [&]<class U>(const U& a) { return make(a, U(parameter)); };
        const std::string full = name + ' ' + std::to_string(parameter);
        all.push_back({full, worst_density<T>(shape, all.size() + 1, count), stated});
        if (invariant)
            all.push_back({full + ", anisotropic", worst_density<T>(shape, all.size() + 1, count, true), stated});
    };
    add(
        "beckmann", 0, 10, []<class U>(const U&, const U&) { return lobe::beckmann_shape<U>{}; }, true);
    for (double gamma : {1.625, 1.75, 2.0, 3.0, 10.0, 40.0})
        add(
            "student_t", gamma, 10, []<class U>(const U&, const U& x) { return lobe::student_t_shape<U>(x); }, true);
    for (double p : {0.25, 0.5, 1.0, 2.0, 4.0})
        add(
            "exponential_power", p, 12 * std::max(1.0, p),
            []<class U>(const U&, const U& x) { return lobe::exponential_power_shape<U>(x); }, true);
    add(
        "blinn_phong", 0, 12,
        []<class U>(const U& a, const U&) { return lobe::student_t_shape<U>::from_k(U(1) / (a * a)); }, false);
    for (double gamma : {0.5, 1.0, 1.5, 2.0, 3.0, 5.0})
        add(
            "gtr", gamma, 12, []<class U>(const U& a, const U& x) { return lobe::gtr_shape<U>(a, x); }, false);
    for (double C : {0.5, 1.0, 1.5, 2.0, 3.0, 10.0})
        add(
            "abc", C, 12, []<class U>(const U& a, const U& x) { return lobe::abc_shape<U>(a, x); }, false);
    for (double p : {0.0, 0.5, 1.0, 2.0, 4.0})
        add(
            "sgd", p, std::same_as<T, float> ? 10 : 10 + 1e-14 / 0x1p-53,
            []<class U>(const U& a, const U& x) { return lobe::sgd_shape<U>(a, x); }, false, 500);
    for (const auto& [name, worst, stated] : all) {
        INFO(name << ": " << worst << " ULP per 1 + |ln(D pi alpha^2)|");
        CHECK(worst <= stated);
    }
}

TEMPLATE_TEST_CASE("Phong's D up to 45 degrees", "[multiprecision][ndf]", float, double) {
    using T = TestType;
    random_numbers random(10);
    double worst = 0, transcribed = 0;
    for (int i = 0; i < 5000; ++i) {
        const T a = static_cast<T>(i % 2 ? random.log_between(1e-2, 1) : random.between(0.9, 1));
        const double theta = 0.7853981633974483 - random.log_between(std::same_as<T, float> ? 1e-6 : 1e-14, 0.7),
                     phi = random.between(0, 6.28);
        const vec3<T> m{static_cast<T>(std::sin(theta) * std::cos(phi)),
                        static_cast<T>(std::sin(theta) * std::sin(phi)), static_cast<T>(std::cos(theta))};
        const vec3<digits50> w = exact(m);
        const lobe::alpha<digits50> width{digits50(a)};
        const digits50 r2 = w.x * w.x + w.y * w.y, z2 = w.z * w.z, cosine = (z2 - r2) / (z2 + r2),
                       D = density(lobe::phong_shape(width.value()), width, w);
        const digits50 of_peak = D * lobe::pi<digits50>() * width.value() * width.value();
        if (!(cosine > 16 * std::numeric_limits<T>::epsilon()) || !(of_peak > std::numeric_limits<T>::min())) continue;
        const digits50 n = lobe::phong_exponent_from_alpha(width),
                       printed = 2 * (n + 1) / lobe::pi<digits50>() * pow(cosine, n);
        const double conditioning = (1 + std::abs(static_cast<double>(log(of_peak)))) / static_cast<double>(cosine);
        worst = larger(worst, ulps(density(lobe::phong_shape<T>(a), lobe::alpha<T>(a), m), D) / conditioning);
        transcribed = larger(transcribed, static_cast<double>(abs(D / printed - 1)) / conditioning);
    }
    INFO(worst << " ULP per (1 + |ln(D pi alpha^2)|) / cos(2 theta); printed " << transcribed);
    CHECK(worst <= 10);
    CHECK(transcribed < 1e-48);
}

TEST_CASE("rounding errors of closed projected areas and Lambda", "[multiprecision][ndf]") {
    random_numbers random(9);
    double area = 0, lambda = 0, student = 0, student_lambda = 0, walter = 0, flakes = 0, flakes_area = 0,
           area_float = 0;
    for (int i = 0; i < 3000; ++i) {
        const double ax = random.log_between(1e-4, 1), ay = random.log_between(1e-4, 1);
        const vec3<double> v = random.grazing_direction(1e-6), m = random.direction();
        const lobe::alpha_xy<double> width{ax, ay};
        const lobe::alpha_xy<digits50> wide{digits50(ax), digits50(ay)};
        const lobe::beckmann ndf{width};
        const lobe::beckmann truth{wide};
        area = larger(area, ulps(ndf.projected_area(v), truth.projected_area(exact(v))));
        const digits50 L = truth.lambda(exact(v)),
                       cot = digits50(v.z) / sqrt(pow(digits50(ax) * v.x, 2) + pow(digits50(ay) * v.y, 2));
        if (cot < 8) lambda = larger(lambda, std::abs(static_cast<double>(digits50(ndf.lambda(v)) / L - 1)));
        walter = larger(walter, ulps(lobe::beckmann_walter{width}.projected_area(v),
                                     lobe::beckmann_walter{wide}.projected_area(exact(v))));
        const vec3<float> vf(v);
        const float axf = static_cast<float>(ax), ayf = static_cast<float>(ay);
        area_float = larger(
            area_float, ulps(lobe::beckmann{lobe::alpha_xy{axf, ayf}}.projected_area(vf),
                             lobe::beckmann{lobe::alpha_xy{digits50(axf), digits50(ayf)}}.projected_area(exact(vf))));
        flakes = larger(flakes, ulps(lobe::sggx{width}.D(m), lobe::sggx{wide}.D(exact(m))));
        flakes_area =
            larger(flakes_area, ulps(lobe::sggx{width}.projected_area(m), lobe::sggx{wide}.projected_area(exact(m))));
        if (i % 20 == 0) {
            for (double gamma : {1.6, 1.75, 2.0, 3.0, 10.0, 1000.0}) {
                const lobe::student_t one{width, gamma};
                const lobe::student_t other{wide, digits50(gamma)};
                const digits50 sigma = other.projected_area(exact(v)), back = sigma - v.z;
                student = larger(student, std::abs(static_cast<double>(digits50(one.projected_area(v)) / sigma - 1)));
                if (back > 1e-6 * v.z)
                    student_lambda =
                        larger(student_lambda,
                               std::abs(static_cast<double>(digits50(one.lambda(v)) / other.lambda(exact(v)) - 1)));
            }
        }
    }
    INFO("Beckmann: area " << area << " ULP, float " << area_float << ", Lambda " << lambda << "; Walter " << walter
                           << " ULP; Student-t: area " << student << ", Lambda " << student_lambda << "; SGGX: D "
                           << flakes << " ULP, area " << flakes_area);
    CHECK(area <= 4);
    CHECK(area_float <= 4);
    CHECK(lambda < 4e-14);
    CHECK(walter <= 6);
    CHECK(student < 1e-14);
    CHECK(student_lambda < 1e-12);
    CHECK(flakes <= 16);
    CHECK(flakes_area <= 4);
}

TEST_CASE("SGD on 50 digits is normalised by the exponential integral", "[multiprecision][ndf]") {
    // Gamma(1-p, a) = a^(1-p) E_p(a), and erfc for p = 1/2: Boost's, not ours. At the normal D = exp(-a) a^-p / (pi a
    // Gamma a^(1-p)).
    for (const char* width : {"0.001", "0.1", "0.9", "1.5"}) {
        const digits50 a(width), flat = exp(-a) / (lobe::pi<digits50>() * a);
        const auto peak = [&](const digits50& p) {
            return density(lobe::sgd_shape(a, p), lobe::alpha<digits50>(a), {digits50(0), digits50(0), digits50(1)});
        };
        for (unsigned p : {1u, 2u, 4u})
            CHECK(abs(peak(digits50(p)) * a * boost::math::expint(p, a) / flat - 1) < digits50("1e-45"));
        CHECK(abs(peak(digits50("0.5")) * sqrt(a * lobe::pi<digits50>()) * erfc(sqrt(a)) / flat - 1) <
              digits50("1e-45"));
    }
}

TEST_CASE("families meet on 50 digits", "[multiprecision][ndf]") {
    const lobe::alpha<digits50> a(digits50("0.3"));
    const vec3<digits50> m{digits50("0.2"), digits50("0.1"), digits50("0.7")},
        v{digits50("0.6"), digits50(0), digits50("0.8")};
    // Lambda by independent quadrature, whose ten digits are right
    const digits50 mu("0.4");
    const vec3<digits50> w{sqrt(1 - mu * mu), digits50(0), mu};
    CHECK(abs(lobe::blinn_phong{lobe::alpha<digits50>(digits50("0.4"))}.lambda(w) - digits50("0.02720671867")) <
          digits50("5e-12"));
    // Student-t tends to Beckmann as 1/gamma
    const lobe::beckmann beckmann{a};
    digits50 last = 1;
    for (const char* gamma : {"10", "100", "1000", "10000"}) {
        const lobe::student_t t{a, digits50(gamma)};
        const digits50 apart = abs(t.D(m) / beckmann.D(m) - 1) + abs(t.projected_area(v) - beckmann.projected_area(v));
        CHECK(apart < last / 8);
        CHECK(apart > last / 200);
        last = apart;
    }
    const lobe::mixture both{beckmann, lobe::student_t{a, digits50("2.5")}, digits50("0.25")};
    CHECK(abs(both.D(m) - (3 * beckmann.D(m) + lobe::student_t{a, digits50("2.5")}.D(m)) / 4) < digits50("1e-45"));
    // the inverse CDF and the survival undo each other
    const digits50 u("0.37");
    const lobe::gtr_shape<digits50> gtr(digits50("0.3"), digits50("1.5"));
    CHECK(abs(1 - gtr.survival(gtr.tan2(u)) - u) < digits50("1e-45"));
    const lobe::phong_shape<digits50> phong(digits50("0.3"));
    CHECK(abs(1 - phong.survival(phong.tan2(u)) - u) < digits50("1e-45"));
    const lobe::student_t_shape<digits50> student(digits50("2.5"));
    CHECK(abs(1 - student.survival(student.tan2(u)) - u) < digits50("1e-45"));
    const lobe::exponential_power_shape<digits50> epd(digits50("0.5"));
    CHECK(abs(1 - epd.survival(epd.tan2(u)) - u) < digits50("1e-40"));
}
