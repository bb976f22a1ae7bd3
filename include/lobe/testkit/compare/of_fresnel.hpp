// Two Fresnel reflectances, side by side.
#pragma once

#include <lobe/testkit/compare/differences.hpp>
#include <lobe/testkit/compare/energy.hpp>
#include <lobe/testkit/compare/places.hpp>
#include <lobe/testkit/measure/budget.hpp>
#include <lobe/testkit/subject/reflectance.hpp>
#include <lobe/testkit/verdict/attempt.hpp>

#include <algorithm>
#include <string>

namespace lobe::testkit {

namespace id {
inline constexpr property_id equal_F{"equal_F", "F: the same values"};
inline constexpr property_id share_of_F{"share_of_F", "F: share of cosines that differ"};
}  // namespace id

namespace detail {

/// A function of the cosine, computed in A, as one of a place in T: the z of its v.
template <class T, std::size_t N, class A, std::size_t M>
auto F_at(const fresnel_functions<A, M>& fresnel) {
    return [f = fresnel.at](const place<T>& at) {
        return as_values<N>(f(static_cast<A>((std::min)(at.v.z, T(1)))));  // rounding_noise moves it beyond
    };
}

template <class T, std::size_t N>
report compared_fresnel(const side_by_side<T, N>& F, const compare_options& o) {
    report r = opened(as_options(o));
    if (!r.passed()) return r;
    const auto at = [](double cosine) { return place<T>{.v = {T(0), T(0), static_cast<T>(cosine)}, .has_l = false}; };
    const auto input = [](const place<T>& p) { return "cosine = " + literal(p.v.z); };
    place<T> last{};
    attempt(
        r, [&] { return input(last); },
        [&] {
            differences<T, N> of_F({id::equal_F, id::share_of_F}, o.tolerance, F);
            generator random(o.seed, 13);
            for (int i = 0, n = places_of(o.effort) / 4; i < n; ++i) {
                const double even = (i + 0.5) / n, grazing = random.log_between(1e-6, 1);
                of_F.look(last = at(even), true);
                of_F.look(last = at(grazing), false);
                of_F.look(last = at(1 - grazing), false);
            }
            for (const double end : {0.0, 1.0}) of_F.look(last = at(end), false);
            of_F.report_to(r, input);
            // its cosine-weighted mean: 2 int F(u) u du
            energy_mesh m(
                [&](double x, double) {
                    const place<T> there = at(x);
                    return energy_of(F.a(there), F.b(there), 2 * x);
                },
                16, 1, 2);
            const budget effort = budget_of(o.effort);
            m.refine(effort.tolerance, 1, effort.evaluations);
            energy_rows energy;
            energy.add(m, o.tolerance, "");
            energy.report_to(r);
        });
    return r;
}

template <class A, std::size_t NA, class B, std::size_t NB>
report compared(const fresnel_functions<A, NA>& a, const fresnel_functions<B, NB>& b, const compare_options& o) {
    static_assert(NA == NB || NA == 1 || NB == 1, "a and b return spectra of different sizes");
    using T = coarser<A, B>;
    constexpr std::size_t N = (std::max)(NA, NB);
    return compared_fresnel<T, N>({F_at<T, N>(a), F_at<T, N>(b), !std::is_same_v<A, T>, !std::is_same_v<B, T>}, o);
}

}  // namespace detail

}  // namespace lobe::testkit
