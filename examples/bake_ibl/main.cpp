// Bakes an environment for image-based light: a prefiltered cube, its irradiance, harmonics, the split-sum texture.
#include "ktx2.hpp"

#include "../common/environment.hpp"
#include "../common/font.hpp"
#include "../common/image.hpp"
#include "../common/maps.hpp"
#include "../common/output.hpp"
#include "../common/picture.hpp"
#include "../common/rows.hpp"

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <numeric>
#include <sstream>

#include <CLI/CLI.hpp>
#include <glm/gtc/packing.hpp>
#include <lobe/energy/dfg_export.hpp>
#include <lobe/lobe.hpp>
#include <tbb/global_control.h>
#include <tbb/info.h>

namespace {

volatile std::sig_atomic_t interrupted = 0;

void stop_if_interrupted() {
    if (interrupted) throw std::runtime_error("interrupted: nothing was written");
}

/// Rows shared out among the cores, until an interruption.
auto stoppable_rows(const std::string& name) { return rows_of(name, stop_if_interrupted); }

/// Towards the middle of a texel.
vec3 texel_direction(int size, int face, int column, int row) {
    const auto along = [&](int i) { return (static_cast<float>(i) + 0.5f) / static_cast<float>(size); };
    return lobe::cube_direction(face, glm::vec2{along(column), along(row)});
}

struct options {
    std::filesystem::path environment, out = "baked";
    int size = 256, smallest = 8, irradiance_size = 32, harmonics_degree = 2, dfg_size = 128, threads = 0;
    std::uint32_t samples = 1024;
    double tolerance = 0, rotate = 0;
    float exposure_clamp = 0;
    bool reference = false;
};

options parsed(int argc, char** argv) {
    options o;
    CLI::App app{
        "Bakes a lat-long environment for image-based light: prefiltered.ktx2 (a cube, roughness from 0 at its "
        "first level to 1 at its last), irradiance.ktx2 (irradiance/pi), harmonics.json, dfg.ktx2, dfg.raw, "
        "dfg.h, faces_LEVEL.exr, sheet.png."};
    const auto power_of_two = CLI::Validator(
        [](std::string& text) {
            const long n = std::strtol(text.c_str(), nullptr, 10);  // Range refuses what is no number
            return (n & (n - 1)) ? std::string("must be a power of two") : std::string();
        },
        "POWER OF TWO");
    const auto finite = CLI::Validator(
        [](std::string& text) {
            // a NaN is within every Range
            return std::isfinite(std::strtod(text.c_str(), nullptr)) ? std::string() : std::string("must be finite");
        },
        "FINITE");
    app.add_option("environment", o.environment,
                   "Radiance HDR or OpenEXR, width = 2 x height; without it: a studio made here");
    app.add_option("--out", o.out, "folder for the files")->capture_default_str();
    app.add_option("--size", o.size, "texels along an edge of the cube")
        ->check(CLI::Range(16, 2048) & power_of_two)
        ->capture_default_str();
    app.add_option("--smallest", o.smallest, "... of its last level")
        ->check(CLI::Range(4, 64) & power_of_two)
        ->capture_default_str();
    app.add_option("--samples", o.samples, "samples a texel")->check(CLI::Range(1, 1 << 20))->capture_default_str();
    app.add_option("--tolerance", o.tolerance,
                   "16 times the samples where they differ by more than this part; 0: never")
        ->check(CLI::Range(0.0, 10.0) & finite)
        ->capture_default_str();
    app.add_option("--sh-order", o.harmonics_degree, "highest degree of the harmonics")
        ->check(CLI::Range(0, 20))
        ->capture_default_str();
    app.add_option("--rotate", o.rotate, "degrees about the vertical axis, from +z to +x")
        ->check(CLI::Range(-360.0, 360.0) & finite)
        ->capture_default_str();
    app.add_option("--exposure-clamp", o.exposure_clamp,
                   "dims radiance whose mean of rgb is above this; loses energy; 0: none")
        ->check(CLI::Range(0.0f, 1e20f) & finite)
        ->capture_default_str();
    app.add_option("--threads", o.threads, "0: one a core")->check(CLI::Range(0, 1024))->capture_default_str();
    app.add_flag("--reference", o.reference, "compares the chain with sums over all texels and prints the errors");
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == 0) std::exit(app.exit(error));  // --help
        throw;
    }
    if (o.smallest >= o.size) throw std::runtime_error("--smallest must be below --size");
    return o;
}

constexpr float largest_half = 65504;

std::uint16_t half(float x) { return glm::packHalf1x16(std::min(x, largest_half)); }

texture as_texture(const std::vector<lobe::cube<float>>& levels) {
    texture t{4, levels.front().size(), levels.front().size(), true, {}};
    for (const auto& level : levels) {
        t.levels.emplace_back();
        level.for_each([&](int, int, int, const vec3& c) {
            t.levels.back().insert(t.levels.back().end(), {half(c.x), half(c.y), half(c.z), half(1)});
        });
    }
    return t;
}

/// The six faces side by side.
image strip(const lobe::cube<float>& level) {
    image out{6 * level.size(), level.size()};
    level.for_each([&](int face, int x, int y, const vec3& c) { out(face * level.size() + x, y) = c; });
    return out;
}

template <class... Text>
void write_text(const std::filesystem::path& path, const Text&... text) {
    std::ofstream out(path, std::ios::binary);
    (out << ... << text);
    out.close();
    if (!out) throw std::runtime_error(path.string() + ": cannot be written");
}

std::string json_of(const lobe::harmonics<float>& radiance) {
    const auto irradiance = radiance.irradiance();
    std::ostringstream out;
    out << std::setprecision(9);
    const auto list = [&](const char* name, const lobe::harmonics<float>& h) {
        out << "  \"" << name << "\": [";
        for (std::size_t i = 0; i < h.coefficients.size(); ++i) {
            const vec3& c = h.coefficients[i];
            out << (i ? ",\n    [" : "\n    [") << c.x << ", " << c.y << ", " << c.z << "]";
        }
        out << "]";
    };
    out << "{\n  \"basis\": \"real, orthonormal, without the Condon-Shortley phase; order l, then m = -l..l; y is "
           "up\",\n"
        << "  \"degree\": " << radiance.degree() << ",\n";
    list("radiance", radiance);
    out << ",\n";
    list("irradiance_over_pi", irradiance);
    out << "\n}\n";
    return out.str();
}

std::string header_of(const std::vector<glm::vec2>& texels, int size) {
    std::ostringstream out;
    out << "// Split-sum terms (scale, bias) of GGX with height-correlated Smith: F0 x + F90 y. " << size << " x "
        << size << ",\n// columns: n.v from 0, rows: roughness from 0, both at the centres of texels.\n"
        << "static const float dfg[" << size * size << "][2] = {\n"
        << std::setprecision(7) << std::fixed;
    for (const glm::vec2& t : texels) out << "    {" << t.x << "f, " << t.y << "f},\n";
    out << "};\n";
    return out.str();
}

/// What halves cannot hold is said, not dimmed in silence.
void note_what_halves_lose(const std::string& file, const std::vector<lobe::cube<float>>& levels) {
    int above = 0;
    for (const auto& level : levels)
        level.for_each([&](int, int, int, const vec3& c) {
            for (const float x : {c.x, c.y, c.z}) above += x > largest_half;
        });
    if (above) std::cout << file << ": " << above << " values above 65504 taken as 65504; --exposure-clamp dims them\n";
}

/// Relative rms error of each filtered level against the sum over all texels, in some of its texels.
void compare(const lobe::cube<float>& environment, const std::vector<lobe::cube<float>>& levels) {
    struct light {
        vec3 direction, radiance;
        double solid_angle;
    };
    std::vector<light> lights;
    environment.for_each([&](int face, int column, int row, const vec3& radiance) {
        lights.push_back({texel_direction(environment.size(), face, column, row), radiance,
                          lobe::cube_texel_solid_angle<double>(column, row, environment.size())});
    });

    constexpr int places = 96;
    std::cout << "errors against the sum over all texels, rms over " << places
              << " texels of a level, of its rms radiance\n";
    for (std::size_t i = 1; i < levels.size(); ++i) {
        const float roughness = lobe::roughness_of_level(static_cast<float>(i), static_cast<int>(levels.size()));
        const lobe::ggx normals{lobe::alpha<float>::from_roughness(roughness)};
        const int size = levels[i].size();
        std::vector<double> squares(places), norms(places);
        stoppable_rows("sums, level " + std::to_string(i))(places, [&](int k) {
            const int face = k % 6, x = (k * 7) % size, y = (k * 11) % size;
            const lobe::frame<float> at(texel_direction(size, face, x, y));
            glm::dvec3 total(0);
            double weights = 0;
            for (const light& from : lights) {
                const vec3 l = at.to_local(from.direction);
                if (l.z <= 0) continue;
                const double weight = static_cast<double>(normals.D(l + vec3{0, 0, 1}) * l.z) * from.solid_angle;
                total += glm::dvec3(from.radiance) * weight;
                weights += weight;
            }
            const glm::dvec3 exact = total / weights, off = glm::dvec3(levels[i].at(face, x, y)) - exact;
            squares[static_cast<std::size_t>(k)] = lobe::dot(off, off);
            norms[static_cast<std::size_t>(k)] = lobe::dot(exact, exact);
        });
        const auto sum = [](const std::vector<double>& terms) {
            return std::accumulate(terms.begin(), terms.end(), 0.0);
        };
        std::cout << "  roughness " << std::fixed << std::setprecision(2) << roughness << ": "
                  << 100 * std::sqrt(sum(squares) / sum(norms)) << " %\n";
    }
}

image contact_sheet(const std::vector<lobe::cube<float>>& levels, const lobe::cube<float>& irradiance,
                    const std::vector<glm::vec2>& dfg, int dfg_size, const std::string& name, float exposure) {
    const font face{LOBE_EXAMPLE_FONT};
    const int tile = 96, margin = 16, line = 28, left = 170, rows = static_cast<int>(levels.size()) + 1;
    image page{left + 6 * tile + margin, 76 + rows * (tile + 8) + line + 2 * tile + margin};
    const auto text = [&](int x, int y, float size, const std::string& words) {
        face.write(page, static_cast<float>(x), static_cast<float>(y), size, vec3(0.9f), words);
    };
    std::ostringstream how;
    how << std::setprecision(3) << "radiance x " << exposure << ", ACES filmic curve, sRGB";
    text(margin, 28, 20, name);
    text(margin, 48, 13, how.str());
    const char* names[] = {"+x", "-x", "+y", "-y", "+z", "-z"};
    for (int f = 0; f < 6; ++f) text(left + f * tile + tile / 2 - 8, 70, 13, names[f]);
    const auto row = [&](int number, const std::string& label, const std::string& detail, const auto& level) {
        const int top = 76 + number * (tile + 8);
        text(margin, top + tile / 2, 15, label);
        text(margin, top + tile / 2 + 18, 13, detail);
        for (int y = 0; y < tile; ++y)
            for (int x = 0; x < 6 * tile; ++x) {
                const int n = level.size();
                page(left + x, top + y) =
                    tone_mapped(level.at(x / tile, (x % tile) * n / tile, y * n / tile), exposure);
            }
    };
    for (std::size_t i = 0; i < levels.size(); ++i) {
        std::ostringstream label;
        label << "roughness " << std::fixed << std::setprecision(2)
              << lobe::roughness_of_level(static_cast<float>(i), static_cast<int>(levels.size()));
        const std::string size = std::to_string(levels[i].size());
        row(static_cast<int>(i), label.str(), size + " x " + size, levels[i]);
    }
    const std::string size = std::to_string(irradiance.size());
    row(rows - 1, "irradiance/pi", size + " x " + size, irradiance);
    const int top = 76 + rows * (tile + 8) + line;
    text(margin, top + tile, 15, "split-sum terms");
    text(margin, top + tile + 18, 13, "red scale, green bias");
    text(left + 2 * tile + 12, top + 14, 13, "roughness 1 at the top, 0 below;");
    text(left + 2 * tile + 12, top + 32, 13, "n.v from 0 on the left to 1");
    for (int y = 0; y < 2 * tile; ++y)
        for (int x = 0; x < 2 * tile; ++x) {
            const int column = x * dfg_size / (2 * tile), below = (2 * tile - 1 - y) * dfg_size / (2 * tile);
            const glm::vec2 t = dfg[static_cast<std::size_t>(below * dfg_size + column)];
            page(left + x, top + y) = as_it_is(vec3{t.x, t.y, 0}, 1);
        }
    return page;
}

}  // namespace

int main(int argc, char** argv) try {
    const options o = parsed(argc, argv);
    std::signal(SIGINT, [](int) { interrupted = 1; });
    std::signal(SIGTERM, [](int) { interrupted = 1; });
    const tbb::global_control threads(
        tbb::global_control::max_allowed_parallelism,
        static_cast<std::size_t>(o.threads ? o.threads : tbb::info::default_concurrency()));
    auto map = o.environment.empty() ? studio_light() : load_environment(o.environment);
    const std::string name =
        o.environment.empty() ? "the studio light of the examples" : o.environment.filename().string();

    int levels = 1;
    while ((o.size >> levels) >= o.smallest) ++levels;
    std::vector<std::string> names{"prefiltered.ktx2", "irradiance.ktx2", "harmonics.json", "dfg.ktx2",
                                   "dfg.raw",          "dfg.h",           "sheet.png"};
    for (int i = 0; i < levels; ++i) names.push_back("faces_" + std::to_string(i) + ".exr");
    output_folder out{o.out, names};
    std::cout << name << ", " << map.width << " x " << map.height << "\n";

    if (o.exposure_clamp > 0) {
        for (vec3& c : map.pixels) c = lobe::dimmed(c, o.exposure_clamp);
        map = {map.width, map.height, std::move(map.pixels)};
    }
    const lobe::latlong_pyramid<float> halved{std::move(map)};

    // two look-ups for each texel of the map, of a halved one where these would be more than 16 along a texel's edge
    std::size_t from = 0;
    while (halved.level(from).width > 32 * o.size) ++from;
    const int per_axis = std::max(halved.level(from).width / (2 * o.size), 2);
    const auto turn = lobe::rotation<float>::about_up(static_cast<float>(o.rotate / 360));
    const lobe::rotated turned{halved.level(from), turn};
    const lobe::cube_pyramid<float> environment{
        lobe::make_cube<float>(turned, o.size, per_axis, stoppable_rows("cube, " + std::to_string(o.size)))};

    int level = 0;
    const auto chain =
        lobe::prefilter(environment, {.smallest = o.smallest, .count = o.samples, .tolerance = o.tolerance},
                        [&](int rows, const auto& g) {
                            ++level;
                            stoppable_rows("roughness, level " + std::to_string(level))(rows, g);
                        });
    std::vector<lobe::cube<float>> cubes;
    for (std::size_t i = 0; i < chain.size(); ++i) cubes.push_back(chain.level(i));

    const lobe::harmonics<float> radiance(environment.level(0), o.harmonics_degree);
    const auto& coarse = halved.level(halvings(halved, diffuse_texel));
    const auto irradiance =
        lobe::make_cube<float>([&](const vec3& n) { return lobe::irradiance(coarse, turn.back(n)); }, o.irradiance_size,
                               1, stoppable_rows("irradiance"));

    lobe::dfg_layout layout;
    layout.width = layout.height = o.dfg_size;
    std::vector<glm::vec2> dfg;
    {
        const step progress("split-sum texture", 1);
        dfg = lobe::dfg_texels(lobe::smith_correlated{}, layout);
    }
    stop_if_interrupted();
    if (o.reference) compare(environment.level(0), cubes);
    note_what_halves_lose("prefiltered.ktx2", cubes);
    note_what_halves_lose("irradiance.ktx2", {irradiance});

    const std::string writer = "lobe bake_ibl " + std::string(lobe::version);
    write_ktx2(out.temporary("prefiltered.ktx2"), as_texture(cubes), writer);
    write_ktx2(out.temporary("irradiance.ktx2"), as_texture({irradiance}), writer);
    write_text(out.temporary("harmonics.json"), json_of(radiance));
    write_ktx2(out.temporary("dfg.ktx2"), {2, o.dfg_size, o.dfg_size, false, {lobe::rg16f(dfg)}}, writer);
    write_text(out.temporary("dfg.raw"),
               std::string(reinterpret_cast<const char*>(dfg.data()), dfg.size() * sizeof(dfg[0])));
    write_text(out.temporary("dfg.h"), header_of(dfg, o.dfg_size));
    for (std::size_t i = 0; i < cubes.size(); ++i)
        write_exr(out.temporary("faces_" + std::to_string(i) + ".exr"), strip(cubes[i]),
                  "radiance; faces +x -x +y -y +z -z from the left");
    const float exposure = 0.5f / mean_over_directions(halved.level(0));
    write_png(out.temporary("sheet.png"), contact_sheet(cubes, irradiance, dfg, o.dfg_size, name, exposure));
    stop_if_interrupted();
    out.commit();
} catch (const std::exception& error) {
    std::cerr << "bake_ibl: " << error.what() << '\n';
    return 1;
}
