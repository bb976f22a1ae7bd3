// Written by lobe 0.1.0
// Split-sum terms of isotropic GGX with smith_correlated, four fits, and image-based light with all bounces.
// Domain: cos_v in [0.001,1], alpha in [0.0009,1]. Error of the albedo: tiny 2.8e-2, cheap 1.6e-2, medium 4.6e-3,
// precise 1.1e-3.
#pragma once

#include <cmath>

#ifndef LOBE_SHADING_VECTORS
#define LOBE_SHADING_VECTORS
namespace shading {

struct vec2 {
    float x, y;
    __host__ __device__ vec2(float a, float b) : x(a), y(b) {}
};
struct vec3 {
    float x, y, z;
    __host__ __device__ vec3(float a, float b, float c) : x(a), y(b), z(c) {}
    __host__ __device__ explicit vec3(float a) : x(a), y(a), z(a) {}
};
__host__ __device__ inline vec3 operator-(vec3 a) { return vec3(-a.x, -a.y, -a.z); }
__host__ __device__ inline vec3 operator+(vec3 a, vec3 b) { return vec3(a.x + b.x, a.y + b.y, a.z + b.z); }
__host__ __device__ inline vec3 operator+(vec3 a, float b) { return vec3(a.x + b, a.y + b, a.z + b); }
__host__ __device__ inline vec3 operator+(float a, vec3 b) { return vec3(a + b.x, a + b.y, a + b.z); }
__host__ __device__ inline vec3 operator-(vec3 a, vec3 b) { return vec3(a.x - b.x, a.y - b.y, a.z - b.z); }
__host__ __device__ inline vec3 operator-(vec3 a, float b) { return vec3(a.x - b, a.y - b, a.z - b); }
__host__ __device__ inline vec3 operator-(float a, vec3 b) { return vec3(a - b.x, a - b.y, a - b.z); }
__host__ __device__ inline vec3 operator*(vec3 a, vec3 b) { return vec3(a.x * b.x, a.y * b.y, a.z * b.z); }
__host__ __device__ inline vec3 operator*(vec3 a, float b) { return vec3(a.x * b, a.y * b, a.z * b); }
__host__ __device__ inline vec3 operator*(float a, vec3 b) { return vec3(a * b.x, a * b.y, a * b.z); }
__host__ __device__ inline vec3 operator/(vec3 a, vec3 b) { return vec3(a.x / b.x, a.y / b.y, a.z / b.z); }
__host__ __device__ inline vec3 operator/(vec3 a, float b) { return vec3(a.x / b, a.y / b, a.z / b); }
__host__ __device__ inline vec3 operator/(float a, vec3 b) { return vec3(a / b.x, a / b.y, a / b.z); }
__host__ __device__ inline float dot(vec3 a, vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
__host__ __device__ inline float max(float a, float b) { return a < b ? b : a; }
__host__ __device__ inline float min(float a, float b) { return b < a ? b : a; }
using std::abs;
__host__ __device__ inline vec3 abs(vec3 a) { return vec3(abs(a.x), abs(a.y), abs(a.z)); }
using std::sqrt;
__host__ __device__ inline vec3 sqrt(vec3 a) { return vec3(sqrt(a.x), sqrt(a.y), sqrt(a.z)); }
using std::exp;
__host__ __device__ inline vec3 exp(vec3 a) { return vec3(exp(a.x), exp(a.y), exp(a.z)); }
using std::exp2;
__host__ __device__ inline vec3 exp2(vec3 a) { return vec3(exp2(a.x), exp2(a.y), exp2(a.z)); }
using std::expm1;
__host__ __device__ inline vec3 expm1(vec3 a) { return vec3(expm1(a.x), expm1(a.y), expm1(a.z)); }
using std::log;
__host__ __device__ inline vec3 log(vec3 a) { return vec3(log(a.x), log(a.y), log(a.z)); }
using std::log2;
__host__ __device__ inline vec3 log2(vec3 a) { return vec3(log2(a.x), log2(a.y), log2(a.z)); }
using std::log1p;
__host__ __device__ inline vec3 log1p(vec3 a) { return vec3(log1p(a.x), log1p(a.y), log1p(a.z)); }
using std::sin;
__host__ __device__ inline vec3 sin(vec3 a) { return vec3(sin(a.x), sin(a.y), sin(a.z)); }
using std::cos;
__host__ __device__ inline vec3 cos(vec3 a) { return vec3(cos(a.x), cos(a.y), cos(a.z)); }
using std::tanh;
__host__ __device__ inline vec3 tanh(vec3 a) { return vec3(tanh(a.x), tanh(a.y), tanh(a.z)); }
using std::acos;
__host__ __device__ inline vec3 acos(vec3 a) { return vec3(acos(a.x), acos(a.y), acos(a.z)); }
using std::erfc;
__host__ __device__ inline vec3 erfc(vec3 a) { return vec3(erfc(a.x), erfc(a.y), erfc(a.z)); }
using std::floor;
__host__ __device__ inline vec3 floor(vec3 a) { return vec3(floor(a.x), floor(a.y), floor(a.z)); }
__host__ __device__ inline vec3 max(vec3 a, vec3 b) { return vec3(max(a.x, b.x), max(a.y, b.y), max(a.z, b.z)); }
__host__ __device__ inline vec3 min(vec3 a, vec3 b) { return vec3(min(a.x, b.x), min(a.y, b.y), min(a.z, b.z)); }
using std::pow;
__host__ __device__ inline vec3 pow(vec3 a, vec3 b) { return vec3(pow(a.x, b.x), pow(a.y, b.y), pow(a.z, b.z)); }
using std::atan2;
__host__ __device__ inline vec3 atan2(vec3 a, vec3 b) { return vec3(atan2(a.x, b.x), atan2(a.y, b.y), atan2(a.z, b.z)); }

}  // namespace shading
#endif

namespace shading {

struct dfg_terms {
    float scale;
    float bias;
};

struct ibl_weights3 {
    vec3 radiance;
    vec3 irradiance;
};

__host__ __device__ inline dfg_terms dfg_tiny(float cos_v, float alpha) {
    const float t1 = alpha * alpha;
    const float t2 = cos_v + (5.9148107f * alpha + 1.3126427f) * alpha;
    const float t3 = t2 + 0.0072317305f;
    const float t4 = cos_v * t1 * (0.8215735f + 19.310698f * t1) * t3;
    const float t5 = t1 * alpha;
    const float t6 = cos_v * cos_v * cos_v + 21.320505f * t5 * cos_v;
    const float t7 = t6 + 6.755714f * t5;
    const float t8 = 1.0f / (t7 * t3);
    const float t9 = 1.0f - t4 * t8;
    const float t10 = (1.0574776f * cos_v + 1.3323929f * alpha) * cos_v;
    const float t11 = t10 + (3.0923212f * alpha + 0.03739872f) * alpha;
    const float t12 = 1.0f - t11 * t7 * t8;
    const float t13 = t12 * t12;
    const float t14 = t9 * (t13 * t13 * t12);
    return {t9 - t14, t14};
}

__host__ __device__ inline dfg_terms dfg_cheap(float cos_v, float alpha) {
    const float t1 = alpha * alpha;
    const float t2 = 0.4657219f + 9.989591f * t1 + 2.117033f * alpha * cos_v * cos_v;
    const float t3 = cos_v + (5.9148107f * alpha + 1.3126427f) * alpha;
    const float t4 = t3 + 0.0072317305f;
    const float t5 = t1 * alpha;
    const float t6 = cos_v * cos_v * cos_v + 13.935205f * t5 * cos_v;
    const float t7 = t6 + 2.885303f * t5;
    const float t8 = 1.0f / (t7 * t4);
    const float t9 = 1.0f - cos_v * t1 * t2 * t4 * t8;
    const float t10 = (1.0574776f * cos_v + 1.3323929f * alpha) * cos_v;
    const float t11 = t10 + (3.0923212f * alpha + 0.03739872f) * alpha;
    const float t12 = 1.0f - t11 * t7 * t8;
    const float t13 = t12 * t12;
    const float t14 = t9 * (t13 * t13 * t12);
    return {t9 - t14, t14};
}

__host__ __device__ inline dfg_terms dfg_medium(float cos_v, float alpha) {
    const float t1 = alpha * alpha;
    const float t2 = t1 * alpha;
    const float t3 = t1 * t1;
    const float t4 = 19.25841f * t2 + 0.2791325f - 4.4412456f * t3 * cos_v;
    const float t5 = cos_v * t1 * (t4 * cos_v + 6.3986063f * t1 + 0.7755784f);
    const float t6 = cos_v + (7.78157f * alpha + 3.184543f) * alpha;
    const float t7 = sqrt(alpha);
    const float t8 = (1.8398677f * alpha + 3.3001425f) * t7 + 0.4379561f;
    const float t9 = t6 * cos_v + t8 * (alpha * t7);
    const float t10 = (cos_v + 8.408655f * t3) * cos_v + (17.736061f * t1 + 3.5498514f) * t1;
    const float t11 = (0.5351705f * t1 - 1.9557374f) * alpha + 2.9557564f;
    const float t12 = t10 * cos_v + t11 * t2;
    const float t13 = 1.0f / (t12 * t9);
    const float t14 = 1.0f - t5 * t9 * t13;
    const float t15 = (1.007147f * cos_v + 3.2703702f * alpha) * cos_v;
    const float t16 = (t15 + 6.58987f * t1) * cos_v + 2.587197f * (t1 * t7);
    const float t17 = 1.0f - t16 * t12 * t13;
    const float t18 = t17 * t17;
    const float t19 = t14 * (t18 * t18 * t17);
    return {t14 - t19, t19};
}

__host__ __device__ inline dfg_terms dfg_precise(float cos_v, float alpha) {
    const float t1 = alpha * alpha;
    const float t2 = (-80.92356f * alpha + 159.31013f) * alpha - 68.58001f;
    const float t3 = (13.252991f * alpha + 47.883152f) * alpha + 23.356142f;
    const float t4 = (t2 * alpha + 23.680496f) * alpha * cos_v + (t3 * t1 + 3.272493f);
    const float t5 = t4 * cos_v + (3.1924329f * alpha - 0.30789798f) * alpha;
    const float t6 = sqrt(alpha);
    const float t7 = (3.574554f * t6 + 2.947536f) * t6 + 1.1579635f;
    const float t8 = (0.71944004f * alpha + 0.6703227f) * t6 + 0.06690896f;
    const float t9 = (cos_v + t7 * alpha) * cos_v + t8 * (alpha * t6);
    const float t10 = (4.6752467f - alpha) * cos_v + 19.079456f * t1;
    const float t11 = (24.166279f * alpha + 86.77667f) * t1 + 11.586927f;
    const float t12 = ((t10 + 0.16968752f) * cos_v + t11 * t1) * cos_v;
    const float t13 = (22.483315f * alpha + 10.312562f) * alpha + 0.39994174f;
    const float t14 = (t12 + t13 * t1) * cos_v + 0.4846967f * (t1 * alpha);
    const float t15 = 1.0f / (t14 * t9);
    const float t16 = 1.0f - cos_v * t1 * (t5 + 0.1134351f) * t9 * t15;
    const float t17 = (-1.996815f * t6 + 2.612494f) * alpha + 1.4740415f;
    const float t18 = (0.9968305f * cos_v + t17 * alpha) * cos_v + 4.242914f * t1;
    const float t19 = t18 * cos_v + (0.2249494f * t6 + 0.43820956f) * (t1 * t6);
    const float t20 = 1.0f - t19 * t14 * t15;
    const float t21 = t20 * t20;
    const float t22 = t16 * (t21 * t21 * t20);
    return {t16 - t22, t22};
}

// radiance: of the prefiltered environment, irradiance: of irradiance/pi.
__host__ __device__ inline ibl_weights3 ibl_all_bounces(float cos_v, float alpha, vec3 F0) {
    const float t1 = alpha * alpha;
    const float t2 = (-80.92356f * alpha + 159.31013f) * alpha - 68.58001f;
    const float t3 = (13.252991f * alpha + 47.883152f) * alpha + 23.356142f;
    const float t4 = (t2 * alpha + 23.680496f) * alpha * cos_v + (t3 * t1 + 3.272493f);
    const float t5 = t4 * cos_v + (3.1924329f * alpha - 0.30789798f) * alpha;
    const float t6 = sqrt(alpha);
    const float t7 = (3.574554f * t6 + 2.947536f) * t6 + 1.1579635f;
    const float t8 = (0.71944004f * alpha + 0.6703227f) * t6 + 0.06690896f;
    const float t9 = (cos_v + t7 * alpha) * cos_v + t8 * (alpha * t6);
    const float t10 = (4.6752467f - alpha) * cos_v + 19.079456f * t1;
    const float t11 = (24.166279f * alpha + 86.77667f) * t1 + 11.586927f;
    const float t12 = ((t10 + 0.16968752f) * cos_v + t11 * t1) * cos_v;
    const float t13 = (22.483315f * alpha + 10.312562f) * alpha + 0.39994174f;
    const float t14 = (t12 + t13 * t1) * cos_v + 0.4846967f * (t1 * alpha);
    const float t15 = 1.0f / (t14 * t9);
    const float t16 = 1.0f - cos_v * t1 * (t5 + 0.1134351f) * t9 * t15;
    const float t17 = (-1.996815f * t6 + 2.612494f) * alpha + 1.4740415f;
    const float t18 = (0.9968305f * cos_v + t17 * alpha) * cos_v + 4.242914f * t1;
    const float t19 = t18 * cos_v + (0.2249494f * t6 + 0.43820956f) * (t1 * t6);
    const float t20 = 1.0f - t19 * t14 * t15;
    const float t21 = t20 * t20;
    const float t22 = t16 * (t21 * t21 * t20);
    const float t23 = t16 - t22;
    const float t24 = 1.0f - (t23 + t22);
    const float t25 = exp(-2.75f * pow(alpha, 0.65f) - 1.59f * cos_v);
    const vec3 w1 = F0 + (1.0f - F0) * t25;
    const float t26 = t24 * (0.49f + 0.19f * t24);
    const vec3 w2 = t24 * w1 * w1 * (1.0f - t26) / (1.0f - t26 * w1);
    const float t27 = min(max((alpha - 0.1f) * 5.0f, 0.0f), 1.0f);
    const float t28 = t27 * t27 * (3.0f - 2.0f * t27);
    return {F0 * t23 + t22 + w2 * (1.0f - t28), w2 * t28};
}

}  // namespace shading
