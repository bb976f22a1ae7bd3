#include "lights.hpp"

#include "bake.hpp"

#include <algorithm>
#include <cmath>

#include <lobe/lobe.hpp>

namespace {

/// The brightest texel that a bilinear look-up within this one reads.
float brightness(const lobe::latlong<float>& map, int x, int y) {
    float brightest = 0;
    for (int j = std::max(y - 1, 0); j <= std::min(y + 1, map.height - 1); ++j)
        for (int i = -1; i <= 1; ++i)
            brightest = std::max(brightest, mean_of_channels(map.at((x + i + map.width) % map.width, j)));
    return brightest;
}

/// Densities in the unit square over this are densities in solid angle.
float solid_angle_of_square(const vec3& direction) {
    return 2 * lobe::pi<float>() * lobe::pi<float>() * std::hypot(direction.x, direction.z);
}

}  // namespace

lights::lights(const lobe::latlong<float>& map) : width(map.width), height(map.height), density(map.pixels.size()) {
    const float threshold = 50 * mean_over_directions(map);
    double total = 0;
    for (std::size_t i = 0; i < density.size(); ++i) {
        const int x = static_cast<int>(i) % width, y = static_cast<int>(i) / width;
        const float excess = brightness(map, x, y) - threshold;
        if (excess <= 0) continue;
        density[i] = excess * lobe::latlong_texel_solid_angle<float>(y, width, height);
        total += density[i];
        texels.push_back(i);
    }
    double sum = 0;
    for (const std::size_t i : texels) {
        sum += density[i];
        cumulative.push_back(static_cast<float>(sum / total));
        density[i] *= static_cast<float>(static_cast<double>(density.size()) / total);
    }
}

lights::light lights::sample(float u, float x, float y) const {
    const auto found = std::upper_bound(cumulative.begin(), cumulative.end() - 1, u);
    const std::size_t i = texels[static_cast<std::size_t>(found - cumulative.begin())];
    const auto column = static_cast<float>(static_cast<int>(i) % width),
               row = static_cast<float>(static_cast<int>(i) / width);
    const vec3 direction = lobe::latlong_direction(
        glm::vec2{(column + x) / static_cast<float>(width), (row + y) / static_cast<float>(height)});
    return {direction, density[i] / solid_angle_of_square(direction)};
}

float lights::pdf(const vec3& direction) const {
    const glm::vec2 uv = lobe::latlong_uv(direction);
    const int column = std::min(static_cast<int>(uv.x * static_cast<float>(width)), width - 1);
    const int row = std::min(static_cast<int>(uv.y * static_cast<float>(height)), height - 1);
    return density[static_cast<std::size_t>(row * width + column)] / solid_angle_of_square(direction);
}
