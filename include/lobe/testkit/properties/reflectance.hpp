// A Fresnel reflectance: its range, its shape, its average.
#pragma once

#include <lobe/testkit/measure/mesh.hpp>
#include <lobe/testkit/subject/reflectance.hpp>
#include <lobe/testkit/verdict/per_view.hpp>

#include <cmath>
#include <limits>
#include <string>

namespace lobe::testkit {

namespace id {
inline constexpr property_id F_finite{"F_finite", "F is finite"};
inline constexpr property_id F_not_negative{"F_not_negative", "F is not negative"};
inline constexpr property_id F_at_most_1{"F_at_most_1", "F is at most 1"};
inline constexpr property_id F_rises{"F_rises", "F at grazing is at least F at normal"};
inline constexpr property_id F_flat{"F_flat", "F is flat at normal incidence"};
inline constexpr property_id F_average{"F_average", "average = 2 int F(u) u du"};
}  // namespace id

namespace detail {

template <class T>
inline constexpr double rounding_of_F = 16 * static_cast<double>(std::numeric_limits<T>::epsilon());

template <class T, std::size_t N>
void range(reflectance<T, N>& f, report& r) {
    constexpr double rounding = rounding_of_F<T>;
    const int n = f.claims.effort == effort::quick ? 20000 : 1000000;
    struct extreme {
        double value;
        T cosine;
        std::string text() const { return "cosine = " + literal(cosine); }
    };
    extreme low{0, T(0)}, high{1, T(0)};
    const auto look = [&](double cosine) {
        for (const double x : f.at(cosine)) {
            if (x < low.value) low = {x, f.last};
            if (x > high.value) high = {x, f.last};
        }
    };
    for (int i = 0; i <= n; ++i) look(static_cast<double>(i) / n);
    for (double x = 1; x > 1e-12; x /= 3) look(x), look(1 - x);
    look(static_cast<double>(std::numeric_limits<T>::denorm_min()));
    const bool finite = f.not_finite == 0;
    r.add(id::F_finite, {.passed = finite,
                         .measured = f.none,
                         .input = finite ? "" : extreme{f.none, f.none_at}.text(),
                         .meaning = "a 0/0, or the root or power of a negative number"});
    r.add(id::F_not_negative, {.passed = low.value >= -rounding,
                               .measured = low.value,
                               .tolerance = rounding,
                               .input = low.text(),
                               .meaning = "a reflectance is at least 0"});
    r.add(id::F_at_most_1,
          {.passed = high.value <= 1 + rounding,
           .measured = high.value,
           .expected = 1,
           .tolerance = rounding,
           .input = high.text(),
           .meaning = "a reflectance is at most 1: the factor (1 - F0) is missing, or F90 is above 1"});
}

template <class T, std::size_t N>
void shape(reflectance<T, N>& f, report& r) {
    const auto grazing = f.at(0), normal = f.at(1), close = f.at(1 - 1e-4), further = f.at(1 - 1e-3);
    constexpr double rounding = rounding_of_F<T>;
    std::size_t k = 0, steep = 0;
    double steepest = -1;
    for (std::size_t i = 0; i < N; ++i) {
        if (grazing[i] - normal[i] < grazing[k] - normal[k]) k = i;
        // dF/dcos at 1, extrapolated from two steps: the quadratic term, which is there, cancels.
        const double slope = std::abs(10 * (normal[i] - close[i]) / 1e-4 - (normal[i] - further[i]) / 1e-3) / 9;
        if (slope > steepest) steepest = slope, steep = i;
    }
    r.add(id::F_rises,
          {.passed = grazing[k] >= normal[k] - rounding,
           .measured = grazing[k],
           .expected = normal[k],
           .tolerance = rounding,
           .input = "cosine = 0 and 1",
           .meaning =
               "F falls towards grazing: F0 and F90 are swapped, or the power is of the cosine instead of 1 - cosine"});
    if (!f.claims.flat_at_normal) return;
    const double allowed = 0.02 + 20 * rounding / 1e-4;
    r.add(id::F_flat,
          {.passed = steepest <= allowed,
           .measured = steepest,
           .tolerance = allowed,
           .input = "cosine = 1 - 1e-4, channel " + std::to_string(steep),
           .meaning =
               "dF/dcos is 0 there for every bare interface: 1 - cosine^5 in the place of (1 - cosine)^5, or a power "
               "too low"});
}

template <class T, std::size_t N>
void average(reflectance<T, N>& f, report& r) {
    if (!f.raw.average) return;
    mesh<N> m(
        [&](double x, double) {  // u = x^2 (3 - 2x): both ends magnified
            const double u = x * x * (3 - 2 * x);
            auto out = f.at(u);
            for (double& v : out) v *= 2 * u * 6 * x * (1 - x);
            return out;
        },
        32, 1, N);
    m.refine(1e-5, N, 100000);
    per_view equal(id::F_average, "average() belongs to another function, or lacks the weight of the cosine");
    const auto given = f.raw.average();
    for (std::size_t k = 0; k < N; ++k)
        if (m.integral()[k] > 0 || k == 0)
            equal.add({.measured = given[k],
                       .expected = m.integral()[k],
                       .allowed = f.claims.tolerance * m.integral()[k] + m.error()[k],
                       .v = {0, 0, 1},
                       .input = "channel " + std::to_string(k)});
    equal.report_to(r);
}

}  // namespace detail

}  // namespace lobe::testkit
