// The variants of the foundation, each a function of the inputs at i (make_kernel.hpp), lobe's beside the textbook's.
#pragma once

#include "make_kernel.hpp"
#include "textbook.hpp"

namespace {

using glm::vec2, glm::vec3;
using lobe::alpha, lobe::alpha_xy, lobe::ggx;

vec3 view(const inputs& in, std::size_t i) { return {in.vx[i], in.vy[i], in.vz[i]}; }
vec3 light(const inputs& in, std::size_t i) { return {in.lx[i], in.ly[i], in.lz[i]}; }
vec3 normal(const inputs& in, std::size_t i) { return {in.mx[i], in.my[i], in.mz[i]}; }
vec3 anisotropic_normal(const inputs& in, std::size_t i) { return {in.nx[i], in.ny[i], in.nz[i]}; }
vec2 point(const inputs& in, std::size_t i) { return {in.u1[i], in.u2[i]}; }
vec3 F0(const inputs& in, std::size_t i) { return {in.r[i], in.g[i], in.b[i]}; }
ggx<float> distribution(const inputs& in, std::size_t i) { return ggx{alpha{in.a[i]}}; }

result<3> three(const vec3& x) { return {x.x, x.y, x.z}; }

/// Reads one number: what the call or the loop itself costs.
struct nothing {
    [[gnu::always_inline]] static result<1> at(const inputs& in, std::size_t i) { return {in.vx[i]}; }
};

struct lobe_D {
    [[gnu::always_inline]] static result<1> at(const inputs& in, std::size_t i) { return {distribution(in, i).D(normal(in, i))}; }
};
struct textbook_D {
    [[gnu::always_inline]] static result<1> at(const inputs& in, std::size_t i) { return {textbook::ggx(in.mz[i], in.a[i])}; }
};
struct lobe_D_vl {
    [[gnu::always_inline]] static result<1> at(const inputs& in, std::size_t i) {
        return {distribution(in, i).D(view(in, i) + light(in, i))};
    }
};
struct textbook_D_vl {
    [[gnu::always_inline]] static result<1> at(const inputs& in, std::size_t i) {
        return {textbook::ggx(glm::normalize(view(in, i) + light(in, i)).z, in.a[i])};
    }
};
struct lobe_D_xy {
    [[gnu::always_inline]] static result<1> at(const inputs& in, std::size_t i) {
        return {ggx{alpha_xy{in.ax[i], in.ay[i]}}.D(anisotropic_normal(in, i))};
    }
};
struct textbook_D_xy {
    [[gnu::always_inline]] static result<1> at(const inputs& in, std::size_t i) {
        return {textbook::ggx_anisotropic(anisotropic_normal(in, i), in.ax[i], in.ay[i])};
    }
};

template <class Masking>
struct lobe_visibility {
    [[gnu::always_inline]] static result<1> at(const inputs& in, std::size_t i) {
        return {Masking{}.visibility(distribution(in, i), view(in, i), light(in, i))};
    }
};
template <auto Formula>
struct textbook_visibility {
    [[gnu::always_inline]] static result<1> at(const inputs& in, std::size_t i) { return {Formula(in.vz[i], in.lz[i], in.a[i])}; }
};

struct lobe_schlick {
    [[gnu::always_inline]] static result<1> at(const inputs& in, std::size_t i) { return {lobe::schlick{in.r[i]}(in.v_m[i])}; }
};
struct textbook_schlick {
    [[gnu::always_inline]] static result<1> at(const inputs& in, std::size_t i) { return {textbook::schlick(in.r[i], in.v_m[i])}; }
};
struct lobe_schlick_rgb {
    [[gnu::always_inline]] static result<3> at(const inputs& in, std::size_t i) { return three(lobe::schlick{F0(in, i)}(in.v_m[i])); }
};
struct textbook_schlick_rgb {
    [[gnu::always_inline]] static result<3> at(const inputs& in, std::size_t i) { return three(textbook::schlick(F0(in, i), in.v_m[i])); }
};

struct lobe_f_cos {
    [[gnu::always_inline]] static result<3> at(const inputs& in, std::size_t i) {
        const lobe::microfacet brdf{distribution(in, i), lobe::smith_correlated{}, lobe::schlick{F0(in, i)}};
        return three(brdf.f_cos(view(in, i), light(in, i)));
    }
};
template <auto Formula>
struct textbook_f_cos {
    [[gnu::always_inline]] static result<3> at(const inputs& in, std::size_t i) {
        return three(Formula(view(in, i), light(in, i), in.a[i], F0(in, i)));
    }
};

struct lobe_evaluate {
    [[gnu::always_inline]] static result<4> at(const inputs& in, std::size_t i) {
        const lobe::microfacet brdf{distribution(in, i), lobe::smith_correlated{}, lobe::schlick{F0(in, i)}};
        const auto e = brdf.evaluate(view(in, i), light(in, i));
        return {e.f_cos.x, e.f_cos.y, e.f_cos.z, e.pdf};
    }
};
struct textbook_evaluate {
    [[gnu::always_inline]] static result<4> at(const inputs& in, std::size_t i) {
        const vec3 f = textbook::f_cos<>(view(in, i), light(in, i), in.a[i], F0(in, i));
        return {f.x, f.y, f.z, textbook::pdf_visible(textbook::cosines(view(in, i), light(in, i)), in.a[i])};
    }
};

template <class Sampler>
struct lobe_pdf {
    [[gnu::always_inline]] static result<1> at(const inputs& in, std::size_t i) {
        const lobe::microfacet brdf{distribution(in, i), lobe::smith_correlated{}, lobe::schlick{F0(in, i)}, Sampler{}};
        return {brdf.pdf(view(in, i), light(in, i))};
    }
};
template <auto Formula>
struct textbook_pdf {
    [[gnu::always_inline]] static result<1> at(const inputs& in, std::size_t i) {
        return {Formula(textbook::cosines(view(in, i), light(in, i)), in.a[i])};
    }
};

template <class Sampler>
struct lobe_sample {
    [[gnu::always_inline]] static result<7> at(const inputs& in, std::size_t i) {
        const lobe::microfacet brdf{distribution(in, i), lobe::smith_correlated{}, lobe::schlick{F0(in, i)}, Sampler{}};
        const auto s = brdf.sample(view(in, i), point(in, i));
        return {s.l.x, s.l.y, s.l.z, s.weight.x, s.weight.y, s.weight.z, s.pdf};
    }
};
template <auto Formula>
struct textbook_sample {
    [[gnu::always_inline]] static result<7> at(const inputs& in, std::size_t i) {
        const auto s = Formula(view(in, i), point(in, i), in.a[i], F0(in, i));
        return {s.l.x, s.l.y, s.l.z, s.weight.x, s.weight.y, s.weight.z, s.pdf};
    }
};

struct lobe_hammersley {
    [[gnu::always_inline]] static result<2> at(const inputs& in, std::size_t i) {
        const vec2 p = lobe::hammersley(in.index[i], in.points);
        return {p.x, p.y};
    }
};
struct textbook_hammersley {
    [[gnu::always_inline]] static result<2> at(const inputs& in, std::size_t i) {
        const vec2 p = textbook::hammersley(in.index[i], in.points);
        return {p.x, p.y};
    }
};
struct lobe_radical_inverse {
    [[gnu::always_inline]] static result<1> at(const inputs& in, std::size_t i) { return {lobe::radical_inverse(in.index[i])}; }
};
struct textbook_radical_inverse {
    [[gnu::always_inline]] static result<1> at(const inputs& in, std::size_t i) { return {textbook::radical_inverse(in.index[i])}; }
};

struct lobe_sincos {
    [[gnu::always_inline]] static result<2> at(const inputs& in, std::size_t i) {
        const auto [s, c] = lobe::sincos_2pi(in.turn[i]);
        return {s, c};
    }
};
struct textbook_sincos {
    [[gnu::always_inline]] static result<2> at(const inputs& in, std::size_t i) {
        const float phi = 2.0f * textbook::pi * in.turn[i];
        return {std::sin(phi), std::cos(phi)};
    }
};

struct lobe_dfg_table {
    [[gnu::always_inline]] static result<2> at(const inputs& in, std::size_t i) {
        const auto t = (*in.table)(in.vz[i], alpha{in.a[i]});
        return {t.scale, t.bias};
    }
};
struct textbook_dfg_table {
    [[gnu::always_inline]] static result<2> at(const inputs& in, std::size_t i) {
        const vec2 t = textbook::read(*in.baked, in.vz[i], in.a[i]);
        return {t.x, t.y};
    }
};
struct karis_mobile {
    [[gnu::always_inline]] static result<2> at(const inputs& in, std::size_t i) {
        const vec2 t = textbook::karis_mobile(in.vz[i], in.a[i]);
        return {t.x, t.y};
    }
};

std::vector<kernel> all_kernels() {
    return {
        kernel_of<nothing>("nothing"),
        kernel_of<lobe_D>("lobe D"),
        kernel_of<textbook_D>("textbook D"),
        kernel_of<lobe_D_vl>("lobe D of v+l"),
        kernel_of<textbook_D_vl>("textbook D of v+l"),
        kernel_of<lobe_D_xy>("lobe anisotropic D"),
        kernel_of<textbook_D_xy>("textbook anisotropic D"),
        kernel_of<lobe_visibility<lobe::smith_correlated>>("lobe correlated"),
        kernel_of<textbook_visibility<textbook::visibility_correlated>>("textbook correlated"),
        kernel_of<textbook_visibility<textbook::visibility_hammon>>("Hammon"),
        kernel_of<lobe_visibility<lobe::smith_separable>>("lobe separable"),
        kernel_of<textbook_visibility<textbook::visibility_separable>>("textbook separable"),
        kernel_of<textbook_visibility<textbook::visibility_schlick_ggx>>("Schlick-GGX"),
        kernel_of<lobe_schlick>("lobe Schlick"),
        kernel_of<textbook_schlick>("textbook Schlick"),
        kernel_of<lobe_schlick_rgb>("lobe Schlick rgb"),
        kernel_of<textbook_schlick_rgb>("textbook Schlick rgb"),
        kernel_of<lobe_f_cos>("lobe f_cos"),
        kernel_of<textbook_f_cos<textbook::f_cos<>>>("textbook F D V cos"),
        kernel_of<textbook_f_cos<textbook::f_cos<textbook::schlick<vec3>>>>("textbook pow"),
        kernel_of<textbook_f_cos<textbook::f_cos_guarded>>("textbook guarded"),
        kernel_of<lobe_evaluate>("lobe evaluate"),
        kernel_of<textbook_evaluate>("textbook evaluate"),
        kernel_of<lobe_pdf<lobe::visible_caps>>("lobe pdf visible"),
        kernel_of<textbook_pdf<textbook::pdf_visible>>("textbook pdf visible"),
        kernel_of<lobe_pdf<lobe::all_normals>>("lobe pdf all"),
        kernel_of<textbook_pdf<textbook::pdf_all>>("textbook pdf all"),
        kernel_of<lobe_sample<lobe::visible_caps>>("lobe sample visible"),
        kernel_of<textbook_sample<textbook::sample_visible>>("textbook sample visible"),
        kernel_of<lobe_sample<lobe::all_normals>>("lobe sample all"),
        kernel_of<textbook_sample<textbook::sample_all>>("textbook sample all"),
        kernel_of<lobe_hammersley>("lobe Hammersley"),
        kernel_of<textbook_hammersley>("textbook Hammersley"),
        kernel_of<lobe_radical_inverse>("lobe radical inverse"),
        kernel_of<textbook_radical_inverse>("textbook radical inverse"),
        kernel_of<lobe_sincos>("lobe sincos"),
        kernel_of<textbook_sincos>("textbook sincos"),
        kernel_of<lobe_dfg_table>("lobe table"),
        kernel_of<textbook_dfg_table>("textbook table"),
        kernel_of<karis_mobile>("Karis fit"),
    };
}

}  // namespace
