// The kit's verdicts on what is no number, under flags that let a compiler assume that all are: -ffast-math, and
// without exceptions. Prints the wrong ones; exit 1 if there are any.
#include <lobe/testkit.hpp>

#include <bit>
#include <cstdint>
#include <cstdio>
#include <vector>

namespace {

using namespace lobe::testkit;
using V = glm::vec3;

// By the bits, through memory: no compiler knows what they are.
float of_bits(std::uint32_t bits) {
    const volatile float x = std::bit_cast<float>(bits);
    return x;
}
float nan() { return of_bits(0x7fc00000u); }
float infinity() { return of_bits(0x7f800000u); }
double double_nan() {
    const volatile double x = std::bit_cast<double>(std::uint64_t{0x7ff8'0000'0000'0000u});
    return x;
}

int wrong = 0;
void expect(const char* name, const report& r, const char* key) {
    std::string failed;
    bool named = key == nullptr && r.passed();
    for (const auto& f : r.findings())
        named |= key != nullptr && f.id.key == key, failed += std::string(f.id.key) + " ";
    if (!named) ++wrong;
    std::printf("%s %-32s %s\n", named ? "  " : "!!", name, failed.c_str());
}

struct sampled {
    float (*weight)(const glm::vec2& u);
    float (*density)(const V& l);
    V (*direction)(const V& l);
    float f_cos(const V& v, const V& l) const { return v.z > 0 && l.z > 0 ? 0.8f * l.z / 3.14159265f : 0; }
    float pdf(const V& v, const V& l) const { return v.z > 0 && l.z > 0 ? density(l) : 0; }
    sampled_light<float, float> sample(const V& v, const glm::vec2& u) const {
        if (!(v.z > 0)) return {{0, 0, 1}, 0, 0};
        const float r = std::sqrt(u.x), phi = 6.28318531f * u.y;
        const V l{r * std::cos(phi), r * std::sin(phi), std::sqrt(1 - u.x)};
        if (!(l.z > 0)) return {{0, 0, 1}, 0, 0};
        return {direction(l), weight(u), l.z / 3.14159265f};
    }
};

}  // namespace

int main() {
    const auto f_cos = [](float (*bad)(), auto where) {
        return verify([=](const V& v, const V& l) {
            return where(v, l) ? bad() : v.z > 0 && l.z > 0 ? 0.25f * l.z : 0.0f;
        });
    };
    const auto everywhere = [](const V&, const V&) { return true; };
    const auto ring = [](const V& v, const V& l) { return v.z > 0 && l.z > 0.5f && l.z < 0.51f; };
    const auto below = [](const V&, const V& l) { return l.z < 0; };
    const auto grazing = [](const V& v, const V& l) { return l.z > 0 && v.z > 0 && v.z < 1e-5f; };
    expect("right", f_cos(nan, [](const V&, const V&) { return false; }), nullptr);
    expect("NaN everywhere", f_cos(nan, everywhere), "f_cos_finite");
    expect("NaN on a ring", f_cos(nan, ring), "f_cos_finite");
    expect("NaN below", f_cos(nan, below), "f_cos_finite");
    expect("NaN at grazing", f_cos(nan, grazing), "f_cos_finite");
    expect("infinite everywhere", f_cos(infinity, everywhere), "f_cos_finite");
    expect("infinite on a ring", f_cos(infinity, ring), "f_cos_finite");
    expect("-infinite on a ring", f_cos([] { return -infinity(); }, ring), "f_cos_finite");
    expect("double, NaN on a ring", verify([](const glm::dvec3& v, const glm::dvec3& l) {
               return v.z > 0 && l.z > 0.5 && l.z < 0.51 ? double_nan() : v.z > 0 && l.z > 0 ? 0.25 * l.z : 0.0;
           }),
           "f_cos_finite");
    expect("one channel NaN", verify([](const V& v, const V& l) {
               return v.z > 0 && l.z > 0 ? V(0.2f * l.z, v.z < 0.1f ? nan() : 0, 0) : V(0);
           }),
           "f_cos_finite");
    expect("overflows the kit's sums", verify([](const glm::dvec3&, const glm::dvec3&) { return 1e300; }),
           "white_furnace");

    const auto weight = [](const glm::vec2&) { return 0.8f; };
    const auto density = [](const V& l) { return l.z / 3.14159265f; };
    const auto direction = [](const V& l) { return l; };
    expect("right, sampled", verify(sampled{weight, density, direction}), nullptr);
    expect("weight NaN",
           verify(sampled{[](const glm::vec2& u) { return u.x < 0.1f ? nan() : 0.8f; }, density, direction}),
           "sample_finite");
    expect("weight infinite",
           verify(sampled{[](const glm::vec2& u) { return u.x < 0.1f ? infinity() : 0.8f; }, density, direction}),
           "sample_finite");
    expect("pdf NaN",
           verify(sampled{weight, [](const V& l) { return l.x > 0.5f ? nan() : l.z / 3.14159265f; }, direction}),
           "pdf_finite");
    expect("pdf NaN everywhere", verify(sampled{weight, [](const V&) { return nan(); }, direction}), "pdf_finite");
    expect("pdf infinite",
           verify(sampled{weight, [](const V& l) { return l.x > 0.5f ? infinity() : l.z / 3.14159265f; }, direction}),
           "pdf_finite");
    expect("l NaN", verify(sampled{weight, density, [](const V& l) { return l.x > 0.5f ? V(nan(), l.y, l.z) : l; }}),
           "sample_finite");
    expect("l infinite",
           verify(sampled{weight, density, [](const V& l) { return l.x > 0.5f ? V(l.x, infinity(), l.z) : l; }}),
           "sample_finite");

    expect("F right", verify_fresnel([](float c) { return 0.5f + 0 * c; }), nullptr);
    expect("F NaN", verify_fresnel([](float c) { return c < 0.3f ? nan() : 0.5f; }), "F_finite");
    expect("F NaN everywhere", verify_fresnel([](float) { return nan(); }), "F_finite");
    struct no_average {
        float operator()(float) const { return 0.5f; }
        float average() const { return nan(); }
    };
    expect("average NaN", verify_fresnel(no_average{}), "F_average");
    expect("D right", verify_distribution([](const V& m) { return m.z > 0 ? 0.318309886f : 0; }), nullptr);
    expect("D NaN", verify_distribution([](const V& m) { return m.x > 0.5f ? nan()
                                                                : m.z > 0  ? 0.318309886f
                                                                           : 0; }),
           "D_finite");
    expect("D infinite", verify_distribution([](const V& m) {
               return m.x > 0.5f ? infinity() : m.z > 0 ? 0.318309886f : 0;
           }),
           "D_finite");
    struct no_pdf {
        float D(const V& m) const { return m.z > 0 ? 0.318309886f : 0; }
        float pdf(const V& m) const { return m.z > 0.5f ? nan() : D(m) * m.z; }
    };
    expect("pdf of normals NaN", verify_distribution(no_pdf{}), "pdf_of_normals");
    std::vector<glm::vec2> points;
    for (int i = 0; i < 256; ++i) points.push_back({float(i) / 256, float((i * 97) % 256) / 256});
    points[7].x = nan();
    expect("a point NaN", verify_sequence(points), "points_inside");
    options o;
    o.tolerance = double_nan();
    expect("tolerance NaN", verify(sampled{weight, density, direction}, o), "tolerance");
    return wrong != 0;
}
