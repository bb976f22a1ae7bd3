#include "catch.hpp"
#include "support.hpp"

#include <lobe/ibl/irradiance.hpp>
#include <lobe/ibl/prefilter.hpp>

#include <algorithm>
#include <numeric>
#include <set>

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
            CHECK(omega ==
                  Catch::Approx(2 * 3.141592653589793 / width * (std::cos(top) - std::cos(bottom))).epsilon(1e-9));
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
            const double c =
                lobe::dot(lobe::latlong_direction(vec2<double>{(x + 0.5) / width, (y + 0.5) / height}), axis);
            pixels.push_back({1 + c, c * c, 1});
        }
    return {width, height, pixels};
}

}  // namespace

TEST_CASE("a lat-long image interpolates across its seam and at its poles", "[ibl]") {
    const auto map = cosine_map(256, 128, {0, 0, 1});
    random_numbers random(2);
    for (int i = 0; i < 10000; ++i) {
        const vec3<double> w =
            i % 2 ? random.direction()
                  : lobe::normalize(vec3<double>{-1, random.between(-1, 1), random.between(-0.01, 0.01)});
        // linear: an eighth of the squared texel times the second derivative, in each angle; a sixteenth of it times
        // the first and cot theta for the weights that keep the energy, no more than at the middle of the row next to
        // the pole
        const double texel = 3.141592653589793 / 128, theta = std::acos(std::abs(w.y));
        CHECK(std::abs(map(w).x - (1 + w.z)) < texel * texel * (0.25 + 1 / (16 * std::tan(larger(theta, texel / 2)))));
        CHECK(map(w).z == Catch::Approx(1));
    }
}

TEST_CASE("irradiance: analytic environments", "[ibl]") {
    // L = 1 + w.a: E/pi = 1 + (2/3) n.a.  L = (w.a)^2: E/pi = (1 + (n.a)^2)/4.
    const vec3<double> a = lobe::normalize(vec3<double>{0.3, 0.5, -0.8});
    const auto map = cosine_map(256, 128, a);
    const auto analytic = [&](const vec3<double>& w) {
        const double c = lobe::dot(w, a);
        return vec3<double>{1 + c, c * c, 1};
    };
    random_numbers random(3);
    for (int i = 0; i < 20; ++i) {
        const vec3<double> n = random.direction();
        const double c = lobe::dot(n, a);
        const vec3<double> exact{1 + 2 * c / 3, (1 + c * c) / 4, 1};
        // Hammersley, 4096 points: log(n)/n = 2e-3, measured 2e-4
        CHECK(lobe::length(lobe::irradiance(analytic, n, 4096) - exact) < 1e-3);
        // midpoint rule over texels of 1.4 degrees
        CHECK(lobe::length(lobe::irradiance(map, n) - exact) < 3e-4);
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
        CHECK(lobe::prefiltered_radiance([](const vec3<double>&) { return 3.0; }, r, lobe::alpha{0.3}, 64) ==
              Catch::Approx(3));
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
    std::uint32_t count = 1u << 22;  // no constant: g++ would add them up when it compiles, in 20 GB
    CHECK(std::abs(lobe::irradiance(constant, vec3<float>{0, 1, 0}, count) - 2.5f) < 1e-6f);
    CHECK(std::abs(lobe::prefiltered_radiance(constant, vec3<float>{0, 1, 0}, lobe::alpha{0.5f}, count) - 2.5f) <
          1e-6f);
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
    const lobe::latlong_pyramid<double> pyramid(
        cosine_map(size.first, size.second, lobe::normalize(vec3<double>{0.3, 0.5, -0.8})));
    CHECK(pyramid.level(pyramid.size() - 1).height <= 3);
    const auto mean = [](const latlong<double>& map) {
        vec3<double> total(0);
        for (int y = 0; y < map.height; ++y)
            for (int x = 0; x < map.width; ++x)
                total += map.at(x, y) * lobe::latlong_texel_solid_angle<double>(y, map.width, map.height);
        return total;
    };
    for (std::size_t i = 1; i < pyramid.size(); ++i)
        CHECK(lobe::length(mean(pyramid.level(i)) - mean(pyramid.level(0))) < 1e-9);  // half a million terms
}

namespace {

/// Black but for one texel.
template <class T>
latlong<T> one_texel(int width, int height, int column, int row) {
    std::vector<vec3<T>> pixels(static_cast<std::size_t>(width * height), vec3<T>(T(0)));
    pixels[static_cast<std::size_t>(row * width + column)] = vec3<T>(T(1));
    return {width, height, pixels};
}

template <class T>
latlong<T> noise(int width, int height, std::uint64_t seed) {
    random_numbers random(seed);
    std::vector<vec3<T>> pixels(static_cast<std::size_t>(width * height));
    for (auto& p : pixels) p = vec3<T>(T(random.between(0, 1)));
    return {width, height, pixels};
}

template <class T>
vec3<T> direction(double theta, double phi) {
    return {T(std::sin(theta) * std::cos(phi)), T(std::cos(theta)), T(std::sin(theta) * std::sin(phi))};
}

template <class T>
double energy(const latlong<T>& map) {
    double total = 0;
    for (int y = 0; y < map.height; ++y)
        for (int x = 0; x < map.width; ++x)
            total +=
                static_cast<double>(map.at(x, y).x) * lobe::latlong_texel_solid_angle<double>(y, map.width, map.height);
    return total;
}

/// int look(w).x dw. In theta eight Gauss points between any two of the kinks, the poles, edges and middles of rows, of
/// images of these heights; in phi, `count` equal steps, from elsewhere in each row of points.
template <class T, class Look>
double energy(const Look& look, const std::vector<int>& heights, int count) {
    constexpr double x[] = {0.1834346424956498, 0.5255324099163290, 0.7966664774136267, 0.9602898564975363};
    constexpr double weight[] = {0.3626837833783620, 0.3137066458778873, 0.2223810344533745, 0.1012285362903763};
    constexpr double pi = 3.141592653589793;
    std::set<double> kinks;
    for (const int height : heights)
        for (int i = 0; i <= 2 * height; ++i) kinks.insert(pi * i / (2 * height));
    double total = 0, from = 0, start = 0;
    for (const double to : kinks) {
        for (int i = 0; i < 8; ++i) {
            const double theta = (from + to) / 2 + (i % 2 ? 1 : -1) * x[i / 2] * (to - from) / 2;
            start = std::fmod(start + 0.6180339887498949, 1);
            double row = 0;
            for (int k = 0; k < count; ++k)
                row += static_cast<double>(look(direction<T>(theta, 2 * pi * (k + start) / count)).x);
            total += row / count * 2 * pi * std::sin(theta) * weight[i / 2] * (to - from) / 2;
        }
        from = to;
    }
    return total;
}

}  // namespace

TEMPLATE_TEST_CASE("the energy of an image is kept by every look-up, level and solid angle", "[ibl]", float, double) {
    // The steps divide the columns of every level, so sums along a row are exact, and what is left is rounding: 1e-5
    // asked, 1e-12 had in double, 1e-6 in float. Plain bilinear weights give a texel next to a pole 8% too much.
    const auto [width, height] =
        GENERATE(std::pair{1, 1}, std::pair{2, 1}, std::pair{1, 2}, std::pair{2, 2}, std::pair{3, 5}, std::pair{7, 4},
                 std::pair{16, 1}, std::pair{1, 64}, std::pair{32, 16}, std::pair{21, 11}, std::pair{40, 5});
    for (const auto& map : {noise<TestType>(width, height, 5), one_texel<TestType>(width, height, width / 3, 0),
                            one_texel<TestType>(width, height, width - 1, height - 1),
                            one_texel<TestType>(width, height, 0, height / 2)}) {
        const double exact = energy(map);
        const lobe::latlong_pyramid<TestType> pyramid(map);
        INFO(width << " x " << height);
        std::vector<int> heights;
        int steps = 8;
        double worst = std::abs(energy<TestType>(map, {height}, 4 * width) / exact - 1);
        for (std::size_t i = 0; i < pyramid.size(); ++i) {
            const auto& level = pyramid.level(i);
            worst = larger(worst, std::abs(energy(level) / exact - 1));
            worst = larger(worst, std::abs(energy<TestType>(level, {level.height}, 4 * level.width) / exact - 1));
            heights.push_back(level.height);
            steps = std::lcm(steps, level.width);
        }
        const double bound = sizeof(TestType) == 4 ? 4e-6 : 1e-12;
        CHECK(worst < bound);
        for (const double solid_angle : {1e-4, 0.01, 0.3, 2.0, 13.0}) {
            const auto look = [&](const vec3<TestType>& w) { return pyramid(w, static_cast<TestType>(solid_angle)); };
            INFO(solid_angle << " sr");
            CHECK(std::abs(energy<TestType>(look, heights, steps) / exact - 1) < bound);
        }
    }
}

TEST_CASE("a look-up over a pole is continuous, and right by symmetry", "[ibl]") {
    // L = 1 + x, half a steradian at the zenith: 1. An azimuth of its own at the pole gives 1.41 on one side and 0.59
    // on the other.
    std::vector<vec3<double>> pixels;
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 128; ++x)
            pixels.push_back(
                vec3<double>(1 + lobe::latlong_direction(vec2<double>{(x + 0.5) / 128, (y + 0.5) / 64}).x));
    const lobe::latlong_pyramid<double> pyramid(latlong<double>(128, 64, pixels));
    const auto grainy = noise<double>(GENERATE(1, 5, 64), GENERATE(1, 4, 32), 6);
    const lobe::latlong_pyramid<double> grains(grainy);
    for (const double pole : {0.0, 3.141592653589793})
        for (int i = 0; i < 16; ++i) {
            const auto w = direction<double>(std::abs(pole - 1e-9), 0.1 + i);
            CHECK(std::abs(pyramid(w, 0.5).x - 1) < 1e-8);  // the slope, 1, times the distance
            CHECK(std::abs(pyramid(w).x - 1) < 1e-8);
            const auto across = direction<double>(std::abs(pole - 1e-9), 3.2 + i);
            // at most a full step over half a row of 1/64 of pi: 40 e-9
            CHECK(std::abs(grainy(w).x - grainy(across).x) < 1e-7);
            for (const double solid_angle : {1e-5, 0.01, 0.5, 3.0})
                CHECK(std::abs(grains(w, solid_angle).x - grains(across, solid_angle).x) < 1e-7);
        }
}

TEST_CASE("a small sun gives the same highlight wherever it stands", "[ibl]") {
    // GGX seen head on, in closed form: D(m)/4 with (m.r)^2 = (1 + l.r)/2, and its normalisation by the midpoint rule.
    // A sun of one texel is smaller than any cap that a sample asks for. Rms over reflections up to 80 degrees off the
    // sun, 48 of them: at most 0.12 of the rms highlight, what a look-up that averages over the true cap has. Levels
    // with slivers at the poles: 0.8, and more for more samples.
    constexpr double pi = 3.141592653589793;
    const auto [width, height, count] = GENERATE(std::tuple{64, 32, 1024u}, std::tuple{64, 32, 4096u},
                                                 std::tuple{512, 256, 1024u}, std::tuple{300, 150, 1500u});
    const double a = GENERATE(1.0, 0.5);
    const auto lobe_of = [&](double cosine) {
        const double b = 1 - (1 - a * a) * (1 + cosine) / 2;
        return cosine > 0 ? cosine * a * a / (4 * pi * b * b) : 0.0;
    };
    double all = 0;
    for (int i = 0; i < 10000; ++i) all += 2 * pi * lobe_of((i + 0.5) / 10000) / 10000;
    for (const double degrees : {0.0, 1.0, 2.0, 3.5, 5.0, 7.0, 10.0, 15.0, 20.0, 45.0, 60.0, 100.0, 130.0, 165.0, 172.0,
                                 177.0, 179.0, 180.0}) {
        const int row = std::clamp(static_cast<int>(degrees / 180 * height), 0, height - 1),
                  column = 5 * width / 8;  // the worst: on an edge of every level
        const auto sun = lobe::latlong_direction(vec2<double>{(column + 0.5) / width, (row + 0.5) / height});
        const lobe::latlong_pyramid<float> pyramid(one_texel<float>(width, height, column, row));
        const double power = lobe::latlong_texel_solid_angle<double>(row, width, height);
        double error = 0, highlight = 0;
        for (int k = 0; k < 48; ++k) {
            const double away = 1.4 * std::sqrt((k + 0.5) / 48);
            const vec3<double> r = lobe::frame<double>(sun).to_world(
                {std::sin(away) * std::cos(2.4 * k), std::sin(away) * std::sin(2.4 * k), std::cos(away)});
            const double exact = power * lobe_of(lobe::dot(sun, r)) / all;
            const double difference =
                static_cast<double>(
                    lobe::prefiltered_radiance(pyramid, vec3<float>(r), lobe::alpha{static_cast<float>(a)}, count).x) -
                exact;
            error += difference * difference;
            highlight += exact * exact;
        }
        INFO(width << " x " << height << ", " << count << " samples, alpha " << a << ", " << degrees << " degrees");
        CHECK(std::sqrt(error / highlight) < 0.12);
    }
}

TEMPLATE_TEST_CASE("a constant image is constant, however few its texels", "[ibl]", float, double) {
    using T = TestType;
    const auto [width, height] =
        GENERATE(std::pair{1, 1}, std::pair{2, 1}, std::pair{1, 2}, std::pair{2, 2}, std::pair{3, 1}, std::pair{1, 3},
                 std::pair{8, 1}, std::pair{1, 8}, std::pair{4, 2}, std::pair{3, 5}, std::pair{7, 4},
                 std::pair{4096, 1}, std::pair{1, 4096}, std::pair{64, 32});
    const T value = GENERATE(T(1), T(0.1), T(3e4));
    const latlong<T> map(width, height, std::vector<vec3<T>>(static_cast<std::size_t>(width * height), vec3<T>(value)));
    const lobe::latlong_pyramid<T> pyramid(map);
    // float is summed in double; half a million terms in double
    const T rounding = value * (sizeof(T) == 4 ? T(1.2e-7f) : T(1e-11));
    random_numbers random(7);
    std::vector<vec3<T>> directions{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    for (int i = 0; i < 4; ++i) directions.push_back(vec3<T>(random.direction()));
    INFO(width << " x " << height << ", " << value);
    for (const auto& w : directions) {
        CHECK(std::abs(map(w).x - value) <= rounding);
        for (std::size_t i = 0; i < pyramid.size(); ++i) CHECK(std::abs(pyramid.level(i)(w).x - value) <= rounding);
        for (const T solid_angle : {T(0), T(1e-6), T(0.01), T(1), T(13), T(1e9)})
            CHECK(std::abs(pyramid(w, solid_angle).x - value) <= rounding);
        CHECK(std::abs(lobe::irradiance(map, w).x - value) <= rounding);
        CHECK(std::abs(lobe::irradiance(map, w, 16).x - value) <= rounding);
        for (const T a : {T(0.01), T(1)}) {
            CHECK(std::abs(lobe::prefiltered_radiance(map, w, lobe::alpha{a}, 16).x - value) <= rounding);
            CHECK(std::abs(lobe::prefiltered_radiance(pyramid, w, lobe::alpha{a}, 16).x - value) <= rounding);
        }
    }
}

TEST_CASE("irradiance of images of a few texels", "[ibl]") {
    // Half a sphere of light at an angle from the normal: (1 + cosine)/2, by projecting it onto the floor. The left
    // half of a map is z < 0.
    // Lunes: light between the azimuths a and b around the zenith gives (b - a)/(2 pi) to a floor.
    // Error: 2e-4, as stated.
    random_numbers random(8);
    const auto top = one_texel<double>(1, 2, 0, 0), right = one_texel<double>(2, 1, 1, 0),
               corner = one_texel<double>(2, 2, 1, 0);
    const auto third = one_texel<double>(3, 1, 1, 0), column = one_texel<double>(8, 1, 3, 0),
               quarter = one_texel<double>(4, 2, 2, 1);
    for (int i = 0; i < 50; ++i) {
        const vec3<double> n = random.direction();
        CHECK(std::abs(lobe::irradiance(top, n).x - (1 + n.y) / 2) < 2e-4);
        CHECK(std::abs(lobe::irradiance(right, n).x - (1 + n.z) / 2) < 2e-4);
    }
    for (const double up : {-1.0, 1.0}) {
        const vec3<double> n{0, up, 0};
        CHECK(lobe::irradiance(third, n).x == Catch::Approx(1.0 / 3).margin(2e-4));
        CHECK(lobe::irradiance(column, n).x == Catch::Approx(1.0 / 8).margin(2e-4));
        CHECK(lobe::irradiance(quarter, n).x == Catch::Approx(up < 0 ? 0.25 : 0).margin(2e-4));
        CHECK(lobe::irradiance(corner, n).x == Catch::Approx(up > 0 ? 0.5 : 0).margin(2e-4));
        CHECK(lobe::irradiance(corner, vec3<double>{0, 0, up}).x == Catch::Approx(up > 0 ? 0.5 : 0).margin(2e-4));
        CHECK(lobe::irradiance(corner, vec3<double>{up, 0, 0}).x == Catch::Approx(0.25).margin(2e-4));
    }
}

TEMPLATE_TEST_CASE("a NaN in a direction is a NaN, and no other input is undefined", "[ibl]", float, double) {
    using T = TestType;
    constexpr T nan = std::numeric_limits<T>::quiet_NaN(), infinity = std::numeric_limits<T>::infinity();
    for (const auto& map : {noise<T>(1, 1, 9), noise<T>(8, 4, 9), noise<T>(1, 9, 9), noise<T>(9, 1, 9)}) {
        const lobe::latlong_pyramid<T> pyramid(map);
        const auto inside = [](T x) { return x >= 0 && x <= 1; };
        for (const vec3<T>& w : {vec3<T>{nan, nan, nan}, {nan, 0, 1}, {0, nan, 0}, {0, 0, nan}, {infinity, nan, 0}}) {
            CHECK(std::isnan(map(w).x));
            CHECK(std::isnan(pyramid(w).x));
            for (const T solid_angle : {T(0), T(0.1), infinity, nan}) CHECK(std::isnan(pyramid(w, solid_angle).x));
            CHECK(std::isnan(lobe::irradiance(map, w).x));
            CHECK(std::isnan(lobe::irradiance(map, w, 4).x));
            CHECK(std::isnan(lobe::prefiltered_radiance(map, w, lobe::alpha{T(0.5)}, 4).x));
            CHECK(std::isnan(lobe::prefiltered_radiance(pyramid, w, lobe::alpha{T(0.5)}, 4).x));
        }
        const T huge = (std::numeric_limits<T>::max)(), tiny = std::numeric_limits<T>::denorm_min();
        for (const vec3<T>& w : {vec3<T>{0, 0, 0},
                                 {infinity, 0, 0},
                                 {0, infinity, 0},
                                 {0, -infinity, 0},
                                 {-infinity, 0, infinity},
                                 {infinity, infinity, infinity},
                                 {huge, huge, huge},
                                 {tiny, tiny, -tiny},
                                 {0, 1, tiny}}) {
            for (const T x : {map(w).x, pyramid(w, T(0)).x, pyramid(w, T(1)).x, pyramid(w, infinity).x})
                CHECK((std::isnan(x) || inside(x)));
            (void)lobe::irradiance(map, w);
            (void)lobe::prefiltered_radiance(pyramid, w, lobe::alpha{T(0.5)}, 4);
        }
        // A solid angle of nothing is the image itself, all directions and more the coarsest level.
        for (const vec3<T>& w : {vec3<T>{0, 1, 0}, {0, T(0.6), T(0.8)}, {T(0.6), T(-0.8), 0}, {0, -1, 0}, {-1, 0, 0}}) {
            for (const T solid_angle : {T(0), T(-0.0), T(-1), -infinity, nan, tiny})
                CHECK(pyramid(w, solid_angle).x == map(w).x);
            CHECK(inside(pyramid(w, infinity).x));
            if (pyramid.size() > 1) CHECK(pyramid(w, infinity).x == pyramid.level(pyramid.size() - 1)(w).x);
        }
    }
}

TEST_CASE("an image of the wrong size ends in an assert", "[ibl]") {
    CHECK(aborts([] { (void)latlong<float>(4, 2, std::vector<vec3<float>>(7)); }));
    CHECK(aborts([] { (void)latlong<float>(0, 0, {}); }));
}
