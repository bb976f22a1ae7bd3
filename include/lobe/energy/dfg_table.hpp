// The split-sum terms from a table that is baked once.
#pragma once

#include <lobe/energy/dfg.hpp>

namespace lobe {

namespace detail {

/// A square of node-centred samples over [0,1]^2, read bilinearly. Coordinates outside are taken to the edge.
template <scalar T>
class node_grid {
public:
    explicit node_grid(int nodes)
        : n(nodes), values(static_cast<std::size_t>(nodes) * static_cast<std::size_t>(nodes)) {}

    T& at(int column, int row) { return values[index(column, row)]; }

    T operator()(const T& x, const T& y) const {
        const T last = static_cast<T>(n - 1);
        // in this order a NaN is 0
        const T px = smaller(larger(T(0), x), T(1)) * last, py = smaller(larger(T(0), y), T(1)) * last;
        const int column = (std::min)(static_cast<int>(px), n - 2), row = (std::min)(static_cast<int>(py), n - 2);
        const T tx = px - T(column), ty = py - T(row);
        const T* low = &values[index(column, row)];
        const T* high = low + n;
        return (low[0] * (T(1) - tx) + low[1] * tx) * (T(1) - ty) + (high[0] * (T(1) - tx) + high[1] * tx) * ty;
    }

private:
    std::size_t index(int column, int row) const { return static_cast<std::size_t>(row * n + column); }

    int n;
    std::vector<T> values;
};

/// Table axes. Rows: the fourth root of alpha. Columns of E: its structure lies in mu/alpha at grazing and in mu
/// elsewhere, x = q (1 + k r)/(q + k r), q = sqrt(mu), r = sqrt(alpha), which tends to a function of mu/alpha where
/// both are small. Columns of the scale: the fourth root of mu.
template <scalar T>
struct dfg_axes {
    static constexpr T k = T(1.5);

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

}  // namespace detail

/// scale and bias of isotropic GGX, read from a node-centred table; the type remembers the masking that it was baked
/// for.
/// Domain: cosine = cos(theta_v) in [0,1], alpha in (0,1]; beyond it the edge answers. Scalar types only.
/// Error against `dfg_exact`, 32 x 32: scale and bias 3.5e-3 at most, 8e-4 rms; E = scale + bias 1.5e-3, 4e-4 rms.
template <scalar T, class Masking>
class dfg_table {
public:
    dfg_terms<T> operator()(const T& cosine, const alpha<T>& a) const {
        using std::sqrt;
        const T mu = smaller(larger(T(0), cosine), T(1));  // in this order, which takes a NaN to 0
        const T r = sqrt(a.value()), row = sqrt(r);
        const T E = albedo(detail::dfg_axes<T>::column(mu, r), row);
        const T A = smaller(scale(sqrt(sqrt(mu)), row), E);
        return {A, E - A};
    }

private:
    dfg_table(int size) : albedo(size), scale(size) {}

    template <scalar U, class M>
    friend dfg_table<U, M> bake_dfg(const M&, const struct dfg_table_options&);

    detail::node_grid<T> albedo, scale;
};

struct dfg_table_options {
    int size = 32;   // nodes along each axis, at least 2
    int order = 32;  // of the quadrature: 2 order^2 evaluations a node and term, 1e-6 at 32
};

/// Bakes a `dfg_table`: 2 size^2 albedos, a tenth of a second at 32 x 32. Build once, not per pixel.
/// The nodes at mu = 0 and alpha = 0 hold the limits: E there is a function of mu/alpha alone, which quadrature at
/// alpha = 1e-4 gives to 1e-4.
template <scalar T, class Masking>
dfg_table<T, Masking> bake_dfg(const Masking& masking_model, const dfg_table_options& options = {}) {
    using W = detail::wide_t<T>;
    assert(options.size >= 2 && options.order >= 2 && "bake_dfg: size and order must be at least 2");
    const int last = options.size - 1;
    const auto terms = [&](const W& mu, const W& a) {
        const microfacet lobe{ggx{alpha<W>(a)}, masking_model, detail::schlick_terms{}};
        const W grazing = a * W(1e-6);  // house: a point of the table, mu = 0 to the eye of E
        const vec3<W> v = detail::view_at(larger(mu, grazing));
        return detail::hemisphere_integral_at([&](const vec3<W>& l) { return lobe.f_cos(v, l); }, v, lobe.width(), true,
                                              options.order);
    };
    dfg_table<T, Masking> table(options.size);
    for (int row = 0; row <= last; ++row) {
        const W y = W(row) / W(last);
        const W r = larger(y * y, W(0.01));  // house: a node of the table, alpha = 0 to E's limit
        const W a = r * r;
        for (int column = 0; column <= last; ++column) {
            const W x = W(column) / W(last), x2 = x * x;
            const vec2<W> at_warped = terms(smaller(detail::dfg_axes<W>::mu(x, r), W(1)), a);
            table.albedo.at(column, row) = T(at_warped.x + at_warped.y);
            const W Fc = W(1) - x2 * x2;
            table.scale.at(column, row) = row == 0 ? T(W(1) - Fc * Fc * Fc * Fc * Fc) : T(terms(x2 * x2, a).x);
        }
    }
    return table;
}

}  // namespace lobe
