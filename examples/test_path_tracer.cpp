// The path tracer in a furnace, where surfaces that keep all light cannot be seen, and a scene by three ways to find
// its light, which differ by noise alone. Means of independent pictures; their spread is the noise.
#include "common/environment.hpp"
#include "path_tracer/render.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>

namespace {

int failures = 0;

void check(bool passed, const std::string& what) {
    failures += !passed;
    std::printf("%s %s\n", passed ? "ok   " : "WRONG", what.c_str());
}

struct estimate {
    double mean = 0, error = 0;  // error: the standard error of the mean
};

/// Of each of `parts` x `parts` parts of the picture, over independent pictures.
std::vector<estimate> estimates(const scene& s, settings set, int pictures, int parts) {
    std::vector<estimate> all(static_cast<std::size_t>(parts * parts));
    std::vector<double> squares(all.size());
    for (int i = 0; i < pictures; ++i) {
        set.seed += 1;
        const image picture = render(s, set);
        std::vector<double> means(all.size());
        for (int y = 0; y < set.height; ++y)
            for (int x = 0; x < set.width; ++x)
                means[static_cast<std::size_t>(y * parts / set.height * parts + x * parts / set.width)] +=
                    static_cast<double>(mean_of_channels(picture(x, y))) * parts * parts / (set.width * set.height);
        for (std::size_t k = 0; k < all.size(); ++k) {
            all[k].mean += means[k] / pictures;
            squares[k] += means[k] * means[k] / pictures;
        }
    }
    for (std::size_t k = 0; k < all.size(); ++k)
        all[k].error = std::sqrt(std::max(0.0, squares[k] - all[k].mean * all[k].mean) / (pictures - 1));
    return all;
}

/// `model_error`: what the header promises of the surface's energy, for each time that a path meets it.
void furnace(const std::string& name, scene s, double model_error) {
    for (const auto& [directions, by] : {std::pair{strategy::both, "both"}, {strategy::brdf, "brdf"}}) {
        const auto e = estimates(s, {32, 32, 16, 100, directions}, 8, 1).front();
        char text[160];
        std::snprintf(text, sizeof text, "%-22s by %-4s: %.5f +- %.5f, the model to %.4f", name.c_str(), by, e.mean,
                      e.error, model_error);
        // 6 standard errors of 8 pictures: less often than once in 1000 (Student's t, 7 degrees of freedom)
        check(std::abs(e.mean - 1) <= 6 * e.error + model_error + 2e-5, text);
    }
}

scene ball_in_a_furnace(const material& m) {
    return {{m}, {{{0, 0, 0}, 1, 0}}, {}, uniform_light(), {{-4, 0, 0}, {0, 0, 0}, 0.18f}};
}

/// All kinds of lights and surfaces, lights large enough for BRDF samples to find.
scene room() {
    std::vector<vec3> sky(16 * 8, vec3{0.1f});
    for (std::size_t i = 34; i < 38; ++i) sky[i] = vec3{1.5f};
    scene s{{}, {}, {}, {16, 8, sky}, {{-6.4f, 2.1f, 0}, {0, 0.62f, 0}, 0.31f}};
    add_obj(s, LOBE_EXAMPLE_MODEL, {1.8f, 0, -2.2f}, 1.2f);
    s.add_rectangle({-12, 0, -12}, {0, 0, 24}, {24, 0, 0}, s.add(uniform(metallic_roughness(vec3{0.6f}, 0, 0.4f))));
    material lamp = uniform(diffuse(vec3{0}, 0));
    lamp.emission = {4, 3, 2};
    const auto light = s.add(lamp);
    s.spheres.push_back({{-1.2f, 1.6f, -1.6f}, 0.5f, light});
    s.add_rectangle({-1, 2.2f, 0.5f}, {0, 0.4f, 1.5f}, {1.5f, 0.3f, 0}, light);
    const auto ball = [&](float x, float z, const material& m) { s.spheres.push_back({{x, 0.6f, z}, 0.6f, s.add(m)}); };
    ball(0, -1.4f, uniform(metal(lobe::materials::gold<float>(), 0.5f)));
    ball(0, 0, glass(1.5f, 0.6f, {0.2f, 0.4f, 0.1f}));
    ball(0, 1.4f, uniform(brushed_metal(lobe::materials::copper<float>(), {0.5f, 0.2f})));
    ball(1.6f, -0.7f, uniform(diffuse(vec3{0.8f}, 0.7f)));
    ball(1.6f, 0.7f, uniform(metallic_roughness({0.1f, 0.3f, 0.7f}, 0.5f, 0.4f)));
    return s;
}

void three_ways(int pictures) {
    const scene s = room();
    constexpr int parts = 4;
    const settings set{64, 40, 8, 1000, strategy::both};
    const auto by = [&](strategy d, std::uint64_t seed) {
        settings here = set;
        here.directions = d;
        here.seed = seed;
        return estimates(s, here, pictures, parts);
    };
    const auto both = by(strategy::both, 1000);
    for (const auto& [name, other] :
         {std::pair{"the BRDF", by(strategy::brdf, 2000)}, {"the lights", by(strategy::lights, 3000)}}) {
        double worst = 0, noise = 0, mean = 0, difference = 0, variance = 0;
        for (std::size_t k = 0; k < both.size(); ++k) {
            const double error = std::hypot(both[k].error, other[k].error), off = other[k].mean - both[k].mean;
            worst = std::max(worst, std::abs(off) / error);
            noise = std::max(noise, error / both[k].mean);
            mean += both[k].mean / parts / parts;
            difference += off / parts / parts;
            variance += error * error / std::pow(parts, 4);
        }
        char text[200];
        std::snprintf(text, sizeof text,
                      "by %-10s and by both: %+.2f %% of %.3f, noise %.2f %%; worst of %d parts %.1f standard errors",
                      name, 100 * difference / mean, mean, 100 * std::sqrt(variance) / mean, parts * parts, worst);
        check(worst < 5 && std::abs(difference) < 4 * std::sqrt(variance) && noise < 0.2, text);
    }
}

}  // namespace

/// A number: how many pictures to average, each way.
int main(int argc, char** argv) {
    const vec3 white{1};
    const lobe::conductor<vec3> lossless{vec3{1}, vec3{1e4f}};
    furnace("diffuse", ball_in_a_furnace(uniform(diffuse(white, 0))), 0);
    furnace("rough diffuse", ball_in_a_furnace(uniform(diffuse(white, 1))), 0);
    for (const float roughness : {0.2f, 0.6f, 1.0f})
        furnace("metal " + std::to_string(roughness).substr(0, 3),
                ball_in_a_furnace(uniform(metal(lossless, roughness))), 0.0025);
    for (const float metallic : {0.0f, 0.5f, 1.0f})
        furnace("metallic " + std::to_string(metallic).substr(0, 3),
                ball_in_a_furnace(uniform(metallic_roughness(white, metallic, 0.4f))), 0.0025);
    furnace("smooth glass", ball_in_a_furnace(glass(1.5f, 0, vec3{0})), 0);
    furnace("rough glass", ball_in_a_furnace(glass(1.5f, 0.5f, vec3{0})), 3 * 0.0025);
    scene gem{{}, {}, {}, uniform_light(), {{-4, 0.8f, 0}, {0, 0.9f, 0}, 0.12f}};
    add_obj(gem, LOBE_EXAMPLE_MODEL, vec3{0}, 1.7f);
    for (material& m : gem.materials) m.absorption = vec3{0}, m.at = m.eta > 1 ? m.at : uniform(diffuse(white, 0)).at;
    furnace("a model: stone, glass", std::move(gem), 0);
    three_ways(argc > 1 ? std::atoi(argv[1]) : 24);
    std::printf("%d failed\n", failures);
    return failures != 0;
}
