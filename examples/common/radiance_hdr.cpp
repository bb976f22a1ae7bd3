// Radiance pictures, by "Radiance File Formats" (filefmts.pdf of the Radiance distribution), G. Ward, "Real Pixels",
// Graphics Gems II, 1991, and where these leave a choice by what Radiance's own reader does (Ward,
// ray/src/common/color.c, header.c).
#include "colour.hpp"
#include "map_file.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <limits>
#include <locale>
#include <optional>
#include <sstream>

namespace {

using rgbe = std::array<unsigned char, 4>;  // three mantissas and an exponent that they share

struct source {
    std::ifstream file;
    const char* place = "within its header";

    unsigned char next() {
        const auto byte = file.rdbuf()->sbumpc();
        if (byte == std::ifstream::traits_type::eof()) throw problem(std::string("is truncated: it ends ") + place);
        return static_cast<unsigned char>(byte);
    }

    std::string line() {  // without its end, which is \n or \r\n
        std::string text;
        for (char c = static_cast<char>(next()); c != '\n'; c = static_cast<char>(next())) {
            if (text.size() == 1 << 20) throw problem("is damaged: a line of its header is longer than 1 MiB");
            text += c;
        }
        if (text.ends_with('\r')) text.pop_back();
        return text;
    }

    rgbe pixel() {
        rgbe p;
        for (unsigned char& byte : p) byte = next();
        return p;
    }
};

struct header {
    std::string format;
    glm::dvec3 applied{1};  // what the pixels were multiplied with: all EXPOSUREs and COLORCORRs
    std::optional<chromaticities> primaries;
    bool gamma = false;
};

template <std::size_t N>
std::array<double, N> numbers(const std::string& name, const std::string& text) {
    std::istringstream in{text};
    in.imbue(std::locale::classic());
    std::array<double, N> values{};
    for (double& value : values) in >> value;
    if (!in || !(in >> std::ws).eof())
        throw problem(name + " must be " + (N == 1 ? "a number" : std::to_string(N) + " numbers") + ", not \"" + text +
                      "\"");
    return values;
}

void multiply(header& head, const std::string& name, const std::array<double, 3>& factors) {
    for (int i = 0; i < 3; ++i) {
        if (!(factors[static_cast<std::size_t>(i)] > 0)) throw problem(name + " must be above 0");
        head.applied[i] *= factors[static_cast<std::size_t>(i)];
        if (!(head.applied[i] >= 1e-300 && head.applied[i] <= 1e300))
            throw problem(name + " goes beyond 1e-300 or 1e300");
    }
}

/// Lines NAME=value up to an empty one. EXPOSURE and COLORCORR accumulate, the last PRIMARIES count. All else says
/// nothing of the pixels: comments, the commands that made the picture, and, indented, the headers of the pictures that
/// it was made from.
header read_header(source& in) {
    header head;
    for (std::string line = in.line(); !line.empty(); line = in.line()) {
        const std::size_t equals = line.find('=', 1);
        if (equals == std::string::npos) continue;
        const std::string name = line.substr(0, line.find_last_not_of(" \t", equals - 1) + 1);
        const std::string value = line.substr(equals + 1);
        if (name == "FORMAT") {
            std::string format;
            std::istringstream{value} >> format;
            if (!head.format.empty() && format != head.format) throw problem("FORMAT is given twice, and not the same");
            head.format = format;
            if (format != "32-bit_rle_rgbe" && format != "32-bit_rle_xyze")
                throw problem("FORMAT must be 32-bit_rle_rgbe or 32-bit_rle_xyze, not \"" + value + "\"");
        } else if (name == "EXPOSURE") {
            const double all = numbers<1>(name, value)[0];
            multiply(head, name, {all, all, all});
        } else if (name == "COLORCORR") {
            multiply(head, name, numbers<3>(name, value));
        } else if (name == "PRIMARIES") {
            const auto xy = numbers<8>(name, value);
            head.primaries = chromaticities{{{xy[0], xy[1]}, {xy[2], xy[3]}, {xy[4], xy[5]}, {xy[6], xy[7]}}};
        } else if (name == "GAMMA") {
            head.gamma = true;
        }
    }
    return head;
}

/// "-Y 4 +X 8" is 4 scanlines from the top, each of 8 pixels from the left; "+X 8 -Y 4" is 8 columns from the left,
/// each from the top.
struct resolution {
    long long width = 0, height = 0;
    bool columns = false, leftwards = false, upwards = false;
};

resolution read_resolution(source& in) {
    const std::string line = in.line();
    std::istringstream text{line};
    std::array<char, 2> sign{}, axis{};
    std::array<long long, 2> size{};
    for (std::size_t i = 0; i < 2; ++i) text >> sign[i] >> axis[i] >> size[i];
    const auto is_sign = [](char c) { return c == '+' || c == '-'; };
    const std::size_t x = axis[0] == 'X' ? 0 : 1, y = 1 - x;
    if (!text || !(text >> std::ws).eof() || axis[x] != 'X' || axis[y] != 'Y' || !is_sign(sign[0]) || !is_sign(sign[1]))
        throw problem("the resolution must be like \"-Y 512 +X 1024\", not \"" + line + "\"");
    return {size[x], size[y], x == 0, sign[x] == '-', sign[y] == '+'};
}

/// Pixel after pixel. One with the mantissas 1, 1, 1 (no true pixel is so small against its exponent) repeats the last
/// one as often as its exponent says; the next such one holds the next 8 bits of the count.
void read_old_scanline(source& in, rgbe pixel, std::vector<rgbe>& line) {
    std::size_t i = 0;
    for (int shift = 0;;) {
        if (pixel[0] == 1 && pixel[1] == 1 && pixel[2] == 1) {
            const std::size_t count = static_cast<std::size_t>(pixel[3]) << std::min(shift, 24);
            if (i == 0) throw problem("is damaged: a scanline begins with a repeat count");
            if (count > line.size() - i) throw problem("is damaged: a run goes past the end of its scanline");
            std::fill_n(line.begin() + static_cast<std::ptrdiff_t>(i), count, line[i - 1]);
            i += count;
            shift += 8;
        } else {
            line[i++] = pixel;
            shift = 0;
        }
        if (i == line.size()) return;
        pixel = in.pixel();
    }
}

/// Since Radiance 2.0: the bytes 2, 2, the length in two bytes; then each of the four components by itself, in runs
/// (128 + count, byte) and pieces without one (count, bytes). Scanlines below 8 or above 32767 pixels are never written
/// so.
void read_scanline(source& in, std::vector<rgbe>& line) {
    const rgbe start = in.pixel();
    const std::size_t length = line.size();
    if (length < 8 || length > 32767 || start[0] != 2 || start[1] != 2 || start[2] > 127)
        return read_old_scanline(in, start, line);
    if (start[2] * 256u + start[3] != length)
        throw problem("is damaged: a scanline's length is not that of the picture");
    for (std::size_t component = 0; component < 4; ++component)
        for (std::size_t i = 0; i < length;) {
            const unsigned char code = in.next();
            const bool run = code > 128;
            const std::size_t count = run ? code - 128u : code, end = i + count;
            if (end > length) throw problem("is damaged: a run goes past the end of its scanline");
            const unsigned char byte = run ? in.next() : 0;
            for (; i < end; ++i) line[i][component] = run ? byte : in.next();
        }
}

/// The mantissa is taken as it is, like most programs do (Radiance adds half a step): 1 then is 1.
float decoded(const rgbe& pixel, int i, const header& head) {
    if (pixel[3] == 0) return 0;
    const double value =
        std::ldexp(static_cast<double>(pixel[static_cast<std::size_t>(i)]), pixel[3] - 136) / head.applied[i];
    return static_cast<float>(std::min(value, static_cast<double>(std::numeric_limits<float>::max())));
}

}  // namespace

// Without PRIMARIES the pixels are taken for Rec. 709: that is what nearly all programs write, though Radiance's own
// default has another green and an equal-energy white. XYZ is CIE's, of 1 for white, taken as it stands: no 179 lumens
// a watt, no adaptation.
map_file read_radiance(const std::filesystem::path& path) {
    source in{std::ifstream{path, std::ios::binary}};
    const header head = read_header(in);
    const resolution size = read_resolution(in);
    check_shape(size.width, size.height);

    map_file read;
    read.pixels = {static_cast<int>(size.width), static_cast<int>(size.height)};
    const bool xyz = head.format == "32-bit_rle_xyze";
    if (xyz) read.to_rec709 = xyz_to_rec709();
    if (head.primaries && !xyz) read.to_rec709 = to_rec709(*head.primaries, "PRIMARIES");
    if (head.primaries && xyz) read.notes.push_back("PRIMARIES ignored: they are of RGB, and this is XYZ");
    if (head.gamma) read.notes.push_back("GAMMA ignored: Radiance knows none, its pixels are linear");

    in.place = "before its last pixel";
    image& map = read.pixels;
    std::vector<rgbe> line(static_cast<std::size_t>(size.columns ? map.height : map.width));
    for (int j = 0; j < (size.columns ? map.width : map.height); ++j) {
        read_scanline(in, line);
        for (int i = 0; i < static_cast<int>(line.size()); ++i) {
            const int x = size.columns ? j : i, y = size.columns ? i : j;
            vec3& pixel = map(size.leftwards ? map.width - 1 - x : x, size.upwards ? map.height - 1 - y : y);
            for (int c = 0; c < 3; ++c) pixel[c] = decoded(line[static_cast<std::size_t>(i)], c, head);
        }
    }
    return read;
}
