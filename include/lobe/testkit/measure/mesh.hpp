// Integrals over a rectangle by an adaptive mesh, which finds narrow peaks; its cells then serve as bins.
#pragma once

#include <lobe/core/cpp20.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numeric>
#include <vector>

namespace lobe::testkit {

/// The unit square, cut into cells by the degree-7 rule of Genz & Malik 1980, "An adaptive algorithm for numerical
/// integration over an N-dimensional rectangular region": 17 points a cell, its embedded degree-5 rule for the error,
/// the fourth differences for the next cut. Integrates N functions; the first `driving` of them decide where to cut.
template <std::size_t N>
class mesh {
public:
    using values = std::array<double, N>;
    using integrand = std::function<values(double x, double y)>;

    struct cell {
        double x0, y0, width, height;
        values integral{}, error{};
        bool cut_x = false;
        int child = -1;  // the first of two, or none
        bool leaf() const { return child < 0; }
    };

    mesh(integrand of, int columns, int rows, std::size_t how_many_drive)
        : f(std::move(of)), nx(columns), ny(rows), driving(how_many_drive) {
        for (int j = 0; j < ny; ++j)
            for (int i = 0; i < nx; ++i) {
                cells_.push_back({double(i) / nx, double(j) / ny, 1.0 / nx, 1.0 / ny});
                apply_rule(cells_.back());
            }
    }

    /// Cuts the cells around (x, y) until they are 2^-halvings of the first ones: for a peak that is known to be
    /// possible there.
    void refine_at(double x, double y, int halvings) {
        const double width = std::ldexp(1.0 / nx, -halvings), height = std::ldexp(1.0 / ny, -halvings);
        for (std::size_t at = 0; at < cells_.size(); ++at) {  // the loop reaches the new cells, too
            const cell c = cells_[at];
            const double from_x = x - c.x0 - c.width / 2, from_y = y - c.y0 - c.height / 2;
            const bool beside = std::abs(from_x) <= c.width && std::abs(from_y) <= c.height;
            const bool large = c.width > 1.5 * width || c.height > 1.5 * height;
            if (c.leaf() && beside && large) cut(at, c.width * nx >= c.height * ny);
        }
    }

    /// Cuts every cell that holds more than `limit` of the points: for peaks that a sampler knows of.
    void refine_crowded(const std::vector<std::array<double, 2>>& points, int limit, int rounds) {
        for (int round = 0; round < rounds; ++round) {
            std::vector<int> count(cells_.size());
            for (const auto& p : points) ++count[find(p[0], p[1])];
            bool done = true;
            for (std::size_t at = 0; at < count.size(); ++at)
                if (count[at] > limit) {
                    cut(at, cells_[at].cut_x);
                    done = false;
                }
            if (done) return;
        }
    }

    /// Cuts the cells that carry half of the error, until the error of every driving integral is below `tolerance`,
    /// relative to itself (the first `colours` of them, which are the colours of one thing, to the largest); or until
    /// the evaluations are spent, be it on rounding that no cut makes smaller. The cells are graded in either case.
    void refine(double tolerance, std::size_t colours, long max_evaluations) {
        for (;;) {
            sum_up();
            values scale{};
            double brightest = 0;
            for (std::size_t k = 0; k < colours; ++k) brightest = (std::max)(brightest, std::abs(total_[k]));
            for (std::size_t k = 0; k < driving; ++k)
                scale[k] = (std::max)(k < colours ? brightest : std::abs(total_[k]), 1e-9);
            const auto open = [&](std::size_t k) { return error_[k] > tolerance * scale[k]; };
            bool done = evaluations_ >= max_evaluations;
            if (!done) {
                done = true;
                for (std::size_t k = 0; k < driving; ++k) done = done && !open(k);
            }
            if (done && !grade()) return;
            if (done) continue;

            std::vector<std::pair<double, std::size_t>> by_error;
            double all = 0;
            for (std::size_t at = 0; at < cells_.size(); ++at) {
                if (!cells_[at].leaf()) continue;
                double e = 0;
                for (std::size_t k = 0; k < driving; ++k)
                    if (open(k)) e = (std::max)(e, cells_[at].error[k] / scale[k]);
                by_error.push_back({e, at});
                all += e;
            }
            std::sort(by_error.begin(), by_error.end(), std::greater<>());
            double marked = 0;
            for (const auto& [e, at] : by_error) {
                if (marked >= all / 2 || evaluations_ >= max_evaluations) break;
                cut(at, cells_[at].cut_x);
                marked += e;
            }
        }
    }

    /// Cuts cells that are more than 4 times as wide or high as a neighbour that matters: a ridge leads from that one
    /// into them, unseen.
    bool grade() {
        std::vector<std::pair<std::size_t, bool>> too_large;
        for (const cell& c : cells_) {
            if (!c.leaf()) continue;
            bool matters = false;
            for (std::size_t k = 0; k < driving; ++k)
                matters = matters || std::abs(c.integral[k]) > 1e-5 * std::abs(total_[k]);
            if (!matters) continue;
            const double x = c.x0 + c.width / 2, y = c.y0 + c.height / 2, out = 0.51;
            for (const auto& [dx, dy] : {std::pair(out, 0.0), {-out, 0.0}, {0.0, out}, {0.0, -out}}) {
                const double there_x = x + dx * c.width, there_y = y + dy * c.height;
                if (there_x < 0 || there_x >= 1 || there_y < 0 || there_y >= 1) continue;
                const std::size_t at = find(there_x, there_y);
                if (cells_[at].width > 4.5 * c.width)
                    too_large.push_back({at, true});
                else if (cells_[at].height > 4.5 * c.height)
                    too_large.push_back({at, false});
            }
        }
        for (const auto& [at, across_x] : too_large)
            if (cells_[at].leaf()) cut(at, across_x);
        return !too_large.empty();
    }

    values at(double x, double y) const { return f(x, y); }
    const values& integral() const { return total_; }
    /// By the two rules of different degree: usually far too large, but nothing where the integrand jumps between the
    /// points.
    const values& error() const { return error_; }
    long evaluations() const { return evaluations_; }
    const std::vector<cell>& cells() const { return cells_; }

    /// The leaf that holds the point.
    std::size_t find(double x, double y) const {
        const int i = std::clamp(static_cast<int>(x * nx), 0, nx - 1),
                  j = std::clamp(static_cast<int>(y * ny), 0, ny - 1);
        std::size_t at = static_cast<std::size_t>(j * nx + i);
        while (!cells_[at].leaf()) {
            const std::size_t low = static_cast<std::size_t>(cells_[at].child);
            const bool high = cells_[at].cut_x ? x >= cells_[low + 1].x0 : y >= cells_[low + 1].y0;
            at = low + (high ? 1 : 0);
        }
        return at;
    }

    /// The leaves, neighbours near each other.
    std::vector<std::size_t> leaves() const {
        std::vector<std::size_t> order, stack;
        for (std::size_t root = static_cast<std::size_t>(nx * ny); root-- > 0;) stack.push_back(root);
        while (!stack.empty()) {
            const std::size_t at = stack.back();
            stack.pop_back();
            if (cells_[at].leaf()) {
                order.push_back(at);
            } else {
                stack.push_back(static_cast<std::size_t>(cells_[at].child) + 1);
                stack.push_back(static_cast<std::size_t>(cells_[at].child));
            }
        }
        return order;
    }

private:
    void sum_up() {
        total_ = {};
        error_ = {};
        for (const cell& c : cells_)
            if (c.leaf())
                for (std::size_t k = 0; k < N; ++k) {
                    total_[k] += c.integral[k];
                    error_[k] += c.error[k];
                }
    }

    void cut(std::size_t at, bool across_x) {
        cells_[at].cut_x = across_x;
        cells_[at].child = static_cast<int>(cells_.size());
        const cell whole = cells_[at];
        cell low{whole.x0, whole.y0, across_x ? whole.width / 2 : whole.width,
                 across_x ? whole.height : whole.height / 2};
        cell high = low;
        (across_x ? high.x0 : high.y0) += across_x ? low.width : low.height;
        for (cell* half : {&low, &high}) {
            apply_rule(*half);
            cells_.push_back(*half);
        }
    }

    void apply_rule(cell& c) {
        const double x = c.x0 + c.width / 2, y = c.y0 + c.height / 2, hx = c.width / 2, hy = c.height / 2;
        const double inner = std::sqrt(9.0 / 70), outer = std::sqrt(9.0 / 10), corner = std::sqrt(9.0 / 19);
        evaluations_ += 17;
        values middle = f(x, y), along_inner{}, along_outer{}, diagonal_outer{}, diagonal_corner{}, fourth_x{},
               fourth_y{};
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
        // else the longer side of the cell, in units of the first grid
        c.cut_x = dx > dy || (!(dx < dy) && c.width * nx >= c.height * ny);
    }

    integrand f;
    int nx, ny;
    std::size_t driving;
    long evaluations_ = 0;
    std::vector<cell> cells_;
    values total_{}, error_{};
};

}  // namespace lobe::testkit
