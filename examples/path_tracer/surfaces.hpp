#pragma once

#include "../common/image.hpp"

#include <concepts>
#include <functional>
#include <memory>
#include <type_traits>
#include <variant>

#include <lobe/brdf/eon.hpp>
#include <lobe/bsdf/smooth_dielectric.hpp>
#include <lobe/energy/compensated.hpp>
#include <lobe/energy/compensated_dielectric.hpp>
#include <lobe/energy/metallic_roughness.hpp>
#include <lobe/fresnel/materials.hpp>

// What surfaces are made of. One more is its function here and its name in `surface`.

inline auto diffuse(const vec3& albedo, float roughness) { return lobe::eon{albedo, roughness}; }

inline auto metal(const lobe::conductor<vec3>& fresnel, float roughness) {
    const lobe::ggx normals{lobe::alpha<float>::from_roughness(roughness, 1e-3f)};
    return lobe::compensated{lobe::microfacet{normals, lobe::smith_correlated{}, fresnel}};
}

inline auto brushed_metal(const lobe::conductor<vec3>& fresnel, const lobe::alpha_xy<float>& width) {
    return lobe::microfacet{lobe::ggx{width}, lobe::smith_correlated{}, fresnel};
}

/// glTF's material, with all its energy.
inline auto metallic_roughness(const vec3& base_colour, float metallic, float roughness) {
    const auto a = lobe::alpha<float>::from_roughness(roughness, 1e-3f);
    return lobe::metallic_roughness(base_colour, metallic, a, lobe::smith_multiscatter{});
}

inline auto smooth_glass(float eta) { return lobe::smooth_dielectric{eta}; }

inline auto rough_glass_facets(float eta, float roughness) {
    const lobe::ggx normals{lobe::alpha<float>::from_roughness(roughness, 1e-3f)};
    return lobe::rough_dielectric{normals, lobe::smith_joint{}, eta};
}

/// `later`: of these facets, and outlives what is returned.
inline auto rough_glass(const decltype(rough_glass_facets(0, 0))& facets, const lobe::interface_energy<float>& later) {
    return lobe::compensated_dielectric{facets, later};
}

using surface = std::variant<decltype(diffuse({}, 0)), decltype(metal(lobe::materials::gold<float>(), 0)),
                             decltype(brushed_metal(lobe::materials::gold<float>(), {1, 1})),
                             decltype(metallic_roughness({}, 0, 0)), decltype(smooth_glass(0)),
                             decltype(rough_glass(std::declval<decltype(rough_glass_facets(0, 0))>(),
                                                  std::declval<lobe::interface_energy<float>>()))>;

struct material {
    std::function<surface(const glm::vec2& uv)> at;  // what a point is made of
    vec3 emission{0};
    float eta = 1;                                                         // of glass: index inside over index outside
    vec3 absorption{0};                                                    // ... 1/length
    std::shared_ptr<const lobe::interface_energy<float>> later = nullptr;  // ... what `at` refers to
};

inline material uniform(const surface& all_over) {
    return {[all_over](const glm::vec2&) { return all_over; }};
}
inline material glass(float eta, float roughness, const vec3& absorption) {
    if (roughness == 0) {
        material m = uniform(smooth_glass(eta));
        return {m.at, vec3{0}, eta, absorption};
    }
    const auto facets = rough_glass_facets(eta, roughness);
    const auto later = std::make_shared<const lobe::interface_energy<float>>(facets);
    return {uniform(rough_glass(facets, *later)).at, vec3{0}, eta, absorption, later};
}

// What a path asks a surface for, whatever it is. Tangent space.

template <class B>
constexpr bool is_open = requires {
    requires B::transmits;
};
template <class B>
constexpr bool is_discrete = !lobe::samplable_brdf<B> && !lobe::bsdf<B>;

inline bool transmits(const surface& s) {
    return std::visit([]<class B>(const B&) { return is_open<B>; }, s);
}
inline bool discrete(const surface& s) {
    return std::visit([]<class B>(const B&) { return is_discrete<B>; }, s);
}

/// f |cos| and the density of `sample`; of discrete directions both are 0.
inline lobe::evaluation<vec3, float> evaluate(const surface& s, const vec3& v, const vec3& l) {
    return std::visit(
        [&]<class B>(const B& b) -> lobe::evaluation<vec3, float> {
            if constexpr (is_discrete<B>) {
                return {vec3{0}, 0};
            } else {
                const auto e = b.evaluate(v, l);
                return {vec3(e.f_cos), e.pdf};
            }
        },
        s);
}

/// A direction and its weight; discrete ones have no density: pdf is 0 for them too. A failed sample weighs 0.
inline lobe::direction_sample<vec3, float> sample(const surface& s, const vec3& v, const vec3& u) {
    return std::visit(
        [&]<class B>(const B& b) -> lobe::direction_sample<vec3, float> {
            if constexpr (is_discrete<B>) {
                const auto one = b.sample(v, u.z);
                return {one.l, vec3(one.weight), 0};
            } else if constexpr (lobe::bsdf<B>) {
                const auto one = b.sample(v, u);
                return {one.l, vec3(one.weight), one.pdf};
            } else {
                return b.sample(v, glm::vec2{u.x, u.y});
            }
        },
        s);
}
