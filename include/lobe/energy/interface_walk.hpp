// The random walk through a rough interface: the ground truth of multiple scattering of glass.
#pragma once

#include <lobe/bsdf/refraction.hpp>
#include <lobe/ndf/concepts.hpp>

#include <cassert>

namespace lobe {

/// Heitz, Hanika, d'Eon, Dachsbacher 2016, "Multiple-Scattering Microfacet BSDFs with the Smith Model", section 5:
/// `random_walk` whose facets reflect with the probability F and refract otherwise. On the other side it goes on in the
/// surface seen from there: the direction and the height mirrored. Nothing is absorbed; its first facet is
/// `rough_dielectric` with `smith_joint`. Scalar types only. `eta`: index below the surface over index above.
template <visibly_samplable_distribution N>
class interface_walk {
    using T = typename N::scalar;
    using side = detail::dielectric_side<T>;

public:
    /// Where the light leaves, and how many facets it met: of the paths, the share that leaves in a solid angle is
    /// that of the light that arrives along v, int f |cos| dl for importance transport.
    /// weight: 1, or 0 for a path that was given up.
    struct path {
        vec3<T> l;
        T weight;
        int order;
    };

    constexpr interface_walk(const N& distribution_of_normals, const T& eta)
        : ndf(distribution_of_normals), above(side::above(eta)), below(side::below(eta)) {
        assert(eta > T(0) && "interface_walk: eta must be above 0");
    }

    /// v: unit, above or below. `uniform()`: independent numbers in [0,1), four a facet. A walk of 1000 facets (the
    /// longest of 2e9 had 33) is given up.
    template <class Uniform>
    constexpr path sample(const vec3<T>& v, Uniform&& uniform) const {
        using std::expm1, std::log;
        bool from_below = v.z < T(0);
        vec3<T> w{-v.x, -v.y, from_below ? v.z : -v.z};
        T log_height(0);  // -> random_walk
        for (int order = 0; order < 1000; ++order) {
            const T lambda = ndf.lambda(w);
            const T depth = -log(T(1) - T(uniform()));
            if (w.z > T(0) && log_height * lambda + depth >= T(0))
                return {{w.x, w.y, from_below ? -w.z : w.z}, T(1), order};
            log_height += depth / lambda;
            const T x = T(uniform()), y = T(uniform());
            const vec3<T> m = ndf.sample_visible(-w, {x, y});
            const T c = smaller(larger(-dot(w, m), horizon<T>()), T(1));
            const side& at = from_below ? below : above;
            if (T(uniform()) < at.reflectance(c)) {
                w = normalize(w + T(2) * c * m);
            } else {
                const vec3<T> l = normalize(at.refracted(-w, m, at.cross(c).K));
                w = {l.x, l.y, -l.z};
                log_height = log(-expm1(log_height));
                from_below = !from_below;
            }
        }
        return {{T(0), T(0), T(1)}, T(0), 1000};
    }

private:
    [[no_unique_address]] N ndf;
    side above, below;
};

}  // namespace lobe
