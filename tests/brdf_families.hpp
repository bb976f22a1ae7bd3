// Random BRDFs of every model of the library, and their albedo by an adaptive mesh, which shares nothing with lobe's
// quadrature.
#pragma once

#include "support.hpp"

#include <lobe/lobe.hpp>
#include <lobe/testkit/measure/mesh.hpp>

#include <array>
#include <functional>

/// Random parameters, each a float, so that a BRDF in float and one in double are the same surface.
template <class T>
struct drawn {
    random_numbers random;
    static T in_float(double x) { return static_cast<T>(static_cast<float>(x)); }
    T between(double low, double high) { return in_float(random.between(low, high)); }
    T log(double low, double high) { return in_float(random.log_between(low, high)); }
    T above_1(double low, double high) { return in_float(1 + random.log_between(low, high)); }
    lobe::alpha<T> width() { return lobe::alpha<T>(log(1e-3, 1)); }
    lobe::alpha_xy<T> widths() {
        const T x = log(1e-3, 1);
        return lobe::alpha_xy<T>(x, log(1e-3, 1));
    }
    lobe::vec3<T> color(double low = 0, double high = 1) {
        const T r = between(low, high), g = between(low, high);
        return {r, g, between(low, high)};
    }
    lobe::schlick<T> gloss() { return lobe::schlick<T>(between(0, 1)); }
};

/// One lobe of any BRDF, its type erased: one instantiation of a quadrature serves them all. Three wavelengths, equal
/// ones for a scalar spectrum.
template <class T>
struct any_lobe {
    std::function<lobe::vec3<T>(const lobe::vec3<T>&, const lobe::vec3<T>&)> f;
    lobe::vec2<T> scale;
    std::vector<T> creases;
    bool smooth = false;

    using scalar = T;
    using spectrum = lobe::vec3<T>;
    static constexpr bool isotropic = true;  // half the circle, if the caller says so
    lobe::vec3<T> f_cos(const lobe::vec3<T>& v, const lobe::vec3<T>& l) const { return f(v, l); }
    lobe::vec2<T> width() const { return scale; }
    template <class G>
    void for_each_crease(const G& g) const {
        for (const T& c : creases) g(c);
    }
};
template <class T>
struct any_brdf {
    std::vector<any_lobe<T>> lobes;
    bool isotropic = true;
};
template <class B, class T = typename B::scalar>
any_brdf<T> erased(const B& brdf) {
    any_brdf<T> all{{}, B::isotropic};
    lobe::detail::for_each_lobe(brdf, [&](const auto& part) {
        const auto f_cos = [part](const lobe::vec3<T>& v, const lobe::vec3<T>& l) {
            return lobe::vec3<T>(part.f_cos(v, l));
        };
        all.lobes.push_back({f_cos, part.width(), {}, lobe::detail::smooth(part)});
        lobe::detail::for_each_crease(part, [&](const T& c) { all.lobes.back().creases.push_back(c); });
    });
    return all;
}

/// visit(kind, name, make) for every model: make(drawn) is one of its BRDFs.
template <class T, class Visit>
void every_family(const Visit& visitor) {
    using namespace lobe;
    const char* kind = nullptr;
    const auto visit = [&](const char* name, const auto& make) {
        visitor(kind, name, std::function<any_brdf<T>(drawn<T>&)>([make](drawn<T>& r) { return erased(make(r)); }));
    };
    using R = drawn<T>&;
    const smith_correlated hc;
    const smith_separable sep;
    const perfect_reflector<T> mirror;

    kind = "distributions";
    visit("ggx", [=](R r) { return microfacet{ggx{r.width()}, hc, mirror}; });
    visit("ggx, separable, schlick", [=](R r) { return microfacet{ggx{r.width()}, sep, r.gloss()}; });
    visit("ggx, two widths", [=](R r) { return microfacet{ggx{r.widths()}, hc, r.gloss()}; });
    visit("beckmann", [=](R r) { return microfacet{beckmann{r.width()}, hc, mirror}; });
    visit("beckmann, two widths", [=](R r) { return microfacet{beckmann{r.widths()}, sep, mirror}; });
    visit("beckmann_walter", [=](R r) { return microfacet{beckmann_walter{r.width()}, sep, r.gloss()}; });
    visit("blinn_phong", [=](R r) { return microfacet{blinn_phong{r.width()}, hc, mirror}; });
    visit("phong", [=](R r) { return microfacet{tabulated{phong{alpha<T>(r.log(0.01, 0.7))}}, hc, mirror}; });
    visit("student_t", [=](R r) {
        const auto a = r.width();
        return microfacet{student_t{a, r.between(1.6, 10)}, hc, mirror};
    });
    visit("student_t, two widths", [=](R r) {
        const auto a = r.widths();
        return microfacet{student_t{a, r.between(1.6, 10)}, hc, mirror};
    });
    visit("hyper_cauchy", [=](R r) {
        const auto a = r.width();
        return microfacet{hyper_cauchy{a, r.between(1.6, 10)}, hc, mirror};
    });
    visit("gtr", [=](R r) {
        const auto a = r.width();
        return microfacet{tabulated{gtr{a, r.between(1, 3)}}, hc, mirror};
    });
    visit("exponential_power", [=](R r) {
        const auto a = r.width();
        return microfacet{tabulated{exponential_power{a, r.between(0.3, 4)}}, hc, mirror};
    });
    visit("exponential_power, two widths", [=](R r) {
        const auto a = r.widths();
        return microfacet{tabulated{exponential_power{a, r.between(0.3, 4)}}, hc, mirror};
    });
    visit("abc", [=](R r) {
        const auto a = r.width();
        return microfacet{tabulated{abc{a, r.between(0.2, 3)}}, hc, mirror};
    });
    visit("sgd", [=](R r) {
        const auto a = r.width();
        return microfacet{tabulated{sgd{a, r.between(0.3, 2)}}, hc, mirror};
    });
    visit("mixture", [=](R r) {
        const auto a = r.width(), b = r.width();
        return microfacet{mixture{ggx{a}, beckmann{b}, r.between(0, 1)}, hc, mirror};
    });
    visit("masked_by", [=](R r) {
        const auto a = r.width();
        return microfacet{masked_by{gtr{a, T(1)}, ggx{alpha<T>(T(0.25))}}, sep, mirror};
    });
    kind = "masking";
    visit("ggx, v_cavity", [=](R r) { return microfacet{ggx{r.width()}, v_cavity{}, mirror}; });
    visit("beckmann, two widths, v_cavity", [=](R r) { return microfacet{beckmann{r.widths()}, v_cavity{}, mirror}; });
    visit("ggx, direction_correlated", [=](R r) {
        return microfacet{ggx{r.width()}, smith_direction_correlated{}, mirror};
    });
    visit("ggx, two widths, direction_correlated", [=](R r) {
        return microfacet{ggx{r.widths()}, smith_direction_correlated{}, mirror};
    });
    visit("ggx, hammon", [=](R r) { return microfacet{ggx{r.width()}, smith_hammon{}, r.gloss()}; });
    visit("ggx, schlick_ggx", [=](R r) {
        const auto a = r.width();
        return microfacet{ggx{a}, schlick_ggx{schlick_k<T>(r.between(0.01, 0.7))}, r.gloss()};
    });
    kind = "fresnel";
    visit("dielectric", [=](R r) {
        const auto a = r.width();
        return microfacet{ggx{a}, hc, dielectric{r.above_1(1e-4, 3)}};
    });
    visit("dielectric from inside", [=](R r) {
        const auto a = r.width();
        return microfacet{ggx{a}, hc, dielectric{r.between(0.3, 0.999)}};
    });
    visit("dielectric from inside, two widths, separable", [=](R r) {
        const auto a = r.widths();
        return microfacet{ggx{a}, sep, dielectric{r.between(0.3, 0.999)}};
    });
    visit("beckmann, dispersion from inside", [=](R r) {
        const auto a = r.width();
        const T eta = r.between(0.3, 0.97);
        const auto times = [&](double x) { return drawn<T>::in_float(static_cast<double>(eta) * x); };
        return microfacet{beckmann{a}, hc, dielectric{vec3<T>{eta, times(1.01), times(1.02)}}};
    });
    visit("conductor", [=](R r) {
        const auto a = r.width();
        const T eta = r.between(0.1, 3);
        return microfacet{ggx{a}, hc, conductor{eta, r.between(0.5, 8)}};
    });
    visit("conductor, weak, from inside", [=](R r) {
        const auto a = r.width();
        const T eta = r.between(0.3, 0.999);
        return microfacet{ggx{a}, hc, conductor{eta, r.log(1e-4, 0.5)}};
    });
    visit("f82_tint", [=](R r) {
        const auto a = r.width();
        const T F0 = r.between(0.2, 1);
        return microfacet{ggx{a}, hc, f82_tint{F0, r.between(0, 1)}};
    });
    visit("schlick_gaussian", [=](R r) {
        const auto a = r.width();
        return microfacet{ggx{a}, hc, schlick_gaussian{r.between(0, 1)}};
    });
    visit("schlick of three wavelengths", [=](R r) {
        const auto a = r.width();
        return microfacet{ggx{a}, hc, schlick{r.color()}};
    });
    kind = "diffuse";
    visit("lambert", [=](R r) { return lambert{r.between(0.1, 1)}; });
    visit("oren_nayar", [=](R r) { return oren_nayar{T(1), r.between(0, 1.57)}; });
    visit("fon", [=](R r) { return fon{T(1), r.between(0, 1)}; });
    visit("eon", [=](R r) {
        const T rho = r.between(0, 1);
        return eon{rho, r.between(0, 1)};
    });
    visit("burley", [=](R r) { return burley{T(1), r.between(0, 1)}; });
    visit("burley_frostbite", [=](R r) { return burley_frostbite{T(1), r.between(0, 1)}; });
    kind = "compositions";
    visit("metallic_roughness", [=](R r) {
        const auto base = r.color();
        const T metallic = r.between(0, 1);
        return metallic_roughness(base, metallic, r.width());
    });
    visit("metallic_roughness, two widths", [=](R r) {
        const auto base = r.color();
        const T metallic = r.between(0, 1);
        return metallic_roughness(base, metallic, r.widths());
    });
    visit("coated", [=](R r) {
        const auto base = metallic_roughness(r.color(), T(0), r.width());
        const auto coat = ggx{r.width()};
        return coated(base, coat, r.between(0, 1));
    });
    visit("glass in water over a base", [=](R r) {
        const auto a = r.width();
        const dielectric F{r.between(0.5, 0.99)};
        return layered{microfacet{ggx{a}, hc, F}, lambert{T(1)}, fresnel_coupling{F}};
    });
    visit("reciprocal coupling by table", [table = bake_dfg<T>(hc, {.size = 16, .order = 16})](R r) {
        const auto a = r.width();
        const auto E = [=](const T& mu) { return table(mu, a).albedo(); };
        return layered{microfacet{ggx{a}, smith_correlated{}, perfect_reflector<T>{}}, lambert{T(1)},
                       reciprocal_coupling{E, r.between(0, 0.9)}};
    });
    visit("two lobes", [=](R r) {
        const auto a = r.width(), b = r.width();
        return sum{weighted{T(0.25f), microfacet{ggx{a}, hc, mirror}},
                   weighted{T(0.75f), microfacet{beckmann{b}, sep, mirror}}};
    });
}

/// A view whose cosine is as likely small as large; in the plane of symmetry, or of any azimuth.
template <class T>
T drawn_cosine(drawn<T>& r) {
    return r.log(1e-3, 1);
}

struct mesh_albedo {
    lobe::vec3<double> value{0.0}, error{0.0};
};

/// Adds int density(x, y) dx dy over the unit square, by the testkit's adaptive mesh: Genz & Malik's rule, degree 7.
template <class Density>
void add_by_mesh(mesh_albedo& total, const Density& density, int cells, double tolerance, long evaluations) {
    lobe::testkit::mesh<3> mesh(
        [&](double x, double y) -> std::array<double, 3> {
            const lobe::vec3<double> d = density(x, y);
            return {d.x, d.y, d.z};
        },
        cells, cells, 3);
    mesh.refine(tolerance, 3, evaluations);
    for (int k = 0; k < 3; ++k) {
        total.value[k] += mesh.integral()[static_cast<std::size_t>(k)];
        total.error[k] += mesh.error()[static_cast<std::size_t>(k)];
    }
}

/// int f_cos dl by an adaptive mesh: other coordinates and another rule than `hemisphere_integral`'s.
/// Without creases: the azimuth and the slope of the half vector over `width`, r = tan(chi), chi = chi_max x^2 (3 - 2
/// x).
/// With them: c = v.m and the azimuth psi of m around v, so that a crease is a line of the mesh. c from 1 to where l
/// leaves the hemisphere, cut at every crease and at v.z, where the peak is; psi up to where l meets the horizon, which
/// is at v.n + l.n = 2 c (n.m).
inline mesh_albedo albedo_by_mesh(const any_brdf<double>& brdf, const lobe::vec3<double>& v, double tolerance,
                                  long evaluations) {
    using lobe::vec3;
    using std::sqrt;
    mesh_albedo total;
    for (const auto& part : brdf.lobes) {
        const double wx = part.width().x, wy = part.width().y, start = brdf.isotropic ? std::atan2(v.y, v.x) : 0.3;
        const double range = brdf.isotropic ? 3.141592653589793 : 6.283185307179586, copies = brdf.isotropic ? 2 : 1;
        const double sine_v = sqrt(v.x * v.x + v.y * v.y);
        if (part.creases.empty() || sine_v < 1e-6) {
            const auto density = [&](double x, double y) {
                const double phi = start + range * y, ex = wx * std::cos(phi), ey = wy * std::sin(phi);
                const double b = ex * v.x + ey * v.y, e2 = ex * ex + ey * ey, root = sqrt(b * b + v.z * v.z * e2);
                const double chi_max = std::atan2(v.z, b + root), chi = chi_max * x * x * (3 - 2 * x);
                const double cosine = std::cos(chi), sine = std::sin(chi);
                const vec3<double> m{-sine * ex, -sine * ey, cosine};
                const double m2 = lobe::dot(m, m), v_m = lobe::dot(v, m);
                const double dm = sine * wx * wy / (m2 * sqrt(m2)) * chi_max * 6 * x * (1 - x) * range * copies;
                return part.f_cos(v, 2 * (v_m / m2) * m - v) * (4 * v_m / sqrt(m2) * dm);
            };
            add_by_mesh(total, density, 32, tolerance, evaluations);
            continue;
        }
        // with v, axes
        const vec3<double> up{-v.x * v.z / sine_v, -v.y * v.z / sine_v, sine_v}, side{-v.y / sine_v, v.x / sine_v, 0};
        std::vector<double> cuts{sqrt((1 - sine_v) / 2), sqrt((1 + sine_v) / 2), v.z, 1};
        for (const double c : part.creases)
            if (c > cuts[0]) cuts.push_back(c);
        std::sort(cuts.begin(), cuts.end());
        for (std::size_t k = 0; k + 1 < cuts.size(); ++k)
            for (const double sign : {1.0, -1.0}) {
                if (sign < 0 && brdf.isotropic) continue;
                const auto density = [&](double x, double y) {
                    const double c = cuts[k] + (cuts[k + 1] - cuts[k]) * x * x * (3 - 2 * x),
                                 s = sqrt((1 - c) * (1 + c));
                    const double limit = (v.z / (2 * c) - v.z * c) / (sine_v * s);  // of cos(psi)
                    const double psi_max = limit < -1 ? 3.141592653589793 : limit < 1 ? std::acos(limit) : 0;
                    const double psi = psi_max * y * y * (3 - 2 * y);
                    const vec3<double> m = c * v + s * (std::cos(psi) * up + sign * std::sin(psi) * side);
                    const double area = (cuts[k + 1] - cuts[k]) * 6 * x * (1 - x) * psi_max * 6 * y * (1 - y);
                    return part.f_cos(v, 2 * c * m - v) * (4 * c * area * copies);
                };
                add_by_mesh(total, density, 16, tolerance, evaluations / 4);
            }
    }
    return total;
}
