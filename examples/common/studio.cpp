#include "environment.hpp"
#include "image.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <glm/common.hpp>
#include <lobe/lobe.hpp>

namespace {

struct softbox {
    vec3 centre;                    // as seen from the spheres
    float half_width, half_height;  // tangents of its half angles
    vec3 radiance;
};

// 1 well inside the box, 0 outside, a soft edge between.
float inside(const softbox& box, const vec3& direction) {
    const vec3 axis = lobe::normalize(box.centre);
    const float depth = lobe::dot(direction, axis);
    if (depth <= 0) return 0;
    const vec3 right = lobe::normalize(lobe::cross(axis, vec3{0.01f, 1, 0})), up = lobe::cross(right, axis);
    const float x = std::abs(lobe::dot(direction, right)) / depth / box.half_width;
    const float y = std::abs(lobe::dot(direction, up)) / depth / box.half_height;
    const float edge = std::clamp((1.04f - std::max(x, y)) / 0.08f, 0.0f, 1.0f);
    return edge * edge * (3 - 2 * edge);
}

vec3 studio_radiance(const vec3& direction) {
    static const softbox boxes[] = {
        // the camera looks along +x; +z is on its right
        {{-0.75f, 0.75f, -0.80f}, 0.38f, 0.38f, {42.0f, 39.0f, 35.0f}},  // key: warm, large, behind the camera
        {{-0.30f, 0.20f, 1.00f}, 0.16f, 0.70f, {7.0f, 9.5f, 13.0f}},     // fill: a cool strip on the right
        {{0.85f, 0.35f, -0.75f}, 0.12f, 0.55f, {60.0f, 46.0f, 30.0f}},   // rim: a narrow warm strip from behind
        {{0.10f, 1.00f, 0.10f}, 0.45f, 0.25f, {14.0f, 14.0f, 14.0f}},    // top
        {{-1.00f, -0.25f, 0.55f}, 0.10f, 0.10f, {30.0f, 25.0f, 19.0f}},  // a small warm one, low on the right
    };
    const float height = direction.y;
    vec3 radiance = height > 0 ? mix(vec3{0.30f, 0.31f, 0.34f}, vec3{0.10f, 0.11f, 0.14f}, height)    // wall to ceiling
                               : mix(vec3{0.30f, 0.31f, 0.34f}, vec3{0.55f, 0.47f, 0.40f}, -height);  // wall to floor
    for (const softbox& box : boxes) radiance = mix(radiance, box.radiance, inside(box, direction));
    return radiance;
}

}  // namespace

lobe::latlong<float> studio_light() {
    constexpr int width = 512, height = 256, across = 3;  // across x across samples a pixel
    image map{width, height};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            vec3 sum{0};
            for (int i = 0; i < across * across; ++i) {
                const float u = (static_cast<float>(x) + (static_cast<float>(i % across) + 0.5f) / across) / width;
                const float v = (static_cast<float>(y) + (static_cast<float>(i / across) + 0.5f) / across) / height;
                sum += studio_radiance(lobe::latlong_direction(glm::vec2{u, v}));
            }
            map(x, y) = sum / static_cast<float>(across * across);
        }
    return {width, height, std::move(map.pixels)};
}

lobe::latlong<float> uniform_light() { return {16, 8, std::vector<vec3>(16 * 8, vec3{1})}; }
