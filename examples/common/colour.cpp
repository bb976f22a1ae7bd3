#include "colour.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include <glm/matrix.hpp>

using glm::dmat3, glm::dvec2, glm::dvec3;

namespace {

constexpr chromaticities rec709{dvec2{0.64, 0.33}, dvec2{0.30, 0.60}, dvec2{0.15, 0.06}, dvec2{0.3127, 0.3290}};

// K. M. Lam, "Metamerism and Colour Constancy", 1985. GLM wants columns.
const dmat3 bradford = transpose(dmat3{0.8951, 0.2664, -0.1614, -0.7502, 1.7135, 0.0367, 0.0389, -0.0685, 1.0296});

/// X, Y, Z of a chromaticity, with X + Y + Z = 1. No division by y: the blue of some spaces has y = 0 or below.
dvec3 direction(const dvec2& c) { return {c.x, c.y, 1 - c.x - c.y}; }

dvec3 white_of(const chromaticities& space) { return direction(space[3]) / space[3].y; }  // Y = 1

dmat3 directions_of(const chromaticities& space) {
    return {direction(space[0]), direction(space[1]), direction(space[2])};
}

/// SMPTE RP 177: as much of each primary as makes white of all three.
dmat3 to_xyz(const chromaticities& space) {
    const dmat3 directions = directions_of(space);
    const dvec3 amounts = inverse(directions) * white_of(space);
    return {directions[0] * amounts[0], directions[1] * amounts[1], directions[2] * amounts[2]};
}

double smallest(const dvec3& v) { return std::min({v.x, v.y, v.z}); }

/// A triangle, white inside, and a white that all three of Bradford's cones see.
bool is_colour_space(const chromaticities& space) {
    constexpr double least = 1e-4, furthest = 2;  // camera spaces have primaries up to 1.5 from 0
    for (const dvec2& c : space)
        if (!(std::abs(c.x) <= furthest && std::abs(c.y) <= furthest)) return false;
    if (space[3].y < least || std::abs(determinant(directions_of(space))) < least) return false;
    return smallest(inverse(directions_of(space)) * direction(space[3])) >= least &&
           smallest(bradford * white_of(space)) >= least;
}

/// Rec. 709 in other numbers: Photoshop writes its primaries adapted to the D50 of ICC profiles, and rounded. What
/// these differ by is less than a half rounds, and to convert by it would push pure colours out of Rec. 709.
bool is_nearly_one(const dmat3& m) {
    constexpr double rounding = 0x1p-12;
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row)
            if (std::abs(m[column][row] - (row == column)) > rounding) return false;
    return true;
}

}  // namespace

dmat3 to_rec709(const chromaticities& space, const char* name) {
    if (!is_colour_space(space))
        throw std::runtime_error(std::string(name) +
                                 " are of no colour space: three corners of a triangle and a white inside are needed");
    const dvec3 adapted = (bradford * white_of(rec709)) / (bradford * white_of(space));
    const dmat3 adapt = inverse(bradford) * dmat3{adapted.x, 0, 0, 0, adapted.y, 0, 0, 0, adapted.z} * bradford;
    const dmat3 conversion = xyz_to_rec709() * adapt * to_xyz(space);
    return is_nearly_one(conversion) ? dmat3{1} : conversion;
}

dmat3 xyz_to_rec709() { return inverse(to_xyz(rec709)); }
