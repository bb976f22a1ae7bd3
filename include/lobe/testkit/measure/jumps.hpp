// Where a sampler turns to another lobe: the values of one of its numbers at which its samples jump, whatever the
// others are.
#pragma once

#include <lobe/testkit/measure/random.hpp>
#include <lobe/testkit/measure/rehearse.hpp>

#include <lobe/core/vector.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace lobe::testkit::detail {

/// What becomes of the numbers: a direction, where the sampler succeeds.
template <class T>
using drawing = std::function<std::optional<vec3<T>>(const vec3<T>& u)>;

/// Looks along lines: an interval across which samples move further than across its neighbours is cut, and halved until
/// it holds one step of T. A jump that is there on other lines, too, is the border of a lobe; one that is not is a
/// curve in the square, left to the mesh.
template <class T>
class jumps {
public:
    std::array<std::vector<T>, 3> at{};  // increasing, in (0,1): the first number after the jump
    // the third number does nothing between its jumps, which are the same for all x and y
    bool selects = true;

    jumps(const drawing<T>& sampler, int numbers) : draw(sampler) {
        for (int axis = 0; axis < numbers; ++axis) {
            std::vector<T> found;
            for (std::size_t i = 0; i < lines.size(); ++i)
                for (const T x : along(axis, i)) found.push_back(x);
            std::sort(found.begin(), found.end());
            for (const T x : found) {
                std::vector<T>& of_axis = at[static_cast<std::size_t>(axis)];
                if (!of_axis.empty() && !(x > of_axis.back() + 16 * step(x))) continue;
                int seen = 0;
                for (const line& l : lines) seen += is_jump(axis, l, x);
                if (seen >= 2)
                    of_axis.push_back(x);
                else if (axis == 2)
                    selects = false;
            }
        }
        if (numbers == 3 && moves()) selects = false;
    }

private:
    using outcome = std::optional<vec3<T>>;
    using line = std::array<double, 2>;  // the other numbers
    static constexpr std::array<line, 4> lines{{{0.37, 0.61}, {0.81, 0.23}, {0.13, 0.87}, {0.56, 0.42}}};

    static T step(T x) { return x * std::numeric_limits<T>::epsilon(); }

    outcome on(int axis, const line& l, T x) const {
        vec3<T> u;
        u[axis] = x, u[(axis + 1) % 3] = static_cast<T>(l[0]), u[(axis + 2) % 3] = static_cast<T>(l[1]);
        return draw(u);
    }

    static double distance(const outcome& a, const outcome& b) {
        if (!a || !b) return a || b ? 2 : 0;
        return static_cast<double>(length(*a - *b));
    }

    /// Numbers on a line, and what becomes of them.
    struct scan {
        std::vector<T> x;
        std::vector<outcome> o;
    };
    scan scanned(int axis, const line& l, std::vector<T> x) const {
        scan out{std::move(x), {}};
        rehearse([&] {
            for (const T one : out.x) on(axis, l, one);
        });
        for (const T one : out.x) out.o.push_back(on(axis, l, one));
        return out;
    }

    /// Intervals across which samples move more than across their neighbours: the median of eight, for jumps come in
    /// pairs and closer.
    static std::vector<std::size_t> suspects(const scan& s) {
        std::vector<double> apart;
        for (std::size_t i = 0; i + 1 < s.o.size(); ++i) apart.push_back(distance(s.o[i], s.o[i + 1]));
        std::vector<std::size_t> out;
        for (std::size_t i = 0; i < apart.size(); ++i) {
            const std::size_t from = i < 4 ? 0 : i - 4, to = (std::min)(i + 5, apart.size());
            std::vector<double> beside(apart.begin() + static_cast<std::ptrdiff_t>(from),
                                       apart.begin() + static_cast<std::ptrdiff_t>(to));
            const auto middle = beside.begin() + static_cast<std::ptrdiff_t>(beside.size() / 2);
            std::nth_element(beside.begin(), middle, beside.end());
            if (apart[i] > 2 * *middle + least && out.size() < 16) out.push_back(i);
        }
        return out;
    }

    /// Jumps on one line.
    std::vector<T> along(int axis, std::size_t which) const {
        const line& l = lines[which];
        std::vector<T> x;
        for (int i = 0; i < 192; ++i) {
            const double t = (i + (static_cast<double>(which) + 0.5) / lines.size()) / 192;
            x.push_back(below_one<T>(t * t * (3 - 2 * t)));
        }
        const scan coarse = scanned(axis, l, std::move(x));
        std::vector<T> found;
        for (const std::size_t i : suspects(coarse)) {
            std::vector<T> between;
            for (int k = 0; k <= 12; ++k)
                between.push_back(coarse.x[i] + (coarse.x[i + 1] - coarse.x[i]) * static_cast<T>(k) / T(12));
            const scan fine = scanned(axis, l, std::move(between));
            for (const std::size_t k : suspects(fine))
                if (const auto jump = halved(axis, l, fine.x[k], fine.o[k], fine.x[k + 1], fine.o[k + 1]))
                    found.push_back(*jump);
        }
        return found;
    }

    /// The first number after the jump.
    std::optional<T> halved(int axis, const line& l, T low, outcome at_low, T high, outcome at_high) const {
        const double before = distance(at_low, at_high);
        for (int i = 0; i < 60; ++i) {
            if (i % 5 == 0) rehearse([&] { ask_halves(axis, l, low, high, 5); });
            const T middle = low + (high - low) / 2;
            if (!(middle > low && middle < high)) break;
            const outcome here = on(axis, l, middle);
            if (distance(at_low, here) > distance(here, at_high))
                high = middle, at_high = here;
            else
                low = middle, at_low = here;
            if (i > 5 && distance(at_low, at_high) < before / 8) return std::nullopt;  // it was only steep
        }
        return high;
    }

    /// All places at which some halvings of an interval may ask.
    void ask_halves(int axis, const line& l, T low, T high, int halvings) const {
        const T middle = low + (high - low) / 2;
        if (!halvings || !(middle > low && middle < high)) return;
        on(axis, l, middle);
        ask_halves(axis, l, low, middle, halvings - 1);
        ask_halves(axis, l, middle, high, halvings - 1);
    }

    /// Further apart across x than on either side of it.
    bool is_jump(int axis, const line& l, T x) const {
        const T d = (std::max)(4 * step(x), static_cast<T>(1e-7) * (std::min)(x, T(1) - x));
        if (!(x - 3 * d > T(0)) || !(x + 3 * d < T(1))) return true;
        rehearse([&] {
            for (const T at_x : {x - 3 * d, x - d, x + d, x + 3 * d}) on(axis, l, at_x);
        });
        const outcome a = on(axis, l, x - 3 * d), b = on(axis, l, x - d), c = on(axis, l, x + d),
                      e = on(axis, l, x + 3 * d);
        return distance(b, c) > 4 * (std::max)(distance(a, b), distance(c, e)) + least;
    }

    /// Does the third number change samples between its jumps?
    bool moves() const {
        std::vector<T> ends{T(0)};
        ends.insert(ends.end(), at[2].begin(), at[2].end());
        ends.push_back(T(1));
        for (std::size_t i = 0; i + 1 < ends.size(); ++i)
            for (const line& l : lines)
                if (distance(on(2, l, ends[i] + (ends[i + 1] - ends[i]) / 3),
                             on(2, l, ends[i] + (ends[i + 1] - ends[i]) * T(0.7))) > least)
                    return true;
        return false;
    }

    static constexpr double least = 1e-5;
    const drawing<T>& draw;
};

}  // namespace lobe::testkit::detail
