// Integrals over the hemisphere of light directions by one deterministic rule that follows the half vector.
#pragma once

#include <lobe/core/spectrum.hpp>

#include <cassert>
#include <cmath>
#include <concepts>
#include <limits>
#include <vector>

namespace lobe {

/// An integral, an estimate of its error (no bound: it is how far the last orders were apart, and so usually far too large),
/// and what it cost. Converts to the value.
template <class S, class T>
struct estimate {
    S value;
    T error;
    int evaluations;
    constexpr operator const S&() const { return value; }
};

/// How hard to try. With `order = 0` the order doubles from 8 until three agree within `tolerance` (absolute), or reaches
/// 256: two can agree by accident. Otherwise the value is that of this order, and its error the distance to half of it.
/// An order n costs 2 n^2 evaluations for a view in the plane of symmetry of an isotropic BRDF, 4 n^2 for any other.
struct quadrature {
    double tolerance = 1e-6;  // house: asked of the result, part of no formula
    int order = 0;
};

namespace detail {

/// Gauss-Legendre nodes and weights on [0,1], by Newton's method from Tricomi's first guess. Scalar types only.
template <scalar T>
struct gauss_legendre {
    std::vector<T> x, w;

    explicit gauss_legendre(int n) : x(static_cast<std::size_t>(n)), w(static_cast<std::size_t>(n)) {
        using std::abs;
        for (int i = 0; i < (n + 1) / 2; ++i) {
            T z(std::cos(3.141592653589793 * (i + 0.75) / (n + 0.5)));
            T slope(0), step(1);
            for (int iteration = 0; iteration < 50 && abs(step) > T(2) * std::numeric_limits<T>::epsilon(); ++iteration) {
                T p(1), previous(0);
                for (int k = 0; k < n; ++k) {
                    const T next = z * p + (z * p - previous) * (T(k) / T(k + 1));
                    previous = p;
                    p = next;
                }
                slope = T(n) * (z * p - previous) / (z * z - T(1));
                step = p / slope;
                z -= step;
            }
            const auto low = static_cast<std::size_t>(i), high = static_cast<std::size_t>(n - 1 - i);
            x[low] = (T(1) - z) / T(2);
            x[high] = (T(1) + z) / T(2);
            w[low] = w[high] = T(1) / ((T(1) - z * z) * slope * slope);
        }
    }
};

/// The size of a spectrum, for comparing: its largest component.
template <scalar T>
T magnitude(const T& s) {
    return larger(s, -s);
}
template <scalar T>
T magnitude(const vec2<T>& s) {
    return larger(magnitude(s.x), magnitude(s.y));
}
template <scalar T>
T magnitude(const vec3<T>& s) {
    return larger(larger(magnitude(s.x), magnitude(s.y)), magnitude(s.z));
}
template <class S>
    requires requires(const S s) {
        s.begin();
        s.end();
    }
auto magnitude(const S& s) {
    auto largest = magnitude(*s.begin());
    for (const auto& component : s) largest = larger(largest, magnitude(component));
    return largest;
}

template <class S>
auto difference(const S& a, const S& b) {
    return magnitude(S(a - b));
}

/// How far successive orders are apart: the last step, or an eighth of the one before if that is more.
template <class T>
struct agreement {
    T size = T(0), previous = T(0);
    int steps = 0;

    void add(const T& step) {
        size = larger(step, previous / T(8));
        previous = step;
        ++steps;
    }
    bool within(const T& tolerance) const { return steps > 1 && !(size > tolerance); }
};

/// int g(l) dl over the hemisphere, at one order. l = reflect(v, m), dl = 4 (v.m) dm, and m runs over slopes
/// r (wx cos phi, wy sin phi), with r = tan(chi) and t = tan(chi/2) the variable, out to where l meets the horizon. In the polar
/// coordinates of slopes that is a circle, so the limit is exact:
///   r_max = 1/(b + sqrt(b^2 + |d|^2)),  d = (wx cos phi, wy sin phi),  b = d.(v.x, v.y)/v.z.
/// r_max bends sharply where b = 0, at two azimuths, so each quarter of the circle starts there and its nodes crowd
/// towards it: cos = +-sin(delta), delta = (pi/2) x^3; and towards the horizon: t = t_max (1 - (1-y)^4),
/// the fourth power instead of the second because it takes the error at order 32 from 3e-6 to 2e-8.
/// `mirrored`: g is even in the azimuth around the plane of v and n, so two quarters do for four.
template <class T, class G>
auto hemisphere_integral_at(const G& g, const vec3<T>& v, const vec2<T>& width, bool mirrored, int order) {
    using W = wide_t<T>;
    using S = wide_t<decltype(g(v))>;
    using std::cos, std::sin, std::sqrt;

    const gauss_legendre<W> rule(order);
    const W wx = W(width.x), wy = W(width.y), vx = W(v.x), vy = W(v.y), vz = W(v.z);
    const W bx = wx * vx / vz, by = wy * vy / vz, b_max = sqrt(bx * bx + by * by);
    const W toward_x = b_max > W(0) ? bx / b_max : W(1), toward_y = b_max > W(0) ? by / b_max : W(0);  // azimuth of v, stretched

    S total(W(0));
    for (int quarter = 0; quarter < (mirrored ? 2 : 4); ++quarter) {
        for (int i = 0; i < order; ++i) {
            const W x = rule.x[static_cast<std::size_t>(i)];
            const W delta = pi<W>() / W(2) * x * x * x;
            const W cosine = quarter % 2 ? -sin(delta) : sin(delta), sine = quarter / 2 ? -cos(delta) : cos(delta);
            const W dx = wx * (cosine * toward_x - sine * toward_y), dy = wy * (cosine * toward_y + sine * toward_x);
            const W d2 = dx * dx + dy * dy, b = b_max * cosine, root = sqrt(b * b + d2);
            const W r_max = b > W(0) ? W(1) / (b + root) : (root - b) / d2;
            const W t_max = r_max / (W(1) + sqrt(W(1) + r_max * r_max));
            const W d_phi = rule.w[static_cast<std::size_t>(i)] * W(1.5) * pi<W>() * x * x;
            for (int j = 0; j < order; ++j) {
                const W y = W(1) - rule.x[static_cast<std::size_t>(j)];
                const W t = t_max * (W(1) - y * y * y * y);
                const W r = W(2) * t / ((W(1) - t) * (W(1) + t));
                const W d_chi = rule.w[static_cast<std::size_t>(j)] * W(8) * t_max * y * y * y / (W(1) + t * t);
                const W mz2 = W(1) / (W(1) + d2 * r * r);  // m = (-r dx, -r dy, 1) sqrt(mz2)
                const W a = vz - r * (dx * vx + dy * vy);  // v.m / m.z
                const W dm = wx * wy * r * (W(1) + r * r) * mz2 * sqrt(mz2) * d_chi * d_phi;
                const vec3<T> l(T(-W(2) * a * mz2 * r * dx - vx), T(-W(2) * a * mz2 * r * dy - vy), T(W(2) * a * mz2 - vz));
                total = total + S(g(l)) * (W(4) * a * sqrt(mz2) * dm);
            }
        }
    }
    return total * W(mirrored ? 2 : 1);
}

}  // namespace detail

/// int g(l) dl over the upper hemisphere, for a g that follows reflections from v by a surface whose slopes have the scale
/// `width`: f_cos, a pdf, each times anything smooth. Unit v above the horizon. Scalar types only.
template <scalar T, class G>
auto hemisphere_integral(const G& g, const vec3<T>& v, const vec2<T>& width, bool mirrored, const quadrature& options = {}) {
    using S = decltype(g(v));
    using W = detail::wide_t<T>;
    assert(v.z > T(0) && width.x > T(0) && width.y > T(0) && "hemisphere_integral: v must be above the horizon, widths above 0");
    assert((options.order == 0 || options.order >= 2) && "hemisphere_integral: order must be at least 2, or 0");
    const int per_square = mirrored ? 2 : 4;
    int order = options.order ? options.order / 2 : 8;
    auto value = detail::hemisphere_integral_at(g, v, width, mirrored, order);
    int evaluations = per_square * order * order;
    detail::agreement<W> error;
    do {
        const auto coarse = value;
        order = options.order ? options.order : 2 * order;
        value = detail::hemisphere_integral_at(g, v, width, mirrored, order);
        evaluations += per_square * order * order;
        error.add(detail::difference(value, coarse));
    } while (!options.order && !error.within(W(options.tolerance)) && order < 256);
    return estimate<S, T>{S(value), T(error.size), evaluations};
}

}  // namespace lobe
