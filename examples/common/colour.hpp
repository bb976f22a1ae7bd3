#pragma once

#include <array>

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>

/// CIE x and y of a colour space's red, green, blue and white.
using chromaticities = std::array<glm::dvec2, 4>;

/// From the linear RGB of a space to linear Rec. 709, which is what the library works in. White stays white: it is
/// adapted to D65 as Bradford's cones see it. Rec. 709 itself, to a half's rounding, gives exactly 1.
/// Throws std::runtime_error, which begins with the name, if these are the chromaticities of no colour space.
glm::dmat3 to_rec709(const chromaticities& space, const char* name);

/// From CIE XYZ to linear Rec. 709; nothing is adapted.
glm::dmat3 xyz_to_rec709();
