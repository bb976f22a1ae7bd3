#include "glass.hpp"

#include "../common/random.hpp"
#include "reference_map.hpp"
#include "tiles.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include <glm/exponential.hpp>
#include <lobe/lobe.hpp>

namespace {

using interface_of = lobe::rough_dielectric<lobe::ggx<float>, lobe::smith_joint>;
using compensated = lobe::compensated_dielectric<lobe::ggx<float>, lobe::smith_joint, lobe::radiance_transport>;

/// What the light does at one interface, asked for a path through it: its next direction and weight, and for lights
/// f |cos| and the density that multiple importance sampling compares.
template <class B>
struct by_bsdf {
    B bsdf;

    lobe::direction_sample<float, float> next(const vec3& v, sample_stream& uniform) const {
        const float x = uniform(), y = uniform(), z = uniform();
        return bsdf.sample(v, vec3{x, y, z});
    }
    lobe::evaluation<float, float> evaluate(const vec3& v, const vec3& l) const { return bsdf.evaluate(v, l); }
};

/// The random walk. Where it met one facet its density is f |cos| of single scattering, for importance transport, so
/// these walks find lights by sampling them, too; walks of more facets have none.
struct by_walk {
    lobe::interface_walk<lobe::ggx<float>> walk;
    lobe::rough_dielectric<lobe::ggx<float>, lobe::smith_joint> radiance;
    lobe::rough_dielectric<lobe::ggx<float>, lobe::smith_joint, lobe::importance_transport> density;

    lobe::direction_sample<float, float> next(const vec3& v, sample_stream& uniform) const {
        const auto path = walk.sample(v, uniform);
        const float n = v.z < 0 ? 1 / radiance.relative_index() : radiance.relative_index();
        const bool crossed = (path.l.z < 0) != (v.z < 0);
        return {path.l, path.weight * (crossed ? 1 / (n * n) : 1), path.order == 1 ? density.f_cos(v, path.l) : 0};
    }
    lobe::evaluation<float, float> evaluate(const vec3& v, const vec3& l) const {
        return {radiance.f_cos(v, l), density.f_cos(v, l)};
    }
};

/// Radiance that leaves a unit sphere at its point n towards V, by one path: at each interface the light is sampled,
/// where it is outside, and the path goes on to where it meets the sphere from inside, or out to the map.
/// The glass absorbs on the way (Beer's law). A long path goes on by chance: that of its light, which inside is eta^2
/// times what its radiance says.
template <class Interface>
vec3 one_path(const Interface& at_interface, const glass& g, const reference_map& map, vec3 n, sample_stream& uniform) {
    const vec3 absorbed = -log(g.left) / 2.0f;
    vec3 radiance{0}, throughput{1}, V_here = V;
    for (int bounce = 0; bounce < 4096; ++bounce) {
        const lobe::frame<float> at{n};
        const vec3 v = at.to_local(V_here);
        if (map.lights) {
            const float x = uniform(), y = uniform();
            const auto light = map.lights->sample({x, y});
            const vec3 l = at.to_local(light.direction);
            if (l.z > 0) {
                const auto e = at_interface.evaluate(v, l);
                radiance += throughput * map.radiance(light.direction) * (e.f_cos / (light.pdf + e.pdf));
            }
        }
        const auto s = at_interface.next(v, uniform);
        throughput *= s.weight;
        if (throughput == vec3{0}) break;
        const vec3 L = at.to_world(s.l);
        if (s.l.z > 0) {
            const float light_pdf = map.lights && s.pdf > 0 ? map.lights->pdf(L) : 0;
            const float share = light_pdf > 0 ? 1 - light_pdf / (light_pdf + s.pdf) : 1;
            return radiance + share * throughput * map.radiance(L);
        }
        const float length = -2 * lobe::dot(n, L);
        n = lobe::normalize(n + length * L);
        V_here = -L;
        throughput *= exp(-absorbed * length);
        if (bounce > 8) {
            const float survival = std::min(1.0f, g.eta * g.eta * mean_of_channels(throughput));
            if (!(uniform() < survival)) break;
            throughput /= survival;
        }
    }
    return radiance;
}

}  // namespace

std::vector<sphere> render(const glass& g, const baked_light& light, const vec3& background, const settings& set) {
    struct column {
        interface_of first;
        std::unique_ptr<lobe::interface_energy<float>> energy;
        by_walk walk;
    };
    std::vector<column> columns;
    for (const auto& level : light.levels) {
        const lobe::ggx normals{level.alpha};
        const interface_of first{normals, lobe::smith_joint{}, g.eta};
        columns.push_back({first,
                           std::make_unique<lobe::interface_energy<float>>(first),
                           {lobe::interface_walk{normals, g.eta}, first, {normals, lobe::smith_joint{}, g.eta, {}}}});
    }

    const reference_map map(light.pyramid.level(0));
    const lobe::sample_counts counts{static_cast<std::uint32_t>(set.samples) / batches, batches};
    return shaded_spheres("spheres of " + g.name, columns.size(), 2, background, set, [&](const point& p) {
        const column& here = columns[p.column];
        const auto mean = [&](const auto& at_interface) {
            sample_stream uniform{0};
            return lobe::sample_mean(counts, [&](std::uint32_t batch, std::uint32_t i) {
                if (i == 0) uniform = sample_stream{mixed_bits(p.seed) + batch};
                uniform.next_sample();
                return one_path(at_interface, g, map, p.normal, uniform);
            });
        };
        return shaded{{mean(by_bsdf<interface_of>{here.first}).value,
                       mean(by_bsdf<compensated>{compensated{here.first, *here.energy}}).value},
                      mean(here.walk)};
    });
}
