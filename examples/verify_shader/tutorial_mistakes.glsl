#version 450
// The mistakes that shading tutorials and their readers make most, one request each: every one is found.
// Beside each stands the same function put right, named x_right. Replace x by x_right in a request, and it passes.

const float PI = 3.14159265359;

float square(float x) { return x * x; }
float pow5(float x) { return square(square(x)) * x; }
float clamped(float x) { return max(x, 0.0); }
float schlick(float vh) { return 0.04 + 0.96 * pow5(clamp(1.0 - vh, 0.0, 1.0)); }
float smith(float cosine, float a) { return 2.0 * cosine / (cosine + sqrt(a * a + (1.0 - a * a) * cosine * cosine)); }
float D_GGX(float nh, float a) { return square(a / ((1.0 - nh * nh) + square(a * nh))) / PI; }

// D G F cos(theta_l) / (4 n.l n.v) for F = 1 at alpha 0.3: what most of the functions below begin with.
float lobe(vec3 v, vec3 l) {
    if (v.z <= 0.0 || l.z <= 0.0) return 0.0;
    return D_GGX(normalize(v + l).z, 0.3) * smith(v.z, 0.3) * smith(l.z, 0.3) / (4.0 * v.z);
}

vec3 normal_at(vec2 u, float a) { // a normal with the density D cos(theta)
    float cosine = sqrt((1.0 - u.x) / (1.0 + (a * a - 1.0) * u.x)), sine = sqrt(max(0.0, 1.0 - cosine * cosine));
    return vec3(sine * cos(2.0 * PI * u.y), sine * sin(2.0 * PI * u.y), cosine);
}

// A direction for such a normal: the density of l is that of m over 4 v.m, and the weight is f cos / pdf.
void sample_lobe(vec3 v, vec2 u, float a, out vec3 l, out float weight, out float pdf) {
    vec3 m = normal_at(u, a);
    float vm = dot(v, m);
    l = 2.0 * vm * m - v;
    bool reflects = vm > 0.0 && l.z > 0.0;
    weight = reflects ? smith(v.z, 0.3) * smith(l.z, 0.3) * vm / (v.z * m.z) : 0.0;
    pdf = reflects ? D_GGX(m.z, 0.3) * m.z / (4.0 * vm) : 0.0;
}

float pdf_lobe(vec3 v, vec3 l) {
    vec3 h = normalize(v + l);
    return v.z > 0.0 && l.z > 0.0 ? D_GGX(h.z, 0.3) * h.z / (4.0 * dot(v, h)) : 0.0;
}

// ---- Factors

//! verify brdf "diffuse without 1/pi": diffuse_without_pi(v, l)
float diffuse_without_pi(vec3 v, vec3 l) { return v.z > 0.0 ? clamped(l.z) : 0.0; }
float diffuse_without_pi_right(vec3 v, vec3 l) { return v.z > 0.0 ? clamped(l.z) / PI : 0.0; }

//! verify brdf "specular without 1/4": specular_without_4(v, l)
float specular_without_4(vec3 v, vec3 l) {
    if (v.z <= 0.0 || l.z <= 0.0) return 0.0;
    return D_GGX(normalize(v + l).z, 0.3) * smith(v.z, 0.3) * smith(l.z, 0.3) / (v.z * l.z) * l.z;
}
float specular_without_4_right(vec3 v, vec3 l) { return lobe(v, l); }

//! verify brdf "the cosine of the light, twice": cosine_twice(v, l)
float cosine_twice(vec3 v, vec3 l) { return lobe(v, l) * l.z; }
float cosine_twice_right(vec3 v, vec3 l) { return lobe(v, l); }

//! verify brdf "the light from behind, by abs": light_by_abs(v, l)
float light_by_abs(vec3 v, vec3 l) { return clamped(v.z) > 0.0 ? abs(l.z) / PI : 0.0; }
float light_by_abs_right(vec3 v, vec3 l) { return clamped(v.z) > 0.0 ? clamped(l.z) / PI : 0.0; }

// ---- Energy

//! verify brdf "specular on top of all of the diffuse": diffuse_is_whole(v, l)
float diffuse_is_whole(vec3 v, vec3 l) { return v.z > 0.0 ? clamped(l.z) / PI + schlick(0.5 * length(v + l)) * lobe(v, l) : 0.0; }
float diffuse_is_whole_right(vec3 v, vec3 l) { // Ashikhmin and Shirley 2000
    if (v.z <= 0.0 || l.z <= 0.0) return 0.0;
    float diffuse = 28.0 / (23.0 * PI) * 0.96 * (1.0 - pow5(1.0 - 0.5 * v.z)) * (1.0 - pow5(1.0 - 0.5 * l.z));
    return diffuse * l.z + schlick(0.5 * length(v + l)) * lobe(v, l);
}

//! verify brdf "Fresnel of n.v": fresnel_of_nv(v, l)
float fresnel_of_nv(vec3 v, vec3 l) { return schlick(v.z) * lobe(v, l); }
float fresnel_of_nv_right(vec3 v, vec3 l) { return schlick(0.5 * length(v + l)) * lobe(v, l); }

// With 1/(4 n.v n.l + 0.0001) the BRDF is no longer the one that its samples belong to.
//! verify brdf "0.0001 in the denominator": with_epsilon(v, l)
//!     sample: sample_lobe(v, u, 0.3, l, weight, pdf)
float with_epsilon(vec3 v, vec3 l) {
    if (v.z <= 0.0 || l.z <= 0.0) return 0.0;
    return D_GGX(normalize(v + l).z, 0.3) * smith(v.z, 0.3) * smith(l.z, 0.3) / (4.0 * v.z * l.z + 0.0001) * l.z;
}
float with_epsilon_right(vec3 v, vec3 l) { return lobe(v, l); }

// ---- Numbers that are none

// v.h is 1 + rounding where l is near v, and pow of a negative number is undefined.
//! verify brdf "pow of 1 - v.h": pow_of_negative(v, l)
float pow_of_negative(vec3 v, vec3 l) {
    if (v.z <= 0.0 || l.z <= 0.0) return 0.0;
    return (0.04 + 0.96 * pow(1.0 - dot(v, normalize(v + l)), 5.0)) * lobe(v, l);
}
float pow_of_negative_right(vec3 v, vec3 l) {
    if (v.z <= 0.0 || l.z <= 0.0) return 0.0;
    return schlick(dot(v, normalize(v + l))) * lobe(v, l);
}

// max(n.l, 0) keeps the sign, and 0/0 remains.
//! verify brdf "0/0 at the horizon": zero_by_zero(v, l)
float zero_by_zero(vec3 v, vec3 l) {
    float nv = clamped(v.z), nl = clamped(l.z);
    return D_GGX(normalize(v + l).z, 0.3) * smith(nv, 0.3) * smith(nl, 0.3) / (4.0 * nv * nl) * nl;
}
float zero_by_zero_right(vec3 v, vec3 l) { return lobe(v, l); }

// ---- The distribution and the masking

//! verify distribution "GGX without the square of its denominator": ggx_without_square(m.z, 0.3)
float ggx_without_square(float nh, float a) { return a * a / (PI * (nh * nh * (a * a - 1.0) + 1.0)); }
float ggx_without_square_right(float nh, float a) { return a * a / (PI * square(nh * nh * (a * a - 1.0) + 1.0)); }

// Of a roughness 0.3, so alpha 0.09.
//! verify distribution "roughness where alpha belongs, in the masking": D_GGX(m.z, 0.09)
//!     G1: masking_of_roughness(v.z, 0.3)
float masking_of_roughness(float cosine, float roughness) { return smith(cosine, roughness); }
float masking_of_roughness_right(float cosine, float roughness) { return smith(cosine, roughness * roughness); }

// In float 1 - cos^2 is a multiple of 6e-8, and the lobe of alpha 0.0005 ends at sin^2 = 2.5e-7.
//! verify distribution "1 - cos^2, alpha 0.0005": ggx_by_cosine(m, 0.0005)
float ggx_by_cosine(vec3 m, float a) { return D_GGX(m.z, a); }
float ggx_by_cosine_right(vec3 m, float a) { return square(a / (dot(m.xy, m.xy) + square(a * m.z))) / PI; }

// ---- Sampling

//! verify brdf "roughness where alpha belongs, in the sampler": lobe(v, l)
//!     sample: sample_of_roughness(v, u, sqrt(0.3), l, weight, pdf)
//!     pdf: pdf_lobe(v, l)
void sample_of_roughness(vec3 v, vec2 u, float roughness, out vec3 l, out float weight, out float pdf) {
    sample_lobe(v, u, roughness, l, weight, pdf);
}
void sample_of_roughness_right(vec3 v, vec2 u, float roughness, out vec3 l, out float weight, out float pdf) {
    sample_lobe(v, u, roughness * roughness, l, weight, pdf);
}

//! verify brdf "the density of the normal as that of the light": lobe(v, l)
//!     sample: sample_without_jacobian(v, u, l, pdf)
void sample_without_jacobian(vec3 v, vec2 u, out vec3 l, out float pdf) {
    float weight;
    sample_lobe(v, u, 0.3, l, weight, pdf);
    vec3 m = normalize(v + l);
    if (pdf > 0.0) pdf = D_GGX(m.z, 0.3) * m.z;
}
void sample_without_jacobian_right(vec3 v, vec2 u, out vec3 l, out float pdf) {
    float weight;
    sample_lobe(v, u, 0.3, l, weight, pdf);
}

//! verify brdf "a pdf without the Jacobian": lobe(v, l)
//!     sample: sample_lobe(v, u, 0.3, l, weight, pdf)
//!     pdf: pdf_without_jacobian(v, l)
float pdf_without_jacobian(vec3 v, vec3 l) {
    float nh = normalize(v + l).z;
    return v.z > 0.0 && l.z > 0.0 ? D_GGX(nh, 0.3) * nh : 0.0;
}
float pdf_without_jacobian_right(vec3 v, vec3 l) { return pdf_lobe(v, l); }

//! verify brdf "a weight without the cosine": lobe(v, l)
//!     sample: sample_without_cosine(v, u, l, weight, pdf)
//!     pdf: pdf_lobe(v, l)
void sample_without_cosine(vec3 v, vec2 u, out vec3 l, out float weight, out float pdf) {
    sample_lobe(v, u, 0.3, l, weight, pdf);
    if (pdf > 0.0) weight = lobe(v, l) / l.z / pdf;
}
void sample_without_cosine_right(vec3 v, vec2 u, out vec3 l, out float weight, out float pdf) {
    sample_lobe(v, u, 0.3, l, weight, pdf);
}

// Normals that reflect light from below the surface carry none.
//! verify brdf "samples below the horizon": lobe(v, l)
//!     sample: sample_anywhere(v, u, l, weight, pdf)
void sample_anywhere(vec3 v, vec2 u, out vec3 l, out float weight, out float pdf) {
    vec3 m = normal_at(u, 0.3);
    float vm = dot(v, m);
    l = 2.0 * vm * m - v;
    weight = abs(smith(v.z, 0.3) * smith(abs(l.z), 0.3) * vm / (v.z * m.z));
    pdf = D_GGX(m.z, 0.3) * m.z / abs(4.0 * vm);
}
void sample_anywhere_right(vec3 v, vec2 u, out vec3 l, out float weight, out float pdf) {
    sample_lobe(v, u, 0.3, l, weight, pdf);
}

// ---- Points

//! verify sequence "i / (n - 1)": reaches_one(i, 1024u)
float radical_inverse(uint i) {
    uint bits = 0u;
    for (int k = 0; k < 24; ++k) bits = (bits << 1u) | ((i >> uint(k)) & 1u);
    return float(bits) / 16777216.0;
}
vec2 reaches_one(uint i, uint n) { return vec2(float(i) / float(n - 1u), radical_inverse(i)); }
vec2 reaches_one_right(uint i, uint n) { return vec2(float(i) / float(n), radical_inverse(i)); }

// Points on a line: each coordinate is even, the pair is not.
//! verify sequence "x and y from one number": diagonal(i)
vec2 diagonal(uint i) { return vec2(radical_inverse(i), fract(radical_inverse(i) + 0.5)); }
vec2 diagonal_right(uint i) { return vec2(radical_inverse(i), (float(i) + 0.5) / 1024.0); }
