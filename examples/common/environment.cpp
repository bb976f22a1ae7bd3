#include "environment.hpp"

#include "map_file.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <iostream>
#include <sstream>
#include <string>
#include <string_view>

void check_shape(long long width, long long height) {
    std::ostringstream size;
    size << width << " x " << height << " pixels";
    if (width <= 0 || height <= 0) throw problem("is empty: " + size.str());
    if (width != 2 * height)
        throw problem("is no lat-long map: " + size.str() + ", and its width must be twice its height");
    if (width > largest_width) throw problem("is too large: " + size.str() + ", at most 8192 x 4096 are read");
}

namespace {

constexpr float largest_radiance = 1e20f;  // the squares and sums of anything below stay finite

[[noreturn]] void refuse(int x, int y, float value) {
    std::ostringstream what;
    what << "pixel (" << x << ", " << y << ") holds " << value << ": radiance must be from 0 to 1e20";
    throw problem(what.str());
}

/// Refuses what is no radiance. Values a hair below zero are what lossy compression (DWAB) leaves of black: they become
/// 0.
void check_pixels(map_file& file) {
    image& map = file.pixels;
    for (int y = 0; y < map.height; ++y)
        for (int x = 0; x < map.width; ++x)
            for (int i = 0; i < 3; ++i)
                if (!is_finite(map(x, y)[i]) || map(x, y)[i] > largest_radiance) refuse(x, y, map(x, y)[i]);

    double mean = 0;
    for (const vec3& c : map.pixels)
        mean += std::max(0.0f, mean_of_channels(c)) / static_cast<double>(map.pixels.size());
    const float floor = static_cast<float>(-0.01 * mean);
    int negative = 0;
    for (int y = 0; y < map.height; ++y)
        for (int x = 0; x < map.width; ++x)
            for (int i = 0; i < 3; ++i) {
                float& value = map(x, y)[i];
                if (value < floor) refuse(x, y, value);
                negative += value < 0;
                value = std::max(value, 0.0f);
            }
    if (mean == 0) throw problem("holds no light: every pixel is black");
    if (negative == 0) return;
    std::ostringstream note;
    note << negative << " values between " << floor << " and 0 taken as 0";
    file.notes.push_back(note.str());
}

/// A colour that Rec. 709 cannot mix would need less than nothing of a primary. It gets none.
void convert_to_rec709(map_file& file) {
    int outside = 0;
    for (int y = 0; y < file.pixels.height; ++y)
        for (int x = 0; x < file.pixels.width; ++x) {
            vec3& pixel = file.pixels(x, y);
            const glm::dvec3 colour = file.to_rec709 * glm::dvec3{pixel};
            const double brightest = std::max({colour.x, colour.y, colour.z});
            for (int i = 0; i < 3; ++i) {
                outside += colour[i] < -1e-6 * brightest;  // less is rounding
                pixel[i] = static_cast<float>(std::max(colour[i], 0.0));
                if (pixel[i] > largest_radiance) refuse(x, y, pixel[i]);
            }
        }
    if (outside > 0) file.notes.push_back(std::to_string(outside) + " values of colours outside Rec. 709 taken as 0");
}

map_file read_map(const std::filesystem::path& path) {
    namespace fs = std::filesystem;
    if (!fs::exists(path)) throw problem("does not exist");
    if (!fs::is_regular_file(path)) throw problem("is not a file");
    if (fs::file_size(path) == 0) throw problem("is empty");

    std::ifstream file{path, std::ios::binary};
    if (!file) throw problem("cannot be opened");
    std::array<char, 4> start{};
    file.read(start.data(), start.size());
    const std::string_view magic{start.data(), static_cast<std::size_t>(file.gcount())};
    if (magic == "v/1\x01") try {
            return read_open_exr(path);
        } catch (const problem&) {
            throw;
        } catch (const std::exception& error) {  // OpenEXR's own
            throw problem(std::string("cannot be read: ") + error.what());
        }
    if (magic.starts_with("#?")) return read_radiance(path);  // any name of a program may follow
    throw problem("is neither Radiance HDR nor OpenEXR");
}

/// What a file says of itself goes into messages, and these are one line.
std::string one_line(std::string text) {
    constexpr std::size_t longest = 400;
    if (text.size() > longest) text = text.substr(0, longest) + " ...";
    for (char& c : text)
        if (static_cast<unsigned char>(c) < ' ' || c == '\x7f') c = '?';
    return text;
}

}  // namespace

lobe::latlong<float> load_environment(const std::filesystem::path& path) try {
    map_file file = read_map(path);
    check_pixels(file);
    if (file.to_rec709 != glm::dmat3{1}) convert_to_rec709(file);
    for (const std::string& note : file.notes) std::cout << path.string() << ": " << one_line(note) << '\n';
    return {file.pixels.width, file.pixels.height, std::move(file.pixels.pixels)};
} catch (const std::exception& error) {
    throw std::runtime_error(path.string() + ": " + one_line(error.what()));
}
