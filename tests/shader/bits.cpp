// What is printed as C++ gives what lobe gives, to the bit.
#include "../catch.hpp"
#include "inputs.hpp"
#include "printed.hpp"

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
