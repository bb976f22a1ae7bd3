// Makes Radiance and OpenEXR files, good and bad, and compares what load_environment reads with what was written. The
// pixels of each file are a formula of x and y that no flip, crop or swap of channels leaves alone; conversions of
// colour are compared with published matrices. Run by test_environments.sh.
#include "common/environment.hpp"

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <iostream>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

#include <ImfChannelList.h>
#include <ImfChromaticitiesAttribute.h>
#include <ImfDeepFrameBuffer.h>
#include <ImfDeepScanLineOutputFile.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfMultiPartOutputFile.h>
#include <ImfOutputFile.h>
#include <ImfOutputPart.h>
#include <ImfPartType.h>
#include <ImfRgbaFile.h>
#include <ImfStandardAttributes.h>
#include <ImfTiledOutputPart.h>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

namespace {

namespace fs = std::filesystem;
using glm::dmat3, glm::dvec3;
using colour = std::function<dvec3(int x, int y)>;  // of the picture, from its top left

int passed = 0, failed = 0;

void report(const std::string& name, const std::string& complaint) {
    ++(complaint.empty() ? passed : failed);
    if (!complaint.empty()) std::cerr << "WRONG " << name << ": " << complaint << '\n';
}

/// What load_environment gives: a map, or the text of its exception; and what it said.
struct outcome {
    lobe::latlong<float> map{2, 1, std::vector<glm::vec3>(2)};
    std::string error{}, said{};
};

outcome load(const std::string& file) {
    outcome result;
    std::ostringstream said;
    auto* const screen = std::cout.rdbuf(said.rdbuf());
    try {
        result.map = load_environment(file);
    } catch (const std::exception& error) {
        result.error = error.what();
    }
    std::cout.rdbuf(screen);
    result.said = said.str();
    return result;
}

/// Each channel within tolerance times the largest of the pixel.
void reads(const std::string& file, int width, int height, const colour& expected, double tolerance = 0,
           const std::string& says = "") {
    const outcome got = load(file);
    std::ostringstream complaint;
    if (!got.error.empty()) {
        complaint << "refused: " << got.error;
    } else if (got.map.width != width || got.map.height != height) {
        complaint << "is " << got.map.width << " x " << got.map.height;
    } else if (says.empty() ? !got.said.empty() : got.said.find(says) == std::string::npos) {
        complaint << "said \"" << got.said << "\", not \"" << says << '"';
    } else {
        for (int y = 0; y < height && complaint.str().empty(); ++y)
            for (int x = 0; x < width && complaint.str().empty(); ++x) {
                const dvec3 want = expected(x, y), have{got.map.at(x, y)};
                const double largest = std::max({std::abs(want.x), std::abs(want.y), std::abs(want.z)});
                for (int i = 0; i < 3; ++i)
                    if (!(std::abs(have[i] - want[i]) <= tolerance * largest)) {
                        complaint << "pixel " << x << ' ' << y << " is " << have.x << ' ' << have.y << ' ' << have.z
                                  << ", not " << want.x << ' ' << want.y << ' ' << want.z;
                        break;
                    }
            }
    }
    report(file, complaint.str());
}

void refuses(const std::string& file, const std::string& says) {
    const outcome got = load(file);
    if (got.error.empty())
        report(file, "is read, and ought to be refused: " + says);
    else if (got.error.find(says) == std::string::npos || got.error.find('\n') != std::string::npos ||
             !got.error.starts_with(file))
        report(file, "says \"" + got.error + "\", not \"" + says + '"');
    else
        report(file, "");
}

// ---- Radiance
// ----------------------------------------------------------------------------------------------------------------

using bytes = std::string;
using grid = std::vector<std::vector<bytes>>;  // scanlines of pixels of four bytes

bytes pixel(int r, int g, int b, int e) {
    return {static_cast<char>(r), static_cast<char>(g), static_cast<char>(b), static_cast<char>(e)};
}

constexpr int wide = 16, high = 8;

bytes some_pixel(int x, int y) { return pixel(128 + 3 * x, 90 + 7 * y, 200 - 5 * x, 129 + (y == 3)); }
dvec3 some_colour(int x, int y) { return dvec3{128 + 3 * x, 90 + 7 * y, 200 - 5 * x} / (y == 3 ? 64.0 : 128.0); }

grid picture(int width = wide, int height = high, const std::function<bytes(int, int)>& at = some_pixel) {
    grid rows(static_cast<std::size_t>(height));
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) rows[static_cast<std::size_t>(y)].push_back(at(x, y));
    return rows;
}

bytes flat(const grid& lines) {
    bytes all;
    for (const auto& line : lines)
        for (const bytes& p : line) all += p;
    return all;
}

bytes old_runs(const grid& lines) {
    bytes all;
    for (const auto& line : lines)
        for (std::size_t i = 0, next; i < line.size(); i = next) {
            for (next = i + 1; next < line.size() && line[next] == line[i];) ++next;
            all += line[i];
            for (std::size_t count = next - i - 1; count > 0; count >>= 8)
                all += pixel(1, 1, 1, static_cast<int>(count & 255));
        }
    return all;
}

bytes new_runs(const grid& lines) {
    bytes all;
    for (const auto& line : lines) {
        all += pixel(2, 2, static_cast<int>(line.size() >> 8), static_cast<int>(line.size() & 255));
        for (std::size_t c = 0; c < 4; ++c)
            for (std::size_t i = 0, next; i < line.size(); i = next) {
                for (next = i + 1; next < line.size() && next - i < 127 && line[next][c] == line[i][c];) ++next;
                if (next - i >= 3) {
                    all += {static_cast<char>(128 + next - i), line[i][c]};
                } else {
                    next = std::min(i + 5, line.size());
                    all += static_cast<char>(next - i);
                    for (std::size_t k = i; k < next; ++k) all += line[k][c];
                }
            }
    }
    return all;
}

void write(const std::string& file, const bytes& content) { std::ofstream{file, std::ios::binary} << content; }

const bytes rgbe = "FORMAT=32-bit_rle_rgbe\n", xyze = "FORMAT=32-bit_rle_xyze\n", shape = "\n-Y 8 +X 16\n";

/// A Radiance file with these lines in its header.
std::string with(const std::string& file, const bytes& header) {
    write(file, "#?RADIANCE\n" + header + shape + new_runs(picture()));
    return file;
}

std::string radiance(const std::string& file, const bytes& resolution, const bytes& data) {
    write(file, "#?RADIANCE\n" + rgbe + "\n" + resolution + "\n" + data);
    return file;
}

colour scaled(const dvec3& by) {
    return [by](int x, int y) { return some_colour(x, y) * by; };
}

dmat3 rows(const dvec3& r, const dvec3& g, const dvec3& b) { return transpose(dmat3{r, g, b}); }

/// Colours outside Rec. 709 are cut at 0.
colour converted(const dmat3& m, const colour& from = some_colour) {
    return [m, from](int x, int y) { return max(m * from(x, y), dvec3{0}); };
}

// From Rec. 2020: Rec. ITU-R BT.2087-0. From XYZ of D65: IEC 61966-2-1 gives four decimals (of a white rounded
// otherwise, hence the tolerance). From ACEScg (D60, so adapted by Bradford) and ProPhoto (D50): as published with
// OpenColorIO and by Lindbloom.
const dmat3 from_2020 = rows({1.6605, -0.5876, -0.0728}, {-0.1246, 1.1329, -0.0083}, {-0.0182, -0.1006, 1.1187});
const dmat3 from_xyz = rows({3.2406, -1.5372, -0.4986}, {-0.9689, 1.8758, 0.0415}, {0.0557, -0.2040, 1.0570});
const dmat3 from_acescg =
    rows({1.70505, -0.62179, -0.08326}, {-0.13026, 1.14080, -0.01055}, {-0.02400, -0.12897, 1.15297});
const dmat3 from_prophoto =
    rows({2.03437, -0.72763, -0.30673}, {-0.22883, 1.23175, -0.00292}, {-0.00856, -0.15327, 1.16183});

const bytes primaries_2020 = "PRIMARIES= 0.708 0.292 0.170 0.797 0.131 0.046 0.3127 0.3290\n";
const bytes primaries_709 = "PRIMARIES=.640 .330 .300 .600 .150 .060 .3127 .3290\n";

void radiance_headers() {
    reads(with("new.hdr", rgbe), wide, high, some_colour);
    reads(with("noformat.hdr", ""), wide, high, some_colour);
    reads(with("format_spaces.hdr", "FORMAT = 32-bit_rle_rgbe \n"), wide, high, some_colour);
    reads(with("format_twice.hdr", rgbe + rgbe), wide, high, some_colour);
    reads(with("comments.hdr", "# EXPOSURE=3\nSOFTWARE=x\nVIEW= -vta -vp 0 0 0\npfilt -e 3 EXPOSURE=3\n=\n =\n" + rgbe),
          wide, high, some_colour);
    reads(with("history.hdr", "rpict\n\tpfilt -1 -e 3\n\tEXPOSURE=3\n EXPOSURE=nan\n\tFORMAT=ascii\n" + rgbe), wide,
          high, some_colour);
    reads(with("long.hdr", "COMMENT=" + bytes(100000, 'x') + "\n" + rgbe), wide, high, some_colour);
    reads(with("gamma.hdr", rgbe + "GAMMA=2.2\n"), wide, high, some_colour, 0, "GAMMA ignored");
    for (const char* magic : {"#?RGBE", "#?rpict", "#?"}) {
        write("magic.hdr", magic + ("\n" + rgbe) + shape + new_runs(picture()));
        reads("magic.hdr", wide, high, some_colour);
    }
    write("crlf.hdr", "#?RADIANCE\r\nFORMAT=32-bit_rle_rgbe\r\nEXPOSURE=2\r\n\r\n-Y 8 +X 16\r\n" + new_runs(picture()));
    reads("crlf.hdr", wide, high, scaled(dvec3{0.5}));
    write("trailing.hdr", "#?RADIANCE\n" + shape + new_runs(picture()) + "more");
    reads("trailing.hdr", wide, high, some_colour);

    // the pixels were multiplied with these
    reads(with("exposure.hdr", rgbe + "EXPOSURE=2.0\n"), wide, high, scaled(dvec3{0.5}));
    reads(with("exposures.hdr", "EXPOSURE= 4\nEXPOSURE=.5\nEXPOSURE =\t4e+0 \n" + rgbe), wide, high,
          scaled(dvec3{0.125}));
    reads(with("small.hdr", "EXPOSURE=1.0e-03\n" + rgbe), wide, high, scaled(dvec3{1000}), 1e-7);
    reads(with("colorcorr.hdr", rgbe + "COLORCORR= 2 1 1\n"), wide, high, scaled({0.5, 1, 1}));
    reads(with("corrections.hdr", "COLORCORR=2 4 .5\nEXPOSURE=2\nCOLORCORR=1 2 4\n" + rgbe), wide, high,
          scaled({0.25, 0.0625, 0.25}));

    // colours: the float's rounding for exact ones, the last published digit for the others
    reads(with("p709.hdr", rgbe + primaries_709), wide, high, some_colour);
    reads(with("p2020.hdr", rgbe + primaries_2020), wide, high, converted(from_2020), 2e-4);
    reads(with("p_last.hdr", primaries_2020 + rgbe + primaries_709), wide, high, some_colour);
    reads(with("p_exposed.hdr", primaries_2020 + rgbe + "EXPOSURE=2\nCOLORCORR=1 2 1\n"), wide, high,
          converted(from_2020, scaled({0.5, 0.25, 0.5})), 2e-4);
    reads(with("p_swapped.hdr", "PRIMARIES=.150 .060 .640 .330 .300 .600 .3127 .3290\n" + rgbe), wide, high,
          converted({0, 0, 1, 1, 0, 0, 0, 1, 0}), 1e-6);
    reads(with("p_mirrored.hdr", "PRIMARIES=.300 .600 .640 .330 .150 .060 .3127 .3290\n" + rgbe), wide, high,
          converted({0, 1, 0, 1, 0, 0, 0, 0, 1}), 1e-6);
    reads(with("p_prophoto.hdr", "PRIMARIES=.7347 .2653 .1596 .8404 .0366 .0001 .3457 .3585\n" + rgbe), wide, high,
          converted(from_prophoto), 2e-5);
    const auto white = [](int, int) { return pixel(128, 128, 128, 129); };
    write("p_white.hdr",
          "#?RADIANCE\nPRIMARIES=.640 .330 .290 .600 .150 .060 .333 .333\n" + shape + flat(picture(wide, high, white)));
    reads(
        "p_white.hdr", wide, high, [](int, int) { return dvec3{1}; }, 1e-6);
    const auto green = [](int, int) { return pixel(0, 128, 0, 129); };
    write("p_green.hdr", "#?RADIANCE\n" + primaries_2020 + shape + flat(picture(wide, high, green)));
    reads(
        "p_green.hdr", wide, high,
        [](int, int) {
            return dvec3{0, 1.1329, 0};
        },
        1e-4, "256 values of colours outside Rec. 709 taken as 0");
    reads(with("xyze.hdr", xyze), wide, high, converted(from_xyz), 1e-3);
    reads(with("xyze_exposed.hdr", xyze + "EXPOSURE=4\n"), wide, high, converted(from_xyz, scaled(dvec3{0.25})), 1e-3);
    reads(with("xyze_p.hdr", xyze + primaries_2020), wide, high, converted(from_xyz), 1e-3, "PRIMARIES ignored");

    refuses(with("spectra.hdr", "FORMAT=Radiance_spectra\n"),
            "FORMAT must be 32-bit_rle_rgbe or 32-bit_rle_xyze, not \"Radiance_spectra\"");
    refuses(with("format_none.hdr", "FORMAT=\n"), "FORMAT must be");
    refuses(with("format_two.hdr", rgbe + xyze), "FORMAT is given twice");
    for (const char* value : {"", "abc", "nan", "inf", "1 2", "2x", "0x10", "1e999", "1,5"})
        refuses(with("exposure_bad.hdr", rgbe + "EXPOSURE=" + value + "\n"),
                "EXPOSURE must be a number, not \"" + std::string(value) + "\"");
    for (const char* value : {"0", "-1", "-0.0"})
        refuses(with("exposure_zero.hdr", rgbe + "EXPOSURE=" + value + "\n"), "EXPOSURE must be above 0");
    refuses(with("exposure_absurd.hdr", "EXPOSURE=1e200\nEXPOSURE=1e200\n"), "EXPOSURE goes beyond");
    refuses(with("exposure_tiny.hdr", "EXPOSURE=1e-200\nEXPOSURE=1e-200\n"), "EXPOSURE goes beyond");
    refuses(with("exposure_bright.hdr", "EXPOSURE=1e-40\n"), "radiance must be from 0 to 1e20");
    refuses(with("exposure_dark.hdr", "EXPOSURE=1e60\n"), "holds no light");
    refuses(with("colorcorr_two.hdr", "COLORCORR=1 2\n"), "COLORCORR must be 3 numbers");
    refuses(with("colorcorr_zero.hdr", "COLORCORR=1 0 2\n"), "COLORCORR must be above 0");
    refuses(with("p_seven.hdr", "PRIMARIES=.640 .330 .290 .600 .150 .060 .333\n"), "PRIMARIES must be 8 numbers");
    for (const char* xy : {"0 0 0 0 0 0 0 0", ".64 .33 .64 .33 .15 .06 .3127 .329", ".1 .1 .2 .2 .3 .3 .3127 .329",
                           ".64 .33 .3 .6 .15 .06 .3127 0", ".64 .33 .3 .6 .15 .06 .7 .29",
                           ".64 .33 .3 .6 .15 .06 .64 .33", "640 330 300 600 150 60 312.7 329"})
        refuses(with("p_bad.hdr", "PRIMARIES=" + bytes(xy) + "\n"), "PRIMARIES are of no colour space");
    refuses(with("control.hdr", "EXPOSURE=\x1b[31m\rno" + bytes(1000, 'x') + "\n"),
            "EXPOSURE must be a number, not \"?[31m?no");
    refuses(with("endless.hdr", bytes(2000000, 'x')), "a line of its header is longer than 1 MiB");
    write("nomagic.hdr", rgbe + shape + new_runs(picture()));
    refuses("nomagic.hdr", "is neither Radiance HDR nor OpenEXR");
}

void radiance_orientations() {
    for (const bool columns : {false, true})
        for (const char sx : {'+', '-'})
            for (const char sy : {'+', '-'}) {
                // filefmts: X goes right and Y up from the lower left corner
                grid lines;
                const int count = columns ? wide : high, length = columns ? high : wide;
                for (int j = 0; j < count; ++j) {
                    lines.emplace_back();
                    for (int i = 0; i < length; ++i) {
                        const int along_x = columns ? j : i, along_y = columns ? i : j;
                        const int right = sx == '+' ? along_x : wide - 1 - along_x,
                                  up = sy == '+' ? along_y : high - 1 - along_y;
                        lines.back().push_back(some_pixel(right, high - 1 - up));
                    }
                }
                const bytes x = bytes{sx, 'X'} + " 16", y = bytes{sy, 'Y'} + " 8";
                const bytes resolution = columns ? x + " " + y : y + " " + x;
                for (const auto& packed : {flat, old_runs, new_runs})
                    reads(radiance(resolution + ".hdr", resolution, packed(lines)), wide, high, some_colour);
            }
    reads(radiance("spaces.hdr", "  -Y   8\t+X  16 ", flat(picture())), wide, high, some_colour);
    reads(radiance("narrow.hdr", "-Y8+X16", flat(picture())), wide, high, some_colour);
    for (const char* resolution : {"", "-Y 8", "Y 8 X 16", "-Y 8 -Y 16", "+X 8 +X 16", "-Z 8 +X 16", "-Y 8 +X 16 3",
                                   "-Y a +X b", "-Y 8.5 +X 17", "-Y 99999999999999999999 +X 1", "=Y 8 +X 16"})
        refuses(radiance("resolution.hdr", resolution, flat(picture())), "the resolution must be like");
    refuses(radiance("upright.hdr", "-Y 16 +X 8", flat(picture())),
            "8 x 16 pixels, and its width must be twice its height");
    refuses(radiance("none.hdr", "-Y 0 +X 0", ""), "is empty: 0 x 0 pixels");
    refuses(radiance("less.hdr", "-X -16 -Y -8", ""), "is empty: -16 x -8 pixels");
    refuses(radiance("above.hdr", "-Y 4097 +X 8194", ""), "is too large: 8194 x 4097");
    refuses(radiance("absurd.hdr", "+X 4000000000000000000 +Y 2000000000000000000", ""), "is too large");
}

void radiance_scanlines() {
    const auto runny = [](int x, int y) { return some_pixel(x < 3 ? 0 : x < 9 ? 5 : x, y / 2); };
    const colour runny_colour = [](int x, int y) { return some_colour(x < 3 ? 0 : x < 9 ? 5 : x, y / 2); };
    for (const auto& packed : {flat, old_runs, new_runs})
        reads(radiance("runs.hdr", "-Y 8 +X 16", packed(picture(wide, high, runny))), wide, high, runny_colour);
    grid first = picture(), rest = picture();
    first.resize(2);
    rest.erase(rest.begin(), rest.begin() + 2);
    reads(radiance("mixed.hdr", "-Y 8 +X 16", flat(first) + new_runs(rest)), wide, high, some_colour);
    reads(radiance("mixed_old.hdr", "-Y 8 +X 16", new_runs(first) + old_runs(rest)), wide, high, some_colour);
    for (const int w : {2, 4, 6})  // too narrow for new runs
        for (const auto& packed : {flat, old_runs})
            reads(radiance("small.hdr", "-Y " + std::to_string(w / 2) + " +X " + std::to_string(w),
                           packed(picture(w, w / 2))),
                  w, w / 2, some_colour);
    for (const int same : {257, 700, 1024}) {  // counts of 256, 699 and 1023 repeats take two bytes
        const auto at = [same](int x, int y) { return some_pixel(x < same ? 0 : 9, y % 8); };
        for (const auto& packed : {old_runs, new_runs})
            reads(radiance("wide.hdr", "-Y 512 +X 1024", packed(picture(1024, 512, at))), 1024, 512,
                  [same](int x, int y) { return some_colour(x < same ? 0 : 9, y % 8); });
    }
    // a count of 0 does nothing; a pixel of exponent 0 is black whatever its mantissas; 255 mantissas and small
    // exponents
    const bytes bright = pixel(255, 128, 0, 190), faint = pixel(128, 0, 255, 40), black = pixel(7, 8, 9, 0);
    reads(radiance("ends.hdr", "-Y 1 +X 2", bright + pixel(1, 1, 1, 0) + faint), 2, 1, [](int x, int) {
        return x == 0 ? std::ldexp(1.0, 54) * dvec3{255, 128, 0} : std::ldexp(1.0, -96) * dvec3{128, 0, 255};
    });
    reads(radiance("black.hdr", "-Y 1 +X 2", black + pixel(128, 128, 128, 129)), 2, 1,
          [](int x, int) { return dvec3{1.0 * x}; });

    const bytes grey = pixel(128, 128, 128, 129), start = pixel(2, 2, 0, 16);
    const auto repeats = [](int n) { return pixel(1, 1, 1, n); };
    refuses(radiance("first.hdr", "-Y 8 +X 16", repeats(15) + flat(picture())),
            "is damaged: a scanline begins with a repeat count");
    refuses(radiance("first_next.hdr", "-Y 8 +X 16", grey + repeats(15) + repeats(15)),
            "is damaged: a scanline begins with a repeat count");
    refuses(radiance("past.hdr", "-Y 8 +X 16", grey + repeats(16) + flat(picture())),
            "is damaged: a run goes past the end");
    refuses(radiance("far.hdr", "-Y 8 +X 16",
                     grey + repeats(0) + repeats(0) + repeats(0) + repeats(0) + repeats(0) + repeats(0) + repeats(1)),
            "is damaged: a run goes past the end");
    refuses(radiance("past_run.hdr", "-Y 8 +X 16", start + "\x91\x80" + flat(picture())),
            "is damaged: a run goes past the end");
    refuses(radiance("past_piece.hdr", "-Y 8 +X 16", start + "\x11" + flat(picture())),
            "is damaged: a run goes past the end");
    refuses(radiance("length.hdr", "-Y 8 +X 16", pixel(2, 2, 0, 15) + flat(picture())),
            "is damaged: a scanline's length is not that of the picture");
    refuses(radiance("zeros.hdr", "-Y 8 +X 16", start + bytes(5000, '\0')), "is truncated");
    refuses(radiance("night.hdr", "-Y 8 +X 16", bytes(512, '\0')), "holds no light");

    for (const auto& packed : {flat, old_runs, new_runs}) {
        const bytes data = packed(picture(wide, high, runny)), head = "#?RADIANCE\n" + rgbe + "EXPOSURE=1\n" + shape;
        for (std::size_t n = 0; n < head.size() + data.size(); ++n) {
            write("cut.hdr", (head + data).substr(0, n));
            refuses("cut.hdr", n == 0            ? "is empty"
                               : n < 2           ? "is neither"
                               : n < head.size() ? "is truncated: it ends within its header"
                                                 : "is truncated: it ends before its last pixel");
        }
    }
}

// ---- OpenEXR
// -----------------------------------------------------------------------------------------------------------------

struct channel {
    std::string name;
    Imf::PixelType type;
    std::function<double(int, int)> at;  // of the place in the display window, from its top left
};

std::vector<channel> rgb(Imf::PixelType type = Imf::FLOAT, const std::string& layer = "", double factor = 1) {
    std::vector<channel> three;
    for (int i = 0; i < 3; ++i)
        three.push_back({layer + "RGB"[i], type, [i, factor](int x, int y) { return factor * some_colour(x, y)[i]; }});
    return three;
}

std::vector<channel> together(std::vector<channel> a, const std::vector<channel>& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

using box = Imath::Box2i;
constexpr auto at_once = std::numeric_limits<int>::max();

struct part {
    std::vector<channel> channels;
    box display{{0, 0}, {wide - 1, high - 1}}, data = display;
    std::string name = "part";
    bool tiled = false;
    int lines = at_once;  // how many are written
    Imf::Compression compression = Imf::ZIP_COMPRESSION;
    std::function<void(Imf::Header&)> change = [](Imf::Header&) {};
};

/// Writes a file of one part or of several.
std::string exr(const std::string& file, const std::vector<part>& parts) {
    std::vector<Imf::Header> headers;
    for (const part& p : parts) {
        Imf::Header h{p.display, p.data};
        h.compression() = p.compression;
        h.setType(p.tiled ? Imf::TILEDIMAGE : Imf::SCANLINEIMAGE);
        if (p.tiled) h.setTileDescription({5, 3, Imf::ONE_LEVEL});
        if (parts.size() > 1) h.setName(p.name);
        for (const channel& c : p.channels) h.channels().insert(c.name, Imf::Channel{c.type});
        p.change(h);
        headers.push_back(h);
    }
    Imf::MultiPartOutputFile out{file.c_str(), headers.data(), static_cast<int>(headers.size())};
    for (std::size_t k = 0; k < parts.size(); ++k) {
        const part& p = parts[k];
        const int width = p.data.max.x - p.data.min.x + 1, height = p.data.max.y - p.data.min.y + 1;
        Imf::FrameBuffer buffer;
        std::vector<std::vector<char>> bytes_of(p.channels.size());
        for (std::size_t c = 0; c < p.channels.size(); ++c) {
            const auto type = p.channels[c].type;
            const std::size_t size = type == Imf::HALF ? 2 : 4;
            bytes_of[c].resize(size * static_cast<std::size_t>(width * height));
            char* to = bytes_of[c].data();
            for (int y = p.data.min.y; y <= p.data.max.y; ++y)
                for (int x = p.data.min.x; x <= p.data.max.x; ++x, to += size) {
                    const double value = p.channels[c].at(x - p.display.min.x, y - p.display.min.y);
                    if (type == Imf::HALF) *reinterpret_cast<half*>(to) = half{static_cast<float>(value)};
                    if (type == Imf::FLOAT) *reinterpret_cast<float*>(to) = static_cast<float>(value);
                    if (type == Imf::UINT) *reinterpret_cast<unsigned*>(to) = static_cast<unsigned>(value);
                }
            buffer.insert(p.channels[c].name, Imf::Slice::Make(type, bytes_of[c].data(), p.data, size,
                                                               size * static_cast<std::size_t>(width)));
        }
        if (p.tiled) {
            Imf::TiledOutputPart tiles{out, static_cast<int>(k)};
            tiles.setFrameBuffer(buffer);
            for (int y = 0; y < std::min(tiles.numYTiles(), p.lines); ++y)
                tiles.writeTiles(0, tiles.numXTiles() - 1, y, y);
        } else {
            Imf::OutputPart lines{out, static_cast<int>(k)};
            lines.setFrameBuffer(buffer);
            lines.writePixels(std::min(height, p.lines));
        }
    }
    return file;
}

std::string exr(const std::string& file, const part& p) { return exr(file, std::vector{p}); }

colour within(const box& data) {
    return [data](int x, int y) { return data.intersects(Imath::V2i{x, y}) ? some_colour(x, y) : dvec3{0}; };
}

std::function<void(Imf::Header&)> chromaticities(Imath::V2f r, Imath::V2f g, Imath::V2f b, Imath::V2f w) {
    return [=](Imf::Header& h) { addChromaticities(h, Imf::Chromaticities{r, g, b, w}); };
}

constexpr double half_rounding = 0x1p-11;

void exr_windows() {
    const box all{{0, 0}, {wide - 1, high - 1}};
    reads(exr("whole.exr", {.channels = rgb()}), wide, high, some_colour);
    for (const bool tiled : {false, true}) {
        for (const box& data :
             {box{{3, 2}, {9, 5}}, box{{0, 0}, {7, 3}}, box{{15, 7}, {15, 7}}, box{{-4, -3}, {20, 12}},
              box{{-5, 4}, {3, 20}}, box{{-1, 0}, {16, 7}}, box{{8, -9}, {30, 1}}, box{{0, -1}, {15, 6}}})
            reads(exr("window.exr", {.channels = rgb(), .data = data, .tiled = tiled}), wide, high, within(data));
        // a display window from elsewhere than 0; values are of the place in it
        const box display{{-8, -20}, {7, -13}}, data{{-10, -18}, {2, -15}};
        reads(exr("origin.exr", {.channels = rgb(), .display = display, .data = display, .tiled = tiled}), wide, high,
              some_colour);
        reads(exr("origin_crop.exr", {.channels = rgb(), .display = display, .data = data, .tiled = tiled}), wide, high,
              within({{-2, 2}, {10, 5}}));
        refuses(exr("outside.exr", {.channels = rgb(), .data = {{16, 0}, {31, 7}}, .tiled = tiled}), "holds no light");
        refuses(exr("shape.exr", {.channels = rgb(), .display = {{0, 0}, {7, 7}}, .data = all, .tiled = tiled}),
                "8 x 8 pixels, and its width must be twice");
    }
    // what lies outside the display window is not even looked at
    auto odd = rgb();
    odd[0].at = [](int x, int y) { return x < 0 ? std::nan("") : some_colour(x, y).x; };
    reads(exr("outside_nan.exr", {.channels = odd, .data = {{-4, 0}, {15, 7}}}), wide, high, some_colour);
}

void exr_types() {
    reads(exr("half.exr", {.channels = rgb(Imf::HALF)}), wide, high, some_colour, half_rounding);
    reads(exr("uint.exr", {.channels = rgb(Imf::UINT)}), wide, high,
          [](int x, int y) { return floor(some_colour(x, y)); });
    auto mixed = rgb();
    mixed[0].type = Imf::HALF;
    mixed[1].type = Imf::UINT;
    reads(
        exr("mixed.exr", {.channels = mixed}), wide, high,
        [](int x, int y) {
            const dvec3 c = some_colour(x, y);
            return dvec3{c.x, std::floor(c.y), c.z};
        },
        half_rounding);
    for (const auto lossless : {Imf::NO_COMPRESSION, Imf::RLE_COMPRESSION, Imf::ZIPS_COMPRESSION, Imf::ZIP_COMPRESSION,
                                Imf::PIZ_COMPRESSION, Imf::B44_COMPRESSION, Imf::DWAA_COMPRESSION})
        reads(exr("packed.exr", {.channels = rgb(), .compression = lossless}), wide, high, some_colour,
              lossless == Imf::DWAA_COMPRESSION ? 0.02 : 0);
    for (const auto lossy : {Imf::PXR24_COMPRESSION, Imf::B44A_COMPRESSION, Imf::DWAB_COMPRESSION})
        reads(exr("lossy.exr", {.channels = rgb(Imf::HALF), .compression = lossy}), wide, high, some_colour, 0.05);
    reads(exr("upwards.exr", {.channels = rgb(), .change = [](Imf::Header& h) { h.lineOrder() = Imf::DECREASING_Y; }}),
          wide, high, some_colour);
    reads(exr("tiled.exr", {.channels = rgb(), .tiled = true}), wide, high, some_colour);
    reads(exr("aspect.exr", {.channels = rgb(), .change = [](Imf::Header& h) { h.pixelAspectRatio() = 2; }}), wide,
          high, some_colour);
    reads(exr("luminance.exr", {.channels = rgb(), .change = [](Imf::Header& h) { addWhiteLuminance(h, 100); }}), wide,
          high, some_colour);
    reads(exr("alpha.exr", {.channels = together(rgb(), {{"A", Imf::HALF, [](int, int) { return 0.5; }}})}), wide, high,
          some_colour);
}

void exr_colours() {
    reads(exr("c709.exr", {.channels = rgb(),
                           .change = chromaticities({.64f, .33f}, {.30f, .60f}, {.15f, .06f}, {.3127f, .3290f})}),
          wide, high, some_colour);
    // what Photoshop writes for sRGB
    reads(exr("c709_d50.exr", {.channels = rgb(),
                               .change = chromaticities({.6484474f, .3308766f}, {.3211871f, .5978943f},
                                                        {.1559014f, .0660563f}, {.3457084f, .3585413f})}),
          wide, high, some_colour);
    reads(
        exr("c2020.exr", {.channels = rgb(),
                          .change = chromaticities({.708f, .292f}, {.170f, .797f}, {.131f, .046f}, {.3127f, .3290f})}),
        wide, high, converted(from_2020), 2e-4);
    reads(exr("acescg.exr",
              {.channels = rgb(),
               .data = {{2, 1}, {20, 4}},
               .change = chromaticities({.713f, .293f}, {.165f, .830f}, {.128f, .044f}, {.32168f, .33767f})}),
          wide, high, converted(from_acescg, within({{2, 1}, {20, 4}})), 2e-5);
    // the axes of XYZ as primaries, of which one has y = 0, and D65's XYZ as white, so that R, G, B are X, Y, Z over
    // those of D65
    const dvec3 d65 = dvec3{0.3127, 0.3290, 1 - 0.3127 - 0.3290} / 0.3290;
    reads(exr("xyz.exr", {.channels = rgb(), .change = chromaticities({1, 0}, {0, 1}, {0, 0}, {.3127f, .3290f})}), wide,
          high, converted(from_xyz, [d65](int x, int y) { return some_colour(x, y) * d65; }), 1e-3);
    refuses(exr("c_line.exr",
                {.channels = rgb(), .change = chromaticities({.1f, .1f}, {.2f, .2f}, {.3f, .3f}, {.3127f, .3290f})}),
            "chromaticities are of no colour space");
    refuses(exr("c_zero.exr", {.channels = rgb(), .change = chromaticities({0, 0}, {0, 0}, {0, 0}, {0, 0})}),
            "chromaticities are of no colour space");
    const float nan = std::numeric_limits<float>::quiet_NaN();
    refuses(exr("c_nan.exr", {.channels = rgb(),
                              .change = chromaticities({nan, .33f}, {.30f, .60f}, {.15f, .06f}, {.3127f, .3290f})}),
            "chromaticities must be finite");
    const auto to_2020 = chromaticities({.708f, .292f}, {.170f, .797f}, {.131f, .046f}, {.3127f, .3290f});

    const auto luminance = [](int x, int y) { return some_colour(x, y).x; };
    const colour grey = [](int x, int y) { return dvec3{some_colour(x, y).x}; };
    for (const auto type : {Imf::FLOAT, Imf::HALF}) {
        const double rounding = type == Imf::HALF ? half_rounding : 0;
        reads(exr("y.exr", {.channels = {{"Y", type, luminance}}}), wide, high, grey, rounding);
        reads(exr("ya.exr", {.channels = {{"Y", type, luminance}, {"A", type, luminance}}, .tiled = true}), wide, high,
              grey, rounding);
        reads(exr("y_2020.exr", {.channels = {{"Y", type, luminance}}, .change = to_2020}), wide, high, grey,
              rounding + 1e-6);
    }
    // luminance and chroma as the library writes them: chroma at every other pixel (so one colour is taken), rounded to
    // 5 bits
    for (const box& data : {box{{0, 0}, {wide - 1, high - 1}}, box{{4, 2}, {13, 5}}, box{{-6, -4}, {9, 3}}}) {
        const Imf::Header header{{{0, 0}, {wide - 1, high - 1}}, data};
        const int width = data.max.x - data.min.x + 1, height = data.max.y - data.min.y + 1;
        std::vector<Imf::Rgba> pixels(static_cast<std::size_t>(width * height), Imf::Rgba{0.5f, 0.25f, 0.75f});
        {
            Imf::RgbaOutputFile out{"yc.exr", header, Imf::WRITE_YC};
            out.setFrameBuffer(pixels.data() - data.min.x - width * data.min.y, 1, static_cast<std::size_t>(width));
            out.writePixels(height);
        }
        const colour expected = [data](int x, int y) {
            return data.intersects(Imath::V2i{x, y}) ? dvec3{0.5, 0.25, 0.75} : dvec3{0};
        };
        reads("yc.exr", wide, high, expected, 0x1p-6);
    }
    refuses(exr("yc_parts.exr",
                {{.channels = {{"Y", Imf::HALF, luminance}, {"RY", Imf::HALF, luminance}, {"BY", Imf::HALF, luminance}},
                  .name = "a"},
                 {.channels = {{"Z", Imf::HALF, luminance}}, .name = "b"}}),
            "several parts, and luminance and chroma");
}

void exr_layers() {
    const auto one = [](int, int) { return 1.0; };
    const channel depth{"Z", Imf::FLOAT, one};
    reads(exr("layer.exr", {.channels = rgb(Imf::FLOAT, "beauty.")}), wide, high, some_colour, 0,
          "layer beauty is read");
    reads(exr("nested.exr", {.channels = together(rgb(Imf::HALF, "View Layer.Combined."),
                                                  {{"View Layer.Depth.Z", Imf::FLOAT, one}})}),
          wide, high, some_colour, half_rounding, "layer View Layer.Combined is read");
    reads(exr("top.exr", {.channels = together(rgb(), together(rgb(Imf::FLOAT, "a.", 2), rgb(Imf::FLOAT, "z.", 3)))}),
          wide, high, some_colour);
    reads(
        exr("layer_y.exr", {.channels = {{"lum.Y", Imf::FLOAT, one}, {"Z", Imf::FLOAT, one}}}), wide, high,
        [](int, int) { return dvec3{1}; }, 0, "layer lum is read");
    reads(exr("top_y.exr", {.channels = together({{"Y", Imf::FLOAT, one}}, rgb(Imf::FLOAT, "a."))}), wide, high,
          [](int, int) { return dvec3{1}; });
    refuses(exr("two.exr", {.channels = together(rgb(Imf::FLOAT, "diffuse."), rgb(Imf::FLOAT, "specular."))}),
            "has several layers and none at the top level: diffuse, specular");
    refuses(exr("depth.exr", {.channels = {depth}}), "has no channels R, G and B, and no Y: only Z");
    auto no_blue = rgb();
    no_blue.pop_back();
    refuses(exr("rg.exr", {.channels = no_blue}), "has no channels R, G and B, and no Y: only G, R");
    refuses(exr("line.exr", {.channels = {{"a\nb", Imf::FLOAT, one}}}), "only a?b");

    reads(exr("second.exr", {{.channels = {depth}, .name = "depth"}, {.channels = rgb(), .name = "beauty"}}), wide,
          high, some_colour);
    reads(exr("second_tiled.exr", {{.channels = {depth}, .name = "depth"},
                                   {.channels = rgb(), .data = {{3, 2}, {9, 5}}, .name = "beauty", .tiled = true}}),
          wide, high, within({{3, 2}, {9, 5}}));
    reads(exr("both.exr", {{.channels = rgb(), .name = "left"}, {.channels = rgb(Imf::FLOAT, "", 2), .name = "right"}}),
          wide, high, some_colour, 0, "the first is read, \"left\"");
    reads(exr("layers.exr",
              {{.channels = rgb(Imf::FLOAT, "a.", 2), .name = "first"}, {.channels = rgb(), .name = "second"}}),
          wide, high, some_colour);
    refuses(exr("parts.exr", {{.channels = rgb(Imf::FLOAT, "a."), .name = "first"},
                              {.channels = rgb(Imf::FLOAT, "b."), .name = "second"}}),
            "a (part first), b (part second)");
    {
        Imf::Header header{wide, high};
        header.setType(Imf::DEEPSCANLINE);
        header.compression() = Imf::ZIPS_COMPRESSION;
        for (const char* name : {"R", "G", "B", "Z"}) header.channels().insert(name, Imf::Channel{Imf::HALF});
        Imf::DeepScanLineOutputFile out{"deep.exr", header};
    }
    refuses("deep.exr", "is a deep image, and these are not read");
    {
        Imf::Header header{wide, high};
        for (const char* name : {"R", "G", "B"})
            header.channels().insert(name, Imf::Channel{Imf::HALF, name[0] == 'B' ? 2 : 1, 1});
        std::vector<half> pixels(wide * high, half{1.0f});
        Imf::OutputFile out{"sampled.exr", header};
        Imf::FrameBuffer buffer;
        for (const char* name : {"R", "G", "B"})
            buffer.insert(name, Imf::Slice{Imf::HALF, reinterpret_cast<char*>(pixels.data()), sizeof(half),
                                           sizeof(half) * wide, name[0] == 'B' ? 2 : 1, 1});
        out.setFrameBuffer(buffer);
        out.writePixels(high);
    }
    refuses("sampled.exr", "has the channel B subsampled");
}

void exr_bad_pixels() {
    const double inf = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
    struct bad {
        double value;
        const char* says;
    };
    for (const auto type : {Imf::FLOAT, Imf::HALF})
        for (const auto& [value, says] :
             {bad{nan, "nan"}, bad{-nan, "nan"}, bad{inf, "inf"}, bad{-inf, "-inf"}, bad{-1, "-1"}})
            for (int i = 0; i < 3; ++i) {
                auto channels = rgb(type);
                channels[static_cast<std::size_t>(i)].at = [value = value](int x, int y) {
                    return x == 5 && y == 6 ? value : 0.5;
                };
                refuses(exr("bad.exr", {.channels = channels}),
                        std::string("pixel (5, 6) holds ") + (says[0] == 'n' ? "" : says));
            }
    auto bright = rgb();
    bright[2].at = [](int, int) { return 2e20; };
    refuses(exr("bright.exr", {.channels = bright}), "pixel (0, 0) holds 2e+20");
    auto below = rgb();
    below[2].at = [](int x, int) { return x == 0 ? -0.001 : 0.5; };
    reads(
        exr("below.exr", {.channels = below}), wide, high,
        [](int x, int y) {
            const dvec3 c = some_colour(x, y);
            return dvec3{c.x, c.y, x == 0 ? 0 : 0.5};
        },
        0, "8 values between");
}

void exr_cut() {
    for (const bool tiled : {false, true}) {
        refuses(exr("missing.exr", {.channels = rgb(), .tiled = tiled, .lines = 1, .compression = Imf::NO_COMPRESSION}),
                "is truncated");
        exr("to_cut.exr", {.channels = rgb(), .tiled = tiled});
        std::ifstream in{"to_cut.exr", std::ios::binary};
        const bytes whole{std::istreambuf_iterator<char>{in}, {}};
        for (std::size_t n = 0; n < whole.size(); n += n < 400 ? 1 : 7) {
            write("cut.exr", whole.substr(0, n));
            refuses("cut.exr", n == 0 ? "is empty" : n < 4 ? "is neither" : "");
        }
    }
}

}  // namespace

int main() {
    std::string folder = (fs::temp_directory_path() / "test_environments.XXXXXX").string();
    if (!mkdtemp(folder.data())) return std::perror(folder.c_str()), 1;
    fs::current_path(folder);
    for (const auto test : {radiance_headers, radiance_orientations, radiance_scanlines, exr_windows, exr_types,
                            exr_colours, exr_layers, exr_bad_pixels, exr_cut})
        test();
    fs::current_path("/");
    fs::remove_all(folder);
    std::cout << passed << " passed, " << failed << " failed\n";
    return failed == 0 ? 0 : 1;
}
