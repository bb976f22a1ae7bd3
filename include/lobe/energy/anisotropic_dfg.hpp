// The split-sum terms of anisotropic surfaces from a table.
#pragma once

#include <lobe/energy/dfg_table.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace lobe {

struct anisotropic_dfg_options {
    int cosines = 20, azimuths = 11, widths = 16, ratios = 9;  // nodes along each axis, at least 2
    int order = 16;                                            // of the quadrature: 4 order^2 evaluations a node
};

namespace detail {

/// A view of a surface of two widths, and where that is in a table: its columns and rows are those of `dfg_axes`, for
/// the width that the view sees and for the wider one.
template <scalar T>
struct anisotropic_view {
    static constexpr T narrowest = T(1) / T(16);

    T mu, wide, narrow, seen;  // seen: sqrt(wide^2 cos^2(phi) + narrow^2 sin^2(phi)), phi from the wider side
    T azimuth;                 // atan(sqrt(narrow/wide) tan(phi)) in quarters of a turn

    /// What both widths leave of the bias: that of one, from the seen width at grazing to the geometric mean.
    T fitted_bias() const {
        using std::sqrt;
        return dfg_fit_medium{}(mu, alpha<T>(seen + (sqrt(wide * narrow) - seen) * sqrt(mu))).bias;
    }
    std::array<T, 4> coordinates() const {
        using std::log, std::sqrt;
        return {dfg_axes<T>::column(mu, sqrt(seen)), azimuth, dfg_axes<T>::row(sqrt(sqrt(wide))),
                log(narrow / wide) / log(narrowest)};
    }
};

}  // namespace detail

/// scale and bias of a stretched GGX seen from v, whose azimuth counts: no single width stands for two (off by 0.09 at
/// widths 2 apart, 0.4 at 10). A table of E, and of what `dfg_fit_medium` lacks of the bias, on four axes, read
/// linearly: cosine, azimuth, wider width, ratio.
/// Domain: unit v above the horizon; the wider width from 9e-4 to 1, the narrower down to a sixteenth of it; beyond it
/// the edge of width and ratio answers. Scalar types only. 253 kB in float.
/// Error against quadrature over the domain: E and scale 6e-3, rms 1.2e-3; bias 3.5e-3, rms 4e-4 (24 x 17 x 24 x 17,
/// 1.3 MB: 2.5e-3, 1.5e-3).
template <scalar T, class Masking>
class anisotropic_dfg_table {
    using grid = std::array<int, 4>;

public:
    dfg_terms<T> operator()(const vec3<T>& v, const alpha_xy<T>& width) const {
        const detail::anisotropic_view<T> view = seen_by(v, width);
        const vec2<T> read = at(view.coordinates());
        const T E = smaller(read.x, T(1)), B = smaller(larger(view.fitted_bias() + read.y, T(0)), E);
        return {E - B, B};
    }

private:
    explicit anisotropic_dfg_table(const grid& nodes) : size(nodes) {}

    template <scalar U, class M>
    friend anisotropic_dfg_table<U, M> bake_anisotropic_dfg(const M&, const anisotropic_dfg_options&);

    static detail::anisotropic_view<T> seen_by(const vec3<T>& v, const alpha_xy<T>& width) {
        using std::atan2, std::sqrt;
        const bool along_x = width.x() >= width.y();
        const T wider = along_x ? width.x() : width.y(), narrower = along_x ? width.y() : width.x();
        const T wide = smaller(larger(wider, T(9e-4)), T(1));
        const T narrow = wide * larger(narrower / wider, detail::anisotropic_view<T>::narrowest);
        const T along = absolute(along_x ? v.x : v.y), across = absolute(along_x ? v.y : v.x);
        const T x = along * wide, y = across * narrow, sine2 = v.x * v.x + v.y * v.y;
        const bool tilted = sine2 > T(0);  // along the normal every azimuth will do
        return {smaller(larger(v.z, T(0)), T(1)), wide, narrow, tilted ? sqrt((x * x + y * y) / sine2) : wide,
                tilted ? atan2(across * sqrt(narrow), along * sqrt(wide)) * (T(2) * inv_pi<T>()) : T(0)};
    }

    vec2<T> at(const std::array<T, 4>& coordinates) const {
        grid node;
        std::array<T, 4> part;
        for (std::size_t i = 0; i < 4; ++i) {
            const T x = smaller(larger(T(0), coordinates[i]), T(1)) * T(size[i] - 1);
            node[i] = (std::min)(static_cast<int>(x), size[i] - 2);
            part[i] = x - T(node[i]);
        }
        vec2<T> total(T(0));
        for (unsigned corner = 0; corner < 16; ++corner) {
            int index = 0;
            T weight(1);
            for (std::size_t i = 4; i-- > 0;) {
                const bool next = corner >> i & 1u;
                index = index * size[i] + node[i] + (next ? 1 : 0);
                weight = weight * (next ? part[i] : T(1) - part[i]);
            }
            total = total + values[static_cast<std::size_t>(index)] * weight;
        }
        return total;
    }

    grid size;
    std::vector<vec2<T>> values;  // E, what the fit lacks of the bias; the cosine of v runs fastest
};

/// Bakes an `anisotropic_dfg_table`: 0.8 s at -O2 with the options as they are, 0.3 s where the quadrature vectorises.
template <scalar T, class Masking>
anisotropic_dfg_table<T, Masking> bake_anisotropic_dfg(const Masking& masking_model,
                                                       const anisotropic_dfg_options& options = {}) {
    using W = detail::wide_t<T>;
    using axes = detail::dfg_axes<W>;
    using std::cos, std::pow, std::sin, std::sqrt;
    const std::array<int, 4> n{options.cosines, options.azimuths, options.widths, options.ratios};
    assert(*std::min_element(n.begin(), n.end()) >= 2 && options.order >= 2 &&
           "bake_anisotropic_dfg: sizes and order must be at least 2");
    const detail::hemisphere_rule<W> rule(options.order);
    anisotropic_dfg_table<T, Masking> table(n);
    const auto node = [](int i, int count) { return W(i) / W(count - 1); };
    for (int ratio = 0; ratio < n[3]; ++ratio)
        for (int row = 0; row < n[2]; ++row)
            for (int azimuth = 0; azimuth < n[1]; ++azimuth)
                for (int column = 0; column < n[0]; ++column) {
                    const W root = axes::roughness(node(row, n[2])), wide = root * root;
                    const W narrow = wide * pow(detail::anisotropic_view<W>::narrowest, node(ratio, n[3]));
                    const W psi = node(azimuth, n[1]) * pi<W>() / W(2);
                    const W x = cos(psi) / sqrt(wide), y = sin(psi) / sqrt(narrow), length = sqrt(x * x + y * y);
                    const W along = x / length, across = y / length;
                    const W seen = sqrt(wide * wide * along * along + narrow * narrow * across * across);
                    const W grazing = seen * W(1e-4);  // house: a point of the table, mu = 0 to the eye of E
                    const W mu = smaller(larger(axes::mu(node(column, n[0]), sqrt(seen)), grazing), W(1));
                    const W sine = sqrt((W(1) - mu) * (W(1) + mu));
                    const vec3<W> v{sine * along, sine * across, mu};
                    const dfg_terms<W> t = detail::split_sum(ggx{alpha_xy<W>{wide, narrow}}, masking_model, v).at(rule);
                    const W fit = detail::anisotropic_view<W>{mu, wide, narrow, seen, W(0)}.fitted_bias();
                    table.values.push_back({T(t.albedo()), T(t.bias - fit)});
                }
    return table;
}

}  // namespace lobe
