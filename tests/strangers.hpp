// A stranger's BRDFs, written as textbooks and engines write them: half vectors are normalised, cosines clamped, 1 -
// c*c and pow are not feared. The test kit is tried on them, so they use nothing of lobe. Each is put together from
// small functions: a mistake replaces one of them.
#pragma once

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace strangers {

template <class T>
using vec2 = glm::vec<2, T, glm::defaultp>;
template <class T>
using vec3 = glm::vec<3, T, glm::defaultp>;

template <class T>
inline constexpr T pi = T(3.14159265358979323846);

/// What a renderer calls. The kit looks at members, so what lacks one is another type.
template <class T, class S = T>
struct material {
    struct drawn {
        vec3<T> l{0, 0, 1};
        S weight{0};
        T pdf = 0;
    };
    std::function<S(const vec3<T>& v, const vec3<T>& l)> f_cos;
    std::function<drawn(const vec3<T>& v, const vec2<T>& u)> sample;
    std::function<T(const vec3<T>& v, const vec3<T>& l)> pdf;
};
template <class T, class S>
struct without_pdf {
    explicit without_pdf(const material<T, S>& m) : f_cos(m.f_cos), sample(m.sample) {}
    decltype(material<T, S>::f_cos) f_cos;
    decltype(material<T, S>::sample) sample;
};
template <class T, class S>
struct without_sample {
    explicit without_sample(const material<T, S>& m) : f_cos(m.f_cos) {}
    decltype(material<T, S>::f_cos) f_cos;
};

template <class T>
vec3<T> spherical(T cos_theta, T phi) {
    const T sin_theta = std::sqrt(std::max(T(0), 1 - cos_theta * cos_theta));
    return {sin_theta * std::cos(phi), sin_theta * std::sin(phi), cos_theta};
}
template <class T>
vec3<T> turned(const vec3<T>& w, T angle) {
    const T c = std::cos(angle), s = std::sin(angle);
    return {c * w.x - s * w.y, s * w.x + c * w.y, w.z};
}
template <class T>
bool above(const vec3<T>& v, const vec3<T>& l) {
    return v.z > 0 && l.z > 0;
}
template <class T>
T clamped_dot(const vec3<T>& a, const vec3<T>& b) {
    return std::max(glm::dot(a, b), T(0));
}

// ---- distributions of normals

template <class T>
T ggx_D(const vec3<T>& m, T a) {
    const T a2 = a * a, f = (m.z * a2 - m.z) * m.z + 1;
    return a2 / (pi<T> * f * f);
}
template <class T>
T ggx_D(const vec3<T>& m, T ax, T ay) {
    const T x = m.x / ax, y = m.y / ay, f = x * x + y * y + m.z * m.z;
    return 1 / (pi<T> * ax * ay * f * f);
}
template <class T>
T ggx_lambda(const vec3<T>& w, T ax, T ay) {
    const T t2 = (ax * ax * w.x * w.x + ay * ay * w.y * w.y) / (w.z * w.z);
    return (std::sqrt(1 + t2) - 1) / 2;
}
template <class T>
T ggx_G1(const vec3<T>& w, T ax, T ay) {
    return 2 * w.z / (w.z + std::sqrt(ax * ax * w.x * w.x + ay * ay * w.y * w.y + w.z * w.z));
}
/// Height-correlated Smith.
template <class T>
T ggx_G2(const vec3<T>& v, const vec3<T>& l, T ax, T ay) {
    const T sv = std::sqrt(ax * ax * v.x * v.x + ay * ay * v.y * v.y + v.z * v.z);
    const T sl = std::sqrt(ax * ax * l.x * l.x + ay * ay * l.y * l.y + l.z * l.z);
    return 2 * v.z * l.z / (l.z * sv + v.z * sl);
}
template <class T>
vec3<T> ggx_sample(const vec2<T>& u, T ax, T ay) {
    const T r = std::sqrt(u.x / (1 - u.x)), phi = 2 * pi<T> * u.y;
    return glm::normalize(vec3<T>(ax * r * std::cos(phi), ay * r * std::sin(phi), T(1)));
}
/// Heitz 2018, as printed.
template <class T>
vec3<T> ggx_sample_visible(const vec3<T>& v, const vec2<T>& u, T ax, T ay) {
    const vec3<T> vh = glm::normalize(vec3<T>(ax * v.x, ay * v.y, v.z));
    const T lensq = vh.x * vh.x + vh.y * vh.y;
    const vec3<T> t1 = lensq > 0 ? vec3<T>(-vh.y, vh.x, 0) / std::sqrt(lensq) : vec3<T>(1, 0, 0),
                  t2 = glm::cross(vh, t1);
    const T r = std::sqrt(u.x), phi = 2 * pi<T> * u.y, p1 = r * std::cos(phi), s = (1 + vh.z) / 2;
    const T p2 = (1 - s) * std::sqrt(1 - p1 * p1) + s * (r * std::sin(phi));
    const vec3<T> nh = p1 * t1 + p2 * t2 + std::sqrt(std::max(T(0), 1 - p1 * p1 - p2 * p2)) * vh;
    return glm::normalize(vec3<T>(ax * nh.x, ay * nh.y, std::max(T(0), nh.z)));
}
/// Dupuy & Benyoub 2023, spherical caps.
template <class T>
vec3<T> ggx_sample_caps(const vec3<T>& v, const vec2<T>& u, T ax, T ay) {
    const vec3<T> vh = glm::normalize(vec3<T>(ax * v.x, ay * v.y, v.z));
    const T phi = 2 * pi<T> * u.y, z = (1 - u.x) * (1 + vh.z) - vh.z, s = std::sqrt(std::clamp(1 - z * z, T(0), T(1)));
    const vec3<T> h = vec3<T>(s * std::cos(phi), s * std::sin(phi), z) + vh;
    return glm::normalize(vec3<T>(ax * h.x, ay * h.y, h.z));
}
template <class T>
T ggx_pdf_visible(const vec3<T>& v, const vec3<T>& m, T ax, T ay) {
    return ggx_G1(v, ax, ay) * clamped_dot(v, m) * ggx_D(m, ax, ay) / v.z;
}

template <class T>
T beckmann_D(const vec3<T>& m, T a) {
    const T c2 = m.z * m.z, tan2 = (1 - c2) / c2;
    return std::exp(-tan2 / (a * a)) / (pi<T> * a * a * c2 * c2);
}
template <class T>
T beckmann_G1(const vec3<T>& w, T a) {  // Walter 2007's rational fit
    const T b = w.z / (a * std::sqrt(std::max(T(1e-12), 1 - w.z * w.z)));
    return b < T(1.6) ? (T(3.535) * b + T(2.181) * b * b) / (1 + T(2.276) * b + T(2.577) * b * b) : T(1);
}
template <class T>
T v_cavity(const vec3<T>& v, const vec3<T>& l, const vec3<T>& m) {
    return std::min(T(1), 2 * m.z * std::min(v.z, l.z) / glm::dot(v, m));
}

// ---- Fresnel

template <class T>
std::function<T(T)> schlick(T f0) {
    return [f0](T c) { return f0 + (1 - f0) * std::pow(std::clamp(1 - c, T(0), T(1)), T(5)); };
}
template <class T>
T white(T) {
    return 1;
}

// ---- Cook-Torrance

enum class draws { visible, caps, all };

template <class T>
struct microfacet {
    using V = vec3<T>;
    std::function<T(const V& m)> D;
    std::function<T(const V& v, const V& l, const V& m)> G;
    std::function<T(T)> F = white<T>;
    std::function<V(const V& v, const vec2<T>& u)> sample_m;
    std::function<T(const V& v, const V& m)> pdf_m;
    std::function<T(const V& v, const V& l, const V& m)> weight;  // without F
    std::function<T(const V& v, const V& l, const V& m)> f_cos_of = [](const V& v, const V&, const V&) {
        return 1 / (4 * v.z);
    };
    std::function<T(const V& v, const V& l, const V& m)> jacobian = [](const V& v, const V&, const V& m) {
        return 1 / (4 * std::abs(glm::dot(v, m)));
    };

    operator material<T>() const {
        const microfacet b = *this;
        material<T> out;
        out.f_cos = [b](const V& v, const V& l) {
            if (!above(v, l)) return T(0);
            const V m = glm::normalize(v + l);
            return b.D(m) * b.G(v, l, m) * b.F(clamped_dot(v, m)) * b.f_cos_of(v, l, m);
        };
        out.pdf = [b](const V& v, const V& l) {
            if (!above(v, l)) return T(0);
            const V m = glm::normalize(v + l);
            return b.pdf_m(v, m) * b.jacobian(v, l, m);
        };
        out.sample = [b](const V& v, const vec2<T>& u) {
            typename material<T>::drawn s;
            if (!(v.z > 0)) return s;
            const V m = b.sample_m(v, u);
            const V l = 2 * glm::dot(v, m) * m - v;
            if (!(l.z > 0)) return s;
            s.l = l;
            s.pdf = b.pdf_m(v, m) * b.jacobian(v, l, m);
            s.weight = s.pdf > 0 ? b.F(clamped_dot(v, m)) * b.weight(v, l, m) : T(0);
            return s;
        };
        return out;
    }
};

template <class T>
microfacet<T> drawing_all(microfacet<T> b) {
    b.pdf_m = [D = b.D](const vec3<T>&, const vec3<T>& m) { return D(m) * m.z; };
    b.weight = [G = b.G](const vec3<T>& v, const vec3<T>& l, const vec3<T>& m) {
        return G(v, l, m) * glm::dot(v, m) / (v.z * m.z);
    };
    return b;
}

template <class T>
microfacet<T> ggx(T ax, T ay, draws how = draws::visible) {
    using V = vec3<T>;
    microfacet<T> b;
    if (ax == ay)
        b.D = [ax](const V& m) { return ggx_D(m, ax); };
    else
        b.D = [ax, ay](const V& m) { return ggx_D(m, ax, ay); };
    b.G = [ax, ay](const V& v, const V& l, const V&) { return ggx_G2(v, l, ax, ay); };
    if (how == draws::all) {
        b = drawing_all(b);
        b.sample_m = [ax, ay](const V&, const vec2<T>& u) { return ggx_sample(u, ax, ay); };
        return b;
    }
    b.sample_m = [ax, ay, how](const V& v, const vec2<T>& u) {
        return how == draws::caps ? ggx_sample_caps(v, u, ax, ay) : ggx_sample_visible(v, u, ax, ay);
    };
    b.pdf_m = [ax, ay, D = b.D](const V& v, const V& m) { return ggx_G1(v, ax, ay) * clamped_dot(v, m) * D(m) / v.z; };
    b.weight = [ax, ay](const V& v, const V& l, const V&) { return ggx_G2(v, l, ax, ay) / ggx_G1(v, ax, ay); };
    return b;
}
template <class T>
microfacet<T> ggx(T a, draws how = draws::visible) {
    return ggx(a, a, how);
}

template <class T>
microfacet<T> beckmann(T a) {
    microfacet<T> b;
    b.D = [a](const vec3<T>& m) { return beckmann_D(m, a); };
    b.G = [a](const vec3<T>& v, const vec3<T>& l, const vec3<T>&) { return beckmann_G1(v, a) * beckmann_G1(l, a); };
    b = drawing_all(b);
    b.sample_m = [a](const vec3<T>&, const vec2<T>& u) {
        const T tan2 = -a * a * std::log(1 - u.x);
        return spherical(1 / std::sqrt(1 + tan2), 2 * pi<T> * u.y);
    };
    return b;
}

template <class T>
microfacet<T> blinn_phong(T n) {
    microfacet<T> b;
    b.D = [n](const vec3<T>& m) { return (n + 2) / (2 * pi<T>)*std::pow(m.z, n); };
    b.G = [](const vec3<T>& v, const vec3<T>& l, const vec3<T>& m) { return v_cavity(v, l, m); };
    b = drawing_all(b);
    b.sample_m = [n](const vec3<T>&, const vec2<T>& u) {
        return spherical(std::pow(1 - u.x, 1 / (n + 2)), 2 * pi<T> * u.y);
    };
    return b;
}

// ---- diffuse

template <class T>
vec3<T> cosine_hemisphere(const vec2<T>& u) {
    const T r = std::sqrt(u.x), phi = 2 * pi<T> * u.y;
    return {r * std::cos(phi), r * std::sin(phi), std::sqrt(1 - u.x)};
}

/// Any f(v,l), sampled by the cosine.
template <class T, class F>
auto diffuse(const F& f) {
    using S = std::decay_t<decltype(f(vec3<T>{}, vec3<T>{}))>;
    material<T, S> out;
    out.f_cos = [f](const vec3<T>& v, const vec3<T>& l) { return above(v, l) ? f(v, l) * l.z : S(0); };
    out.pdf = [](const vec3<T>& v, const vec3<T>& l) { return above(v, l) ? l.z / pi<T> : T(0); };
    out.sample = [f](const vec3<T>& v, const vec2<T>& u) {
        typename material<T, S>::drawn s;
        if (!(v.z > 0)) return s;
        s.l = cosine_hemisphere(u);
        s.pdf = s.l.z / pi<T>;
        s.weight = f(v, s.l) * pi<T>;
        return s;
    };
    return out;
}
template <class T>
material<T> lambert(T albedo) {
    return diffuse<T>([albedo](const vec3<T>&, const vec3<T>&) { return albedo / pi<T>; });
}

template <class T>
T oren_nayar(const vec3<T>& v, const vec3<T>& l, T albedo, T sigma, bool swapped = false, bool clamps = true) {
    const T s2 = sigma * sigma, A = 1 - s2 / (2 * (s2 + T(0.33))), B = T(0.45) * s2 / (s2 + T(0.09));
    const T sv = std::sqrt(std::max(T(0), 1 - v.z * v.z)), sl = std::sqrt(std::max(T(0), 1 - l.z * l.z));
    const T cos_phi = sv > T(1e-4) && sl > T(1e-4) ? (v.x * l.x + v.y * l.y) / (sv * sl) : T(0);
    const bool v_is_alpha = (v.z < l.z) != swapped;  // alpha is the larger angle
    const T sin_alpha = v_is_alpha ? sv : sl, tan_beta = v_is_alpha ? sl / l.z : sv / v.z;
    return albedo / pi<T> * (A + B * (clamps ? std::max(T(0), cos_phi) : cos_phi) * sin_alpha * tan_beta);
}

template <class T>
T burley(const vec3<T>& v, const vec3<T>& l, T albedo, T roughness) {
    const T d = clamped_dot(l, glm::normalize(v + l)), f90 = T(0.5) + 2 * d * d * roughness;
    const auto weight = [f90](T c) { return 1 + (f90 - 1) * std::pow(1 - c, T(5)); };
    return albedo / pi<T> * weight(v.z) * weight(l.z);
}

// ---- combinations

/// One of two lobes is drawn by u.x, which is stretched to [0,1) again.
struct selection {
    bool stretches_u = true, counts_a = true, counts_b = true, counts_probability = true, sums_weight = true;
};
template <class T>
material<T> mixture(const material<T>& a, const material<T>& b, T p, selection is = {}) {
    material<T> out;
    out.f_cos = [a, b](const vec3<T>& v, const vec3<T>& l) { return a.f_cos(v, l) + b.f_cos(v, l); };
    out.pdf = [a, b, p, is](const vec3<T>& v, const vec3<T>& l) {
        const T pa = is.counts_a ? a.pdf(v, l) : T(0), pb = is.counts_b ? b.pdf(v, l) : T(0);
        return is.counts_probability ? p * pa + (1 - p) * pb : pa + pb;
    };
    out.sample = [a, b, p, is, out](const vec3<T>& v, const vec2<T>& u) {
        const bool first = u.x < p;
        const T x = !is.stretches_u ? u.x : first ? u.x / p : std::min((u.x - p) / (1 - p), 1 - T(6e-8));
        auto s = first ? a.sample(v, {x, u.y}) : b.sample(v, {x, u.y});
        if (!(s.pdf > 0)) return typename material<T>::drawn{};
        s.pdf = out.pdf(v, s.l);
        if (is.sums_weight) s.weight = out.f_cos(v, s.l) / s.pdf;
        return s;
    };
    return out;
}

template <class T>
material<T, vec3<T>> tinted(const material<T>& m, const vec3<T>& color) {
    material<T, vec3<T>> out;
    out.f_cos = [m, color](const vec3<T>& v, const vec3<T>& l) { return color * m.f_cos(v, l); };
    out.pdf = m.pdf;
    out.sample = [m, color](const vec3<T>& v, const vec2<T>& u) {
        const auto s = m.sample(v, u);
        return typename material<T, vec3<T>>::drawn{s.l, color * s.weight, s.pdf};
    };
    return out;
}

/// v and l are given in world space, turned by `angle` against the tangent frame.
template <class T>
material<T> turned_frame(const material<T>& m, T angle) {
    material<T> out;
    out.f_cos = [m, angle](const vec3<T>& v, const vec3<T>& l) {
        return m.f_cos(turned(v, -angle), turned(l, -angle));
    };
    out.pdf = [m, angle](const vec3<T>& v, const vec3<T>& l) { return m.pdf(turned(v, -angle), turned(l, -angle)); };
    out.sample = [m, angle](const vec3<T>& v, const vec2<T>& u) {
        auto s = m.sample(turned(v, -angle), u);
        s.l = turned(s.l, angle);
        return s;
    };
    return out;
}

// ---- tables of what a lobe reflects, for compensations and for the diffuse part below

template <class T>
struct albedo_table {
    std::vector<T> E;
    T average;

    /// The mean weight of n x n samples, at `size` cosines.
    explicit albedo_table(const material<T>& m, int size = 129, int n = 48) {
        for (int i = 0; i < size; ++i) {
            const T mu = std::max(T(i) / T(size - 1), T(1e-3));
            T sum = 0;
            for (int k = 0; k < n * n; ++k)
                sum += m.sample(spherical(mu, T(0)), {(T(k / n) + T(0.5)) / T(n), (T(k % n) + T(0.5)) / T(n)}).weight;
            E.push_back(sum / T(n * n));
        }
        average = 0;
        for (int i = 0; i < 1024; ++i) average += 2 * (T(i) + T(0.5)) / 1024 * (*this)((T(i) + T(0.5)) / 1024) / 1024;
    }
    T operator()(T mu) const {
        const T x = std::clamp(mu, T(0), T(1)) * T(E.size() - 1);
        const std::size_t i = std::min(static_cast<std::size_t>(x), E.size() - 2);
        return E[i] + (x - T(i)) * (E[i + 1] - E[i]);
    }
};

/// Kulla & Conty 2017: what the table says is lost, returned diffusely. f(v,l), without the cosine.
template <class T>
std::function<T(const vec3<T>& v, const vec3<T>& l)> kulla_conty(const albedo_table<T>& E) {
    return [E](const vec3<T>& v, const vec3<T>& l) { return (1 - E(v.z)) * (1 - E(l.z)) / (pi<T> * (1 - E.average)); };
}

}  // namespace strangers
