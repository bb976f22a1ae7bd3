// Written by lobe 0.1.0
// Specular anti-aliasing: alpha widened by what normals do within a pixel or a texel.
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

// alpha'^2 = alpha^2 + 2 variance of slopes: Olano & Baker 2010.
inline float widened(float alpha, float variance) {
    return sqrt(alpha * alpha + 2.0f * variance);
}

// Tokuyoshi & Kaplanyan 2021, listing 5; dn_dx, dn_dy: derivatives of the shading normal, per pixel.
inline float widened_by_pixel(float alpha, vec3 dn_dx, vec3 dn_dy) {
    const float t1 = alpha * alpha;
    const float t2 = (dot(dn_dx, dn_dx) + dot(dn_dy, dn_dy)) * 0.07957747f;
    const float t3 = min(t1 + min(2.0f * t2, 0.18f), max(t1, 1.0f));
    return sqrt(t3);
}

// Toksvig 2005.
inline float toksvig_variance(float length_of_mean_normal) {
    return max(1.0f - length_of_mean_normal, 0.0f) / length_of_mean_normal;
}

}  // namespace shading
