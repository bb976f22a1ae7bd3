#include "render.hpp"

#include "../common/maps.hpp"
#include "../common/random.hpp"
#include "reference_map.hpp"
#include "tiles.hpp"

#include <lobe/lobe.hpp>
#include <tbb/parallel_for.h>

namespace {

// The four ways to light a point.

struct surface {
    const material& m;
    const baked_light& light;
    const baked_light::level& level;  // of the surface's roughness
    const reference_map& map;
};

/// (a) The split sum as tutorials have it: F0 scale + bias, over a body that gets 1 - F(n.v).
vec3 single_scattering(const surface& s, const vec3& n) {
    const lobe::dfg_terms<float> t = lobe::default_dfg{}(lobe::dot(n, V), s.level.alpha);
    const vec3 specular = s.m.f0 * t.scale + t.bias;
    const vec3 diffuse = s.m.albedo * (1.0f - lobe::schlick{s.m.f0}(lobe::dot(n, V)));
    return specular * s.level.radiance(lobe::reflect(V, n)) + diffuse * s.light.irradiance(n);
}

vec3 lit(const surface& s, const vec3& n, const lobe::ibl_weights<vec3>& w) {
    return w.radiance * s.level.radiance(lobe::reflect(V, n)) + w.irradiance * s.light.irradiance(n);
}

/// (b) With the multiple scattering of Fdez-Aguera.
vec3 fdez_aguera(const surface& s, const vec3& n) {
    const lobe::dfg_terms<float> t = lobe::default_dfg{}(lobe::dot(n, V), s.level.alpha);
    return lit(s, n, lobe::fdez_aguera{}(t, s.m.f0, s.m.albedo));
}

/// (c) With the library's default.
vec3 multiple_scattering(const surface& s, const vec3& n) {
    const lobe::schlick fresnel{s.m.f0};
    return lit(s, n, lobe::smith_multiscatter{}.weights(fresnel, lobe::dot(n, V), s.level.alpha, s.m.albedo));
}

/// (d) One sample of the reference: a random walk on the microsurface that looks up the map itself. Walks of one bounce
/// have a closed form, smith_correlated, whose density is f_cos of a perfect mirror: so these find lights by
/// sampling them, too (multiple importance sampling, balance heuristic). What the facets do not reflect enters
/// the body and comes back without a preferred direction: as irradiance, times the albedo.
vec3 reference_sample(const surface& s, const lobe::frame<float>& at, const vec3& irradiance, sample_stream& uniform) {
    const lobe::ggx normals{s.level.alpha};
    const lobe::schlick fresnel{s.m.f0};
    const lobe::microfacet brdf{normals, lobe::smith_correlated{}, fresnel};
    const lobe::microfacet mirror{normals, lobe::smith_correlated{}, lobe::perfect_reflector{}};
    const vec3 v = at.to_local(V);
    vec3 radiance{0};
    if (s.map.lights) {
        const auto light = s.map.lights->sample({uniform(), uniform()});
        const vec3 l = at.to_local(light.direction);
        radiance = brdf.f_cos(v, l) * s.map.radiance(light.direction) / (light.pdf + mirror.f_cos(v, l));
    }

    const auto path = lobe::random_walk{normals, fresnel}.sample(v, uniform);
    const vec3 L = at.to_world(path.l);
    const float light_pdf = path.order == 1 && s.map.lights ? s.map.lights->pdf(L) : 0;
    const float share = light_pdf > 0 ? 1 - light_pdf / (light_pdf + mirror.f_cos(v, path.l)) : 1;
    return radiance + share * path.weight * s.map.radiance(L) + s.m.albedo * (1.0f - path.weight) * irradiance;
}

lobe::sampled<vec3> reference(const surface& s, const vec3& n, const vec3& irradiance, int samples,
                              std::uint64_t seed) {
    const lobe::frame<float> at{n};
    const lobe::sample_counts counts{static_cast<std::uint32_t>(samples) / batches, batches};
    sample_stream uniform{0};
    return lobe::sample_mean(counts, [&](std::uint32_t batch, std::uint32_t i) {
        if (i == 0) uniform = sample_stream{mixed_bits(seed) + batch};
        uniform.next_sample();
        return reference_sample(s, at, irradiance, uniform);
    });
}

}  // namespace

std::vector<sphere> render(const material& m, const baked_light& light, const vec3& background, const settings& set) {
    // The reference has its own irradiance: each texel of the map, for each normal.
    const auto& coarse = light.pyramid.level(halvings(light.pyramid, diffuse_texel));
    const disc area(set.tile);
    image irradiance{set.tile, set.tile};
    tbb::parallel_for(0, set.tile, [&](int y) {
        for (int x = 0; x < set.tile && m.albedo != vec3{0}; ++x)
            if (area.coverage(x, y) > 0) irradiance(x, y) = lobe::irradiance(coarse, area.normal(x, y));
    });

    const reference_map map(light.pyramid.level(0));
    return shaded_spheres("spheres of " + m.name, light.levels.size(), 3, background, set, [&](const point& p) {
        const surface s{m, light, light.levels[p.column], map};
        const vec3& n = p.normal;
        return shaded{{single_scattering(s, n), fdez_aguera(s, n), multiple_scattering(s, n)},
                      reference(s, n, irradiance(p.x, p.y), set.samples, p.seed)};
    });
}
