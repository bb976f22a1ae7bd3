// What must hold for every input in the stated domain, to the rounding that follows from the formulas; and how a
// failure is reported.
#pragma once

#include "input.hpp"

#include <lobe/brdf/concepts.hpp>

#include <cstdio>
#include <cstdlib>

namespace fuzz {

/// What is being evaluated, for the report.
struct subject {
    const char* model = "";
    const char* scalar = "";
    const input* parameters = nullptr;
    double v[3] = {}, l[3] = {}, u[2] = {};
};
inline subject current;
inline std::uint64_t evaluations = 0, unresolved = 0;

[[noreturn, gnu::noinline, gnu::cold]] inline void fail(const char* what, double measured, double expected,
                                                        double tolerance) {
    const auto print = [](const char* name, double x) { std::fprintf(stderr, "  %-22s %.17g  %a\n", name, x, x); };
    std::fprintf(stderr, "\nbroken: %s\n  model                  %s, %s\n", what, current.model, current.scalar);
    if (current.parameters)
        current.parameters->for_each_parameter([&](const named_value& p) { print(p.name, p.value); });
    const char* const names[] = {"v.x", "v.y", "v.z", "l.x", "l.y", "l.z"};
    for (int i = 0; i < 6; ++i) print(names[i], i < 3 ? current.v[i] : current.l[i - 3]);
    print("u.x", current.u[0]), print("u.y", current.u[1]);
    print("measured", measured), print("expected", expected), print("tolerance", tolerance);
    if (current.parameters) {
        std::fprintf(stderr, "  bytes of the input     ");
        current.parameters->for_each_byte([](std::uint8_t byte) { std::fprintf(stderr, "%02x", byte); });
        std::fprintf(stderr, "\n");
    }
    std::abort();
}

template <class T>
void see(const lobe::vec3<T>& v, const lobe::vec3<T>& l, const lobe::vec2<T>& u) {
    for (int i = 0; i < 3; ++i) current.v[i] = static_cast<double>(v[i]), current.l[i] = static_cast<double>(l[i]);
    current.u[0] = static_cast<double>(u.x), current.u[1] = static_cast<double>(u.y);
}

template <class T>
void expect(bool holds, const char* what, const T& measured, const T& expected = T(0), const T& tolerance = T(0)) {
    if (!holds) [[unlikely]]
        fail(what, static_cast<double>(measured), static_cast<double>(expected), static_cast<double>(tolerance));
}

template <class T>
void expect_near(const char* what, const T& measured, const T& expected, const T& tolerance) {
    expect(finite(measured) && std::abs(measured - expected) <= tolerance, what, measured, expected, tolerance);
}

/// Neither infinite nor a NaN, read off the bits: -ffast-math takes std::isfinite for true.
inline bool finite(float x) { return (std::bit_cast<std::uint32_t>(x) & 0x7f800000u) != 0x7f800000u; }
inline bool finite(double x) { return (std::bit_cast<std::uint64_t>(x) & 0x7ff0000000000000u) != 0x7ff0000000000000u; }

template <class T>
void expect_light(const char* what, const T& x) {
    expect(finite(x) && x >= T(0), what, x);
}
template <class T>
void expect_light(const char* what, const lobe::vec3<T>& x) {
    for (int i = 0; i < 3; ++i) expect_light(what, x[i]);
}

/// u, the largest relative error of one rounding.
template <class T>
constexpr T roundoff = std::numeric_limits<T>::epsilon() / T(2);

/// With -ffast-math two calls of one formula round in orders of their own, which shows where it is ill-conditioned (v +
/// l of opposite directions, the critical angle), and denormals are zeros; at the horizon cos^-4 must not overflow.
#ifdef __FAST_MATH__
constexpr bool fast_math = true;
#else
constexpr bool fast_math = false;
#endif
constexpr int two_calls = fast_math ? 4096 : 8;  // u; by default a few products in another order
template <class T>
constexpr T smallest = fast_math ? std::numeric_limits<T>::min() : std::numeric_limits<T>::denorm_min();
template <class T>
constexpr T lowest_normal = fast_math ? (sizeof(T) == 4 ? T(1e-9) : T(1e-76)) : T(0);

/// | |w|^2 - 1 |. A direction rounded from a unit vector: 6 u. `reflect(v, m)` of a normalised m: |v|^2 and 4 (v.m)^2
/// (|m|^2 - 1) with |m|^2 within 7 u; v.m within 3 u, and l.m of it back in |l|^2: 12 u; the roundings of the products
/// and of the difference: 10 u.
template <class T>
void expect_unit(const char* what, const lobe::vec3<T>& w) {
    expect_near(what, lobe::dot(w, w), T(1), T(64) * roundoff<T>);
}

struct facts {
    bool reciprocal = true;
    int terms = 1;             // lobes that are added
    bool exponential = false;  // the rounding of D grows with its logarithm
    bool fitted_area = false;  // Walter's rational fit of the projected area, a little negative near its end
    int cases = 256;
};

/// The absolute error that underflow may leave in what is divided by the widths (D) and by the cosines (masking).
template <class T>
T underflow(const lobe::vec2<T>& width, const lobe::vec3<T>& v, const lobe::vec3<T>& l) {
    const T small = smallest<T> * T(16);
    return small / lobe::smaller(width.x * width.y, T(1)) / lobe::larger(v.z * l.z, std::numeric_limits<T>::min());
}

/// By how much g(l) changes when each component of l does by `delta`: to first order, and doubled for the rest.
template <class T, class G>
T change(const G& g, const lobe::vec3<T>& l, const T& delta) {
    T total(0);
    for (int i = 0; i < 3; ++i) {
        lobe::vec3<T> above = l, below = l;
        above[i] += delta, below[i] -= delta;
        const T here = g(l), up = std::abs(g(above) - here), down = std::abs(g(below) - here);
        total += T(2) * lobe::larger(up, down);
    }
    return total;
}

/// |measured - g(l)| is the rounding of both, `relative`, or of l. The sampled facet m is known to a few u, and l =
/// reflect(v, m) to less than 12 u in each component: v.m within 3 u, four roundings of numbers up to 2. F takes its
/// cosine from m there and from |v + l|/2 here, which differ by less than 12 u: as l does by 24 u along m. Where that
/// decides the result alone, nothing can be said; such cases are counted. The change of g tells, and where a narrow
/// lobe may hide between two values of l, `turned`: by how many widths m turns.
template <class T, class G, class Absolute>
void expect_conditioned(const char* what, const T& measured, const G& g, const lobe::vec3<T>& l, const T& turned,
                        const T& relative, const Absolute& absolute) {
    const T expected = g(l), most = lobe::larger(measured, expected);
    expect(finite(measured) && finite(expected), what, measured, expected);
    T rounding = relative * most;
    if (std::abs(measured - expected) <= rounding) return;
    rounding += absolute();
    const T moved = change(g, l, T(24) * roundoff<T>);
    if (moved >= most / T(4) || turned >= T(1) / T(4))
        ++unresolved;
    else
        expect_near(what, measured, expected, rounding + moved);
}

/// Cosines below it, above the horizon, promise numbers, not digits.
template <class T>
bool resolved(const lobe::vec3<T>& w) {
    return w.z <= T(0) || w.z >= static_cast<T>(1e-6);
}

/// Everything that a BRDF of an rgb spectrum promises. `rounding_of_F(v, l, i)`: how far the rounding of F takes f_cos,
/// with the cosine that F is asked at.
template <class B, class Rounding, class T = typename B::scalar>
void check_brdf(const B& b, const Rounding& rounding_of_F, const facts& facts, const lobe::vec3<T>& v,
                const lobe::vec3<T>& l, const lobe::vec2<T>& u) {
    if (fast_math && !(resolved(v) && resolved(l))) return;
    constexpr T r = roundoff<T>;
    see(v, l, u);
    const auto f = b.f(v, l), back = b.f(l, v), f_cos = b.f_cos(v, l);
    const auto e = b.evaluate(v, l);
    const T pdf = b.pdf(v, l);
    evaluations += 5;
    expect_light("f", f);
    expect_light("f_cos", f_cos);
    expect_light("pdf", pdf);
    expect_light("evaluate's f_cos", e.f_cos);
    expect_light("evaluate's pdf", e.pdf);
    const bool above = lobe::above_horizon(v, l), digits = resolved(v) && resolved(l);
    const T none = above ? underflow(b.width(), v, l) : T(0), sum = T(facts.terms);
    for (int i = 0; i < 3; ++i) {
        if (!above) {
            expect(f[i] == T(0) && f_cos[i] == T(0) && e.f_cos[i] == T(0), "zero below the horizon", f_cos[i]);
            continue;
        }
        if (!digits) continue;
        const T any_order = none + (fast_math ? rounding_of_F(v, l, i) / l.z : T(0));
        expect_near("f_cos = f cos(theta_l)", f_cos[i], f[i] * l.z, T(two_calls) * sum * r * f_cos[i] + any_order);
        expect_near("evaluate's f_cos", e.f_cos[i], f_cos[i], T(two_calls) * sum * r * f_cos[i] + any_order);
        // Smith's correlated denominator is grouped after v: three roundings of positive terms, each way, and those of
        // the quotient
        if (facts.reciprocal)
            expect_near("f(v,l) = f(l,v)", f[i], back[i], T(2 * two_calls) * sum * r * f[i] + any_order);
    }
    if (!above) expect(pdf == T(0) && e.pdf == T(0), "pdf below the horizon", pdf);
    // of a base that 1 - F leaves: 1 - F is rounded like 1
    const T share = fast_math && facts.terms > 1 ? T(16) * r : T(0);
    if (digits) expect_near("evaluate's pdf", e.pdf, pdf, T(two_calls) * sum * r * pdf + none + share);

    const auto s = b.sample(v, u);
    evaluations += 1;
    expect_light("weight", s.weight);
    expect_light("sample's pdf", s.pdf);
    if (s.pdf == T(0)) {
        expect(s.l == lobe::vec3<T>{T(0), T(0), T(1)}, "a failed sample's l", s.l.z, T(1));
        for (int i = 0; i < 3; ++i) expect(s.weight[i] == T(0), "a failed sample's weight", s.weight[i]);
        return;
    }
    see(v, s.l, u);
    expect(lobe::above_horizon(v, s.l), "a sample from and to above the horizon", s.l.z);
    expect_unit("|l| = 1", s.l);
    if (!(resolved(v) && resolved(s.l))) return;
    const T floor = underflow(b.width(), v, s.l);
    // GGX's D within 12 ULP on both sides, the rest within 8; others as they state
    const T logarithms =
        std::abs(std::log(s.pdf)) + std::abs(std::log(b.width().x * b.width().y)) + std::abs(std::log(v.z * s.l.z));
    T rounding = facts.exponential ? T(40) * r * (T(4) + logarithms) : T(64) * sum * r;
    if (fast_math) rounding *= T(64);
    const T turned = T(24) * r / (v.z + s.l.z) / lobe::smaller(b.width().x, b.width().y);
    expect_conditioned(
        "pdf(v, l) = the sample's pdf", s.pdf, [&](const lobe::vec3<T>& w) { return b.pdf(v, w); }, s.l, turned,
        rounding, [&] { return floor + share; });
    for (int i = 0; i < 3; ++i)
        expect_conditioned(
            "weight pdf = f_cos(v, l)", s.weight[i] * s.pdf, [&](const lobe::vec3<T>& w) { return b.f_cos(v, w)[i]; },
            s.l, turned, rounding, [&] { return floor + rounding_of_F(v, s.l, i); });
    evaluations += 4;
}

/// Visible normals under a Smith masking: weight <= F(v.m), v.m known from |v + l|/2 to 8 u.
template <class B, class F, class T = typename B::scalar>
void check_weight(const B& b, const F& fresnel, const lobe::vec3<T>& v, const lobe::vec2<T>& u) {
    if (!resolved(v)) return;
    constexpr T r = roundoff<T>, near = T(8) * r;
    const auto s = b.sample(v, u);
    evaluations += 1;
    const T c = lobe::length(v + s.l) / T(2);
    const auto cosine = [](const T& x) { return lobe::smaller(lobe::larger(x, T(0)), T(1)); };
    const auto at = fresnel(cosine(c)), more = fresnel(cosine(c + near)), less = fresnel(cosine(c - near));
    for (int i = 0; i < 3; ++i) {
        const T most = lobe::larger(at[i], lobe::larger(more[i], less[i]));
        expect(s.weight[i] <= most + T(32) * r, "weight <= F", s.weight[i], most, T(32) * r);
    }
}

/// No promise but to come back: any bits as directions and numbers.
template <class B, class T = typename B::scalar>
void call_brdf(const B& b, const lobe::vec3<T>& v, const lobe::vec3<T>& l, const lobe::vec2<T>& u) {
    see(v, l, u);
    volatile T sink = b.f(v, l).x + b.f_cos(v, l).x + b.pdf(v, l) + b.evaluate(v, l).pdf + b.sample(v, u).pdf;
    static_cast<void>(sink);
    evaluations += 5;
}

}  // namespace fuzz
