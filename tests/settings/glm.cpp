// Prints numbers of everything that touches a GLM vector. Built once for each of GLM's settings (GLM_FORCE_...): they
// lay vectors out anew, but a number must not change.
#include <lobe/lobe.hpp>
#include <lobe/testkit.hpp>

#include <cstdio>
#include <sstream>
#include <type_traits>

namespace {

void print(const char* name, float x) { std::printf("%s %a\n", name, static_cast<double>(x)); }
void print(const char* name, double x) { std::printf("%s %a\n", name, x); }
template <class T, glm::qualifier Q>
void print(const char* name, const glm::vec<2, T, Q>& x) {
    print(name, x.x), print(name, x.y);
}
template <class T, glm::qualifier Q>
void print(const char* name, const glm::vec<3, T, Q>& x) {
    print(name, x.x), print(name, x.y), print(name, x.z);
}

template <class B>
void print_brdf(const char* name, const B& b) {
    using T = typename B::scalar;
    const lobe::vec3<T> v{T(0.6), T(0), T(0.8)}, l{T(-0.48), T(0.64), T(0.6)};
    print(name, b.f(v, l));
    print(name, b.evaluate(v, l).f_cos);
    print(name, b.pdf(v, l));
    const auto s = b.sample(v, lobe::vec2<T>{T(0.3), T(0.7)});
    print(name, s.l), print(name, s.weight), print(name, s.pdf);
    print(name, lobe::directional_albedo(b, v, {.order = 8}).value);
    if constexpr (B::isotropic) print(name, lobe::average_albedo(b, {.order = 4}).value);
}

template <class T>
void all() {
    using vec3 = lobe::vec3<T>;
    using lobe::alpha, lobe::alpha_xy;
    const vec3 gold{T(1), T(0.71), T(0.29)}, n = lobe::normalize(vec3{T(1), T(2), T(-3)});
    const lobe::frame<T> at{n, vec3{T(0), T(1), T(1)}};
    print("frame", at.to_local(at.to_world(gold))),
        print("bend", lobe::bend_above_horizon(vec3{T(0.6), T(0), T(-0.8)}, T(0.01)));

    const auto smith = lobe::smith_correlated{};
    print_brdf("gold", lobe::microfacet{lobe::ggx{alpha{T(0.3)}}, smith, lobe::schlick{gold}});
    print_brdf("brushed",
               lobe::microfacet{lobe::ggx{alpha_xy{T(0.1), T(0.4)}}, smith, lobe::f82_tint{gold, vec3{T(0.9)}}});
    print_brdf("beckmann", lobe::microfacet{lobe::beckmann{alpha{T(0.3)}}, lobe::v_cavity{}, lobe::schlick{T(0.04)}});
    print_brdf("student_t", lobe::microfacet{lobe::student_t{alpha{T(0.3)}, T(2.5)}, smith, lobe::dielectric{T(1.5)}});
    print_brdf("gtr", lobe::microfacet{lobe::tabulated{lobe::gtr{alpha{T(0.3)}, T(1)}}, smith,
                                       lobe::conductor{gold, vec3{T(2), T(3), T(4)}}});
    print_brdf("eon", lobe::eon{gold, T(0.7)});
    print_brdf("burley", lobe::burley{gold, T(0.7)});
    print_brdf("glTF", lobe::metallic_roughness(gold, T(0.3), alpha{T(0.2)}));
    print_brdf("coated", lobe::coated(lobe::lambert{gold}, lobe::ggx{alpha{T(0.2)}}, T(1)));
    print("sggx", lobe::sggx{alpha{T(0.2)}}.sample_visible(n, lobe::vec2<T>{T(0.3), T(0.7)}));
    print("spot",
          lobe::spot_light{n, vec3{T(0), T(0), T(1)}, gold, lobe::cone<T>(T(0.1), T(1.2))}(vec3{T(0.2), T(0.4), T(3)})
              .illuminance);

    const auto environment = [](const vec3& w) { return vec3{T(1) + w.x, w.y * w.y, T(1)}; };
    print("irradiance", lobe::irradiance(environment, n, 64u));
    print("prefiltered", lobe::prefiltered_radiance(environment, n, alpha<T>{T(0.5)}, 64u));
    std::vector<vec3> pixels;
    for (int i = 0; i < 32 * 16; ++i)
        pixels.push_back(
            environment(lobe::latlong_direction(lobe::hammersley<T>(static_cast<std::uint32_t>(i), 512u))));
    const lobe::latlong_pyramid<T> map{lobe::latlong<T>{32, 16, pixels}};
    print("latlong", map(n)), print("latlong", map(n, T(0.3)));
    print("latlong", lobe::irradiance(map.level(0), n));
    print("latlong", lobe::prefiltered_radiance(map, n, alpha<T>{T(0.5)}, 64u));
    // more than float holds: sums over samples are kept in double
    print("wide", lobe::irradiance([](const vec3& w) { return vec3{w.x > T(0) ? T(16777217) : T(1)}; },
                                   vec3{T(1), T(0), T(0)}, 4096u));

    const auto table = lobe::bake_dfg<T>(smith, {.size = 4, .order = 8});
    const auto weights = lobe::fdez_aguera{}(table(T(0.3), alpha{T(0.4)}), gold, vec3{T(0.5)});
    print("split sum", weights.radiance), print("split sum", weights.irradiance);

    std::ostringstream verdict;
    verdict << lobe::testkit::verify(lobe::microfacet{lobe::ggx{alpha{T(0.3)}}, smith, lobe::schlick{gold}});
    std::puts(verdict.str().c_str());
}

}  // namespace

int main() {
    std::fprintf(stderr, "%zu bytes a vec3, length_t of %zu\n", sizeof(glm::vec3), sizeof(glm::length_t));
    all<float>();
    all<double>();
}
