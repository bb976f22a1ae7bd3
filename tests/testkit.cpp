#include "catch.hpp"
#include "support.hpp"

#include <lobe/testkit.hpp>

#include <filesystem>
#include <memory>

using namespace lobe::testkit;
using lobe::vec2;
using lobe::vec3;

namespace {

constexpr double pi = 3.141592653589793;

/// An honest white BRDF, and what the tests change about it.
struct white {
    static constexpr bool isotropic = true;
    double factor = 1;
    double f_cos(const glm::dvec3& v, const glm::dvec3& l) const { return v.z > 0 && l.z > 0 ? factor * l.z / pi : 0; }
};

const check& the_check(const report& r, const std::string& property) {
    for (const check& c : r.checks())
        if (c.property == property) return c;
    throw std::runtime_error("no check " + property);
}

}  // namespace

TEST_CASE("the cubature is exact for polynomials of degree 7, and finds a peak it is told of", "[testkit]") {
    for (int p = 0; p <= 7; ++p)
        for (int q = 0; p + q <= 7; ++q) {
            const mesh<1> m([&](double x, double y) { return mesh<1>::values{std::pow(x, p) * std::pow(y, q)}; }, 2, 3,
                            1);
            mesh<1> summed = m;
            summed.refine(1, 1, 0);
            CHECK(summed.integral()[0] * (p + 1) * (q + 1) == Catch::Approx(1).epsilon(1e-13));
        }
    const double width = 1e-3;
    mesh<1> m(
        [&](double x, double y) {
            const double dx = (x - 0.3123) / width, dy = (y - 0.6) / width;
            return mesh<1>::values{std::exp(-dx * dx - dy * dy) / (pi * width * width)};
        },
        8, 16, 1);
    m.refine_at(0.3123, 0.6, 5);
    m.refine(1e-4, 1, 100000);
    CHECK(std::abs(m.integral()[0] - 1) < 1e-4);
    CHECK(std::abs(m.integral()[0] - 1) < m.error()[0]);

    // Every point is in the leaf that says so.
    random_numbers random(1);
    for (int i = 0; i < 1000; ++i) {
        const double x = random(), y = random();
        const auto& c = m.cells()[m.find(x, y)];
        CHECK((c.leaf() && x >= c.x0 && x <= c.x0 + c.width && y >= c.y0 && y <= c.y0 + c.height));
    }
}

TEST_CASE("charts cover the hemisphere once", "[testkit]") {
    random_numbers random(2);
    const auto verify_chart = [&](const auto& chart) {
        mesh<2> m(
            [&](double x, double y) {
                const auto p = chart(x, y);
                return mesh<2>::values{p.area, p.area * p.l.z};
            },
            8, 16, 2);
        m.refine(1e-6, 1, 1000000);
        CHECK(m.integral()[0] == Catch::Approx(2 * pi).epsilon(2e-6));
        CHECK(m.integral()[1] == Catch::Approx(pi).epsilon(2e-6));
        for (int i = 0; i < 1000; ++i) {
            const double x = random.between(0.2, 0.95), y = random();  // below, v + l cancels
            const auto back = chart.find(chart(x, y).l);
            CHECK(std::abs(back[0] - x) < 1e-9);
            CHECK(std::abs(std::remainder(back[1] - y, 1.0)) < 1e-9);
        }
    };
    for (const double mu : {1.0, 0.7, 0.1, 0.01})
        verify_chart(detail::half_vector_chart(detail::direction<double>(mu, 0.7)));
    verify_chart(detail::normal_chart{});
}

TEST_CASE("chi-squared: tail, merging, verdict", "[testkit]") {
    // Quantiles of the chi-squared distribution (NIST/SEMATECH e-Handbook, 1.3.6.7.4); Wilson & Hilferty are good to a
    // few percent there.
    CHECK(detail::chi_squared_tail(23.209, 10) == Catch::Approx(0.01).epsilon(0.03));
    CHECK(detail::chi_squared_tail(18.307, 10) == Catch::Approx(0.05).epsilon(0.03));
    CHECK(detail::chi_squared_tail(135.807, 100) == Catch::Approx(0.01).epsilon(0.03));
    const auto bins = detail::merged({{3, 2}, {4, 6}, {5, 5}, {1, 0}, {30, 31}, {2, 1}}, 10);
    REQUIRE(bins.size() == 2);
    CHECK(bins[0].expected == 12);
    CHECK(bins[0].observed == 13);
    CHECK(bins[1].expected == 33);
    CHECK(bins[1].observed == 32);
    random_numbers random(3);
    std::vector<detail::bin> fair(20, {500, 0}), skewed;
    for (int i = 0; i < 10000; ++i) ++fair[static_cast<std::size_t>(20 * random())].observed;
    CHECK(detail::chi_squared_probability(fair) > 0.001);
    skewed = fair;
    skewed[0].observed += 120;  // five standard deviations
    skewed[1].observed -= 120;
    CHECK(detail::chi_squared_probability(skewed) < 0.001);
}

TEST_CASE("discrepancies of sets that are known", "[testkit]") {
    // One point in the middle: int int (1[x>1/2] 1[y>1/2] - x y)^2 = 1/9 - 2 (3/8)^2 + 1/4 = 23/288.
    CHECK(detail::squared_l2_star_discrepancy({{0.5, 0.5}}) == Catch::Approx(23.0 / 288));
    CHECK(detail::star_discrepancy({0.5}) == Catch::Approx(0.5));
    std::vector<double> centred;
    for (int i = 0; i < 10; ++i) centred.push_back((i + 0.5) / 10);
    CHECK(detail::star_discrepancy(centred) == Catch::Approx(0.05));
}

TEST_CASE("a report says what, where, and what it means", "[testkit]") {
    options o;
    o.name = "white \"wall\"";
    o.lossless = true;
    const report good = verify(white{}, o);
    INFO(good);
    CHECK(good.passed());
    CHECK(good);
    CHECK(good.findings().empty());

    const report bad = verify(white{pi}, o);
    CHECK(!bad);
    const check& furnace = the_check(bad, "white furnace is 1");
    CHECK(!furnace.passed);
    CHECK(furnace.measured == Catch::Approx(pi).epsilon(1e-3));
    CHECK(furnace.expected == 1);
    CHECK(furnace.tolerance < 0.003);
    CHECK(furnace.meaning.find("missing 1/pi") != std::string::npos);
    CHECK(furnace.input.find("glm::dvec3 v{") == 0);
    CHECK(bad.findings().size() == 2);  // for a fixed view, and for a fixed light

    // A coloured wall without 1/pi: no furnace is off by pi, and yet.
    const auto paint = [](const glm::dvec3& v, const glm::dvec3& l) { return v.z > 0 && l.z > 0 ? 0.5 * l.z : 0.0; };
    CHECK(the_check(verify(paint), "white furnace is at most 1").meaning.find("missing 1/pi") != std::string::npos);

    // What Catch prints when REQUIRE(verify(...)) fails is the table.
    const std::string printed = Catch::Detail::stringify(bad);
    for (const char* part : {"FAILED", "white furnace is 1", "3.14159", "missing 1/pi", "glm::dvec3 v{"})
        CHECK(printed.find(part) != std::string::npos);

    const std::string json = bad.json();
    for (const char* part : {"\"subject\": \"white \\\"wall\\\"\"", "\"passed\": false",
                             "\"id\": \"white_furnace\", \"property\": \"white furnace is 1\""})
        CHECK(json.find(part) != std::string::npos);
    CHECK(std::count(json.begin(), json.end(), '{') == std::count(json.begin(), json.end(), '}'));
    CHECK(detail::json_number(std::nan("")) == "null");
    CHECK(detail::quoted("a\n\t\"\\") == "\"a\\u000a\\u0009\\\"\\\\\"");
}

TEST_CASE("inputs are printed with all their digits", "[testkit]") {
    CHECK(detail::literal(0.1f) == "0.100000001f");
    CHECK(detail::literal(1.0f) == "1.0f");
    CHECK(detail::literal(0.1) == "0.10000000000000001");
    CHECK(detail::literal(1e-40f) == "9.9999461e-41f");
    CHECK(detail::literal("v", vec3<float>(0, 0, 1)) == "glm::vec3 v{0.0f, 0.0f, 1.0f}; ");
}

TEST_CASE("a fixed seed gives one verdict", "[testkit]") {
    CHECK(verify(white{}).json() == verify(white{}).json());
    options other;
    other.seed = 2;
    CHECK(verify(white{}, other).passed());
}

TEST_CASE("scalar types: as the type says, else as the value returned", "[testkit]") {
    struct says {
        using scalar = float;
        double f_cos(glm::dvec3, glm::dvec3) const { return 0; }
    };
    const auto returns_float = [](glm::vec3, glm::vec3) { return 0.f; };
    const auto returns_double = [](glm::dvec3, glm::dvec3) { return glm::dvec3(0); };
    const auto generic = [](const auto& v, const auto&) { return v.z; };
    struct three {
        float r, g, b;
    };
    const auto own_spectrum = [](glm::vec3, glm::vec3) { return three{}; };
    const auto is = [](const auto& brdf, auto expected) {
        return std::is_same_v<decltype(detail::interface_of(brdf)), decltype(expected)>;
    };
    CHECK(is(says{}, detail::brdf_functions<float, 1>{}));
    CHECK(is(returns_float, detail::brdf_functions<float, 1>{}));
    CHECK(is(returns_double, detail::brdf_functions<double, 3>{}));
    CHECK(is(generic, detail::brdf_functions<double, 1>{}));
    CHECK(is(own_spectrum, detail::brdf_functions<float, 3>{}));
}

TEST_CASE("adapters: functions apart, without the cosine, in world space", "[testkit]") {
    const auto f = [](glm::vec3, glm::vec3) { return 0.8f / 3.14159265f; };
    CHECK(verify(with_cosine(f)).passed());
    CHECK(!verify(f).passed());  // f itself is no f_cos: it lacks the cosine, and does not vanish below

    const auto sample = [](glm::vec3, glm::vec2 u) {
        const float r = std::sqrt(u.x), phi = 6.28318531f * u.y, z = std::sqrt(1 - u.x);
        return sampled_light<float, float>{{r * std::cos(phi), r * std::sin(phi), z}, 0.8f, z / 3.14159265f};
    };
    const auto pdf = [](glm::vec3, glm::vec3 l) { return std::max(l.z, 0.f) / 3.14159265f; };
    const functions whole(with_cosine(f), sample, pdf);
    const report r = verify(whole);
    INFO(r);
    CHECK(r.passed());
    CHECK_NOTHROW(the_check(r, "samples follow the pdf (chi-squared)"));
    CHECK_NOTHROW(the_check(verify(functions(with_cosine(f), sample)), "mean weight = furnace"));
    CHECK_NOTHROW(the_check(verify(functions(with_cosine(f), no_sample{}, pdf)), "integral of the pdf is at most 1"));

    const auto coloured = [](glm::vec3, glm::vec3) { return glm::vec3(0.2f, 0.1f, 0.05f); };
    CHECK(verify(with_cosine(coloured)).passed());
    struct three {  // spectra that cannot be multiplied
        float r, g, b;
    };
    const auto own = [](float bright) {
        return with_cosine([=](glm::vec3, glm::vec3) { return three{0.2f, 0.1f, bright}; });
    };
    const auto array = [](double bright) {
        return with_cosine([=](glm::dvec3, glm::dvec3) { return std::array{0.2, bright}; });
    };
    CHECK(verify(own(0.3f)).passed());
    CHECK(!verify(own(0.4f)).passed());
    CHECK(verify(array(0.3)).passed());
    CHECK(!verify(array(0.4)).passed());

    // Any order of parameters; the wrong one is found.
    const auto lambert = [](glm::vec3 n, glm::vec3 l, glm::vec3 v) {
        return lobe::dot(n, v) > 0 ? std::max(lobe::dot(n, l), 0.f) * 0.8f / 3.14159265f : 0.f;
    };
    CHECK(verify(in_world<argument::n, argument::l, argument::v>(lambert)).passed());
    CHECK(!verify(in_world<argument::n, argument::v, argument::l>(lambert)).passed());
}

TEST_CASE("a sampler or a pdf that does not fit is not passed over", "[testkit]") {
    struct right {
        float f_cos(glm::vec3 v, glm::vec3 l) const { return v.z > 0 && l.z > 0 ? 0.2f * l.z : 0.f; }
    };
    struct no_u : right {
        sampled_light<float, float> sample(glm::vec3) const { return {}; }
    };
    struct a_pair : right {
        std::pair<glm::vec3, float> sample(glm::vec3, glm::vec2) const { return {}; }
    };
    struct not_const : right {
        sampled_light<float, float> sample(glm::vec3, glm::vec2) { return {}; }
    };
    struct pair_weight : right {
        sampled_light<std::pair<float, float>, float> sample(glm::vec3, glm::vec2) const { return {}; }
    };
    struct two_of_them : right {
        float sample(glm::vec3) const { return 0; }
        float sample(glm::vec2) const { return 0; }
    };
    struct vector_pdf : right {
        glm::vec3 pdf(glm::vec3, glm::vec3) const { return {}; }
    };
    const auto findings = [](const auto& b) {
        std::string names;
        for (const finding& f : verify(b).findings()) names += f.property + ";";
        return names;
    };
    CHECK(findings(right{}).empty());
    CHECK(findings(no_u{}) == "sample(v, u) can be called;");
    CHECK(findings(a_pair{}) == "sample(v, u) can be called;");
    CHECK(findings(not_const{}) == "sample(v, u) can be called;");
    CHECK(findings(two_of_them{}) == "sample(v, u) can be called;");
    CHECK(findings(vector_pdf{}) == "pdf(v, l) can be called;");
    CHECK(findings([](glm::vec3 v, glm::vec3 l) { return right{}.f_cos(v, l); }).empty());
    const auto f = [](glm::vec3 v, glm::vec3 l) { return right{}.f_cos(v, l); };
    CHECK(findings(functions(f, [](glm::vec3) { return glm::vec3(0, 0, 1); })) == "sample(v, u) can be called;");
    CHECK(findings(functions(f, no_sample{}, [](glm::vec3) { return 1; })) == "pdf(v, l) can be called;");
    CHECK(findings(functions(f)).empty());
    CHECK(findings(pair_weight{}) == "sample(v, u) can be called;");
}

TEST_CASE("samplers of two numbers, or of three", "[testkit]") {
    struct base {
        double f_cos(const glm::dvec3& v, const glm::dvec3& l) const { return v.z > 0 && l.z > 0 ? 0.5 * l.z / pi : 0; }
        double pdf(const glm::dvec3& v, const glm::dvec3& l) const { return v.z > 0 && l.z > 0 ? l.z / pi : 0; }
        static sampled_light<double, double> drawn(const glm::dvec3& v, double x, double y) {
            if (!(v.z > 0)) return {{0, 0, 1}, 0, 0};
            const double r = std::sqrt(x), z = std::sqrt(1 - x);
            return {{r * std::cos(2 * pi * y), r * std::sin(2 * pi * y), z}, 0.5, z / pi};
        }
    };
    struct two : base {
        auto sample(const glm::dvec3& v, const glm::dvec2& u) const { return drawn(v, u.x, u.y); }
    };
    struct three : base {  // the half of the azimuth by the third
        auto sample(const glm::dvec3& v, const glm::dvec3& u) const {
            return drawn(v, u.x, u.z < 0.3127 ? 0.3127 * u.y : 0.3127 + 0.6873 * u.y);
        }
    };
    struct both : base {  // the two are asked for, so the three may be wrong
        auto sample(const glm::dvec3& v, const glm::dvec2& u) const { return drawn(v, u.x, u.y); }
        auto sample(const glm::dvec3& v, const glm::dvec3& u) const { return drawn(v, u.z * u.x, u.y); }
    };
    struct wrong : base {
        auto sample(const glm::dvec3& v, const glm::dvec3& u) const { return drawn(v, u.x * u.z, u.y); }
    };
    CHECK(detail::interface_of(two{}).numbers == 2);
    CHECK(detail::interface_of(three{}).numbers == 3);
    CHECK(detail::interface_of(both{}).numbers == 2);
    for (const report& r : {verify(two{}), verify(three{}), verify(both{})}) {
        INFO(r);
        CHECK(r.passed());
        CHECK_NOTHROW(the_check(r, "samples follow the pdf (chi-squared)"));
    }
    const report r = verify(wrong{});
    CHECK(!the_check(r, "means of samples = means of the pdf").passed);
    CHECK(the_check(r, "means of samples = means of the pdf").id == id::pdf_of_samples.means);

    // What was drawn from is printed, three numbers of three.
    struct long_ones : base {
        auto sample(const glm::dvec3& v, const glm::dvec3& u) const {
            auto s = drawn(v, u.x, u.y);
            if (u.z > 0.9) s.l *= 1.01;
            return s;
        }
    };
    CHECK(the_check(verify(long_ones{}), "sampled directions are unit").input.find("glm::dvec3 u{") !=
          std::string::npos);
    const auto f = [](const glm::dvec3& v, const glm::dvec3& l) { return base{}.f_cos(v, l); };
    CHECK(verify(functions(f, [](const glm::dvec3& v, const glm::dvec3& u) { return three{}.sample(v, u); })).passed());
}

TEST_CASE("means over the numbers of a sampler, cut where it jumps", "[testkit]") {
    // 1 where the number is below p, else 3, times a smooth function of the others: int (1 + x) = 3/2.
    for (const double p : {0.0131, 0.1729, 0.5, 0.7137, 0.9973})
        for (int axis = 0; axis < 3; ++axis) {
            const auto first = [&](const glm::dvec3& u) { return u[axis] < p; };
            const detail::expectation<double> over_u(
                [&](const glm::dvec3& u) {
                    return std::optional(
                        detail::direction<double>(first(u) ? 0.5 : 0.25, 2 * pi * u[axis == 0 ? 1 : 0]));
                },
                3);
            const auto mean = over_u.of<1>(
                [&](const glm::dvec3& u) { return std::array{(first(u) ? 1.0 : 3.0) * (1 + u[axis == 0 ? 1 : 0])}; },
                detail::budget_of(effort::quick), 1, 1)(false);
            INFO("axis " << axis << ", p " << p);
            CHECK(mean.value[0] == Catch::Approx((p + 3 * (1 - p)) * 1.5).epsilon(1e-6));
            CHECK(mean.error[0] < 1e-4);
        }
    // A third number that changes everything: within its error. The plane z = x cuts fewer than 2 of 12 cubes, the
    // spread there is at most 1/2: 6 sqrt(2/12/4/(32 12^3)) = 5.2e-3.
    const auto moved = [](const glm::dvec3& u) { return std::optional(lobe::normalize(u + glm::dvec3(0, 0, 1))); };
    const detail::expectation<double> over_u(moved, 3);
    const auto value = [](const glm::dvec3& u) { return std::array{u.x * u.y * u.z + (u.z < u.x ? 1 : 0)}; };
    const auto mean = over_u.of<1>(value, detail::budget_of(effort::quick), 1, 1)(false);
    CHECK(std::abs(mean.value[0] - 0.625) < mean.error[0]);
    CHECK(mean.error[0] < 5.2e-3);
}

TEST_CASE("a tolerance that makes no sense is refused", "[testkit]") {
    for (const double senseless : {std::nan(""), -1e-3, 0.0, double(INFINITY)}) {
        options o;
        o.tolerance = senseless;
        for (const report& r : {verify(white{}, o), verify_fresnel([](double) { return 1.0; }, o),
                                verify_distribution([](const glm::dvec3& m) { return m.z > 0 ? 1 / pi : 0; }, o)}) {
            REQUIRE(r.findings().size() == 1);
            CHECK(r.findings()[0].property == "options.tolerance is above 0, and a number");
        }
    }
}

TEST_CASE("claims: isotropy, zero below, and what is not reciprocal", "[testkit]") {
    options o;
    const auto brushed = [](const glm::dvec3& v, const glm::dvec3& l) {
        return v.z > 0 && l.z > 0 ? l.z / pi * (1 - 0.5 * std::abs((v + l).x) / lobe::length(v + l)) : 0.0;
    };
    CHECK(verify(brushed, o).passed());
    o.isotropic = true;
    CHECK(!verify(brushed, o).passed());

    const auto two_sided_view = [](const glm::dvec3&, const glm::dvec3& l) { return std::max(l.z, 0.0) / pi; };
    o = {};
    CHECK(verify(two_sided_view, o).passed());
    o.zero_below = true;
    CHECK(!verify(two_sided_view, o).passed());

    const auto one_sided = [](const glm::dvec3& v, const glm::dvec3& l) {
        return v.z > 0 && l.z > 0 ? l.z / pi * (1 - 0.3 * v.z) : 0.0;
    };
    o = {};
    CHECK(!verify(one_sided, o).passed());
    o.reciprocal = false;
    CHECK(verify(one_sided, o).passed());
}

TEST_CASE("a function with a random generator inside is found", "[testkit]") {
    const auto noisy = [random = std::make_shared<random_numbers>(5)](const glm::dvec3& v, const glm::dvec3& l) {
        return v.z > 0 && l.z > 0 ? l.z / pi * (0.5 + 1e-4 * (*random)()) : 0.0;
    };
    CHECK(!the_check(verify(noisy), "the same input, the same value").passed);
}

TEST_CASE("the kit includes no model, and its rooms only what is below them", "[testkit]") {
    namespace fs = std::filesystem;
    const fs::path kit = fs::path(LOBE_REFERENCE_DIR) / "../../include/lobe/testkit";
    const std::vector<std::string> rooms{"measure", "subject", "verdict", "properties"};
    int files = 0;
    for (const auto& entry : fs::recursive_directory_iterator(kit)) {
        if (!entry.is_regular_file()) continue;
        ++files;
        const std::string room = fs::relative(entry.path(), kit).parent_path().string();
        const auto floor = std::find(rooms.begin(), rooms.end(), room);
        std::ifstream file(entry.path());
        int lines = 0;
        for (std::string line; std::getline(file, line); ++lines) {
            if (line.rfind("#include <lobe/", 0) != 0) continue;
            INFO(entry.path() << ": " << line);
            const bool of_kit = line.find("lobe/testkit/") != std::string::npos;
            CHECK((of_kit || line.find("lobe/core/") != std::string::npos));
            for (auto above = floor; above != rooms.end(); ++above)
                if (above != floor) CHECK(line.find("lobe/testkit/" + *above + "/") == std::string::npos);
            if (!room.empty()) CHECK(line.find("lobe/testkit/verify") == std::string::npos);
        }
        INFO(entry.path());
        CHECK(lines <= 250);
    }
    CHECK(files > 30);
}

TEST_CASE("Fresnel reflectances: right ones pass, each misprint has its finding", "[testkit]") {
    const auto power = [](double x, int n) {
        double p = 1;
        for (int i = 0; i < n; ++i) p *= x;
        return p;
    };
    CHECK(verify_fresnel([&](double u) { return 0.04 + 0.96 * power(1 - u, 5); }).passed());
    CHECK(verify_fresnel([](float u) {
              return glm::vec3(1.f, 0.7f, 0.3f) + glm::vec3(0.f, 0.3f, 0.7f) * std::pow(1 - u, 5.f);
          }).passed());

    const auto finding_of = [](const auto& f) {
        const auto all = verify_fresnel(f).findings();
        return all.empty() ? std::string() : all[0].property;
    };
    CHECK(finding_of([&](double u) { return 0.04 + 0.96 * (1 - power(u, 5)); }) == "F is flat at normal incidence");
    CHECK(finding_of([&](double u) { return 0.04 + 0.96 * power(u, 5); }) == "F at grazing is at least F at normal");
    CHECK(finding_of([&](double u) { return 0.04 + power(1 - u, 5); }) == "F is at most 1");
    CHECK(finding_of([&](double u) { return 0.04 - 0.1 * u * u; }) == "F is not negative");
    CHECK(finding_of([](double u) { return std::sqrt(u - 0.5) * 0; }) == "F is finite");
    struct wrong_average {
        double operator()(double u) const { return 0.04 + 0.96 * (1 - u) * (1 - u) * (1 - u) * (1 - u) * (1 - u); }
        double average() const { return 0.04 + 0.96 / 6; }  // without the cosine; right: / 21
    };
    CHECK(finding_of(wrong_average{}) == "average = 2 int F(u) u du");
    CHECK(finding_of([](double) -> double { throw std::runtime_error("no"); }) == "no exception");
}

TEST_CASE("point sets: right ones pass, each fault has its finding", "[testkit]") {
    const auto finding_of = [](const auto& points) {
        const auto all = verify_sequence(points).findings();
        return all.empty() ? std::string() : all[0].property;
    };
    const auto reversed = [](std::uint32_t i) {
        double x = 0, place = 0.5;
        for (; i; i >>= 1, place /= 2) x += (i & 1u) * place;
        return x;
    };
    std::vector<glm::dvec2> hammersley, last_is_1, diagonal, few_bits, random, golden;
    random_numbers numbers(4);
    for (std::uint32_t i = 0; i < 1000; ++i) {
        hammersley.push_back({i / 1000.0, reversed(i)});
        last_is_1.push_back({i / 999.0, reversed(i)});
        diagonal.push_back({i / 1000.0, i / 1000.0});
        few_bits.push_back({reversed(i & 127u), reversed(i & 127u)});
        random.push_back({numbers(), numbers()});
        golden.push_back({i / 1000.0, std::fmod(i * 0.6180339887498949, 1.0)});
    }
    CHECK(finding_of(hammersley).empty());
    CHECK(finding_of(golden).empty());
    CHECK(finding_of(last_is_1) == "points are in [0,1)");
    CHECK(finding_of(diagonal) == "discrepancy is below random");
    CHECK(finding_of(few_bits) == "points are distinct");
    CHECK(finding_of(random) == "x is evenly spread");
    CHECK(finding_of(std::vector<glm::vec2>(10)) == "at least 64 points");
    options o;
    o.low_discrepancy = false;
    CHECK(verify_sequence(random, o).passed());
}

TEST_CASE("distributions of normals: right ones pass, each misprint has its finding", "[testkit]") {
    const double a = 0.3;
    const auto finding_of = [](const auto& D) {
        const auto all = verify_distribution(D).findings();
        return all.empty() ? std::string() : all[0].property;
    };
    const auto ggx = [a](const glm::dvec3& m) {
        const double d = m.x * m.x + m.y * m.y + a * a * m.z * m.z;
        return m.z > 0 ? a * a / (pi * d * d) : 0;
    };
    const auto not_squared = [a](const glm::dvec3& m) {
        return m.z > 0 ? a * a / (pi * (m.z * m.z * (a * a - 1) + 1)) : 0;
    };
    const auto blinn = [](double n) {
        return [n](const glm::dvec3& m) { return m.z >= 0 ? (n + 2) / (2 * pi) * std::pow(m.z, n) : 0; };
    };
    const auto both_sides = [a](const glm::dvec3& m) {
        const double d = m.z * m.z * (a * a - 1) + 1;
        return a * a / (pi * d * d);
    };
    CHECK(finding_of(ggx).empty());
    CHECK(finding_of(not_squared) == "integral of D cos(theta) = 1");
    CHECK(finding_of([&](const glm::dvec3& m) { return 1.005 * ggx(m); }) == "integral of D cos(theta) = 1");
    CHECK(finding_of(blinn(2 / (a * a) - 2)).empty());
    // integrates to 1, and grows without bound to the horizon
    CHECK(finding_of(blinn(2 * a * a - 2)) == "D is finite");
    CHECK(finding_of(both_sides) == "D vanishes below");

    // With the masking of another width, or a sampler of another.
    struct masked {
        double a, width;
        double D(const glm::dvec3& m) const {
            const double d = m.x * m.x + m.y * m.y + a * a * m.z * m.z;
            return m.z > 0 ? a * a / (pi * d * d) : 0;
        }
        double lambda(const glm::dvec3& w) const {
            return (std::sqrt(1 + width * width * (w.x * w.x + w.y * w.y) / (w.z * w.z)) - 1) / 2;
        }
        glm::dvec3 sample(const glm::dvec2& u) const {
            const double t2 = a * a * u.x / (1 - u.x), c = 1 / std::sqrt(1 + t2), s = c * std::sqrt(t2);
            return {s * std::cos(2 * pi * u.y), s * std::sin(2 * pi * u.y), c};
        }
    };
    const report right = verify_distribution(masked{a, a});
    INFO(right);
    CHECK(right.passed());
    CHECK(finding_of(masked{a, 1.02 * a}) == "projected area = integral of max(0, v.m) D");
    struct wide_sampler : masked {
        glm::dvec3 sample(const glm::dvec2& u) const { return masked{1.01 * a, a}.sample(u); }
    };
    CHECK(finding_of(wide_sampler{{a, a}}) == "means of normals = means of the pdf");
}
