// What the foundation's rows are measured against: the same quantities in long double, from the same float inputs,
// written from the formulas in components, without the library (the split sum excepted).
#pragma once

#include "element.hpp"

#include <glm/geometric.hpp>

#include <cmath>
#include <limits>

namespace truth {

using element = ::element<real>;
using vec2 = glm::vec<2, real>;
using vec3 = glm::vec<3, real>;
inline constexpr real pi = 3.14159265358979323846264338327950288L;

inline vec3 unit(const vec3& w) { return w / std::sqrt(dot(w, w)); }

/// GGX of any positive multiple of m.
inline real D(const vec3& m, real ax, real ay) {
    const real x = m.x / ax, y = m.y / ay, d = x * x + y * y + m.z * m.z, mm = dot(m, m);
    return mm * mm / (pi * ax * ay * d * d);
}
inline real S(const vec3& w, real a) { return std::sqrt(a * a * (w.x * w.x + w.y * w.y) + w.z * w.z); }
inline real projected_area(const vec3& w, real a) { return (w.z + S(w, a)) / 2; }

inline real visibility_correlated(const vec3& v, const vec3& l, real a) {
    return 1 / (2 * (l.z * S(v, a) + v.z * S(l, a)));
}
inline real visibility_separable(const vec3& v, const vec3& l, real a) {
    return 1 / (4 * projected_area(v, a) * projected_area(l, a));
}

template <class Spectrum>
Spectrum schlick(const Spectrum& F0, real u) {
    return F0 + (Spectrum(1) - F0) * std::pow(1 - u, real(5));
}

inline vec3 f_cos(const element& e) {
    const vec3 v = e.v(), l = e.l(), s = v + l;
    return schlick(e.F0(), std::sqrt(dot(s, s)) / 2) * (D(s, e.a(), e.a()) * visibility_correlated(v, l, e.a()) * l.z);
}

inline real pdf_visible(const element& e) {
    return D(e.v() + e.l(), e.a(), e.a()) / (4 * projected_area(e.v(), e.a()));
}

inline real pdf_all(const element& e) {
    const vec3 s = e.v() + e.l();
    const real length = std::sqrt(dot(s, s));
    return D(s, e.a(), e.a()) * (s.z / length) / (4 * (length / 2));
}

struct sampled {
    vec3 l, weight;
    real pdf;
};

/// Reflects about m. Where the reflection grazes the horizon rounding decides whether the sample fails: those are not
/// counted.
inline sampled reflect(const element& e, const vec3& m, bool visible) {
    const vec3 v = e.v();
    const real a = e.a(), v_m = dot(v, m);
    const vec3 l = 2 * v_m * m - v;
    if (std::abs(l.z) < 1e-4L || std::abs(v_m) < 1e-4L) return {l, l, std::numeric_limits<real>::quiet_NaN()};
    if (l.z <= 0 || v_m <= 0) return {{0, 0, 1}, {0, 0, 0}, 0};
    const real area = visible ? projected_area(v, a) : v_m / m.z;  // pdf = D/(4 area), weight = 4 F V cos area
    return {l, schlick(e.F0(), v_m) * (4 * visibility_correlated(v, l, a) * l.z * area), D(m, a, a) / (4 * area)};
}

/// Dupuy & Benyoub 2023: u1 is the height in the cap, u2 the azimuth.
inline sampled sample_caps(const element& e) {
    const real a = e.a(), phi = 2 * pi * e.u().y;
    const vec3 v = e.v(), w = unit({a * v.x, a * v.y, v.z});
    const real q = e.u().x * (1 + w.z), rho = std::sqrt(q * (2 - q));
    const vec3 h{rho * std::cos(phi) + w.x, rho * std::sin(phi) + w.y, 1 - q + w.z};
    return reflect(e, unit({a * h.x, a * h.y, h.z}), true);
}

/// Heitz 2018: u1 is the radius in the disk, u2 the azimuth.
inline sampled sample_heitz2018(const element& e) {
    const real a = e.a(), phi = 2 * pi * e.u().y, r = std::sqrt(e.u().x);
    const vec3 v = e.v(), w = unit({a * v.x, a * v.y, v.z});
    const real sine = std::sqrt(w.x * w.x + w.y * w.y), s = (1 + w.z) / 2;
    const vec3 T1{-w.y / sine, w.x / sine, 0}, T2{-w.z * T1.y, w.z * T1.x, w.x * T1.y - w.y * T1.x};
    const real t1 = r * std::cos(phi), t2 = (1 - s) * std::sqrt(1 - t1 * t1) + s * r * std::sin(phi);
    const vec3 n = t1 * T1 + t2 * T2 + std::sqrt(std::max(real(0), 1 - t1 * t1 - t2 * t2)) * w;
    return reflect(e, unit({a * n.x, a * n.y, std::max(real(0), n.z)}), true);
}

/// Walter et al. 2007: the inverse CDF.
inline sampled sample_all(const element& e) {
    const real u = e.u().x, phi = 2 * pi * e.u().y, r = e.a() * std::sqrt(u);
    return reflect(e, unit({r * std::cos(phi), r * std::sin(phi), std::sqrt(1 - u)}), false);
}

inline real radical_inverse(std::uint32_t i) {
    real value = 0, digit = 0.5L;
    for (; i != 0; i >>= 1, digit /= 2) value += static_cast<real>(i & 1) * digit;
    return value;
}

/// (scale, bias) by lobe's own quadrature at order 128, in double, which the tests compare with the reference tables.
inline vec2 dfg(const element& e) {
    const auto t =
        lobe::dfg_exact(lobe::smith_correlated{}, double(e.v().z), lobe::alpha{double(e.a())}, {.order = 128});
    return {t.scale, t.bias};
}

}  // namespace truth
