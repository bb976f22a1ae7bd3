// Means over all the numbers u that a sampler can be given: over the square, or the cube where it takes three.
#pragma once

#include <lobe/testkit/measure/budget.hpp>
#include <lobe/testkit/measure/jumps.hpp>
#include <lobe/testkit/measure/mesh.hpp>
#include <lobe/testkit/measure/rehearse.hpp>
#include <lobe/testkit/measure/second_opinion.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace lobe::testkit::detail {

/// A box of numbers in which the sampler does not jump, but for curves. The edges of x and y are magnified, u = t^2 (3
/// - 2 t): tails, and directions that reflection loses, lie there.
template <class T>
struct box {
    std::array<T, 3> low{}, high{};

    T number(std::size_t axis, double t) const {
        const double from = static_cast<double>(low[axis]), to = static_cast<double>(high[axis]);
        return (std::clamp)(static_cast<T>(from + (to - from) * t), low[axis], last(axis));
    }
    vec3<T> at(double x, double y, double third = 0.5) const {
        return {number(0, magnified(x)), number(1, magnified(y)), number(2, third)};
    }
    double size(std::size_t axis) const { return static_cast<double>(high[axis]) - static_cast<double>(low[axis]); }
    double volume() const { return size(0) * size(1) * size(2); }
    T last(std::size_t axis) const { return std::nextafter(high[axis], T(0)); }

    static double magnified(double t) { return t * t * (3 - 2 * t); }
    static double magnification(double t) { return 6 * t * (1 - t); }
};

/// `draw(u)` returns a direction where the sampler succeeds. The square is cut where it jumps to another lobe, and the
/// boxes lie side by side in one mesh, which is fine from the start along the border between samples that succeed and
/// that fail: an adaptive rule alone steps over a narrow tongue of it. What lies beyond the last step of a float in a
/// box, where heavy tails may hide, counts as error.
template <class T>
class expectation {
public:
    expectation(drawing<T> sampler, int how_many) : draw(std::move(sampler)), numbers(how_many) {
        const jumps<T> found(draw, numbers);
        selects = found.selects;
        std::array<std::vector<T>, 3> ends;
        for (std::size_t k = 0; k < 3; ++k) {
            ends[k] = {T(0)};
            ends[k].insert(ends[k].end(), found.at[k].begin(), found.at[k].end());
            ends[k].push_back(T(1));
        }
        for (std::size_t z = 0; z + 1 < ends[2].size(); ++z)
            for (std::size_t y = 0; y + 1 < ends[1].size(); ++y)
                for (std::size_t x = 0; x + 1 < ends[0].size(); ++x)
                    boxes.push_back(
                        {{ends[0][x], ends[1][y], ends[2][z]}, {ends[0][x + 1], ends[1][y + 1], ends[2][z + 1]}});
    }

    /// The mean of value(u) over all u; the first `driving` decide where to look, the first `colours` are the colours
    /// of one thing.
    template <std::size_t N>
    doubtable<N> of(const std::function<std::array<double, N>(const vec3<T>& u)>& value, const budget& b,
                    std::size_t driving, std::size_t colours) const {
        if (!selects) return {by_chance<N>(value, 11), [value] { return by_chance<N>(value, 13); }};
        return over_boxes<N>(value, b, driving, colours);
    }

    drawing<T> draw;
    int numbers;

private:
    template <std::size_t N>
    using integrand = std::function<std::array<double, N>(const vec3<T>& u)>;

    template <std::size_t N>
    doubtable<N> over_boxes(const integrand<N>& value, const budget& b, std::size_t driving,
                            std::size_t colours) const {
        const std::size_t count = boxes.size();
        const int columns = (std::max)(6, 16 / static_cast<int>(count));
        const auto scaled = static_cast<double>(count);
        const auto side_by_side = [this, value, count, scaled](double x, double y, double third) {
            const std::size_t which = (std::min)(static_cast<std::size_t>(x * scaled), count - 1);
            const double local = x * scaled - static_cast<double>(which);
            std::array<double, N> out = value(boxes[which].at(local, y, third));
            const double size =
                boxes[which].volume() * scaled * box<T>::magnification(local) * box<T>::magnification(y);
            for (double& k : out) k *= size;
            return out;
        };
        const auto m = std::make_shared<mesh<N>>([side_by_side](double x, double y) { return side_by_side(x, y, 0.5); },
                                                 count == 1 ? 16 : columns * static_cast<int>(count), 16, driving);
        const int n = count == 1 ? 64 : count < 5 ? 32 : 16;
        for (std::size_t which = 0; which < count; ++which)
            for (const auto& [x, y] : border(boxes[which], n))
                m->refine_at((static_cast<double>(which) + x) / scaled, y, 2);
        m->refine(b.tolerance, colours, b.evaluations);

        std::array<double, N> beyond{};
        if constexpr (std::is_same_v<T, float>)
            for (const box<T>& a : boxes)
                for (int i = 0; i < 16; ++i)
                    for (const std::size_t axis : {0u, 1u}) {
                        const double along = box<T>::magnified((i + 0.5) / 16),
                                     width = 8 * 0x1p-24 / 16 * a.size(1 - axis) * a.size(2);
                        const auto edge = [&](double end) {
                            return value(axis == 0 ? a.at(end, along) : a.at(along, end));
                        };
                        add_sizes<N>(beyond, edge(1), width);
                        if (a.low[axis] > T(0)) add_sizes<N>(beyond, edge(0), width);
                    }
        const auto with_beyond = [beyond](estimate<N> e) {
            add_sizes<N>(e.error, beyond, 1);
            return e;
        };
        // By chance the third number, too: a lobe may be so thin that no line met it.
        return {with_beyond({m->integral(), m->error()}), [m, side_by_side, with_beyond, numbers = this->numbers] {
                    const auto anywhere = [&](double x, double y, generator& random) {
                        return side_by_side(x, y, numbers == 3 ? random() : 0.5);
                    };
                    return with_beyond(second_opinion(*m, anywhere).all);
                }};
    }

    /// Corners of n^2 squares between which samples begin to fail.
    std::vector<std::array<double, 2>> border(const box<T>& a, int n) const {
        const auto succeeds = [&](int i) { return draw(a.at((i % n + 0.5) / n, (i / n + 0.5) / n)).has_value(); };
        rehearse([&] {
            for (int i = 0; i < n * n; ++i) succeeds(i);
        });
        std::vector<bool> ok;
        ok.reserve(static_cast<std::size_t>(n * n));
        for (int i = 0; i < n * n; ++i) ok.push_back(succeeds(i));
        std::vector<std::array<double, 2>> out;
        for (int i = 0; i < n * (n - 1); ++i) {
            const auto at = static_cast<std::size_t>(i), above = static_cast<std::size_t>(i + n);
            if (ok[at] != ok[above] || (i % n < n - 1 && ok[at] != ok[at + 1]))
                out.push_back({(i % n + 1.0) / n, (i / n + 1.0) / n});
        }
        return out;
    }

    /// Where the third number does more than select a lobe, no mesh of the square will do: the mean of 32 means, each
    /// of one sample in each of 12^3 cubes. The error is six times what their spread says: exceeded by one in 1e6,
    /// where the tails are not heavy (Student, 31 degrees of freedom).
    template <std::size_t N>
    static estimate<N> by_chance(const integrand<N>& value, std::uint64_t seed) {
        constexpr int rounds = 32, n = 12;
        generator random(seed);
        estimate<N> out;
        std::array<double, N> squares{};
        for (int i = 0; i < rounds; ++i) {
            const auto mean = [&](generator& drawn) {
                std::array<double, N> sum{};
                for (int k = 0; k < n * n * n; ++k) {
                    const double x = (k % n + drawn()) / n, y = (k / n % n + drawn()) / n,
                                 z = (k / (n * n) + drawn()) / n;
                    const std::array<double, N> one = value({below_one<T>(x), below_one<T>(y), below_one<T>(z)});
                    for (std::size_t c = 0; c < N; ++c) sum[c] += one[c] / (n * n * n);
                }
                return sum;
            };
            rehearse([&] {
                generator copy = random;
                mean(copy);
            });
            const std::array<double, N> sum = mean(random);
            for (std::size_t c = 0; c < N; ++c) out.value[c] += sum[c] / rounds, squares[c] += sum[c] * sum[c] / rounds;
        }
        for (std::size_t c = 0; c < N; ++c)
            out.error[c] = 6 * std::sqrt((std::max)(0.0, squares[c] - out.value[c] * out.value[c]) / (rounds - 1));
        return out;
    }

    template <std::size_t N>
    static void add_sizes(std::array<double, N>& sum, const std::array<double, N>& x, double weight) {
        for (std::size_t k = 0; k < N; ++k) sum[k] += weight * std::abs(x[k]);
    }

    std::vector<box<T>> boxes;
    bool selects = true;
};

}  // namespace lobe::testkit::detail
