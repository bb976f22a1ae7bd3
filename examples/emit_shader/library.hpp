// The functions that go into a file: of a composition, of whole models, and the ready-made files of examples/shaders.
#pragma once

#include "composition.hpp"
#include "words.hpp"

namespace emit {

namespace shader = lobe::shader;

inline const std::vector<word> normals_words{
    {"ggx", "GGX of one width: Trowbridge & Reitz 1975; Walter et al. 2007, eq. 33"},
    {"ggx_xy", "GGX of two widths: Burley 2012, eq. 13; Heitz 2014, eq. 86"},
    {"beckmann", "Beckmann of one width: Walter et al. 2007, eq. 25"},
    {"beckmann_xy", "Beckmann of two widths: Heitz 2014"},
    {"beckmann_walter", "Beckmann with the rational masking of Walter et al. 2007, p. 7"}};
inline const std::vector<word> masking_words{
    {"smith_correlated", "Smith's masking, heights correlated: Heitz 2014, eq. 99"},
    {"smith_separable", "Smith's masking, separable: Walter et al. 2007, eq. 23"},
    {"smith_direction_correlated", "Smith's masking, heights and azimuths correlated: Heitz 2014"},
    {"smith_hammon", "smith_correlated of GGX without square roots: Hammon 2017"},
    {"v_cavity", "V-cavities: Torrance & Sparrow 1967"}};
inline const std::vector<word> fresnel_words{
    {"schlick", "Fresnel by Schlick 1994; F0 in [0,1], linear"},
    {"schlick_gaussian", "Schlick's Fresnel by an exponential: Lagarde 2012"},
    {"f82_tint", "Schlick's Fresnel with a tint at 82 degrees: Hoffman 2019; F0, tint in [0,1]"},
    {"dielectric", "Fresnel's equations between dielectrics; eta > 0, the index beyond over that on the side of v"},
    {"conductor", "Fresnel's equations of a metal, eta + i k; eta from 0.001, k >= 0"}};
inline const std::vector<word> sampler_words{
    {"visible_normals", "samples visible normals by spherical caps: Dupuy & Benyoub 2023"},
    {"visible_heitz2018", "samples visible normals as Heitz 2018"},
    {"visible_bounded_caps", "samples by bounded caps: Eto & Tokuyoshi 2023"},
    {"all_normals", "samples all normals by inverse CDF: Walter et al. 2007"}};
inline const std::vector<word> model_words{
    {"lambert", "Lambert's diffuse reflector"},
    {"oren_nayar", "Oren & Nayar 1994"},
    {"fon", "Fujii's Oren-Nayar: Fujii 2012; Portsmouth, Kutz, Hill 2025"},
    {"eon", "energy-preserving Oren-Nayar: Portsmouth, Kutz, Hill 2025"},
    {"burley", "Disney's diffuse: Burley 2012"},
    {"burley_frostbite", "Disney's diffuse, renormalised: Lagarde & de Rousiers 2014"},
    {"metallic_roughness", "glTF 2.0, appendix B; alpha = roughness^2, with the floor of your choice"},
    {"metallic_roughness_all_bounces", "glTF's material with the later bounces of light, fitted to the random walk"}};
inline const std::vector<word> function_words{
    {"f", "the BRDF, 1/sr"},
    {"f_cos", "f cos(theta_l)"},
    {"pdf", "the density of sample, 1/sr"},
    {"evaluate", "f_cos and pdf together"},
    {"sample", "a light direction, its weight f_cos/pdf, its density"},
    {"dfg", "split-sum terms: F0 scale + bias, a fit to 1e-3; of other normals and masking a table"},
    {"dfg_table", "the same read from a baked table: GGX to 4e-4"},
    {"dfg_texture", "uv and what becomes of the texel, for that table as a texture (--texels)"}};

inline std::vector<std::string> names(std::initializer_list<const std::vector<word>*> lists) {
    std::vector<std::string> all;
    for (const auto* list : lists)
        for (const word& w : *list) all.push_back(w.name);
    return all;
}

inline const char* domain =
    "v, l: unit, in tangent space, n = (0,0,1), pointing away from the surface; 0 where one is below the horizon.\n"
    "u in [0,1)^2. A sample that fails has pdf = 0 and weight = 0.";

/// What `--functions` may ask of one BRDF; B makes it of the parameters.
template <class Make, class... P>
void add_functions(shader::file& to, const std::vector<std::string>& wanted, const std::string& prefix,
                   const std::vector<const char*>& parameters, const Make& make) {
    const auto of = [&](const std::string& name, std::initializer_list<const char*> first, auto f) {
        std::vector<const char*> all(first);
        all.insert(all.end(), parameters.begin(), parameters.end());
        to.add(shader::function(prefix + name, all, f));
    };
    for (const std::string& name : wanted) {
        if (name == "f")
            of(name, {"v", "l"}, [&](vec3 v, vec3 l, P... p) { return make(p...).f(v, l); });
        else if (name == "f_cos")
            of(name, {"v", "l"}, [&](vec3 v, vec3 l, P... p) { return make(p...).f_cos(v, l); });
        else if (name == "pdf")
            of(name, {"v", "l"}, [&](vec3 v, vec3 l, P... p) { return make(p...).pdf(v, l); });
        else if (name == "evaluate")
            of(name, {"v", "l"}, [&](vec3 v, vec3 l, P... p) { return make(p...).evaluate(v, l); });
        else if (name == "sample")  // a word of GLSL, so never alone
            of(prefix.empty() ? "sample_brdf" : name, {"v", "u"},
               [&](vec3 v, vec2 u, P... p) { return make(p...).sample(v, u); });
    }
}

inline auto dfg_function(const std::string& prefix) {
    return shader::function(prefix + "dfg", {"cos_v", "alpha"},
                            [](real cosine, real a) { return lobe::dfg_fit_precise{}(cosine, lobe::alpha<real>(a)); })
        .about("Split-sum terms of isotropic GGX with smith_correlated: the albedo is F0 scale + F90 bias.\n"
               "Domain: cos_v in [0.001,1], alpha in [0.0009,1]. Error: 1.1e-3, rms 5e-4.");
}

/// The baked table of one width and one masking model: functions that read it, from an array or from a texture, and
/// its texels.
template <class Table>
void add_table(shader::file& to, const Table& table, const std::string& name, const std::string& prefix,
               std::vector<glm::vec2>& texels) {
    const shader::dfg terms(prefix + "dfg", table);
    const std::string domain = "cos_v in [0,1], alpha in (0,1]; right from cos_v = 0.001, alpha = 0.0009 on.";
    if (name != "dfg_texture") {
        to.add(shader::function(prefix + "dfg", {"cos_v", "alpha"},
                                [&](real cosine, real a) { return terms(cosine, lobe::alpha<real>(a)); })
                   .about("Split-sum terms: the albedo is F0 scale + F90 bias. Domain: " + domain +
                          "\nError: GGX 4e-4, rms 5e-5; separable masking 6e-4; Beckmann 2.5e-3."));
        return;
    }
    const std::string size = std::to_string(terms.nodes());
    to.add(shader::function(prefix + "dfg_uv", {"cos_v", "alpha"},
                            [&](real cosine, real a) { return terms.uv(cosine, lobe::alpha<real>(a)); })
               .about("Where to read the texture of " + size + " x " + size +
                      " texels, RG32F or RG16F, linearly, clamped to its edge."));
    to.add(shader::function(
               prefix + "dfg_of_texel", {"cos_v", "alpha", "texel"},
               [&](real cosine, real a, vec2 texel) { return terms.of_texel(cosine, lobe::alpha<real>(a), texel); })
               .about("Split-sum terms, given what the texture holds at " + prefix +
                      "dfg_uv(cos_v, alpha): the albedo is F0 scale + F90 "
                      "bias.\nDomain: " +
                      domain));
    texels = shader::dfg_texels_of(table);
}

template <class Masking>
void add_table_of(shader::file& to, const std::string& normals, const Masking& masking, const std::string& name,
                  const std::string& prefix, std::vector<glm::vec2>& texels) {
    if (normals == "ggx")
        add_table(to, lobe::bake_dfg<float>(masking), name, prefix, texels);
    else if (normals == "beckmann")
        add_table(to, lobe::bake_dfg<float>(masking, {}, [](auto a) { return lobe::beckmann{a}; }), name, prefix,
                  texels);
    else
        throw mistake("a table is of 'ggx' or 'beckmann' of one width, not of '" + normals + "'");
}

/// `dfg` and its kin, of normals and masking.
inline void add_dfg(shader::file& to, const std::string& normals, const std::string& masking, const std::string& name,
                    const std::string& prefix, std::vector<glm::vec2>& texels) {
    if (masking == "smith_correlated" && normals == "ggx") {
        if (name == "dfg")
            to.add(dfg_function(prefix));
        else
            add_table(to, lobe::default_dfg{}, name, prefix, texels);
    } else if (masking == "smith_correlated")
        add_table_of(to, normals, lobe::smith_correlated{}, name, prefix, texels);
    else if (masking == "smith_separable")
        add_table_of(to, normals, lobe::smith_separable{}, name, prefix, texels);
    else
        throw mistake("a table is of 'smith_correlated' or 'smith_separable', not of '" + masking + "'");
}

/// A whole model by its name.
inline void add_model(shader::file& to, const std::string& model, const std::vector<std::string>& wanted,
                      const std::string& prefix) {
    const auto rough = [&](auto make) {
        add_functions<decltype(make), vec3, real>(to, wanted, prefix, {"albedo", "roughness"}, make);
    };
    if (model == "lambert") {
        const auto make = [](const vec3& rho) { return lobe::lambert{rho}; };
        add_functions<decltype(make), vec3>(to, wanted, prefix, {"albedo"}, make);
    } else if (model == "oren_nayar") {
        rough([](const vec3& rho, const real& r) { return lobe::oren_nayar{rho, r}; });
    } else if (model == "fon") {
        rough([](const vec3& rho, const real& r) { return lobe::fon{rho, r}; });
    } else if (model == "eon") {
        rough([](const vec3& rho, const real& r) { return lobe::eon{rho, r}; });
    } else if (model == "burley") {
        rough([](const vec3& rho, const real& r) { return lobe::burley{rho, r}; });
    } else if (model == "burley_frostbite") {
        rough([](const vec3& rho, const real& r) { return lobe::burley_frostbite{rho, r}; });
    } else if (model == "metallic_roughness") {
        const auto make = [](const vec3& c, const real& m, const real& a) {
            return lobe::metallic_roughness(c, m, lobe::alpha<real>(a));
        };
        add_functions<decltype(make), vec3, real, real>(to, wanted, prefix, {"base_color", "metallic", "alpha"}, make);
    } else {
        const auto make = [](const vec3& c, const real& m, const real& a) {
            return lobe::metallic_roughness(c, m, lobe::alpha<real>(a),
                                            lobe::smith_multiscatter{lobe::dfg_fit_precise{}});
        };
        add_functions<decltype(make), vec3, real, real>(to, wanted, prefix, {"base_color", "metallic", "alpha"}, make);
    }
}

/// A microfacet BRDF by the names of its parts.
struct parts {
    std::string normals = "ggx", masking = "smith_correlated", fresnel = "schlick", sampler;
};

inline masking masking_of(const std::string& name) {
    if (name == "smith_correlated") return masking(lobe::smith_correlated{});
    if (name == "smith_separable") return masking(lobe::smith_separable{});
    if (name == "smith_direction_correlated") return masking(lobe::smith_direction_correlated{});
    if (name == "smith_hammon") return masking(lobe::smith_hammon{});
    return masking(lobe::v_cavity{});
}
inline sampler sampler_of(const std::string& name) {
    if (name == "visible_normals") return sampler(lobe::visible_normals{});
    if (name == "visible_heitz2018") return sampler(lobe::visible_heitz2018{});
    if (name == "visible_bounded_caps") return sampler(lobe::visible_bounded_caps{});
    return sampler(lobe::all_normals{});
}

template <class... Width>
normals normals_of(const std::string& name, const Width&... a) {
    if constexpr (sizeof...(Width) == 2) {
        const lobe::alpha_xy<real> width{a...};
        return name == "ggx_xy" ? normals(lobe::ggx{width}) : normals(lobe::beckmann{width});
    } else {
        const lobe::alpha<real> width(a...);
        if (name == "ggx") return normals(lobe::ggx{width});
        return name == "beckmann" ? normals(lobe::beckmann{width}) : normals(lobe::beckmann_walter{width});
    }
}

template <class Reflectance, class... F>
void add_of_fresnel(shader::file& to, const parts& p, const std::vector<std::string>& wanted, const std::string& prefix,
                    const std::vector<const char*>& names_of_fresnel, const Reflectance& fresnel) {
    std::vector<const char*> all{"alpha"};
    if (p.normals.ends_with("_xy")) all = {"alpha_x", "alpha_y"};
    all.insert(all.end(), names_of_fresnel.begin(), names_of_fresnel.end());
    const auto fits = [&](const normals& n) {
        if (!masking_of(p.masking).fits(n))
            throw mistake("the masking '" + p.masking + "' does not go with '" + p.normals + "'");
        if (!sampler_of(p.sampler).fits(n))
            throw mistake("the sampler '" + p.sampler + "' does not go with '" + p.normals + "'");
        return n;
    };
    if (all[0] == std::string("alpha")) {
        const auto make = [&](const real& a, const F&... f) {
            return composition{fits(normals_of(p.normals, a)), masking_of(p.masking), fresnel(f...),
                               sampler_of(p.sampler)};
        };
        add_functions<decltype(make), real, F...>(to, wanted, prefix, all, make);
    } else {
        const auto make = [&](const real& x, const real& y, const F&... f) {
            return composition{fits(normals_of(p.normals, x, y)), masking_of(p.masking), fresnel(f...),
                               sampler_of(p.sampler)};
        };
        add_functions<decltype(make), real, real, F...>(to, wanted, prefix, all, make);
    }
}

inline void add_microfacet(shader::file& to, parts p, const std::vector<std::string>& wanted, const std::string& prefix,
                           std::vector<glm::vec2>& texels) {
    if (p.sampler.empty()) p.sampler = p.normals.starts_with("ggx") ? "visible_normals" : "all_normals";
    if (p.fresnel == "schlick") {
        const auto f = [](const vec3& F0) { return reflectance(lobe::schlick{F0}); };
        add_of_fresnel<decltype(f), vec3>(to, p, wanted, prefix, {"F0"}, f);
    } else if (p.fresnel == "schlick_gaussian") {
        const auto f = [](const vec3& F0) { return reflectance(lobe::schlick_gaussian{F0}); };
        add_of_fresnel<decltype(f), vec3>(to, p, wanted, prefix, {"F0"}, f);
    } else if (p.fresnel == "f82_tint") {
        const auto f = [](const vec3& F0, const vec3& tint) { return reflectance(lobe::f82_tint{F0, tint}); };
        add_of_fresnel<decltype(f), vec3, vec3>(to, p, wanted, prefix, {"F0", "tint"}, f);
    } else if (p.fresnel == "dielectric") {
        const auto f = [](const real& eta) { return reflectance(lobe::dielectric{vec3(eta, eta, eta)}); };
        add_of_fresnel<decltype(f), real>(to, p, wanted, prefix, {"eta"}, f);
    } else {
        const auto f = [](const vec3& eta, const vec3& k) { return reflectance(lobe::conductor{eta, k}); };
        add_of_fresnel<decltype(f), vec3, vec3>(to, p, wanted, prefix, {"eta", "k"}, f);
    }
    for (const std::string& name : wanted)
        if (name.starts_with("dfg")) add_dfg(to, p.normals, p.masking, name, prefix, texels);
}

/// The ready-made files of examples/shaders: name, what is said on top, functions.
struct ready_made {
    std::string name, about;
    shader::file content;
};

inline std::vector<ready_made> all_ready_made() {
    const std::vector<std::string> path{"evaluate", "sample"};
    std::vector<glm::vec2> none;
    std::vector<ready_made> all;
    const auto start = [&](const std::string& name, const std::string& about) -> shader::file& {
        return all.emplace_back(ready_made{name, about, {}}).content;
    };
    {
        auto& f = start(
            "ggx", std::string("ggx smith_correlated schlick: the microfacet BRDF, isotropic and anisotropic.\n") +
                       domain + "\nalpha in [1e-4,1], F0 in [0,1], linear. Error in float: 20 ULP of f_cos and pdf.");
        add_microfacet(f, {}, {"evaluate", "sample", "dfg"}, "ggx_", none);
        parts anisotropic;
        anisotropic.normals = "ggx_xy";
        add_microfacet(f, anisotropic, path, "ggx_xy_", none);
    }
    {
        auto& f =
            start("metallic_roughness",
                  std::string("glTF 2.0's material, as its specification has it and with all bounces of light.\n") +
                      domain + "\nbase_color, metallic in [0,1], linear; alpha = max(roughness^2, 1e-4).");
        add_model(f, "metallic_roughness", path, "gltf_");
        add_model(f, "metallic_roughness_all_bounces", path, "gltf_all_bounces_");
    }
    {
        auto& f = start("diffuse", std::string("Diffuse models. albedo, roughness in [0,1].\n") + domain);
        for (const char* model : {"lambert", "eon", "burley", "burley_frostbite"})
            add_model(f, model, path, std::string(model) + "_");
    }
    {
        auto& f = start(
            "warps",
            "Maps of the unit square and their inverses; u.x radial, u.y azimuthal, except in the concentric maps.\n"
            "Error in float: 3e-7.");
        f.add(
            shader::function("square_to_uniform_disk", {"u"}, [](vec2 u) { return lobe::square_to_uniform_disk(u); }));
        f.add(
            shader::function("uniform_disk_to_square", {"p"}, [](vec2 p) { return lobe::uniform_disk_to_square(p); }));
        f.add(shader::function("square_to_uniform_disk_concentric", {"u"},
                               [](vec2 u) { return lobe::square_to_uniform_disk_concentric(u); }));
        f.add(shader::function("square_to_uniform_hemisphere", {"u"},
                               [](vec2 u) { return lobe::square_to_uniform_hemisphere(u); }));
        f.add(shader::function("uniform_hemisphere_to_square", {"w"},
                               [](vec3 w) { return lobe::uniform_hemisphere_to_square(w); }));
        f.add(shader::function("square_to_cosine_hemisphere", {"u"},
                               [](vec2 u) { return lobe::square_to_cosine_hemisphere(u); }));
        f.add(shader::function("cosine_hemisphere_to_square", {"w"},
                               [](vec3 w) { return lobe::cosine_hemisphere_to_square(w); }));
        f.add(shader::function("cosine_hemisphere_pdf", {"w"}, [](vec3 w) { return lobe::cosine_hemisphere_pdf(w); }));
    }
    {
        auto& f = start("dfg", "Split-sum terms of isotropic GGX with smith_correlated, four fits, and image-based "
                               "light with all bounces.\n"
                               "Domain: cos_v in [0.001,1], alpha in [0.0009,1]. Error of the albedo: tiny 2.8e-2, "
                               "cheap 1.6e-2, medium 4.6e-3,\n"
                               "precise 1.1e-3.");
        const auto fit = [&](const char* name, auto terms) {
            f.add(shader::function(name, {"cos_v", "alpha"},
                                   [terms](real c, real a) { return terms(c, lobe::alpha<real>(a)); }));
        };
        fit("dfg_tiny", lobe::dfg_fit_tiny{});
        fit("dfg_cheap", lobe::dfg_fit_cheap{});
        fit("dfg_medium", lobe::dfg_fit_medium{});
        fit("dfg_precise", lobe::dfg_fit_precise{});
        f.add(shader::function("ibl_all_bounces", {"cos_v", "alpha", "F0"}, [](real c, real a, vec3 F0) {
                  return lobe::smith_multiscatter{lobe::dfg_fit_precise{}}.weights(lobe::schlick{F0}, c,
                                                                                   lobe::alpha<real>(a));
              }).about("radiance: of the prefiltered environment, irradiance: of irradiance/pi."));
    }
    {
        auto& f =
            start("dfg_table", "Split-sum terms of isotropic GGX with smith_correlated, read from a table of 32 x 32.");
        add_dfg(f, "ggx", "smith_correlated", "dfg_table", "", none);
    }
    {
        auto& f = start("antialiasing",
                        "Specular anti-aliasing: alpha widened by what normals do within a pixel or a texel.");
        f.add(shader::function("widened", {"alpha", "variance"}, [](real a, real v) {
                  return lobe::widened(lobe::alpha<real>(a), v).value();
              }).about("alpha'^2 = alpha^2 + 2 variance of slopes: Olano & Baker 2010."));
        f.add(shader::function(
                  "widened_by_pixel", {"alpha", "dn_dx", "dn_dy"},
                  [](real a, vec3 x, vec3 y) { return lobe::widened_by_pixel(lobe::alpha<real>(a), x, y).value(); })
                  .about("Tokuyoshi & Kaplanyan 2021, listing 5; dn_dx, dn_dy: derivatives of the shading normal, per "
                         "pixel."));
        f.add(shader::function("toksvig_variance", {"length_of_mean_normal"}, [](real n) {
                  return lobe::toksvig_variance(n);
              }).about("Toksvig 2005."));
    }
    return all;
}

}  // namespace emit
