#pragma once

#include <filesystem>

#include <lobe/ibl/latlong.hpp>

/// A lat-long map from a file, Radiance HDR or OpenEXR whatever its name says, in linear Rec. 709.
/// Says on std::cout what it had to change or choose.
/// Throws std::runtime_error, "FILE: problem", for anything that is no finite, non-negative 2:1 map that holds light.
lobe::latlong<float> load_environment(const std::filesystem::path& file);

/// A photographer's studio: softboxes of different sizes and colours, a floor and a ceiling. 512 x 256, always the
/// same.
lobe::latlong<float> studio_light();

/// The white furnace: radiance 1 from everywhere.
lobe::latlong<float> uniform_light();
