// Every sampler of half vectors: that its directions have the density it states (by their histogram too:
// chi_squared.cpp), what it loses, and how much it varies.
#include "catch.hpp"
#include "ndf_support.hpp"

#include <lobe/brdf/ggx_samplers.hpp>
#include <lobe/brdf/microfacet.hpp>
#include <lobe/energy/albedo.hpp>
#include <lobe/fresnel/schlick.hpp>
#include <lobe/ndf/ggx.hpp>
#include <lobe/sampling/points.hpp>

#include <xsimd/xsimd.hpp>

#include <set>

using lobe::all_normals;
using lobe::alpha;
using lobe::alpha_xy;
using lobe::ggx;
using lobe::microfacet;
using lobe::vec2;
using lobe::vec3;
using lobe::visible_bounded_caps;
using lobe::visible_heitz2018;
using lobe::visible_normals;

namespace {

constexpr double pi = 3.141592653589793;
constexpr double grazing = 0.0017453283658983088;  // cos(89.9 degrees)

vec3<double> at(double mu, double phi = 0.9) {
    const double sine = std::sqrt((1 - mu) * (1 + mu));
    return {sine * std::cos(phi), sine * std::sin(phi), mu};
}

struct situation {
    double ax, ay, mu;
};
const situation situations[] = {
    {0.001, 0.001, 1},    {0.001, 0.001, 0.5}, {0.001, 0.001, grazing}, {0.05, 0.05, 0.1}, {0.1, 0.1, grazing},
    {0.3, 0.3, 0.2},      {1, 1, 0.5},         {1, 1, grazing},         {1, 1, 1},         {0.001, 0.3, 0.5},
    {0.6, 0.05, grazing}, {0.02, 1, 0.05},     {2.5, 1.5, 0.3}};

/// A view in float. (Not inlined: GCC 12 at -O2 optimises the conversion of a pair of numbers from double to float and
/// back away.)
[[gnu::noinline]] vec3<float> float_view(random_numbers& random) { return random.grazing_direction<float>(1e-3); }

double angle(const vec3<double>& a, const vec3<double>& b) {
    return std::atan2(lobe::length(lobe::cross(a, b)), lobe::dot(a, b));
}

template <class Sampler>
auto mirror(const situation& s, const Sampler& sampler) {
    return microfacet{ggx{alpha_xy{s.ax, s.ay}}, lobe::smith_correlated{}, lobe::perfect_reflector{}, sampler};
}

template <class F>
void for_each_sampler(const F& f) {
    f("visible_normals", visible_normals{});
    f("visible_heitz2018", visible_heitz2018{});
    f("visible_bounded_caps", visible_bounded_caps{});
    f("all_normals", all_normals{});
}

/// pdf |dl/du| - 1, worst over random u where the light is above the horizon.
template <class B, class Sampler>
double jacobian_error(const B& brdf, const Sampler& sampler, const situation& s, std::uint64_t seed) {
    const ggx ndf{alpha_xy{s.ax, s.ay}};
    const vec3<double> v = at(s.mu);
    const auto light = [&](const vec2<double>& u) {
        return lobe::reflect(v, lobe::normalize(sampler.sample(ndf, v, u)));
    };
    random_numbers random(seed);
    double worst = 0;
    int tried = 0;
    for (int k = 0; k < 400; ++k) {
        const vec2<double> u{random.between(0.01, 0.99), random.between(0.01, 0.99)};
        const vec3<double> l = light(u);
        if (!(l.z > 1e-3)) continue;
        ++tried;
        worst = larger(worst, std::abs(brdf.pdf(v, l) * jacobian(light, u) - 1));
    }
    return tried ? worst : 1;
}

}  // namespace

TEST_CASE("pdf is the Jacobian of the map from the square to light directions", "[samplers]") {
    std::uint64_t seed = 1;
    for (const situation& s : situations)
        for_each_sampler([&](const char* name, const auto& sampler) {
            const double error = jacobian_error(mirror(s, sampler), sampler, s, ++seed);
            INFO(name << " alpha " << s.ax << ' ' << s.ay << " mu " << s.mu << ": " << error);
            CHECK(error < 1e-6);
        });
}

namespace {

struct moments {
    double mean = 0, variance = 0, largest = 0, failed = 0;
};

template <class B>
moments of_weights(const B& brdf, const vec3<double>& v, std::uint32_t count) {
    moments m;
    for (std::uint32_t i = 0; i < count; ++i) {
        const auto s = brdf.sample(v, lobe::hammersley<double>(i, count));
        const double step = s.weight - m.mean;  // Welford's sums
        m.mean += step / (i + 1);
        m.variance += step * (s.weight - m.mean);
        m.largest = larger(m.largest, s.weight);
        if (!(s.pdf > 0)) m.failed += 1.0 / count;
    }
    m.variance /= count;
    return m;
}

/// What E[weight^2] - E[weight]^2 is, by quadrature: int f_cos^2/pdf dl - (int f_cos dl)^2.
template <class B>
double exact_variance(const B& brdf, const vec3<double>& v) {
    const auto square = [&](const vec3<double>& l) {
        const auto e = brdf.evaluate(v, l);
        return e.pdf > 0 ? e.f_cos * e.f_cos / e.pdf : 0;  // a node may round to the horizon
    };
    const double albedo = lobe::directional_albedo(brdf, v, {.order = 96}).value;
    return lobe::hemisphere_integral(square, v, brdf.width(), false, {.order = 96}).value - albedo * albedo;
}

}  // namespace

TEST_CASE("weight * pdf is f_cos, and the mean of the weights the albedo", "[samplers]") {
    const std::uint32_t count = 1u << 17;
    for (const situation& s : situations)
        for_each_sampler([&](const char* name, const auto& sampler) {
            const auto brdf = mirror(s, sampler);
            const vec3<double> v = at(s.mu);
            random_numbers random(11);
            double product = 0, density = 0, shared = 0;
            for (int i = 0; i < 2000; ++i) {
                const double u = random();
                const auto drawn = brdf.sample(v, {u, random()});
                if (!(drawn.pdf > 0)) continue;
                const auto e = brdf.evaluate(v, drawn.l);
                // l is known to 2e-16, so the slopes of v + l to 2e-16/(s.z alpha), which D feels fourfold, D^2 over 1
                // + slope^2/alpha^2.
                const double conditioning = 1 + 4 / ((v.z + drawn.l.z) * std::min(s.ax, s.ay)) +
                                            4 / (v.z + drawn.l.z) / lobe::length(v + drawn.l);
                product = larger(product, std::abs(drawn.weight * drawn.pdf / e.f_cos - 1) / conditioning);
                density = larger(density, std::abs(drawn.pdf / e.pdf - 1) / conditioning);
                shared = larger({shared, std::abs(e.pdf / brdf.pdf(v, drawn.l) - 1),
                                 std::abs(e.f_cos / brdf.f_cos(v, drawn.l) - 1)});
            }
            const moments m = of_weights(brdf, v, count);
            const double albedo = lobe::directional_albedo(brdf, v, {.tolerance = 1e-7}).value;
            INFO(name << " alpha " << s.ax << ' ' << s.ay << " mu " << s.mu << ": " << product << ' ' << density << ' '
                      << shared << "; mean weight " << m.mean << ", albedo " << albedo << ", variance " << m.variance);
            CHECK(product < 16e-16);
            CHECK(density < 16e-16);
            CHECK(shared < 1e-14);
            // Random points would be within 5 sigma; Hammersley's are better by n^(1/4) at least even where samples
            // fail at once beyond an edge: a tenth of that.
            CHECK(std::abs(m.mean - albedo) < 0.5 * std::sqrt(m.variance / count) + 2e-6);
        });
}

TEST_CASE("rejection and variance of the samplers, by sampling, by quadrature and as measured elsewhere",
          "[samplers]") {
    struct figure {
        double alpha, mu, rejected, variance, digit;
    };
    // Independently computed, with half a unit of the last digit quoted. 2^18 points are sure to 1e-3 of rejection and
    // 0.2 % of variance.
    const auto expect = [](const char* name, const auto& sampler, std::initializer_list<figure> figures) {
        for (const figure& f : figures) {
            const auto brdf = mirror({f.alpha, f.alpha, f.mu}, sampler);
            const moments m = of_weights(brdf, at(f.mu), 1u << 18);
            const double exact = exact_variance(brdf, at(f.mu));
            INFO(name << " alpha " << f.alpha << " mu " << f.mu << ": rejected " << m.failed << ", variance "
                      << m.variance << ", exactly " << exact);
            if (f.rejected >= 0) CHECK(std::abs(m.failed - f.rejected) < 0.001);
            CHECK(m.variance == Catch::Approx(exact).epsilon(0.002).margin(1e-9));
            CHECK(std::abs(exact - f.variance) <= f.digit);
        }
    };
    expect("visible_normals", visible_normals{},
           {{1, 0.5, 0.333, 0.149, 0.0005}, {0.1, 1, -1, 0.0103, 0.00005}, {0.1, 0.05, -1, 0.0337, 0.00005}});
    expect("visible_heitz2018", visible_heitz2018{},
           {{1, 0.5, 0.333, 0.149, 0.0005}, {0.1, 1, -1, 0.0103, 0.00005}, {0.1, 0.05, -1, 0.0337, 0.00005}});
    // (bounded at alpha 0.1, mu 0.05: 0.03105, quoted as 0.0310)
    expect("visible_bounded_caps", visible_bounded_caps{},
           {{1, 0.5, 0, 0.032, 0.0005}, {0.1, 1, 0, 0.0005, 0.00005}, {0.1, 0.05, -1, 0.0310, 0.0001}});
    CHECK(of_weights(mirror({1, 1, 0.5}, visible_bounded_caps{}), at(0.5), 1u << 18).failed == 0);
    // All normals: a sampled estimate of 3.02 with weights up to 56 missed the tail. Weights reach 180, and their
    // variance is 3.494.
    const auto all = mirror({0.1, 0.1, 0.05}, all_normals{});
    const moments m = of_weights(all, at(0.05), 1u << 18);
    INFO(m.variance << ' ' << m.largest);
    CHECK(exact_variance(all, at(0.05)) == Catch::Approx(3.494).margin(0.0005));
    CHECK(m.variance == Catch::Approx(3.494).epsilon(0.01));
    CHECK((m.largest > 150 && m.largest < 181));
}

TEST_CASE("the order of the samplers: bounded caps fail least and weigh least", "[samplers]") {
    random_numbers random(12);
    for (int i = 0; i < 40; ++i) {
        const double a = random.log_between(0.01, 1), b = i % 2 ? a : random.log_between(0.01, 1),
                     mu = random.log_between(0.01, 1);
        const moments caps = of_weights(mirror({a, b, mu}, visible_normals{}), at(mu), 4096);
        const moments bounded = of_weights(mirror({a, b, mu}, visible_bounded_caps{}), at(mu), 4096);
        INFO(a << ' ' << b << ' ' << mu);
        CHECK(bounded.failed <= caps.failed + 1e-3);  // 4096 points: a few more or less
        CHECK(bounded.variance <= caps.variance * 1.01 + 1e-6);
        CHECK(bounded.largest <= 1 + 1e-14);
        CHECK(caps.largest <= 1 + 1e-14);
    }
}

TEST_CASE("bounded caps: by hand, and no light direction is left out", "[samplers]") {
    // a = 1: k = 0, area = S/2 = 1/2, pdf = 1/(2 pi): light directions uniform on the hemisphere
    for (double mu : {grazing, 0.5, 1.0}) {
        const auto brdf = mirror({1, 1, mu}, visible_bounded_caps{});
        CHECK(brdf.pdf(at(mu), at(0.3, 2)) == Catch::Approx(1 / (2 * pi)).epsilon(1e-14));
        CHECK(brdf.sample(at(mu), {0.25, 0.5}).pdf == Catch::Approx(1 / (2 * pi)).epsilon(1e-14));
    }
    // a = 0.5, mu = 1: s = 1, k = 0.75/(1.25) = 0.6, S = 1, area = 0.8
    CHECK(visible_bounded_caps{}.area(ggx{alpha{0.5}}, vec3<double>{0, 0, 1}, 1.0, 1.0, 1.0) ==
          Catch::Approx(0.8).epsilon(1e-15));
    // The whole upper hemisphere of l is within the cap: mapped back to the surface of width 1, the mirrored view that
    // l's half vector was drawn from lies above -b. o = 2 (V.M) M - V, M = unit unstretched half vector (independent of
    // `sample`).
    random_numbers random(13);
    double slack = 1;
    for (int i = 0; i < 200000; ++i) {
        const double ax = random.log_between(1e-3, 3), ay = random.log_between(1e-3, 3);
        const vec3<double> v = random.grazing_direction(1e-3), l = random.grazing_direction(1e-6), h = v + l;
        const vec3<double> M = lobe::normalize(vec3<double>{h.x / ax, h.y / ay, h.z}),
                           V = lobe::normalize(vec3<double>{ax * v.x, ay * v.y, v.z});
        const double a = std::min({ax, ay, 1.0}), s = 1 + std::hypot(v.x, v.y),
                     k = (1 - a * a) * s * s / (s * s + a * a * v.z * v.z);
        slack = smaller(slack, (2 * lobe::dot(V, M) * M - V).z + k * V.z);
    }
    INFO(slack);
    CHECK(slack > -1e-12);
}

TEST_CASE("samplers in float: angles at the smallest alpha, unit normals at the corners", "[samplers]") {
    const float last = 0x1.fffffep-1f;
    for_each_sampler([&](const char* name, const auto& sampler) {
        using S = std::remove_cvref_t<decltype(sampler)>;
        const bool is_cap = std::is_same_v<S, visible_normals> || std::is_same_v<S, visible_bounded_caps>;
        double unit = 0, below = 0, facing = 0;
        bool finite = true;
        for (float a : {1e-4f, 0.01f, 1.0f})
            for (const vec3<float> v :
                 {vec3<float>{0, 0, 1}, vec3<float>{1e-22f, 0, 1}, vec3<float>{-1e-17f, 1e-17f, 1},
                  vec3<float>{0.8f, 0, 0.6f}, vec3<float>{0, -1, 1e-3f}, vec3<float>{0.6f, 0.8f, 1e-6f},
                  vec3<float>{1, 0, 1e-30f}})
                for (float x : {0.0f, 1e-30f, 1e-7f, 0.5f, last})
                    for (float y : {0.0f, 0.25f, 0.3f, 0.5f, 0.75f, last}) {
                        const ggx ndf{alpha{a}};
                        const vec3<float> m = lobe::normalize(sampler.sample(ndf, v, vec2<float>{x, y}));
                        const microfacet brdf{ndf, lobe::smith_correlated{}, lobe::perfect_reflector{}, sampler};
                        const auto s = brdf.sample(v, {x, y});
                        unit = larger(unit, std::abs(static_cast<double>(lobe::length(m)) - 1));
                        below = smaller(below, static_cast<double>(m.z));
                        facing = smaller(facing, static_cast<double>(lobe::dot(v, m)));
                        finite = finite && std::isfinite(m.x) && std::isfinite(s.weight) && std::isfinite(s.pdf) &&
                                 s.weight >= 0 && s.pdf >= 0;
                    }
        INFO(name << ' ' << unit << ' ' << below << ' ' << facing);
        CHECK(finite);
        CHECK(unit < 3e-7);
        CHECK(below >= 0);
        // visible_normals may turn a facet away where u.x rounds to 1 and v is horizontal: the sample then fails
        if (!std::is_same_v<S, all_normals> && !std::is_same_v<S, visible_normals>) CHECK(facing >= -1e-6);

        random_numbers random(14);
        std::set<float> angles;
        double worst = 0, conditioned = 0, smallest = 0;
        const int n = 200000;
        for (int i = 0; i < n; ++i) {
            const float a = i % 2 ? 1e-4f : static_cast<float>(random.log_between(1e-4, 1));
            const double wide = static_cast<double>(a);
            const vec3<float> v = float_view(random);
            const vec2<float> u{static_cast<float>(random()) * last, static_cast<float>(random()) * last};
            const vec3<double> m(sampler.sample(ggx{alpha{a}}, v, u)), view(v);
            const vec3<double> exact = sampler.sample(ggx{alpha{wide}}, view, vec2<double>(u));
            const double error = angle(m, exact);
            // A cap's normal is the sum of the view and of a direction on the cap, of length 2 cos, each with an error
            // of 1 ULP.
            const vec3<double> M = lobe::normalize(vec3<double>{exact.x, exact.y, wide * exact.z});
            const vec3<double> V = lobe::normalize(vec3<double>{wide * view.x, wide * view.y, view.z});
            worst = larger(worst, error);
            conditioned = larger(conditioned, error / (1 + 1 / std::max(1e-9, lobe::dot(M, V))));
            if (i % 2) {
                smallest = larger(smallest, error);
                angles.insert(static_cast<float>(std::hypot(m.x, m.y)));
            }
        }
        INFO(name << " errs by " << worst << " radian, " << conditioned << " conditioned, " << smallest
                  << " at alpha 1e-4; distinct " << angles.size());
        CHECK(static_cast<double>(angles.size()) > 0.95 * n / 2);
        CHECK(smallest < 6e-8);
        CHECK(conditioned < 3 * 6e-8);
        if (!is_cap) CHECK(worst < 7 * 6e-8);  // a few roundings, none amplified
    });
}

TEST_CASE("Heitz's sampler is the printed one, without its cancellations", "[samplers]") {
    // The listing of the paper's appendix, in double and in float.
    const auto printed = [](auto ax, auto ay, const auto& v, const auto& u) {
        using T = decltype(ax);
        const vec3<T> V = lobe::normalize(vec3<T>{ax * v.x, ay * v.y, v.z});
        const T lensq = V.x * V.x + V.y * V.y;
        const vec3<T> T1 = lensq > 0 ? vec3<T>{-V.y, V.x, 0} * (1 / std::sqrt(lensq)) : vec3<T>{1, 0, 0};
        const vec3<T> T2 = lobe::cross(V, T1);
        const T r = std::sqrt(u.x), phi = T(2 * pi) * u.y;
        const T t1 = r * std::cos(phi), s = (1 + V.z) / 2;
        const T t2 = (1 - s) * std::sqrt(1 - t1 * t1) + s * r * std::sin(phi);
        const vec3<T> N = t1 * T1 + t2 * T2 + std::sqrt(std::max(T(0), 1 - t1 * t1 - t2 * t2)) * V;
        return lobe::normalize(vec3<T>{ax * N.x, ay * N.y, std::max(T(0), N.z)});
    };
    random_numbers random(16);
    double in_double = 0, in_float = 0, ours = 0;
    for (int i = 0; i < 100000; ++i) {
        const float ax = static_cast<float>(random.log_between(1e-3, 1)),
                    ay = i % 2 ? ax : static_cast<float>(random.log_between(1e-3, 1));
        const double wx = static_cast<double>(ax), wy = static_cast<double>(ay);
        const vec3<float> v = float_view(random);
        const vec2<float> u{static_cast<float>(random()) * 0.999f, static_cast<float>(random())};
        const vec3<double> view(v), m = visible_heitz2018{}.sample(ggx{alpha_xy{wx, wy}}, view, vec2<double>(u));
        const vec3<double> M = lobe::normalize(vec3<double>{m.x / wx, m.y / wy, m.z}),
                           V = lobe::normalize(vec3<double>{wx * view.x, wy * view.y, view.z});
        // In double where the printed form does not cancel; the angle feels an error of M at most max(a)/min(a) times
        // over.
        if (lobe::dot(M, V) > 0.1 && M.z > 0.1)
            in_double = larger(in_double,
                               angle(m, printed(wx, wy, view, vec2<double>(u))) * std::min(wx, wy) / std::max(wx, wy));
        if (i % 2 == 0) continue;
        in_float = larger(in_float, angle(m, vec3<double>(printed(ax, ay, v, u))));
        ours = larger(ours, angle(m, vec3<double>(visible_heitz2018{}.sample(ggx{alpha_xy{ax, ay}}, v, u))));
    }
    INFO("printed against ours in double " << in_double << "; in float " << in_float << ", ours " << ours);
    CHECK(in_double < 1e-14);  // tens of roundings of 1e-16, up to 10 times over
    CHECK(ours < 7 * 6e-8);
    CHECK(in_float > 10 * ours);
}

namespace {

/// A distribution that is not GGX, and that cannot be sampled.
struct another {
    using scalar = double;
    static constexpr bool isotropic = true;
    double D(const vec3<double>& m) const { return m.z < 0 ? 0 : 1 / pi; }
    double projected_area(const vec3<double>& w) const { return (1 + w.z) / 2; }
    double lambda(const vec3<double>& w) const { return (1 / w.z - 1) / 2; }
    vec2<double> width() const { return {1, 1}; }
};

}  // namespace

TEST_CASE("samplers swap in one word; those of GGX take nothing else", "[samplers]") {
    static_assert(lobe::distribution<another>);
    static_assert(lobe::normal_sampler<visible_heitz2018, ggx<float>> &&
                  lobe::normal_sampler<visible_bounded_caps, ggx<double, alpha_xy<double>>>);
    static_assert(!lobe::normal_sampler<visible_heitz2018, another> &&
                  !lobe::normal_sampler<visible_bounded_caps, another>);
    static_assert(!lobe::normal_sampler<visible_normals, another> && !lobe::normal_sampler<all_normals, another>);
    for_each_sampler([](const char*, const auto& sampler) {
        using S = std::remove_cvref_t<decltype(sampler)>;
        static_assert(sizeof(microfacet<ggx<float>, lobe::smith_correlated, lobe::schlick<vec3<float>>, S>) == 16);
    });
    // one density, two maps; and evaluating does not depend on the sampler
    const vec3<double> v = at(0.3), l = at(0.6, -2);
    const situation s{0.2, 0.5, 0.3};
    CHECK(mirror(s, visible_heitz2018{}).pdf(v, l) == mirror(s, visible_normals{}).pdf(v, l));
    CHECK(mirror(s, visible_bounded_caps{}).f_cos(v, l) == mirror(s, visible_normals{}).f_cos(v, l));
    CHECK(mirror(s, visible_bounded_caps{}).pdf(v, l) > mirror(s, visible_normals{}).pdf(v, l));
    // below the horizon nothing is drawn, and nothing is NaN
    for_each_sampler([&](const char* name, const auto& sampler) {
        for (const vec3<double>& below : {vec3<double>{0.6, 0, -0.8}, vec3<double>{0, 0, -1}, vec3<double>{1, 0, 0}}) {
            const auto drawn = mirror(s, sampler).sample(below, {0.3, 0.7});
            INFO(name << ' ' << below.z);
            CHECK((drawn.pdf == 0 && drawn.weight == 0 && drawn.l == vec3<double>{0, 0, 1}));
            CHECK(mirror(s, sampler).pdf(below, l) == 0);
        }
    });
}

TEST_CASE("samplers on packs give what their lanes give", "[samplers]") {
    using pack = xsimd::batch<float>;
    for_each_sampler([](const char* name, const auto& sampler) {
        const microfacet one{ggx{alpha_xy{0.3f, 0.1f}}, lobe::smith_correlated{}, lobe::schlick{0.04f}, sampler};
        const microfacet wide{ggx{alpha_xy{pack(0.3f), pack(0.1f)}}, lobe::smith_correlated{},
                              lobe::schlick{pack(0.04f)}, sampler};
        random_numbers random(15);
        double worst = 0;
        for (int trial = 0; trial < 500; ++trial) {
            float lanes[5][pack::size];
            vec3<float> v[pack::size];
            vec2<float> u[pack::size];
            for (std::size_t i = 0; i < pack::size; ++i) {
                v[i] = trial ? random.grazing_direction<float>(0.01) : vec3<float>{0, 0, 1};
                u[i] = {static_cast<float>(random()) * 0.999f, static_cast<float>(random()) * 0.999f};
                const float values[5] = {v[i].x, v[i].y, v[i].z, u[i].x, u[i].y};
                for (int k = 0; k < 5; ++k) lanes[k][i] = values[k];
            }
            const auto load = [&](int k) { return pack::load_unaligned(lanes[k]); };
            const auto s = wide.sample({load(0), load(1), load(2)}, {load(3), load(4)});
            for (std::size_t i = 0; i < pack::size; ++i) {
                const auto expected = one.sample(v[i], u[i]);
                if ((expected.pdf > 0) != (s.pdf.get(i) > 0)) {
                    // only where l grazes the horizon may the two disagree
                    if (expected.l.z < 0.999f && expected.l.z > 1e-5f) worst = 1;
                    continue;
                }
                worst = larger({worst, static_cast<double>(std::abs(s.l.x.get(i) - expected.l.x)),
                                static_cast<double>(std::abs(s.weight.get(i) - expected.weight))});
            }
        }
        INFO(name << ' ' << worst);
        CHECK(worst < 1e-5);  // a few ULP of 6e-8, times 1/alpha = 10
    });
}
