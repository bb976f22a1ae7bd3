// An environment as a cube map, and its pyramid.
#pragma once

#include <lobe/core/spectrum.hpp>
#include <lobe/ibl/directions.hpp>
#include <lobe/numeric/gauss_legendre.hpp>

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

namespace detail {

/// dw/(dx dy) at a point p of a face of the cube from -1 to 1: |p|^-3.
template <scalar T>
constexpr T cube_density(const vec3<T>& p) {
    using std::sqrt;
    const T d2 = dot(p, p);
    return T(1) / (d2 * sqrt(d2));
}

/// A number for each texel of a quarter of a face, the one of the last columns and rows; the others mirror it.
template <class X>
class cube_quarter {
public:
    /// `value(column, row)`, of columns and rows from size/2 on.
    template <class Value>
    cube_quarter(int size, const Value& value) : n(size) {
        for (int row = n / 2; row < n; ++row)
            for (int column = n / 2; column < n; ++column) values.push_back(value(column, row));
    }
    const X& at(int column, int row) const {
        const auto from_middle = [&](int i) { return static_cast<std::size_t>((std::max)(i, n - 1 - i) - n / 2); };
        return values[from_middle(row) * static_cast<std::size_t>(n - n / 2) + from_middle(column)];
    }

private:
    int n;
    std::vector<X> values;
};

/// Which part of the solid angle of a look-up's weight for a texel belongs to the texel before it, the one nearer to
/// the middle of the face, in its row; in its column it is at(row, column).
/// Between the middles of two texels, solid angle is denser where the face's middle is nearer. Half of it there belongs
/// to each texel by area, but by linear weights, 1 - t and t, the outer texel has more. So much is its excess,
///   int (t - [t > 1/2]) (hat(s) + box(s))/2 dw,  hat(s) = max(0, 1 - |s|),  box(s) = [|s| < 1/2],
/// across the row, at s texels from its middle; the product of two differences is that of one with the mean of the
/// other, twice. Over an edge the other face makes a mirror of it, and hat(s) with what it has beyond is 1.
/// By 3 x 3 points in each quarter of a texel: the energy of size 2 to 1e-6, of size 8 to 1e-10.
template <scalar T>
cube_quarter<T> cube_inner_parts(int n) {
    const gauss_legendre<T> rule(3);
    const auto middle = [&](int i) { return T(2 * i + 1 - n) / T(n); };
    const auto excess_of = [&](int column, int row) {
        if (2 * column <= n) return T(0);  // no column is nearer to the middle, or one that is as near
        T total(0);
        for (int part = -2; part < 2; ++part) {  // half texels, from the row's middle
            if ((part == -2 && row == 0) || (part == 1 && row == n - 1)) continue;
            const bool inside = part == -1 || part == 0, at_edge = row == (part < 0 ? 0 : n - 1);
            for (std::size_t j = 0; j < rule.x.size(); ++j)
                for (int half = 0; half < 2; ++half)
                    for (std::size_t i = 0; i < rule.x.size(); ++i) {
                        const T s = (T(part) + rule.x[j]) / T(2), t = (T(half) + rule.x[i]) / T(2);
                        const T hat = at_edge ? T(1) : T(1) - absolute(s), box(inside ? 1 : 0);
                        total += rule.w[j] * rule.w[i] * (t - T(half)) * (hat + box) / T(2) *
                                 cube_density(vec3<T>{middle(column - 1) + t * T(2) / T(n),
                                                      middle(row) + s * T(2) / T(n), T(1)});
                    }
        }
        return total / (T(n) * T(n));
    };
    const cube_quarter<T> excess(n, excess_of);
    return {n, [&](int column, int row) {
                const auto gained = [&](int i, int j) {
                    const T lost = i < n - 1 ? excess.at(i + 1, j) : T(0);
                    return excess.at(i, j) - (2 * i == n - 1 ? T(2) : T(1)) * lost;
                };
                const T omega = cube_texel_solid_angle<T>(column, row, n);
                return excess.at(column, row) / (omega + gained(column, row) + gained(row, column));
            }};
}

}  // namespace detail

/// Radiance on the six faces of a cube, linear rgb, in the order and orientation of `cube_point`, row by row. Called
/// with a direction it interpolates linearly on its face, and over the edges as if the face went on: no seams. Each
/// texel counts as much as its solid angle, so that the look-up has the image's energy: what is interpolated is not the
/// texels but nodes that hold a little, up to 0.13/size, of the next texel towards the middle of the face. Scalar types
/// only.
/// Error: of a smooth image 1/(2 size^2) of its second derivatives along the face, 1/(8 size^2) of the first, and next
/// to an edge 1/(2 size) of it; of its energy, 1e-6; of a constant none.
template <scalar T>
class cube {
public:
    /// Precondition: 6 size^2 pixels, size at least 1.
    cube(int texels_along_an_edge, std::vector<vec3<T>> radiance) : cube(texels_along_an_edge, std::move(radiance), 0) {
        const detail::cube_quarter<W> inner = detail::cube_inner_parts<W>(n);
        for_each([&](int face, int column, int row, const vec3<T>& L) {
            const auto before = [&](int i) { return 2 * i > n - 1 ? i - 1 : 2 * i < n - 1 ? i + 1 : i; };
            padded[index(face, column, row)] = L + (at(face, before(column), row) - L) * T(inner.at(column, row)) +
                                               (at(face, column, before(row)) - L) * T(inner.at(row, column));
        });
        pad();
    }

    int size() const { return n; }
    const vec3<T>& at(int face, int column, int row) const { return pixels[texel(face, column, row)]; }
    /// What look-ups interpolate; one column and one row beyond each edge, too.
    const vec3<T>& node(int face, int column, int row) const { return padded[index(face, column, row)]; }

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
    using W = detail::wide_t<T>;

    cube(int texels_along_an_edge, std::vector<vec3<T>> radiance, int)
        : n(texels_along_an_edge), pixels(std::move(radiance)), padded(6 * stride() * stride()) {
        assert(n > 0 && "cube: a face has at least one pixel");
        assert(pixels.size() == 6 * static_cast<std::size_t>(n) * static_cast<std::size_t>(n) &&
               "cube: six faces of size times size pixels");
    }
    /// The cube whose nodes these are.
    static cube of_nodes(int size, std::vector<vec3<T>> nodes) {
        cube out(size, std::move(nodes), 0);
        out.for_each(
            [&](int face, int column, int row, const vec3<T>& L) { out.padded[out.index(face, column, row)] = L; });
        out.pad();
        return out;
    }

    std::size_t texel(int face, int column, int row) const {
        return static_cast<std::size_t>((face * n + row) * n + column);
    }
    /// Nodes are kept with a border one wide.
    std::size_t stride() const { return static_cast<std::size_t>(n) + 2; }
    std::size_t index(int face, int column, int row) const {
        return (static_cast<std::size_t>(face) * stride() + static_cast<std::size_t>(row + 1)) * stride() +
               static_cast<std::size_t>(column + 1);
    }

    /// The border is what the neighbours hold next to the edge; at a corner, the mean of the three nodes that meet.
    void pad() {
        for (int face = 0; face < 6; ++face)
            for (int i = -1; i <= n; ++i)
                for (const int side : {-1, n}) {
                    padded[index(face, i, side)] = border(face, i, side);
                    padded[index(face, side, i)] = border(face, side, i);
                }
    }
    vec3<T> border(int face, int column, int row) const {
        vec3<T> total(T(0));
        for_each_source(n, face, column, row,
                        [&](int f, int i, int j, const T& part) { total += node(f, i, j) * part; });
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
    std::vector<vec3<T>> pixels, padded;
};

/// A texel of a cube of what an environment shows: the mean of `per_axis`^2 look-ups, weighted with their solid angles.
/// `environment`: any callable of a unit direction.
template <scalar T, class Environment>
vec3<T> cube_texel_mean(const Environment& environment, int size, int face, int column, int row, int per_axis) {
    using W = detail::wide_t<T>;
    vec3<W> total(W(0));
    W weights(0);
    for (int j = 0; j < per_axis; ++j)
        for (int i = 0; i < per_axis; ++i) {
            const auto along = [&](int texel, int part) {
                return (T(texel) + (T(part) + T(0.5f)) / T(per_axis)) / T(size);
            };
            const vec3<T> p = cube_point(face, vec2<T>{along(column, i), along(row, j)});
            const W weight = detail::cube_density(vec3<W>(p));
            total += vec3<W>(vec3<T>(environment(normalize(p)))) * weight;
            weights += weight;
        }
    return vec3<T>(total / weights);
}

/// All of its texels. `for_each_row`: as `one_by_one`.
template <scalar T, class Environment, class ForEachRow = one_by_one>
cube<T> make_cube(const Environment& environment, int size, int per_axis = 1, const ForEachRow& for_each_row = {}) {
    assert(size > 0 && per_axis > 0 && "make_cube: size and look-ups must be above 0");
    std::vector<vec3<T>> pixels(6 * static_cast<std::size_t>(size) * static_cast<std::size_t>(size));
    for_each_row(6 * size, [&](int row) {
        for (int column = 0; column < size; ++column)
            pixels[static_cast<std::size_t>(row) * static_cast<std::size_t>(size) + static_cast<std::size_t>(column)] =
                cube_texel_mean<T>(environment, size, row / size, column, row % size, per_axis);
    });
    return cube<T>(size, std::move(pixels));
}

/// A cube map and its halvings. What another level than the image interpolates are means of the image under the hat
/// that look-ups give them, so that look-ups in every level have the energy of the image, to rounding (with the mean
/// over a texel they would be off by 0.2/size). The size is a power of two. Called with a direction and a solid angle
/// it answers with about the mean radiance over it: what filtered importance sampling asks for.
template <scalar T>
class cube_pyramid {
public:
    explicit cube_pyramid(cube<T> base)
        : per_texel(T(3) / T(4) * T(6) * T(base.size()) * T(base.size()) / (T(4) * pi<T>())) {
        assert((base.size() & (base.size() - 1)) == 0 && "cube_pyramid: the size must be a power of two");
        levels.push_back(std::move(base));
        const auto moments_of_texels = moments_of(levels.front().size());
        for (int size = levels.front().size() / 2; size > 0; size /= 2)
            levels.push_back(reduced(levels.front(), moments_of_texels, size));
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
    using W = detail::wide_t<T>;

    /// int (1, x, y, x y) dw over a texel, x and y from -1/2 to 1/2 in it.
    struct moments {
        W one, x, y, xy;
    };
    static detail::cube_quarter<moments> moments_of(int size) {
        const gauss_legendre<W> rule(6);
        return {size, [&](int column, int row) {
                    moments m{};
                    for (std::size_t j = 0; j < rule.x.size(); ++j)
                        for (std::size_t i = 0; i < rule.x.size(); ++i) {
                            const auto on_face = [&](int k, const W& x) { return W(2) * (W(k) + x) / W(size) - W(1); };
                            const W x = rule.x[i] - W(0.5), y = rule.x[j] - W(0.5);
                            const W dw = W(4) * rule.w[i] * rule.w[j] / (W(size) * W(size)) *
                                         detail::cube_density(
                                             vec3<W>{on_face(column, rule.x[i]), on_face(row, rule.x[j]), W(1)});
                            m.one += dw, m.x += x * dw, m.y += y * dw, m.xy += x * y * dw;
                        }
                    return m;
                }};
    }

    /// Nodes of a coarser cube: each the mean of the image under the hat that look-ups give it. The hat is bilinear
    /// over any texel of the image, so that its integral there is one of the moments.
    static cube<T> reduced(const cube<T>& image, const detail::cube_quarter<moments>& of_texel, int size) {
        const std::size_t nodes = 6 * static_cast<std::size_t>(size) * static_cast<std::size_t>(size);
        std::vector<vec3<W>> totals(nodes, vec3<W>(W(0)));
        std::vector<W> weights(nodes, W(0));
        const W step = W(size) / W(image.size());
        image.for_each([&](int face, int column, int row, const vec3<T>& radiance) {
            const moments& m = of_texel.at(column, row);
            const auto along = [&](int k) { return (W(k) + W(0.5)) * step + W(0.5); };
            // the moments are of a quarter of the face, outward from its middle
            const auto outward = [&](int k) { return 2 * k + 1 > image.size() ? step : -step; };
            const W x = along(column), y = along(row), dx = outward(column), dy = outward(row);
            const int i = static_cast<int>(x), j = static_cast<int>(y);
            for (int corner = 0; corner < 4; ++corner) {
                const int right = corner % 2, down = corner / 2;
                const W tx = right ? x - W(i) : W(i + 1) - x, ty = down ? y - W(j) : W(j + 1) - y;
                const W sx = right ? dx : -dx, sy = down ? dy : -dy;
                const W hat = tx * ty * m.one + sx * ty * m.x + tx * sy * m.y + sx * sy * m.xy;
                cube<T>::for_each_source(size, face, i - 1 + right, j - 1 + down,
                                         [&](int f, int c, int r, const T& part) {
                                             const auto at = static_cast<std::size_t>((f * size + r) * size + c);
                                             totals[at] += vec3<W>(radiance) * (hat * W(part));
                                             weights[at] += hat * W(part);
                                         });
            }
        });
        std::vector<vec3<T>> means;
        for (std::size_t k = 0; k < nodes; ++k) means.push_back(vec3<T>(totals[k] / weights[k]));
        return cube<T>::of_nodes(size, std::move(means));
    }

    std::vector<cube<T>> levels;
    T per_texel;
};

}  // namespace lobe
