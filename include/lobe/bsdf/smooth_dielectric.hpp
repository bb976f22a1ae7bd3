// Smooth interfaces: samplers of one direction or two, which have no density.
#pragma once

#include <lobe/bsdf/concepts.hpp>
#include <lobe/bsdf/refraction.hpp>

#include <cassert>

namespace lobe {

/// One of a few directions: its weight, and the probability that it is chosen. There is no density, and no `f` to ask:
/// a light in just this direction is met by chance never, so multiple importance sampling gives the sample all weight.
/// A failed sample, v on the horizon, has probability = 0, weight = 0, l = (0,0,1).
template <class S, scalar T>
struct discrete_sample {
    vec3<T> l;
    S weight;
    T probability;
};

namespace detail {

/// l, weight and probability where the mask holds, a failed sample elsewhere.
template <class Mask, scalar T>
constexpr discrete_sample<T, T> chosen_if(const Mask& mask, const vec3<T>& l, const T& weight, const T& probability) {
    return {select(mask, l, vec3<T>{T(0), T(0), T(1)}), select(mask, weight, T(0)), select(mask, probability, T(0))};
}

}  // namespace detail

/// A mirror of any Fresnel reflectance, a metal: `microfacet` as its width goes to 0. Fails from below the horizon.
template <class F>
class mirror {
    F fresnel_;

public:
    constexpr explicit mirror(const F& reflectance) : fresnel_(reflectance) {}

    template <scalar T>
        requires(fresnel<F, T>)
    constexpr auto sample(const vec3<T>& v) const {
        const auto above = v.z > horizon<T>();
        const auto F_v = fresnel_(select(above, smaller(v.z, T(1)), T(1)));
        return discrete_sample<std::remove_const_t<decltype(F_v)>, T>{
            select(above, vec3<T>{-v.x, -v.y, v.z}, vec3<T>{T(0), T(0), T(1)}), F_v * select(above, T(1), T(0)),
            select(above, T(1), T(0))};
    }
};

/// A smooth interface between two transparent media: Fresnel's equations and Snell's law, from both sides. The limit of
/// `rough_dielectric` as its width goes to 0. `eta`: index below over index above.
template <scalar T, transport Transport = radiance_transport>
class smooth_dielectric {
    using side = detail::dielectric_side<T>;

public:
    using scalar = T;
    using spectrum = T;
    static constexpr bool transmits = true;

    constexpr explicit smooth_dielectric(const T& eta, const Transport& = {})
        : above(side::above(eta)), below(side::below(eta)) {
        assert(all(eta > T(0)) && all(detail::finite(T(eta * eta))) &&
               "smooth_dielectric: eta must be above 0 and its square finite");
    }

    /// u in [0,1): reflects if u < F. Weight 1; of refraction for radiance (eta_v/eta_l)^2.
    constexpr discrete_sample<T, T> sample(const vec3<T>& v, const T& u) const {
        const auto one = reflection(v), other = refraction(v);
        const T n = facing(v).n;
        const auto reflects = u < one.weight;
        // what refraction's weight holds beside 1 - F
        const T scale = select(reflects, T(1), Transport::scale(n));
        return detail::chosen_if(one.probability > T(0), select(reflects, one.l, other.l), scale,
                                 select(reflects, one.weight, other.weight / scale));
    }

    /// Both, for renderers that follow both: the weights are F and 1 - F, scaled; probability 1 or, where nothing goes,
    /// 0.
    constexpr discrete_sample<T, T> reflection(const vec3<T>& v) const {
        return detail::chosen_if(absolute(v.z) > horizon<T>(), vec3<T>{-v.x, -v.y, v.z},
                                 facing(v).reflectance(cosine(v)), T(1));
    }
    constexpr discrete_sample<T, T> refraction(const vec3<T>& v) const {
        const side at = facing(v);
        const T c = cosine(v);
        const auto through = at.cross(c);
        const vec3<T> l = at.refracted({v.x, v.y, c}, {T(0), T(0), T(1)}, through.K);
        const T goes = select(through.g > T(0), absolute(v.z), T(0));
        return detail::chosen_if(goes > horizon<T>(), vec3<T>{l.x, l.y, select(v.z < T(0), -l.z, l.z)},
                                 at.transmittance(c, through.g) * Transport::scale(at.n), T(1));
    }

private:
    constexpr side facing(const vec3<T>& v) const { return side::choose(v.z < T(0), below, above); }
    static constexpr T cosine(const vec3<T>& v) { return smaller(larger(absolute(v.z), horizon<T>()), T(1)); }

    side above, below;
};

}  // namespace lobe
