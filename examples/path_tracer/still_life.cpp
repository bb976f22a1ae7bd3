#include "scene.hpp"

#include <cmath>

std::size_t scene::add(const material& m) {
    materials.push_back(m);
    return materials.size() - 1;
}

void scene::add_rectangle(const vec3& corner, const vec3& x, const vec3& y, std::size_t material) {
    const vec3 n = lobe::normalize(lobe::cross(x, y)), far = corner + x + y;
    triangles.push_back({{corner, corner + x, far}, {n, n, n}, {{{0, 0}, {1, 0}, {1, 1}}}, material});
    triangles.push_back({{corner, far, corner + y}, {n, n, n}, {{{0, 0}, {1, 1}, {0, 1}}}, material});
}

scene still_life(const std::filesystem::path& model, lobe::latlong<float> environment) {
    namespace metals = lobe::materials;
    scene s{{}, {}, {}, std::move(environment), {{-6.4f, 2.1f, 0}, {0, 0.62f, 0}, 0.31f}};
    add_obj(s, model, {0, 0, 0}, 1.7f);

    const auto checkers = [](const glm::vec2& uv) -> surface {
        const auto field = [](float x) { return static_cast<int>(std::floor(24 * x)); };
        const bool dark = ((field(uv.x) ^ field(uv.y)) & 1) != 0;
        return metallic_roughness(dark ? vec3{0.10f, 0.11f, 0.13f} : vec3{0.55f, 0.53f, 0.50f}, 0, dark ? 0.25f : 0.5f);
    };
    s.add_rectangle({-12, 0, -12}, {0, 0, 24}, {24, 0, 0}, s.add({checkers}));

    const auto ball = [&](float x, float z, float radius, const material& m) {
        s.spheres.push_back({{x, radius, z}, radius, s.add(m)});
    };
    ball(-0.2f, -1.75f, 0.7f, uniform(metal(metals::gold<float>(), 0.35f)));
    ball(-1.5f, -0.85f, 0.45f, glass(1.5f, 0, vec3{0}));
    ball(-1.5f, 0.85f, 0.45f, glass(1.5f, 0.45f, {1.6f, 0.3f, 0.9f}));
    ball(-0.2f, 1.75f, 0.7f, uniform(brushed_metal(metals::copper<float>(), {0.4f, 0.06f})));
    ball(1.6f, -1.3f, 0.75f, uniform(diffuse({0.72f, 0.30f, 0.22f}, 0.8f)));
    ball(1.6f, 1.3f, 0.75f, uniform(metallic_roughness({0.05f, 0.22f, 0.55f}, 0, 0.15f)));

    material lamp = uniform(diffuse(vec3{0}, 0));
    lamp.emission = {9.0f, 7.4f, 5.4f};
    s.add_rectangle({-0.6f, 3.4f, -3.2f}, {1.4f, 0, 0}, {0, 0.5f, 1.2f}, s.add(lamp));
    lamp.emission = {34.0f, 17.0f, 6.0f};
    ball(-2.35f, 0.05f, 0.09f, lamp);
    return s;
}
