// What is claimed of a subject, and how hard to look.
#pragma once

#include <lobe/core/cpp20.hpp>

#include <cstdint>
#include <optional>
#include <string>

namespace lobe::testkit {

enum class effort { quick, thorough };

struct options {
    testkit::effort effort = effort::quick;
    std::uint64_t seed = 1;
    double tolerance = 2e-3;  // relative error that counts, beyond rounding and the error of the quadrature
    std::string name{};       // heads the report

    // Claims about a BRDF, or a distribution.
    bool reciprocal = true;  // f(v,l) = f(l,v): no compensation or diffuse weight that looks at one direction only is
    bool lossless = false;   // the white furnace returns exactly 1: F = 1 and all scattering counted
    std::optional<bool>
        // nothing changes when v and l turn about the normal; unset: as `isotropic` of the type says, else no claim
        isotropic;
    // f_cos is 0 also where v is below the horizon and l above it (l below, v above: always asked for)
    bool zero_below = false;
    // f_cos on the whole sphere, v and l on either side: a BSDF. Unset: as `transmits` of the type says, else not
    std::optional<bool> transmits;
    // of a BSDF, index below the surface over index above. Unset: as `relative_index()` of the type says, else 1
    std::optional<double> eta;
    // of a BSDF, refraction holds (eta_v/eta_l)^2. Unset: as the type's `transports` says, else it does
    std::optional<bool> radiance;
    bool area_below = false;  // projected_area is right below the horizon, too

    // Claims about a Fresnel reflectance, or a set of points.
    // dF/dcos = 0 at normal incidence: all bare interfaces in unpolarised light, no thin films
    bool flat_at_normal = true;
    bool low_discrepancy = true;  // more evenly spread than random points
};

}  // namespace lobe::testkit
