// Integrals over a rectangle by an adaptive mesh, which finds narrow peaks; its cells then serve as bins.
#pragma once

#include <lobe/core/cpp20.hpp>
#include <lobe/testkit/measure/genz_malik.hpp>
#include <lobe/testkit/measure/rehearse.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numeric>
#include <vector>

namespace lobe::testkit {

/// The unit square, cut into cells. Integrates N functions by genz_malik; the first `driving` of them decide where to
/// cut.
template <std::size_t N>
class mesh {
public:
    using values = std::array<double, N>;
    using integrand = std::function<values(double x, double y)>;

    using cell = mesh_cell<N>;

    mesh(integrand of, int columns, int rows, std::size_t how_many_drive)
        : f(std::move(of)), nx(columns), ny(rows), driving(how_many_drive) {
        for (int j = 0; j < ny; ++j)
            for (int i = 0; i < nx; ++i) cells_.push_back({double(i) / nx, double(j) / ny, 1.0 / nx, 1.0 / ny});
        apply_rules();
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
        apply_rules();
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
            apply_rules();
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
            bool done = evaluations() >= max_evaluations;
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
                if (marked >= all / 2 || evaluations() >= max_evaluations) break;
                cut(at, cells_[at].cut_x);
                marked += e;
            }
            apply_rules();
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
        apply_rules();
        return !too_large.empty();
    }

    values at(double x, double y) const { return f(x, y); }
    const values& integral() const { return total_; }
    /// By the two rules of different degree: usually far too large, but nothing where the integrand jumps between the
    /// points.
    const values& error() const { return error_; }
    long evaluations() const { return 17 * static_cast<long>(cells_.size()); }
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
        cells_.push_back(low), cells_.push_back(high);
    }

    /// To the cells that are new.
    void apply_rules() {
        detail::rehearse([&] {
            for (cell c : std::vector<cell>(cells_.begin() + static_cast<std::ptrdiff_t>(ready), cells_.end()))
                genz_malik(c, f, driving, nx, ny);
        });
        for (; ready < cells_.size(); ++ready) genz_malik(cells_[ready], f, driving, nx, ny);
    }

    integrand f;
    int nx, ny;
    std::size_t driving;
    std::vector<cell> cells_;
    std::size_t ready = 0;
    values total_{}, error_{};
};

}  // namespace lobe::testkit
