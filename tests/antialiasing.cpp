#include "catch.hpp"
#include "support.hpp"

#include <lobe/core/frame.hpp>
#include <lobe/energy/quadrature.hpp>
#include <lobe/ndf/ggx.hpp>
#include <lobe/width/antialiasing.hpp>

#include <xsimd/xsimd.hpp>

using lobe::alpha;
using lobe::alpha_xy;
using lobe::lean_moments;
using lobe::slope_matrix;
using lobe::vec2;
using lobe::vec3;

namespace {

constexpr double pi = 3.141592653589793;
constexpr double epsilon = std::numeric_limits<double>::epsilon();

/// Beckmann's density of slopes, written out here.
double beckmann_slopes(double ax, double ay, double x, double y) {
    return std::exp(-(x / ax) * (x / ax) - (y / ay) * (y / ay)) / (pi * ax * ay);
}
double ggx_slopes(double ax, double ay, double x, double y) {
    const double t = 1 + (x / ax) * (x / ax) + (y / ay) * (y / ay);
    return 1 / (pi * ax * ay * t * t);
}

/// The average of `slopes` over Gaussian offsets of the covariance C, by the trapezoidal rule on a square of 8 standard
/// deviations: 1e-14 for Gaussians (its error is that of exp(-2 pi^2/step^2), step = 1/8 of a deviation).
template <class F>
double average_over_gaussian(const slope_matrix<double>& C, const F& slopes) {
    // b = L (s, t), L the Cholesky factor
    const double l11 = std::sqrt(C.xx), l21 = C.xy / l11, l22 = std::sqrt(C.yy - l21 * l21);
    double total = 0;
    for (int i = -64; i <= 64; ++i)
        for (int j = -64; j <= 64; ++j) {
            const double s = i / 8.0, t = j / 8.0;
            total += std::exp(-(s * s + t * t) / 2) / (2 * pi * 64) * slopes(l11 * s, l21 * s + l22 * t);
        }
    return total;
}

/// The matrix alpha^2 of a width with axes of its own.
slope_matrix<double> matrix_of(const lobe::oriented_width<double>& o) {
    const double x2 = o.width.x() * o.width.x(), y2 = o.width.y() * o.width.y(), c = o.tangent.x, s = o.tangent.y;
    return {x2 * c * c + y2 * s * s, (x2 - y2) * c * s, x2 * s * s + y2 * c * c};
}

double distance(const slope_matrix<double>& a, const slope_matrix<double>& b) {
    return larger({std::abs(a.xx - b.xx), std::abs(a.xy - b.xy), std::abs(a.yy - b.yy)});
}

}  // namespace

TEST_CASE("the average of Beckmann surfaces is the Beckmann surface of the added variance", "[antialiasing]") {
    const slope_matrix<double> C{0.04, 0.015, 0.02};
    const alpha_xy base{0.3, 0.2};
    const auto wide = lobe::widened(base, C);
    const alpha isotropic{0.25};
    double worst = 0;
    for (double x : {0.0, 0.1, -0.3, 0.6})
        for (double y : {0.0, 0.2, -0.4}) {
            const double average = average_over_gaussian(
                C, [&](double bx, double by) { return beckmann_slopes(base.x(), base.y(), x - bx, y - by); });
            const double u = x * wide.tangent.x + y * wide.tangent.y, w = y * wide.tangent.x - x * wide.tangent.y;
            worst = larger(worst, std::abs(average / beckmann_slopes(wide.width.x(), wide.width.y(), u, w) - 1));
            const double even = average_over_gaussian(
                {0.03, 0, 0.03}, [&](double bx, double by) { return beckmann_slopes(0.25, 0.25, x - bx, y - by); });
            const double a = lobe::widened(isotropic, 0.03).value();
            worst = larger(worst, std::abs(even / beckmann_slopes(a, a, x, y) - 1));
            const auto aligned = lobe::widened(base, 0.03);
            const double both = average_over_gaussian(
                {0.03, 0, 0.03}, [&](double bx, double by) { return beckmann_slopes(0.3, 0.2, x - bx, y - by); });
            worst = larger(worst, std::abs(both / beckmann_slopes(aligned.x(), aligned.y(), x, y) - 1));
        }
    INFO(worst);
    CHECK(worst < 1e-12);
}

TEST_CASE("for GGX the added variance is an approximation, too narrow at the core", "[antialiasing]") {
    // variance = alpha^2/2, at the peak: the average is (1 - e E1(1))/(pi alpha^2), the rule 1/(2 pi alpha^2): 24 %
    // above
    const double a = 0.2, variance = a * a / 2;
    const double average =
        average_over_gaussian({variance, 0, variance}, [&](double x, double y) { return ggx_slopes(a, a, x, y); });
    CHECK(average == Catch::Approx((1 - 0.596347362323194) / (pi * a * a)).epsilon(1e-6));
    const double rule = lobe::ggx{lobe::widened(alpha{a}, variance)}.D(vec3<double>{0, 0, 1});
    CHECK(rule / average == Catch::Approx(1.2387).epsilon(1e-4));
}

TEST_CASE("eigen-decomposition: the matrix again, orthonormal, the wider axis first", "[antialiasing]") {
    random_numbers random(1);
    double back = 0, unit = 0;
    bool ordered = true;
    for (int i = 0; i < 100000; ++i) {
        const alpha_xy base{random.log_between(1e-2, 1), random.log_between(1e-2, 1)};
        const double s1 = random.log_between(1e-3, 1), s2 = random.log_between(1e-3, 1), c = random.between(-1, 1);
        const slope_matrix<double> C{s1 * s1, c * s1 * s2, s2 * s2};
        const auto o = lobe::widened(base, C);
        const slope_matrix<double> sum{base.x() * base.x() + 2 * C.xx, 2 * C.xy, base.y() * base.y() + 2 * C.yy};
        back = larger(back, distance(matrix_of(o), sum) / (sum.xx + sum.yy));
        unit = larger(unit, std::abs(lobe::dot(o.tangent, o.tangent) - 1));
        ordered = ordered && o.width.x() >= o.width.y();
    }
    INFO(back / epsilon << ' ' << unit / epsilon);
    CHECK(back < 8 * epsilon);  // products of rounded widths and axes
    CHECK(unit < 4 * epsilon);
    CHECK(ordered);

    const auto round = lobe::widened(alpha_xy{0.3, 0.3}, slope_matrix<double>{0.02, 0, 0.02});
    CHECK(round.tangent == vec2<double>{1, 0});
    CHECK(round.width.x() == Catch::Approx(std::sqrt(0.09 + 0.04)));
    const auto along_y = lobe::widened(alpha_xy{0.1, 0.3}, slope_matrix<double>{0, 0, 0});
    CHECK(std::abs(along_y.tangent.y) == 1);
    CHECK(along_y.width.x() == Catch::Approx(0.3));
    CHECK(along_y.width.y() == Catch::Approx(0.1));
}

TEST_CASE("a scratched mirror, where the determinant has no digits left in float", "[antialiasing]") {
    random_numbers random(2);
    double low = 0, high = 0;
    for (int i = 0; i < 10000; ++i) {
        const float angle = static_cast<float>(random.between(0, 6.28)),
                    s = static_cast<float>(random.log_between(0.1, 1)), x = s * std::cos(angle),
                    y = s * std::sin(angle);
        const auto o = lobe::widened(alpha_xy{1e-4f, 1e-4f}, slope_matrix<float>{x * x, x * y, y * y});  // rank 1
        // truth: 1e-4 across; x x, x y, y y are rounded, by 6e-8 s^2, which is up to 2.4e-4 s of width
        low = larger(low, 1e-4 - static_cast<double>(o.width.y()));
        high = larger(high, static_cast<double>(o.width.y() / s));
        CHECK(std::abs(o.tangent.x * y - o.tangent.y * x) < 2e-6f * s);
    }
    INFO(low << ' ' << high);
    CHECK(low < 1e-11);  // never narrower than the base
    CHECK(high < 1.5e-3);
}

TEST_CASE("LEAN: moments of a normal map", "[antialiasing]") {
    random_numbers random(3);
    std::vector<vec3<double>> normals;
    for (int i = 0; i < 256; ++i) {
        const double x = random.between(-0.3, 0.5), y = 0.5 * x + random.between(-0.2, 0.1);
        normals.push_back(random.between(0.5, 2) * vec3<double>{-x, -y, 1});  // any length
    }
    // averaged in pairs, as mip levels are
    std::vector<lean_moments<double>> level;
    std::vector<lobe::clean_moments<double>> clean;
    for (const auto& n : normals) {
        level.push_back(lean_moments<double>::of(n));
        clean.push_back(lobe::clean_moments<double>::of(n));
    }
    for (; level.size() > 1; level.resize(level.size() / 2), clean.resize(clean.size() / 2))
        for (std::size_t i = 0; 2 * i < level.size(); ++i) {
            level[i] = level[2 * i] * 0.5 + level[2 * i + 1] * 0.5;
            clean[i] = clean[2 * i] * 0.5 + clean[2 * i + 1] * 0.5;
        }
    // in two passes
    double mx = 0, my = 0;
    for (const auto& n : normals) mx += -n.x / n.z / 256, my += -n.y / n.z / 256;
    slope_matrix<double> two_pass{0, 0, 0};
    for (const auto& n : normals) {
        const double dx = -n.x / n.z - mx, dy = -n.y / n.z - my;
        two_pass = {two_pass.xx + dx * dx / 256, two_pass.xy + dx * dy / 256, two_pass.yy + dy * dy / 256};
    }
    CHECK(distance(level[0].covariance(), two_pass) < 1e-15);
    CHECK(clean[0].variance() == Catch::Approx((two_pass.xx + two_pass.yy) / 2).epsilon(1e-13));
    CHECK(lobe::length(level[0].normal() - lobe::normalize(vec3<double>{-mx, -my, 1})) < 1e-15);
    CHECK(lobe::length(clean[0].normal() - level[0].normal()) < 1e-15);

    // End to end: the slopes of the whole map, each texel a Beckmann surface of its own, have the mean and covariance
    // of the filtered one.
    const alpha_xy base{0.2, 0.35};
    double m0 = 0, m1 = 0, mxx = 0, mxy = 0, myy = 0;
    for (const auto& n : normals)
        for (int i = -32; i <= 32; ++i)
            for (int j = -32; j <= 32; ++j) {  // trapezoidal, 8 standard deviations
                const double dx = base.x() * i / 6, dy = base.y() * j / 6, x = dx - n.x / n.z, y = dy - n.y / n.z;
                const double w = beckmann_slopes(base.x(), base.y(), dx, dy) * base.x() * base.y() / 36 / 256;
                m0 += w, m1 += w * x, mxx += w * (x - mx) * (x - mx), mxy += w * (x - mx) * (y - my),
                    myy += w * (y - my) * (y - my);
            }
    CHECK(m0 == Catch::Approx(1).epsilon(1e-9));
    CHECK(m1 == Catch::Approx(mx).epsilon(1e-9));
    const auto filtered = matrix_of(lobe::widened(base, level[0].covariance()));
    CHECK(distance(filtered, {2 * mxx, 2 * mxy, 2 * myy}) < 1e-9);

    // The oriented width through a frame: D of the rotated GGX is the matrix form 1/(pi sqrt(det) z^4 (1 + x^T A^-1
    // x)^2)
    const auto o = lobe::widened(base, two_pass);
    const lobe::frame<double> at(vec3<double>{0, 0, 1}, vec3<double>{o.tangent.x, o.tangent.y, 0});
    const auto A = matrix_of(o);
    const double det = A.xx * A.yy - A.xy * A.xy;
    for (int i = 0; i < 100; ++i) {
        const vec3<double> m = random.grazing_direction(0.1);
        const double x = m.x / m.z, y = m.y / m.z, q = 1 + (A.yy * x * x - 2 * A.xy * x * y + A.xx * y * y) / det;
        CHECK(lobe::ggx{o.width}.D(at.to_local(m)) ==
              Catch::Approx(1 / (pi * std::sqrt(det) * q * q * m.z * m.z * m.z * m.z)).epsilon(1e-10));
    }
}

TEST_CASE("one normal has no variance, and rounding does not make it negative", "[antialiasing]") {
    random_numbers random(4);
    for (int i = 0; i < 10000; ++i) {
        const vec3<float> n = random.grazing_direction<float>(0.1);
        auto sum = lean_moments<float>::of(n) * 0.3f + lean_moments<float>::of(n) * 0.7f;
        const auto C = sum.covariance();
        const float scale = sum.M.xx + sum.M.yy;
        const float variance =
            (lobe::clean_moments<float>::of(n) * 0.3f + lobe::clean_moments<float>::of(n) * 0.7f).variance();
        REQUIRE((C.xx >= 0 && C.yy >= 0 && variance >= 0));
        // M and b b^T: two products and a sum each, b twice
        REQUIRE(larger({C.xx, C.yy, std::abs(C.xy), variance}) <= 8 * 6e-8f * scale);
    }
}

TEST_CASE("Toksvig", "[antialiasing]") {
    random_numbers random(5);
    for (int i = 0; i < 1000; ++i) {
        const double p = random.log_between(1, 1e4), length = random.between(0.1, 1),
                     variance = lobe::toksvig_variance(length);
        CHECK(1 / lobe::toksvig_exponent(p, length) == Catch::Approx(1 / p + variance).epsilon(1e-13));
        const double a = random.log_between(1e-3, 1);
        const double wide = lobe::widened(alpha{a}, variance).value();
        CHECK(wide * wide == Catch::Approx(a * a + 2 * (1 - length) / length).epsilon(1e-13));
    }
    CHECK(lobe::toksvig_variance(1.0) == 0);
    CHECK(lobe::widened(alpha{0.3}, lobe::toksvig_variance(1.0)).value() == Catch::Approx(0.3));
    CHECK(lobe::toksvig_exponent(100.0, 1.0) == 100);

    // How far the proxy is off for Gaussian slopes of variance s: |N| = int e^-t (1 + 2 s t)^(-1/2) dt.
    const lobe::gauss_legendre<double> rule(64);
    const std::pair<double, double> known[] = {{0.001, 0.002}, {0.01, 0.019}, {0.05, 0.08}, {0.2, 0.22}};
    for (const auto& [s, off] : known) {
        double length = 0;
        for (std::size_t i = 0; i < rule.x.size(); ++i) {
            const double t = 40 * rule.x[i];
            length += 40 * rule.w[i] * std::exp(-t) / std::sqrt(1 + 2 * s * t);
        }
        CHECK(1 - lobe::toksvig_variance(length) / s == Catch::Approx(off).margin(off < 0.05 ? 0.0005 : 0.005));
    }
}

TEST_CASE("Toksvig: lengths that rounding and 8-bit maps take above 1 are 1", "[antialiasing]") {
    random_numbers random(12);
    int above = 0, bad = 0;
    const auto count = [&](float length) {
        above += length > 1;
        bad += !(lobe::toksvig_variance(length) >= 0) ||
               !(lobe::widened(alpha(1e-4f), lobe::toksvig_variance(length)).value() >= 0.999e-4f);
        bad += !(lobe::toksvig_exponent(100.0f, length) <= 100);
    };
    for (int i = 0; i < 10000; ++i) {
        const auto n = random.direction<float>();
        count(lobe::length(lobe::normalize(n)));
        const auto stored = [](float x) { return std::round((x + 1) / 2 * 255) / 255 * 2 - 1; };
        count(lobe::length(vec3<float>{stored(n.x), stored(n.y), stored(n.z)}));
    }
    CHECK(above > 1000);  // or nothing was tested
    CHECK(bad == 0);
    CHECK(lobe::toksvig_variance(std::nextafter(1.0f, 2.0f)) == 0);
    CHECK(lobe::toksvig_exponent(100.0f, 1.0068f) == 100);
}

TEST_CASE("a filter widens or leaves alone, whatever alpha", "[antialiasing]") {
    const vec3<double> none{0, 0, 0}, some{0.3, 0, 0};
    for (double a : {0.9, 1.0, 1.1, 2.0, 10.0}) {
        CHECK(lobe::widened_by_pixel(alpha{a}, none, none).value() == Catch::Approx(a).epsilon(1e-15));
        CHECK(lobe::widened_by_pixel(alpha{a}, some, none).value() >= a);
        CHECK(lobe::widened_by_pixel(alpha_xy{a, 0.1}, some, none).x() ==
              lobe::widened_by_pixel(alpha{a}, some, none).value());
        CHECK(lobe::widened_by_pixel(alpha_xy{0.1, a}, some, none).y() ==
              lobe::widened_by_pixel(alpha{a}, some, none).value());
    }
}

TEST_CASE("Tokuyoshi and Kaplanyan: normals of a pixel", "[antialiasing]") {
    random_numbers random(6);
    for (int i = 0; i < 100; ++i) {
        const vec3<double> dx = 0.1 * random.direction(), dy = 0.2 * random.direction();
        // Normals n0 + s dx + t dy, s and t of variance 1/(2 pi): the mean variance along two axes of the plane that dx
        // and dy span
        const double sigma2 = 1 / (2 * pi);
        const double trace = sigma2 * (lobe::dot(dx, dx) + lobe::dot(dy, dy));
        CHECK(lobe::pixel_variance(dx, dy) == Catch::Approx(trace / 2).epsilon(1e-14));
        const double a = random.between(0.01, 0.5), k2 = std::min(2 * trace / 2, 0.18);
        CHECK(lobe::widened_by_pixel(alpha{a}, dx, dy).value() == Catch::Approx(std::sqrt(a * a + k2)).epsilon(1e-14));
        CHECK(lobe::widened_by_pixel(alpha_xy{a, 0.7}, dx, dy).x() == lobe::widened_by_pixel(alpha{a}, dx, dy).value());
        CHECK(lobe::widened_by_pixel(alpha_xy{0.7, a}, dx, dy).y() == lobe::widened_by_pixel(alpha{a}, dx, dy).value());
    }
    const vec3<double> edge{1.5, 0, 0}, none{0, 0, 0};
    CHECK(lobe::widened_by_pixel(alpha{0.1}, edge, none).value() == Catch::Approx(std::sqrt(0.01 + 0.18)));
    CHECK(lobe::widened_by_pixel(alpha{0.95}, edge, none).value() == 1);
    CHECK(lobe::widened_by_pixel(alpha{0.1}, none, none).value() == Catch::Approx(0.1).epsilon(1e-15));
    CHECK(lobe::widened_by_pixel(alpha{0.1}, edge, none, 2 * 0.2).value() ==
          Catch::Approx(std::sqrt(0.01 + 1.5 * 1.5 / (2 * pi))));
}

TEST_CASE("Tokuyoshi and Kaplanyan: the half vector's footprint in projected space", "[antialiasing]") {
    random_numbers random(7);
    double worst = 0;
    for (int i = 0; i < 10000; ++i) {
        const double ax = random.log_between(1e-3, 0.99), ay = random.log_between(1e-3, 0.99),
                     size = random.log_between(1e-3, 1);
        const vec2<double> dx{random.between(-size, size), random.between(-size, size)},
            dy{random.between(-size, size), random.between(-size, size)};
        // As printed: W' = A/(1 - A) + K, A' = W' (1 + W')^-1, by matrices in long double
        using real = long double;
        const real s2 = 2 / (2 * 3.14159265358979323846264338L);
        const real wxx =
            real(ax) * real(ax) / (1 - real(ax) * real(ax)) + s2 * (real(dx.x) * real(dx.x) + real(dy.x) * real(dy.x));
        const real wyy =
            real(ay) * real(ay) / (1 - real(ay) * real(ay)) + s2 * (real(dx.y) * real(dx.y) + real(dy.y) * real(dy.y));
        const real wxy = s2 * (real(dx.x) * real(dx.y) + real(dy.x) * real(dy.y));
        const real det = (1 + wxx) * (1 + wyy) - wxy * wxy;
        const real axx = (wxx * (1 + wyy) - wxy * wxy) / det, axy = (-wxx * wxy + wxy * (1 + wxx)) / det,
                   ayy = (wyy * (1 + wxx) - wxy * wxy) / det;
        const auto got = matrix_of(lobe::widened_by_half_vector(alpha_xy{ax, ay}, dx, dy));
        worst = larger(worst,
                       distance(got, {static_cast<double>(axx), static_cast<double>(axy), static_cast<double>(ayy)}) /
                           static_cast<double>(axx + ayy));
    }
    INFO(worst / epsilon);
    CHECK(worst < 24 * epsilon);

    // W is GGX's squared width in the disk of (m.x, m.y): D = 1/(pi alpha^2 (1 + r^2/W)^2)
    for (double a : {0.1, 0.6}) {
        const vec3<double> m = random.grazing_direction(0.1);
        const double W = a * a / (1 - a * a), q = 1 + (m.x * m.x + m.y * m.y) / W;
        CHECK(lobe::ggx{alpha{a}}.D(m) == Catch::Approx(1 / (pi * a * a * q * q)).epsilon(1e-12));
    }
    const vec2<double> dx{0.2, 0.1}, dy{-0.1, 0.3}, none{0, 0};
    const auto same = lobe::widened_by_half_vector(alpha_xy{0.5, 0.2}, none, none);
    CHECK(same.width.x() == Catch::Approx(0.5).epsilon(1e-15));
    CHECK(same.width.y() == Catch::Approx(0.2).epsilon(1e-15));
    const auto full = lobe::widened_by_half_vector(alpha_xy{1.0, 1.0}, dx, dy);
    CHECK(full.width.x() == Catch::Approx(1).epsilon(1e-15));
    CHECK(full.width.y() == Catch::Approx(1).epsilon(1e-15));
    const auto huge = lobe::widened_by_half_vector(alpha_xy{0.01, 0.01}, 1e4 * dx, 1e4 * dy);
    CHECK((huge.width.x() <= 1 && huge.width.y() > 0.99));
    // For small widths and footprints it is the addition of variances
    const auto small = lobe::widened_by_half_vector(alpha_xy{1e-3, 1e-3}, 1e-3 * dx, 1e-3 * dy);
    const auto added = lobe::widened(alpha_xy{1e-3, 1e-3}, slope_matrix<double>{1e-6 * (0.04 + 0.01) / (2 * pi),
                                                                                1e-6 * (0.02 - 0.03) / (2 * pi),
                                                                                1e-6 * (0.01 + 0.09) / (2 * pi)});
    CHECK(small.width.x() == Catch::Approx(added.width.x()).epsilon(1e-5));
    CHECK(small.width.y() == Catch::Approx(added.width.y()).epsilon(1e-5));
}

TEST_CASE("widening packs", "[antialiasing]") {
    using pack = xsimd::batch<float>;
    const auto wide = lobe::widened(alpha_xy<pack>(pack(0.1f), pack(0.3f)),
                                    slope_matrix<pack>{pack(0.02f), pack(-0.01f), pack(0.03f)});
    const auto one = lobe::widened(alpha_xy(0.1f, 0.3f), slope_matrix<float>{0.02f, -0.01f, 0.03f});
    CHECK(wide.width.x().get(0) == Catch::Approx(one.width.x()));
    CHECK(wide.tangent.y.get(1) == Catch::Approx(one.tangent.y));
    const vec3<pack> dn{pack(0.1f), pack(0.2f), pack(0.0f)};
    CHECK(lobe::widened_by_pixel(alpha<pack>(pack(0.1f)), dn, dn).value().get(0) ==
          Catch::Approx(
              lobe::widened_by_pixel(alpha(0.1f), vec3<float>{0.1f, 0.2f, 0}, vec3<float>{0.1f, 0.2f, 0}).value()));
}

TEST_CASE("bad variances end in an assert", "[antialiasing]") {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    for (const float bad : {-0.1f, nan}) {
        CHECK(aborts([&] { (void)lobe::widened(alpha(0.1f), bad); }));
        CHECK(aborts([&] { (void)lobe::widened(alpha_xy(0.1f, 0.2f), bad); }));
        CHECK(aborts([&] { (void)lobe::toksvig_variance(bad); }));
        CHECK(aborts([&] { (void)lobe::toksvig_exponent(bad, 0.5f); }));
    }
    CHECK(aborts([] {
        (void)lobe::widened_by_half_vector(alpha_xy(0.1f, 1.1f), vec2<float>{0, 0}, vec2<float>{0, 0});
    }));
}
