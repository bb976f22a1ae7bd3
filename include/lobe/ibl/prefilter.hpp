// The prefiltered environment of the split sum.
#pragma once

#include <lobe/core/frame.hpp>
#include <lobe/core/spectrum.hpp>
#include <lobe/ndf/ggx.hpp>
#include <lobe/sampling/points.hpp>

#include <cassert>
#include <type_traits>

namespace lobe {

/// The radiance that a GGX lobe seen head on collects around r: V = N = R, weighted with the cosine to r,
///   LD = sum L(l) (r.l) / sum (r.l),  l = reflect(r, m),  m by inverse CDF, pdf(l) = D(m)/4.
/// Karis 2013, "Real Shading in Unreal Engine 4"; it equals int D L (r.l) dl / int D (r.l) dl.
/// `environment`: any callable from a unit world direction to a radiance. One that also takes a solid angle in sr gets
/// the one of the sample, 4/(count pdf), and should return the mean over it: filtered importance sampling (Colbert &
/// Krivanek 2007, GPU Gems 3, chapter 20, with their bias of one level): far fewer samples, for a blur of that size.
/// r: unit, world space; count >= 1; alpha <= 1, where the first half vector at least reflects upwards.
/// Error: that of `count` Hammersley points; none for a constant environment.
template <scalar T, class Environment>
constexpr auto prefiltered_radiance(const Environment& environment, const vec3<T>& r, const alpha<T>& a,
                                    std::uint32_t count) {
    using S = std::decay_t<decltype(environment(r))>;
    using WS = detail::wide_t<S>;
    using W = detail::wide_t<T>;
    assert(count > 0 && "prefiltered_radiance: count must be above 0");
    const ggx<T> normals{a};
    const frame<T> at(r);
    WS total(W(0));
    W weights(0);
    for (std::uint32_t i = 0; i < count; ++i) {
        const vec3<T> m = normals.sample(hammersley<T>(i, count));
        const vec3<T> l = reflect(vec3<T>{T(0), T(0), T(1)}, m);
        const T weight = larger(l.z, T(0));
        if constexpr (std::is_invocable_v<const Environment&, const vec3<T>&, const T&>)
            total = total + WS(environment(at.to_world(l), T(16) / (T(count) * normals.D(m)))) * W(weight);
        else
            total = total + WS(environment(at.to_world(l))) * W(weight);
        weights += W(weight);
    }
    return S(total * (W(1) / weights));
}

}  // namespace lobe
