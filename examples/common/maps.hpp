#pragma once

#include <cstddef>

#include <lobe/ibl/latlong.hpp>

/// The mean radiance of a map over the sphere of directions, and over r, g and b.
float mean_over_directions(const lobe::latlong<float>&);

/// How often the environment can be halved until its texels would be wider than `angle`.
std::size_t halvings(const lobe::latlong_pyramid<float>&, float angle);

constexpr float diffuse_texel = 0.025f;  // 256 x 128: diffuse light has no details that these would miss
