// The forms that tutorials print, in float, on GLM, for comparison only: the guards, clamps, powers and cancelling
// differences are theirs. Sources name the equation; the way to write it is that of the shader listings in circulation.
#pragma once

#include "inputs.hpp"

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <cmath>

namespace textbook {

using glm::vec2, glm::vec3;
inline constexpr float pi = 3.14159265358979f;

/// Trowbridge & Reitz 1975; Walter et al. 2007, eq. 33.
inline float ggx(float NoH, float a) {
    const float a2 = a * a;
    const float d = (NoH * NoH) * (a2 - 1.0f) + 1.0f;
    return a2 / (pi * d * d);
}

/// Burley 2012, eq. 13.
inline float ggx_anisotropic(const vec3& h, float ax, float ay) {
    const float x = h.x / ax, y = h.y / ay;
    const float d = x * x + y * y + h.z * h.z;
    return 1.0f / (pi * ax * ay * d * d);
}

/// Heitz 2014, eq. 99, as a visibility.
inline float visibility_correlated(float NoV, float NoL, float a) {
    const float a2 = a * a;
    const float shadow_v = NoL * std::sqrt(NoV * NoV * (1.0f - a2) + a2);
    const float shadow_l = NoV * std::sqrt(NoL * NoL * (1.0f - a2) + a2);
    return 0.5f / (shadow_v + shadow_l);
}

/// Hammon 2017, "PBR Diffuse Lighting for GGX+Smith Microsurfaces": approximates the correlated form.
inline float visibility_hammon(float NoV, float NoL, float a) {
    const float product = 2.0f * NoL * NoV, sum = NoL + NoV;
    return 0.5f / (product * (1.0f - a) + sum * a);
}

/// Walter et al. 2007, eq. 34.
inline float G1(float NoX, float a) {
    const float a2 = a * a;
    return 2.0f * NoX / (NoX + std::sqrt(a2 + (1.0f - a2) * NoX * NoX));
}

/// Smith 1967; Walter et al. 2007, eq. 23.
inline float visibility_separable(float NoV, float NoL, float a) {
    return G1(NoV, a) * G1(NoL, a) / (4.0f * NoV * NoL);
}

/// Schlick 1994; Karis 2013, k = alpha/2: approximates the separable form.
inline float schlick_ggx(float NoX, float k) { return NoX / (NoX * (1.0f - k) + k); }
inline float visibility_schlick_ggx(float NoV, float NoL, float a) {
    return schlick_ggx(NoV, a / 2.0f) * schlick_ggx(NoL, a / 2.0f) / (4.0f * NoV * NoL);
}

/// Schlick 1994, eq. 15.
template <class Spectrum>
inline Spectrum schlick(const Spectrum& F0, float u) {
    return F0 + (Spectrum(1.0f) - F0) * std::pow(1.0f - u, 5.0f);
}

/// The same with products for the power, as engines write it.
inline vec3 schlick_products(const vec3& F0, float u) {
    const float w = 1.0f - u, w2 = w * w;
    return F0 + (vec3(1.0f) - F0) * (w2 * w2 * w);
}

struct cosines {
    vec3 h;
    float NoV, NoL, NoH, VoH;
    cosines(const vec3& v, const vec3& l)
        : h(glm::normalize(v + l)), NoV(std::max(v.z, 1e-4f)), NoL(std::max(l.z, 0.0f)), NoH(std::max(h.z, 0.0f)),
          VoH(std::max(glm::dot(v, h), 0.0f)) {}
};

/// F D V cos, V in its closed form.
template <auto Fresnel = schlick_products>
inline vec3 f_cos(const vec3& v, const vec3& l, float a, const vec3& F0) {
    const cosines c(v, l);
    return Fresnel(F0, c.VoH) * (ggx(c.NoH, a) * visibility_correlated(c.NoV, c.NoL, a) * c.NoL);
}

/// Cook & Torrance 1982 with all its cosines: D F G / (4 NoV NoL + 0.001) cos.
inline vec3 f_cos_guarded(const vec3& v, const vec3& l, float a, const vec3& F0) {
    const cosines c(v, l);
    const float a2 = a * a;
    const float G = 2.0f * c.NoL * c.NoV /
                    std::max(c.NoL * std::sqrt(c.NoV * c.NoV * (1.0f - a2) + a2) +
                                 c.NoV * std::sqrt(c.NoL * c.NoL * (1.0f - a2) + a2),
                             1e-4f);
    return ggx(c.NoH, a) * schlick(F0, c.VoH) * G / (4.0f * c.NoV * c.NoL + 0.001f) * c.NoL;
}

/// Density of light directions, visible normals: G1 D VoH / NoV / (4 VoH). Heitz 2018.
inline float pdf_visible(const cosines& c, float a) {
    return G1(c.NoV, a) * ggx(c.NoH, a) * c.VoH / c.NoV / (4.0f * c.VoH);
}

/// ... all normals: D NoH / (4 VoH). Walter et al. 2007, eq. 24, 38.
inline float pdf_all(const cosines& c, float a) { return ggx(c.NoH, a) * c.NoH / (4.0f * c.VoH); }

struct sampled {
    vec3 l, weight;
    float pdf;
};

inline sampled reflect_and_weigh(const vec3& v, const vec3& h, float a, const vec3& F0, bool visible) {
    const vec3 l = 2.0f * glm::dot(v, h) * h - v;
    const float NoV = v.z, NoL = l.z, NoH = h.z, VoH = glm::dot(v, h);
    if (NoL <= 0.0f || VoH <= 0.0f) return {vec3(0.0f, 0.0f, 1.0f), vec3(0.0f), 0.0f};
    const float a2 = a * a;
    const float G = 2.0f * NoL * NoV /
                    (NoL * std::sqrt(NoV * NoV * (1.0f - a2) + a2) + NoV * std::sqrt(NoL * NoL * (1.0f - a2) + a2));
    const vec3 F = schlick_products(F0, VoH);
    if (visible) return {l, F * (G / G1(NoV, a)), G1(NoV, a) * ggx(NoH, a) / (4.0f * NoV)};
    return {l, F * (G * VoH / (NoV * NoH)), ggx(NoH, a) * NoH / (4.0f * VoH)};
}

/// Heitz 2018, "Sampling the GGX Distribution of Visible Normals", listing 1.
inline sampled sample_visible(const vec3& v, const vec2& u, float a, const vec3& F0) {
    const vec3 Vh = glm::normalize(vec3(a * v.x, a * v.y, v.z));
    const float lensq = Vh.x * Vh.x + Vh.y * Vh.y;
    const vec3 T1 = lensq > 0.0f ? vec3(-Vh.y, Vh.x, 0.0f) / std::sqrt(lensq) : vec3(1.0f, 0.0f, 0.0f);
    const vec3 T2 = glm::cross(Vh, T1);
    const float r = std::sqrt(u.x), phi = 2.0f * pi * u.y;
    const float t1 = r * std::cos(phi), s = 0.5f * (1.0f + Vh.z);
    const float t2 = (1.0f - s) * std::sqrt(1.0f - t1 * t1) + s * (r * std::sin(phi));
    const vec3 Nh = t1 * T1 + t2 * T2 + std::sqrt(std::max(0.0f, 1.0f - t1 * t1 - t2 * t2)) * Vh;
    return reflect_and_weigh(v, glm::normalize(vec3(a * Nh.x, a * Nh.y, std::max(0.0f, Nh.z))), a, F0, true);
}

/// Walter et al. 2007, eq. 35-36, as Karis 2013 prints it.
inline vec3 ggx_normal(const vec2& u, float a) {
    const float phi = 2.0f * pi * u.y;
    const float cosine = std::sqrt((1.0f - u.x) / (1.0f + (a * a - 1.0f) * u.x));
    const float sine = std::sqrt(1.0f - cosine * cosine);
    return {sine * std::cos(phi), sine * std::sin(phi), cosine};
}

inline sampled sample_all(const vec3& v, const vec2& u, float a, const vec3& F0) {
    return reflect_and_weigh(v, ggx_normal(u, a), a, F0, false);
}

/// Van der Corput 1935, as Dammertz prints it.
inline float radical_inverse(std::uint32_t bits) {
    bits = (bits << 16) | (bits >> 16);
    bits = ((bits & 0x55555555u) << 1) | ((bits & 0xAAAAAAAAu) >> 1);
    bits = ((bits & 0x33333333u) << 2) | ((bits & 0xCCCCCCCCu) >> 2);
    bits = ((bits & 0x0F0F0F0Fu) << 4) | ((bits & 0xF0F0F0F0u) >> 4);
    bits = ((bits & 0x00FF00FFu) << 8) | ((bits & 0xFF00FF00u) >> 8);
    return static_cast<float>(bits) * 2.3283064365386963e-10f;
}
inline vec2 hammersley(std::uint32_t i, std::uint32_t N) {
    return {static_cast<float>(i) / static_cast<float>(N), radical_inverse(i)};
}

/// Karis 2013, "Real Shading in Unreal Engine 4": the split sum by Monte Carlo, one entry of the table.
inline vec2 integrate_brdf(float NoV, float a, std::uint32_t samples) {
    const vec3 v(std::sqrt(1.0f - NoV * NoV), 0.0f, NoV);
    vec2 sum(0.0f);
    for (std::uint32_t i = 0; i < samples; ++i) {
        const vec3 h = ggx_normal(hammersley(i, samples), a);
        const vec3 l = 2.0f * glm::dot(v, h) * h - v;
        const float NoL = std::max(l.z, 0.0f), NoH = std::max(h.z, 0.0f), VoH = std::max(glm::dot(v, h), 0.0f);
        if (NoL > 0.0f) {
            const float G = schlick_ggx(NoV, a / 2.0f) * schlick_ggx(NoL, a / 2.0f);
            const float G_vis = G * VoH / (NoH * NoV);
            const float Fc = std::pow(1.0f - VoH, 5.0f);
            sum += vec2((1.0f - Fc) * G_vis, Fc * G_vis);
        }
    }
    return sum / static_cast<float>(samples);
}

inline textbook_table bake(int size, std::uint32_t samples) {
    textbook_table table{size, {}, {}};
    for (int row = 0; row < size; ++row) {
        const float roughness = (static_cast<float>(row) + 0.5f) / static_cast<float>(size);
        for (int column = 0; column < size; ++column) {
            const vec2 t = integrate_brdf((static_cast<float>(column) + 0.5f) / static_cast<float>(size),
                                          roughness * roughness, samples);
            table.scale.push_back(t.x);
            table.bias.push_back(t.y);
        }
    }
    return table;
}

/// What a texture unit does with it: bilinear, clamped to the edge.
inline vec2 read(const textbook_table& table, float NoV, float a) {
    const float last = static_cast<float>(table.size - 1);
    const float x = std::clamp(NoV * static_cast<float>(table.size) - 0.5f, 0.0f, last);
    const float y = std::clamp(std::sqrt(a) * static_cast<float>(table.size) - 0.5f, 0.0f, last);
    const int column = std::min(static_cast<int>(x), table.size - 2),
              row = std::min(static_cast<int>(y), table.size - 2);
    const float tx = x - static_cast<float>(column), ty = y - static_cast<float>(row);
    const auto at = [&](const float* corner) {
        const float low = corner[0] * (1.0f - tx) + corner[1] * tx;
        const float high = corner[table.size] * (1.0f - tx) + corner[table.size + 1] * tx;
        return low * (1.0f - ty) + high * ty;
    };
    const int corner = row * table.size + column;
    return {at(table.scale.data() + corner), at(table.bias.data() + corner)};
}

/// Karis 2014, "Physically Based Shading on Mobile": a fit of the same split sum.
inline vec2 karis_mobile(float NoV, float a) {
    const float roughness = std::sqrt(a);
    const glm::vec4 c0(-1.0f, -0.0275f, -0.572f, 0.022f), c1(1.0f, 0.0425f, 1.04f, -0.04f);
    const glm::vec4 r = roughness * c0 + c1;
    const float a004 = std::min(r.x * r.x, std::exp2(-9.28f * NoV)) * r.x + r.y;
    return {-1.04f * a004 + r.z, 1.04f * a004 + r.w};
}

}  // namespace textbook
