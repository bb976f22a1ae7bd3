// What an element of a plain loop costs in instructions. instructions.sh compiles this file and runs it under
// callgrind, which counts what lies between the two marks below; by itself the program does nothing. It stands alone
// and names no default, so that it compiles with the headers of other revisions too.
#include "limit.hpp"

#include <lobe/brdf/eon.hpp>
#include <lobe/brdf/ggx_samplers.hpp>
#include <lobe/brdf/metallic_roughness.hpp>
#include <lobe/brdf/microfacet.hpp>
#include <lobe/energy/dfg_table.hpp>
#include <lobe/fresnel/conductor.hpp>
#include <lobe/fresnel/dielectric.hpp>
#include <lobe/fresnel/schlick.hpp>
#include <lobe/ibl/prefilter.hpp>
#include <lobe/ndf/ggx.hpp>
#include <lobe/sampling/lattices.hpp>
#include <lobe/sampling/points.hpp>
#include <lobe/sampling/sobol.hpp>

#include <valgrind/callgrind.h>

#include <cmath>
#include <cstdint>
#include <memory>
#include <random>
#include <string>
#include <utility>

namespace {

using glm::vec2, glm::vec3;
using lobe::alpha, lobe::ggx, lobe::smith_correlated, lobe::schlick;

constexpr std::size_t count = 1024;
using stream = float[count];

struct inputs {
    stream vx, vy, vz, lx, ly, lz, mx, my, mz, mu, a, r, g, b, u1, u2, eta;
    std::uint32_t index[count];

    inputs() {
        std::mt19937 random(20240229);
        const auto between = [&](float low, float high) {
            return low + (high - low) * (static_cast<float>(random() >> 8) * 0x1p-24f);
        };
        const auto direction = [&](float* x, float* y, float* z) {
            const float cosine = between(0.05f, 1), phi = between(0, 6.28f), sine = std::sqrt(1 - cosine * cosine);
            *x = sine * std::cos(phi), *y = sine * std::sin(phi), *z = cosine;
        };
        for (std::size_t i = 0; i < count; ++i) {
            direction(vx + i, vy + i, vz + i);
            direction(lx + i, ly + i, lz + i);
            direction(mx + i, my + i, mz + i);
            for (float* s : {mu, a, r, g, b, u1, u2}) s[i] = between(0.05f, 0.95f);
            eta[i] = between(1.3f, 2.5f);
            index[i] = static_cast<std::uint32_t>(i);
        }
    }
};

/// Element i of the inputs.
struct element {
    const inputs& in;
    std::size_t i;

    vec3 v() const { return {in.vx[i], in.vy[i], in.vz[i]}; }
    vec3 l() const { return {in.lx[i], in.ly[i], in.lz[i]}; }
    vec3 m() const { return {in.mx[i], in.my[i], in.mz[i]}; }
    vec3 rgb() const { return {in.r[i], in.g[i], in.b[i]}; }
    vec2 u() const { return {in.u1[i], in.u2[i]}; }
    float mu() const { return in.mu[i]; }
    ggx<float> ndf() const { return ggx{alpha{in.a[i]}}; }
    limit::direction view() const { return {in.vx[i], in.vy[i], in.vz[i]}; }
    limit::direction light() const { return {in.lx[i], in.ly[i], in.lz[i]}; }
    limit::direction normal() const { return {in.mx[i], in.my[i], in.mz[i]}; }
    limit::rgb F0() const { return {in.r[i], in.g[i], in.b[i]}; }
    float a() const { return in.a[i]; }
    float eta() const { return in.eta[i]; }
    auto metallic() const { return lobe::metallic_roughness(rgb(), in.mu[i], alpha{in.a[i]}); }
};

/// What `use` does with the BRDF of an element, built where it is used: clang 14 does not vectorise a loop around a
/// function that returns one.
template <class Use>
auto with_brdf(const Use& use) {
    return [use](const element& e) { return use(lobe::microfacet{e.ndf(), smith_correlated{}, schlick{e.rgb()}}, e); };
}

template <class... T>
struct numbers {
    float of[sizeof...(T)];
};
template <class... T>
numbers(T...) -> numbers<T...>;

auto flat(float x) { return numbers{x}; }
auto flat(const vec2& w) { return numbers{w.x, w.y}; }
auto flat(const vec3& w) { return numbers{w.x, w.y, w.z}; }
auto flat(const lobe::dfg_terms<float>& t) { return numbers{t.scale, t.bias}; }
auto flat(const limit::direction& w) { return numbers{w.x, w.y, w.z}; }
auto flat(const limit::rgb& c) { return numbers{c.r, c.g, c.b}; }
auto flat(const limit::point& p) { return numbers{p.x, p.y}; }
auto flat(const limit::evaluated& e) { return numbers{e.f_cos.r, e.f_cos.g, e.f_cos.b, e.pdf}; }
auto flat(const limit::sampled& s) { return numbers{s.l.x, s.l.y, s.l.z, s.weight.r, s.weight.g, s.weight.b, s.pdf}; }
template <class R>
auto flat(const R& r) {
    if constexpr (requires { r.weight; })
        return numbers{r.l.x, r.l.y, r.l.z, r.weight.x, r.weight.y, r.weight.z, r.pdf};
    else
        return numbers{r.f_cos.x, r.f_cos.y, r.f_cos.z, r.pdf};
}

template <class Kernel>
[[gnu::noinline]] void loop(const inputs& in, float* __restrict out, const Kernel& kernel) {
    for (std::size_t i = 0; i < count; ++i) {
        const auto numbers = flat(kernel(element{in, i}));
        [&]<std::size_t... K>(std::index_sequence<K...>) { ((out[K * count + i] = numbers.of[K]), ...); }
        (std::make_index_sequence<sizeof numbers / sizeof(float)>{});
    }
    asm volatile("" : : "r"(out) : "memory");  // as if somebody read it
}

/// `each`: how many times an element does what is counted.
template <class Kernel>
void measure(const char* name, const inputs& in, const Kernel& kernel, std::uint32_t each = 1) {
    static float out[8 * count];
    const std::string mark = std::to_string(count * each) + ' ' + name;
    loop(in, out, kernel);  // what the first call alone does, as binding functions of other libraries, is not counted
    CALLGRIND_ZERO_STATS;
    loop(in, out, kernel);
    CALLGRIND_DUMP_STATS_AT(mark.c_str());
}

}  // namespace

int main() {
    const auto arrays = std::make_unique<inputs>();
    const inputs& in = *arrays;
    const auto table = lobe::bake_dfg<float>(smith_correlated{}, {.size = 8});

    measure("f_cos", in, with_brdf([](const auto& brdf, const element& e) { return brdf.f_cos(e.v(), e.l()); }));
    measure("evaluate", in, with_brdf([](const auto& brdf, const element& e) { return brdf.evaluate(e.v(), e.l()); }));
    measure("pdf", in, with_brdf([](const auto& brdf, const element& e) { return brdf.pdf(e.v(), e.l()); }));
    measure("sample, visible normals", in,
            with_brdf([](const auto& brdf, const element& e) { return brdf.sample(e.v(), e.u()); }));
    measure("sample, all normals", in, [](const element& e) {
        return lobe::microfacet{e.ndf(), smith_correlated{}, schlick{e.rgb()}, lobe::all_normals{}}.sample(e.v(),
                                                                                                           e.u());
    });
    measure("metallic_roughness f_cos", in, [](const element& e) { return e.metallic().f_cos(e.v(), e.l()); });
    measure("coated f_cos", in, [](const element& e) {
        return lobe::coated(e.metallic(), ggx{alpha{0.125f}}, e.mu()).f_cos(e.v(), e.l());
    });
    measure("eon f_cos", in, [](const element& e) { return lobe::eon{e.rgb(), e.mu()}.f_cos(e.v(), e.l()); });
    measure("eon sample", in, [](const element& e) { return lobe::eon{e.rgb(), e.mu()}.sample(e.v(), e.u()); });
    measure("D", in, [](const element& e) { return e.ndf().D(e.m()); });
    measure("visibility", in, [](const element& e) { return smith_correlated{}.visibility(e.ndf(), e.v(), e.l()); });
    measure("sample of the distribution", in, [](const element& e) { return e.ndf().sample(e.u()); });
    measure("schlick rgb", in, [](const element& e) { return schlick{e.rgb()}(e.mu()); });
    measure("dielectric", in, [](const element& e) { return lobe::dielectric{e.in.eta[e.i]}(e.mu()); });
    measure("conductor rgb", in, [](const element& e) {
        return lobe::conductor{e.rgb(), e.in.eta[e.i] * e.rgb()}(e.mu());
    });
    measure("hammersley", in, [](const element& e) { return lobe::hammersley(e.in.index[e.i], count); });
    measure("fibonacci", in, [](const element& e) { return lobe::fibonacci(e.in.index[e.i], count); });
    measure("owen_sobol", in, [](const element& e) { return lobe::owen_sobol(e.in.index[e.i], 1); });
    measure("dfg_table", in, [&table](const element& e) { return table(e.mu(), alpha{e.in.a[e.i]}); });
    constexpr std::uint32_t taps = 64;
    const auto sky = [](const vec3& w) { return w; };
    measure(
        "prefiltered_radiance, a tap", in,
        [&](const element& e) { return lobe::prefiltered_radiance(sky, e.m(), alpha{e.in.a[e.i]}, taps); }, taps);

    // What instructions.sh sets lobe's beside: the same name behind the colon.
    measure("limit: f_cos", in, [](const element& e) { return limit::f_cos(e.view(), e.light(), e.a(), e.F0()); });
    measure("limit: evaluate", in,
            [](const element& e) { return limit::evaluate(e.view(), e.light(), e.a(), e.F0()); });
    measure("limit: pdf", in, [](const element& e) { return limit::pdf(e.view(), e.light(), e.a()); });
    measure("limit: sample, visible normals", in, [](const element& e) {
        return limit::sample_visible(e.view(), e.in.u1[e.i], e.in.u2[e.i], e.a(), e.F0());
    });
    measure("limit: D", in, [](const element& e) { return limit::D(e.normal(), e.a()); });
    measure("limit: visibility", in, [](const element& e) { return limit::visibility(e.view(), e.light(), e.a()); });
    measure("limit: sample of the distribution", in,
            [](const element& e) { return limit::sample_normal(e.in.u1[e.i], e.in.u2[e.i], e.a()); });
    measure("limit: schlick rgb", in, [](const element& e) { return limit::schlick(e.F0(), e.mu()); });
    measure("limit: dielectric", in, [](const element& e) { return limit::dielectric(e.eta(), e.mu()); });
    measure("limit: conductor rgb", in,
            [](const element& e) { return limit::conductor(e.F0(), limit::scaled(e.F0(), e.eta()), e.mu()); });
    measure("limit: hammersley", in, [](const element& e) { return limit::hammersley(e.in.index[e.i], count); });
}
