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

struct inputs {
    stream<float> vx, vy, vz, lx, ly, lz;  // view and light, both above the horizon, mirrored about a visible GGX normal
    stream<float> mx, my, mz;              // that normal
    stream<float> v_m;                     // v.m
    stream<float> a;                       // its width
    stream<float> nx, ny, nz, ax, ay;      // a normal of an anisotropic GGX, and the widths
    stream<float> u1, u2;                  // a point of the unit square
    stream<float> turn;                    // an angle in turns
    stream<float> r, g, b;                 // F0
    stream<std::uint32_t> index;           // of a point of a sequence of `points`
    std::uint32_t points = 0;

    const lobe::dfg_table<float, lobe::smith_correlated>* table = nullptr;
    const textbook_table* baked = nullptr;
};

enum class set { usual, extreme };

/// usual: alpha evenly spread in the logarithm over [1e-3, 1]; 1024 points; turns anywhere.
/// extreme: alpha 1e-4 (anisotropic: 1e-4 by up to 1); indices up to 2^32 - 1; turns within 1e-3 of a multiple of 1/4.
inputs make_inputs(set which);
