// The random walk on a Smith microsurface: the ground truth of multiple scattering.
#pragma once

#include <lobe/brdf/concepts.hpp>

#include <cmath>

namespace lobe {

/// Heitz, Hanika, d'Eon, Dachsbacher 2016, "Multiple-Scattering Microfacet BSDFs with the Smith Model", section 4 and
/// algorithm 1: a ray enters a surface whose heights and normals are uncorrelated, is reflected by visible normals
/// until it escapes, and is weighted with F at each bounce. It needs no table and no assumption beyond Smith's; its
/// first bounce is `smith_correlated`. Scalar types only.
template <visibly_samplable_distribution N, class F>
class random_walk {
    using T = typename N::scalar;
    using S = decltype(std::declval<const F&>()(std::declval<const T&>()));

public:
    /// Direction in which the light leaves (or, read backwards, comes from), the product of the Fresnel reflectances,
    /// the number of bounces. E[weight] over l in a solid angle is int f cos(theta_l) dl over it.
    struct path {
        vec3<T> l;
        S weight;
        int order;
    };

    constexpr random_walk(const N& distribution_of_normals, const F& reflectance)
        : ndf(distribution_of_normals), fresnel(reflectance) {}

    /// v: unit, above the horizon. `uniform()`: independent numbers in [0,1), three a bounce.
    /// `first` may be given to take the first facet from a point set. A walk of 1000 bounces (the longest of 4e9 had
    /// 14) is given up: weight 0.
    template <class Uniform>
    constexpr path sample(const vec3<T>& v, Uniform&& uniform) const {
        return sample(v, vec2<T>{T(uniform()), T(uniform())}, uniform);
    }

    template <class Uniform>
    constexpr path sample(const vec3<T>& v, const vec2<T>& first, Uniform&& uniform) const {
        using std::log;
        // The logarithm of C1, the fraction of the surface that is lower, stands for the height: along w it changes by
        // an exponentially distributed step over Lambda(w) (eq. 18-20), whatever the distribution of heights.
        T log_height(0);
        vec3<T> w = -v;
        S weight(T(1));
        for (int order = 0; order < 1000; ++order) {
            const T lambda = ndf.lambda(w);
            const T depth = -log(T(1) - T(uniform()));
            if (w.z > T(0) && log_height * lambda + depth >= T(0)) return {w, weight, order};
            log_height += depth / lambda;
            const vec2<T> u = order == 0 ? first : vec2<T>{T(uniform()), T(uniform())};
            const vec3<T> m = ndf.sample_visible(-w, u);
            const T cosine = -dot(w, m);
            weight = weight * fresnel(smaller(larger(cosine, T(0)), T(1)));
            w = normalize(w + T(2) * cosine * m);
        }
        return {{T(0), T(0), T(1)}, S(T(0)), 1000};
    }

private:
    [[no_unique_address]] N ndf;
    [[no_unique_address]] F fresnel;
};

}  // namespace lobe
