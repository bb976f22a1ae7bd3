// Samples of interfaces: a million against their density on the sphere, and their weights.
#include "catch.hpp"
#include "support.hpp"

#include <lobe/bsdf/rough_dielectric.hpp>
#include <lobe/bsdf/thin_dielectric.hpp>
#include <lobe/ndf/beckmann.hpp>
#include <lobe/ndf/ggx.hpp>
#include <lobe/testkit/measure/chi_squared.hpp>

using lobe::alpha;
using lobe::alpha_xy;
using lobe::beckmann;
using lobe::ggx;
using lobe::importance_transport;
using lobe::rough_dielectric;
using lobe::smith_joint;
using lobe::smith_product;
using lobe::vec3;

namespace {

constexpr double pi = 3.141592653589793;

/// The probability that a right sampler is further off, of a million samples in bins of equal solid angle and one of
/// failed ones. Expected: the pdf at 40 x 40 points of each bin.
template <class B>
double chance(const B& bsdf, const vec3<double>& v, std::uint64_t seed) {
    constexpr int rows = 40, columns = 32, inside = 40, samples = 1000000;
    const auto at = [](double z, double phi) {
        const double r = std::sqrt((1 - z) * (1 + z));
        return vec3<double>{r * std::cos(phi), r * std::sin(phi), z};
    };
    std::vector<lobe::testkit::detail::bin> bins;
    double all = 0;
    for (int i = 0; i < rows; ++i)
        for (int j = 0; j < columns; ++j) {
            double sum = 0;
            for (int k = 0; k < inside * inside; ++k) {
                const double z = -1 + 2 * (i + (k / inside + 0.5) / inside) / rows,
                             phi = 2 * pi * (j + (k % inside + 0.5) / inside) / columns;
                sum += bsdf.pdf(v, at(z, phi));
            }
            const double p = sum / (inside * inside) * 4 * pi / (rows * columns);
            all += p;
            bins.push_back({p * samples, 0});
        }
    bins.push_back({std::max(1 - all, 0.0) * samples, 0});
    random_numbers random(seed);
    for (int i = 0; i < samples; ++i) {
        const double x = random(), y = random(), z = random();
        const auto s = bsdf.sample(v, {x, y, z});
        if (!(s.pdf > 0)) {
            bins.back().observed += 1;
            continue;
        }
        const double turn = std::atan2(s.l.y, s.l.x) / (2 * pi);
        const int row = std::min(static_cast<int>((s.l.z + 1) / 2 * rows), rows - 1),
                  column = std::min(static_cast<int>((turn < 0 ? turn + 1 : turn) * columns), columns - 1);
        bins[static_cast<std::size_t>(row * columns + column)].observed += 1;
    }
    return lobe::testkit::detail::chi_squared_probability(lobe::testkit::detail::merged(bins, 20));
}

}  // namespace

TEST_CASE("a million samples of an interface have its density, from both sides", "[glass]") {
    double least = 1;
    int tested = 0;
    const auto test = [&](const auto& bsdf, const vec3<double>& v) {
        const double p = chance(bsdf, v, static_cast<std::uint64_t>(++tested));
        INFO("case " << tested << ", cosine " << v.z << ": p " << p);
        CHECK(p > 1e-4);
        least = larger(-least, -p) * -1;
    };
    for (const double mu : {0.9, 0.3, -0.9, -0.5}) {
        const double s = std::sqrt((1 - mu) * (1 + mu));
        const vec3<double> v{0.6 * s, 0.8 * s, mu};
        test(rough_dielectric{ggx{alpha{0.5}}, smith_joint{}, 1.5}, v);
        test(rough_dielectric{beckmann{alpha{0.6}}, smith_product{}, 1.33}, v);
        test(rough_dielectric{ggx{alpha_xy{1.0, 0.1}}, smith_joint{}, 1.5}, v);
    }
    test(lobe::rough_thin_dielectric{ggx{alpha{0.5}}, lobe::smith_correlated{}, 1.5}, {0.6, 0, -0.8});
    // a wrong density is seen: that of another index
    struct wrong {
        rough_dielectric<ggx<double>, smith_product> drawn{ggx{alpha{0.5}}, smith_product{}, 1.5},
            said{ggx{alpha{0.5}}, smith_product{}, 1.52};
        double pdf(const vec3<double>& v, const vec3<double>& l) const { return said.pdf(v, l); }
        auto sample(const vec3<double>& v, const vec3<double>& u) const { return drawn.sample(v, u); }
    };
    CHECK(chance(wrong{}, {0.6, 0, 0.8}, 1) < 1e-6);
}

namespace {

template <class T>
T heaviest(int samples) {
    random_numbers random(9);
    T most(0);
    for (int i = 0; i < samples; ++i) {
        const T a = static_cast<T>(random.log_between(1e-4, 1)), b = static_cast<T>(random.log_between(1e-4, 1)),
                eta = static_cast<T>(random.log_between(0.3, 3));
        vec3<T> v = random.grazing_direction<T>(1e-6);
        if (i % 2) v.z = -v.z;
        const vec3<T> u{static_cast<T>(random()), static_cast<T>(random()), static_cast<T>(random())};
        const auto weight = [&](const auto& ndf, const auto& masking) {
            const auto w = rough_dielectric{ndf, masking, eta, importance_transport{}}.sample(v, u).weight;
            most = w > most || w != w ? w : most;
        };
        if (i % 4 < 2) {
            weight(ggx{alpha{a}}, smith_joint{});
            weight(ggx{alpha_xy{a, b}}, smith_joint{});
        } else {
            weight(ggx{alpha{a}}, smith_product{});
            if (i % 64 < 4) weight(beckmann{alpha{a}}, smith_joint{});
        }
    }
    return most;
}

}  // namespace

TEST_CASE("the weight of a sample of importance is at most 1", "[glass]") {
    CHECK(heaviest<float>(2000000) <= 1 + 4 * std::numeric_limits<float>::epsilon());
    CHECK(heaviest<double>(500000) <= 1 + 4 * std::numeric_limits<double>::epsilon());
}

TEST_CASE("the same of 1e8 samples", "[.glass_long]") {
    CHECK(heaviest<float>(67000000) <= 1 + 4 * std::numeric_limits<float>::epsilon());
}
