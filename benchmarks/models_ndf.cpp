// Distributions of normals.
#include "models.hpp"

#include <lobe/ndf/beckmann.hpp>
#include <lobe/ndf/blinn_phong.hpp>
#include <lobe/ndf/masked_by.hpp>
#include <lobe/ndf/mixture.hpp>
#include <lobe/ndf/sggx.hpp>
#include <lobe/ndf/student_t.hpp>

namespace {

using lobe::alpha, lobe::ggx, lobe::beckmann;

/// Below this float runs out of exponents, and a relative error says nothing.
template <class T>
result<1, T> if_not_tiny(const T& x) {
    if constexpr (std::same_as<T, real>)
        return {x < 1e-30L ? not_counted : x};
    else
        return {x};
}

struct density {
    [[gnu::always_inline]] static auto of(const auto& ndf, const auto& e) { return if_not_tiny(ndf.D(e.m())); }
};
struct anisotropic_density {
    [[gnu::always_inline]] static auto of(const auto& ndf, const auto& e) {
        return if_not_tiny(ndf.D(e.anisotropic_m()));
    }
};
struct area {
    [[gnu::always_inline]] static auto of(const auto& ndf, const auto& e) { return one(ndf.projected_area(e.v())); }
};
struct lambda {
    [[gnu::always_inline]] static auto of(const auto& ndf, const auto& e) { return if_not_tiny(ndf.lambda(e.v())); }
};

constexpr auto isotropic_ggx = [](const auto& e) { return ggx{e.alpha()}; };
constexpr auto isotropic_beckmann = [](const auto& e) { return beckmann{e.alpha()}; };
constexpr auto walter = [](const auto& e) { return lobe::beckmann_walter{e.alpha()}; };
constexpr auto anisotropic_ggx = [](const auto& e) { return ggx{e.alpha_xy()}; };
constexpr auto anisotropic_beckmann = [](const auto& e) { return beckmann{e.alpha_xy()}; };
constexpr auto anisotropic_walter = [](const auto& e) { return lobe::beckmann_walter{e.alpha_xy()}; };

template <class Operation>
rows_of<Operation> isotropic(const char* title, const char* of) {
    rows_of<Operation> rows(title, {{of, unit_of_error::relative, 0, 1}});
    rows.add("`ggx`", isotropic_ggx);
    rows.add("`beckmann`", isotropic_beckmann);
    rows.add("`student_t`, gamma 2.5", []<class T>(const element<T>& e) {
        return lobe::student_t{e.alpha(), T(2.5f)};
    });
    rows.add("`hyper_cauchy`, gamma 2.5", []<class T>(const element<T>& e) {
        return lobe::hyper_cauchy{e.alpha(), T(2.5f)};
    });
    rows.add("`blinn_phong`", [](const auto& e) { return lobe::blinn_phong{e.alpha()}; });
    rows.add("`mixture`, 3/4 `ggx`, 1/4 `beckmann`", []<class T>(const element<T>& e) {
        return lobe::mixture{ggx{e.alpha()}, beckmann{alpha<T>(e.alpha().value() / T(2))}, T(0.25f)};
    });
    rows.add("`masked_by`, `blinn_phong` by `beckmann`", [](const auto& e) {
        return lobe::masked_by{lobe::blinn_phong{e.alpha()}, beckmann{e.alpha()}};
    });
    rows.add("`sggx`", [](const auto& e) { return lobe::sggx{e.alpha()}; });
    return rows;
}

/// What has no area is made where it is asked for its D ...
void add_densities(rows_of<density>& rows) {
    rows.add("`exponential_power`, p 1/2", []<class T>(const element<T>& e) {
        return lobe::exponential_power{e.alpha(), T(0.5f)};
    });
    rows.add("`phong`", [](const auto& e) { return lobe::phong{e.alpha()}; });
    rows.add("`gtr`, gamma 1", []<class T>(const element<T>& e) { return lobe::gtr{e.alpha(), T(1)}; });
    rows.add("`gtr`, gamma 3/2", []<class T>(const element<T>& e) { return lobe::gtr{e.alpha(), T(1.5f)}; });
    rows.add("`abc`, C 3/2", []<class T>(const element<T>& e) { return lobe::abc{e.alpha(), T(1.5f)}; });
    rows.add("`sgd`, p 1/2", []<class T>(const element<T>& e) { return lobe::sgd{e.alpha(), T(0.5f)}; });
}

/// ... and its table once.
void add_tabulated(rows_of<area>& rows) {
    const auto add = [&](const char* label, const auto& model) { rows.add(label, model, "table"); };
    add("`tabulated`, `exponential_power`, p 1/2", [](const auto& e) {
        return lobe::stretched{lobe::shared{e.built().exponential_power}, e.alpha()};
    });
    add(
        "`tabulated`, `phong`", [](const auto& e) -> const auto& { return e.built().phong; });
    add(
        "`tabulated`, `gtr`, gamma 1", [](const auto& e) -> const auto& { return e.built().gtr_1; });
    add(
        "`tabulated`, `gtr`, gamma 3/2", [](const auto& e) -> const auto& { return e.built().gtr_3_2; });
    add(
        "`tabulated`, `abc`, C 3/2", [](const auto& e) -> const auto& { return e.built().abc; });
    add(
        "`tabulated`, `sgd`, p 1/2", [](const auto& e) -> const auto& { return e.built().sgd; });
}

template <class Operation>
rows_of<Operation> anisotropic(const char* title, const char* of) {
    rows_of<Operation> rows(title, {{of, unit_of_error::relative, 0, 1}});
    rows.add("`ggx`", anisotropic_ggx);
    rows.add("`beckmann`", anisotropic_beckmann);
    rows.add("`student_t`, gamma 2.5", []<class T>(const element<T>& e) {
        return lobe::student_t{e.alpha_xy(), T(2.5f)};
    });
    rows.add("`sggx`", [](const auto& e) { return lobe::sggx{e.alpha_xy()}; });
    return rows;
}

}  // namespace

std::vector<section> distribution_models() {
    auto D = isotropic<density>("Distributions: D", "D");
    add_densities(D);
    auto D_xy = anisotropic<anisotropic_density>("Distributions: D, anisotropic", "D");
    auto sigma = isotropic<area>("Distributions: projected area", "sigma");
    add_tabulated(sigma);
    sigma.add("`beckmann_walter`", walter, "`beckmann`", isotropic_beckmann);
    auto sigma_xy = anisotropic<area>("Distributions: projected area, anisotropic", "sigma");
    sigma_xy.add("`beckmann_walter`", anisotropic_walter, "`beckmann`", anisotropic_beckmann);

    rows_of<lambda> L("Distributions: Lambda",
                      {{"Lambda", unit_of_error::relative, 0, 1}, {"1 + Lambda", unit_of_error::weight, 0, 1}});
    L.add("`ggx`", isotropic_ggx);
    L.add("`beckmann`", isotropic_beckmann);
    L.add("`beckmann_walter`", walter, "`beckmann`", isotropic_beckmann);
    return {D.made, D_xy.made, sigma.made, sigma_xy.made, L.made};
}
