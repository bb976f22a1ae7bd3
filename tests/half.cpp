// GGX in half precision (binary16), emulated, and by the compiler's own type where there is one.
#include "catch.hpp"
#include "support.hpp"

#include <lobe/ndf/ggx.hpp>
#include <lobe/ndf/ggx_half.hpp>

#include <bit>
#include <iomanip>
#include <iostream>
#include <utility>

using lobe::alpha;
using lobe::ggx;
using lobe::vec3;

// Named, not anonymous: lobe's templates find the operators by their arguments' namespace.
namespace binary16 {

enum class subnormals { kept, flushed };

/// x to the nearest of binary16, ties to even: 11 bits, down to steps of 2^-24, infinite from 65520 on. Flushed: 0
/// below 2^-14. Sums and products of two halves are exact in double (53 bits), and quotients cannot fall on a tie
/// unless they are one (53 >= 2 11 + 2, Figueroa 1995), so to compute in double and round once more is correct
/// rounding.
inline double rounded(double x, subnormals mode) {
    if (!std::isfinite(x) || x == 0) return x;
    int exponent = 0;
    std::frexp(x, &exponent);
    const double step = std::ldexp(1.0, std::max(exponent - 11, -24));
    const double nearest = std::nearbyint(x / step) * step;
    if (std::abs(nearest) > 65504) return std::copysign(std::numeric_limits<double>::infinity(), x);
    return mode == subnormals::flushed && std::abs(nearest) < 0x1p-14 ? std::copysign(0.0, x) : nearest;
}

/// A number that is rounded to binary16 after each step.
template <subnormals mode>
struct half {
    double value;
    half() = default;
    explicit half(double x) : value(rounded(x, mode)) {}
    explicit operator double() const { return value; }
    friend half operator-(half a) { return half(-a.value); }
    friend half operator+(half a, half b) { return half(a.value + b.value); }
    friend half operator-(half a, half b) { return half(a.value - b.value); }
    friend half operator*(half a, half b) { return half(a.value * b.value); }
    friend half operator/(half a, half b) { return half(a.value / b.value); }
    friend bool operator<(half a, half b) { return a.value < b.value; }
    friend bool operator>(half a, half b) { return a.value > b.value; }
};

#if defined(__FLT16_MANT_DIG__)  // the compiler has _Float16
/// _Float16, rounded after each step: compilers may keep the digits of float within an expression.
struct native {
    _Float16 value;
    native() = default;
    explicit native(double x) : value(static_cast<_Float16>(x)) {}
    static native from(_Float16 x) {
        native n;
        n.value = x;
        return n;
    }
    explicit operator double() const { return static_cast<double>(value); }
    friend native operator-(native a) { return from(-a.value); }
    friend native operator+(native a, native b) { return from(a.value + b.value); }
    friend native operator-(native a, native b) { return from(a.value - b.value); }
    friend native operator*(native a, native b) { return from(a.value * b.value); }
    friend native operator/(native a, native b) { return from(a.value / b.value); }
    friend bool operator<(native a, native b) { return a.value < b.value; }
    friend bool operator>(native a, native b) { return a.value > b.value; }
};
#endif

}  // namespace binary16

using binary16::subnormals;
using half = binary16::half<subnormals::kept>;
using flushed_half = binary16::half<subnormals::flushed>;

namespace {

constexpr double pi = 3.141592653589793;
constexpr double u = 0x1p-11;                // the rounding of one step
constexpr double last_alpha = 0.0022044038;  // 1/sqrt(65504 pi)

/// n roundings: (1 + u)^n - 1.
double roundings(int n, double unit = u) { return std::expm1(n * std::log1p(unit)); }

double to_half(double x) { return binary16::rounded(x, subnormals::kept); }

// The forms that are compared, in the arithmetic of T.

/// a^2/(pi (c (a^2 c - c) + 1)^2): Karis 2013, as shaders in float have it.
template <class T>
T textbook(const vec3<T>& m, const T& a) {
    const T a2 = a * a, d = (m.z * a2 - m.z) * m.z + T(1);
    return a2 / (lobe::pi<T>() * d * d);
}

/// (a/(1 - c^2 + (a c)^2))^2/pi.
template <class T>
T one_minus_square(const vec3<T>& m, const T& a) {
    const T n = m.z * a, k = a / (T(1) - m.z * m.z + n * n);
    return k * k * lobe::inv_pi<T>();
}

/// The same with |n x m|^2, clamped: Filament's D_GGX and Unity's GGX_Mobile (with its 1/pi).
template <class T>
T lagrange(const vec3<T>& m, const T& a) {
    const T n = m.z * a, k = a / (m.x * m.x + m.y * m.y + n * n);
    return lobe::smaller(k * k * lobe::inv_pi<T>(), T(65504));
}

/// D by its definition, of m as it is, unit or not.
double exact_D(double x, double y, double z, double a) {
    const double k = a / (x * x + y * y + a * a * z * z);
    return k * k / pi;
}

struct sweep_error {
    double worst = 0, mean = 0, same_inputs = 0, alpha_at_worst = 0, theta_at_worst = 0;
};

/// Relative errors of D over alpha (rounded to half, so that it is known exactly) and theta from 0 to the horizon,
/// every azimuth, against double: of the direction before it was rounded, and of the rounded m as it is. What D loses
/// because it is subnormal itself, or rounds to one, is not counted.
template <class T, class D>
sweep_error sweep(const D& density, double low, double high, double step, double subnormal = 0x1p-25) {
    constexpr int thetas = 2000;
    sweep_error e;
    int count = 0;
    for (int j = 0; low + j * step <= high * (1 + 1e-9); ++j) {
        const double a = to_half(low + j * step);
        for (int i = 0; i <= thetas; ++i, ++count) {
            const double theta = pi / 2 * i / thetas, phi = 2.399963 * i;
            const double s = std::sin(theta), c = i == thetas ? 0 : std::cos(theta);
            const vec3<T> m{static_cast<T>(s * std::cos(phi)), static_cast<T>(s * std::sin(phi)), static_cast<T>(c)};
            const double value = static_cast<double>(density(m, static_cast<T>(a)));
            const auto error = [&](double exact) {
                const double distance = std::abs(value - exact);
                return (exact < 0x1.04p-14 ? larger(0.0, distance - subnormal) : distance) / exact;
            };
            const double wrong = error(exact_D(s * std::cos(phi), s * std::sin(phi), c, a));
            const double wrong_here =
                error(exact_D(static_cast<double>(m.x), static_cast<double>(m.y), static_cast<double>(m.z), a));
            e.mean += wrong;
            e.same_inputs = larger(e.same_inputs, wrong_here);
            if (wrong <= e.worst || std::isnan(e.worst)) continue;  // a NaN is the worst of all
            e.worst = wrong;
            e.alpha_at_worst = a;
            e.theta_at_worst = theta;
        }
    }
    e.mean /= count;
    return e;
}

const auto by_ggx = []<class T>(const vec3<T>& m, const T& a) { return ggx{alpha<T>(a)}.D(m); };
const auto by_half = []<class T>(const vec3<T>& m, const T& a) { return lobe::D_ggx_half(m, alpha<T>(a)); };

void print(const std::string& name, const sweep_error& e) {
    std::cout << std::left << std::setw(58) << name << std::right << std::setprecision(3);
    for (const double x : {e.worst, e.alpha_at_worst, e.theta_at_worst, e.mean}) std::cout << std::setw(10) << x;
    std::cout << '\n';
}

}  // namespace

TEST_CASE("half: D over alpha 0.05..1 and every angle, form by form", "[half]") {
    std::cout << "GGX in 16 bits, alpha 0.05 to 1, theta from 0 to the horizon: relative error of D against double\n"
              << std::left << std::setw(58) << "form"
              << "     worst     alpha     theta      mean\n";
    const auto row = [&]<class T>(T, const std::string& name, const auto& density) {
        const sweep_error e = sweep<T>(density, 0.05, 1, 0.05);
        print(name, e);
        return e;
    };
    const auto by_textbook = [](const auto& m, const auto& a) { return textbook(m, a); };
    const auto by_square = [](const auto& m, const auto& a) { return one_minus_square(m, a); };
    const auto by_lagrange = [](const auto& m, const auto& a) { return lagrange(m, a); };
    const auto text = row(half(0), "half   a^2/(pi (c (a^2 c - c) + 1)^2)", by_textbook);
    const auto square = row(half(0), "half   k with 1 - c^2", by_square);
    const auto mobile = row(half(0), "half   k with |n x m|^2 (Filament, Unity mobile)", by_lagrange);
    const auto general = row(half(0), "half   lobe::ggx", by_ggx);
    const auto special = row(half(0), "half   lobe::D_ggx_half", by_half);
    const auto flushed_mobile = row(flushed_half(0), "half   k with |n x m|^2, subnormals flushed", by_lagrange);
    const auto flushed_general = row(flushed_half(0), "half   lobe::ggx, subnormals flushed", by_ggx);
    const auto flushed_special = row(flushed_half(0), "half   lobe::D_ggx_half, subnormals flushed", by_half);
    const auto in_float = row(0.0f, "float  lobe::ggx", by_ggx);
    const auto text_in_float = row(0.0f, "float  a^2/(pi (c (a^2 c - c) + 1)^2)", by_textbook);

    // Roundings, each of u = 2^-11 at most. D_ggx_half: q 4 (two in a product, two sums), the quotient 1, twice that in
    // the square, 1/pi and two products: 13. The rounding of m moves q by 2: 4 more in D.
    CHECK(special.same_inputs < roundings(13));
    CHECK(special.worst < roundings(17));
    // a product below 6.1e-5 beside q >= 64 alpha = 3.2: 2e-5 each, 0.1 u
    CHECK(flushed_special.same_inputs < roundings(13 + 1));
    CHECK(flushed_special.worst < roundings(17 + 1));
    // On average, errors that are uniform within +-u have the variance u^2/3: of k 1 (quotient) + 2 (sums) + 2 (a
    // product) + 4 (m, squared), four times that in D, two products more; and 1/pi is off by 0.32 u.
    CHECK(special.mean < (std::sqrt((4 * 9 + 2) / 3.0) + 0.32) * u);
    // ggx<half>: 4 in a (m.m), 4 in the denominator, 1 in the quotient; twice that and 1 for the square; 3 for 1/pi; m
    // moves the quotient by 4: 30, and the squares' subnormals are 3 2^-25 of a^2 >= 0.0025.
    CHECK(general.worst < roundings(30 + 1));
    CHECK(mobile.worst < roundings(30 + 1));
    // Where subnormals are flushed, x^2 and y^2 may lose 6.1e-5 each beside a^2 = 0.0025: 5 % of k, 10 % of D.
    CHECK(flushed_general.worst > 0.04);
    CHECK(flushed_mobile.worst > 0.04);
    CHECK(flushed_general.worst < 4 * 0x1p-14 / 0.0024 + roundings(31));
    // What all of this is for: cosines round to 1 up to theta = 0.022, where D at alpha 0.05 has fallen to 1/1.42 of
    // its peak.
    CHECK(text.worst > 0.4);
    CHECK(square.worst > 0.4);
    CHECK(in_float.worst < 12 * 0x1p-23 + roundings(8, 0x1p-24));  // 12 ULP, as ggx states, and the rounding of m
    CHECK(text_in_float.worst > 20 * in_float.worst);
}

TEST_CASE("half: D_ggx_half down to alpha 0.0022, where ggx in half is infinite", "[half]") {
    const auto special = sweep<half>(by_half, 0.0022066, 0.05, 0.0005);
    const auto flushed = sweep<flushed_half>(by_half, 0.0022066, 0.05, 0.0005, 0x1p-14);
    const auto general = sweep<half>(by_ggx, 1.0 / 128, 0.05, 0.0005);
    std::cout << "alpha 0.0022 to 0.05\n";
    print("half   lobe::D_ggx_half", special);
    print("half   lobe::D_ggx_half, subnormals flushed", flushed);
    print("half   lobe::ggx, alpha 0.0078 to 0.05", general);
    CHECK(special.same_inputs < roundings(13));
    CHECK(special.worst < roundings(17));
    // flushed: two products below 2^-14 beside q >= 64 alpha = 0.14 are 2 x 0.9 u of q, 4 u of D
    CHECK(flushed.same_inputs < roundings(13 + 4));
    CHECK(flushed.worst < roundings(17 + 4));
    // squares that are subnormal, off by 3 2^-25 in all beside a^2 = 2^-14: 3 u of k
    CHECK(general.worst < roundings(31 + 6));
    CHECK(std::isinf(static_cast<double>(ggx{alpha{half(1.0 / 257)}}.D({half(0), half(0), half(1)}))));
    CHECK(std::isfinite(static_cast<double>(ggx{alpha{half(1.0 / 255)}}.D({half(0), half(0), half(1)}))));
}

TEST_CASE("half: where the clamp begins, and what it costs", "[half]") {
    const vec3<half> n{half(0), half(0), half(1)};
    const auto peak = [&](double a) { return static_cast<double>(lobe::D_ggx_half(n, alpha{half(a)})); };
    // 1/sqrt(65504 pi). Along the normal q is exact, so that D is off by 5 u at most (two of the quotient, 1/pi, two
    // products), alpha by 1
    CHECK(last_alpha == Catch::Approx(1 / std::sqrt(65504 * pi)).epsilon(1e-7));
    CHECK(peak(last_alpha * (1 + 4 * u)) < 65504);
    CHECK(peak(last_alpha * (1 - 4 * u)) == 65504);
    CHECK(std::isinf(
        static_cast<double>(lobe::D_ggx_half(n, alpha{half(0.002)}, half(std::numeric_limits<double>::infinity())))));
    CHECK(static_cast<double>(lobe::D_ggx_half(n, alpha{half(0.1)}, half(10))) == 10);
    // Every alpha that is a half, and every direction: a number between 0 and 65504.
    int bad = 0;
    for (int exponent = -24; exponent <= 0; ++exponent)
        for (double mantissa : {1.0, 1.37, 1.9})
            for (int i = 0; i <= 400; ++i) {
                const double s = i < 100 ? std::exp2(-0.25 * i) : std::sin(pi / 2 * (i - 100) / 300),
                             c = std::sqrt((1 - s) * (1 + s));
                const alpha<half> a{half(std::min(1.0, std::ldexp(mantissa, exponent)))};
                const double D = static_cast<double>(lobe::D_ggx_half({half(0.6 * s), half(-0.8 * s), half(c)}, a));
                const double below = static_cast<double>(lobe::D_ggx_half({half(0.6 * s), half(0.8 * s), half(-c)}, a));
                bad += !(D >= 0 && D <= 65504) + !(c > 1e-3 ? below == 0 : below >= 0);
            }
    CHECK(bad == 0);
    // int min(D, 65504) cos dm = 2 c - c^2, c = alpha/last_alpha: in t = sin^2, cos dm = pi dt, D = a^2/(pi (a^2 + (1 -
    // a^2) t)^2); a^2 beside 1 is 5e-6. The trapezoid rule in ln t.
    for (const auto& [a, stated] : {std::pair{0.002, 0.99}, std::pair{0.001, 0.70}, std::pair{1e-4, 0.09}}) {
        const double width = to_half(a), c = width / last_alpha;
        double light = 0, in_double = 0;
        constexpr int steps = 4000;
        const double low = std::log(1e-6 * width * width), h = -low / steps;
        for (int i = 0; i <= steps; ++i) {
            const double t = std::exp(low + i * h), s = std::sqrt(t), z = std::sqrt(1 - std::min(t, 1.0)),
                         weight = pi * t * h;
            light += weight * static_cast<double>(lobe::D_ggx_half(vec3<half>{half(0.6 * s), half(0.8 * s), half(z)},
                                                                   alpha{half(width)}));
            in_double += weight * lobe::D_ggx_half(vec3<double>{0.6 * s, 0.8 * s, z}, alpha{width});
        }
        INFO("alpha " << a << ": " << light << ", in double " << in_double << ", stated " << 2 * c - c * c);
        // 1e-6 c^2 below the first node, h^2 at the kink
        CHECK(in_double == Catch::Approx(2 * c - c * c).margin(1e-4));
        CHECK(light == Catch::Approx(in_double).epsilon(roundings(17)));
        CHECK(2 * c - c * c == Catch::Approx(stated).margin(0.006));
    }
}

TEMPLATE_TEST_CASE("half: D_ggx_half is GGX in any scalar type", "[half]", float, double) {
    using T = TestType;
    random_numbers random(1);
    double worst = 0;
    for (int i = 0; i < 100000; ++i) {
        const T a = static_cast<T>(random.log_between(0.0023, 1));
        const auto m = random.grazing_direction<T>(1e-3);
        const long double x = m.x, y = m.y, z = m.z, w = a, k = w / (x * x + y * y + w * w * z * z);
        worst = larger(worst, ulp_error(lobe::D_ggx_half(m, alpha<T>(a)), k * k / 3.14159265358979323846264338L));
    }
    INFO(worst << " ULP");
    CHECK(worst <= 13);  // a rounding is an ULP at most
    CHECK(lobe::D_ggx_half(vec3<T>{0, 0, -1}, alpha<T>(T(0.1))) == 0);
    CHECK(lobe::D_ggx_half(vec3<T>{0, 0, 1}, alpha<T>(T(0.001))) == T(65504));
}

#if defined(__FLT16_MANT_DIG__)

namespace {

bool same(half a, _Float16 b) {
    const double x = static_cast<double>(a), y = static_cast<double>(b);
    return (std::isnan(x) && std::isnan(y)) || (x == y && std::signbit(x) == std::signbit(y));
}

}  // namespace

TEST_CASE("half: the emulation is the compiler's _Float16, bit for bit", "[half]") {
    random_numbers random(2);
    int wrong = 0;
    // conversions: every half, the ties between neighbours, and what is next to the ties
    for (unsigned bits = 0; bits < 0x7c00; ++bits) {
        const double x = static_cast<double>(std::bit_cast<_Float16>(static_cast<std::uint16_t>(bits)));
        const double next = bits == 0x7bff
                                ? 65536.0
                                : static_cast<double>(std::bit_cast<_Float16>(static_cast<std::uint16_t>(bits + 1)));
        const double tie = (x + next) / 2;
        for (const double y : {x, tie, std::nextafter(tie, 0.0), std::nextafter(tie, 1e9)})
            wrong += !same(half(y), static_cast<_Float16>(y)) + !same(half(-y), static_cast<_Float16>(-y));
    }
    CHECK(wrong == 0);
    // operations: any two bit patterns, infinities and NaN among them
    for (int i = 0; i < 1000000; ++i) {
        const auto any = [&] { return std::bit_cast<_Float16>(static_cast<std::uint16_t>(random() * 65536)); };
        const _Float16 a = any(), b = any();
        const half x(static_cast<double>(a)), y(static_cast<double>(b));
        const _Float16 sum = a + b, difference = a - b, product = a * b, quotient = a / b;
        wrong += !same(x + y, sum) + !same(x - y, difference) + !same(x * y, product) + !same(x / y, quotient) +
                 ((x < y) != (a < b));
    }
    CHECK(wrong == 0);
    // and so is D
    using binary16::native;
    for (int i = 0; i < 200000; ++i) {
        const auto m = random.grazing_direction(1e-5);
        const double a = random.log_between(1e-5, 1);
        const vec3<half> h{half(m.x), half(m.y), half(m.z)};
        const vec3<native> w{native(m.x), native(m.y), native(m.z)};
        wrong += !same(lobe::D_ggx_half(h, alpha{half(a)}), lobe::D_ggx_half(w, alpha{native(a)}).value);
        wrong += !same(ggx{alpha{half(a)}}.D(h), ggx{alpha{native(a)}}.D(w).value);
    }
    CHECK(wrong == 0);
}

TEST_CASE("half: D takes _Float16 as it is", "[half]") {
    const auto special = sweep<_Float16>(by_half, 0.0022066, 1, 0.01), general = sweep<_Float16>(by_ggx, 0.05, 1, 0.05);
    CHECK(special.worst < roundings(17));
    CHECK(general.worst < roundings(31));
}

#endif
