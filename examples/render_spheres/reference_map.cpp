#include "reference_map.hpp"

#include "../common/image.hpp"
#include "../common/maps.hpp"

#include <algorithm>
#include <utility>

namespace {

/// Samples what is brighter than twice the map's mean: paths find the rest, and a uniform light has no noise.
decltype(reference_map::lights) lights_of(const lobe::latlong<float>& map) {
    const float floor = 2 * mean_over_directions(map);
    image excess{map.width, map.height};
    bool any = false;
    for (std::size_t i = 0; i < excess.pixels.size(); ++i) {
        excess.pixels[i] = vec3{std::max(mean_of_channels(map.pixels[i]) - floor, 0.0f)};
        any |= excess.pixels[i].x > 0;
    }
    if (!any) return {};
    return lobe::environment_sampler{lobe::latlong<float>{map.width, map.height, std::move(excess.pixels)}};
}

}  // namespace

reference_map::reference_map(const lobe::latlong<float>& environment)
    : radiance(environment), lights(lights_of(environment)) {}
