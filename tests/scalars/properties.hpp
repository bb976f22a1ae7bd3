// What holds in every scalar type: properties of a BRDF, and its numbers against the same composition in double.
#pragma once

#include "../support.hpp"

#include <lobe/brdf/lambert.hpp>
#include <lobe/brdf/masking.hpp>
#include <lobe/brdf/microfacet.hpp>
#include <lobe/core/spectrum.hpp>
#include <lobe/fresnel/schlick.hpp>
#include <lobe/ndf/beckmann.hpp>
#include <lobe/ndf/ggx.hpp>

namespace scalars {

/// How a test reads and writes T. Specialised for packs.
template <class T>
struct number {
    static constexpr std::size_t lanes = 1;
    static inline const double epsilon = std::ldexp(1.0, 1 - lobe::detail::digits<T>());
    static T load(const double* x) { return T(*x); }
    static double lane(const T& x, std::size_t) { return static_cast<double>(x); }
};

template <class Pack>
    requires requires {
        Pack::size;
        typename Pack::batch_bool_type;
    }
struct number<Pack> {
    using T = typename Pack::value_type;
    static constexpr std::size_t lanes = Pack::size;
    static constexpr double epsilon = std::numeric_limits<T>::epsilon();
    static Pack load(const double* x) {
        T all[lanes];
        for (std::size_t i = 0; i < lanes; ++i) all[i] = static_cast<T>(x[i]);
        return Pack::load_unaligned(all);
    }
    static double lane(const Pack& x, std::size_t i) { return static_cast<double>(x.get(i)); }
};

/// What is rounded to float is the same number in every type. (Volatile: -ffast-math drops the rounding.)
inline double in_float(double x) {
    const volatile float rounded = static_cast<float>(x);
    return static_cast<double>(rounded);
}

/// A vector in each lane, and the same vectors in double.
template <class T>
struct vectors {
    using N = number<T>;
    double x[N::lanes], y[N::lanes], z[N::lanes];
    template <class Draw>
    explicit vectors(const Draw& draw) {
        for (std::size_t i = 0; i < N::lanes; ++i) {
            const lobe::vec3<double> w = draw();
            x[i] = in_float(w.x), y[i] = in_float(w.y), z[i] = in_float(w.z);
        }
    }
    lobe::vec3<T> all() const { return {N::load(x), N::load(y), N::load(z)}; }
    lobe::vec3<double> one(std::size_t i) const { return {x[i], y[i], z[i]}; }
};

/// Every constant is exact in float.
template <class T>
auto isotropic_ggx() {
    return lobe::microfacet{lobe::ggx{lobe::alpha<T>(T(0.25))}, lobe::smith_correlated{}, lobe::schlick{T(0.0625)}};
}
template <class T>
auto anisotropic_ggx() {
    return lobe::microfacet{lobe::ggx{lobe::alpha_xy<T>(T(0.5), T(0.25))}, lobe::smith_correlated{},
                            lobe::schlick{T(0.0625)}};
}
template <class T>
auto gaussian() {
    return lobe::microfacet{lobe::beckmann{lobe::alpha<T>(T(0.5))}, lobe::smith_correlated{}, lobe::schlick{T(0.0625)},
                            lobe::all_normals{}};
}

/// The largest error of each property, in epsilons of T over the conditioning of D: a relative error of 1/a in the
/// slope t of the half vector is one of t/a in D, and v + l rounds t by 1/(v.z + l.z).
struct errors {
    double reciprocity = 0, evaluate = 0, sampled_pdf = 0, sampled_weight = 0, f_cos = 0, pdf = 0;
    int looked_at = 0;
};

inline double conditioning(const lobe::vec3<double>& v, const lobe::vec3<double>& l, double width) {
    const lobe::vec3<double> s = v + l;
    const double tangent2 = (s.x * s.x + s.y * s.y) / (s.z * s.z);
    return 1 + tangent2 / (width * width) + (1 + std::sqrt(tangent2)) / (width * s.z);
}

template <class T, class Brdf, class Truth>
errors look_at(const Brdf& brdf, const Truth& truth, double width) {
    using N = number<T>;
    const double unit = std::max(N::epsilon, std::numeric_limits<double>::epsilon());  // of the comparisons in double
    random_numbers random(1);
    const auto above = [&] {
        lobe::vec3<double> w;
        do w = random.direction();
        while (w.z < 0.1);
        return w;
    };
    errors worst;
    const auto look = [&](double& record, double value, double expected, double condition) {
        if (expected > 1e-30) record = larger(record, std::abs(value - expected) / (expected * condition * unit));
    };
    for (int trial = 0; trial < 300; ++trial) {
        const vectors<T> vs(above), ls(above), us([&] { return lobe::vec3<double>{random(), random(), 0}; });
        const lobe::vec3<T> v = vs.all(), l = ls.all(), u = us.all();
        const T f = brdf.f(v, l), back = brdf.f(l, v), f_cos = brdf.f_cos(v, l), pdf = brdf.pdf(v, l);
        const auto e = brdf.evaluate(v, l);
        const auto s = brdf.sample(v, {u.x, u.y});
        const T s_pdf = brdf.pdf(v, s.l), s_f_cos = brdf.f_cos(v, s.l), product = s.weight * s.pdf;
        for (std::size_t i = 0; i < N::lanes; ++i) {
            const auto lane = [i](const T& x) { return N::lane(x, i); };
            const lobe::vec3<double> vi = vs.one(i), li = ls.one(i), si{lane(s.l.x), lane(s.l.y), lane(s.l.z)};
            const double c = conditioning(vi, li, width), cs = conditioning(vi, si, width);
            look(worst.reciprocity, lane(back), lane(f), c);
            look(worst.evaluate, lane(e.f_cos), lane(f_cos), c);
            look(worst.evaluate, lane(e.pdf), lane(pdf), c);
            look(worst.f_cos, lane(f_cos), truth.f_cos(vi, li), c);
            look(worst.pdf, lane(pdf), truth.pdf(vi, li), c);
            if (!(lane(s.pdf) > 0) || si.z < 0.1) continue;
            ++worst.looked_at;
            look(worst.sampled_pdf, lane(s_pdf), lane(s.pdf), cs);
            look(worst.sampled_weight, lane(product), lane(s_f_cos), cs);
        }
    }
    return worst;
}

/// int D(m) cos dm over slopes (ax r cos phi, ay r sin phi) with r^2 = u/(1 - u), u = w^3 (10 - 15 w + 6 w^2), by the
/// midpoint rule of 64 x 16 points. What is integrated over w starts as 30 w^2 and ends alike, so that the rule errs by
/// 7/5760 h^4 (360 + 360) = 5.2e-8 at most.
template <class T, class N>
double whole(const N& ndf, double ax, double ay) {
    using std::sqrt;
    const double pi = lobe::pi<double>();
    double total = 0;
    for (int i = 0; i < 64; ++i)
        for (int k = 0; k < 16; ++k) {
            const double w = (i + 0.5) / 64, phi = 2 * pi * (k + 0.5) / 16, u = w * w * w * (10 - 15 * w + 6 * w * w),
                         r = sqrt(u / (1 - u));
            const vectors<T> m([&] { return lobe::vec3<double>{ax * r * std::cos(phi), ay * r * std::sin(phi), 1}; });
            const lobe::vec3<double> m1 = m.one(0);
            const double m2 = lobe::dot(m1, m1), cos4 = 1 / (m2 * m2), du = 30 * w * w * (1 - w) * (1 - w) / 64;
            const double D = number<T>::lane(ndf.D(m.all()), number<T>::lanes - 1);
            total += D * cos4 * ax * ay / (2 * (1 - u) * (1 - u)) * du * (2 * pi / 16);
        }
    return total;
}

/// 16 epsilons over the conditioning: f_cos is stated to 15 ULP, the largest of these; measured are 4.3.
inline constexpr double allowed = 16;

inline void check(const char* name, const errors& e, bool reciprocal_to_the_bit = false) {
    INFO(name << ": reciprocity " << e.reciprocity << ", evaluate " << e.evaluate << ", pdf of a sample "
              << e.sampled_pdf << ", its weight " << e.sampled_weight << ", f_cos " << e.f_cos << ", pdf " << e.pdf
              << " epsilons");
    if (reciprocal_to_the_bit) CHECK(e.reciprocity == 0);
    CHECK(e.reciprocity <= allowed);
    CHECK(e.evaluate <= allowed);
    CHECK(e.sampled_pdf <= allowed);
    CHECK(e.sampled_weight <= allowed);
    CHECK(e.f_cos <= allowed);
    CHECK(e.pdf <= allowed);
    CHECK(e.looked_at > 100);
}

/// All of it, in one scalar.
template <class T>
void verify_all() {
    check("GGX", look_at<T>(isotropic_ggx<T>(), isotropic_ggx<double>(), 0.25));
    check("GGX, two widths", look_at<T>(anisotropic_ggx<T>(), anisotropic_ggx<double>(), 0.25));
    check("Beckmann", look_at<T>(gaussian<T>(), gaussian<double>(), 0.5));
    check("Lambert", look_at<T>(lobe::lambert{T(0.75)}, lobe::lambert{0.75}, 1), true);
    const double rounding = 1e-7 + allowed * number<T>::epsilon;
    CHECK(std::abs(whole<T>(lobe::ggx{lobe::alpha<T>(T(0.25))}, 0.25, 0.25) - 1) < rounding);
    CHECK(std::abs(whole<T>(lobe::ggx{lobe::alpha_xy<T>(T(0.5), T(0.25))}, 0.5, 0.25) - 1) < rounding);
    CHECK(std::abs(whole<T>(lobe::beckmann{lobe::alpha<T>(T(0.5))}, 0.5, 0.5) - 1) < rounding);
}

}  // namespace scalars
