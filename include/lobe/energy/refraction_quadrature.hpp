// Integrals over the directions that a rough interface refracts to, by a rule that follows the half vector.
#pragma once

#include <lobe/bsdf/refraction.hpp>
#include <lobe/energy/quadrature.hpp>

namespace lobe {

namespace detail {

/// A node x of [0,1] as one of a piece, with nodes that crowd towards both ends like a cube.
template <class W>
struct crowded_twice {
    W at, slope;
    explicit crowded_twice(const W& x) {
        const W y = W(1) - x, a = x * x * x, b = y * y * y, sum = a + b;
        at = a / sum;
        slope = W(3) * x * x * y * y / (sum * sum);
    }
};

/// Directions of slopes at which what refracts bends, met from the denser side:
/// where a ray touches the circle of total reflection v.m = c, where that goes to infinity, where a ray touches the
/// circle of l on the horizon, and where the two circles meet.
template <class W>
std::vector<azimuth_mark<W>> refraction_marks(const W& n, const W& critical, const vec3<W>& v) {
    using std::sqrt;
    std::vector<azimuth_mark<W>> marks;
    const W s2 = v.x * v.x + v.y * v.y, s = sqrt(s2);
    if (!(n < W(1)) || !(s > W(0))) return marks;
    const W q = (critical - v.z) * (critical + v.z);
    if (q > W(0)) marks.push_back({-sqrt(q), s2 - q});
    marks.push_back({-critical, s2 - critical * critical});
    if (s > n) {
        const W rest = (s - n) * (s + n);
        marks.push_back({-sqrt(rest), n * n});
        marks.push_back({-rest / s, n * n * rest / s2});
    }
    return marks;
}

/// int g(l) dl over the other side, at one order, v above the surface: l = -(v + K m)/n, dl = K^2/(n g) dm.
/// m runs over slopes r (wx cos phi, wy sin phi), with the variables of `hemisphere_integral_at`, along each ray out to
/// v.m = 0:  r_max = v.z/(d.(v.x, v.y)), d = (wx cos phi, wy sin phi), or infinity.
/// From the denser side a ray is cut where all is reflected, v.m = sqrt(1 - n^2), and where l is on the horizon:
///   v.z^2 |d|^2 r^2 + 2 v.z d.(v.x, v.y) r + v.x^2 + v.y^2 - n^2 = 0.
template <class T, class G>
auto refraction_integral_at(const G& g, const vec3<T>& v, const dielectric_side<wide_t<T>>& side, const vec2<T>& width,
                            bool mirrored, const hemisphere_rule<wide_t<T>>& rule, int* evaluations = nullptr) {
    using W = wide_t<T>;
    using S = wide_t<decltype(g(v))>;
    using std::sqrt;

    const vec3<W> view(W(v.x), W(v.y), W(v.z));
    const W wx = W(width.x), wy = W(width.y), critical = side.e < W(0) ? sqrt(-side.e) : W(0);
    const W px = wx * view.x, py = wy * view.y, p_max = sqrt(px * px + py * py);
    const W toward_x = p_max > W(0) ? px / p_max : W(1), toward_y = p_max > W(0) ? py / p_max : W(0);

    S sum(W(0));
    int count = 0;
    const auto add_piece = [&](const W& from, const W& to, const W& dx, const W& dy, const W& weight) {
        for (std::size_t j = 0; j < rule.rule.x.size(); ++j) {
            const crowded_twice<W> node(rule.rule.x[j]);
            const W t = from + (to - from) * node.at, up = (W(1) - t) * (W(1) + t), out = W(2) * t;
            const W size = sqrt(up * up + out * out * (dx * dx + dy * dy));
            const vec3<W> m(-out * dx / size, -out * dy / size, up / size);
            const W c = dot(view, m);
            if (!(c > W(0))) continue;
            const auto through = side.cross(c);
            const vec3<W> l = side.refracted(view, m, through.K);
            if (!(through.g > W(0)) || !(l.z < W(0))) continue;
            // dm = cos^3 r dr dphi in slopes, r = 2t/(1 - t^2)
            const W dm = out * (W(1) + t * t) * W(2) / (size * size * size);
            const W dl = through.K * through.K / (side.n * through.g) * dm;
            sum =
                sum + S(g(vec3<T>(T(l.x), T(l.y), T(l.z)))) * (dl * rule.rule.w[j] * node.slope * (to - from) * weight);
        }
        count += static_cast<int>(rule.rule.x.size());
    };
    std::vector<W> cuts;
    const auto add_rays = [&](const std::vector<typename hemisphere_rule<W>::azimuth>& azimuths, int quarter) {
        for (const auto& at : azimuths) {
            const W cosine = quarter % 2 ? -at.sine : at.sine, sine = quarter / 2 ? -at.cosine : at.cosine;
            const W dx = wx * (cosine * toward_x - sine * toward_y), dy = wy * (cosine * toward_y + sine * toward_x);
            const W d2 = dx * dx + dy * dy, p = p_max * cosine;
            cuts.clear();
            if (critical > W(0)) {
                const W end = p > W(0) ? view.z / p : std::numeric_limits<W>::max();
                add_slopes(cuts, critical, view.z, p, d2, end);
                const W q = (view.x * view.x + view.y * view.y - side.n * side.n) / (view.z * view.z * d2),
                        half = p / (view.z * d2), discriminant = half * half - q;
                if (discriminant > W(0))
                    for (const W& r : {-half - sqrt(discriminant), -half + sqrt(discriminant)})
                        if (r > W(0) && r < end) cuts.push_back(r);
                std::sort(cuts.begin(), cuts.end());
            }
            const auto half_angle = [](const W& r) { return r / (W(1) + sqrt(W(1) + r * r)); };
            W from(0);
            for (const W& r : cuts) {
                add_piece(from, half_angle(r), dx, dy, at.weight);
                from = half_angle(r);
            }
            add_piece(from, p > W(0) ? half_angle(view.z / p) : W(1), dx, dy, at.weight);
        }
    };
    const auto cut =
        azimuths_of(refraction_marks(side.n, critical, view), view, vec2<W>{wx, wy}, vec2<W>{toward_x, toward_y});
    for (int quarter = 0; quarter < (mirrored ? 2 : 4); ++quarter) {
        const auto& deltas = cut[static_cast<std::size_t>(quarter)];
        for (std::size_t k = 0; k + 1 < deltas.size(); ++k)
            add_rays(rule.azimuths(deltas[k], deltas[k + 1], k + 2 < deltas.size()), quarter);
    }
    if (evaluations) *evaluations += count;
    return sum * (W(mirrored ? 2 : 1) * wx * wy);
}

}  // namespace detail

}  // namespace lobe
