// A white furnace: no more light comes back than was sent, for a fixed view and for a fixed light.
#pragma once

#include <lobe/testkit/verdict/per_view.hpp>
#include <lobe/testkit/verdict/property.hpp>

#include <memory>

namespace lobe::testkit {

namespace id {
inline constexpr property_id furnace{"white_furnace", "white furnace is at most 1"};
inline constexpr property_id lossless_furnace{"white_furnace", "white furnace is 1"};
inline constexpr property_id furnace_of_light{"white_furnace_of_light", "white furnace of a light is at most 1"};
inline constexpr property_id lossless_furnace_of_light{"white_furnace_of_light", "white furnace of a light is 1"};
}  // namespace id

namespace detail {

template <class T, std::size_t N>
class furnace : public brdf_property<T, N> {
public:
    using typename brdf_property<T, N>::view;
    explicit furnace(subject<T, N>& judged)
        : brdf_property<T, N>(judged),
          of_view(
              judged.claims.lossless ? id::lossless_furnace : id::furnace,
              judged.scatters.both
                  ? "energy is gained: reflection and refraction do not share it (F and 1 - F of the same v.m), the "
                    "Jacobian of the refracted half vector, (eta_v/eta_l)^2 of radiance missing or upside down, a D "
                    "that is not normalised, or a masking that is missing"
                  : "energy is gained: a diffuse part that does not give up what the specular part reflects, a D that "
                    "is not normalised, a masking that is missing or of another width, a compensation with the wrong "
                    "average, or a constant",
              judged.claims.lossless ? relation::equal : relation::at_most,
              "energy is lost: single scattering only, a factor too many, or a compensation with the wrong average") {}

    /// int f(v,l) cos(theta_l) dl.
    void at_view(const view& from) override {
        for (std::size_t k = 0; k < N; ++k)
            if (!is_padding<N>(k, from.reflected().value[k]))
                of_view.add([&](bool doubted) -> view_result {
                    const auto E = from.reflected(doubted);
                    return {.measured = E.value[k],
                            .expected = 1,
                            .allowed = from.allowed + E.error[k],
                            .rounding = from.allowed - this->b.claims.tolerance,
                            .v = from.w,
                            .input = from.text};
                });
    }
    void report_to(report& r) override { of_view.report_to(r); }

private:
    per_view of_view;
};

template <class T, std::size_t N>
class furnace_of_light : public brdf_property<T, N> {
public:
    using typename brdf_property<T, N>::view, typename brdf_property<T, N>::values, typename brdf_property<T, N>::V;
    explicit furnace_of_light(subject<T, N>& judged)
        : brdf_property<T, N>(judged),
          of_light(judged.claims.lossless ? id::lossless_furnace_of_light : id::furnace_of_light,
                   "energy is gained for this light, more than for such a view: f(v,l) is not f(l,v), a weight looks "
                   "at the viewer only",
                   judged.claims.lossless ? relation::equal : relation::at_most,
                   "energy is lost for this light, more than for such a view: f(v,l) is not f(l,v), a weight looks at "
                   "the viewer only") {}

    /// int f(v,l) cos(theta_v) dv, the view's direction taken for that of the light.
    void at_view(const view& from) override {
        subject<T, N>& brdf = this->b;
        if (!brdf.claims.reciprocal) return;
        const V& l = from.v;
        const auto over_v = std::make_shared<mesh<N>>(
            [&](double x, double y) {
                const auto p = from.chart(x, y);
                const V v(p.l);
                values f = brdf.f_cos(v, l);
                const double power = p.area * std::abs(static_cast<double>(v.z) / static_cast<double>(l.z)) *
                                     brdf.scatters.power_of_light(v, l);
                for (double& f_k : f) f_k *= power;
                return f;
            },
            from.chart.columns, 16, N);
        integrate(*over_v, from.chart, from.w, {}, brdf.effort, N);
        const double allowed =
            brdf.claims.tolerance +
            relative_rounding<T>(*over_v, from.chart, l, [&](const V& a, const V& c) { return brdf.total(c, a); });
        const auto integral = doubtable_integral<N>(over_v);
        for (std::size_t k = 0; k < N; ++k)
            if (!is_padding<N>(k, over_v->integral()[k]))
                of_light.add([&](bool doubted) -> view_result {
                    const estimate<N>& E = integral(doubted);
                    return {.measured = E.value[k],
                            .expected = 1,
                            .allowed = allowed + E.error[k],
                            .rounding = allowed - brdf.claims.tolerance,
                            .v = from.w,
                            .input = literal("l", l)};
                });
        const auto of_view = from.reflected();
        for (std::size_t k = 0; k < N; ++k) {
            const double error = integral(false).error[k] + of_view.error[k] + 2 * allowed * of_view.value[k];
            as_for_the_view = as_for_the_view &&
                              std::abs(over_v->integral()[k] - of_view.value[k]) <= error + 0.005 * of_view.value[k];
        }
    }
    /// Of what is reciprocal, the two furnaces are one.
    void report_to(report& r) override {
        report alone("");
        of_light.report_to(alone);
        for (check c : alone.checks()) {
            if (!c.passed && as_for_the_view)
                c.meaning = "as for a view, the row above: the two directions are alike, so the cause is the same";
            r.add(c);
        }
    }

private:
    bool as_for_the_view = true;
    per_view of_light;
};

}  // namespace detail

}  // namespace lobe::testkit
