// An environment as a cube map, and its pyramid.
#pragma once

#include <lobe/core/spectrum.hpp>
#include <lobe/ibl/directions.hpp>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace lobe {

template <scalar T>
class cube_pyramid;

/// Radiance on the six faces of a cube, linear rgb, in the order and orientation of `cube_point`, row by row. Called
/// with a direction it interpolates linearly on its face, and over the edges as if the face went on: no seams. Scalar
/// types only.
/// Error: of a smooth image 1/(2 size^2) of its second derivatives along the face, next to an edge 1/(2 size) of the
/// first; of a constant none. The energy of one texel, seen by look-ups, is off by 1/size^2, at an edge or corner by
/// 0.2/size (a `latlong` keeps it to 1e-6).
template <scalar T>
class cube {
public:
    /// Precondition: 6 size^2 pixels, size at least 1.
    cube(int texels_along_an_edge, const std::vector<vec3<T>>& radiance)
        : n(texels_along_an_edge), padded(6 * stride() * stride()) {
        assert(n > 0 && "cube: a face has at least one pixel");
        assert(radiance.size() == 6 * static_cast<std::size_t>(n) * static_cast<std::size_t>(n) &&
               "cube: six faces of size times size pixels");
        const vec3<T>* pixel = radiance.data();
        for (int face = 0; face < 6; ++face)
            for (int row = 0; row < n; ++row)
                for (int column = 0; column < n; ++column) padded[index(face, column, row)] = *pixel++;
        for (int face = 0; face < 6; ++face) pad(face);
    }

    int size() const { return n; }
    const vec3<T>& at(int face, int column, int row) const { return padded[index(face, column, row)]; }

    vec3<T> operator()(const vec3<T>& direction) const { return (*this)(cube_uv(direction)); }
    vec3<T> operator()(const cube_place<T>& place) const {
        const T x = place.uv.x * T(n) + T(0.5f), y = place.uv.y * T(n) + T(0.5f);  // from 1/2 to n + 1/2
        // a NaN is nowhere
        if (!(x >= T(0) && y >= T(0))) return vec3<T>(std::numeric_limits<T>::quiet_NaN());
        const int column = (std::min)(static_cast<int>(x), n), row = (std::min)(static_cast<int>(y), n);
        const T tx = x - T(column), ty = y - T(row);
        const vec3<T>* low = &padded[index(place.face, column - 1, row - 1)];
        const vec3<T>* high = low + stride();
        return (low[0] * (T(1) - tx) + low[1] * tx) * (T(1) - ty) + (high[0] * (T(1) - tx) + high[1] * tx) * ty;
    }

    /// Each pixel, g(face, column, row, radiance).
    template <class G>
    void for_each(const G& g) const {
        for (int face = 0; face < 6; ++face)
            for (int row = 0; row < n; ++row)
                for (int column = 0; column < n; ++column) g(face, column, row, at(face, column, row));
    }

private:
    /// Faces are kept with a border one texel wide.
    std::size_t stride() const { return static_cast<std::size_t>(n) + 2; }
    std::size_t index(int face, int column, int row) const {
        return (static_cast<std::size_t>(face) * stride() + static_cast<std::size_t>(row + 1)) * stride() +
               static_cast<std::size_t>(column + 1);
    }

    /// The border is what the neighbours hold next to the edge; at a corner, the mean of the three texels that meet.
    void pad(int face) {
        for (int i = -1; i <= n; ++i)
            for (const int side : {-1, n}) {
                padded[index(face, i, side)] = border(face, i, side);
                padded[index(face, side, i)] = border(face, side, i);
            }
    }
    vec3<T> border(int face, int column, int row) const {
        vec3<T> total(T(0));
        for_each_source(n, face, column, row, [&](int f, int i, int j, const T& part) { total += at(f, i, j) * part; });
        return total;
    }

    /// What a texel of a face with its border consists of: g(face, column, row, part).
    template <class G>
    static void for_each_source(int n, int face, int column, int row, const G& g) {
        const int inside_column = (std::min)((std::max)(column, 0), n - 1),
                  inside_row = (std::min)((std::max)(row, 0), n - 1);
        if (column == inside_column && row == inside_row) return g(face, column, row, T(1));
        const auto neighbour = [&](int i, int j, const T& part) {
            vec3<T> w = cube_point(face, vec2<T>{(T(i) + T(0.5f)) / T(n), (T(j) + T(0.5f)) / T(n)});
            // one component is beyond 1: the neighbour's texel of the same place along the edge is next to it
            for (T* c : {&w.x, &w.y, &w.z}) *c = smaller(larger(*c, T(-1)), T(1));
            // half a texel below the edge, so that the neighbour's component is the largest
            const cube_place<T> place = cube_uv(w - cube_point(face, vec2<T>{T(0.5f), T(0.5f)}) * (T(1) / T(n)));
            const auto texel = [&](const T& x) { return (std::min)((std::max)(static_cast<int>(x * T(n)), 0), n - 1); };
            g(place.face, texel(place.uv.x), texel(place.uv.y), part);
        };
        if (column == inside_column || row == inside_row) return neighbour(column, row, T(1));
        g(face, inside_column, inside_row, T(1) / T(3));
        neighbour(column, inside_row, T(1) / T(3));
        neighbour(inside_column, row, T(1) / T(3));
    }

    friend cube_pyramid<T>;

    int n;
    std::vector<vec3<T>> padded;
};

/// A texel of a cube of what an environment shows: the mean of `per_axis`^2 look-ups, weighted with their solid angles.
/// `environment`: any callable of a unit direction.
template <scalar T, class Environment>
vec3<T> cube_texel_mean(const Environment& environment, int size, int face, int column, int row, int per_axis) {
    using W = detail::wide_t<T>;
    using std::sqrt;
    vec3<W> total(W(0));
    W weights(0);
    for (int j = 0; j < per_axis; ++j)
        for (int i = 0; i < per_axis; ++i) {
            const auto along = [&](int texel, int part) {
                return (T(texel) + (T(part) + T(0.5f)) / T(per_axis)) / T(size);
            };
            const vec3<T> p = cube_point(face, vec2<T>{along(column, i), along(row, j)});
            const W d2 = W(dot(p, p)), weight = W(1) / (d2 * sqrt(d2));
            total += vec3<W>(vec3<T>(environment(normalize(p)))) * weight;
            weights += weight;
        }
    return vec3<T>(total / weights);
}

/// All of its texels.
template <scalar T, class Environment>
cube<T> make_cube(const Environment& environment, int size, int per_axis = 1) {
    assert(size > 0 && per_axis > 0 && "make_cube: size and look-ups must be above 0");
    std::vector<vec3<T>> pixels;
    for (int face = 0; face < 6; ++face)
        for (int row = 0; row < size; ++row)
            for (int column = 0; column < size; ++column)
                pixels.push_back(cube_texel_mean<T>(environment, size, face, column, row, per_axis));
    return cube<T>(size, pixels);
}

/// A cube map and its halvings. A texel of another level than the image is the mean of the image under the hat that a
/// look-up gives it, so that look-ups in every level have the energy of the image (to 4e-3; the mean over the texel
/// alone would be off by 0.2/size). The size is a power of two. Called with a direction and a solid angle it answers
/// with about the mean radiance over it: what filtered importance sampling asks for.
template <scalar T>
class cube_pyramid {
public:
    explicit cube_pyramid(cube<T> base)
        : per_texel(T(3) / T(4) * T(6) * T(base.size()) * T(base.size()) / (T(4) * pi<T>())) {
        assert((base.size() & (base.size() - 1)) == 0 && "cube_pyramid: the size must be a power of two");
        levels.push_back(std::move(base));
        for (int size = levels.front().size() / 2; size > 0; size /= 2) levels.push_back(reduced(levels.front(), size));
    }

    vec3<T> operator()(const vec3<T>& direction) const { return levels.front()(direction); }

    /// Interpolated between levels: `level_of`, texel = 4 pi/(6 size^2).
    vec3<T> operator()(const vec3<T>& direction, const T& solid_angle) const {
        return at_level(direction, level_of(solid_angle));
    }

    /// 1/2 log2(3/4 solid_angle / texel): under a hat and interpolated a texel has 4/3 of the variance of one that is a
    /// mean over itself. Solid angles to levels, from 0 to the coarsest; what is 0, below or a NaN gets the image.
    T level_of(const T& solid_angle) const {
        using std::log2;
        const T coarsest = T(static_cast<int>(levels.size()) - 1);
        return smaller(larger(T(0), log2(solid_angle * per_texel) / T(2)), coarsest);
    }
    vec3<T> at_level(const vec3<T>& direction, const T& lod) const {
        const cube_place<T> place = cube_uv(direction);
        const auto low = static_cast<std::size_t>(lod), high = (std::min)(low + 1, levels.size() - 1);
        const T t = lod - T(static_cast<int>(low));
        return levels[low](place) * (T(1) - t) + levels[high](place) * t;
    }

    const cube<T>& level(std::size_t i) const { return levels[i]; }
    std::size_t size() const { return levels.size(); }

private:
    static cube<T> reduced(const cube<T>& image, int n) {
        using W = detail::wide_t<T>;
        const auto texels = 6 * static_cast<std::size_t>(n) * static_cast<std::size_t>(n);
        std::vector<vec3<W>> totals(texels, vec3<W>(W(0)));
        std::vector<W> weights(texels, W(0));
        image.for_each([&](int face, int column, int row, const vec3<T>& radiance) {
            const W omega = cube_texel_solid_angle<W>(column, row, image.size());
            const auto along = [&](int i) { return (W(i) + W(0.5)) / W(image.size()) * W(n) + W(0.5); };
            const W x = along(column), y = along(row);
            const int i = static_cast<int>(x), j = static_cast<int>(y);
            for (int corner = 0; corner < 4; ++corner) {
                const int right = corner % 2, down = corner / 2;
                const W tx = x - W(i), ty = y - W(j);
                const W hat = omega * (right ? tx : W(1) - tx) * (down ? ty : W(1) - ty);
                cube<T>::for_each_source(n, face, i - 1 + right, j - 1 + down, [&](int f, int c, int r, const T& part) {
                    const auto at =
                        (static_cast<std::size_t>(f) * static_cast<std::size_t>(n) + static_cast<std::size_t>(r)) *
                            static_cast<std::size_t>(n) +
                        static_cast<std::size_t>(c);
                    totals[at] += vec3<W>(radiance) * (hat * W(part));
                    weights[at] += hat * W(part);
                });
            }
        });
        std::vector<vec3<T>> pixels;
        for (std::size_t k = 0; k < texels; ++k) pixels.push_back(vec3<T>(totals[k] / weights[k]));
        return cube<T>(n, pixels);
    }

    std::vector<cube<T>> levels;
    T per_texel;
};

}  // namespace lobe
