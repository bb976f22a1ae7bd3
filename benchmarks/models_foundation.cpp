// The foundation, lobe's forms beside those that tutorials print.
#include "models.hpp"
#include "textbook.hpp"
#include "truth.hpp"

#include <lobe/energy/default_dfg.hpp>
#include <lobe/energy/dfg_published.hpp>

namespace {

using enum unit_of_error;
using lobe::ggx, lobe::microfacet, lobe::schlick, lobe::smith_correlated;

/// Sampled by visible normals where no sampler is named. (F0 is not `e.F0()`: a function that returns what another
/// returned keeps clang 14 from vectorising the loop.)
template <class... Sampler>
constexpr auto ggx_lobe = []<class T>(const element<T>& e) {
    return microfacet{ggx{e.alpha()}, smith_correlated{},
                      schlick{lobe::vec3<T>{e.at(e.in.r), e.at(e.in.g), e.at(e.in.b)}}, Sampler{}...};
};
constexpr auto brdf = ggx_lobe<>;
constexpr auto all_normals = ggx_lobe<lobe::all_normals>;

section D_of_a_normal() {
    rows_of<itself> rows("D, isotropic GGX, of a unit normal", {{"D", relative, 0, 1}});
    const auto exact = [](const auto& e) { return one(truth::D(e.m(), e.a(), e.a())); };
    rows.against(
        "lobe `ggx::D`", [](const auto& e) { return one(ggx{e.alpha()}.D(e.m())); }, exact);
    rows.against(
        "textbook, `(a2-1)*NoH*NoH + 1`", [](const auto& e) { return one(textbook::ggx(e.m().z, e.a())); }, exact);
    return rows.made;
}

section D_of_v_and_l() {
    rows_of<itself> rows("D, isotropic GGX, of v and l", {{"D", relative, 0, 1}});
    const auto exact = [](const auto& e) { return one(truth::D(e.v() + e.l(), e.a(), e.a())); };
    rows.against(
        "lobe `ggx::D`", [](const auto& e) { return one(ggx{e.alpha()}.D(e.v() + e.l())); }, exact);
    rows.against(
        "textbook, half vector normalized",
        [](const auto& e) { return one(textbook::ggx(glm::normalize(e.v() + e.l()).z, e.a())); }, exact);
    return rows.made;
}

section anisotropic_D() {
    rows_of<itself> rows("D, anisotropic GGX, of a unit normal", {{"D", relative, 0, 1}});
    const auto exact = [](const auto& e) { return one(truth::D(e.anisotropic_m(), e.at(e.in.ax), e.at(e.in.ay))); };
    rows.against(
        "lobe `ggx::D`", [](const auto& e) { return one(ggx{e.alpha_xy()}.D(e.anisotropic_m())); }, exact);
    rows.against(
        "textbook",
        [](const auto& e) { return one(textbook::ggx_anisotropic(e.anisotropic_m(), e.at(e.in.ax), e.at(e.in.ay))); },
        exact);
    return rows.made;
}

template <class Masking>
constexpr auto visibility = [](const auto& e) { return one(Masking{}.visibility(ggx{e.alpha()}, e.v(), e.l())); };
template <auto Formula>
constexpr auto textbook_visibility = [](const auto& e) { return one(Formula(e.v().z, e.l().z, e.a())); };

section correlated() {
    rows_of<itself> rows("Visibility, correlated", {{"V", relative, 0, 1}});
    const auto exact = [](const auto& e) { return one(truth::visibility_correlated(e.v(), e.l(), e.a())); };
    rows.against("lobe `smith_correlated`", visibility<smith_correlated>, exact);
    rows.against("textbook", textbook_visibility<textbook::visibility_correlated>, exact);
    rows.against("Hammon 2017, no square root", textbook_visibility<textbook::visibility_hammon>, exact, "model");
    return rows.made;
}

section separable() {
    rows_of<itself> rows("Visibility, separable", {{"V", relative, 0, 1}});
    const auto exact = [](const auto& e) { return one(truth::visibility_separable(e.v(), e.l(), e.a())); };
    rows.against("lobe `smith_separable`", visibility<lobe::smith_separable>, exact);
    rows.against("textbook, G1 times G1", textbook_visibility<textbook::visibility_separable>, exact);
    rows.against("Schlick-GGX, k = alpha/2", textbook_visibility<textbook::visibility_schlick_ggx>, exact, "model");
    return rows.made;
}

section fresnel() {
    rows_of<itself> rows("Fresnel, one number", {{"F", relative, 0, 1}});
    const auto exact = [](const auto& e) { return one(truth::schlick(e.at(e.in.r), e.v_m())); };
    rows.against(
        "lobe `schlick`", [](const auto& e) { return one(schlick{e.at(e.in.r)}(e.v_m())); }, exact);
    rows.against(
        "textbook, `pow(1-u, 5)`", [](const auto& e) { return one(textbook::schlick(e.at(e.in.r), e.v_m())); }, exact);
    return rows.made;
}

section fresnel_rgb() {
    rows_of<itself> rows("Fresnel, rgb", {{"F", relative, 0, 3}});
    const auto exact = [](const auto& e) { return three(truth::schlick(e.F0(), e.v_m())); };
    rows.against(
        "lobe `schlick`", [](const auto& e) { return three(schlick{e.F0()}(e.v_m())); }, exact);
    rows.against(
        "textbook, `pow(1-u, 5)`", [](const auto& e) { return three(textbook::schlick(e.F0(), e.v_m())); }, exact);
    return rows.made;
}

template <auto Formula>
constexpr auto textbook_f_cos = [](const auto& e) { return three(Formula(e.v(), e.l(), e.a(), e.F0())); };

section whole_f_cos() {
    rows_of<itself> rows("The whole BRDF: f_cos", {{"f_cos", relative, 0, 3}});
    const auto exact = [](const auto& e) { return three(truth::f_cos(e)); };
    rows.against(
        "lobe `microfacet::f_cos`", [](const auto& e) { return three(brdf(e).f_cos(e.v(), e.l())); }, exact);
    rows.against("textbook, F D V cos", textbook_f_cos<textbook::f_cos<>>, exact);
    rows.against("textbook, F D V cos, `pow(1-u, 5)`", textbook_f_cos<textbook::f_cos<textbook::schlick<glm::vec3>>>,
                 exact);
    rows.against("textbook, F D G / (4 NoV NoL + 0.001) cos, `pow`", textbook_f_cos<textbook::f_cos_guarded>, exact,
                 "guards");
    return rows.made;
}

section f_cos_and_pdf() {
    rows_of<itself> rows("f_cos and pdf together", {{"f_cos, pdf", relative, 0, 4}});
    const auto exact = [](const auto& e) { return four(truth::f_cos(e), truth::pdf_visible(e)); };
    rows.against(
        "lobe `microfacet::evaluate`", [](const auto& e) { return evaluate::of(brdf(e), e); }, exact);
    rows.against(
        "textbook, one half vector",
        [](const auto& e) {
            return four(textbook::f_cos<>(e.v(), e.l(), e.a(), e.F0()), textbook::pdf_visible({e.v(), e.l()}, e.a()));
        },
        exact);
    return rows.made;
}

template <auto Formula>
constexpr auto textbook_pdf = [](const auto& e) {
    return one(Formula({e.v(), e.l()}, e.a()));
};

section pdf_visible() {
    rows_of<itself> rows("pdf, visible normals", {{"pdf", relative, 0, 1}});
    const auto exact = [](const auto& e) { return one(truth::pdf_visible(e)); };
    rows.against(
        "lobe `pdf`, `visible_normals`", [](const auto& e) { return one(brdf(e).pdf(e.v(), e.l())); }, exact);
    rows.against("textbook, G1 D VoH / NoV / (4 VoH)", textbook_pdf<textbook::pdf_visible>, exact);
    return rows.made;
}

section pdf_all() {
    rows_of<itself> rows("pdf, all normals", {{"pdf", relative, 0, 1}});
    const auto exact = [](const auto& e) { return one(truth::pdf_all(e)); };
    rows.against(
        "lobe `pdf`, `all_normals`", [](const auto& e) { return one(all_normals(e).pdf(e.v(), e.l())); }, exact);
    rows.against("textbook, D NoH / (4 VoH)", textbook_pdf<textbook::pdf_all>, exact);
    return rows.made;
}

template <auto Formula>
struct sampled_by {
    float a;
    glm::vec3 F0;
    auto sample(const glm::vec3& v, const glm::vec2& u) const { return Formula(v, u, a, F0); }
};
template <auto Formula>
constexpr auto textbook_sample = [](const auto& e) {
    return sampled_by<Formula>{e.a(), e.F0()};
};
/// Each map of the square is compared with itself.
template <auto Map>
constexpr auto exact_sample = [](const auto& e) {
    const truth::sampled s = Map(e);
    return result<7, real>{s.l.x, s.l.y, s.l.z, s.weight.x, s.weight.y, s.weight.z, s.pdf};
};

section sample_visible() {
    rows_of<sample> rows("Sample visible normals: l, weight, pdf", sample_metrics);
    rows.against("lobe `sample`, `visible_normals`", brdf, exact_sample<truth::sample_caps>);
    rows.against("textbook, Heitz 2018", textbook_sample<textbook::sample_visible>,
                 exact_sample<truth::sample_heitz2018>);
    return rows.made;
}

section sample_all() {
    rows_of<sample> rows("Sample all normals: l, weight, pdf", sample_metrics);
    rows.against("lobe `sample`, `all_normals`", all_normals, exact_sample<truth::sample_all>);
    rows.against("textbook, inverse CDF", textbook_sample<textbook::sample_all>, exact_sample<truth::sample_all>);
    return rows.made;
}

/// lobe's points are half a step off the origin.
template <bool From_0>
constexpr auto exact_hammersley = [](const auto& e) {
    const real n = e.in.points, offset = From_0 ? 0 : 0.5L;
    return result<2, real>{(e.index() + offset) / n, truth::radical_inverse(e.index()) + offset / n};
};

section hammersley() {
    rows_of<itself> rows("Hammersley points", {{"coordinate", absolute, 0, 2}, {"points at 1", points_at_1, 0, 2}});
    rows.against(
        "lobe `hammersley`", [](const auto& e) { return two(lobe::hammersley(e.index(), e.in.points)); },
        exact_hammersley<false>);
    rows.against(
        "textbook, i/N and bits * 2.328e-10",
        [](const auto& e) { return two(textbook::hammersley(e.index(), e.in.points)); }, exact_hammersley<true>);
    return rows.made;
}

section radical_inverse() {
    rows_of<itself> rows("Radical inverse", {{"coordinate", absolute, 0, 1}, {"points at 1", points_at_1, 0, 1}});
    const auto exact = [](const auto& e) { return one(truth::radical_inverse(e.index())); };
    rows.against(
        "lobe `radical_inverse`", [](const auto& e) { return one(lobe::radical_inverse(e.index())); }, exact);
    rows.against(
        "textbook, bits * 2.328e-10", [](const auto& e) { return one(textbook::radical_inverse(e.index())); }, exact);
    return rows.made;
}

section sine_and_cosine() {
    rows_of<itself> rows("Sine and cosine of a turn", {{"sin, cos", relative, 0, 2}});
    const auto exact = [](const auto& e) {
        const real phi = 2 * truth::pi * e.turn();
        return result<2, real>{std::sin(phi), std::cos(phi)};
    };
    rows.against(
        "lobe `sincos_2pi`",
        [](const auto& e) {
            const auto [s, c] = lobe::sincos_2pi(e.turn());
            return result<2>{s, c};
        },
        exact);
    rows.against(
        "`std::sin`, `std::cos` of 2*pi*u",
        [](const auto& e) {
            const float phi = 2.0f * textbook::pi * e.turn();
            return result<2>{std::sin(phi), std::cos(phi)};
        },
        exact);
    return rows.made;
}

constexpr auto exact_dfg = [](const auto& e) { return two(truth::dfg(e)); };

template <class Fit>
constexpr auto fitted = [](const auto& e) { return two(Fit{}(e.v().z, e.alpha())); };

section dfg_look_up() {
    rows_of<itself> rows("Split-sum terms: one look-up", {{"scale, bias", absolute, 0, 2}});
    rows.against(
        "lobe `dfg_table`, 32 x 32", [](const auto& e) { return two(e.built().dfg(e.v().z, e.alpha())); }, exact_dfg,
        "table");
    rows.against(
        "textbook, 32 x 32, 1024 samples an entry",
        [](const auto& e) { return two(textbook::read(*e.in.baked, e.v().z, e.a())); }, exact_dfg, "model, table");
    rows.against(
        "Karis 2014, mobile fit", [](const auto& e) { return two(textbook::karis_mobile(e.v().z, e.a())); }, exact_dfg,
        "model");
    const auto table = [&](const char* label, auto terms) { rows.against(label, terms, exact_dfg, "table"); };
    table("lobe `default_dfg`", fitted<lobe::default_dfg>);
    table("lobe `dfg_table`, 16 x 16", [](const auto& e) { return two(e.built().dfg_16(e.v().z, e.alpha())); });
    table("lobe `dfg_table`, 64 x 64", [](const auto& e) { return two(e.built().dfg_64(e.v().z, e.alpha())); });
    const auto fit = [&](const char* label, auto terms) { rows.against(label, terms, exact_dfg, "model"); };
    fit("lobe `dfg_fit_tiny`", fitted<lobe::dfg_fit_tiny>);
    fit("lobe `dfg_fit_cheap`", fitted<lobe::dfg_fit_cheap>);
    fit("lobe `dfg_fit_medium`", fitted<lobe::dfg_fit_medium>);
    fit("lobe `dfg_fit_precise`", fitted<lobe::dfg_fit_precise>);
    fit("Lazarov 2013, `dfg_lazarov`", fitted<lobe::dfg_lazarov>);
    fit("Hirvonen et al. 2019, `dfg_hirvonen`", fitted<lobe::dfg_hirvonen>);
    fit("MaterialX, `dfg_materialx`", fitted<lobe::dfg_materialx>);
    return rows.made;
}

template <int Order>
constexpr auto quadrature =
    [](const auto& e) { return two(lobe::dfg_exact(smith_correlated{}, e.v().z, e.alpha(), {.order = Order})); };

constexpr auto to_1e_3 = [](const auto& e) {
    return two(lobe::dfg_exact(smith_correlated{}, e.v().z, e.alpha(), {.tolerance = 1e-3}));
};
constexpr auto to_1e_6 = [](const auto& e) {
    return two(lobe::dfg_exact(smith_correlated{}, e.v().z, e.alpha(), {.tolerance = 1e-6}));
};

section dfg_integration() {
    rows_of<itself> rows("Split-sum terms: one integration", {{"scale, bias", absolute, 0, 2}});
    const auto add = [&](const char* label, auto model, const char* kind) {
        rows.against(label, model, exact_dfg, kind);
        rows.not_in_a_loop();
    };
    add("lobe `dfg_exact`, order 16", quadrature<16>, "quadrature");
    add(
        "textbook, 1024 Hammersley samples",
        [](const auto& e) { return two(textbook::integrate_brdf(e.v().z, e.a(), 1024)); }, "model, noise");
    add("lobe `dfg_exact`, order 32", quadrature<32>, "quadrature");
    add("lobe `dfg_exact`, tolerance 1e-3", to_1e_3, "quadrature");
    add("lobe `dfg_exact`, tolerance 1e-6", to_1e_6, "quadrature");
    return rows.made;
}

section dfg_baking() {
    static_assert(32 * 32 == count);
    rows_of<itself> rows("Split-sum terms: baking 32 x 32", {});
    rows.pass("lobe `bake_dfg`",
              [] { return lobe::bake_dfg<float>(smith_correlated{}, {.size = 32})(0.5f, lobe::alpha{0.5f}).scale; });
    rows.pass("textbook, 1024 samples an entry", [] { return textbook::bake(32, 1024).scale[0]; });
    return rows.made;
}

}  // namespace

std::vector<section> foundation_sections() {
    return {D_of_a_normal(),   D_of_v_and_l(),   anisotropic_D(),   correlated(),    separable(),
            fresnel(),         fresnel_rgb(),    whole_f_cos(),     f_cos_and_pdf(), pdf_visible(),
            pdf_all(),         sample_visible(), sample_all(),      hammersley(),    radical_inverse(),
            sine_and_cosine(), dfg_look_up(),    dfg_integration(), dfg_baking()};
}
