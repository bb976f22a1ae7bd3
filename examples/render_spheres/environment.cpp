#include "environment.hpp"

#include "image.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <fstream>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <glm/geometric.hpp>
#include <stb_image.h>

namespace {

constexpr int largest_width = 8192;
constexpr float largest_radiance = 1e20f;  // the squares and sums of anything below stay finite

using problem = std::runtime_error;

void check_shape(long long width, long long height) {
    std::ostringstream size;
    size << width << " x " << height << " pixels";
    if (width <= 0 || height <= 0) throw problem("is empty: " + size.str());
    if (width != 2 * height) throw problem("is no lat-long map: " + size.str() + ", and its width must be twice its height");
    if (width > largest_width) throw problem("is too large: " + size.str() + ", at most 8192 x 4096 are read");
}

/// Refuses what is no radiance. Values a hair below zero are what lossy compression (DWAB) leaves of black: they become 0.
void check_pixels(image& map, const std::filesystem::path& path) {
    double mean = 0;
    for (const vec3& c : map.pixels) mean += std::max(0.0f, mean_of_channels(c)) / static_cast<double>(map.pixels.size());
    const float floor = static_cast<float>(-0.01 * mean);
    int negative = 0;
    for (int y = 0; y < map.height; ++y)
        for (int x = 0; x < map.width; ++x)
            for (int i = 0; i < 3; ++i) {
                float& value = map(x, y)[i];
                if (!(value >= std::min(floor, 0.0f) && value <= largest_radiance)) {
                    std::ostringstream what;
                    what << "pixel (" << x << ", " << y << ") holds " << value << ": radiance must be from 0 to 1e20";
                    throw problem(what.str());
                }
                negative += value < 0;
                value = std::max(value, 0.0f);
            }
    if (mean == 0) throw problem("holds no light: every pixel is black");
    if (negative > 0) std::cout << path.string() << ": " << negative << " values between " << floor << " and 0 taken as 0\n";
}

// Past the end of its data stb_image reads zeros, and its run-length decoder waits there for ever. So this reader hands it
// line feeds, on which every loop of the decoder ends, and remembers that it had to.
struct hdr_reader {
    std::ifstream file;
    bool past_end = false;

    static int read(void* self, char* data, int size) {
        auto& reader = *static_cast<hdr_reader*>(self);
        reader.file.read(data, size);
        const auto got = static_cast<int>(reader.file.gcount());
        if (got > 0) return got;
        reader.past_end = true;
        std::memset(data, '\n', static_cast<std::size_t>(size));
        return size;
    }
    static void skip(void* self, int count) { static_cast<hdr_reader*>(self)->file.seekg(count, std::ios::cur); }
    static int eof(void* self) {
        auto& reader = *static_cast<hdr_reader*>(self);
        return reader.past_end || reader.file.peek() == std::ifstream::traits_type::eof();
    }
};

image read_hdr(const std::filesystem::path& path) {
    const stbi_io_callbacks calls{hdr_reader::read, hdr_reader::skip, hdr_reader::eof};
    int width = 0, height = 0, channels = 0;

    hdr_reader header{std::ifstream{path, std::ios::binary}};
    const bool understood = stbi_info_from_callbacks(&calls, &header, &width, &height, &channels) != 0;
    if (header.past_end) throw problem("is truncated: it ends within its header");
    if (!understood) throw problem(std::string("is no Radiance HDR file that can be read: ") + stbi_failure_reason());
    check_shape(width, height);

    hdr_reader reader{std::ifstream{path, std::ios::binary}};
    float* decoded = stbi_loadf_from_callbacks(&calls, &reader, &width, &height, &channels, 3);
    image map{width, height};
    if (decoded) std::memcpy(map.pixels.data(), decoded, map.pixels.size() * sizeof(vec3));
    stbi_image_free(decoded);
    if (reader.past_end) throw problem("is truncated: it ends before its last pixel");
    if (!decoded) throw problem(std::string("is damaged: ") + stbi_failure_reason());
    return map;
}

// By the OpenEXR library: tinyexr does not know the DWAA and DWAB compression that many published maps use.
image read_exr(const std::filesystem::path& path) {
    Imf::Header::setMaxImageSize(largest_width, largest_width);  // before it believes an absurd header
    Imf::InputFile file{path.c_str()};
    const auto& window = file.header().dataWindow();
    check_shape(1LL + window.max.x - window.min.x, 1LL + window.max.y - window.min.y);
    if (!file.isComplete()) throw problem("is truncated: some of its scan lines are missing");

    image map{window.max.x - window.min.x + 1, window.max.y - window.min.y + 1};
    Imf::FrameBuffer pixels;
    const std::size_t row = sizeof(vec3) * static_cast<std::size_t>(map.width);
    const char* const names[] = {"R", "G", "B"};
    for (int i = 0; i < 3; ++i) {
        if (!file.header().channels().findChannel(names[i])) throw problem(std::string("has no channel ") + names[i]);
        auto* first = reinterpret_cast<char*>(&map.pixels[0][i]);
        pixels.insert(names[i], Imf::Slice::Make(Imf::FLOAT, first, window, sizeof(vec3), row));
    }
    file.setFrameBuffer(pixels);
    file.readPixels(window.min.y, window.max.y);
    return map;
}

image read_map(const std::filesystem::path& path) {
    namespace fs = std::filesystem;
    if (!fs::exists(path)) throw problem("does not exist");
    if (!fs::is_regular_file(path)) throw problem("is not a file");
    if (fs::file_size(path) == 0) throw problem("is empty");

    std::ifstream file{path, std::ios::binary};
    if (!file) throw problem("cannot be opened");
    std::array<char, 10> start{};
    file.read(start.data(), start.size());
    const std::string_view magic{start.data(), static_cast<std::size_t>(file.gcount())};
    if (magic.starts_with("v/1\x01")) try {
            return read_exr(path);
        } catch (const problem&) {
            throw;
        } catch (const std::exception& error) {  // OpenEXR's own
            throw problem(std::string("cannot be read: ") + error.what());
        }
    if (magic.starts_with("#?RADIANCE") || magic.starts_with("#?RGBE")) return read_hdr(path);
    throw problem("is neither Radiance HDR nor OpenEXR");
}

}  // namespace

lobe::latlong<float> load_environment(const std::filesystem::path& file) try {
    image map = read_map(file);
    check_pixels(map, file);
    return {map.width, map.height, std::move(map.pixels)};
} catch (const std::exception& error) {
    throw std::runtime_error(file.string() + ": " + error.what());
}
