// The split-sum terms as a texture: every convention by name.
#pragma once

#include <lobe/energy/dfg.hpp>

#include <cassert>
#include <cmath>
#include <cstdint>
#include <vector>

namespace lobe {

/// What a shader's DFG texture holds. Columns: the cosine of the view, from 0 on the left.
struct dfg_layout {
    /// The two channels: (scale, bias), for F0 x + F90 y; or (bias, scale + bias), for mix(x, y, F0) where F90 = 1.
    enum class channels { scale_bias, bias_albedo };
    /// What the rows are even in.
    enum class axis { roughness, alpha };
    /// Where the numbers belong: the centres of texels, (i + 1/2)/n, as a texture is read by default; or nodes,
    /// i/(n - 1), for look-ups that move their coordinates.
    enum class samples { centres, nodes };
    /// What the first row in memory is.
    enum class first_row { smooth, rough };

    int width = 128, height = 128;
    dfg_layout::channels channels = channels::scale_bias;
    dfg_layout::axis axis = axis::roughness;
    dfg_layout::samples samples = samples::centres;
    dfg_layout::first_row first_row = first_row::smooth;
};

/// The texels, RG, row by row, each `dfg_exact` at its place, to 1e-5: a table that was read from a smaller one would
/// be off by more than half a step of 16 bits. Nodes at cosine or alpha 0 hold the limit, to 1e-4. In float: RG32F.
/// Read linearly, 128 x 128 in roughness, E is off by up to 0.05 at cosines below 0.05, where a texel is wider than
/// alpha and E bends at mu = alpha, and by 0.004 above (`dfg_table` and its warped axis: 4e-4 from a 32 x 32).
template <class Masking, class OfWidth = ggx_of_width>
std::vector<vec2<float>> dfg_texels(const Masking& masking, const dfg_layout& layout = {},
                                    const OfWidth& of_width = {}) {
    assert(layout.width >= 2 && layout.height >= 2 && "dfg_texels: a texture has at least two columns and rows");
    const auto place = [&](int i, int n) {
        return layout.samples == dfg_layout::samples::nodes ? double(i) / double(n - 1) : (double(i) + 0.5) / double(n);
    };
    const detail::hemisphere_rule<double> rule(std::same_as<OfWidth, ggx_of_width> ? 16 : 32);
    std::vector<vec2<float>> texels;
    for (int j = 0; j < layout.height; ++j) {
        const bool rough_first = layout.first_row == dfg_layout::first_row::rough;
        const double y = place(rough_first ? layout.height - 1 - j : j, layout.height);
        const double a = layout.axis == dfg_layout::axis::roughness ? y * y : y;
        const alpha<double> width(larger(a, 1e-4));  // house: a row of a table, alpha = 0 to the eye
        for (int i = 0; i < layout.width; ++i) {
            const double mu = larger(place(i, layout.width), width.value() * 1e-6);  // house: a column, mu = 0
            const dfg_terms<double> t = detail::split_sum(of_width(width), masking, detail::view_at(mu)).at(rule);
            texels.push_back(layout.channels == dfg_layout::channels::scale_bias ? vec2<float>(t.scale, t.bias)
                                                                                 : vec2<float>(t.bias, t.albedo()));
        }
    }
    return texels;
}

namespace detail {

/// The half nearest to x, ties to even, as bits; x in [0,1].
constexpr std::uint16_t half_bits(float x) {
    // halves below 2^-14 are multiples of 2^-24, as floats from 1/2 on are, so that the sum rounds as they do
    if (x < 0x1p-14f) return static_cast<std::uint16_t>(detail::bit_cast<std::uint32_t>(x + 0.5f) - 0x3f000000u);
    const auto bits = detail::bit_cast<std::uint32_t>(x);  // exponent - 127, then 23 bits: a half's are 15 and 10
    return static_cast<std::uint16_t>(((bits + 0xfffu + ((bits >> 13) & 1u)) >> 13) - ((127u - 15u) << 10));
}

/// Two integers of 16 bits a texel. The quadrature may end above 1.
template <class ToBits>
std::vector<std::uint16_t> in_16_bits(const std::vector<vec2<float>>& texels, const ToBits& to_bits) {
    std::vector<std::uint16_t> bits;
    for (const vec2<float>& t : texels)
        for (const float x : {t.x, t.y}) bits.push_back(to_bits(smaller(x, 1.0f)));
    return bits;
}

}  // namespace detail

/// Texels as RG16F, two halves each, rounded to nearest, ties to even: to 2.5e-4.
inline std::vector<std::uint16_t> rg16f(const std::vector<vec2<float>>& texels) {
    return detail::in_16_bits(texels, detail::half_bits);
}

/// Texels as RG16 unorm, where x is read as bits/65535, rounded to nearest: to 7.7e-6.
inline std::vector<std::uint16_t> rg16_unorm(const std::vector<vec2<float>>& texels) {
    return detail::in_16_bits(texels,
                              [](float x) { return static_cast<std::uint16_t>(std::lround(double(x) * 65535)); });
}

}  // namespace lobe
