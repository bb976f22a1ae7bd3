// Spheres under image-based light: the split sum, the split sum with multiple scattering, and the truth, side by side.
// Balls of glass: single scattering, compensated, and the truth.

#include "../common/environment.hpp"
#include "../common/font.hpp"
#include "../common/output.hpp"
#include "../common/picture.hpp"
#include "bake.hpp"
#include "glass.hpp"
#include "render.hpp"
#include "report.hpp"

#include <exception>
#include <iomanip>
#include <iostream>
#include <sstream>

#include <CLI/CLI.hpp>

namespace {

struct options {
    std::filesystem::path environment, out = "out";
    settings render{.tile = 96, .samples = 2048, .seed = 1};
};

options parsed(int argc, char** argv) {
    options o;
    CLI::App app{"Renders spheres under a lat-long environment and in a white furnace: split sum, multiple scattering, "
                 "reference. Balls of glass."};
    app.add_option("environment", o.environment,
                   "Radiance HDR or OpenEXR, width = 2 x height; without it: a studio made here");
    app.add_option("--out", o.out, "folder for the pictures")->capture_default_str();
    app.add_option("--tile", o.render.tile, "pixels across each sphere's tile")
        ->check(CLI::Range(32, 512))
        ->capture_default_str();
    app.add_option("--samples", o.render.samples, "random walks a pixel of the reference")
        ->check(CLI::Range(1, 1 << 24))
        ->capture_default_str();
    app.add_option("--seed", o.render.seed, "of the random walks")->capture_default_str();
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == 0) std::exit(app.exit(error));  // --help
        throw;
    }
    o.render.samples = whole_batches(o.render.samples);
    return o;
}

const std::vector<float> roughnesses = [] {
    std::vector<float> r;
    for (int i = 0; i < 8; ++i) r.push_back(0.05f + 0.95f * static_cast<float>(i) / 7);
    return r;
}();

const material gold{"gold", {1.00f, 0.71f, 0.29f}, {0, 0, 0}};
const material white_dielectric{"white dielectric", vec3{0.04f}, vec3{1}};
const material white_metal{"white metal", vec3{1}, {0, 0, 0}};
const glass clear{"clear glass", 1.5f, vec3{1}};
const glass bottle{"bottle glass", 1.5f, {0.45f, 0.85f, 0.6f}};

const std::vector<named> split_sums{{"single scattering", "split sum; diffuse 1 − F(n·v)"},
                                    {"multiple scattering", "split sum; Fdez-Agüera 2019"},
                                    {"multiple scattering", "split sum; smith_multiscatter"}};
const std::vector<named> interfaces{{"single scattering", "rough_dielectric"},
                                    {"multiple scattering", "compensated_dielectric"}};
const named random_walks{"random walk", "the reference"};

std::string short_text(float x) {
    std::ostringstream out;
    out << std::setprecision(2) << x;
    return out.str();
}

std::string heading(const material& m) {
    const auto& f0 = m.f0;
    std::string text = m.name + ", F0 = ";
    text += f0.x == f0.z ? short_text(f0.x)
                         : "(" + short_text(f0.x) + ", " + short_text(f0.y) + ", " + short_text(f0.z) + ")";
    return m.albedo == vec3{0} ? text : text + ", diffuse albedo " + short_text(m.albedo.x);
}

std::string heading(const glass& g) {
    std::string text = g.name + ", eta = " + short_text(g.eta);
    if (g.left == vec3{1}) return text + ", absorbs nothing";
    return text + ", through its middle (" + short_text(g.left.x) + ", " + short_text(g.left.y) + ", " +
           short_text(g.left.z) + ") is left";
}

}  // namespace

int main(int argc, char** argv) try {
    const options o = parsed(argc, argv);
    const bool studio = o.environment.empty();
    auto environment = studio ? studio_light() : load_environment(o.environment);
    const std::string name = studio ? "the studio light of this program" : o.environment.filename().string();
    const font face{LOBE_EXAMPLE_FONT};
    output_folder out{o.out,
                      {"spheres.png", "spheres.exr", "furnace.png", "furnace.exr", "glass.png", "glass.exr",
                       "glass_furnace.png", "glass_furnace.exr"}};

    std::cout << "\n" << name << ", " << environment.width << " x " << environment.height << "\n";
    const baked_light light = bake(std::move(environment), roughnesses);
    report spheres{"Spheres under " + name, split_sums, random_walks, light, o.render.samples};
    for (const material& m : {gold, white_dielectric}) spheres.add(heading(m), render(m, light, vec3{0}, o.render));
    settings few = o.render;  // a path through glass has several interfaces
    few.samples = whole_batches(few.samples / 8);
    report balls{"Balls of glass under " + name, interfaces, random_walks, light, few.samples};
    balls.add(heading(bottle), render(bottle, light, vec3{0}, few));

    std::cout << "\nwhite furnace\n";
    // there is little noise under uniform light
    const baked_light white = bake(uniform_light(), roughnesses);
    report furnace{"Spheres in the white furnace, radiance 1 from everywhere", split_sums, random_walks, white,
                   few.samples};
    for (const material& m : {white_metal, white_dielectric, gold})
        furnace.add(heading(m), render(m, white, vec3{1}, few));
    report clear_balls{"Glass in the white furnace, radiance 1 from everywhere", interfaces, random_walks, white,
                       few.samples};
    clear_balls.add(heading(clear), render(clear, white, vec3{1}, few));

    for (const report* r : {&spheres, &balls, &furnace, &clear_balls}) r->print_errors(std::cout);

    write_png(out.temporary("spheres.png"), spheres.tone_mapped_page(face));
    write_exr(out.temporary("spheres.exr"), spheres.linear(),
              "radiance; rows: gold a b c d |b-d| |c-d|, white dielectric the same");
    write_png(out.temporary("furnace.png"), furnace.furnace_page(face));
    write_exr(out.temporary("furnace.exr"), furnace.linear(),
              "radiance; rows: white metal a b c d |b-d| |c-d|, white dielectric, gold the same");
    write_png(out.temporary("glass.png"), balls.tone_mapped_page(face));
    write_exr(out.temporary("glass.exr"), balls.linear(), "radiance; rows: bottle glass a b c |a-c| |b-c|");
    write_png(out.temporary("glass_furnace.png"), clear_balls.furnace_page(face));
    write_exr(out.temporary("glass_furnace.exr"), clear_balls.linear(),
              "radiance; rows: clear glass a b c |a-c| |b-c|");
    out.commit();
} catch (const std::exception& error) {
    std::cerr << "render_spheres: " << error.what() << '\n';
    return 1;
}
