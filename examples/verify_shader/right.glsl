#version 450
// A metal, a dielectric over a diffuse base, and Lambert, as they ought to be: every request passes.
// All is computed in float, as a GPU does. Lines that begin with //! are requests to run.sh; README.md explains them.

const float PI = 3.14159265359;

float square(float x) { return x * x; }
float pow5(float x) { return square(square(x)) * x; }

// Points (i + 1/2) / n and the bits of i in reverse, of which float keeps 24: all 32 would round up to 1.
//! verify sequence "Hammersley": hammersley(i, 1024u)
vec2 hammersley(uint i, uint n) {
    uint bits = (i << 16u) | (i >> 16u);
    bits = ((bits & 0x55555555u) << 1u) | ((bits & 0xAAAAAAAAu) >> 1u);
    bits = ((bits & 0x33333333u) << 2u) | ((bits & 0xCCCCCCCCu) >> 2u);
    bits = ((bits & 0x0F0F0F0Fu) << 4u) | ((bits & 0xF0F0F0F0u) >> 4u);
    bits = ((bits & 0x00FF00FFu) << 8u) | ((bits & 0xFF00FF00u) >> 8u);
    return vec2((float(i) + 0.5) / float(n), float(bits >> 8u) / 16777216.0);
}

// Schlick 1994. The clamp is for v.h = 1 + rounding.
//! verify fresnel "Schlick, gold": F_Schlick(cosine, vec3(1.0, 0.71, 0.29))
//! verify fresnel "Schlick, glass": F_Schlick(cosine, vec3(0.04))
vec3 F_Schlick(float vh, vec3 f0) { return f0 + (1.0 - f0) * pow5(clamp(1.0 - vh, 0.0, 1.0)); }

// GGX, Walter et al. 2007. The sine comes from a cross product (Lagrange's identity): 1 - cos^2 has no digits left for a narrow lobe.
// h is any positive multiple of the half vector.
//! verify distribution "GGX, roughness 0.1", isotropic: D_GGX(n, m, 0.01)
//!     G1: G1_Smith(v.z, 0.01)
//!     sample: sample_GGX(u, 0.01)
//! verify distribution "GGX, roughness 0.5", isotropic: D_GGX(n, m, 0.25)
//!     G1: G1_Smith(v.z, 0.25)
//!     sample: sample_GGX(u, 0.25)
//! verify distribution "GGX, roughness 1", isotropic: D_GGX(n, m, 1.0)
//!     G1: G1_Smith(v.z, 1.0)
//!     sample: sample_GGX(u, 1.0)
float D_GGX(vec3 n, vec3 h, float a) {
    vec3 s = cross(n, h);
    float k = a * dot(h, h) / (dot(s, s) + square(a * dot(n, h)));
    return k * k / PI;
}

vec3 sample_GGX(vec2 u, float a) {
    vec2 slope = a * sqrt(u.x / (1.0 - u.x)) * vec2(cos(2.0 * PI * u.y), sin(2.0 * PI * u.y));
    return normalize(vec3(slope, 1.0));
}

// sqrt(a^2 + (1 - a^2) cos^2): cos + S is twice the projected area of the microsurface.
float S_GGX(float cosine, float a) { return sqrt(a * a + (1.0 - a * a) * cosine * cosine); }
float G1_Smith(float cosine, float a) { return 2.0 * cosine / (cosine + S_GGX(cosine, a)); }

// G / (4 n.v n.l), height-correlated: Heitz 2014, eq. 99.
float V_Smith(float nv, float nl, float a) { return 0.5 / (nl * S_GGX(nv, a) + nv * S_GGX(nl, a)); }

vec3 metal(vec3 n, vec3 v, vec3 l, vec3 f0, float a) {
    float nv = dot(n, v), nl = dot(n, l);
    if (nv <= 0.0 || nl <= 0.0) return vec3(0.0);
    vec3 h = v + l;
    return F_Schlick(0.5 * length(h), f0) * D_GGX(n, h, a) * V_Smith(nv, nl, a) * nl; // v.h = |v + l| / 2
}

// Visible normals by spherical caps, Dupuy and Benyoub 2023; tangent space.
void sample_metal(vec3 v, vec2 u, vec3 f0, float a, out vec3 l, out vec3 weight, out float pdf) {
    vec3 w = normalize(vec3(a * v.xy, v.z));
    float t = u.x * (1.0 + w.z), s = sqrt(t * (2.0 - t));
    vec3 c = w + vec3(s * cos(2.0 * PI * u.y), s * sin(2.0 * PI * u.y), 1.0 - t);
    vec3 m = normalize(vec3(a * c.xy, c.z));
    float vm = dot(v, m);
    l = 2.0 * vm * m - v;
    weight = vec3(0.0);
    pdf = 0.0;
    if (l.z <= 0.0) return;
    float Sv = S_GGX(v.z, a);
    weight = F_Schlick(vm, f0) * l.z * (v.z + Sv) / (l.z * Sv + v.z * S_GGX(l.z, a)); // F G2/G1
    pdf = D_GGX(vec3(0.0, 0.0, 1.0), m, a) / (2.0 * (v.z + Sv));
}

float pdf_metal(vec3 v, vec3 l, float a) {
    return v.z > 0.0 && l.z > 0.0 ? D_GGX(vec3(0.0, 0.0, 1.0), v + l, a) / (2.0 * (v.z + S_GGX(v.z, a))) : 0.0;
}

//! verify brdf "gold, roughness 0.1", isotropic: metal(n, v, l, vec3(1.0, 0.71, 0.29), 0.01)
//!     sample: sample_metal(v, u, vec3(1.0, 0.71, 0.29), 0.01, l, weight, pdf)
//!     pdf: pdf_metal(v, l, 0.01)
//! verify brdf "gold, roughness 0.5", isotropic: metal(n, v, l, vec3(1.0, 0.71, 0.29), 0.25)
//!     sample: sample_metal(v, u, vec3(1.0, 0.71, 0.29), 0.25, l, weight, pdf)
//!     pdf: pdf_metal(v, l, 0.25)
//! verify brdf "gold, roughness 1", isotropic: metal(n, v, l, vec3(1.0, 0.71, 0.29), 1.0)
//!     sample: sample_metal(v, u, vec3(1.0, 0.71, 0.29), 1.0, l, weight, pdf)
//!     pdf: pdf_metal(v, l, 1.0)
//! verify brdf "gold, roughness 0.5, oblique n", world space: metal(n, v, l, vec3(1.0, 0.71, 0.29), 0.25)

// The base gets what the surface leaves, seen from both sides: Ashikhmin and Shirley 2000, eq. 5.
vec3 dielectric(vec3 n, vec3 v, vec3 l, vec3 base, float f0, float a) {
    float nv = dot(n, v), nl = dot(n, l);
    if (nv <= 0.0 || nl <= 0.0) return vec3(0.0);
    vec3 diffuse = 28.0 / (23.0 * PI) * base * (1.0 - f0) * (1.0 - pow5(1.0 - 0.5 * nv)) * (1.0 - pow5(1.0 - 0.5 * nl));
    return diffuse * nl + metal(n, v, l, vec3(f0), a);
}

float pdf_dielectric(vec3 v, vec3 l, float a) { return 0.5 * pdf_metal(v, l, a) + 0.5 * max(l.z, 0.0) / PI; }

// One half of the samples from the surface, one from the base. The weight is f cos / pdf of both together.
void sample_dielectric(vec3 v, vec2 u, float a, out vec3 l, out float pdf) {
    vec3 unused_weight;
    if (u.x < 0.5) {
        sample_metal(v, vec2(2.0 * u.x, u.y), vec3(1.0), a, l, unused_weight, pdf);
    } else {
        float r = sqrt(2.0 * u.x - 1.0);
        l = vec3(r * cos(2.0 * PI * u.y), r * sin(2.0 * PI * u.y), sqrt(2.0 - 2.0 * u.x));
    }
    pdf = l.z > 0.0 ? pdf_dielectric(v, l, a) : 0.0;
}

//! verify brdf "white dielectric, roughness 0.1", isotropic: dielectric(n, v, l, vec3(1.0), 0.04, 0.01)
//!     sample: sample_dielectric(v, u, 0.01, l, pdf)
//!     pdf: pdf_dielectric(v, l, 0.01)
//! verify brdf "white dielectric, roughness 0.5", isotropic: dielectric(n, v, l, vec3(1.0), 0.04, 0.25)
//!     sample: sample_dielectric(v, u, 0.25, l, pdf)
//!     pdf: pdf_dielectric(v, l, 0.25)
//! verify brdf "white dielectric, roughness 1", isotropic: dielectric(n, v, l, vec3(1.0), 0.04, 1.0)
//!     sample: sample_dielectric(v, u, 1.0, l, pdf)
//!     pdf: pdf_dielectric(v, l, 1.0)

//! verify brdf "Lambert", lossless, isotropic: max(dot(n, l), 0.0) / PI
//!     sample: sample_lambert(u, l, weight, pdf)
//!     pdf: max(l.z, 0.0) / PI
void sample_lambert(vec2 u, out vec3 l, out float weight, out float pdf) {
    float r = sqrt(u.x);
    l = vec3(r * cos(2.0 * PI * u.y), r * sin(2.0 * PI * u.y), sqrt(1.0 - u.x));
    weight = 1.0;
    pdf = l.z / PI;
}
