// Everything but the test kit.
#pragma once

#include <lobe/version.hpp>

#include <lobe/core/frame.hpp>
#include <lobe/core/scalar.hpp>
#include <lobe/core/spectrum.hpp>
#include <lobe/core/vector.hpp>

#include <lobe/numeric/beta_ratio.hpp>
#include <lobe/numeric/gauss_legendre.hpp>
#include <lobe/numeric/integrals.hpp>
#include <lobe/numeric/precision.hpp>
#include <lobe/numeric/roots.hpp>
#include <lobe/numeric/special_functions.hpp>

#include <lobe/width/alpha.hpp>
#include <lobe/width/antialiasing.hpp>
#include <lobe/width/exponents.hpp>

#include <lobe/sampling/lattices.hpp>
#include <lobe/sampling/points.hpp>
#include <lobe/sampling/sample_mean.hpp>
#include <lobe/sampling/sobol.hpp>
#include <lobe/sampling/warp.hpp>

#include <lobe/ndf/abc.hpp>
#include <lobe/ndf/beckmann.hpp>
#include <lobe/ndf/blinn_phong.hpp>
#include <lobe/ndf/concepts.hpp>
#include <lobe/ndf/exponential_power.hpp>
#include <lobe/ndf/ggx.hpp>
#include <lobe/ndf/ggx_half.hpp>
#include <lobe/ndf/gtr.hpp>
#include <lobe/ndf/masked_by.hpp>
#include <lobe/ndf/mixture.hpp>
#include <lobe/ndf/phong.hpp>
#include <lobe/ndf/radial.hpp>
#include <lobe/ndf/sgd.hpp>
#include <lobe/ndf/sggx.hpp>
#include <lobe/ndf/stretched.hpp>
#include <lobe/ndf/student_t.hpp>

#include <lobe/fresnel/conductor.hpp>
#include <lobe/fresnel/dielectric.hpp>
#include <lobe/fresnel/f82_tint.hpp>
#include <lobe/fresnel/ior.hpp>
#include <lobe/fresnel/materials.hpp>
#include <lobe/fresnel/schlick.hpp>
#include <lobe/fresnel/schlick_gaussian.hpp>
#include <lobe/fresnel/schlick_roughness.hpp>

#include <lobe/brdf/burley.hpp>
#include <lobe/brdf/concepts.hpp>
#include <lobe/brdf/diffuse.hpp>
#include <lobe/brdf/diffuse_samplers.hpp>
#include <lobe/brdf/eon.hpp>
#include <lobe/brdf/ggx_samplers.hpp>
#include <lobe/brdf/lambert.hpp>
#include <lobe/brdf/layered.hpp>
#include <lobe/brdf/masking.hpp>
#include <lobe/brdf/metallic_roughness.hpp>
#include <lobe/brdf/microfacet.hpp>
#include <lobe/brdf/oren_nayar.hpp>
#include <lobe/brdf/samplers.hpp>
#include <lobe/brdf/scaled.hpp>
#include <lobe/brdf/schlick_ggx.hpp>
#include <lobe/brdf/sum.hpp>
#include <lobe/brdf/v_cavity.hpp>

#include <lobe/bsdf/concepts.hpp>
#include <lobe/bsdf/masking.hpp>
#include <lobe/bsdf/refraction.hpp>
#include <lobe/bsdf/rough_dielectric.hpp>
#include <lobe/bsdf/smooth_dielectric.hpp>
#include <lobe/bsdf/thin_dielectric.hpp>
#include <lobe/bsdf/tinted.hpp>

#include <lobe/lights/punctual.hpp>

#include <lobe/energy/albedo.hpp>
#include <lobe/energy/anisotropic_dfg.hpp>
#include <lobe/energy/compensated.hpp>
#include <lobe/energy/compensated_dielectric.hpp>
#include <lobe/energy/default_dfg.hpp>
#include <lobe/energy/dfg.hpp>
#include <lobe/energy/dfg_export.hpp>
#include <lobe/energy/dfg_fit.hpp>
#include <lobe/energy/dfg_published.hpp>
#include <lobe/energy/dfg_table.hpp>
#include <lobe/energy/fdez_aguera.hpp>
#include <lobe/energy/interface_albedo.hpp>
#include <lobe/energy/interface_walk.hpp>
#include <lobe/energy/kulla_conty.hpp>
#include <lobe/energy/metallic_roughness.hpp>
#include <lobe/energy/multiple_scattering.hpp>
#include <lobe/energy/quadrature.hpp>
#include <lobe/energy/random_walk.hpp>
#include <lobe/energy/refraction_quadrature.hpp>
#include <lobe/energy/smith_multiscatter.hpp>
#include <lobe/energy/turquin.hpp>

#include <lobe/ibl/cube.hpp>
#include <lobe/ibl/directions.hpp>
#include <lobe/ibl/environment_sampler.hpp>
#include <lobe/ibl/harmonics.hpp>
#include <lobe/ibl/irradiance.hpp>
#include <lobe/ibl/latlong.hpp>
#include <lobe/ibl/prefilter.hpp>
#include <lobe/ibl/reflected_radiance.hpp>
#include <lobe/ibl/rotated.hpp>
#include <lobe/ibl/shade.hpp>
