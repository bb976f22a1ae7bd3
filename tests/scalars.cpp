// The library in every scalar type that it supports; 50 digits are in multiprecision/scalars.cpp.
#include "catch.hpp"
#include "scalars/numbers.hpp"
#include "scalars/properties.hpp"

#include <xsimd/xsimd.hpp>

using scalars::dual;

TEMPLATE_TEST_CASE("one text of the formulas holds in every scalar", "[scalars]", float, double, long double,
                   xsimd::batch<float>, xsimd::batch<double>, scalars::dual, scalars::archetype) {
    scalars::verify_all<TestType>();
}

namespace {

template <class T>
T composed(const T& width, const T& F0, const lobe::vec3<T>& v, const lobe::vec3<T>& l) {
    return lobe::microfacet{lobe::ggx{lobe::alpha<T>(width)}, lobe::smith_correlated{}, lobe::schlick{F0}}.f_cos(v, l);
}

template <class T>
T composed_beckmann(const T& width, const T& F0, const lobe::vec3<T>& v, const lobe::vec3<T>& l) {
    const lobe::beckmann ndf{lobe::alpha_xy<T>(width, T(0.5))};
    return lobe::microfacet{ndf, lobe::smith_correlated{}, lobe::schlick{F0}, lobe::all_normals{}}.f_cos(v, l);
}

}  // namespace

TEST_CASE("dual numbers differentiate with respect to width and F0 and view", "[scalars]") {
    // Central differences of step h err by h^2/6 of the third derivative, which grows as (6/alpha)^3 along with the
    // exponential of Beckmann's slopes, 2e-7 f, and by rounding, 15 * 1e-16 f/h = 2e-10 f.
    const double h = 1e-5, tolerance = 1e-6;
    random_numbers random(2);
    const auto up = [&] {
        lobe::vec3<double> w;
        do w = random.direction();
        while (w.z < 0.3);
        return w;
    };
    for (int trial = 0; trial < 300; ++trial) {
        const lobe::vec3<double> v = up(), l = up();
        const double x[5] = {random.between(0.25, 1), random.between(0.02, 0.9), v.x, v.y, v.z};
        for (const bool gauss : {false, true})
            for (int k = 0; k < 5; ++k) {
                const auto f = [&](const auto& p) {
                    using T = std::remove_cvref_t<decltype(p[0])>;
                    const lobe::vec3<T> view{p[2], p[3], p[4]}, light{T(l.x), T(l.y), T(l.z)};
                    return gauss ? composed_beckmann<T>(p[0], p[1], view, light) : composed<T>(p[0], p[1], view, light);
                };
                dual with[5];
                double more[5], less[5];
                for (int j = 0; j < 5; ++j) {
                    with[j] = dual(x[j], j == k ? 1 : 0);
                    more[j] = x[j] + (j == k ? h : 0);
                    less[j] = x[j] - (j == k ? h : 0);
                }
                const double difference = (f(more) - f(less)) / (2 * h);
                const dual d = f(with);
                INFO("parameter " << k << (gauss ? ", Beckmann" : ", GGX"));
                CHECK(std::abs(d.value - f(x)) <= 64 * std::numeric_limits<double>::epsilon() * f(x));
                CHECK(std::abs(d.slope - difference) <= tolerance * (std::abs(difference) + f(x) + 1));
            }
    }
}

TEST_CASE("dual numbers differentiate narrow lobes; samples have derivatives", "[scalars]") {
    const auto f = [](auto a, auto v, auto l) {
        using T = decltype(a);
        return lobe::microfacet{lobe::ggx{lobe::alpha<T>(a)}, lobe::smith_correlated{}, lobe::schlick{T(0.04)}}.f_cos(
            v, l);
    };
    const lobe::vec3<double> v = lobe::normalize(lobe::vec3<double>{0.3, 0.1, 0.8}),
                             l = lobe::normalize(lobe::vec3<double>{-0.5, 0.1, 0.6});
    const auto lift = [](const lobe::vec3<double>& w) { return lobe::vec3<dual>{dual(w.x), dual(w.y), dual(w.z)}; };
    for (double a : {0.05, 0.3, 0.9}) {
        const dual d = f(dual(a, 1), lift(v), lift(l));
        const double h = 1e-5, difference = (f(a + h, v, l) - f(a - h, v, l)) / (2 * h);
        CHECK(d.value == Catch::Approx(f(a, v, l)));
        CHECK(d.slope == Catch::Approx(difference).epsilon(1e-6));
    }
    const auto s = lobe::microfacet{lobe::ggx{lobe::alpha<dual>(dual(0.3, 1))}, lobe::smith_correlated{},
                                    lobe::schlick{dual(0.04)}}
                       .sample(lift(v), {dual(0.3), dual(0.7)});
    CHECK(s.weight.value > 0);
    CHECK(std::isfinite(s.weight.slope));
}
