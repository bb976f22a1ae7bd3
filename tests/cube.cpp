// Cube maps: directions, solid angles, look-ups over edges and corners, energy.
#include "catch.hpp"
#include "support.hpp"

#include <lobe/ibl/cube.hpp>
#include <lobe/ibl/latlong.hpp>
#include <lobe/numeric/gauss_legendre.hpp>

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

TEST_CASE("a pyramid of cubes keeps constants", "[ibl]") {
    const auto one = [](const vec3<float>&) { return vec3<float>(1); };
    const lobe::cube_pyramid<float> white(lobe::make_cube<float>(one, 64));
    random_numbers random(4);
    for (int i = 0; i < 2000; ++i) {
        const vec3<float> w(random.direction());
        const auto omega = static_cast<float>(random.log_between(1e-6, 20));
        CHECK(std::abs(white(w, omega).x - 1) < 1e-6f);
    }
}

namespace {

/// int L dw as look-ups see it: Gauss-Legendre of 4 x 4 points in parts of each quarter of a texel, where they are
/// bilinear; at least 16 parts along a face, so that the solid angle is integrated to 1e-9.
template <class T>
double energy_seen(const cube<T>& map) {
    const lobe::gauss_legendre<double> rule(4);
    const int cells = 2 * map.size() * ((7 + map.size()) / map.size());
    double seen = 0;
    for (int face = 0; face < 6; ++face)
        for (int row = 0; row < cells; ++row)
            for (int column = 0; column < cells; ++column)
                for (std::size_t j = 0; j < 4; ++j)
                    for (std::size_t i = 0; i < 4; ++i) {
                        const double u = (column + rule.x[i]) / cells, v = (row + rule.x[j]) / cells;
                        const double x = 2 * u - 1, y = 2 * v - 1, d2 = 1 + x * x + y * y;
                        const double value = static_cast<double>(
                            map(lobe::cube_place<T>{face, vec2<T>{static_cast<T>(u), static_cast<T>(v)}}).x);
                        seen += value * 4 * rule.w[i] * rule.w[j] / (cells * cells) / (d2 * std::sqrt(d2));
                    }
    return seen;
}

/// The largest relative error of the energy of one texel of 1e5, of all texels or some, in all levels.
template <class T>
std::pair<double, double> energy_errors(int size, int every) {
    double image = 0, halvings = 0;
    const int texels = 6 * size * size;
    for (int k = 0; k < texels; k += every) {
        std::vector<vec3<T>> pixels(static_cast<std::size_t>(texels), vec3<T>(0));
        pixels[static_cast<std::size_t>(k)] = vec3<T>(static_cast<T>(1e5));
        const lobe::cube_pyramid<T> sun(cube<T>(size, pixels));
        const double energy = 1e5 * lobe::cube_texel_solid_angle<double>(k % size, k / size % size, size);
        for (std::size_t level = 0; level < sun.size(); ++level) {
            double& worst = level == 0 ? image : halvings;
            worst = larger(worst, std::abs(energy_seen(sun.level(level)) / energy - 1));
        }
    }
    return {image, halvings};
}

}  // namespace

TEST_CASE("look-ups have the energy of any texel of a cube, in every level of its pyramid", "[ibl]") {
    for (const int size : {1, 2, 4, 8}) {
        const auto [image, halvings] = energy_errors<double>(size, 1);
        INFO("size " << size << ": " << image << ", " << halvings);
        CHECK(image < 1e-5);
        CHECK(halvings < 1e-8);  // the rule of the moments
    }
    const auto [image, halvings] = energy_errors<float>(32, 397);
    INFO("in float: " << image << ", " << halvings);
    CHECK(image < 1e-5);
    CHECK(halvings < 1e-5);
    // a size that is odd
    for (const int size : {3, 5}) {
        for (int k = 0; k < 6 * size * size; ++k) {
            std::vector<vec3<double>> pixels(static_cast<std::size_t>(6 * size * size), vec3<double>(0));
            pixels[static_cast<std::size_t>(k)] = vec3<double>(1);
            const double energy = lobe::cube_texel_solid_angle<double>(k % size, k / size % size, size);
            CHECK(std::abs(energy_seen(cube<double>(size, pixels)) / energy - 1) < 1e-5);
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
    const auto back = lobe::make_latlong<double>(faces, 128, 64, 2);
    double off = 0, light = 0, image = 0;
    for (int row = 0; row < 64; ++row)
        for (int column = 0; column < 128; ++column) {
            off = larger(off, lobe::length(back.at(column, row) - map.at(column, row)));
            CHECK(std::abs(back.at(column, row).z - 1) < 1e-12);
            const double omega = lobe::latlong_texel_solid_angle<double>(row, 128, 64);
            light += omega * back.at(column, row).x;
            image += omega * map.at(column, row).x;
        }
    CHECK(off < 8e-3);  // there and back
    CHECK(light == Catch::Approx(image).epsilon(1e-5));
    // a texel is a mean over its solid angle: of cos^2 from the zenith, exactly
    const auto squares =
        lobe::make_latlong<double>([](const vec3<double>& w) { return vec3<double>(w.y * w.y); }, 4, 2, 64);
    CHECK(squares.at(0, 0).x == Catch::Approx(1.0 / 3).epsilon(1e-4));
}

TEST_CASE("a bright texel keeps its energy in a conversion, as far as look-ups resolve it", "[ibl]") {
    // 8 look-ups an axis of texels as wide: the midpoint rule over its hat, which is 16 wide
    const auto at = [](int size, int k) { return (k * 29 + 11) % size; };
    for (int k = 0; k < 12; ++k) {
        std::vector<vec3<double>> pixels(6 * 32 * 32, vec3<double>(0));
        const int column = at(32, k), row = at(32, 3 * k);
        pixels[static_cast<std::size_t>((k % 6 * 32 + row) * 32 + column)] = vec3<double>(1e5);
        const auto map = lobe::make_latlong<double>(cube<double>(32, pixels), 128, 64, 8);
        double energy = 0;
        for (int j = 0; j < 64; ++j)
            for (int i = 0; i < 128; ++i)
                energy += map.at(i, j).x * lobe::latlong_texel_solid_angle<double>(j, 128, 64);
        CHECK(energy == Catch::Approx(1e5 * lobe::cube_texel_solid_angle<double>(column, row, 32)).epsilon(0.01));
    }
    for (int k = 0; k < 12; ++k) {  // not next to the poles, where texels are narrow
        std::vector<vec3<double>> pixels(128 * 64, vec3<double>(0));
        const int column = at(128, k), row = 8 + at(48, k);
        pixels[static_cast<std::size_t>(row * 128 + column)] = vec3<double>(1e5);
        const auto faces = lobe::make_cube<double>(lobe::latlong<double>(128, 64, pixels), 32, 8);
        double energy = 0;
        faces.for_each([&](int, int i, int j, const vec3<double>& L) {
            energy += L.x * lobe::cube_texel_solid_angle<double>(i, j, 32);
        });
        CHECK(energy == Catch::Approx(1e5 * lobe::latlong_texel_solid_angle<double>(row, 128, 64)).epsilon(0.01));
    }
}
