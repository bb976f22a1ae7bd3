// A call of everything that a renderer's inner loop may ask of lobe, one function a model: what the tests of compilers,
// flags and GPUs instantiate. Each returns one number, into which all that was computed has gone. (The macros and the
// test kit are in their own tests.)
#pragma once

#include <lobe/lobe.hpp>

#include <cstdint>
#include <vector>

namespace everything {

/// Two unit directions above the horizon, a point of the unit square, a width and a number in (0,1).
template <class T>
struct input {
    lobe::vec3<T> v, l;
    lobe::vec2<T> u;
    T width, x;

    constexpr lobe::alpha<T> a() const { return lobe::alpha<T>(width); }
    constexpr lobe::alpha_xy<T> xy() const { return {width, width * T(0.5f)}; }
    constexpr lobe::vec3<T> color() const { return {x, x * T(0.5f), x * T(0.25f)}; }
};

template <class T>
constexpr T number(const T& s) {
    return s;
}
template <class T>
constexpr T number(const lobe::vec3<T>& s) {
    return s.x + s.y + s.z;
}
template <class T>
constexpr T number(const lobe::vec2<T>& s) {
    return s.x + s.y;
}

template <class N, class T>
constexpr T of_distribution(const N& ndf, const input<T>& in) {
    T total = ndf.D(in.l) + ndf.projected_area(in.v) + ndf.lambda(in.v) + number(ndf.width());
    if constexpr (lobe::samplable_distribution<N>) {
        const lobe::vec3<T> m = ndf.sample(in.u);
        total += number(m) + ndf.pdf(m);
    }
    if constexpr (lobe::visibly_samplable_distribution<N>) {
        const lobe::vec3<T> m = ndf.sample_visible(in.v, in.u);
        total += number(m) + ndf.pdf_visible(in.v, m);
    }
    return total;
}

template <class B, class T>
constexpr T of_brdf(const B& b, const input<T>& in) {
    T total = number(b.f(in.v, in.l)) + number(b.f_cos(in.v, in.l)) + number(b.width());
    if constexpr (lobe::samplable_brdf<B>) {
        const auto s = b.sample(in.v, in.u);
        const auto e = b.evaluate(in.v, s.l);
        total += number(s.l) + number(s.weight) + s.pdf + number(e.f_cos) + e.pdf + b.pdf(in.v, in.l);
    }
    return total;
}

/// The same of an interface, from both sides.
template <class B, class T>
constexpr T of_bsdf(const B& b, const input<T>& in) {
    const auto from = [&](const lobe::vec3<T>& v) {
        const auto s = b.sample(v, {in.u.x, in.u.y, in.x});
        const auto e = b.evaluate(v, s.l);
        return number(s.l) + number(s.weight) + s.pdf + number(e.f_cos) + e.pdf + b.pdf(v, in.l) +
               number(b.f(v, in.l)) + number(b.f_cos(v, in.l));
    };
    return from(in.v) + from(-in.v);
}

/// A distribution, and the BRDF that it makes with what it can be sampled by.
template <class N, class T>
constexpr T of_facets(const N& ndf, const input<T>& in) {
    const lobe::schlick F{in.x};
    if constexpr (lobe::visibly_samplable_distribution<N>)
        return of_distribution(ndf, in) + of_brdf(lobe::microfacet{ndf, lobe::smith_correlated{}, F}, in);
    else
        return of_distribution(ndf, in) +
               of_brdf(lobe::microfacet{ndf, lobe::smith_correlated{}, F, lobe::all_normals{}}, in);
}

template <class M, class T>
constexpr T of_masking(const M& m, const input<T>& in) {
    const lobe::ggx ndf{in.a()};
    return m.visibility(ndf, in.v, in.l) + m.G2(ndf, in.v, in.l) +
           of_brdf(lobe::microfacet{ndf, m, lobe::schlick{in.x}}, in);
}

template <class F, class T>
constexpr T of_fresnel(const F& f, const input<T>& in) {
    return number(f(in.x)) + T(number(f.average())) +
           of_brdf(lobe::microfacet{lobe::ggx{in.a()}, lobe::smith_correlated{}, f}, in);
}

template <class L, class T>
constexpr T of_light(const L& light, const input<T>& in) {
    const auto at_point = light(in.v);
    return number(at_point.l) + number(at_point.illuminance) +
           number(reflected_radiance(lobe::lambert{in.x}, in.v, at_point));
}

/// Numbers for random_walk: a generator of the caller's own.
template <class T>
struct generator {
    std::uint32_t state;
    constexpr T operator()() {
        state = state * 747796405u + 2891336453u;
        return lobe::detail::fraction<T>(state ^ (state >> 16));
    }
};

template <class N, class F, class T>
constexpr T of_walk(const N& ndf, const F& f, const input<T>& in) {
    const lobe::random_walk walk{ndf, f};
    generator<T> uniform{1};
    const auto path = walk.sample(in.v, uniform), stratified = walk.sample(in.v, in.u, uniform);
    return number(path.l) + number(path.weight) + T(path.order) + number(stratified.l);
}

// ---- one function a model
// -------------------------------------------------------------------------------------------------------

#define EVERYTHING_CALL(name, ...)                                                                                     \
    template <class T>                                                                                                 \
    constexpr T name([[maybe_unused]] const input<T>& in) {                                                            \
        using namespace lobe;                                                                                          \
        return __VA_ARGS__;                                                                                            \
    }
#include "everything.inc"
#undef EVERYTHING_CALL

template <class T>
constexpr lobe::latlong<T> map_of(const input<T>& in) {
    return {8, 4, std::vector<lobe::vec3<T>>(32, in.color())};
}

#define EVERYTHING_CALL(name, ...)                                                                                     \
    template <class T>                                                                                                 \
    T name([[maybe_unused]] const input<T>& in) {                                                                      \
        using namespace lobe;                                                                                          \
        return __VA_ARGS__;                                                                                            \
    }
#include "host_only.inc"
#undef EVERYTHING_CALL

/// Hands `use` the name and the value of each.
template <class T, class Use>
void for_each(const input<T>& in, const Use& use) {
#define EVERYTHING_CALL(name, ...) use(#name, name(in));
#include "everything.inc"
#include "host_only.inc"
#undef EVERYTHING_CALL
}

}  // namespace everything
