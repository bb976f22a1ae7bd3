// What every variant of a row is fed: one stated set of arrays, from a fixed seed.
#pragma once

#include <lobe/brdf/microfacet.hpp>
#include <lobe/energy/dfg.hpp>
#include <lobe/energy/dfg_table.hpp>
#include <lobe/fresnel/schlick.hpp>
#include <lobe/ndf/ggx.hpp>
#include <lobe/sampling/points.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

inline constexpr std::size_t count = 1024;         // small enough for the first two levels of cache
inline constexpr std::size_t stride = count + 16;  // streams exactly 4 KiB apart collide

template <class T>
struct alignas(64) stream {
    std::array<T, stride> values{};
    const T& operator[](std::size_t i) const { return values[i]; }
    T& operator[](std::size_t i) { return values[i]; }
};

/// A square table of (scale, bias) as tutorials bake it: texel centres, (cosine, roughness), read bilinearly.
struct textbook_table {
    int size = 0;
    std::vector<float> scale, bias;
};

template <class T>
struct prebuilt;

/// What models need beyond the directions. (Aligned, so that no stream is where results are, modulo 4 KiB.)
struct alignas(4096) parameters {
    using rgb = std::array<stream<float>, 3>;

    // anything in [0,1): a weight, metallic, the roughness of a diffuse base, an anisotropy
    stream<float> fraction;
    stream<float> roughness;  // sqrt of a
    stream<float> length;     // of a mean normal
    stream<float> eta, f0;    // of a glass
    rgb refracted;            // where the normal m sends v through it
    rgb metal_eta, metal_k;   // one of the five of lobe::materials
    // Fresnel's reflectance along the normal, and that at 82 degrees over Schlick's
    rgb metal_F0, metal_tint;
    rgb E_avg;                            // average albedo of GGX of the width a with the reflectance F0
    std::array<stream<float>, 4> slopes;  // of two facets; derivatives over a pixel
};

struct inputs {
    // view and light, both above the horizon, mirrored about a visible GGX normal
    stream<float> vx, vy, vz, lx, ly, lz;
    stream<float> mx, my, mz;          // that normal
    stream<float> v_m;                 // v.m
    stream<float> a;                   // its width
    stream<float> nx, ny, nz, ax, ay;  // a normal of an anisotropic GGX, and the widths
    stream<float> u1, u2;              // a point of the unit square
    stream<float> turn;                // an angle in turns
    stream<float> r, g, b;             // F0
    stream<std::uint32_t> index;       // of a point of a sequence of `points`
    std::uint32_t points = 0;
    parameters more;

    const textbook_table* baked = nullptr;
    const prebuilt<float>* built = nullptr;
    const prebuilt<long double>* built_exactly = nullptr;
};

enum class set { usual, extreme };

/// usual: alpha evenly spread in the logarithm over [1e-3, 1]; 1024 points; turns anywhere.
/// extreme: alpha 1e-4 (anisotropic: 1e-4 by up to 1); indices up to 2^32 - 1; turns within 1e-3 of a multiple of 1/4.
inputs make_inputs(set which);

/// Fills in E_avg, from the prebuilt table.
void set_average_albedos(inputs& in);
