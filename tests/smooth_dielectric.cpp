// Smooth interfaces, panes and tints: against Fresnel's and Snell's laws, the series summed, and the rough interface.
#include "catch.hpp"
#include "support.hpp"

#include <lobe/bsdf/rough_dielectric.hpp>
#include <lobe/bsdf/smooth_dielectric.hpp>
#include <lobe/bsdf/thin_dielectric.hpp>
#include <lobe/bsdf/tinted.hpp>
#include <lobe/fresnel/conductor.hpp>
#include <lobe/fresnel/dielectric.hpp>
#include <lobe/fresnel/schlick.hpp>
#include <lobe/ndf/ggx.hpp>

#include <xsimd/xsimd.hpp>

using lobe::alpha;
using lobe::ggx;
using lobe::vec3;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

vec3<double> view(double mu, bool above = true) {
    return {0.6 * std::sqrt((1 - mu) * (1 + mu)), -0.8 * std::sqrt((1 - mu) * (1 + mu)), above ? mu : -mu};
}

}  // namespace

TEST_CASE("a smooth interface: Snell, Fresnel, both transports", "[glass]") {
    random_numbers random(1);
    for (int i = 0; i < 20000; ++i) {
        const double eta = random.between(0.3, 3), mu = random.log_between(1e-4, 1);
        const bool above = i % 2 == 0;
        const double n = above ? eta : 1 / eta, F = lobe::dielectric{n}(mu);
        const vec3<double> v = view(mu, above);
        const lobe::smooth_dielectric radiance{eta};
        const lobe::smooth_dielectric importance{eta, lobe::importance_transport{}};
        const auto r = radiance.reflection(v), t = radiance.refraction(v), ti = importance.refraction(v);
        // near the critical angle F is a root: 1e-16 of n are 1e-8 of F
        const double g2 = std::abs(n * n - 1 + mu * mu),
                     allowed = 64 * eps / std::sqrt(g2) * (1 + n * n) / std::min(mu, 1.0);
        CHECK(r.l == vec3<double>{-v.x, -v.y, v.z});
        CHECK(std::abs(r.weight - F) < allowed);
        CHECK(std::abs(r.weight + ti.weight - 1) < allowed);
        if (n * n - 1 + mu * mu <= 0) {
            CHECK(t.probability == 0);
            continue;
        }
        CHECK(t.weight == Catch::Approx(ti.weight / (n * n)));
        CHECK(std::abs(lobe::length(t.l) - 1) < 8 * eps);
        CHECK(std::abs(n * t.l.x + v.x) < 8 * eps * std::max(1.0, n));
        CHECK(std::abs(n * t.l.y + v.y) < 8 * eps * std::max(1.0, n));
        CHECK(t.l.z * v.z < 0);
        // back along the same way
        const auto back = radiance.refraction(t.l);
        CHECK(lobe::length(back.l - v) < 64 * eps / std::min(mu, std::abs(t.l.z)));
        CHECK(std::abs(back.weight / (n * n) - ti.weight) < 64 * allowed / std::min(1.0, std::abs(t.l.z)));
        const double u = random();
        const auto s = radiance.sample(v, u);
        CHECK(s.l == (u < r.weight ? r.l : t.l));
        CHECK(s.weight * s.probability == Catch::Approx(u < r.weight ? r.weight : t.weight).epsilon(1e-6));
    }
    CHECK(lobe::smooth_dielectric{1.5}.sample(vec3<double>{1, 0, 0}, 0.5).probability == 0);
    CHECK(lobe::smooth_dielectric{1.5}.reflection(vec3<double>{0, 0, 1}).weight == Catch::Approx(0.04));
}

TEST_CASE("the smooth interface is the limit of the rough one", "[glass]") {
    random_numbers random(2);
    const lobe::rough_dielectric rough{ggx{alpha{1e-6}}, lobe::smith_joint{}, 1.5};
    const lobe::smooth_dielectric smooth{1.5};
    for (int i = 0; i < 1000; ++i) {
        const auto v = view(random.between(0.1, 1), i % 2 == 0);
        const double u = random();
        if (std::abs(smooth.reflection(v).weight - u) < 1e-2) continue;
        const auto s = smooth.sample(v, u);
        const auto t = rough.sample(v, {random.between(0, 0.9), random(), u});
        CHECK(lobe::length(s.l - t.l) < 1e-3);
        CHECK(std::abs(s.weight - t.weight) < 1e-3);
    }
}

TEST_CASE("a mirror", "[glass]") {
    const lobe::mirror gold{lobe::conductor{vec3<double>{0.2, 0.4, 1.4}, vec3<double>{3.9, 2.5, 1.9}}};
    const auto s = gold.sample(view(0.3));
    CHECK(s.l == vec3<double>{-view(0.3).x, -view(0.3).y, 0.3});
    CHECK(s.weight.y == lobe::conductor{0.4, 2.5}(0.3));
    CHECK(s.probability == 1);
    const auto below = lobe::mirror{lobe::schlick{0.5f}}.sample(vec3<float>{0.6f, 0, -0.8f});
    CHECK(below.probability == 0);
    CHECK(below.weight == 0);
    CHECK(below.l.z == 1);
}

TEST_CASE("a pane is the series of its reflections", "[glass]") {
    for (const double eta : {1.0, 1.1, 1.5, 2.4, 0.8})
        for (double mu = 0.001; mu <= 1; mu += 0.037) {
            const double R = lobe::dielectric{eta}(mu);
            double reflected = R, transmitted = 0, inside = 1 - R;  // all that is inside meets the far face first
            for (int k = 0; k < 4000 && inside > 1e-18; ++k) {
                (k % 2 ? reflected : transmitted) += inside * (1 - R);
                inside *= R;
            }
            const lobe::pane pane{eta};
            CHECK(pane(mu) == Catch::Approx(reflected).margin(1e-12 + inside));
            CHECK(pane.transmittance(mu) == Catch::Approx(transmitted).margin(1e-12 + inside));
            const lobe::thin_dielectric thin{eta};
            for (const bool above : {true, false}) {
                const auto through = thin.sample(view(mu, above), 1 - 0x1p-53);
                CHECK(through.weight == 1);
                if (R < 1) {
                    CHECK(through.l == -view(mu, above));
                    CHECK(through.probability == pane.transmittance(mu));
                }
                const auto back = thin.sample(view(mu, above), 0.0);
                if (R > 0) {
                    CHECK(back.l.z == view(mu, above).z);
                    CHECK(back.probability == pane(mu));
                }
            }
        }
}

TEST_CASE("a rough pane: two lobes of microfacet, reciprocal, its samples have its density", "[glass]") {
    const auto one = [](double) { return 1.0; };
    const lobe::rough_thin_dielectric thin{ggx{alpha{0.4}}, lobe::smith_correlated{}, 1.5};
    const lobe::microfacet lossless{ggx{alpha{0.4}}, lobe::smith_correlated{}, one};
    random_numbers random(3);
    for (int i = 0; i < 20000; ++i) {
        const auto v = random.direction(), l = random.direction();
        const auto e = thin.evaluate(v, l);
        CHECK(e.f_cos == Catch::Approx(thin.f(v, l) * std::abs(l.z)).epsilon(1e-12));
        CHECK(e.f_cos == Catch::Approx(thin.f_cos(v, l)).epsilon(8 * eps));  // V alone rounds otherwise
        CHECK(e.pdf == thin.pdf(v, l));
        CHECK(thin.f(v, l) == Catch::Approx(thin.f(l, v)).epsilon(1e-12));
        // the two sides share what the lossless lobe has
        const vec3<double> up{v.x, v.y, std::abs(v.z)}, lit{l.x, l.y, std::abs(l.z)};
        CHECK(thin.f(v, l) + thin.f(v, {l.x, l.y, -l.z}) == Catch::Approx(lossless.f(up, lit)).epsilon(1e-12));
        const auto s = thin.sample(v, {random(), random(), random()});
        if (!(s.pdf > 0)) continue;
        const auto at = thin.evaluate(v, s.l);
        CHECK(at.pdf == Catch::Approx(s.pdf).epsilon(1e-9));
        CHECK(at.f_cos == Catch::Approx(s.pdf * s.weight).epsilon(1e-9));
        CHECK(s.weight <= 1 + 4 * eps);
    }
}

TEST_CASE("tints are weights of the two parts", "[glass]") {
    const vec3<double> red{1, 0.2, 0.1}, green{0.1, 0.9, 0.3};
    const lobe::rough_dielectric glass{ggx{alpha{0.4}}, lobe::smith_joint{}, 1.5};
    const lobe::tinted tinted{glass, red, green};
    const lobe::tinted window{lobe::thin_dielectric{1.5}, red, green};
    random_numbers random(4);
    int parts[2] = {0, 0};
    for (int i = 0; i < 2000; ++i) {
        const auto v = random.direction(), l = random.direction();
        const vec3<double> tint = (v.z > 0) == (l.z > 0) ? red : green;
        const auto e = tinted.evaluate(v, l);
        for (int k = 0; k < 3; ++k) {
            CHECK(e.f_cos[k] == Catch::Approx(glass.f_cos(v, l) * tint[k]));
            CHECK(tinted.f(v, l)[k] == Catch::Approx(glass.f(v, l) * tint[k]));
            CHECK(tinted.f_cos(v, l)[k] == e.f_cos[k]);
        }
        CHECK(e.pdf == glass.pdf(v, l));
        CHECK(tinted.pdf(v, l) == e.pdf);
        const vec3<double> u{random(), random(), random()};
        const auto s = glass.sample(v, u);
        const auto t = tinted.sample(v, u);
        const bool reflected = (v.z > 0) == (s.l.z > 0);
        ++parts[reflected];
        CHECK(t.l == s.l);
        CHECK(t.pdf == s.pdf);
        CHECK(t.weight.y == Catch::Approx(s.weight * (reflected ? red : green).y));
        const auto w = window.sample(v, u.z);
        CHECK(w.weight.x == ((w.l.z > 0) == (v.z > 0) ? red : green).x);
    }
    CHECK(parts[0] > 100);
    CHECK(parts[1] > 100);
}

TEST_CASE("smooth interfaces and panes on packs", "[glass]") {
    using pack = xsimd::batch<float>;
    random_numbers random(5);
    for (int trial = 0; trial < 200; ++trial) {
        std::vector<float> x, y, z, u;
        for (std::size_t lane = 0; lane < pack::size; ++lane) {
            const auto v = random.direction<float>();
            x.push_back(v.x), y.push_back(v.y), z.push_back(v.z), u.push_back(float(random()));
        }
        const vec3<pack> v{pack::load_unaligned(x.data()), pack::load_unaligned(y.data()),
                           pack::load_unaligned(z.data())};
        const pack many = pack::load_unaligned(u.data());
        const auto a = lobe::smooth_dielectric{pack(1.5f)}.sample(v, many);
        const auto b = lobe::thin_dielectric{pack(1.5f)}.sample(v, many);
        for (std::size_t i = 0; i < pack::size; ++i) {
            const vec3<float> vi{x[i], y[i], z[i]};
            const auto ai = lobe::smooth_dielectric{1.5f}.sample(vi, u[i]);
            const auto bi = lobe::thin_dielectric{1.5f}.sample(vi, u[i]);
            CHECK(std::abs(a.l.z.get(i) - ai.l.z) < 1e-6f);
            CHECK(std::abs(a.probability.get(i) - ai.probability) < 1e-6f);
            CHECK(b.l.z.get(i) == bi.l.z);
        }
    }
}
