// No call with an input inside its domain raises FE_INVALID or FE_DIVBYZERO, whichever side of a `select` is taken:
// debug builds that trap NaNs at birth (feenableexcept) run through. Every model at the ends of what it is given, in
// float and double; a standalone program, built with and without optimisation, without lobe::vectorize, whose
// -fno-trapping-math gives the promise away.
#include <lobe/lobe.hpp>

#include <cfenv>
#include <csetjmp>
#include <csignal>
#include <cstdio>
#include <string>

#if !defined(__GLIBC__)
int main() { std::puts("no feenableexcept here: nothing is tested"); }
#else

using lobe::alpha;
using lobe::alpha_xy;
using lobe::vec2;
using lobe::vec3;

namespace {

sigjmp_buf back;
int failures = 0, calls = 0;

[[noreturn]] void trapped(int) { siglongjmp(back, 1); }

/// Runs f(), which is to raise nothing.
template <class F>
[[gnu::noinline]] void quietly(const std::string& name, const F& f) {
    ++calls;
    if (sigsetjmp(back, 1) == 0) {
        std::feclearexcept(FE_ALL_EXCEPT);
        feenableexcept(FE_INVALID | FE_DIVBYZERO);
        f();
        fedisableexcept(FE_ALL_EXCEPT);
    } else {
        std::feclearexcept(FE_ALL_EXCEPT);
        fedisableexcept(FE_ALL_EXCEPT);
        ++failures;
        std::printf("raised: %s\n", name.c_str());
    }
}

/// The compiler may not know what becomes of x.
template <class T>
void keep(const T& x) {
    asm volatile("" : : "g"(&x) : "memory");
}
/// ... nor what x is.
template <class T>
[[gnu::noinline]] T unknown(T x) {
    asm volatile("" : : "g"(&x) : "memory");
    return x;
}

template <class T>
struct inputs {
    std::vector<vec3<T>> w;  // of about unit length, anywhere
    std::vector<vec2<T>> u;  // in [0,1)^2
    std::vector<T> c;        // in [0,1]
};

template <class T>
inputs<T> corners() {
    using limits = std::numeric_limits<T>;
    inputs<T> in;
    const T tiny[] = {T(0),     T(-0.0), limits::denorm_min(), T(-1e-30), T(1e-19), T(1e-18), T(-1e-18), T(1e-12),
                      T(-1e-6), T(0.6)};
    for (const T a : tiny)
        for (const T b : tiny) {
            const T c = std::sqrt(1 - a * a - b * b);
            for (const T s : {c, -c}) {
                in.w.push_back({a, b, s});
                in.w.push_back({s, a, b});
                in.w.push_back({b, s, a});
            }
        }
    const T below_1 = 1 - limits::epsilon() / 2;
    in.w.push_back({0, 0, below_1});
    in.w.push_back({0, 0, 1 + 2 * limits::epsilon()});
    in.w.push_back({0, 0, -1 - 2 * limits::epsilon()});
    in.w.push_back({-1 - limits::epsilon(), 0, T(1e-18)});
    const T some[] = {T(0), limits::denorm_min(), T(1e-20), T(0.125), T(0.25), T(0.5), T(0.7), below_1};
    for (const T x : some)
        for (const T y : some) in.u.push_back({x, y});
    in.c = {T(0),   T(-0.0), limits::denorm_min(), T(1e-30), T(1e-18), T(1e-6),
            T(0.1), T(0.5),  std::sqrt(T(0.75)),   T(0.9),   below_1,  T(1)};
    return in;
}

/// The lights that are hard on the view v: itself, what mirrors it, what all but cancels it, and a few others.
template <class T, class Visit>
void every_light(const inputs<T>& in, std::size_t i, const Visit& visit) {
    const vec3<T> v = in.w[i];
    for (const vec3<T>& l : {v, -v, vec3<T>{-v.x, -v.y, v.z}, vec3<T>{-v.x, v.y, v.z}, vec3<T>{-v.x, -v.y, T(1e-18)},
                             vec3<T>{-v.x, -v.y, T(-1e-30)}, vec3<T>{0, 0, 1}, vec3<T>{0, 0, -1},
                             vec3<T>{T(0.6), 0, T(0.8)}, vec3<T>{0, -1, T(1e-18)}, vec3<T>{0, 1, 0}})
        visit(l);
    for (std::size_t k = 1; k < 8; ++k) visit(in.w[(i * k * 37 + 11 * k) % in.w.size()]);
}

template <class B, class T>
[[gnu::noinline]] void evaluate(const B& b, const vec3<T>& v, const vec3<T>& l) {
    keep(b.f(v, l));
    keep(b.f_cos(v, l));
    keep(b.pdf(v, l));
    keep(b.evaluate(v, l));
}
template <class B, class T>
[[gnu::noinline]] void sample(const B& b, const vec3<T>& v, const vec2<T>& u) {
    keep(b.sample(v, u));
}

/// Every stride-th view: the models that take integrals to sample have fewer.
template <class B, class T>
void brdf(const std::string& name, const B& b, const inputs<T>& in, std::size_t stride = 1) {
    quietly(name + ", evaluate", [&] {
        for (std::size_t i = 0; i < in.w.size(); ++i)
            every_light(in, i, [&](const vec3<T>& l) { evaluate(b, in.w[i], l); });
    });
    quietly(name + ", sample", [&] {
        for (std::size_t i = 0; i < in.w.size(); i += stride)
            for (std::size_t k = i % stride; k < in.u.size(); k += stride) sample(b, in.w[i], in.u[k]);
    });
}

template <class N, class T>
[[gnu::noinline]] void functions(const N& ndf, const vec3<T>& w) {
    keep(ndf.D(w));
    keep(ndf.projected_area(w));
    keep(ndf.pdf(w));
    if (std::abs(w.z) > T(1e-6)) keep(ndf.lambda(w));  // at the horizon it is infinite
}
template <class N, class T>
[[gnu::noinline]] void normal(const N& ndf, const vec2<T>& u) {
    keep(ndf.sample(u));
}
template <class N, class T>
[[gnu::noinline]] void visible_normal(const N& ndf, const vec3<T>& v, const vec2<T>& u) {
    const vec3<T> m = ndf.sample_visible(v, u);
    keep(m);
    keep(ndf.pdf_visible(v, m));
}

template <class N, class T>
void distribution(const std::string& name, const N& ndf, const inputs<T>& in, std::size_t stride = 1) {
    quietly(name + ", D", [&] {
        for (const auto& w : in.w) functions(ndf, w);
    });
    quietly(name + ", normals", [&] {
        for (const auto& u : in.u) normal(ndf, u);
    });
    const lobe::schlick F{T(0.04)};
    brdf(name + ", all normals", lobe::microfacet{ndf, lobe::smith_correlated{}, F, lobe::all_normals{}}, in);
    if constexpr (lobe::visibly_samplable_distribution<N>) {
        quietly(name + ", visible normals", [&] {
            for (std::size_t i = 0; i < in.w.size(); i += stride)
                for (std::size_t k = i % stride; k < in.u.size(); k += stride)
                    if (in.w[i].z >= T(1e-18)) visible_normal(ndf, in.w[i], in.u[k]);
        });
        brdf(name, lobe::microfacet{ndf, lobe::smith_correlated{}, F}, in, stride);
    }
}

template <class T>
void distributions(const inputs<T>& in) {
    for (const T a : {T(1e-6), T(1e-4), T(0.1), T(1)}) {
        const alpha<T> width(unknown(a));
        const std::string of = std::string(" ") + std::to_string(static_cast<double>(a) * 1e6) + "e-6";
        distribution("ggx" + of, lobe::ggx{width}, in);
        distribution("ggx, anisotropic" + of, lobe::ggx{alpha_xy<T>(width.value(), 1)}, in);
        distribution("ggx, across" + of, lobe::ggx{alpha_xy<T>(T(0.3), width.value())}, in);
        distribution("beckmann" + of, lobe::beckmann{width}, in, 5);
        distribution("beckmann, anisotropic" + of, lobe::beckmann{alpha_xy<T>(width.value(), 1)}, in, 5);
        distribution("beckmann_walter" + of, lobe::beckmann_walter{width}, in);
        distribution("mixture" + of, lobe::mixture{lobe::ggx{width}, lobe::beckmann{width}, T(0.3)}, in, 5);
        distribution("mixture of one" + of, lobe::mixture{lobe::ggx{width}, lobe::ggx{alpha<T>(T(0.3))}, T(0)}, in);
        distribution("mixture of the other" + of, lobe::mixture{lobe::ggx{width}, lobe::ggx{alpha<T>(T(0.3))}, T(1)},
                     in);
        distribution("masked_by" + of, lobe::masked_by{lobe::beckmann{width}, lobe::ggx{width}}, in);
        for (const T gamma : {T(1.6), T(2), T(3)})
            distribution("student_t" + of, lobe::student_t{width, gamma}, in, 61);
        distribution("hyper_cauchy" + of, lobe::hyper_cauchy{width, T(2.5)}, in, 61);
        if (a < T(1e-4)) continue;  // tables
        quietly("tables of projected areas" + of, [&] {
            const lobe::tabulated gtr{lobe::gtr{width, T(1)}};
            const lobe::tabulated abc{lobe::abc{width, T(1.5)}};
            const lobe::tabulated sgd{lobe::sgd{width, T(1)}};
            const lobe::tabulated phong{lobe::phong{width}};
            const lobe::tabulated power{lobe::exponential_power{width, T(1.5)}};
            keep(gtr), keep(abc), keep(sgd), keep(phong), keep(power);
        });
        for (const T gamma : {T(1), T(1.5), T(2)})
            distribution("gtr" + of, lobe::tabulated{lobe::gtr{width, gamma}}, in, 301);
        if (a >= T(0.01)) distribution("blinn_phong" + of, lobe::blinn_phong{width}, in, 301);
        distribution("phong" + of, lobe::tabulated{lobe::phong{width}}, in, 301);
        distribution("abc" + of, lobe::tabulated{lobe::abc{width, T(1.5)}}, in, 301);
        distribution("sgd" + of, lobe::tabulated{lobe::sgd{width, T(1)}}, in, 301);
        for (const T p : {T(0.5), T(2)})
            distribution("exponential_power" + of, lobe::tabulated{lobe::exponential_power{width, p}}, in, 301);
    }
}

template <class T>
void microfacets(const inputs<T>& in) {
    for (const T a : {T(1e-6), T(0.09), T(1)}) {
        const lobe::ggx ndf{alpha<T>(unknown(a))};
        const lobe::ggx stretched{alpha_xy<T>(unknown(a), T(0.5))};
        const alpha<T> width(a);
        const lobe::schlick F{vec3<T>{1, T(0.5), 0}};
        brdf("smith_separable", lobe::microfacet{ndf, lobe::smith_separable{}, F}, in);
        brdf("smith_direction_correlated", lobe::microfacet{ndf, lobe::smith_direction_correlated{}, F}, in);
        brdf("smith_hammon", lobe::microfacet{ndf, lobe::smith_hammon{}, F}, in);
        brdf("schlick_ggx", lobe::microfacet{ndf, lobe::schlick_ggx{lobe::k_from_alpha(width)}, F}, in);
        brdf("schlick_ggx, k = 0", lobe::microfacet{ndf, lobe::schlick_ggx{lobe::schlick_k{T(0)}}, F}, in);
        brdf("v_cavity", lobe::microfacet{ndf, lobe::v_cavity{}, F}, in);
        brdf("visible_heitz2018", lobe::microfacet{ndf, lobe::smith_correlated{}, F, lobe::visible_heitz2018{}}, in);
        brdf("visible_bounded_caps", lobe::microfacet{ndf, lobe::smith_correlated{}, F, lobe::visible_bounded_caps{}},
             in);
        brdf("visible_heitz2018, anisotropic",
             lobe::microfacet{stretched, lobe::smith_correlated{}, F, lobe::visible_heitz2018{}}, in);
        brdf("visible_bounded_caps, anisotropic",
             lobe::microfacet{stretched, lobe::smith_correlated{}, F, lobe::visible_bounded_caps{}}, in);
        brdf("v_cavity, all normals", lobe::microfacet{stretched, lobe::v_cavity{}, F, lobe::all_normals{}}, in);
        const auto fresnel = [&](const std::string& name, const auto& of) {
            brdf(name, lobe::microfacet{ndf, lobe::smith_correlated{}, of}, in);
        };
        fresnel("dielectric, glass", lobe::dielectric{T(1.5)});
        fresnel("dielectric, from inside", lobe::dielectric{T(0.5)});
        fresnel("conductor", lobe::conductor{T(0.2), T(3)});
        fresnel("f82_tint", lobe::f82_tint{T(0.9), T(0.5)});
        fresnel("schlick_gaussian", lobe::schlick_gaussian{T(0.04)});
        fresnel("perfect_reflector", lobe::perfect_reflector{});
    }
}

template <class T>
void diffuse(const inputs<T>& in) {
    const vec3<T> colour{1, T(0.5), 0};
    brdf("lambert", lobe::lambert{colour}, in);
    for (const T rough : {T(0), T(0.4), T(1)}) {
        const T r = unknown(rough);
        brdf("burley", lobe::burley{colour, r}, in);
        brdf("burley_frostbite", lobe::burley_frostbite{colour, r}, in);
        brdf("oren_nayar", lobe::oren_nayar{colour, r}, in);
        brdf("fon", lobe::fon{colour, r}, in);
        brdf("fon, by the cosine", lobe::fon{colour, r, lobe::cosine_sampling{}}, in);
        brdf("eon", lobe::eon{colour, r}, in);
        brdf("eon, fitted", lobe::eon{colour, r, lobe::fon_loss_fit{}}, in);
    }
}

template <class T>
void compositions(const inputs<T>& in) {
    const vec3<T> colour{1, T(0.5), 0}, black(0);
    for (const T a : {T(1e-6), T(0.09), T(1)}) {
        const alpha<T> width(unknown(a));
        const lobe::microfacet mirror{lobe::ggx{width}, lobe::smith_correlated{}, lobe::schlick{colour}};
        const lobe::microfacet dark{lobe::ggx{width}, lobe::smith_correlated{}, lobe::schlick{black, black}};
        for (const T metallic : {T(0), T(0.5), T(1)}) {
            brdf("metallic_roughness", lobe::metallic_roughness(colour, metallic, width), in);
            brdf("coated",
                 lobe::coated(lobe::metallic_roughness(colour, metallic, width), lobe::ggx{width}, T(1) - metallic),
                 in);
        }
        brdf("sum", lobe::sum{lobe::weighted{T(0.5), mirror}, lobe::weighted{T(0), mirror}, lobe::lambert{colour}}, in);
        brdf("sum of black ones", lobe::sum{dark, lobe::lambert{black}}, in);
        const lobe::schlick E{colour * T(0.5)};
        brdf("layered, albedo_coupling", lobe::layered{mirror, lobe::eon{colour, T(0.5)}, lobe::albedo_coupling{E}},
             in);
        brdf("layered, reciprocal_coupling",
             lobe::layered{mirror, lobe::burley{colour, T(0.5)}, lobe::reciprocal_coupling{E, E.average()}}, in);
        brdf("layered, fresnel_coupling",
             lobe::layered{mirror, lobe::lambert{colour}, lobe::fresnel_coupling{lobe::dielectric{vec3<T>(T(0.5))}}},
             in);
    }
}

template <class T>
void reflectances(const inputs<T>& in) {
    const auto fresnel = [&](const std::string& name, const auto& make) {
        quietly(name, [&] {
            const auto F = make();
            for (const T c : in.c) keep(F(unknown(c)));
            keep(F.average());
            if constexpr (requires { F.F0(); }) keep(F.F0());
        });
    };
    using limits = std::numeric_limits<T>;
    for (const T eta : {limits::denorm_min(), limits::min(), T(1e-3), T(0.3), T(0.5), T(1) - limits::epsilon(), T(1),
                        T(1) + limits::epsilon(), T(1.5), T(3), T(1e9), sizeof(T) == 4 ? T(1e19) : T(1e150)}) {
        fresnel("dielectric " + std::to_string(eta), [&] { return lobe::dielectric{unknown(eta)}; });
        for (const T k : {T(0), T(1e-6), T(1), T(3), T(1e9)})
            if (eta >= T(1) / T(1000) && eta <= T(1e9))
                fresnel("conductor " + std::to_string(eta) + " " + std::to_string(k), [&] {
                    return lobe::conductor{unknown(eta), unknown(k)};
                });
    }
    for (const T f0 : {T(0), T(0.04), T(0.5), T(1)}) {
        const T F0 = unknown(f0);
        fresnel("schlick", [&] { return lobe::schlick{F0}; });
        fresnel("schlick, black", [&] { return lobe::schlick{F0, T(0)}; });
        fresnel("schlick_gaussian", [&] { return lobe::schlick_gaussian{F0}; });
        fresnel("schlick_roughness", [&] { return lobe::schlick_roughness{F0, T(1)}; });
        for (const T tint : {T(0), T(0.5), T(1)})
            fresnel("f82_tint", [&] { return lobe::f82_tint{F0, unknown(tint)}; });
        quietly("ior", [&] {
            if (F0 < T(1)) keep(lobe::f0_from_ior(lobe::ior_from_f0(F0)));
        });
    }
    quietly("fit_f82_tint", [] { keep(lobe::fit_f82_tint(lobe::materials::gold<T>())); });
}

template <class T>
void the_rest(const inputs<T>& in) {
    const std::string scalar = sizeof(T) == 4 ? "float: " : "double: ";
    quietly(scalar + "frames", [&] {
        for (const auto& n : in.w) {
            const lobe::frame<T> at(n);
            keep(at);
            keep(at.to_local(at.to_world(n)));
            keep(lobe::bend_above_horizon(n, T(1e-3)));
            const vec3<T> tangent{T(0.48), T(0.64), T(0.6)};
            const vec3<T> across = lobe::cross(n, tangent);
            if (lobe::dot(across, across) > T(1e-6)) keep(lobe::frame<T>(n, tangent));
        }
    });
    quietly(scalar + "sggx", [&] {
        for (const auto& n : in.w) {
            const lobe::sggx<T> flakes(lobe::frame<T>(n), {T(0.5), T(0.01), T(1)});
            for (const auto& u : in.u) {
                const auto m = flakes.sample_visible(n, u);
                keep(m), keep(flakes.D(m)), keep(flakes.pdf_visible(n, m)), keep(flakes.projected_area(m));
            }
            keep(lobe::sggx<T>::from_matrix(flakes.matrix()));
        }
    });
    quietly(scalar + "half vectors", [&] {
        for (const auto& v : in.w)
            if (v.z >= T(1e-6)) keep(lobe::half_vector(v, {0, 0, 1})), keep(lobe::reflect(v, {0, 0, 1}));
    });
    quietly(scalar + "warps", [&] {
        for (const auto& u : in.u) {
            keep(lobe::uniform_disk_to_square(lobe::square_to_uniform_disk(u)));
            keep(lobe::uniform_disk_concentric_to_square(lobe::square_to_uniform_disk_concentric(u)));
            keep(lobe::uniform_hemisphere_to_square(lobe::square_to_uniform_hemisphere(u)));
            keep(lobe::cosine_hemisphere_to_square(lobe::square_to_cosine_hemisphere(u)));
            keep(lobe::cosine_hemisphere_concentric_to_square(lobe::square_to_cosine_hemisphere_concentric(u)));
            keep(lobe::cosine_hemisphere_pdf(lobe::square_to_cosine_hemisphere(u)));
        }
        for (const auto& w : in.w)
            if (w.z >= T(0)) {
                keep(lobe::uniform_hemisphere_to_square(w));
                keep(lobe::cosine_hemisphere_to_square(w));
                keep(lobe::cosine_hemisphere_concentric_to_square(w));
            }
    });
    quietly(scalar + "points", [&] {
        for (const std::uint32_t n : {1u, 2u, 3u, 1000u, 4294967295u})
            for (const std::uint32_t i : {0u, n / 2, n - 1})
                keep(lobe::hammersley<T>(i, n)), keep(lobe::radical_inverse<T>(i));
    });
    quietly(scalar + "lights", [&] {
        for (const auto& w : in.w) {
            const vec3<T> origin(0), axis{0, 0, -1};
            for (const T d : {T(1e-6), T(1), T(1e6)}) {
                keep(lobe::point_light{origin, T(1)}(w * d));
                keep(lobe::point_light{origin, T(1), lobe::inverse_square_within{T(2)}}(w * d));
                for (const auto& cone : {lobe::cone{T(0), T(1)}, lobe::cone{T(0.5), lobe::pi<T>() / T(2)}})
                    keep(lobe::spot_light{origin, axis, T(1), cone}(w * d)), keep(cone.solid_angle());
            }
            const lobe::microfacet b{lobe::ggx{alpha<T>(T(0.1))}, lobe::smith_correlated{}, lobe::schlick{T(0.04)}};
            keep(lobe::reflected_radiance(b, w, lobe::directional_light{w, T(1)}(origin)));
        }
    });
    quietly(scalar + "widths", [&] {
        for (const T a : {T(1e-6), T(0.1), T(1)}) {
            const alpha<T> width(unknown(a));
            const alpha_xy<T> both(width.value(), T(0.3)), same(T(0.3), T(0.3));
            for (const T x : {T(0), T(1e-20), T(0.1), T(1)}) {
                const T variance = unknown(x);
                keep(lobe::widened(width, variance)), keep(lobe::widened(both, variance));
                keep(lobe::widened(both, lobe::slope_matrix<T>{variance, T(0), variance}));
                keep(lobe::widened(same, lobe::slope_matrix<T>{variance, variance / T(2), variance}));
                const vec3<T> dx{variance, 0, 0}, dy{0, variance, 0};
                keep(lobe::widened_by_pixel(width, dx, dy)), keep(lobe::widened_by_pixel(both, dx, dy));
                keep(lobe::widened_by_half_vector(both, vec2<T>{variance, 0}, vec2<T>{0, variance}));
                keep(lobe::widened_by_half_vector(same, vec2<T>{0, 0}, vec2<T>{0, variance}));
                if (variance > T(0))
                    keep(lobe::toksvig_variance(variance)), keep(lobe::toksvig_exponent(T(100), variance));
            }
            for (const T r : {T(0), T(0.5), T(1)}) {
                keep(alpha<T>::from_roughness(r, T(1e-4)));
                keep(alpha_xy<T>::from_disney(r, T(1), T(1e-4))), keep(alpha_xy<T>::from_imageworks(r, T(1), T(1e-4)));
                keep(alpha_xy<T>::from_openpbr(r, T(1), T(1e-4)));
            }
        }
        for (const auto& n : in.w)
            if (n.z > T(1e-6))
                keep(lobe::lean_moments<T>::of(n).covariance()), keep(lobe::clean_moments<T>::of(n).variance());
    });
    for (const T a : {T(1e-3), T(0.3), T(1)}) {
        const lobe::microfacet b{lobe::ggx{alpha<T>(unknown(a))}, lobe::smith_correlated{}, lobe::schlick{T(0.04)}};
        quietly(scalar + "albedos", [&] {
            for (const T mu : {T(1e-3), T(0.1), T(1)}) {
                keep(lobe::directional_albedo(b, mu, {.order = 16}));
                keep(lobe::directional_albedo(lobe::coated(lobe::lambert{T(1)}, lobe::ggx{alpha<T>(a)}, T(1)), mu,
                                              {.order = 16}));
                keep(lobe::directional_albedo(lobe::eon{T(1), T(1)}, mu, {.order = 16}));
                keep(lobe::dfg_exact<T>(lobe::smith_correlated{}, mu, alpha<T>(a), {.order = 16}));
            }
            keep(lobe::directional_albedo(b, vec3<T>{0, T(0.6), T(0.8)}, {.order = 16}));
            keep(lobe::directional_albedo(b, vec3<T>{0, 0, 1}));
            keep(lobe::average_albedo(b, {.order = 16}));
        });
        quietly(scalar + "random walk", [&] {
            const lobe::random_walk walk{lobe::ggx{alpha<T>(a)}, lobe::schlick{T(0.04)}};
            const lobe::random_walk gaussian{lobe::beckmann{alpha<T>(a)}, lobe::schlick{T(0.04)}};
            std::uint32_t i = 0;
            const auto uniform = [&] { return lobe::radical_inverse<T>(i++ * 2654435761u); };
            for (const auto& v : in.w)
                if (v.z >= T(1e-6)) keep(walk.sample(v, uniform)), keep(gaussian.sample(v, uniform));
        });
        quietly(scalar + "prefiltered radiance", [&] {
            const lobe::latlong<T> sky(4, 2, std::vector<vec3<T>>(8, vec3<T>(1)));
            const lobe::latlong_pyramid<T> pyramid(lobe::latlong<T>(8, 4, std::vector<vec3<T>>(32, vec3<T>(1))));
            for (const auto& n : in.w) {
                keep(lobe::prefiltered_radiance(sky, n, alpha<T>(a), 5));
                keep(lobe::prefiltered_radiance(pyramid, n, alpha<T>(a), 5));
                keep(lobe::irradiance(sky, n, 5)), keep(lobe::irradiance(sky, n));
            }
        });
    }
    quietly(scalar + "bake_dfg", [&] {
        const auto table = lobe::bake_dfg<T>(lobe::smith_correlated{}, {.size = 8, .order = 8});
        keep(lobe::bake_dfg<T>(lobe::v_cavity{}, {.size = 4, .order = 8}));
        for (const T c : in.c)
            for (const T a : {T(1e-8), T(0.3), T(1)}) {
                const auto t = table(c, alpha<T>(a));
                keep(t), keep(lobe::fdez_aguera{}(t, T(0))), keep(lobe::fdez_aguera{}(t, T(1), T(1)));
            }
    });
}

template <class T>
void everything() {
    const inputs<T> in = corners<T>();
    microfacets(in);
    diffuse(in);
    compositions(in);
    reflectances(in);
    the_rest(in);
    distributions(in);
}

}  // namespace

int main() {
    std::signal(SIGFPE, trapped);
    everything<float>();
    everything<double>();
    std::printf("%d groups of calls, %d of which raised an exception\n", calls, failures);
    return failures != 0;
}

#endif
