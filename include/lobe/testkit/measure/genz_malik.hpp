// The rule of the adaptive mesh: what it says of one cell.
#pragma once

#include <lobe/core/cpp20.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <functional>

namespace lobe::testkit {

template <std::size_t N>
struct mesh_cell {
    double x0, y0, width, height;
    std::array<double, N> integral{}, error{};
    bool cut_x = false;
    int child = -1;  // the first of two, or none
    bool leaf() const { return child < 0; }
};

/// The degree-7 rule of Genz & Malik 1980, "An adaptive algorithm for numerical integration over an N-dimensional
/// rectangular region": 17 points a cell, its embedded degree-5 rule for the error, the fourth differences of the first
/// `driving` functions for the next cut; where they are alike, the longer side in units of the grid of nx times ny.
template <std::size_t N>
void genz_malik(mesh_cell<N>& c, const std::function<std::array<double, N>(double x, double y)>& f, std::size_t driving,
                int nx, int ny) {
    using values = std::array<double, N>;
    const double x = c.x0 + c.width / 2, y = c.y0 + c.height / 2, hx = c.width / 2, hy = c.height / 2;
    const double inner = std::sqrt(9.0 / 70), outer = std::sqrt(9.0 / 10), corner = std::sqrt(9.0 / 19);
    values middle = f(x, y), along_inner{}, along_outer{}, diagonal_outer{}, diagonal_corner{}, fourth_x{}, fourth_y{};
    const auto accumulate = [&](values& sum, double dx, double dy) {
        const values v = f(x + dx * hx, y + dy * hy);
        for (std::size_t k = 0; k < N; ++k) sum[k] += v[k];
    };
    for (const bool is_x : {true, false}) {
        values close{}, wide{};
        for (const double sign : {-1.0, 1.0}) {
            accumulate(close, is_x ? sign * inner : 0, is_x ? 0 : sign * inner);
            accumulate(wide, is_x ? sign * outer : 0, is_x ? 0 : sign * outer);
        }
        for (std::size_t k = 0; k < N; ++k) {
            (is_x ? fourth_x : fourth_y)[k] =
                std::abs(close[k] - 2 * middle[k] - (inner * inner) / (outer * outer) * (wide[k] - 2 * middle[k]));
            along_inner[k] += close[k];
            along_outer[k] += wide[k];
        }
    }
    for (const double sx : {-1.0, 1.0})
        for (const double sy : {-1.0, 1.0}) {
            accumulate(diagonal_outer, sx * outer, sy * outer);
            accumulate(diagonal_corner, sx * corner, sy * corner);
        }
    const double area = c.width * c.height;
    double dx = 0, dy = 0, size = 1e-300;
    for (std::size_t k = 0; k < N; ++k) {
        const double m = middle[k], i = along_inner[k], o = along_outer[k], d = diagonal_outer[k];
        c.integral[k] = area * (-3816.0 / 19683 * m + 980.0 / 6561 * i + 1020.0 / 19683 * o + 200.0 / 19683 * d +
                                6859.0 / 19683 / 4 * diagonal_corner[k]);
        const double degree_5 = area * (-971.0 / 729 * m + 245.0 / 486 * i + 65.0 / 1458 * o + 25.0 / 729 * d);
        c.error[k] = std::abs(c.integral[k] - degree_5);
        if (k < driving && c.error[k] > size) size = c.error[k], dx = fourth_x[k], dy = fourth_y[k];
    }
    // else the longer side of the cell, in units of the first grid; what is cut already stays so
    if (c.leaf()) c.cut_x = dx > dy || (!(dx < dy) && c.width * nx >= c.height * ny);
}

}  // namespace lobe::testkit
