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
rows_of<Operation> isotropic(const char* title, const char* note, const char* of) {
    rows_of<Operation> rows(title, note, {{of, unit_of_error::relative, 0, 1}});
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
rows_of<Operation> anisotropic(const char* title, const char* note, const char* of) {
    rows_of<Operation> rows(title, note, {{of, unit_of_error::relative, 0, 1}});
    rows.add("`ggx`", anisotropic_ggx);
    rows.add("`beckmann`", anisotropic_beckmann);
    rows.add("`student_t`, gamma 2.5", []<class T>(const element<T>& e) { return lobe::student_t{e.alpha_xy(), T(2.5f)}; });
    rows.add("`sggx`", [](const auto& e) { return lobe::sggx{e.alpha_xy()}; });
    return rows;
}

}  // namespace

std::vector<model_section> distribution_models() {
    auto D = isotropic<density>(
        "Distributions: D",
        "Of the unit normals that GGX of the width has, in 1/sr. `phong`, `gtr`, `abc` and `sgd` have one width, 0.3 (extreme: 1e-4), as "
        "their constructors normalise and tabulate. Relative errors where D is above 1e-30. Exact: the same formula in long double.",
        "D");
    auto D_xy = anisotropic<anisotropic_density>("Distributions: D, anisotropic", "As above, of two widths.", "D");
    auto sigma = isotropic<area>("Distributions: projected area",
                                 "sigma(v), what masking is made of. Exact: closed forms in long double; for those with a table the "
                                 "integral of their facets. `beckmann_walter` is an approximation of `beckmann`.",
                                 "sigma");
    sigma.add("`beckmann_walter`", walter, "`beckmann`", isotropic_beckmann);
    auto sigma_xy = anisotropic<area>("Distributions: projected area, anisotropic", "As above.", "sigma");
    sigma_xy.add("`beckmann_walter`", anisotropic_walter, "`beckmann`", anisotropic_beckmann);

    rows_of<lambda> L("Distributions: Lambda",
                      "Smith's Lambda where it has a form of its own; elsewhere it is the area of the back faces over the cosine. Lambda: "
                      "relative errors where it is above 1e-30, which for Beckmann of alpha 1e-4 it nowhere is; `beckmann_walter` has 0 "
                      "from cot = 1.6 alpha on. 1 + Lambda, which is what masking sees of it: relative to the larger of 1 and Lambda.",
                      {{"Lambda", unit_of_error::relative, 0, 1}, {"1 + Lambda", unit_of_error::weight, 0, 1}});
    L.add("`ggx`", isotropic_ggx);
    L.add("`beckmann`", isotropic_beckmann);
    L.add("`beckmann_walter`", walter, "`beckmann`", isotropic_beckmann);
    return {D.made, D_xy.made, sigma.made, sigma_xy.made, L.made};
}
