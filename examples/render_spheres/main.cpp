// Spheres under image-based light: the split sum, the split sum with multiple scattering, and the truth, side by side.

#include "bake.hpp"
#include "environment.hpp"
#include "font.hpp"
#include "output.hpp"
#include "picture.hpp"
#include "render.hpp"
#include "report.hpp"

#include <exception>
#include <iostream>

#include <CLI/CLI.hpp>

namespace {

struct options {
    std::filesystem::path environment, out = "out";
    settings render{.tile = 96, .samples = 2048, .seed = 1};
};

options parsed(int argc, char** argv) {
    options o;
    CLI::App app{"Renders spheres under a lat-long environment and in a white furnace: split sum, multiple scattering, "
                 "reference."};
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

}  // namespace

int main(int argc, char** argv) try {
    const options o = parsed(argc, argv);
    const bool studio = o.environment.empty();
    auto environment = studio ? studio_light() : load_environment(o.environment);
    const std::string name = studio ? "the studio light of this program" : o.environment.filename().string();
    const font face{LOBE_EXAMPLE_FONT};
    output_folder out{o.out, {"spheres.png", "spheres.exr", "furnace.png", "furnace.exr"}};

    std::cout << "\n" << name << ", " << environment.width << " x " << environment.height << "\n";
    const baked_light light = bake(std::move(environment), roughnesses);
    report spheres{"Spheres under " + name, light, o.render};
    for (const material& m : {gold, white_dielectric}) spheres.add(m, render(m, light, vec3{0}, o.render));

    std::cout << "\nwhite furnace\n";
    settings few = o.render;
    few.samples = whole_batches(few.samples / 8);  // there is little noise under uniform light
    const baked_light white = bake(uniform_light(), roughnesses);
    report furnace{"Spheres in the white furnace, radiance 1 from everywhere", white, few};
    for (const material& m : {white_metal, white_dielectric, gold}) furnace.add(m, render(m, white, vec3{1}, few));

    spheres.print_errors(std::cout);
    furnace.print_errors(std::cout);

    write_png(out.temporary("spheres.png"), spheres.tone_mapped_page(face));
    write_exr(out.temporary("spheres.exr"), spheres.linear(),
              "radiance; rows: gold a b c d |b-d| |c-d|, white dielectric the same");
    write_png(out.temporary("furnace.png"), furnace.furnace_page(face));
    write_exr(out.temporary("furnace.exr"), furnace.linear(),
              "radiance; rows: white metal a b c d |b-d| |c-d|, white dielectric, gold the same");
    out.commit();
} catch (const std::exception& error) {
    std::cerr << "render_spheres: " << error.what() << '\n';
    return 1;
}
