// The prefiltered chain: constants, energy, prepared samples, against the sum over all texels, spiky light.
#include "catch.hpp"
#include "support.hpp"

#include <lobe/ibl/harmonics.hpp>
#include <lobe/ibl/shade.hpp>

using lobe::alpha, lobe::cube, lobe::cube_pyramid, lobe::vec2, lobe::vec3;

namespace {

cube<float> noise(int size) {
    random_numbers random(1);
    std::vector<vec3<float>> pixels;
    for (int i = 0; i < 6 * size * size; ++i)
        pixels.push_back(vec3<float>(vec3<double>{random() < 0.02 ? 50 : random(), random(), 1}));
    return {size, pixels};
}

/// LD by the sum over all texels: int D L (r.l) dl / int D (r.l) dl.
vec3<double> brute_force(const cube<float>& map, const vec3<double>& r, double a) {
    vec3<double> total(0);
    double weights = 0;
    map.for_each([&](int face, int column, int row, const vec3<float>& L) {
        const double n = map.size();
        const vec3<double> l = lobe::cube_direction(face, vec2<double>{(column + 0.5) / n, (row + 0.5) / n});
        const double cosine = lobe::dot(l, r);
        if (cosine <= 0) return;
        const vec3<double> m = l + r, across = lobe::cross(m, r);
        const double z = lobe::dot(m, r), s2 = lobe::dot(across, across), m2 = lobe::dot(m, m);
        const double k = a * m2 / (s2 + a * a * z * z);
        const double weight = k * k * cosine * lobe::cube_texel_solid_angle<double>(column, row, map.size());
        total += vec3<double>(L) * weight;
        weights += weight;
    });
    return total / weights;
}

double energy(const cube<float>& map) {
    double total = 0;
    map.for_each([&](int, int column, int row, const vec3<float>& L) {
        total += static_cast<double>(L.x) * lobe::cube_texel_solid_angle<double>(column, row, map.size());
    });
    return total;
}

}  // namespace

TEST_CASE("prefiltered chain: a uniform environment stays 1", "[ibl]") {
    const cube_pyramid<float> white(lobe::make_cube<float>([](const vec3<float>&) { return vec3<float>(1); }, 32));
    const auto chain = lobe::prefilter(white, {.smallest = 4, .count = 256});
    CHECK(chain.size() == 4);
    random_numbers random(2);
    for (int i = 0; i < 2000; ++i) {
        const vec3<float> r(random.direction());
        CHECK(std::abs(chain(r, static_cast<float>(random())).x - 1) < 1e-5f);
    }
    // and the pixel: a white metal, a white base, any roughness
    const auto E = [](const vec3<float>&) { return vec3<float>(1); };
    for (float rough : {0.05f, 0.3f, 0.7f, 1.0f}) {
        const vec3<float> n{0, 1, 0}, v = lobe::normalize(vec3<float>{0.3f, 0.4f, 0.1f});
        const auto metal = lobe::shade(chain, E, n, v, lobe::schlick{vec3<float>(1)}, rough, vec3<float>(0));
        const auto matte = lobe::shade(chain, E, n, v, lobe::schlick{vec3<float>(0.04f)}, rough, vec3<float>(1));
        CHECK(std::abs(metal.x - 1) < 2e-5f);
        CHECK(std::abs(matte.x - 1) < 2e-5f);
    }
}

TEST_CASE("prepared samples are those of prefiltered_radiance", "[ibl]") {
    const cube_pyramid<float> map(noise(32));
    random_numbers random(3);
    for (float a : {0.01f, 0.2f, 1.0f}) {
        const lobe::prefilter_samples<float> samples(map, alpha<float>(a), 256);
        for (int i = 0; i < 20; ++i) {
            const vec3<float> r(random.direction());
            const auto plain = lobe::prefiltered_radiance(map, r, alpha<float>(a), 256u), fast = samples(map, r);
            CHECK(lobe::length(plain - fast) < 2e-5f * lobe::length(plain));
            CHECK(lobe::length(samples.estimate(map, r).value - fast) < 1e-5f * lobe::length(plain));
        }
    }
}

TEST_CASE("prefiltered radiance against the sum over all texels", "[ibl]") {
    // light over a horizon and a glow: of a map whose texels are small for the lobe
    const auto sky = [](const vec3<float>& w) {
        const float glow = std::exp(30 * (w.x * 0.6f + w.y * 0.8f - 1));
        return vec3<float>(w.y > 0 ? 1.0f : 0.2f) + vec3<float>(20 * glow);
    };
    const cube_pyramid<float> map(lobe::make_cube<float>(sky, 64, 2));
    random_numbers random(4);
    for (double rough : {0.3, 0.5, 0.8, 1.0}) {
        const double a = rough * rough;
        const lobe::prefilter_samples<float> samples(map, alpha<float>(static_cast<float>(a)), 1024);
        double squares = 0, norm = 0;
        for (int i = 0; i < 40; ++i) {
            const vec3<double> r = random.direction();
            const vec3<double> exact = brute_force(map.level(0), r, a);
            const double off = lobe::length(vec3<double>(samples(map, vec3<float>(r))) - exact);
            squares += off * off;
            norm += lobe::dot(exact, exact);
        }
        INFO("roughness " << rough << ": " << std::sqrt(squares / norm));
        CHECK(std::sqrt(squares / norm) < 0.015);
    }
}

TEST_CASE("the chain keeps the energy of one texel, wherever it is", "[ibl]") {
    const std::array<int, 3> places[] = {{0, 0, 0}, {2, 31, 32}, {4, 63, 11}, {3, 33, 63}};
    for (const auto& [face, column, row] : places) {
        std::vector<vec3<float>> pixels(6 * 64 * 64, vec3<float>(0));
        pixels[static_cast<std::size_t>((face * 64 + row) * 64 + column)] = vec3<float>(1e5f);
        const cube_pyramid<float> sun(cube<float>(64, pixels));
        const double whole = energy(sun.level(0));
        const auto chain = lobe::prefilter(sun, {.smallest = 16, .count = 1024});
        for (std::size_t level = 1; level < chain.size(); ++level) {
            INFO("face " << face << " level " << level << ": " << energy(chain.level(level)) / whole - 1);
            CHECK(energy(chain.level(level)) == Catch::Approx(whole).epsilon(0.01));
        }
    }
}

TEST_CASE("more samples where light is spiky", "[ibl]") {
    std::vector<vec3<float>> pixels(6 * 64 * 64, vec3<float>(0.1f));
    pixels[static_cast<std::size_t>(64 * 10 + 30)] = vec3<float>(1e5f);
    const cube_pyramid<float> sun(cube<float>(64, pixels));
    const auto few = lobe::prefilter(sun, {.smallest = 16, .count = 64});
    const auto adaptive = lobe::prefilter(sun, {.smallest = 16, .count = 64, .tolerance = 0.2});
    const auto many = lobe::prefilter(sun, {.smallest = 16, .count = 1024});
    double off_few = 0, off_adaptive = 0;
    int same = 0;
    many.level(1).for_each([&](int face, int column, int row, const vec3<float>& L) {
        const auto off = [&](const auto& chain) {
            return static_cast<double>(std::abs(chain.level(1).at(face, column, row).x - L.x) / L.x);
        };
        off_few = larger(off_few, off(few));
        off_adaptive = larger(off_adaptive, off(adaptive));
        same += adaptive.level(1).at(face, column, row) == few.level(1).at(face, column, row);
    });
    CHECK(off_few > 0.3);
    CHECK(off_adaptive < 0.5 * off_few);
    INFO(off_few << ' ' << off_adaptive << ' ' << same);
    CHECK(same > 100);  // where it is dark, the few do
}

TEST_CASE("roughness and levels", "[ibl]") {
    CHECK(lobe::roughness_of_level(0.0f, 6) == 0);
    CHECK(lobe::roughness_of_level(5.0f, 6) == 1);
    CHECK(lobe::level_of_roughness(lobe::roughness_of_level(2.0f, 6), 6) == 2);
}
