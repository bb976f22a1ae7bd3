#include "catch.hpp"
#include "support.hpp"

#include <lobe/brdf/microfacet.hpp>
#include <lobe/energy/quadrature.hpp>
#include <lobe/fresnel/conductor.hpp>
#include <lobe/fresnel/dielectric.hpp>
#include <lobe/fresnel/f82_tint.hpp>
#include <lobe/fresnel/ior.hpp>
#include <lobe/fresnel/materials.hpp>
#include <lobe/fresnel/schlick.hpp>
#include <lobe/fresnel/schlick_gaussian.hpp>
#include <lobe/fresnel/schlick_roughness.hpp>
#include <lobe/ndf/ggx.hpp>

#include <xsimd/xsimd.hpp>

#include <complex>

using lobe::conductor;
using lobe::dielectric;
using lobe::f82_tint;
using lobe::schlick;
using lobe::schlick_gaussian;
using lobe::schlick_roughness;
using lobe::vec3;

namespace {

constexpr double epsilon = 0x1p-53, not_a_number = std::numeric_limits<double>::quiet_NaN();

/// Fresnel's equations as textbooks print them, in complex long double: an independent transcription.
long double printed_fresnel(long double eta, long double k, long double c) {
    using complex = std::complex<long double>;
    const complex n(eta, k), cos_t = std::sqrt(complex(1) - (1 - c * c) / (n * n));
    return (std::norm((c - n * cos_t) / (c + n * cos_t)) + std::norm((n * c - cos_t) / (n * c + cos_t))) / 2;
}

/// 2 int_0^1 F(u) u du by 64 Gauss points.
template <class F>
double average_by_quadrature(const F& f) {
    static const lobe::gauss_legendre<double> rule(64);
    double sum = 0;
    for (std::size_t i = 0; i < rule.x.size(); ++i) sum += 2 * rule.w[i] * rule.x[i] * f(rule.x[i]);
    return sum;
}

/// The largest |f - g| over u in [0,1], and where it is.
struct deviation {
    double size = 0, at = 0;
};
template <class F, class G>
deviation largest_deviation(const F& f, const G& g) {
    deviation worst;
    for (int i = 0; i <= 4000; ++i) {
        const double u = i / 4000.0, d = std::abs(f(u) - g(u));
        if (d > worst.size) worst = {d, u};
    }
    return worst;
}

}  // namespace

TEST_CASE("Walsh's average agrees with every row of the 40-digit table", "[fresnel]") {
    double worst = 0, worst_ulp = 0, f0 = 0;
    for (const auto& row : reference_table("favg_dielectric.csv")) {
        const dielectric glass{row[0]};
        worst = std::max(worst, std::abs(glass.average() - row[2]));
        worst_ulp = std::max(worst_ulp, ulp_error(glass.average(), row[2]));
        // F0 is (n-1)^2 of a printed n that is a double: exact inputs, so rounding alone
        f0 = std::max({f0, ulp_error(lobe::f0_from_ior(row[0]), row[1]), ulp_error(glass.F0(), row[1])});
    }
    INFO("average off by " << worst << ", " << worst_ulp << " ULP; F0 by " << f0 << " ULP");
    CHECK(worst < 1e-15);
    CHECK(worst_ulp <= 12);  // the bracket is 3 times smaller than the largest of its terms, which carry 4 ULP each
    CHECK(f0 <= 7);          // three roundings of the quotient, doubled by the square, and one of that
}

TEST_CASE("conductors agree with every row of the 40-digit table", "[fresnel]") {
    double average = 0, values = 0;
    for (const auto& row : reference_table("favg_conductor.csv")) {
        const conductor metal{row[1], row[2]};
        average = std::max(average, ulp_error(metal.average(), row[4]));
        values = std::max(
            {values, ulp_error(metal.F0(), row[3]), ulp_error(metal(0.5), row[5]), ulp_error(metal(0.1), row[6])});
    }
    INFO("average off by " << average << " ULP, values by " << values << " ULP");
    CHECK(average <= 8);
    CHECK(values <= 8);
}

TEST_CASE("a reflectance is a number in [0,1] in its whole domain, and outside it ends in an assert", "[fresnel]") {
    int bad = 0;
    const auto count = [&](const auto& F) {
        for (int i = 0; i <= 200; ++i) {
            const float c = i < 100 ? std::pow(10.0f, -0.3f * static_cast<float>(i))
                                    : static_cast<float>(i - 100) / 100,
                        R = F(c);
            bad += !(R >= 0 && R <= 1 + 8 * 6e-8f);
        }
    };
    for (float eta : {1e-3f, 0.1f, 1.0f, 1.5f, 1e4f, 1e9f}) {
        for (float k : {0.0f, 1e-3f, 1.0f, 1e5f, 1e9f}) count(conductor{eta, k});
        count(dielectric{eta});
        // a mirror, but where eta is as large
        CHECK(conductor{eta, 1e9f}(0.5f) >= 1 - std::max(8 * eta / 1e18f, 4 / (eta + 1)) - 4e-7f);
    }
    count(dielectric{1e18f});
    CHECK(bad == 0);
    const float nan = std::numeric_limits<float>::quiet_NaN(), infinite = std::numeric_limits<float>::infinity();
    for (const float k : {-0.1f, 1e10f, infinite, nan}) CHECK(aborts([&] { (void)conductor(1.0f, k); }));
    for (const float eta : {0.0f, -1.0f, 1e-4f, 1e10f, infinite, nan})
        CHECK(aborts([&] { (void)conductor(eta, 1.0f); }));
    for (const float eta : {0.0f, -1.0f, nan}) CHECK(aborts([&] { (void)dielectric(eta); }));
}

TEST_CASE("dielectric and conductor are the complex equations", "[fresnel]") {
    random_numbers random(1);
    double insulators = 0, metals = 0;
    for (int i = 0; i < 100000; ++i) {
        const double eta = random.log_between(0.4, 10), k = random.log_between(0.5, 10),
                     c = random.log_between(1e-8, 1);
        // the printed form is itself off by 1e-19 over cos_t, which vanishes at the critical angle: stay 1e-6 away from
        // it
        if (std::abs(eta * eta - (1 - c) * (1 + c)) > 1e-6)
            insulators =
                std::max(insulators, std::abs(dielectric{eta}(c) - static_cast<double>(printed_fresnel(eta, 0, c))));
        metals = std::max(metals, std::abs(conductor{eta, k}(c) - static_cast<double>(printed_fresnel(eta, k, c))));
    }
    INFO("dielectric off by " << insulators << ", conductor by " << metals);
    CHECK(insulators < 1e-12);  // e rounds by 1e-16, g = sqrt(e + c^2) >= 1e-3 by 1e-13, F by 4 times that
    CHECK(metals < 8 * epsilon);
}

TEST_CASE("the errors that the Fresnel headers state, in float, eta an input", "[fresnel]") {
    random_numbers random(12);
    double insulators = 0, inside = 0, metals = 0, weak = 0;
    for (int i = 0; i < 600000; ++i) {
        // near eta = 1 and near the normal Rs is all there is, and its square doubles what it rounds: half of the
        // indices and cosines are there
        const float eta = static_cast<float>(i % 2 ? random.between(1, 10) : 1 + random.log_between(1e-7, 9));
        const float c = static_cast<float>(i % 4 < 2   ? 1 - random.log_between(1e-7, 1)
                                           : i % 8 < 4 ? random()
                                                       : random.log_between(1e-6, 1));
        if (eta > 1 && eta <= 10 && c > 0)
            insulators = std::max(insulators, ulp_error(dielectric{eta}(c), printed_fresnel(eta, 0, c)));
        // from inside, half of the cosines just beyond the critical one: 12 ULP, and 1.5 times the inputs' own
        const float less = static_cast<float>(random.between(0.3, 1)), critical = std::sqrt((1 - less) * (1 + less));
        const float u = static_cast<float>(i % 2 ? random() : random.log_between(1e-7, 1));
        const float beyond = std::min(1.0f, critical + (1 - critical) * u);
        const long double F = printed_fresnel(less, 0, beyond);
        double change = 0;
        for (const float n : {0.0f, 1.0f})
            for (const float to : {0.0f, 2.0f}) {
                const float moved = std::min(1.0f, std::nextafter(beyond, to));
                change = std::max(
                    change, ulp_error(static_cast<double>(printed_fresnel(std::nextafter(less, n), 0, moved)), F));
            }
        change *= 0x1p-29;  // from places of double to places of float
        inside = std::max(inside, ulp_error(dielectric{less}(beyond), F) / (12 + 1.5 * change));

        const float metal = static_cast<float>(random.log_between(0.3, 10));
        const float k = static_cast<float>(i % 2 ? random.log_between(0.5, 10) : random.between(0.5, 0.6));
        const float near_1 = i % 2 ? metal : static_cast<float>(random.between(0.9, 1.2));
        metals = std::max(metals, ulp_error(conductor{near_1, k}(c), printed_fresnel(near_1, k, c)));
        const float little = static_cast<float>(random.log_between(1e-6, 0.5));
        if (eta <= 10) weak = std::max(weak, ulp_error(conductor{eta, little}(c), printed_fresnel(eta, little, c)));
    }
    INFO("dielectric " << insulators << ", from inside " << inside << ", metals " << metals << ", weak absorbers "
                       << weak);
    CHECK(insulators <= 12);
    CHECK(inside <= 1);
    CHECK(metals <= 9);
    CHECK(weak <= 12);
    // found by climbing: the worst of this form, 11, and those of e = (eta - 1)(eta + 1) over e + 2 c (g + c), 12.2 to
    // 13.9
    for (const auto& [eta, c] : {std::pair{1.00015032f, 0.367648154f},
                                 {1.00195205f, 0.999720693f},
                                 {1.00026119f, 0.250201076f},
                                 {1.06434262f, 0.98552978f},
                                 {1.01556456f, 0.99698019f},
                                 {1.09120262f, 0.985587358f}})
        CHECK(ulp_error(dielectric{eta}(c), printed_fresnel(eta, 0, c)) <= 12);
    // for eta < 1 the critical angle, as k nears 0
    const double stated[][2] = {{0.1, 14}, {0.01, 80}, {0.001, 300}};
    for (const auto& [k, bound] : stated) {
        double worst = 0;
        for (int i = 0; i < 50000; ++i) {
            const float eta = static_cast<float>(random.between(0.3, 1)), extinction = static_cast<float>(k);
            const float spread = static_cast<float>(random.between(-4, 4) * k),
                        critical = std::sqrt((1 - eta) * (1 + eta));
            const float c = std::clamp(critical + spread, 1e-3f, 1.0f);
            worst = std::max(worst, ulp_error(conductor{eta, extinction}(c), printed_fresnel(eta, extinction, c)));
        }
        INFO("k = " << k << ": " << worst);
        CHECK(worst <= bound);
    }
    // and for eta << 1 it is at the normal: up to 6/eta roundings
    double normal = 0;
    for (int i = 0; i < 4000; ++i) {
        const float eta = static_cast<float>(random.log_between(1e-3, 0.3));
        normal = std::max(normal,
                          static_cast<double>(eta * std::abs(dielectric{eta}(1.0f) / printed_fresnel(eta, 0, 1) - 1)));
    }
    CHECK(normal <= 6 * 0x1p-24);
}

TEST_CASE("a conductor at k = 0 is a dielectric, total internal reflection included", "[fresnel]") {
    random_numbers random(2);
    double worst = 0;
    int total = 0;
    for (int i = 0; i < 100000; ++i) {
        const double eta = random.log_between(0.3, 10), c = i % 2 ? random() : random.log_between(1e-8, 1);
        const double F = dielectric{eta}(c);
        total += F == 1;
        worst = std::max(worst, ulp_error(conductor{eta, 0.0}(c), F));
    }
    INFO(worst << "; total reflections " << total);
    CHECK(worst <= 24);  // 12 ULP each
    CHECK(total > 10000);
    for (double eta : {0.5, 1.0, 1.5})
        CHECK(conductor{eta, 0.0}(0.0) == Catch::Approx(dielectric{eta}(0.0)).epsilon(4 * epsilon));
    for (double eta : {1.02, 1.5, 4.0})
        CHECK(conductor{eta, 0.0}.average() == Catch::Approx(dielectric{eta}.average()).epsilon(28 * epsilon));
    // the kink at the critical angle: what the header states
    CHECK(std::abs(conductor{0.6575, 0.0}.average() - dielectric{0.6575}.average()) ==
          Catch::Approx(0.018).margin(0.001));
}

TEST_CASE("reflectance is the same from both sides of the interface", "[fresnel]") {
    random_numbers random(3);
    double worst = 0;
    for (int i = 0; i < 100000; ++i) {
        const double eta = random.log_between(1, 10), c = random.log_between(1e-4, 1);
        const double g2 = (eta - 1) * (eta + 1) + c * c, c_t = std::sqrt(g2) / eta;
        const double F = dielectric{eta}(c), back = dielectric{1 / eta}(c_t);
        // From inside g = c/eta, and g^2 = c_t^2 + (1/eta - 1)(1/eta + 1) rounds by 11 epsilon in all: c_t by 3 and
        // twice that in its square, 1/eta by 2, the rest 3. So g is off by 11/2 (eta/c)^2, relatively, and 1 - F by no
        // more. Both F's carry 12 ULP.
        worst = std::max(worst, std::abs(F - back) / (epsilon * (24 + 5.5 * (1 - F) * eta * eta / (c * c))));
    }
    INFO(worst);
    CHECK(worst < 1);
    CHECK(dielectric{1.5}(1.0) == Catch::Approx(dielectric{1 / 1.5}(1.0)).epsilon(1e-15));
}

TEST_CASE("the limits of the dielectric", "[fresnel]") {
    CHECK(dielectric{1.5}(1.0) == Catch::Approx(0.04).epsilon(4 * epsilon));
    CHECK(dielectric{1.5}(0.0) == Catch::Approx(1).epsilon(4 * epsilon));
    CHECK(dielectric{1.5f}(1e-30f) == Catch::Approx(1).epsilon(3e-7));
    CHECK(dielectric{1.0}(0.3) == 0);
    CHECK(dielectric{1.0}.average() == 0);
    CHECK(dielectric{1.0}(0.0) == 1);
    CHECK(dielectric{1e150}.average() == Catch::Approx(1));
    CHECK(dielectric{1e-150}.average() == Catch::Approx(1));
    CHECK(dielectric{1e-320}.average() == 1);  // 1/eta is infinite
    CHECK(conductor{1.0, 0.0}(0.0) == 1);
    // at the critical angle: 4 sqrt(1e-16)
    CHECK(conductor{0.5, 0.0}(std::sqrt(0.75)) == Catch::Approx(1).epsilon(1e-7));
    const double brewster = std::cos(std::atan(1.5));  // Rp = 0, and Rs = ((n^2 - 1)/(n^2 + 1))^2
    CHECK(dielectric{1.5}(brewster) == Catch::Approx(std::pow((2.25 - 1) / (2.25 + 1), 2) / 2).epsilon(1e-14));
    // near 1 the average is d/3 + d^2 (ln(d/2)/2 + 19/24) + O(d^3 ln d)
    for (double d : {0x1p-14, 0x1p-20, 0x1p-27}) {
        const double series = d / 3 + d * d * (std::log(d / 2) / 2 + 19.0 / 24);
        CHECK(std::abs(dielectric{1 + d}.average() / series - 1) < 20 * d * d * std::abs(std::log(d)));
    }
}

TEST_CASE("the averages are the integrals of the reflectances", "[fresnel]") {
    // 64 points: the nearest singularities are at u = +-i sqrt(eta^2 - 1), which makes the rule's error below 1e-16 for
    // eta >= 1.02
    for (double eta : {1.02, 1.1, 1.33, 1.5, 2.42, 10.0})
        CHECK(std::abs(dielectric{eta}.average() - average_by_quadrature(dielectric{eta})) < 8 * epsilon);
    // from inside: 1 up to the critical cosine, and u du = g dg beyond it, with g from 0 to eta
    for (double eta : {0.3, 0.5, 1 / 1.5, 0.75, 0.9}) {
        const auto beyond = [&](double t) { return dielectric{eta}(std::sqrt(1 - eta * eta + eta * eta * t * t)); };
        const double exact = 1 - eta * eta + eta * eta * average_by_quadrature(beyond);
        CHECK(std::abs(dielectric{eta}.average() - exact) < 1e-12);  // F near g = 0 feels 1e-16 in u as 1e-16/g
    }
    random_numbers random(4);
    double metals = 0, thin = 0;
    for (int i = 0; i < 2000; ++i) {
        const double eta = random.log_between(0.04, 10), k = random.log_between(0.5, 10);
        metals = std::max(metals, std::abs(conductor{eta, k}.average() - average_by_quadrature(conductor{eta, k})));
        const double dense = random.between(1, 10), weak = random.log_between(1e-6, 1);
        const conductor absorber{dense + 0.02, weak};
        thin = std::max(thin, std::abs(absorber.average() - average_by_quadrature(absorber)));
    }
    INFO("metals " << metals << ", weak absorbers " << thin);
    CHECK(metals < 16 * epsilon);  // 8 ULP of F for each of the two rules
    CHECK(thin < 16 * epsilon);

    const schlick_gaussian gaussian{0.04, 0.9};
    CHECK(std::abs(gaussian.average() - average_by_quadrature(gaussian)) < 4 * epsilon);
    const schlick_roughness rough{0.04, 0.3};
    CHECK(std::abs(rough.average() - average_by_quadrature(rough)) < 4 * epsilon);
    CHECK(rough.average() == Catch::Approx(0.04 + (0.7 - 0.04) / 21));
    const f82_tint positive{0.9, 0.7};
    CHECK(std::abs(positive.average() - average_by_quadrature(positive)) < 4 * epsilon);
}

TEST_CASE("how far Schlick's approximation is from Fresnel's equations", "[fresnel]") {
    // independently computed numbers, which are given to two or three digits
    const auto off = [](const auto& exact) { return largest_deviation(schlick{exact(1.0)}, exact); };
    const auto rounds_to = [](double x, double quoted) { return std::abs(x - quoted) <= 0.0005; };
    CHECK(rounds_to(off(dielectric{1.33}).size, 0.060));
    CHECK(rounds_to(off(dielectric{1.5}).size, 0.036));
    CHECK(rounds_to(off(dielectric{2.0}).size, 0.044));
    for (double eta : {1.33, 1.5, 2.0}) CHECK(std::abs(off(dielectric{eta}).at - 0.1) < 0.06);
    const double beyond[][2] = {{1.01, 0.55}, {1.1, 0.21}, {1.2, 0.11}, {2.5, 0.08}, {4.0, 0.20}};
    for (const auto& [eta, stated] : beyond) CHECK(std::abs(off(dielectric{eta}).size - stated) <= 0.005);
    CHECK(rounds_to(off(conductor{0.143, 3.983}).size, 0.016));
    CHECK(rounds_to(off(conductor{0.965, 6.4}).size, 0.093));
    CHECK(rounds_to(off(conductor{2.95, 2.932}).size, 0.176));
    // averages: up to 0.0445 for a dielectric (largest towards eta = 1, where it is 1/21 = 0.0476)
    CHECK(schlick{lobe::f0_from_ior(1.01)}.average() - dielectric{1.01}.average() ==
          Catch::Approx(0.0445).margin(5e-5));
}

TEST_CASE("Schlick's approximation as a spherical Gaussian", "[fresnel]") {
    const schlick_gaussian gaussian{0.0};
    const deviation worst = largest_deviation(gaussian, schlick{0.0});
    INFO(worst.size << " at " << worst.at);
    CHECK(worst.size == Catch::Approx(0.003767).epsilon(1e-3));
    CHECK(worst.at == Catch::Approx(0.0555).margin(0.002));
    CHECK(gaussian(0.0) == 1);
    CHECK(gaussian(1.0) == Catch::Approx(1.6816e-4).epsilon(1e-4));  // 2^-12.53789
    const schlick_gaussian between{vec3<float>{0.1f, 0.2f, 0.3f}, vec3<float>{0.9f, 0.8f, 0.7f}};
    CHECK(between(0.0f) == vec3<float>{0.9f, 0.8f, 0.7f});
    CHECK(between.F0() == vec3<float>{0.1f, 0.2f, 0.3f});
    CHECK(sizeof(schlick_gaussian<float>) == sizeof(float));
}

TEST_CASE("Schlick with roughness stays between F0 and max(1 - r, F0)", "[fresnel]") {
    for (double f0 : {0.0, 0.04, 0.5, 1.0})
        for (double r : {0.0, 0.3, 0.8, 1.0}) {
            const schlick_roughness f{f0, r};
            CHECK(f(1.0) == f0);
            CHECK(f(0.0) == Catch::Approx(std::max(1 - r, f0)));
            CHECK(f(0.3) >= f0 * (1 - epsilon));
            CHECK(f(0.3) <= std::max(1 - r, f0) * (1 + epsilon));
            CHECK(f(0.3) == Catch::Approx(f0 + (std::max(1 - r, f0) - f0) * std::pow(0.7, 5)));
        }
    const schlick_roughness gold{lobe::materials::F0::gold<float>(), 0.5f};
    CHECK(gold(0.0f).x == 1);
    CHECK(gold(0.0f).z == 0.5f);
}

TEST_CASE("F82-tint has its tint at 82 degrees, and Schlick at t = 1", "[fresnel]") {
    for (double f0 : {0.0, 0.04, 0.5, 0.91, 1.0}) {
        for (double t : {0.6, 0.8, 1.0}) {
            INFO(f0 << ' ' << t);
            CHECK(f82_tint{f0, t}(1 / 7.0) == Catch::Approx(t * schlick{f0}(1 / 7.0)).epsilon(8 * epsilon));
            CHECK(f82_tint{f0, t}(1.0) == Catch::Approx(f0).margin(1e-300));
            CHECK(f82_tint{f0, t}(0.0) == 1);
        }
        CHECK(largest_deviation(f82_tint{f0, 1.0}, schlick{f0}).size == 0);
    }
    CHECK(std::acos(1 / 7.0) * 180 / 3.141592653589793 == Catch::Approx(81.787));
    // fitted to Fresnel's equations: independently computed numbers
    const auto off = [](const auto& exact) { return largest_deviation(lobe::fit_f82_tint(exact), exact).size; };
    CHECK(std::abs(off(conductor{0.965, 6.4}) - 0.0065) < 0.00005);
    CHECK(std::abs(off(conductor{2.95, 2.932}) - 0.019) < 0.0005);
    const auto worst = [&](const conductor<vec3<double>>& metal) {
        const vec3<double> n = metal.index(), k = metal.extinction();
        return std::max({off(conductor{n.x, k.x}), off(conductor{n.y, k.y}), off(conductor{n.z, k.z})});
    };
    namespace materials = lobe::materials;
    CHECK(worst(materials::gold<double>()) < 0.0175);
    CHECK(worst(materials::silver<double>()) < 0.0175);
    CHECK(worst(materials::copper<double>()) < 0.0175);
    CHECK(worst(materials::iron<double>()) < 0.0195);
    CHECK(worst(materials::aluminium<double>()) < 0.0225);
    CHECK(std::abs(off(dielectric{1.5}) - 0.028) < 0.0005);
}

TEST_CASE("where F82-tint is clamped, and what that does to its average", "[fresnel]") {
    const auto unclamped = [](double f0, double t, double u) {
        const double b = schlick{f0}(1 / 7.0) * (1 - t) * std::pow(7.0, 7) / std::pow(6.0, 6);
        return schlick{f0}(u)-b * u * std::pow(1 - u, 6);
    };
    const auto lowest = [&](double f0, double t) {
        double low = 1;
        for (int k = 0; k <= 200; ++k) low = std::min(low, unclamped(f0, t, k / 200.0));
        return low;
    };
    double clamped = 0, bottom = 0, largest_tint = 0, wrong = 0, average = 0, closed = 0;
    for (int i = 0; i < 100; ++i)
        for (int j = 0; j < 100; ++j) clamped += (lowest((i + 0.5) / 100, (j + 0.5) / 100) < 0) / 1e4;
    for (int i = 0; i <= 100; ++i)
        for (int j = 0; j <= 100; ++j) {
            const double f0 = i / 100.0, t = j / 100.0, low = lowest(f0, t);
            const f82_tint f{f0, t};
            bottom = std::min(bottom, low);
            if (low < -8 * epsilon) largest_tint = std::max(largest_tint, t);
            double below = 0;  // midpoint rule: what the clamp adds, to 1e-4
            for (int k = 0; k < 200; ++k) {
                const double u = (k + 0.5) / 200, free = unclamped(f0, t, u);
                wrong = std::max(wrong, std::abs(f(u) - std::max(free, 0.0)));
                below += 2 * u * (std::max(free, 0.0) - free) / 200;
            }
            const double integral = average_by_quadrature([&](double u) { return unclamped(f0, t, u); });
            closed = std::max(closed, std::abs(std::max(integral, 0.0) - f.average()));
            average = std::max(average, integral + below - f.average());
        }
    INFO("clamped " << clamped << ", lowest " << bottom << ", tints up to " << largest_tint << ", average too small by "
                    << average);
    // cells on the border: 100 or so of 10000, half of them each way
    CHECK(clamped == Catch::Approx(0.076).margin(0.002));
    CHECK(bottom == Catch::Approx(-0.127).margin(0.0005));
    CHECK(largest_tint == Catch::Approx(0.51));  // at F0 = 0 the clamp acts where b > 4, t < 0.5102
    CHECK(average == Catch::Approx(0.0164).margin(1e-4));
    CHECK(wrong < 8 * epsilon);
    CHECK(closed < 16 * epsilon);  // b is at most 17.6, so its terms are a few times 1
}

TEST_CASE("index of refraction to F0 and back", "[fresnel]") {
    CHECK(lobe::f0_from_ior(1.5) == Catch::Approx(0.04).epsilon(4 * epsilon));
    CHECK(lobe::ior_from_f0(0.04) == Catch::Approx(1.5).epsilon(4 * epsilon));
    CHECK(lobe::ior_from_f0(0.0) == 1);
    CHECK(lobe::f0_from_ior(1 / 1.5) == Catch::Approx(0.04).epsilon(8 * epsilon));
    CHECK(lobe::f0_from_ior(1.5 / 1.33) == Catch::Approx(0.0036085).epsilon(1e-4));  // glass in water
    random_numbers random(5);
    double there = 0, back = 0;
    for (int i = 0; i < 100000; ++i) {
        const double eta = random.log_between(1.001, 100), f0 = random.between(0, 0.999);
        there = std::max(there, std::abs(lobe::ior_from_f0(lobe::f0_from_ior(eta)) / eta - 1) / (1 + eta));
        back = std::max(back, std::abs(lobe::f0_from_ior(lobe::ior_from_f0(f0)) - f0) / std::sqrt(f0));
    }
    // F0 rounded to epsilon is sqrt(F0) to epsilon/2, and 1 - sqrt(F0) = 2/(eta + 1) to (eta + 1)/4 of epsilon: 4
    // roundings of it
    INFO(there / epsilon << ' ' << back / epsilon);
    CHECK(there < 4 * epsilon);
    CHECK(back < 8 * epsilon);
    const vec3<float> flint = lobe::f0_from_ior(vec3<float>{1.61f, 1.62f, 1.63f});
    CHECK(flint.y == lobe::f0_from_ior(1.62f));
    CHECK(lobe::ior_from_f0(flint).z == lobe::ior_from_f0(flint.z));
}

namespace {

template <class S>
double furthest(const S& a, const S& b) {
    return static_cast<double>(std::max({std::abs(a.x - b.x), std::abs(a.y - b.y), std::abs(a.z - b.z)}));
}

}  // namespace

TEST_CASE("materials: the documents' table, and metals at three wavelengths near it", "[fresnel]") {
    namespace materials = lobe::materials;
    using color = vec3<double>;
    CHECK(materials::F0::water<double>() == color(0.02));
    CHECK(materials::F0::plastic_low<double>() == color(0.03));
    CHECK(materials::F0::plastic_high<double>() == color(0.05));
    CHECK(materials::F0::glass_high<double>() == color(0.08));
    CHECK(materials::F0::diamond<double>() == color(0.17));
    CHECK(materials::F0::gold<double>() == color(1.00, 0.71, 0.29));
    CHECK(materials::F0::silver<double>() == color(0.95, 0.93, 0.88));
    CHECK(materials::F0::copper<double>() == color(0.95, 0.64, 0.54));
    CHECK(materials::F0::iron<double>() == color(0.56, 0.57, 0.58));
    CHECK(materials::F0::aluminium<float>() == vec3<float>(0.91f, 0.92f, 0.92f));
    // insulators against Fresnel's equations at their index: the table has two decimals
    CHECK(std::abs(dielectric{1.333}.F0() - 0.02) < 0.005);
    CHECK(std::abs(dielectric{2.417}.F0() - 0.17) < 0.005);
    // metals: three wavelengths are not a colour, so the distances are those that the header states
    const double off[] = {furthest(materials::gold<double>().F0(), materials::F0::gold<double>()),
                          furthest(materials::silver<double>().F0(), materials::F0::silver<double>()),
                          furthest(materials::copper<double>().F0(), materials::F0::copper<double>()),
                          furthest(materials::iron<double>().F0(), materials::F0::iron<double>()),
                          furthest(materials::aluminium<double>().F0(), materials::F0::aluminium<double>())};
    const double stated[] = {0.118, 0.101, 0.021, 0.084, 0.006};
    for (int i = 0; i < 5; ++i) CHECK(std::abs(off[i] - stated[i]) < 0.001);
    // red, green, blue in this order: what the eye knows of them
    const color gold = materials::gold<double>().F0(), copper = materials::copper<double>().F0();
    CHECK((gold.x > gold.y && gold.y > gold.z && copper.x > copper.y && copper.y > copper.z && gold.y > copper.y));
    CHECK(materials::silver<float>()(0.5f).x == conductor{0.05f, 4.483f}(0.5f));
    CHECK(materials::aluminium<float>().average().y == Catch::Approx(conductor{1.0728f, 6.7839f}.average()));
}

TEST_CASE("a spectrum is its components", "[fresnel]") {
    const vec3<double> eta{0.2, 1.0, 1.4}, k{3.9, 2.4, 0.0}, f0{0.9, 0.5, 0.04}, tint{1, 0.2, 0.7};
    const conductor metal{eta, k};
    const dielectric prism{eta};
    const f82_tint tinted{f0, tint};
    for (double u : {0.0, 0.1, 0.7, 1.0})
        for (int i = 0; i < 3; ++i) {
            CHECK(metal(u)[i] == conductor{eta[i], k[i]}(u));
            CHECK(prism(u)[i] == dielectric{eta[i]}(u));
            CHECK(tinted(u)[i] == f82_tint{f0[i], tint[i]}(u));
            CHECK(tinted.average()[i] == Catch::Approx(f82_tint{f0[i], tint[i]}.average()));
            CHECK(metal.average()[i] == conductor{eta[i], k[i]}.average());
            CHECK(prism.average()[i] == dielectric{eta[i]}.average());
        }
    CHECK(lobe::fit_f82_tint(lobe::materials::gold<double>()).F0() == lobe::materials::gold<double>().F0());
}

TEST_CASE("every Fresnel reflectance composes with a microfacet BRDF, and takes no more room than its numbers",
          "[fresnel]") {
    const lobe::ggx ndf{lobe::alpha{0.3f}};
    const vec3<float> v{0.6f, 0, 0.8f}, l{0, 0.8f, 0.6f}, f0{0.9f, 0.5f, 0.04f};
    const auto red = [&](const auto& fresnel) {
        return lobe::microfacet{ndf, lobe::smith_correlated{}, fresnel}.f_cos(v, l);
    };
    const float D = red(schlick{1.0f}), u = lobe::length(v + l) / 2;
    CHECK(red(dielectric{1.5f}) == Catch::Approx(D * dielectric{1.5f}(u)).epsilon(1e-6));
    CHECK(red(conductor{0.2f, 3.9f}) == Catch::Approx(D * conductor{0.2f, 3.9f}(u)).epsilon(1e-6));
    CHECK(red(schlick_gaussian{0.5f}) == Catch::Approx(D * schlick_gaussian{0.5f}(u)).epsilon(1e-6));
    CHECK(red(f82_tint{f0, f0}).y == Catch::Approx(D * f82_tint{0.5f, 0.5f}(u)).epsilon(1e-6));
    CHECK(red(schlick_roughness{f0, 0.5f}).y == Catch::Approx(D * schlick_roughness{0.5f, 0.5f}(u)).epsilon(1e-6));
    CHECK(red(lobe::materials::iron<float>()).z == Catch::Approx(D * conductor{2.59f, 2.77f}(u)).epsilon(1e-6));
    static_assert(sizeof(lobe::microfacet{ndf, lobe::smith_correlated{}, schlick{f0}}) == 16);
    static_assert(sizeof(dielectric{1.5f}) == 4 && sizeof(conductor{f0, f0}) == 24 && sizeof(f82_tint{f0, f0}) == 24);
    static_assert(!std::is_invocable_v<dielectric<float>, double> &&
                  !std::is_invocable_v<conductor<vec3<double>>, float>);
}

namespace {

template <class F, class G>
void compare_packs(const F& wide, const G& one) {
    using pack = xsimd::batch<float>;
    alignas(64) float in[pack::size];
    random_numbers random(6);
    double worst = 0;
    for (int trial = 0; trial < 1000; ++trial) {
        for (float& u : in) u = static_cast<float>(trial % 2 ? random() : random.log_between(1e-6, 1));
        const pack out = wide(pack::load_unaligned(in));
        for (std::size_t i = 0; i < pack::size; ++i)
            worst = std::max(worst, std::abs(static_cast<double>(out.get(i) - one(in[i]))));
    }
    CHECK(worst < 8 * 6e-8);
    CHECK(std::abs(wide.average().get(0) - one.average()) < 8 * 6e-8f);
}

}  // namespace

TEST_CASE("packs give what their lanes give", "[fresnel]") {
    using pack = xsimd::batch<float>;
    for (float eta : {0.6f, 1.0f, 1.5f, 4.0f}) {
        compare_packs(dielectric{pack(eta)}, dielectric{eta});
        compare_packs(conductor{pack(eta), pack(0.0f)}, conductor{eta, 0.0f});
        compare_packs(conductor{pack(eta), pack(3.0f)}, conductor{eta, 3.0f});
    }
    compare_packs(f82_tint{pack(0.9f), pack(0.1f)}, f82_tint{0.9f, 0.1f});
    compare_packs(schlick_gaussian{pack(0.04f)}, schlick_gaussian{0.04f});
    compare_packs(schlick_roughness{pack(0.04f), pack(0.3f)}, schlick_roughness{0.04f, 0.3f});
    const vec3<pack> f0{pack(0.9f), pack(0.5f), pack(0.04f)};
    CHECK(conductor{f0, f0}(pack(0.3f)).y.get(0) == Catch::Approx(conductor{0.5f, 0.5f}(0.3f)));
    CHECK(lobe::ior_from_f0(f0).z.get(0) == Catch::Approx(1.5f));
}

TEST_CASE("Fresnel parameters out of their domain end in an assert", "[fresnel]") {
    CHECK(aborts([] { (void)dielectric(0.0); }));
    CHECK(aborts([] { (void)dielectric(-1.5); }));
    CHECK(aborts([] { (void)dielectric(not_a_number); }));
    CHECK(aborts([] { (void)dielectric(vec3<float>{1.5f, 1.5f, 0.0f}); }));
    CHECK(aborts([] { (void)dielectric(std::numeric_limits<double>::infinity()); }));
    CHECK(aborts([] { (void)dielectric(2e19f); }));  // whose square is infinite
    CHECK(!aborts([] { (void)dielectric(1e19f); }));
    CHECK(aborts([] { (void)conductor(-0.1, 3.0); }));
    CHECK(aborts([] { (void)conductor(0.2, -3.0); }));
    CHECK(aborts([] { (void)conductor(0.2, not_a_number); }));
    CHECK(aborts([] { (void)conductor(not_a_number, 3.0); }));
    CHECK(aborts([] { (void)f82_tint(1.1, 0.5); }));
    CHECK(aborts([] { (void)f82_tint(0.5, -0.1); }));
    CHECK(aborts([] { (void)f82_tint(0.5, 1.1); }));
    CHECK(aborts([] { (void)f82_tint(0.5, not_a_number); }));
    CHECK(aborts([] { (void)schlick_gaussian(1.5); }));
    CHECK(aborts([] { (void)schlick_gaussian(0.5, not_a_number); }));
    CHECK(aborts([] { (void)schlick_roughness(0.5, -0.1); }));
    CHECK(aborts([] { (void)schlick_roughness(0.5, not_a_number); }));
    CHECK(aborts([] { (void)schlick_roughness(not_a_number, 0.5); }));
    CHECK(aborts([] { (void)lobe::f0_from_ior(-1.0); }));
    CHECK(aborts([] { (void)lobe::f0_from_ior(not_a_number); }));
    CHECK(aborts([] { (void)lobe::ior_from_f0(1.0); }));
    CHECK(aborts([] { (void)lobe::ior_from_f0(-0.1); }));
    CHECK(!aborts([] { (void)conductor(0.2, 0.0); }));
    CHECK(!aborts([] { (void)f82_tint(1.0, 0.0); }));
}
