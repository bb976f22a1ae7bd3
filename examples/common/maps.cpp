#include "maps.hpp"

#include "image.hpp"

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
