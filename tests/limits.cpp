// Every function at the ends of what it is given: the table of docs/limits.md, row by row, in float and in double. The
// values hold with asserts compiled in or out; the asserts themselves, and what they say, come last.
#include "catch.hpp"
#include "support.hpp"

#include <lobe/lobe.hpp>

#include <array>
#include <cstdio>

using lobe::alpha;
using lobe::alpha_xy;
using lobe::beckmann;
using lobe::ggx;
using lobe::microfacet;
using lobe::perfect_reflector;
using lobe::schlick;
using lobe::smith_correlated;
using lobe::vec2;
using lobe::vec3;

namespace {

constexpr double pi = 3.141592653589793;

/// Does a sanitizer take a division by zero for an error?
#if defined(__has_feature)
#if __has_feature(undefined_behavior_sanitizer)
#define LOBE_TEST_DIVISIONS_WATCHED
#endif
#endif
#ifdef LOBE_TEST_DIVISIONS_WATCHED
constexpr bool divisions_watched = true;
#else
constexpr bool divisions_watched = false;
#endif
template <class T>
using limits = std::numeric_limits<T>;
template <class T>
constexpr T not_a_number = limits<T>::quiet_NaN();
/// The smallest cosine of the domain of `microfacet`.
template <class T>
constexpr T smallest_cosine = sizeof(T) == 4 ? T(1e-18) : T(1e-150);
template <class T>
constexpr T below_one = T(1) - limits<T>::epsilon() / 2;
template <class T>
const vec3<T> normal{0, 0, 1};

template <class T>
bool in_range(T x) {
    return x >= 0 && x <= limits<T>::max();
}
template <class T>
bool in_range(const vec3<T>& s) {
    return in_range(s.x) && in_range(s.y) && in_range(s.z);
}

/// visit(name, BRDF) for one of each kind, specular ones of width a.
template <class T, class Visit>
void every_brdf(T a, const Visit& visit) {
    const alpha<T> width(a);
    const schlick F{vec3<T>{1, T(0.5), 0}};
    const vec3<T> colour{1, T(0.5), 0};
    visit("smith_correlated", microfacet{ggx{width}, smith_correlated{}, F});
    visit("smith_separable", microfacet{ggx{width}, lobe::smith_separable{}, F});
    visit("smith_direction_correlated", microfacet{ggx{width}, lobe::smith_direction_correlated{}, F});
    visit("smith_hammon", microfacet{ggx{width}, lobe::smith_hammon{}, F});
    visit("schlick_ggx", microfacet{ggx{width}, lobe::schlick_ggx{lobe::k_from_alpha(width)}, F});
    visit("v_cavity", microfacet{ggx{width}, lobe::v_cavity{}, F});
    visit("visible_heitz2018", microfacet{ggx{width}, smith_correlated{}, F, lobe::visible_heitz2018{}});
    visit("visible_bounded_caps", microfacet{ggx{width}, smith_correlated{}, F, lobe::visible_bounded_caps{}});
    visit("all_normals", microfacet{ggx{width}, smith_correlated{}, F, lobe::all_normals{}});
    visit("v_cavity, black", microfacet{ggx{width}, lobe::v_cavity{}, schlick{vec3<T>(0), vec3<T>(0)}});
    visit("alpha_xy", microfacet{ggx{alpha_xy<T>(a, 1)}, smith_correlated{}, F});
    visit("beckmann", microfacet{beckmann{width}, smith_correlated{}, F});
    visit("beckmann, all normals", microfacet{beckmann{width}, smith_correlated{}, F, lobe::all_normals{}});
    visit("student_t", microfacet{lobe::student_t{width, T(3)}, smith_correlated{}, F});
    visit("gtr", microfacet{lobe::tabulated{lobe::gtr{width, T(1)}}, smith_correlated{}, F});
    visit("student_t, long tails",
          microfacet{lobe::student_t{width, T(1.6)}, smith_correlated{}, F, lobe::all_normals{}});
    visit("abc", microfacet{lobe::tabulated{lobe::abc{width, T(1.5)}}, smith_correlated{}, F, lobe::all_normals{}});
    visit("mixture", microfacet{lobe::mixture{ggx{width}, beckmann{width}, T(0.3)}, smith_correlated{}, F});
    visit("dielectric", microfacet{ggx{width}, smith_correlated{}, lobe::dielectric{T(1.5)}});
    visit("dielectric from inside", microfacet{ggx{width}, smith_correlated{}, lobe::dielectric{T(0.5)}});
    visit("conductor", microfacet{ggx{width}, smith_correlated{}, lobe::conductor{T(0.2), T(3)}});
    visit("lambert", lobe::lambert{colour});
    visit("burley", lobe::burley{colour, T(1)});
    visit("oren_nayar", lobe::oren_nayar{colour, T(1)});
    visit("eon", lobe::eon{colour, T(1)});
    visit("metallic_roughness", lobe::metallic_roughness(colour, T(0.5), width));
    visit("coated", lobe::coated(lobe::metallic_roughness(colour, T(0.5), width), ggx{width}, T(1)));
}

/// A failed sample, to the bit.
template <class T, class S>
bool failed(const lobe::direction_sample<S, T>& s) {
    return s.pdf == 0 && s.weight == S(T(0)) && s.l == normal<T>;
}

/// A failed sample, or a direction above the horizon with a weight and a density that are numbers.
template <class T, class S>
bool valid(const lobe::direction_sample<S, T>& s) {
    const bool unit = std::abs(lobe::length(s.l) - 1) < 16 * limits<T>::epsilon();
    return failed(s) || (s.pdf > 0 && s.l.z > 0 && in_range(s.pdf) && in_range(s.weight) && unit);
}

/// A number whose exponent is as likely as any other, or zero, of either sign.
template <class T>
T any_exponent(random_numbers& random) {
    const double x = random(), sign = random() < 0.5 ? -1 : 1;
    return static_cast<T>(sign * (x < 0.1   ? 0
                                  : x < 0.6 ? random.log_between(sizeof(T) == 4 ? 1e-46 : 1e-320, 1)
                                  : x < 0.8 ? random.log_between(1e-20, 1)
                                            : random()));
}

/// Of unit length but for a few ULP: two components of any size, in any of the three places.
template <class T>
vec3<T> any_direction(random_numbers& random) {
    T a = any_exponent<T>(random), b = any_exponent<T>(random);
    if (a * a + b * b > 1) a /= 2, b /= 2;
    const T sign = random() < 0.3 ? T(-1) : T(1),
            stretch = 1 + static_cast<T>(random.between(-2, 2)) * limits<T>::epsilon();
    const T c = sign * std::sqrt(1 - a * a - b * b) * stretch;
    const double place = random();
    return place < 0.3 ? vec3<T>{c, a, b} : place < 0.6 ? vec3<T>{b, c, a} : vec3<T>{a, b, c};
}

/// A light for the view v: any, or v, -v, or what all but cancels it.
template <class T>
vec3<T> any_light(random_numbers& random, const vec3<T>& v) {
    const double kind = random();
    const vec3<T> l = kind < 0.3   ? vec3<T>{-v.x, -v.y, any_exponent<T>(random) * v.z}
                      : kind < 0.5 ? vec3<T>{-v.x, -v.y, any_exponent<T>(random)}
                      : kind < 0.6 ? -v
                      : kind < 0.7 ? v
                      : kind < 0.8 ? vec3<T>{-v.x, -v.y, v.z}
                                   : any_direction<T>(random);
    return std::abs(lobe::length(l) - 1) < 8 * limits<T>::epsilon() ? l : any_direction<T>(random);
}

template <class T>
T any_share(random_numbers& random) {
    const double x = random();
    return x < 0.1   ? T(0)
           : x < 0.2 ? below_one<T>
           : x < 0.3 ? std::abs(any_exponent<T>(random)) / 2
                     : (std::min)(static_cast<T>(random()), below_one<T>);
}

}  // namespace

TEMPLATE_TEST_CASE("limits: cosines of zero, v = -l, v = l, v = l = n, for every BRDF", "[limits]", float, double) {
    using T = TestType;
    const T t = smallest_cosine<T>, p = T(0.6), q = T(0.8);
    const std::array<std::pair<vec3<T>, vec3<T>>, 16> pairs{{
        {{0, 0, 1}, {0, 0, 1}},  // v = l = n
        {{p, 0, q}, {p, 0, q}},  // v = l
        {{1, 0, t}, {1, 0, t}},  // ... at the horizon
        {{1, 0, t}, {p, 0, q}},  // cosines next to zero
        {{p, 0, q}, {1, 0, t}},
        {{1, 0, t}, {0, 1, t}},
        {{1, 0, t}, {-1, 0, t}},   // v = -l but for them
        {{p, 0, q}, {-p, 0, -q}},  // v = -l
        {{0, 0, 1}, {0, 0, -1}},
        {{1, 0, 0}, {-1, 0, 0}},
        {{1, 0, 0}, {p, 0, q}},  // cos_v = 0
        {{p, 0, q}, {1, 0, 0}},  // cos_l = 0
        {{1, 0, 0}, {0, 1, 0}},  // both
        {{1, 0, 0}, {1, 0, 0}},
        {{1, 0, T(-0.0)}, {p, 0, q}},
        {{p, 0, q}, {0, 1, T(-0.0)}},
    }};
    for (const T a : {T(1e-4), T(0.1), T(1)})
        every_brdf(a, [&](const std::string& name, const auto& b) {
            int bad = 0;
            for (const auto& [v, l] : pairs) {
                const bool above = v.z > 0 && l.z > 0;
                const auto e = b.evaluate(v, l);
                const auto f = b.f(v, l), f_cos = b.f_cos(v, l);
                bad += !in_range(f) + !in_range(f_cos) + !in_range(e.f_cos) + !in_range(b.pdf(v, l)) + !in_range(e.pdf);
                const decltype(f) zero(T(0));
                if (!above) bad += f != zero || f_cos != zero || e.f_cos != zero || b.pdf(v, l) != 0 || e.pdf != 0;
                if (v.z <= 0) bad += !failed(b.sample(v, {T(0.3), T(0.6)}));
            }
            INFO(name << ", alpha " << a);
            CHECK(bad == 0);
        });
}

TEMPLATE_TEST_CASE("limits: the horizon, where the formulas end", "[limits]", float, double) {
    using T = TestType;
    // The smallest cosine of the domain is above it. Half of two that are below, v + l has a square without digits, or
    // 0.
    const T h = lobe::horizon<T>(), next = h * (1 + limits<T>::epsilon());
    CHECK(smallest_cosine<T> > h);
    CHECK(h * h >= limits<T>::min());
    const vec3<T> v{T(0.6), 0, T(0.8)};
    for (const T a : {T(1e-6), T(0.1), T(1)})
        every_brdf(a, [&](const std::string& name, const auto& b) {
            INFO(name << ", alpha " << a);
            using S = decltype(b.f(v, v));
            const S black(T(0));
            int bad = 0;
            for (const auto& w :
                 {vec3<T>{-1, 0, h}, vec3<T>{0, 1, h}, vec3<T>{-1, 0, h / 2}, vec3<T>{1, 0, limits<T>::denorm_min()}}) {
                bad += b.f(v, w) != black || b.f_cos(v, w) != black || b.f(w, v) != black || b.pdf(v, w) != 0 ||
                       b.evaluate(w, v).pdf != 0;
                bad += !failed(b.sample(w, {T(0.3), T(0.6)}));
            }
            const vec3<T> low{-1, 0, next};
            bad += !in_range(b.f(v, low)) + !in_range(b.f(low, v)) + !in_range(b.f_cos(low, vec3<T>{1, 0, next})) +
                   !in_range(b.pdf(low, low));
            bad += !valid(b.sample(low, {T(0.3), T(0.6)}));
            CHECK(bad == 0);
        });
    const T tiny = sizeof(T) == 4 ? T(1e-30) : T(1e-250);  // whose square is 0
    const vec3<T> up{1, 0, tiny}, across{-1, 0, tiny};
    const microfacet mirror{ggx{alpha<T>(T(0.3))}, smith_correlated{}, schlick{T(0.04)}};
    CHECK(mirror.f_cos(up, across) == 0);
    CHECK(mirror.pdf(up, across) == 0);
}

TEMPLATE_TEST_CASE("limits: never a NaN, for any two directions of about unit length", "[limits]", float, double) {
    using T = TestType;
    // 3e8 pairs, of every alpha down to 1.2e-19, were tried so once by hand. Where f exceeds its type it is the largest
    // number.
    random_numbers random(4);
    std::vector<std::pair<vec3<T>, vec3<T>>> pairs;
    const std::array<T, 10> corner{
        T(0), T(-0.0), limits<T>::denorm_min(), T(1e-30), T(1e-19), T(1e-18), T(1e-12), T(1e-6), T(-1e-18), T(-1e-30)};
    for (const T x : corner)
        for (const T y : corner) {  // the horizon around -x, and v = -l but for the cosines
            const auto rest = [](T p, T q) { return std::sqrt(1 - p * p - q * q); };
            pairs.push_back({{rest(x, 0), 0, x}, {-rest(y, 0), 0, y}});
            pairs.push_back({{0, -rest(x, 0), x}, {0, rest(y, 0), y}});
            pairs.push_back({{rest(x, 0), x, T(1e-18)}, {-rest(y, 0), y, T(1e-18)}});
            pairs.push_back({{x, y, rest(x, y)}, {y, x, -rest(x, y)}});
        }
    for (int i = 0; i < 2000; ++i) {
        const auto v = any_direction<T>(random);
        pairs.push_back({v, any_light(random, v)});
    }
    for (const T a : {T(1e-6), T(1e-4), T(0.1), T(1)})
        every_brdf(a, [&](const std::string& name, const auto& b) {
            int bad = 0;
            vec3<T> v(0), l(0);
            const auto expect = [&](bool holds, const auto& pair) {
                if (holds) return;
                ++bad;
                v = pair.first, l = pair.second;
            };
            for (const auto& pair : pairs) {
                const auto& [w, z] = pair;
                const auto e = b.evaluate(w, z);
                expect(in_range(b.f(w, z)) && in_range(b.f_cos(w, z)) && in_range(e.f_cos) && in_range(b.pdf(w, z)) &&
                           in_range(e.pdf),
                       pair);
                expect(valid(b.sample(w, vec2<T>{any_share<T>(random), any_share<T>(random)})), pair);
            }
            INFO(name << ", alpha " << a << ", v " << v.x << ' ' << v.y << ' ' << v.z << ", l " << l.x << ' ' << l.y
                      << ' ' << l.z);
            CHECK(bad == 0);
        });
}

TEMPLATE_TEST_CASE("limits: the values there", "[limits]", float, double) {
    using T = TestType;
    const double ulp = limits<T>::epsilon();
    for (const T a : {T(1e-4), T(0.1), T(1)}) {
        const ggx ndf{alpha<T>(a)};
        const microfacet brdf{ndf, smith_correlated{}, schlick{T(0.04)}};
        const double wide = static_cast<double>(a);
        // v = l = n: F0/(4 pi alpha^2), V = 1/4. 12 ULP of D, 6 of V, 8 of F, three products
        const double along_normal = static_cast<double>(T(0.04)) / (4 * pi * wide * wide);
        CHECK(static_cast<double>(brdf.f(normal<T>, normal<T>)) == Catch::Approx(along_normal).epsilon(29 * ulp));
        // v = l: v.m = 1, so F is F0 to the bit, whatever |v + l| rounds to
        const vec3<T> v{T(0.6), 0, T(0.8)};
        const T D = ndf.D(v + v), V = smith_correlated{}.visibility(ndf, v, v);
        CHECK(static_cast<double>(brdf.f(v, v)) ==
              Catch::Approx(static_cast<double>(T(0.04) * D * V)).epsilon(8 * ulp));
        // cos_l -> 0: sl -> alpha/2, so V -> 1/(2 alpha cos_v): finite, and f_cos goes to 0 with the cosine
        const vec3<T> l{-1, 0, smallest_cosine<T>};
        const double V_grazing = static_cast<double>(smith_correlated{}.visibility(ndf, v, l));
        CHECK(V_grazing == Catch::Approx(1 / (2 * wide * static_cast<double>(v.z))).epsilon(6 * ulp));
        CHECK(static_cast<double>(brdf.f_cos(v, l) / l.z) ==
              Catch::Approx(static_cast<double>(brdf.f(v, l))).epsilon(4 * ulp));
        CHECK(brdf.f(v, l) > 0);
    }
}

TEMPLATE_TEST_CASE("limits: u at 0, next to 1, and 1, which is outside", "[limits]", float, double) {
    using T = TestType;
    const T t = smallest_cosine<T>;
    for (const T a : {T(1e-4), T(0.1), T(1)})
        every_brdf(a, [&](const std::string& name, const auto& b) {
            int bad = 0;
            for (const vec3<T>& v :
                 {normal<T>, vec3<T>{T(0.6), 0, T(0.8)}, lobe::normalize(vec3<T>{1, 0, T(0.01)}), vec3<T>{0, -1, t}})
                for (const T x : {T(0), T(0.5), below_one<T>, T(1)})
                    for (const T y : {T(0), T(0.5), below_one<T>, T(1)})
                        if (x < 1 || !divisions_watched) bad += !valid(b.sample(v, vec2<T>{x, y}));
            INFO(name << ", alpha " << a);
            CHECK(bad == 0);
        });
    // The distributions and the warps themselves: unit directions on the square, and a NaN or the horizon at 1.
    const auto unit = [](const vec3<T>& m) {
        return std::abs(lobe::length(m) - 1) < 8 * limits<T>::epsilon() && m.z >= 0;
    };
    const alpha<T> a(T(0.3));
    const vec3<T> v{T(0.6), 0, T(0.8)};
    for (const T x : {T(0), below_one<T>})
        for (const T y : {T(0), below_one<T>}) {
            const vec2<T> u{x, y};
            for (const vec3<T>& m :
                 {ggx{a}.sample(u), beckmann{a}.sample(u), lobe::student_t{a, T(3)}.sample(u),
                  lobe::gtr{a, T(1.5)}.sample(u), lobe::blinn_phong{a}.sample(u), lobe::phong{a}.sample(u),
                  lobe::exponential_power{a, T(1)}.sample(u), ggx{a}.sample_visible(v, u),
                  beckmann{a}.sample_visible(v, u), lobe::square_to_cosine_hemisphere(u),
                  lobe::square_to_uniform_hemisphere(u), lobe::square_to_cosine_hemisphere_concentric(u)})
                CHECK(unit(m));
        }
    CHECK(unit(ggx{a}.sample({1, 1})));
    CHECK(std::isnan(beckmann{a}.sample({1, 1}).z));  // tan = infinity
}

TEMPLATE_TEST_CASE("limits: Fresnel at its ends", "[limits]", float, double) {
    using T = TestType;
    const double ulp = limits<T>::epsilon();
    const auto same = [&](T a, double b, double error) {
        return std::abs(static_cast<double>(a) - b) <= error * ulp * b;
    };
    // eta = 1: no interface. At c = 0 (whose square is 0) every eta reflects all, and so does this one
    const lobe::dielectric none{T(1)};
    for (const T c : {smallest_cosine<T>, T(1e-6), T(0.3), T(1)}) CHECK(none(c) == 0);
    CHECK(none(T(0)) == 1);
    CHECK(none.average() == 0);
    CHECK(none.F0() == 0);
    // total internal reflection: exactly 1 up to the critical angle, cos = sqrt(1 - eta^2), and below 1 from there on
    const lobe::dielectric inside{T(0.5)};
    const T critical = std::sqrt(T(0.75));
    for (const T c : {T(0), T(0.3), critical * (1 - 4 * limits<T>::epsilon())}) CHECK(inside(c) == 1);
    CHECK(inside(critical * (1 + 4 * limits<T>::epsilon())) < 1);
    CHECK(same(inside(T(1)), 1.0 / 9, 8));
    // eta large: F0 = ((eta-1)/(eta+1))^2 -> 1, as long as eta^2 is a number; eta small: all is reflected
    const T most = sizeof(T) == 4 ? T(1e19) : T(1e150), least = limits<T>::min();
    for (const T c : {T(0), T(0.3), T(1)}) {
        CHECK(same(lobe::dielectric{most}(c), 1, 8));
        CHECK(lobe::dielectric{least}(c) == 1);
        CHECK(lobe::dielectric{limits<T>::denorm_min()}(c) == 1);
    }
    for (const T eta : {least, T(0.5), T(1), T(1.5), most}) CHECK(lobe::dielectric{eta}(T(0)) == 1);
    CHECK(same(lobe::dielectric{most}.average(), 1, 12));
    CHECK(same(lobe::dielectric{least}.average(), 1, 12));
    CHECK(same(lobe::dielectric{limits<T>::denorm_min()}.average(), 1, 12));
    // k = 0 is a dielectric, eta = 1 among them (8 ULP each); k large a mirror
    for (const T eta : {T(0.5), T(1), T(1.33), T(2.5), T(100)})
        for (const T c : {T(0), T(1e-3), T(0.3), T(0.95), T(1)}) {
            if (eta == T(0.5) && std::abs(c - critical) < T(0.1)) continue;
            INFO("eta " << eta << ", c " << c);
            CHECK(same(lobe::conductor{eta, T(0)}(c), static_cast<double>(lobe::dielectric{eta}(c)), 16));
        }
    for (const T eta : {T(0.001), T(1), T(1e9)})
        for (const T c : {T(0), T(0.3), T(1)})  // 1 - F is 4 eta/(eta^2 + k^2) times (c + 1/c)/2
            CHECK(std::abs(lobe::conductor{eta, T(1e9)}(c)-1) <= T(8e-9) + 8 * limits<T>::epsilon());
    // F0 = 0 and 1
    for (const T c : {T(0), T(0.3), T(1)}) {
        CHECK(schlick{T(1)}(c) == 1);
        CHECK(lobe::f82_tint{T(1), T(1)}(c) == 1);
    }
    CHECK(schlick{T(0)}(T(1)) == 0);
    CHECK(schlick{T(0)}(T(0)) == 1);
    CHECK(same(schlick{T(1)}.average(), 1, 3));
    CHECK(lobe::f82_tint{T(0), T(0)}(T(1) / T(7)) <= 4 * limits<T>::epsilon());
    CHECK(lobe::ior_from_f0(T(0)) == 1);
    CHECK(lobe::f0_from_ior(T(1)) == 0);
    // F0 next to 1: 1 - sqrt(F0), of a quarter ULP, rounds to half an ULP, or to none
    CHECK((lobe::ior_from_f0(below_one<T>) == limits<T>::infinity() ||
           lobe::ior_from_f0(below_one<T>) > 2 / limits<T>::epsilon()));
}

TEMPLATE_TEST_CASE("limits: alpha next to zero", "[limits]", float, double) {
    using T = TestType;
    const double ulp = limits<T>::epsilon();
    const vec3<T> v{T(0.6), 0, T(0.8)}, l{T(-0.6), 0, T(0.8)}, off{0, T(0.6), T(0.8)};
    // as far as alpha^2 is a number with all its digits, so is D
    const T least = sizeof(T) == 4 ? T(1.2e-19) : T(1.5e-153);
    for (const T a : {T(1e-6), T(1e-10), least}) {
        const long double exact = 1 / (3.14159265358979323846264338L * a * a);
        CHECK(std::abs(static_cast<double>(ggx{alpha<T>(a)}.D(normal<T>) / exact - 1)) <= 12 * ulp);
        CHECK(ggx{alpha<T>(a)}.projected_area(normal<T>) == 1);
    }
    // Below, denormals among them, outside every domain: the peak is infinite, or zero once alpha^2 is; all else is
    // dark, nothing a NaN, and a sample the mirror direction with the weight F, or a failure.
    for (const T a : {limits<T>::denorm_min(), limits<T>::min(), least / 100}) {
        const ggx ndf{alpha<T>(a)};
        const microfacet mirror{ndf, smith_correlated{}, schlick{T(0.5)}};
        INFO("alpha " << a);
        CHECK((ndf.D(normal<T>) == limits<T>::infinity() || ndf.D(normal<T>) == 0));
        CHECK(ndf.D(off) < limits<T>::min());
        CHECK((mirror.f_cos(v, l) == limits<T>::infinity() || mirror.f_cos(v, l) == 0));
        CHECK(mirror.f_cos(v, off) < limits<T>::min());
        CHECK(ndf.projected_area(v) == v.z);
        const auto s = mirror.sample(v, {T(0.5), T(0.3)});
        const double weight = static_cast<double>(schlick{T(0.5)}(T(0.8)));
        const bool mirrored = lobe::length(s.l - l) < 8 * limits<T>::epsilon();
        CHECK((failed(s) || (mirrored && std::abs(static_cast<double>(s.weight) / weight - 1) < 32 * ulp)));
    }
    // a texture's 0, with a floor
    const auto a = alpha<T>::from_roughness(T(0), T(1e-4));
    CHECK(a.value() == T(1e-4));
    CHECK(alpha<T>::from_roughness(T(-0.0), T(1e-4)).value() == T(1e-4));
    CHECK(alpha_xy<T>::from_disney(T(0), T(1), T(1e-4)).y() == T(1e-4));
    CHECK(alpha_xy<T>::from_imageworks(T(0.5), T(1), T(1e-4)).y() == T(1e-4));
    CHECK(alpha_xy<T>::from_openpbr(T(0.5), T(1), T(1e-4)).y() == T(1e-4));
    CHECK(in_range(microfacet{ggx{a}, smith_correlated{}, schlick{T(0.5)}}.f_cos(v, l)));
    const auto white = lobe::metallic_roughness(vec3<T>{1}, T(1), T(0), T(1e-4)).sample(v, {T(0.3), T(0.7)});
    CHECK(valid(white));
    CHECK(white.weight.x > T(0.99));
}

TEMPLATE_TEST_CASE("limits: widths 1000 and a million apart", "[limits]", float, double) {
    using T = TestType;
    random_numbers random(1);
    for (const double ratio : {1e3, 1e6})
        for (const bool along_x : {true, false}) {
            double D = 0, area = 0, below = 0, lambda = 0;
            int bad = 0, failures = 0;
            double light = 0;
            constexpr int n = 20000;
            for (int i = 0; i < n; ++i) {
                const T wide = static_cast<T>(random.log_between(1e-2, 1)),
                        narrow = static_cast<T>(static_cast<double>(wide) / ratio);
                const alpha_xy<T> a(along_x ? narrow : wide, along_x ? wide : narrow);
                const alpha_xy<long double> b(a.x(), a.y());
                const ggx ndf{a};
                const ggx exact{b};
                // normals in the plane of the wide axis as well as anywhere
                auto m = random.grazing_direction<T>(1e-3);
                if (i % 2) (along_x ? m.x : m.y) *= narrow;
                const auto v = random.grazing_direction<T>(1e-3);
                D = larger(D, ulp_error(ndf.D(m), exact.D(vec3<long double>(m))));
                area = larger(area, ulp_error(ndf.projected_area(v), exact.projected_area(vec3<long double>(v))));
                below = larger(below, ulp_error(ndf.projected_area(-v), exact.projected_area(-vec3<long double>(v))));
                lambda = larger(lambda, ulp_error(ndf.lambda(v), exact.lambda(vec3<long double>(v))));
                const microfacet brdf{ndf, smith_correlated{}, perfect_reflector{}};
                const auto s =
                    brdf.sample(v, {static_cast<T>(random() * 0.99999994), static_cast<T>(random() * 0.99999994)});
                bad += !valid(s) + !(s.weight <= T(1) + 16 * limits<T>::epsilon());
                failures += s.pdf == 0;
                light += static_cast<double>(s.weight) / n;
            }
            INFO("1:" << ratio << ": D " << D << ", area " << area << ", below the horizon " << below << ", Lambda "
                      << lambda << " ULP; light " << light << ", failed " << failures);
            CHECK(D <= 12);
            CHECK(area <= 4);
            CHECK(below <= 5);
            CHECK(lambda <= 8);
            CHECK(bad == 0);
            CHECK(light > 0.5);  // views down to 1e-3, wide axes up to 1: what single scattering leaves
        }
}

TEMPLATE_TEST_CASE("limits: directions a few ULP off unit length", "[limits]", float, double) {
    using T = TestType;
    // v (1 + d) + l (1 - d) = s + d (v - l), s = v + l, and v - l is across s: m turns by d tan(v,m), and by the
    // rounding of v and l, sqrt(3)/2 ULP over |s| each. d ln D/d theta is 2/alpha at most. den and the cosine are
    // linear in v and in l; 25 ULP for what each side rounds.
    random_numbers random(2);
    const T ulp = limits<T>::epsilon();
    for (const T a : {T(0.02), T(0.3), T(1)}) {
        const microfacet brdf{ggx{alpha<T>(a)}, smith_correlated{}, schlick{T(0.5)}};
        const microfacet black{ggx{alpha<T>(a)}, smith_correlated{}, schlick{T(0)}};
        double worst = 0;
        T largest_fresnel = 0;
        int bad = 0;
        for (int i = 0; i < 20000; ++i) {
            const auto v = random.grazing_direction<T>(1e-4), l = random.grazing_direction<T>(1e-4);
            const T d = T(4) * ulp;
            const T here = brdf.f_cos(v, l), there = brdf.f_cos(v * (1 + d), l * (1 - d));
            const double turn = static_cast<double>((d * lobe::length(v - l) + 2 * ulp) / lobe::length(v + l));
            const double bound =
                turn * 2 / static_cast<double>(a) + 2 * static_cast<double>(d) + 50 * static_cast<double>(ulp);
            worst = larger(worst, std::abs(static_cast<double>(there / here) - 1) / bound);
            largest_fresnel = larger(largest_fresnel, std::abs(black.f(v * (1 + d), v * (1 + d))));
            const vec2<T> x{static_cast<T>(random() * 0.9999), static_cast<T>(random() * 0.9999)};
            bad += !valid(brdf.sample(v * (1 + d), x));
        }
        INFO("alpha " << a << ": " << worst << " of the bound");
        CHECK(worst < 1);
        CHECK(bad == 0);
        CHECK(largest_fresnel == 0);  // v.m above 1 is 1, so F0 = 0 stays 0 and never goes below
    }
}

TEMPLATE_TEST_CASE("limits: directions that are not unit at all", "[limits]", float, double) {
    using T = TestType;
    // Homogeneous, and so right to the bit for powers of two: D and Lambda of degree 0, the projected area of degree 1.
    // (f, pdf and sample are not: undefined.)
    random_numbers random(3);
    const alpha<T> a(T(0.3));
    const auto homogeneous = [&](const std::string& name, const auto& ndf) {
        int bad = 0;
        for (int i = 0; i < 500; ++i) {
            const auto m = random.grazing_direction<T>(1e-3), w = random.direction<T>();
            for (const T k : {T(0.25), T(2), T(1024)}) {
                bad += ndf.D(k * m) != ndf.D(m);
                const T area = ndf.projected_area(w);
                // Beckmann's from below is a subnormal soon
                bad += area > T(1e-30f) && ndf.projected_area(k * w) != k * area;
                bad += ndf.lambda(k * w) != ndf.lambda(w);
            }
        }
        INFO(name);
        CHECK(bad == 0);
    };
    homogeneous("ggx", ggx{a});
    homogeneous("ggx, anisotropic", ggx{alpha_xy<T>(T(0.1), T(0.7))});
    homogeneous("beckmann", beckmann{a});
    homogeneous("student_t", lobe::student_t{a, T(3)});
    homogeneous("gtr", lobe::tabulated{lobe::gtr{a, T(1.5)}});
    homogeneous("blinn_phong", lobe::blinn_phong{a});
    homogeneous("mixture", lobe::mixture{ggx{a}, beckmann{a}, T(0.25)});
    // A tangent of any length, a normal of none but 1
    const lobe::frame<T> one(normal<T>, vec3<T>{T(0.6), T(0.8), T(0.5)}),
        same(normal<T>, vec3<T>{T(0.6), T(0.8), T(0.5)} * T(1024));
    CHECK(one.t == same.t);
    CHECK(one.b == same.b);
    // The zero vector is below the horizon; it has no direction, though, and there is a 0/0 on the way
    if (!divisions_watched)
        every_brdf(T(0.1), [&](const std::string& name, const auto& b) {
            INFO(name);
            CHECK(b.pdf(vec3<T>(0), normal<T>) == 0);
            CHECK(b.f_cos(vec3<T>(0), normal<T>) == decltype(b.f_cos(normal<T>, normal<T>))(T(0)));
            CHECK(failed(b.sample(vec3<T>(0), {T(0.3), T(0.6)})));
        });
}

TEMPLATE_TEST_CASE("limits: a NaN in a direction never becomes light", "[limits]", float, double) {
    using T = TestType;
    const vec3<T> unknown(not_a_number<T>), l{T(-0.6), 0, T(0.8)};
    const auto dark = [](T x) { return std::isnan(x) || x == 0; };
    const auto all_dark = [&]<class S>(const S& s) {
        if constexpr (std::same_as<S, T>)
            return dark(s);
        else
            return dark(s.x) && dark(s.y) && dark(s.z);
    };
    every_brdf(T(0.1), [&](const std::string& name, const auto& b) {
        INFO(name);
        const vec3<T> half_known{T(0.6), 0, not_a_number<T>};
        for (const auto& [v, w] :
             {std::pair{unknown, l}, std::pair{l, unknown}, std::pair{unknown, unknown}, std::pair{half_known, l}}) {
            CHECK(all_dark(b.f(v, w)));
            CHECK(all_dark(b.f_cos(v, w)));
            CHECK(dark(b.pdf(v, w)));
            CHECK(dark(b.evaluate(v, w).pdf));
        }
        CHECK(failed(b.sample(unknown, {T(0.3), T(0.6)})));
        CHECK(failed(b.sample(half_known, {T(0.3), T(0.6)})));
    });
    // where one number is asked for, a NaN is the edge: a cosine of zero
    const lobe::sum both{microfacet{ggx{alpha<T>(T(0.1))}, smith_correlated{}, schlick{T(0.5)}}, lobe::lambert{T(0.5)}};
    for (const T x : {T(0.1), T(0.9)})  // one lobe is drawn, then the other, which does not look at v.x
        CHECK(failed(both.sample(vec3<T>{not_a_number<T>, 0, T(0.8)}, {x, T(0.6)})));
    const lobe::coupled base{lobe::lambert{T(0.5)}, lobe::fresnel_coupling{schlick{T(0.5)}}};
    CHECK(failed(base.sample(unknown, {T(0.3), T(0.6)})));
    const auto table = lobe::bake_dfg<T>(smith_correlated{}, {.size = 8, .order = 16});
    CHECK(table(not_a_number<T>, alpha<T>(T(0.3))).albedo() == table(T(0), alpha<T>(T(0.3))).albedo());
}

TEMPLATE_TEST_CASE("limits: spectra of zeros and ones", "[limits]", float, double) {
    using T = TestType;
    using S = vec3<T>;
    const S black(0), white(1);
    const vec3<T> v{T(0.6), 0, T(0.8)}, l{T(-0.6), 0, T(0.8)};
    const alpha<T> a(T(0.3));
    // reflects nothing: the value is zero, the sample none the less a sample
    const auto check_black = [&](const auto& b) {
        CHECK(b.f(v, l) == black);
        CHECK(b.f_cos(v, l) == black);
        const auto s = b.sample(v, {T(0.3), T(0.6)});
        CHECK(s.weight == black);
        CHECK(in_range(s.pdf));
    };
    check_black(lobe::lambert{black});
    check_black(lobe::burley{black, T(0.5)});
    check_black(lobe::oren_nayar{black, T(0.5)});
    check_black(lobe::eon{black, T(0.5)});
    check_black(microfacet{ggx{a}, smith_correlated{}, schlick{black, black}});
    check_black(lobe::sum{lobe::lambert{black}, microfacet{ggx{a}, smith_correlated{}, schlick{black, black}}});
    check_black(lobe::weighted{T(0), lobe::lambert{white}});
    // F0 = 0 keeps Schlick's grazing reflectance: black only seen along the normal
    const microfacet grey{ggx{a}, smith_correlated{}, schlick{black}};
    CHECK(grey.f(normal<T>, normal<T>) == black);
    CHECK(grey.f(v, l).x > 0);
    // the weights of image-based light: what F0 = 0 leaves, a white base returns
    const auto terms = lobe::dfg_terms<T>{T(0.7), T(0.1)};
    const auto nothing = lobe::fdez_aguera{}(terms, black, black), rest = lobe::fdez_aguera{}(terms, black, white);
    const auto mirror = lobe::fdez_aguera{}(terms, white);
    CHECK(nothing.radiance == S(T(0.1)));  // the bias: Schlick's grazing part
    CHECK(std::abs(rest.radiance.x + rest.irradiance.x - 1) <= 4 * limits<T>::epsilon());
    CHECK(std::abs(mirror.radiance.x + mirror.irradiance.x - 1) <= 8 * limits<T>::epsilon());
    // couplings: a lobe that reflects nothing leaves all to the base, one that reflects all nothing
    const auto none = [](T) { return S(0); };
    const auto all = [](T) { return S(1); };
    CHECK(lobe::albedo_coupling{none}(v, l) == white);
    CHECK(lobe::albedo_coupling{all}(v, l) == black);
    CHECK(lobe::reciprocal_coupling{none, black}(v, l) == white);
    CHECK(lobe::complement{lobe::coat_share{schlick{white}, T(1)}}(v, l) == black);
    CHECK(lobe::metallic_roughness(black, T(1), a).f(normal<T>, normal<T>) == black);
}

TEMPLATE_TEST_CASE("limits: split-sum terms at the edges of the table and beyond", "[limits]", float, double) {
    using T = TestType;
    const auto table = lobe::bake_dfg<T>(smith_correlated{}, {.size = 8, .order = 16});
    for (const T a : {limits<T>::denorm_min(), T(1e-8), T(0.3), T(1), T(3)}) {
        const alpha<T> width(a);
        for (const T mu : {T(-1), T(0), limits<T>::denorm_min(), T(0.3), T(1), T(1) + limits<T>::epsilon(), T(2)}) {
            const auto t = table(mu, width);
            CHECK(t.scale >= 0);
            CHECK(t.bias >= 0);
            CHECK(t.albedo() <= 1 + T(2e-5));  // the nodes are of order 16
        }
        CHECK(table(T(-1), width).scale == table(T(0), width).scale);
        for (const T mu : {T(2), limits<T>::max(), limits<T>::infinity()}) {
            CHECK(table(mu, width).scale == table(T(1), width).scale);
            CHECK(table(mu, width).bias == table(T(1), width).bias);
        }
        CHECK(table(-limits<T>::infinity(), width).bias == table(T(0), width).bias);
    }
    CHECK(table(T(0.3), alpha<T>(T(3))).scale == table(T(0.3), alpha<T>(T(1))).scale);
    CHECK(table.average(alpha<T>(T(3))).scale == table.average(alpha<T>(T(1))).scale);
    // a mirror seen along its normal
    CHECK(std::abs(table(T(1), alpha<T>(T(1e-8))).scale - 1) < T(2e-5));
}

#ifndef NDEBUG

namespace {

/// What f() says on standard error before it aborts; empty if it does not.
template <class F>
std::string last_words(const F& f) {
    std::array<int, 2> ends{};
    if (pipe(ends.data())) throw std::runtime_error("no pipe");
    const pid_t child = fork();
    if (child == 0) {
        std::signal(SIGABRT, SIG_DFL);
        dup2(ends[1], STDERR_FILENO);
        close(ends[0]);
        f();
        _exit(0);
    }
    close(ends[1]);
    std::string said;
    std::array<char, 512> part{};
    for (ssize_t n; (n = read(ends[0], part.data(), part.size())) > 0;)
        said.append(part.data(), static_cast<std::size_t>(n));
    close(ends[0]);
    int status = 0;
    waitpid(child, &status, 0);
    return WIFSIGNALED(status) && WTERMSIG(status) == SIGABRT ? said : "";
}

}  // namespace

TEMPLATE_TEST_CASE("limits: parameters outside the domain end in an assert that says so", "[limits]", float, double) {
    using T = TestType;
    const T inf = limits<T>::infinity();
    const auto expect = [](const std::string& sentence, const auto& f) {
        const std::string said = last_words(f);
        INFO("expected: " << sentence << "\nsaid: " << said);
        CHECK(said.find(sentence) != std::string::npos);
    };
    for (const T bad : {T(0), T(-0.0), T(-1), not_a_number<T>, inf}) {
        expect("alpha must be above 0 and finite", [&] { (void)alpha<T>(bad); });
        expect("both widths must be above 0 and finite", [&] { (void)alpha_xy<T>(bad, T(1)); });
        expect("both widths must be above 0 and finite", [&] { (void)alpha_xy<T>(T(1), bad); });
        expect("eta must be above 0 and its square finite", [&] { (void)lobe::dielectric<T>(bad); });
        expect("eta must be above 0 and its square finite", [&] {
            (void)lobe::dielectric<vec3<T>>(vec3<T>{T(1), T(1), bad});
        });
    }
    expect("eta must be above 0 and its square finite",
           [] { (void)lobe::dielectric<T>(2 * std::sqrt(limits<T>::max())); });
    CHECK(last_words([] { (void)alpha<T>(limits<T>::max()); }).empty());
    CHECK(last_words([] { (void)lobe::dielectric<T>(std::sqrt(limits<T>::max()) / 2); }).empty());
    for (const T bad : {T(0), T(-0.0), T(-1), not_a_number<T>}) {
        expect("eta must be above 0", [&] { (void)lobe::f0_from_ior(bad); });
        expect("eta must be in [1/1000, 1e9]", [&] { (void)lobe::conductor<T>(bad, T(1)); });
    }
    // a texture without a floor
    expect("alpha must be above 0", [] { (void)alpha<T>::from_roughness(T(0)); });
    // whose square is 0
    expect("alpha must be above 0", [] { (void)alpha<T>::from_roughness(limits<T>::denorm_min()); });
    expect("alpha must be above 0", [] { (void)alpha<T>::from_roughness(not_a_number<T>, T(1e-4)); });
    expect("both widths must be above 0", [] { (void)alpha_xy<T>::from_disney(T(0), T(0)); });
    expect("both widths must be above 0", [] { (void)alpha_xy<T>::from_imageworks(T(0.5), T(1)); });
    expect("both widths must be above 0", [] { (void)alpha_xy<T>::from_openpbr(T(0.5), T(1)); });
    for (const T bad : {T(-1), not_a_number<T>, inf})
        expect("k must be in [0, 1e9]", [&] { (void)lobe::conductor<T>(T(1), bad); });
    expect("eta must be in [1/1000, 1e9]", [&] { (void)lobe::conductor<T>(inf, T(1)); });
    for (const T bad : {T(-0.01), T(1.01), not_a_number<T>, inf}) {
        expect("F0 must be in [0,1]", [&] { (void)schlick<T>(bad); });
        expect("F0 must be in [0,1]", [&] { (void)schlick<vec3<T>>(vec3<T>{T(0.5), T(0.5), bad}); });
        expect("F90 must be in [0,1]", [&] { (void)schlick{T(0.5), bad}; });
        expect("the tint must be in [0,1]", [&] { (void)lobe::f82_tint<T>(T(0.5), bad); });
        expect("F0 must be in [0,1)", [&] { (void)lobe::ior_from_f0(bad); });
        expect("the base colour must be in [0,1]",
               [&] { (void)lobe::metallic_roughness(bad, T(0), alpha<T>(T(0.1))); });
        expect("metallic must be in [0,1]", [&] { (void)lobe::metallic_roughness(T(1), bad, alpha<T>(T(0.1))); });
        expect("the weight must be in [0,1]",
               [&] { (void)lobe::coated(lobe::lambert{T(1)}, ggx{alpha<T>(T(0.1))}, bad); });
        CHECK(aborts([&] { (void)lobe::lambert<T>(bad); }));
    }
    expect("F0 must be in [0,1)", [] { (void)lobe::ior_from_f0(T(1)); });
    expect("the weight must not be negative", [] { (void)lobe::weighted{not_a_number<T>, lobe::lambert{T(1)}}; });
    const auto none = [](T) { return T(0); };
    expect("the average albedo must be below 1", [&] { (void)lobe::reciprocal_coupling{none, T(1)}; });
    // cosines of quadrature
    const microfacet mirror{ggx{alpha<T>(T(0.3))}, smith_correlated{}, perfect_reflector{}};
    for (const T bad : {T(0), T(-0.5), T(1.5), not_a_number<T>})
        CHECK(aborts([&] { (void)lobe::directional_albedo(mirror, bad); }));
    CHECK(aborts([&] { (void)lobe::frame<T>(normal<T>, normal<T>); }));  // a tangent along the normal
}

#endif
