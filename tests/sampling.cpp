#include "catch.hpp"
#include "support.hpp"

#include <lobe/sampling/points.hpp>
#include <lobe/sampling/warp.hpp>

#include <set>

using lobe::vec2;
using lobe::vec3;

TEST_CASE("points are in [0,1) for every index", "[sampling]") {
    random_numbers random(1);
    const auto inside = [](const auto& u) { return u.x >= 0 && u.x < 1 && u.y >= 0 && u.y < 1; };
    const auto check = [&](std::uint32_t i, std::uint32_t n) {
        return inside(lobe::hammersley<float>(i, n)) && inside(lobe::hammersley<double>(i, n));
    };
    bool good = true;
    for (int k = 0; k < 2000000; ++k) {
        const auto n = static_cast<std::uint32_t>(random.log_between(1, 4294967295.0));
        const auto i = static_cast<std::uint32_t>(random() * n);
        good = good && check(i, n) && check(n - 1, n);
    }
    for (std::uint32_t n = 1; n < 3000; ++n)
        for (std::uint32_t i = 0; i < n; i += 7) good = good && check(i, n);
    CHECK(good);
    CHECK(check(0xffffffffu - 1, 0xffffffffu));
    // rounds to 1.0f when converted
    for (std::uint32_t low = 0; low < 256; ++low) CHECK(lobe::radical_inverse<float>(0xffffff00u | low) < 1);
    CHECK(lobe::radical_inverse<double>(0xffffffffu) < 1);
}

TEST_CASE("the radical inverse mirrors the bits", "[sampling]") {
    for (std::uint32_t i : {0u, 1u, 2u, 3u, 12345u, 0x80000001u}) {
        double mirrored = 0;
        for (int bit = 0; bit < 32; ++bit) mirrored += (i >> bit & 1u) * std::ldexp(1.0, -1 - bit);
        CHECK(lobe::radical_inverse<double>(i) == mirrored);
        CHECK(std::abs(static_cast<double>(lobe::radical_inverse<float>(i)) - mirrored) < 0x1p-24);
    }
}

TEST_CASE("Hammersley points stand where the definition says", "[sampling]") {
    for (std::uint32_t n : {1u, 5u, 64u, 1000u, 1u << 20})
        for (std::uint32_t i = 0; i < n; i += 1 + n / 50) {
            const auto u = lobe::hammersley<double>(i, n);
            CHECK(std::abs(u.x - (i + 0.5) / n) <= 0x1p-31);
            CHECK(std::abs(u.y - (lobe::radical_inverse<double>(i) + 0.5 / n)) <= 0x1p-31);
            const auto f = lobe::hammersley<float>(i, n);
            CHECK(std::abs(static_cast<double>(f.x) - (i + 0.5) / n) <= 0x1.01p-24);
            CHECK(std::abs(static_cast<double>(f.y) - u.y) <= 0x1p-24);
        }
}

TEST_CASE("256 Hammersley points are a (0,8,2)-net", "[sampling]") {
    for (int rows = 0; rows <= 8; ++rows) {
        std::set<std::pair<int, int>> boxes;
        for (std::uint32_t i = 0; i < 256; ++i) {
            const auto u = lobe::hammersley<double>(i, 256);
            boxes.insert(
                {static_cast<int>(u.x * std::ldexp(1, rows)), static_cast<int>(u.y * std::ldexp(1, 8 - rows))});
        }
        CHECK(boxes.size() == 256);
    }
}

namespace {

/// The largest |pdf * |d omega / d u| - 1| by central differences, and the largest |inverse(map(u)) - u|.
template <class Map, class Pdf, class Inverse>
std::pair<double, double> check_warp(Map map, Pdf pdf, Inverse inverse) {
    random_numbers random(7);
    double density = 0, round_trip = 0;
    const double h = 1e-5;
    for (int k = 0; k < 20000; ++k) {
        const vec2<double> u{random.between(1e-3, 1 - 1e-3), random.between(1e-3, 1 - 1e-3)};
        const auto back = inverse(map(u));
        round_trip = larger({round_trip, std::abs(back.x - u.x), std::abs(back.y - u.y)});
        if (std::abs(u.x - 0.5) < 1e-2 || std::abs(u.y - 0.5) < 1e-2 || std::abs(u.x - u.y) < 1e-4 ||
            std::abs(u.x + u.y - 1) < 1e-4)
            continue;  // the creases of the concentric map
        const auto dx = (map(vec2<double>{u.x + h, u.y}) - map(vec2<double>{u.x - h, u.y})) / (2 * h);
        const auto dy = (map(vec2<double>{u.x, u.y + h}) - map(vec2<double>{u.x, u.y - h})) / (2 * h);
        double area;
        if constexpr (std::is_same_v<decltype(map(u)), vec3<double>>)
            area = lobe::length(lobe::cross(dx, dy));
        else
            area = std::abs(dx.x * dy.y - dx.y * dy.x);
        density = larger(density, std::abs(pdf(map(u)) * area - 1));
    }
    return {density, round_trip};
}

}  // namespace

TEST_CASE("warps have the density they state and an inverse", "[sampling]") {
    // Central differences: h^2 times the third derivative, up to 1e3 at the edge u.x = 1e-3, plus rounding 1e-16/h.
    const auto expect = [](const std::pair<double, double>& errors) {
        CHECK(errors.first < 1e-4);
        CHECK(errors.second < 1e-12);
    };
    using d2 = vec2<double>;
    using d3 = vec3<double>;
    expect(check_warp([](d2 u) { return lobe::square_to_uniform_disk(u); },
                      [](d2) { return lobe::uniform_disk_pdf<double>(); },
                      [](d2 p) { return lobe::uniform_disk_to_square(p); }));
    expect(check_warp([](d2 u) { return lobe::square_to_uniform_disk_concentric(u); },
                      [](d2) { return lobe::uniform_disk_concentric_pdf<double>(); },
                      [](d2 p) { return lobe::uniform_disk_concentric_to_square(p); }));
    expect(check_warp([](d2 u) { return lobe::square_to_uniform_hemisphere(u); },
                      [](d3) { return lobe::uniform_hemisphere_pdf<double>(); },
                      [](d3 w) { return lobe::uniform_hemisphere_to_square(w); }));
    expect(check_warp([](d2 u) { return lobe::square_to_cosine_hemisphere(u); },
                      [](d3 w) { return lobe::cosine_hemisphere_pdf(w); },
                      [](d3 w) { return lobe::cosine_hemisphere_to_square(w); }));
    expect(check_warp([](d2 u) { return lobe::square_to_cosine_hemisphere_concentric(u); },
                      [](d3 w) { return lobe::cosine_hemisphere_concentric_pdf(w); },
                      [](d3 w) { return lobe::cosine_hemisphere_concentric_to_square(w); }));
}

TEST_CASE("warps give unit vectors above the horizon, at the corners of the square too", "[sampling]") {
    const float last = 0x1.fffffep-1f;
    for (float x : {0.0f, 1e-30f, 0.25f, 0.5f, last})
        for (float y : {0.0f, 1e-30f, 0.25f, 0.5f, 0.75f, last}) {
            const vec2<float> u{x, y};
            for (const auto& w : {lobe::square_to_uniform_hemisphere(u), lobe::square_to_cosine_hemisphere(u),
                                  lobe::square_to_cosine_hemisphere_concentric(u)}) {
                CHECK(w.z >= 0);
                CHECK(std::abs(lobe::length(w) - 1) < 4e-7f);
            }
            CHECK(lobe::length(vec3<float>(lobe::square_to_uniform_disk(u), 0)) <= 1.0000002f);
        }
    CHECK(lobe::cosine_hemisphere_pdf(vec3<float>{0, 0, -1}) == 0);
    const auto back = lobe::cosine_hemisphere_to_square(lobe::normalize(vec3<float>{0.5f, -1e-12f, 0.5f}));
    CHECK(back.y >= 0);
    CHECK(back.y < 1);
}
