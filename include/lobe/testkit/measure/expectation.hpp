// Means over all the numbers u that a sampler can be given: over the square, or the cube where it takes three.
#pragma once

#include <lobe/testkit/measure/budget.hpp>
#include <lobe/testkit/measure/mesh.hpp>
#include <lobe/testkit/measure/random.hpp>

#include <array>
#include <cmath>
#include <functional>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace lobe::testkit::detail {

/// `draw(u)` returns a direction where the sampler succeeds. Its edges are magnified, u = t^2 (3 - 2 t): tails, and directions that
/// reflection loses, lie there. The mesh is fine from the start along the border between samples that succeed and that fail, which an
/// adaptive rule alone steps over where it has a narrow tongue. What lies beyond the last step of a float before 1, where heavy tails may
/// hide, counts as error.
template <class T>
class expectation {
public:
    std::function<std::optional<vec3<T>>(const vec3<T>& u)> draw;
    int numbers = 2;

    template <std::size_t N>
    struct mean {
        std::array<double, N> value, error;
    };
    /// The mean of value(u) over all u; the first `driving` decide where to look, the first `colours` are the colours of one thing.
    template <std::size_t N>
    mean<N> of(const std::function<std::array<double, N>(const vec3<T>& u)>& value, const budget& b, std::size_t driving,
               std::size_t colours) const {
        const auto at_u = [&](double x, double y) { return value({below_one<T>(x), below_one<T>(y), T(0)}); };
        mesh<N> m(
            [&](double x, double y) {
                std::array<double, N> out = at_u(magnified(x), magnified(y));
                for (double& k : out) k *= 36 * x * (1 - x) * y * (1 - y);
                return out;
            },
            16, 16, driving);
        constexpr int n = 64;
        std::vector<bool> ok(n * n);
        for (int i = 0; i < n * n; ++i)
            ok[static_cast<std::size_t>(i)] =
                draw({below_one<T>(magnified((i % n + 0.5) / n)), below_one<T>(magnified((i / n + 0.5) / n)), T(0)}).has_value();
        for (int i = 0; i < n * (n - 1); ++i) {
            const auto at = static_cast<std::size_t>(i);
            if (ok[at] != ok[at + n] || (i % n < n - 1 && ok[at] != ok[at + 1])) m.refine_at((i % n + 1.0) / n, (i / n + 1.0) / n, 2);
        }
        m.refine(b.tolerance, colours, b.evaluations);

        mean<N> out{m.integral(), m.error()};
        constexpr double step = 0x1p-24, last = 1 - step;
        for (int i = 0; i < 16 && std::is_same_v<T, float>; ++i) {
            const std::array<double, N> edge_x = at_u(last, (i + 0.5) / 16), edge_y = at_u((i + 0.5) / 16, last);
            for (std::size_t k = 0; k < N; ++k) out.error[k] += (std::abs(edge_x[k]) + std::abs(edge_y[k])) * 8 * step / 16;
        }
        return out;
    }

private:
    static double magnified(double t) { return t * t * (3 - 2 * t); }
};

}  // namespace lobe::testkit::detail
