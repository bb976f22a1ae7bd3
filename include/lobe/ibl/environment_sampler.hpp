// Directions to sample an environment by, in proportion to what it sends.
#pragma once

#include <lobe/core/spectrum.hpp>
#include <lobe/ibl/cube.hpp>
#include <lobe/ibl/latlong.hpp>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <vector>

namespace lobe {

namespace detail {

/// Rows of columns drawn in proportion to weights: a row, then a column of it, and where in the cell.
template <scalar T>
class cell_sampler {
public:
    struct cell {
        int column, row;
        vec2<T> within;  // in [0,1)^2
    };

    cell_sampler(int columns, const std::vector<double>& weights)
        : width(static_cast<std::size_t>(columns)), height(weights.size() / width), columns_below(weights.size()),
          rows_below(height) {
        double total = 0;
        for (std::size_t row = 0; row < height; ++row) {
            double of_row = 0;
            for (std::size_t i = row * width; i < (row + 1) * width; ++i) columns_below[i] = of_row += weights[i];
            rows_below[row] = total += of_row;
        }
        assert(total > 0 && "environment_sampler: an environment without light cannot be sampled");
    }

    cell sample(const vec2<T>& u) const {
        const place row = find(rows_below.data(), height, double(u.y));
        const place column = find(&columns_below[row.index * width], width, double(u.x));
        return {static_cast<int>(column.index), static_cast<int>(row.index), {T(column.within), T(row.within)}};
    }
    /// How often a cell is drawn.
    double probability(int column, int row) const {
        const auto i = static_cast<std::size_t>(row) * width + static_cast<std::size_t>(column);
        return (columns_below[i] - (column > 0 ? columns_below[i - 1] : 0)) / rows_below.back();
    }

private:
    struct place {
        std::size_t index;
        double within;
    };

    /// The first of the running sums that is above u times the last, so that nothing of weight 0 is ever drawn.
    static place find(const double* below, std::size_t count, double u) {
        const double target = u * below[count - 1];
        const double* found = std::upper_bound(below, below + count - 1, target);
        const double before = found == below ? 0 : found[-1], part = (target - before) / (*found - before);
        // a float that rounds to 1 would be outside of the cell
        return {static_cast<std::size_t>(found - below), (std::min)(part, 1 - 0x1p-24)};
    }

    std::size_t width, height;
    std::vector<double> columns_below, rows_below;
};

/// The mean of r, g and b under a hat as wide as two texels: what a look-up anywhere in the texel may read has a part
/// in it. `at(i, j)`: the texel so many columns and rows from this one.
template <class At>
double brightness_around(const At& at) {
    double total = 0;
    for (int j = -1; j <= 1; ++j)
        for (int i = -1; i <= 1; ++i) {
            const auto& c = at(i, j);
            const double weight = (i ? 1.0 : 6.0) * (j ? 1.0 : 6.0) / 64;
            total += weight * larger(0.0, double(c.x) + double(c.y) + double(c.z)) / 3;
        }
    return total;
}

}  // namespace detail

/// A direction that was drawn, and its density in 1/sr.
template <scalar T>
struct sampled_direction {
    vec3<T> direction;
    T pdf;
};

/// Draws directions of an environment map in proportion to the radiance there: its texels by their light, the mean of
/// rgb over the exact solid angle; inside a texel evenly in solid angle (`latlong`), or in its area, with the density
/// that this is (`cube`). So `pdf` is exact, at the poles too. Wherever a look-up in the map is not 0, pdf is not.
/// For `by_lights`, `by_both` (-> `reflected_radiance`). Build once: 16 bytes a texel. Scalar types only.
/// Precondition: some texel is brighter than 0. u in [0,1)^2.
template <class Map>
class environment_sampler;
template <class Map>
environment_sampler(const Map&) -> environment_sampler<Map>;

template <scalar T>
class environment_sampler<latlong<T>> {
public:
    explicit environment_sampler(const latlong<T>& map)
        : width(map.width), height(map.height), cells(map.width, weights(map)) {}

    sampled_direction<T> sample(const vec2<T>& u) const {
        using std::sqrt;
        const auto [column, row, within] = cells.sample(u);
        const auto [sin_phi, cos_phi] = sincos_2pi((T(column) + within.x) / T(width));
        // evenly in height: sin^2(theta/2) between those of the edges, from the nearer pole
        const bool below = 2 * row >= height;
        const T edge0 = half_sine2(below ? height - row : row), edge1 = half_sine2(below ? height - row - 1 : row + 1);
        const T s2 = edge0 + (edge1 - edge0) * within.y, sine = T(2) * sqrt(s2 * (T(1) - s2));
        const T up = T(1) - T(2) * s2;
        return {{-sine * cos_phi, below ? -up : up, -sine * sin_phi}, density(column, row)};
    }
    T pdf(const vec3<T>& direction) const {
        const vec2<T> uv = latlong_uv(direction);
        return density((std::min)(static_cast<int>(uv.x * T(width)), width - 1),
                       (std::min)(static_cast<int>(uv.y * T(height)), height - 1));
    }

private:
    T density(int column, int row) const {
        return T(cells.probability(column, row) / latlong_texel_solid_angle<double>(row, width, height));
    }
    /// sin^2(theta/2) of the edge above a row.
    T half_sine2(int row) const {
        const T s = sincos_2pi(T(row) / T(4 * height)).sin;
        return s * s;
    }
    static std::vector<double> weights(const latlong<T>& map) {
        std::vector<double> result;
        for (int row = 0; row < map.height; ++row) {
            const double omega = latlong_texel_solid_angle<double>(row, map.width, map.height);
            for (int column = 0; column < map.width; ++column)
                result.push_back(omega * detail::brightness_around([&](int i, int j) {
                                     // over the poles a look-up reads the whole row next to it: its own texel stands
                                     // for it
                                     const int r = (std::min)((std::max)(row + j, 0), map.height - 1);
                                     return map.at((column + i + map.width) % map.width, r);
                                 }));
        }
        // where the row at a pole has light, all of its texels see its mean
        for (const int row : {0, map.height - 1}) {
            double mean = 0;
            const auto first = static_cast<std::size_t>(row) * static_cast<std::size_t>(map.width);
            for (int i = 0; i < map.width; ++i) mean += result[first + static_cast<std::size_t>(i)] / map.width;
            for (int i = 0; i < map.width; ++i) {
                double& weight = result[first + static_cast<std::size_t>(i)];
                weight = (7 * weight + mean) / 8;  // of the texel's area an eighth is nearer to the pole's mean
            }
        }
        return result;
    }

    int width, height;
    detail::cell_sampler<T> cells;
};

template <scalar T>
class environment_sampler<cube<T>> {
public:
    explicit environment_sampler(const cube<T>& map) : size(map.size()), cells(map.size(), weights(map)) {}

    sampled_direction<T> sample(const vec2<T>& u) const {
        const auto [column, row, within] = cells.sample(u);
        const vec2<T> uv{(T(column) + within.x) / T(size), (T(row % size) + within.y) / T(size)};
        const vec3<T> p = cube_point(row / size, uv);
        return {normalize(p), density(column, row, p)};
    }
    T pdf(const vec3<T>& direction) const {
        const cube_place<T> place = cube_uv(direction);
        const auto texel = [&](const T& x) { return (std::min)(static_cast<int>(x * T(size)), size - 1); };
        return density(texel(place.uv.x), place.face * size + texel(place.uv.y), cube_point(place.face, place.uv));
    }

private:
    /// Evenly on the face, p on it: per solid angle |p|^3 times the density per area, (size/2)^2 a texel.
    T density(int column, int row, const vec3<T>& p) const {
        using std::sqrt;
        const T d2 = dot(p, p), per_area = T(size) * T(size) / T(4);
        return T(cells.probability(column, row)) * per_area * d2 * sqrt(d2);
    }
    static std::vector<double> weights(const cube<T>& map) {
        std::vector<double> result;
        map.for_each([&](int face, int column, int row, const vec3<T>&) {
            result.push_back(cube_texel_solid_angle<double>(column, row, map.size()) *
                             detail::brightness_around(
                                 [&](int i, int j) -> const vec3<T>& { return map.at(face, column + i, row + j); }));
        });
        return result;
    }

    int size;
    detail::cell_sampler<T> cells;
};

}  // namespace lobe
