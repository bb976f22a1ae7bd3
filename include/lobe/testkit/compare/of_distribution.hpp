// Two distributions of normals, side by side.
#pragma once

#include <lobe/testkit/compare/differences.hpp>
#include <lobe/testkit/compare/energy.hpp>
#include <lobe/testkit/compare/places.hpp>
#include <lobe/testkit/measure/budget.hpp>
#include <lobe/testkit/measure/normal_chart.hpp>
#include <lobe/testkit/subject/distribution.hpp>
#include <lobe/testkit/verdict/attempt.hpp>

#include <array>
#include <cmath>
#include <functional>
#include <utility>

namespace lobe::testkit {

namespace id {
inline constexpr property_id equal_D{"equal_D", "D: the same values"};
inline constexpr property_id share_of_D{"share_of_D", "D: share of normals that differ"};
inline constexpr property_id equal_area{"equal_area", "projected area (or Lambda, G1): the same values"};
inline constexpr property_id share_of_area{"share_of_area", "projected area: share of directions that differ"};
}  // namespace id

namespace detail {

/// A function of one direction, computed in A, as one of a place in T.
template <class T, class A>
typename side_by_side<T, 1>::function of_normal(std::function<double(const vec3<A>&)> f) {
    if (!f) return {};
    return [f = std::move(f)](const place<T>& at) { return std::array{f(vec3<A>(at.v))}; };
}

template <class T>
report compared_distributions(const side_by_side<T, 1>& D, const side_by_side<T, 1>& area, const compare_options& o) {
    report r = opened(as_options(o));
    if (!r.passed()) return r;
    place<T> last{};
    const auto input = [](const place<T>& at) { return at.text(); };
    attempt(
        r, [&] { return last.text(); },
        [&] {
            differences<T, 1> of_D({id::equal_D, id::share_of_D}, o.tolerance, D);
            differences<T, 1> of_area({id::equal_area, id::share_of_area}, o.tolerance, area);
            generator random(o.seed, 12);
            for (int i = 0, n = places_of(o.effort) / 2; i < n; ++i) {
                const bool even = i % 2 == 0;
                const vec3<T> w = random_direction<T>(random, even, false);
                const double slope = random.log_between(1e-7, 1e3), turn = tau * random();
                const vec3<double> m{slope * std::cos(turn), slope * std::sin(turn), 1};
                last = {.v = even ? w : vec3<T>(normalize(m)), .has_l = false, .first = "m"};
                of_D.look(last, even);
                if (!area.a || !area.b) continue;
                last = {.v = w, .has_l = false, .first = "w"};
                of_area.look(last, even);
            }
            of_D.report_to(r, input);
            energy_mesh m(
                [&](double x, double y) {
                    const auto p = normal_chart{}(x, y);
                    const place<T> at{.v = vec3<T>(p.l), .has_l = false};
                    return energy_of(D.a(at), D.b(at), p.l.z * p.area);
                },
                8, 16, 2);
            const budget effort = budget_of(o.effort);
            m.refine(effort.tolerance, 1, effort.evaluations);
            energy_rows energy;
            const auto value = [&](const vec3<T>& w, const vec3<T>&) {
                return (D.a_is_finer ? D.a : D.b)(place<T>{.v = w, .has_l = false})[0];
            };
            energy.add(m, o.tolerance + relative_rounding<T>(m, normal_chart{}, vec3<T>(0, 0, 1), value), "");
            energy.report_to(r);
            if (area.a && area.b) of_area.report_to(r, input);
        });
    return r;
}

template <class A, class B>
report compared(const distribution_functions<A>& a, const distribution_functions<B>& b, const compare_options& o) {
    using T = coarser<A, B>;
    const bool a_is_finer = !std::is_same_v<A, T>, b_is_finer = !std::is_same_v<B, T>;
    return compared_distributions<T>({of_normal<T>(a.D), of_normal<T>(b.D), a_is_finer, b_is_finer},
                                     {of_normal<T>(a.area), of_normal<T>(b.area), a_is_finer, b_is_finer}, o);
}

}  // namespace detail

}  // namespace lobe::testkit
