// How much light a rough interface reflects and transmits, by quadrature.
#pragma once

#include <lobe/bsdf/rough_dielectric.hpp>
#include <lobe/energy/albedo.hpp>
#include <lobe/energy/refraction_quadrature.hpp>

namespace lobe {}  // namespace lobe
