// Two BRDFs, side by side.
#pragma once

#include <lobe/testkit/compare/differences.hpp>
#include <lobe/testkit/compare/energy.hpp>
#include <lobe/testkit/compare/places.hpp>
#include <lobe/testkit/measure/budget.hpp>
#include <lobe/testkit/measure/half_vector_chart.hpp>
#include <lobe/testkit/subject/brdf.hpp>
#include <lobe/testkit/verdict/attempt.hpp>

#include <array>

namespace lobe::testkit {

namespace id {
inline constexpr property_id equal_f_cos{"equal_f_cos", "f_cos: the same values"};
inline constexpr property_id share_of_f_cos{"share_of_f_cos", "f_cos: share of directions that differ"};
inline constexpr property_id equal_pdf{"equal_pdf", "pdf: the same values"};
inline constexpr property_id share_of_pdf{"share_of_pdf", "pdf: share of directions that differ"};
}  // namespace id

namespace detail {

/// f_cos and pdf, computed in A, as functions of a place in T.
template <class T, std::size_t N, class A, std::size_t M>
auto f_cos_at(const brdf_functions<A, M>& brdf) {
    return [f = brdf.f_cos](const place<T>& at) { return as_values<N>(f(vec3<A>(at.v), vec3<A>(at.l))); };
}
template <class T, class A, std::size_t M>
typename side_by_side<T, 1>::function pdf_at(const brdf_functions<A, M>& brdf) {
    if (!brdf.pdf) return {};
    return [f = brdf.pdf](const place<T>& at) { return std::array{f(vec3<A>(at.v), vec3<A>(at.l))}; };
}

template <class T, std::size_t N>
void compare_energy(report& r, const side_by_side<T, N>& f, const compare_options& o) {
    const budget effort = budget_of(o.effort);
    energy_rows energy;
    for (int i = 0; i < effort.views; ++i) {
        const double t = (i + 0.5) / effort.views;
        const vec3<T> v = direction<T>(i == 0   ? 1
                                       : i == 1 ? 0.01
                                                : 0.02 + 0.97 * t * (0.4 + 0.6 * t),
                                       golden_angle * i);
        const half_vector_chart chart(normalize(vec3<double>(v)));
        const auto at = [&](const vec3<double>& l) { return place<T>{.v = v, .l = vec3<T>(l)}; };
        energy_mesh m(
            [&](double x, double y) {
                const auto p = chart(x, y);
                return energy_of(f.a(at(p.l)), f.b(at(p.l)), p.area);
            },
            8, 16, 2);
        for (const vec3<double>& w : {vec3<double>(v), vec3<double>{0, 0, 1}}) {
            const auto peak = chart.find(w);
            m.refine_at(peak[0], peak[1], 4);
        }
        m.refine(effort.tolerance, 1, effort.evaluations);
        const auto total = [&](const vec3<T>& a, const vec3<T>& c) {
            double sum = 0;
            for (const double x : (f.a_is_finer ? f.a : f.b)(place<T>{.v = a, .l = c})) sum += x;
            return sum;
        };
        energy.add(m, o.tolerance + relative_rounding<T>(m, chart, v, total), literal("v", v));
    }
    energy.report_to(r);
}

template <class T, std::size_t N>
report compared_brdfs(const side_by_side<T, N>& f, const side_by_side<T, 1>& pdf, const compare_options& o) {
    report r = opened(as_options(o));
    if (!r.passed()) return r;
    place<T> last{};
    const auto input = [](const place<T>& at) { return at.text(); };
    attempt(
        r, [&] { return last.text(); },
        [&] {
            differences<T, N> of_f({id::equal_f_cos, id::share_of_f_cos}, o.tolerance, f);
            differences<T, 1> of_pdf({id::equal_pdf, id::share_of_pdf}, o.tolerance, pdf);
            for_each_pair<T>(o, [&](const vec3<T>& v, const vec3<T>& l, bool counts) {
                last = {.v = v, .l = l};
                of_f.look(last, counts);
                if (pdf.a && pdf.b) of_pdf.look(last, counts);
            });
            of_f.report_to(r, input);
            compare_energy(r, f, o);
            if (pdf.a && pdf.b) of_pdf.report_to(r, input);
        });
    return r;
}

template <class A, std::size_t NA, class B, std::size_t NB>
report compared(const brdf_functions<A, NA>& a, const brdf_functions<B, NB>& b, const compare_options& o) {
    static_assert(NA == NB || NA == 1 || NB == 1, "a and b return spectra of different sizes");
    using T = coarser<A, B>;
    constexpr std::size_t N = (std::max)(NA, NB);
    const bool a_is_finer = !std::is_same_v<A, T>, b_is_finer = !std::is_same_v<B, T>;
    return compared_brdfs<T, N>({f_cos_at<T, N>(a), f_cos_at<T, N>(b), a_is_finer, b_is_finer},
                                {pdf_at<T>(a), pdf_at<T>(b), a_is_finer, b_is_finer}, o);
}

}  // namespace detail

}  // namespace lobe::testkit
