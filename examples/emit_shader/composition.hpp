// A BRDF whose parts are chosen while the program runs. What records has one scalar type, so a part can be a variant of
// lobe's own: the shader holds what was chosen, and no trace of the choice.
#pragma once

#include <lobe/lobe.hpp>
#include <lobe/shader.hpp>

#include <type_traits>
#include <variant>

namespace emit {

using lobe::shader::real;
using lobe::shader::vec2;
using lobe::shader::vec3;

/// A distribution of normals.
class normals {
public:
    using scalar = real;
    static constexpr bool isotropic = false;
    using any = std::variant<lobe::ggx<real>, lobe::ggx<real, lobe::alpha_xy<real>>, lobe::beckmann<real>,
                             lobe::beckmann<real, lobe::alpha_xy<real>>, lobe::beckmann_walter<real>>;

    explicit normals(const any& distribution) : chosen(distribution) {}
    real D(const vec3& m) const {
        return std::visit([&](const auto& n) { return n.D(m); }, chosen);
    }
    real projected_area(const vec3& w) const {
        return std::visit([&](const auto& n) { return n.projected_area(w); }, chosen);
    }
    real projected_area_above(const vec3& w) const {
        return std::visit([&](const auto& n) { return lobe::detail::area_above(n, w); }, chosen);
    }
    real lambda(const vec3& w) const {
        return std::visit([&](const auto& n) { return n.lambda(w); }, chosen);
    }
    vec2 width() const {
        return std::visit([&](const auto& n) { return n.width(); }, chosen);
    }

    any chosen;
};

class masking {
public:
    using any = std::variant<lobe::smith_correlated, lobe::smith_separable, lobe::smith_direction_correlated,
                             lobe::smith_hammon, lobe::v_cavity>;

    explicit masking(const any& model) : chosen(model) {}
    real denominator(const normals& ndf, const vec3& v, const vec3& l) const {
        return denominator(ndf, v, l, ndf.projected_area_above(v));
    }
    real denominator(const normals& ndf, const vec3& v, const vec3& l, const real& sv) const {
        return std::visit(
            [&](const auto& m, const auto& n) {
                if constexpr (requires { m.denominator(n, v, l, sv); })
                    return m.denominator(n, v, l, sv);
                else
                    return real(0);  // `fits` has refused it
            },
            chosen, ndf.chosen);
    }
    /// smith_hammon knows one width.
    bool fits(const normals& ndf) const {
        return std::visit(
            [](const auto& m, const auto& n) {
                return requires(vec3 w) { m.denominator(n, w, w, w.x); };
            },
            chosen, ndf.chosen);
    }

private:
    any chosen;
};

class reflectance {
public:
    using any = std::variant<lobe::schlick<vec3>, lobe::schlick_gaussian<vec3>, lobe::f82_tint<vec3>,
                             lobe::dielectric<vec3>, lobe::conductor<vec3>>;

    explicit reflectance(const any& fresnel) : chosen(fresnel) {}
    vec3 operator()(const real& cosine) const {
        return std::visit([&](const auto& f) { return vec3(f(cosine)); }, chosen);
    }

private:
    any chosen;
};

class sampler {
public:
    using any =
        std::variant<lobe::visible_normals, lobe::visible_heitz2018, lobe::visible_bounded_caps, lobe::all_normals>;

    explicit sampler(const any& way) : chosen(way) {}
    vec3 sample(const normals& ndf, const vec3& v, const vec2& u) const {
        return std::visit(
            [&](const auto& s, const auto& n) {
                if constexpr (requires { s.sample(n, v, u); })
                    return vec3(s.sample(n, v, u));
                else
                    return v;  // `fits` has refused it
            },
            chosen, ndf.chosen);
    }
    real area(const normals& ndf, const vec3& v, const real& v_m, const real& m_z, const real& sv) const {
        return std::visit(
            [&](const auto& s, const auto& n) {
                if constexpr (requires { s.area(n, v, v_m, m_z, sv); })
                    return s.area(n, v, v_m, m_z, sv);
                else
                    return sv;
            },
            chosen, ndf.chosen);
    }
    bool fits(const normals& ndf) const {
        return std::visit(
            [](const auto& s, const auto& n) {
                return requires(vec3 w, vec2 u) { s.sample(n, w, u); };
            },
            chosen, ndf.chosen);
    }

private:
    any chosen;
};

using composition = lobe::microfacet<normals, masking, reflectance, sampler>;

}  // namespace emit
