#include "bake.hpp"

#include "../common/image.hpp"
#include "../common/maps.hpp"
#include "../common/rows.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <iomanip>
#include <sstream>
#include <string>
#include <utility>

#include <lobe/lobe.hpp>

namespace {

/// Fine enough for bilinear look-ups in a lobe of this width, and no finer than the environment itself.
int prefiltered_size(lobe::alpha<float> a, int finest) {
    int size = std::min(32, finest);
    while (2 * size <= std::min(finest, 256) && static_cast<float>(size) * a.value() < 3) size *= 2;
    return size;
}

}  // namespace

baked_light bake(lobe::latlong<float> environment, const std::vector<float>& roughnesses) {
    lobe::latlong_pyramid<float> pyramid{std::move(environment)};
    const auto& coarse = pyramid.level(halvings(pyramid, diffuse_texel));
    auto irradiance = lobe::make_latlong<float>([&](const vec3& n) { return lobe::irradiance(coarse, n); }, 64, 32, 1,
                                                rows_of("irradiance"));

    // twice as many texels as a lat-long map has along a quarter of the equator: edges of lights stay sharp in mirrors
    const int height = pyramid.level(0).height;
    const auto finest = static_cast<int>(std::bit_ceil(static_cast<unsigned>(std::clamp(height, 1, 512))));
    const lobe::cube_pyramid<float> cubes{lobe::make_cube<float>(pyramid.level(0), finest, 2, rows_of("cube"))};

    std::vector<baked_light::level> levels;
    for (const float roughness : roughnesses) {
        const auto a = lobe::alpha<float>::from_roughness(roughness);
        const int size = prefiltered_size(a, finest);
        const lobe::prefilter_samples<float> samples{
            cubes, a, static_cast<std::uint32_t>(std::clamp((1 << 22) / (size * size), 128, 1024))};
        std::ostringstream name;
        name << "radiance for roughness " << std::fixed << std::setprecision(2) << roughness;
        levels.push_back({roughness, a,
                          lobe::make_cube<float>([&](const vec3& r) { return samples(cubes, r); }, size, 1,
                                                 rows_of(name.str() + ", " + std::to_string(size)))});
    }
    return {std::move(pyramid), std::move(irradiance), std::move(levels)};
}
