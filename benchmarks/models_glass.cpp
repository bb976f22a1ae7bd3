// A rough interface, from above: refraction, and both by sampling.
#include "models.hpp"

#include <lobe/bsdf/rough_dielectric.hpp>
#include <lobe/bsdf/thin_dielectric.hpp>

namespace {

using lobe::ggx, lobe::rough_dielectric;

struct refracted_f_cos {
    [[gnu::always_inline]] static auto of(const auto& glass, const auto& e) {
        return one(glass.f_cos(e.v(), e.at(e.in.more.refracted)));
    }
};
struct refracted_pdf {
    [[gnu::always_inline]] static auto of(const auto& glass, const auto& e) {
        return one(glass.pdf(e.v(), e.at(e.in.more.refracted)));
    }
};
struct refracted_evaluate {
    [[gnu::always_inline]] static auto of(const auto& glass, const auto& e) {
        const auto both = glass.evaluate(e.v(), e.at(e.in.more.refracted));
        return two(lobe::vec2<decltype(both.pdf)>{both.f_cos, both.pdf});
    }
};
struct sample_of_glass {
    [[gnu::always_inline]] static auto of(const auto& glass, const auto& e) {
        auto s = glass.sample(e.v(), {e.u().x, e.u().y, e.fraction()});
        using T = decltype(s.pdf);
        if constexpr (std::same_as<T, real>)
            if (std::abs(s.l.z) < 1e-4L) s.pdf = not_counted;
        return result<5, T>{s.l.x, s.l.y, s.l.z, s.weight, s.pdf};
    }
};

template <class Masking>
constexpr auto glass_of = [](const auto& e) {
    return rough_dielectric{ggx{e.alpha()}, Masking{}, e.at(e.in.more.eta)};
};

template <class Operation>
section glass(const char* title, std::vector<metric> metrics) {
    rows_of<Operation> rows(title, std::move(metrics));
    constexpr auto exact = glass_of<lobe::smith_joint_exact>;
    rows.add("`smith_joint`", glass_of<lobe::smith_joint>, "`smith_joint_exact`", exact);
    rows.add("`smith_product`", glass_of<lobe::smith_product>);
    rows.add("`smith_product`, anisotropic", [](const auto& e) {
        return rough_dielectric{ggx{e.alpha_xy()}, lobe::smith_product{}, e.at(e.in.more.eta)};
    });
    rows.add("`smith_joint_exact`", exact);
    rows.not_in_a_loop();
    return rows.made;
}

}  // namespace

std::vector<section> glass_models() {
    using enum unit_of_error;
    std::vector<section> all{
        glass<refracted_f_cos>("Rough glass, refraction: f_cos", {{"f_cos", relative, 0, 1}}),
        glass<refracted_pdf>("Rough glass, refraction: pdf", {{"pdf", relative, 0, 1}}),
        glass<refracted_evaluate>("Rough glass, refraction: f_cos and pdf together", {{"f_cos, pdf", relative, 0, 2}}),
        glass<sample_of_glass>("Rough glass: sample",
                               {{"l", direction, 0, 3}, {"weight", weight, 3, 1}, {"pdf", relative, 4, 1}})};
    rows_of<sample_of_glass> panes("Rough pane: sample",
                                   {{"l", direction, 0, 3}, {"weight", weight, 3, 1}, {"pdf", relative, 4, 1}});
    panes.add("`rough_thin_dielectric`", [](const auto& e) {
        return lobe::rough_thin_dielectric{ggx{e.alpha()}, lobe::smith_correlated{}, e.at(e.in.more.eta)};
    });
    all.push_back(panes.made);
    return all;
}
