#include "catch.hpp"
#include "support.hpp"

#include <lobe/width/alpha.hpp>

#include <xsimd/xsimd.hpp>

using lobe::alpha;
using lobe::alpha_xy;

namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

}  // namespace

TEST_CASE("identities of the anisotropic parametrisations", "[widths]") {
    random_numbers random(1);
    double worst = 0;
    for (int i = 0; i < 10000; ++i) {
        const double r = random.between(0.01, 1), a = random(), r2 = r * r;
        const auto disney = alpha_xy<double>::from_disney(r, a),
                   imageworks = alpha_xy<double>::from_imageworks(r, 2 * a - 1),
                   openpbr = alpha_xy<double>::from_openpbr(r, a);
        // x y = r^4; (x + y)/2 = r^2; x^2 + y^2 = 2 r^4: each a few roundings
        worst = larger({worst, std::abs(disney.x() * disney.y() / (r2 * r2) - 1),
                        std::abs((imageworks.x() + imageworks.y()) / (2 * r2) - 1),
                        std::abs((openpbr.x() * openpbr.x() + openpbr.y() * openpbr.y()) / (2 * r2 * r2) - 1)});
        // and what tells them apart from others with the same identity: the ratio
        worst = larger({worst, std::abs(disney.y() / disney.x() / (1 - 0.9 * a) - 1),
                        std::abs(openpbr.y() / openpbr.x() / (1 - a) - 1),
                        std::abs((imageworks.x() - imageworks.y()) / r2 - 2 * (2 * a - 1)) / 4});
    }
    INFO(worst / epsilon);
    CHECK(worst < 12 * epsilon);
}

TEST_CASE("no anisotropy is r^2 along both axes", "[widths]") {
    for (float r : {0.1f, 0.5f, 1.0f})
        for (const auto& width : {alpha_xy<float>::from_disney(r, 0.0f), alpha_xy<float>::from_imageworks(r, 0.0f),
                                  alpha_xy<float>::from_openpbr(r, 0.0f)}) {
            CHECK(width.x() == alpha<float>::from_roughness(r).value());
            CHECK(width.y() == width.x());
        }
}

TEST_CASE("the far ends: 10:1, and floors where a width would be 0", "[widths]") {
    const auto disney = alpha_xy<double>::from_disney(0.5, 1.0);
    CHECK(disney.x() / disney.y() == Catch::Approx(10));
    CHECK(disney.y() == Catch::Approx(0.25 * std::sqrt(0.1)));  // aspect 0.316, not 0.1 (docs/errata.md, S4-2)
    const auto half = alpha_xy<double>::from_openpbr(0.5, 0.5);
    CHECK(half.x() == Catch::Approx(0.25 * std::sqrt(2 / 1.25)));
    const auto flat = alpha_xy<float>::from_openpbr(0.5f, 1.0f, 1e-4f);
    CHECK(flat.x() == Catch::Approx(0.25 * std::sqrt(2.0)));
    CHECK(flat.y() == 1e-4f);
    CHECK(alpha_xy<float>::from_imageworks(0.5f, 1.0f, 1e-4f).y() == 1e-4f);
    CHECK(alpha_xy<float>::from_imageworks(0.5f, -1.0f, 1e-4f).x() == 1e-4f);
    CHECK(alpha_xy<float>::from_imageworks(0.5f, 1.0f, 1e-4f).x() == 0.5f);
    CHECK(alpha_xy<float>::from_disney(0.0f, 0.5f, 1e-4f).x() == 1e-4f);
    CHECK(alpha_xy<float>::at_least(0.1f, 0.0f, 1e-3f).y() == 1e-3f);
    CHECK(alpha_xy<float>::at_least(0.1f, 0.0f, 1e-3f).x() == 0.1f);
}

TEST_CASE("widths of packs", "[widths]") {
    using pack = xsimd::batch<float>;
    const pack r(0.6f), a(0.3f);
    CHECK(alpha_xy<pack>::from_disney(r, a).y().get(0) == Catch::Approx(alpha_xy<float>::from_disney(0.6f, 0.3f).y()));
    CHECK(alpha_xy<pack>::from_openpbr(r, a).x().get(1) ==
          Catch::Approx(alpha_xy<float>::from_openpbr(0.6f, 0.3f).x()));
    CHECK(alpha_xy<pack>::from_imageworks(r, a, pack(0.5f)).y().get(0) == 0.5f);
}

TEST_CASE("bad widths end in an assert", "[widths]") {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    for (const float bad : {-0.1f, 1.1f, nan}) {
        CHECK(aborts([&] { (void)alpha_xy<float>::from_disney(0.5f, bad); }));
        CHECK(aborts([&] { (void)alpha_xy<float>::from_openpbr(0.5f, bad); }));
        CHECK(aborts([&] { (void)alpha_xy<float>::from_imageworks(0.5f, bad < 0 ? -1.1f : bad); }));
    }
    CHECK(aborts([] { (void)alpha_xy<float>::from_imageworks(0.5f, 1.0f); }));
    CHECK(aborts([] { (void)alpha_xy<float>::from_openpbr(0.5f, 1.0f); }));
    CHECK(aborts([] { (void)alpha_xy<float>::from_disney(0.0f, 0.5f); }));
    CHECK(aborts([&] { (void)alpha_xy<float>::from_disney(nan, 0.5f); }));
}
