// Every sampler: a million samples against the density that its pdf states.
#include "catch.hpp"
#include "ndf_support.hpp"

#include <lobe/brdf/burley.hpp>
#include <lobe/brdf/eon.hpp>
#include <lobe/brdf/ggx_samplers.hpp>
#include <lobe/brdf/lambert.hpp>
#include <lobe/brdf/metallic_roughness.hpp>
#include <lobe/brdf/oren_nayar.hpp>
#include <lobe/fresnel/schlick.hpp>
#include <lobe/sampling/warp.hpp>

using lobe::alpha;
using lobe::alpha_xy;
using lobe::ggx;
using lobe::vec2;
using lobe::vec3;

namespace {

constexpr double pi = 3.141592653589793;
constexpr double grazing = 0.0017453283658983088;  // cos(89.9 degrees)

vec3<double> at(double mu, double phi = 0.9) {
    const double sine = std::sqrt((1 - mu) * (1 + mu));
    return {sine * std::cos(phi), sine * std::sin(phi), mu};
}

/// Which directions a sampler can return, as polar slopes r (wx cos phi, wy sin phi): along each azimuth those below a
/// largest r.
enum class reach { hemisphere, seen, reflected };

/// The bins: rings of r, 4 to an e-fold, and sectors, the first of which starts a quarter turn from the view: there
/// what can be seen ends sharply.
class bins {
public:
    static constexpr int sectors = 16;
    static constexpr double first = -2.5, step = 0.25;  // ln r of the first edge, and between edges

    bins(const vec2<double>& widths, const vec3<double>& view, reach limit)
        : w(widths), v(view), to(limit), origin(std::atan2(w.y * v.y, w.x * v.x) + pi / 2) {
        for (double ln_r = first; ln_r < std::log(1000 / std::min(w.x, w.y)); ln_r += step)
            edges.push_back(std::exp(ln_r));
    }

    std::size_t count() const { return (edges.size() + 1) * sectors; }

    std::size_t of(const vec3<double>& m) const {
        const double x = m.x / (m.z * w.x), y = m.y / (m.z * w.y), ln_r = std::log(x * x + y * y) / 2;
        double turn = (std::atan2(y, x) - origin) / (2 * pi);
        turn -= std::floor(turn);
        const double ring =
            std::min(std::max(0.0, 1 + std::floor((ln_r - first) / step)), static_cast<double>(edges.size()));
        return static_cast<std::size_t>(ring) * sectors +
               static_cast<std::size_t>(std::min(static_cast<int>(turn * sectors), sectors - 1));
    }

    /// int density(m) dm over each, by Gauss's rule: in r over the disk inside the first edge, in ln r over the rings,
    /// by e-folds to 1e30 outside the last; in phi, nodes crowd towards the edges of a sector. Where the reach ends
    /// inside a bin, the error is 1/96^2 of it.
    template <class Density>
    std::vector<double> probabilities(const Density& density) const {
        const lobe::gauss_legendre<double> across(96), along(6);
        std::vector<double> p(count());
        for (int sector = 0; sector < sectors; ++sector)
            for (std::size_t k = 0; k < across.x.size(); ++k) {
                const double x = across.x[k], phi = origin + 2 * pi * (sector + x * x * (3 - 2 * x)) / sectors;
                const double d_phi = across.w[k] * 6 * x * (1 - x) * 2 * pi / sectors;
                const double dx = w.x * std::cos(phi), dy = w.y * std::sin(phi), top = largest(dx, dy);
                const auto at_slope = [&](double r) {
                    const double z = 1 / std::sqrt(1 + r * r * (dx * dx + dy * dy));
                    return density(vec3<double>{r * dx * z, r * dy * z, z}) * w.x * w.y * r * z * z * z * d_phi;
                };
                const auto add = [&](std::size_t ring, double low, double high) {
                    high = std::min(high, top);
                    for (std::size_t i = 0; low < high && i < along.x.size(); ++i) {
                        const double r = low > 0 ? low * std::pow(high / low, along.x[i]) : high * along.x[i];
                        p[ring * sectors + static_cast<std::size_t>(sector)] +=
                            at_slope(r) * along.w[i] * (low > 0 ? r * std::log(high / low) : high);
                    }
                };
                add(0, 0, edges[0]);
                for (std::size_t i = 1; i < edges.size(); ++i) add(i, edges[i - 1], edges[i]);
                for (double r = edges.back(); r < std::min(top, 1e30); r *= 2.72) add(edges.size(), r, 2.72 * r);
            }
        return p;
    }

private:
    /// v.m > 0, or l.z > 0, with m = (r dx, r dy, 1): v.z + r (d.v) > 0, or v.z |d|^2 r^2 - 2 r (d.v) - v.z < 0, a
    /// circle.
    double largest(double dx, double dy) const {
        const double c = dx * v.x + dy * v.y, d2 = dx * dx + dy * dy;
        if (to == reach::hemisphere || (to == reach::seen && c >= 0)) return 1e300;
        if (to == reach::seen) return v.z / -c;
        const double root = std::sqrt(c * c + v.z * v.z * d2);
        return c > 0 ? (c + root) / (v.z * d2) : v.z / (root - c);
    }

    vec2<double> w;
    vec3<double> v;
    reach to;
    double origin;
    std::vector<double> edges;
};

struct fit {
    double p, integral, success;
    int degrees;
};

/// Pearson's chi^2 of a million samples against the integrals of the pdf. What is not a direction above the horizon
/// counts as failed, a bin of its own; bins that expect fewer than 10 are merged. p is the chance that a right sampler
/// is further off, by Wilson and Hilferty's cube root, good to 1 % of itself from 20 degrees on.
template <class Sample, class Density>
fit chi_squared(const bins& cells, const Sample& sample, const Density& density, std::uint64_t seed) {
    constexpr int samples = 1000000;
    std::vector<double> expected = cells.probabilities(density), counted(expected.size());
    random_numbers random(seed);
    double failed = 0, integral = 0;
    for (int i = 0; i < samples; ++i) {
        const double u = random();
        const vec3<double> m = sample(vec2<double>{u, random()});
        if (m.z > 0)
            ++counted[cells.of(m)];
        else
            ++failed;
    }
    for (const double p : expected) integral += p;
    expected.push_back(std::max(0.0, 1 - integral));
    counted.push_back(failed);
    double chi2 = 0, merged_expected = 0, merged_counted = 0;
    int used = 0;
    for (std::size_t i = 0; i < expected.size(); ++i) {
        merged_expected += expected[i] * samples;
        merged_counted += counted[i];
        if (merged_expected < 10) continue;
        chi2 += (merged_counted - merged_expected) * (merged_counted - merged_expected) / merged_expected;
        ++used;
        merged_expected = merged_counted = 0;
    }
    if (merged_counted > 50) chi2 = 1e30;  // where fewer than 10 are expected: 1e-19, a leak
    const double degrees = used - 1, t = 2 / (9 * degrees), z = (std::cbrt(chi2 / degrees) - (1 - t)) / std::sqrt(t);
    return {std::erfc(z / std::sqrt(2.0)) / 2, integral, 1 - failed / samples, used - 1};
}

template <class N>
fit all_normals(const N& ndf, std::uint64_t seed) {
    return chi_squared(
        bins(ndf.width(), {0, 0, 1}, reach::hemisphere), [&](const vec2<double>& u) { return ndf.sample(u); },
        [&](const vec3<double>& m) { return ndf.pdf(m); }, seed);
}

template <class N>
fit visible_normals(const N& ndf, const vec2<double>& width, const vec3<double>& v, std::uint64_t seed) {
    return chi_squared(
        bins(width, v, reach::seen), [&](const vec2<double>& u) { return ndf.sample_visible(v, u); },
        [&](const vec3<double>& m) { return ndf.pdf_visible(v, m); }, seed);
}

/// Of light directions, as half vectors: dl = 4 (v.m) dm.
template <class B>
fit light_directions(const B& brdf, const vec3<double>& v, std::uint64_t seed) {
    const auto half = [&](const vec2<double>& u) {
        const auto s = brdf.sample(v, u);
        return s.pdf > 0 ? lobe::normalize(v + s.l) : vec3<double>(0);
    };
    return chi_squared(
        bins(brdf.width(), v, reach::reflected), half,
        [&](const vec3<double>& m) { return brdf.pdf(v, lobe::reflect(v, m)) * 4 * lobe::dot(v, m); }, seed);
}

struct result {
    std::string name;
    fit is;
    double error;  // of the quadrature that integrates the pdf
};

/// The fits so far.
class all_tests {
public:
    void of_normals(const std::string& name, const auto& ndf) { add(name + ", all", all_normals(ndf, seed())); }
    void of_visible(const std::string& name, const auto& ndf, double mu) {
        add(name + ", visible at " + std::to_string(mu), visible_normals(ndf, ndf.width(), at(mu), seed()));
    }
    void of_lights(const std::string& name, const auto& brdf, double mu, double error = 1e-6) {
        add(name + ", lights at " + std::to_string(mu), light_directions(brdf, at(mu), seed()), error);
    }
    void add(const std::string& name, const fit& is, double error = 1e-6) { results.push_back({name, is, error}); }
    std::uint64_t seed() const { return 100 + results.size(); }

    std::vector<result> results;
};

const struct {
    double ax, ay, mu;
} situations[] = {
    {0.001, 0.001, 1},    {0.001, 0.001, 0.5}, {0.001, 0.001, grazing}, {0.05, 0.05, 0.1}, {0.1, 0.1, grazing},
    {0.3, 0.3, 0.2},      {1, 1, 0.5},         {1, 1, grazing},         {1, 1, 1},         {0.001, 0.3, 0.5},
    {0.6, 0.05, grazing}, {0.02, 1, 0.05},     {2.5, 1.5, 0.3}};

void microfacets_of_ggx(all_tests& tests) {
    for (const auto& [ax, ay, mu] : situations) {
        const std::string name = std::to_string(ax) + ' ' + std::to_string(ay);
        const ggx ndf{alpha_xy{ax, ay}};
        const auto with = [&](const auto& sampler) {
            return lobe::microfacet{ndf, lobe::smith_correlated{}, lobe::perfect_reflector{}, sampler};
        };
        tests.of_lights("visible_normals " + name, with(lobe::visible_normals{}), mu);
        tests.of_lights("visible_heitz2018 " + name, with(lobe::visible_heitz2018{}), mu);
        tests.of_lights("visible_bounded_caps " + name, with(lobe::visible_bounded_caps{}), mu);
        tests.of_lights("all_normals " + name, with(lobe::all_normals{}), mu);
    }
}

void normals(all_tests& tests) {
    for (const double a : {0.001, 1.0}) {
        const alpha<double> width{a};
        const alpha_xy<double> widths{a, 0.3};
        const std::string name = ' ' + std::to_string(a);
        tests.of_normals("ggx" + name, ggx{width});
        tests.of_normals("beckmann" + name, lobe::beckmann{widths});
        tests.of_normals("student_t" + name, lobe::student_t{widths, 1.6});
        tests.of_normals("hyper_cauchy" + name, lobe::hyper_cauchy{width, 3.0});
        tests.of_normals("blinn_phong" + name, lobe::blinn_phong{width});
        tests.of_normals("phong" + name, lobe::phong{width});
        tests.of_normals("exponential_power" + name, lobe::exponential_power{widths, a < 1 ? 0.5 : 2.0});
        tests.of_normals("gtr 1" + name, lobe::gtr{width, 1.0});
        tests.of_normals("gtr 3" + name, lobe::gtr{width, 3.0});
        tests.of_normals("abc" + name, lobe::abc{width, 1.5});
        for (const double mu : {1.0, 0.5, grazing}) {
            tests.of_visible("ggx" + name, ggx{widths}, mu);
            tests.of_visible("beckmann" + name, lobe::beckmann{widths}, mu);
        }
    }
    tests.of_normals("sgd", lobe::sgd{alpha{0.1}, 1.5});
    const lobe::mixture both{ggx{alpha{0.5}}, lobe::beckmann{alpha{0.1}}, 0.4};
    tests.of_normals("mixture", both);
    for (const double mu : {1.0, 0.3, grazing}) tests.of_visible("mixture", both, mu);
    const lobe::masked_by pair{lobe::blinn_phong{alpha{0.5}}, ggx{alpha{0.5}}};
    tests.of_normals("masked_by", pair);
}

/// Their distribution lives on the whole sphere; what is seen of it, in the frame of the view, on a hemisphere.
void flakes(all_tests& tests) {
    const auto seen = [&](const std::string& name, const lobe::sggx<double>& sggx, const vec3<double>& v) {
        const lobe::frame<double> of_view(v);
        tests.add("sggx, " + name,
                  chi_squared(
                      bins({1, 1}, {0, 0, 1}, reach::hemisphere),
                      [&](const vec2<double>& u) { return of_view.to_local(sggx.sample_visible(v, u)); },
                      [&](const vec3<double>& m) { return sggx.pdf_visible(v, of_view.to_world(m)); }, tests.seed()));
    };
    seen("a surface from above", lobe::sggx{alpha_xy{0.3, 0.5}}, at(0.7));
    seen("a surface from its side", lobe::sggx{alpha{0.3}}, at(grazing));
    seen("a rough one", lobe::sggx{alpha{1.0}}, at(0.5));
    seen("a fibre", lobe::sggx<double>::fiber(lobe::frame<double>(at(0.2, 3)), alpha{0.2}), at(-0.4));
    seen("any axes", lobe::sggx{lobe::frame<double>(at(-0.3, 2)), vec3<double>{0.2, 0.9, 0.5}}, at(0.6));
    // so narrow that its normals lie around n; what is seen of the other side counts as failed
    const lobe::sggx narrow{alpha{0.001}};
    for (const double mu : {1.0, 0.5, grazing})
        tests.add("sggx, narrow, at " + std::to_string(mu),
                  visible_normals(narrow, {0.001, 0.001}, at(mu), tests.seed()));
}

/// By quadrature and Newton's method: up to 15 microseconds a sample at grazing angles, where all share one code; half
/// a microsecond at the normal. In between both branches are taken.
void numeric_visible_normals(all_tests& tests) {
    const alpha<double> narrow{0.001}, middle{0.3}, wide{1};
    tests.of_visible("student_t", lobe::student_t{narrow, 3.0}, 1);
    tests.of_visible("hyper_cauchy", lobe::hyper_cauchy{narrow, 2.5}, 1);
    tests.of_visible("blinn_phong", lobe::blinn_phong{narrow}, 1);
    tests.of_visible("phong", lobe::tabulated{lobe::phong{narrow}}, 1);
    tests.of_visible("exponential_power", lobe::tabulated{lobe::exponential_power{narrow, 0.5}}, 1);
    tests.of_visible("gtr", lobe::tabulated{lobe::gtr{narrow, 3.0}}, 1);
    tests.of_visible("abc", lobe::tabulated{lobe::abc{narrow, 2.5}}, 1);
    tests.of_visible("student_t", lobe::student_t{middle, 3.0}, 0.5);
    tests.of_visible("hyper_cauchy", lobe::hyper_cauchy{alpha_xy{0.6, 0.2}, 2.5}, 0.5);
    tests.of_visible("blinn_phong", lobe::blinn_phong{alpha{0.5}}, 0.5);
    tests.of_visible("phong", lobe::tabulated{lobe::phong{wide}}, 0.5);
    tests.of_visible("exponential_power", lobe::tabulated{lobe::exponential_power{alpha_xy{0.6, 0.2}, 2.0}}, grazing);
    tests.of_visible("gtr", lobe::tabulated{lobe::gtr{middle, 1.0}}, 0.5);
    tests.of_visible("abc", lobe::tabulated{lobe::abc{alpha{0.5}, 1.5}}, 0.5);
    tests.of_visible("sgd", lobe::tabulated{lobe::sgd{middle, 1.5}}, 0.5);
    tests.of_visible("gtr", lobe::tabulated{lobe::gtr{narrow, 3.0}}, grazing);
}

void diffuse(all_tests& tests) {
    for (const double mu : {1.0, 0.5, grazing}) tests.of_lights("lambert", lobe::lambert{0.5}, mu);
    for (const double mu : {1.0, 0.5, 0.1, grazing}) {  // the density has an edge at theta_l = theta_v, inside of bins
        tests.of_lights("oren_nayar", lobe::oren_nayar{0.5, 1.5}, mu, 2e-5);
        tests.of_lights("fon", lobe::fon{0.5, 0.3}, mu, 2e-5);
        tests.of_lights("eon", lobe::eon{0.5, 1.0}, mu, 2e-5);
    }
    tests.of_lights("oren_nayar by the cosine", lobe::oren_nayar{0.5, 0.3, lobe::cosine_sampling{}}, 0.5);
    tests.of_lights("fon by the cosine", lobe::fon{0.5, 0.3, lobe::cosine_sampling{}}, 0.5);
    tests.of_lights("eon by the cosine", lobe::eon{0.5, 0.3, lobe::fon_loss{}, lobe::cosine_sampling{}}, 0.5);
    tests.of_lights("burley", lobe::burley{0.5, 0.3}, 0.5);
    tests.of_lights("burley_frostbite", lobe::burley_frostbite{0.5, 0.3}, 0.5);
    const auto warp = [&](const std::string& name, const auto& map, const auto& pdf) {
        tests.add(name, chi_squared(bins({1, 1}, {0, 0, 1}, reach::hemisphere), map, pdf, tests.seed()));
    };
    const auto cosine = [](const vec3<double>& w) { return lobe::cosine_hemisphere_pdf(w); };
    warp(
        "cosine_hemisphere", [](const vec2<double>& u) { return lobe::square_to_cosine_hemisphere(u); }, cosine);
    warp(
        "cosine_hemisphere_concentric",
        [](const vec2<double>& u) { return lobe::square_to_cosine_hemisphere_concentric(u); }, cosine);
    warp(
        "uniform_hemisphere", [](const vec2<double>& u) { return lobe::square_to_uniform_hemisphere(u); },
        [](const vec3<double>&) { return lobe::uniform_hemisphere_pdf<double>(); });
}

void compositions(all_tests& tests) {
    const auto gloss = [](double a, double F0) {
        return lobe::microfacet{ggx{alpha{a}}, lobe::smith_correlated{}, lobe::schlick{F0}};
    };
    const auto some_E = [](double mu) { return 0.04 + 0.4 * (1 - mu); };
    const lobe::burley base{0.7, 0.5};
    for (const auto& [a, mu] : {std::pair{0.001, 0.3}, std::pair{0.1, 1.0}, std::pair{1.0, grazing}}) {
        const std::string name = std::to_string(a);
        tests.of_lights("metallic_roughness " + name, lobe::metallic_roughness(0.7, 0.2, alpha{a}), mu);
        tests.of_lights("anisotropic metallic_roughness " + name,
                        lobe::metallic_roughness(0.7, 0.2, alpha_xy{a, 3 * a}), mu);
        tests.of_lights(
            "sum " + name,
            lobe::sum{lobe::weighted{0.4, gloss(a, 0.6)}, lobe::weighted{0.6, gloss(0.8, 0.6)}, lobe::lambert{0.3}},
            mu);
        tests.of_lights("coated " + name,
                        lobe::coated(lobe::metallic_roughness(0.7, 0.2, alpha{0.5}), ggx{alpha{a}}, 1.0), mu);
        tests.of_lights("layered by fresnel " + name,
                        lobe::layered{gloss(a, 0.04), base, lobe::fresnel_coupling{lobe::schlick{0.04}}}, mu);
        tests.of_lights("layered by albedo " + name, lobe::layered{gloss(a, 0.04), base, lobe::albedo_coupling{some_E}},
                        mu);
        tests.of_lights("layered both ways " + name,
                        lobe::layered{gloss(a, 0.04), base, lobe::reciprocal_coupling{some_E, 0.25}}, mu);
    }
}

}  // namespace

TEST_CASE("a million samples of every sampler follow its pdf", "[sampling]") {
    all_tests tests;
    microfacets_of_ggx(tests);
    normals(tests);
    numeric_visible_normals(tests);
    flakes(tests);
    diffuse(tests);
    compositions(tests);
    // 1 % for all of them together (Sidak): of right samplers all pass in 99 of 100 choices of seeds
    const double threshold = 1 - std::pow(0.99, 1 / static_cast<double>(tests.results.size()));
    for (const auto& [name, is, error] : tests.results) {
        INFO(name << ": p " << is.p << " of " << is.degrees << " degrees; pdf integrates to " << is.integral
                  << ", successes " << is.success);
        CHECK(is.p > threshold);
        CHECK(is.degrees > 100);
        CHECK(is.integral < 1 + error);
    }
}

TEST_CASE("chi-squared of a million can see: a density that is 1 % off fails", "[sampling]") {
    const lobe::beckmann drawn{alpha{0.3}};
    const auto against = [&](const auto& stated) {
        return chi_squared(
                   bins({0.3, 0.3}, at(0.2), reach::seen),
                   [&](const vec2<double>& u) { return drawn.sample_visible(at(0.2), u); },
                   [&](const vec3<double>& m) { return stated.pdf_visible(at(0.2), m); }, 7)
            .p;
    };
    CHECK(against(drawn) > 1e-4);
    CHECK(against(lobe::beckmann{alpha{0.303}}) < 1e-4);
    CHECK(against(lobe::mixture{drawn, ggx{alpha{0.3}}, 0.02}) < 1e-4);
    // a roughness that is 3 % off: of the density, 1 %
    struct tilted : lobe::fon<double> {
        using fon::fon;
        double pdf(const vec3<double>& v, const vec3<double>& l) const { return lobe::fon{0.5, 0.97}.pdf(v, l); }
    };
    CHECK(light_directions(tilted(0.5, 1.0), at(0.2), 7).p < 1e-4);
    // visible normals drawn, bounded caps stated
    struct wrong : lobe::visible_normals {
        double area(const ggx<double>& ndf, const vec3<double>& v, double v_m, double m_z, double sv) const {
            return lobe::visible_bounded_caps{}.area(ndf, v, v_m, m_z, sv);
        }
    };
    CHECK(
        light_directions(
            lobe::microfacet{ggx{alpha{0.3}}, lobe::smith_correlated{}, lobe::perfect_reflector{}, wrong{}}, at(0.2), 7)
            .p < 1e-4);
}
