#pragma once

#include "../common/image.hpp"
#include "bake.hpp"

#include <cstdint>
#include <string>
#include <vector>

/// A metal has no diffuse albedo; a dielectric has the one of the body under its surface.
struct material {
    std::string name;
    vec3 f0;
    vec3 albedo;
};

constexpr int batches = 16;  // of samples, independent of each other: their spread is the noise

constexpr int whole_batches(int samples) {
    return (samples / batches + (samples % batches != 0 || samples == 0)) * batches;
}

struct settings {
    int tile;     // pixels across the picture of one sphere
    int samples;  // random walks a pixel, in whole batches
    std::uint64_t seed;
};

/// Errors against the reference over the pixels of a sphere. Energy is the mean of r, g and b.
struct error_of_energy {
    double mean;     // sum of the differences / sum of the reference; signed
    double largest;  // largest difference of a pixel / mean of the reference
};

/// One material at one roughness: its pictures (radiance), by each way to compute them and in truth, what the last two
/// ways miss of that, and how much each way misses.
struct sphere {
    std::vector<image> ways;
    image reference;
    std::vector<image> off;
    std::vector<error_of_energy> errors;
    double noise;  // standard error of the reference, rms over the pixels / mean of the reference
};

/// One sphere for each level of the light.
std::vector<sphere> render(const material&, const baked_light&, const vec3& background, const settings&);
