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

baked_light bake(lobe::latlong<float> environment, const std::vector<float>& roughnesses);
