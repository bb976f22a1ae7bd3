// What recording keeps, drops and folds, and how it is written.
#include "../catch.hpp"

#include <lobe/lobe.hpp>
#include <lobe/shader.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>

namespace shader = lobe::shader;
using shader::real;

namespace {

struct material {
    shader::vec3 base_color;
    real roughness;
};

template <class R, class A>
std::string text(const shader::recorded<R, A>& f, const shader::language& to = shader::glsl()) {
    shader::file file;
    return file.add(f).print(to);
}

/// How often a word occurs.
int count(const std::string& in, const std::string& word) {
    int n = 0;
    for (std::size_t at = in.find(word); at != std::string::npos; at = in.find(word, at + 1)) ++n;
    return n;
}

}  // namespace

template <>
struct lobe::shader::members<material> {
    static constexpr auto name = "material";
    static constexpr std::tuple fields{field{"base_color", &material::base_color},
                                       field{"roughness", &material::roughness}};
};

TEST_CASE("what is computed twice is written once, what nobody needs not at all", "[shader]") {
    const std::string s = text(shader::function("f", {"x", "y"}, [](real x, real y) {
        [[maybe_unused]] const real dead = exp(x) + tanh(y);
        return sqrt(x * y) + x * y / sqrt(x * y);
    }));
    CHECK(count(s, "x * y") == 1);
    CHECK(count(s, "sqrt") == 1);
    CHECK(count(s, "exp") + count(s, "tanh") == 0);
}

TEST_CASE("constants fold where no bit changes", "[shader]") {
    const auto one = [](auto f) { return text(shader::function("f", {"x"}, f)); };
    CHECK(count(one([](real x) { return x * real(1) - real(0) + real(2) * real(3); }), "return x + 6.0;") == 1);
    CHECK(count(one([](real x) { return x / real(8); }), "return x * 0.125;") == 1);
    CHECK(count(one([](real x) { return x / real(3); }), "return x / 3.0;") == 1);  // x * 0.33333334 rounds otherwise
    CHECK(count(one([](real x) { return x + real(0); }), "return x + 0.0;") == 1);  // -0 becomes 0
    CHECK(count(one([](real x) { return x * real(0); }), "return x * 0.0;") == 1);  // of infinity it is a NaN
    CHECK(count(one([](real x) { return -(-x); }), "return x;") == 1);
    CHECK(count(one([](real x) { return lobe::larger(x, real(0.1f)); }), "return max(x, 0.1);") == 1);
    CHECK(count(one([](real x) { return lobe::smaller(real(1e-20f), x); }), "return min(1e-20, x);") == 1);
    CHECK(count(one([](real x) { return lobe::quotient(x > real(0), real(1), x); }),
                "return x > 0.0 ? 1.0 / x : 0.0;") == 1);
}

TEST_CASE("operations keep the order in which they round", "[shader]") {
    const auto three = [](auto f) { return text(shader::function("f", {"a", "b", "c"}, f)); };
    CHECK(count(three([](real a, real b, real c) { return a + (b + c); }), "return a + (b + c);") == 1);
    CHECK(count(three([](real a, real b, real c) { return a + b + c; }), "return a + b + c;") == 1);
    CHECK(count(three([](real a, real b, real c) { return a / (b * c); }), "return a / (b * c);") == 1);
    CHECK(count(three([](real a, real b, real c) { return (a - b) * -c; }), "return (a - b) * -c;") == 1);
    CHECK(count(three([](real a, real b, real c) { return a - (b - c); }), "return a - (b - c);") == 1);
    const std::string mixed =
        text(shader::function("f", {"a", "b", "c"},
                              [](real a, real b, real c) { return select(a < b && (b < c || c < a), a, b); }),
             shader::wgsl());
    CHECK(count(mixed, "return select(b, a, a < b && (b < c || c < a));") == 1);
}

TEST_CASE("three equal operations are one of vectors, and products summed are dot", "[shader]") {
    const std::string s =
        text(shader::function("f", {"v", "l", "F0"}, [](shader::vec3 v, shader::vec3 l, shader::vec3 F0) {
            return lobe::schlick{F0}(lobe::length(shader::vec3(v + l)) / real(2));
        }));
    CHECK(count(s, "vec3 w1 = v + l;") == 1);
    CHECK(count(s, "dot(w1, w1)") == 1);
    CHECK(count(s, "return F0 + (1.0 - F0) * ") == 1);
}

TEST_CASE("names are the author's, and nobody's reserved words", "[shader]") {
    const auto f = shader::function("f", {"sample", "x"}, [](real s, real x) {
        const real alpha = named("alpha", x * x), again = named("alpha", s * s);
        return alpha + again;
    });
    CHECK(count(text(f), "float alpha = x * x;") == 1);
    CHECK(count(text(f), "float alpha_2 = sample_ * sample_;") == 1);
    CHECK_THROWS_WITH(text(shader::function("sample", {"x"}, [](real x) { return x; })),
                      "sample is a word of GLSL: choose another name for the function");
}

TEST_CASE("functions call functions, and take structs", "[shader]") {
    const auto alpha = shader::function("alpha_of", {"r"}, [](real r) { return r * r; });
    const auto f = shader::function("shade", {"v", "l", "m"}, [&](shader::vec3 v, shader::vec3 l, material m) {
        const lobe::alpha<real> a(alpha(m.roughness));
        return lobe::microfacet{lobe::ggx{a}, lobe::smith_correlated{}, lobe::schlick{m.base_color}}.evaluate(v, l);
    });
    const std::string s = text(f);
    CHECK(count(s, "alpha_of(m.roughness)") == 1);
    CHECK(s.find("float alpha_of(float r)") < s.find("evaluation3 shade(vec3 v, vec3 l, material m)"));
    CHECK(count(s, "struct material {") == 1);
    CHECK(count(s, "m.base_color + (1.0 - m.base_color) * ") == 1);
    CHECK_THROWS_WITH(shader::function("g", {"x"}, [&](real x) { return x * alpha(real(3)); }),
                      "alpha_of: called with constants alone; compute that on the host");
}

TEST_CASE("a table as a texture is the table", "[shader]") {
    const shader::dfg terms("table", lobe::default_dfg{});
    const auto texels = shader::dfg_texels_of(lobe::default_dfg{});
    const int n = terms.nodes();
    REQUIRE(texels.size() == 1024);
    double worst = 0;
    for (float mu = 0.001f; mu < 1; mu += 0.0173f)
        for (float a = 0.001f; a < 1; a += 0.0191f) {
            const lobe::alpha<real> width{real(a)};
            const shader::vec2 uv = terms.uv(real(mu), width);
            const float x = uv.x.number() * float(n) - 0.5f, y = uv.y.number() * float(n) - 0.5f;  // as samplers do
            const int i = std::clamp(int(x), 0, n - 2), j = std::clamp(int(y), 0, n - 2);
            const auto at = [&](int c, int r) { return texels[std::size_t(r * n + c)]; };
            const float s = x - float(i), t = y - float(j);
            const glm::vec2 texel =
                (at(i, j) * (1 - s) + at(i + 1, j) * s) * (1 - t) + (at(i, j + 1) * (1 - s) + at(i + 1, j + 1) * s) * t;
            const auto found = terms.of_texel(real(mu), width, {real(texel.x), real(texel.y)});
            const auto wanted = lobe::default_dfg{}(mu, lobe::alpha<float>(a));
            worst = std::max({worst, std::abs(double(found.scale.number() - wanted.scale)),
                              std::abs(double(found.bias.number() - wanted.bias))});
        }
    CHECK(worst < 1e-6);
}

TEST_CASE("a literal reads back to the same bits", "[shader]") {
    for (const float x : {0.1f, 1.0f / 3, 1e-38f, 3.4028235e38f, 0x1p-60f, 16777216.0f, 1.17549435e-38f, 6.2831855f}) {
        const std::string s = shader::detail::literal(x, "f");
        CHECK(std::strtof(s.c_str(), nullptr) == x);
        CHECK(std::strtod(s.c_str(), nullptr) <= 3.4028234663852886e38);  // WGSL: not above the largest float
        CHECK(s.find_first_of(".e") != std::string::npos);
    }
    CHECK(shader::detail::literal(0.1f, "") == "0.1");
    CHECK(shader::detail::literal(2, "f") == "2.0f");
}
