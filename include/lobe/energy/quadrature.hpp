// Integrals over the hemisphere of light directions by one deterministic rule that follows the half vector.
#pragma once

#include <lobe/core/spectrum.hpp>
#include <lobe/numeric/gauss_legendre.hpp>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <concepts>
#include <limits>
#include <type_traits>
#include <vector>

namespace lobe {

/// An integral, an estimate of its error, and what it cost. Converts to the value. The estimate is no bound: of 100
/// random integrals one may be off by more. Usually it is far too large. It counts the roundings in T of g and of the
/// directions it is asked at.
template <class S, class T>
struct estimate {
    S value;
    T error;
    int evaluations;
    constexpr operator const S&() const { return value; }
};

/// How hard to try. With `order = 0` the order goes 8, 12, 16, 24, 32, ... until the error is at most `tolerance`
/// (absolute; before the roundings in T), or the order 192. Otherwise the value is that of this order. In both cases
/// the error is 4 times the distance to the farther of two lower orders, 3/4 and 1/2 of it: one alone can agree by
/// accident. An isotropic lobe that says it is `smooth`, as microfacets of most maskings do, goes from 16 to 32, and
/// stops there if that changed it 64 times less than what made 16 of 8 and 12: the error is then 1/16 of this change.
/// For GGX that is 2976 evaluations.
/// An order n costs 2 n^2 evaluations for a view in the plane of symmetry of an isotropic BRDF, 4 n^2 for any other,
/// and with the two lower ones 1.8 times that; with a critical angle, 2 to 5 times more.
struct quadrature {
    double tolerance = 1e-6;  // house: asked of the result, part of no formula
    int order = 0;
};

namespace detail {

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

template <class S, class W>
struct converged {
    S value;
    W error;
    int order;
};

/// The value at an order, with the error that `quadrature` describes: at the order asked for, or at the first that
/// meets the tolerance. `smooth`: the integrand has no crease.
template <class W, class AtOrder>
auto converge(const AtOrder& at_order, const quadrature& options, int last, bool smooth = false) {
    int order = options.order ? options.order : 16;
    auto half = at_order(order / 2), lower = at_order(3 * order / 4), value = at_order(order);
    using value_type = decltype(value);
    const auto error = [&] { return W(4) * W(larger(difference(value, half), difference(value, lower))); };
    if (smooth && !options.order && error() > W(options.tolerance)) {
        // From 16 to 32 at once. Where that gains 64 times, n^-6 (smooth ones gain n^-7 to n^-8), the next doubling
        // would gain as much; a quarter of it is believed.
        const auto twice = at_order(32);
        const W before = error() / W(4), now = W(larger(difference(twice, value), difference(twice, lower) / 8));
        if (now <= before / W(64) && now / W(16) <= W(options.tolerance))
            return converged<value_type, W>{twice, now / W(16), 32};
        half = value;
        lower = at_order(24);
        value = twice;
        order = 32;
    }
    while (!options.order && error() > W(options.tolerance) && order < last) {
        order = order % 3 ? order / 2 * 3 : order / 3 * 4;
        half = lower;
        lower = value;
        value = at_order(order);
    }
    return converged<value_type, W>{value, error(), order};
}

/// What a value may be off by because g is rounded to T, and because the direction l is: by u, which shifts the half
/// vector by u/mu slopes, at random, so that its effect on a lobe of that width goes down with the root of the
/// evaluations. Measured, in units of what is in the bracket and epsilon |value|: 1 at most for most models, for all
/// 3.5.
template <class T, class S>
auto rounding(const S& value, const wide_t<T>& width_times_mu, int order) {
    using W = wide_t<T>;
    return W(4) * W(std::numeric_limits<T>::epsilon()) * W(magnitude(value)) *
           (W(1) + W(1) / (width_times_mu * W(order)));
}

/// A node x of [0,1] as one of a piece of a longer range: nodes crowd towards the end at 0 like a cube, and towards the
/// other like a square where the range goes on there.
template <class W>
struct crowded {
    W at, slope;
    crowded(const W& x, bool goes_on)
        : at(x * x * x * (goes_on ? W(4) - W(3) * x : W(1))), slope(W(3) * x * x * (goes_on ? W(4) - W(4) * x : W(1))) {
    }
};

/// A direction of slopes at which the rule is cut, on both sides of the azimuth of v: its part along v's azimuth, and
/// the square of that across it; none if that is not positive.
template <class W>
struct azimuth_mark {
    W along, across2;
};

/// Of creases v.m = c, of reflection: where c is on the horizon, and where a ray touches the circle.
template <class W>
std::vector<azimuth_mark<W>> reflection_marks(const std::vector<W>& creases, const vec3<W>& v) {
    using std::sqrt;
    std::vector<azimuth_mark<W>> marks;
    const W s = sqrt(v.x * v.x + v.y * v.y);
    if (s > W(0))
        for (const W& c : creases) {
            // v.l on the circle, and of an l on the horizon the part along v
            const W h = W(2) * c * c - W(1), out = h / s;
            marks.push_back({-(s + out), W(1) - out * out});
            const W q = (c - v.z) * (c + v.z);  // n outside of the circle: rays touch it
            if (q > W(0)) marks.push_back({-sqrt(q), s * s - q});
        }
    return marks;
}

/// Where each quarter of the circle is cut, as angles delta from the azimuth at which the horizon bends. See
/// `hemisphere_integral_at`.
template <class W>
std::array<std::vector<W>, 4> azimuths_of(const std::vector<azimuth_mark<W>>& marks, const vec3<W>& v,
                                          const vec2<W>& width, const vec2<W>& toward) {
    using std::abs, std::atan2, std::sqrt;
    std::array<std::vector<W>, 4> deltas;
    for (auto& quarter : deltas) quarter.push_back(W(0));
    for (const auto& [along, across2] : marks) {
        if (!(across2 > W(0))) continue;
        for (const W& across : {sqrt(across2), -sqrt(across2)}) {
            const W x = (along * v.x - across * v.y) / width.x, y = (along * v.y + across * v.x) / width.y;
            const W cosine = x * toward.x + y * toward.y, sine = y * toward.x - x * toward.y;
            deltas[(cosine < W(0) ? 1u : 0u) + (sine < W(0) ? 2u : 0u)].push_back(atan2(abs(cosine), abs(sine)));
        }
    }
    for (auto& quarter : deltas) {
        quarter.push_back(pi<W>() / W(2));
        std::sort(quarter.begin(), quarter.end());
    }
    return deltas;
}

/// The slopes along a ray at which v.m = c, up to the horizon.
template <class W>
void add_slopes(std::vector<W>& slopes, const W& c, const W& vz, const W& p, const W& d2, const W& r_max) {
    using std::sqrt;
    const W q = (vz - c) * (vz + c), discriminant = p * p + d2 * q;
    if (!(discriminant > W(0))) return;
    const W root = c * sqrt(discriminant), k = vz * p + (p < W(0) ? -root : root);
    for (const W& r : {q / k, k / (p * p - c * c * d2)})
        if (r > W(0) && r < r_max) slopes.push_back(r);
}

/// The nodes of `hemisphere_integral_at` at an order, made once for any number of views.
template <class W>
struct hemisphere_rule {
    struct azimuth {
        W sine, cosine, weight;
    };
    /// Of each node: how far it is from the end of the ray, and its weight, both for a ray of length 1.
    struct ray {
        std::vector<W> back, weight;
    };

    gauss_legendre<W> rule;
    std::vector<azimuth> quarter;  // of the circle, from where the horizon bends
    ray whole, cut;                // cut: from a crease on

    hemisphere_rule(int order) : rule(order), quarter(azimuths(W(0), pi<W>() / W(2), false)) {
        for (std::size_t j = 0; j < rule.x.size(); ++j) {
            const W x = rule.x[j], y = W(1) - x, y3 = y * y * y, weight = W(8) * rule.w[j] * y3;
            whole.back.push_back(y * y3);
            whole.weight.push_back(weight);
            cut.back.push_back(y * y3 * (W(5) - W(4) * y));
            cut.weight.push_back(weight * W(5) * x);
        }
    }

    /// Of a piece of a quarter; `goes_on`: it ends at a crease.
    std::vector<azimuth> azimuths(const W& from, const W& to, bool goes_on) const {
        using std::cos, std::sin;
        std::vector<azimuth> nodes;
        for (std::size_t i = 0; i < rule.x.size(); ++i) {
            const crowded<W> node(rule.x[i], goes_on);
            const W delta = from + (to - from) * node.at;
            nodes.push_back({sin(delta), cos(delta), rule.w[i] * (to - from) * node.slope});
        }
        return nodes;
    }
};

/// A sum for each node of a ray, so that the loop over the nodes vectorises; of vectors component by component, because
/// g++ does not otherwise.
template <class S>
class node_sums {
    std::vector<S> sums;

public:
    node_sums(std::size_t nodes, const S& zero) : sums(nodes, zero) {}
    auto adder() {
        return [sum = sums.data()](std::size_t j, const S& g) { sum[j] = sum[j] + g; };
    }
    S total() const {
        S all = sums[0];
        for (std::size_t j = 1; j < sums.size(); ++j) all = all + sums[j];
        return all;
    }
};
template <int N, scalar W>
class node_sums<glm::vec<N, W, glm::defaultp>> {
    using S = glm::vec<N, W, glm::defaultp>;
    std::array<std::vector<W>, std::size_t{N}> sums;

public:
    node_sums(std::size_t nodes, const S& zero) { sums.fill(std::vector<W>(nodes, zero.x)); }
    auto adder() {
        std::array<W*, std::size_t{N}> sum;
        for (std::size_t c = 0; c < sum.size(); ++c) sum[c] = sums[c].data();
        return [sum](std::size_t j, const S& g) {
            for (int c = 0; c < N; ++c) sum[static_cast<std::size_t>(c)][j] += g[c];
        };
    }
    S total() const {
        S all(W(0));
        for (int c = 0; c < N; ++c)
            for (const W& sum : sums[static_cast<std::size_t>(c)]) all[c] += sum;
        return all;
    }
};

/// Adds g along a ray of slopes r (dx, dy), from t = from to t = to, each node to a sum of its own: a loop that
/// vectorises where g does.
template <class T, class G, class S, class W>
void add_along(const typename hemisphere_rule<W>::ray& nodes, const W from, const W to, const W dx, const W dy,
               const vec3<W> v, const W ray_weight, const G& integrand, node_sums<S>& sums) {
    // a copy, which no store to the sums can change, unless there is a table in it
    constexpr bool by_value = std::is_trivially_copyable_v<G> && sizeof(G) <= 256;
    const std::conditional_t<by_value, const G, const G&> g = integrand;
    const W *back = nodes.back.data(), *weights = nodes.weight.data();
    const auto add = sums.adder();
    const W length = to - from, d2 = dx * dx + dy * dy, e = dx * v.x + dy * v.y, weight = ray_weight * length;
    const std::size_t count = nodes.back.size();
    for (std::size_t j = 0; j < count; ++j) {
        // c, s: cosine and sine of chi, times 1 + t^2
        const W t = to - length * back[j], c = (W(1) - t) * (W(1) + t), s = W(2) * t;
        const W q = W(1) / (c * c + d2 * s * s);          // m = (-s dx, -s dy, c) sqrt(q)
        const W a = v.z * c - s * e;                      // v.m / sqrt(q)
        const W v_m_dm = a * s * (W(1) + t * t) * q * q;  // (v.m) dm, less factors that the caller has
        const W k = W(2) * a * q;
        const vec3<T> l(T(-k * s * dx - v.x), T(-k * s * dy - v.y), T(k * c - v.z));
        add(j, S(g(l)) * (v_m_dm * weights[j] * weight));
    }
}

/// int g(l) dl over the hemisphere, at one order. l = reflect(v, m), dl = 4 (v.m) dm, and m runs over slopes r (wx cos
/// phi, wy sin phi), with r = tan(chi) and t = tan(chi/2) the variable, out to where l meets the horizon. In the polar
/// coordinates of slopes that is a circle, so the limit is exact:
///   r_max = 1/(b + sqrt(b^2 + |d|^2)),  d = (wx cos phi, wy sin phi),  b = d.(v.x, v.y)/v.z.
/// r_max bends sharply where b = 0, at two azimuths, so each quarter of the circle starts there and its nodes crowd
/// towards it: cos = +-sin(delta), delta = (pi/2) x^3; and towards the horizon: t = t_max (1 - (1-y)^4),
/// the fourth power instead of the second because it takes the error at order 32 from 3e-6 to 2e-8.
/// `mirrored`: g is even in the azimuth around the plane of v and n, so two quarters do for four.
///
/// `creases`: cosines v.m = c at which g has a kink, or the root of a total reflection. Both variables are cut there,
/// so that each piece is smooth: the slopes along a ray where
///   v.m = c:  (p^2 - c^2 |d|^2) r^2 - 2 v.z p r + q = 0,  p = d.(v.x, v.y),  q = v.z^2 - c^2,
/// with nodes that crowd like the root on both sides of a cut; the azimuths where a ray touches that circle, and those
/// where it meets the horizon. `evaluations`: how many are added to it.
template <class T, class G>
auto hemisphere_integral_at(const G& g, const vec3<T>& v, const vec2<T>& width, bool mirrored,
                            const hemisphere_rule<wide_t<T>>& rule, const std::vector<wide_t<T>>& creases = {},
                            int* evaluations = nullptr) {
    using W = wide_t<T>;
    using S = wide_t<decltype(g(v))>;
    using std::sqrt;

    const vec3<W> view(W(v.x), W(v.y), W(v.z));
    const W wx = W(width.x), wy = W(width.y);
    const W bx = wx * view.x / view.z, by = wy * view.y / view.z, b_max = sqrt(bx * bx + by * by);
    // azimuth of v, stretched
    const W toward_x = b_max > W(0) ? bx / b_max : W(1), toward_y = b_max > W(0) ? by / b_max : W(0);

    node_sums<S> sums(rule.quarter.size(), S(W(0)));
    std::vector<W> slopes;
    const auto add_rays = [&](const std::vector<typename hemisphere_rule<W>::azimuth>& azimuths, int quarter) {
        for (const auto& at : azimuths) {
            const W cosine = quarter % 2 ? -at.sine : at.sine, sine = quarter / 2 ? -at.cosine : at.cosine;
            const W dx = wx * (cosine * toward_x - sine * toward_y), dy = wy * (cosine * toward_y + sine * toward_x);
            const W d2 = dx * dx + dy * dy, b = b_max * cosine, root = sqrt(b * b + d2);
            const W r_max = b > W(0) ? W(1) / (b + root) : (root - b) / d2;
            slopes.clear();
            for (const W& c : creases) add_slopes(slopes, c, view.z, view.z * b, d2, r_max);
            std::sort(slopes.begin(), slopes.end());
            slopes.push_back(r_max);
            W from(0);
            for (const W& slope : slopes) {
                const W to = slope / (W(1) + sqrt(W(1) + slope * slope));
                add_along<T>(from > W(0) ? rule.cut : rule.whole, from, to, dx, dy, view, at.weight, g, sums);
                from = to;
            }
            if (evaluations) *evaluations += static_cast<int>(slopes.size() * azimuths.size());
        }
    };
    const auto cuts = azimuths_of(reflection_marks(creases, view), view, vec2<W>{wx, wy}, vec2<W>{toward_x, toward_y});
    for (int quarter = 0; quarter < (mirrored ? 2 : 4); ++quarter) {
        const auto& deltas = cuts[static_cast<std::size_t>(quarter)];
        if (deltas.size() == 2)
            add_rays(rule.quarter, quarter);
        else
            for (std::size_t k = 0; k < deltas.size() - 1; ++k)
                add_rays(rule.azimuths(deltas[k], deltas[k + 1], k + 2 < deltas.size()), quarter);
    }
    return sums.total() * (W(mirrored ? 8 : 4) * wx * wy);
}

}  // namespace detail

/// int g(l) dl over the upper hemisphere, for a g that follows reflections from v by a surface whose slopes have the
/// scale `width`: f_cos, a pdf, each times anything smooth. Unit v above the horizon. Scalar types only.
/// `creases`: the cosines v.m in (0,1) at which g has a kink, m the half vector: critical angles. The nodes are cut
/// there. `smooth`: g has no kink at all; with `mirrored` fewer orders do.
template <scalar T, class G>
auto hemisphere_integral(const G& g, const vec3<T>& v, const vec2<T>& width, bool mirrored,
                         const quadrature& options = {}, const std::vector<detail::wide_t<T>>& creases = {},
                         bool smooth = false) {
    using S = decltype(g(v));
    using W = detail::wide_t<T>;
    assert(v.z > T(0) && width.x > T(0) && width.y > T(0) &&
           "hemisphere_integral: v must be above the horizon, widths above 0");
    assert((options.order == 0 || options.order >= 2) && "hemisphere_integral: order must be at least 2, or 0");
    int evaluations = 0;
    const auto at_order = [&](int order) {
        return detail::hemisphere_integral_at(g, v, width, mirrored, order, creases, &evaluations);
    };
    const auto result = detail::converge<W>(at_order, options, 192, smooth && mirrored && creases.empty());
    const W rounded = detail::rounding<T>(result.value, W(smaller(width.x, width.y)) * W(v.z), result.order);
    return estimate<S, T>{S(result.value), T(result.error + rounded), evaluations};
}

}  // namespace lobe
