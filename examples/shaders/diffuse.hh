// Written by lobe 0.1.0
// Diffuse models. albedo, roughness in [0,1].
// v, l: unit, in tangent space, n = (0,0,1), pointing away from the surface; 0 where one is below the horizon.
// u in [0,1)^2. A sample that fails has pdf = 0 and weight = 0.
#pragma once

#include <cmath>

#ifndef LOBE_SHADING_VECTORS
#define LOBE_SHADING_VECTORS
namespace shading {

struct vec2 {
    float x, y;
     vec2(float a, float b) : x(a), y(b) {}
};
struct vec3 {
    float x, y, z;
     vec3(float a, float b, float c) : x(a), y(b), z(c) {}
     explicit vec3(float a) : x(a), y(a), z(a) {}
};
 inline vec3 operator-(vec3 a) { return vec3(-a.x, -a.y, -a.z); }
 inline vec3 operator+(vec3 a, vec3 b) { return vec3(a.x + b.x, a.y + b.y, a.z + b.z); }
 inline vec3 operator+(vec3 a, float b) { return vec3(a.x + b, a.y + b, a.z + b); }
 inline vec3 operator+(float a, vec3 b) { return vec3(a + b.x, a + b.y, a + b.z); }
 inline vec3 operator-(vec3 a, vec3 b) { return vec3(a.x - b.x, a.y - b.y, a.z - b.z); }
 inline vec3 operator-(vec3 a, float b) { return vec3(a.x - b, a.y - b, a.z - b); }
 inline vec3 operator-(float a, vec3 b) { return vec3(a - b.x, a - b.y, a - b.z); }
 inline vec3 operator*(vec3 a, vec3 b) { return vec3(a.x * b.x, a.y * b.y, a.z * b.z); }
 inline vec3 operator*(vec3 a, float b) { return vec3(a.x * b, a.y * b, a.z * b); }
 inline vec3 operator*(float a, vec3 b) { return vec3(a * b.x, a * b.y, a * b.z); }
 inline vec3 operator/(vec3 a, vec3 b) { return vec3(a.x / b.x, a.y / b.y, a.z / b.z); }
 inline vec3 operator/(vec3 a, float b) { return vec3(a.x / b, a.y / b, a.z / b); }
 inline vec3 operator/(float a, vec3 b) { return vec3(a / b.x, a / b.y, a / b.z); }
 inline float dot(vec3 a, vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
 inline float max(float a, float b) { return a < b ? b : a; }
 inline float min(float a, float b) { return b < a ? b : a; }
using std::abs;
 inline vec3 abs(vec3 a) { return vec3(abs(a.x), abs(a.y), abs(a.z)); }
using std::sqrt;
 inline vec3 sqrt(vec3 a) { return vec3(sqrt(a.x), sqrt(a.y), sqrt(a.z)); }
using std::exp;
 inline vec3 exp(vec3 a) { return vec3(exp(a.x), exp(a.y), exp(a.z)); }
using std::exp2;
 inline vec3 exp2(vec3 a) { return vec3(exp2(a.x), exp2(a.y), exp2(a.z)); }
using std::expm1;
 inline vec3 expm1(vec3 a) { return vec3(expm1(a.x), expm1(a.y), expm1(a.z)); }
using std::log;
 inline vec3 log(vec3 a) { return vec3(log(a.x), log(a.y), log(a.z)); }
using std::log2;
 inline vec3 log2(vec3 a) { return vec3(log2(a.x), log2(a.y), log2(a.z)); }
using std::log1p;
 inline vec3 log1p(vec3 a) { return vec3(log1p(a.x), log1p(a.y), log1p(a.z)); }
using std::sin;
 inline vec3 sin(vec3 a) { return vec3(sin(a.x), sin(a.y), sin(a.z)); }
using std::cos;
 inline vec3 cos(vec3 a) { return vec3(cos(a.x), cos(a.y), cos(a.z)); }
using std::tanh;
 inline vec3 tanh(vec3 a) { return vec3(tanh(a.x), tanh(a.y), tanh(a.z)); }
using std::acos;
 inline vec3 acos(vec3 a) { return vec3(acos(a.x), acos(a.y), acos(a.z)); }
using std::erfc;
 inline vec3 erfc(vec3 a) { return vec3(erfc(a.x), erfc(a.y), erfc(a.z)); }
using std::floor;
 inline vec3 floor(vec3 a) { return vec3(floor(a.x), floor(a.y), floor(a.z)); }
 inline vec3 max(vec3 a, vec3 b) { return vec3(max(a.x, b.x), max(a.y, b.y), max(a.z, b.z)); }
 inline vec3 min(vec3 a, vec3 b) { return vec3(min(a.x, b.x), min(a.y, b.y), min(a.z, b.z)); }
using std::pow;
 inline vec3 pow(vec3 a, vec3 b) { return vec3(pow(a.x, b.x), pow(a.y, b.y), pow(a.z, b.z)); }
using std::atan2;
 inline vec3 atan2(vec3 a, vec3 b) { return vec3(atan2(a.x, b.x), atan2(a.y, b.y), atan2(a.z, b.z)); }

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

inline evaluation3 lambert_evaluate(vec3 v, vec3 l, vec3 albedo) {
    const float t1 = v.z > 8.6736174e-19f && l.z > 8.6736174e-19f ? l.z * 0.31830987f : 0.0f;
    return {albedo * t1, t1};
}

inline direction_sample3 lambert_sample(vec3 v, vec2 u, vec3 albedo) {
    const float t1 = sqrt(1.0f - u.x);
    const bool b1 = v.z > 8.6736174e-19f && t1 > 8.6736174e-19f;
    const float t2 = sqrt(u.x);
    const float t3 = u.y < 0.125f ? 0.0f : 1.0f;
    const float t4 = u.y < 0.375f ? 0.0f : 1.0f;
    const float t5 = u.y < 0.625f ? 0.0f : 1.0f;
    const float t6 = u.y < 0.875f ? 0.0f : 1.0f;
    const float t7 = t3 + t4 + t5 + t6;
    const bool b2 = t7 == 1.0f;
    const bool b3 = t7 == 2.0f;
    const bool b4 = t7 == 3.0f;
    const bool b5 = b2 || b4;
    const float t8 = u.y - t7 * 0.25f;
    const float t9 = t8 * t8;
    const float t10 = -41.341675f + t9 * (81.59394f + t9 * -75.4534f);
    const float t11 = t8 * 6.2831855f + t8 * (-1.7484555e-07f + t9 * t10);
    const float t12 = 64.93932f + t9 * (-85.44374f + t9 * 59.245964f);
    const float t13 = 1.0f + t9 * (-19.739208f + t9 * t12);
    const float t14 = b5 ? t11 : t13;
    const float t15 = b2 || b3 ? -t14 : t14;
    const float t16 = b1 ? t2 * t15 : 0.0f;
    const float t17 = b5 ? t13 : t11;
    const float t18 = b3 || b4 ? -t17 : t17;
    const float t19 = b1 ? t2 * t18 : 0.0f;
    const float t20 = b1 ? t1 : 1.0f;
    const float t21 = b1 ? 1.0f : 0.0f;
    return {vec3(t16, t19, t20), albedo * t21, b1 ? t1 * 0.31830987f : 0.0f};
}

inline evaluation3 eon_evaluate(vec3 v, vec3 l, vec3 albedo, float roughness) {
    const bool b1 = v.z > 8.6736174e-19f && l.z > 8.6736174e-19f;
    const float t1 = 1.0f / (1.0f + 0.2877934f * roughness);
    const float t2 = v.x * l.x + v.y * l.y;
    const bool b2 = t2 > 0.0f;
    const float t3 = max(max(v.z, l.z), 8.6736174e-19f);
    const float t4 = b2 ? t3 : 1.0f;
    const float t5 = l.z * 0.31830987f;
    const float t6 = t1 * max(1.0f + roughness * t2 / t4, 0.0f) * t5;
    const float t7 = b1 ? t6 : 0.0f;
    const float t8 = roughness * t1;
    const vec3 w1 = albedo * albedo * ((t1 + t8 * 0.07248825f) * t8 / 0.2153052f);
    const float t9 = v.x * v.x + v.y * v.y;
    const float t10 = sqrt(t9);
    const float t11 = 1.0f / (1.0f + t10);
    const float t12 = t10 * (t10 - 0.6666667f * (1.0f + t10 * t10 * t11));
    const float t13 = t10 * atan2(v.z, t10) + v.z * (0.9041297f * v.z * t11 + t12);
    const float t14 = sqrt(l.x * l.x + l.y * l.y);
    const float t15 = 1.0f / (1.0f + t14);
    const float t16 = t14 * (t14 - 0.6666667f * (1.0f + t14 * t14 * t15));
    const float t17 = t14 * atan2(l.z, t14) + l.z * (0.9041297f * l.z * t15 + t16);
    const float t18 = b1 ? t13 * 0.31830987f * (t17 * 0.31830987f) * t5 : 0.0f;
    const vec3 w2 = w1 / (1.0f - albedo * (t8 * 0.2153052f)) * t18;
    const float t19 = b2 && t14 > 0.0f ? t2 / t14 : 0.0f;
    const float t20 = roughness * 0.9f * t2 + roughness * t19 * (1.0f / t3 - 1.0f);
    const float t21 = roughness * t10 * (t9 / (1.0f + abs(v.z))) * 0.31830987f;
    return {albedo * t7 + w2, b1 ? t5 * ((1.0f + t20) / (1.0f + t21)) : 0.0f};
}

inline direction_sample3 eon_sample(vec3 v, vec2 u, vec3 albedo, float roughness) {
    const float t1 = v.x * v.x + v.y * v.y;
    const float t2 = sqrt(t1);
    const float t3 = abs(v.z);
    const float t4 = t1 / (1.0f + t3);
    const float t5 = roughness * t2 * t4 * 0.31830987f;
    const float t6 = 1.0f + t5;
    const float t7 = t5 / t6;
    const bool b1 = u.x < t7;
    const float t8 = b1 ? 0.0f : t7;
    const float t9 = b1 ? t7 : 1.0f;
    const float t10 = t9 - t8;
    const float t11 = (u.x - t8) / t10;
    const bool b2 = t11 < t4;
    const float t12 = (t9 - u.x) / t10;
    const float t13 = b2 ? t3 + t4 * t12 : t4 + t3 * t11;
    const float t14 = b2 ? t4 * t11 : t3 * t12;
    const float t15 = sqrt(t14);
    const float t16 = t13 / (1.0f + t15);
    const float t17 = b2 ? t16 : t15;
    const float t18 = roughness * 0.9f;
    const float t19 = t18 * t2;
    const float t20 = sqrt(t11);
    const float t21 = u.y < 0.125f ? 0.0f : 1.0f;
    const float t22 = u.y < 0.375f ? 0.0f : 1.0f;
    const float t23 = u.y < 0.625f ? 0.0f : 1.0f;
    const float t24 = u.y < 0.875f ? 0.0f : 1.0f;
    const float t25 = t21 + t22 + t23 + t24;
    const bool b3 = t25 == 1.0f;
    const bool b4 = t25 == 2.0f;
    const bool b5 = t25 == 3.0f;
    const bool b6 = b3 || b5;
    const float t26 = u.y - t25 * 0.25f;
    const float t27 = t26 * t26;
    const float t28 = -41.341675f + t27 * (81.59394f + t27 * -75.4534f);
    const float t29 = t26 * 6.2831855f + t26 * (-1.7484555e-07f + t27 * t28);
    const float t30 = 64.93932f + t27 * (-85.44374f + t27 * 59.245964f);
    const float t31 = 1.0f + t27 * (-19.739208f + t27 * t30);
    const float t32 = b6 ? t29 : t31;
    const float t33 = b3 || b4 ? -t32 : t32;
    const float t34 = t20 * t33;
    const float t35 = 1.0f + t19 * t34;
    const float t36 = sqrt(t35 * t35 + t19 * t19 * t12);
    const float t37 = b1 ? t17 : sqrt(2.0f * t12 / (t35 + t36));
    const bool b7 = v.z > 8.6736174e-19f && t37 > 8.6736174e-19f;
    const bool b8 = t1 > 1.1754944e-38f;
    const float t38 = b8 ? v.x / t2 : 1.0f;
    const float t39 = b2 ? t15 : t16;
    const float t40 = sqrt(t39 * (1.0f + t17));
    const float t41 = (2.0f * t34 + t19 * (t34 * t34 + t12)) / (1.0f + t36);
    const float t42 = b1 ? 2.0f * t40 * sqrt(u.y * (1.0f - u.y)) : t41;
    const float t43 = b8 ? v.y / t2 : 0.0f;
    const float t44 = b6 ? t31 : t29;
    const float t45 = b4 || b5 ? -t44 : t44;
    const float t46 = b1 ? t40 * (2.0f * u.y - 1.0f) : t20 * t45;
    const float t47 = t38 * t42 - t43 * t46;
    const float t48 = b7 ? t47 : 0.0f;
    const float t49 = t43 * t42 + t38 * t46;
    const float t50 = b7 ? t49 : 0.0f;
    const float t51 = b7 ? t37 : 1.0f;
    const float t52 = 1.0f / (1.0f + 0.2877934f * roughness);
    const float t53 = v.x * t47 + v.y * t49;
    const bool b9 = t53 > 0.0f;
    const float t54 = max(max(v.z, t37), 8.6736174e-19f);
    const float t55 = b9 ? t54 : 1.0f;
    const float t56 = t52 * max(1.0f + roughness * t53 / t55, 0.0f);
    const float t57 = sqrt(t47 * t47 + t49 * t49);
    const float t58 = b9 && t57 > 0.0f ? t53 / t57 : 0.0f;
    const float t59 = t18 * t53 + roughness * t58 * (1.0f / t54 - 1.0f);
    const float t60 = (1.0f + t59) / t6;
    const float t61 = b7 ? 1.0f / t60 : 0.0f;
    const float t62 = b7 ? t56 * t61 : 0.0f;
    const float t63 = roughness * t52;
    const vec3 w1 = albedo * albedo * ((t52 + t63 * 0.07248825f) * t63 / 0.2153052f);
    const float t64 = 1.0f / (1.0f + t2);
    const float t65 = t2 * (t2 - 0.6666667f * (1.0f + t2 * t2 * t64));
    const float t66 = t2 * atan2(v.z, t2) + v.z * (0.9041297f * v.z * t64 + t65);
    const float t67 = 1.0f / (1.0f + t57);
    const float t68 = t57 * (t57 - 0.6666667f * (1.0f + t57 * t57 * t67));
    const float t69 = t57 * atan2(t37, t57) + t37 * (0.9041297f * t37 * t67 + t68);
    const float t70 = t66 * 0.31830987f * (t69 * 0.31830987f) * t61;
    const float t71 = b7 ? t70 : 0.0f;
    const vec3 w2 = w1 / (1.0f - albedo * (t63 * 0.2153052f)) * t71;
    return {vec3(t48, t50, t51), albedo * t62 + w2, b7 ? t37 * 0.31830987f * t60 : 0.0f};
}

inline evaluation3 burley_evaluate(vec3 v, vec3 l, vec3 albedo, float roughness) {
    const bool b1 = v.z > 8.6736174e-19f && l.z > 8.6736174e-19f;
    const float t1 = 0.5f + roughness * (1.0f + dot(v, l)) - 1.0f;
    const float t2 = 1.0f - l.z;
    const float t3 = t2 * t2;
    const float t4 = 1.0f - v.z;
    const float t5 = t4 * t4;
    const float t6 = (1.0f + t1 * (t3 * t3 * t2)) * (1.0f + t1 * (t5 * t5 * t4));
    const float t7 = l.z * 0.31830987f;
    const float t8 = b1 ? t6 * t7 : 0.0f;
    return {albedo * t8, b1 ? t7 : 0.0f};
}

inline direction_sample3 burley_sample(vec3 v, vec2 u, vec3 albedo, float roughness) {
    const float t1 = sqrt(1.0f - u.x);
    const bool b1 = v.z > 8.6736174e-19f && t1 > 8.6736174e-19f;
    const float t2 = sqrt(u.x);
    const float t3 = u.y < 0.125f ? 0.0f : 1.0f;
    const float t4 = u.y < 0.375f ? 0.0f : 1.0f;
    const float t5 = u.y < 0.625f ? 0.0f : 1.0f;
    const float t6 = u.y < 0.875f ? 0.0f : 1.0f;
    const float t7 = t3 + t4 + t5 + t6;
    const bool b2 = t7 == 1.0f;
    const bool b3 = t7 == 2.0f;
    const bool b4 = t7 == 3.0f;
    const bool b5 = b2 || b4;
    const float t8 = u.y - t7 * 0.25f;
    const float t9 = t8 * t8;
    const float t10 = -41.341675f + t9 * (81.59394f + t9 * -75.4534f);
    const float t11 = t8 * 6.2831855f + t8 * (-1.7484555e-07f + t9 * t10);
    const float t12 = 64.93932f + t9 * (-85.44374f + t9 * 59.245964f);
    const float t13 = 1.0f + t9 * (-19.739208f + t9 * t12);
    const float t14 = b5 ? t11 : t13;
    const float t15 = b2 || b3 ? -t14 : t14;
    const float t16 = t2 * t15;
    const float t17 = b1 ? t16 : 0.0f;
    const float t18 = b5 ? t13 : t11;
    const float t19 = b3 || b4 ? -t18 : t18;
    const float t20 = t2 * t19;
    const float t21 = b1 ? t20 : 0.0f;
    const float t22 = b1 ? t1 : 1.0f;
    const float t23 = roughness * (1.0f + (v.x * t16 + v.y * t20 + v.z * t1));
    const float t24 = 0.5f + t23 - 1.0f;
    const float t25 = 1.0f - t1;
    const float t26 = t25 * t25;
    const float t27 = 1.0f - v.z;
    const float t28 = t27 * t27;
    const float t29 = (1.0f + t24 * (t26 * t26 * t25)) * (1.0f + t24 * (t28 * t28 * t27));
    const float t30 = b1 ? 1.0f : 0.0f;
    const float t31 = b1 ? t29 * t30 : 0.0f;
    return {vec3(t17, t21, t22), albedo * t31, b1 ? t1 * 0.31830987f : 0.0f};
}

inline evaluation3 burley_frostbite_evaluate(vec3 v, vec3 l, vec3 albedo, float roughness) {
    const bool b1 = v.z > 8.6736174e-19f && l.z > 8.6736174e-19f;
    const float t1 = roughness * (0.5f + (1.0f + dot(v, l))) - 1.0f;
    const float t2 = 1.0f - l.z;
    const float t3 = t2 * t2;
    const float t4 = 1.0f - v.z;
    const float t5 = t4 * t4;
    const float t6 = (1.0f + t1 * (t3 * t3 * t2)) * (1.0f + t1 * (t5 * t5 * t4));
    const float t7 = l.z * 0.31830987f;
    const float t8 = b1 ? t6 * (1.0f + -0.33774835f * roughness) * t7 : 0.0f;
    return {albedo * t8, b1 ? t7 : 0.0f};
}

inline direction_sample3 burley_frostbite_sample(vec3 v, vec2 u, vec3 albedo, float roughness) {
    const float t1 = sqrt(1.0f - u.x);
    const bool b1 = v.z > 8.6736174e-19f && t1 > 8.6736174e-19f;
    const float t2 = sqrt(u.x);
    const float t3 = u.y < 0.125f ? 0.0f : 1.0f;
    const float t4 = u.y < 0.375f ? 0.0f : 1.0f;
    const float t5 = u.y < 0.625f ? 0.0f : 1.0f;
    const float t6 = u.y < 0.875f ? 0.0f : 1.0f;
    const float t7 = t3 + t4 + t5 + t6;
    const bool b2 = t7 == 1.0f;
    const bool b3 = t7 == 2.0f;
    const bool b4 = t7 == 3.0f;
    const bool b5 = b2 || b4;
    const float t8 = u.y - t7 * 0.25f;
    const float t9 = t8 * t8;
    const float t10 = -41.341675f + t9 * (81.59394f + t9 * -75.4534f);
    const float t11 = t8 * 6.2831855f + t8 * (-1.7484555e-07f + t9 * t10);
    const float t12 = 64.93932f + t9 * (-85.44374f + t9 * 59.245964f);
    const float t13 = 1.0f + t9 * (-19.739208f + t9 * t12);
    const float t14 = b5 ? t11 : t13;
    const float t15 = b2 || b3 ? -t14 : t14;
    const float t16 = t2 * t15;
    const float t17 = b1 ? t16 : 0.0f;
    const float t18 = b5 ? t13 : t11;
    const float t19 = b3 || b4 ? -t18 : t18;
    const float t20 = t2 * t19;
    const float t21 = b1 ? t20 : 0.0f;
    const float t22 = b1 ? t1 : 1.0f;
    const float t23 = 0.5f + (1.0f + (v.x * t16 + v.y * t20 + v.z * t1));
    const float t24 = roughness * t23 - 1.0f;
    const float t25 = 1.0f - t1;
    const float t26 = t25 * t25;
    const float t27 = 1.0f - v.z;
    const float t28 = t27 * t27;
    const float t29 = (1.0f + t24 * (t26 * t26 * t25)) * (1.0f + t24 * (t28 * t28 * t27));
    const float t30 = b1 ? 1.0f : 0.0f;
    const float t31 = t29 * (1.0f + -0.33774835f * roughness) * t30;
    const float t32 = b1 ? t31 : 0.0f;
    return {vec3(t17, t21, t22), albedo * t32, b1 ? t1 * 0.31830987f : 0.0f};
}

}  // namespace shading
