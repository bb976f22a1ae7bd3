// The diffuse reflector of Lambert.
#pragma once

#include <lobe/brdf/diffuse.hpp>

namespace lobe {

/// f = albedo/pi, in 1/sr. Lambert 1760. Sampled in proportion to the cosine, so that the weight is the albedo.
/// S: one number or linear rgb, albedo in [0,1]; v, l unit, in tangent space; zero below the horizon.
template <class S>
class lambert : public cosine_sampled<lambert<S>, S> {
    using T = component_t<S>;

public:
    constexpr explicit lambert(const S& albedo) : rho(albedo) {
        assert(detail::in_unit_interval(rho) && "lambert: the albedo must be in [0,1]");
    }

private:
    friend cosine_sampled<lambert, S>;

    template <class Mask>
    constexpr S pi_f(const vec3<T>&, const vec3<T>&, const Mask& lit, const T& factor) const {
        return rho * select(lit, factor, T(0));
    }

    S rho;
};

}  // namespace lobe
