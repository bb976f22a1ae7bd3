#pragma once

#include "surfaces.hpp"

#include <array>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include <lobe/ibl/latlong.hpp>

struct sphere {
    vec3 centre;
    float radius;
    std::size_t material;
};

struct triangle {
    std::array<vec3, 3> corners, normals;  // normals: unit, of the corners
    std::array<glm::vec2, 3> uv;
    std::size_t material;

    vec3 across() const { return lobe::cross(corners[1] - corners[0], corners[2] - corners[0]); }
    float area() const { return lobe::length(across()) / 2; }
};

struct camera {
    vec3 eye, target;
    float field;  // tangent of half the angle across the picture's height
};

struct scene {
    std::vector<material> materials;
    std::vector<sphere> spheres;
    std::vector<triangle> triangles;
    lobe::latlong<float> environment;
    camera view;

    std::size_t add(const material&);
    void add_rectangle(const vec3& corner, const vec3& x, const vec3& y, std::size_t material);
};

/// The triangles and materials of an OBJ file and its MTL: Kd or map_Kd, Pr and Pm (roughness, metallic), Ke; illum 4,
/// 6, 7 and 9 are glass of index Ni, of whose light Tf is left after a length of 1. Scaled to `size` across, put on
/// `foot`. Throws std::runtime_error, "FILE: problem".
void add_obj(scene&, const std::filesystem::path& file, const vec3& foot, float size);

/// A model among balls of lobe's materials, on a checkered floor, under a lamp and an environment.
scene still_life(const std::filesystem::path& model, lobe::latlong<float> environment);

/// Where a ray ends.
struct hit {
    float distance;
    vec3 point, normal, facing;  // facing: the true normal, of which `normal` is the interpolated one; both outwards
    vec3 tangent;
    glm::vec2 uv;
    std::size_t material;
    bool of_sphere;
    std::size_t primitive;  // sphere or triangle
};

/// Finds where rays end, by Embree. Keeps a reference to the scene.
class ray_tracer {
public:
    explicit ray_tracer(const scene&);
    ~ray_tracer();
    std::optional<hit> first_hit(const vec3& origin, const vec3& direction) const;
    bool blocked(const vec3& origin, const vec3& direction, float distance) const;

private:
    struct embree;
    const scene& s;
    std::unique_ptr<embree> rays;
};
