#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

/// A texture as Khronos's KTX 2.0 has it, uncompressed: 16-bit floats, two or four a texel; one picture or the six
/// faces of a cube; levels from the largest, each face row by row from the top.
struct texture {
    int channels;  // 2: VK_FORMAT_R16G16_SFLOAT, 4: VK_FORMAT_R16G16B16A16_SFLOAT
    int width, height;
    bool cube;
    std::vector<std::vector<std::uint16_t>> levels;  // the faces of a level one after the other
};

/// Throws std::runtime_error where the file cannot be written.
void write_ktx2(const std::filesystem::path&, const texture&, const std::string& writer);
