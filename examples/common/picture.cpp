#include "picture.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfOutputFile.h>
#include <ImfStandardAttributes.h>
#include <glm/common.hpp>
#include <stb_image_write.h>

// ---- colours
// -----------------------------------------------------------------------------------------------------------

namespace {

float srgb(float x) {
    x = std::clamp(x, 0.0f, 1.0f);
    return x <= 0.0031308f ? 12.92f * x : 1.055f * std::pow(x, 1 / 2.4f) - 0.055f;
}

float filmic(float x) { return x * (2.51f * x + 0.03f) / (x * (2.43f * x + 0.59f) + 0.14f); }

}  // namespace

vec3 tone_mapped(const vec3& radiance, float exposure) {
    const vec3 x = radiance * exposure;
    return {srgb(filmic(x.x)), srgb(filmic(x.y)), srgb(filmic(x.z))};
}

vec3 as_it_is(const vec3& radiance, float exposure) {
    const vec3 x = radiance * exposure;
    return {srgb(x.x), srgb(x.y), srgb(x.z)};
}

vec3 false_colour(float x) {
    static const vec3 inferno[] = {{0, 0, 4},     {27, 12, 65},   {74, 12, 107}, {120, 28, 109}, {165, 44, 96},
                                   {207, 68, 70}, {237, 105, 37}, {251, 155, 6}, {247, 209, 61}, {252, 255, 164}};
    constexpr int last = static_cast<int>(std::size(inferno)) - 1;
    const float position = std::clamp(x, 0.0f, 1.0f) * last;
    const int i = std::min(static_cast<int>(position), last - 1);
    return mix(inferno[i], inferno[i + 1], position - static_cast<float>(i)) / 255.0f;
}

// ---- files
// -------------------------------------------------------------------------------------------------------------

void write_png(const std::filesystem::path& path, const image& screen_colours) {
    std::vector<std::uint8_t> bytes;
    bytes.reserve(3 * screen_colours.pixels.size());
    for (const vec3& c : screen_colours.pixels)
        for (const float x : {c.x, c.y, c.z})
            bytes.push_back(static_cast<std::uint8_t>(std::lround(255 * std::clamp(x, 0.0f, 1.0f))));

    std::ofstream file{path, std::ios::binary};
    const auto append = [](void* out, void* data, int size) {
        static_cast<std::ofstream*>(out)->write(static_cast<char*>(data), size);
    };
    const int done = stbi_write_png_to_func(append, &file, screen_colours.width, screen_colours.height, 3, bytes.data(),
                                            3 * screen_colours.width);
    file.close();
    if (!done || !file) throw std::runtime_error(path.string() + ": cannot be written");
}

void write_exr(const std::filesystem::path& path, const image& radiance, const std::string& comment) try {
    Imf::Header header(radiance.width, radiance.height);
    Imf::addComments(header, comment);
    Imf::FrameBuffer pixels;
    const std::size_t row = sizeof(vec3) * static_cast<std::size_t>(radiance.width);
    const char* const names[] = {"R", "G", "B"};
    for (int i = 0; i < 3; ++i) {
        header.channels().insert(names[i], Imf::Channel(Imf::FLOAT));
        // OpenEXR's slices serve reading too
        auto* first = reinterpret_cast<char*>(const_cast<float*>(&radiance.pixels[0][i]));
        pixels.insert(names[i], Imf::Slice(Imf::FLOAT, first, sizeof(vec3), row));
    }
    Imf::OutputFile file(path.c_str(), header);
    file.setFrameBuffer(pixels);
    file.writePixels(radiance.height);
} catch (const std::exception& error) {
    throw std::runtime_error(path.string() + ": cannot be written: " + error.what());
}
