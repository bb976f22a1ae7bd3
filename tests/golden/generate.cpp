// The golden values of docs/reference: generate FOLDER [points]. It includes nothing of lobe: the formulas are
// written down here
// a second time, as they are printed, on 50 digits; the integrals in long double by two resolutions.
#include <boost/math/constants/constants.hpp>
#include <boost/math/special_functions/erf.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>

#include <array>
#include <cmath>
#include <fstream>
#include <functional>
#include <iomanip>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using R = boost::multiprecision::cpp_bin_float_50;

template <class T>
T pi() {
    return boost::math::constants::pi<T>();
}

template <class T>
struct vec {
    T x, y, z;
    vec operator+(const vec& b) const { return {x + b.x, y + b.y, z + b.z}; }
    vec operator*(const T& s) const { return {x * s, y * s, z * s}; }
};
template <class T>
T dot(const vec<T>& a, const vec<T>& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class T>
vec<T> unit(const vec<T>& w) {
    using std::sqrt;
    return w * (1 / sqrt(dot(w, w)));
}

enum class normals { ggx, beckmann };

/// Distribution of normals and Smith's Lambda. GGX: Walter et al. 2007, eq. 33, anisotropic as Burley 2012, eq. 13;
/// Beckmann: Walter et al. 2007, eq. 25; Lambda: Heitz 2014, eq. 72, 68, widths by eq. 80.
template <class T>
struct surface {
    normals kind;
    T ax, ay;

    T D(const vec<T>& of) const {
        using std::exp;
        const vec<T> m = unit(of);
        const T slope2 = m.x * m.x / (ax * ax) + m.y * m.y / (ay * ay), c2 = m.z * m.z;
        if (kind == normals::beckmann) return exp(-slope2 / c2) / (pi<T>() * ax * ay * c2 * c2);
        return 1 / (pi<T>() * ax * ay * (slope2 + c2) * (slope2 + c2));
    }
    T lambda(const vec<T>& w) const {
        using std::exp, std::sqrt, boost::math::erfc;
        const T tan2 = (ax * ax * w.x * w.x + ay * ay * w.y * w.y) / (w.z * w.z);  // 1/a^2
        if (kind == normals::ggx) return tan2 / (2 * (sqrt(1 + tan2) + 1));
        if (!(tan2 > T(1e-7))) return 0;  // exp(-1e7)
        const T a = 1 / sqrt(tan2);
        return (exp(-a * a) / (a * sqrt(pi<T>())) - erfc(a)) / 2;
    }
    T G1(const vec<T>& w) const { return 1 / (1 + lambda(w)); }
    T G2(const vec<T>& v, const vec<T>& l) const { return 1 / (1 + lambda(v) + lambda(l)); }
    T V(const vec<T>& v, const vec<T>& l) const { return G2(v, l) / (4 * v.z * l.z); }
};

template <class T>
T schlick(const T& F0, const T& c) {  // Schlick 1994
    const T d = 1 - c, d2 = d * d;
    return F0 + (1 - F0) * d2 * d2 * d;
}
/// Fresnel's equations for unpolarised light, from the air: index n, extinction k.
template <class T>
T dielectric(const T& n, const T& c) {
    using std::sqrt;
    const T t = sqrt(n * n - 1 + c * c) / n, s = (c - n * t) / (c + n * t), p = (n * c - t) / (n * c + t);
    return (s * s + p * p) / 2;
}
template <class T>
T conductor(const T& n, const T& k, const T& c) {  // Born & Wolf 1999, section 14.2
    using std::sqrt;
    const T s2 = 1 - c * c, d = n * n - k * k - s2, q = sqrt(d * d + 4 * n * n * k * k), a = sqrt((q + d) / 2);
    const T Rs = (q + c * c - 2 * a * c) / (q + c * c + 2 * a * c);
    return Rs * (1 + (q * c * c + s2 * s2 - 2 * a * c * s2) / (q * c * c + s2 * s2 + 2 * a * c * s2)) / 2;
}

// ---- Integrals

/// Tanh-sinh (Takahasi & Mori 1974) over (0, length) in steps of h: f(x, length - x), each exact to its last digits.
template <class T, class F>
auto tanh_sinh(const T& length, const T& h, const F& f) {
    using std::cosh, std::exp, std::sinh;
    auto sum = f(length / 2, length / 2) * (pi<T>() / 4 * length);
    for (int i = 1; i * h < T(4); ++i) {
        const T t = i * h, e = exp(-pi<T>() * sinh(t)), end = length * e / (1 + e);
        const T weight = length * pi<T>() * cosh(t) * e / ((1 + e) * (1 + e));
        sum = sum + f(end, length - end) * weight + f(length - end, end) * weight;
    }
    return sum * h;
}

/// A and B of E = F0 A + B: int G2 (v.m)/cos(theta_v) D dm with the weights 1 - Fc and Fc = (1 - v.m)^5. m = (t
// cos, t
/// sin, 1)/sqrt(1 + t^2), t = alpha x, up to where l meets the horizon.
template <class T>
struct terms {
    T A, B;
    terms operator+(const terms& o) const { return {A + o.A, B + o.B}; }
    terms operator*(const T& s) const { return {A * s, B * s}; }
};
template <class T>
terms<T> split_sum(normals kind, const T& alpha, const T& mu, const T& h) {
    using std::atan, std::cos, std::exp, std::sin, std::sqrt;
    const surface<T> s{kind, alpha, alpha};
    const vec<T> v{sqrt((1 - mu) * (1 + mu)), 0, mu};
    const T lambda_v = s.lambda(v);
    const auto along = [&](const T& cos_phi) {
        const T k = v.x * cos_phi / mu, root = sqrt(1 + k * k), t_max = k > 0 ? k + root : 1 / (root - k);
        // at the slope alpha x, of the density P(x)/pi, `left` below where l meets the horizon
        const auto at = [&](const T& x, const T& left, const T& P) {
            const T t = alpha * x, t2 = 1 + t * t, v_m = (v.x * t * cos_phi + mu) / sqrt(t2);
            const T l_z = mu * alpha * left * (t + 1 / t_max) / t2;
            const vec<T> l{sqrt((l_z < 1 ? 1 - l_z : T(0)) * (1 + l_z)), 0, l_z};
            const T E = P / pi<T>() * x * sqrt(t2) * v_m / mu / (1 + lambda_v + s.lambda(l));
            const T d = (1 - v_m), Fc = d * d * d * d * d;
            return terms<T>{E * (1 - Fc), E * Fc};
        };
        const T X = t_max / alpha, last = 8;  // exp(-64)
        if (kind == normals::beckmann)
            return tanh_sinh<T>(X < last ? X : last, h, [&](const T& x, const T& left) {
                return at(x, X < last ? left : left + (X - last), exp(-x * x));
            });
        const T cos_top = 1 / sqrt(1 + X * X), sin_top = X * cos_top;  // x = tan(psi)
        return tanh_sinh<T>(atan(X), h, [&](const T& psi, const T& left) {
            const T cosine = cos_top * cos(left) + sin_top * sin(left), x = sin(psi) / cosine;
            const T P = 1 / ((1 + x * x) * (1 + x * x));
            return at(x, sin(left) / (cos_top * cosine), P) * (1 / (cosine * cosine));
        });
    };
    const auto half = [&](const T& sign) {  // both sides of cos(phi) = 0, where a grazing view turns
        return tanh_sinh<T>(pi<T>() / 2, h, [&](const T& from_zero, const T& to_side) {
            return along(sign * (to_side < from_zero ? sin(to_side) : cos(from_zero)));
        });
    };
    return (half(T(1)) + half(T(-1))) * T(2);
}
template <class T>
terms<T> average(normals kind, const T& alpha, const T& h) {
    return tanh_sinh<T>(T(1), h, [&](const T& mu, const T&) { return split_sum<T>(kind, alpha, mu, h) * (2 * mu); });
}

// ---- The table

struct row {
    std::string normals, ax, ay, quantity;
    std::array<std::string, 6> w;
    std::string value, condition;
};
std::vector<row> table;

std::string text(const R& x, int digits) {
    std::ostringstream out;
    out << std::setprecision(digits) << x;
    return out.str();
}

/// A quantity of decimal inputs, and by how many units of their last place it moves where each is off by one half:
/// sum |x df/dx| / |f|.
void add(const std::string& normals, const std::string& quantity, const std::vector<std::string>& in,
         std::size_t widths, const std::function<R(const std::vector<R>&)>& f) {
    std::vector<R> x;
    for (const std::string& s : in) x.emplace_back(s);
    const R value = f(x);
    if (!(value > R("1e-30"))) return;
    R condition = 0;
    const R h("1e-16");
    for (std::size_t i = 0; i < x.size(); ++i) {
        std::vector<R> more = x, less = x;
        more[i] *= 1 + h, less[i] *= 1 - h;
        condition += abs(f(more) - f(less)) / (2 * h * value);
    }
    row r{normals, widths > 0 ? in[0] : "", widths > 1 ? in[1] : "", quantity, {}, text(value, 20), text(condition, 3)};
    for (std::size_t i = widths; i < in.size(); ++i) r.w[i - widths] = in[i];
    table.push_back(r);
}
std::vector<std::string> joined(std::vector<std::string> a, const vec<R>& v) {
    for (const R& x : {v.x, v.y, v.z}) a.push_back(text(x, 25));
    return a;
}
vec<R> direction(const R& cosine, const R& azimuth) {
    const R sine = sqrt((1 - cosine) * (1 + cosine));
    return {sine * cos(azimuth), sine * sin(azimuth), cosine};
}

void points(normals kind, const std::string& name, const std::string& ax, const std::string& ay) {
    const std::vector<std::string> widths{ax, ay};
    const auto of = [kind](const std::vector<R>& x) { return surface<R>{kind, x[0], x[1]}; };
    const auto at = [](const std::vector<R>& x, std::size_t i) { return vec<R>{x[i], x[i + 1], x[i + 2]}; };
    const R w = sqrt(R(ax) * R(ay));
    for (const char* slope : {"0", "0.5", "1", "3", "30"}) {
        const vec<R> m = unit(vec<R>{R(slope) * w * cos(R("0.7")), R(slope) * w * sin(R("0.7")), R(1)});
        add(name, "D", joined(widths, m), 2, [=](const std::vector<R>& x) { return of(x).D(at(x, 2)); });
    }
    for (const char* cosine : {"1", "0.9", "0.5", "0.1", "0.01", "0.001"}) {
        const vec<R> v = direction(R(cosine), R("0.4"));
        const auto in = joined(widths, v);
        add(name, "Lambda", in, 2, [=](const std::vector<R>& x) { return of(x).lambda(at(x, 2)); });
        add(name, "G1", in, 2, [=](const std::vector<R>& x) { return of(x).G1(at(x, 2)); });
        for (const auto& [slope, azimuth] : {std::pair("0.2", "1"), {"1.5", "-1"}}) {
            const vec<R> m = unit(vec<R>{R(slope) * w * cos(R(azimuth)), R(slope) * w * sin(R(azimuth)), R(1)});
            const vec<R> l = m * (2 * dot(v, m)) + v * R(-1);
            if (!(l.z > R("1e-3"))) continue;
            const auto pair = joined(in, l);
            add(name, "G2", pair, 2, [=](const std::vector<R>& x) { return of(x).G2(at(x, 2), at(x, 5)); });
            add(name, "G2_separable", pair, 2,
                [=](const std::vector<R>& x) { return of(x).G1(at(x, 2)) * of(x).G1(at(x, 5)); });
            add(name, "V", pair, 2, [=](const std::vector<R>& x) { return of(x).V(at(x, 2), at(x, 5)); });
            const auto f = [=](const std::vector<R>& x) {
                const vec<R> a = at(x, 2), b = at(x, 5), half = a + b;
                return schlick(R("0.04"), R(sqrt(dot(half, half)) / 2)) * of(x).D(half) * of(x).V(a, b);
            };
            add(name, "f", pair, 2, f);
            add(name, "f_cos", pair, 2, [=](const std::vector<R>& x) { return R(f(x) * x[7]); });
            add(name, "pdf", pair, 2, [=](const std::vector<R>& x) {
                return R(of(x).G1(at(x, 2)) * of(x).D(at(x, 2) + at(x, 5)) / (4 * x[4]));
            });
        }
    }
}

double worst = 0, worst_average = 0;
void integrals(normals kind, const std::string& name, const std::string& alpha) {
    using T = long double;
    const auto add_terms = [&](const std::string& suffix, const std::string& mu, const terms<T>& e) {
        for (const auto& [quantity, x] : {std::pair("E", e.A + e.B), {"A", e.A}, {"B", e.B}}) {
            std::ostringstream out;
            out << std::setprecision(10) << x;
            table.push_back({name, alpha, alpha, quantity + suffix, {"", "", mu}, out.str(), ""});
        }
    };
    const auto apart = [](const terms<T>& a, const terms<T>& b) {
        return static_cast<double>((std::max)(std::abs(a.A - b.A), std::abs(a.B - b.B)));
    };
    const T a = std::stold(alpha);
    for (const char* mu : {"1", "0.9", "0.5", "0.1", "0.01", "0.001"}) {
        const terms<T> e = split_sum<T>(kind, a, std::stold(mu), 1 / T(32));
        worst = (std::max)(worst, apart(e, split_sum<T>(kind, a, std::stold(mu), 1 / T(24))));
        add_terms("", mu, e);
    }
    const terms<T> e = average<T>(kind, a, 1 / T(20));
    worst_average = (std::max)(worst_average, apart(e, average<T>(kind, a, 1 / T(16))));
    add_terms("_average", "", e);
}

void fresnel() {
    for (const char* c : {"1", "0.9", "0.5", "0.1", "0.01", "0.001"}) {
        const std::vector<std::string> in{"0", "0", c};
        add("", "F_schlick_0.04", in, 0, [](const std::vector<R>& x) { return schlick(R("0.04"), x[2]); });
        add("", "F_dielectric_1.5", in, 0, [](const std::vector<R>& x) { return dielectric(R("1.5"), x[2]); });
        add("", "F_conductor_0.2_3.9", in, 0,
            [](const std::vector<R>& x) { return conductor(R("0.2"), R("3.9"), x[2]); });
    }
}

void write(const std::string& folder) {
    const char* const columns[] = {"normals", "alpha_x", "alpha_y", "quantity", "v_x",   "v_y",
                                   "v_z",     "l_x",     "l_y",     "l_z",      "value", "condition"};
    std::ofstream csv(folder + "/golden.csv"), json(folder + "/golden.json");
    csv << "# CC0 1.0: golden values of microfacet reflectance; docs/golden.md says how each was made and how to "
           "compare\n";
    json << "{\"license\": \"CC0-1.0\", \"about\": \"docs/golden.md\", \"rows\": [";
    for (const char* c : columns) csv << (c == columns[0] ? "" : ",") << c;
    csv << '\n';
    for (const row& r : table) {
        const std::string* const all[] = {&r.normals, &r.ax,   &r.ay,   &r.quantity, &r.w[0],  &r.w[1],
                                          &r.w[2],    &r.w[3], &r.w[4], &r.w[5],     &r.value, &r.condition};
        json << (&r == table.data() ? "\n{" : ",\n{");
        bool first = true;
        for (std::size_t i = 0; i < std::size(all); ++i) {
            csv << (i ? "," : "") << *all[i];
            if (all[i]->empty()) continue;
            const bool word = i == 0 || i == 3;
            json << (first ? "" : ", ") << '"' << columns[i] << "\": " << (word ? "\"" : "") << *all[i]
                 << (word ? "\"" : "");
            first = false;
        }
        csv << '\n';
        json << '}';
    }
    json << "\n]}\n";
    if (!csv.flush() || !json.flush()) throw std::runtime_error(folder + ": cannot be written");
}

}  // namespace

int main(int argc, char** argv) try {
    if (argc != 2 && (argc != 3 || argv[2] != std::string("points")))
        throw std::runtime_error("generate FOLDER [points]");
    fresnel();
    for (const auto& [kind, name] : {std::pair(normals::ggx, "ggx"), {normals::beckmann, "beckmann"}}) {
        for (const char* alpha : {"0.0001", "0.01", "0.1", "0.5", "1"}) {
            points(kind, name, alpha, alpha);
            if (argc == 2) integrals(kind, name, alpha);
        }
        for (const auto& [ax, ay] : {std::pair("0.1", "0.4"), {"0.001", "0.5"}, {"1", "0.01"}})
            points(kind, name, ax, ay);
    }
    // E of alpha 1 is 1 - mu ln(1 + 1/mu); and one integral on 50 digits.
    const terms<long double> in_long = split_sum<long double>(normals::ggx, 0.5L, 0.5L, 1 / 20.0L);
    const terms<R> in_R = split_sum<R>(normals::ggx, R("0.5"), R("0.5"), R(1) / 10);
    const terms<long double> one = split_sum<long double>(normals::ggx, 1, 0.5L, 1 / 20.0L);
    std::cout << table.size() << " values. Integrals of two resolutions differ by " << worst
              << " (averages: " << worst_average << "), from 50 digits by "
              << abs(R(in_long.A + in_long.B) - in_R.A - in_R.B).str(2) << ", from the closed form by "
              << static_cast<double>(std::abs(one.A + one.B - (1 - 0.5L * std::log(3.0L)))) << '\n';
    write(argv[1]);
} catch (const std::exception& e) {
    std::cerr << e.what() << '\n';
    return 1;
}
