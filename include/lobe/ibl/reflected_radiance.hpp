// The reflectance equation by sampling: what a surface sends to the viewer.
#pragma once

#include <lobe/brdf/concepts.hpp>
#include <lobe/core/frame.hpp>
#include <lobe/sampling/sample_mean.hpp>

namespace lobe {

/// An environment, or a sampler of one, as the tangent space of `at` sees it. It keeps a reference.
template <scalar T, class Environment>
class in_tangent_space {
public:
    constexpr in_tangent_space(const frame<T>& at, const Environment& of_world_directions)
        : local(at), world(of_world_directions) {}

    constexpr auto operator()(const vec3<T>& l) const requires std::invocable < const Environment&, const vec3<T>
    & > { return world(local.to_world(l)); }
    constexpr auto sample(const vec2<T>& u) const requires requires(const Environment& e) { e.sample(u); }
    {
        auto s = world.sample(u);
        s.direction = local.to_local(s.direction);
        return s;
    }
    constexpr T pdf(const vec3<T>& l) const requires requires(const Environment& e) { e.pdf(l); }
    { return world.pdf(local.to_world(l)); }

private:
    frame<T> local;
    const Environment& world;
};

// Where the directions of light come from. A sampler of lights has `sample(u)`, which returns {direction, pdf}, and
// `pdf(direction)`, both in tangent space (-> `in_tangent_space`); pdf in 1/sr, 0 where it never draws.

/// mean of weight(l) L(l), l from `sample`: right for any environment, noisy where small lights are bright.
struct by_brdf {
    template <samplable_brdf B, class V, class Environment, class Points>
    constexpr auto operator()(const B& b, const V& v, const Environment& L, const Points& points, std::uint32_t round,
                              std::uint32_t i) const {
        const auto s = b.sample(v, points(round, i, 0));
        return s.weight * L(s.l);
    }
};

/// mean of f_cos(v,l) L(l)/pdf(l), l from the lights: right where they cover all light; noisy where the BRDF is narrow.
template <class Lights>
class by_lights {
public:
    constexpr explicit by_lights(const Lights& sampler) : lights(sampler) {}

    template <samplable_brdf B, class V, class Environment, class Points>
    constexpr auto operator()(const B& b, const V& v, const Environment& L, const Points& points, std::uint32_t round,
                              std::uint32_t i) const {
        using T = typename B::scalar;
        const auto s = lights.sample(points(round, i, 1));
        return b.f_cos(v, s.direction) * quotient(s.pdf > T(0), T(1), s.pdf) * L(s.direction);
    }

private:
    const Lights& lights;
};

/// One direction from each, weighted by the balance heuristic, f_cos L/(pdf of the BRDF + pdf of the lights): Veach &
/// Guibas 1995, "Optimally Combining Sampling Techniques for Monte Carlo Rendering". The BRDF finds what the lights
/// leave out.
template <class Lights>
class by_both {
public:
    constexpr explicit by_both(const Lights& sampler) : lights(sampler) {}

    template <samplable_brdf B, class V, class Environment, class Points>
    constexpr auto operator()(const B& b, const V& v, const Environment& L, const Points& points, std::uint32_t round,
                              std::uint32_t i) const {
        using T = typename B::scalar;
        const auto s = b.sample(v, points(round, i, 0));
        const auto from_brdf = s.weight * quotient(s.pdf > T(0), s.pdf, s.pdf + lights.pdf(s.l)) * L(s.l);
        const auto light = lights.sample(points(round, i, 1));
        const auto e = b.evaluate(v, light.direction);
        return from_brdf + e.f_cos * quotient(light.pdf > T(0), T(1), light.pdf + e.pdf) * L(light.direction);
    }

private:
    const Lights& lights;
};

/// The reflectance equation L(v) = int f(v,l) L(l) cos(theta_l) dl as a mean over samples, with its standard error:
/// unbiased for every number of points.
/// v: unit, in tangent space. `environment`: a callable from a unit direction in tangent space to a radiance, a number
/// or an rgb; `in_tangent_space{frame{n}, map}` for a map of world directions. `points`: how many and which, as
/// `shifted_hammersley` has them. `strategy`: `by_brdf{}`, `by_lights{sampler}`, `by_both{sampler}`.
template <samplable_brdf B, class Environment, class Points, class Strategy = by_brdf>
constexpr auto reflected_radiance(const B& b, const vec3<typename B::scalar>& v, const Environment& environment,
                                  const Points& points, const Strategy& strategy = {}) {
    return sample_mean(
        points, [&](std::uint32_t round, std::uint32_t i) { return strategy(b, v, environment, points, round, i); });
}

}  // namespace lobe
