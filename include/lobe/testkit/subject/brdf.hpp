// A stranger's BRDF: which scalar it computes in, which functions it has, and how many numbers its sampler takes.
#pragma once

#include <lobe/core/vector.hpp>
#include <lobe/testkit/measure/sides.hpp>
#include <lobe/testkit/subject/spectrum.hpp>

#include <concepts>
#include <functional>
#include <type_traits>
#include <utility>

namespace lobe::testkit::detail {

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

/// `B::scalar` where given, else that of the value returned. (What takes double vectors may take float ones: GLM
/// converts silently.)
template <class B>
auto scalar_of_brdf() {
    if constexpr (requires { typename B::scalar; }) {
        return typename B::scalar{};
    } else if constexpr (has_any_f_cos<B, vec3<double>>) {
        using value =
            std::remove_cvref_t<decltype(call_f_cos(std::declval<const B&>(), vec3<double>{}, vec3<double>{}))>;
        return scalar_of_spectrum<value>{};
    } else {
        return float{};
    }
}

/// What `sample` returned, as doubles.
template <class T, std::size_t N>
struct drawn {
    vec3<T> l{};
    std::array<double, N> weight{};
    double pdf = 0;
    bool ok = false;  // a density above zero and l where the subject scatters to
};

/// A stranger's functions, those that exist: the judge is compiled once for a scalar type and a number of channels, not
/// once a BRDF.
template <class T, std::size_t N>
struct brdf_functions {
    using values = std::array<double, N>;
    std::function<values(const vec3<T>& v, const vec3<T>& l)> f_cos;
    std::function<double(const vec3<T>& v, const vec3<T>& l)> pdf;
    std::function<drawn<T, N>(const vec3<T>& v, const vec3<T>& u)> sample;
    int numbers = 2;  // of u, that sample takes
    std::function<std::pair<values, double>(const vec3<T>& v, const vec3<T>& l)> evaluate;
    bool isotropic = false;
    detail::sides sides{};
    bool misfit_sample = false, misfit_pdf = false;  // there is a member of that name, but it cannot be called
};

/// Is there a member of that name, whatever its signature? A class that inherits it twice does not know which one is
/// meant.
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

template <class B, class V, class U>
concept samples_by = requires(const B& b, const V w, const U u) {
    V(b.sample(w, u).l);
    requires is_spectrum<std::remove_cvref_t<decltype(b.sample(w, u).weight)>>;
    static_cast<double>(b.sample(w, u).pdf);
};

template <class B>
auto interface_of(const B& b) {
    using T = decltype(scalar_of_brdf<B>());
    using V = vec3<T>;
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
    const auto as_drawn = [](const auto& s) {
        return drawn<T, N>{.l = V(s.l), .weight = as_values<N>(s.weight), .pdf = static_cast<double>(s.pdf)};
    };
    // Two numbers where it takes two. (GLM turns three into two without a word, so what takes two may seem to take
    // three.)
    if constexpr (samples_by<B, V, vec2<T>>) {
        out.sample = [&b, as_drawn](const V& v, const V& u) { return as_drawn(b.sample(v, vec2<T>(u.x, u.y))); };
    } else if constexpr (samples_by<B, V, vec3<T>>) {
        out.sample = [&b, as_drawn](const V& v, const V& u) { return as_drawn(b.sample(v, u)); };
        out.numbers = 3;
    } else {
        out.misfit_sample = has_member_sample<B>;
    }
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
    if constexpr (requires {
                      { B::transmits } -> std::convertible_to<bool>;
                  })
        out.sides.both = B::transmits;
    if constexpr (requires {
                      { b.relative_index() } -> std::convertible_to<double>;
                  })
        out.sides.eta = static_cast<double>(b.relative_index());
    if constexpr (requires {
                      { B::transports::scale(2.0) } -> std::convertible_to<double>;
                  })
        out.sides.radiance = B::transports::scale(2.0) < 1;
    return out;
}

}  // namespace lobe::testkit::detail
