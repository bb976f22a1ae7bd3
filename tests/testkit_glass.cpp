// The test kit on the whole sphere: glasses with exactly one mistake each must fail, right ones must pass.
#include <lobe/lobe.hpp>
#include <lobe/testkit.hpp>

#include "catch.hpp"

#include <cmath>
#include <iterator>
#include <numbers>
#include <string>
#include <string_view>

namespace {

using V = lobe::vec3<double>;
using lobe::alpha;
using lobe::alpha_xy;
using lobe::cross;
using lobe::dot;
using lobe::ggx;
using lobe::length;
using lobe::normalize;
using lobe::rough_dielectric;
using lobe::testkit::options;
using lobe::testkit::report;
using lobe::testkit::verify;

enum class mistake {
    none,
    transmits_all,             // 1 instead of 1 - F in f
    no_scale,                  // of radiance, in f
    scale_upside_down,         // in f
    scale_in_f_only,           // not in the weight
    no_light_cosine_in_f,      // |l.m| of the refraction's Jacobian
    no_light_cosine_in_pdf,    //
    no_index_in_pdf,           // n^2 of the Jacobian
    denominator_not_squared,   // in f
    no_transmittance_in_pdf,   // 1 - F
    no_reflectance_in_pdf,     // F
    half_vector_of_inverse,    // v + l/n
    index_not_inverted_below,  // of everything, from below
    fresnel_not_inverted,      // of F, from below
    fresnel_of_normal,         // F(n.v) in f
    selects_by_normal,         // F(n.v) in sample
    no_masking_of_refracted,   // G1(l)
    no_quarter,                // 1/4 of the reflection
    signed_cosine,             // l.z instead of |l.z|
    refracted_not_unit,        //
    refracts_normal,           // about n instead of m, in sample
    narrow_sampler,            // alpha 5 % off
    selects_by_used_number,    // u.x twice
    pdf_one_sided,             // 0 where l is below
    pdf_of_refraction_halved,  //
    f_one_sided,               // from below, half vectors are not turned
    bright_from_below,         // 5 % on the reflection
    weight_times_fresnel,      // of reflections
    weight_1_percent,          // of refraction
    nan_beyond_critical,       // sqrt of a negative number
    reflects_to_other_side,    // from below
    absorbs_by_view,           // f of refraction times v.z: not reciprocal
    tinted_sample,             // the weight of refraction lacks a tint of .9
};

/// Walter et al. 2007, GGX, separable masking; radiance.
struct walter {
    using scalar = double;
    static constexpr bool isotropic = true, transmits = true;
    double a = 0.3, eta = 1.5;
    mistake m = mistake::none;

    double relative_index() const { return eta; }
    bool is(mistake k) const { return m == k; }
    double n_of(const V& v) const { return v.z > 0 || is(mistake::index_not_inverted_below) ? eta : 1 / eta; }

    static double F(double n, double c) {
        const double g2 = n * n - 1 + c * c;
        if (!(g2 > 0)) return 1;
        const double g = std::sqrt(g2), s = (g - c) / (g + c), t = (c * (g + c) - 1) / (c * (g - c) + 1);
        return s * s * (1 + t * t) / 2;
    }
    double fresnel(const V& v, double c) const {
        if (is(mistake::nan_beyond_critical) && n_of(v) * n_of(v) - 1 + c * c < 0) return std::nan("");
        return F(is(mistake::fresnel_not_inverted) && v.z < 0 ? eta : n_of(v), c);
    }
    double D(const V& h) const {
        if (!(h.z > 0)) return 0;
        const double t = (h.x * h.x + h.y * h.y) / (a * a) + h.z * h.z;
        return 1 / (std::numbers::pi * a * a * t * t);
    }
    double G1(const V& w) const {
        const double t2 = a * a * (w.x * w.x + w.y * w.y) / (w.z * w.z);
        return 2 / (1 + std::sqrt(1 + t2));
    }
    /// The half vector, up, and whether its facet sends v to l.
    bool facet(const V& v, const V& l, V& h) const {
        if (v.z == 0 || l.z == 0) return false;
        const bool reflects = v.z * l.z > 0;
        const double n = is(mistake::half_vector_of_inverse) ? 1 / n_of(v) : n_of(v);
        h = reflects ? v + l : v + n * l;
        const double size = length(h);
        if (!(size > 0)) return false;
        h = h / size;
        if (h.z < 0 && !(is(mistake::f_one_sided) && v.z < 0)) h = -h;
        const double vm = dot(v, h), lm = dot(l, h);
        return vm * v.z > 0 && lm * l.z > 0;
    }
    double f_cos(const V& v, const V& l) const {
        V h;
        if (!facet(v, l, h)) return 0;
        const double n = n_of(v), vm = std::abs(dot(v, h)), lm = std::abs(dot(l, h));
        const double R = fresnel(v, is(mistake::fresnel_of_normal) ? std::abs(v.z) : vm);
        const double cosine = is(mistake::signed_cosine) ? l.z / std::abs(l.z) : 1;
        if (v.z * l.z > 0)
            return cosine * R * D(h) * G1(v) * G1(l) / ((is(mistake::no_quarter) ? 1 : 4) * std::abs(v.z)) *
                   (is(mistake::bright_from_below) && v.z < 0 ? 1.05 : 1);
        const double K = dot(v, h) + n * dot(l, h);
        double f = (is(mistake::transmits_all) ? 1 : 1 - R) * D(h) * G1(v) * vm / (std::abs(v.z) * K * K);
        if (is(mistake::denominator_not_squared)) f *= std::abs(K);
        if (!is(mistake::no_light_cosine_in_f)) f *= lm;
        if (!is(mistake::no_masking_of_refracted)) f *= G1(l);
        if (is(mistake::no_scale)) f *= n * n;
        if (is(mistake::scale_upside_down)) f *= n * n * n * n;
        if (is(mistake::absorbs_by_view)) f *= std::abs(v.z);
        if (is(mistake::tinted_sample)) f *= 0.9;
        return cosine * f;
    }
    double pdf(const V& v, const V& l) const {
        V h;
        if (!facet(v, l, h)) return 0;
        const double n = n_of(v), vm = std::abs(dot(v, h)), lm = std::abs(dot(l, h)), R = fresnel(v, vm);
        const double visible = D(h) * G1(v) * vm / std::abs(v.z);
        if (v.z * l.z > 0) return (is(mistake::no_reflectance_in_pdf) ? 1 : R) * visible / (4 * vm);
        if (is(mistake::pdf_one_sided) && l.z < 0) return 0;
        const double K = dot(v, h) + n * dot(l, h);
        double p = (is(mistake::no_transmittance_in_pdf) ? 1 : 1 - R) * visible / (K * K);
        if (!is(mistake::no_light_cosine_in_pdf)) p *= lm;
        if (!is(mistake::no_index_in_pdf)) p *= n * n;
        if (is(mistake::pdf_of_refraction_halved)) p /= 2;
        return p;
    }
    struct drawn {
        V l{0, 0, 1};
        double weight = 0, pdf = 0;
    };
    /// Heitz 2018, "Sampling the GGX distribution of visible normals".
    V visible_normal(const V& w, double x, double y) const {
        const double width = is(mistake::narrow_sampler) ? a * 0.95 : a;
        const V s = normalize(V{width * w.x, width * w.y, w.z});
        const double across = s.x * s.x + s.y * s.y;
        const V t1 = across > 0 ? V{-s.y, s.x, 0} / std::sqrt(across) : V{1, 0, 0}, t2 = cross(s, t1);
        const double r = std::sqrt(x), phi = 2 * std::numbers::pi * y, p1 = r * std::cos(phi), q = (1 + s.z) / 2;
        const double p2 = (1 - q) * std::sqrt(1 - p1 * p1) + q * r * std::sin(phi);
        const V on = p1 * t1 + p2 * t2 + std::sqrt(std::max(0.0, 1 - p1 * p1 - p2 * p2)) * s;
        return normalize(V{width * on.x, width * on.y, std::max(0.0, on.z)});
    }
    drawn sample(const V& v, const V& u) const {
        if (v.z == 0) return {};
        const double side = v.z < 0 ? -1 : 1, n = n_of(v);
        const V w{v.x, v.y, std::abs(v.z)}, h = visible_normal(w, u.x, u.y);
        const double c = dot(w, h), R = fresnel(v, c);
        drawn s;
        const bool reflects =
            (is(mistake::selects_by_used_number) ? u.x : u.z) < (is(mistake::selects_by_normal) ? fresnel(v, w.z) : R);
        if (reflects) {
            s.l = 2 * c * h - w;
            if (!(s.l.z > 0)) return {};
            s.l.z *= is(mistake::reflects_to_other_side) ? 1 : side;
            s.weight = G1(s.l) * (is(mistake::weight_times_fresnel) ? R : 1);
        } else {
            const double g2 = n * n - 1 + c * c;
            if (!(g2 >= 0)) return {};
            const V about = is(mistake::refracts_normal) ? V{0, 0, 1} : h;
            const double k = dot(w, about), g = std::sqrt(n * n - 1 + k * k);
            s.l = -(w + (g - k) * about) / n;
            if (is(mistake::refracted_not_unit)) s.l = s.l * n;
            if (s.l.z >= 0) return {};
            s.l.z *= side;
            s.weight = G1(s.l) / (is(mistake::scale_in_f_only) ? 1 : n * n) *
                       (is(mistake::weight_1_percent) ? 1.01 : 1) * (is(mistake::absorbs_by_view) ? w.z : 1);
            if (is(mistake::no_scale)) s.weight *= n * n;
        }
        s.pdf = pdf(v, s.l);
        if (!(s.pdf > 0)) return {};
        return s;
    }
};

struct wrong_glass {
    mistake m;
    std::string_view clue;  // part of the meaning of a finding
};
constexpr wrong_glass wrong_glasses[] = {
    {mistake::transmits_all, "energy is gained"},
    {mistake::no_scale, "(eta_v/eta_l)^2, which radiance is scaled by, is missing"},
    {mistake::scale_upside_down, "upside down"},
    {mistake::scale_in_f_only, "of refraction alone"},
    {mistake::no_light_cosine_in_f, "of refraction alone"},
    {mistake::no_light_cosine_in_pdf, "of refraction alone"},
    {mistake::no_index_in_pdf, "of refraction alone"},
    {mistake::denominator_not_squared, "of refraction alone"},
    {mistake::no_transmittance_in_pdf, ""},
    {mistake::no_reflectance_in_pdf, ""},
    {mistake::half_vector_of_inverse, ""},
    {mistake::index_not_inverted_below, ""},
    {mistake::fresnel_not_inverted, "of refraction alone"},
    {mistake::fresnel_of_normal, ""},
    {mistake::selects_by_normal, ""},
    {mistake::no_masking_of_refracted, "of refraction alone"},
    {mistake::no_quarter, "of reflection alone: 4 times"},
    {mistake::signed_cosine, "a cosine that is not clamped"},
    {mistake::refracted_not_unit, ""},
    {mistake::refracts_normal, ""},
    {mistake::narrow_sampler, ""},
    {mistake::selects_by_used_number, ""},
    {mistake::pdf_one_sided, ""},
    {mistake::pdf_of_refraction_halved, "of refraction alone: 2 times"},
    {mistake::f_one_sided, "of refraction alone"},
    {mistake::bright_from_below, "of reflection alone, from below alone: the same factor"},
    {mistake::weight_times_fresnel, "of reflection alone"},
    {mistake::weight_1_percent, "of refraction alone: the same factor"},
    {mistake::nan_beyond_critical, "the root or power of a negative number"},
    {mistake::reflects_to_other_side, "from below"},
    {mistake::absorbs_by_view, ""},
    {mistake::tinted_sample, "of refraction alone: the same factor"},
};

report verdict(const walter& glass, std::uint64_t seed) {
    options o;
    o.seed = seed;
    return verify(glass, o);
}

template <class B>
void expect_pass(const std::string& name, const B& glass, std::uint64_t seeds, options o = {}) {
    for (o.seed = 1; o.seed <= seeds; ++o.seed) {
        const auto r = verify(glass, o);
        INFO(name << ", seed " << o.seed << "\n" << r);
        CHECK(r.passed());
    }
}

void expect_right_glasses(std::uint64_t seeds) {
    const bool all = seeds > 1;
    const alpha<double> satin{0.3}, fine{0.02}, coarse{1.0};
    const lobe::smith_joint joint;
    const lobe::importance_transport importance;
    expect_pass("Walter", walter{}, seeds);
    expect_pass("Walter, from the other side", walter{.a = 0.1, .eta = 1 / 1.33}, seeds);
    expect_pass("satin", rough_dielectric{ggx{satin}, joint, 1.5}, seeds);
    expect_pass("float", rough_dielectric{ggx{alpha<float>{0.3f}}, joint, 1.5f}, seeds);
    if (!all) return;
    expect_pass("satin, importance", rough_dielectric{ggx{satin}, joint, 1.5, importance}, seeds);
    expect_pass("fine", rough_dielectric{ggx{fine}, joint, 1.5}, seeds);
    expect_pass("coarse", rough_dielectric{ggx{coarse}, joint, 1.5}, seeds);
    expect_pass("diamond", rough_dielectric{ggx{satin}, joint, 2.4}, seeds);
    expect_pass("air in diamond", rough_dielectric{ggx{satin}, joint, 1 / 2.4}, seeds);
    expect_pass("nearly matched", rough_dielectric{ggx{satin}, joint, 1.05}, seeds);
    expect_pass("product", rough_dielectric{ggx{satin}, lobe::smith_product{}, 1.5}, seeds);
    expect_pass("exact", rough_dielectric{ggx{satin}, lobe::smith_joint_exact{}, 1.5, importance}, seeds);
    expect_pass("Beckmann", rough_dielectric{lobe::beckmann{satin}, joint, 1.5}, seeds);
    expect_pass("brushed", rough_dielectric{ggx{alpha_xy<double>{0.05, 0.5}}, joint, 1.5}, seeds);
    expect_pass("float, fine", rough_dielectric{ggx{alpha<float>{0.02f}}, joint, 1.33f, importance}, seeds);
}

/// Every one of them with a step of 1.
void expect_found(std::size_t step) {
    for (std::size_t i = 0; i < std::size(wrong_glasses); i += step) {
        const auto& [m, clue] = wrong_glasses[i];
        const report r = verdict({.m = m}, 1);
        INFO("mistake " << static_cast<int>(m) << ", clue " << clue << "\n" << r);
        CHECK(!r.passed());
        bool said = clue.empty();
        for (const auto& f : r.findings()) said = said || f.meaning.find(clue) != std::string::npos;
        CHECK(said);
    }
}

}  // namespace

TEST_CASE("right glasses pass: four of fifteen", "[testkit]") { expect_right_glasses(1); }

TEST_CASE("right glasses pass with forty seeds", "[.stress]") { expect_right_glasses(40); }

TEST_CASE("glasses with one mistake fail and say where: every fourth", "[testkit]") { expect_found(4); }

TEST_CASE("all glasses with one mistake fail", "[.stress]") { expect_found(1); }

TEST_CASE("a BSDF that does not say so is told in one sentence", "[testkit]") {
    const walter glass;
    const lobe::testkit::functions silent{[=](const V& v, const V& l) { return glass.f_cos(v, l); },
                                          [=](const V& v, const V& u) { return glass.sample(v, u); },
                                          [=](const V& v, const V& l) { return glass.pdf(v, l); }};
    const report r = verify(silent);
    INFO(r);
    CHECK(!r.passed());
    bool said = false;
    for (const auto& f : r.findings()) said = said || f.meaning.find("options.transmits") != std::string::npos;
    CHECK(said);

    options o;  // said with options: the same verdict as by the type
    o.transmits = true;
    o.eta = 1.5;
    CHECK(verify(silent, o).passed());
    o.eta = 1.4;
    CHECK(!verify(silent, o).passed());
    o.eta = -1;
    CHECK(!verify(silent, o).passed());
}
