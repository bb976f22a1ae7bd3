// The samplers of the rough diffuse models: bounded weights, densities, their spread, and the ends of what they are
// given.
#include "catch.hpp"
#include "support.hpp"

#include <lobe/brdf/burley.hpp>
#include <lobe/brdf/eon.hpp>
#include <lobe/brdf/lambert.hpp>
#include <lobe/brdf/layered.hpp>
#include <lobe/brdf/oren_nayar.hpp>
#include <lobe/energy/quadrature.hpp>
#include <lobe/ndf/ggx.hpp>
#include <lobe/sampling/points.hpp>

#include <xsimd/xsimd.hpp>

using lobe::cosine_sampling;
using lobe::vec2;
using lobe::vec3;

namespace {

constexpr double pi = 3.14159265358979324;

template <class T>
vec3<T> at_cosine(T mu, double phi = 0) {
    const double z = static_cast<double>(mu), sine = std::sqrt((1 - z) * (1 + z));
    return {static_cast<T>(sine * std::cos(phi)), static_cast<T>(sine * std::sin(phi)), mu};
}

/// The rough models; `largest`: the weight that their comments state, rho = 1.
template <class T, class G>
void for_each_rough(T rho, T r, const G& g) {
    g("oren_nayar", lobe::oren_nayar{rho, r * T(pi / 2)}, 1.06);
    g("fon", lobe::fon{rho, r}, 1.04);
    g("eon", lobe::eon{rho, r}, 1.16);
    g("eon, fon_loss_fit", lobe::eon{rho, r, lobe::fon_loss_fit{}}, 1.16);
}
template <class G>
void for_each_by_cosine(double rho, double r, const G& g) {
    g("oren_nayar", lobe::oren_nayar{rho, r * (pi / 2), cosine_sampling{}});
    g("fon", lobe::fon{rho, r, cosine_sampling{}});
    g("eon", lobe::eon{rho, r, lobe::fon_loss{}, cosine_sampling{}});
    g("eon, fon_loss_fit", lobe::eon{rho, r, lobe::fon_loss_fit{}, cosine_sampling{}});
}

/// int g dl over the hemisphere: 48 nodes of Gauss in theta and phi, split where the models have edges, theta_l =
/// theta_v and a quarter turn from v, and crowding towards the lower ends. Within 1e-9 for v.z from 1e-3.
template <class G>
double over_hemisphere(double mu, const G& g) {
    static const lobe::gauss_legendre<double> rule(48);
    const double theta_v = std::acos(mu);
    double total = 0;
    for (const auto& [from, to] : {std::pair{0.0, theta_v}, std::pair{theta_v, pi / 2}})
        for (std::size_t i = 0; i < rule.x.size(); ++i)
            for (int quarter = 0; quarter < 4; ++quarter)
                for (std::size_t j = 0; j < rule.x.size(); ++j) {
                    const double t = rule.x[i], theta = to - (to - from) * t * t,
                                 phi = pi / 2 * (quarter - 1 + rule.x[j]);
                    const double w = rule.w[i] * (to - from) * 2 * t * pi / 2 * rule.w[j] * std::sin(theta);
                    total += w * g(vec3<double>{std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi),
                                                std::cos(theta)});
                }
    return total;
}

/// 0, next to it, a grid, next to 1.
template <class T>
std::vector<T> square_side(int steps) {
    using limits = std::numeric_limits<T>;
    std::vector<T> side{T(0),        limits::denorm_min(),     limits::min(), T(1e-12), T(1e-6),
                        1 - T(1e-6), 1 - limits::epsilon() / 2};
    for (int i = 1; i < steps; ++i) side.push_back(T(i) / T(steps));
    return side;
}

}  // namespace

TEMPLATE_TEST_CASE("the weight of a rough diffuse sample is bounded", "[diffuse]", float, double) {
    using T = TestType;
    const std::vector<T> side = square_side<T>(24);
    std::vector<T> cosines{std::is_same_v<T, float> ? T(1e-18) : T(1e-150)};
    for (const double mu : {1e-12, 1e-6, 1e-4, 1e-3, 0.01, 0.03, 0.1, 0.3, 0.5, 0.8, 0.99, 0.999999, 1.0})
        cosines.push_back(static_cast<T>(mu));
    for (const T r : {T(0), T(1e-30), T(1e-6), T(0.01), T(0.1), T(0.3), T(0.7), T(1)})
        for_each_rough(T(1), r, [&](const std::string& name, const auto& brdf, double stated) {
            double largest = 0, evaluated = 0;
            bool right = true;
            for (const T mu : cosines)
                for (const double phi : {0.0, 2.2, -pi / 2}) {
                    const vec3<T> v = at_cosine(mu, phi);
                    for (const T x : side)
                        for (const T y : side) {
                            const auto s = brdf.sample(v, {x, y});
                            largest = larger(largest, static_cast<double>(s.weight));
                            right = right && s.pdf > 0 && s.l.z > 0 && s.weight >= 0;
                            right = right && std::abs(lobe::length(s.l) - 1) < 4 * std::numeric_limits<T>::epsilon();
                        }
                    // the same by evaluating, wherever l is: the opposite at grazing, where 1 + r s vanishes, among
                    // them
                    for (const T z : cosines)
                        for (int turn = 0; turn <= 16; ++turn) {
                            const auto e = brdf.evaluate(v, at_cosine(z, phi + pi * turn / 16));
                            evaluated = larger(evaluated, static_cast<double>(e.f_cos / e.pdf));
                        }
                }
            INFO(name << " r " << r << " largest weight " << largest << ", evaluated " << evaluated);
            CHECK(right);
            CHECK(largest <= stated);
            CHECK(evaluated <= stated);
        });
}

TEST_CASE("sampled by the cosine, the weight of a rough diffuse model grows as its comment says", "[diffuse]") {
    const double grows[] = {0.44, 0.78, 0.78, 0.78};
    for (const double mu : {1e-2, 1e-4}) {
        std::size_t model = 0;
        for_each_by_cosine(1, 1, [&](const std::string& name, const auto& brdf) {
            const double w = brdf.sample(at_cosine(mu), {1 - mu * mu, 0}).weight;  // l = v
            INFO(name << ' ' << mu << ' ' << w);
            CHECK(w * mu == Catch::Approx(grows[model++]).epsilon(0.02));
            const vec3<double> l = at_cosine(0.3, 2.0);
            CHECK(brdf.pdf(at_cosine(mu), l) == Catch::Approx(0.3 / pi).epsilon(1e-15));
        });
    }
}

TEST_CASE("the density of rough diffuse samples is the printed one, and integrates to 1", "[diffuse]") {
    // By angles, in long double; tilt and peak as the models' comments have them.
    using real = long double;
    random_numbers random(1);
    double worst = 0;
    for (int i = 0; i < 20000; ++i) {
        const double r = random(), sigma = r * pi / 2;
        const vec3<double> v = random.grazing_direction(1e-3), l = random.grazing_direction(1e-3);
        const auto polar = [](const vec3<double>& w) {
            return std::atan2(std::hypot(real(w.x), real(w.y)), real(w.z));
        };
        const real theta_v = polar(v), theta_l = polar(l);
        const real cos_phi = std::cos(std::atan2(real(v.y), real(v.x)) - std::atan2(real(l.y), real(l.x)));
        const auto printed = [&](real tilt, real peak) {
            const real sv = std::sin(theta_v), cv = std::cos(theta_v), cl = std::cos(theta_l),
                       s = sv * std::sin(theta_l) * cos_phi;
            const real second = peak * sv * std::max(real(0), cos_phi) * (std::min(real(1), cl / cv) - cl);
            return (cl * (1 + tilt * s) + second) / (std::acos(real(-1)) + peak * sv * (1 - cv));
        };
        const real s2 = real(sigma) * real(sigma), ratio = 0.45L * s2 / (s2 + 0.09L) / (1 - 0.5L * s2 / (s2 + 0.33L));
        const auto compare = [&](double pdf, real exact) {
            worst = larger(worst, static_cast<double>(std::abs(real(pdf) / exact - 1)));
        };
        compare(lobe::oren_nayar{0.5, sigma}.pdf(v, l), printed(ratio / 3, ratio));
        compare(lobe::fon{0.5, r}.pdf(v, l), printed(0.9L * real(r), real(r)));
        compare(lobe::eon{0.5, r}.pdf(v, l), printed(0.9L * real(r), real(r)));
    }
    INFO(worst);
    CHECK(worst < 5e-15);  // 1 + tilt s >= 0.1 with s wrong by 1e-16; and a dozen roundings

    for (const double mu : {0.001, 0.1, 0.5, 0.9, 1.0})
        for_each_rough(1.0, 1.0, [&](const std::string& name, const auto& brdf, double) {
            INFO(name << " mu " << mu);
            CHECK(over_hemisphere(mu, [&](const vec3<double>& l) { return brdf.pdf(at_cosine(mu), l); }) ==
                  Catch::Approx(1).epsilon(1e-6));
        });
}

TEMPLATE_TEST_CASE("rough diffuse samples: moments of their light, and its spread", "[diffuse]", float, double) {
    using T = TestType;
    constexpr std::uint32_t n = 1u << 18;
    for (const double r : {0.1, 1.0})
        for (const double mu : {0.5, 0.1, 0.01, 0.001}) {
            double by_cosine[4];
            std::size_t model = 0;
            for_each_by_cosine(0.8, r, [&](const std::string&, const auto& brdf) {
                const vec3<double> v = at_cosine(mu);
                const double E = over_hemisphere(mu, [&](const vec3<double>& l) { return brdf.f_cos(v, l); });
                const double E2 =
                    over_hemisphere(mu, [&](const vec3<double>& l) { return pi * brdf.f(v, l) * brdf.f_cos(v, l); });
                by_cosine[model++] = std::sqrt(E2 / (E * E) - 1);
            });
            model = 0;
            for_each_rough(T(0.8), static_cast<T>(r), [&](const std::string& name, const auto& brdf, double) {
                const vec3<T> v = at_cosine(static_cast<T>(mu), 0.7), toward = at_cosine(T(0), 0.7);
                double moments[3] = {}, square = 0;
                for (std::uint32_t i = 0; i < n; ++i) {
                    const auto s = brdf.sample(v, lobe::hammersley<T>(i, n));
                    const double w = static_cast<double>(s.weight), x = static_cast<double>(lobe::dot(s.l, toward));
                    const double z = static_cast<double>(s.l.z);
                    moments[0] += w / n, moments[1] += w * x / n, moments[2] += w * z / n, square += w * w / n;
                }
                const double spread = std::sqrt(square / (moments[0] * moments[0]) - 1);
                INFO(name << " r " << r << " mu " << mu << ": spread " << spread << " of the mean, by the cosine "
                          << by_cosine[model]);
                // The same model in double, as the quadrature's.
                std::size_t k = 0;
                for_each_rough(0.8, r, [&](const std::string&, const auto& exact, double) {
                    if (k++ != model) return;
                    const auto moment = [&](const auto& weighting) {
                        return over_hemisphere(
                            mu, [&](const vec3<double>& l) { return exact.f_cos(at_cosine(mu), l) * weighting(l); });
                    };
                    // Hammersley: (log2 n)/n = 7e-5
                    CHECK(std::abs(moments[0] - moment([](const auto&) { return 1.0; })) < 1e-4);
                    CHECK(std::abs(moments[1] - moment([](const auto& l) { return l.x; })) < 1e-4);
                    CHECK(std::abs(moments[2] - moment([](const auto& l) { return l.z; })) < 1e-4);
                });
                CHECK(spread < 0.08);
                CHECK(spread < by_cosine[model] / (mu < 0.2 ? 3 : 1.5));
                ++model;
            });
        }
}

TEST_CASE("rough diffuse sampling of no roughness, and from above, is the cosine's", "[diffuse]") {
    random_numbers random(4);
    for (int i = 0; i < 1000; ++i) {
        const vec3<float> v = random.grazing_direction<float>(1e-6), n{0, 0, 1};
        const vec2<float> u{static_cast<float>(random()) * 0.999f, static_cast<float>(random()) * 0.999f};
        for_each_rough(0.7f, 0.0f, [&](const std::string&, const auto& brdf, double) {
            const auto s = brdf.sample(v, u);
            CHECK((s.weight == 0.7f && s.l.z == std::sqrt(1 - u.x)));
        });
        for_each_rough(0.7f, 1.0f, [&](const std::string&, const auto& brdf, double) {
            const auto s = brdf.sample(n, u), c = lobe::lambert{1.0f}.sample(n, u);
            CHECK(s.pdf == Catch::Approx(c.pdf).epsilon(1e-6));
            CHECK(lobe::length(s.l - c.l) < 1e-6f);
        });
    }
}

TEST_CASE("rough diffuse samples in float are those in double", "[diffuse]") {
    random_numbers random(5);
    double worst = 0, cosine = 0;
    for (int i = 0; i < 200000; ++i) {
        const float mu = static_cast<float>(random.log_between(1e-6, 1)), r = static_cast<float>(random());
        const vec3<float> v = at_cosine(mu, random.between(-pi, pi));
        const vec2<float> u{static_cast<float>(random.log_between(1e-6, 1)) * 0.999f,
                            static_cast<float>(random()) * 0.999f};
        const vec2<float> x{i % 2 ? u.x : 1 - u.x, u.y};
        // Where u.x nears the share of the second lobe, p, which lobe is chosen is a matter of rounding, and u.x - p is
        // known to that of p.
        const double z = static_cast<double>(mu),
                     m = static_cast<double>(r) * std::sqrt((1 - z) * (1 + z)) * (1 - z) / pi, p = m / (1 + m);
        if (std::abs(static_cast<double>(x.x) - p) < 1e-3) continue;
        const auto in_float = lobe::fon{1.0f, r}.sample(v, x);
        const auto in_double = lobe::fon{1.0, static_cast<double>(r)}.sample(vec3<double>(v), vec2<double>(x));
        worst = larger(worst, lobe::length(vec3<double>(in_float.l) - in_double.l));
        cosine = larger(cosine, std::abs(static_cast<double>(in_float.l.z) / in_double.l.z - 1));
    }
    INFO(worst << " radian; cosines, relative " << cosine);
    CHECK(worst < 1e-6);          // a dozen roundings
    CHECK(cosine < 6e-8 / 1e-3);  // of u.x - p; 1 - u.x is exact
}

TEST_CASE("rough diffuse sampling from below and of a NaN fails", "[diffuse]") {
    const float nan = std::numeric_limits<float>::quiet_NaN(), tiny = std::numeric_limits<float>::denorm_min();
    for (const float r : {0.0f, 0.5f, 1.0f})
        for_each_rough(0.7f, r, [&](const std::string& name, const auto& brdf, double) {
            INFO(name);
            const vec3<float> bad[] = {{0.6f, 0, -0.8f}, {0, 0, -1},      {1, 0, 0},   {1, 0, 1e-30f},
                                       {1, 0, -0.0f},    {nan, nan, nan}, {0, 0, nan}, {nan, 0, -0.5f}};
            for (const vec3<float>& v : bad) {
                const auto s = brdf.sample(v, {0.3f, 0.7f});
                CHECK((s.pdf == 0 && s.weight == 0 && s.l == vec3<float>{0, 0, 1}));
                CHECK((brdf.pdf(v, {0.6f, 0, 0.8f}) == 0 && brdf.evaluate({0.6f, 0, 0.8f}, v).pdf == 0));
            }
            const vec3<float> good[] = {{0, 0, 1},           {1e-25f, 0, 1},     {tiny, -tiny, 1},
                                        {1e-19f, 1e-19f, 1}, {0, 0, 1.0000001f}, {1, 0, 1e-18f}};
            for (const vec3<float>& v : good)
                for (const float x : {0.0f, 0.1f, 0.3f, 0.9999f}) {
                    const auto s = brdf.sample(v, {x, 0.4f});
                    CHECK((s.pdf > 0 && s.weight > 0 && s.weight < 1 && s.l.z > 0));
                    CHECK(lobe::length(s.l) == Catch::Approx(1).epsilon(1e-6));
                    for (const vec3<float>& l : {good[0], good[1], good[2], vec3<float>{0.6f, 0, 0.8f}})
                        CHECK(brdf.pdf(v, l) > 0);
                }
        });
}
