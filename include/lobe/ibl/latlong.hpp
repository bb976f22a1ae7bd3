// An environment as a lat-long image, and its pyramid.
#pragma once

#include <lobe/core/spectrum.hpp>
#include <lobe/ibl/directions.hpp>

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <utility>
#include <vector>

namespace lobe {

template <scalar T>
class latlong_pyramid;

namespace detail {

/// Where a look-up reads: u of latlong_uv, with 1 in place of 0 on one side of the seam, and the angle from the pole
/// that is nearer, as v is. In double at least: in float, what 1/pi loses to rounding opens a gap of 2e-5 of a column
/// of 2048 at the seam.
template <scalar T>
struct latlong_place {
    wide_t<T> u, v;
    T sine, cotangent;  // of the angle from the pole
    bool nadir;         // is that pole the nadir?

    explicit latlong_place(const vec3<T>& direction) : nadir(direction.y < T(0)) {
        using std::atan2, std::sqrt;
        using W = wide_t<T>;
        const T height = nadir ? -direction.y : direction.y;
        sine = sqrt(direction.x * direction.x + direction.z * direction.z);
        cotangent = quotient(sine > T(0), height, sine);
        u = W(0.5) + W(T(atan2(direction.z, direction.x))) * (inv_pi<W>() / W(2));
        v = W(T(atan2(sine, height))) * inv_pi<W>();
    }
    bool exists() const { return v >= wide_t<T>(0); }  // a direction with a NaN in it is nowhere
};

/// Between a and b; a itself for a = b.
template <scalar T>
constexpr vec3<T> mix(const vec3<T>& a, const vec3<T>& b, const T& t) {
    return a + (b - a) * t;
}

/// The square of a texel's height, the side of `solid_angle`, in columns of a row at `sine`.
template <scalar T>
T latlong_height2(const T& solid_angle, const T& sine, int width) {
    const T column = sine * (T(2) * pi<T>() / T(width));
    return solid_angle / larger(column * column, smallest<T>());
}

/// How many columns of a row to average, of this square, from 1 to all.
template <scalar T>
T latlong_window(const T& square, int width) {
    using std::sqrt;
    return smaller(sqrt(larger(T(1), square)), T(width));  // in this order a NaN is one
}

}  // namespace detail

/// Radiance on a lat-long image, row by row from the zenith, linear rgb. Called with a unit direction it interpolates
/// linearly in both angles, around the seam and over the poles, where it is the mean of the row next to them. Between
/// the middles of two rows the lower one has, at the fraction t of the way, the weight
///   t + k t (1 - t) cot theta,  k = h (h - sin h)/(sin h - h cos h),  h = pi/(2 height):
/// so each texel counts as much as its solid angle, and the look-up has the image's energy: plain bilinear weights,
/// with k = 0, give the rows at the poles 8% too much. A direction with a NaN in it gets a NaN. Scalar types only.
/// The means at the poles are the constructor's: change no pixel afterwards.
/// Error: of a smooth image, with d = pi/height: d^2/8 of its second derivatives and d^2/16 cot theta of the first; of
/// its energy, 1e-6 in float, 1e-13 in double; of a constant, none.
template <scalar T>
struct latlong {
    int width, height;
    std::vector<vec3<T>> pixels;

    /// Precondition: width * height pixels, at least one.
    latlong(int columns, int rows, std::vector<vec3<T>> radiance)
        : width(columns), height(rows), pixels(std::move(radiance)) {
        using std::cos, std::sin;
        assert(width > 0 && height > 0 && "latlong: an image has at least one pixel");
        assert(pixels.size() == static_cast<std::size_t>(width) * static_cast<std::size_t>(height) &&
               "latlong: width times height pixels");
        zenith = mean_along(0, W(0), W(width));
        nadir = mean_along(height - 1, W(0), W(width));
        const W h = pi<W>() / W(2 * height);
        k = T(h * (h - sin(h)) / (sin(h) - h * cos(h)));
    }

    const vec3<T>& at(int column, int row) const {
        return pixels[static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                      static_cast<std::size_t>(column)];
    }

    vec3<T> operator()(const vec3<T>& direction) const {
        const detail::latlong_place<T> place(direction);
        return place.exists() ? interpolated(place) : vec3<T>(T(place.v));
    }

private:
    friend latlong_pyramid<T>;
    using W = detail::wide_t<T>;

    vec3<T> interpolated(const detail::latlong_place<T>& place) const {
        const W x = place.u * W(width) + W(0.5);  // from 1/2 to width + 1/2
        const int column = static_cast<int>(x);
        const int left = column > 0 ? column - 1 : width - 1, right = column < width ? column : 0;
        const T t = T(x - W(column));
        return over_rows(place, [&](int row) { return detail::mix(at(left, row), at(right, row), t); });
    }

    /// The same with rows averaged over a window of so many columns, at least one; with one it is the same.
    vec3<T> averaged(const detail::latlong_place<T>& place, const T& columns) const {
        return over_rows(place,
                         [&](int row) { return mean_along(row, place.u * W(width) - W(columns) / W(2), W(columns)); });
    }

    /// `along(row)`: the radiance of a row at the azimuth of the place. Whatever mean over azimuths that is, the energy
    /// stays.
    template <class Along>
    vec3<T> over_rows(const detail::latlong_place<T>& place, const Along& along) const {
        const auto row = [&](int from_pole) { return along(place.nadir ? height - 1 - from_pole : from_pole); };
        const W y = place.v * W(height) - W(0.5);
        if (y < W(0)) return detail::mix(place.nadir ? nadir : zenith, row(0), T(W(1) + W(2) * y));
        const int i = static_cast<int>(y);
        const T t = T(y - W(i));
        return detail::mix(row(i), row((std::min)(i + 1, height - 1)), t + k * t * (T(1) - t) * place.cotangent);
    }

    /// The mean of a row from column `from` on, over so many columns, fractions counted.
    vec3<T> mean_along(int row, const W& from, const W& columns) const {
        using std::floor;
        const W to = from + columns;
        W left = floor(from), weights(0);
        int column = static_cast<int>(left) % width;
        if (column < 0) column += width;
        vec3<W> total(W(0));
        for (; left < to; left += W(1)) {
            const W weight = smaller(left + W(1), to) - larger(left, from);
            total += vec3<W>(at(column, row)) * weight;
            weights += weight;
            if (++column == width) column = 0;
        }
        return vec3<T>(total / weights);
    }

    vec3<T> zenith, nadir;
    T k;
};

/// A lat-long image and its halvings. Level 0 is the image. A texel of another level is a mean around its middle, under
/// a hat as wide as two texels, and near the poles over as much more of the row as makes it as wide as high. Called
/// with a direction and a solid angle it answers with about the mean radiance over that solid angle: what filtered
/// importance sampling asks for. Every level and every solid angle keep the energy of the image. A solid angle that is
/// 0, below or a NaN gets the image itself.
/// Error: the mean is as wide as one over a disk of 4 times the solid angle. A sun of one texel, prefiltered for alpha
/// 1 from 1024 samples, is right to 0.1 of the highlight (rms) near the poles, 0.035 elsewhere.
template <scalar T>
class latlong_pyramid {
public:
    explicit latlong_pyramid(latlong<T> base) : texel(square(pi<T>() / T(base.height))), per_texel(T(1) / texel) {
        levels.push_back(std::move(base));
        for (latlong<T> level = levels.front(); level.height > 2;) {
            level = halved(level);
            levels.push_back(squared(level));
        }
    }

    vec3<T> operator()(const vec3<T>& direction) const { return levels.front()(direction); }

    /// Level of detail 1/2 log2(solid_angle / texel), texel = (pi/height)^2, interpolated between levels. Below 0, the
    /// image's own rows, averaged along as far as the solid angle reaches.
    vec3<T> operator()(const vec3<T>& direction, const T& solid_angle) const {
        using std::log2;
        const detail::latlong_place<T> place(direction);
        if (!place.exists()) return vec3<T>(T(place.v));
        const T finest(0), coarsest = static_cast<T>(levels.size() - 1);
        // in this order a NaN is the finest
        const T lod = smaller(larger(finest, log2(solid_angle * per_texel) / T(2)), coarsest);
        const auto low = static_cast<std::size_t>(lod);
        const auto high = (std::min)(low + 1, levels.size() - 1);
        const vec3<T> fine = low == 0 ? image(place, smaller(solid_angle, texel)) : levels[low].interpolated(place);
        return detail::mix(fine, levels[high].interpolated(place), lod - static_cast<T>(low));
    }

    const latlong<T>& level(std::size_t i) const { return levels[i]; }
    std::size_t size() const { return levels.size(); }

private:
    using W = detail::wide_t<T>;

    static T square(const T& x) { return x * x; }

    /// The image itself, its rows averaged as far as the solid angle reaches. Read by interpolation, a texel has the
    /// variance 1/12 + 1/6 of its height squared, x^2/4 of a column; a window, (columns^2 + 2)/12. The missing 1/12
    /// leaves alone texels as wide as high, nearly.
    vec3<T> image(const detail::latlong_place<T>& place, const T& solid_angle) const {
        const latlong<T>& map = levels.front();
        const T window = detail::latlong_window(
            T(3) * (detail::latlong_height2(solid_angle, place.sine, map.width) - T(1)), map.width);
        return window > T(1) ? map.averaged(place, window) : map.interpolated(place);
    }

    struct share {
        int fine, coarse;
        W weight;
    };
    struct node {
        W place;
        int coarse;
    };

    /// What part of the interval between two edges each of the coarse ones takes: hats, linear from node to node,
    /// integrated.
    static std::vector<share> shares(const std::vector<W>& edges, const std::vector<node>& nodes) {
        std::vector<share> result;
        std::size_t k = 0;
        for (std::size_t i = 0; i + 1 < edges.size(); ++i)
            for (W from = edges[i]; from < edges[i + 1];) {
                while (!(from < nodes[k + 1].place)) ++k;
                const node &left = nodes[k], &right = nodes[k + 1];
                const W to = smaller(edges[i + 1], right.place), part = to - from;
                const W next = part * ((from + to) / W(2) - left.place) / (right.place - left.place);
                result.push_back({static_cast<int>(i), left.coarse, part - next});
                result.push_back({static_cast<int>(i), right.coarse, next});
                from = to;
            }
        return result;
    }

    static std::vector<share> column_shares(int fine, int coarse) {
        std::vector<W> edges;
        std::vector<node> nodes;
        for (int i = 0; i <= fine; ++i) edges.push_back(W(i) * W(coarse) / W(fine));
        for (int i = -1; i <= coarse; ++i) nodes.push_back({W(i) + W(0.5), (i + coarse) % coarse});
        return shares(edges, nodes);
    }

    /// In area, 1 - cos theta. The first node is the pole; each edge between two coarse rows is half way between two
    /// nodes, so the hats hold as much as the rows.
    static std::vector<share> row_shares(int fine, int coarse) {
        const auto area = [](int i, int rows) {  // of i rows: 2 sin^2(theta/2)
            const W s = sincos_2pi(W(i) / W(4 * rows)).sin;
            return W(2) * s * s;
        };
        std::vector<W> edges;
        std::vector<node> nodes{{W(0), 0}};
        for (int i = 0; i <= fine; ++i) edges.push_back(area(i, fine));
        for (int i = 1; i < coarse; ++i) nodes.push_back({W(2) * area(i, coarse) - nodes.back().place, i});
        nodes.push_back({W(3), coarse - 1});  // beyond the other pole
        return shares(edges, nodes);
    }

    /// Half the rows, and half the columns unless that makes texels wider than high; odd numbers rounded down. Each
    /// texel is the mean under a hat as wide as two: what is bright stays where it is, where the mean over the texel
    /// alone would move it to the middle.
    static latlong<T> halved(const latlong<T>& fine) {
        const int height = fine.height / 2, width = fine.width > 2 * height ? fine.width / 2 : fine.width;
        const auto count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
        std::vector<vec3<W>> totals(count, vec3<W>(W(0)));
        std::vector<W> weights(count, W(0));
        const auto columns = column_shares(fine.width, width);
        for (const share& row : row_shares(fine.height, height))
            for (const share& column : columns) {
                const auto i = static_cast<std::size_t>(row.coarse) * static_cast<std::size_t>(width) +
                               static_cast<std::size_t>(column.coarse);
                const W weight = row.weight * column.weight;
                totals[i] += vec3<W>(fine.at(column.fine, row.fine)) * weight;
                weights[i] += weight;
            }
        std::vector<vec3<T>> pixels;
        pixels.reserve(count);
        for (std::size_t i = 0; i < count; ++i) pixels.push_back(vec3<T>(totals[i] / weights[i]));
        return {width, height, std::move(pixels)};
    }

    /// Each texel the mean along its row over a window that makes it as wide as high. Its hat and the interpolation
    /// have the variance 1/6 + 1/6 of its height squared, x^2/3 of a column; with a window, (columns^2 + 3)/12.
    static latlong<T> squared(const latlong<T>& level) {
        std::vector<vec3<T>> pixels;
        pixels.reserve(level.pixels.size());
        for (int row = 0; row < level.height; ++row) {
            const W sine = sincos_2pi((W(row) + W(0.5)) / W(2 * level.height)).sin, side = pi<W>() / W(level.height);
            const W columns = detail::latlong_window(
                W(4) * detail::latlong_height2(side * side, sine, level.width) - W(3), level.width);
            for (int column = 0; column < level.width; ++column)
                pixels.push_back(level.mean_along(row, W(column) + (W(1) - columns) / W(2), columns));
        }
        return {level.width, level.height, std::move(pixels)};
    }

    std::vector<latlong<T>> levels;
    T texel, per_texel;
};

/// A lat-long map of what an environment shows: each texel the mean of `per_axis`^2 look-ups, weighted with their solid
/// angles. `environment`: any callable of a unit direction, a `cube` or a `rotated` map, too. `for_each_row`: as
/// `one_by_one`.
template <scalar T, class Environment, class ForEachRow = one_by_one>
latlong<T> make_latlong(const Environment& environment, int width, int height, int per_axis = 1,
                        const ForEachRow& for_each_row = {}) {
    using W = detail::wide_t<T>;
    assert(width > 0 && height > 0 && per_axis > 0 && "make_latlong: width, height and look-ups must be above 0");
    std::vector<vec3<T>> pixels(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    for_each_row(height, [&](int row) {
        for (int column = 0; column < width; ++column) {
            vec3<W> total(W(0));
            W weights(0);
            for (int j = row * per_axis; j < (row + 1) * per_axis; ++j) {
                const W weight = latlong_texel_solid_angle<W>(j, width * per_axis, height * per_axis);
                for (int i = column * per_axis; i < (column + 1) * per_axis; ++i) {
                    const vec2<T> uv{(T(i) + T(0.5f)) / T(width * per_axis), (T(j) + T(0.5f)) / T(height * per_axis)};
                    total += vec3<W>(vec3<T>(environment(latlong_direction(uv)))) * weight;
                    weights += weight;
                }
            }
            pixels[static_cast<std::size_t>(row) * static_cast<std::size_t>(width) + static_cast<std::size_t>(column)] =
                vec3<T>(total / weights);
        }
    });
    return latlong<T>(width, height, std::move(pixels));
}

}  // namespace lobe
