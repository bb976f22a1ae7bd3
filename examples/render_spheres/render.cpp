#include "render.hpp"

#include "progress.hpp"
#include "random.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <glm/common.hpp>
#include <lobe/lobe.hpp>
#include <tbb/parallel_for.h>

namespace {

// The camera is far away and looks along +x, at the middle of the map; y is up, z is on its right.
const vec3 V{-1, 0, 0};

// ---- the four ways to light a point
// -----------------------------------------------------------------------------------

using light_sampler = lobe::environment_sampler<lobe::latlong<float>>;

/// Samples what is brighter than twice the map's mean: walks find the rest, and a uniform light has no noise.
std::optional<light_sampler> lights_of(const lobe::latlong<float>& map) {
    const float floor = 2 * mean_over_directions(map);
    image excess{map.width, map.height};
    bool any = false;
    for (std::size_t i = 0; i < excess.pixels.size(); ++i) {
        excess.pixels[i] = vec3{std::max(mean_of_channels(map.pixels[i]) - floor, 0.0f)};
        any |= excess.pixels[i].x > 0;
    }
    if (!any) return {};
    return light_sampler{lobe::latlong<float>{map.width, map.height, std::move(excess.pixels)}};
}

/// What the reference looks up: the map itself, and its lights to sample.
struct reference_map {
    const lobe::latlong<float>& radiance;
    std::optional<light_sampler> lights;

    explicit reference_map(const lobe::latlong<float>& environment)
        : radiance(environment), lights(lights_of(environment)) {}
};

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

// ---- the sphere in its tile
// --------------------------------------------------------------------------------------------

struct disc {
    float radius, centre;

    explicit disc(int tile)
        : radius(0.46f * static_cast<float>(tile)), centre(0.5f * static_cast<float>(tile) - 0.5f) {}

    float distance(int x, int y) const {
        return std::hypot(static_cast<float>(x) - centre, static_cast<float>(y) - centre);
    }
    /// The part of the pixel that the sphere covers.
    float coverage(int x, int y) const { return std::clamp(radius - distance(x, y) + 0.5f, 0.0f, 1.0f); }
    /// The normal under the middle of the pixel; at the rim, where the middle may miss, a grazing one.
    vec3 normal(int x, int y) const {
        const float scale = 1 / std::max(radius, 1.0001f * distance(x, y));
        const float right = (static_cast<float>(x) - centre) * scale, up = (centre - static_cast<float>(y)) * scale;
        return lobe::normalize(vec3{-std::sqrt(1 - right * right - up * up), up, right});
    }
};

/// Fills in the errors of a sphere whose pictures are complete; `squared_error` is that of each pixel of the reference.
void measure(sphere& s, const std::vector<double>& squared_error, const disc& area) {
    double pixels = 0, energy = 0, variance = 0;
    for (int y = 0; y < s.reference.height; ++y)
        for (int x = 0; x < s.reference.width; ++x) {
            if (area.coverage(x, y) < 1) continue;
            const double c = mean_of_channels(s.reference(x, y));
            const auto add = [&](error_of_energy& error, const image& picture) {
                const double off = mean_of_channels(picture(x, y)) - c;
                error.mean += off;
                error.largest = std::max(error.largest, std::abs(off));
            };
            add(s.single_error, s.single);
            add(s.fdez_aguera_error, s.fdez_aguera);
            add(s.multiple_error, s.multiple);
            energy += c;
            variance += squared_error[static_cast<std::size_t>(y * s.reference.width + x)];
            ++pixels;
        }
    const double mean = energy / pixels;
    for (error_of_energy* error : {&s.single_error, &s.fdez_aguera_error, &s.multiple_error})
        *error = {error->mean / energy, error->largest / mean};
    s.noise = std::sqrt(variance / pixels) / mean;
}

}  // namespace

std::vector<sphere> render(const material& m, const baked_light& light, const vec3& background, const settings& set) {
    const disc area(set.tile);
    const auto tile = static_cast<std::size_t>(set.tile);
    const image blank{set.tile, set.tile};
    std::vector<sphere> spheres(light.levels.size(), sphere{blank, blank, blank, blank, blank, blank, {}, {}, {}, 0});
    std::vector<std::vector<double>> squared_errors(spheres.size(), std::vector<double>(tile * tile));
    step progress("spheres of " + m.name, (spheres.size() + 1) * tile);

    // The reference has its own irradiance: each texel of the map, for each normal.
    const auto& coarse = light.pyramid.level(halvings(light.pyramid, diffuse_texel));
    image irradiance = blank;
    tbb::parallel_for(0, set.tile, [&](int y) {
        for (int x = 0; x < set.tile && m.albedo != vec3{0}; ++x)
            if (area.coverage(x, y) > 0) irradiance(x, y) = lobe::irradiance(coarse, area.normal(x, y));
        progress.advance();
    });

    const reference_map map(light.pyramid.level(0));

    tbb::parallel_for(std::size_t{0}, spheres.size() * tile, [&](std::size_t row) {
        const std::size_t column = row / tile;
        const int y = static_cast<int>(row % tile);
        const auto& level = light.levels[column];
        const surface s{m, light, level, map};
        sphere& out = spheres[column];
        for (int x = 0; x < set.tile; ++x) {
            const float coverage = area.coverage(x, y);
            // its seed: the same whatever core it runs on
            const std::size_t pixel = row * tile + static_cast<std::size_t>(x);
            vec3 a{0}, b{0}, c{0};
            lobe::sampled<vec3> truth{};
            if (coverage > 0) {
                const vec3 n = area.normal(x, y);
                a = single_scattering(s, n);
                b = fdez_aguera(s, n);
                c = multiple_scattering(s, n);
                truth = reference(s, n, irradiance(x, y), set.samples, mixed_bits(set.seed) ^ pixel);
            }
            out.single(x, y) = mix(background, a, coverage);
            out.fdez_aguera(x, y) = mix(background, b, coverage);
            out.multiple(x, y) = mix(background, c, coverage);
            out.reference(x, y) = mix(background, truth.value, coverage);
            out.fdez_aguera_off(x, y) = abs(out.fdez_aguera(x, y) - out.reference(x, y));
            out.multiple_off(x, y) = abs(out.multiple(x, y) - out.reference(x, y));
            const double error = mean_of_channels(truth.standard_error);
            squared_errors[column][pixel - column * tile * tile] = error * error;
        }
        progress.advance();
    });

    for (std::size_t i = 0; i < spheres.size(); ++i) measure(spheres[i], squared_errors[i], area);
    return spheres;
}
