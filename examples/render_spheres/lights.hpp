#pragma once

#include "image.hpp"

#include <cstddef>
#include <vector>

#include <lobe/ibl/latlong.hpp>

/// The lights of a lat-long map, as directions to sample: what is brighter than 50 times its mean, in proportion to the
/// excess.
class lights {
public:
    explicit lights(const lobe::latlong<float>& map);

    struct light {
        vec3 direction;
        float pdf;  // 1/sr
    };
    bool empty() const { return texels.empty(); }
    light sample(float u, float x, float y) const;  // numbers in [0,1): which texel, and where in it
    float pdf(const vec3& direction) const;         // 0 where there is no light

private:
    int width, height;
    std::vector<std::size_t> texels;  // that are lights
    std::vector<float> cumulative;    // their part of the whole, summed up
    std::vector<float> density;       // of every texel, in the unit square
};
