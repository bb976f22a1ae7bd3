#pragma once

#include <cstddef>
#include <vector>

#include <glm/vec3.hpp>

using glm::vec3;

/// Pixels in rows from the top: linear radiance, or colours from 0 to 1 that a screen shows.
struct image {
    int width, height;
    std::vector<vec3> pixels = std::vector<vec3>(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));

    vec3& operator()(int x, int y) { return pixels[index(x, y)]; }
    const vec3& operator()(int x, int y) const { return pixels[index(x, y)]; }

private:
    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
    }
};

inline float mean_of_channels(const vec3& c) { return (c.x + c.y + c.z) / 3; }

inline void paste(image& page, const image& tile, int left, int top) {
    for (int y = 0; y < tile.height; ++y)
        for (int x = 0; x < tile.width; ++x) page(left + x, top + y) = tile(x, y);
}
