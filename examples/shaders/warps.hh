// Written by lobe 0.1.0
// Maps of the unit square and their inverses; u.x radial, u.y azimuthal, except in the concentric maps.
// Error in float: 3e-7.
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

inline vec2 square_to_uniform_disk(vec2 u) {
    const float t1 = sqrt(u.x);
    const float t2 = u.y < 0.125f ? 0.0f : 1.0f;
    const float t3 = u.y < 0.375f ? 0.0f : 1.0f;
    const float t4 = u.y < 0.625f ? 0.0f : 1.0f;
    const float t5 = u.y < 0.875f ? 0.0f : 1.0f;
    const float t6 = t2 + t3 + t4 + t5;
    const bool b1 = t6 == 1.0f;
    const bool b2 = t6 == 2.0f;
    const bool b3 = t6 == 3.0f;
    const bool b4 = b1 || b3;
    const float t7 = u.y - t6 * 0.25f;
    const float t8 = t7 * t7;
    const float t9 = -41.341675f + t8 * (81.59394f + t8 * -75.4534f);
    const float t10 = t7 * 6.2831855f + t7 * (-1.7484555e-07f + t8 * t9);
    const float t11 = 64.93932f + t8 * (-85.44374f + t8 * 59.245964f);
    const float t12 = 1.0f + t8 * (-19.739208f + t8 * t11);
    const float t13 = b4 ? t10 : t12;
    const float t14 = b1 || b2 ? -t13 : t13;
    const float t15 = b4 ? t12 : t10;
    const float t16 = b2 || b3 ? -t15 : t15;
    return vec2(t1 * t14, t1 * t16);
}

inline vec2 uniform_disk_to_square(vec2 p) {
    const float t1 = atan2(p.y, p.x) * 0.15915494f;
    const float t2 = t1 < 0.0f ? t1 + 1.0f : t1;
    const float t3 = t2 < 1.0f ? t2 : 0.0f;
    return vec2(p.x * p.x + p.y * p.y, t3);
}

inline vec2 square_to_uniform_disk_concentric(vec2 u) {
    const bool b1 = min(u.x, 1.0f - u.x) < min(u.y, 1.0f - u.y);
    const float t1 = 2.0f * u.x - 1.0f;
    const float t2 = 2.0f * u.y - 1.0f;
    const float t3 = b1 ? t1 : t2;
    const float t4 = b1 ? t2 : t1;
    const float t5 = t3 == 0.0f ? 1.0f : t3;
    const float t6 = t4 / t5 * 0.125f;
    const float t7 = t6 < 0.125f ? 0.0f : 1.0f;
    const float t8 = t6 < 0.375f ? 0.0f : 1.0f;
    const float t9 = t6 < 0.625f ? 0.0f : 1.0f;
    const float t10 = t6 < 0.875f ? 0.0f : 1.0f;
    const float t11 = t7 + t8 + t9 + t10;
    const bool b2 = t11 == 1.0f;
    const bool b3 = t11 == 2.0f;
    const bool b4 = t11 == 3.0f;
    const bool b5 = b2 || b4;
    const float t12 = t6 - t11 * 0.25f;
    const float t13 = t12 * t12;
    const float t14 = -41.341675f + t13 * (81.59394f + t13 * -75.4534f);
    const float t15 = t12 * 6.2831855f + t12 * (-1.7484555e-07f + t13 * t14);
    const float t16 = 64.93932f + t13 * (-85.44374f + t13 * 59.245964f);
    const float t17 = 1.0f + t13 * (-19.739208f + t13 * t16);
    const float t18 = b5 ? t15 : t17;
    const float t19 = b2 || b3 ? -t18 : t18;
    const float t20 = b5 ? t17 : t15;
    const float t21 = b3 || b4 ? -t20 : t20;
    const float t22 = b1 ? t19 : t21;
    const float t23 = b1 ? t21 : t19;
    return vec2(t3 * t22, t3 * t23);
}

inline vec3 square_to_uniform_hemisphere(vec2 u) {
    const float t1 = sqrt(u.x * (2.0f - u.x));
    const float t2 = u.y < 0.125f ? 0.0f : 1.0f;
    const float t3 = u.y < 0.375f ? 0.0f : 1.0f;
    const float t4 = u.y < 0.625f ? 0.0f : 1.0f;
    const float t5 = u.y < 0.875f ? 0.0f : 1.0f;
    const float t6 = t2 + t3 + t4 + t5;
    const bool b1 = t6 == 1.0f;
    const bool b2 = t6 == 2.0f;
    const bool b3 = t6 == 3.0f;
    const bool b4 = b1 || b3;
    const float t7 = u.y - t6 * 0.25f;
    const float t8 = t7 * t7;
    const float t9 = -41.341675f + t8 * (81.59394f + t8 * -75.4534f);
    const float t10 = t7 * 6.2831855f + t7 * (-1.7484555e-07f + t8 * t9);
    const float t11 = 64.93932f + t8 * (-85.44374f + t8 * 59.245964f);
    const float t12 = 1.0f + t8 * (-19.739208f + t8 * t11);
    const float t13 = b4 ? t10 : t12;
    const float t14 = b1 || b2 ? -t13 : t13;
    const float t15 = b4 ? t12 : t10;
    const float t16 = b2 || b3 ? -t15 : t15;
    return vec3(t1 * t14, t1 * t16, 1.0f - u.x);
}

inline vec2 uniform_hemisphere_to_square(vec3 w) {
    const float t1 = atan2(w.y, w.x) * 0.15915494f;
    const float t2 = t1 < 0.0f ? t1 + 1.0f : t1;
    const float t3 = t2 < 1.0f ? t2 : 0.0f;
    return vec2((w.x * w.x + w.y * w.y) / (1.0f + w.z), t3);
}

inline vec3 square_to_cosine_hemisphere(vec2 u) {
    const float t1 = sqrt(u.x);
    const float t2 = u.y < 0.125f ? 0.0f : 1.0f;
    const float t3 = u.y < 0.375f ? 0.0f : 1.0f;
    const float t4 = u.y < 0.625f ? 0.0f : 1.0f;
    const float t5 = u.y < 0.875f ? 0.0f : 1.0f;
    const float t6 = t2 + t3 + t4 + t5;
    const bool b1 = t6 == 1.0f;
    const bool b2 = t6 == 2.0f;
    const bool b3 = t6 == 3.0f;
    const bool b4 = b1 || b3;
    const float t7 = u.y - t6 * 0.25f;
    const float t8 = t7 * t7;
    const float t9 = -41.341675f + t8 * (81.59394f + t8 * -75.4534f);
    const float t10 = t7 * 6.2831855f + t7 * (-1.7484555e-07f + t8 * t9);
    const float t11 = 64.93932f + t8 * (-85.44374f + t8 * 59.245964f);
    const float t12 = 1.0f + t8 * (-19.739208f + t8 * t11);
    const float t13 = b4 ? t10 : t12;
    const float t14 = b1 || b2 ? -t13 : t13;
    const float t15 = b4 ? t12 : t10;
    const float t16 = b2 || b3 ? -t15 : t15;
    return vec3(t1 * t14, t1 * t16, sqrt(1.0f - u.x));
}

inline vec2 cosine_hemisphere_to_square(vec3 w) {
    const float t1 = atan2(w.y, w.x) * 0.15915494f;
    const float t2 = t1 < 0.0f ? t1 + 1.0f : t1;
    const float t3 = t2 < 1.0f ? t2 : 0.0f;
    return vec2(w.x * w.x + w.y * w.y, t3);
}

inline float cosine_hemisphere_pdf(vec3 w) {
    return max(w.z, 0.0f) * 0.31830987f;
}

}  // namespace shading
