// What lobe's own functions return, as structs of a shader. A 1 or a 3 in a name says how many channels it has.
#pragma once

#include <lobe/brdf/concepts.hpp>
#include <lobe/energy/dfg.hpp>
#include <lobe/energy/multiple_scattering.hpp>
#include <lobe/shader/function.hpp>

namespace lobe::shader {

template <>
struct members<evaluation<real, real>> {
    using S = evaluation<real, real>;
    static constexpr auto name = "evaluation1";
    static constexpr std::tuple fields{field{"f_cos", &S::f_cos}, field{"pdf", &S::pdf}};
};
template <>
struct members<evaluation<vec3, real>> {
    using S = evaluation<vec3, real>;
    static constexpr auto name = "evaluation3";
    static constexpr std::tuple fields{field{"f_cos", &S::f_cos}, field{"pdf", &S::pdf}};
};
template <>
struct members<direction_sample<real, real>> {
    using S = direction_sample<real, real>;
    static constexpr auto name = "direction_sample1";
    static constexpr std::tuple fields{field{"l", &S::l}, field{"weight", &S::weight}, field{"pdf", &S::pdf}};
};
template <>
struct members<direction_sample<vec3, real>> {
    using S = direction_sample<vec3, real>;
    static constexpr auto name = "direction_sample3";
    static constexpr std::tuple fields{field{"l", &S::l}, field{"weight", &S::weight}, field{"pdf", &S::pdf}};
};
template <>
struct members<dfg_terms<real>> {
    using S = dfg_terms<real>;
    static constexpr auto name = "dfg_terms";
    static constexpr std::tuple fields{field{"scale", &S::scale}, field{"bias", &S::bias}};
};
template <>
struct members<ibl_weights<real>> {
    using S = ibl_weights<real>;
    static constexpr auto name = "ibl_weights1";
    static constexpr std::tuple fields{field{"radiance", &S::radiance}, field{"irradiance", &S::irradiance}};
};
template <>
struct members<ibl_weights<vec3>> {
    using S = ibl_weights<vec3>;
    static constexpr auto name = "ibl_weights3";
    static constexpr std::tuple fields{field{"radiance", &S::radiance}, field{"irradiance", &S::irradiance}};
};

}  // namespace lobe::shader
