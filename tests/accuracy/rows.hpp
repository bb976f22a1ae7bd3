// What is promised of rounding: functions, once for float and double as compiled here and for fifty digits; their
// inputs; their bounds.
#pragma once

#include <lobe/brdf/burley.hpp>
#include <lobe/brdf/ggx_samplers.hpp>
#include <lobe/brdf/microfacet.hpp>
#include <lobe/brdf/oren_nayar.hpp>
#include <lobe/brdf/schlick_ggx.hpp>
#include <lobe/brdf/v_cavity.hpp>
#include <lobe/core/frame.hpp>
#include <lobe/fresnel/conductor.hpp>
#include <lobe/fresnel/dielectric.hpp>
#include <lobe/fresnel/f82_tint.hpp>
#include <lobe/fresnel/schlick.hpp>
#include <lobe/fresnel/schlick_gaussian.hpp>
#include <lobe/fresnel/schlick_roughness.hpp>
#include <lobe/ndf/abc.hpp>
#include <lobe/ndf/beckmann.hpp>
#include <lobe/ndf/blinn_phong.hpp>
#include <lobe/ndf/exponential_power.hpp>
#include <lobe/ndf/ggx.hpp>
#include <lobe/ndf/gtr.hpp>
#include <lobe/ndf/sggx.hpp>
#include <lobe/ndf/student_t.hpp>
#include <lobe/sampling/warp.hpp>

#include <string>
#include <vector>

namespace accuracy {

using lobe::alpha;
using lobe::alpha_xy;
using lobe::vec2;
using lobe::vec3;

/// What a row's numbers are, in this order.
enum class inputs {
    turn,          // u
    cosine,        // u
    index,         // an index of refraction
    index_cosine,  // an index above 1, a cosine
    reflectance,   // F0
    roughness,     // roughness, a degree of anisotropy
    direction,     // w
    normal,        // ax = ay, m
    normal_xy,     // ax, ay, m
    view,          // ax = ay, w above the horizon
    view_xy,       // ax, ay, w above the horizon
    view_below,    // ax, ay, w below the horizon
    pair,          // ax = ay, v, l
    pair_xy,       // ax, ay, v, l
    square,        // u
    square_of,     // ax = ay, u
    square_of_xy,  // ax, ay, u
    seen,          // ax = ay, u, v above the horizon
    seen_narrow,   // ax = ay = 1e-4, u, v above the horizon
    seen_xy,       // ax, ay, u, v above the horizon
    seen_below,    // ax = ay from 0.01, u, v below the horizon
};

enum class unit {
    ulp,                 // in the last place of the value
    ulp_of_1,            // 2^-23 in float, 2^-52 in double
    ulp_of_exponential,  // in the last place of the value, times 1 + |ln(D pi ax ay)|, as exponentials round
    ulp_of_power,        // ... times 1 + |ln(D pi ax ay cos^4)|, where 1/cos^4 and a power cancel
    radian,              // the angle between two directions, of float; of double 2^29 times smaller
    // ... over 1 + a |Sv| |S^-1 m|^2/(2 v.m), S the stretch, a the larger width: as visible normals are conditioned
    radian_seen,
    radius,  // the distance of two points of the unit disk, of float; of double 2^29 times smaller
};

/// A function, with values or with directions, and the worst of its errors.
template <class U>
struct row {
    const char* name;
    inputs takes;
    double bound;
    unit in;
    U (*value)(const U* x);
    vec3<U> (*direction)(const U* x) = nullptr;
};

template <class U>
vec3<U> at(const U* x) {
    return {x[0], x[1], x[2]};
}

template <class U>
vec2<U> square(const U* x) {
    return {x[2], x[3]};
}
template <class U>
vec3<U> on_plane(const vec2<U>& p) {
    return {p.x, p.y, U(0)};
}

/// A constant that every type has exactly.
template <class U>
U number(double x) {
    return U(x);
}

/// D of a radial shape of width a, without the table of its area.
template <class U, class Shape>
U density(const Shape& shape, const U* x) {
    return lobe::radial_profile<Shape, U>(shape).D(at(x + 2), alpha<U>(x[0]));
}

template <class U>
std::vector<row<U>> rows() {
    using lobe::beckmann;
    using lobe::ggx;
    using lobe::smith_correlated;
    using lobe::smith_separable;
    constexpr auto ulp = unit::ulp, of_1 = unit::ulp_of_1, exponential = unit::ulp_of_exponential,
                   power = unit::ulp_of_power;
    constexpr auto radian = unit::radian, seen = unit::radian_seen, radius = unit::radius;
    return {
        {"sin of sincos_2pi", inputs::turn, 2, ulp, [](const U* x) { return U(lobe::sincos_2pi(x[0]).sin); }},
        {"cos of sincos_2pi", inputs::turn, 2, ulp, [](const U* x) { return U(lobe::sincos_2pi(x[0]).cos); }},
        {"schlick, F0 = 1/32", inputs::cosine, 8, ulp,
         [](const U* x) { return U(lobe::schlick{number<U>(0.03125)}(x[0])); }},
        {"schlick, F0 = 3/4", inputs::cosine, 2, ulp,
         [](const U* x) { return U(lobe::schlick{number<U>(0.75)}(x[0])); }},
        {"dielectric, eta = 3/2", inputs::cosine, 8, ulp,
         [](const U* x) { return U(lobe::dielectric{number<U>(1.5)}(x[0])); }},
        {"dielectric, eta = 5/2", inputs::cosine, 8, ulp,
         [](const U* x) { return U(lobe::dielectric{number<U>(2.5)}(x[0])); }},
        {"dielectric, eta from 1 to 10", inputs::index_cosine, 12, ulp,
         [](const U* x) { return U(lobe::dielectric{x[0]}(x[1])); }},
        {"conductor, 5/16 + 3 i", inputs::cosine, 8, ulp,
         [](const U* x) {
             return U(lobe::conductor{number<U>(0.3125), number<U>(3)}(x[0]));
         }},
        {"conductor, 3 + 3 i", inputs::cosine, 8, ulp,
         [](const U* x) {
             return U(lobe::conductor{number<U>(3), number<U>(3)}(x[0]));
         }},
        {"conductor, eta + i/2", inputs::index_cosine, 9, ulp,
         [](const U* x) {
             return U(lobe::conductor{x[0], number<U>(0.5)}(x[1]));
         }},
        {"f82_tint, 3/4, 1/2", inputs::cosine, 4, of_1,
         [](const U* x) {
             return U(lobe::f82_tint{number<U>(0.75), number<U>(0.5)}(x[0]));
         }},
        {"ggx D", inputs::normal, 12, ulp, [](const U* x) { return U(ggx{alpha<U>(x[0])}.D(at(x + 2))); }},
        {"ggx D, anisotropic", inputs::normal_xy, 12, ulp,
         [](const U* x) { return U(ggx{alpha_xy<U>(x[0], x[1])}.D(at(x + 2))); }},
        {"ggx projected_area", inputs::view, 4, ulp,
         [](const U* x) { return U(ggx{alpha<U>(x[0])}.projected_area(at(x + 2))); }},
        {"ggx projected_area, anisotropic", inputs::view_xy, 4, ulp,
         [](const U* x) { return U(ggx{alpha_xy<U>(x[0], x[1])}.projected_area(at(x + 2))); }},
        {"ggx projected_area, below the horizon", inputs::view_below, 5, ulp,
         [](const U* x) { return U(ggx{alpha_xy<U>(x[0], x[1])}.projected_area(at(x + 2))); }},
        {"ggx lambda", inputs::view, 8, ulp, [](const U* x) { return U(ggx{alpha<U>(x[0])}.lambda(at(x + 2))); }},
        {"ggx lambda, anisotropic", inputs::view_xy, 8, ulp,
         [](const U* x) { return U(ggx{alpha_xy<U>(x[0], x[1])}.lambda(at(x + 2))); }},
        {"smith_correlated visibility", inputs::pair, 6, ulp,
         [](const U* x) { return U(smith_correlated{}.visibility(ggx{alpha<U>(x[0])}, at(x + 2), at(x + 5))); }},
        {"smith_correlated visibility, anisotropic", inputs::pair_xy, 6, ulp,
         [](const U* x) {
             return U(smith_correlated{}.visibility(ggx{alpha_xy<U>(x[0], x[1])}, at(x + 2), at(x + 5)));
         }},
        {"smith_separable visibility", inputs::pair, 6, ulp,
         [](const U* x) { return U(smith_separable{}.visibility(ggx{alpha<U>(x[0])}, at(x + 2), at(x + 5))); }},
        {"microfacet f_cos, ggx, Schlick", inputs::pair, 20, ulp,
         [](const U* x) {
             const lobe::microfacet brdf{ggx{alpha<U>(x[0])}, smith_correlated{}, lobe::schlick{number<U>(0.03125)}};
             return U(brdf.f_cos(at(x + 2), at(x + 5)));
         }},
        {"microfacet f_cos, anisotropic", inputs::pair_xy, 20, ulp,
         [](const U* x) {
             const lobe::microfacet brdf{ggx{alpha_xy<U>(x[0], x[1])}, smith_correlated{},
                                         lobe::schlick{number<U>(0.03125)}};
             return U(brdf.f_cos(at(x + 2), at(x + 5)));
         }},
        {"microfacet pdf", inputs::pair, 20, ulp,
         [](const U* x) {
             const lobe::microfacet brdf{ggx{alpha<U>(x[0])}, smith_correlated{}, lobe::schlick{number<U>(0.03125)}};
             return U(brdf.pdf(at(x + 2), at(x + 5)));
         }},
        {"schlick_gaussian, F0 = 1/32", inputs::cosine, 8, ulp,
         [](const U* x) { return U(lobe::schlick_gaussian{number<U>(0.03125)}(x[0])); }},
        {"schlick_roughness, F0 = 1/32, r = 1/2", inputs::cosine, 8, ulp,
         [](const U* x) {
             return U(lobe::schlick_roughness{number<U>(0.03125), number<U>(0.5)}(x[0]));
         }},
        {"f0_from_ior", inputs::index, 7, ulp, [](const U* x) { return U(lobe::f0_from_ior(x[0])); }},
        {"ior_from_f0", inputs::reflectance, 4, ulp, [](const U* x) { return U(lobe::ior_from_f0(x[0])); }},
        {"dielectric average", inputs::index, 16, ulp, [](const U* x) { return U(lobe::dielectric{x[0]}.average()); }},
        {"alpha_xy::from_disney, x", inputs::roughness, 6, ulp,
         [](const U* x) { return U(alpha_xy<U>::from_disney(x[0], x[1]).x()); }},
        {"alpha_xy::from_disney, y", inputs::roughness, 6, ulp,
         [](const U* x) { return U(alpha_xy<U>::from_disney(x[0], x[1]).y()); }},
        {"alpha_xy::from_imageworks, x", inputs::roughness, 2, ulp,
         [](const U* x) { return U(alpha_xy<U>::from_imageworks(x[0], x[1]).x()); }},
        {"alpha_xy::from_openpbr, x", inputs::roughness, 4, ulp,
         [](const U* x) { return U(alpha_xy<U>::from_openpbr(x[0], x[1]).x()); }},
        {"alpha_xy::from_openpbr, y", inputs::roughness, 4, ulp,
         [](const U* x) { return U(alpha_xy<U>::from_openpbr(x[0], x[1]).y()); }},
        {"beckmann D", inputs::normal, 12, exponential,
         [](const U* x) { return U(beckmann{alpha<U>(x[0])}.D(at(x + 2))); }},
        {"beckmann D, anisotropic", inputs::normal_xy, 12, exponential,
         [](const U* x) { return U(beckmann{alpha_xy<U>(x[0], x[1])}.D(at(x + 2))); }},
        {"beckmann projected_area", inputs::view, 4, ulp,
         [](const U* x) { return U(beckmann{alpha<U>(x[0])}.projected_area(at(x + 2))); }},
        {"blinn_phong D", inputs::normal, 10, power,
         [](const U* x) { return U(lobe::blinn_phong{alpha<U>(x[0])}.D(at(x + 2))); }},
        {"student_t D, gamma = 49/32", inputs::normal_xy, 10, power,
         [](const U* x) {
             return U(lobe::student_t{alpha_xy<U>(x[0], x[1]), number<U>(1.53125)}.D(at(x + 2)));
         }},
        {"student_t D, gamma = 10", inputs::normal_xy, 10, power,
         [](const U* x) {
             return U(lobe::student_t{alpha_xy<U>(x[0], x[1]), number<U>(10)}.D(at(x + 2)));
         }},
        {"exponential_power D, p = 1/2", inputs::normal, 6, power,
         [](const U* x) { return density(lobe::exponential_power_shape<U>(number<U>(0.5)), x); }},
        {"exponential_power D, p = 4", inputs::normal, 24, power,
         [](const U* x) { return density(lobe::exponential_power_shape<U>(number<U>(4)), x); }},
        {"gtr D, gamma = 5", inputs::normal, 12, power,
         [](const U* x) { return density(lobe::gtr_shape<U>(x[0], number<U>(5)), x); }},
        {"gtr D, gamma = 3/2", inputs::normal, 12, power,
         [](const U* x) { return density(lobe::gtr_shape<U>(x[0], number<U>(1.5)), x); }},
        {"abc D, C = 3/2", inputs::normal, 12, exponential,
         [](const U* x) { return density(lobe::abc_shape<U>(x[0], number<U>(1.5)), x); }},
        {"sggx D, axes along x, y, z", inputs::normal_xy, 16, ulp,
         [](const U* x) { return U(lobe::sggx{alpha_xy<U>(x[0], x[1])}.D(at(x + 2))); }},
        {"sggx projected_area, axes along x, y, z", inputs::view_xy, 4, ulp,
         [](const U* x) { return U(lobe::sggx{alpha_xy<U>(x[0], x[1])}.projected_area(at(x + 2))); }},
        {"smith_direction_correlated visibility", inputs::pair, 6, ulp,
         [](const U* x) {
             return U(lobe::smith_direction_correlated{}.visibility(ggx{alpha<U>(x[0])}, at(x + 2), at(x + 5)));
         }},
        {"smith_hammon visibility", inputs::pair, 4, ulp,
         [](const U* x) { return U(lobe::smith_hammon{}.visibility(ggx{alpha<U>(x[0])}, at(x + 2), at(x + 5))); }},
        {"schlick_ggx visibility, k = alpha/2", inputs::pair, 6, ulp,
         [](const U* x) {
             const ggx ndf{alpha<U>(x[0])};
             return U(lobe::schlick_ggx{lobe::k_from_alpha(alpha<U>(x[0]))}.visibility(ndf, at(x + 2), at(x + 5)));
         }},
        {"v_cavity visibility", inputs::pair, 6, ulp,
         [](const U* x) { return U(lobe::v_cavity{}.visibility(ggx{alpha<U>(x[0])}, at(x + 2), at(x + 5))); }},
        {"smith_correlated visibility, beckmann", inputs::pair, 6, ulp,
         [](const U* x) { return U(smith_correlated{}.visibility(beckmann{alpha<U>(x[0])}, at(x + 2), at(x + 5))); }},
        {"fon_loss", inputs::view, 8, ulp, [](const U* x) { return U(lobe::fon_loss{}(at(x + 2))); }},
        {"burley f, roughness 1/2", inputs::pair, 12, ulp,
         [](const U* x) {
             return U(lobe::burley{number<U>(0.5), number<U>(0.5)}.f(at(x + 2), at(x + 5)));
         }},
        {"frame, t", inputs::direction, 2e-7, radian, nullptr, [](const U* x) { return lobe::frame<U>(at(x)).t; }},
        {"frame, b", inputs::direction, 2e-7, radian, nullptr, [](const U* x) { return lobe::frame<U>(at(x)).b; }},
        {"square_to_uniform_disk", inputs::square, 3e-7, radius, nullptr,
         [](const U* x) { return on_plane(lobe::square_to_uniform_disk(square(x))); }},
        {"square_to_uniform_disk_concentric", inputs::square, 3e-7, radius, nullptr,
         [](const U* x) { return on_plane(lobe::square_to_uniform_disk_concentric(square(x))); }},
        {"square_to_uniform_hemisphere", inputs::square, 3e-7, radian, nullptr,
         [](const U* x) { return lobe::square_to_uniform_hemisphere(square(x)); }},
        {"square_to_cosine_hemisphere", inputs::square, 3e-7, radian, nullptr,
         [](const U* x) { return lobe::square_to_cosine_hemisphere(square(x)); }},
        {"square_to_cosine_hemisphere_concentric", inputs::square, 3e-7, radian, nullptr,
         [](const U* x) { return lobe::square_to_cosine_hemisphere_concentric(square(x)); }},
        {"ggx sample", inputs::square_of, 3e-7, radian, nullptr,
         [](const U* x) { return ggx{alpha<U>(x[0])}.sample(square(x)); }},
        {"ggx sample, anisotropic", inputs::square_of_xy, 3e-7, radian, nullptr,
         [](const U* x) { return ggx{alpha_xy<U>(x[0], x[1])}.sample(square(x)); }},
        {"ggx sample_visible", inputs::seen, 3e-7, seen, nullptr,
         [](const U* x) { return ggx{alpha<U>(x[0])}.sample_visible(at(x + 4), square(x)); }},
        {"ggx sample_visible, anisotropic", inputs::seen_xy, 3e-7, seen, nullptr,
         [](const U* x) { return ggx{alpha_xy<U>(x[0], x[1])}.sample_visible(at(x + 4), square(x)); }},
        {"ggx sample_visible, from below", inputs::seen_below, 3e-7, seen, nullptr,
         [](const U* x) { return ggx{alpha<U>(x[0])}.sample_visible(at(x + 4), square(x)); }},
        {"ggx sample_visible, alpha 1e-4", inputs::seen_narrow, 4e-4, radian, nullptr,
         [](const U* x) { return ggx{alpha<U>(x[0])}.sample_visible(at(x + 4), square(x)); }},
        {"visible_heitz2018", inputs::seen, 4e-7, radian, nullptr,
         [](const U* x) {
             return lobe::normalize(lobe::visible_heitz2018{}.sample(ggx{alpha<U>(x[0])}, at(x + 4), square(x)));
         }},
        {"visible_bounded_caps", inputs::seen, 3e-7, seen, nullptr,
         [](const U* x) {
             return lobe::normalize(lobe::visible_bounded_caps{}.sample(ggx{alpha<U>(x[0])}, at(x + 4), square(x)));
         }},
        {"beckmann sample", inputs::square_of, 3e-7, radian, nullptr,
         [](const U* x) { return lobe::beckmann{alpha<U>(x[0])}.sample(square(x)); }},
    };
}

/// Functions of one number in [0,1], for sweeps over every float of it.
template <class U>
std::vector<row<U>> functions_of_one_number() {
    std::vector<row<U>> all;
    for (const auto& r : rows<U>())
        if (r.takes == inputs::turn || r.takes == inputs::cosine) all.push_back(r);
    const auto add = [&](const char* name, double bound, U (*value)(const U*)) {
        all.push_back({name, inputs::cosine, bound, unit::ulp, value});
    };
    using lobe::ggx;
    add("ggx D, alpha = 2^-10, m = (u, 0, 1)", 12, [](const U* x) {
        return U(ggx{alpha<U>(number<U>(0x1p-10))}.D({x[0], U(0), U(1)}));
    });
    add("ggx D, alpha = 2^-10, m = (1, 0, u)", 12, [](const U* x) {
        return U(ggx{alpha<U>(number<U>(0x1p-10))}.D({U(1), U(0), x[0]}));
    });
    add("ggx D, alpha = 5/8, m = (u, 0, 1)", 12, [](const U* x) {
        return U(ggx{alpha<U>(number<U>(0.625))}.D({x[0], U(0), U(1)}));
    });
    add("ggx D, alpha = 5/8, m = (1, 0, u)", 12, [](const U* x) {
        return U(ggx{alpha<U>(number<U>(0.625))}.D({U(1), U(0), x[0]}));
    });
    // The projected area is homogeneous: of a direction, times the length.
    add("ggx projected_area, alpha = 2^-10, w = (1, 0, u)", 4, [](const U* x) {
        return U(ggx{alpha<U>(number<U>(0x1p-10))}.projected_area({U(1), U(0), x[0]}));
    });
    add("ggx projected_area, alpha = 5/8, w = (1, 0, u)", 4, [](const U* x) {
        return U(ggx{alpha<U>(number<U>(0.625))}.projected_area({U(1), U(0), x[0]}));
    });
    add("ggx projected_area, alpha = 5/8, w = (1, 0, -u)", 5, [](const U* x) {
        return U(ggx{alpha<U>(number<U>(0.625))}.projected_area({U(1), U(0), -x[0]}));
    });
    return all;
}

}  // namespace accuracy
