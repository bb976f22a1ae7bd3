// The recipes of docs/verify.md, word for word, against stand-ins for the interfaces of other renderers.
#include "catch.hpp"
#include "support.hpp"

#include <lobe/testkit.hpp>

#include <optional>
#include <tuple>

namespace {

/// What each stand-in computes: grey Lambert of the albedo, with cosine sampling.
constexpr float inv_pi = 0.318309886f;
glm::vec3 cosine_direction(float x, float y) {
    const float r = std::sqrt(x), phi = 6.28318531f * y;
    return {r * std::cos(phi), r * std::sin(phi), std::sqrt(1 - x)};
}

namespace pbrt {
struct Vector3f {
    float x, y, z;
};
struct Point2f {
    float x, y;
};
struct SampledSpectrum {
    float value;
    float operator[](int) const { return value; }
};
enum class TransportMode { Radiance };
struct BSDFSample {
    SampledSpectrum f;
    Vector3f wi;
    float pdf;
};
struct BxDF {
    float albedo;
    SampledSpectrum f(Vector3f wo, Vector3f wi, TransportMode) const { return {wo.z * wi.z > 0 ? albedo * inv_pi : 0}; }
    std::optional<BSDFSample> Sample_f(Vector3f wo, float, Point2f u, TransportMode) const {
        glm::vec3 wi = cosine_direction(u.x, u.y);
        if (wo.z < 0) wi.z = -wi.z;
        return BSDFSample{{albedo * inv_pi}, {wi.x, wi.y, wi.z}, std::abs(wi.z) * inv_pi};
    }
    float PDF(Vector3f wo, Vector3f wi, TransportMode) const { return wo.z * wi.z > 0 ? std::abs(wi.z) * inv_pi : 0; }
};
}  // namespace pbrt

namespace mitsuba {
struct Vector3f {
    float v[3];
    float x() const { return v[0]; }
    float y() const { return v[1]; }
    float z() const { return v[2]; }
};
using Spectrum = std::array<float, 3>;
struct SurfaceInteraction3f {
    Vector3f wi;
};
struct BSDFContext {};
struct BSDFSample3f {
    Vector3f wo;
    float pdf;
};
namespace dr {
template <class T>
T zeros() {
    return {};
}
}  // namespace dr
struct BSDF {
    float albedo;
    Spectrum eval(const BSDFContext&, const SurfaceInteraction3f& si, const Vector3f& wo) const {
        const float f = si.wi.z() > 0 && wo.z() > 0 ? albedo * inv_pi * wo.z() : 0;
        return {f, f, f};
    }
    float pdf(const BSDFContext&, const SurfaceInteraction3f& si, const Vector3f& wo) const {
        return si.wi.z() > 0 && wo.z() > 0 ? inv_pi * wo.z() : 0;
    }
    std::pair<BSDFSample3f, Spectrum> sample(const BSDFContext&, const SurfaceInteraction3f&, float,
                                             std::array<float, 2> u) const {
        const glm::vec3 l = cosine_direction(u[0], u[1]);
        return {{{{l.x, l.y, l.z}}, l.z * inv_pi}, {albedo, albedo, albedo}};
    }
};
}  // namespace mitsuba

struct MyBSDF {
    float albedo;
    glm::vec3 eval(glm::vec3 wi, glm::vec3 wo) const {
        return std::min(wi.z, wo.z) > 0 ? glm::vec3(albedo * inv_pi * wo.z) : glm::vec3(0);
    }
    bool sample(glm::vec3 wi, glm::vec3& wo, float& pdf, glm::vec3& weight, unsigned& lobe_type, glm::vec2 u) const {
        wo = cosine_direction(u.x, u.y);
        pdf = wo.z * inv_pi;
        weight = glm::vec3(albedo);
        lobe_type = 1;
        return std::min(wi.z, wo.z) > 0;
    }
    float evalPdf(glm::vec3 wi, glm::vec3 wo) const { return std::min(wi.z, wo.z) > 0 ? wo.z * inv_pi : 0; }
};

using namespace mitsuba;
using uint = unsigned;

// [recipes]
struct from_pbrt {
    using scalar = float;
    const pbrt::BxDF& bxdf;
    static pbrt::Vector3f to(glm::vec3 w) { return {w.x, w.y, w.z}; }
    glm::vec3 f_cos(glm::vec3 v, glm::vec3 l) const {
        if (v.z <= 0 || l.z <= 0) return glm::vec3(0);
        const pbrt::SampledSpectrum f = bxdf.f(to(v), to(l), pbrt::TransportMode::Radiance);
        return glm::vec3(f[0], f[1], f[2]) * l.z;
    }
    auto sample(glm::vec3 v, glm::vec3 u) const {
        lobe::testkit::sampled_light<glm::vec3, float> out{{0, 0, 1}, glm::vec3(0), 0};
        const auto s = bxdf.Sample_f(to(v), u.z, {u.x, u.y}, pbrt::TransportMode::Radiance);
        if (!s) return out;
        const glm::vec3 f(s->f[0], s->f[1], s->f[2]);
        out = {{s->wi.x, s->wi.y, s->wi.z}, f * (std::abs(s->wi.z) / s->pdf), s->pdf};
        return out;
    }
    float pdf(glm::vec3 v, glm::vec3 l) const { return bxdf.PDF(to(v), to(l), pbrt::TransportMode::Radiance); }
};
struct from_mitsuba {
    using scalar = float;
    const BSDF* bsdf;
    static SurfaceInteraction3f at(glm::vec3 v) {
        auto si = dr::zeros<SurfaceInteraction3f>();
        si.wi = {v.x, v.y, v.z};
        return si;
    }
    glm::vec3 f_cos(glm::vec3 v, glm::vec3 l) const {
        const auto f = bsdf->eval({}, at(v), {l.x, l.y, l.z});
        return {f[0], f[1], f[2]};
    }
    auto sample(glm::vec3 v, glm::vec3 u) const {
        const auto [s, w] = bsdf->sample({}, at(v), u.z, {u.x, u.y});
        const glm::vec3 l(s.wo.x(), s.wo.y(), s.wo.z()), weight(w[0], w[1], w[2]);
        return lobe::testkit::sampled_light<glm::vec3, float>{l, weight, s.pdf};
    }
    float pdf(glm::vec3 v, glm::vec3 l) const { return bsdf->pdf({}, at(v), {l.x, l.y, l.z}); }
};
struct from_falcor {
    using scalar = float;
    MyBSDF bsdf;
    glm::vec3 f_cos(glm::vec3 v, glm::vec3 l) const { return bsdf.eval(v, l); }
    auto sample(glm::vec3 v, glm::vec2 u) const {
        lobe::testkit::sampled_light<glm::vec3, float> s{{0, 0, 1}, glm::vec3(0), 0};
        uint lobe_type;
        if (!bsdf.sample(v, s.l, s.pdf, s.weight, lobe_type, u)) s.pdf = 0, s.weight = glm::vec3(0);
        return s;
    }
    float pdf(glm::vec3 v, glm::vec3 l) const { return bsdf.evalPdf(v, l); }
};
// [end]

}  // namespace

TEST_CASE("recipes for other renderers' interfaces: a right BRDF passes, a wrong one does not", "[testkit]") {
    const auto judged = [](const auto& brdf) {
        const auto report = lobe::testkit::verify(brdf);
        INFO(report);
        CHECK(report.checks().size() > 15);  // with its sampler and its pdf
        return report.passed();
    };
    CHECK(judged(from_pbrt{pbrt::BxDF{0.8f}}));
    CHECK(!judged(from_pbrt{pbrt::BxDF{1.1f}}));
    const BSDF good{0.8f}, bad{1.1f};
    CHECK(judged(from_mitsuba{&good}));
    CHECK(!judged(from_mitsuba{&bad}));
    CHECK(judged(from_falcor{{0.8f}}));
    CHECK(!judged(from_falcor{{1.1f}}));
}

TEST_CASE("docs/verify.md has the recipes that are tested", "[testkit]") {
    const auto text_of = [](const std::string& path) {
        std::ifstream file(std::string(LOBE_REFERENCE_DIR) + "/../../" + path);
        return std::string(std::istreambuf_iterator<char>(file), {});
    };
    const std::string tested = text_of("tests/recipes.cpp"), page = text_of("docs/verify.md");
    const auto begin = tested.find("// [recipes]\n") + 13, end = tested.find("// [end]");
    REQUIRE(end > begin);
    std::istringstream lines(tested.substr(begin, end - begin));
    for (std::string line; std::getline(lines, line);) {
        INFO(line);
        CHECK(page.find(line + "\n") != std::string::npos);
    }
}
