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

/// Where a look-up reads: u of latlong_uv, with 1 in place of 0 on one side of the seam, and the angle from the pole that is nearer, as v is.
/// In double at least: in float, what 1/pi loses to rounding would open a gap of 1e-4 of a column of 2048 at the seam.
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
        cotangent = quotient(height, sine);
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

/// How many columns of a row to average so that a look-up there reads about as far along the row as a texel of so many sr is high:
///   columns^2 = 3 (x^2 - 1),  x^2 = solid_angle/(sine 2 pi/width)^2,  from 1 to the whole row.
/// Interpolated over the box of a texel, a row has the variance 1/12 + 1/6 of its height, here x^2/4 of a column; a window of so many columns,
/// in the same way, (columns^2 + 2)/12. The rest, 1/12, leaves alone what is less than a sixth higher than wide.
template <scalar T>
T latlong_window(const T& solid_angle, const T& sine, int width) {
    using std::sqrt;
    const T column = sine * (T(2) * pi<T>() / T(width));
    const T square = T(3) * (quotient(solid_angle, column * column) - T(1));
    return smaller(sqrt(larger(T(1), square)), T(width));  // in this order a NaN is one column
}

}  // namespace detail

/// Radiance on a lat-long image, row by row from the zenith, linear rgb. Called with a unit direction it interpolates linearly in both
/// angles, around the seam and over the poles, where it is the mean of the row next to them. Between the middles of two rows the lower one
/// has, at the fraction t of the way, the weight
///   t + k t (1 - t) cot theta,  k = h (h - sin h)/(sin h - h cos h),  h = pi/(2 height):
/// so each texel counts as much as its solid angle, and the look-up has the image's energy: plain bilinear weights, with k = 0, give the
/// rows at the poles 8% too much. A direction with a NaN in it gets a NaN. Scalar types only.
/// The means at the poles are the constructor's: change no pixel afterwards.
/// Error: of a smooth image, a texel's square times an eighth of the second derivatives; of its energy and of a constant, rounding.
template <scalar T>
struct latlong {
    int width, height;
    std::vector<vec3<T>> pixels;

    /// Precondition: width * height pixels, at least one.
    latlong(int columns, int rows, std::vector<vec3<T>> radiance) : width(columns), height(rows), pixels(std::move(radiance)) {
        using std::cos, std::sin;
        assert(width > 0 && height > 0 && "latlong: an image has at least one pixel");
        assert(pixels.size() == static_cast<std::size_t>(width) * static_cast<std::size_t>(height) && "latlong: width times height pixels");
        zenith = mean_along(0, W(0), W(width));
        nadir = mean_along(height - 1, W(0), W(width));
        const W h = pi<W>() / W(2 * height);
        k = T(h * (h - sin(h)) / (sin(h) - h * cos(h)));
    }

    const vec3<T>& at(int column, int row) const {
        return pixels[static_cast<std::size_t>(row) * static_cast<std::size_t>(width) + static_cast<std::size_t>(column)];
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
        return over_rows(place, [&](int row) { return mean_along(row, place.u * W(width) - W(columns) / W(2), W(columns)); });
    }

    /// `along(row)`: the radiance of a row at the azimuth of the place. Whatever mean over azimuths that is, the energy stays.
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

/// A lat-long image and its halvings. Level 0 is the image. A texel of another is the mean over its solid angle and, where the texels of a
/// row are narrower than high, over more of the row: near the poles, too, it is about as wide as high. Called with a direction and a
/// solid angle it answers with about the mean radiance over that solid angle: what filtered importance sampling asks for.
/// Every level and every solid angle keep the energy of the image. A solid angle that is 0, below or a NaN gets the image itself.
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

    /// Level of detail 1/2 log2(solid_angle / texel), texel = (pi/height)^2, interpolated between levels. Below 0, the image's own rows,
    /// averaged along as far as the solid angle reaches.
    vec3<T> operator()(const vec3<T>& direction, const T& solid_angle) const {
        using std::log2;
        const detail::latlong_place<T> place(direction);
        if (!place.exists()) return vec3<T>(T(place.v));
        const T finest(0), coarsest = static_cast<T>(levels.size() - 1);
        const T lod = smaller(larger(finest, log2(solid_angle * per_texel) / T(2)), coarsest);  // in this order a NaN is the finest
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

    vec3<T> image(const detail::latlong_place<T>& place, const T& solid_angle) const {
        const T window = detail::latlong_window(solid_angle, place.sine, levels.front().width);
        return window > T(1) ? levels.front().averaged(place, window) : levels.front().interpolated(place);
    }

    /// Half the rows, and half the columns unless that makes texels wider than high; odd numbers rounded down. Each texel is the mean over
    /// what it covers, in fractions of the finer ones.
    static latlong<T> halved(const latlong<T>& fine) {
        const int height = fine.height / 2, width = fine.width > 2 * height ? fine.width / 2 : fine.width;
        const auto edge = [](int i, int from, int to) { return static_cast<W>(i) * static_cast<W>(from) / static_cast<W>(to); };
        std::vector<vec3<T>> pixels;
        pixels.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                const W left = edge(x, fine.width, width), right = edge(x + 1, fine.width, width);
                const W top = edge(y, fine.height, height), bottom = edge(y + 1, fine.height, height);
                vec3<W> total(W(0));
                W weights(0);
                for (int row = static_cast<int>(top); row < fine.height && static_cast<W>(row) < bottom; ++row)
                    for (int column = static_cast<int>(left); column < fine.width && static_cast<W>(column) < right; ++column) {
                        const W from = larger(static_cast<W>(row), top), to = smaller(static_cast<W>(row + 1), bottom);
                        const W across = smaller(static_cast<W>(column + 1), right) - larger(static_cast<W>(column), left);
                        const W turn = W(0.25) / static_cast<W>(fine.height);  // cos theta(from) - cos theta(to), as a product
                        const W weight = across * sincos_2pi((from + to) * turn).sin * sincos_2pi((to - from) * turn).sin;
                        total += vec3<W>(fine.at(column, row)) * weight;
                        weights += weight;
                    }
                pixels.push_back(vec3<T>(total / weights));
            }
        return {width, height, std::move(pixels)};
    }

    /// Each texel the mean along its row over a window that makes it about as wide as high.
    static latlong<T> squared(const latlong<T>& level) {
        std::vector<vec3<T>> pixels;
        pixels.reserve(level.pixels.size());
        for (int row = 0; row < level.height; ++row) {
            const W sine = sincos_2pi((W(row) + W(0.5)) / W(2 * level.height)).sin, side = pi<W>() / W(level.height);
            const W columns = detail::latlong_window(side * side, sine, level.width);
            for (int column = 0; column < level.width; ++column)
                pixels.push_back(level.mean_along(row, W(column) + (W(1) - columns) / W(2), columns));
        }
        return {level.width, level.height, std::move(pixels)};
    }

    std::vector<latlong<T>> levels;
    T texel, per_texel;
};

}  // namespace lobe
