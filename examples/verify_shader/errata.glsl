#version 450
// The misprints of docs/errata.md, each as the function that is printed and named after its id; beside it the right one, named _right.
// Every request fails, and its finding is the erratum. Replace Sx_y by Sx_y_right in a request, and it passes.
// The ids that no function of directions can show are listed at the end, with the reason.

const float PI = 3.14159265359;

float square(float x) { return x * x; }
float pow5(float x) { return square(square(x)) * x; }
float schlick(float f0, float vh) { return f0 + (1.0 - f0) * pow5(clamp(1.0 - vh, 0.0, 1.0)); }

// GGX by sine and cosine, its projected area twice, Smith's masking, and Beckmann's masking (Walter et al. 2007).
float D_GGX(vec3 h, float a) { return square(a * dot(h, h) / (dot(h.xy, h.xy) + square(a * h.z))) / PI; }
float S_GGX(float cosine, float a) { return sqrt(a * a + (1.0 - a * a) * cosine * cosine); }
float G1_GGX(float cosine, float a) { return 2.0 * cosine / (cosine + S_GGX(cosine, a)); }
float G2_GGX(float nv, float nl, float a) { return 2.0 * nv * nl / (nl * S_GGX(nv, a) + nv * S_GGX(nl, a)); }
float G1_Beckmann(float cosine, float a) {
    float c = cosine / (a * sqrt(max(0.0, 1.0 - cosine * cosine)));
    return c < 1.6 ? (3.535 * c + 2.181 * c * c) / (1.0 + 2.276 * c + 2.577 * c * c) : 1.0;
}

// D G F cos(theta_l) / (4 n.l n.v), and its parts for those who need them.
bool above(vec3 v, vec3 l) { return v.z > 0.0 && l.z > 0.0; }
float cos_of_half(vec3 v, vec3 l) { return 0.5 * length(v + l); } // v.h
float masked(vec3 v, vec3 l, float G, float a) { return above(v, l) ? D_GGX(v + l, a) * G / (4.0 * v.z) : 0.0; }
float lobe(vec3 v, vec3 l, float F, float a) { return F * masked(v, l, G2_GGX(v.z, l.z, a), a); }
float plastic(vec3 v, vec3 l, float a) { return lobe(v, l, schlick(0.04, cos_of_half(v, l)), a); }
float diffuse(vec3 v, vec3 l) { return above(v, l) ? l.z / PI : 0.0; }

// A direction by a normal with the density D cos(theta); w = G v.m / (n.v n.m) is the weight of F = 1. 0 where nothing is reflected.
float reflected(vec3 v, vec2 u, float a, out vec3 l, out float pdf) {
    vec2 slope = a * sqrt(u.x / (1.0 - u.x)) * vec2(cos(2.0 * PI * u.y), sin(2.0 * PI * u.y));
    vec3 m = normalize(vec3(slope, 1.0));
    float vm = dot(v, m);
    l = 2.0 * vm * m - v;
    bool reflects = vm > 0.0 && l.z > 0.0;
    pdf = reflects ? D_GGX(m, a) * m.z / (4.0 * vm) : 0.0;
    return reflects ? G2_GGX(v.z, l.z, a) * vm / (v.z * m.z) : 0.0;
}

// ---- 000: image-based light

//! verify distribution "S0-1: the bracket is not squared": S0_1(m.z, 0.1)
float S0_1(float c, float a) { return a * a / (PI * (c * c * (a * a - 1.0) + 1.0)); }
float S0_1_right(float c, float a) { return a * a / (PI * square(c * c * (a * a - 1.0) + 1.0)); }

// It is still normalised; the masking of its width shows it. (Blinn-Phong is near Beckmann: hence the tolerance.)
//! verify distribution "S0-2: exponent 2 a^2 - 2", tolerance 0.05: S0_2(m.z, 0.3)
//!     G1: G1_Beckmann(v.z, 0.3)
float S0_2(float c, float a) { return a * a / PI * pow(c, 2.0 * a * a - 2.0); }
float S0_2_right(float c, float a) { return 1.0 / (PI * a * a) * pow(c, 2.0 / (a * a) - 2.0); }

//! verify fresnel "S0-3: 1 - (v.h)^5": S0_3(cosine, 0.04)
float S0_3(float vh, float f0) { return f0 + (1.0 - f0) * (1.0 - pow5(vh)); }
float S0_3_right(float vh, float f0) { return f0 + (1.0 - f0) * pow5(1.0 - vh); }

//! verify brdf "S0-4: the height-correlated G": masked(v, l, S0_4(v.z, l.z, 0.1), 0.1)
float S0_4(float nv, float nl, float a) {
    float a2 = a * a;
    return 2.0 * nv / sqrt(nv + sqrt(a2 + (1.0 - a2) * nv)) * (2.0 * nl / sqrt(nl + sqrt(a2 + (1.0 - a2) * nl)));
}
float S0_4_right(float nv, float nl, float a) { return G2_GGX(nv, nl, a); }

//! verify brdf "S0-5: diffuse light by uniform samples": diffuse(v, l)
//!     sample: S0_5(u, l, weight, pdf)
void uniform_hemisphere(vec2 u, out vec3 l, out float pdf) {
    float z = 1.0 - u.x, sine = sqrt(u.x * (1.0 + z));
    l = vec3(sine * cos(2.0 * PI * u.y), sine * sin(2.0 * PI * u.y), z);
    pdf = 1.0 / (2.0 * PI);
}
void S0_5(vec2 u, out vec3 l, out float weight, out float pdf) { // the sum 1/(N pi) L
    uniform_hemisphere(u, l, pdf);
    weight = 1.0 / PI;
}
void S0_5_right(vec2 u, out vec3 l, out float weight, out float pdf) {
    uniform_hemisphere(u, l, pdf);
    weight = 2.0 * l.z;
}

//! verify brdf "S0-6: 1/(2 pi) as a density on the sphere": diffuse(v, l)
//!     sample: uniform_sphere(u, S0_6(), l, pdf)
//!     pdf: S0_6()
float S0_6() { return 1.0 / (2.0 * PI); }
float S0_6_right() { return 1.0 / (4.0 * PI); }
void uniform_sphere(vec2 u, float density, out vec3 l, out float pdf) {
    float z = 1.0 - 2.0 * u.x, sine = 2.0 * sqrt(u.x * (1.0 - u.x));
    l = vec3(sine * cos(2.0 * PI * u.y), sine * sin(2.0 * PI * u.y), z);
    pdf = z > 0.0 ? density : 0.0; // a sample below the surface has failed
}

//! verify brdf "S0-7: diffuse weight 1 - F(v.h)": S0_7(v, l, 0.04, 0.05)
float S0_7(vec3 v, vec3 l, float f0, float a) {
    float F = schlick(f0, cos_of_half(v, l));
    return (1.0 - F) * diffuse(v, l) + lobe(v, l, F, a);
}
float S0_7_right(vec3 v, vec3 l, float f0, float a) { // Ashikhmin and Shirley 2000
    float coupled = 28.0 / 23.0 * (1.0 - f0) * (1.0 - pow5(1.0 - 0.5 * v.z)) * (1.0 - pow5(1.0 - 0.5 * l.z));
    return coupled * diffuse(v, l) + lobe(v, l, schlick(f0, cos_of_half(v, l)), a);
}

// Every sample adds F0 (1 - Fc) w to the first term and Fc w to the second.
//! verify brdf "S0-8: the power in both split-sum terms": plastic(v, l, 0.3)
//!     sample: weight = reflected(v, u, 0.3, l, pdf), weight *= S0_8(0.04, cos_of_half(v, l))
float S0_8(float f0, float vh) {
    float Fc = 1.0 - pow5(vh);
    return f0 * (1.0 - Fc) + Fc;
}
float S0_8_right(float f0, float vh) {
    float Fc = pow5(1.0 - vh);
    return f0 * (1.0 - Fc) + Fc;
}

//! verify brdf "S0-9: the weight of a sample as the visibility": visible(v, l, S0_9(v, l, 0.3), 0.3)
float visible(vec3 v, vec3 l, float V, float a) { return above(v, l) ? D_GGX(v + l, a) * V * l.z : 0.0; }
float S0_9(vec3 v, vec3 l, float a) { return G2_GGX(v.z, l.z, a) * cos_of_half(v, l) / (v.z * normalize(v + l).z); }
float S0_9_right(vec3 v, vec3 l, float a) { return G2_GGX(v.z, l.z, a) / (4.0 * v.z * l.z); }

//! verify distribution "S0-13: D is the density of normals": D_GGX(m, 0.5)
//!     sample: normal_of_GGX(u, 0.5)
//!     pdf: S0_13(m, 0.5)
vec3 normal_of_GGX(vec2 u, float a) {
    float r = a * sqrt(u.x / (1.0 - u.x));
    return normalize(vec3(r * cos(2.0 * PI * u.y), r * sin(2.0 * PI * u.y), 1.0));
}
float S0_13(vec3 m, float a) { return D_GGX(m, a); }
float S0_13_right(vec3 m, float a) { return D_GGX(m, a) * m.z; }

// ---- 001: multiple scattering. For GGX of alpha 0.5: the split-sum terms, fitted to 1e-3, and what is added to the single scattering
// lobe(v, l, F, 0.5), which is "radiance"; light from l alone has the "irradiance" cos(theta_l)/pi. The weights look at v only.

float A_half(float mu) {
    float x = sqrt(max(mu, 0.0));
    return 0.9099 + x * (-0.1575 + x * (-1.1404 + x * (2.0271 + x * (-1.2107 + x * 0.2595))));
}
float B_half(float mu) {
    float x = sqrt(max(mu, 0.0));
    return 0.0939 + x * (-0.0001 + x * (-0.5023 + x * (0.6307 - x * 0.2222)));
}
float E_half(float mu) { return A_half(mu) + B_half(mu); }
float white(vec3 v, vec3 l) { return lobe(v, l, 1.0, 0.5); }

// Light from l adds to E radiance, and takes from (1 - E irradiance).
//! verify brdf "S1-1: (1 - E irradiance)", lossless, not reciprocal: white(v, l) + S1_1(E_half(v.z), diffuse(v, l))
float S1_1(float E, float irradiance) { return -E * irradiance; }
float S1_1_right(float E, float irradiance) { return (1.0 - E) * irradiance; }

//! verify brdf "S1-2: Fms without Fss E", lossless, not reciprocal: white(v, l) + S1_2(E_half(v.z), 1.0) * diffuse(v, l)
float S1_2(float E, float Favg) { return Favg / (1.0 - (1.0 - E) * Favg) * (1.0 - E); }           // Fms Ems
float S1_2_right(float E, float Favg) { return E * Favg / (1.0 - (1.0 - E) * Favg) * (1.0 - E); } // F = 1: Fss = 1

//! verify brdf "S1-3: Schlick's Fresnel with roughness, twice": lobe(v, l, S1_3(v.z, cos_of_half(v, l), 0.04, 0.7), 0.49)
float schlick_roughness(float nv, float f0, float roughness) { return f0 + (max(1.0 - roughness, f0) - f0) * pow5(1.0 - nv); }
float S1_3(float nv, float vh, float f0, float roughness) {
    float Fc = pow5(max(1.0 - vh, 0.0));
    return schlick_roughness(nv, f0, roughness) * (1.0 - Fc) + Fc;
}
float S1_3_right(float nv, float vh, float f0, float roughness) {
    float Fc = pow5(max(1.0 - vh, 0.0));
    return f0 * (1.0 - Fc) + Fc;
}

//! verify brdf "S1-5: irradiance without its 1/pi", lossless, not reciprocal: white(v, l) + (1.0 - E_half(v.z)) * S1_5(v, l)
float S1_5(vec3 v, vec3 l) { return above(v, l) ? l.z : 0.0; }
float S1_5_right(vec3 v, vec3 l) { return diffuse(v, l); }

// Over a white base; Fss E = F0 A + B.
//! verify brdf "S1-10: Ed = 1 - F0", lossless, not reciprocal: plastic(v, l, 0.5) + S1_10(v.z, 0.04) * diffuse(v, l)
float S1_10(float mu, float f0) {
    float Favg = (1.0 + 20.0 * f0) / 21.0, Ems = 1.0 - E_half(mu), FssE = f0 * A_half(mu) + B_half(mu);
    return FssE * Favg / (1.0 - Ems * Favg) * Ems + (1.0 - f0);
}
float S1_10_right(float mu, float f0) {
    float Favg = (1.0 + 20.0 * f0) / 21.0, Ems = 1.0 - E_half(mu), FssE = f0 * A_half(mu) + B_half(mu);
    float FmsEms = FssE * Favg / (1.0 - Ems * Favg) * Ems;
    return FmsEms + (1.0 - (FssE + FmsEms));
}

// ---- 002: direct light

// Roughness 0.25. This k is a model of its own: it says 4.6 times as much as Smith's area at n.v = 0.01; the printed one 7.7 times.
//! verify distribution "S2-1: k = alpha/2 with alpha = (r + 1)/2", tolerance 6.0: D_GGX(m, 0.0625)
//!     G1: G1_schlick(v.z, S2_1(0.25))
float G1_schlick(float cosine, float k) { return cosine / (cosine * (1.0 - k) + k); }
float S2_1(float r) { return (r + 1.0) / 2.0 / 2.0; }
float S2_1_right(float r) { return square(r + 1.0) / 8.0; }

//! verify fresnel "S2-3: F0 is the reflectance at 90 degrees": S2_3(cosine, 0.04)
float S2_3(float vh, float f0) { return f0 + (1.0 - f0) * pow5(vh); }
float S2_3_right(float vh, float f0) { return f0 + (1.0 - f0) * pow5(1.0 - vh); }

//! verify brdf "S2-4: Fresnel of n.v": lobe(v, l, S2_4(v, l), 0.3)
float S2_4(vec3 v, vec3 l) { return schlick(0.04, v.z); }
float S2_4_right(vec3 v, vec3 l) { return schlick(0.04, cos_of_half(v, l)); }

//! verify brdf "S2-10: k_d = (1 - F(h.v)) (1 - metallic)": S2_10(v, l, 0.0) * diffuse(v, l) + plastic(v, l, 0.1)
float S2_10(vec3 v, vec3 l, float metallic) { return (1.0 - schlick(0.04, cos_of_half(v, l))) * (1.0 - metallic); }
float S2_10_right(vec3 v, vec3 l, float metallic) {
    return 28.0 / 23.0 * 0.96 * (1.0 - pow5(1.0 - 0.5 * v.z)) * (1.0 - pow5(1.0 - 0.5 * l.z)) * (1.0 - metallic);
}

// ---- 003: indirect light

//! verify brdf "S3-2: 0.001 in the denominator of a weight": lobe(v, l, 1.0, 0.01)
//!     sample: S3_2(v, u, l, weight, pdf)
void S3_2_right(vec3 v, vec2 u, out vec3 l, out float weight, out float pdf) {
    weight = reflected(v, u, 0.01, l, pdf);
}
void S3_2(vec3 v, vec2 u, out vec3 l, out float weight, out float pdf) {
    S3_2_right(v, u, l, weight, pdf);
    if (pdf > 0.0) weight = G2_GGX(v.z, l.z, 0.01) * cos_of_half(v, l) / (v.z * normalize(v + l).z + 0.001);
}

//! verify fresnel "S3-2: 0.001 under the power": 0.04 + 0.96 * S3_2_power(cosine)
float S3_2_power(float vh) { return pow5(1.0 - vh + 0.001); }
float S3_2_power_right(float vh) { return pow5(1.0 - vh); }

//! verify brdf "S3-4: Fresnel of n.v in the estimator": plastic(v, l, 0.3)
//!     sample: weight = reflected(v, u, 0.3, l, pdf), weight *= S3_4(v, l)
float S3_4(vec3 v, vec3 l) { return schlick(0.04, v.z); }
float S3_4_right(vec3 v, vec3 l) { return schlick(0.04, cos_of_half(v, l)); }

// Roughness 0.5. The approximation itself is up to 16 % off Smith's.
//! verify distribution "S3-6: k = alpha^2/2 with alpha = r^2", tolerance 0.2: D_GGX(m, 0.25)
//!     G1: G1_schlick(v.z, S3_6(0.5))
float S3_6(float r) { return square(r * r) / 2.0; }
float S3_6_right(float r) { return r * r / 2.0; }

// The angles of a sum of 32 by 32 samples, as shares of their ranges.
//! verify sequence "S3-10: sums from 0 to n", points 1056, not evenly spread: S3_10(i, 32u)
vec2 S3_10(uint i, uint n) { return vec2(float(i % (n + 1u)) / float(n), float(i / (n + 1u)) / float(n + 1u)); }
vec2 S3_10_right(uint i, uint n) { return vec2(float(i % n) / float(n), float(i / n) / float(n + 1u)); }

//! verify brdf "S3-13: Schlick's Fresnel with roughness times A": plastic(v, l, 0.3)
//!     sample: weight = reflected(v, u, 0.3, l, pdf), weight *= S3_13(v, l, 0.04, sqrt(0.3))
float S3_13(vec3 v, vec3 l, float f0, float roughness) { return S1_3(v.z, cos_of_half(v, l), f0, roughness); }
float S3_13_right(vec3 v, vec3 l, float f0, float roughness) { return S1_3_right(v.z, cos_of_half(v, l), f0, roughness); }

// Of alpha 0.001, in float.
//! verify distribution "S3-14: sinTheta = sqrt(1 - cosTheta*cosTheta)": D_GGX(m, 0.001)
//!     sample: S3_14(u, 0.001)
vec3 S3_14(vec2 u, float a) {
    float cosine = sqrt((1.0 - u.x) / ((1.0 - u.x) + a * a * u.x)), sine = sqrt(1.0 - cosine * cosine);
    return vec3(sine * cos(2.0 * PI * u.y), sine * sin(2.0 * PI * u.y), cosine);
}
vec3 S3_14_right(vec2 u, float a) {
    float root = sqrt((1.0 - u.x) + a * a * u.x), cosine = sqrt(1.0 - u.x) / root, sine = a * sqrt(u.x) / root;
    return vec3(sine * cos(2.0 * PI * u.y), sine * sin(2.0 * PI * u.y), cosine);
}

// The last points of 2^32.
//! verify sequence "S3-15: float(bits) * 2^-32": vec2((float(i) + 0.5) / 1024.0, S3_15(reversed(4294967295u - i)))
uint reversed(uint i) {
    uint bits = (i << 16u) | (i >> 16u);
    bits = ((bits & 0x55555555u) << 1u) | ((bits & 0xAAAAAAAAu) >> 1u);
    bits = ((bits & 0x33333333u) << 2u) | ((bits & 0xCCCCCCCCu) >> 2u);
    bits = ((bits & 0x0F0F0F0Fu) << 4u) | ((bits & 0xF0F0F0F0u) >> 4u);
    return ((bits & 0x00FF00FFu) << 8u) | ((bits & 0xFF00FF00u) >> 8u);
}
float S3_15(uint bits) { return float(bits) * 2.3283064365386963e-10; }
float S3_15_right(uint bits) { return float(bits >> 8u) * 5.9604644775390625e-8; }

// ---- 004: distributions of normals

//! verify distribution "S4-1: a minus between the slopes": S4_1(m, 0.3, 0.6)
float S4_1(vec3 m, float ax, float ay) {
    float slope = sqrt(square(m.x / ax) - square(m.y / ay)) / m.z;
    return 1.0 / (PI * ax * ay * square(m.z * m.z * (1.0 + slope * slope)));
}
float S4_1_right(vec3 m, float ax, float ay) {
    return 1.0 / (PI * ax * ay * square(square(m.x / ax) + square(m.y / ay) + m.z * m.z));
}

// Beckmann of the rms slope 0.2, and the masking of the width that belongs to it. (Walter's fit of it: 0.4 %.)
//! verify distribution "S4-4: alpha = 2 sigma", tolerance 0.01: beckmann_of_sigma(m, 0.2)
//!     G1: G1_Beckmann(v.z, S4_4(0.2))
float beckmann_of_sigma(vec3 m, float sigma) {
    float c2 = max(m.z * m.z, 1.0e-6), tan2 = dot(m.xy, m.xy) / c2;
    return exp(-tan2 / (2.0 * sigma * sigma)) / (2.0 * PI * sigma * sigma * c2 * c2);
}
float S4_4(float sigma) { return 2.0 * sigma; }
float S4_4_right(float sigma) { return sqrt(2.0) * sigma; }

// At k = 1, the end of the range that is printed.
//! verify distribution "S4-5: widths r^2 (1 + k) and r^2 (1 - k)": S4_1_right(m, S4_5(0.5, 1.0).x, S4_5(0.5, 1.0).y)
vec2 S4_5(float r, float k) { return r * r * vec2(1.0 + k, 1.0 - k); }
vec2 S4_5_right(float r, float k) { // Burley 2012
    float aspect = sqrt(1.0 - 0.9 * k);
    return r * r * vec2(1.0 / aspect, aspect);
}

//! verify distribution "S4-6: the mobile GGX returns p^2": S4_6(m, 0.25)
float p_mobile(vec3 m, float a) { return a / (dot(m.xy, m.xy) + square(a * m.z)); }
float S4_6(vec3 m, float a) { return square(p_mobile(m, a)); }
float S4_6_right(vec3 m, float a) { return square(p_mobile(m, a)) / PI; }

//! verify distribution "S4-7: a clamp at 65504": S4_7(m, 0.001)
float S4_7(vec3 m, float a) { return min(square(p_mobile(m, a)) / PI, 65504.0); }
float S4_7_right(vec3 m, float a) { return square(p_mobile(m, a)) / PI; }

// Of alpha 0.001, in float.
//! verify distribution "S4-9: (NoH*a2 - NoH)*NoH + 1": S4_9(m, 0.001)
float S4_9(vec3 m, float a) {
    float a2 = a * a, d = (m.z * a2 - m.z) * m.z + 1.0;
    return a2 / (PI * d * d);
}
float S4_9_right(vec3 m, float a) { return square(a / (dot(m.xy, m.xy) + square(a * m.z))) / PI; }

// gamma = 1; the constant of gamma = 2, which is GGX.
//! verify distribution "S4-10: GTR with a constant c": S4_10(0.1) / (1.0 - (1.0 - 0.01) * m.z * m.z)
float S4_10(float a) { return a * a / PI; }
float S4_10_right(float a) { return (a * a - 1.0) / (PI * log(a * a)); }

// The exponent of alpha 1.2.
//! verify distribution "S4-15: the exponent 2/alpha^2 - 2 for any alpha": (S4_15(1.2) + 2.0) / (2.0 * PI) * pow(max(m.z, 0.0), S4_15(1.2))
float S4_15(float a) { return 2.0 / (a * a) - 2.0; }
float S4_15_right(float a) { return 2.0 / square(min(a, 0.99)) - 2.0; }

// ---- What no function of directions can show
//
// Does not compile, or is incomplete: S1-8, S2-6, S3-3, S3-7, S3-8, S3-9, S3-23.
// Words, names, notation, references: S0-10, S0-14, S0-15, S1-4, S1-9, S2-2, S2-7, S2-8, S3-5, S3-12, S3-17, S3-18, S3-19, S4-8, S4-11,
//     S4-14, S4-16, S4-17.
// A surface like any other, if not the one that is meant; to absorb more is no error: S0-11, S0-12, S2-5, S4-2, S4-3.
// What is made with a BRDF, its tables, pictures and units: S0-16, S1-6, S2-9, S3-11, S3-16, S3-22, S3-24, S3-25.
// Too rare or too small: S3-1 needs a roughness of 0; S3-20 moves one sample in 2^24; S3-21 shifts the energy by 5e-4.
// Claims: S1-7, "preserved exactly": S1_2_right without `not reciprocal` fails. S4-12, "not shape-invariant". S4-13, as S0-13.
