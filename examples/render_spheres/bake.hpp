#pragma once

#include <vector>

#include <lobe/ibl/cube.hpp>
#include <lobe/ibl/latlong.hpp>
#include <lobe/width/alpha.hpp>

/// An environment and what image-based lighting keeps of it.
struct baked_light {
    struct level {
        float roughness;
        lobe::alpha<float> alpha;
        lobe::cube<float> radiance;  // prefiltered with V = N = R
    };
    lobe::latlong_pyramid<float> pyramid;  // level(0) is the environment itself
    lobe::latlong<float> irradiance;       // divided by pi
    std::vector<level> levels;             // one for exactly each roughness
};

/// The mean radiance of a map over the sphere of directions, and over r, g and b.
float mean_over_directions(const lobe::latlong<float>&);

/// How often the environment can be halved until its texels would be wider than `angle`.
std::size_t halvings(const lobe::latlong_pyramid<float>&, float angle);

constexpr float diffuse_texel = 0.025f;  // 256 x 128: diffuse light has no details that these would miss

baked_light bake(lobe::latlong<float> environment, const std::vector<float>& roughnesses);
