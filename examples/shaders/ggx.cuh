// Written by lobe 0.1.0
// ggx smith_correlated schlick: the microfacet BRDF, isotropic and anisotropic.
// v, l: unit, in tangent space, n = (0,0,1), pointing away from the surface; 0 where one is below the horizon.
// u in [0,1)^2. A sample that fails has pdf = 0 and weight = 0.
// alpha in [1e-4,1], F0 in [0,1], linear. Error in float: 20 ULP of f_cos and pdf.
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

struct evaluation3 {
    vec3 f_cos;
    float pdf;
};

struct direction_sample3 {
    vec3 l;
    vec3 weight;
    float pdf;
};

struct dfg_terms {
    float scale;
    float bias;
};

__host__ __device__ inline evaluation3 ggx_evaluate(vec3 v, vec3 l, float alpha, vec3 F0) {
    const vec3 w1 = v + l;
    const float t1 = w1.x * w1.x + w1.y * w1.y;
    const float t2 = abs(w1.z);
    const float t3 = t1 + t2 * t2;
    const float t4 = 1.0f - min(sqrt(t3) * 0.5f, 1.0f);
    const float t5 = t4 * t4;
    const bool b1 = v.z > 8.6736174e-19f && l.z > 8.6736174e-19f;
    const float t6 = alpha * t2;
    const float t7 = t1 + t6 * t6;
    const float t8 = t7 > 0.0f ? alpha * t3 / t7 : 0.0f;
    const float t9 = 0.31830987f * (t8 * t8) * 0.25f;
    const float t10 = alpha * v.x;
    const float t11 = alpha * v.y;
    const float t12 = sqrt(t10 * t10 + t11 * t11 + v.z * v.z) + v.z;
    const float t13 = t12 * 0.5f;
    const float t14 = alpha * l.x;
    const float t15 = alpha * l.y;
    const float t16 = sqrt(t14 * t14 + t15 * t15 + l.z * l.z) + l.z;
    const float t17 = t9 * l.z / (t13 * l.z + (t16 * 0.5f - l.z) * v.z);
    const float t18 = b1 ? t17 : 0.0f;
    return {(F0 + (1.0f - F0) * (t5 * t5 * t4)) * t18, b1 ? t9 / t13 : 0.0f};
}

__host__ __device__ inline direction_sample3 ggx_sample(vec3 v, vec2 u, float alpha, vec3 F0) {
    const float t1 = alpha * v.x;
    const float t2 = alpha * v.y;
    const float t3 = t1 * t1 + t2 * t2;
    const float t4 = abs(v.z);
    const float t5 = sqrt(t3 + t4 * t4);
    const float t6 = t5 + abs(t4);
    const float t7 = (1.0f - u.x) * t6;
    const float t8 = sqrt(u.x * (t6 * t7 + t3));
    const float t9 = u.y < 0.125f ? 0.0f : 1.0f;
    const float t10 = u.y < 0.375f ? 0.0f : 1.0f;
    const float t11 = u.y < 0.625f ? 0.0f : 1.0f;
    const float t12 = u.y < 0.875f ? 0.0f : 1.0f;
    const float t13 = t9 + t10 + t11 + t12;
    const bool b1 = t13 == 1.0f;
    const bool b2 = t13 == 2.0f;
    const bool b3 = t13 == 3.0f;
    const bool b4 = b1 || b3;
    const float t14 = u.y - t13 * 0.25f;
    const float t15 = t14 * t14;
    const float t16 = -41.341675f + t15 * (81.59394f + t15 * -75.4534f);
    const float t17 = t14 * 6.2831855f + t14 * (-1.7484555e-07f + t15 * t16);
    const float t18 = 64.93932f + t15 * (-85.44374f + t15 * 59.245964f);
    const float t19 = 1.0f + t15 * (-19.739208f + t15 * t18);
    const float t20 = b4 ? t17 : t19;
    const float t21 = b1 || b2 ? -t20 : t20;
    const float t22 = alpha * (t8 * t21 + t1);
    const float t23 = b4 ? t19 : t17;
    const float t24 = b2 || b3 ? -t23 : t23;
    const float t25 = alpha * (t8 * t24 + t2);
    const float t26 = v.x * t22 + v.y * t25 + t4 * t7;
    const float t27 = t22 * t22 + t25 * t25;
    const float t28 = 2.0f * t26 / max(t27 + t7 * t7, 1.1754944e-38f);
    const float t29 = t28 * t7 - t4;
    const float t30 = abs(t7);
    const float t31 = alpha * t30;
    const float t32 = t27 + t31 * t31;
    const float t33 = t32 > 0.0f ? alpha * (t27 + t30 * t30) / t32 : 0.0f;
    const float t34 = (t5 + t4) * 0.5f;
    const float t35 = 0.31830987f * (t33 * t33) / (4.0f * t34);
    const bool b5 = v.z > 8.6736174e-19f && t29 > 8.6736174e-19f && t35 > 0.0f;
    const float t36 = t28 * t22 - v.x;
    const float t37 = b5 ? t36 : 0.0f;
    const float t38 = t28 * t25 - v.y;
    const float t39 = b5 ? t38 : 0.0f;
    const float t40 = b5 ? t29 : 1.0f;
    const float t41 = b5 ? min(sqrt(t26 * t28 * 0.5f), 1.0f) : 1.0f;
    const float t42 = 1.0f - t41;
    const float t43 = t42 * t42;
    const float t44 = alpha * t36;
    const float t45 = alpha * t38;
    const float t46 = sqrt(t44 * t44 + t45 * t45 + t29 * t29) + t29;
    const float t47 = t29 * t34 / (t34 * t29 + (t46 * 0.5f - t29) * t4);
    const float t48 = b5 ? t47 : 0.0f;
    return {vec3(t37, t39, t40), (F0 + (1.0f - F0) * (t43 * t43 * t42)) * t48, b5 ? t35 : 0.0f};
}

// Split-sum terms of isotropic GGX with smith_correlated: the albedo is F0 scale + F90 bias.
// Domain: cos_v in [0.001,1], alpha in [0.0009,1]. Error: 1.1e-3, rms 5e-4.
__host__ __device__ inline dfg_terms ggx_dfg(float cos_v, float alpha) {
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

__host__ __device__ inline evaluation3 ggx_xy_evaluate(vec3 v, vec3 l, float alpha_x, float alpha_y, vec3 F0) {
    const vec3 w1 = v + l;
    const float t1 = w1.x * w1.x;
    const float t2 = w1.y * w1.y;
    const float t3 = abs(w1.z);
    const float t4 = t3 * t3;
    const float t5 = t1 + t2 + t4;
    const float t6 = 1.0f - min(sqrt(t5) * 0.5f, 1.0f);
    const float t7 = t6 * t6;
    const bool b1 = v.z > 8.6736174e-19f && l.z > 8.6736174e-19f;
    const float t8 = alpha_y / alpha_x * t1 + alpha_x / alpha_y * t2;
    const float t9 = alpha_x * alpha_y;
    const float t10 = t8 + t9 * t4;
    const float t11 = t10 > 0.0f ? t5 / t10 : 0.0f;
    const float t12 = 0.31830987f * (t11 * t11 * t9) * 0.25f;
    const float t13 = alpha_x * v.x;
    const float t14 = alpha_y * v.y;
    const float t15 = sqrt(t13 * t13 + t14 * t14 + v.z * v.z) + v.z;
    const float t16 = t15 * 0.5f;
    const float t17 = alpha_x * l.x;
    const float t18 = alpha_y * l.y;
    const float t19 = sqrt(t17 * t17 + t18 * t18 + l.z * l.z) + l.z;
    const float t20 = t12 * l.z / (t16 * l.z + (t19 * 0.5f - l.z) * v.z);
    const float t21 = b1 ? t20 : 0.0f;
    return {(F0 + (1.0f - F0) * (t7 * t7 * t6)) * t21, b1 ? t12 / t16 : 0.0f};
}

__host__ __device__ inline direction_sample3 ggx_xy_sample(vec3 v, vec2 u, float alpha_x, float alpha_y, vec3 F0) {
    const float t1 = alpha_x * v.x;
    const float t2 = alpha_y * v.y;
    const float t3 = t1 * t1 + t2 * t2;
    const float t4 = abs(v.z);
    const float t5 = sqrt(t3 + t4 * t4);
    const float t6 = t5 + abs(t4);
    const float t7 = (1.0f - u.x) * t6;
    const float t8 = sqrt(u.x * (t6 * t7 + t3));
    const float t9 = u.y < 0.125f ? 0.0f : 1.0f;
    const float t10 = u.y < 0.375f ? 0.0f : 1.0f;
    const float t11 = u.y < 0.625f ? 0.0f : 1.0f;
    const float t12 = u.y < 0.875f ? 0.0f : 1.0f;
    const float t13 = t9 + t10 + t11 + t12;
    const bool b1 = t13 == 1.0f;
    const bool b2 = t13 == 2.0f;
    const bool b3 = t13 == 3.0f;
    const bool b4 = b1 || b3;
    const float t14 = u.y - t13 * 0.25f;
    const float t15 = t14 * t14;
    const float t16 = -41.341675f + t15 * (81.59394f + t15 * -75.4534f);
    const float t17 = t14 * 6.2831855f + t14 * (-1.7484555e-07f + t15 * t16);
    const float t18 = 64.93932f + t15 * (-85.44374f + t15 * 59.245964f);
    const float t19 = 1.0f + t15 * (-19.739208f + t15 * t18);
    const float t20 = b4 ? t17 : t19;
    const float t21 = b1 || b2 ? -t20 : t20;
    const float t22 = alpha_x * (t8 * t21 + t1);
    const float t23 = b4 ? t19 : t17;
    const float t24 = b2 || b3 ? -t23 : t23;
    const float t25 = alpha_y * (t8 * t24 + t2);
    const float t26 = v.x * t22 + v.y * t25 + t4 * t7;
    const float t27 = t22 * t22;
    const float t28 = t25 * t25;
    const float t29 = t27 + t28;
    const float t30 = 2.0f * t26 / max(t29 + t7 * t7, 1.1754944e-38f);
    const float t31 = t30 * t7 - t4;
    const float t32 = alpha_y / alpha_x * t27 + alpha_x / alpha_y * t28;
    const float t33 = alpha_x * alpha_y;
    const float t34 = abs(t7);
    const float t35 = t34 * t34;
    const float t36 = t32 + t33 * t35;
    const float t37 = t36 > 0.0f ? (t29 + t35) / t36 : 0.0f;
    const float t38 = (t5 + t4) * 0.5f;
    const float t39 = 0.31830987f * (t37 * t37 * t33) / (4.0f * t38);
    const bool b5 = v.z > 8.6736174e-19f && t31 > 8.6736174e-19f && t39 > 0.0f;
    const float t40 = t30 * t22 - v.x;
    const float t41 = b5 ? t40 : 0.0f;
    const float t42 = t30 * t25 - v.y;
    const float t43 = b5 ? t42 : 0.0f;
    const float t44 = b5 ? t31 : 1.0f;
    const float t45 = b5 ? min(sqrt(t26 * t30 * 0.5f), 1.0f) : 1.0f;
    const float t46 = 1.0f - t45;
    const float t47 = t46 * t46;
    const float t48 = alpha_x * t40;
    const float t49 = alpha_y * t42;
    const float t50 = sqrt(t48 * t48 + t49 * t49 + t31 * t31) + t31;
    const float t51 = t31 * t38 / (t38 * t31 + (t50 * 0.5f - t31) * t4);
    const float t52 = b5 ? t51 : 0.0f;
    return {vec3(t41, t43, t44), (F0 + (1.0f - F0) * (t47 * t47 * t46)) * t52, b5 ? t39 : 0.0f};
}

}  // namespace shading
