#include "catch.hpp"
#include "support.hpp"

#include <lobe/ibl/irradiance.hpp>
#include <lobe/ibl/prefilter.hpp>

using lobe::latlong;
using lobe::vec2;
using lobe::vec3;

TEST_CASE("lat-long directions go there and back", "[ibl]") {
    random_numbers random(1);
    for (int i = 0; i < 10000; ++i) {
        const vec3<double> w = random.direction();
        CHECK(lobe::length(lobe::latlong_direction(lobe::latlong_uv(w)) - w) < 1e-14);
    }
    CHECK(lobe::latlong_uv(vec3<double>{0, 1, 0}).y == 0);
    CHECK(lobe::latlong_uv(vec3<double>{0, -1, 0}).y == Catch::Approx(1));
    CHECK(lobe::latlong_uv(vec3<double>{1, 0, 0}).x == Catch::Approx(0.5));
    CHECK(lobe::latlong_uv(vec3<double>{0, 0, 1}).x == Catch::Approx(0.75));
    const vec3<double> near_pole{1e-9, 1, 0};
    CHECK(lobe::latlong_uv(near_pole).y == Catch::Approx(1e-9 / 3.141592653589793));
    CHECK(lobe::latlong_uv(vec3<float>{-1, 0, 1e-12f}).x < 1);
}

TEST_CASE("texel solid angles add up to the sphere, and are exact", "[ibl]") {
    for (const auto& [width, height] : {std::pair{8, 4}, std::pair{64, 32}, std::pair{2048, 1024}, std::pair{7, 5}}) {
        double total = 0, total_float = 0;
        for (int row = 0; row < height; ++row) {
            const double omega = lobe::latlong_texel_solid_angle<double>(row, width, height);
            total += width * omega;
            total_float += width * static_cast<double>(lobe::latlong_texel_solid_angle<float>(row, width, height));
            const double top = 3.141592653589793 * row / height, bottom = 3.141592653589793 * (row + 1) / height;
            CHECK(omega == Catch::Approx(2 * 3.141592653589793 / width * (std::cos(top) - std::cos(bottom))).epsilon(1e-9));
        }
        CHECK(total == Catch::Approx(4 * 3.141592653589793).epsilon(1e-13));
        CHECK(total_float == Catch::Approx(4 * 3.141592653589793).epsilon(2e-6));
    }
}

namespace {

latlong<double> cosine_map(int width, int height, const vec3<double>& axis) {
    std::vector<vec3<double>> pixels;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const double c = lobe::dot(lobe::latlong_direction(vec2<double>{(x + 0.5) / width, (y + 0.5) / height}), axis);
            pixels.push_back({1 + c, c * c, 1});
        }
    return {width, height, pixels};
}

}  // namespace

TEST_CASE("a lat-long image interpolates across its seam and at its poles", "[ibl]") {
    const auto map = cosine_map(256, 128, {0, 0, 1});
    random_numbers random(2);
    for (int i = 0; i < 10000; ++i) {
        const vec3<double> w = i % 2 ? random.direction() : lobe::normalize(vec3<double>{-1, random.between(-1, 1), random.between(-0.01, 0.01)});
        // bilinear: an eighth of the squared texel times the second derivative, and half a texel of clamping at the poles
        CHECK(std::abs(map(w).x - (1 + w.z)) < (std::abs(w.y) > 0.999 ? 0.013 : 2e-4));
        CHECK(map(w).z == Catch::Approx(1));
    }
}

TEST_CASE("irradiance: analytic environments", "[ibl]") {
    // L = 1 + w.a: E/pi = 1 + (2/3) n.a.  L = (w.a)^2: E/pi = (1 + (n.a)^2)/4.
    const vec3<double> a = lobe::normalize(vec3<double>{0.3, 0.5, -0.8});
    const auto map = cosine_map(256, 128, a);
    const auto analytic = [&](const vec3<double>& w) { const double c = lobe::dot(w, a); return vec3<double>{1 + c, c * c, 1}; };
    random_numbers random(3);
    for (int i = 0; i < 20; ++i) {
        const vec3<double> n = random.direction();
        const double c = lobe::dot(n, a);
        const vec3<double> exact{1 + 2 * c / 3, (1 + c * c) / 4, 1};
        CHECK(lobe::length(lobe::irradiance(analytic, n, 4096) - exact) < 1e-3);  // Hammersley, 4096 points: log(n)/n = 2e-3, measured 2e-4
        CHECK(lobe::length(lobe::irradiance(map, n) - exact) < 3e-4);              // midpoint rule over texels of 1.4 degrees
    }
    const auto constant = [](const vec3<float>&) { return 2.5f; };
    CHECK(lobe::irradiance(constant, vec3<float>{0, 1, 0}, 64) == Catch::Approx(2.5));
}

TEST_CASE("prefiltered radiance: the reference values and a constant environment", "[ibl]") {
    // By independent quadrature, L(l) = max(0, l.r) gives 0.95435439 at alpha 0.1 and 0.76356088 at alpha 0.5
    random_numbers random(4);
    for (int i = 0; i < 5; ++i) {
        const vec3<double> r = random.direction();
        const auto forward = [&](const vec3<double>& l) { return std::max(0.0, lobe::dot(l, r)); };
        CHECK(std::abs(lobe::prefiltered_radiance(forward, r, lobe::alpha{0.1}, 1u << 14) - 0.95435439) < 1e-5);
        CHECK(std::abs(lobe::prefiltered_radiance(forward, r, lobe::alpha{0.5}, 1u << 14) - 0.76356088) < 1e-4);
        CHECK(lobe::prefiltered_radiance([](const vec3<double>&) { return 3.0; }, r, lobe::alpha{0.3}, 64) == Catch::Approx(3));
    }
}

TEST_CASE("filtered importance sampling converges to the unfiltered integral", "[ibl]") {
    const vec3<double> a = lobe::normalize(vec3<double>{0.3, 0.5, -0.8});
    const auto map = cosine_map(256, 128, a);
    const lobe::latlong_pyramid<double> pyramid(map);
    CHECK(pyramid.size() == 7);
    const vec3<double> r = lobe::normalize(vec3<double>{0.5, 0.2, -0.7});
    for (double width : {0.05, 0.3, 1.0}) {
        const auto exact = lobe::prefiltered_radiance(map, r, lobe::alpha{width}, 1u << 16);
        // the filter blurs over 4/(count pdf) sr: its bias falls with the count, to nothing where that is a texel
        const auto error = [&](std::uint32_t count) {
            return lobe::length(lobe::prefiltered_radiance(pyramid, r, lobe::alpha{width}, count) - exact);
        };
        INFO(width << ": " << error(64) << ' ' << error(1024) << ' ' << error(1u << 16));
        CHECK(error(1024) < error(64) / 2);
        CHECK(error(1u << 16) < 1e-3);
    }
}

TEST_CASE("a million samples of a constant environment add up", "[ibl]") {
    const auto constant = [](const vec3<float>&) { return 2.5f; };
    CHECK(std::abs(lobe::irradiance(constant, vec3<float>{0, 1, 0}, 1u << 22) - 2.5f) < 1e-6f);
    CHECK(std::abs(lobe::prefiltered_radiance(constant, vec3<float>{0, 1, 0}, lobe::alpha{0.5f}, 1u << 22) - 2.5f) < 1e-6f);
}

TEST_CASE("filtered importance sampling takes the solid angle that it states", "[ibl]") {
    // 4/(count pdf) = 16/(count D): read off what the environment is asked for.
    const lobe::ggx ndf{lobe::alpha{0.5}};
    const vec3<double> r{0, 0, 1};
    double asked = 0;
    std::uint32_t count = 0;
    const auto environment = [&]<class... Angle>(const vec3<double>& l, const Angle&... solid_angle) {
        if constexpr (sizeof...(Angle) == 1) {
            const double D = ndf.D(lobe::half_vector(l, r));
            asked = larger(asked, std::abs((solid_angle + ...) * 256 * D / 16 - 1));
            ++count;
        }
        return 1.0;
    };
    CHECK(lobe::prefiltered_radiance(environment, r, lobe::alpha{0.5}, 256) == Catch::Approx(1));
    CHECK(count == 256);
    CHECK(asked < 1e-9);
    // the pyramid answers a solid angle of 4^k texels from level k
    const lobe::latlong_pyramid<double> pyramid(cosine_map(64, 32, r));
    const double texel = 3.141592653589793 / 32 * 3.141592653589793 / 32;
    for (std::size_t k = 0; k < pyramid.size(); ++k) {
        const vec3<double> w{0.6, 0.48, 0.64};
        CHECK(lobe::length(pyramid(w, texel * std::pow(4.0, static_cast<double>(k))) - pyramid.level(k)(w)) < 1e-9);
    }
}

TEST_CASE("each level of the pyramid keeps the mean over the sphere, odd sizes too", "[ibl]") {
    const auto size = GENERATE(std::pair{64, 32}, std::pair{1000, 500}, std::pair{21, 11});
    const lobe::latlong_pyramid<double> pyramid(cosine_map(size.first, size.second, lobe::normalize(vec3<double>{0.3, 0.5, -0.8})));
    CHECK(pyramid.level(pyramid.size() - 1).height <= 3);
    const auto mean = [](const latlong<double>& map) {
        vec3<double> total(0);
        for (int y = 0; y < map.height; ++y)
            for (int x = 0; x < map.width; ++x) total += map.at(x, y) * lobe::latlong_texel_solid_angle<double>(y, map.width, map.height);
        return total;
    };
    for (std::size_t i = 1; i < pyramid.size(); ++i) CHECK(lobe::length(mean(pyramid.level(i)) - mean(pyramid.level(0))) < 1e-9);  // half a million terms
}

TEST_CASE("an image of the wrong size ends in an assert", "[ibl]") {
    CHECK(aborts([] { (void)latlong<float>(4, 2, std::vector<vec3<float>>(7)); }));
    CHECK(aborts([] { (void)latlong<float>(0, 0, {}); }));
}
