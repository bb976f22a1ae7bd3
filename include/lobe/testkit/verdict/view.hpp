// A view, and the integrals over it that several properties share.
#pragma once

#include <lobe/testkit/measure/expectation.hpp>
#include <lobe/testkit/measure/light_chart.hpp>
#include <lobe/testkit/measure/moments.hpp>
#include <lobe/testkit/measure/over_directions.hpp>
#include <lobe/testkit/measure/rounding.hpp>
#include <lobe/testkit/measure/second_opinion.hpp>
#include <lobe/testkit/subject/subject.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

namespace lobe::testkit::detail {

/// A number that a spectrum of unknown size does not have.
template <std::size_t N>
bool is_padding(std::size_t k, double x) {
    return k > 0 && N == 16 && same(x, 0);
}

/// Integrals of f_cos over the light, or of the weight over u, as power: a number a channel, then the moments of all
/// channels together.
template <std::size_t N>
struct integrals {
    std::array<double, N> value{}, error{};
    std::array<double, 5> moment{}, moment_error{};
    double uncovered = 0;  // the part of what is reflected that the pdf does not reach
};

template <class T, std::size_t N>
class view {
    subject<T, N>& b;

public:
    using V = vec3<T>;
    using values = std::array<double, N>;

    view(subject<T, N>& judged, const V& from, std::uint64_t seed_of_view)
        : b(judged), v(from), w(normalize(vec3<double>(from))), text(literal("v", from)), seed(seed_of_view),
          chart(w, b.scatters) {
        if (!b.has_sample()) return;
        const auto sampler = [this](const V& u) {
            const auto s = b.sample(v, u);
            return s.ok ? std::optional<V>(s.l) : std::nullopt;
        };
        over_u.emplace(sampler, b.raw.numbers);
    }
    view(const view&) = delete;
    view& operator=(const view&) = delete;

    /// Draws strata^2 samples, and shows them: look(u, s). Some of them tell the integrals where to look.
    template <class Look>
    void draw(const Look& look) {
        if (!b.has_sample()) return;
        const int n = b.effort.strata, stride = (std::max)(1, n * n / 512);
        rehearse([&] {
            generator random(seed);
            for (int i = 0; i < n * n; ++i) {
                const auto s = b.sample(v, random_u<T>(random, b.raw.numbers, i % n, i / n, n));
                if (!s.ok) continue;
                b.f_cos(v, s.l);
                if (b.has_pdf()) b.pdf(v, s.l);
            }
        });
        generator random(seed);
        for (int i = 0; i < n * n; ++i) {
            const V u = random_u<T>(random, b.raw.numbers, i % n, i / n, n);
            const auto s = b.sample(v, u);
            look(u, s);
            if (s.ok && i % stride == 0) some.push_back(chart.find(vec3<double>(s.l)));
        }
        asked = n * n / stride;
    }

    void integrate() {
        reflect();
        if (b.has_sample()) weigh();
    }

    V v;
    vec3<double> w;    // v, of length 1
    std::string text;  // v, as C++
    std::uint64_t seed;
    light_chart chart;
    hints some;                            // where samples lie
    int asked = 0;                         // of how many
    std::optional<expectation<T>> over_u;  // where there are samples

    integrals<N> reflected(bool doubted = false) const { return parted(over_l(doubted)); }
    integrals<N> weighted(bool doubted = false) const { return parted(over_samples(doubted)); }
    double allowed = 0;  // the tolerance, and what rounding does to the integrals of f_cos: relative

private:
    void reflect() {
        const auto m = std::make_shared<mesh<N + 6>>(
            [this](double x, double y) {
                const auto p = chart(x, y);
                const V l(p.l);
                const values f = b.f_cos(v, l);
                const double power = p.area * b.scatters.power(v, l);
                typename mesh<N + 6>::values out{};
                double sum = 0;
                for (std::size_t k = 0; k < N; ++k) sum += out[k] = f[k] * power;
                if (b.has_pdf())
                    if (sum > 0 && same(b.pdf(v, l), 0)) out[N + 5] = sum;
                const auto t = moments_of_light(w, p.l);
                for (std::size_t k = 0; k < 5; ++k) out[N + k] = sum * t[k];
                return out;
            },
            chart.columns, 16, N + 3);
        detail::integrate(*m, chart, w, some, b.effort, N);
        over_l = doubtable_integral<N + 6>(m);
        allowed = b.claims.tolerance +
                  relative_rounding<T>(*m, chart, v, [&](const V& a, const V& c) { return b.total(a, c); });
    }

    void weigh() {
        over_samples = over_u->template of<N + 5>(
            [this](const V& u) {
                const auto s = b.sample(v, u);
                std::array<double, N + 5> out{};
                if (!s.ok) return out;
                double sum = 0;
                const double power = b.scatters.power(v, s.l);
                for (std::size_t k = 0; k < N; ++k) sum += out[k] = s.weight[k] * power;
                const auto t = moments_of_light(w, vec3<double>(s.l));
                for (std::size_t k = 0; k < 5; ++k) out[N + k] = sum * t[k];
                return out;
            },
            b.effort, N + 3, N);
    }

    template <std::size_t M>
    static integrals<N> parted(const estimate<M>& e) {
        integrals<N> out;
        for (std::size_t k = 0; k < N; ++k) out.value[k] = e.value[k], out.error[k] = e.error[k];
        for (std::size_t k = 0; k < 5; ++k) out.moment[k] = e.value[N + k], out.moment_error[k] = e.error[N + k];
        if constexpr (M == N + 6) out.uncovered = e.value[N + 5];
        return out;
    }

    doubtable<N + 6> over_l;
    doubtable<N + 5> over_samples;
};

}  // namespace lobe::testkit::detail
