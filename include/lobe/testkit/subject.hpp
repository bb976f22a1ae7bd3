// A stranger's BRDF as the kit sees it: which scalar it computes in, which functions it has; every value it returns is watched.
#pragma once

#include <lobe/core/vector.hpp>
#include <lobe/testkit/options.hpp>
#include <lobe/testkit/report.hpp>

#include <array>
#include <cassert>
#include <concepts>
#include <cstdint>
#include <exception>
#include <functional>
#include <limits>
#include <random>
#include <string>
#include <type_traits>

namespace lobe::testkit {

namespace detail {

/// The number that a spectrum consists of, and how many: of a number, a GLM vector, anything with a size that [] reads, or r, g, b.
template <class S>
concept has_size = requires(const S s) {
    std::tuple_size<S>::value;
    static_cast<double>(s[0]);
};
template <class S>
concept has_iterators = requires(const S s) {
    static_cast<double>(*s.begin());
    s.end() - s.begin();
};
template <class S>
concept has_rgb = requires(const S s) {
    static_cast<double>(s.r);
    static_cast<double>(s.g);
    static_cast<double>(s.b);
};

template <class S>
struct spectrum;
template <class S>
    requires std::is_arithmetic_v<S>
struct spectrum<S> {
    using scalar = S;
    static constexpr std::size_t size = 1;
    static double get(const S& s, std::size_t) { return static_cast<double>(s); }
};
template <glm::length_t N, class T, glm::qualifier Q>
struct spectrum<glm::vec<N, T, Q>> {
    using scalar = T;
    static constexpr std::size_t size = static_cast<std::size_t>(N);
    static double get(const glm::vec<N, T, Q>& s, std::size_t i) { return static_cast<double>(s[static_cast<glm::length_t>(i)]); }
};
template <has_size S>
struct spectrum<S> {
    using scalar = std::remove_cvref_t<decltype(std::declval<const S&>()[0])>;
    static constexpr std::size_t size = std::tuple_size<S>::value;
    static double get(const S& s, std::size_t i) { return static_cast<double>(s[i]); }
};
template <has_iterators S>
    requires(!has_size<S>)
struct spectrum<S> {
    using scalar = std::remove_cvref_t<decltype(*std::declval<const S&>().begin())>;
    static constexpr std::size_t size = 16;  // its own size is known at run time only
    static double get(const S& s, std::size_t i) {
        const auto count = static_cast<std::size_t>(s.end() - s.begin());
        assert(count <= size && "a spectrum of at most 16 numbers");
        return i < count ? static_cast<double>(*(s.begin() + static_cast<std::ptrdiff_t>(i))) : 0;
    }
};
template <has_rgb S>
    requires(!has_size<S> && !has_iterators<S>)
struct spectrum<S> {
    using scalar = std::remove_cvref_t<decltype(std::declval<const S&>().r)>;
    static constexpr std::size_t size = 3;
    static double get(const S& s, std::size_t i) { return static_cast<double>(i == 0 ? s.r : i == 1 ? s.g : s.b); }
};

template <class S>
concept is_spectrum = requires {
    typename spectrum<S>::scalar;
};
/// Whether it is float or double that S is computed in.
template <class S>
using scalar_of_spectrum = std::conditional_t<std::is_same_v<typename spectrum<S>::scalar, float>, float, double>;

template <class B, class V>
concept has_f_cos = requires(const B& b, const V w) {
    b.f_cos(w, w);
};
template <class B, class V>
concept is_f_cos = !has_f_cos<B, V> && requires(const B& b, const V w) {
    b(w, w);
};

template <class V, class B>
decltype(auto) call_f_cos(const B& b, const V& v, const V& l) {
    if constexpr (has_f_cos<B, V>)
        return b.f_cos(v, l);
    else
        return b(v, l);
}

template <class B, class V>
concept has_any_f_cos = has_f_cos<B, V> || is_f_cos<B, V>;
template <class B, class V>
concept returns_spectrum = has_any_f_cos<B, V> && requires(const B& b, const V w) {
    requires is_spectrum<std::remove_cvref_t<decltype(call_f_cos(b, w, w))>>;
};

/// `B::scalar` where given, else that of the value returned. (What takes double vectors may take float ones: GLM converts silently.)
template <class B>
auto scalar_of_brdf() {
    if constexpr (requires { typename B::scalar; }) {
        return typename B::scalar{};
    } else if constexpr (has_any_f_cos<B, vec3<double>>) {
        using value = std::remove_cvref_t<decltype(call_f_cos(std::declval<const B&>(), vec3<double>{}, vec3<double>{}))>;
        return scalar_of_spectrum<value>{};
    } else {
        return float{};
    }
}

/// Where a value was asked for: ready to paste.
template <class T>
std::string literal(T x) {
    std::string text = number(static_cast<double>(x), std::is_same_v<T, float> ? 9 : 17);
    if (!std::isfinite(x)) return text;
    if (text.find_first_of(".e") == std::string::npos) text += ".0";
    return text + (std::is_same_v<T, float> ? "f" : "");
}
template <class T>
std::string literal(const char* name, const vec3<T>& w) {
    return std::string(std::is_same_v<T, float> ? "glm::vec3 " : "glm::dvec3 ") + name + "{" + literal(w.x) + ", " + literal(w.y) + ", " +
           literal(w.z) + "}; ";
}
template <class T>
std::string literal(const char* name, const vec2<T>& u) {
    return std::string(std::is_same_v<T, float> ? "glm::vec2 " : "glm::dvec2 ") + name + "{" + literal(u.x) + ", " + literal(u.y) + "}; ";
}

/// Directions and numbers that a value was computed from.
template <class T>
struct place {
    vec3<T> v{}, l{};
    vec2<T> u{};
    bool has_l = true, has_u = false;
    const char* first = "v";  // what v is: a normal, in places of a distribution
    std::string text() const { return literal(first, v) + (has_l ? literal("l", l) : "") + (has_u ? literal("u", u) : ""); }
};

/// Uniform in [0,1), the same on every platform.
class generator {
public:
    explicit generator(std::uint64_t seed) : engine(seed) {}
    double operator()() { return static_cast<double>(engine() >> 11) * 0x1p-53; }
    double log_between(double low, double high) { return low * std::exp((*this)() * std::log(high / low)); }
    std::uint64_t bits() { return engine(); }

private:
    std::mt19937_64 engine;
};

/// A number of [0,1) in T: rounding may not turn it into 1.
template <class T>
T below_one(double u) {
    return (std::min)(static_cast<T>(u), T(1) - std::numeric_limits<T>::epsilon() / 2);
}

template <class T>
vec3<T> direction(double cosine, double azimuth) {
    const double sine = std::sqrt((1 - cosine) * (1 + cosine));
    return {static_cast<T>(sine * std::cos(azimuth)), static_cast<T>(sine * std::sin(azimuth)), static_cast<T>(cosine)};
}

inline constexpr double tau = 6.283185307179586;
inline constexpr double golden_angle = 2.399963229728653;

/// How far a value moves when every component of v and l moves by a few units of rounding: what rounding inside the function, or in
/// its inputs, does to it there.
template <class T, class F>
double rounding_noise(const F& value, const place<T>& at, int steps = 32) {
    generator random(7);
    const double exact = value(at.v, at.l);
    double noise = 0;
    for (int i = 0; i < steps; ++i) {
        // Both a little longer or shorter, which changes no half vector but how its components round; then each component.
        const T scale = T(1) + static_cast<T>(2 * random() - 1) * T(16) * std::numeric_limits<T>::epsilon();
        vec3<T> v = at.v * scale, l = at.l * scale;
        for (vec3<T>* w : {&v, &l})
            for (int k = 0; k < 3; ++k) {
                const double step = (2 * random() - 1) * 4 * static_cast<double>(std::numeric_limits<T>::epsilon());
                const T moved = static_cast<T>(static_cast<double>((*w)[k]) + step);
                (*w)[k] = k < 2 || (moved > T(0)) == ((*w)[k] > T(0)) ? moved : (*w)[k] / T(2);  // the horizon is not crossed
            }
        noise = (std::max)(noise, std::abs(value(v, l) - exact));
    }
    return noise;
}

/// Counts what is never right: values that are not finite, negative, or positive below the horizon; keeps the first of each.
template <class T>
struct watch {
    explicit watch(const char* function) : what(function) {}

    static constexpr double rounding = 1e-6;  // what float leaves of a difference of numbers near 1

    std::string what;
    long calls = 0, not_finite = 0, negative = 0, below = 0;
    double nan_value = 0, negative_value = 0, below_value = 0;
    place<T> nan_place{}, negative_place{}, below_place{};

    /// The value itself where it is a number, else 0. `again(v, l)` asks for it elsewhere: a sign that rounding decides is no fault.
    template <class Again>
    double see(double x, const place<T>& at, bool must_vanish, const Again& again) {
        const bool by_rounding = x < -rounding && negative < 100 && std::isfinite(x) && -x <= 4 * rounding_noise(again, at);
        return by_rounding ? 0 : see(x, at, must_vanish);
    }
    double see(double x, const place<T>& at, bool must_vanish) {
        if (!std::isfinite(x)) {
            if (!not_finite++) nan_value = x, nan_place = at;
            return 0;
        }
        if (x < -rounding) {
            ++negative;
            if (x < negative_value) negative_value = x, negative_place = at;
        }
        if (must_vanish && !equal(x, 0.0)) {
            ++below;
            if (std::abs(x) > std::abs(below_value)) below_value = x, below_place = at;
        }
        return x;
    }

    void report_to(
        report& r, bool says_below = true,
        const char* why_below = "light from below the horizon is reflected: the sign of a cosine is lost (abs) or never looked at") const {
        const auto share = [&](long n) {
            return " (" + number(100.0 * static_cast<double>(n) / static_cast<double>((std::max)(calls, 1L)), 3) + " % of the values)";
        };
        r.add({{what + " is finite", not_finite ? nan_value : 0, 0, 0, not_finite ? nan_place.text() : "",
                not_finite == calls ? "every value is NaN or infinite"
                                    : "a 0/0, an overflow, or the root or power of a negative number at an extreme" + share(not_finite)},
               not_finite == 0});
        r.add({{what + " is not negative", negative_value, 0, 0, negative ? negative_place.text() : "",
                "a cosine that is not clamped or checked, or a weight that turns negative" + share(negative)},
               negative == 0});
        if (says_below)
            r.add({{what + " vanishes below", below_value, 0, 0, below ? below_place.text() : "", why_below + share(below)}, below == 0});
    }
};

/// What `sample` returned, as doubles.
template <class T, std::size_t N>
struct drawn {
    vec3<T> l{};
    std::array<double, N> weight{};
    double pdf = 0;
    bool ok = false;  // a density above zero and l above the horizon
};

/// A stranger's functions, those that exist: the judge is compiled once for a scalar type and a number of channels, not once a BRDF.
template <class T, std::size_t N>
struct brdf_functions {
    using values = std::array<double, N>;
    std::function<values(const vec3<T>& v, const vec3<T>& l)> f_cos;
    std::function<double(const vec3<T>& v, const vec3<T>& l)> pdf;
    std::function<drawn<T, N>(const vec3<T>& v, const vec2<T>& u)> sample;
    std::function<std::pair<values, double>(const vec3<T>& v, const vec3<T>& l)> evaluate;
    bool isotropic = false;
    bool misfit_sample = false, misfit_pdf = false;  // there is a member of that name, but it cannot be called
};

/// Is there a member of that name, whatever its signature? A class that inherits it twice does not know which one is meant.
struct named_sample {
    int sample;
};
struct named_pdf {
    int pdf;
};
template <class B, class Name>
struct heir : B, Name {};
template <class B>
concept can_be_inherited = std::is_class_v<B> && !std::is_final_v<B>;
template <class B>
concept has_member_sample = can_be_inherited<B> && !requires {
    &heir<B, named_sample>::sample;
};
template <class B>
concept has_member_pdf = can_be_inherited<B> && !requires {
    &heir<B, named_pdf>::pdf;
};

template <std::size_t N, class S>
std::array<double, N> as_values(const S& s) {
    std::array<double, N> out;
    for (std::size_t i = 0; i < N; ++i) out[i] = spectrum<S>::get(s, spectrum<S>::size == 1 ? 0 : i);
    return out;
}

template <class B>
auto interface_of(const B& b) {
    using T = decltype(scalar_of_brdf<B>());
    using V = vec3<T>;
    using U = vec2<T>;
    using value = std::remove_cvref_t<decltype(call_f_cos(b, V{}, V{}))>;
    constexpr std::size_t N = spectrum<value>::size;
    brdf_functions<T, N> out;
    out.f_cos = [&b](const V& v, const V& l) { return as_values<N>(call_f_cos(b, v, l)); };
    if constexpr (requires(const V w) {
                      { b.pdf(w, w) } -> std::convertible_to<double>;
                  })
        out.pdf = [&b](const V& v, const V& l) { return static_cast<double>(b.pdf(v, l)); };
    else
        out.misfit_pdf = has_member_pdf<B>;
    if constexpr (requires(const V w, const U u) {
                      V(b.sample(w, u).l);
                      requires is_spectrum<std::remove_cvref_t<decltype(b.sample(w, u).weight)>>;
                      static_cast<double>(b.sample(w, u).pdf);
                  })
        out.sample = [&b](const V& v, const U& u) {
            const auto s = b.sample(v, u);
            return drawn<T, N>{V(s.l), as_values<N>(s.weight), static_cast<double>(s.pdf)};
        };
    else
        out.misfit_sample = has_member_sample<B>;
    if constexpr (requires(const V w) {
                      b.evaluate(w, w).f_cos;
                      b.evaluate(w, w).pdf;
                  })
        out.evaluate = [&b](const V& v, const V& l) {
            const auto e = b.evaluate(v, l);
            return std::pair(as_values<N>(e.f_cos), static_cast<double>(e.pdf));
        };
    if constexpr (requires {
                      { B::isotropic } -> std::convertible_to<bool>;
                  })
        out.isotropic = B::isotropic;
    return out;
}

/// The functions, watched.
template <class T, std::size_t N>
class subject {
public:
    using V = vec3<T>;
    using values = std::array<double, N>;

    subject(brdf_functions<T, N> judged, bool below_is_zero) : b(std::move(judged)), zero_below(below_is_zero) {}

    bool has_pdf() const { return static_cast<bool>(b.pdf); }
    bool has_sample() const { return static_cast<bool>(b.sample); }

    values f_cos(const V& v, const V& l) {
        last = {v, l};
        values out = b.f_cos(v, l);
        const bool vanish = l.z < 0 && v.z > 0 ? true : zero_below && v.z < 0;
        ++of_f.calls;
        for (std::size_t i = 0; i < N; ++i) {
            out[i] = of_f.see(out[i], last, vanish, [&](const V& a, const V& c) { return b.f_cos(a, c)[i]; });
            largest = (std::max)(largest, std::abs(out[i]));
        }
        return out;
    }

    double pdf(const V& v, const V& l) {
        last = {v, l};
        ++of_pdf.calls;
        return of_pdf.see(b.pdf(v, l), last, false, b.pdf);
    }

    drawn<T, N> sample(const V& v, const vec2<T>& u) {
        last = {v, {}, u, false, true};
        drawn<T, N> s = b.sample(v, u);
        ++of_sample.calls;
        s.pdf = of_sample.see(s.pdf, last, false);
        bool carries_light = false;
        for (double& w : s.weight) {
            w = of_sample.see(w, last, false);
            carries_light |= !equal(w, 0.0);
        }
        if (s.pdf > 0) {  // a failed sample may carry any l
            for (const T x : {s.l.x, s.l.y, s.l.z}) of_sample.see(static_cast<double>(std::abs(x)), last, false);
            const double length = std::hypot(static_cast<double>(s.l.x), static_cast<double>(s.l.y), static_cast<double>(s.l.z));
            if (!(std::abs(length - 1) <= std::abs(worst_length - 1))) worst_length = length, length_place = last;
            if (!(s.l.z > 0) && carries_light) ++of_sample.below, of_sample.below_value = s.weight[0], of_sample.below_place = last;
        } else if (carries_light) {
            if (!light_without_pdf++) light_place = last;
        }
        s.ok = s.pdf > 0 && s.l.z > 0;
        if (v.z > 0) ++(s.ok ? good_samples : lost_samples);
        if (!s.ok) s.weight = {};
        return s;
    }

    brdf_functions<T, N> b;
    bool zero_below;
    watch<T> of_f{"f_cos"}, of_pdf{"pdf"}, of_sample{"sample"};
    place<T> last{}, length_place{}, light_place{};
    double largest = 0, worst_length = 1;
    long light_without_pdf = 0, good_samples = 0, lost_samples = 0;
};

}  // namespace detail

}  // namespace lobe::testkit
