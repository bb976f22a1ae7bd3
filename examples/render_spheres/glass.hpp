#pragma once

#include "render.hpp"

/// A ball of glass: what it is made of, and how much of the light is left after crossing it through its middle.
struct glass {
    std::string name;
    float eta;
    vec3 left;
};

/// One sphere for each level of the light: (a) single scattering, (b) compensated, against random walks.
std::vector<sphere> render(const glass&, const baked_light&, const vec3& background, const settings&);
