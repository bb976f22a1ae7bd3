// Which sides of a surface a subject scatters to, and what refraction does to radiance.
#pragma once

#include <lobe/core/vector.hpp>

namespace lobe::testkit::detail {

/// A BRDF looks at one side. A BSDF scatters to both: v and l may lie above or below.
struct sides {
    bool both = false;
    double eta = 1;        // index below the surface over index above
    bool radiance = true;  // refraction holds (eta_v/eta_l)^2

    /// n = eta_l/eta_v, 1 where light is reflected.
    template <class T>
    double index(const vec3<T>& v, const vec3<T>& l) const {
        return !both || (v.z < 0) == (l.z < 0) ? 1 : v.z < 0 ? 1 / eta : eta;
    }
    /// What f_cos(v,l) is multiplied by for the power that leaves along l of what comes along v: the furnace is its
    /// integral. Veach 1997, section 5.2.
    template <class T>
    double power(const vec3<T>& v, const vec3<T>& l) const {
        const double n = index(v, l);
        return radiance ? n * n : 1;
    }
    /// The same for the power that leaves along v of what comes along l.
    template <class T>
    double power_of_light(const vec3<T>& v, const vec3<T>& l) const {
        const double n = index(v, l);
        return radiance ? 1 : 1 / (n * n);
    }
    /// f(v,l) times this is f(l,v) times this of (l,v).
    template <class T>
    double reciprocal(const vec3<T>& v, const vec3<T>& l) const {
        return radiance ? index(v, l) : 1 / index(v, l);
    }
    template <class T>
    bool judged(const vec3<T>& w) const {
        return w.z > T(0) || (both && w.z < T(0));
    }
};

template <class T>
vec3<T> upward(const vec3<T>& w) {
    return {w.x, w.y, w.z < T(0) ? -w.z : w.z};
}

}  // namespace lobe::testkit::detail
