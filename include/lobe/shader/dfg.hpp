// A baked table of split-sum terms as a shader has it: its look-up and its numbers.
#pragma once

#include <lobe/energy/dfg_table.hpp>
#include <lobe/shader/real.hpp>
#include <lobe/shader/structs.hpp>

namespace lobe::shader {

namespace detail {

/// lobe's `node_grid` of a table that is printed: four reads of the square, two of the line.
class grid {
public:
    grid(const std::string& name, const lobe::detail::node_grid<float>& from, std::size_t pairs)
        : nodes(from.nodes), at(function(name, {"i"}, [](real i) { return vec2(i, i); })) {
        std::vector<glm::vec2> values;
        for (std::size_t i = 0; i < pairs; ++i) values.emplace_back(from.values[2 * i], from.values[2 * i + 1]);
        at.reading(values);
    }

    vec2 operator()(const real& x) const {
        const axis column(x, nodes);
        return between(column.node, column);
    }
    vec2 operator()(const real& x, const real& y) const {
        const axis column(x, nodes), row(y, nodes);
        const real low = row.node * real(nodes) + column.node;
        return row.mixed(between(low, column), between(low + real(nodes), column));
    }
    int size() const { return nodes; }

private:
    struct axis {
        real node, t;
        axis(const real& x, int n) {
            const real position = smaller(larger(real(0), x), real(1)) * real(n - 1);  // in this order a NaN is 0
            node = smaller(floor(position), real(n - 2));
            t = position - node;
        }
        vec2 mixed(const vec2& a, const vec2& b) const { return a * (real(1) - t) + b * t; }
    };
    vec2 between(const real& node, const axis& along) const { return along.mixed(at(node), at(node + real(1))); }

    int nodes;
    recorded<vec2, std::tuple<real>> at;
};

}  // namespace detail

/// A `dfg_table`, or `default_dfg`, to be recorded: the same look-up, bit for bit, and its numbers as arrays
/// `NAME_missing` and `NAME_averages`. It stands where the table would:
/// `compensated{brdf, kulla_conty{dfg{"dfg", table}}}`.
template <class Table>
class dfg {
    using look_up = lobe::detail::dfg_look_up<detail::grid>;

public:
    template <class N, class Masking>
    static constexpr bool describes = Table::template describes<N, Masking>;

    dfg(const std::string& name, const Table& table) : dfg(name, table.parts()) {}

    dfg_terms<real> operator()(const real& cosine, const alpha<real>& a) const { return grids.terms(cosine, a); }
    dfg_terms<real> average(const alpha<real>& a) const { return grids.average(a); }

    /// With the numbers as a texture, RG, 32 bits, `nodes` wide and high, read linearly, clamped: where it is read,
    vec2 uv(const real& cosine, const alpha<real>& a) const {
        const real n(grids.missing.size());
        return (look_up::place(cosine, a) * (n - real(1)) + real(0.5)) / n;
    }
    /// and what becomes of the texel.
    static dfg_terms<real> of_texel(const real& cosine, const alpha<real>& a, const vec2& texel) {
        return look_up::completed(cosine, a, texel);
    }
    int nodes() const { return grids.missing.size(); }

private:
    dfg(const std::string& name, const lobe::detail::dfg_grids<float>& from)
        : grids{detail::grid(name + "_missing", from.missing, square(from.missing.nodes)),
                detail::grid(name + "_averages", from.averages, static_cast<std::size_t>(from.averages.nodes))} {}
    static std::size_t square(int n) { return static_cast<std::size_t>(n) * static_cast<std::size_t>(n); }

    look_up grids;
};
template <class Table>
dfg(const char*, Table) -> dfg<Table>;
template <class Table>
dfg(std::string, Table) -> dfg<Table>;

/// What to upload as the texture of `uv`: RG32F, row by row.
template <class Table>
std::vector<glm::vec2> dfg_texels_of(const Table& table) {
    const auto from = table.parts().missing;
    std::vector<glm::vec2> texels;
    for (int i = 0; i < from.nodes * from.nodes; ++i) texels.emplace_back(from.values[2 * i], from.values[2 * i + 1]);
    return texels;
}

}  // namespace lobe::shader
