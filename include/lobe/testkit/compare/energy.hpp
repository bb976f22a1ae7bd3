// By how much energy two functions differ.
#pragma once

#include <lobe/testkit/measure/mesh.hpp>
#include <lobe/testkit/measure/text.hpp>
#include <lobe/testkit/verdict/report.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace lobe::testkit {

namespace id {
inline constexpr property_id equal_energy{"equal_energy", "the same energy"};
inline constexpr property_id energy_that_differs{"energy_that_differs", "energy that differs"};
}  // namespace id

namespace detail {

/// int b, int |a - b|, int (a - b): the first two say where to cut.
using energy_mesh = mesh<3>;
template <std::size_t N>
energy_mesh::values energy_of(const std::array<double, N>& a, const std::array<double, N>& b, double area) {
    energy_mesh::values out{};
    for (std::size_t k = 0; k < N; ++k) {
        const double x = computable(a[k]), y = computable(b[k]);
        out[0] += y * area;
        out[1] += std::abs(x - y) * area;
        out[2] += (x - y) * area;
    }
    return out;
}

/// Of several views, or of one integral: the one at which most energy differs.
class energy_rows {
public:
    /// `relative`: the tolerance, and what rounding does to the integral.
    void add(const energy_mesh& m, double relative, std::string input) {
        const auto &value = m.integral(), &error = m.error();
        const double size = (std::max)(std::abs(value[0]), std::abs(value[0] + value[2]));
        const double allowed = relative * size;
        if (const double over = std::abs(value[2]) / (allowed + error[2]); over > most.over)
            most = {over, value[0] + value[2], value[0], allowed + error[2], input};
        if (const double over = value[1] / (allowed + error[1]); over > apart.over)
            apart = {over, value[1] / size, 0, (allowed + error[1]) / size, std::move(input)};
    }
    void report_to(report& r) const {
        const bool same_sum = !(most.over > 1), same_parts = !(apart.over > 1);
        r.add(id::equal_energy, {.passed = same_sum,
                                 .measured = most.measured,
                                 .expected = most.expected,
                                 .tolerance = most.allowed,
                                 .input = most.input,
                                 .meaning = "a returns " + percent(std::abs(most.measured / most.expected - 1)) +
                                            (most.measured < most.expected ? " less" : " more") + " than b"});
        r.add(id::energy_that_differs, {.passed = same_parts,
                                        .measured = apart.measured,
                                        .expected = apart.expected,
                                        .tolerance = apart.allowed,
                                        .input = apart.input,
                                        .meaning = "what is lost and what is gained, together " +
                                                   percent(apart.measured) + " of b: int |a - b|"});
    }

private:
    struct row {
        double over = -1, measured = 0, expected = 0, allowed = 0;
        std::string input{};
    };
    row most{}, apart{};
};

}  // namespace detail

}  // namespace lobe::testkit
