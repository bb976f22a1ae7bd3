// What BRDFs are composed from, masking and Fresnel, and the diffuse BRDFs.
#include "models.hpp"

#include <lobe/brdf/burley.hpp>
#include <lobe/brdf/eon.hpp>
#include <lobe/brdf/lambert.hpp>
#include <lobe/brdf/oren_nayar.hpp>
#include <lobe/brdf/schlick_ggx.hpp>
#include <lobe/brdf/v_cavity.hpp>
#include <lobe/fresnel/conductor.hpp>
#include <lobe/fresnel/dielectric.hpp>
#include <lobe/fresnel/f82_tint.hpp>
#include <lobe/fresnel/schlick_gaussian.hpp>
#include <lobe/fresnel/schlick_roughness.hpp>
#include <lobe/ndf/beckmann.hpp>

namespace {

using lobe::ggx, lobe::beckmann;

template <class Masking, class N>
struct masked {
    Masking masking;
    N ndf;
};
template <class Masking, class N>
masked(Masking, N) -> masked<Masking, N>;

struct G2 {
    [[gnu::always_inline]] static auto of(const auto& surface, const auto& e) {
        return one(surface.masking.G2(surface.ndf, e.v(), e.l()));
    }
};

/// A masking that takes no constant, of GGX.
template <class Masking>
constexpr auto of_ggx = [](const auto& e) {
    return masked{Masking{}, ggx{e.alpha()}};
};
constexpr auto of_beckmann = [](const auto& e) { return masked{lobe::smith_separable{}, beckmann{e.alpha()}}; };

section masking_models() {
    rows_of<G2> rows("Masking and shadowing", {{"G2", unit_of_error::absolute, 0, 1}});
    constexpr auto correlated = of_ggx<lobe::smith_correlated>;
    constexpr auto separable = of_ggx<lobe::smith_separable>;
    const auto schlick = [&](const char* label, auto model) { rows.add(label, model, "`smith_separable`", separable); };
    rows.add("`smith_correlated`", correlated);
    rows.add("`smith_hammon`", of_ggx<lobe::smith_hammon>, "`smith_correlated`", correlated);
    rows.add("`smith_separable`", separable, "`smith_correlated`", correlated);
    schlick("`schlick_ggx`, `k_from_alpha`", [](const auto& e) {
        return masked{lobe::schlick_ggx{k_from_alpha(e.alpha())}, ggx{e.alpha()}};
    });
    schlick("`schlick_ggx`, `k_ibl`", [](const auto& e) {
        return masked{lobe::schlick_ggx{lobe::k_ibl(e.at(e.in.more.roughness))}, ggx{e.alpha()}};
    });
    schlick("`schlick_ggx`, `k_ue4_direct`", [](const auto& e) {
        return masked{lobe::schlick_ggx{lobe::k_ue4_direct(e.at(e.in.more.roughness))}, ggx{e.alpha()}};
    });
    schlick("`schlick_ggx`, `k_schlick1994`", []<class T>(const element<T>& e) {
        return masked{lobe::schlick_ggx{lobe::k_schlick1994(e.alpha().value() * std::sqrt(T(0.5f)))}, ggx{e.alpha()}};
    });
    rows.add("`smith_direction_correlated`", of_ggx<lobe::smith_direction_correlated>);
    rows.add("`v_cavity`", of_ggx<lobe::v_cavity>);
    rows.add("`smith_separable` of `beckmann`", of_beckmann);
    rows.add(
        "`smith_separable` of `beckmann_walter`",
        [](const auto& e) {
            return masked{lobe::smith_separable{}, lobe::beckmann_walter{e.alpha()}};
        },
        "`beckmann`", of_beckmann);
    return rows.made;
}

struct reflectance {
    [[gnu::always_inline]] static auto of(const auto& fresnel, const auto& e) { return one(fresnel(e.v_m())); }
};
struct reflectance_rgb {
    [[gnu::always_inline]] static auto of(const auto& fresnel, const auto& e) { return three(fresnel(e.v_m())); }
};
struct average {
    [[gnu::always_inline]] static auto of(const auto& fresnel, const auto&) { return one(fresnel.average()); }
};
struct average_rgb {
    [[gnu::always_inline]] static auto of(const auto& fresnel, const auto&) { return three(fresnel.average()); }
};

template <class Operation>
section glass(const char* title, const char* of) {
    rows_of<Operation> rows(title, {{of, unit_of_error::absolute, 0, 1}});
    constexpr auto exact = [](const auto& e) { return lobe::dielectric{e.at(e.in.more.eta)}; };
    constexpr auto schlick = [](const auto& e) { return lobe::schlick{e.at(e.in.more.f0)}; };
    rows.add("`dielectric`", exact);
    rows.add("`schlick`", schlick, "`dielectric`", exact);
    rows.add(
        "`schlick_gaussian`", [](const auto& e) { return lobe::schlick_gaussian{e.at(e.in.more.f0)}; }, "`dielectric`",
        exact);
    rows.add("`schlick_roughness`", [](const auto& e) {
        return lobe::schlick_roughness{e.at(e.in.more.f0), e.fraction()};
    });
    return rows.made;
}

template <class Operation>
section metal(const char* title, const char* of) {
    rows_of<Operation> rows(title, {{of, unit_of_error::absolute, 0, 3}});
    constexpr auto exact = [](const auto& e) {
        return lobe::conductor{e.at(e.in.more.metal_eta), e.at(e.in.more.metal_k)};
    };
    rows.add("`conductor`", exact);
    rows.add(
        "`f82_tint`",
        [](const auto& e) {
            return lobe::f82_tint{e.at(e.in.more.metal_F0), e.at(e.in.more.metal_tint)};
        },
        "`conductor`", exact);
    rows.add(
        "`schlick`", [](const auto& e) { return lobe::schlick{e.at(e.in.more.metal_F0)}; }, "`conductor`", exact);
    rows.add(
        "`schlick_gaussian`", [](const auto& e) { return lobe::schlick_gaussian{e.at(e.in.more.metal_F0)}; },
        "`conductor`", exact);
    return rows.made;
}

section diffuse_models() {
    rows_of<f_cos> rows("Diffuse BRDFs: f_cos", {{"f_cos", unit_of_error::absolute, 0, 3}});
    constexpr auto eon = [](const auto& e) { return lobe::eon{e.F0(), e.fraction()}; };
    rows.add("`lambert`", [](const auto& e) { return lobe::lambert{e.F0()}; });
    rows.add("`oren_nayar`, qualitative model of 1994", [](const auto& e) {
        return lobe::oren_nayar{e.F0(), e.fraction()};
    });
    rows.add("`fon`, Fujii 2012", [](const auto& e) { return lobe::fon{e.F0(), e.fraction()}; });
    rows.add("`eon`", eon);
    rows.add(
        "`eon`, `fon_loss_fit`",
        [](const auto& e) {
            return lobe::eon{e.F0(), e.fraction(), lobe::fon_loss_fit{}};
        },
        "`eon`", eon);
    rows.add("`burley`", [](const auto& e) { return lobe::burley{e.F0(), e.fraction()}; });
    rows.add("`burley_frostbite`", [](const auto& e) { return lobe::burley_frostbite{e.F0(), e.fraction()}; });
    return rows.made;
}

}  // namespace

std::vector<section> brdf_part_models() {
    return {masking_models(),
            glass<reflectance>("Fresnel: glass", "F"),
            metal<reflectance_rgb>("Fresnel: metals, rgb", "F"),
            glass<average>("Fresnel: average of glass", "F_avg"),
            metal<average_rgb>("Fresnel: average of metals, rgb", "F_avg"),
            diffuse_models()};
}
