// The same quantities in long double, from the same float inputs: what every error is measured against. Written from the
// formulas in components, without the library (the split sum excepted).
#pragma once

#include "inputs.hpp"

#include <cmath>
#include <limits>

namespace truth {

using real = long double;
inline constexpr real pi = 3.14159265358979323846264338327950288L;

struct vector {
    real x, y, z;
};
inline vector operator+(const vector& a, const vector& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline vector operator*(real s, const vector& a) { return {s * a.x, s * a.y, s * a.z}; }
inline real dot(const vector& a, const vector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline vector unit(const vector& a) { return 1 / std::sqrt(dot(a, a)) * a; }

inline vector view(const inputs& in, std::size_t i) { return {in.vx[i], in.vy[i], in.vz[i]}; }
inline vector light(const inputs& in, std::size_t i) { return {in.lx[i], in.ly[i], in.lz[i]}; }

/// GGX of any positive multiple of m.
inline real D(const vector& m, real ax, real ay) {
    const real x = m.x / ax, y = m.y / ay, d = x * x + y * y + m.z * m.z, mm = dot(m, m);
    return mm * mm / (pi * ax * ay * d * d);
}
inline real S(const vector& w, real a) { return std::sqrt(a * a * (w.x * w.x + w.y * w.y) + w.z * w.z); }
inline real projected_area(const vector& w, real a) { return (w.z + S(w, a)) / 2; }

inline real visibility_correlated(const vector& v, const vector& l, real a) { return 1 / (2 * (l.z * S(v, a) + v.z * S(l, a))); }
inline real visibility_separable(const vector& v, const vector& l, real a) { return 1 / (4 * projected_area(v, a) * projected_area(l, a)); }

inline real schlick(real F0, real u) { return F0 + (1 - F0) * std::pow(1 - u, real(5)); }

inline vector f_cos(const inputs& in, std::size_t i) {
    const vector v = view(in, i), l = light(in, i), s = v + l;
    const real a = in.a[i], u = std::sqrt(dot(s, s)) / 2, rest = D(s, a, a) * visibility_correlated(v, l, a) * l.z;
    return rest * vector{schlick(in.r[i], u), schlick(in.g[i], u), schlick(in.b[i], u)};
}

inline real pdf_visible(const inputs& in, std::size_t i) {
    const vector v = view(in, i), s = v + light(in, i);
    const real a = in.a[i];
    return D(s, a, a) / (4 * projected_area(v, a));
}

inline real pdf_all(const inputs& in, std::size_t i) {
    const vector s = view(in, i) + light(in, i);
    const real a = in.a[i], length = std::sqrt(dot(s, s));
    return D(s, a, a) * (s.z / length) / (4 * (length / 2));
}

struct sampled {
    vector l, weight;
    real pdf;
};

/// Reflects about m. Where the reflection grazes the horizon rounding decides whether the sample fails: those are not counted.
inline sampled reflect(const inputs& in, std::size_t i, const vector& m, bool visible) {
    const vector v = view(in, i);
    const real a = in.a[i], v_m = dot(v, m);
    const vector l = 2 * v_m * m + real(-1) * v;
    if (std::abs(l.z) < 1e-4L || std::abs(v_m) < 1e-4L) return {l, l, std::numeric_limits<real>::quiet_NaN()};
    if (l.z <= 0 || v_m <= 0) return {{0, 0, 1}, {0, 0, 0}, 0};
    const real area = visible ? projected_area(v, a) : v_m / m.z;  // pdf = D/(4 area), weight = 4 F V cos area
    const real weight = 4 * visibility_correlated(v, l, a) * l.z * area;
    return {l, weight * vector{schlick(in.r[i], v_m), schlick(in.g[i], v_m), schlick(in.b[i], v_m)}, D(m, a, a) / (4 * area)};
}

/// Dupuy & Benyoub 2023: u1 is the height in the cap, u2 the azimuth.
inline sampled sample_caps(const inputs& in, std::size_t i) {
    const real a = in.a[i], u = in.u1[i], phi = 2 * pi * in.u2[i];
    const vector v = view(in, i), w = unit({a * v.x, a * v.y, v.z});
    const real q = u * (1 + w.z), rho = std::sqrt(q * (2 - q));
    const vector h{rho * std::cos(phi) + w.x, rho * std::sin(phi) + w.y, 1 - q + w.z};
    return reflect(in, i, unit({a * h.x, a * h.y, h.z}), true);
}

/// Heitz 2018: u1 is the radius in the disk, u2 the azimuth.
inline sampled sample_heitz2018(const inputs& in, std::size_t i) {
    const real a = in.a[i], phi = 2 * pi * in.u2[i], r = std::sqrt(real(in.u1[i]));
    const vector v = view(in, i), w = unit({a * v.x, a * v.y, v.z});
    const real sine = std::sqrt(w.x * w.x + w.y * w.y), s = (1 + w.z) / 2;
    const vector T1{-w.y / sine, w.x / sine, 0}, T2{-w.z * T1.y, w.z * T1.x, w.x * T1.y - w.y * T1.x};
    const real t1 = r * std::cos(phi), t2 = (1 - s) * std::sqrt(1 - t1 * t1) + s * r * std::sin(phi);
    const vector n = t1 * T1 + t2 * T2 + std::sqrt(std::max(real(0), 1 - t1 * t1 - t2 * t2)) * w;
    return reflect(in, i, unit({a * n.x, a * n.y, std::max(real(0), n.z)}), true);
}

/// Walter et al. 2007: the inverse CDF.
inline sampled sample_all(const inputs& in, std::size_t i) {
    const real a = in.a[i], u = in.u1[i], phi = 2 * pi * in.u2[i], r = a * std::sqrt(u);
    return reflect(in, i, unit({r * std::cos(phi), r * std::sin(phi), std::sqrt(1 - u)}), false);
}

inline real radical_inverse(std::uint32_t i) {
    real value = 0, digit = 0.5L;
    for (; i != 0; i >>= 1, digit /= 2) value += static_cast<real>(i & 1) * digit;
    return value;
}

struct terms {
    real scale, bias;
};
/// By lobe's own quadrature at order 128, in double, which the tests compare with the reference tables.
terms dfg(const inputs& in, std::size_t i);

}  // namespace truth
