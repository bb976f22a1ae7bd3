// Distributions at the ends of their domains, where tests of the whole domain have few points.
#include "catch.hpp"
#include "support.hpp"

#include <lobe/ndf/abc.hpp>
#include <lobe/ndf/beckmann.hpp>
#include <lobe/ndf/blinn_phong.hpp>
#include <lobe/ndf/exponential_power.hpp>
#include <lobe/ndf/sgd.hpp>
#include <lobe/ndf/sggx.hpp>
#include <lobe/ndf/student_t.hpp>

using lobe::alpha;
using lobe::vec2;
using lobe::vec3;
using real = long double;

namespace {

constexpr double pi = 3.141592653589793;

/// back(a) of Student-t by its definition, int (x - a) P(x) dx over x > a: P, the slopes along one axis, falls as (1 +
/// x^2/k)^-(k + 1/2).
real back_by_definition(real k, real a) {
    const auto P = [&](real x) { return std::exp(-(k + 0.5L) * std::log1p(x * x / k)); };
    const real scale = 1 / std::max<real>(1, 2 * a);  // of x - a, beyond which P falls
    const real all = 2 * lobe::detail::integral_to_infinity<real>(1, P);
    return lobe::detail::integral_to_infinity<real>(scale, [&](real x) { return x * P(a + x); }) / all;
}

struct area_errors {
    double area = 0, lambda = 0;
};

/// Relative errors of the projected area and of Lambda against the same in long double, for cosines around the width.
template <class T, class Make>
area_errors worst_area(T a, const Make& make, double least_lambda) {
    const auto ndf = make(a);
    const auto exact = make(static_cast<real>(a));
    area_errors worst;
    for (int i = 0; i < 2000; ++i) {
        const T z = a * static_cast<T>(std::pow(10.0, -2 + i * 3.5 / 2000));
        if (!(z < 1)) break;
        const T s = std::sqrt((1 - z) * (1 + z));
        const vec3<real> w{s, 0, z};
        worst.area = larger(worst.area,
                            static_cast<double>(std::abs(ndf.projected_area({s, 0, z}) / exact.projected_area(w) - 1)));
        const real lambda = exact.lambda(w);
        if (lambda > least_lambda)
            worst.lambda = larger(worst.lambda, static_cast<double>(std::abs(ndf.lambda({s, 0, z}) / lambda - 1)));
    }
    return worst;
}

}  // namespace

TEST_CASE("Student-t and Blinn-Phong: the closed area is its integral", "[ndf_extremes]") {
    for (real k : {0.6L, 1.0L, 2.0L, 11.0L, 100.0L, 1e4L, 1e6L})
        for (real a : {0.0L, 0.1L, 0.7L, 1.2L, 1.3L, 2.0L, 3.0L}) {
            const real closed = lobe::student_t_shape<real>::from_k(k).back(a), integral = back_by_definition(k, a);
            INFO("k " << k << ", a " << a);
            // the quadrature's: 1e-9, twice, near enough
            CHECK(std::abs(static_cast<double>(closed / integral - 1)) < 1e-8);
        }
}

TEMPLATE_TEST_CASE("Student-t and Blinn-Phong keep the digits of their areas at every exponent", "[ndf_extremes]",
                   float, double) {
    using T = TestType;
    constexpr bool single = std::is_same_v<T, float>;
    const double stated_area = single ? 3e-7 : 1e-14, stated_lambda = single ? 2e-6 : 1e-12,
                 least_lambda = single ? 1e-4 : 1e-12;
    const auto check = [&](const area_errors& worst, const std::string& name, double parameter) {
        INFO(name << ' ' << parameter << ": area " << worst.area << ", Lambda " << worst.lambda);
        CHECK(worst.area < stated_area);
        CHECK(worst.lambda < stated_lambda);
    };
    for (double a : {1e-4, 1e-3, 1e-2, 0.1, 0.3, 1.0})
        check(worst_area(
                  static_cast<T>(a), []<class U>(U x) { return lobe::blinn_phong{alpha<U>(x)}; }, least_lambda),
              "blinn_phong", a);
    for (double gamma : {1.5625, 3.0, 40.0, 1e3, 1e4, 1e6}) {
        const auto make = [&]<class U>(U x) { return lobe::student_t{alpha<U>(x), static_cast<U>(gamma)}; };
        check(worst_area(T(0.3f), make, least_lambda), "student_t", gamma);
    }
}

TEST_CASE("exponential power draws the slopes of its own distribution for every p", "[ndf_extremes]") {
    double worst = 0;
    for (double p : {0.1, 0.25, 0.5, 1.0, 2.0, 4.0, 5.5, 6.0, 8.0, 10.0, 50.0}) {
        const lobe::exponential_power_shape<double> shape(p);
        for (double u : {1e-6, 0.01, 0.3, 0.49, 0.5, 0.51, 0.55, 0.6, 0.7, 0.9, 0.999, 1 - 1e-9})
            worst = larger(worst, std::abs(1 - shape.survival(shape.tan2(u)) - u));
        // even slopes within a disk of slope 1 in the limit of large p: tan^2 = u
        if (p == 50) CHECK(shape.tan2(0.25) == Catch::Approx(0.25 / std::tgamma(1 - 1 / (p + 1))).epsilon(0.01));
    }
    CHECK(worst < 1e-13);  // survival is right to 1e-14, and steps of Newton's method below 2e-9 leave their square
}

TEST_CASE("rounding of D at wide widths and small exponents", "[ndf_extremes]") {
    const auto direction = [](int i) {
        const float z = std::pow(10.0f, -4 * static_cast<float>(i) / 4000);
        return vec3<float>{std::sqrt((1 - z) * (1 + z)), 0, z};
    };
    // abc in float: its normalisation is a difference of near equals
    double worst_abc = 0;
    for (float a : {1e-3f, 0.3f, 3.0f, 10.0f, 30.0f, 100.0f})
        for (float C : {0.0f, 0.5f, 1.0f, 2.0f, 5.0f}) {
            const lobe::abc_shape<float> shape(a, C);
            const lobe::abc_shape<real> exact(a, C);
            for (int i = 0; i < 4000; i += 3) {
                const auto m = direction(i);
                const vec3<real> wide(m.x, m.y, m.z);
                const double D =
                    static_cast<double>(lobe::radial_profile<decltype(exact), real>(exact).D(wide, alpha<real>(a)));
                if (!(D > 1e-35)) continue;
                const float value = lobe::radial_profile<decltype(shape), float>(shape).D(m, alpha<float>(a));
                worst_abc = larger(
                    worst_abc,
                    ulp_error(value, D) /
                        (8 * (1 + std::abs(std::log(D * pi * static_cast<double>(a) * static_cast<double>(a))))));
            }
        }
    INFO("abc: " << worst_abc << " of what is stated");
    CHECK(worst_abc < 1);

    double worst_power = 0;
    for (float p : {0.1f, 0.25f, 0.5f, 1.0f, 2.0f, 4.0f, 10.0f, 50.0f})
        for (float a : {1e-3f, 0.1f, 1.0f, 3.0f}) {
            const lobe::exponential_power_shape<float> shape(p);
            const lobe::exponential_power_shape<real> exact(p);
            for (int i = 0; i < 4000; ++i) {
                const auto m = direction(i);
                const vec3<real> wide(m.x, m.y, m.z);
                const double slope = static_cast<double>(m.x) / static_cast<double>(m.z) / static_cast<double>(a);
                const double D =
                    static_cast<double>(lobe::radial_profile<decltype(exact), real>(exact).D(wide, alpha<real>(a)));
                if (!(D * std::min(1.0, static_cast<double>(a) * static_cast<double>(a)) > 1e-36)) continue;
                const float value = lobe::radial_profile<decltype(shape), float>(shape).D(m, alpha<float>(a));
                worst_power =
                    larger(worst_power, ulp_error(value, D) / (8 * std::max(1.0, static_cast<double>(p)) *
                                                               (1 + std::pow(slope, 2 * static_cast<double>(p)))));
            }
        }
    INFO("exponential_power: " << worst_power << " of what is stated");
    CHECK(worst_power < 1);
}

TEST_CASE("sgd is a number in its whole domain, and outside it ends in an assert", "[ndf_extremes]") {
    for (double a : {1e-4, 1e-2, 1.0, 100.0})
        for (double p : {0.0, 4.0, 9.0, 50.0}) {
            const lobe::sgd_shape<double> shape(a, p);
            CHECK(shape.D(0, 1) > 0);
            CHECK(std::isfinite(shape.D(0, 1)));
            CHECK(shape.D(2 / a, 3) >= 0);
        }
    const float nan = std::numeric_limits<float>::quiet_NaN();
    for (const float bad : {-0.1f, 100.0f, nan}) CHECK(aborts([&] { (void)lobe::sgd_shape<float>(1e-4f, bad); }));
    for (const float bad : {-0.1f, 0.0f, 720.0f, nan}) CHECK(aborts([&] { (void)lobe::sgd_shape<float>(bad, 1.0f); }));
}

TEST_CASE("sggx: axes of either hand, as mirrored UVs give them", "[ndf_extremes]") {
    random_numbers random(4);
    const lobe::frame<double> at(random.direction(), random.direction());
    auto mirrored = at;
    mirrored.b = -at.b;
    const vec3<double> areas{0.1, 0.4, 1};
    const lobe::sggx<double> right(at, areas), left(mirrored, areas);  // S does not change when an axis turns round
    for (int i = 0; i < 1000; ++i) {
        const auto m = random.direction(), v = random.direction();
        CHECK(left.D(m) == Catch::Approx(right.D(m)).epsilon(1e-13));
        CHECK(left.projected_area(m) == Catch::Approx(right.projected_area(m)).epsilon(1e-14));
        const auto s = left.sample_visible(v, {random(), random()});
        CHECK(left.pdf_visible(v, s) > 0);
    }
    CHECK(aborts([&] { (void)lobe::sggx<double>(at, {0.1, 0.0, 1.0}); }));
}

TEST_CASE("asserts say what is wrong, in the words of the call", "[ndf_extremes]") {
    for (const float gamma : {1.5f, 1.0f, std::numeric_limits<float>::quiet_NaN()}) {
        CHECK(aborts([&] { (void)lobe::student_t(alpha(0.3f), gamma); }));
        CHECK(aborts([&] { (void)lobe::hyper_cauchy(alpha(0.3f), gamma); }));
    }
    CHECK(aborts([] { (void)lobe::blinn_phong(alpha(1.5f)); }));
    for (const float p : {0.0f, -1.0f, 51.0f}) CHECK(aborts([&] { (void)lobe::exponential_power_shape<float>(p); }));
}
