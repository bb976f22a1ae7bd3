// A pixel under image-based light.
#pragma once

#include <lobe/energy/smith_multiscatter.hpp>
#include <lobe/ibl/prefilter.hpp>

namespace lobe {

/// The radiance towards v of a GGX surface in an environment:
///   weights.radiance L(reflect(v, n), roughness) + weights.irradiance E(n)
/// `prefiltered(r, roughness)`: a `prefiltered_chain`, or any callable. `irradiance(n)`: irradiance/pi, as
/// `harmonics`'s or a map. `model`: who gives the weights, with the light of later bounces. `albedo`: of a diffuse base
/// under the interface; 0 for a metal. n, v: unit, world space, n.v > 0; roughness in (0,1]: alpha is its square.
/// Error: that of the split sum, which prefilters as if v were n: `examples/render_spheres` shows it.
template <scalar T, class Prefiltered, class Irradiance, class F, class Model = smith_multiscatter<>>
constexpr vec3<T> shade(const Prefiltered& prefiltered, const Irradiance& irradiance, const vec3<T>& n,
                        const vec3<T>& v, const F& fresnel, const T& roughness, const vec3<T>& albedo,
                        const Model& model = Model()) {
    const auto w = model.weights(fresnel, dot(n, v), alpha<T>::from_roughness(roughness), albedo);
    return w.radiance * prefiltered(reflect(v, n), roughness) + w.irradiance * irradiance(n);
}

}  // namespace lobe
