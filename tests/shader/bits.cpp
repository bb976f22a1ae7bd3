// What is printed as C++ gives what lobe gives, to the bit.
#include "../catch.hpp"
#include "derivatives.hpp"
#include "inputs.hpp"
#include "printed.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace {

using shader_tests::input;

bool same_bits(const shader_tests::numbers& a, const shader_tests::numbers& b) {
    if (a.count != b.count) return false;
    for (std::size_t i = 0; i < a.count; ++i)
        if (std::bit_cast<std::uint32_t>(a.at[i]) != std::bit_cast<std::uint32_t>(b.at[i]) &&
            !(std::isnan(a.at[i]) && std::isnan(b.at[i])))
            return false;
    return true;
}

const std::vector<input<float>>& inputs() {
    static const std::vector<input<float>> all = [] {
        std::vector<input<float>> in = shader_tests::extreme_inputs();
        shader_tests::random_inputs random;
        while (in.size() < 1000000) in.push_back(random());
        return in;
    }();
    return all;
}

template <class Lobe, class Printed>
void compare(const std::string& name, const Lobe& of_lobe, const Printed& printed) {
    long differ = 0;
    const input<float>* first = nullptr;
    for (const input<float>& in : inputs()) {
        const shading::vec3 v(in.v.x, in.v.y, in.v.z), l(in.l.x, in.l.y, in.l.z);
        const auto a = shader_tests::numbers_of(of_lobe(in));
        const auto b = shader_tests::numbers_of(printed(v, l, shading::vec2(in.u.x, in.u.y), in.width, in.x));
        if (same_bits(a, b)) continue;
        if (!differ++) first = &in;
    }
    INFO(name << " differs " << differ << " times");
    if (first)
        FAIL_CHECK("first at v = " << first->v.x << " " << first->v.y << " " << first->v.z << ", l = " << first->l.x
                                   << " " << first->l.y << " " << first->l.z << ", u = " << first->u.x << " "
                                   << first->u.y << ", width = " << first->width << ", x = " << first->x);
    CHECK(differ == 0);
}

}  // namespace

TEST_CASE("printed C++ is lobe to the bit", "[shader]") {
#define SHADER_FUNCTION(name, ...)                                                                                     \
    compare(                                                                                                           \
        #name, [](const input<float>& in) { return shader_tests::name(in); },                                          \
        [](auto... in) { return shading::name(in...); });
#include "functions.inc"
#undef SHADER_FUNCTION
}

TEST_CASE("a dual of what records prints derivatives", "[shader]") {
    shader_tests::random_inputs random;
    double worst = 0;
    int seen = 0;
    for (int i = 0; i < 20000; ++i) {
        const input<float> in = random();
        if (in.v.z < 0.1f || in.l.z < 0.1f || in.width < 0.05f) continue;
        const auto printed = shading::value_and_slopes(shading::vec3(in.v.x, in.v.y, in.v.z),
                                                       shading::vec3(in.l.x, in.l.y, in.l.z), in.width, in.x);
        const lobe::vec3<double> v(in.v), l(in.l);
        const auto f_cos = [&](double a, double F0) {
            return lobe::microfacet{lobe::ggx{lobe::alpha<double>(a)}, lobe::smith_correlated{}, lobe::schlick{F0}}
                .f_cos(v, l);
        };
        const double a = in.width, h = 1e-6 * a;
        const double by_alpha = (f_cos(a + h, in.x) - f_cos(a - h, in.x)) / (2 * h);
        const double by_F0 = f_cos(a, 1) - f_cos(a, 0);  // linear in F0
        const double size = f_cos(a, in.x) / a;          // of what cancels in the slope
        worst = std::max({worst, std::abs(printed.y - by_alpha) / (std::abs(by_alpha) + size),
                          std::abs(printed.z - by_F0) / by_F0, std::abs(printed.x - f_cos(a, in.x)) / f_cos(a, in.x)});
        ++seen;
    }
    CAPTURE(worst);
    CHECK(seen > 3000);
    CHECK(worst < 2e-6);
}
