// An environment as a lat-long image, and its pyramid.
#pragma once

#include <lobe/ibl/directions.hpp>

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <utility>
#include <vector>

namespace lobe {

/// Radiance on a lat-long image, row by row from the zenith, linear rgb. Called with a unit direction it interpolates
/// bilinearly, around the seam and up to the poles. Scalar types only.
template <scalar T>
struct latlong {
    int width, height;
    std::vector<vec3<T>> pixels;

    /// Precondition: width * height pixels, at least one.
    latlong(int columns, int rows, std::vector<vec3<T>> radiance) : width(columns), height(rows), pixels(std::move(radiance)) {
        assert(width > 0 && height > 0);
        assert(pixels.size() == static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    }

    const vec3<T>& at(int column, int row) const {
        return pixels[static_cast<std::size_t>(row) * static_cast<std::size_t>(width) + static_cast<std::size_t>(column)];
    }

    vec3<T> operator()(const vec3<T>& direction) const {
        using std::floor;
        const vec2<T> uv = latlong_uv(direction);
        const T x = uv.x * T(width) - T(0.5), y = uv.y * T(height) - T(0.5);
        const T x0 = floor(x), y0 = floor(y);
        const int left = (static_cast<int>(x0) + width) % width, right = (left + 1) % width;
        const int top = std::clamp(static_cast<int>(y0), 0, height - 1), bottom = std::min(static_cast<int>(y0) + 1, height - 1);
        const T tx = x - x0, ty = y - y0;
        return (at(left, top) * (T(1) - tx) + at(right, top) * tx) * (T(1) - ty) +
               (at(left, bottom) * (T(1) - tx) + at(right, bottom) * tx) * ty;
    }
};

/// A lat-long image and its halvings, each texel the mean over its solid angle. Called with a direction and a solid angle it
/// answers with about the mean radiance over that solid angle: what filtered importance sampling asks for.
template <scalar T>
class latlong_pyramid {
public:
    explicit latlong_pyramid(latlong<T> base) {
        levels.push_back(std::move(base));
        while (levels.back().width % 2 == 0 && levels.back().height % 2 == 0 && levels.back().height > 2)
            levels.push_back(halved(levels.back()));
    }

    vec3<T> operator()(const vec3<T>& direction) const { return levels.front()(direction); }

    /// Level of detail 1/2 log2(solid_angle / texel), texel = (pi/height)^2, interpolated between levels.
    vec3<T> operator()(const vec3<T>& direction, const T& solid_angle) const {
        using std::log2;
        const T side = pi<T>() / T(levels.front().height);
        const T finest(0), coarsest = static_cast<T>(levels.size() - 1);
        const T lod = min(max(log2(solid_angle / (side * side)) / T(2), finest), coarsest);
        const auto low = static_cast<std::size_t>(lod);
        const auto high = std::min(low + 1, levels.size() - 1);
        const T t = lod - static_cast<T>(low);
        return levels[low](direction) * (T(1) - t) + levels[high](direction) * t;
    }

    const latlong<T>& level(std::size_t i) const { return levels[i]; }
    std::size_t size() const { return levels.size(); }

private:
    static latlong<T> halved(const latlong<T>& fine) {
        const int width = fine.width / 2, height = fine.height / 2;
        std::vector<vec3<T>> pixels;
        pixels.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
        for (int y = 0; y < height; ++y) {
            const T top = latlong_texel_solid_angle<T>(2 * y, fine.width, fine.height);
            const T bottom = latlong_texel_solid_angle<T>(2 * y + 1, fine.width, fine.height);
            for (int x = 0; x < width; ++x)
                pixels.push_back(((fine.at(2 * x, 2 * y) + fine.at(2 * x + 1, 2 * y)) * top +
                                  (fine.at(2 * x, 2 * y + 1) + fine.at(2 * x + 1, 2 * y + 1)) * bottom) /
                                 (T(2) * (top + bottom)));
        }
        return {width, height, std::move(pixels)};
    }

    std::vector<latlong<T>> levels;
};

}  // namespace lobe
