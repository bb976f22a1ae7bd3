#pragma once

#include "image.hpp"

#include <filesystem>
#include <string>

/// ACES filmic curve, as fitted by Narkowicz 2015, of radiance times exposure, then sRGB.
vec3 tone_mapped(const vec3& radiance, float exposure);

/// sRGB of radiance times exposure and nothing else.
vec3 as_it_is(const vec3& radiance, float exposure);

/// The colours of matplotlib's inferno, black to yellow, for x from 0 to 1.
vec3 false_colour(float x);

void write_png(const std::filesystem::path&, const image& screen_colours);
void write_exr(const std::filesystem::path&, const image& radiance, const std::string& comment);
