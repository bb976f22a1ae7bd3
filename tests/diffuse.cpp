#include "catch.hpp"
#include "support.hpp"

#include <lobe/brdf/burley.hpp>
#include <lobe/brdf/eon.hpp>
#include <lobe/brdf/lambert.hpp>
#include <lobe/brdf/oren_nayar.hpp>
#include <lobe/energy/albedo.hpp>
#include <lobe/sampling/points.hpp>

#include <xsimd/xsimd.hpp>

using lobe::vec2;
using lobe::vec3;

namespace {

using real = long double;
constexpr real pi = 3.141592653589793238462643383279502884L;
constexpr double epsilon = std::numeric_limits<double>::epsilon();

// The equations as papers print them, by angles and cosines, in long double: independent transcriptions.

struct angles {
    real mu_v, mu_l, theta_v, theta_l, cos_phi;
    angles(const vec3<double>& v, const vec3<double>& l) {
        const real sv = std::hypot(real(v.x), real(v.y)), sl = std::hypot(real(l.x), real(l.y));
        theta_v = std::atan2(sv, real(v.z));
        theta_l = std::atan2(sl, real(l.z));
        mu_v = std::cos(theta_v);
        mu_l = std::cos(theta_l);
        cos_phi = std::cos(std::atan2(real(v.y), real(v.x)) - std::atan2(real(l.y), real(l.x)));
    }
    real v_l() const { return mu_v * mu_l + std::sin(theta_v) * std::sin(theta_l) * cos_phi; }
};

real printed_oren_nayar(real rho, real sigma, const angles& g) {
    const real s2 = sigma * sigma, A = 1 - 0.5L * s2 / (s2 + 0.33L), B = 0.45L * s2 / (s2 + 0.09L);
    const real larger = std::max(g.theta_v, g.theta_l), smaller = std::min(g.theta_v, g.theta_l);
    return rho / pi * (A + B * std::max(real(0), g.cos_phi) * std::sin(larger) * std::tan(smaller));
}

const real c1 = 0.5L - 2 / (3 * pi), c2 = 2 / 3.0L - 28 / (15 * pi);

real printed_fon(real rho, real r, const angles& g) {
    const real A = 1 / (1 + c1 * r), s = g.v_l() - g.mu_v * g.mu_l;
    return rho / pi * A * (1 + r * (s > 0 ? s / std::max(g.mu_v, g.mu_l) : s));
}

real printed_E_F(real r, real mu) {
    const real S = std::sqrt((1 - mu) * (1 + mu));
    const real G = S * (std::acos(mu) - S * mu) + 2 / 3.0L * (S / mu * (1 - S * S * S) - S);
    return (1 + r * G / pi) / (1 + c1 * r);
}

real printed_E_F_fit(real r, real mu) {
    const real m = 1 - mu;
    const real G = m * (0.0571085289L + m * (0.491881867L + m * (-0.332181442L + m * 0.0714429953L)));
    return (1 + r * G) / (1 + c1 * r);
}

real printed_eon(real rho, real r, const angles& g, bool fit) {
    const real E_v = fit ? printed_E_F_fit(r, g.mu_v) : printed_E_F(r, g.mu_v),
               E_l = fit ? printed_E_F_fit(r, g.mu_l) : printed_E_F(r, g.mu_l);
    const real E_avg = (1 + c2 * r) / (1 + c1 * r), rho_ms = rho * rho * E_avg / (1 - rho * (1 - E_avg));
    return printed_fon(rho, r, g) + rho_ms / pi * std::max(real(0), 1 - E_v) * std::max(real(0), 1 - E_l) / (1 - E_avg);
}

real printed_burley(real rho, real r, const angles& g, bool frostbite) {
    const real LdotH2 = (1 + g.v_l()) / 2;
    const real F90 = (frostbite ? 0.5L * r : 0.5L) + 2 * r * LdotH2, factor = frostbite ? 1 + r * (1 / 1.51L - 1) : 1;
    return rho / pi * (1 + (F90 - 1) * std::pow(1 - g.mu_l, real(5))) *
           (1 + (F90 - 1) * std::pow(1 - g.mu_v, real(5))) * factor;
}

vec3<double> at_cosine(double mu) { return {std::sqrt((1 - mu) * (1 + mu)), 0, mu}; }

/// The directional albedo by a rule of its own: Gauss-Legendre in theta and phi, split where the models have edges, at
/// theta_l = theta_v and at a quarter turn, so that each piece is smooth and 24 nodes a side reach 1e-13.
template <class B>
double albedo(const B& b, double mu) {
    static const lobe::gauss_legendre<double> rule(24);
    const vec3<double> v = at_cosine(mu);
    const double half_pi = static_cast<double>(pi / 2), theta_v = std::atan2(v.x, v.z);
    double total = 0;
    for (const auto& [from, to] : {std::pair{0.0, theta_v}, std::pair{theta_v, half_pi}})
        for (std::size_t i = 0; i < rule.x.size(); ++i)
            for (int quarter = 0; quarter < 2; ++quarter)
                for (std::size_t j = 0; j < rule.x.size(); ++j) {
                    const double theta = from + (to - from) * rule.x[i], phi = half_pi * (quarter + rule.x[j]);
                    const vec3<double> l{std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi),
                                         std::cos(theta)};
                    total += 2 * rule.w[i] * rule.w[j] * (to - from) * half_pi * std::sin(theta) * b.f_cos(v, l);
                }
    return total;
}

template <class B, class W>
concept takes = requires(const B& b, const W& w) {
    b.f(w, w);
};

struct range {
    double low = 1e9, high = -1e9;
    void add(double x) { low = std::min(low, x), high = larger(high, x); }
};

/// Every model at one albedo and roughness.
template <class S, class T, class G>
void for_each_model(const S& rho, const T& r, const G& g) {
    g(lobe::lambert{rho});
    g(lobe::oren_nayar{rho, r});
    g(lobe::fon{rho, r});
    g(lobe::eon{rho, r});
    g(lobe::eon{rho, r, lobe::fon_loss_fit{}});
    g(lobe::burley{rho, r});
    g(lobe::burley_frostbite{rho, r});
    g(lobe::oren_nayar{rho, r, lobe::cosine_sampling{}});
    g(lobe::fon{rho, r, lobe::cosine_sampling{}});
    g(lobe::eon{rho, r, lobe::fon_loss{}, lobe::cosine_sampling{}});
}

}  // namespace

TEST_CASE("each diffuse f is the printed equation", "[diffuse]") {
    // v and l are given to 1e-16, which reaches s = v.x l.x + v.y l.y, and through it f, times r/max(mu); where terms
    // cancel, errors are absolute. So errors are counted in units of rho/pi (0.3 + r/max(mu)), or of f where that is
    // more.
    random_numbers random(1);
    double worst[6] = {};
    for (int i = 0; i < 100000; ++i) {
        const double rho = random.between(0.01, 1), r = i % 8 ? random() : i % 16 / 8;
        const vec3<double> v = random.grazing_direction(1e-3), l = random.grazing_direction(1e-3);
        const angles g(v, l);
        const auto compare = [&](double& error, const auto& brdf, real printed) {
            const real scale = std::max(printed, real(rho) / pi * (0.3L + real(r) / std::max(g.mu_v, g.mu_l)));
            error = larger(error, static_cast<double>(std::abs(real(brdf.f(v, l)) - printed) / scale));
            error = larger(error, static_cast<double>(std::abs(real(brdf.f_cos(v, l)) - printed * real(l.z)) /
                                                      (scale * real(l.z))));
        };
        compare(worst[0], lobe::oren_nayar{rho, 1.5 * r}, printed_oren_nayar(rho, 1.5L * real(r), g));
        compare(worst[1], lobe::fon{rho, r}, printed_fon(rho, r, g));
        compare(worst[4], lobe::burley{rho, r}, printed_burley(rho, r, g, false));
        compare(worst[5], lobe::burley_frostbite{rho, r}, printed_burley(rho, r, g, true));
        if (r == 0) continue;  // 0/0 as printed
        // 1 - E_avg as printed loses 1/(0.2 r) of its digits even in long double
        const double lost = 1 + 0x1p-11 / r;
        double exact = 0, fit = 0;
        compare(exact, lobe::eon{rho, r}, printed_eon(rho, r, g, false));
        compare(fit, lobe::eon{rho, r, lobe::fon_loss_fit{}}, printed_eon(rho, r, g, true));
        worst[2] = larger(worst[2], exact / lost);
        worst[3] = larger(worst[3], fit / lost);
    }
    INFO(worst[0] << ' ' << worst[1] << ' ' << worst[2] << ' ' << worst[3] << ' ' << worst[4] << ' ' << worst[5]);
    for (double error : worst) CHECK(error < 16 * epsilon);
}

TEST_CASE("no roughness is Lambert", "[diffuse]") {
    random_numbers random(2);
    const lobe::lambert smooth{0.7};
    double worst = 0;
    for (int i = 0; i < 1000; ++i) {
        const vec3<double> v = random.grazing_direction(1e-6), l = random.grazing_direction(1e-6);
        for (double f : {lobe::oren_nayar{0.7, 0.0}.f(v, l), lobe::fon{0.7, 0.0}.f(v, l), lobe::eon{0.7, 0.0}.f(v, l)})
            worst = larger(worst, std::abs(f - smooth.f(v, l)));
    }
    CHECK(worst == 0);
}

TEST_CASE("diffuse models are reciprocal", "[diffuse]") {
    random_numbers random(3);
    for (double r : {0.0, 0.3, 1.0})
        for_each_model(0.8, r, [&](const auto& brdf) {
            double worst = 0;
            for (int i = 0; i < 20000; ++i) {
                const vec3<double> v = random.grazing_direction(1e-6), l = random.grazing_direction(1e-6);
                const double there = brdf.f(v, l), back = brdf.f(l, v);
                // rounding of sums, in units of rho/pi
                worst = larger(worst, std::abs(there - back) / (there + 0.8 / 3.14));
            }
            CHECK(worst < 4 * epsilon);
        });
}

TEST_CASE("albedo ranges at rho = 1", "[diffuse]") {
    // Independently computed numbers, which are those of a grid that starts at mu = 0.02 and, for Oren-Nayar, has sigma
    // from 0.3 to 1.5; "0.563..." is cut off, the others are rounded.
    range oren_nayar, burley, frostbite;
    for (double mu : {0.02, 0.05, 0.1, 0.2, 0.3, 0.5, 0.7, 0.85, 1.0}) {
        for (double sigma : {0.3, 0.6, 0.9, 1.2, 1.5}) oren_nayar.add(albedo(lobe::oren_nayar{1.0, sigma}, mu));
        for (double r : {0.0, 0.1, 0.25, 0.5, 0.75, 1.0}) {
            burley.add(albedo(lobe::burley{1.0, r}, mu));
            frostbite.add(albedo(lobe::burley_frostbite{1.0, r}, mu));
        }
    }
    INFO(oren_nayar.low << " " << oren_nayar.high << "  " << burley.low << " " << burley.high << "  " << frostbite.low
                        << " " << frostbite.high);
    CHECK(std::abs(oren_nayar.low - 0.5635) < 0.0005);
    CHECK(std::abs(oren_nayar.high - 1.004) < 0.0005);
    CHECK(std::abs(burley.low - 0.535) < 0.0005);
    CHECK(std::abs(burley.high - 1.52) < 0.005);
    CHECK(std::abs(frostbite.low - 0.09) < 0.005);
    CHECK(std::abs(frostbite.high - 1.006) < 0.0005);

    // The ranges that the comments state, over everything.
    for (double mu : {1e-6, 1e-3, 0.01, 0.02, 0.1, 0.3, 1.0}) {
        for (int i = 0; i <= 32; ++i) {
            oren_nayar.add(albedo(lobe::oren_nayar{1.0, static_cast<double>(pi / 2) * i / 32}, mu));
            burley.add(albedo(lobe::burley{1.0, i / 32.0}, mu));
            frostbite.add(albedo(lobe::burley_frostbite{1.0, i / 32.0}, mu));
        }
    }
    CHECK(std::abs(oren_nayar.low - 0.559) < 0.0005);
    CHECK(std::abs(oren_nayar.high - 1.015) < 0.0005);
    CHECK(burley.low == Catch::Approx(0.5 * (1 - 0.5 / 21)).epsilon(1e-5));  // r = 0 at grazing, in closed form
    CHECK(std::abs(burley.high - 1.56) < 0.005);
    CHECK(frostbite.low < 1e-5);
    CHECK((frostbite.high > 1.03 && frostbite.high < 1.032));
    // Oren-Nayar from above: s = 0, so E = A; Burley from above, r = 0: 1 - 1/2 * 2 int (1 - mu)^5 mu dmu
    CHECK(albedo(lobe::oren_nayar{1.0, 0.5}, 1.0) == Catch::Approx(1 - 0.125 / 0.58).epsilon(1e-12));
    CHECK(albedo(lobe::burley{1.0, 0.0}, 1.0) == Catch::Approx(1 - 0.5 / 21).epsilon(1e-12));
}

TEST_CASE("FON's albedo is its closed form, and its average", "[diffuse]") {
    for (double r : {0.1, 0.5, 1.0}) {
        const lobe::fon brdf{0.6, r};
        for (double mu : {0.001, 0.01, 0.1, 0.5, 0.9, 1.0}) {
            INFO("r " << r << " mu " << mu);
            const double closed = brdf.albedo(at_cosine(mu));
            CHECK(std::abs(albedo(brdf, mu) - closed) < 1e-12);
            CHECK(std::abs(static_cast<double>(0.6L * printed_E_F(r, mu)) - closed) < 4 * epsilon);
            CHECK(std::abs(static_cast<double>(0.6L * printed_E_F_fit(r, mu)) -
                           brdf.albedo(at_cosine(mu), lobe::fon_loss_fit{})) <
                  (mu < 0.01 ? 3e-4 * r : 4 * epsilon));  // below, E of the fit exceeds 1 and is held there
            // lobe's own rule has no edge at s = 0: Gauss-Legendre of order n errs by 1/n^2 there
            CHECK(std::abs(lobe::directional_albedo(brdf, mu, {.order = 128}).value - closed) < 1.0 / (128 * 128));
        }
        CHECK(brdf.albedo(vec3<double>{1, 0, 0}) == Catch::Approx(0.6).epsilon(1e-15));
        const auto average = lobe::average_albedo(brdf, {.order = 32});
        const real printed = 0.6L * (1 + c2 * real(r)) / (1 + c1 * real(r));
        CHECK(std::abs(average.value - static_cast<double>(printed)) < 1.0 / (32 * 32));
        // 2 int E mu dmu by Gauss-Legendre in mu = t^3
        const lobe::gauss_legendre<double> rule(64);
        double integral = 0;
        for (std::size_t i = 0; i < rule.x.size(); ++i) {
            const double t = rule.x[i], mu = t * t * t;
            integral += 6 * rule.w[i] * t * t * mu * brdf.albedo(at_cosine(mu));
        }
        CHECK(std::abs(integral - static_cast<double>(printed)) < 1e-7);  // E has a square root's edge at mu = 1
    }
}

TEST_CASE("the fit of FON's albedo is within 4.7e-4", "[diffuse]") {
    double loss = 0, E = 0;
    const lobe::fon brdf{1.0, 1.0};
    for (int i = 1; i <= 10000; ++i) {
        const vec3<double> w = at_cosine(i / 10000.0);
        loss = larger(loss, std::abs(lobe::fon_loss_fit{}(w)-lobe::fon_loss{}(w)));
        E = larger(E, std::abs(brdf.albedo(w, lobe::fon_loss_fit{}) - brdf.albedo(w)));
    }
    INFO(loss << ' ' << E);
    CHECK(loss < 6.1e-4);
    CHECK(E < 4.7e-4);
    CHECK(E > 4.6e-4);
}

TEST_CASE("what FON loses, at both ends", "[diffuse]") {
    CHECK(lobe::fon_loss{}(vec3<float>{1, 0, 1e-30f}) == Catch::Approx(1e-30f / 3.14159265f));
    CHECK(lobe::fon_loss{}(vec3<float>{1, 0, 0}) == 0);
    CHECK(lobe::fon_loss{}(vec3<double>{0, 0, 1}) == Catch::Approx(static_cast<double>(c1)).epsilon(1e-15));
    CHECK(lobe::fon_loss_fit{}(vec3<double>{0, 0, 1}) == Catch::Approx(static_cast<double>(c1)).epsilon(1e-15));
    CHECK(lobe::fon_loss_fit{}(vec3<float>{1, 0, 0}) == 0);
}

TEST_CASE("EON reflects all light where rho is 1", "[diffuse]") {
    for (double r : {0.0, 0.1, 0.5, 1.0})
        for (double mu : {0.001, 0.01, 0.1, 0.3, 0.5, 0.7, 0.9, 1.0}) {
            INFO("r " << r << " mu " << mu);
            CHECK(std::abs(albedo(lobe::eon{1.0, r}, mu) - 1) < 1e-12);
            CHECK(std::abs(albedo(lobe::eon{1.0, r, lobe::fon_loss_fit{}}, mu) - 1) < 4e-4);
            CHECK(albedo(lobe::eon{0.5, r}, mu) <= 0.5 + 1e-12);
            CHECK(std::abs(lobe::directional_albedo(lobe::eon{1.0, r}, mu, {.order = 128}).value - 1) <
                  1.0 / (128 * 128));
            if (r == 0) CHECK(albedo(lobe::eon{0.5, r}, mu) == Catch::Approx(0.5).epsilon(1e-12));
        }
    CHECK(std::abs(lobe::average_albedo(lobe::eon{1.0, 1.0}, {.order = 32}).value - 1) < 1.0 / (32 * 32));
}

TEST_CASE("no diffuse model is negative, and none is seen from below", "[diffuse]") {
    random_numbers random(5);
    for (float r : {0.0f, 0.5f, 1.0f})
        for_each_model(1.0f, r, [&](const auto& brdf) {
            float lowest = 0, below = 0;
            const auto look = [&](const vec3<float>& v, const vec3<float>& l) {
                const float f = brdf.f(v, l), f_cos = brdf.f_cos(v, l), pdf = brdf.pdf(v, l);
                lowest = f >= 0 && f_cos >= 0 && pdf >= 0 ? lowest : -1;  // a NaN counts
                if (v.z <= 0 || l.z <= 0)
                    below = larger({below, f, f_cos, pdf, brdf.sample(v, {0.3f, 0.7f}).pdf * float(v.z <= 0)});
            };
            for (int i = 0; i < 20000; ++i) {
                look(random.grazing_direction<float>(1e-6), random.grazing_direction<float>(1e-6));
                look(random.direction<float>(), random.direction<float>());
            }
            const vec3<float> edges[] = {{0, 0, 1},       {0, 0, -1},       {1, 0, 0},      {-1, 0, 0},
                                         {0.6f, 0, 0.8f}, {0.6f, 0, -0.8f}, {1, 0, 1e-20f}, {-1, 0, 1e-20f}};
            for (const auto& v : edges)
                for (const auto& l : edges) look(v, l);
            // FON, antiparallel at grazing with r = 1: 1 + r s is 0, and the two roundings of it are 6e-8 each
            CHECK(lowest >= 0);
            CHECK(below == 0);
        });
}

TEST_CASE("diffuse sampling: weight * pdf = f_cos, E[weight] = albedo", "[diffuse]") {
    for (double mu : {0.02, 0.4, 1.0})
        for_each_model(0.8, 0.6, [&](const auto& brdf) {
            const vec3<double> v = {0.6 * std::sqrt((1 - mu) * (1 + mu)), 0.8 * std::sqrt((1 - mu) * (1 + mu)), mu};
            double mean = 0, worst = 0;
            constexpr std::uint32_t count = 1u << 16;
            for (std::uint32_t i = 0; i < count; ++i) {
                const auto s = brdf.sample(v, lobe::hammersley<double>(i, count));
                const auto e = brdf.evaluate(v, s.l);
                mean += s.weight / count;
                worst = larger({worst, std::abs(s.weight * s.pdf / brdf.f_cos(v, s.l) - 1),
                                std::abs(s.pdf / brdf.pdf(v, s.l) - 1), std::abs(e.f_cos / brdf.f_cos(v, s.l) - 1),
                                std::abs(e.pdf / s.pdf - 1)});
            }
            INFO("mu " << mu << " mean " << mean << " albedo " << albedo(brdf, mu));
            CHECK(worst < 4 * epsilon);
            // Hammersley in two dimensions: (log2 n)/n = 2.4e-4 for a variation of 1, and the weight varies by about
            // that, but for the peak of s/max(mu) at grazing where that is sampled by the cosine
            CHECK(std::abs(mean - albedo(brdf, mu)) < 5e-4);
        });
    const auto below = lobe::eon{0.5f, 0.5f}.sample({0.6f, 0, -0.8f}, {0.3f, 0.3f});
    CHECK(below.pdf == 0);
    CHECK(below.weight == 0);
    CHECK(below.l == vec3<float>{0, 0, 1});
}

TEST_CASE("a colour is its channels; concepts hold", "[diffuse]") {
    const vec3<double> rho{0.9, 0.5, 0.1}, v = lobe::normalize(vec3<double>{0.3, 0.2, 0.4}),
                                           l = lobe::normalize(vec3<double>{-0.1, 0.9, 0.4});
    std::vector<vec3<double>> colours;
    for_each_model(rho, 0.7, [&](const auto& brdf) {
        static_assert(lobe::samplable_brdf<std::remove_cvref_t<decltype(brdf)>>);
        static_assert(std::remove_cvref_t<decltype(brdf)>::isotropic);
        CHECK(brdf.width() == vec2<double>{1, 1});
        colours.push_back(brdf.f_cos(v, l));
    });
    for (int channel = 0; channel < 3; ++channel) {
        std::size_t i = 0;
        for_each_model(rho[channel], 0.7, [&](const auto& brdf) { CHECK(brdf.f_cos(v, l) == colours[i++][channel]); });
    }
    static_assert(sizeof(lobe::lambert<float>) == 4);
    static_assert(sizeof(lobe::fon<float>) == 12);
    static_assert(sizeof(lobe::eon<float>) == 16);
    static_assert(sizeof(lobe::oren_nayar<float>) == 12);
    static_assert(sizeof(lobe::eon<float, lobe::fon_loss, lobe::cosine_sampling>) == 16);  // a sampler takes no room
    // vectors of another precision find a deleted function
    static_assert(takes<lobe::eon<float>, vec3<float>> && !takes<lobe::eon<float>, vec3<double>>);
    static_assert(takes<lobe::lambert<float>, vec3<float>> && !takes<lobe::lambert<float>, vec3<double>>);
}

namespace {

/// A spectrum of the user's own names its number.
struct bands {
    using value_type = double;
    double value[4];
    explicit bands(double x) : value{x, x, x, x} {}
    template <class Op>
    static bands each(bands a, const bands& b, Op op) {
        for (int i = 0; i < 4; ++i) a.value[i] = op(a.value[i], b.value[i]);
        return a;
    }
    friend bands operator+(const bands& a, const bands& b) {
        return each(a, b, [](double x, double y) { return x + y; });
    }
    friend bands operator-(const bands& a, const bands& b) {
        return each(a, b, [](double x, double y) { return x - y; });
    }
    friend bands operator*(const bands& a, const bands& b) {
        return each(a, b, [](double x, double y) { return x * y; });
    }
    friend bands operator/(const bands& a, const bands& b) {
        return each(a, b, [](double x, double y) { return x / y; });
    }
    friend bands operator*(const bands& a, double x) { return a * bands(x); }
};

}  // namespace

TEST_CASE("a spectrum of the user's own", "[diffuse]") {
    bands rho(0.2);
    rho.value[2] = 0.9;
    const vec3<double> v{0.6, 0, 0.8}, l{0, 0.8, 0.6};
    std::vector<bands> all;
    for_each_model(rho, 0.7, [&](const auto& brdf) { all.push_back(brdf.f_cos(v, l)); });
    std::size_t i = 0;
    for_each_model(0.9, 0.7, [&](const auto& brdf) {
        CHECK(brdf.f_cos(v, l) == Catch::Approx(all[i++].value[2]).epsilon(4 * epsilon));
    });
}

TEST_CASE("packs of floats give what their lanes give", "[diffuse]") {
    using pack = xsimd::batch<float>;
    random_numbers random(6);
    for (int trial = 0; trial < 100; ++trial) {
        std::vector<float> in[8];
        for (std::size_t lane = 0; lane < pack::size; ++lane) {
            const auto v = random.grazing_direction<float>(1e-3), l = random.direction<float>();
            const float values[8] = {
                v.x, v.y, v.z, l.x, l.y, l.z, static_cast<float>(random()), static_cast<float>(random())};
            for (int k = 0; k < 8; ++k) in[k].push_back(values[k]);
        }
        pack p[8];
        for (int k = 0; k < 8; ++k) p[k] = pack::load_unaligned(in[k].data());
        std::vector<pack> f_cos, weight;
        for_each_model(vec3<pack>(pack(0.8f), pack(0.5f), pack(0.2f)), pack(0.6f), [&](const auto& brdf) {
            f_cos.push_back(brdf.evaluate({p[0], p[1], p[2]}, {p[3], p[4], p[5]}).f_cos.y);
            weight.push_back(brdf.sample({p[0], p[1], p[2]}, {p[6], p[7]}).weight.x);
        });
        for (std::size_t lane = 0; lane < pack::size; ++lane) {
            const vec3<float> v{in[0][lane], in[1][lane], in[2][lane]}, l{in[3][lane], in[4][lane], in[5][lane]};
            std::size_t i = 0;
            for_each_model(vec3<float>(0.8f, 0.5f, 0.2f), 0.6f, [&](const auto& brdf) {
                const float one = brdf.f_cos(v, l).y, w = brdf.sample(v, {in[6][lane], in[7][lane]}).weight.x;
                CHECK(std::abs(f_cos[i].get(lane) - one) <= 2e-6f * (one + 0.1f * std::max(l.z, 0.0f)));
                CHECK(std::abs(weight[i].get(lane) - w) <= 2e-6f * (w + 1));
                ++i;
            });
        }
    }
}

TEST_CASE("bad parameters end in an assert", "[diffuse]") {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    CHECK_FALSE(aborts([] { for_each_model(1.0f, 1.0f, [](const auto&) {}); }));
    for (const float bad : {-0.1f, 1.1f, nan}) {
        CHECK(aborts([&] { (void)lobe::lambert(bad); }));
        CHECK(aborts([&] { (void)lobe::oren_nayar(bad, 0.5f); }));
        CHECK(aborts([&] { (void)lobe::oren_nayar(0.5f, bad > 1 ? 2.0f : bad); }));
        CHECK(aborts([&] { (void)lobe::fon(bad, 0.5f); }));
        CHECK(aborts([&] { (void)lobe::fon(0.5f, bad); }));
        CHECK(aborts([&] { (void)lobe::eon(bad, 0.5f); }));
        CHECK(aborts([&] { (void)lobe::eon(0.5f, bad); }));
        CHECK(aborts([&] { (void)lobe::burley(bad, 0.5f); }));
        CHECK(aborts([&] { (void)lobe::burley(0.5f, bad); }));
        CHECK(aborts([&] { (void)lobe::burley_frostbite(bad, 0.5f); }));
        CHECK(aborts([&] { (void)lobe::burley_frostbite(0.5f, bad); }));
    }
}
