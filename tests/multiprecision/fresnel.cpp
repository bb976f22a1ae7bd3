// Fresnel's equations in complex arithmetic on 50 digits, and Walsh's average as it is printed: what rounding does to
// float and double over the whole domain.
#include "../catch.hpp"
#include "digits50.hpp"

#include <lobe/fresnel/conductor.hpp>
#include <lobe/fresnel/dielectric.hpp>
#include <lobe/fresnel/f82_tint.hpp>
#include <lobe/fresnel/ior.hpp>
#include <lobe/fresnel/schlick_gaussian.hpp>
#include <lobe/fresnel/schlick_roughness.hpp>

#include <boost/multiprecision/cpp_complex.hpp>

using complex50 = boost::multiprecision::cpp_complex_50;

namespace {

digits50 printed_fresnel(const digits50& eta, const digits50& k, const digits50& c) {
    const complex50 n(eta, k), cos_t = sqrt(complex50(1) - complex50(1 - c * c) / (n * n));
    return (norm((c - n * cos_t) / (c + n * cos_t)) + norm((n * c - cos_t) / (n * c + cos_t))).real() / 2;
}

/// By how much F changes, in ULP of T, where eta and c move by one ULP each.
template <class T>
double change_of_one_ulp(const T& eta, const T& c) {
    const digits50 F = printed_fresnel(eta, 0, c);
    double change = 0;
    for (const T n : {T(0), T(20)})
        for (const T to : {T(0), T(2)}) {
            const T moved = std::min(T(1), std::nextafter(c, to));
            change = std::max(change, ulps(T(0), digits50(F - printed_fresnel(std::nextafter(eta, n), 0, moved)), F));
        }
    return change;
}

digits50 printed_walsh(const digits50& n) {
    if (n < 1) return 1 - n * n * (1 - printed_walsh(1 / n));
    const digits50 n2 = n * n, n4 = n2 * n2, p = n2 + 1, m = n4 - 1, d = n2 - 1;
    return digits50(1) / 2 + (n - 1) * (3 * n + 1) / (6 * (n + 1) * (n + 1)) +
           n2 * d * d / (p * p * p) * log((n - 1) / (n + 1)) - 2 * n * n2 * (n2 + 2 * n - 1) / (p * m) +
           8 * n4 * (n4 + 1) / (p * m * m) * log(n);
}

}  // namespace

TEMPLATE_TEST_CASE("Fresnel's equations against complex arithmetic on 50 digits", "[fresnel]", float, double) {
    using T = TestType;
    random_numbers random(1);
    double insulators = 0, inside = 0, metals = 0, weak = 0, worst_change = 0;
    for (int i = 0; i < 12000; ++i) {
        // dense near eta = 1 and near the normal, where the roundings of e and of g + c count twice
        const T eta = static_cast<T>(i % 2 ? random.between(1, 10) : 1 + random.log_between(1e-6, 9));
        const T c = static_cast<T>(i % 4 < 2   ? 1 - random.log_between(1e-7, 1)
                                   : i % 8 < 4 ? random()
                                               : random.log_between(1e-6, 1));
        if (eta > T(1) && eta <= T(10) && c > T(0)) {
            insulators = std::max(insulators, ulps(lobe::dielectric{eta}(c), printed_fresnel(eta, 0, c)));
            const T little = static_cast<T>(random.log_between(1e-6, 0.5));
            weak = std::max(weak, ulps(lobe::conductor{eta, little}(c), printed_fresnel(eta, little, c)));
        }
        const T metal = static_cast<T>(i % 2 ? random.log_between(0.3, 10) : random.between(0.9, 1.2));
        const T k = static_cast<T>(i % 2 ? random.log_between(0.5, 10) : random.between(0.5, 0.6));
        metals = std::max(metals, ulps(lobe::conductor{metal, k}(c), printed_fresnel(metal, k, c)));
        const T less = static_cast<T>(random.between(0.3, 1)), critical = std::sqrt((1 - less) * (1 + less));
        const T beyond = std::min(T(1), critical + (1 - critical) * static_cast<T>(random.log_between(1e-7, 1)));
        const double change = change_of_one_ulp(less, beyond);
        worst_change = std::max(worst_change, change);
        inside = std::max(inside,
                          ulps(lobe::dielectric{less}(beyond), printed_fresnel(less, 0, beyond)) / (12 + 1.5 * change));
    }
    INFO("dielectric " << insulators << ", from inside " << inside << ", metals " << metals << ", weak absorber "
                       << weak << "; an ULP of eta and c changes F by up to " << worst_change);
    CHECK(insulators <= 12);
    CHECK(inside <= 1);
    CHECK(metals <= 9);
    CHECK(weak <= 12);
}

TEMPLATE_TEST_CASE("the averages against Walsh's printed equation, and the conductor's own on 50 digits", "[fresnel]",
                   float, double) {
    using T = TestType;
    random_numbers random(2);
    double walsh = 0, metals = 0, tint = 0, gaussian = 0, rough = 0, f0 = 0, ior = 0;
    for (int i = 0; i < 2000; ++i) {
        // from 1 + 1e-5, where the printed form still has 50 - 20 digits, to 1e4, and the inverses
        const double d = random.log_between(1e-5, 1e4);
        const T n = static_cast<T>(i % 2 ? 1 + d : 1 / (1 + d));
        if (n == T(1)) continue;
        walsh = std::max(walsh, ulps(lobe::dielectric{n}.average(), printed_walsh(digits50(n))));
        const digits50 amplitude = (digits50(n) - 1) / (digits50(n) + 1);
        f0 = std::max(f0, ulps(lobe::f0_from_ior(n), digits50(amplitude * amplitude)));

        const T F0 = static_cast<T>(random()), t = static_cast<T>(random.between(0.52, 1)),
                u = static_cast<T>(random());
        const digits50 root = sqrt(digits50(F0));
        ior = std::max(ior,
                       ulps(lobe::ior_from_f0(F0), digits50((1 + root) / (1 - root))) * static_cast<double>(1 - root));
        // b u (1-u)^6 is at most (1 - t) Schlick(1/7), so F is a difference of things no larger than 1
        const digits50 off =
            abs(digits50(lobe::f82_tint{F0, t}(u)) - lobe::f82_tint{digits50(F0), digits50(t)}(digits50(u)));
        tint = std::max(tint, std::ldexp(static_cast<double>(off), std::numeric_limits<T>::digits));
        gaussian =
            std::max(gaussian, ulps(lobe::schlick_gaussian{F0}(u), lobe::schlick_gaussian{digits50(F0)}(digits50(u))));
        rough = std::max(rough, ulps(lobe::schlick_roughness{F0, t}(u),
                                     lobe::schlick_roughness{digits50(F0), digits50(t)}(digits50(u))));
        if (i % 20 == 0) {
            const T eta = static_cast<T>(random.log_between(0.04, 10)), k = static_cast<T>(random.log_between(0.5, 10));
            metals = std::max(
                metals, ulps(lobe::conductor{eta, k}.average(), lobe::conductor{digits50(eta), digits50(k)}.average()));
        }
    }
    INFO("Walsh " << walsh << ", conductor " << metals << ", F82 " << tint << " of 1, Gaussian " << gaussian
                  << ", roughness " << rough << ", F0 " << f0 << ", index " << ior);
    CHECK(walsh <= 12);  // the bracket is 3 times smaller than the largest of its terms, which carry 4 ULP each
    CHECK(metals <= 16);
    CHECK(tint <= 4);
    CHECK(gaussian <= 8);
    CHECK(rough <= 8);
    CHECK(f0 <= 7);  // three roundings of the quotient, doubled by the square, and one of that
    CHECK(ior <= 4);
}

TEST_CASE("fifty digits keep fifty digits", "[fresnel]") {
    const digits50 eta("1.37"), c("0.3"), k("2.9"), tiny("1e-45");
    CHECK(abs(lobe::dielectric{eta}(c)-printed_fresnel(eta, 0, c)) < tiny);
    CHECK(abs(lobe::conductor{eta, k}(c)-printed_fresnel(eta, k, c)) < tiny);
    for (const char* n : {"0.2", "0.7", "1.1", "1.5", "1.7", "5", "300"})
        CHECK(abs(lobe::dielectric{digits50(n)}.average() - printed_walsh(digits50(n))) < tiny);
    // nodes in double
    CHECK(abs(lobe::conductor{eta, digits50(0)}.average() - lobe::dielectric{eta}.average()) < digits50("1e-15"));
    CHECK(abs(lobe::ior_from_f0(lobe::f0_from_ior(eta)) - eta) < tiny);
    const lobe::vec3<digits50> three{eta, eta, k};
    CHECK(abs(lobe::conductor{three, three}(c).z - printed_fresnel(k, k, c)) < tiny);
}
