// The reflectance equation by sampling against quadrature: BRDFs and lights of several kinds, drawn in three ways.
#include "catch.hpp"
#include "support.hpp"

#include <lobe/lobe.hpp>

using lobe::alpha, lobe::vec2, lobe::vec3;

namespace {

/// A glow around an axis: exp(kappa (l.axis - 1)), and its own sampler, the von Mises-Fisher distribution
/// (Fisher 1953), pdf = kappa exp(kappa (l.axis - 1))/(2 pi (1 - exp(-2 kappa))).
struct glow {
    lobe::frame<double> at;
    double kappa;

    vec3<double> operator()(const vec3<double>& l) const { return vec3<double>{1, 0.5, 0.25} * (30 * fall(l)); }

    struct drawn {
        vec3<double> direction;
        double pdf;
    };
    drawn sample(const vec2<double>& u) const {
        const double down = -std::log1p(-u.x * (1 - std::exp(-2 * kappa))) / kappa;  // 1 - l.axis
        const double sine = std::sqrt(down * (2 - down)), phi = 2 * lobe::pi<double>() * u.y;
        const vec3<double> l = at.to_world({sine * std::cos(phi), sine * std::sin(phi), 1 - down});
        return {l, pdf(l)};
    }
    double pdf(const vec3<double>& l) const {
        return kappa * fall(l) / (2 * lobe::pi<double>() * (1 - std::exp(-2 * kappa)));
    }

private:
    double fall(const vec3<double>& l) const { return std::exp(kappa * (lobe::dot(l, at.n) - 1)); }
};

vec3<double> view(double cosine) { return {std::sqrt(1 - cosine * cosine), 0, cosine}; }

const lobe::schlick gold{vec3<double>{1.0, 0.71, 0.29}};

/// Each case to g(name, brdf, v, light).
template <class G>
void for_each_case(const G& g) {
    using lobe::ggx, lobe::microfacet, lobe::smith_correlated;
    const auto light = [](double x, double y, double z, double kappa) {
        return glow{lobe::frame<double>{lobe::normalize(vec3<double>{x, y, z})}, kappa};
    };
    g("Lambert, broad light", lobe::lambert{vec3<double>{0.5}}, view(0.7), light(0.2, 0.4, 1, 3));
    const vec3<double> albedo{0.8, 0.5, 0.2};
    g("Burley, light at the horizon", lobe::burley{albedo, 1.0}, view(0.2), light(1, 0.3, 0.02, 12));
    g("gold, light in the lobe", microfacet{ggx{alpha{0.3}}, smith_correlated{}, gold}, view(0.6),
      light(-0.8, 0.1, 0.5, 20));
    g("gold at grazing", microfacet{ggx{alpha{0.6}}, smith_correlated{}, gold}, view(0.1), light(-0.5, 0.5, 1, 8));
    g("brushed gold", microfacet{ggx{lobe::alpha_xy{0.5, 0.15}}, smith_correlated{}, gold}, view(0.8),
      light(-0.5, 0.4, 0.7, 15));
    g("a coat over a base", lobe::metallic_roughness(vec3<double>{0.9, 0.3, 0.1}, 0.3, alpha{0.4}), view(0.5),
      light(-0.6, -0.3, 0.6, 10));
}

/// Each way of drawing directions to g(name, strategy).
template <class G>
void for_each_strategy(const glow& light, const G& g) {
    g("by the BRDF", lobe::by_brdf{});
    g("by the lights", lobe::by_lights{light});
    g("by both", lobe::by_both{light});
}

/// The integral, in its lobes; the error is what a second order leaves.
template <class B>
vec3<double> integral(const B& b, const vec3<double>& v, const glow& light) {
    const auto at_order = [&](int order) {
        vec3<double> total{0};
        lobe::detail::for_each_lobe(b, [&](const auto& lobe) {
            total += lobe::detail::hemisphere_integral_at(
                [&](const vec3<double>& l) { return lobe.f_cos(v, l) * light(l); }, v, lobe.width(), false, order);
        });
        return total;
    };
    const vec3<double> value = at_order(64), other = at_order(48);
    for (int k = 0; k < 3; ++k) REQUIRE(std::abs(value[k] - other[k]) < 1e-5 * value[k]);
    return value;
}

}  // namespace

TEST_CASE("reflected radiance: unbiased, and its standard error is right", "[ibl]") {
    for_each_case([](const std::string& name, const auto& b, const vec3<double>& v, const glow& light) {
        const vec3<double> exact = integral(b, v, light);
        for_each_strategy(light, [&](const std::string& drawn, const auto& strategy) {
            INFO(name << ", " << drawn);
            // many short runs: their mean has no bias, their spread is what each says of itself
            const int runs = 400;
            vec3<double> mean{0}, squared{0}, stated{0};
            for (int run = 0; run < runs; ++run) {
                const lobe::shifted_hammersley<double> points{16, 32, static_cast<std::uint64_t>(run)};
                const auto L = lobe::reflected_radiance(b, v, light, points, strategy);
                const vec3<double> off = L.value - exact;
                mean += off / double(runs);
                squared += off * off / double(runs);
                stated += L.standard_error * L.standard_error / double(runs);
            }
            for (int k = 0; k < 3; ++k) {
                // 4 standard errors, and what the quadrature leaves
                CHECK(std::abs(mean[k]) < 4 * std::sqrt(squared[k] / runs) + 1e-5 * exact[k]);
                // 400 runs know their spread to 3.5 %; of 18 strategies the worst is off by 3 of these
                CHECK(std::sqrt(stated[k] / squared[k]) == Catch::Approx(1).margin(0.15));
            }
        });
    });
}

TEST_CASE("reflected radiance: a map of world directions", "[ibl]") {
    // 1 + w.a over a white Lambertian surface: 1 + (2/3) n.a
    const vec3<double> a{0.36, 0.48, -0.8}, n{0.6, 0, 0.8};
    const auto world = [&](const vec3<double>& w) { return 1 + lobe::dot(w, a); };
    const lobe::in_tangent_space environment{lobe::frame{n}, world};
    const lobe::shifted_hammersley<double> points{64};
    const auto L = lobe::reflected_radiance(lobe::lambert{1.0}, view(0.5), environment, points);
    const double exact = 1 + 2 * lobe::dot(n, a) / 3;
    CHECK(L.standard_error > 0);
    CHECK(std::abs(L - exact) < 4 * L.standard_error);

    // a sampler of world directions, in its tangent space: the densities agree, the directions turn with the frame
    const glow sun{lobe::frame<double>{a}, 5};
    const lobe::frame<double> at{n};
    const lobe::in_tangent_space local{at, sun};
    const auto drawn = local.sample({0.3, 0.6});
    CHECK(local.pdf(drawn.direction) == Catch::Approx(drawn.pdf).epsilon(1e-13));
    CHECK(lobe::length(at.to_world(drawn.direction) - sun.sample({0.3, 0.6}).direction) < 1e-14);
}

TEST_CASE("shifted points: in the square, spread evenly, rounds of their own", "[sampling]") {
    const lobe::shifted_hammersley<float> points{1u << 12, 8, 5};
    for (std::uint32_t round = 0; round < points.rounds; ++round) {
        double x = 0;
        for (std::uint32_t i = 0; i < points.count; ++i) {
            const auto u = points(round, i);
            REQUIRE((u.x >= 0 && u.x < 1 && u.y >= 0 && u.y < 1));
            x += static_cast<double>(u.x) / points.count;
        }
        CHECK(std::abs(x - 0.5) < 0.5 / points.count + 1e-6);  // one a step of the axis; the shift rounds to 2^-24
        CHECK(points(round, 0) != points(round, 0, 1));
        CHECK(points(round, 0) != points((round + 1) % points.rounds, 0));
        CHECK(points(round, 0) != lobe::shifted_hammersley<float>{1u << 12, 8, 6}(round, 0));
    }
}

TEST_CASE("sample mean: value and standard error of what it is given", "[sampling]") {
    // rounds of 1, 2, 3, 4, twice each: mean 2.5, variance 5/3, standard error sqrt(5/12)
    const auto m = lobe::sample_mean({2, 4}, [](std::uint32_t round, std::uint32_t) { return float(round + 1); });
    CHECK(m.value == 2.5f);
    CHECK(m.standard_error == Catch::Approx(std::sqrt(5.0 / 12)).epsilon(1e-6));
}
