// A rough interface: f, pdf and samples against printed forms, tables of another method, and each other.
#include "catch.hpp"
#include "support.hpp"

#include <lobe/brdf/microfacet.hpp>
#include <lobe/bsdf/rough_dielectric.hpp>
#include <lobe/fresnel/dielectric.hpp>
#include <lobe/ndf/beckmann.hpp>
#include <lobe/ndf/ggx.hpp>
#include <lobe/sampling/sobol.hpp>

#include <xsimd/xsimd.hpp>

using lobe::alpha;
using lobe::alpha_xy;
using lobe::beckmann;
using lobe::ggx;
using lobe::importance_transport;
using lobe::radiance_transport;
using lobe::rough_dielectric;
using lobe::smith_joint;
using lobe::smith_joint_exact;
using lobe::smith_product;
using lobe::vec3;

namespace {

using real = long double;

template <class T>
constexpr T eps = std::numeric_limits<T>::epsilon();

/// A view at the cosine mu, from above or from below.
template <class T = double>
vec3<T> view(double mu, bool above = true) {
    return {static_cast<T>(std::sqrt((1 - mu) * (1 + mu))), T(0), static_cast<T>(above ? mu : -mu)};
}

/// ln Gamma by Stirling's series from 30 on: the C library's agrees, and tells other threads of the sign.
real log_gamma(real x) {
    real product = 1;
    for (; x < 30; x += 1) product *= x;
    const real y = 1 / (x * x);
    return (x - 0.5L) * std::log(x) - x + 0.9189385332046727417803297364056L - std::log(product) +
           (1 / 12.0L - y * (1 / 360.0L - y * (1 / 1260.0L - y * (1 / 1680.0L - y * (1 / 1188.0L))))) / x;
}
real beta_ratio(real a, real b) { return std::exp(log_gamma(2 + a) + log_gamma(2 + b) - log_gamma(2 + a + b)); }

/// Equations 16, 20, 21 and 22 of Walter et al. 2007 as they are printed, of GGX: the half vector normalised, Snell's
/// law by cosines, masking by Lambda. f for radiance; and what says how well conditioned the half vector is.
struct printed {
    real f, pdf, K, c, g, mz, correlation;  // correlation: f over that of the product form
};
template <class T>
printed printed_glass(real ax, real ay, real eta, bool joint, const vec3<T>& v_in, const vec3<T>& l_in) {
    const real up = v_in.z < 0 ? -1 : 1, n = v_in.z < 0 ? 1 / eta : eta;
    const real v[3] = {real(v_in.x), real(v_in.y), up * real(v_in.z)},
               l[3] = {real(l_in.x), real(l_in.y), up * real(l_in.z)};
    const bool reflects = l[2] > 0;
    const real nl = reflects ? 1 : n;
    real h[3] = {v[0] + nl * l[0], v[1] + nl * l[1], v[2] + nl * l[2]};
    const real K = std::sqrt(h[0] * h[0] + h[1] * h[1] + h[2] * h[2]);
    for (real& x : h) x /= h[2] < 0 ? -K : K;
    const real vm = v[0] * h[0] + v[1] * h[1] + v[2] * h[2], lm = l[0] * h[0] + l[1] * h[1] + l[2] * h[2];
    if (!(vm > 0) || (reflects ? lm <= 0 : lm >= 0)) return {};
    const real t = (h[0] / ax) * (h[0] / ax) + (h[1] / ay) * (h[1] / ay) + h[2] * h[2];
    const real D = 1 / (3.14159265358979323846264338L * ax * ay * t * t);
    const auto Lambda = [&](const real* w) {
        return (std::sqrt(1 + (ax * ax * w[0] * w[0] + ay * ay * w[1] * w[1]) / (w[2] * w[2])) - 1) / 2;
    };
    const real a = Lambda(v), b = Lambda(l), product = 1 / ((1 + a) * (1 + b));
    const real G = !joint ? product : reflects ? 1 / (1 + a + b) : product * beta_ratio(a, b);
    const real g2 = n * n - 1 + vm * vm;
    real F = 1;
    if (g2 > 0) {
        const real g = std::sqrt(g2), A = (g - vm) / (g + vm), B = (vm * (g + vm) - 1) / (vm * (g - vm) + 1);
        F = A * A * (1 + B * B) / 2;
    }
    const real Dv = vm * D / ((1 + a) * v[2]), z = v[2] * std::abs(l[2]);
    if (reflects) return {F * D * G / (4 * z), F * Dv / (4 * vm), K, vm, lm, h[2], G / product};
    const real square = (vm + n * lm) * (vm + n * lm);
    return {vm * -lm * (1 - F) * D * G / (z * square),
            (1 - F) * Dv * n * n * -lm / square,
            K,
            vm,
            -n * lm,
            h[2],
            G / product};
}

template <class B>
void for_each_glass_pair(const B& glass, std::uint64_t seed, int pairs, const auto& use) {
    using T = typename B::scalar;
    random_numbers random(seed);
    for (int i = 0; i < pairs; ++i) {
        vec3<T> v = random.grazing_direction<T>(1e-2);
        if (random() < 0.5) v.z = -v.z;
        const auto s = glass.sample(v, {static_cast<T>(random()), static_cast<T>(random()), static_cast<T>(random())});
        if (s.pdf > 0) use(v, s);
    }
}

}  // namespace

TEST_CASE("the ratio of Gamma functions, to rounding and by its fit", "[glass]") {
    random_numbers random(1);
    double exact = 0, in_double = 0, in_float = 0;
    for (int i = 0; i < 200000; ++i) {
        const float a = static_cast<float>(random.log_between(1e-6, 1e9)),
                    b = static_cast<float>(random.log_between(1e-6, 1e3));
        const real truth = beta_ratio(a, b);
        if (a + b < 1e3F && truth > 1e-12L)
            exact =
                larger(exact, static_cast<double>(std::abs(real(lobe::detail::beta_ratio<double>(a, b)) / truth - 1)));
        in_double =
            larger(in_double, static_cast<double>(std::abs(real(lobe::detail::beta_ratio_fit<double>(a, b)) - truth)));
        in_float =
            larger(in_float, static_cast<double>(std::abs(real(lobe::detail::beta_ratio_fit<float>(b, a)) - truth)));
    }
    CHECK(exact < 1e-13);
    CHECK(in_double < 2.1e-7);
    CHECK(in_float < 1.3e-6);
    CHECK(lobe::detail::beta_ratio_fit(0.0F, 0.0F) <= 1);
    CHECK(lobe::detail::beta_ratio_fit(0.0F, 1e9F) > 1 - 4 * eps<float>);
}

TEST_CASE("refraction as printed", "[glass]") {
    // `model`: what the fit of the joint masking may be off by, absolutely
    const auto compare = [](const auto& glass, double ax, double ay, double eta, bool joint, double model) {
        double f = 0, pdf = 0;
        int seen = 0;
        for_each_glass_pair(glass, 2, 20000, [&](const auto& v, const auto& s) {
            if ((s.l.z > 0) == (v.z > 0)) return;  // compared with `microfacet` below
            using T = decltype(s.pdf);
            const printed p = printed_glass(ax, ay, eta, joint, v, s.l);
            if (!(std::min({p.c, p.g, p.mz}) > 0.1L)) return;
            const double slope =
                static_cast<double>(1 + 1 / (p.K * std::min(ax, ay)));  // of the half vector, in widths
            const auto e = glass.evaluate(v, s.l);
            const auto off = [&](T value, real truth, double allowed) {
                return (static_cast<double>(std::abs(real(value) / truth - 1)) - allowed) / eps<T> / slope;
            };
            const double fit = model / static_cast<double>(p.correlation);
            f = larger({f, off(e.f_cos, p.f * std::abs(real(s.l.z)), fit), off(glass.f(v, s.l), p.f, fit)});
            pdf = larger({pdf, off(e.pdf, p.pdf, 0), off(glass.pdf(v, s.l), p.pdf, 0)});
            ++seen;
        });
        INFO("eta " << eta << ", alpha " << ax << " " << ay << ", joint " << joint << ": f " << f << ", pdf " << pdf);
        CHECK(f < 32);
        CHECK(pdf < 32);
        CHECK(pdf > 0);
        CHECK(seen > 1000);
    };
    for (const double eta : {1.1, 1.33, 1.5, 2.4, 1 / 1.1, 1 / 1.33, 1 / 1.5, 1 / 2.4})
        for (const float a : {1e-4F, 1e-2F, 0.1F, 0.5F, 1.0F}) {
            const float n = static_cast<float>(eta), narrow = 0.1F * a;
            compare(rough_dielectric{ggx{alpha{a}}, smith_product{}, n}, a, a, n, false, 0);
            compare(rough_dielectric{ggx{alpha_xy{a, narrow}}, smith_product{}, n}, a, narrow, n, false, 0);
            compare(rough_dielectric{ggx{alpha{a}}, smith_joint{}, n}, a, a, n, true, 1.3e-6);
            compare(rough_dielectric{ggx{alpha{double(a)}}, smith_joint{}, eta}, a, a, eta, true, 2.1e-7);
            compare(rough_dielectric{ggx{alpha{double(a)}}, smith_joint_exact{}, eta}, a, a, eta, true, 1e-13);
        }
}

TEST_CASE("a sample's pdf and weight are those of its direction", "[glass]") {
    // what rounding l to double does to the half vector, in widths, is at most some 1e-13 here
    const auto compare = [](const auto& glass) {
        int reflected = 0, refracted = 0;
        for_each_glass_pair(glass, 5, 20000, [&](const auto& v, const auto& s) {
            const auto e = glass.evaluate(v, s.l);
            REQUIRE(s.pdf == Catch::Approx(e.pdf).epsilon(1e-8));
            REQUIRE(s.weight * s.pdf == Catch::Approx(e.f_cos).epsilon(1e-8));
            ++((s.l.z > 0) == (v.z > 0) ? reflected : refracted);
        });
        CHECK(reflected > 1000);
        CHECK(refracted > 1000);
    };
    for (const double eta : {1.33, 2.4, 1 / 1.5}) {
        compare(rough_dielectric{ggx{alpha{0.3}}, smith_joint{}, eta});
        compare(rough_dielectric{ggx{alpha_xy{0.8, 0.1}}, smith_product{}, eta, lobe::importance_transport{}});
        compare(rough_dielectric{lobe::beckmann{alpha{0.5}}, smith_product{}, eta});
    }
}

TEST_CASE("the reflection of an interface is that of microfacet: from above evaluate's to the bit", "[glass]") {
    random_numbers random(3);
    const auto compare = [&](const auto& ndf, const auto& interface_mask, const auto& mask, float eta) {
        const rough_dielectric glass{ndf, interface_mask, eta};
        const lobe::microfacet from_above{ndf, mask, lobe::dielectric{eta}},
            from_below{ndf, mask, lobe::dielectric{1 / eta}};
        double below = 0;
        for (int i = 0; i < 20000; ++i) {
            const auto v = random.grazing_direction<float>(1e-3), l = random.grazing_direction<float>(1e-3);
            const auto a = glass.evaluate(v, l), b = from_above.evaluate(v, l);
            REQUIRE((a.f_cos == b.f_cos || std::abs(a.f_cos - b.f_cos) < 1e-37F));  // the latter of subnormal ones
            // `f` alone takes a denominator of other roundings
            const float f = from_above.f(v, l);
            REQUIRE(std::abs(glass.f(v, l) - f) <= 8 * eps<float> * f + 1e-37F);
            // from below, F near its critical angle rounds as its root does
            const vec3<float> vd{v.x, v.y, -v.z}, ld{l.x, l.y, -l.z};
            const float c = lobe::length(v + l) / 2, g2 = std::abs(1 / (eta * eta) - 1 + c * c);
            const auto d = glass.evaluate(vd, ld), e = from_below.evaluate(v, l);
            if (!(e.f_cos > 1e-30F)) continue;
            below = larger(below, static_cast<double>(std::abs(d.f_cos / e.f_cos - 1) * std::min(1.0F, g2) *
                                                      std::abs(1 - 1 / eta) / eps<float>));
            // the share of the samples that F takes
            REQUIRE((b.pdf < 1e-30F || std::abs(a.pdf / (b.pdf * lobe::dielectric{eta}(c)) - 1) < 8 * eps<float>));
        }
        CHECK(below < 12);
    };
    for (const float eta : {1.01F, 1.5F, 2.4F, 0.7F}) {
        compare(ggx{alpha{0.3F}}, smith_joint{}, lobe::smith_correlated{}, eta);
        compare(ggx{alpha_xy{0.02F, 0.2F}}, smith_product{}, lobe::smith_separable{}, eta);
        compare(beckmann{alpha{0.4F}}, smith_joint{}, lobe::smith_correlated{}, eta);
    }
}

TEST_CASE("radiance and importance are each other's transpose", "[glass]") {
    const auto worst = [](const auto& ndf, const auto& masking, auto eta) {
        const rough_dielectric radiance{ndf, masking, eta};
        const rough_dielectric importance{ndf, masking, eta, importance_transport{}};
        double most = 0;
        for_each_glass_pair(radiance, 4, 50000, [&](const auto& v, const auto& s) {
            const auto there = importance.f(v, s.l), back = radiance.f(s.l, v);
            if (there > 1e-30F) most = larger(most, static_cast<double>(std::abs(there / back - 1)));
        });
        return most;
    };
    // exchanging v and l negates h and changes its roundings, which D sees as epsilon/(|K| alpha), |K| >= |eta - 1|
    for (const double eta : {1.1, 1.5, 2.4, 0.6}) {
        const double K = std::abs(eta - 1) / std::max(eta, 1.0);
        CHECK(worst(ggx{alpha{0.3}}, smith_joint{}, eta) < 100 * eps<double> / (K * K * 0.3));
        CHECK(worst(ggx{alpha_xy{0.1, 0.6}}, smith_product{}, eta) < 100 * eps<double> / (K * K * 0.1));
        CHECK(worst(beckmann{alpha{0.5}}, smith_joint_exact{}, eta) < 1e4 * eps<double> / (K * K * 0.5));
    }
}

TEST_CASE("reflected and transmitted light against a table of another method", "[glass]") {
    constexpr int n = 4096;
    double worst = 0, squares = 0;
    int compared = 0, call = 0;
    for (const auto& row : reference_table("glass_single.csv")) {
        const double eta = row[0], a = row[1], mu = row[2];
        const auto shares = [&](const auto& masking, double R, double T) {
            const bool above = call % 2 == 0;  // from below, the same numbers with 1/eta
            const rough_dielectric glass{ggx{alpha{a}}, masking, above ? eta : 1 / eta, importance_transport{}};
            double sum[2] = {0, 0}, sum2[2] = {0, 0};
            random_numbers random(static_cast<std::uint64_t>(call + 10));
            for (int i = 0; i < n; ++i) {
                const double x = random(), y = random(), z = random();
                const auto s = glass.sample(view(mu, above), {x, y, z});
                const int to = (s.l.z > 0) == above ? 0 : 1;
                sum[to] += s.weight;
                sum2[to] += s.weight * s.weight;
            }
            for (int to = 0; to < 2; ++to) {
                const double mean = sum[to] / n, expected = to ? T : R;
                if (std::min(expected, 1 - expected) * n < 20) {  // too few of a kind to be normal
                    CHECK(std::abs(mean - expected) * n < 25);
                    continue;
                }
                const double error = std::sqrt((sum2[to] / n - mean * mean) / n);
                const double z = (mean - expected) / error;
                worst = larger(worst, std::abs(z));
                squares += z * z;
                ++compared;
            }
            ++call;
        };
        shares(smith_joint{}, row[3], row[5]);
        shares(smith_product{}, row[4], row[6]);
    }
    INFO(compared << " shares, the worst " << worst << " standard errors off, mean square " << squares / compared);
    CHECK(compared > 1200);
    CHECK(worst < 4.5);  // of 1500 normal ones: 1 in 100 times more
    CHECK(squares / compared < 1.15);
    CHECK(squares / compared > 0.7);
}

TEST_CASE("sampled directions are unit, obey Snell's law and cost what they must, at every angle", "[glass]") {
    random_numbers random(5);
    double length = 0, snell = 0, weight = 0, pdf = 0;
    for (int i = 0; i < 1000000; ++i) {
        // critical angles and grazing ones among them
        const float eta = static_cast<float>(i % 2 ? random.between(0.4, 2.5) : 1 + random.log_between(1e-6, 1));
        const float a = static_cast<float>(random.log_between(1e-4, 1));
        const double n = eta, critical = std::sqrt(std::abs(1 - std::min(n, 1 / n) * std::min(n, 1 / n)));
        const double mu =
            i % 3 ? random.log_between(1e-6, 1)
                  : std::min(1.0, critical * (1 + random.log_between(1e-7, 1e-1) * (random() < 0.5 ? 1 : -1)));
        const vec3<float> v = view<float>(mu, random() < 0.5),
                          u{float(random()) * (1 - 0x1p-24F), float(random()) * (1 - 0x1p-24F),
                            float(random()) * (1 - 0x1p-24F)};
        const rough_dielectric glass{ggx{alpha{a}}, smith_product{}, eta, importance_transport{}};
        const auto s = glass.sample(v, u);
        REQUIRE(std::isfinite(s.weight + s.pdf + s.l.x + s.l.y + s.l.z));
        REQUIRE((s.pdf >= 0 && s.weight >= 0));
        if (!(s.pdf > 0)) continue;
        weight = larger(weight, static_cast<double>(s.weight));
        const double l2 = double(s.l.x) * s.l.x + double(s.l.y) * s.l.y + double(s.l.z) * s.l.z;
        length = larger(length, std::abs(std::sqrt(l2) - 1));
        if ((s.l.z > 0) == (v.z > 0)) continue;
        // Snell: the half vector carries all of v + n l, so v x m = -n l x m, m the sampled facet
        const double up = v.z < 0 ? -1 : 1, N = v.z < 0 ? 1 / n : n;
        const auto m = glass.normals().sample_visible({v.x, v.y, std::abs(v.z)}, {u.x, u.y});
        const vec3<double> V{v.x, v.y, up * v.z}, L{s.l.x, s.l.y, up * s.l.z}, M{m.x, m.y, m.z};
        const vec3<double> across = lobe::cross(V, M) + N * lobe::cross(L, M);
        snell = larger(snell, lobe::length(across) / std::max(1.0, N));
        const double c = lobe::dot(V, M), g = -N * lobe::dot(L, M);
        // n^2 - 1 + c^2 = g^2
        pdf = larger(pdf, std::abs(N * N - 1 + c * c - g * g) / std::max(1.0, N * N));
    }
    INFO("length " << length << ", Snell " << snell << ", weight - 1 " << weight - 1 << ", g " << pdf);
    CHECK(length < 16 * eps<float>);
    CHECK(snell < 8 * eps<float>);
    CHECK(pdf < 16 * eps<float>);
    CHECK(weight <= 1 + 4 * eps<float>);
}

TEST_CASE("an index of 1 is not there, a smooth interface is Snell's", "[glass]") {
    random_numbers random(6);
    const rough_dielectric matched{ggx{alpha{0.5F}}, smith_product{}, 1.0F},
        nearly{ggx{alpha{0.5F}}, smith_product{}, 1.00001F};
    for (int i = 0; i < 2000; ++i) {
        auto v = random.grazing_direction<float>(1e-3);
        if (i % 2) v.z = -v.z;
        const vec3<float> u{float(random()), float(random()) * 0.999F, float(random()) * 0.999F};
        const auto s = matched.sample(v, u);
        REQUIRE(s.pdf > 1e30F);  // a delta function
        CHECK(std::abs(lobe::dot(s.l, v) + 1) < 4 * eps<float>);
        CHECK(s.weight ==
              Catch::Approx(lobe::smith_product{}.G1(matched.normals(), {v.x, v.y, std::abs(v.z)})).epsilon(1e-5));
        const auto e = matched.evaluate(v, s.l);
        CHECK(e.f_cos == 0);
        CHECK(e.pdf == 0);
        CHECK(matched.f(v, -v) == 0);
        const auto t = nearly.sample(v, u);  // 1e-5 off, over the cosine of the facet
        CHECK(lobe::dot(t.l, v) < -0.9F);
    }
    for (const double mu : {1.0, 0.7, 0.3, 0.05})
        for (const bool above : {true, false}) {
            const vec3<double> v = view(mu, above);
            const double eta = 1.5, n = above ? eta : 1 / eta;
            const rough_dielectric glass{ggx{alpha{1e-4}}, smith_joint{}, eta};
            int refracted = 0;
            for (int i = 0; i < 1000; ++i) {
                const auto s = glass.sample(v, {random(), random(), random()});
                if (!(s.pdf > 0) || (s.l.z > 0) == above || random() > 1) continue;
                ++refracted;
                // a facet tilted by its few widths turns l by as much
                CHECK(std::abs(s.l.x + v.x / n) < 0.05);
                CHECK(s.weight * n * n > 0.99);
            }
            CHECK((refracted > 0) == (n * n - 1 + mu * mu > 0));
        }
}

TEST_CASE("no NaN, whatever the two directions", "[glass]") {
    const auto test = []<class T>(const T& smallest, const auto& ndf, const auto& masking) {
        random_numbers random(7);
        const auto component = [&] {
            const double size =
                random() < 0.3 ? (random() < 0.5 ? 0.0 : 1.0) : random.log_between(static_cast<double>(smallest), 1);
            return static_cast<T>(random() < 0.5 ? size : -size);
        };
        const auto unit = [&] {
            for (;;) {
                const vec3<T> w{component(), component(), component()};
                const T s = std::sqrt(w.x * w.x + w.y * w.y + w.z * w.z);
                if (s > T(0.5)) return vec3<T>{w.x / s, w.y / s, w.z / s};
            }
        };
        for (int i = 0; i < 100000; ++i) {
            const T eta =
                i % 5 == 0 ? T(1) : static_cast<T>(i % 5 == 1 ? 1 + (random() - 0.5) * 1e-6 : random.between(0.3, 3));
            const rough_dielectric glass{ndf, masking, eta};
            const vec3<T> v = unit(), l = i % 7 == 0   ? -v
                                          : i % 7 == 1 ? v
                                          : i % 7 == 2 ? vec3<T>{-v.x, -v.y, v.z}
                                                       : unit();
            const auto e = glass.evaluate(v, l);
            const T f = glass.f(v, l), p = glass.pdf(v, l);
            REQUIRE((e.f_cos >= 0 && e.pdf >= 0 && f >= 0 && p >= 0));
            REQUIRE(f <= std::numeric_limits<T>::max());
            const T end = 1 - eps<T> / 2;
            const auto corner = [&] {
                return random() < 0.2 ? T(0) : random() < 0.2 ? end : std::min(end, static_cast<T>(random()));
            };
            const auto s = glass.sample(v, {corner(), corner(), corner()});
            REQUIRE((s.weight >= 0 && s.weight <= 12 && s.pdf >= 0 && s.pdf <= std::numeric_limits<T>::max()));
            REQUIRE(std::abs(lobe::dot(s.l, s.l) - 1) < 64 * eps<T>);
        }
    };
    test(1e-30F, ggx{alpha{0.3F}}, smith_joint{});
    test(1e-30F, ggx{alpha{1e-4F}}, smith_joint{});
    test(1e-30F, ggx{alpha_xy{1e-4F, 1.0F}}, smith_product{});
    test(1e-30F, beckmann{alpha{0.3F}}, smith_joint{});
    test(1e-300, ggx{alpha{1e-4}}, smith_joint_exact{});
}

namespace {

template <class Pack>
void compare_packs() {
    using T = typename Pack::value_type;
    random_numbers random(8);
    const auto load = [](const std::vector<T>& lanes) { return Pack::load_unaligned(lanes.data()); };
    const rough_dielectric one{ggx{alpha{T(0.3)}}, smith_joint{}, T(1.5)};
    const rough_dielectric wide{ggx{alpha{Pack(T(0.3))}}, smith_joint{}, Pack(T(1.5))};
    for (int trial = 0; trial < 500; ++trial) {
        std::vector<T> in[9];
        for (std::size_t lane = 0; lane < Pack::size; ++lane) {
            const auto v = random.direction<T>(), l = random.direction<T>();
            const T values[9] = {v.x, v.y, v.z, l.x, l.y, l.z, T(random()), T(random()), T(random())};
            for (int k = 0; k < 9; ++k) in[k].push_back(values[k]);
        }
        const vec3<Pack> v{load(in[0]), load(in[1]), load(in[2])}, l{load(in[3]), load(in[4]), load(in[5])},
            u{load(in[6]), load(in[7]), load(in[8])};
        const auto e = wide.evaluate(v, l);
        const auto s = wide.sample(v, u);
        const auto f = wide.f(v, l), pdf = wide.pdf(v, l);
        for (std::size_t i = 0; i < Pack::size; ++i) {
            const vec3<T> vi{in[0][i], in[1][i], in[2][i]}, li{in[3][i], in[4][i], in[5][i]},
                ui{in[6][i], in[7][i], in[8][i]};
            const auto ei = one.evaluate(vi, li);
            const auto si = one.sample(vi, ui);
            const auto near = [](T a, T b, T scale) { return std::abs(a - b) <= 64 * eps<T> * scale; };
            CHECK(near(e.f_cos.get(i), ei.f_cos, ei.f_cos));
            CHECK(near(e.pdf.get(i), ei.pdf, ei.pdf));
            CHECK(near(f.get(i), one.f(vi, li), one.f(vi, li)));
            CHECK(near(pdf.get(i), one.pdf(vi, li), one.pdf(vi, li)));
            CHECK(near(s.l.z.get(i), si.l.z, 1));
            CHECK(near(s.weight.get(i), si.weight, 1));
            CHECK(near(s.pdf.get(i), si.pdf, si.pdf * 16));
        }
    }
}

}  // namespace

TEST_CASE("glass on packs gives what its lanes give", "[glass]") {
    compare_packs<xsimd::batch<float>>();
    compare_packs<xsimd::batch<double>>();
}
