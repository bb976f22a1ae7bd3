// Means over all the numbers u that a sampler can be given: over the square, or the cube where it takes three.
#pragma once

#include <lobe/testkit/measure/budget.hpp>
#include <lobe/testkit/measure/jumps.hpp>
#include <lobe/testkit/measure/mesh.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace lobe::testkit::detail {

/// A box of numbers in which the sampler does not jump, but for curves. The edges of x and y are magnified, u = t^2 (3 - 2 t): tails, and
/// directions that reflection loses, lie there.
template <class T>
struct box {
    std::array<T, 3> low{}, high{};

    T number(std::size_t axis, double t) const {
        const double from = static_cast<double>(low[axis]), to = static_cast<double>(high[axis]);
        return (std::clamp)(static_cast<T>(from + (to - from) * t), low[axis], last(axis));
    }
    vec3<T> at(double x, double y, double z) const { return {number(0, magnified(x)), number(1, magnified(y)), number(2, z)}; }
    double size(std::size_t axis) const { return static_cast<double>(high[axis]) - static_cast<double>(low[axis]); }
    double volume() const { return size(0) * size(1) * size(2); }
    T last(std::size_t axis) const { return std::nextafter(high[axis], T(0)); }

    static double magnified(double t) { return t * t * (3 - 2 * t); }
    static double magnification(double t) { return 6 * t * (1 - t); }
};

/// `draw(u)` returns a direction where the sampler succeeds. The square is cut where it jumps to another lobe, and the boxes lie side by side
/// in one mesh, which is fine from the start along the border between samples that succeed and that fail: an adaptive rule alone steps
/// over a narrow tongue of it. What lies beyond the last step of a float in a box, where heavy tails may hide, counts as error.
template <class T>
class expectation {
public:
    template <std::size_t N>
    struct mean {
        std::array<double, N> value{}, error{};
    };

    expectation(drawing<T> sampler, int how_many) : draw(std::move(sampler)), numbers(how_many) {
        const jumps<T> found(draw, numbers);
        third = found.third;
        std::array<std::vector<T>, 3> ends;
        for (std::size_t k = 0; k < 3; ++k) {
            ends[k] = {T(0)};
            ends[k].insert(ends[k].end(), found.at[k].begin(), found.at[k].end());
            ends[k].push_back(T(1));
        }
        for (std::size_t z = 0; z + 1 < ends[2].size(); ++z)
            for (std::size_t y = 0; y + 1 < ends[1].size(); ++y)
                for (std::size_t x = 0; x + 1 < ends[0].size(); ++x)
                    boxes.push_back({{ends[0][x], ends[1][y], ends[2][z]}, {ends[0][x + 1], ends[1][y + 1], ends[2][z + 1]}});
    }

    /// The mean of value(u) over all u; the first `driving` decide where to look, the first `colours` are the colours of one thing.
    template <std::size_t N>
    mean<N> of(const std::function<std::array<double, N>(const vec3<T>& u)>& value, const budget& b, std::size_t driving,
               std::size_t colours) const {
        if (third == third_number::idle) return over_boxes<N>([&](const box<T>& a, double x, double y) { return value(a.at(x, y, 0.5)); }, b, driving, colours);
        budget less = b;
        less.evaluations /= 4;
        if (third == third_number::curved)
            return over_boxes<N>([&](const box<T>& a, double x, double y) { return by_halves<N>(value, a, x, y); }, less, driving, colours);
        const auto gauss = [&](const auto& rule) {
            return over_boxes<N>(
                [&](const box<T>& a, double x, double y) {
                    std::array<double, N> sum{};
                    for (const auto& [z, weight] : rule) add<N>(sum, value(a.at(x, y, z)), weight);
                    return sum;
                },
                less, driving, colours);
        };
        mean<N> out = gauss(gauss_6);
        const mean<N> coarse = gauss(gauss_4);
        for (std::size_t k = 0; k < N; ++k) out.error[k] += std::abs(out.value[k] - coarse.value[k]);
        return out;
    }

    drawing<T> draw;
    int numbers;

private:
    /// int value(box, x, y) over x and y, summed over the boxes.
    template <std::size_t N>
    mean<N> over_boxes(const std::function<std::array<double, N>(const box<T>&, double x, double y)>& value, const budget& b,
                       std::size_t driving, std::size_t colours) const {
        const std::size_t count = boxes.size();
        const int columns = (std::max)(6, 16 / static_cast<int>(count));
        const auto scaled = static_cast<double>(count);
        mesh<N> m(
            [&](double x, double y) {
                const std::size_t which = (std::min)(static_cast<std::size_t>(x * scaled), count - 1);
                const double local = x * scaled - static_cast<double>(which);
                std::array<double, N> out = value(boxes[which], local, y);
                const double size = boxes[which].volume() * scaled * box<T>::magnification(local) * box<T>::magnification(y);
                for (double& k : out) k *= size;
                return out;
            },
            count == 1 ? 16 : columns * static_cast<int>(count), 16, driving);
        const int n = count == 1 ? 64 : count < 5 ? 32 : 16;
        for (std::size_t which = 0; which < count; ++which)
            for (const auto& [x, y] : border(boxes[which], n)) m.refine_at((static_cast<double>(which) + x) / scaled, y, 2);
        m.refine(b.tolerance, colours, b.evaluations);

        mean<N> out{m.integral(), m.error()};
        if constexpr (std::is_same_v<T, float>)
            for (const box<T>& a : boxes)
                for (int i = 0; i < 16; ++i)
                    for (const std::size_t axis : {0u, 1u}) {
                        const double along = box<T>::magnified((i + 0.5) / 16), width = 8 * 0x1p-24 / 16 * a.size(1 - axis) * a.size(2);
                        const auto edge = [&](double end) { return axis == 0 ? value(a, end, along) : value(a, along, end); };
                        add_sizes<N>(out.error, edge(1), width);
                        if (a.low[axis] > T(0)) add_sizes<N>(out.error, edge(0), width);
                    }
        return out;
    }

    /// Corners of n^2 squares between which samples begin to fail.
    std::vector<std::array<double, 2>> border(const box<T>& a, int n) const {
        std::vector<bool> ok;
        for (int i = 0; i < n * n; ++i) ok.push_back(draw(a.at((i % n + 0.5) / n, (i / n + 0.5) / n, 0.5)).has_value());
        std::vector<std::array<double, 2>> out;
        for (int i = 0; i < n * (n - 1); ++i) {
            const auto at = static_cast<std::size_t>(i), above = static_cast<std::size_t>(i + n);
            if (ok[at] != ok[above] || (i % n < n - 1 && ok[at] != ok[at + 1])) out.push_back({(i % n + 1.0) / n, (i / n + 1.0) / n});
        }
        return out;
    }

    /// The mean over z of what is constant between jumps.
    template <std::size_t N, class Value>
    static std::array<double, N> by_halves(const Value& value, const box<T>& a, double x, double y) {
        constexpr int n = 8;
        std::array<double, N> sum{};
        double low = 0, from = 0.5 / n;
        std::array<double, N> here = value(a.at(x, y, from));
        for (int i = 1; i < n; ++i) {
            double to = (i + 0.5) / n;
            const std::array<double, N> there = value(a.at(x, y, to));
            if (here != there) {
                double left = from, right = to;
                for (int halving = 0; halving < 14; ++halving) {
                    const double middle = (left + right) / 2;
                    (value(a.at(x, y, middle)) == here ? left : right) = middle;
                }
                add<N>(sum, here, (left + right) / 2 - low);
                low = (left + right) / 2, here = there;
            }
            from = to;
        }
        add<N>(sum, here, 1 - low);
        return sum;
    }

    template <std::size_t N>
    static void add(std::array<double, N>& sum, const std::array<double, N>& x, double weight) {
        for (std::size_t k = 0; k < N; ++k) sum[k] += weight * x[k];
    }
    template <std::size_t N>
    static void add_sizes(std::array<double, N>& sum, const std::array<double, N>& x, double weight) {
        for (std::size_t k = 0; k < N; ++k) sum[k] += weight * std::abs(x[k]);
    }

    // Gauss & Legendre on [0,1]: nodes, weights.
    using node = std::pair<double, double>;
    static constexpr std::array<node, 4> gauss_4{{{0.06943184420297371, 0.1739274225687269},
                                                  {0.33000947820757187, 0.3260725774312731},
                                                  {0.6699905217924281, 0.3260725774312731},
                                                  {0.9305681557970263, 0.1739274225687269}}};
    static constexpr std::array<node, 6> gauss_6{{{0.03376524289842399, 0.08566224618958517},
                                                  {0.16939530676686774, 0.1803807865240693},
                                                  {0.38069040695840156, 0.23395696728634552},
                                                  {0.6193095930415985, 0.23395696728634552},
                                                  {0.8306046932331322, 0.1803807865240693},
                                                  {0.966234757101576, 0.08566224618958517}}};

    std::vector<box<T>> boxes;
    third_number third = third_number::idle;
};

}  // namespace lobe::testkit::detail
