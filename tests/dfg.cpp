// Who provides the split-sum terms, against quadrature: tables, fits, averages, the table that comes with the library.
#include "catch.hpp"
#include "support.hpp"

#include <lobe/lobe.hpp>

#include <glm/gtc/packing.hpp>

#include <fstream>
#include <iomanip>

using lobe::alpha, lobe::dfg_terms, lobe::smith_correlated;

namespace {

/// The largest errors over a grid and random points: mu in [0.001,1], roughness in [0.03,1].
struct errors {
    double E = 0, scale = 0, bias = 0;
};

struct point {
    double mu, roughness;
    dfg_terms<double> exact;
};

/// Of normals and masking; order 32 is good to 2e-8.
template <class Masking, class OfWidth = lobe::ggx_of_width>
std::vector<point> points_of(const Masking& masking, int random_points, const OfWidth& of_width = {}) {
    std::vector<point> points;
    const auto add = [&](double mu, double r) {
        points.push_back({mu, r, lobe::dfg_exact(masking, mu, alpha{r * r}, {.order = 32}, of_width)});
    };
    for (int i = 0; i <= 40; ++i)
        for (int j = 0; j <= 30; ++j) add(std::pow(10.0, -3 + 3 * i / 40.0), 0.03 + 0.97 * j / 30);
    random_numbers random(7);
    for (int i = 0; i < random_points; ++i)
        add(i % 2 ? random.log_between(0.001, 1) : random.between(0.001, 1), random.between(0.03, 1));
    return points;
}

template <class T, class Provider>
errors errors_of(const Provider& provider, const std::vector<point>& points) {
    errors e;
    for (const point& p : points) {
        const dfg_terms<T> t = provider(static_cast<T>(p.mu), alpha<T>(static_cast<T>(p.roughness * p.roughness)));
        const double scale = static_cast<double>(t.scale), bias = static_cast<double>(t.bias);
        e.E = larger(e.E, std::abs(scale + bias - p.exact.albedo()));
        e.scale = larger(e.scale, std::abs(scale - p.exact.scale));
        e.bias = larger(e.bias, std::abs(bias - p.exact.bias));
    }
    return e;
}

/// The largest part by which a provider's average is off that of its own terms, of scale, bias and 1 - E (relative).
template <class T, class Provider>
double inconsistency(const Provider& provider) {
    const lobe::gauss_legendre<double> rule(256);
    double worst = 0;
    for (double r : {0.03, 0.1, 0.21, 0.33, 0.47, 0.6, 0.74, 0.85, 1.0}) {
        const alpha<T> a(static_cast<T>(r * r));
        dfg_terms<double> own{0, 0};
        for (std::size_t i = 0; i < rule.x.size(); ++i) {
            const double x = rule.x[i], mu = x * x * x;
            const dfg_terms<T> t = provider(static_cast<T>(mu), a);
            own.scale += rule.w[i] * 6 * x * x * mu * static_cast<double>(t.scale);
            own.bias += rule.w[i] * 6 * x * x * mu * static_cast<double>(t.bias);
        }
        const dfg_terms<T> said = provider.average(a);
        worst = larger({worst, std::abs(static_cast<double>(said.scale) - own.scale),
                        std::abs(static_cast<double>(said.bias) - own.bias),
                        std::abs(static_cast<double>(T(1) - said.albedo()) / (1 - own.albedo()) - 1)});
    }
    return worst;
}

static_assert(lobe::dfg_provider<lobe::default_dfg, float> && lobe::dfg_provider<lobe::default_dfg, double>);
static_assert(lobe::dfg_provider<lobe::dfg_table<float, smith_correlated>, float>);
static_assert(lobe::dfg_provider<lobe::dfg_fit_cheap, float> && lobe::dfg_provider<lobe::dfg_materialx, double>);
static_assert(lobe::default_dfg::describes<lobe::ggx<float>, smith_correlated>);
static_assert(!lobe::default_dfg::describes<lobe::ggx<float>, lobe::smith_separable>);
static_assert(!lobe::default_dfg::describes<lobe::beckmann<float>, smith_correlated>);
static_assert(!lobe::default_dfg::describes<lobe::ggx<float, lobe::alpha_xy<float>>, smith_correlated>);

}  // namespace

TEST_CASE("split-sum terms: tables and fits keep their stated errors", "[dfg]") {
    const auto points = points_of(smith_correlated{}, 2000);
    const auto within = [&](const errors& e, double E, double bias, double scale) {
        CHECK(e.E < E);
        CHECK(e.bias < bias);
        CHECK(e.scale < scale);
    };
    SECTION("default") {
        within(errors_of<float>(lobe::default_dfg{}, points), 4e-4, 4e-4, 4e-4);
        within(errors_of<double>(lobe::default_dfg{}, points), 4e-4, 4e-4, 4e-4);
    }
    SECTION("tables of other sizes") {
        // linear interpolation: a quarter, for twice the nodes
        const auto sized = [](int n) { return lobe::bake_dfg<float>(smith_correlated{}, {.size = n}); };
        within(errors_of<float>(sized(16), points), 1.5e-3, 1e-3, 1.5e-3);
        within(errors_of<float>(sized(64), points), 1e-4, 1e-4, 1e-4);
    }
    SECTION("fits") {
        within(errors_of<float>(lobe::dfg_fit_tiny{}, points), 2.5e-2, 2.8e-2, 3.4e-2);
        within(errors_of<float>(lobe::dfg_fit_cheap{}, points), 1.3e-2, 1.6e-2, 2.7e-2);
        within(errors_of<float>(lobe::dfg_fit_medium{}, points), 4.6e-3, 3e-3, 7.2e-3);
        within(errors_of<float>(lobe::dfg_fit_precise{}, points), 1.1e-3, 9.7e-4, 1.91e-3);
    }
    SECTION("published, as far as they go") {
        within(errors_of<float>(lobe::dfg_karis_mobile{}, points), 0.55, 0.086, 0.5);
        within(errors_of<float>(lobe::dfg_lazarov{}, points), 0.45, 0.49, 0.52);
        within(errors_of<float>(lobe::dfg_hirvonen{}, points), 0.4, 0.095, 0.37);
        within(errors_of<float>(lobe::dfg_materialx{}, points), 0.14, 0.05, 0.12);
        double worst = 0, of_average = 0;
        for (const point& p : points) {
            const alpha a{p.roughness * p.roughness};
            worst = larger(worst, std::abs(lobe::kulla_conty_fit{}.lost(p.mu, a) - (1 - p.exact.albedo())));
        }
        for (double r : {0.03, 0.2, 0.5, 0.8, 1.0})
            of_average =
                larger(of_average, std::abs(lobe::kulla_conty_fit{}.lost_on_average(alpha{r * r}) -
                                            (1 - lobe::exact_dfg<smith_correlated>{}.average(alpha{r * r}).albedo())));
        CHECK(worst < 0.11);
        CHECK(of_average < 1.3e-3);
    }
}

TEST_CASE("split-sum terms: tables keep their errors on the reference table", "[dfg]") {
    const auto separable = lobe::bake_dfg<double>(lobe::smith_separable{});
    double worst = 0, worst_separable = 0;
    int rows = 0;
    for (const auto& row : reference_table("splitsum_ggx_AB.csv")) {
        const auto off = [&](const dfg_terms<double>& t, double scale, double bias) {
            return larger({std::abs(t.scale - scale), std::abs(t.bias - bias), std::abs(t.albedo() - scale - bias)});
        };
        worst = larger(worst, off(lobe::default_dfg{}(row[0], alpha{row[1]}), row[2], row[3]));
        worst_separable = larger(worst_separable, off(separable(row[0], alpha{row[1]}), row[4], row[5]));
        ++rows;
    }
    CHECK(rows == 169);
    CHECK(worst < 4e-4);
    CHECK(worst_separable < 6e-4);
}

TEST_CASE("split-sum terms of other normals and maskings, from a table", "[dfg]") {
    const auto of_beckmann = [](auto a) { return lobe::beckmann{a}; };
    const auto beckmann = lobe::bake_dfg<float>(smith_correlated{}, {}, of_beckmann);
    static_assert(decltype(beckmann)::describes<lobe::beckmann<float>, smith_correlated>);
    static_assert(!decltype(beckmann)::describes<lobe::ggx<float>, smith_correlated>);
    const errors b = errors_of<float>(beckmann, points_of(smith_correlated{}, 500, of_beckmann));
    INFO("Beckmann " << b.E << " " << b.scale << " " << b.bias);
    CHECK(larger({b.E, b.scale, b.bias}) < 2.5e-3);
    const auto separable = lobe::bake_dfg<float>(lobe::smith_separable{});
    const errors s = errors_of<float>(separable, points_of(lobe::smith_separable{}, 500));
    INFO("separable " << s.E << " " << s.scale << " " << s.bias);
    CHECK(larger({s.E, s.scale, s.bias}) < 6e-4);
}

TEST_CASE("split-sum terms: averages are those of the same terms", "[dfg]") {
    // in float, 1 - E at roughness 0.03, 4e-6, has lost all but 4 %; in double the rule of 32 nodes is left
    CHECK(inconsistency<double>(lobe::default_dfg{}) < 2e-3);
    CHECK(inconsistency<double>(lobe::bake_dfg<double>(smith_correlated{})) < 2e-3);
    CHECK(inconsistency<double>(lobe::dfg_fit_cheap{}) < 2e-4);
    CHECK(inconsistency<double>(lobe::dfg_fit_medium{}) < 1e-4);
    CHECK(inconsistency<double>(lobe::dfg_fit_precise{}) < 1e-4);
    CHECK(inconsistency<double>(lobe::dfg_materialx{}) < 2e-2);
    for (double a : {0.01, 0.2, 0.7, 1.0}) {
        const auto exact = lobe::exact_dfg<smith_correlated>{}.average(alpha{a});
        const double E = lobe::average_albedo(
            lobe::microfacet{lobe::ggx{alpha{a}}, smith_correlated{}, lobe::perfect_reflector<double>{}});
        CHECK(std::abs(exact.albedo() - E) < 1e-6);
    }
}

TEST_CASE("split-sum terms: no table overshoots", "[dfg]") {
    random_numbers random(8);
    const auto beckmann = lobe::bake_dfg<float>(smith_correlated{}, {}, [](auto a) { return lobe::beckmann{a}; });
    const auto sane = [](const dfg_terms<float>& t) { return t.scale >= 0 && t.bias >= 0 && t.albedo() <= 1; };
    for (int i = 0; i < 100000; ++i) {
        const auto mu = static_cast<float>(i % 2 ? random() : random.log_between(1e-7, 1));
        const alpha<float> a(static_cast<float>(random.log_between(1e-6, 1)));
        REQUIRE(sane(lobe::default_dfg{}(mu, a)));
        REQUIRE(sane(beckmann(mu, a)));
    }
}

TEST_CASE("split-sum terms of anisotropic surfaces, from a table of four axes", "[dfg]") {
    const auto table = lobe::bake_anisotropic_dfg<float>(smith_correlated{});
    const auto read = [&](const lobe::vec3<double>& v, double x, double y) {
        return table(lobe::vec3<float>(v), {static_cast<float>(x), static_cast<float>(y)});
    };
    random_numbers random(11);
    errors e;
    for (int i = 0; i < 1500; ++i) {
        const double wide = std::pow(random.between(0.1733, 1), 4), narrow = wide * std::pow(16.0, -random());
        const lobe::alpha_xy<double> width = i % 2 ? lobe::alpha_xy{wide, narrow} : lobe::alpha_xy{narrow, wide};
        const double mu = i % 3 ? random.log_between(0.001, 1) : random.between(0.001, 1);
        const double sine = std::sqrt((1 - mu) * (1 + mu)), phi = random.between(0, 2 * lobe::pi<double>());
        const lobe::vec3<double> v{sine * std::cos(phi), sine * std::sin(phi), mu};
        const lobe::microfacet metal{lobe::ggx{width}, smith_correlated{}, lobe::detail::schlick_terms{}};
        const auto exact = lobe::hemisphere_integral([&](const lobe::vec3<double>& l) { return metal.f_cos(v, l); }, v,
                                                     metal.width(), false, {.order = 48})
                               .value;
        const dfg_terms<float> t = read(v, width.x(), width.y());
        e.E = larger(e.E, std::abs(static_cast<double>(t.albedo()) - exact.x - exact.y));
        e.scale = larger(e.scale, std::abs(static_cast<double>(t.scale) - exact.x));
        e.bias = larger(e.bias, std::abs(static_cast<double>(t.bias) - exact.y));
        CHECK((t.scale >= 0 && t.bias >= 0 && t.albedo() <= 1));
    }
    INFO(e.E << ' ' << e.scale << ' ' << e.bias);
    CHECK(e.E < 6e-3);
    CHECK(e.scale < 6e-3);
    CHECK(e.bias < 3.5e-3);
    // along the normal there is no azimuth; equal widths are the isotropic surface
    for (const double mu : {0.01, 0.2, 0.7, 1.0})
        for (const double a : {0.01, 0.3, 1.0}) {
            const auto flat =
                read({std::sqrt((1 - mu) * (1 + mu)) * 0.6, std::sqrt((1 - mu) * (1 + mu)) * 0.8, mu}, a, a);
            const auto isotropic = lobe::dfg_exact(smith_correlated{}, mu, alpha{a});
            CHECK(std::abs(static_cast<double>(flat.albedo()) - isotropic.albedo()) < 6e-3);
            CHECK(std::abs(static_cast<double>(flat.bias) - isotropic.bias) < 3.5e-3);
        }
    // beyond the domain the edge answers
    const lobe::vec3<double> v{0.48, 0.64, 0.6};
    CHECK(read(v, 0.5, 1e-3).albedo() == read(v, 0.5, 0.5 / 16).albedo());
    CHECK(read(v, 3, 1.5).bias == read(v, 1, 0.5).bias);
    CHECK(read(v, 1e-7, 1e-7).scale == read(v, 9e-4, 9e-4).scale);
}

TEST_CASE("split-sum terms as a texture: each convention, read back", "[dfg]") {
    using lobe::dfg_layout;
    constexpr int columns = 9, rows = 5;
    for (const auto channels : {dfg_layout::channels::scale_bias, dfg_layout::channels::bias_albedo})
        for (const auto axis : {dfg_layout::axis::roughness, dfg_layout::axis::alpha})
            for (const auto samples : {dfg_layout::samples::centres, dfg_layout::samples::nodes})
                for (const auto first : {dfg_layout::first_row::smooth, dfg_layout::first_row::rough}) {
                    const auto texels =
                        lobe::dfg_texels(smith_correlated{}, {columns, rows, channels, axis, samples, first});
                    const auto half = lobe::rg16f(texels), unorm = lobe::rg16_unorm(texels);
                    REQUIRE(texels.size() == columns * rows);
                    double in_float = 0, in_half = 0, in_unorm = 0;
                    for (int i = 0; i < columns; ++i)
                        for (int j = 0; j < rows; ++j) {
                            const bool nodes = samples == dfg_layout::samples::nodes;
                            const double x = nodes ? i / (columns - 1.0) : (i + 0.5) / columns;
                            const double y = nodes ? j / (rows - 1.0) : (j + 0.5) / rows;
                            const double a = axis == dfg_layout::axis::roughness ? y * y : y;
                            if (x * a == 0) continue;
                            const auto t = lobe::dfg_exact(smith_correlated{}, x, alpha{a}, {.order = 32});
                            const int row = first == dfg_layout::first_row::smooth ? j : rows - 1 - j;
                            const auto at = static_cast<std::size_t>(row * columns + i);
                            const bool plain = channels == dfg_layout::channels::scale_bias;
                            const double expected[] = {plain ? t.scale : t.bias, plain ? t.bias : t.albedo()};
                            for (int c = 0; c < 2; ++c) {
                                const auto k = 2 * at + static_cast<std::size_t>(c);
                                const auto off = [&](float read) {
                                    return std::abs(static_cast<double>(read) - expected[c]);
                                };
                                in_float = larger(in_float, off(texels[at][c]));
                                in_half = larger(in_half, off(glm::unpackHalf1x16(half[k])));
                                in_unorm = larger(in_unorm, off(static_cast<float>(unorm[k]) / 65535));
                            }
                        }
                    CHECK(in_float < 1e-5);
                    CHECK(in_half < 1e-5 + 0x1p-12);
                    CHECK(in_unorm < 1e-5 + 0.5 / 65535);
                }
    // the limits at the nodes of 0: all light at grazing, F0 + (1 - F0) (1 - mu)^5 of a mirror
    const auto corner =
        lobe::dfg_texels(smith_correlated{}, {.width = 3, .height = 3, .samples = dfg_layout::samples::nodes});
    CHECK(corner[0].x + corner[0].y == Catch::Approx(1).margin(1e-4));
    CHECK(corner[1].y == Catch::Approx(std::pow(0.5, 5)).margin(1e-4));
    CHECK(corner[6].x + corner[6].y == Catch::Approx(1).margin(1e-4));
}

TEST_CASE("halves are the nearest, ties to even", "[dfg]") {
    const auto bits_of = [](float x) { return lobe::rg16f({{x, 0.0f}})[0]; };
    int wrong = 0;
    for (unsigned h = 0; h < 0x3c00; ++h) {  // from 0 up to 1
        const auto low = static_cast<std::uint16_t>(h), high = static_cast<std::uint16_t>(h + 1);
        const float x = glm::unpackHalf1x16(low), tie = (x + glm::unpackHalf1x16(high)) / 2;  // exact in float
        wrong += bits_of(x) != low;
        wrong += bits_of(std::nextafter(tie, 0.0f)) != low;
        wrong += bits_of(tie) != (h % 2 ? high : low);
        wrong += bits_of(std::nextafter(tie, 1.0f)) != high;
    }
    CHECK(wrong == 0);
    CHECK(bits_of(1.0f) == 0x3c00);
    CHECK(lobe::rg16_unorm({{0.0f, 1.00001f}}) == std::vector<std::uint16_t>{0, 65535});
}

TEST_CASE("a table of 64 x 64 holds at its nodes what quadrature says", "[dfg]") {
    const auto fast = lobe::bake_dfg<double>(smith_correlated{}, {.size = 64, .order = 12});
    const auto slow = lobe::bake_dfg<double>(smith_correlated{}, {.size = 64, .order = 32});
    double worst = 0;
    for (int i = 0; i < 2 * 64 * 64; ++i)
        worst = larger(worst, std::abs(fast.parts().missing.values[i] - slow.parts().missing.values[i]));
    INFO(worst);
    CHECK(worst < 1e-4);
}

namespace {

template <class N>
void write_numbers(std::ostream& out, const char* name, const N* values, int count) {
    out << "\ninline constexpr float default_dfg_" << name << "[] = {";
    std::string line;
    for (int i = 0; i < count; ++i) {
        std::ostringstream number;
        number << std::setprecision(6) << values[i];
        std::string text = number.str();
        if (text.find_first_of(".e") == std::string::npos) text += ".0";
        text += i + 1 < count ? "f," : "f";
        if (line.size() + text.size() > 112) {
            out << "\n    " << line;
            line.clear();
        }
        line += (line.empty() ? "" : " ") + text;
    }
    out << "\n    " << line << "};\n";
}

}  // namespace

// After a change of the fit, of the axes or of the bake: lobe_tests "[.write_default_dfg]" in the folder of the header.
TEST_CASE("write default_dfg_data.hpp", "[.write_default_dfg]") {
    const auto table = lobe::bake_dfg<double>(smith_correlated{}, {.size = 32, .order = 32});
    std::ofstream out("default_dfg_data.hpp");
    out << "// The numbers of `default_dfg`, written by tests/dfg.cpp.\n#pragma once\n\n"
           "#include <lobe/core/cpp20.hpp>\n\n// clang-format off\nnamespace lobe::detail {\n";
    write_numbers(out, "missing", table.parts().missing.values, 2 * 32 * 32);
    write_numbers(out, "averages", table.parts().averages.values, 2 * 64);
    out << "\n}  // namespace lobe::detail\n// clang-format on\n";
    CHECK(out.good());
}

TEST_CASE("the table that comes with the library is the one that is baked", "[dfg]") {
    // at another order than the one it was written with, and its numbers have 6 digits
    const auto table = lobe::bake_dfg<double>(smith_correlated{}, {.size = 32, .order = 24});
    const auto same = [](const auto& baked, const float* kept, int count, double bound) {
        double worst = 0;
        for (int i = 0; i < count; ++i) worst = larger(worst, std::abs(baked.values[i] - static_cast<double>(kept[i])));
        CHECK(worst < bound);
    };
    same(table.parts().missing, lobe::detail::default_dfg_missing, 2 * 32 * 32, 1e-6);
    same(table.parts().averages, lobe::detail::default_dfg_averages, 2 * 64, 1e-4);
}
