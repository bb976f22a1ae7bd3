// An environment, or its irradiance, as spherical harmonics.
#pragma once

#include <lobe/core/spectrum.hpp>
#include <lobe/ibl/cube.hpp>
#include <lobe/ibl/latlong.hpp>

#include <cassert>
#include <cmath>
#include <vector>

namespace lobe {

namespace detail {

/// Each real harmonic of a unit direction up to a degree to g(l, m, Y), in the order l = 0, 1, ..., m = -l..l.
/// Orthonormal, without the Condon-Shortley phase: Y_00 = 1/sqrt(4 pi), (Y_1-1, Y_10, Y_11) = sqrt(3/(4 pi)) (y, z, x).
/// By recurrences in l of the normalised Legendre functions (Holmes & Featherstone 2002) over sine^m, which x and y
/// carry: no division by a sine.
template <scalar T, class G>
void for_each_harmonic(const vec3<T>& w, int degree, const G& g) {
    using std::sqrt;
    const auto count = static_cast<std::size_t>(degree) + 1;
    // sine^m cos(m phi) and sine^m sin(m phi), and the values of one m for all l
    std::vector<T> cosines(count, T(1)), sines(count, T(0)), values(count * count, T(0));
    for (std::size_t m = 1; m < count; ++m) {
        cosines[m] = cosines[m - 1] * w.x - sines[m - 1] * w.y;
        sines[m] = cosines[m - 1] * w.y + sines[m - 1] * w.x;
    }
    T diagonal = sqrt(inv_pi<T>() / T(4));
    for (int m = 0; m <= degree; ++m) {
        if (m > 0) diagonal = diagonal * sqrt(T(2 * m + 1) / T(2 * m));
        T before(0), now = diagonal;
        for (int l = m; l <= degree; ++l) {
            values[static_cast<std::size_t>(l) * count + static_cast<std::size_t>(m)] = now;
            const T above = T((l + 1) * (l + 1) - m * m), a = sqrt(T((2 * l + 1) * (2 * l + 3)) / above);
            const T b = sqrt(T(2 * l + 3) * T(l * l - m * m) / (T(2 * l - 1) * above));
            const T next = a * w.z * now - (l > m ? b * before : T(0));
            before = now;
            now = next;
        }
    }
    for (int l = 0; l <= degree; ++l)
        for (int m = -l; m <= l; ++m) {
            const auto k = static_cast<std::size_t>(m < 0 ? -m : m);
            const T P = values[static_cast<std::size_t>(l) * count + k];
            g(l, m, m == 0 ? P : P * sqrt(T(2)) * (m < 0 ? sines[k] : cosines[k]));
        }
}

/// 2 pi int_0^1 P_l(x) x dx: what the cosine does to a harmonic of degree l. Ramamoorthi & Hanrahan 2001, eq. 8, by the
/// recurrence A_l = -A_{l-2} (l - 3)/(l + 2) of even l; odd ones above 1 are 0.
template <scalar T>
T cosine_harmonic(int l) {
    if (l == 0) return pi<T>();
    if (l == 1) return T(2) / T(3) * pi<T>();
    if (l % 2) return T(0);
    T A = pi<T>() / T(4);
    for (int k = 4; k <= l; k += 2) A = -A * T(k - 3) / T(k + 2);
    return A;
}

}  // namespace detail

/// A function on the sphere as (degree + 1)^2 coefficients, rgb, in the order of l, then m = -l..l: see
/// `for_each_harmonic`. Called with a unit direction it gives its value.
template <scalar T>
class harmonics {
public:
    explicit harmonics(int highest_degree)
        : coefficients(static_cast<std::size_t>(highest_degree + 1) * static_cast<std::size_t>(highest_degree + 1),
                       vec3<T>(T(0))),
          n(highest_degree) {
        assert(n >= 0 && "harmonics: the degree must not be negative");
    }

    /// int L Y dw of a map, by its texels and their exact solid angles. Ramamoorthi & Hanrahan 2001, "An Efficient
    /// Representation for Irradiance Environment Maps", eq. 10.
    harmonics(const latlong<T>& map, int highest_degree) : harmonics(highest_degree) {
        for (int row = 0; row < map.height; ++row)
            for (int column = 0; column < map.width; ++column)
                add(latlong_direction(vec2<W>{(W(column) + W(0.5)) / W(map.width), (W(row) + W(0.5)) / W(map.height)}),
                    map.at(column, row), latlong_texel_solid_angle<W>(row, map.width, map.height));
        finish();
    }
    harmonics(const cube<T>& map, int highest_degree) : harmonics(highest_degree) {
        const W size = W(map.size());
        map.for_each([&](int face, int column, int row, const vec3<T>& radiance) {
            add(cube_direction(face, vec2<W>{(W(column) + W(0.5)) / size, (W(row) + W(0.5)) / size}), radiance,
                cube_texel_solid_angle<W>(column, row, map.size()));
        });
        finish();
    }

    int degree() const { return n; }
    const vec3<T>& at(int l, int m) const { return coefficients[static_cast<std::size_t>(l * (l + 1) + m)]; }
    vec3<T>& at(int l, int m) { return coefficients[static_cast<std::size_t>(l * (l + 1) + m)]; }

    vec3<T> operator()(const vec3<T>& w) const {
        vec3<T> total(T(0));
        detail::for_each_harmonic(w, n, [&](int l, int m, const T& Y) { total += at(l, m) * Y; });
        return total;
    }

    /// Of radiance: irradiance/pi, as `irradiance` has it. Exact for what is below this degree. A sun rings: it is off
    /// by up to 9 % of its own peak at degree 2, and negative; `windowed` by a little, or `larger(0, ...)`.
    harmonics irradiance() const {
        return scaled([](int l) { return detail::cosine_harmonic<T>(l) * inv_pi<T>(); });
    }

    /// Against ringing: each degree times 1/(1 + lambda l^2 (l + 1)^2), which makes the squared Laplacian smaller.
    /// Sloan 2008, "Stupid Spherical Harmonics (SH) Tricks", "Windowing". lambda 0 changes nothing. The mean stays.
    harmonics windowed(const T& lambda) const {
        return scaled([&](int l) { return T(1) / (T(1) + lambda * T(l * l) * T((l + 1) * (l + 1))); });
    }
    /// ... by the smallest lambda, to a factor of 1.1, for which no channel is below 0, as far as 4096 directions tell.
    harmonics windowed_above_zero() const {
        if (lowest() >= T(0)) return *this;
        T lambda = T(1) / T(10000);  // house: where the search begins, too small to see
        while (lambda < T(1e4f) && windowed(lambda).lowest() < T(0)) lambda = lambda * T(1.1f);
        return windowed(lambda);
    }

    std::vector<vec3<T>> coefficients;

private:
    using W = detail::wide_t<T>;

    void add(const vec3<W>& w, const vec3<T>& radiance, const W& solid_angle) {
        sums.resize(coefficients.size(), vec3<W>(W(0)));
        of_white.resize(coefficients.size(), W(0));
        const vec3<W> light = vec3<W>(radiance) * solid_angle;
        std::size_t i = 0;
        detail::for_each_harmonic(w, n, [&](int, int, const W& Y) {
            sums[i] += light * Y;
            of_white[i++] += solid_angle * Y;
        });
    }
    /// The mean by itself, and the rest by what differs from it: so that a constant is one, whatever the texels.
    void finish() {
        using std::sqrt;
        const vec3<W> mean = sums[0] / of_white[0];
        coefficients[0] = vec3<T>(mean * sqrt(W(4) * pi<W>()));
        for (std::size_t i = 1; i < sums.size(); ++i) coefficients[i] = vec3<T>(sums[i] - mean * of_white[i]);
        sums = {};
        of_white = {};
    }

    template <class Factor>
    harmonics scaled(const Factor& factor) const {
        harmonics out(n);
        for (int l = 0; l <= n; ++l)
            for (int m = -l; m <= l; ++m) out.at(l, m) = at(l, m) * factor(l);
        return out;
    }
    T lowest() const {
        T least = (*this)({T(0), T(0), T(1)}).x;
        for (int row = 0; row < 32; ++row)
            for (int column = 0; column < 128; ++column) {
                const vec3<T> value =
                    (*this)(latlong_direction(vec2<T>{(T(column) + T(0.5f)) / T(128), (T(row) + T(0.5f)) / T(32)}));
                least = smaller(least, smaller(value.x, smaller(value.y, value.z)));
            }
        return least;
    }

    int n;
    std::vector<vec3<W>> sums;
    std::vector<W> of_white;
};

}  // namespace lobe
