// The split-sum terms of anisotropic surfaces from a table.
#pragma once

#include <lobe/energy/dfg.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace lobe {

struct anisotropic_dfg_options {
    int cosines = 24, azimuths = 9, widths = 16, ratios = 9;  // nodes along each axis, at least 2
    int order = 16;                                           // of the quadrature: 4 order^2 evaluations a node
};

/// scale and bias of a stretched GGX seen from v, whose azimuth counts: no single width stands for two (off by 0.09 at
/// widths 2 apart, 0.4 at 10). Kept are E and the effective cosine c of bias = E (1 - c)^5, on four axes, read
/// linearly:
///   azimuth phi from the wider side, atan(sqrt(ay/ax) tan(phi));  width: fourth root of ax, the wider;
///   ratio: log(ay/ax);  cosine: sqrt(mu) (1 + 1.5 r)/(sqrt(mu) + 1.5 r) for E, fourth root of mu for c,
///   r: root of the width that v sees, sqrt(ax^2 cos^2(phi) + ay^2 sin^2(phi))
/// Domain: unit v above the horizon; widths from 9e-4 to 1, up to 16 apart; beyond it the edge answers. Scalar types
/// only. 250 kB in float.
/// Error against quadrature over the domain: E 7e-3, rms 1.2e-3; scale, bias 1.1e-2 (24 x 17 x 16 x 17: 5e-3, 8e-3).
template <scalar T, class Masking>
class anisotropic_dfg_table {
    using grid = std::array<int, 4>;

public:
    dfg_terms<T> operator()(const vec3<T>& v, const alpha_xy<T>& width) const {
        const place at(v, width);
        const T E = smaller(read(0, at.column_of_E(), at), T(1));
        const T w = T(1) - read(1, at.column_of_cosine(), at), w2 = w * w, B = E * (w2 * w2 * w);
        return {E - B, B};
    }

private:
    static constexpr T narrowest = T(1) / T(16), first = T(0.17320508), k = T(1.5);

    /// v and the widths, as numbers of [0,1].
    struct place {
        T mu, r, azimuth, row, ratio;

        place(const vec3<T>& v, const alpha_xy<T>& width) : mu(smaller(larger(v.z, T(0)), T(1))) {
            using std::atan2, std::log, std::sqrt;
            const bool along_x = width.x() >= width.y();
            const T ax = along_x ? width.x() : width.y(), ay = along_x ? width.y() : width.x();
            const T x = absolute(along_x ? v.x : v.y) * ax, y = absolute(along_x ? v.y : v.x) * ay;
            const T sine2 = v.x * v.x + v.y * v.y;
            r = sqrt(sine2 > T(0) ? sqrt((x * x + y * y) / sine2) : ax);
            azimuth = sine2 > T(0) ? atan2(y * sqrt(ax), x * sqrt(ay)) * (T(2) * inv_pi<T>()) : T(0);
            row = (sqrt(sqrt(ax)) - first) / (T(1) - first);
            ratio = log(ay / ax) / log(narrowest);
        }
        T column_of_E() const {
            using std::sqrt;
            const T q = sqrt(mu);
            return q * (T(1) + k * r) / (q + k * r);
        }
        T column_of_cosine() const {
            using std::sqrt;
            return sqrt(sqrt(mu));
        }
    };

    anisotropic_dfg_table(const grid& nodes)
        : size(nodes), values(static_cast<std::size_t>(2 * nodes[0] * nodes[1] * nodes[2] * nodes[3])) {}

    template <scalar U, class M>
    friend anisotropic_dfg_table<U, M> bake_anisotropic_dfg(const M&, const anisotropic_dfg_options&);

    T read(int which, const T& column, const place& at) const {
        const T coordinates[4] = {column, at.azimuth, at.row, at.ratio};
        int node[4];
        T part[4];
        for (int i = 0; i < 4; ++i) {
            const T x = smaller(larger(T(0), coordinates[i]), T(1)) * T(size[std::size_t(i)] - 1);
            node[i] = (std::min)(static_cast<int>(x), size[std::size_t(i)] - 2);
            part[i] = x - T(node[i]);
        }
        T total(0);
        for (int corner = 0; corner < 16; ++corner) {
            int index = which;
            T weight(1);
            for (int i = 3; i >= 0; --i) {
                const int step = (corner >> i) & 1;
                index = index * size[std::size_t(i)] + node[i] + step;
                weight = weight * (step ? part[i] : T(1) - part[i]);
            }
            total = total + weight * values[static_cast<std::size_t>(index)];
        }
        return total;
    }

    grid size;
    std::vector<T> values;  // E, then c; the cosine of v runs fastest
};

/// Bakes an `anisotropic_dfg_table`: 1.6 s with the options as they are.
template <scalar T, class Masking>
anisotropic_dfg_table<T, Masking> bake_anisotropic_dfg(const Masking& masking_model,
                                                       const anisotropic_dfg_options& options = {}) {
    using W = detail::wide_t<T>;
    using table_type = anisotropic_dfg_table<T, Masking>;
    using std::cos, std::pow, std::sin, std::sqrt;
    const std::array<int, 4> n{options.cosines, options.azimuths, options.widths, options.ratios};
    assert(*std::min_element(n.begin(), n.end()) >= 2 && options.order >= 2 &&
           "bake_anisotropic_dfg: sizes and order must be at least 2");
    table_type table(n);
    const auto node = [](int i, int count) { return W(i) / W(count - 1); };
    auto value = table.values.begin();
    for (int which = 0; which < 2; ++which)
        for (int ratio = 0; ratio < n[3]; ++ratio)
            for (int row = 0; row < n[2]; ++row)
                for (int azimuth = 0; azimuth < n[1]; ++azimuth)
                    for (int column = 0; column < n[0]; ++column) {
                        const W y = W(table_type::first) + W(T(1) - table_type::first) * node(row, n[2]);
                        const W ax = y * y * y * y, ay = ax * pow(W(table_type::narrowest), node(ratio, n[3]));
                        const W psi = node(azimuth, n[1]) * pi<W>() / W(2);
                        const W x0 = cos(psi) / sqrt(ax), y0 = sin(psi) / sqrt(ay), length0 = sqrt(x0 * x0 + y0 * y0);
                        const W c = x0 / length0, s = y0 / length0;
                        const W r = sqrt(sqrt(ax * ax * c * c + ay * ay * s * s));
                        const W x = node(column, n[0]), k = W(table_type::k);
                        const W q = which == 0 ? k * x * r / (W(1) + k * r - x) : x * x;
                        const W grazing = r * r * W(1e-4);  // house: a point of the table, mu = 0 to the eye of E
                        const W mu = smaller(larger(q * q, grazing), W(1)), sine = sqrt((W(1) - mu) * (W(1) + mu));
                        const microfacet lobe{ggx{alpha_xy<W>{ax, ay}}, masking_model, detail::schlick_terms{}};
                        const vec3<W> v{sine * c, sine * s, mu};
                        const vec2<W> t = detail::hemisphere_integral_at(
                            [&](const vec3<W>& l) { return lobe.f_cos(v, l); }, v, lobe.width(), false, options.order);
                        *value++ = T(which == 0 ? t.x + t.y : W(1) - pow(t.y / (t.x + t.y), W(0.2)));
                    }
    return table;
}

}  // namespace lobe
