#include "bake.hpp"

#include "image.hpp"
#include "progress.hpp"

#include <algorithm>
#include <cstdint>
#include <iomanip>
#include <sstream>
#include <string>
#include <utility>

#include <lobe/lobe.hpp>
#include <tbb/parallel_for.h>

namespace {

/// A lat-long map of `at(direction)`, its rows shared out among the cores.
template <class Function>
lobe::latlong<float> tabulated(int width, int height, const std::string& name, const Function& at) {
    image map{width, height};
    step progress(name + ", " + std::to_string(width) + " x " + std::to_string(height),
                  static_cast<std::size_t>(height));
    tbb::parallel_for(0, height, [&](int y) {
        for (int x = 0; x < width; ++x) {
            const glm::vec2 uv{(static_cast<float>(x) + 0.5f) / static_cast<float>(width),
                               (static_cast<float>(y) + 0.5f) / static_cast<float>(height)};
            map(x, y) = at(lobe::latlong_direction(uv));
        }
        progress.advance();
    });
    return {width, height, std::move(map.pixels)};
}

/// Fine enough for bilinear look-ups in a lobe of this width, and no finer than the map itself.
int prefiltered_width(lobe::alpha<float> a, int environment_width) {
    const int finest = std::min(environment_width, 1024);
    int width = std::min(128, finest);
    while (2 * width <= finest && static_cast<float>(width) * a.value() < 12) width *= 2;
    return width;
}

}  // namespace

float mean_over_directions(const lobe::latlong<float>& map) {
    double sum = 0, solid_angle = 0;
    for (int y = 0; y < map.height; ++y) {
        const double texel = lobe::latlong_texel_solid_angle<double>(y, map.width, map.height);
        for (int x = 0; x < map.width; ++x) sum += texel * mean_of_channels(map.at(x, y));
        solid_angle += texel * map.width;
    }
    return static_cast<float>(sum / solid_angle);
}

std::size_t halvings(const lobe::latlong_pyramid<float>& pyramid, float angle) {
    std::size_t level = 0;
    while (level + 1 < pyramid.size() &&
           lobe::pi<float>() / static_cast<float>(pyramid.level(level + 1).height) <= angle)
        ++level;
    return level;
}

baked_light bake(lobe::latlong<float> environment, const std::vector<float>& roughnesses) {
    lobe::latlong_pyramid<float> pyramid{std::move(environment)};
    const auto& coarse = pyramid.level(halvings(pyramid, diffuse_texel));
    auto irradiance = tabulated(64, 32, "irradiance", [&](const vec3& n) { return lobe::irradiance(coarse, n); });

    std::vector<baked_light::level> levels;
    for (const float roughness : roughnesses) {
        const auto a = lobe::alpha<float>::from_roughness(roughness);
        const int width = prefiltered_width(a, pyramid.level(0).width);
        const auto count = static_cast<std::uint32_t>(std::clamp((1 << 26) / (width * width), 128, 1024));
        std::ostringstream name;
        name << "radiance for roughness " << std::fixed << std::setprecision(2) << roughness;
        levels.push_back({roughness, a, tabulated(width, width / 2, name.str(), [&](const vec3& r) {
                              return lobe::prefiltered_radiance(pyramid, r, a, count);
                          })});
    }
    return {std::move(pyramid), std::move(irradiance), std::move(levels)};
}
