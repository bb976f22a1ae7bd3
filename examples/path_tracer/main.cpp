// A small path tracer: a model from an OBJ file among balls of lobe's materials; spheres and triangles by Embree.
#include "render.hpp"

#include "../common/environment.hpp"
#include "../common/output.hpp"
#include "../common/picture.hpp"

#include <cmath>
#include <csignal>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <map>

#include <CLI/CLI.hpp>
#include <tbb/global_control.h>
#include <tbb/info.h>

namespace {

volatile std::sig_atomic_t interrupted = 0;

void stop_if_interrupted() {
    if (interrupted) throw std::runtime_error("interrupted: nothing was written");
}

struct options {
    std::filesystem::path model = LOBE_EXAMPLE_MODEL, environment, out = "out";
    settings render{.width = 640, .height = 400, .samples = 64, .seed = 1, .directions = strategy::both};
    int threads = 0;
    float exposure = 0.13f;
};

const std::map<std::string, strategy> strategies{
    {"both", strategy::both}, {"brdf", strategy::brdf}, {"lights", strategy::lights}};

options parsed(int argc, char** argv) {
    options o;
    std::string directions = "both";
    CLI::App app{"Renders path_tracer.png and path_tracer.exr: a model among balls of metal, glass, clay and glaze."};
    const auto finite = CLI::Validator(
        [](std::string& text) {
            // a NaN is within every Range
            return std::isfinite(std::strtod(text.c_str(), nullptr)) ? std::string() : std::string("must be finite");
        },
        "FINITE");
    app.add_option("model", o.model, "OBJ; without it: a gem on a pedestal");
    app.add_option("--environment", o.environment,
                   "Radiance HDR or OpenEXR, width = 2 x height; without it: a studio made here");
    app.add_option("--out", o.out, "folder for the pictures")->capture_default_str();
    app.add_option("--width", o.render.width, "of the picture")->check(CLI::Range(8, 8192))->capture_default_str();
    app.add_option("--height", o.render.height, "of the picture")->check(CLI::Range(8, 8192))->capture_default_str();
    app.add_option("--samples", o.render.samples, "paths a pixel")
        ->check(CLI::Range(1, 1 << 24))
        ->capture_default_str();
    app.add_option("--seed", o.render.seed, "of the paths")->capture_default_str();
    app.add_option("--directions", directions, "to light: sampled by both, the brdf or the lights")
        ->check(CLI::IsMember(strategies))
        ->capture_default_str();
    app.add_option("--exposure", o.exposure, "of the PNG")
        ->check(CLI::Range(0.001f, 1000.0f) & finite)
        ->capture_default_str();
    app.add_option("--threads", o.threads, "0: one a core")->check(CLI::Range(0, 1024))->capture_default_str();
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == 0) std::exit(app.exit(error));  // --help
        throw;
    }
    o.render.directions = strategies.at(directions);
    return o;
}

}  // namespace

int main(int argc, char** argv) try {
    const options o = parsed(argc, argv);
    const tbb::global_control threads{
        tbb::global_control::max_allowed_parallelism,
        static_cast<std::size_t>(o.threads ? o.threads : tbb::info::default_concurrency())};
    const scene s = still_life(o.model, o.environment.empty() ? studio_light() : load_environment(o.environment));
    output_folder out{o.out, {"path_tracer.png", "path_tracer.exr"}};
    std::signal(SIGINT, [](int) { interrupted = 1; });
    std::signal(SIGTERM, [](int) { interrupted = 1; });

    const image radiance = render(s, o.render, stop_if_interrupted);
    image screen = radiance;
    for (vec3& c : screen.pixels) c = tone_mapped(c, o.exposure);
    write_png(out.temporary("path_tracer.png"), screen);
    write_exr(out.temporary("path_tracer.exr"), radiance, "radiance, " + std::to_string(o.render.samples) + " paths");
    out.commit();
} catch (const std::exception& error) {
    std::cerr << "path_tracer: " << error.what() << '\n';
    return 2;
}
