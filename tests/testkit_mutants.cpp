// The test kit, tested: BRDFs with exactly one mistake each must fail, right ones over hard parameters must pass.
#include <lobe/testkit.hpp>

#include "catch.hpp"
#include "strangers.hpp"

#include <array>
#include <cstdint>
#include <cstdio>
#include <ctime>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace strangers;
using lobe::testkit::options;
using lobe::testkit::report;

using V = vec3<double>;
using U = vec2<double>;
using drawn = material<double>::drawn;
using facets = microfacet<double>;

/// A subject, what is claimed of it, and the finding that names its mistake: part of a property and of its meaning.
struct trial {
    std::string name;
    std::function<report(options)> judge;
    options claims;
    std::string property, meaning;
};

class trials {
public:
    template <class B>
    void add(std::string name, const B& brdf, std::string property = "", std::string meaning = "") {
        add(std::move(name), options{}, brdf, std::move(property), std::move(meaning));
    }
    template <class B>
    void add(std::string name, options claims, const B& brdf, std::string property = "", std::string meaning = "") {
        claims.name = name;
        const auto judge = [brdf](const options& o) { return lobe::testkit::verify(brdf, o); };
        all.push_back({std::move(name), judge, std::move(claims), std::move(property), std::move(meaning)});
    }
    void add(std::string name, const facets& brdf, std::string property = "", std::string meaning = "") {
        add(std::move(name), material<double>(brdf), std::move(property), std::move(meaning));
    }
    std::vector<trial> all;
};

// ---- claims

options lossless() {
    options o;
    o.lossless = true;
    return o;
}
options lossless_not_reciprocal() {
    options o = lossless();
    o.reciprocal = false;
    return o;
}
options not_reciprocal(std::uint64_t seed = 1) {
    options o;
    o.reciprocal = false;
    o.seed = seed;
    return o;
}
options isotropic() {
    options o;
    o.isotropic = true;
    return o;
}

// ---- materials that several trials share

facets with_F(facets b, std::function<double(double)> F) {
    b.F = std::move(F);
    return b;
}

/// A glaze over a white base that returns all the glaze lets through; the table is that of the right glaze.
const facets& glaze() {
    static const facets b = with_F(ggx(0.4), schlick(0.3));
    return b;
}
const albedo_table<double>& glaze_albedo() {
    static const albedo_table<double> E{material<double>(glaze())};
    return E;
}
material<double> glazed(const facets& specular, double p = 0.5) {
    return mixture<double>(specular, diffuse<double>(kulla_conty(glaze_albedo())), p);
}

/// A white metal of roughness 0.5, and what it loses.
const albedo_table<double>& metal_albedo() {
    static const albedo_table<double> E{material<double>(ggx(0.5))};
    return E;
}
material<double> compensated(const albedo_table<double>& E) {
    return mixture<double>(ggx(0.5), diffuse<double>(kulla_conty(E)), 0.7);
}

/// Light goes back to where it came from: D about v itself. int D(m) (v.m) dm over the hemisphere about v is at most 1.
material<double> retro_reflector(double a) {
    material<double> out;
    const auto lobe = [a](const V& v, const V& l) {
        const double c = std::max(glm::dot(v, l), 0.0), s2 = glm::dot(glm::cross(v, l), glm::cross(v, l)),
                     k = s2 / (a * a) + c * c;
        return 1 / (pi<double> * a * a * k * k);
    };
    out.f_cos = [lobe](const V& v, const V& l) {
        return above(v, l) ? lobe(v, l) * std::min(v.z, l.z) * l.z / std::max(v.z, l.z) : 0;
    };
    return out;
}

/// f cos = cos^n about the mirror direction, or about v itself, bounded and symmetric by min(n.v, n.l).
template <class T>
material<T> phong(T n, bool retro = false) {
    using vec = vec3<T>;
    material<T> out;
    const auto axis_of = [retro](const vec& v) { return retro ? v : vec(-v.x, -v.y, v.z); };
    const auto density = [n, axis_of](const vec& v, const vec& l) {
        return (n + 1) / (2 * pi<T>)*std::pow(std::clamp(glm::dot(axis_of(v), l), T(0), T(1)), n);
    };
    out.pdf = [density](const vec& v, const vec& l) { return above(v, l) ? density(v, l) : T(0); };
    out.f_cos = [density](const vec& v, const vec& l) {
        return above(v, l) ? density(v, l) * l.z * std::min(v.z, l.z) / std::max(v.z, l.z) : T(0);
    };
    out.sample = [n, axis_of, density](const vec& v, const vec2<T>& u) {
        typename material<T>::drawn s;
        if (!(v.z > 0)) return s;
        const vec axis = axis_of(v);
        const vec t = glm::normalize(glm::cross(axis, std::abs(axis.z) < T(0.9) ? vec(0, 0, 1) : vec(1, 0, 0)));
        const T tilt = std::pow(1 - u.x, 1 / (n + 1)), side = std::sqrt(std::max(T(0), 1 - tilt * tilt)),
                phi = 2 * pi<T> * u.y;
        const vec l = side * std::cos(phi) * t + side * std::sin(phi) * glm::cross(axis, t) + tilt * axis;
        if (!(l.z > 0)) return s;
        s.l = l;
        s.pdf = density(v, l);
        s.weight = s.pdf > 0 ? l.z * std::min(v.z, l.z) / std::max(v.z, l.z) : T(0);
        return s;
    };
    return out;
}

/// Fresnel's reflectance of glass.
double glass(double c) {
    const double g = std::sqrt(1.25 + c * c), A = (g - c) / (g + c), B = (c * (g + c) - 1) / (c * (g - c) + 1);
    return A * A * (1 + B * B) / 2;
}
/// Lambert below GGX: the Fresnel term of the view is the share of the gloss. `number` selects the lobe: that of the
/// radius (0), that of the azimuth (1), each stretched again; or a third one.
template <class Numbers>
struct selecting {
    struct parts {
        material<double> gloss, base;
        double share(const V& v) const { return glass(v.z); }
    };
    parts of;
    int number;
    double f_cos(const V& v, const V& l) const {
        return above(v, l) ? of.gloss.f_cos(v, l) + (1 - of.share(v)) * of.base.f_cos(v, l) : 0;
    }
    double pdf(const V& v, const V& l) const {
        return above(v, l) ? of.share(v) * of.gloss.pdf(v, l) + (1 - of.share(v)) * of.base.pdf(v, l) : 0;
    }
    drawn sample(const V& v, const Numbers& u) const {
        if (!(v.z > 0)) return {};
        const double p = of.share(v), selector = u[number];
        const bool first = selector < p;
        U two(u.x, u.y);
        if (number < 2) two[number] = std::min(first ? selector / p : (selector - p) / (1 - p), 1 - 1e-16);
        drawn s = (first ? of.gloss : of.base).sample(v, two);
        if (!(s.pdf > 0)) return {};
        s.pdf = pdf(v, s.l);
        s.weight = f_cos(v, s.l) / s.pdf;
        return s;
    }
};
template <class Numbers>
selecting<Numbers> selected_by(int number, double a) {
    facets gloss = ggx(a, draws::all);
    gloss.F = glass;
    gloss.G = [a](const V& v, const V& l, const V&) { return ggx_G1(v, a, a) * ggx_G1(l, a, a); };
    return {{gloss, lambert(1.0)}, number};
}
/// As the dielectrics of path tracers: the third number selects by the Fresnel term at the normal that the others draw.
struct selecting_at_m {
    material<double> gloss = ggx(0.3);
    static double F(double c) { return 0.04 + 0.96 * std::pow(1 - c, 5); }
    static V normal(const V& v, const U& u) { return ggx_sample_visible(v, u, 0.3, 0.3); }
    double f_cos(const V& v, const V& l) const {
        return above(v, l) ? F(glm::length(v + l) / 2) * gloss.f_cos(v, l) + 0.4 * l.z / pi<double> : 0;
    }
    double pdf(const V& v, const V& l) const {
        if (!above(v, l)) return 0;
        const double turn = std::atan2(l.y, l.x) / (2 * pi<double>);
        // that cosine_hemisphere(u) = l was drawn with
        const V m = normal(v, {l.x * l.x + l.y * l.y, turn - std::floor(turn)});
        return F(glm::length(v + l) / 2) * gloss.pdf(v, l) + (1 - F(clamped_dot(v, m))) * l.z / pi<double>;
    }
    drawn sample(const V& v, const V& u) const {
        if (!(v.z > 0)) return {};
        const V m = normal(v, {u.x, u.y}),
                l = u.z < F(clamped_dot(v, m)) ? 2 * glm::dot(v, m) * m - v : cosine_hemisphere(U(u.x, u.y));
        if (!(l.z > 0)) return {};
        return {l, f_cos(v, l) / pdf(v, l), pdf(v, l)};
    }
};

/// Half vectors about a tilted axis, 1/4 D(m) with int D dm = 1: at most 1 of the light returns.
material<double> tilted(double a, double tilt, double azimuth, double albedo) {
    const V axis = spherical(std::cos(tilt), azimuth), t = glm::normalize(glm::cross(axis, V(0, 0, 1))),
            s = glm::cross(axis, t);
    const auto D = [=](const V& m) {
        const V local(glm::dot(m, t), glm::dot(m, s), glm::dot(m, axis));
        return local.z > 0 ? ggx_D(local, a, a) * local.z : 0;
    };
    material<double> out;
    out.pdf = [D](const V& v, const V& l) {
        if (!above(v, l)) return 0.0;
        const V m = glm::normalize(v + l);
        return D(m) / (4 * std::abs(glm::dot(v, m)));
    };
    out.f_cos = [D, albedo](const V& v, const V& l) {
        return above(v, l) ? albedo * D(glm::normalize(v + l)) / 4 * l.z : 0;
    };
    out.sample = [=](const V& v, const U& u) {
        drawn d;
        const V local = ggx_sample(u, a, a), m = local.x * t + local.y * s + local.z * axis,
                l = 2 * glm::dot(v, m) * m - v;
        if (!(v.z > 0) || !(l.z > 0) || !(glm::dot(v, m) > 0)) return d;
        d.l = l;
        d.pdf = D(m) / (4 * glm::dot(v, m));
        d.weight = d.pdf > 0 ? albedo * glm::dot(v, m) * l.z : 0;
        return d;
    };
    return out;
}

/// The same, but f_cos is multiplied by `factor` where the condition holds.
template <class T, class Condition>
material<T> altered(material<T> m, T factor, const Condition& where) {
    m.f_cos = [f = m.f_cos, factor, where](const vec3<T>& v, const vec3<T>& l) {
        return f(v, l) * (where(v, l) ? factor : T(1));
    };
    return m;
}
/// The same, but the samples pass through `change(v, u, s)`.
template <class T, class S, class Change>
material<T, S> resampled(material<T, S> m, const Change& change) {
    m.sample = [sample = m.sample, change](const vec3<T>& v, const vec2<T>& u) {
        auto s = sample(v, u);
        change(v, u, s);
        return s;
    };
    return m;
}
/// The same, but pdf(v, l) passes through `change(v, l, p)`.
template <class T, class S, class Change>
material<T, S> with_pdf(material<T, S> m, const Change& change) {
    m.pdf = [pdf = m.pdf, change](const vec3<T>& v, const vec3<T>& l) { return change(v, l, pdf(v, l)); };
    return m;
}
/// f_cos passes through `change(v, l, f)`.
template <class T, class S, class Change>
material<T, S> with_f_cos(material<T, S> m, const Change& change) {
    m.f_cos = [f_cos = m.f_cos, change](const vec3<T>& v, const vec3<T>& l) { return change(v, l, f_cos(v, l)); };
    return m;
}

double azimuth_of(const V& w) { return std::atan2(w.y, w.x); }
double grazing(double c) { return std::pow(1 - c, 5); }

// ---- the mistakes

void wrong_formulas(trials& t) {
    facets b = with_F(ggx(0.5), schlick(0.04));
    b.D = [](const V& m) { return 0.25 / (pi<double> * (m.z * m.z * (0.25 - 1) + 1)); };
    b.pdf_m = [D = b.D](const V& v, const V& m) { return ggx_G1(v, 0.5, 0.5) * clamped_dot(v, m) * D(m) / v.z; };
    t.add("GGX, denominator not squared", b, "integral of the pdf");

    const double n = 2 * 0.3 * 0.3 - 2;  // in place of 2/a^2 - 2
    b = blinn_phong(2 / (0.3 * 0.3) - 2);
    b.D = blinn_phong(n).D;
    b.pdf_m = [D = b.D](const V&, const V& m) { return D(m) * m.z; };
    t.add("Blinn-Phong exponent 2a^2-2", b, "chi-squared");

    t.add("Schlick 1-(v.h)^5", lossless(),
          without_sample(glazed(with_F(glaze(), [](double c) { return 0.3 + 0.7 * (1 - std::pow(c, 5)); }))),
          "white furnace");
    t.add("Schlick with the fourth power", lossless(),
          without_sample(glazed(with_F(glaze(), [](double c) { return 0.3 + 0.7 * std::pow(1 - c, 4); }))),
          "white furnace");
    t.add("Fresnel of v.l", lossless(),
          with_f_cos(glazed(glaze()),
                     [](const V& v, const V& l, double f) {
                         if (!above(v, l)) return f;
                         const V m = glm::normalize(v + l);
                         const double vm = clamped_dot(v, m), F = 0.3 + 0.7 * grazing(vm),
                                      wrong = 0.3 + 0.7 * grazing(clamped_dot(v, l));
                         return f + ggx_D(m, 0.4) * ggx_G2(v, l, 0.4, 0.4) * (wrong - F) / (4 * v.z);
                     }),
          "white furnace");

    b = ggx(0.5);
    b.G = [](const V& v, const V& l, const V&) {
        const auto one = [](double x) { return 2 * x / std::sqrt(x + std::sqrt(0.25 + 0.75 * x)); };
        return one(v.z) * one(l.z);
    };
    t.add("correlated G as misprinted", without_sample(material<double>(b)), "white furnace is at most 1");

    b = ggx(0.4);
    b.D = [](const V& m) { return pi<double> * ggx_D(m, 0.4); };
    t.add("GGX without 1/pi, no sampler", without_sample(material<double>(b)), "white furnace is at most 1", "1/pi");
    t.add("GGX without 1/pi, its sampler right", b, "weight * pdf", "1/pi");

    b = ggx(0.4);  // the half-float trick: p*p, the 1/pi forgotten
    b.D = [](const V& m) {
        const V c = glm::cross(V(0, 0, 1), m);
        const double p = 0.4 / (glm::dot(c, c) + 0.16 * m.z * m.z);
        return p * p;
    };
    b.pdf_m = [D = b.D](const V& v, const V& m) { return ggx_G1(v, 0.4, 0.4) * clamped_dot(v, m) * D(m) / v.z; };
    t.add("GGX of mobile engines, without 1/pi", b, "integral of the pdf", "1/pi");

    b = ggx(0.4);
    b.f_cos_of = [](const V& v, const V&, const V&) { return 1 / v.z; };
    t.add("without the 1/4", b, "weight * pdf", "1/4");
    t.add("without the 1/4, no sampler", without_sample(material<double>(b)), "white furnace is at most 1", "1/4");

    b = ggx(0.4);
    b.f_cos_of = [](const V& v, const V& l, const V&) { return 1 / (4 * v.z * l.z); };
    t.add("GGX without the cosine", without_sample(material<double>(b)), "reciprocity", "cos(theta_l)");
    b.f_cos_of = [](const V& v, const V& l, const V&) { return l.z / (4 * v.z); };
    t.add("GGX with the cosine twice", without_sample(material<double>(b)), "reciprocity", "cos(theta_l)");
    t.add("Lambert without 1/pi", without_sample(diffuse<double>([](const V&, const V&) { return 1.0; })),
          "white furnace is at most 1", "1/pi");
    t.add("Lambert without the cosine",
          without_sample(with_f_cos(lambert(1.0), [](const V&, const V& l, double f) { return f > 0 ? f / l.z : 0; })),
          "reciprocity", "cos(theta_l)");

    b = ggx(0.3, 0.6, draws::all);
    b.D = [](const V& m) {
        const double f = m.x * m.x / 0.09 - m.y * m.y / 0.36 + m.z * m.z;
        return 1 / (pi<double> * 0.18 * f * f);
    };
    t.add("anisotropic GGX with a minus", without_sample(material<double>(b)), "white furnace");
    t.add("anisotropic GGX with a minus, sampled", drawing_all(b), "integral of the pdf");

    b = ggx(0.4);
    b.f_cos_of = [](const V& v, const V& l, const V&) { return (0.04 + 0.96 * grazing(v.z)) / (4 * v.z) + 0 * l.z; };
    t.add("Fresnel of n.v", without_sample(material<double>(b)), "reciprocity", "n.v");

    b = glaze();
    b.D = [](const V& m) { return ggx_D(0.98 * m, 0.4); };
    t.add("D of a half vector not unit", lossless(), without_sample(glazed(b)), "white furnace is 1");

    b = beckmann(0.3);
    b.D = [](const V& m) {
        const double c2 = m.z * m.z;
        return std::exp((c2 - 1) / (c2 * 0.3)) / (pi<double> * 0.09 * c2 * c2);
    };
    t.add("Beckmann, exponent over alpha", without_sample(material<double>(b)), "white furnace is at most 1");

    b = ggx(0.5);
    b.G = [](const V& v, const V& l, const V&) { return ggx_G2(v, l, 0.25, 0.25); };
    t.add("GGX masked with alpha^2", without_sample(material<double>(b)), "white furnace is at most 1");
    b.G = [](const V&, const V&, const V&) { return 1.0; };
    t.add("GGX without masking", without_sample(material<double>(b)), "white furnace is at most 1");
    b.G = [](const V& v, const V&, const V&) { return ggx_G1(v, 0.5, 0.5); };
    t.add("GGX masked for v only", without_sample(material<double>(b)), "reciprocity", "masking");

    b = ggx(0.25);  // Schlick's k of direct light in f, that of image-based light in the weight
    const auto schlick_G = [](double k, const V& v, const V& l) {
        return v.z / (v.z * (1 - k) + k) * l.z / (l.z * (1 - k) + k);
    };
    b.G = [schlick_G](const V& v, const V& l, const V&) { return schlick_G(1.5 * 1.5 / 8, v, l); };
    b = drawing_all(b);
    b.sample_m = ggx(0.25, draws::all).sample_m;
    b.weight = [schlick_G](const V& v, const V& l, const V& m) {
        return schlick_G(0.125, v, l) * glm::dot(v, m) / (v.z * m.z);
    };
    t.add("two conventions of Schlick's k", b, "weight * pdf");

    b = ggx(0.2);
    b.f_cos_of = [](const V& v, const V& l, const V&) { return l.z / (4 * v.z * l.z + 0.001); };
    t.add("0.001 added to the denominator", b, "weight * pdf");
    b = ggx(0.02);
    b.D = [](const V& m) {
        const double f = (m.z * 0.0004 - m.z) * m.z + 1;
        return 0.0004 / std::max(pi<double> * f * f, 1e-5);
    };
    t.add("D's denominator clamped", b, "weight * pdf");

    t.add("Phong lobe, cosine missing",
          without_sample(with_f_cos(phong(40.0),
                                    [](const V& v, const V& l, double) {
                                        return above(v, l) ? 41 / (2 * pi<double>)*std::pow(
                                                                      clamped_dot(V(-v.x, -v.y, v.z), l), 40)
                                                           : 0;
                                    })),
          "reciprocity");
    t.add("Phong pdf normalised for n.h",
          with_pdf(phong(10.0), [](const V&, const V&, double p) { return p * 12 / 11; }), "pdf", "same factor");
}

void wrong_energy(trials& t) {
    const material<double> white_base = lambert(1.0);
    const facets coat = with_F(ggx(0.1), schlick(0.04));
    const material<double> kd = diffuse<double>([](const V& v, const V& l) {
        return (1 - (0.04 + 0.96 * grazing(clamped_dot(v, glm::normalize(v + l))))) / pi<double>;
    });
    t.add("(1-F) diffuse + all of the specular", without_sample(mixture<double>(coat, kd, 0.5)),
          "white furnace is at most 1");
    t.add("clear coat on an unattenuated base", without_sample(mixture<double>(coat, white_base, 0.5)),
          "white furnace is at most 1");
    t.add("Burley's diffuse, white and rough",
          diffuse<double>([](const V& v, const V& l) { return burley(v, l, 1.0, 1.0); }), "white furnace is at most 1");
    t.add("Oren-Nayar, alpha and beta swapped",
          without_sample(diffuse<double>([](const V& v, const V& l) { return oren_nayar(v, l, 0.8, 0.5, true); })),
          "white furnace");
    t.add("Oren-Nayar, cos(phi) not clamped",
          diffuse<double>([](const V& v, const V& l) { return oren_nayar(v, l, 0.8, 0.9, false, false); }),
          "f_cos is not negative");
    t.add("Oren-Nayar, white", diffuse<double>([](const V& v, const V& l) { return oren_nayar(v, l, 1.0, 0.2); }),
          "white furnace is at most 1");

    auto E = metal_albedo();
    E.average = 0;
    for (int i = 0; i < 1024; ++i) E.average += E((i + 0.5) / 1024) / 1024;
    t.add("Kulla-Conty, E_avg without 2 mu", lossless(), without_sample(compensated(E)), "white furnace is 1");
    t.add("Kulla-Conty without 1/(1-E_avg)", lossless(),
          without_sample(mixture<double>(ggx(0.5), diffuse<double>([](const V& v, const V& l) {
                                             return (1 - metal_albedo()(v.z)) * (1 - metal_albedo()(l.z)) / pi<double>;
                                         }),
                                         0.7)),
          "white furnace is 1");
    E = metal_albedo();
    for (std::size_t i = 0; i < E.E.size(); ++i) {  // node i baked at the middle of texel i
        const double mu = (static_cast<double>(i) + 0.5) / static_cast<double>(E.E.size()) * 0.9;
        E.E[i] = metal_albedo()(mu);
    }
    t.add("Kulla-Conty, table read beside its nodes", lossless(), without_sample(compensated(E)), "white furnace is 1");
    t.add("Kulla-Conty, table of 8 read by nearest", lossless(),
          without_sample(mixture<double>(ggx(0.5), diffuse<double>([](const V& v, const V& l) {
                                             const auto nearest = [](double mu) {
                                                 return metal_albedo()(std::round(mu * 7) / 7);
                                             };
                                             return (1 - nearest(v.z)) * (1 - nearest(l.z)) /
                                                    (pi<double> * (1 - metal_albedo().average));
                                         }),
                                         0.7)),
          "white furnace is 1");
    t.add("lossless but for the multiple scattering", lossless(), without_sample(material<double>(ggx(0.5))),
          "white furnace is 1");
    t.add("lossless, 0.5 % too much", lossless(),
          diffuse<double>([](const V&, const V&) { return 1.005 / pi<double>; }), "white furnace is 1");
    t.add("lossless, 0.5 % too little", lossless(),
          diffuse<double>([](const V&, const V&) { return 0.995 / pi<double>; }), "white furnace is 1");
    t.add("lossless glaze, 0.5 % too little", lossless(),
          with_f_cos(glazed(glaze()), [](const V&, const V&, double f) { return 0.995 * f; }), "white furnace is 1");

    t.add(
        "retro-reflector without a bound",
        without_sample(with_f_cos(retro_reflector(0.05),
                                  [](const V& v, const V& l, double f) { return f > 0 ? f / std::min(v.z, l.z) : 0; })),
        "white furnace is at most 1");
    t.add("sheen on 1/(4 n.v n.l)", without_sample(diffuse<double>([](const V& v, const V& l) {
              const V m = glm::normalize(v + l);
              const double sin2 = std::max(0.0, 1 - m.z * m.z);
              return (2 + 1 / 0.3) * std::pow(sin2, 0.5 / 0.3) / (2 * pi<double>) / (4 * v.z * l.z);
          })),
          "white furnace is at most 1");
    t.add("a tilted lobe returns twice the light", without_sample(tilted(0.05, 0.6, 1.0, 3.0)), "white furnace");
    t.add("a narrow tilted lobe returns 10 times the light", tilted(0.01, 0.5, 2.0, 10.0), "white furnace");
    t.add("a diffuse weight of one side, not declared",
          diffuse<double>([](const V& v, const V&) { return (1 - glaze_albedo()(v.z)) / pi<double>; }), "reciprocity",
          "one side");
    t.add("scaled by 1/E(v), not declared",
          with_f_cos(material<double>(ggx(0.5)),
                     [](const V& v, const V&, double f) { return f > 0 ? f / metal_albedo()(v.z) : 0; }),
          "reciprocity");
    t.add("claimed to be isotropic", isotropic(), material<double>(ggx(0.2, 0.3)), "isotropy");
    t.add("a stripe of 5 degrees, claimed isotropic", isotropic(),
          without_sample(
              altered(lambert(0.5), 0.8, [](const V&, const V& l) { return std::abs(azimuth_of(l) - 0.4) < 0.044; })),
          "isotropy");

    using rgb = material<double, V>;
    const V gold(1.0, 0.71, 0.29);
    const rgb metal = tinted<double>(ggx(0.3), gold);
    t.add("one channel without 1/pi",
          with_f_cos(metal, [](const V&, const V&, const V& f) { return f * V(1, 1, pi<double>); }), "weight * pdf",
          "1/pi");
    t.add("one channel of n.v",
          with_f_cos(metal, [](const V& v, const V&,
                               const V& f) { return f * V(1, 1, 1 - 0.3 * grazing(std::max(v.z, 0.0))); }),
          "reciprocity");
    t.add("two channels exchanged in the weight",
          resampled(metal, [](const V&, const U&, rgb::drawn& s) { std::swap(s.weight.y, s.weight.z); }),
          "weight * pdf");
    t.add("one channel of a lossless one lost", lossless(), tinted<double>(lambert(1.0), V(1, 1, 0.9)),
          "white furnace is 1");
}

void wrong_samplers(trials& t) {
    const facets all = ggx(0.3, draws::all), visible = ggx(0.3);
    facets b = all;
    b.jacobian = [](const V&, const V&, const V&) { return 1.0; };
    t.add("pdf without the Jacobian", b, "weight * pdf", "4 v.m");
    b.jacobian = [](const V&, const V&, const V& m) { return 1 / (4 * m.z); };
    t.add("Jacobian 1/(4 n.h)", b, "weight * pdf");
    b.jacobian = [](const V&, const V& l, const V&) { return 1 / (4 * l.z); };
    t.add("Jacobian 1/(4 n.l)", b, "weight * pdf");
    b.jacobian = [](const V& v, const V&, const V& m) { return 1 / glm::dot(v, m); };
    t.add("Jacobian 1/(v.m)", b, "weight * pdf", "1/4");
    b = all;
    b.pdf_m = [D = b.D](const V&, const V& m) { return D(m); };
    t.add("pdf without cos(theta_h)", b, "weight * pdf", "cos(theta_m)");

    b = visible;
    b.pdf_m = all.pdf_m;
    t.add("visible normals, pdf of all normals", b, "chi-squared");
    b = all;
    b.pdf_m = visible.pdf_m;
    t.add("all normals, pdf of visible ones", b, "chi-squared");
    b = visible;
    b.sample_m = ggx(std::sqrt(0.3)).sample_m;
    t.add("samples of roughness, not alpha", b, "chi-squared");
    b = visible;
    b.sample_m = ggx(0.31).sample_m;
    t.add("samples of a width 3 % off", b, "means of sample");

    const facets brushed = ggx(0.1, 0.4), swapped = ggx(0.4, 0.1);
    b = brushed;
    b.sample_m = swapped.sample_m;
    t.add("axes exchanged in the samples", b, "chi-squared");
    b = brushed;
    b.pdf_m = swapped.pdf_m;
    t.add("axes exchanged in the pdf", b, "chi-squared");
    b = brushed;
    b.D = swapped.D;
    t.add("axes exchanged in D", b, "weight * pdf");
    material<double> m = turned_frame<double>(brushed, 0.7);
    m.sample = turned_frame<double>(brushed, -0.7).sample;
    t.add("samples turned by the inverse frame", m, "chi-squared");
    b = brushed;
    b.weight = [](const V& v, const V& l, const V&) { return ggx_G2(v, l, 0.1, 0.1) / ggx_G1(v, 0.1, 0.1); };
    t.add("weight masked with one axis only", b, "weight * pdf");

    b = visible;
    b.weight = [](const V&, const V& l, const V&) { return ggx_G1(l, 0.3, 0.3); };
    t.add("weight G1(l) for the correlated G", b, "weight * pdf");
    b.weight = [](const V& v, const V& l, const V&) { return ggx_G2(v, l, 0.3, 0.3); };
    t.add("weight G2, not divided by G1(v)", b, "weight * pdf");

    b = visible;  // three mistakes in Heitz's listing
    b.sample_m = [](const V& v, const U& u) { return ggx_sample_visible(v, U(u.x * u.x, u.y), 0.3, 0.3); };
    t.add("visible normals, a root too few", b, "chi-squared");
    b.sample_m = [](const V& v, const U& u) {
        const V vh = glm::normalize(V(0.3 * v.x, 0.3 * v.y, v.z));
        const V t1 = glm::normalize(V(-vh.y, vh.x + 1e-12, 0)), t2 = glm::cross(vh, t1);
        const double p1 = std::sqrt(u.x) * std::cos(2 * pi<double> * u.y),
                     p2 = std::sqrt(u.x) * std::sin(2 * pi<double> * u.y);
        const V nh = p1 * t1 + p2 * t2 + std::sqrt(std::max(0.0, 1 - p1 * p1 - p2 * p2)) * vh;
        return glm::normalize(V(0.3 * nh.x, 0.3 * nh.y, std::max(0.0, nh.z)));
    };
    t.add("visible normals, disk not warped", b, "integral of the pdf");
    b.sample_m = [](const V& v, const U& u) {
        const V good = ggx_sample_visible(v, u, 0.3, 0.3);
        return glm::normalize(good * V(1, 1.1, 1));
    };
    t.add("visible normals, stretched back unevenly", b, "chi-squared");
    b.sample_m = [](const V& v, const U& u) {
        const V n = ggx_sample_visible(V(0, 0, 1), u, 0.3, 0.3);
        return glm::dot(v, n) > 0 ? n : V(-n.x, -n.y, n.z);
    };
    t.add("visible normals of v = n", b, "chi-squared");
    b = visible;
    b.sample_m = [](const V& v, const U& u) { return ggx_sample_visible(v, U(u.x, u.y / 2), 0.3, 0.3); };
    t.add("half of the azimuth", b, "chi-squared");
    b.sample_m = [](const V& v, const U& u) { return ggx_sample_visible(v, U(u.x, u.x), 0.3, 0.3); };
    t.add("u.x used for u.y", b, "chi-squared");
    b.sample_m = [](const V& v, const U& u) { return ggx_sample_visible(v, U(std::min(u.x, 0.97), u.y), 0.3, 0.3); };
    t.add("u.x clamped to 0.97", b, "means of sample");

    const material<double> lambertian = lambert(0.8), glossy = visible;
    t.add("no pdf: half of the azimuth",
          without_pdf(resampled(lambertian, [](const V&, const U&, drawn& s) { s.l.y = std::abs(s.l.y); })),
          "weighted means");
    t.add("no pdf: uniform, weighted as cosine",
          without_pdf(resampled(lambertian,
                                [](const V& v, const U& u, drawn& s) {
                                    if (v.z > 0 && u.x > 0)
                                        s.l = spherical(u.x, 2 * pi<double> * u.y), s.pdf = s.l.z / pi<double>;
                                    if (u.x == 0) s = {};
                                })),
          "weighted means");
    t.add("no pdf: samples of roughness", without_pdf([&] {
              facets x = with_F(visible, white<double>);
              x.sample_m = ggx(0.55).sample_m;
              return material<double>(x);
          }()),
          "mean weight");
    const auto uniform_pdf = [](const V& v, const V& l, double) { return above(v, l) ? 1 / (2 * pi<double>) : 0; };
    t.add("cosine samples, uniform pdf",
          with_pdf(resampled(lambertian,
                             [](const V& v, const U&, drawn& s) {
                                 if (v.z > 0) s.weight = 1.6 * s.l.z, s.pdf = 1 / (2 * pi<double>);
                             }),
                   uniform_pdf),
          "chi-squared");
    t.add("uniform samples, weight of the cosine",
          with_pdf(resampled(lambertian,
                             [](const V& v, const U& u, drawn& s) {
                                 if (v.z > 0 && u.x > 0)
                                     s = {spherical(u.x, 2 * pi<double> * u.y), 0.8, 1 / (2 * pi<double>)};
                             }),
                   uniform_pdf),
          "weight * pdf");
    t.add("uniform samples of the sphere's pdf",
          with_pdf(resampled(lambertian,
                             [](const V& v, const U& u, drawn& s) {
                                 if (v.z > 0)
                                     s.l = spherical(u.x, 2 * pi<double> * u.y), s.weight = 3.2 * s.l.z,
                                     s.pdf = 1 / (4 * pi<double>);
                             }),
                   [](const V& v, const V& l, double) { return above(v, l) ? 1 / (4 * pi<double>) : 0; }),
          "integral of the pdf", "factor 2");
    t.add("cosine samples, a root forgotten",
          resampled(lambertian,
                    [](const V& v, const U& u, drawn& s) {
                        if (v.z > 0)
                            s.l = spherical(std::sqrt(1 - u.x * u.x), 2 * pi<double> * u.y), s.pdf = s.l.z / pi<double>;
                    }),
          "chi-squared");

    for (const auto& [name, brdf] : {std::pair<std::string, material<double>>{"GGX", glossy},
                                     {"Lambert", lambertian},
                                     {"mixture", glazed(glaze())}}) {
        t.add(name + ", weight 0.5 % off", resampled(brdf, [](const V&, const U&, drawn& s) { s.weight *= 1.005; }),
              "weight * pdf", "same factor");
        t.add(name + ", pdf() 0.5 % off", with_pdf(brdf, [](const V&, const V&, double p) { return 1.005 * p; }),
              "pdf(v, sample.l)", "same factor");
        const auto both = [](const V&, const U&, drawn& s) { s.weight /= 1.005, s.pdf *= 1.005; };
        t.add(name + ", pdf 0.5 % up, weight 0.5 % down",
              with_pdf(resampled(brdf, both), [](const V&, const V&, double p) { return 1.005 * p; }),
              "integral of the pdf");
        t.add(name + ", the same, no pdf()", without_pdf(resampled(brdf, both)), "mean weight");
    }
    t.add("NDF samples, weights clamped",
          resampled(material<double>(ggx(0.5, draws::all)),
                    [](const V&, const U&, drawn& s) { s.weight = std::min(s.weight, 1.0); }),
          "weight * pdf");

    const auto other_width = ggx(0.5).operator material<double>();
    t.add(
        "sample.pdf right, pdf() of another width",
        [&] {
            auto x = glossy;
            x.pdf = other_width.pdf;
            return x;
        }(),
        "pdf(v, sample.l)");
    t.add("pdf() right, sample.pdf of another width",
          resampled(glossy,
                    [other_width](const V& v, const U&, drawn& s) {
                        if (s.pdf > 0) s.pdf = other_width.pdf(v, s.l);
                    }),
          "pdf(v, sample.l)");
    t.add("pdf() in another frame",
          with_pdf<double>(material<double>(brushed), [pdf = turned_frame<double>(brushed, 0.2).pdf](
                                                          const V& v, const V& l, double) { return pdf(v, l); }),
          "pdf(v, sample.l)");
    t.add("pdf() of l and v exchanged",
          with_pdf(glossy, [pdf = glossy.pdf](const V& v, const V& l, double) { return pdf(l, v); }),
          "pdf(v, sample.l)");
    t.add("pdf() nothing on one side",
          with_pdf(glossy, [](const V&, const V& l, double p) { return l.x > 0.2 ? 0 : p; }),
          "pdf > 0 where f_cos > 0");

    selection is;
    const facets half = with_F(ggx(0.1), [](double) { return 0.5; });
    const auto two = [half](selection s, double p = 0.3) { return mixture<double>(half, lambert(0.3), p, s); };
    is.counts_b = false;
    t.add("mixture, pdf forgets a lobe", two(is), "chi-squared");
    is = {};
    is.counts_probability = false;
    t.add("mixture, pdf forgets the probabilities", two(is), "integral of the pdf");
    is = {};
    is.stretches_u = false;
    t.add("mixture, u.x not stretched again", two(is), "chi-squared");
    is = {};
    is.sums_weight = false;
    t.add("mixture, weight of one lobe", two(is), "weight * pdf");
    t.add(
        "mixture, probability of another formula",
        [&] {
            auto x = two({});
            x.sample = two({}, 0.35).sample;
            return x;
        }(),
        "pdf(v, sample.l)");
    is = {};
    m = two({});
    m.sample = [good = m, chosen = two({}, 0.34)](const V& v, const U& u) {
        auto s = chosen.sample(v, u);
        if (s.pdf > 0) s.pdf = good.pdf(v, s.l), s.weight = good.f_cos(v, s.l) / s.pdf;
        return s;
    };
    t.add("mixture, drawn with 0.34, said to be 0.3", m, "means of sample");

    const auto third = [](const auto& change) {
        return lobe::testkit::functions(
            [b = selected_by<V>(2, 0.3)](const V& v, const V& l) { return b.f_cos(v, l); },
            [b = selected_by<V>(2, 0.3), change](const V& v, const V& u) { return change(b, v, u); },
            [b = selected_by<V>(2, 0.3)](const V& v, const V& l) { return b.pdf(v, l); });
    };
    t.add("third number, a share 5 % off", not_reciprocal(),
          third([](const auto& mixed, const V& v, const V& u) { return mixed.sample(v, V(u.x, u.y, 0.95 * u.z)); }),
          "means of sample");
    t.add("third number, pdf 0.5 % up, weight 0.5 % down", not_reciprocal(),
          third([](const auto& mixed, const V& v, const V& u) {
              drawn s = mixed.sample(v, u);
              return s.pdf *= 1.005, s.weight /= 1.005, s;
          }),
          "pdf(v, sample.l)");
    t.add("third number used for u.x", not_reciprocal(),
          third([](const auto& mixed, const V& v, const V& u) { return mixed.sample(v, V(u.z, u.y, u.z)); }),
          "chi-squared");
    t.add("third number at m, samples of a wider lobe", not_reciprocal(),
          lobe::testkit::functions(
              [b = selecting_at_m{}](const V& v, const V& l) { return b.f_cos(v, l); },
              [b = selecting_at_m{}](const V& v, const V& u) { return b.sample(v, V(0.95 * u.x, u.y, u.z)); },
              [b = selecting_at_m{}](const V& v, const V& l) { return b.pdf(v, l); }),
          "means of sample");

    t.add("a tenth thrown away, not counted",
          resampled(glossy,
                    [](const V&, const U& u, drawn& s) {
                        if (u.y < 0.1) s = {};
                    }),
          "integral of the pdf");
    t.add("reflected at -m", resampled(glossy, [](const V&, const U&, drawn& s) { s.l = -s.l; }),
          "sample vanishes below", "reflect(i, m)");
    t.add("reflected to the side of v",
          resampled(glossy, [](const V&, const U&, drawn& s) { s.l = V(-s.l.x, -s.l.y, s.l.z); }), "weight * pdf",
          "(-x, -y, z)");
    t.add("y of the samples has the wrong sign",
          resampled(glossy, [](const V&, const U&, drawn& s) { s.l.y = -s.l.y; }), "chi-squared", "(x, -y, z)");
    t.add("failed samples with a weight",
          without_pdf(resampled(glossy,
                                [](const V&, const U&, drawn& s) {
                                    if (s.pdf == 0) s.weight = 1;
                                })),
          "no light without a density");
    t.add("failed samples with weight 0/0",
          without_pdf(resampled(glossy,
                                [](const V&, const U&, drawn& s) {
                                    if (s.pdf == 0) s.weight = s.pdf / s.pdf;
                                })),
          "sample is finite");
    facets below = visible;
    t.add(
        "samples below the horizon kept",
        [&] {
            material<double> x = below;
            x.sample = [below](const V& v, const U& u) {
                drawn s;
                if (!(v.z > 0)) return s;
                const V n = below.sample_m(v, u);
                s.l = 2 * glm::dot(v, n) * n - v;
                s.pdf = below.pdf_m(v, n) / (4 * glm::dot(v, n));
                s.weight = ggx_G1(V(s.l.x, s.l.y, std::abs(s.l.z)), 0.3, 0.3);
                return s;
            };
            return x;
        }(),
        "sample vanishes below");
    t.add("sampled directions 0.1 % too long", resampled(glossy, [](const V&, const U&, drawn& s) { s.l *= 1.001; }),
          "sampled directions are unit");
}

void wrong_values(trials& t) {
    const material<double> glossy = ggx(0.3), base = lambert(0.5);
    t.add("negative below the horizon",
          without_sample(
              with_f_cos(base, [](const V& v, const V& l, double) { return v.z > 0 ? 0.5 * l.z / pi<double> : 0; })),
          "f_cos is not negative");
    t.add(
        "positive below the horizon (abs)",
        without_sample(with_f_cos(base, [](const V&, const V& l, double) { return 0.5 * std::abs(l.z) / pi<double>; })),
        "f_cos vanishes below", "abs");
    t.add("GGX with abs of the cosines",
          without_sample(with_f_cos(glossy,
                                    [](const V& v, const V& l, double) {
                                        if (v.z == 0) return 0.0;
                                        const V a(v.x, v.y, std::abs(v.z)), b(l.x, l.y, std::abs(l.z)),
                                            m = glm::normalize(a + b);
                                        return ggx_D(m, 0.3) * ggx_G2(a, b, 0.3, 0.3) / (4 * a.z);
                                    })),
          "f_cos vanishes below", "abs");
    t.add("a little light below: 1e-9",
          without_sample(
              with_f_cos(base, [](const V& v, const V& l, double f) { return v.z > 0 && l.z < 0 ? 1e-9 : f; })),
          "f_cos vanishes below");
    t.add("0/0 where v is at the horizon",
          without_sample(
              with_f_cos(glossy, [](const V& v, const V& l, double f) { return v.z == 0 && l.z > 0 ? 0 / v.z : f; })),
          "f_cos is finite");
    t.add("0/0 at v = l = n",
          without_sample(with_f_cos(
              glossy, [](const V& v, const V& l, double f) { return v.z == 1 && l.z == 1 ? std::acos(1 + 1e-9) : f; })),
          "f_cos is finite");
    t.add("0/0 where v and l are opposite",
          without_sample(
              with_f_cos(glossy, [](const V& v, const V& l, double f) { return f + 0 * glm::normalize(v + l).z; })),
          "f_cos is finite");
    t.add("0/0 of one u: log(0)",
          without_pdf(resampled(glossy,
                                [](const V&, const U& u, drawn& s) {
                                    s.weight *= u.x == 0 ? std::sqrt(-1 - std::log(u.x)) * 0 + std::log(u.x) * 0 : 1;
                                })),
          "sample is finite");
    t.add("0/0 of u.x just below 1",
          without_pdf(resampled(base,
                                [](const V&, const U& u, drawn& s) {
                                    if (u.x > 1 - 1e-12) s.l.x = std::sqrt(-u.x);
                                })),
          "sample is finite");
    t.add("infinite at the mirror of v",
          without_sample(with_f_cos(glossy,
                                    [](const V& v, const V& l, double f) {
                                        return above(v, l) && v.x == -l.x && v.y == -l.y ? f / std::abs(v.x + l.x) : f;
                                    })),
          "f_cos is finite");
    t.add("0/0 at v = l",
          without_sample(with_f_cos(glossy,
                                    [](const V& v, const V& l, double f) {
                                        return f > 0 ? f * (1 + 0 * std::sqrt(1 / (1 - std::min(1.0, glm::dot(v, l)))))
                                                     : f;
                                    })),
          "f_cos is finite");
    t.add("power of a negative cosine", without_sample(diffuse<double>([](const V& v, const V& l) {
              return 0.2 / pi<double> + 0.1 * std::pow(glm::dot(V(-v.x, -v.y, v.z), l), 10.5);
          })),
          "f_cos is finite");
    t.add("odd power of a negative cosine", without_sample(diffuse<double>([](const V& v, const V& l) {
              return 0.02 + 0.1 * std::pow(glm::dot(V(-v.x, -v.y, v.z), l), 5);
          })),
          "f_cos is not negative");
    t.add("pdf() infinite at the normal",
          with_pdf(glossy,
                   [](const V& v, const V& l, double p) {
                       const V h = v + l;
                       return p > 0 && h.x == 0 && h.y == 0 ? p / (h.x * h.x) : p;
                   }),
          "pdf is finite");
    t.add("pdf() negative on one side",
          with_pdf(glossy, [](const V&, const V& l, double p) { return l.x > 0.5 ? -p : p; }), "pdf is not negative");

    // Right almost everywhere.
    t.add("wrong below cos(theta_v) = 0.05",
          without_sample(altered(glossy, 2.0, [](const V& v, const V&) { return v.z < 0.05; })), "reciprocity");
    t.add("wrong below cos(theta_v) = 0.001",
          without_sample(altered(glossy, 2.0, [](const V& v, const V&) { return v.z < 0.001; })), "reciprocity");
    t.add(
        "wrong in 5 degrees of the azimuth of l",
        without_sample(altered(glossy, 0.9, [](const V&, const V& l) { return std::abs(azimuth_of(l) - 1) < 0.044; })),
        "reciprocity");
    t.add("wrong in 5 degrees, sampled",
          altered(glossy, 0.9,
                  [](const V& v, const V& l) { return std::abs(std::sin(azimuth_of(l) + azimuth_of(v) - 1)) < 0.044; }),
          "weight * pdf");
    t.add("a step of 1 % across the plane x = 0",
          altered(glossy, 0.99, [](const V& v, const V& l) { return v.x * l.x > 0; }), "weight * pdf");
    t.add("wrong where v and l are close",
          altered(glossy, 1.1, [](const V& v, const V& l) { return glm::dot(v, l) > 0.999; }), "weight * pdf");
    const auto narrow = [](const V& v) { return v.z > 0 && std::abs(azimuth_of(v) + 2) < 0.044; };
    t.add("weight wrong in 5 degrees of v",
          without_pdf(resampled(glossy,
                                [narrow](const V& v, const U&, drawn& s) {
                                    if (narrow(v)) s.weight *= 0.9;
                                })),
          "weight * pdf");
    t.add("pdf() wrong in 5 degrees of v",
          with_pdf(glossy, [narrow](const V& v, const V&, double p) { return narrow(v) ? 1.1 * p : p; }),
          "pdf(v, sample.l)");
    t.add("weight wrong below cos(theta_v) = 0.005",
          without_pdf(resampled(glossy,
                                [](const V& v, const U&, drawn& s) {
                                    if (v.z < 0.005) s.weight *= 0.9;
                                })),
          "weight * pdf");
    t.add("weight wrong for 0.60 < cos(theta_v) < 0.62",
          without_pdf(resampled(glossy,
                                [](const V& v, const U&, drawn& s) {
                                    if (v.z > 0.6 && v.z < 0.62) s.weight *= 0.9;
                                })),
          "weight * pdf");
    t.add("sampler of v = n takes another branch",
          resampled(glossy,
                    [](const V& v, const U&, drawn& s) {
                        if (v.x == 0 && v.y == 0) s.pdf /= 2;
                    }),
          "pdf(v, sample.l)");
}

// ---- right, and hard

template <class T>
void right_widths(trials& t, const std::string& scalar) {
    for (const double alpha : {0.005, 0.01, 0.03, 0.1, 0.5, 1.0}) {
        char name[64];
        std::snprintf(name, sizeof name, "GGX %g, %s", alpha, scalar.c_str());
        auto b = ggx(static_cast<T>(alpha), alpha < 0.05 ? draws::caps : draws::visible);
        if (alpha > 0.05) b.F = schlick(T(0.04));
        t.add(name, material<T>(b));
    }
}

std::vector<trial> right_ones() {
    trials t;
    right_widths<double>(t, "double");
    right_widths<float>(t, "float");
    t.add("GGX 0.3, all normals drawn, float", material<float>(ggx(0.3f, draws::all)));
    t.add("GGX 0.5, all normals drawn", ggx(0.5, draws::all));
    t.add("GGX 0.05 x 0.5", ggx(0.05, 0.5));
    t.add("GGX 0.5 x 0.05, float", material<float>(ggx(0.5f, 0.05f)));
    t.add("GGX 0.05 x 0.5, turned", turned_frame<double>(ggx(0.05, 0.5, draws::caps), 0.7));
    t.add("Beckmann 0.3, float", material<float>(beckmann(0.3f)));
    t.add("Beckmann 0.1", beckmann(0.1));
    t.add("Blinn-Phong 200", blinn_phong(200.0));
    t.add("mixture GGX 0.01 + 0.5",
          mixture<double>(with_F(ggx(0.01), schlick(0.04)), with_F(ggx(0.5), [](double) { return 0.04; }), 0.2));
    t.add("white glaze, lossless", lossless(), glazed(glaze()));
    t.add("white glaze, selected with 0.9, lossless", lossless(), glazed(glaze(), 0.9));
    t.add("specular + (1 - E(v)) diffuse, declared", lossless_not_reciprocal(),
          mixture<double>(glaze(),
                          diffuse<double>([](const V& v, const V&) { return (1 - glaze_albedo()(v.z)) / pi<double>; }),
                          0.5));
    t.add("Kulla-Conty, lossless", lossless(), compensated(metal_albedo()));
    t.add("scaled by 1/E(v), declared", lossless_not_reciprocal(),
          resampled(with_f_cos(material<double>(ggx(0.5)),
                               [](const V& v, const V&, double f) { return f / metal_albedo()(v.z); }),
                    [](const V& v, const U&, drawn& s) { s.weight /= metal_albedo()(v.z); }));
    t.add("Lambert", lossless(), lambert(1.0));
    t.add("Lambert, float, claimed isotropic", isotropic(), lambert(0.8f));
    t.add("Lambert, uniform samples",
          with_pdf(resampled(lambert(0.8),
                             [](const V& v, const U& u, drawn& s) {
                                 if (v.z > 0)
                                     s.l = spherical(u.x, 2 * pi<double> * u.y), s.weight = 1.6 * s.l.z,
                                     s.pdf = 1 / (2 * pi<double>);
                             }),
                   [](const V& v, const V& l, double) { return above(v, l) ? 1 / (2 * pi<double>) : 0; }));
    t.add("Oren-Nayar", diffuse<double>([](const V& v, const V& l) { return oren_nayar(v, l, 0.8, 0.5); }));
    t.add("Oren-Nayar, float",
          diffuse<float>([](const vec3<float>& v, const vec3<float>& l) { return oren_nayar(v, l, 0.8f, 0.3f); }));
    t.add("Burley", diffuse<double>([](const V& v, const V& l) { return burley(v, l, 0.6, 0.8); }));
    t.add("Lommel-Seeliger",
          diffuse<double>([](const V& v, const V& l) { return 0.9 / (4 * pi<double> * (v.z + l.z)); }));
    facets cavity = ggx(0.3, draws::all);
    cavity.G = [](const V& v, const V& l, const V& m) { return v_cavity(v, l, m); };
    t.add("V-cavities", with_F(drawing_all(cavity), schlick(0.5)));

    facets step = ggx(0.3, draws::all);  // a cone of normals, all equally dense: D jumps at its rim
    step.D = [](const V& m) { return m.z * m.z > 1 / (1 + 0.09) ? (1 + 0.09) / (0.09 * pi<double>) : 0; };
    step.G = [](const V& v, const V& l, const V& m) { return v_cavity(v, l, m); };
    step = drawing_all(step);
    step.sample_m = [](const V&, const U& u) {
        return spherical(std::sqrt(1 - u.x * (0.09 / 1.09)), 2 * pi<double> * u.y);
    };
    t.add("a distribution with a rim", step);

    t.add("GGX 0.03, float, drawn by sqrt(1 - c*c)", [] {
        const float a = 0.03f;
        auto b = ggx(a, draws::all);
        b.sample_m = [a](const vec3<float>&, const vec2<float>& u) {
            return spherical(std::sqrt((1 - u.x) / (1 + (a * a - 1) * u.x)), 2 * pi<float> * u.y);
        };
        return material<float>(b);
    }());
    t.add("a spike of 0.001 on Lambert",
          mixture<double>(with_F(ggx(0.003), [](double) { return 0.001; }), lambert(0.9), 0.1));
    t.add("spikes and Lambert in one spectrum",
          [spike = material<double>(ggx(0.005)), base = lambert(0.9)](const V& v, const V& l) {
              return V(spike.f_cos(v, l), base.f_cos(v, l), 0);
          });
    t.add("stripes", without_sample(with_f_cos(lambert(0.9), [](const V& v, const V& l, double f) {
              return f > 0 && std::sin(60 * glm::normalize(v + l).x) > 0 ? f : 0.3 * f;
          })));
    t.add("tilted mirrors", tilted(0.02, 0.4, 2.0, 1.0));
    t.add("sharp tilted mirrors, missed from some views", tilted(0.005, 0.7, 1.0, 1.0));
    t.add("tilted mirrors, f_cos alone", without_sample(tilted(0.02, 0.4, 2.0, 1.0)));
    t.add("retro-reflector 0.02", without_sample(retro_reflector(0.02)));
    t.add("Phong 5000", phong(5000.0));
    t.add("Phong 5000, float", phong(5000.0f));
    t.add("Phong 100000, float", phong(100000.0f));
    t.add("retro-reflecting Phong 20000, float", phong(20000.0f, true));
    t.add("retro-reflecting Phong 100000, float", phong(100000.0f, true));
    t.add("Phong 100000", phong(100000.0));
    t.add("Phong 50", phong(50.0));
    t.add("black and blue", tinted<double>(ggx(0.2), V(0, 0, 0.7)));
    t.add("gold, float", tinted<float>(ggx(0.2f), vec3<float>(1.0f, 0.71f, 0.29f)));
    t.add("two-sided", [] {
        material<double> m = ggx(0.3);
        const auto flipped = [](const V& w) { return V(w.x, w.y, -w.z); };
        m.f_cos = [f = m.f_cos, flipped](const V& v, const V& l) {
            return v.z < 0 ? f(flipped(v), flipped(l)) : f(v, l);
        };
        m.pdf = [pdf = m.pdf, flipped](const V& v, const V& l) {
            return v.z < 0 ? pdf(flipped(v), flipped(l)) : pdf(v, l);
        };
        m.sample = [sample = m.sample, flipped](const V& v, const U& u) {
            auto s = sample(v.z < 0 ? flipped(v) : v, u);
            if (v.z < 0) s.l = flipped(s.l);
            return s;
        };
        return m;
    }());
    t.add("samples below keep their pdf, weight 0", [] {
        const facets b = ggx(0.6);
        material<double> m = b;
        m.sample = [b](const V& v, const U& u) {
            drawn s;
            if (!(v.z > 0)) return s;
            const V n = b.sample_m(v, u);
            s.l = 2 * glm::dot(v, n) * n - v;
            s.pdf = b.pdf_m(v, n) / (4 * glm::dot(v, n));
            s.weight = s.l.z > 0 ? b.weight(v, s.l, n) : 0;
            return s;
        };
        return m;
    }());
    t.add("failed samples with any l", resampled(material<double>(ggx(0.6)), [](const V&, const U&, drawn& s) {
              if (s.pdf == 0) s.l = V(std::numeric_limits<double>::quiet_NaN(), 7, 3);
          }));
    t.add("u exchanged and reversed", [] {
        material<double> m = ggx(0.3);
        m.sample = [sample = m.sample](const V& v, const U& u) {
            return sample(v, U(std::min(1 - u.y, 1 - 1e-16), u.x));
        };
        return m;
    }());
    t.add("dim: 1e-5 of a GGX, float", tinted<float>(ggx(0.3f), vec3<float>(1e-5f)));
    t.add("f_cos alone", without_sample(material<double>(ggx(0.2))));
    t.add("f_cos and sample", without_pdf(material<double>(ggx(0.2))));
    for (const std::uint64_t seed : {1u, 4u, 6u})
        for (const double a : {0.25, 0.49}) {
            t.add("selected by u.x", not_reciprocal(seed), selected_by<U>(0, a));
            t.add("selected by u.y", not_reciprocal(seed), selected_by<U>(1, a));
        }
    for (const double a : {0.05, 0.5}) t.add("selected by a third number", not_reciprocal(), selected_by<V>(2, a));
    t.add("selected by a third number, at m", not_reciprocal(), selecting_at_m{});
    t.add("a lambda", [](const V& v, const V& l) { return above(v, l) ? l.z * 0.3 : 0.0; });
    t.add("a lambda of spectra", [](const V& v, const V& l) {
        const double c = above(v, l) ? l.z : 0;
        return std::array<double, 4>{0, 0.1 * c, 0.2 * c, 0.3 * c};
    });
    t.add("world space, float", [frame = std::array<vec3<float>, 3>{vec3<float>(0.36f, 0.48f, -0.8f),
                                                                    vec3<float>(-0.8f, 0.6f, 0.0f),
                                                                    vec3<float>(0.48f, 0.64f, 0.6f)},
                                 brdf = material<float>(ggx(0.15f))](const vec3<float>& v, const vec3<float>& l) {
        const vec3<float> V_ = v.x * frame[0] + v.y * frame[1] + v.z * frame[2],
                          L = l.x * frame[0] + l.y * frame[1] + l.z * frame[2];
        const vec3<float> H = glm::normalize(V_ + L), N = frame[2];
        const float nv = glm::dot(N, V_), nl = glm::dot(N, L), nh = glm::dot(N, H), a2 = 0.15f * 0.15f;
        if (v.z <= 0 || l.z <= 0 || nv <= 0 || nl <= 0) return 0.0f;
        const float f = (nh * a2 - nh) * nh + 1, D = a2 / (pi<float> * f * f);
        const float vis = 0.5f / (nl * std::sqrt(nv * nv * (1 - a2) + a2) + nv * std::sqrt(nl * nl * (1 - a2) + a2));
        return D * vis * nl;
    });
    return t.all;
}

std::vector<trial> wrong_ones() {
    trials t;
    wrong_formulas(t);
    wrong_energy(t);
    wrong_samplers(t);
    wrong_values(t);
    return t.all;
}

/// No BRDFs at all, or used wrongly: each must come back with a finding, and must come back.
std::vector<trial> misused_ones() {
    trials t;
    const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
    const auto constant = [](double c) { return [c](const V&, const V&) { return c; }; };
    t.add(
        "throws", [](const V&, const V&) -> double { throw std::runtime_error("no texture"); }, "no exception",
        "no texture");
    t.add(
        "throws an int, sometimes", [](const V& v, const V& l) { return v.z < 0.2 && v.z > 0 ? throw 7 : l.z; },
        "no exception");
    t.add("throws in sample",
          resampled(lambert(0.5),
                    [](const V& v, const U&, drawn&) {
                        if (v.z < 0.5) throw std::runtime_error("u");
                    }),
          "no exception", "u");
    t.add("NaN everywhere", constant(nan), "f_cos is finite", "every value");
    t.add("infinite everywhere", constant(infinity), "f_cos is finite", "every value");
    t.add("0 everywhere", constant(0), "f_cos is not always 0", "nothing can be verified");
    t.add("1 everywhere", constant(1), "f_cos vanishes below");
    t.add("-1 everywhere", constant(-1), "f_cos is not negative");
    t.add("huge everywhere", constant(1e300));
    material<double> mirror;
    mirror.f_cos = [](const V&, const V&) { return 0.0; };
    mirror.pdf = mirror.f_cos;
    mirror.sample = [](const V& v, const U&) { return drawn{V(-v.x, -v.y, v.z), 1, 0}; };
    t.add("a perfect mirror", mirror, "no light without a density", "perfect mirror");
    mirror.sample = [](const V& v, const U&) { return drawn{V(-v.x, -v.y, v.z), 1, 1}; };
    t.add("a perfect mirror of density 1", mirror, "weight * pdf", "100 % of the samples");
    material<double> glazed_mirror = lambert(0.5);
    glazed_mirror.pdf = [p = glazed_mirror.pdf](const V& v, const V& l) { return p(v, l) / 2; };
    glazed_mirror.sample = [below = glazed_mirror.sample](const V& v, const U& u) {
        auto s = below(v, {u.x < 0.5 ? 2 * u.x : 2 * u.x - 1, u.y});
        if (u.x < 0.5 && v.z > 0) s.l = V(-v.x, -v.y, v.z);
        s.pdf /= 2;
        return s;
    };
    t.add("a perfect mirror on Lambert", glazed_mirror, "integral of the pdf", "50 % of the samples");
    t.add(
        "NaN in every part",
        [&] {
            material<double> m;
            m.f_cos = m.pdf = [nan](const V&, const V&) { return nan; };
            m.sample = [nan](const V&, const U&) { return drawn{V(nan), nan, nan}; };
            return m;
        }(),
        "sample is finite");
    t.add(
        "infinite in every part",
        [&] {
            material<double> m;
            m.f_cos = m.pdf = [infinity](const V&, const V&) { return infinity; };
            m.sample = [infinity](const V&, const U&) { return drawn{V(infinity), infinity, infinity}; };
            return m;
        }(),
        "sample is finite");
    t.add("samples of NaN directions, l.z aside",
          resampled(lambert(0.5), [nan](const V&, const U&, drawn& s) { s.l.x = nan; }), "sample is finite");
    t.add("random numbers", [state = std::make_shared<std::uint32_t>(1u)](const V&, const V&) {
        *state = *state * 1664525u + 1013904223u;
        return static_cast<double>(*state) * 0x1p-32;
    });
    t.add("every sample the same l",
          resampled(lambert(0.5), [](const V&, const U&, drawn& s) { s.l = V(0, 0.6, 0.8); }), "samples follow",
          "one and the same direction");
    t.add("every sample fails", resampled(lambert(0.5), [](const V&, const U&, drawn& s) { s = {}; }),
          "integral of the pdf", "most samples fail");
    t.add("takes degrees of cosines: reads l.z only", [](const V&, const V& l) { return l.z; });
    return t.all;
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// Prints a row of the table; false where the verdict, or the finding, is another.
bool as_expected(const trial& t, bool right) {
    const std::clock_t start = std::clock();
    const report r = t.judge(t.claims);
    const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    const auto findings = r.findings();
    bool named = t.property.empty() && t.meaning.empty();
    std::string properties;
    for (const auto& f : findings) {
        named |= contains(f.property, t.property) && contains(f.meaning, t.meaning);
        properties += (properties.empty() ? "" : "; ") + f.property;
    }
    const bool good = right ? r.passed() : !r.passed() && named;
    std::printf("%s %-46s %-6s %.2f s  %s\n", good ? "  " : "!!", t.name.c_str(), r.passed() ? "passed" : "FAILED",
                seconds, properties.c_str());
    if (!good && right)
        for (const auto& f : findings)
            std::printf("       %s: %.9g, expected %.9g +- %.3g\n       %s\n       at %s\n", f.property.c_str(),
                        f.measured, f.expected, f.tolerance, f.meaning.c_str(), f.input.c_str());
    return good;
}

int misjudged(const std::vector<trial>& all, bool right) {
    int wrong = 0;
    for (const trial& t : all) wrong += !as_expected(t, right);
    std::printf("%d of %d as they should be\n\n", static_cast<int>(all.size()) - wrong, static_cast<int>(all.size()));
    return wrong;
}

}  // namespace

TEST_CASE("The test kit passes what is right, over hard parameters") {
    const auto all = right_ones();
    CHECK(all.size() >= 30);
    CHECK(misjudged(all, true) == 0);
}

TEST_CASE("The test kit catches every single mistake, and names it") {
    const auto all = wrong_ones();
    CHECK(all.size() >= 60);
    CHECK(misjudged(all, false) == 0);
}

TEST_CASE("The test kit survives what is no BRDF, and says so") { CHECK(misjudged(misused_ones(), false) == 0); }
