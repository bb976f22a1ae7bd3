// Filtered against unfiltered importance sampling of a real map: the rows of docs/ibl.md and of its plot.
// prefilter_curves MAP DATA_FOLDER
#include "../../examples/common/environment.hpp"

#include <lobe/lobe.hpp>

#include <cmath>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <random>

using glm::vec3;

namespace {

constexpr float roughnesses[] = {0.3f, 0.5f, 0.8f};

/// The sum over all texels: int D L (r.l) dl / int D (r.l) dl.
glm::dvec3 brute_force(const lobe::cube<float>& map, const vec3& r, const lobe::alpha<float>& a) {
    const lobe::ggx normals{a};
    const lobe::frame<float> at(r);
    glm::dvec3 total(0);
    double weights = 0;
    map.for_each([&](int face, int column, int row, const vec3& L) {
        const auto along = [&](int i) { return (static_cast<float>(i) + 0.5f) / static_cast<float>(map.size()); };
        const vec3 l = at.to_local(lobe::cube_direction(face, glm::vec2{along(column), along(row)}));
        if (l.z <= 0) return;
        const double weight = static_cast<double>(normals.D(l + vec3{0, 0, 1}) * l.z) *
                              lobe::cube_texel_solid_angle<double>(column, row, map.size());
        total += glm::dvec3(L) * weight;
        weights += weight;
    });
    return total / weights;
}

}  // namespace

int main(int argc, char** argv) try {
    if (argc != 3) throw std::runtime_error("prefilter_curves MAP DATA_FOLDER");
    const auto map = load_environment(argv[1]);
    const lobe::cube_pyramid<float> environment(lobe::make_cube<float>(map, 128, 4));
    std::mt19937 random(1);
    std::normal_distribution<float> normal;
    std::vector<vec3> directions;
    for (int i = 0; i < 400; ++i)
        directions.push_back(lobe::normalize(vec3{normal(random), normal(random), normal(random)}));

    std::cout << "| roughness | samples | filtered | unfiltered |\n|--:|--:|--:|--:|\n" << std::fixed;
    for (const float roughness : roughnesses) {
        const auto a = lobe::alpha<float>::from_roughness(roughness);
        std::vector<glm::dvec3> exact;
        double norm = 0;
        for (const vec3& r : directions) {
            exact.push_back(brute_force(environment.level(0), r, a));
            norm += lobe::dot(exact.back(), exact.back());
        }
        const auto error = [&](const auto& prefiltered) {
            double squares = 0;
            for (std::size_t i = 0; i < directions.size(); ++i) {
                const glm::dvec3 off = glm::dvec3(prefiltered(directions[i])) - exact[i];
                squares += lobe::dot(off, off);
            }
            return std::sqrt(squares / norm);
        };
        std::ofstream out(std::string(argv[2]) + "/" + std::to_string(static_cast<int>(10 * roughness)) + ".dat");
        for (std::uint32_t n = 16; n <= 16384; n *= 2) {
            const double unfiltered = error([&](const vec3& r) {
                return lobe::prefiltered_radiance([&](const vec3& w) { return environment(w); }, r, a, n);
            });
            const lobe::prefilter_samples<float> samples(environment, a, n);
            const double filtered = error([&](const vec3& r) { return samples(environment, r); });
            out << n << ' ' << filtered << ' ' << unfiltered << '\n';
            std::cout << "| " << std::setprecision(1) << roughness << " | " << n << " | " << std::setprecision(4)
                      << filtered << " | " << unfiltered << " |\n";
        }
        if (!out.good()) throw std::runtime_error(std::string(argv[2]) + ": cannot be written");
    }
} catch (const std::exception& error) {
    std::cerr << "prefilter_curves: " << error.what() << '\n';
    return 1;
}
