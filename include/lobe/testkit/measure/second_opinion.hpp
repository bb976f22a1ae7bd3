// An integral a second time, by chance: what an adaptive rule cannot know of a jump between its points, random points
// do.
#pragma once

#include <lobe/testkit/measure/mesh.hpp>
#include <lobe/testkit/measure/random.hpp>
#include <lobe/testkit/measure/rehearse.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

namespace lobe::testkit::detail {

/// Integrals, and how far off they may be.
template <std::size_t N>
struct estimate {
    std::array<double, N> value{}, error{};
};

/// Rounds of a second opinion, and how many standard errors it may be off: one in 1e4 is further (Student, 31 degrees
/// of freedom).
inline constexpr int opinion_rounds = 32;
inline constexpr double opinion_cells = 2048;  // at least, be the leaves parted for it
inline constexpr double opinion_spread = 4.5;
/// Tails of a density x^-(1+a) hold a/(a - 1) times the largest of all contributions beyond it: 5 at a = 1.25.
inline constexpr double opinion_tail = 5;

/// The mean of rounds, and its standard error.
class rounds_of {
public:
    void add(double x) {
        ++count;
        const double off = x - mean_;
        mean_ += off / count;
        squares += off * (x - mean_);
    }
    double mean() const { return mean_; }
    double standard_error() const { return count > 1 ? std::sqrt(squares / (count * (count - 1.0))) : 0; }

private:
    int count = 0;
    double mean_ = 0, squares = 0;
};

/// The integrals of a mesh and of each of its leaves, by pairs of random points in every leaf, or part of one, opposite
/// each other about the centre: what is linear cancels. No bias, however the integrand jumps; the error is what the
/// rounds say of each other. `f` may draw further numbers.
template <std::size_t N>
struct opinion {
    estimate<N> all;
    std::vector<double> leaf, variance;  // of the first integral, in the order of mesh.leaves()
};
template <std::size_t N, class Integrand>
opinion<N> second_opinion(const mesh<N>& m, const Integrand& f) {
    generator random(12);
    const std::vector<std::size_t> leaves = m.leaves();
    // of a leaf's side
    const int parts = static_cast<int>(std::ceil(std::sqrt(opinion_cells / static_cast<double>(leaves.size()))));
    std::array<rounds_of, N> total;
    std::array<double, N> largest{};  // contribution of one pair
    std::vector<rounds_of> of_leaf(leaves.size());
    /// One round: add(leaf, values at a, values at b, half the area they stand for).
    const auto in_pairs = [&](generator& drawn, const auto& add) {
        for (std::size_t i = 0; i < leaves.size(); ++i) {
            const auto& c = m.cells()[leaves[i]];
            const double width = c.width / parts, height = c.height / parts;
            for (int part = 0; part < parts * parts; ++part) {
                const double x0 = c.x0 + part % parts * width, y0 = c.y0 + part / parts * height, x = drawn(),
                             y = drawn();
                const auto a = f(x0 + x * width, y0 + y * height, drawn);
                add(i, a, f(x0 + (1 - x) * width, y0 + (1 - y) * height, drawn), width * height / 2);
            }
        }
    };
    for (int round = 0; round < opinion_rounds; ++round) {
        rehearse([&] {
            generator copy = random;
            in_pairs(copy, [](auto&&...) {});
        });
        std::array<double, N> sum{};
        std::vector<double> first(leaves.size());
        in_pairs(random, [&](std::size_t i, const auto& a, const auto& b, double half) {
            for (std::size_t k = 0; k < N; ++k) {
                sum[k] += half * (a[k] + b[k]);
                largest[k] = (std::max)(largest[k], half * (std::abs(a[k]) + std::abs(b[k])));
            }
            first[i] += half * (a[0] + b[0]);
        });
        for (std::size_t i = 0; i < leaves.size(); ++i) of_leaf[i].add(first[i]);
        for (std::size_t k = 0; k < N; ++k) total[k].add(sum[k]);
    }
    opinion<N> out;
    for (std::size_t k = 0; k < N; ++k) {
        out.all.value[k] = total[k].mean();
        out.all.error[k] = opinion_spread * total[k].standard_error() + opinion_tail * largest[k] / opinion_rounds;
    }
    for (const rounds_of& r : of_leaf)
        out.leaf.push_back(r.mean()), out.variance.push_back(r.standard_error() * r.standard_error());
    return out;
}
template <std::size_t N>
opinion<N> second_opinion(const mesh<N>& m) {
    return second_opinion(m, [&m](double x, double y, generator&) { return m.at(x, y); });
}

/// Integrals by a rule, and by chance when somebody doubts them.
template <std::size_t N>
class doubtable {
public:
    using second = std::function<estimate<N>()>;
    doubtable() = default;
    doubtable(estimate<N> by_rule, second by_chance) : first(std::move(by_rule)), again_(std::move(by_chance)) {}
    const estimate<N>& operator()(bool doubted) const {
        if (!doubted) return first;
        if (!asked) asked = std::make_shared<estimate<N>>(again_());
        return *asked;
    }

private:
    estimate<N> first{};
    second again_;
    mutable std::shared_ptr<const estimate<N>> asked;
};
template <std::size_t N>
doubtable<N> doubtable_integral(std::shared_ptr<const mesh<N>> m) {
    return {{m->integral(), m->error()}, [m] { return second_opinion(*m).all; }};
}

}  // namespace lobe::testkit::detail
