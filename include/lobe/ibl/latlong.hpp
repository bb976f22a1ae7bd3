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
        assert(width > 0 && height > 0 && "latlong: an image has at least one pixel");
        assert(pixels.size() == static_cast<std::size_t>(width) * static_cast<std::size_t>(height) && "latlong: width times height pixels");
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
        const int top = std::clamp(static_cast<int>(y0), 0, height - 1), bottom = std::clamp(static_cast<int>(y0) + 1, 0, height - 1);
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
        while (levels.back().height > 2 && levels.back().width > 2) levels.push_back(halved(levels.back()));
    }

    vec3<T> operator()(const vec3<T>& direction) const { return levels.front()(direction); }

    /// Level of detail 1/2 log2(solid_angle / texel), texel = (pi/height)^2, interpolated between levels.
    vec3<T> operator()(const vec3<T>& direction, const T& solid_angle) const {
        using std::log2;
        const T side = pi<T>() / T(levels.front().height);
        const T finest(0), coarsest = static_cast<T>(levels.size() - 1);
        const T lod = smaller(larger(finest, log2(solid_angle / (side * side)) / T(2)), coarsest);  // in this order a NaN is the finest
        const auto low = static_cast<std::size_t>(lod);
        const auto high = (std::min)(low + 1, levels.size() - 1);
        const T t = lod - static_cast<T>(low);
        return levels[low](direction) * (T(1) - t) + levels[high](direction) * t;
    }

    const latlong<T>& level(std::size_t i) const { return levels[i]; }
    std::size_t size() const { return levels.size(); }

private:
    /// Half the size, odd ones rounded down: each texel is the mean over what it covers, in fractions of the finer ones.
    static latlong<T> halved(const latlong<T>& fine) {
        const int width = fine.width / 2, height = fine.height / 2;
        const T wide = static_cast<T>(fine.width) / static_cast<T>(width), high = static_cast<T>(fine.height) / static_cast<T>(height);
        std::vector<vec3<T>> pixels;
        pixels.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                const T left = static_cast<T>(x) * wide, right = left + wide, top = static_cast<T>(y) * high, bottom = top + high;
                vec3<T> total(T(0));
                T weights(0);
                for (int row = static_cast<int>(top); row < fine.height && static_cast<T>(row) < bottom; ++row)
                    for (int column = static_cast<int>(left); column < fine.width && static_cast<T>(column) < right; ++column) {
                        const T from = larger(static_cast<T>(row), top), to = smaller(static_cast<T>(row + 1), bottom);
                        const T across = smaller(static_cast<T>(column + 1), right) - larger(static_cast<T>(column), left);
                        const T turn = T(0.25) / static_cast<T>(fine.height);  // cos theta(from) - cos theta(to), as a product
                        const T weight = across * sincos_2pi((from + to) * turn).sin * sincos_2pi((to - from) * turn).sin;
                        total += fine.at(column, row) * weight;
                        weights += weight;
                    }
                pixels.push_back(total / weights);
            }
        return {width, height, std::move(pixels)};
    }

    std::vector<latlong<T>> levels;
};

}  // namespace lobe
