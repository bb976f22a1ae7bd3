#pragma once

#include "render.hpp"

#include <functional>

#include <lobe/sampling/sample_mean.hpp>

/// What one point of a sphere looks like: by each of the ways to compute it, and in truth.
struct shaded {
    std::vector<vec3> ways;
    lobe::sampled<vec3> truth;
};

/// The point of a sphere under the pixel x, y, its normal, and a seed: the same whatever core it runs on.
struct point {
    std::size_t column;
    int x, y;
    vec3 normal;
    std::uint64_t seed;
};

/// What the sphere of a tile covers, and its normals.
struct disc {
    float radius, centre;

    explicit disc(int tile);
    float coverage(int x, int y) const;  // the part of the pixel that the sphere covers
    /// Under the middle of the pixel; at the rim, where the middle may miss, a grazing one.
    vec3 normal(int x, int y) const;

private:
    float distance(int x, int y) const;
};

/// The camera is far away and looks along +x, at the middle of the map; y is up, z is on its right.
inline const vec3 V{-1, 0, 0};

/// Pictures of `columns` spheres, each pixel by so many `ways` and in truth, and what the ways miss. On all cores.
std::vector<sphere> shaded_spheres(const std::string& name, std::size_t columns, std::size_t ways,
                                   const vec3& background, const settings&, const std::function<shaded(const point&)>&);
