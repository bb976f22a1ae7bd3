// The recipes of docs/integrate.md, whose code is this code.
#include "catch.hpp"
#include "integrate/batches.hpp"
#include "support.hpp"

#include <glm/common.hpp>
#include <glm/exponential.hpp>

#include <filesystem>
#include <map>
#include <variant>

using glm::vec2;
using glm::vec3;

namespace {

// [variant]
auto metal(const vec3& F0, float roughness) {
    const auto a = lobe::alpha<float>::from_roughness(roughness, 1e-3f);
    return lobe::microfacet{lobe::ggx{a}, lobe::smith_correlated{}, lobe::schlick{F0}};
}
auto plastic(const vec3& colour, float roughness) { return lobe::metallic_roughness(colour, 0.0f, roughness, 1e-3f); }

using surface = std::variant<lobe::lambert<vec3>, decltype(metal({}, 1)), decltype(plastic({}, 1))>;

auto evaluate(const surface& s, const vec3& v, const vec3& l) {
    return std::visit([&](const auto& brdf) { return brdf.evaluate(v, l); }, s);
}
auto sample(const surface& s, const vec3& v, const vec2& u) {
    return std::visit([&](const auto& brdf) { return brdf.sample(v, u); }, s);
}
// [end]

// [switch]
enum class kind { matte, metal, plastic };
struct material {
    kind is;
    vec3 colour;
    float roughness;
};

/// Calls `use` with the BRDF of a material, composed here: two or three numbers, no allocation.
template <class Use>
auto with_brdf(const material& m, const Use& use) {
    switch (m.is) {
        case kind::metal: return use(metal(m.colour, m.roughness));
        case kind::plastic: return use(plastic(m.colour, m.roughness));
        case kind::matte: break;
    }
    return use(lobe::lambert{m.colour});
}

vec3 lit(const std::vector<material>& materials, std::size_t index, const vec3& v, const vec3& l) {
    return with_brdf(materials[index], [&](const auto& brdf) { return brdf.f_cos(v, l); });
}
// [end]

// [textures]
struct texels {
    vec3 colour;  // linear, filtered: may overshoot
    float metallic, roughness;
};
auto brdf_at(const texels& t) {
    const vec3 colour = glm::clamp(t.colour, 0.0f, 1.0f);
    const float metallic = glm::clamp(t.metallic, 0.0f, 1.0f);
    return lobe::metallic_roughness(colour, metallic, t.roughness, 1e-3f);  // alpha = max(roughness^2, 1e-3)
}
// [end]

// [two sides]
/// The frame of the side that the viewer sees. For what reflects; glass wants the outside normal, always.
lobe::frame<float> facing(const vec3& n, const vec3& V) { return lobe::frame<float>{lobe::dot(n, V) < 0 ? -n : n}; }
// [end]

// [normal map]
/// A view and lights in the frame of a mapped normal that never sees what the true surface hides.
struct mapped {
    lobe::frame<float> at;
    vec3 v, g;  // the view, and the true normal: tangent space

    mapped(const vec3& map_normal, const vec3& true_normal, const vec3& V)
        : at(map_normal), v(lobe::bend_above_horizon(at.to_local(V), 1e-3f)), g(at.to_local(true_normal)) {}

    template <class B>
    vec3 f_cos(const B& brdf, const vec3& L) const {
        const vec3 l = at.to_local(L);
        return brdf.f_cos(v, l) * lobe::bump_shadowing(g, l);
    }
    template <class B>
    auto sample(const B& brdf, const vec2& u) const {
        auto s = brdf.sample(v, u);
        s.weight = s.weight * lobe::bump_shadowing(g, s.l);  // 0 below the true surface: the path ends
        return s;
    }
};
// [end]

// [mirror]
/// What a path asks for. A mirror has no density: pdf is 0, `discrete` says so, and nothing is to be evaluated.
struct bounce {
    vec3 l, weight;
    float pdf;
    bool discrete;
};

template <class B>
bounce next(const B& brdf, const vec3& v, const vec2& u) {
    if constexpr (lobe::samplable_brdf<B>) {
        const auto s = brdf.sample(v, u);
        return {s.l, s.weight, s.pdf, false};
    } else {
        const auto s = brdf.sample(v);  // lobe::mirror
        return {s.l, s.weight, 0, true};
    }
}
template <class B>
lobe::evaluation<vec3, float> seen(const B& brdf, const vec3& v, const vec3& l) {
    if constexpr (lobe::samplable_brdf<B>)
        return brdf.evaluate(v, l);
    else
        return {vec3{0}, 0};
}

/// The share of a light that the ray of a bounce found (balance heuristic); that of one drawn from the light is 1
/// less the same.
float share(const bounce& b, float light_pdf) { return b.discrete ? 1 : b.pdf / (b.pdf + light_pdf); }
// [end]

// [arrays]
/// No BRDF has a default: a width of 0, or of 1, would be a material that nobody asked for.
static_assert(!std::is_default_constructible_v<decltype(metal({}, 1))>);
static_assert(std::is_default_constructible_v<surface> == std::is_default_constructible_v<lobe::lambert<vec3>>);

/// Sized at once with a BRDF of your own, or with nothing:
std::vector<lobe::lambert<vec3>> of_one(std::size_t size) { return {size, lobe::lambert{vec3{0.5f}}}; }
using surface_or_none = std::variant<std::monostate, lobe::lambert<vec3>, decltype(metal({}, 1))>;
std::array<surface_or_none, 16> none_yet() { return {}; }
/// Values like any other: assigned, copied by bytes.
static_assert(std::is_trivially_copyable_v<decltype(metal({}, 1))> && sizeof(metal({}, 1)) == 16);
// [end]

const std::vector<material> materials{{kind::matte, vec3{0.8f, 0.5f, 0.3f}, 0},
                                      {kind::metal, vec3{1.0f, 0.71f, 0.29f}, 0.3f},
                                      {kind::plastic, vec3{0.1f, 0.4f, 0.7f}, 0.5f}};
surface surface_of(const material& m) {
    return with_brdf(m, [](const auto& brdf) { return surface{brdf}; });
}

bool same(const vec3& a, const vec3& b) { return a.x == b.x && a.y == b.y && a.z == b.z; }
bool near_to(const vec3& a, const vec3& b, float tolerance) {
    return lobe::length(a - b) <= tolerance * (1e-6f + lobe::length(b));
}

// [glass]
/// A path meets glass: where it goes on, with its throughput; s.pdf == 0: it ends, and the weight is 0.
template <class Glass>
vec3 onward(const Glass& glass, const vec3& outside_normal, const vec3& ray, const vec3& u, float& throughput,
            bool& inside) {
    const lobe::frame at{outside_normal};
    const auto s = glass.sample(at.to_local(-ray), u);  // u.z chooses between reflection and refraction
    throughput *= s.weight;
    inside = s.l.z < 0;  // the medium that the next segment crosses
    return at.to_world(s.l);
}

/// What comes from a light, e.f_cos, which holds |cos|; e.pdf is for multiple importance sampling.
template <class Glass>
auto lit(const Glass& glass, const vec3& outside_normal, const vec3& ray, const vec3& light) {
    const lobe::frame at{outside_normal};
    return glass.evaluate(at.to_local(-ray), at.to_local(light));
}

/// What a segment inside lets through: Beer's law, absorption in 1/length.
vec3 let_through(const vec3& absorption, float distance) { return glm::exp(-absorption * distance); }
// [end]

}  // namespace

TEST_CASE("a variant and a switch give what the BRDF itself gives", "[integrate]") {
    random_numbers random(1);
    for (int i = 0; i < 1000; ++i) {
        const vec3 v = random.grazing_direction<float>(0.01), l = random.direction<float>();
        const vec2 u{random() * 0.999, random() * 0.999};
        for (std::size_t m = 0; m < materials.size(); ++m) {
            const surface s = surface_of(materials[m]);
            REQUIRE(s.index() == m);
            const vec3 alone = with_brdf(materials[m], [&](const auto& brdf) { return brdf.evaluate(v, l).f_cos; });
            CHECK(same(evaluate(s, v, l).f_cos, alone));
            CHECK(near_to(lit(materials, m, v, l), alone, 1e-5f));  // f_cos, rounded by itself
            const auto drawn = sample(s, v, u);
            if (drawn.pdf > 0) {
                const auto e = evaluate(s, v, drawn.l);
                CHECK(near_to(drawn.weight * drawn.pdf, e.f_cos, 1e-3f));
            }
        }
    }
}

TEST_CASE("hits in batches are shaded as they are one by one", "[integrate]") {
    random_numbers random(2);
    std::map<std::size_t, batches::batch> of_material;
    std::vector<std::pair<vec3, vec3>> hits;
    for (std::uint32_t pixel = 0; pixel < 1000; ++pixel) {
        const vec3 v = random.grazing_direction<float>(0.01), l = random.direction<float>();
        batches::batch& to = of_material[pixel % 3];
        to.vx[to.count] = v.x, to.vy[to.count] = v.y, to.vz[to.count] = v.z;
        to.lx[to.count] = l.x, to.ly[to.count] = l.y, to.lz[to.count] = l.z;
        to.roughness[to.count] = static_cast<float>(random()), to.F0[to.count] = static_cast<float>(random());
        to.pixel[to.count++] = pixel;
        hits.emplace_back(v, l);
    }
    float worst = 0, worst_textured = 0;
    for (auto& [m, of] : of_material) {
        REQUIRE(of.count > 300);
        with_brdf(materials[m], [&batch = of](const auto& brdf) { batches::shade(brdf, batch); });
        for (std::size_t i = 0; i < of.count; ++i) {
            const auto& [v, l] = hits[of.pixel[i]];
            const vec3 one = lit(materials, m, v, l), f{of.r[i], of.g[i], of.b[i]};
            worst = larger(worst, lobe::length(f - one) / (lobe::length(one) + 1e-20f));
        }
        batches::shade_textured(of);
        for (std::size_t i = 0; i < of.count; ++i) {
            const auto& [v, l] = hits[of.pixel[i]];
            const float one = metal(vec3{of.F0[i]}, of.roughness[i]).f_cos(v, l).y;
            worst_textured = larger(worst_textured, std::abs(of.g[i] - one) / (one + 1e-20f));
        }
    }
    INFO("constant " << worst << ", textured " << worst_textured);
    CHECK(worst <= 2e-6f);
    CHECK(worst_textured <= 2e-6f);
}

TEST_CASE("texels that are 0 or overshoot make a BRDF", "[integrate]") {
    const vec3 v = lobe::normalize(vec3{0.6f, 0, 0.8f}), mirrored{-v.x, -v.y, v.z};
    for (const texels& t : {texels{vec3{0}, 0, 0}, texels{vec3{1.02f, -0.01f, 0.5f}, 1.01f, 0},
                            texels{vec3{1}, -0.01f, 1}, texels{vec3{0.5f}, 0.5f, 0.02f}}) {
        const vec3 f = brdf_at(t).f_cos(v, mirrored);
        CHECK((f.x >= 0 && f.y >= 0 && f.z >= 0 && f.x + f.y + f.z > 0));
        CHECK(std::isfinite(f.x + f.y + f.z));
    }
    CHECK(aborts([] { lobe::metallic_roughness(vec3{1.02f}, 1.0f, 0.5f, 1e-3f); }));
}

TEST_CASE("a sheet looks the same from its two sides", "[integrate]") {
    random_numbers random(3);
    const auto brdf = metal(vec3{1, 0.7f, 0.3f}, 0.4f);
    int seen_from_both = 0;
    for (int i = 0; i < 1000; ++i) {
        const vec3 n = random.direction<float>(), V = random.direction<float>(), L = random.direction<float>();
        const auto front = facing(n, V), turned = facing(-n, V);
        CHECK(front.to_local(V).z >= 0);
        const vec3 f = brdf.f_cos(front.to_local(V), front.to_local(L));
        CHECK(near_to(f, brdf.f_cos(turned.to_local(V), turned.to_local(L)), 1e-4f));
        seen_from_both += f.x > 0;
    }
    CHECK(seen_from_both > 400);
}

TEST_CASE("a normal map sees no light from below the true surface and is black nowhere in sight", "[integrate]") {
    random_numbers random(4);
    const auto brdf = metal(vec3{1}, 0.4f);
    const vec3 n{0, 0, 1};
    int bent = 0, hidden = 0, kept = 0;
    for (int i = 0; i < 3000; ++i) {
        const vec3 V = random.grazing_direction<float>(1e-3), L = random.direction<float>();
        const vec3 m = random.grazing_direction<float>(0.5);
        const mapped at(m, n, V);
        bent += lobe::dot(m, V) <= 0;
        const vec3 f = at.f_cos(brdf, L);
        CHECK((f.x >= 0 && std::isfinite(f.x)));
        if (L.z < -1e-6f && lobe::dot(m, L) > 0) {
            ++hidden;
            CHECK(f.x == 0);
        }
        // the mirror direction of the bent view is always lit by the mapped normal alone
        CHECK(brdf.f_cos(at.v, {-at.v.x, -at.v.y, at.v.z}).x > 0);
        const auto s = at.sample(brdf, {random() * 0.999, random() * 0.999});
        CHECK((s.weight.x >= 0 && s.weight.x <= 1.001f));
        if (at.at.to_world(s.l).z < -1e-6f) CHECK(s.weight.x == 0);
        kept += s.weight.x > 0;
    }
    CHECK((bent > 100 && hidden > 100 && kept > 1000));
}

TEST_CASE("a mirror beside rough surfaces: light is counted once", "[integrate]") {
    // in a white furnace, light drawn uniformly and by the surface: the sum is the albedo, that of the mirror F(v)
    const vec3 v = lobe::normalize(vec3{0.6f, 0, 0.8f});
    const auto radiance = [&](const auto& brdf) {
        random_numbers random(5);
        double sum = 0;
        const int samples = 20000;
        const float light_pdf = 1 / (4 * 3.14159265f);
        for (int i = 0; i < samples; ++i) {
            const bounce b = next(brdf, v, {random() * 0.9999, random() * 0.9999});
            if (b.discrete || b.pdf > 0) sum += static_cast<double>(b.weight.y * share(b, light_pdf));
            const vec3 l = random.direction<float>();
            const auto e = seen(brdf, v, l);
            if (e.pdf > 0)
                sum += static_cast<double>(e.f_cos.y / light_pdf * (1 - share({l, vec3{1}, e.pdf, false}, light_pdf)));
        }
        return sum / samples;
    };
    const lobe::schlick F{vec3{1, 0.7f, 0.3f}};
    CHECK(radiance(lobe::mirror{F}) == Catch::Approx(F(v.z).y).epsilon(1e-5));
    CHECK(radiance(lobe::lambert{vec3{0.6f}}) == Catch::Approx(0.6).epsilon(0.02));
    const auto rough = metal(vec3{1, 0.7f, 0.3f}, 0.5f);
    CHECK(radiance(rough) == Catch::Approx(lobe::directional_albedo(rough, v.z).value.y).epsilon(0.02));
}

TEST_CASE("arrays of BRDFs begin with a BRDF of one's own or with none", "[integrate]") {
    const auto matte = of_one(3);
    CHECK((matte.size() == 3 && matte[2].f_cos({0, 0, 1}, {0, 0, 1}).x == Catch::Approx(0.5 / 3.14159265)));
    auto table = none_yet();
    CHECK(table[5].index() == 0);
    table[5] = metal(vec3{1}, 0.5f);
    CHECK(std::get<2>(table[5]).f_cos({0, 0, 1}, {0, 0, 1}).x > 0);
}

TEST_CASE("a path through glass carries what the interface reflects and lets through", "[integrate]") {
    const auto normal = lobe::normalize(vec3{0.3f, -0.5f, 0.8f});
    const lobe::rough_dielectric glass{lobe::ggx{lobe::alpha{0.4f}}, lobe::smith_joint{}, 1.5f};
    const lobe::frame at{normal};
    random_numbers random(5);
    for (const vec3 v : {vec3{0.6f, 0, 0.8f}, vec3{0.6f, 0, -0.8f}}) {
        const auto expected = lobe::directional_albedo(glass, v);
        double sum[2] = {0, 0}, squares[2] = {0, 0}, off = 0;
        const int paths = 40000;
        for (int i = 0; i < paths; ++i) {
            float throughput = 1;
            bool inside = false;
            const vec3 u{random(), random(), random()}, ray = -at.to_world(v);
            const vec3 l = onward(glass, normal, ray, u, throughput, inside);
            if (!(throughput > 0)) continue;
            off = larger(off, static_cast<double>(lobe::length(l)) - 1);
            CHECK(inside == (lobe::dot(l, normal) < 0));
            const bool crossed = inside == (v.z > 0);
            const auto weight = static_cast<double>(throughput);
            sum[crossed] += weight / paths;
            squares[crossed] += weight * weight / paths;
            const auto e = lit(glass, normal, ray, l);
            CHECK(e.f_cos == Catch::Approx(throughput * e.pdf).epsilon(1e-3).margin(1e-4));
        }
        CHECK(off < 1e-6);
        const double truth[2] = {static_cast<double>(expected.reflected.value),
                                 static_cast<double>(expected.transmitted.value)};
        for (int side = 0; side < 2; ++side) {
            INFO(sum[side] << " for " << truth[side]);
            CHECK(std::abs(sum[side] - truth[side]) < 4.5 * std::sqrt((squares[side] - sum[side] * sum[side]) / paths));
        }
    }
    CHECK(let_through(vec3{1, 2, 0}, 0.5f).y == Catch::Approx(std::exp(-1.0)));
}

TEST_CASE("docs/integrate.md and docs/glass.md have the recipes that are tested and no others", "[integrate]") {
    const std::filesystem::path root = std::filesystem::path(LOBE_REFERENCE_DIR) / "../..";
    /// The lines between `begin` and the next `end`, block by block.
    const auto blocks = [&](const char* path, const std::string& begin, const std::string& end) {
        std::ifstream file(root / path);
        std::vector<std::string> found;
        bool inside = false;
        for (std::string line; std::getline(file, line);)
            if (inside && line == end)
                inside = false;
            else if (inside)
                found.back() += line + "\n";
            else if (line.starts_with(begin))
                inside = true, found.emplace_back();
        return found;
    };
    auto tested = blocks("tests/integrate.cpp", "// [", "// [end]");
    const auto more = blocks("tests/integrate/batches.hpp", "// [", "// [end]");
    tested.insert(tested.end(), more.begin(), more.end());
    auto shown = blocks("docs/integrate.md", "```cpp", "```");
    const auto glass = blocks("docs/glass.md", "```cpp", "```");
    shown.insert(shown.end(), glass.begin(), glass.end());
    REQUIRE(tested.size() == 9);
    std::sort(tested.begin(), tested.end());
    std::sort(shown.begin(), shown.end());
    REQUIRE(shown.size() == tested.size());
    for (std::size_t i = 0; i < shown.size(); ++i) CHECK(shown[i] == tested[i]);
}
