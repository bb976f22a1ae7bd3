#include "lights.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <lobe/core/frame.hpp>

namespace {

/// The cone of directions in which a sphere is seen, from outside of it.
struct cone {
    vec3 towards;
    float distance2, height;  // height: 1 - cosine of its half angle

    cone(const sphere& ball, const vec3& from) : towards(ball.centre - from), distance2(lobe::dot(towards, towards)) {
        const float sine2 = ball.radius * ball.radius / distance2;
        height = sine2 < 1 ? sine2 / (1 + std::sqrt(1 - sine2)) : 0;
    }
    float pdf() const { return height > 0 ? 1 / (2 * lobe::pi<float>() * height) : 0; }
};

}  // namespace

light_sampler::light_sampler(const scene& described)
    : s(described), environment(s.environment), of_sphere(s.spheres.size()), of_triangle(s.triangles.size()) {
    const auto add = [&](bool is_sphere, std::size_t i, std::size_t material, float area) {
        const float power = mean_of_channels(s.materials[material].emission) * area;
        if (!(power > 0)) return;
        (is_sphere ? of_sphere : of_triangle)[i] = emitters.size();
        emitters.push_back({is_sphere, i});
        up_to.push_back((up_to.empty() ? 0 : up_to.back()) + power);
    };
    for (std::size_t i = 0; i < s.spheres.size(); ++i) {
        const float r = s.spheres[i].radius;
        add(true, i, s.spheres[i].material, 4 * lobe::pi<float>() * r * r);
    }
    for (std::size_t i = 0; i < s.triangles.size(); ++i)
        add(false, i, s.triangles[i].material, 2 * s.triangles[i].area());  // both sides
    of_environment = emitters.empty() ? 1.0f : 0.5f;
}

light_sample light_sampler::sample(const vec3& point, const vec3& u) const {
    if (u.z < of_environment) {
        const auto l = environment.sample({u.x, u.y});
        return {l.direction, std::numeric_limits<float>::infinity(), s.environment(l.direction),
                l.pdf * of_environment};
    }
    const float at = (u.z - of_environment) / (1 - of_environment) * up_to.back();
    const auto i = static_cast<std::size_t>(std::upper_bound(up_to.begin(), up_to.end() - 1, at) - up_to.begin());
    const emitter& e = emitters[i];
    if (e.is_sphere) {
        const sphere& ball = s.spheres[e.primitive];
        const cone seen{ball, point};
        const float up = u.x * seen.height, sine = std::sqrt(up * (2 - up)), D = std::sqrt(seen.distance2);
        const auto turn = lobe::sincos_2pi(u.y);
        const float miss2 = seen.distance2 * sine * sine;  // of the ray's distance from the centre
        const float distance = D * (1 - up) - std::sqrt(std::max(0.0f, ball.radius * ball.radius - miss2));
        const vec3 direction =
            lobe::frame{lobe::normalize(seen.towards)}.to_world({sine * turn.cos, sine * turn.sin, 1 - up});
        return {direction, distance, s.materials[ball.material].emission, seen.pdf() * probability(i)};
    }
    const triangle& face = s.triangles[e.primitive];
    const float root = std::sqrt(u.x), b1 = root * (1 - u.y), b2 = root * u.y;
    const vec3 towards = face.corners[0] * (1 - root) + face.corners[1] * b1 + face.corners[2] * b2 - point;
    const float d2 = lobe::dot(towards, towards), d = std::sqrt(d2);
    const vec3 direction = towards / d;
    const float seen = std::abs(lobe::dot(face.across(), direction)) / 2;  // its area times the cosine
    return {direction, d, s.materials[face.material].emission, seen > 0 ? d2 / seen * probability(i) : 0};
}

float light_sampler::pdf(const vec3& point, const vec3& direction, const std::optional<hit>& end) const {
    if (!end) return environment.pdf(direction) * of_environment;
    const std::size_t i = end->primitive;
    if (end->of_sphere) return cone(s.spheres[i], point).pdf() * probability(of_sphere[i]);
    const float seen = std::abs(lobe::dot(s.triangles[i].across(), direction)) / 2;
    return end->distance * end->distance / seen * probability(of_triangle[i]);
}
