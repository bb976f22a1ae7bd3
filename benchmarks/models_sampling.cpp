// Samplers, and the compositions that are sampled by them.
#include "models.hpp"

#include <lobe/brdf/eon.hpp>
#include <lobe/brdf/ggx_samplers.hpp>
#include <lobe/brdf/metallic_roughness.hpp>
#include <lobe/ndf/beckmann.hpp>
#include <lobe/ndf/student_t.hpp>

#include <algorithm>
#include <cstdio>

namespace {

using lobe::alpha, lobe::ggx, lobe::microfacet, lobe::schlick, lobe::smith_correlated;

/// A lobe of any distribution, with the Fresnel of the element.
template <class N, class Sampler = lobe::visible_normals>
[[gnu::always_inline]] inline auto lobe_of(const N& ndf, const auto& e, const Sampler& sampler = {}) {
    return microfacet{ndf, smith_correlated{}, schlick{e.F0()}, sampler};
}
template <class Sampler>
constexpr auto ggx_lobe = [](const auto& e) { return lobe_of(ggx{e.alpha()}, e, Sampler{}); };

std::string text(const char* format, double x) {
    char buffer[32];
    std::snprintf(buffer, sizeof buffer, format, x);
    return buffer;
}

/// var(weight)/mean(weight)^2 over all samples, failed ones included: the number of samples that leaves an error of 100
/// %.
double relative_variance(const auto& brdf, double mu) {
    constexpr std::uint32_t n = 1 << 16;
    double sum = 0, squares = 0;
    for (std::uint32_t i = 0; i < n; ++i) {
        const double weight =
            brdf.sample({std::sqrt((1 - mu) * (1 + mu)), 0, mu}, lobe::hammersley<double>(i, n)).weight;
        sum += weight;
        squares += weight * weight;
    }
    return squares * n / (sum * sum) - 1;
}
template <class Sampler>
double relative_variance(const Sampler& sampler, double width, double mu) {
    return relative_variance(microfacet{ggx{alpha{width}}, smith_correlated{}, lobe::perfect_reflector{}, sampler}, mu);
}

std::vector<std::vector<std::string>> diffuse_variances() {
    std::vector<std::vector<std::string>> table{
        {"variance / mean^2 of the weight"}, {"`backscatter_sampling`"}, {"`cosine_sampling`"}};
    for (const double r : {0.1, 0.5, 1.0})
        for (const double mu : {0.5, 0.1, 0.01}) {
            table[0].push_back("r " + text("%.1f", r) + ", cos " + text("%.2f", mu));
            table[1].push_back(text("%.2g", relative_variance(lobe::eon{1.0, r}, mu)));
            table[2].push_back(
                text("%.2g", relative_variance(lobe::eon{1.0, r, lobe::fon_loss{}, lobe::cosine_sampling{}}, mu)));
        }
    return table;
}

std::vector<std::vector<std::string>> variances() {
    std::vector<std::vector<std::string>> table{{"variance / mean^2 of the weight"},
                                                {"`visible_normals`, `visible_heitz2018`"},
                                                {"`visible_bounded_caps`"},
                                                {"`all_normals`"}};
    for (const double width : {0.1, 0.5, 1.0})
        for (const double mu : {0.95, 0.5, 0.1}) {
            table[0].push_back("alpha " + text("%.1f", width) + ", cos " + text("%.2f", mu));
            table[1].push_back(text("%.2g", relative_variance(lobe::visible_normals{}, width, mu)));
            table[2].push_back(text("%.2g", relative_variance(lobe::visible_bounded_caps{}, width, mu)));
            table[3].push_back(text("%.2g", relative_variance(lobe::all_normals{}, width, mu)));
        }
    return table;
}

std::vector<section> samplers() {
    rows_of<sample> of_ggx("Samplers of GGX", sample_metrics);
    of_ggx.add("`visible_normals`", ggx_lobe<lobe::visible_normals>);
    of_ggx.add("`visible_bounded_caps`", ggx_lobe<lobe::visible_bounded_caps>);
    of_ggx.add("`visible_heitz2018`", ggx_lobe<lobe::visible_heitz2018>);
    of_ggx.add("`all_normals`", ggx_lobe<lobe::all_normals>);
    if (exact_results_too) of_ggx.made.extra = variances();

    rows_of<sample> others("Samplers of other distributions", sample_metrics);
    const auto student = []<class T>(const element<T>& e) { return lobe_of(lobe::student_t{e.alpha(), T(2.5f)}, e); };
    others.add("`beckmann`, visible normals", [](const auto& e) { return lobe_of(lobe::beckmann{e.alpha()}, e); });
    others.add("`beckmann`, `all_normals`",
               [](const auto& e) { return lobe_of(lobe::beckmann{e.alpha()}, e, lobe::all_normals{}); });
    others.add("`student_t`, gamma 2.5, visible normals", student);
    others.not_in_a_loop();

    rows_of<sample> diffuse("Samplers of `eon`", {{"l", unit_of_error::absolute, 0, 3},
                                                  {"weight", unit_of_error::weight, 3, 3},
                                                  {"pdf", unit_of_error::relative, 6, 1}});
    diffuse.add("`backscatter_sampling`", [](const auto& e) {
        return lobe::eon{e.F0(), e.fraction(), lobe::fon_loss_fit{}};
    });
    diffuse.add("`cosine_sampling`", [](const auto& e) {
        return lobe::eon{e.F0(), e.fraction(), lobe::fon_loss_fit{}, lobe::cosine_sampling{}};
    });
    if (exact_results_too) diffuse.made.extra = diffuse_variances();

    rows_of<itself> maps("Maps of the square", {{"x, y, z", unit_of_error::absolute, 0, 3}});
    maps.add("`square_to_cosine_hemisphere`",
             [](const auto& e) { return three(lobe::square_to_cosine_hemisphere(e.u())); });
    maps.add("`square_to_cosine_hemisphere_concentric`",
             [](const auto& e) { return three(lobe::square_to_cosine_hemisphere_concentric(e.u())); });
    maps.add("`square_to_uniform_hemisphere`",
             [](const auto& e) { return three(lobe::square_to_uniform_hemisphere(e.u())); });
    rows_of<itself> disks("Maps of the square: disks", {{"x, y", unit_of_error::absolute, 0, 2}});
    disks.add("`square_to_uniform_disk`", [](const auto& e) { return two(lobe::square_to_uniform_disk(e.u())); });
    disks.add("`square_to_uniform_disk_concentric`",
              [](const auto& e) { return two(lobe::square_to_uniform_disk_concentric(e.u())); });
    return {of_ggx.made, others.made, diffuse.made, maps.made, disks.made};
}

/// The directional albedo of the element's GGX lobe, from the table ...
template <class T>
struct table_albedo {
    const element<T>& e;
    lobe::vec3<T> operator()(const T& mu) const {
        const auto t = e.built().dfg(mu, e.alpha());
        return e.F0() * t.scale + lobe::vec3<T>(t.bias);
    }
};
/// ... and by quadrature.
template <class T>
struct exact_albedo {
    const element<T>& e;
    lobe::vec3<T> operator()(const T& mu) const {
        const auto t =
            lobe::dfg_exact(smith_correlated{}, static_cast<double>(mu), alpha{double(e.in.a[e.i])}, {.order = 32});
        return e.F0() * T(t.scale) + lobe::vec3<T>(T(t.bias));
    }
};

/// GGX over Lambert.
[[gnu::always_inline]] inline auto over_lambert(const auto& e, const auto& coupling) {
    return lobe::layered{lobe_of(ggx{e.alpha()}, e), lobe::lambert{e.at(e.in.more.metal_F0)}, coupling};
}
[[gnu::always_inline]] inline auto metallic(const auto& e) {
    return lobe::metallic_roughness(e.at(e.in.more.metal_F0), e.fraction(), e.alpha());
}

template <template <class> class Albedo>
constexpr auto with_albedo =
    []<class T>(const element<T>& e) { return over_lambert(e, lobe::albedo_coupling{Albedo<T>{e}}); };
template <template <class> class Albedo>
constexpr auto reciprocal = []<class T>(const element<T>& e) {
    return over_lambert(e, lobe::reciprocal_coupling{Albedo<T>{e}, e.at(e.in.more.E_avg)});
};

template <class Operation>
rows_of<Operation> compositions(const char* title, std::vector<metric> metrics) {
    rows_of<Operation> rows(title, std::move(metrics));
    const auto from_table = [&](const char* label, auto model, [[maybe_unused]] auto exact) {
        if constexpr (std::same_as<Operation, f_cos>)
            rows.add(label, model, "exact albedo", exact);
        else
            rows.add(label, model);
    };
    rows.add("`microfacet` alone", ggx_lobe<lobe::visible_normals>);
    rows.add("`metallic_roughness`", [](const auto& e) { return metallic(e); });
    rows.add("`layered`, `fresnel_coupling`",
             [](const auto& e) { return over_lambert(e, lobe::fresnel_coupling{schlick{e.F0()}}); });
    from_table("`layered`, `albedo_coupling`, table", with_albedo<table_albedo>, with_albedo<exact_albedo>);
    from_table("`layered`, `reciprocal_coupling`, table", reciprocal<table_albedo>, reciprocal<exact_albedo>);
    rows.add("`coated` `metallic_roughness`", []<class T>(const element<T>& e) {
        return lobe::coated(metallic(e), ggx{alpha<T>(T(0.125f))}, e.fraction());
    });
    rows.add("`sum` of two specular lobes", []<class T>(const element<T>& e) {
        const T w = e.fraction();
        return lobe::sum{lobe::weighted{T(1) - w, lobe_of(ggx{e.alpha()}, e)},
                         lobe::weighted{w, lobe_of(ggx{alpha<T>(T(0.5f))}, e)}};
    });
    return rows;
}

}  // namespace

std::vector<section> sampler_models() {
    using enum unit_of_error;
    std::vector<section> all = samplers();
    all.push_back(compositions<f_cos>("Compositions: f_cos", {{"f_cos", relative, 0, 3}}).made);
    all.push_back(
        compositions<evaluate>("Compositions: f_cos and pdf together", {{"f_cos, pdf", relative, 0, 4}}).made);
    all.push_back(compositions<sample>("Compositions: sample", sample_metrics).made);
    return all;
}
