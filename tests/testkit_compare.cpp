// Two implementations side by side: differences that must be found, and equal ones that must pass.
#include "catch.hpp"
#include "strangers.hpp"

#include <lobe/lobe.hpp>
#include <lobe/testkit.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

using lobe::alpha;
using lobe::alpha_xy;
using lobe::vec3;
using lobe::testkit::check;
using lobe::testkit::compare;
using lobe::testkit::compare_distribution;
using lobe::testkit::compare_fresnel;
using lobe::testkit::compare_options;
using lobe::testkit::report;
namespace id = lobe::testkit::id;

namespace {

using V = vec3<double>;

check row(const report& r, const lobe::testkit::property_id& which) {
    for (const check& c : r.checks())
        if (c.id == which) return c;
    FAIL("no row " << which.key << " in\n" << r);
    return {};
}
bool has(const std::string& text, const char* part) { return text.find(part) != std::string::npos; }

void expect_equal(const report& r) {
    INFO(r);
    CHECK(r.passed());
    CHECK(r.checks().size() >= 4);
}

template <class T>
auto metal(double a) {
    return lobe::microfacet{lobe::ggx{alpha<T>{static_cast<T>(a)}}, lobe::smith_correlated{},
                            lobe::schlick{vec3<T>{T(1), T(0.71f), T(0.29f)}}};
}
double grey(const V& v, const V& l) { return v.z > 0 && l.z > 0 ? 0.5 / 3.14159265358979 * l.z : 0; }

/// GGX as textbooks write it: 1 - c*c cancels.
template <class T>
auto textbook_D(double width) {
    return [a = static_cast<T>(width)](const vec3<T>& m) {
        const T c2 = m.z * m.z, t2 = (1 - c2) / c2, d = a * a + t2;
        return a * a / (strangers::pi<T> * c2 * c2 * d * d);
    };
}

}  // namespace

TEST_CASE("compare: equal ones pass, float beside double", "[testkit]") {
    for (const double a : {0.005, 0.03, 0.3, 1.0}) {
        INFO("alpha " << a);
        // the same alpha: what float makes of it
        const double as_float = static_cast<double>(static_cast<float>(a));
        const lobe::microfacet exact{lobe::ggx{alpha{as_float}}, lobe::smith_correlated{},
                                     lobe::schlick{V(vec3<float>(1, 0.71f, 0.29f))}};
        for (const std::uint64_t seed : {1u, 2u, 3u}) {
            expect_equal(compare(metal<float>(a), exact, {.seed = seed}));
            expect_equal(compare(exact, metal<float>(a), {.seed = seed}));
            expect_equal(compare(metal<float>(a), metal<float>(a), {.seed = seed}));
        }
        expect_equal(compare(metal<double>(a), metal<double>(a)));
        expect_equal(compare_distribution(lobe::ggx{alpha{static_cast<float>(a)}}, lobe::ggx{alpha{as_float}}));
        expect_equal(
            compare_distribution(lobe::beckmann{alpha{static_cast<float>(a)}}, lobe::beckmann{alpha{as_float}}));
    }
    expect_equal(compare(lobe::lambert{vec3<float>(0.5f)}, lobe::lambert{0.5f}));  // three numbers beside one
    expect_equal(compare(grey, lobe::lambert{0.5}));
}

TEST_CASE("compare: the same formula written in another way passes", "[testkit]") {
    for (const double a : {0.05, 0.5}) {
        INFO("alpha " << a);
        expect_equal(compare_distribution(textbook_D<double>(a), lobe::ggx{alpha{a}}));
        const lobe::ggx isotropic{alpha{a}};
        const lobe::ggx both_ways{alpha_xy{a, a}};
        expect_equal(compare_distribution(isotropic, both_ways));
        expect_equal(compare(lobe::microfacet{isotropic, lobe::smith_correlated{}, lobe::schlick{0.04}},
                             lobe::microfacet{both_ways, lobe::smith_correlated{}, lobe::schlick{0.04}}));
    }
    const auto power = [](double u) { return 0.04 + 0.96 * std::pow(1 - u, 5); };
    expect_equal(compare_fresnel(power, lobe::schlick{0.04}));
    expect_equal(compare_fresnel(lobe::dielectric{1.5f}, lobe::dielectric{1.5}));
}

TEST_CASE("compare: 1e-3 in 1 % of the hemisphere, in half a million calls", "[testkit]") {
    // a cap of 1 % of the solid angle about `axis`, in which the light is 1e-3 brighter
    const auto patched = [](const auto& brdf, const V& axis) {
        return [&brdf, axis](const V& v, const V& l) { return brdf.f_cos(v, l) * (dot(l, axis) > 0.99 ? 1.001 : 1.0); };
    };
    const V axes[] = {{0, 0, 1}, normalize(V{1, 0, 1}), normalize(V{0.3, -0.9, 0.15})};
    const lobe::lambert matt{0.5};
    const auto shiny = metal<double>(0.2);
    for (const V& axis : axes) {
        const report of_matt = compare(patched(matt, axis), matt), of_shiny = compare(patched(shiny, axis), shiny);
        for (const report& r : {of_matt, of_shiny}) {
            INFO(r);
            const check values = row(r, id::equal_f_cos);
            CHECK(!values.passed);
            CHECK(values.measured / values.expected == Catch::Detail::Approx(1.001).epsilon(1e-6));
            CHECK(has(values.meaning, "0.1 % above"));
            CHECK(!values.input.empty());
            // of 65536 directions: 3 standard deviations of the count of 1 % are 12 % of it; near the horizon the cap
            // is cut off: 0.45 of it at least is left
            const double share = row(r, id::share_of_f_cos).measured;
            CHECK(share < 0.0112);
            CHECK(share > 0.0045 * 0.88);
        }
        // a random v sees the patch of a diffuse surface as l.z of the patch: int over the cap of 1e-3 l.z/pi
        if (&axis == &axes[0]) {
            const double energy =
                row(of_matt, id::equal_f_cos).passed ? 0 : row(of_matt, id::energy_that_differs).measured;
            CHECK(energy == Catch::Detail::Approx(1e-3 * (1 - 0.99 * 0.99)).epsilon(0.1));
        }
    }
    // one second is 1e6 calls of a function that takes a microsecond; a tenth of that is the kit's own
    long calls = 0;
    const auto counted = [&](const V& v, const V& l) { return ++calls, shiny.f_cos(v, l); };
    CHECK(compare(counted, shiny).passed());
    CHECK(calls < 500000);
}

TEST_CASE("compare: what is lost, which breaks no law", "[testkit]") {
    const auto exact = metal<double>(0.3);
    const auto channel = [&](const V& v, const V& l) { return exact.f_cos(v, l).x; };
    const auto expect_loss = [&](const auto& f, double least_share, double most_share) {
        const report r = compare(f, channel);
        INFO(r);
        CHECK(!row(r, id::equal_f_cos).passed);
        const double share = row(r, id::share_of_f_cos).measured;
        CHECK(share >= least_share);
        CHECK(share <= most_share);
        CHECK(row(r, id::equal_energy).measured < row(r, id::equal_energy).expected);
        return row(r, id::equal_energy);
    };
    // a constant
    const check dim = expect_loss([&](const V& v, const V& l) { return 0.98 * channel(v, l); }, 0.99, 1);
    CHECK(dim.measured / dim.expected == Catch::Detail::Approx(0.98).epsilon(1e-6));
    CHECK(has(dim.meaning, "returns 2 % less"));
    // the mirror direction clamped: nearly all of a narrow lobe
    const auto narrow = metal<double>(0.02);
    const report clamped = compare([&](const V& v, const V& l) { return (std::min)(narrow.f_cos(v, l).x, 4.0); },
                                   [&](const V& v, const V& l) { return narrow.f_cos(v, l).x; });
    INFO(clamped);
    CHECK(row(clamped, id::equal_energy).measured < 0.5 * row(clamped, id::equal_energy).expected);
    CHECK(!row(clamped, id::equal_f_cos).passed);
    // a floor of the cosine, seen at grazing only
    const auto floored = [&](const V& v, const V& l) { return channel(V{v.x, v.y, (std::max)(v.z, 1e-3)}, l); };
    const report at_grazing = compare(floored, channel);
    INFO(at_grazing);
    CHECK(!row(at_grazing, id::equal_f_cos).passed);
    CHECK(row(at_grazing, id::share_of_f_cos).measured < 0.01);
}

TEST_CASE("compare: right in double and wrong in float is a cancellation", "[testkit]") {
    const double a = static_cast<double>(0.005f);
    const report r = compare_distribution(textbook_D<float>(a), lobe::ggx{alpha{a}});
    INFO(r);
    const check values = row(r, id::equal_D);
    CHECK(!values.passed);
    CHECK(has(values.meaning, "cancellation"));
    CHECK(has(values.meaning, "of a, in float"));
    const report turned = compare_distribution(lobe::ggx{alpha{a}}, textbook_D<float>(a));
    CHECK(has(row(turned, id::equal_D).meaning, "of b, in float"));
    // a wrong constant is none
    const report wrong = compare_distribution([=](const vec3<float>& m) { return 1.01f * textbook_D<float>(0.5)(m); },
                                              lobe::ggx{alpha{0.5}});
    INFO(wrong);
    CHECK(!wrong.passed());
    CHECK(!has(row(wrong, id::equal_D).meaning, "cancellation"));
    CHECK(has(row(wrong, id::equal_D).meaning, "the same factor 1.01"));
}

TEST_CASE("compare: D, projected area, F, pdf", "[testkit]") {
    const report tail = compare_distribution(lobe::ggx{alpha{0.3}}, lobe::student_t{alpha{0.3}, 2.1});
    CHECK(!row(tail, id::equal_D).passed);
    CHECK(!row(tail, id::equal_area).passed);
    struct other_area : lobe::ggx<double> {
        using lobe::ggx<double>::ggx;
        double projected_area(const V& w) const { return 1.001 * lobe::ggx<double>::projected_area(w); }
    };
    const report area = compare_distribution(other_area(alpha{0.3}), lobe::ggx{alpha{0.3}});
    INFO(area);
    CHECK(row(area, id::equal_D).passed);
    CHECK(!row(area, id::equal_area).passed);

    const report fit = compare_fresnel(lobe::schlick{0.04}, lobe::dielectric{1.5});
    INFO(fit);
    CHECK(!fit.passed());
    CHECK(has(row(fit, id::equal_F).input, "cosine = "));
    // Schlick's average 1/21 + 20/21 F0, and that of the exact one by its closed form
    CHECK(row(fit, id::equal_energy).measured == Catch::Detail::Approx(0.04 + 0.96 / 21).epsilon(1e-6));
    CHECK(row(fit, id::equal_energy).expected == Catch::Detail::Approx(lobe::dielectric{1.5}.average()).epsilon(1e-4));
    CHECK(compare_fresnel(lobe::schlick{0.04}, lobe::dielectric{1.5}, {.tolerance = 0.6}).passed());

    const auto brdf = metal<double>(0.3);
    struct other_pdf {
        decltype(brdf) exact;
        vec3<double> f_cos(const V& v, const V& l) const { return exact.f_cos(v, l); }
        double pdf(const V& v, const V& l) const { return exact.pdf(v, l) * (l.z > 0.9 ? 1.01 : 1); }
    };
    const report pdf = compare(other_pdf{brdf}, brdf);
    INFO(pdf);
    CHECK(row(pdf, id::equal_f_cos).passed);
    CHECK(!row(pdf, id::equal_pdf).passed);
    CHECK(row(pdf, id::share_of_pdf).measured == Catch::Detail::Approx(0.1).epsilon(0.05));
}

TEST_CASE("compare: what is no comparison fails", "[testkit]") {
    const auto black = [](const V&, const V&) { return 0.0; };
    CHECK(!compare(black, black).passed());
    const auto nan_at_grazing = [](const V& v, const V& l) {
        return l.z < 0.01 ? std::numeric_limits<double>::quiet_NaN() : grey(v, l);
    };
    const report r = compare(nan_at_grazing, grey);
    CHECK(has(row(r, id::equal_f_cos).meaning, "NaN"));
    const auto throws = [](const V& v, const V& l) {
        if (l.z < 0.01) throw std::runtime_error("too low");
        return grey(v, l);
    };
    CHECK(has(compare(throws, grey).checks().back().meaning, "too low"));
    CHECK(!compare(grey, grey, {.tolerance = 0}).passed());
    // below the horizon where asked for
    const auto careless = [](const V& v, const V& l) { return v.z > 0 ? 0.5 / 3.14159265358979 * std::abs(l.z) : 0; };
    CHECK(compare(careless, grey).passed());
    CHECK(!compare(careless, grey, {.whole_sphere = true}).passed());
}
