// Gives what a shader asks to verify to the test kit, and prints of each report what failed, or all of it with --all.
// With --junit FILE it writes them there, too, as a build server reads them.
// Exit status 1 if something failed.
#include "subject.hpp"

#include <lobe/testkit.hpp>

#include <fstream>
#include <iostream>
#include <string_view>
#include <vector>

namespace {

using glm::vec2, glm::vec3;
using namespace lobe::testkit;

report verify_brdf(const subject& s) {
    const lobe::frame<float> at(s.world_space ? lobe::normalize(vec3(0.36f, -0.48f, 0.8f)) : vec3(0, 0, 1));
    const auto f_cos = [&](const vec3& v, const vec3& l) { return s.f_cos(at.n, at.to_world(v), at.to_world(l)); };
    const auto pdf = [&](const vec3& v, const vec3& l) { return s.pdf_light(at.n, at.to_world(v), at.to_world(l)); };
    const auto sample = [&](const vec3& v, const vec2& u) {
        const auto drawn = s.sample_light(at.n, at.to_world(v), u);
        return sampled_light<vec3, float>{at.to_local(drawn.l), drawn.weight, drawn.pdf};
    };
    if (s.sample_light && s.pdf_light) return verify(functions(f_cos, sample, pdf), s.options);
    if (s.sample_light) return verify(functions(f_cos, sample), s.options);
    return verify(functions(f_cos), s.options);
}

/// A shader asks for D above the horizon only.
template <bool HasG1, bool HasSample>
struct distribution {
    const subject& s;
    vec3 n{0, 0, 1};

    float D(const vec3& m) const { return m.z < 0 ? 0 : s.D(n, m); }
    float G1(const vec3& v) const requires HasG1 { return s.G1(n, v); }
    vec3 sample(const vec2& u) const requires HasSample { return s.sample_normal(n, u); }
    float pdf(const vec3& m) const requires HasSample { return s.pdf_normal ? s.pdf_normal(n, m) : D(m) * m.z; }
};

report verify_D(const subject& s) {
    if (s.G1 && s.sample_normal) return verify_distribution(distribution<true, true>{s}, s.options);
    if (s.G1) return verify_distribution(distribution<true, false>{s}, s.options);
    if (s.sample_normal) return verify_distribution(distribution<false, true>{s}, s.options);
    return verify_distribution(distribution<false, false>{s}, s.options);
}

report verdict_on(const subject& s) {
    if (s.f_cos) return verify_brdf(s);
    if (s.D) return verify_D(s);
    if (s.F) return verify_fresnel([&](float cosine) { return s.F(cosine); }, s.options);
    std::vector<vec2> points;
    for (unsigned i = 0; i < s.points; ++i) points.push_back(s.point(i));
    return verify_sequence(points, s.options);
}

report failures_of(const report& r) {
    report failed(r.name());
    for (const check& c : r.checks())
        if (!c.passed) failed.add(c);
    return failed;
}

}  // namespace

int main(int count, char** arguments) {
    bool all = false;
    const char* file = nullptr;
    for (int i = 1; i < count; ++i) {
        all |= std::string_view(arguments[i]) == "--all";
        if (std::string_view(arguments[i]) == "--junit" && i + 1 < count) file = arguments[++i];
    }
    int passed = 0, failed = 0;
    std::vector<report> reports;
    for (const subject& s : shader::requested()) {
        const report r = reports.emplace_back(verdict_on(s));
        if (all || !r)
            std::cout << (all ? r : failures_of(r)) << std::endl;
        else
            std::cout << r.name() << ": passed, " << r.checks().size() << " properties\n" << std::endl;
        ++(r ? passed : failed);
    }
    if (file) std::ofstream(file) << junit(reports);
    std::cout << passed << " passed, " << failed << " failed\n";
    return failed ? 1 : 0;
}
