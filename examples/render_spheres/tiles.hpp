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

/// The normal under the middle of the pixel of a tile; at the rim, where the middle may miss, a grazing one.
/// Nothing where the sphere does not cover the pixel.
struct disc {
    float radius, centre;

    explicit disc(int tile);
    float coverage(int x, int y) const;  // the part of the pixel that the sphere covers
    vec3 normal(int x, int y) const;

private:
    float distance(int x, int y) const;
};

/// The camera is far away and looks along +x, at the middle of the map; y is up, z is on its right.
inline const vec3 V{-1, 0, 0};

/// Pictures of `columns` spheres, on both cores, and what the ways miss of the truth.
std::vector<sphere> shaded_spheres(const std::string& name, std::size_t columns, const vec3& background,
                                   const settings&, const std::function<shaded(const point&)>&);
