// A microfacet BRDF that keeps the energy of its later bounces.
#pragma once

#include <lobe/energy/smith_multiscatter.hpp>

namespace lobe {

/// `compensated{microfacet{...}}`, `compensated{microfacet{...}, model}`: a metal with all its bounces, f, f_cos, pdf,
/// evaluate, sample as any BRDF. Models: `smith_multiscatter`, the default, `kulla_conty`, `turquin`. A model is a
/// callable that makes a BRDF of a microfacet lobe.
template <class Lobe, class Model = smith_multiscatter<>>
class compensated : public std::invoke_result_t<const Model&, const Lobe&> {
public:
    constexpr explicit compensated(const Lobe& first_bounce, const Model& later_bounces = Model())
        : std::invoke_result_t<const Model&, const Lobe&>(later_bounces(first_bounce)) {}
};

}  // namespace lobe
