// The recipe "batches" of docs/integrate.md, alone: tests/settings/vectorised.sh asks compilers whether its loops
// vectorise.
#pragma once

#include <lobe/lobe.hpp>

#include <array>
#include <cstdint>

namespace batches {

using glm::vec3;

// [batches]
/// Hits on one material, component by component. Arrays of one struct do not overlap, so loops over them vectorise.
struct batch {
    static constexpr std::size_t size = 512;
    std::size_t count = 0;
    std::array<float, size> vx, vy, vz, lx, ly, lz;  // directions, tangent space
    std::array<float, size> roughness, F0;           // textures
    std::array<float, size> r, g, b;                 // f_cos
    std::array<std::uint32_t, size> pixel;
};

/// One BRDF for all hits. (By value: what it holds cannot overlap the arrays.)
template <lobe::brdf B>
void shade(B brdf, batch& hits) {
    for (std::size_t i = 0; i < hits.count; ++i) {
        const vec3 v{hits.vx[i], hits.vy[i], hits.vz[i]}, l{hits.lx[i], hits.ly[i], hits.lz[i]};
        const vec3 f = brdf.f_cos(v, l);
        hits.r[i] = f.x, hits.g[i] = f.y, hits.b[i] = f.z;
    }
}

/// One BRDF a hit, composed from its texels. (The width in its place: with a variable for it g++ 12 does not
/// vectorise.)
inline void shade_textured(batch& hits) {
    for (std::size_t i = 0; i < hits.count; ++i) {
        const vec3 v{hits.vx[i], hits.vy[i], hits.vz[i]}, l{hits.lx[i], hits.ly[i], hits.lz[i]};
        const lobe::microfacet brdf{lobe::ggx{lobe::alpha<float>::from_roughness(hits.roughness[i], 1e-3f)},
                                    lobe::smith_correlated{}, lobe::schlick{hits.F0[i]}};
        const float f = brdf.f_cos(v, l);
        hits.r[i] = f, hits.g[i] = f, hits.b[i] = f;
    }
}
// [end]

}  // namespace batches
