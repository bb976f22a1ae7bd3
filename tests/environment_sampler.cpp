// Sampling environments: the density integrates to 1, is that of the samples, and covers what look-ups see.
#include "catch.hpp"
#include "support.hpp"

#include <lobe/brdf/lambert.hpp>
#include <lobe/ibl/environment_sampler.hpp>
#include <lobe/ibl/reflected_radiance.hpp>

using lobe::cube, lobe::latlong, lobe::vec2, lobe::vec3;

namespace {

latlong<double> one_texel(int width, int height, int column, int row, double rest = 0) {
    std::vector<vec3<double>> pixels(static_cast<std::size_t>(width * height), vec3<double>(rest));
    pixels[static_cast<std::size_t>(row * width + column)] = vec3<double>(1000, 500, 0);
    return {width, height, pixels};
}
cube<double> one_texel_of_cube(int size, int face, int column, int row, double rest = 0) {
    std::vector<vec3<double>> pixels(static_cast<std::size_t>(6 * size * size), vec3<double>(rest));
    pixels[static_cast<std::size_t>((face * size + row) * size + column)] = vec3<double>(1000, 500, 0);
    return {size, pixels};
}

/// Each map to g: light at a pole, at the seam, in a corner, everywhere.
template <class G>
void for_each_map(const G& g) {
    g("pole", one_texel(32, 16, 5, 0));
    g("other pole, over a dim rest", one_texel(32, 16, 31, 15, 1));
    g("seam", one_texel(32, 16, 0, 7));
    g("odd sizes", one_texel(7, 5, 6, 2, 0.1));
    std::vector<vec3<double>> pixels;
    random_numbers random(1);
    for (int i = 0; i < 32 * 16; ++i) pixels.push_back(vec3<double>(random() * random(), random(), 0));
    g("everywhere", latlong<double>(32, 16, pixels));
    g("cube, corner", one_texel_of_cube(8, 2, 0, 7));
    g("cube, edge, over a dim rest", one_texel_of_cube(8, 5, 7, 3, 1));
    pixels.resize(6 * 64);
    g("cube, everywhere", cube<double>(8, pixels));
}

}  // namespace

TEST_CASE("the density of an environment sampler integrates to 1", "[ibl]") {
    for_each_map([](const char* name, const auto& map) {
        const lobe::environment_sampler lights(map);
        // texels are constant in solid angle, or smooth: the midpoint rule in cells that do not cross them. Of a cube,
        // whose density varies as |p|^3 in a texel, 64 cells a texel and axis leave 1e-6
        double total = 0;
        if constexpr (std::is_same_v<std::decay_t<decltype(map)>, latlong<double>>) {
            const int n = 3;
            for (int row = 0; row < n * map.height; ++row)
                for (int column = 0; column < n * map.width; ++column)
                    total += lights.pdf(lobe::latlong_direction(
                                 vec2<double>{(column + 0.5) / (n * map.width), (row + 0.5) / (n * map.height)})) *
                             lobe::latlong_texel_solid_angle<double>(row, n * map.width, n * map.height);
        } else {
            const int n = 64 * map.size();
            for (int face = 0; face < 6; ++face)
                for (int row = 0; row < n; ++row)
                    for (int column = 0; column < n; ++column)
                        total +=
                            lights.pdf(lobe::cube_direction(face, vec2<double>{(column + 0.5) / n, (row + 0.5) / n})) *
                            lobe::cube_texel_solid_angle<double>(column, row, n);
        }
        INFO(name);
        CHECK(std::abs(total - 1) < 1e-6);
    });
}

TEST_CASE("samples of an environment follow its density", "[ibl]") {
    for_each_map([](const char* name, const auto& map) {
        const lobe::environment_sampler lights(map);
        random_numbers random(2);
        const int samples = 200000, columns = 24, rows = 12;
        std::vector<double> drawn(columns * rows), expected(columns * rows);
        const auto bin = [&](const vec3<double>& w) {
            const auto uv = lobe::latlong_uv(w);
            return static_cast<std::size_t>(std::min(static_cast<int>(uv.y * rows), rows - 1) * columns +
                                            std::min(static_cast<int>(uv.x * columns), columns - 1));
        };
        for (int i = 0; i < samples; ++i) {
            const auto s = lights.sample({random(), random()});
            REQUIRE(lobe::length(s.direction) == Catch::Approx(1).epsilon(1e-14));
            // a sample on an edge may round into the neighbour
            if (std::abs(lights.pdf(s.direction) / s.pdf - 1) > 1e-9) continue;
            drawn[bin(s.direction)] += 1;
        }
        double all = 0;
        for (double count : drawn) all += count;
        CHECK(all > 0.9999 * samples);
        // the expected counts by the midpoint rule, 40 cells a bin and axis
        const int n = 40;
        for (int row = 0; row < rows * n; ++row)
            for (int column = 0; column < columns * n; ++column) {
                const auto w =
                    lobe::latlong_direction(vec2<double>{(column + 0.5) / (columns * n), (row + 0.5) / (rows * n)});
                expected[bin(w)] +=
                    samples * lights.pdf(w) * lobe::latlong_texel_solid_angle<double>(row, columns * n, rows * n);
            }
        double statistic = 0;
        int freedom = -1;
        for (std::size_t i = 0; i < drawn.size(); ++i) {
            if (expected[i] < 20) continue;
            // the midpoint rule knows an edge of the density to half a cell, 1/(2 n) of the bin
            const double error = std::sqrt(expected[i]) + expected[i] * 0.01;
            statistic += std::pow((drawn[i] - expected[i]) / error, 2);
            ++freedom;
        }
        INFO(name << ": " << statistic << " for " << freedom);
        CHECK(statistic < freedom + 5 * std::sqrt(2.0 * (freedom + 1)) + 5);
    });
}

TEST_CASE("an environment sampler covers what a look-up sees", "[ibl]") {
    for_each_map([](const char* name, const auto& map) {
        const lobe::environment_sampler lights(map);
        random_numbers random(3);
        INFO(name);
        int uncovered = 0;
        for (int i = 0; i < 50000; ++i) {
            const vec3<double> w = random.direction();
            if (map(w).x > 0 && !(lights.pdf(w) > 0)) ++uncovered;
        }
        CHECK(uncovered == 0);
    });
}

TEST_CASE("light sampling of an environment is unbiased", "[ibl]") {
    for_each_map([](const char* name, const auto& map) {
        const lobe::environment_sampler lights(map);
        const lobe::frame<double> at(lobe::normalize(vec3<double>{0.3, 0.9, 0.2}));
        const lobe::in_tangent_space environment{at, map};
        const lobe::in_tangent_space sampler{at, lights};
        const lobe::lambert white{vec3<double>(1)};
        const vec3<double> v{0, 0, 1};
        const auto by_lights = lobe::reflected_radiance(
            white, v, environment, lobe::shifted_hammersley<double>{1024, 32, 1}, lobe::by_lights{sampler});
        const auto by_brdf =
            lobe::reflected_radiance(white, v, environment, lobe::shifted_hammersley<double>{4096, 32, 2});
        const auto by_both = lobe::reflected_radiance(
            white, v, environment, lobe::shifted_hammersley<double>{1024, 32, 3}, lobe::by_both{sampler});
        INFO(name << ": " << by_lights.value.x << " " << by_brdf.value.x << " " << by_both.value.x);
        CHECK(std::abs(by_lights.value.x - by_brdf.value.x) <
              4 * std::hypot(by_lights.standard_error.x, by_brdf.standard_error.x) + 1e-12);
        CHECK(std::abs(by_both.value.x - by_brdf.value.x) <
              4 * std::hypot(by_both.standard_error.x, by_brdf.standard_error.x) + 1e-12);
    });
}

TEST_CASE("environment sampler: u at the ends, in float", "[ibl]") {
    std::vector<vec3<float>> pixels(64 * 32, vec3<float>(0));
    pixels[40] = vec3<float>(1);
    const latlong<float> map(64, 32, pixels);
    const lobe::environment_sampler lights(map);
    for (float x : {0.0f, 0x1.fffffep-1f, 0.5f})
        for (float y : {0.0f, 0x1.fffffep-1f, 0.5f}) {
            const auto s = lights.sample({x, y});
            CHECK(s.pdf > 0);
            CHECK(std::abs(lobe::length(s.direction) - 1) < 1e-6f);
        }
}
