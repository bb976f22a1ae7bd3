#include "catch.hpp"
#include "support.hpp"

#include <lobe/core/frame.hpp>
#include <lobe/width/alpha.hpp>

#include <bit>

using lobe::frame;
using lobe::vec3;

namespace {

// Half-way cases and the last bit of long double: what a correctly rounded reference cannot tell.
constexpr double reference_slack = 0.01;

template <class T>
double worst_sincos(T u) {
    const long double x = 2 * 3.141592653589793238462643383279502884L * static_cast<long double>(u);
    const auto [s, c] = lobe::sincos_2pi(u);
    // The reference itself: reduce in turns, where it is exact, or sinl at a multiple of pi is wrong in the absolute.
    const long double turns = static_cast<long double>(u);
    const long double quarter = std::round(turns * 4);
    const long double r = 2 * 3.141592653589793238462643383279502884L * (turns - quarter / 4);
    long double exact_sin = std::sin(x), exact_cos = std::cos(x);
    switch (static_cast<int>(quarter) % 4) {
        case 0: exact_sin = std::sin(r), exact_cos = std::cos(r); break;
        case 1: exact_sin = std::cos(r), exact_cos = -std::sin(r); break;
        case 2: exact_sin = -std::sin(r), exact_cos = -std::cos(r); break;
        case 3: exact_sin = -std::cos(r), exact_cos = std::sin(r); break;
    }
    return larger(ulp_error(s, exact_sin), ulp_error(c, exact_cos));
}

}  // namespace

TEST_CASE("sincos_2pi is within 2 ULP: a strided sweep of the floats of [0,1]", "[core]") {
    double worst = 0;
    for (std::uint32_t bits = 0; bits <= std::bit_cast<std::uint32_t>(1.0f); bits += 509)
        worst = larger(worst, worst_sincos(std::bit_cast<float>(bits)));
    for (int i = 0; i <= 4000000; ++i)  // evenly spread as well: most floats of [0,1] are tiny
        worst = larger(worst, worst_sincos(static_cast<float>(i) / 4000000.0f));
    INFO(worst << " ULP");
    CHECK(worst <= 2);
}

TEST_CASE("sincos_2pi is within 2 ULP in double", "[core]") {
    random_numbers random(1);
    double worst = 0;
    for (int i = 0; i < 1000000; ++i)
        worst = larger({worst, worst_sincos(random()), worst_sincos(random.log_between(1e-300, 1))});
    INFO(worst << " ULP");
    CHECK(worst <= 2 + reference_slack);
}

TEST_CASE("sincos_2pi of whole quarters is exact", "[core]") {
    CHECK(lobe::sincos_2pi(0.0f).sin == 0);
    CHECK(lobe::sincos_2pi(0.25f).sin == 1);
    CHECK(lobe::sincos_2pi(0.25f).cos == 0);
    CHECK(lobe::sincos_2pi(0.5).cos == -1);
    CHECK(lobe::sincos_2pi(0.75).sin == -1);
    CHECK(lobe::sincos_2pi(1.0).cos == 1);
    CHECK(lobe::sincos_2pi(-0.1f).sin == -lobe::sincos_2pi(0.1f).sin);
}

namespace {

template <class T>
double not_orthonormal(const frame<T>& at) {
    double worst = 0;
    const vec3<long double> axes[3] = {vec3<long double>(at.t), vec3<long double>(at.b), vec3<long double>(at.n)};
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            worst = larger(worst, static_cast<double>(std::abs(lobe::dot(axes[i], axes[j]) - (i == j ? 1 : 0))));
    return worst / std::numeric_limits<T>::epsilon();  // ULP of 1
}

}  // namespace

TEMPLATE_TEST_CASE("frames are orthonormal and right-handed", "[core]", float, double) {
    using T = TestType;
    random_numbers random(2);
    double worst = 0, worst_with_tangent = 0;
    const auto look = [&](const vec3<T>& n) {
        const frame<T> at(n);
        worst = larger(worst, not_orthonormal(at));
        CHECK(lobe::dot(lobe::cross(at.t, at.b), at.n) > T(0.99));
    };
    for (const T x : {T(-1), T(0), T(1)})
        for (const T y : {T(-1), T(0), T(1)})
            for (const T z : {T(-1), T(0), T(1)})
                if (x != 0 || y != 0 || z != 0) look(lobe::normalize(vec3<T>{x, y, z}));
    for (int i = 0; i < 100000; ++i) {
        const vec3<T> n = lobe::normalize(random.direction<T>());
        const T tiny = static_cast<T>(random.log_between(1e-20, 1));
        worst = larger(worst, not_orthonormal(frame<T>(n)));
        look(lobe::normalize(vec3<T>{n.x * tiny, n.y * tiny, n.z < 0 ? T(-1) : T(1)}));  // close to the poles
        // a tangent down to 1e-4 radian from the normal, of any length
        const frame<T> any(n);
        const T angle = static_cast<T>(random.log_between(1e-4, 1.5));
        const frame<T> with_tangent(n, T(7) * (std::cos(angle) * n + std::sin(angle) * any.t));
        worst_with_tangent = larger(worst_with_tangent, not_orthonormal(with_tangent));
        if (angle > T(0.01)) CHECK(lobe::dot(with_tangent.t, any.t) > T(0.999));
        CHECK(lobe::dot(lobe::cross(with_tangent.t, with_tangent.b), n) > T(0.99));
    }
    INFO(worst << " ULP, with a tangent " << worst_with_tangent);
    CHECK(worst <= 4);
    CHECK(worst_with_tangent <= 4);
}

TEST_CASE("to_local undoes to_world, and the normal is z", "[core]") {
    random_numbers random(3);
    for (int i = 0; i < 1000; ++i) {
        const frame<double> at(random.direction());
        const vec3<double> w = random.direction(), back = at.to_local(at.to_world(w));
        CHECK(lobe::length(back - w) < 1e-14);
        CHECK(at.to_local(at.n).z == Catch::Approx(1).epsilon(1e-14));
    }
}

TEST_CASE("a view below the horizon is bent by name, others are left alone to the bit", "[core]") {
    random_numbers random(4);
    for (int i = 0; i < 10000; ++i) {
        const vec3<float> v = random.direction<float>();
        const vec3<float> bent = lobe::bend_above_horizon(v, 0.01f);
        if (v.z >= 0.01f) {
            CHECK(bent == v);
        } else {
            CHECK(bent.z == 0.01f);
            CHECK(std::abs(lobe::length(bent) - 1) < 1e-6f);
            CHECK(std::abs(bent.x * v.y - bent.y * v.x) < 1e-6f);  // the same azimuth
            CHECK(bent.x * v.x + bent.y * v.y >= 0);
        }
    }
    const vec3<float> down = lobe::bend_above_horizon(vec3<float>{0, 0, -1}, 0.01f);
    CHECK(down.z == 0.01f);
    CHECK(lobe::length(down) == Catch::Approx(1));
    for (float x : {1e-38f, 1e-30f, 1e-20f, 1e-16f, 1e-14f, 1e-8f})
        CHECK(lobe::length(lobe::bend_above_horizon(vec3<float>{0, x, -1}, 0.01f)) == Catch::Approx(1));
}

TEST_CASE("light below the true surface of a normal map fades to nothing", "[core]") {
    random_numbers random(11);
    for (int i = 0; i < 10000; ++i) {
        const vec3<double> l = random.direction();
        vec3<double> g = random.direction();
        g.z = std::abs(g.z);
        const double tangent2 = (g.x * g.x + g.y * g.y) / (g.z * g.z), c = lobe::dot(g, l);
        // Estevez et al.'s listing: the masking 2/(1 + sqrt(1 + a^2 tan^2)) of a GGX, by its tangent
        const double listed = c > 0 ? 2 / (1 + std::sqrt(1 + std::min(tangent2 / 8, 1.0) * (1 / (c * c) - 1))) : 0;
        CHECK(std::abs(lobe::bump_shadowing(g, l) - listed) < 1e-9);
        CHECK(lobe::bump_shadowing(vec3<double>{0, 0, 1}, l) == (l.z > 0 ? 1 : 0));
    }
    CHECK(lobe::bump_shadowing(vec3<float>{0.6f, 0, 0.8f}, vec3<float>{-0.8f, 0, 0.6f}) ==
          Catch::Approx(0).margin(1e-6));
    CHECK(lobe::bump_shadowing(vec3<float>{0.6f, 0, 0.8f}, vec3<float>{-0.9f, 0, 0.4f}) == 0);
}

TEST_CASE("roughness becomes alpha by name", "[core]") {
    CHECK(lobe::alpha<float>::from_roughness(0.5f).value() == 0.25f);
    CHECK(lobe::alpha<float>::from_roughness(0.0f, 1e-4f).value() == 1e-4f);
    CHECK(lobe::alpha<double>::at_least(0.2, 1e-4).value() == 0.2);
    CHECK(lobe::alpha{0.3}.value() == 0.3);
}

TEST_CASE("preconditions end in an assert", "[core]") {
    CHECK_FALSE(aborts([] { (void)lobe::alpha<float>(0.1f); }));
    CHECK(aborts([] { (void)lobe::alpha<float>(0.0f); }));
    CHECK(aborts([] { (void)lobe::alpha<float>(-0.1f); }));
    CHECK(aborts([] { (void)lobe::alpha<float>(std::numeric_limits<float>::quiet_NaN()); }));
    CHECK(aborts([] { (void)lobe::alpha<float>(std::numeric_limits<float>::infinity()); }));
    CHECK(aborts([] { (void)lobe::alpha_xy<float>(0.1f, std::numeric_limits<float>::infinity()); }));
    CHECK_FALSE(aborts([] { (void)lobe::alpha<float>(std::numeric_limits<float>::max()); }));
    CHECK(aborts([] { (void)lobe::alpha<float>::from_roughness(0.0f); }));
    CHECK(aborts([] { (void)lobe::alpha_xy<float>(0.1f, 0.0f); }));
    CHECK(aborts([] { (void)frame<float>(vec3<float>{0, 0, 1}, vec3<float>{0, 0, 2}); }));
}
