#pragma once

#include "scene.hpp"

#include <cstdint>

/// Where the directions to light come from.
enum class strategy { both, brdf, lights };

struct settings {
    int width, height, samples;  // a pixel
    std::uint64_t seed;
    strategy directions;
};

/// The radiance of each pixel. On all cores; `before_each` row may stop it with an exception.
image render(
    const scene&, const settings&, void (*before_each)() = [] {});
