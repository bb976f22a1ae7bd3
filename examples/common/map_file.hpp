#pragma once

#include "image.hpp"

#include <bit>
#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include <glm/mat3x3.hpp>

/// What a reader makes of a file: the numbers as they stand there, unchecked, and how to get from them to Rec. 709.
struct map_file {
    image pixels{0, 0};
    glm::dmat3 to_rec709{1};
    std::vector<std::string> notes;  // what the user should know of how it was read
};

using problem = std::runtime_error;

constexpr int largest_width = 8192;
// throws a problem unless it is a lat-long map that is not too large
void check_shape(long long width, long long height);

map_file read_radiance(const std::filesystem::path& path);
map_file read_open_exr(const std::filesystem::path& path);

/// By the bits: under -ffast-math a compiler takes it that no float is a NaN, and drops every comparison that would
/// find one.
inline bool is_finite(float value) { return (std::bit_cast<std::uint32_t>(value) & 0x7f800000u) != 0x7f800000u; }
