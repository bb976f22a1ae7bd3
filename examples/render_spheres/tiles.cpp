#include "tiles.hpp"

#include "../common/progress.hpp"
#include "../common/random.hpp"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <lobe/core/vector.hpp>
#include <tbb/parallel_for.h>

namespace {

/// Fills in the errors of a sphere whose pictures are complete; `squared_error` is that of each pixel of the reference.
void measure(sphere& s, const std::vector<double>& squared_error, const disc& area) {
    double pixels = 0, energy = 0, variance = 0;
    for (int y = 0; y < s.reference.height; ++y)
        for (int x = 0; x < s.reference.width; ++x) {
            if (area.coverage(x, y) < 1) continue;
            const double truth = mean_of_channels(s.reference(x, y));
            for (std::size_t way = 0; way < s.ways.size(); ++way) {
                const double off = mean_of_channels(s.ways[way](x, y)) - truth;
                s.errors[way].mean += off;
                s.errors[way].largest = std::max(s.errors[way].largest, std::abs(off));
            }
            energy += truth;
            variance += squared_error[static_cast<std::size_t>(y * s.reference.width + x)];
            ++pixels;
        }
    const double mean = energy / pixels;
    for (error_of_energy& error : s.errors) error = {error.mean / energy, error.largest / mean};
    s.noise = std::sqrt(variance / pixels) / mean;
}

}  // namespace

disc::disc(int tile) : radius(0.46f * static_cast<float>(tile)), centre(0.5f * static_cast<float>(tile) - 0.5f) {}

float disc::distance(int x, int y) const {
    return std::hypot(static_cast<float>(x) - centre, static_cast<float>(y) - centre);
}

float disc::coverage(int x, int y) const { return std::clamp(radius - distance(x, y) + 0.5f, 0.0f, 1.0f); }

vec3 disc::normal(int x, int y) const {
    const float scale = 1 / std::max(radius, 1.0001f * distance(x, y));
    const float right = (static_cast<float>(x) - centre) * scale, up = (centre - static_cast<float>(y)) * scale;
    return lobe::normalize(vec3{-std::sqrt(1 - right * right - up * up), up, right});
}

std::vector<sphere> shaded_spheres(const std::string& name, std::size_t columns, std::size_t ways,
                                   const vec3& background, const settings& set,
                                   const std::function<shaded(const point&)>& shade) {
    const disc area(set.tile);
    const auto tile = static_cast<std::size_t>(set.tile);
    const image blank{set.tile, set.tile};
    std::vector<sphere> spheres(columns);
    for (sphere& s : spheres) {
        s.ways.assign(ways, blank);
        s.reference = blank;
        s.off.assign(2, blank);
        s.errors.assign(ways, {});
    }
    std::vector<std::vector<double>> squared_errors(columns, std::vector<double>(tile * tile));
    step progress(name, columns * tile);

    tbb::parallel_for(std::size_t{0}, columns * tile, [&](std::size_t row) {
        const std::size_t column = row / tile;
        const int y = static_cast<int>(row % tile);
        sphere& out = spheres[column];
        for (int x = 0; x < set.tile; ++x) {
            const float coverage = area.coverage(x, y);
            const std::size_t pixel = row * tile + static_cast<std::size_t>(x);
            shaded s{std::vector<vec3>(ways), {}};
            if (coverage > 0) s = shade({column, x, y, area.normal(x, y), mixed_bits(set.seed) ^ pixel});
            out.reference(x, y) = mix(background, s.truth.value, coverage);
            for (std::size_t way = 0; way < ways; ++way) out.ways[way](x, y) = mix(background, s.ways[way], coverage);
            for (std::size_t k = 0; k < out.off.size(); ++k)
                out.off[k](x, y) = abs(out.ways[ways - out.off.size() + k](x, y) - out.reference(x, y));
            const double error = mean_of_channels(s.truth.standard_error);
            squared_errors[column][pixel - column * tile * tile] = error * error;
        }
        progress.advance();
    });

    for (std::size_t i = 0; i < columns; ++i) measure(spheres[i], squared_errors[i], area);
    return spheres;
}
