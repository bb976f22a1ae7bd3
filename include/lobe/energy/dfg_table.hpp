// The split-sum terms from a table that is baked once.
#pragma once

#include <lobe/energy/dfg_fit.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace lobe {

namespace detail {

/// Pairs of numbers at the nodes of [0,1] or of its square, row by row, read linearly. Coordinates outside are taken to
/// the edge. (By an index, not by pointers that move: so a loop of look-ups becomes one of gathers.)
template <class N>
struct node_grid {
    const N* values;
    int nodes;  // along each axis

    template <scalar T>
    [[gnu::always_inline]] vec2<T> operator()(const T& x) const {
        const axis<T> at(x, nodes);
        return between(at.node, at);
    }
    template <scalar T>
    [[gnu::always_inline]] vec2<T> operator()(const T& x, const T& y) const {
        const axis<T> column(x, nodes), row(y, nodes);
        const int low = row.node * nodes + column.node;
        return row.mixed(between(low, column), between(low + nodes, column));
    }

private:
    template <class T>
    struct axis {
        int node;
        T t;
        axis(const T& x, int n) {
            const T position = smaller(larger(T(0), x), T(1)) * T(n - 1);  // in this order a NaN is 0
            node = (std::min)(static_cast<int>(position), n - 2);
            t = position - T(node);
        }
        vec2<T> mixed(const vec2<T>& a, const vec2<T>& b) const { return a * (T(1) - t) + b * t; }
    };

    template <class T>
    vec2<T> between(int node, const axis<T>& at) const {
        const int i = 2 * node;
        return at.mixed({T(values[i]), T(values[i + 1])}, {T(values[i + 2]), T(values[i + 3])});
    }
};

/// Where a table keeps what. Rows: y = sqrt(roughness) from 0.03 on; below, the first row holds, with its columns at
/// mu/alpha. Columns: the structure lies in mu/alpha at grazing and in mu elsewhere, x = q (1 + k r)/(q + k r), q =
/// sqrt(mu), r = roughness, which tends to a function of mu/alpha where both are small.
template <scalar T>
struct dfg_axes {
    static constexpr T k = T(3), first = T(0.17320508);

    static T row(const T& y) { return (y - first) * (T(1) / (T(1) - first)); }
    static T roughness(const T& row) {
        const T y = first + (T(1) - first) * row;
        return y * y;
    }
    static T column(const T& mu, const T& r) {
        using std::sqrt;
        const T q = sqrt(mu);
        return q * (T(1) + k * r) / (q + k * r);
    }
    static T mu(const T& x, const T& r) {
        const T q = k * x * r / (T(1) + k * r - x);
        return q * q;
    }
};

/// 1 - E_avg of GGX to 0.5 %: what the table of averages holds is a factor of it. r: roughness.
template <scalar T>
constexpr T lost_on_average(const T& r) {
    const auto k = [](double x) { return constant<T>(x); };
    const T r2 = r * r;
    return r2 * r2 * (k(14.15478) + (k(896.04254) + (k(-718.7735) + k(192.48886) * r) * r) * r) /
           (T(1) + (k(131.89117) + (k(519.71826) + (k(-542.23383) + k(539.40222) * r) * r) * r) * r);
}

/// What a table consists of: (E, scale), what the medium fit lacks of them; averages, (1 - E_avg)/`lost_on_average` and
/// the bias.
template <class Grid>
struct dfg_look_up {
    Grid missing, averages;

    template <scalar T>
    [[gnu::always_inline]] dfg_terms<T> terms(const T& cosine, const alpha<T>& width) const {
        const vec2<T> at = place(cosine, width);
        return completed(cosine, width, missing(at.x, at.y));
    }
    /// Where `missing` is read: column and row, in [0,1] from the first node to the last.
    template <scalar T>
    [[gnu::always_inline]] static vec2<T> place(const T& cosine, const alpha<T>& width) {
        using std::sqrt;
        const T r = sqrt(inside(width).value());
        return {dfg_axes<T>::column(inside(cosine), r), dfg_axes<T>::row(sqrt(r))};
    }
    /// ... and what becomes of it.
    template <scalar T>
    [[gnu::always_inline]] static dfg_terms<T> completed(const T& cosine, const alpha<T>& width, const vec2<T>& more) {
        const dfg_terms<T> fit = dfg_fit_medium{}(inside(cosine), inside(width));
        const T E = smaller(fit.albedo() + more.x, T(1)), A = smaller(larger(fit.scale + more.y, T(0)), E);
        return {A, E - A};
    }
    template <scalar T>
    dfg_terms<T> average(const alpha<T>& width) const {
        using std::sqrt;
        const T r = sqrt(inside(width).value());
        const vec2<T> at = averages(dfg_axes<T>::row(sqrt(r)));
        return {T(1) - lost_on_average(r) * at.x - at.y, at.y};
    }

private:
    template <scalar T>
    static T inside(const T& cosine) {
        return smaller(larger(T(0), cosine), T(1));  // in this order, which takes a NaN to 0
    }
    template <scalar T>
    static alpha<T> inside(const alpha<T>& width) {
        return alpha<T>(smaller(larger(width.value(), T(1e-8f)), T(1)));  // house: below it the fit underflows in float
    }
};
template <class N>
using dfg_grids = dfg_look_up<node_grid<N>>;

}  // namespace detail

/// scale and bias, read from a node-centred table of what `dfg_fit_medium` lacks; the type remembers what normals and
/// masking it was baked for.
/// Domain: cosine = cos(theta_v) in [0,1], alpha in (0,1]; beyond it the edge answers. Scalar types only.
/// Error against `dfg_exact`, 32 x 32, mu in [0.001,1], roughness in [0.03,1]: E, scale, bias 4e-4, rms 5e-5, 5e-5,
/// 3e-5 (16 x 16: 1.5e-3; 64 x 64: 1e-4); separable masking 6e-4; Beckmann 2.5e-3. scale, bias >= 0, E <= 1.
template <scalar T, class Masking, class OfWidth = ggx_of_width>
class dfg_table {
public:
    template <class N, class M>
    static constexpr bool describes = std::same_as<M, Masking>&&
        std::same_as<N, std::decay_t<std::invoke_result_t<OfWidth, alpha<typename N::scalar>>>>;

    [[gnu::always_inline]] dfg_terms<T> operator()(const T& cosine, const alpha<T>& a) const {
        return parts().terms(cosine, a);
    }

    /// Error: 1e-5 of the averages of what the table says.
    dfg_terms<T> average(const alpha<T>& a) const { return parts().average(a); }

    /// What it consists of, to embed it as `default_dfg` is.
    detail::dfg_grids<T> parts() const { return {{square.data(), nodes}, {line.data(), 2 * nodes}}; }

private:
    explicit dfg_table(int nodes_along_an_axis) : nodes(nodes_along_an_axis) {}

    template <scalar U, class M, class O>
    friend dfg_table<U, M, O> bake_dfg(const M&, const struct dfg_table_options&, const O&);

    int nodes;
    std::vector<T> square, line;
};

struct dfg_table_options {
    int size = 32;  // nodes along each axis, at least 2
    int order = 0;  // of the quadrature: 2 order^2 evaluations a node. 0: 16 for GGX, to 1e-5 (12: 6e-5); 32 for others
};

/// Bakes a `dfg_table`: size^2 albedos, a hundredth of a second at 32 x 32. Build once, not per pixel. Of GGX, or of
/// the normals that `of_width` makes of an `alpha`: `bake_dfg<float>(smith_correlated{}, {}, [](auto a) { return
/// lobe::beckmann{a}; })`. The nodes at mu = 0 hold the limit: E there is a function of mu/alpha alone.
template <scalar T, class Masking, class OfWidth = ggx_of_width>
dfg_table<T, Masking, OfWidth> bake_dfg(const Masking& masking_model, const dfg_table_options& options = {},
                                        const OfWidth& of_width = {}) {
    using W = detail::wide_t<T>;
    using axes = detail::dfg_axes<W>;
    assert(options.size >= 2 && (options.order >= 2 || options.order == 0) &&
           "bake_dfg: size and order must be at least 2");
    const int n = options.size;
    const int order = options.order ? options.order : std::same_as<OfWidth, ggx_of_width> ? 16 : 32;
    const detail::hemisphere_rule<W> rule(order);
    dfg_table<T, Masking, OfWidth> table(n);
    for (int row = 0; row < n; ++row) {
        const W r = axes::roughness(W(row) / W(n - 1));
        const alpha<W> a(r * r);
        for (int column = 0; column < n; ++column) {
            const W grazing = a.value() * W(1e-6);  // house: a point of the table, mu = 0 to the eye of E
            const W mu = smaller(larger(axes::mu(W(column) / W(n - 1), r), grazing), W(1));
            const dfg_terms<W> exact = detail::split_sum(of_width(a), masking_model, detail::view_at(mu)).at(rule);
            const dfg_terms<W> fit = dfg_fit_medium{}(mu, a);
            table.square.insert(table.square.end(), {T(exact.albedo() - fit.albedo()), T(exact.scale - fit.scale)});
        }
    }
    for (int row = 0; row < 2 * n; ++row) {
        const W r = axes::roughness(W(row) / W(2 * n - 1));
        const auto own = [&](const W& mu, const alpha<W>& a) { return table.parts().terms(mu, a); };
        const dfg_terms<W> average = detail::dfg_average(own, alpha<W>(r * r));
        table.line.insert(table.line.end(),
                          {T((W(1) - average.albedo()) / detail::lost_on_average(r)), T(average.bias)});
    }
    return table;
}

}  // namespace lobe
