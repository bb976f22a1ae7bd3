#include "rows.hpp"

namespace {

using truth::real, truth::view, truth::light;

void three(const truth::vector& w, real* out) {
    out[0] = w.x;
    out[1] = w.y;
    out[2] = w.z;
}
void seven(const truth::sampled& s, real* out) {
    three(s.l, out);
    three(s.weight, out + 3);
    out[6] = s.pdf;
}

void D(const inputs& in, std::size_t i, real* out) { *out = truth::D({in.mx[i], in.my[i], in.mz[i]}, in.a[i], in.a[i]); }
void D_vl(const inputs& in, std::size_t i, real* out) { *out = truth::D(view(in, i) + light(in, i), in.a[i], in.a[i]); }
void D_xy(const inputs& in, std::size_t i, real* out) { *out = truth::D({in.nx[i], in.ny[i], in.nz[i]}, in.ax[i], in.ay[i]); }
void correlated(const inputs& in, std::size_t i, real* out) { *out = truth::visibility_correlated(view(in, i), light(in, i), in.a[i]); }
void separable(const inputs& in, std::size_t i, real* out) { *out = truth::visibility_separable(view(in, i), light(in, i), in.a[i]); }
void schlick(const inputs& in, std::size_t i, real* out) { *out = truth::schlick(in.r[i], in.v_m[i]); }
void schlick_rgb(const inputs& in, std::size_t i, real* out) {
    three({truth::schlick(in.r[i], in.v_m[i]), truth::schlick(in.g[i], in.v_m[i]), truth::schlick(in.b[i], in.v_m[i])}, out);
}
void f_cos(const inputs& in, std::size_t i, real* out) { three(truth::f_cos(in, i), out); }
void evaluate(const inputs& in, std::size_t i, real* out) {
    f_cos(in, i, out);
    out[3] = truth::pdf_visible(in, i);
}
void pdf_visible(const inputs& in, std::size_t i, real* out) { *out = truth::pdf_visible(in, i); }
void pdf_all(const inputs& in, std::size_t i, real* out) { *out = truth::pdf_all(in, i); }
void sample_caps(const inputs& in, std::size_t i, real* out) { seven(truth::sample_caps(in, i), out); }
void sample_heitz2018(const inputs& in, std::size_t i, real* out) { seven(truth::sample_heitz2018(in, i), out); }
void sample_all(const inputs& in, std::size_t i, real* out) { seven(truth::sample_all(in, i), out); }
void radical_inverse(const inputs& in, std::size_t i, real* out) { *out = truth::radical_inverse(in.index[i]); }
void hammersley(const inputs& in, std::size_t i, real* out) {
    out[0] = (in.index[i] + 0.5L) / in.points;
    out[1] = truth::radical_inverse(in.index[i]) + 0.5L / in.points;
}
void hammersley_from_0(const inputs& in, std::size_t i, real* out) {
    out[0] = static_cast<real>(in.index[i]) / in.points;
    radical_inverse(in, i, out + 1);
}
void sincos(const inputs& in, std::size_t i, real* out) {
    const real phi = 2 * truth::pi * in.turn[i];
    out[0] = std::sin(phi);
    out[1] = std::cos(phi);
}
void dfg(const inputs& in, std::size_t i, real* out) {
    static const inputs* known = nullptr;  // the same for all rows, and not cheap
    static std::vector<truth::terms> terms;
    if (known != &in) {
        known = &in;
        terms.clear();
        for (std::size_t k = 0; k < count; ++k) terms.push_back(truth::dfg(in, k));
    }
    out[0] = terms[i].scale;
    out[1] = terms[i].bias;
}

}  // namespace

std::vector<section> sections() {
    using enum unit_of_error;
    const std::vector<metric> sample_metrics{{"l", direction, 0, 3}, {"weight", weight, 3, 3}, {"pdf", relative, 6, 1}};
    return {
        {"D, isotropic GGX, of a unit normal",
         "",
         {{"D", relative, 0, 1}},
         {{"lobe D", "lobe `ggx::D`", {{"rounding", D}}}, {"textbook D", "textbook, `(a2-1)*NoH*NoH + 1`", {{"rounding", D}}}}},
        {"D, isotropic GGX, of v and l",
         "lobe takes `v + l` as it is; the textbook normalizes it.",
         {{"D", relative, 0, 1}},
         {{"lobe D of v+l", "lobe `ggx::D`", {{"rounding", D_vl}}},
          {"textbook D of v+l", "textbook, half vector normalized", {{"rounding", D_vl}}}}},
        {"D, anisotropic GGX, of a unit normal",
         "",
         {{"D", relative, 0, 1}},
         {{"lobe anisotropic D", "lobe `ggx::D`", {{"rounding", D_xy}}}, {"textbook anisotropic D", "textbook", {{"rounding", D_xy}}}}},
        {"Visibility, correlated",
         "G2 / (4 cos cos).",
         {{"V", relative, 0, 1}},
         {{"lobe correlated", "lobe `smith_correlated`", {{"rounding", correlated}}},
          {"textbook correlated", "textbook", {{"rounding", correlated}}},
          {"Hammon", "Hammon 2017, no square root", {{"model", correlated}}}}},
        {"Visibility, separable",
         "G1 G1 / (4 cos cos).",
         {{"V", relative, 0, 1}},
         {{"lobe separable", "lobe `smith_separable`", {{"rounding", separable}}},
          {"textbook separable", "textbook, G1 times G1", {{"rounding", separable}}},
          {"Schlick-GGX", "Schlick-GGX, k = alpha/2", {{"model", separable}}}}},
        {"Fresnel, one number",
         "",
         {{"F", relative, 0, 1}},
         {{"lobe Schlick", "lobe `schlick`", {{"rounding", schlick}}}, {"textbook Schlick", "textbook, `pow(1-u, 5)`", {{"rounding", schlick}}}}},
        {"Fresnel, rgb",
         "",
         {{"F", relative, 0, 3}},
         {{"lobe Schlick rgb", "lobe `schlick`", {{"rounding", schlick_rgb}}},
          {"textbook Schlick rgb", "textbook, `pow(1-u, 5)`", {{"rounding", schlick_rgb}}}}},
        {"The whole BRDF: f_cos",
         "GGX, correlated masking, rgb Schlick.",
         {{"f_cos", relative, 0, 3}},
         {{"lobe f_cos", "lobe `microfacet::f_cos`", {{"rounding", f_cos}}},
          {"textbook F D V cos", "textbook, F D V cos", {{"rounding", f_cos}}},
          {"textbook pow", "textbook, F D V cos, `pow(1-u, 5)`", {{"rounding", f_cos}}},
          {"textbook guarded", "textbook, F D G / (4 NoV NoL + 0.001) cos, `pow`", {{"guards", f_cos}}}}},
        {"f_cos and pdf together",
         "The pdf is that of visible normals.",
         {{"f_cos, pdf", relative, 0, 4}},
         {{"lobe evaluate", "lobe `microfacet::evaluate`", {{"rounding", evaluate}}},
          {"textbook evaluate", "textbook, one half vector", {{"rounding", evaluate}}}}},
        {"pdf, visible normals",
         "",
         {{"pdf", relative, 0, 1}},
         {{"lobe pdf visible", "lobe `pdf`, `visible_caps`", {{"rounding", pdf_visible}}},
          {"textbook pdf visible", "textbook, G1 D VoH / NoV / (4 VoH)", {{"rounding", pdf_visible}}}}},
        {"pdf, all normals",
         "",
         {{"pdf", relative, 0, 1}},
         {{"lobe pdf all", "lobe `pdf`, `all_normals`", {{"rounding", pdf_all}}},
          {"textbook pdf all", "textbook, D NoH / (4 VoH)", {{"rounding", pdf_all}}}}},
        {"Sample visible normals: l, weight, pdf",
         "lobe: spherical caps (Dupuy & Benyoub 2023). Textbook: Heitz 2018. Each is compared with its own map. "
         "The error of l is in units of alpha, that of the weight relative to at least 1.",
         sample_metrics,
         {{"lobe sample visible", "lobe `sample`, `visible_caps`", {{"rounding", sample_caps}}},
          {"textbook sample visible", "textbook, Heitz 2018", {{"rounding", sample_heitz2018}}}}},
        {"Sample all normals: l, weight, pdf",
         "The inverse CDF. The textbook takes the sine from the cosine, `sqrt(1 - c*c)`.",
         sample_metrics,
         {{"lobe sample all", "lobe `sample`, `all_normals`", {{"rounding", sample_all}}},
          {"textbook sample all", "textbook, inverse CDF", {{"rounding", sample_all}}}}},
        {"Hammersley points",
         "Absolute errors, each against its own definition: lobe's points are half a step off the origin. A coordinate of 1 is outside the "
         "square: how many points have one.",
         {{"coordinate", absolute, 0, 2}, {"points at 1", points_at_1, 0, 2}},
         {{"lobe Hammersley", "lobe `hammersley`", {{"rounding", hammersley}}},
          {"textbook Hammersley", "textbook, i/N and bits * 2.328e-10", {{"rounding", hammersley_from_0}}}}},
        {"Radical inverse",
         "Absolute errors, and how many points are at 1.",
         {{"coordinate", absolute, 0, 1}, {"points at 1", points_at_1, 0, 1}},
         {{"lobe radical inverse", "lobe `radical_inverse`", {{"rounding", radical_inverse}}},
          {"textbook radical inverse", "textbook, bits * 2.328e-10", {{"rounding", radical_inverse}}}}},
        {"Sine and cosine of a turn",
         "",
         {{"sin, cos", relative, 0, 2}},
         {{"lobe sincos", "lobe `sincos_2pi`", {{"rounding", sincos}}},
          {"textbook sincos", "`std::sin`, `std::cos` of 2*pi*u", {{"rounding", sincos}}}}},
        {"Split-sum terms: one look-up",
         "Absolute errors against correlated Smith by quadrature. A baked table is read bilinearly.",
         {{"scale, bias", absolute, 0, 2}},
         {{"lobe table", "lobe `dfg_table`, 32 x 32", {{"table", dfg}}},
          {"textbook table", "textbook, 32 x 32, 1024 samples an entry", {{"model, table", dfg}}},
          {"Karis fit", "Karis 2014, mobile fit", {{"model", dfg}}}}},
        {"Split-sum terms: one integration",
         "Absolute errors, as above.",
         {{"scale, bias", absolute, 0, 2}},
         {{"dfg_exact 16", "lobe `dfg_exact`, order 16", {{"quadrature", dfg}}},
          {"Monte Carlo", "textbook, 1024 Hammersley samples", {{"model, noise", dfg}}},
          {"dfg_exact 32", "lobe `dfg_exact`, order 32", {{"quadrature", dfg}}}}},
        {"Split-sum terms: baking 32 x 32",
         "ns an entry. The errors are those of the look-ups.",
         {},
         {{"lobe bake", "lobe `bake_dfg`", {}}, {"textbook bake", "textbook, 1024 samples an entry", {}}}},
    };
}
