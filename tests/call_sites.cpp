// The call sites of the design, as they are written there.
#include "catch.hpp"
#include "support.hpp"

#include <lobe/lobe.hpp>

using lobe::alpha;

namespace {

using glm::vec2;
using glm::vec3;

struct ray {
    vec3 p, d;
};
vec3 prefiltered(const vec3&, float) { return vec3(1); }
vec3 irradiance(const vec3&) { return vec3(1); }

}  // namespace

TEST_CASE("call sites 1 to 5 compile as written, in float", "[call_sites]") {
    const float rough = 0.5f;
    const vec3 n = lobe::normalize(vec3(0.3f, -0.2f, 0.9f)), V = lobe::normalize(vec3(0.5f, 0.1f, 0.8f));
    const vec3 L = lobe::normalize(vec3(-0.2f, 0.4f, 0.7f)), radiance(2.0f), R = lobe::reflect(V, n), p(0.0f);
    const vec2 u(0.3f, 0.6f);
    const vec3 f0(1.00f, 0.71f, 0.29f), albedo(0.0f);
    vec3 Lo(0.0f), throughput(1.0f);
    ray next{};

    // 1. evaluate, in any renderer
    const auto a = alpha<float>::from_roughness(rough, 1e-4f);
    const auto brdf =
        lobe::microfacet{lobe::ggx{a}, lobe::smith_correlated{}, lobe::schlick{vec3{1.00f, 0.71f, 0.29f}}};
    const lobe::frame at{n};  // n: world-space unit normal
    const vec3 v = at.to_local(V), l = at.to_local(L);
    Lo += radiance * brdf.f_cos(v, l);
    CHECK(Lo.x > 0);
    static_assert(sizeof(brdf) == 16);
    static_assert(sizeof(lobe::microfacet<lobe::ggx<float>, lobe::smith_correlated, lobe::schlick<vec3>>) == 16);

    // 2. a path tracer
    do {
        const auto s = brdf.sample(v, u);  // samples visible normals
        if (s.pdf == 0) break;
        throughput *= s.weight;
        next = ray{p, at.to_world(s.l)};
    } while (false);
    const auto e = brdf.evaluate(v, l);  // e.f_cos, e.pdf: for light samples in multiple importance sampling
    CHECK(lobe::dot(next.d, n) > 0);
    CHECK(throughput.x > throughput.z);
    CHECK(e.f_cos == brdf.f_cos(v, l));
    CHECK(e.pdf == Catch::Approx(brdf.pdf(v, l)));

    // 3. split-sum terms: exact, from a table, or from a fit -- same call
    const auto table = lobe::bake_dfg<float>(lobe::smith_correlated{}, {.size = 32});  // its type knows its masking
    // t.scale, t.bias: F0*scale + F90*bias
    const lobe::dfg_terms<float> t = table(v.z, a);
    const lobe::dfg_terms<float> x = lobe::dfg_exact<float>(lobe::smith_correlated{}, v.z, a);
    CHECK(std::abs(t.scale - x.scale) < 1e-3f);
    const lobe::dfg_terms<float> ready = lobe::default_dfg{}(v.z, a), fit = lobe::dfg_fit_precise{}(v.z, a);
    CHECK(std::abs(ready.scale - x.scale) < 1e-3f);
    CHECK(std::abs(fit.scale - x.scale) < 2e-3f);

    // ... and all bounces
    const lobe::compensated metal{brdf};
    CHECK(metal.f_cos(v, l).y > brdf.f_cos(v, l).y);
    const auto all = lobe::smith_multiscatter{}.weights(lobe::schlick{vec3{0.04f}}, v.z, a, vec3{1.0f});
    CHECK(lobe::length(all.radiance + all.irradiance - vec3{1.0f}) < 1e-5f);

    // 4. multi-scattering image-based light
    const auto w = lobe::fdez_aguera{}(t, f0, albedo);  // w.radiance, w.irradiance
    Lo = w.radiance * prefiltered(R, rough) + w.irradiance * irradiance(n);
    CHECK(Lo.x == Catch::Approx(1));

    // 5. energy of any composition, by quadrature
    // F = 1, double
    const lobe::microfacet mirror{lobe::ggx{alpha{0.3}}, lobe::smith_correlated{}, lobe::perfect_reflector{}};
    const double mu = 0.5;
    // by cosine: isotropic types only
    double E = lobe::directional_albedo(mirror, mu), Ebar = lobe::average_albedo(mirror);
    // by direction: any type; value and error
    const auto estimate = lobe::directional_albedo(brdf, v, {.tolerance = 1e-6});
    CHECK(E < Ebar);
    CHECK(estimate.value.x > estimate.value.z);
    CHECK(estimate.error < 1e-5f);
}

TEST_CASE("the same call sites in double", "[call_sites]") {
    using glm::dvec2;
    using glm::dvec3;
    const dvec3 n = lobe::normalize(dvec3(0.3, -0.2, 0.9)), V = lobe::normalize(dvec3(0.5, 0.1, 0.8));
    const dvec3 L = lobe::normalize(dvec3(-0.2, 0.4, 0.7)), f0(1.00, 0.71, 0.29), albedo(0.0);
    const auto a = alpha<double>::from_roughness(0.5, 1e-4);
    const auto brdf = lobe::microfacet{lobe::ggx{a}, lobe::smith_correlated{}, lobe::schlick{dvec3{1.00, 0.71, 0.29}}};
    const lobe::frame at{n};
    const dvec3 v = at.to_local(V), l = at.to_local(L);
    CHECK(brdf.f_cos(v, l).x > 0);
    const auto s = brdf.sample(v, dvec2(0.3, 0.6));
    CHECK(s.pdf > 0);
    CHECK(brdf.evaluate(v, l).pdf > 0);
    const auto table = lobe::bake_dfg<double>(lobe::smith_correlated{}, {.size = 32});
    const lobe::dfg_terms<double> t = table(v.z, a);
    const lobe::dfg_terms<double> x = lobe::dfg_exact<double>(lobe::smith_correlated{}, v.z, a);
    CHECK(std::abs(t.scale - x.scale) < 3e-3);
    const auto w = lobe::fdez_aguera{}(t, f0, albedo);
    CHECK((w.radiance + w.irradiance).x == Catch::Approx(1));
    CHECK(lobe::directional_albedo(brdf, v, {.tolerance = 1e-6}).error <= 1e-6);
    const auto aniso =
        lobe::microfacet{lobe::ggx{lobe::alpha_xy{0.1, 0.5}}, lobe::smith_correlated{}, lobe::schlick{0.04}};
    CHECK(lobe::directional_albedo(aniso, v).value > 0);
}
