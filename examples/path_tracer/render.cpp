#include "render.hpp"

#include "../common/random.hpp"
#include "../common/rows.hpp"
#include "lights.hpp"

#include <algorithm>
#include <cmath>

#include <glm/exponential.hpp>
#include <lobe/core/frame.hpp>

namespace {

class path_tracer {
public:
    path_tracer(const scene& described, strategy by) : s(described), rays(s), lights(s), directions(by) {}

    /// What arrives at `origin` from `direction`, by one path. At each point a light is sampled, and the path goes on
    /// where the surface sends it; where both may find the same light they share it (balance heuristic).
    vec3 radiance(vec3 origin, vec3 direction, sample_stream& uniform) const {
        vec3 sum{0}, throughput{1};
        float pdf = 0, inside2 = 1;  // of the direction, 0 if no light can be sampled there; index squared here
        vec3 from = origin;
        for (int bounce = 0;; ++bounce) {
            const auto end = rays.first_hit(origin, direction);
            const vec3 emitted = end ? s.materials[end->material].emission : s.environment(direction);
            if (emitted != vec3{0}) sum += throughput * emitted * share(from, direction, end, pdf);
            if (!end) return sum;

            const material& m = s.materials[end->material];
            const surface here = m.at(end->uv);
            const bool open = transmits(here), from_inside = lobe::dot(direction, end->facing) > 0;
            if (open && from_inside) throughput *= exp(-m.absorption * end->distance);
            const float turn = !open && from_inside ? -1.0f : 1.0f;  // opaque surfaces have two sides
            const lobe::frame<float> at{turn * end->normal, end->tangent};
            const vec3 facing = turn * end->facing;
            vec3 v = at.to_local(-direction);
            if (!open)
                v = lobe::bend_above_horizon(v, 1e-3f);
            else if ((v.z < 0) != from_inside)
                return sum;  // an interpolated normal shows the other side
            // on the side of the true surface where the interpolated normal has it
            const auto valid = [&](const vec3& l, const vec3& L) { return (l.z > 0) == (lobe::dot(L, facing) > 0); };

            if (directions != strategy::brdf && !discrete(here))
                sum += throughput * direct(here, at, v, *end, facing, valid, three(uniform));

            const auto next = sample(here, v, three(uniform));
            direction = lobe::normalize(at.to_world(next.l));
            if (next.weight == vec3{0} || !valid(next.l, direction)) return sum;
            throughput *= next.weight;
            pdf = next.pdf;
            from = end->point;
            origin = off_surface(end->point, facing, direction);
            if (open && from_inside != (next.l.z < 0)) inside2 *= next.l.z < 0 ? m.eta * m.eta : 1 / (m.eta * m.eta);
            if (bounce >= 4) {  // goes on by chance: that of its light
                const float most = std::max({throughput.x, throughput.y, throughput.z});
                const float survival = std::min(0.97f, most * inside2);
                if (!(uniform() < survival)) return sum;
                throughput /= survival;
            }
        }
    }

private:
    static vec3 three(sample_stream& uniform) {
        const float x = uniform(), y = uniform(), z = uniform();
        return {x, y, z};
    }

    /// Away from rounding, to the side where the ray goes.
    static vec3 off_surface(const vec3& p, const vec3& facing, const vec3& direction) {
        const float size = std::max({1.0f, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
        return p + facing * (lobe::dot(facing, direction) > 0 ? size * 0x1p-16f : -size * 0x1p-16f);
    }

    /// Of the light that a path meets by its own direction, the part that is not left to `direct`.
    float share(const vec3& from, const vec3& direction, const std::optional<hit>& end, float pdf) const {
        if (pdf == 0 || directions == strategy::brdf) return 1;
        if (directions == strategy::lights) return 0;
        return pdf / (pdf + lights.pdf(from, direction, end));
    }

    template <class Valid>
    vec3 direct(const surface& here, const lobe::frame<float>& at, const vec3& v, const hit& end, const vec3& facing,
                const Valid& valid, const vec3& u) const {
        const auto light = lights.sample(end.point, u);
        const vec3 l = at.to_local(light.direction);
        if (light.pdf == 0 || !valid(l, light.direction)) return vec3{0};
        const auto e = evaluate(here, v, l);
        if (e.f_cos == vec3{0}) return vec3{0};
        const vec3 origin = off_surface(end.point, facing, light.direction);
        if (rays.blocked(origin, light.direction, light.distance * (1 - 0x1p-12f))) return vec3{0};
        return e.f_cos * light.radiance / (directions == strategy::lights ? light.pdf : light.pdf + e.pdf);
    }

    const scene& s;
    ray_tracer rays;
    light_sampler lights;
    strategy directions;
};

}  // namespace

image render(const scene& s, const settings& set, void (*before_each)()) {
    const path_tracer paths{s, set.directions};
    const vec3 forward = lobe::normalize(s.view.target - s.view.eye);
    const vec3 right = lobe::normalize(lobe::cross(forward, vec3{0, 1, 0})), up = lobe::cross(right, forward);
    const auto half = static_cast<float>(set.height) / 2;
    image out{set.width, set.height};
    rows_of("paths", before_each)(set.height, [&](int y) {
        for (int x = 0; x < set.width; ++x) {
            sample_stream uniform{mixed_bits(set.seed) + static_cast<std::uint64_t>(y * set.width + x)};
            glm::dvec3 sum{0};
            for (int i = 0; i < set.samples; ++i) {
                uniform.next_sample();
                const float dx = (static_cast<float>(x) + uniform() - static_cast<float>(set.width) / 2) / half;
                const float dy = (half - static_cast<float>(y) - uniform()) / half;
                const vec3 direction = lobe::normalize(forward + s.view.field * (dx * right + dy * up));
                sum += glm::dvec3{paths.radiance(s.view.eye, direction, uniform)};
            }
            out(x, y) = vec3(sum / static_cast<double>(set.samples));
        }
    });
    return out;
}
