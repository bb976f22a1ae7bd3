// Hand-written loops' bodies: floats in, floats out, for what GGX needs above the horizon. The fewest instructions that
// give what lobe's functions give, zero below the horizon included, with no type, no concept and no guard of a divisor:
// instructions.sh prints lobe's count over theirs.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

namespace limit {

inline constexpr float pi = 3.14159265358979f;

struct direction {
    float x, y, z;
};
struct rgb {
    float r, g, b;
};
struct evaluated {
    rgb f_cos;
    float pdf;
};
struct sampled {
    direction l;
    rgb weight;
    float pdf;
};
struct point {
    float x, y;
};

/// |(a x, a y, z)|, the length of a stretched direction.
[[gnu::always_inline]] inline float stretched(const direction& w, float a) {
    return std::sqrt(a * a * (w.x * w.x + w.y * w.y) + w.z * w.z);
}

[[gnu::always_inline]] inline float D(const direction& m, float a) {
    const float xy = m.x * m.x + m.y * m.y, az = a * m.z;
    const float k = a * (xy + m.z * m.z) / (xy + az * az);
    return m.z < 0.0f ? 0.0f : k * k * (1.0f / pi);
}

[[gnu::always_inline]] inline float visibility(const direction& v, const direction& l, float a) {
    return 0.5f / (stretched(v, a) * l.z + stretched(l, a) * v.z);
}

[[gnu::always_inline]] inline rgb schlick(const rgb& f0, float u) {
    const float w = 1.0f - u, w2 = w * w, w5 = w2 * w2 * w;
    return {f0.r + (1.0f - f0.r) * w5, f0.g + (1.0f - f0.g) * w5, f0.b + (1.0f - f0.b) * w5};
}
[[gnu::always_inline]] inline rgb scaled(const rgb& c, float k) { return {c.r * k, c.g * k, c.b * k}; }

/// v + l and what D and F want of it.
struct half {
    float k, v_m;
    [[gnu::always_inline]] half(const direction& v, const direction& l, float a) {
        const float x = v.x + l.x, y = v.y + l.y, z = v.z + l.z, xy = x * x + y * y, ss = xy + z * z, az = a * z;
        k = a * ss / (xy + az * az);
        v_m = std::sqrt(ss) * 0.5f;
    }
};
[[gnu::always_inline]] inline bool lit(const direction& v, const direction& l) { return (v.z > 0.0f) & (l.z > 0.0f); }

[[gnu::always_inline]] inline rgb f_cos(const direction& v, const direction& l, float a, const rgb& f0) {
    const half h(v, l, a);
    const float den = stretched(v, a) * l.z + stretched(l, a) * v.z;
    const float t = h.k * h.k * l.z * (0.5f / pi) / den;
    return scaled(schlick(f0, h.v_m), lit(v, l) ? t : 0.0f);
}

[[gnu::always_inline]] inline evaluated evaluate(const direction& v, const direction& l, float a, const rgb& f0) {
    const half h(v, l, a);
    const float S = stretched(v, a), D = h.k * h.k * (0.5f / pi);
    const float t = D * l.z / (S * l.z + stretched(l, a) * v.z), p = D / (S + v.z);
    return {scaled(schlick(f0, h.v_m), lit(v, l) ? t : 0.0f), lit(v, l) ? p : 0.0f};
}

[[gnu::always_inline]] inline float pdf(const direction& v, const direction& l, float a) {
    const float x = v.x + l.x, y = v.y + l.y, z = v.z + l.z, xy = x * x + y * y, az = a * z;
    const float k = a * (xy + z * z) / (xy + az * az), p = k * k * (0.5f / pi) / (stretched(v, a) + v.z);
    return lit(v, l) ? p : 0.0f;
}

/// Cosine and sine of a turn: the nearest quarter subtracted, polynomials, swapped and signed by their bits.
[[gnu::always_inline]] inline point circle(float u) {
    const auto turn = static_cast<std::int32_t>(4.0f * u + 0.5f);
    const float r = u - static_cast<float>(turn) * 0.25f, t = r * r;
    const float sine = r * (6.2831853f + t * (-41.341673f + t * (81.593937f + t * -75.453396f)));
    const float cosine = 1.0f + t * (-19.739208694f + t * (64.939326f + t * (-85.443742f + t * 59.245964f)));
    const auto q = static_cast<std::uint32_t>(turn), s = std::bit_cast<std::uint32_t>(sine),
               c = std::bit_cast<std::uint32_t>(cosine), swap = (s ^ c) & (0u - (q & 1u));
    return {std::bit_cast<float>(c ^ swap ^ ((q + 1u) & 2u) << 30), std::bit_cast<float>(s ^ swap ^ (q & 2u) << 30)};
}

[[gnu::always_inline]] inline direction sample_normal(float u1, float u2, float a) {
    const point c = circle(u2);
    const float z2 = 1.0f - u1, k = 1.0f / std::sqrt(a * a * u1 + z2), r = a * std::sqrt(u1) * k;
    return {r * c.x, r * c.y, std::sqrt(z2) * k};
}

/// Spherical caps on multiples of the normal n: l = 2 (v.n)/(n.n) n - v.
[[gnu::always_inline]] inline sampled sample_visible(const direction& v, float u1, float u2, float a, const rgb& f0) {
    const float x = a * v.x, y = a * v.y, sine2 = x * x + y * y, S = std::sqrt(sine2 + v.z * v.z), height = S + v.z;
    const float cap = (1.0f - u1) * height, r = std::sqrt(u1 * (height * cap + sine2));
    const point c = circle(u2);
    const direction n{a * (r * c.x + x), a * (r * c.y + y), cap};
    const float xy = n.x * n.x + n.y * n.y, nn = xy + n.z * n.z, vn = v.x * n.x + v.y * n.y + v.z * n.z,
                k = 2.0f * vn / nn;
    const direction l{k * n.x - v.x, k * n.y - v.y, k * n.z - v.z};
    const float az = a * n.z, d = a * nn / (xy + az * az), p = d * d * (0.5f / pi) / height;
    const float weight = l.z * height / (S * l.z + stretched(l, a) * v.z);
    const bool valid = l.z > 0.0f;
    return {{valid ? l.x : 0.0f, valid ? l.y : 0.0f, valid ? l.z : 1.0f},
            scaled(schlick(f0, std::sqrt(0.5f * vn * k)), valid ? weight : 0.0f),
            valid ? p : 0.0f};
}

[[gnu::always_inline]] inline float dielectric(float eta, float c) {
    const float e = (eta - 1.0f) * (eta + 1.0f), g2 = e + c * c, g = std::sqrt(g2 > 0.0f ? g2 : 0.0f),
                s2 = 1.0f - c * c;
    const float s = (g - c) / (g + c), p = (g * c - s2) / (g * c + s2);
    return g2 > 0.0f ? 0.5f * s * s * (1.0f + p * p) : 1.0f;
}

/// Lagarde 2013.
[[gnu::always_inline]] inline float conductor(float eta, float k, float c) {
    const float c2 = c * c, s2 = 1.0f - c2, e2 = eta * eta, k2 = k * k, t0 = e2 - k2 - s2;
    const float ab = std::sqrt(t0 * t0 + 4.0f * e2 * k2), a = std::sqrt(ab + t0);
    const float t1 = ab + c2, t2 = 1.41421356f * c * a, t3 = c2 * ab + s2 * s2, t4 = t2 * s2;
    const float s = (t1 - t2) / (t1 + t2);
    return 0.5f * s * (1.0f + (t3 - t4) / (t3 + t4));
}
[[gnu::always_inline]] inline rgb conductor(const rgb& eta, const rgb& k, float c) {
    return {conductor(eta.r, k.r, c), conductor(eta.g, k.g, c), conductor(eta.b, k.b, c)};
}

/// Points of the half-step Hammersley set, n below 2^24.
[[gnu::always_inline]] inline point hammersley(std::uint32_t i, std::uint32_t n) {
    const float step = 1.0f / static_cast<float>(n);
    std::uint32_t b = (i << 16) | (i >> 16);
    b = ((b & 0x00ff00ffu) << 8) | ((b & 0xff00ff00u) >> 8);
    b = ((b & 0x0f0f0f0fu) << 4) | ((b & 0xf0f0f0f0u) >> 4);
    b = ((b & 0x33333333u) << 2) | ((b & 0xccccccccu) >> 2);
    b = ((b & 0x55555555u) << 1) | ((b & 0xaaaaaaaau) >> 1);
    return {(static_cast<float>(static_cast<std::int32_t>(i)) + 0.5f) * step,
            static_cast<float>(static_cast<std::int32_t>(b >> 8)) * 0x1p-24f + 0.5f * step};
}

}  // namespace limit
