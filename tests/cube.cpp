// Cube maps: directions, solid angles, look-ups over edges and corners, energy.
#include "catch.hpp"
#include "support.hpp"

#include <lobe/ibl/cube.hpp>
#include <lobe/ibl/latlong.hpp>

using lobe::cube, lobe::vec2, lobe::vec3;

TEST_CASE("cube directions go there and back", "[ibl]") {
    random_numbers random(1);
    for (int i = 0; i < 20000; ++i) {
        const vec3<double> w = random.direction();
        const auto place = lobe::cube_uv(w);
        REQUIRE((place.uv.x >= 0 && place.uv.x <= 1 && place.uv.y >= 0 && place.uv.y <= 1));
        CHECK(lobe::length(lobe::cube_direction(place.face, place.uv) - w) < 1e-15 * 4);
        const auto same = lobe::cube_uv(w * 7.0);
        CHECK((same.face == place.face && std::abs(same.uv.x - place.uv.x) < 1e-15 * 4));
    }
    // as the specification has them: the middle of each face, and on +x right is -z, down is -y
    const vec3<double> axes[6] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    for (int face = 0; face < 6; ++face) CHECK(lobe::cube_point(face, vec2<double>{0.5, 0.5}) == axes[face]);
    CHECK(lobe::cube_point(0, vec2<double>{1.0, 0.0}) == vec3<double>{1, 1, -1});
    CHECK(lobe::cube_point(2, vec2<double>{1.0, 1.0}) == vec3<double>{1, 1, 1});
    CHECK(lobe::cube_point(5, vec2<double>{0.0, 0.0}) == vec3<double>{1, 1, -1});
}

TEST_CASE("cube solid angles add up to the sphere, and are exact", "[ibl]") {
    for (int size : {1, 2, 7, 64}) {
        double total = 0, total_float = 0;
        for (int row = 0; row < size; ++row)
            for (int column = 0; column < size; ++column) {
                total += 6 * lobe::cube_texel_solid_angle<double>(column, row, size);
                total_float += 6 * static_cast<double>(lobe::cube_texel_solid_angle<float>(column, row, size));
            }
        CHECK(std::abs(total - 4 * lobe::pi<double>()) < 1e-12);
        CHECK(std::abs(total_float - 4 * lobe::pi<double>()) < 1e-5);
    }
    // a quarter of a face, by the midpoint rule
    double quarter = 0;
    for (int i = 0; i < 1000; ++i)
        for (int j = 0; j < 1000; ++j) {
            const double x = (i + 0.5) / 1000, y = (j + 0.5) / 1000, d2 = 1 + x * x + y * y;
            quarter += 1e-6 / (d2 * std::sqrt(d2));
        }
    CHECK(lobe::cube_texel_solid_angle<double>(1, 1, 2) == Catch::Approx(quarter).epsilon(1e-6));
}

TEST_CASE("a cube interpolates over its edges and corners", "[ibl]") {
    const auto smooth = [](const vec3<double>& w) { return vec3<double>{1 + w.x, w.y * w.z, 1}; };
    random_numbers random(2);
    for (int size : {16, 64}) {
        const auto map = lobe::make_cube<double>(smooth, size);
        double worst = 0, at_edges = 0;
        for (int i = 0; i < 50000; ++i) {
            vec3<double> w = random.direction();
            const auto uv = lobe::cube_uv(w).uv;
            if (larger(std::abs(uv.x - 0.5), std::abs(uv.y - 0.5)) > 0.5 - 0.5 / size) continue;
            if (i % 2) {  // onto an edge, or next to it
                const double s = random.between(0.999, 1.001);
                w = lobe::normalize(vec3<double>{1, s, random.between(-1, 1)});
                if (i % 4 == 1) w = {w.y, w.z, -w.x};
            }
            const vec3<double> off = map(w) - smooth(w);
            CHECK(map(w).z == Catch::Approx(1).epsilon(1e-14));
            (i % 2 ? at_edges : worst) = larger(i % 2 ? at_edges : worst, std::abs(off.x) + std::abs(off.y));
        }
        INFO(size << ": " << worst << ", at edges " << at_edges);
        // two functions whose second derivatives along a face are at most 3: an eighth of a texel squared, (2/size)^2
        CHECK(worst < 4.0 / (size * size));
        // over an edge the neighbour's texel is up to half a texel off along it, of which half counts
        CHECK(at_edges < 0.5 / size);
    }
}

TEST_CASE("a cube has no seams", "[ibl]") {
    // noise: on both sides of every edge the look-up is the same
    random_numbers random(3);
    for (int size : {1, 2, 8}) {
        std::vector<vec3<double>> pixels;
        for (int i = 0; i < 6 * size * size; ++i) pixels.push_back({random(), random(), random()});
        const cube<double> map(size, pixels);
        double worst = 0;
        for (int i = 0; i < 20000; ++i) {
            const double along = random.between(-1, 1), step = 1e-9;
            const double sx = random() < 0.5 ? -1 : 1, sy = random() < 0.5 ? -1 : 1;
            vec3<double> a{sx, sy * (1 - step), along}, b{sx * (1 - step), sy, along};
            for (int turn = i % 3; turn > 0; --turn) {
                a = {a.y, a.z, a.x};
                b = {b.y, b.z, b.x};
            }
            worst = larger(worst, lobe::length(map(lobe::normalize(a)) - map(lobe::normalize(b))));
        }
        INFO(size << " " << worst);
        CHECK(worst < 1e-7);
    }
}

TEST_CASE("a pyramid of cubes keeps constants and the energy of one texel", "[ibl]") {
    const auto one = [](const vec3<float>&) { return vec3<float>(1); };
    const lobe::cube_pyramid<float> white(lobe::make_cube<float>(one, 64));
    random_numbers random(4);
    for (int i = 0; i < 2000; ++i) {
        const vec3<float> w(random.direction());
        const auto omega = static_cast<float>(random.log_between(1e-6, 20));
        CHECK(std::abs(white(w, omega).x - 1) < 1e-6f);
    }
    for (const auto& [face, column, row] : {std::array{0, 0, 0}, std::array{2, 31, 32}, std::array{5, 63, 10}}) {
        std::vector<vec3<float>> pixels(6 * 64 * 64, vec3<float>(0));
        pixels[static_cast<std::size_t>((face * 64 + row) * 64 + column)] = vec3<float>(1e5f);
        const lobe::cube_pyramid<float> sun(cube<float>(64, pixels));
        const double energy = 1e5 * lobe::cube_texel_solid_angle<double>(column, row, 64);
        // by look-ups: 1024^2 on each face
        const int n = 1024;
        for (std::size_t level = 0; level < sun.size(); ++level) {
            double seen = 0;
            for (int f = 0; f < 6; ++f)
                for (int j = 0; j < n; ++j)
                    for (int i = 0; i < n; ++i) {
                        const vec2<float> uv{(static_cast<float>(i) + 0.5f) / n, (static_cast<float>(j) + 0.5f) / n};
                        const float value = sun.level(level)(lobe::cube_place<float>{f, uv}).x;
                        if (value > 0)
                            seen += static_cast<double>(value) * lobe::cube_texel_solid_angle<double>(i, j, n);
                    }
            INFO("level " << level << ": " << seen / energy - 1);
            // the hat of a texel and the texel have other weights: of a corner, where three faces meet, 3e-3
            const bool at_edge = column == 0 || column == 63;
            CHECK(seen == Catch::Approx(energy).epsilon(level > 0 ? 4e-3 : at_edge ? 3e-3 : 3e-4));
        }
    }
}

TEST_CASE("lat-long to cube and back", "[ibl]") {
    std::vector<vec3<double>> pixels;
    for (int row = 0; row < 64; ++row)
        for (int column = 0; column < 128; ++column) {
            const vec3<double> w = lobe::latlong_direction(vec2<double>{(column + 0.5) / 128, (row + 0.5) / 64});
            pixels.push_back({1 + w.x, 1 + w.y * w.z, 1});
        }
    const lobe::latlong<double> map(128, 64, pixels);
    const auto faces = lobe::make_cube<double>(map, 64, 2);
    random_numbers random(5);
    for (int i = 0; i < 2000; ++i) {
        const vec3<double> w = random.direction();
        CHECK(lobe::length(faces(w) - map(w)) < 4e-3);
        CHECK(std::abs(faces(w).z - 1) < 1e-12);
    }
}
