// Lights, anti-aliasing, the numbers that artists give, and multiple scattering.
#include "models.hpp"

#include <lobe/core/frame.hpp>
#include <lobe/energy/fdez_aguera.hpp>
#include <lobe/energy/kulla_conty.hpp>
#include <lobe/energy/random_walk.hpp>
#include <lobe/energy/smith_multiscatter.hpp>
#include <lobe/energy/turquin.hpp>
#include <lobe/fresnel/ior.hpp>
#include <lobe/lights/punctual.hpp>
#include <lobe/ndf/blinn_phong.hpp>
#include <lobe/width/antialiasing.hpp>

namespace {

using lobe::vec2, lobe::vec3;

/// A light is built once and shines on many points: of the square below it.
struct at_a_point {
    [[gnu::always_inline]] static auto of(const auto& light, const auto& e) {
        const auto u = e.u();
        const auto arriving = light({u.x, u.y, decltype(u.x)(0)});
        return four(arriving.l, arriving.illuminance);
    }
};
template <class T>
constexpr vec3<T> light_position() {
    return {T(0.25f), T(0.5f), T(0.75f)};
}

section lights() {
    rows_of<at_a_point> rows("Punctual lights",
                             {{"l", unit_of_error::absolute, 0, 3}, {"E", unit_of_error::weight, 3, 1}});
    rows.add("`point_light`", []<class T>(const element<T>&) { return lobe::point_light{light_position<T>(), T(3)}; });
    rows.add("`point_light`, `inverse_square_within`", []<class T>(const element<T>&) {
        return lobe::point_light{light_position<T>(), T(3), lobe::inverse_square_within{T(1.5f)}};
    });
    rows.add("`spot_light`", []<class T>(const element<T>&) {
        return lobe::spot_light{light_position<T>(), vec3<T>{T(0), T(0), T(-1)}, T(3), lobe::cone{T(0.25f), T(0.75f)}};
    });
    return rows.made;
}

template <class T>
result<1, T> number(const lobe::alpha<T>& a) {
    return {a.value()};
}
template <class T>
result<2, T> numbers(const lobe::alpha_xy<T>& a) {
    return {a.x(), a.y()};
}

/// Moments of two facets, averaged.
template <template <class> class Moments, class T>
Moments<T> averaged(const element<T>& e) {
    const auto& s = e.in.more.slopes;
    return (Moments<T>::of(vec3<T>{e.at(s[0]), e.at(s[1]), T(1)}) +
            Moments<T>::of(vec3<T>{e.at(s[2]), e.at(s[3]), T(1)})) *
           T(0.5f);
}

section antialiasing() {
    rows_of<itself> rows("Anti-aliasing: an isotropic width", {{"alpha", unit_of_error::relative, 0, 1}});
    rows.add("Toksvig 2005, `widened` by `toksvig_variance`", [](const auto& e) {
        return number(lobe::widened(e.alpha(), lobe::toksvig_variance(e.at(e.in.more.length))));
    });
    rows.add("Toksvig 2005, `toksvig_exponent`",
             [](const auto& e) { return one(lobe::toksvig_exponent(e.at(e.in.more.eta), e.at(e.in.more.length))); });
    rows.add("CLEAN, two `clean_moments`, `widened`", [](const auto& e) {
        return number(lobe::widened(e.alpha(), averaged<lobe::clean_moments>(e).variance()));
    });
    rows.add("Tokuyoshi & Kaplanyan 2021, `widened_by_pixel`", []<class T>(const element<T>& e) {
        const auto& s = e.in.more.slopes;
        return number(
            lobe::widened_by_pixel(e.alpha(), {e.at(s[0]), e.at(s[1]), T(0)}, {e.at(s[2]), e.at(s[3]), T(0)}));
    });
    return rows.made;
}

section anisotropic_antialiasing() {
    rows_of<itself> rows("Anti-aliasing: widths along axes of their own",
                         {{"wide", unit_of_error::relative, 0, 1}, {"narrow", unit_of_error::relative, 1, 1}});
    rows.add("LEAN, two `lean_moments`, `widened`", [](const auto& e) {
        return numbers(lobe::widened(e.alpha_xy(), averaged<lobe::lean_moments>(e).covariance()).width);
    });
    rows.add("Tokuyoshi & Kaplanyan 2021, `widened_by_half_vector`", []<class T>(const element<T>& e) {
        const auto& s = e.in.more.slopes;
        return numbers(
            lobe::widened_by_half_vector(e.alpha_xy(), vec2<T>{e.at(s[0]), e.at(s[1])}, vec2<T>{e.at(s[2]), e.at(s[3])})
                .width);
    });
    return rows.made;
}

section conversions() {
    rows_of<itself> rows("Roughness, exponent, index", {{"result", unit_of_error::relative, 0, 1}});
    rows.add("`alpha::from_roughness`", []<class T>(const element<T>& e) {
        return number(lobe::alpha<T>::from_roughness(e.at(e.in.more.roughness)));
    });
    rows.add("`blinn_phong_exponent_from_alpha`",
             [](const auto& e) { return one(lobe::blinn_phong_exponent_from_alpha(e.alpha())); });
    rows.add("`alpha_from_blinn_phong_exponent`",
             [](const auto& e) { return number(lobe::alpha_from_blinn_phong_exponent(e.at(e.in.more.eta))); });
    rows.add("`phong_exponent_from_alpha`",
             [](const auto& e) { return one(lobe::phong_exponent_from_alpha(e.alpha())); });
    rows.add("`alpha_from_phong_exponent`",
             [](const auto& e) { return number(lobe::alpha_from_phong_exponent(e.at(e.in.more.eta))); });
    rows.add("`blinn_phong_exponent_from_gloss`", []<class T>(const element<T>& e) {
        return one(lobe::blinn_phong_exponent_from_gloss(e.fraction(), T(8192)));
    });
    rows.add("`f0_from_ior`", [](const auto& e) { return one(lobe::f0_from_ior(e.at(e.in.more.eta))); });
    rows.add("`ior_from_f0`", [](const auto& e) { return one(lobe::ior_from_f0(e.at(e.in.more.f0))); });
    return rows.made;
}

section anisotropies() {
    rows_of<itself> rows("Anisotropy", {{"alpha x, y", unit_of_error::relative, 0, 2}});
    rows.add("`alpha_xy::from_disney`", []<class T>(const element<T>& e) {
        return numbers(lobe::alpha_xy<T>::from_disney(e.at(e.in.more.roughness), e.fraction()));
    });
    rows.add("`alpha_xy::from_imageworks`", []<class T>(const element<T>& e) {
        return numbers(lobe::alpha_xy<T>::from_imageworks(e.at(e.in.more.roughness), e.fraction()));
    });
    rows.add("`alpha_xy::from_openpbr`", []<class T>(const element<T>& e) {
        return numbers(lobe::alpha_xy<T>::from_openpbr(e.at(e.in.more.roughness), e.fraction()));
    });
    return rows.made;
}

/// Numbers in [0,1) of an element's own.
class uniform_numbers {
public:
    explicit uniform_numbers(std::size_t i) : state(static_cast<std::uint32_t>(i) * 747796405u + 2891336453u) {}

    float operator()() {  // O'Neill 2014, "PCG"
        state = state * 747796405u + 2891336453u;
        const std::uint32_t word = ((state >> ((state >> 28) + 4)) ^ state) * 277803737u;
        return static_cast<float>(((word >> 22) ^ word) >> 8) * 0x1p-24f;
    }

private:
    std::uint32_t state;
};

/// What a white environment shows: from the split-sum terms ...
template <class T>
result<3, T> fdez_aguera(const element<T>& e, const lobe::dfg_terms<T>& terms) {
    const auto w = lobe::fdez_aguera{}(terms, e.F0());
    return three(w.radiance + w.irradiance);
}
template <class Model>
constexpr auto weights_of = [](const auto& e) {
    const auto w = Model{}.weights(lobe::schlick{e.F0()}, e.v().z, e.alpha());
    return three(w.radiance + w.irradiance);
};
/// ... and by random walks.
template <class T>
result<3, T> mean_of_walks(const element<T>& e, int walks) {
    const lobe::random_walk surface{lobe::ggx{e.alpha()}, lobe::schlick{e.F0()}};
    uniform_numbers uniform(e.i);
    vec3<T> sum(T(0));
    for (int i = 0; i < walks; ++i) sum += surface.sample(e.v(), uniform).weight;
    return three(sum / T(walks));
}

constexpr int walks = 4096;

section multiple_scattering() {
    rows_of<itself> rows("Multiple scattering", {{"albedo", unit_of_error::absolute, 0, 3}});
    rows.add(
        "`fdez_aguera`, terms from `dfg_table`",
        [](const auto& e) { return fdez_aguera(e, e.built().dfg(e.v().z, e.alpha())); }, "`random_walk`",
        [](const auto& e) { return mean_of_walks(e, walks); });
    const auto weights = [&](const char* label, auto model) {
        rows.add(label, model, "`random_walk`", [](const auto& e) { return mean_of_walks(e, walks); });
    };
    weights("`turquin`, terms from `dfg_fit_precise`", weights_of<lobe::turquin<lobe::dfg_fit_precise>>);
    weights("`kulla_conty`, terms from `dfg_fit_precise`", weights_of<lobe::kulla_conty<lobe::dfg_fit_precise>>);
    weights("`smith_multiscatter`, terms from `dfg_fit_precise`",
            weights_of<lobe::smith_multiscatter<lobe::dfg_fit_precise>>);
    weights("`smith_multiscatter`", weights_of<lobe::smith_multiscatter<>>);
    rows.add("`random_walk`, one walk", [](const auto& e) { return mean_of_walks(e, 1); });
    rows.only_timed();
    return rows.made;
}

}  // namespace

std::vector<section> other_models() {
    return {lights(), antialiasing(), anisotropic_antialiasing(), conversions(), anisotropies(), multiple_scattering()};
}
