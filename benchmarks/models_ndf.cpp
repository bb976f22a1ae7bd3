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
    static constexpr const char* of_tables = "rounding";
    [[gnu::always_inline]] static auto of(const auto& ndf, const auto& e) { return if_not_tiny(ndf.D(e.m())); }
};
struct anisotropic_density {
    [[gnu::always_inline]] static auto of(const auto& ndf, const auto& e) { return if_not_tiny(ndf.D(e.anisotropic_m())); }
};
struct area {
    static constexpr const char* of_tables = "table";
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
    rows.add("`student_t`, gamma 2.5", []<class T>(const element<T>& e) { return lobe::student_t{e.alpha(), T(2.5f)}; });
    rows.add("`hyper_cauchy`, gamma 2.5", []<class T>(const element<T>& e) { return lobe::hyper_cauchy{e.alpha(), T(2.5f)}; });
    rows.add("`blinn_phong`", [](const auto& e) { return lobe::blinn_phong{e.alpha()}; });
    rows.add("`mixture`, 3/4 `ggx`, 1/4 `beckmann`", []<class T>(const element<T>& e) {
        return lobe::mixture{ggx{e.alpha()}, beckmann{alpha<T>(e.alpha().value() / T(2))}, T(0.25f)};
    });
    rows.add("`masked_by`, `blinn_phong` by `beckmann`", [](const auto& e) {
        return lobe::masked_by{lobe::blinn_phong{e.alpha()}, beckmann{e.alpha()}};
    });
    rows.add("`sggx`", [](const auto& e) { return lobe::sggx{e.alpha()}; });
    const char* const kind = Operation::of_tables;
    rows.add(
        "`exponential_power`, p 1/2",
        [](const auto& e) {
            return lobe::stretched{lobe::shared{e.built().exponential_power}, e.alpha()};
        },
        kind);
    rows.add(
        "`phong`", [](const auto& e) -> const auto& { return e.built().phong; }, kind);
    rows.add(
        "`gtr`, gamma 1", [](const auto& e) -> const auto& { return e.built().gtr_1; }, kind);
    rows.add(
        "`gtr`, gamma 3/2", [](const auto& e) -> const auto& { return e.built().gtr_3_2; }, kind);
    rows.add(
        "`abc`, C 3/2", [](const auto& e) -> const auto& { return e.built().abc; }, kind);
    rows.add(
        "`sgd`, p 1/2", [](const auto& e) -> const auto& { return e.built().sgd; }, kind);
    return rows;
}

template <class Operation>
rows_of<Operation> anisotropic(const char* title, const char* of) {
    rows_of<Operation> rows(title, {{of, unit_of_error::relative, 0, 1}});
    rows.add("`ggx`", anisotropic_ggx);
    rows.add("`beckmann`", anisotropic_beckmann);
    rows.add("`student_t`, gamma 2.5", []<class T>(const element<T>& e) { return lobe::student_t{e.alpha_xy(), T(2.5f)}; });
    rows.add("`sggx`", [](const auto& e) { return lobe::sggx{e.alpha_xy()}; });
    return rows;
}

}  // namespace

std::vector<section> distribution_models() {
    auto D = isotropic<density>("Distributions: D", "D");
    auto D_xy = anisotropic<anisotropic_density>("Distributions: D, anisotropic", "D");
    auto sigma = isotropic<area>("Distributions: projected area", "sigma");
    sigma.add("`beckmann_walter`", walter, "`beckmann`", isotropic_beckmann);
    auto sigma_xy = anisotropic<area>("Distributions: projected area, anisotropic", "sigma");
    sigma_xy.add("`beckmann_walter`", anisotropic_walter, "`beckmann`", anisotropic_beckmann);

    rows_of<lambda> L("Distributions: Lambda", {{"Lambda", unit_of_error::relative, 0, 1}, {"1 + Lambda", unit_of_error::weight, 0, 1}});
    L.add("`ggx`", isotropic_ggx);
    L.add("`beckmann`", isotropic_beckmann);
    L.add("`beckmann_walter`", walter, "`beckmann`", isotropic_beckmann);
    return {D.made, D_xy.made, sigma.made, sigma_xy.made, L.made};
}
