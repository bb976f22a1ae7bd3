// The fuzzer's target: an input chooses a model and its parameters, and up to 256 cases of directions and random
// numbers follow from it.
// Built twice: in the stated domain, where all the invariants hold, and with LOBE_FUZZ_ANY_BITS on any bits as
// directions and numbers, of which nothing is promised but to come back.
#include "invariants.hpp"
#include "parts.hpp"

namespace fuzz {

#ifdef LOBE_FUZZ_ANY_BITS
constexpr bool any_bits = true;
#else
constexpr bool any_bits = false;
#endif

template <class T>
constexpr const char* scalar_name = sizeof(T) == 4 ? "float" : "double";

/// Runs `g(v, l, u)` for every case: in the domain, or on any bits.
template <class T, class InDomain, class Anything>
void every_case(input& in, int cases, const lobe::vec2<T>& width, const InDomain& in_domain, const Anything& anything) {
    in.end_of_parameters();
    for (int i = 0; i < cases; ++i) {
        in.start_case(static_cast<std::uint64_t>(i));
        if constexpr (any_bits) {
            const lobe::vec3<T> v = any_vector<T>(in), l = any_vector<T>(in);
            const T x = any_turns<T>(in);
            anything(v, l, lobe::vec2<T>{x, any_turns<T>(in)});
        } else {
            const lobe::vec3<T> v = direction<T>(in), l = light(in, v, width);
            const T x = number_below_1<T>(in);
            in_domain(v, l, lobe::vec2<T>{x, number_below_1<T>(in)});
        }
    }
}

template <class B, class T = typename B::scalar>
void brdf(input& in, const char* name, const B& b, const facts& facts) {
    current.model = name;
    const auto none = [](const auto&, const auto&, int) { return T(0); };
    every_case<T>(
        in, facts.cases, b.width(),
        [&](const auto& v, const auto& l, const auto& u) { check_brdf(b, none, facts, v, l, u); },
        [&](const auto& v, const auto& l, const auto& u) { call_brdf(b, v, l, u); });
}

/// What a distribution promises by itself.
template <class N, class T = typename N::scalar>
void check_distribution(const N& ndf, const facts& facts, const lobe::vec3<T>& v, const lobe::vec3<T>& m,
                        const lobe::vec2<T>& u) {
    constexpr T r = roundoff<T>;
    see(v, m, u);
    const T D = lobe::larger(m.z, -m.z) < lowest_normal<T> ? T(0) : ndf.D(m);
    expect_light("D", D);
    if (m.z < T(0)) expect(D == T(0), "D below the horizon", D);
    if (m.z >= static_cast<T>(1e-6)) {
        const lobe::vec2<T> a = ndf.width();
        T exponent(1);
        if (facts.exponential && D > T(0))
            exponent += std::abs(std::log(D)) + std::abs(std::log(a.x * a.y)) + std::abs(T(4) * std::log(m.z));
        expect_near("D of any multiple of m", ndf.D(T(3) * m), D,
                    T(fast_math ? 64 : 24) * r * exponent * D + underflow(a, m, m));
    }
    const T area = ndf.projected_area(v), behind = ndf.projected_area(-v);
    evaluations += 4;
    if (!facts.fitted_area) {
        expect_light("projected area", area);
        // int (w.m) D dm = cos(theta_w): what is seen from the front less what is seen from behind
        expect_near("area(w) - area(-w) = cos", area - behind, v.z, T(16) * r * (area + behind));
        if (v.z > T(0) && resolved(v)) {
            const T lambda = ndf.lambda(v);
            expect_light("Lambda", lambda);
            expect_near("area = cos (1 + Lambda)", area, v.z + v.z * lambda, T(64) * r * area);
            evaluations += 1;
        }
    }
    if constexpr (lobe::samplable_distribution<N>) {
        const lobe::vec3<T> n = ndf.sample(u);
        expect_unit("a normal", n);
        expect(n.z >= T(0), "a normal above the horizon", n.z);
        if (n.z >= lowest_normal<T>) expect_light("pdf of a normal", ndf.pdf(n));
        evaluations += 2;
    }
    if constexpr (lobe::visibly_samplable_distribution<N>) {
        if (v.z <= T(0)) return;
        const lobe::vec3<T> n = ndf.sample_visible(v, u);
        expect_unit("a visible normal", n);
        expect(n.z >= T(0), "a visible normal above the horizon", n.z);
        if (n.z >= lowest_normal<T>) expect_light("pdf of a visible normal", ndf.pdf_visible(v, n));
        evaluations += 2;
    }
}

/// A BRDF of the distribution, or the distribution itself.
template <class N, class Sampler, class T = typename N::scalar>
void microfacet(input& in, const char* name, const N& ndf, const Sampler& sampler, const facts& facts) {
    current.model = name;
    constexpr bool visible = !std::same_as<Sampler, lobe::all_normals>,
                   of_ggx = std::same_as<std::remove_cvref_t<decltype(ndf)>, lobe::ggx<T>>;
    if (in.below(4) == 0) {
        every_case<T>(
            in, facts.cases, ndf.width(),
            [&](const auto& v, const auto& m, const auto& u) { check_distribution(ndf, facts, v, m, u); },
            [&](const auto& v, const auto& m, const auto& u) {
                see(v, m, u);
                volatile T sink = ndf.D(m) + ndf.projected_area(v) + ndf.lambda(v) + ndf.sample(u).x;
                if constexpr (lobe::visibly_samplable_distribution<N>)
                    sink = sink + ndf.sample_visible(v, u).x + ndf.pdf_visible(v, m);
                evaluations += 6;
            });
        return;
    }
    const any_masking<T> masking(in, ndf.width().x);
    const any_fresnel<T> fresnel(in);
    const lobe::microfacet b{ndf, masking, fresnel, sampler};
    const lobe::microfacet mirror{ndf, masking, lobe::perfect_reflector<lobe::vec3<T>>{}, sampler};
    const auto rounding_of_F = [&](const auto& v, const auto& l, int i) {
        if (fresnel.critical(lobe::length(v + l) / T(2), i)) return std::numeric_limits<T>::max() / T(2);
        return T(16) * roundoff<T> * mirror.f_cos(v, l)[i];  // 4 ULP of 1 on each side
    };
    every_case<T>(
        in, facts.cases, b.width(),
        [&](const auto& v, const auto& l, const auto& u) {
            check_brdf(b, rounding_of_F, facts, v, l, u);
            if (visible && masking.within_smith(of_ggx)) check_weight(b, fresnel, v, u);
        },
        [&](const auto& v, const auto& l, const auto& u) { call_brdf(b, v, l, u); });
}

template <class N>
void ggx(input& in, const N& ndf) {
    switch (in.below(4)) {
        case 0: return microfacet(in, "ggx, visible_normals", ndf, lobe::visible_normals{}, {});
        case 1: return microfacet(in, "ggx, visible_heitz2018", ndf, lobe::visible_heitz2018{}, {});
        case 2: return microfacet(in, "ggx, visible_bounded_caps", ndf, lobe::visible_bounded_caps{}, {});
        default: return microfacet(in, "ggx, all_normals", ndf, lobe::all_normals{}, {});
    }
}

template <class T>
void microfacets(input& in) {
    switch (in.below(16)) {
        case 0:
        case 1:
        case 2: return ggx(in, lobe::ggx{isotropic<T>(in, 1e-6, 4)});
        case 3:
        case 4:
        case 5: return ggx(in, lobe::ggx{anisotropic<T>(in, 1e-6, 4)});
        case 6:
            return microfacet(in, "beckmann, all_normals", lobe::beckmann{isotropic<T>(in, 1e-4, 4)},
                              lobe::all_normals{}, {.exponential = true});
        case 7:
            return microfacet(in, "beckmann, visible_normals", lobe::beckmann{anisotropic<T>(in, 1e-4, 4)},
                              lobe::visible_normals{}, {.exponential = true, .cases = 64});
        case 8:
            return microfacet(in, "beckmann_walter", lobe::beckmann_walter{anisotropic<T>(in, 1e-4, 4)},
                              lobe::all_normals{}, {.exponential = true, .fitted_area = true});
        case 9: {
            const auto a = anisotropic<T>(in, 1e-4, 4);
            return microfacet(in, "student_t, all_normals",
                              lobe::student_t{a, in.keep("gamma", between<T>(in, 1.51, 40))}, lobe::all_normals{},
                              {.exponential = true, .cases = 64});
        }
        case 10: {
            const auto a = isotropic<T>(in, 1e-4, 4);
            return microfacet(in, "student_t, visible_normals",
                              lobe::student_t{a, in.keep("gamma", between<T>(in, 1.51, 40))}, lobe::visible_normals{},
                              {.exponential = true, .cases = 4});
        }
        case 11: {
            const auto a = isotropic<T>(in, 1e-4, 4);
            return microfacet(in, "hyper_cauchy", lobe::hyper_cauchy{a, in.keep("gamma", between<T>(in, 1.51, 40))},
                              lobe::all_normals{}, {.exponential = true, .cases = 64});
        }
        case 12:
            return microfacet(in, "blinn_phong", lobe::blinn_phong{isotropic<T>(in, 0.01, 1)}, lobe::all_normals{},
                              {.exponential = true, .cases = 64});
        case 13: {
            const auto a = isotropic<T>(in, 1e-4, 1), b = isotropic<T>(in, 1e-4, 1);
            return microfacet(in, "mixture of ggx",
                              lobe::mixture{lobe::ggx{a}, lobe::ggx{b}, in.keep("weight", share<T>(in))},
                              lobe::visible_normals{}, {});
        }
        case 14: {
            const auto a = anisotropic<T>(in, 1e-4, 1), b = anisotropic<T>(in, 1e-4, 1);
            return microfacet(in, "mixture with beckmann",
                              lobe::mixture{lobe::ggx{a}, lobe::beckmann{b}, in.keep("weight", share<T>(in))},
                              lobe::all_normals{}, {.exponential = true});
        }
        default: {
            const auto a = isotropic<T>(in, 1e-4, 1);
            return microfacet(in, "beckmann masked by ggx", lobe::masked_by{lobe::beckmann{a}, lobe::ggx{a}},
                              lobe::all_normals{}, {.exponential = true});
        }
    }
}

template <class T>
void diffuse(input& in) {
    const auto rho = colour<T>(in, "albedo");
    const T rough = in.keep("roughness", share<T>(in));
    switch (in.below(7)) {
        case 0: return brdf(in, "lambert", lobe::lambert{rho}, {});
        case 1: return brdf(in, "oren_nayar", lobe::oren_nayar{rho, rough}, {});
        case 2: return brdf(in, "fon", lobe::fon{rho, rough}, {});
        case 3: return brdf(in, "eon", lobe::eon{rho, rough}, {});
        case 4: return brdf(in, "eon, fon_loss_fit", lobe::eon{rho, rough, lobe::fon_loss_fit{}}, {});
        case 5: return brdf(in, "burley", lobe::burley{rho, rough}, {});
        default: return brdf(in, "burley_frostbite", lobe::burley_frostbite{rho, rough}, {});
    }
}

template <class T>
void compositions(input& in) {
    const auto rho = colour<T>(in, "albedo");
    const T metallic = in.keep("metallic", share<T>(in)), rough = in.keep("roughness", share<T>(in));
    const auto a = isotropic<T>(in, 1e-6, 1);
    const lobe::microfacet mirror{lobe::ggx{a}, lobe::smith_correlated{}, lobe::schlick{colour<T>(in, "F0")}};
    switch (in.below(6)) {
        case 0: return brdf(in, "metallic_roughness", lobe::metallic_roughness(rho, metallic, a), {.terms = 2});
        case 1:
            return brdf(in, "metallic_roughness, anisotropic",
                        lobe::metallic_roughness(rho, metallic, anisotropic<T>(in, 1e-6, 1)), {.terms = 2});
        case 2:
            return brdf(
                in, "coated metallic_roughness",
                lobe::coated(lobe::metallic_roughness(rho, metallic, a), lobe::ggx{isotropic<T>(in, 1e-4, 1)}, rough),
                {.reciprocal = false, .terms = 3});
        case 3: {
            const lobe::microfacet other{lobe::beckmann{isotropic<T>(in, 1e-4, 1)}, lobe::smith_separable{},
                                         lobe::dielectric{numbers<T>(in, "eta", 0.3, 10)}, lobe::all_normals{}};
            return brdf(in, "sum of ggx and beckmann",
                        lobe::sum{lobe::weighted{metallic, mirror}, lobe::weighted{T(1) - metallic, other}},
                        {.terms = 2, .exponential = true});
        }
        case 4: {
            const lobe::schlick F{colour<T>(in, "F0") * T(0.875)};
            return brdf(in, "layered, albedo_coupling",
                        lobe::layered{mirror, lobe::eon{rho, rough}, lobe::albedo_coupling{F}},
                        {.reciprocal = false, .terms = 2});
        }
        default: {
            const lobe::schlick F{colour<T>(in, "F0") * T(0.875)};
            return brdf(in, "layered, reciprocal_coupling",
                        lobe::layered{mirror, lobe::burley{rho, rough}, lobe::reciprocal_coupling{F, F.average()}},
                        {.terms = 2});
        }
    }
}

template <class T>
lobe::frame<T> any_frame(input& in) {
    const lobe::vec3<T> n = direction<T>(in);
    return lobe::frame<T>(n);
}

template <class T>
void flakes(input& in) {
    current.model = "sggx";
    const lobe::frame<T> axes = any_frame<T>(in);
    const lobe::sggx<T> flakes(axes, numbers<T>(in, "area", 1e-4, 1));
    constexpr T r = roundoff<T>;
    every_case<T>(
        in, 256, {T(1), T(1)},
        [&](const auto& v, const auto& l, const auto& u) {
            see(v, l, u);
            const lobe::vec3<T> m = flakes.sample_visible(v, u);
            const T D = flakes.D(l), area = flakes.projected_area(v);
            expect_light("D", D);
            expect_near("flakes have two sides", flakes.D(-l), D, fast_math ? T(64) * r * D : T(0));
            expect_light("projected area", area);
            expect_near("the area from behind", flakes.projected_area(-v), area, fast_math ? T(64) * r * area : T(0));
            expect_unit("a visible normal", m);
            expect(lobe::dot(v, m) >= T(-16) * roundoff<T>, "a visible normal faces v", lobe::dot(v, m));
            expect_light("pdf of a visible normal", flakes.pdf_visible(v, m));
            evaluations += 6;
        },
        [&](const auto& v, const auto& l, const auto& u) {
            see(v, l, u);
            volatile T sink =
                flakes.D(l) + flakes.projected_area(v) + flakes.sample_visible(v, u).x + flakes.pdf_visible(v, l);
            static_cast<void>(sink);
            evaluations += 4;
        });
}

template <class T>
void frames(input& in) {
    current.model = "frame";
    const T least = in.keep("min_cosine", between<T>(in, 1e-4, 0.5));
    const auto orthonormal = [](const lobe::frame<T>& f) {
        const lobe::vec3<T>* axis[] = {&f.t, &f.b, &f.n};
        for (int i = 0; i < 3; ++i)
            for (int k = i; k < 3; ++k) {
                const T off = std::abs(lobe::dot(f.n, f.n) - T(1));  // of a normal that is not quite unit
                expect_near("orthonormal", lobe::dot(*axis[i], *axis[k]), T(i == k),
                            T(fast_math ? 12 : 8) * roundoff<T> + T(4) * off);
            }
    };
    every_case<T>(
        in, 256, {T(1), T(1)},
        [&](const auto& n, const auto& w, const auto& u) {
            see(n, w, u);
            const lobe::frame<T> at(n);
            orthonormal(at);
            const lobe::vec3<T> same = at.to_world(at.to_local(w));
            for (int i = 0; i < 3; ++i) expect_near("there and back", same[i], w[i], T(32) * roundoff<T>);
            const lobe::vec3<T> across = lobe::cross(n, w);
            if (lobe::dot(across, across) > T(1e-6)) orthonormal(lobe::frame<T>(n, w * (u.x + T(0.5))));
            const lobe::vec3<T> bent = lobe::bend_above_horizon(w, least);
            expect_unit("bent", bent);
            expect(bent.z >= least, "bent above the horizon", bent.z, least);
            if (w.z >= least) expect(bent == w, "above the horizon, unchanged", bent.z, w.z);
            evaluations += 4;
        },
        [&](const auto& n, const auto& w, const auto& u) {
            see(n, w, u);
            volatile T sink = lobe::frame<T>(n).to_local(w).x + lobe::frame<T>(n).to_world(w).x +
                              lobe::bend_above_horizon(w, least).x;
            static_cast<void>(sink);
            evaluations += 3;
        });
}

template <class T>
void reflectances(input& in) {
    current.model = "fresnel";
    const any_fresnel<T> fresnel(in);
    const auto reflectance = [](const char* what, const lobe::vec3<T>& F) {
        for (int i = 0; i < 3; ++i) expect(F[i] >= T(0) && F[i] <= T(1) + T(16) * roundoff<T>, what, F[i]);
    };
    reflectance("average() in [0,1]", fresnel.average());
    every_case<T>(
        in, 256, {T(1), T(1)},
        [&](const auto& v, const auto& l, const auto& u) {
            see(v, l, u);
            reflectance("F in [0,1]", fresnel(u.x));
            reflectance("F in [0,1]", fresnel(T(1) - u.y));
            evaluations += 2;
        },
        [&](const auto& v, const auto& l, const auto& u) {
            see(v, l, u);
            volatile T sink = fresnel(u.x).x + fresnel(u.y).x;
            static_cast<void>(sink);
            evaluations += 2;
        });
}

/// The unit square's maps and points, and the sine and cosine they stand on.
template <class T>
void points(input& in) {
    current.model = "points";
    constexpr T r = roundoff<T>;
    const auto square = [](const lobe::vec2<T>& p) {
        expect(p.x >= T(0) && p.x < T(1) && p.y >= T(0) && p.y < T(1), "in [0,1)^2", p.x, p.y);
    };
    // r^2 is known to 8 u, a turn to 8 u of it, and where r is 0 there is no azimuth
    const auto back = [](const lobe::vec2<T>& there, const lobe::vec2<T>& u) {
        expect_near("the inverse map, u.x", there.x, u.x, T(16) * r);
        const T turn = std::abs(there.y - u.y);
        if (u.x > std::numeric_limits<T>::min())
            expect(lobe::smaller(turn, T(1) - turn) <= T(16) * r, "the inverse map, u.y", there.y, u.y, T(16) * r);
    };
    every_case<T>(
        in, 256, {T(1), T(1)},
        [&](const auto& v, const auto& l, const auto& u) {
            see(v, l, u);
            const T turn = T(1.25) * u.x - T(0.125);
            const auto [s, c] = lobe::sincos_2pi(turn);
            // 2 ULP of each
            expect_near("sin^2 + cos^2 = 1", s * s + c * c, T(1), T(10) * r);
            if constexpr (sizeof(T) == 4) {
                const double angle = 6.283185307179586 * static_cast<double>(turn);
                expect_near("the sine", static_cast<double>(s), std::sin(angle), 4.0 * static_cast<double>(r));
                expect_near("the cosine", static_cast<double>(c), std::cos(angle), 4.0 * static_cast<double>(r));
            }
            const auto count = static_cast<std::uint32_t>(in.word() | 1u),
                       i = static_cast<std::uint32_t>(in.word() % count);
            square(lobe::hammersley<T>(i, count));
            square({lobe::radical_inverse<T>(i), T(0)});
            for (const lobe::vec3<T>& w : {lobe::square_to_uniform_hemisphere(u), lobe::square_to_cosine_hemisphere(u),
                                           lobe::square_to_cosine_hemisphere_concentric(u)}) {
                expect_unit("a direction", w);
                expect(w.z >= T(0), "above the horizon", w.z);
                expect_light("pdf", lobe::cosine_hemisphere_pdf(w));
            }
            back(lobe::uniform_hemisphere_to_square(lobe::square_to_uniform_hemisphere(u)), u);
            back(lobe::cosine_hemisphere_to_square(lobe::square_to_cosine_hemisphere(u)), u);
            back(lobe::uniform_disk_to_square(lobe::square_to_uniform_disk(u)), u);
            const auto p = lobe::uniform_disk_concentric_to_square(lobe::square_to_uniform_disk_concentric(u));
            expect_near("the concentric inverse, u.x", p.x, u.x, T(16) * r);
            expect_near("the concentric inverse, u.y", p.y, u.y, T(16) * r);
            evaluations += 14;
        },
        [&](const auto& v, const auto& l, const auto& u) {
            see(v, l, u);
            volatile T sink = lobe::sincos_2pi(u.x).sin + lobe::square_to_uniform_hemisphere(u).x +
                              lobe::square_to_cosine_hemisphere(u).x +
                              lobe::square_to_cosine_hemisphere_concentric(u).x +
                              lobe::uniform_hemisphere_to_square(v).x + lobe::cosine_hemisphere_to_square(l).y +
                              lobe::uniform_disk_concentric_to_square(u).x;
            static_cast<void>(sink);
            evaluations += 7;
        });
}

template <class T>
void one_input(input& in) {
    current.scalar = scalar_name<T>;
    switch (in.below(16)) {
        default: return microfacets<T>(in);
        case 10: return diffuse<T>(in);
        case 11:
        case 12: return compositions<T>(in);
        case 13: return flakes<T>(in);
        case 14: return in.below(2) ? frames<T>(in) : reflectances<T>(in);
        case 15: return points<T>(in);
    }
}

}  // namespace fuzz

namespace {

/// Prints what was done, when all is done.
struct tally {
    ~tally() {
        std::fprintf(stderr, "%llu evaluations, no invariant broken; %llu comparisons left to the rounding of l\n",
                     static_cast<unsigned long long>(fuzz::evaluations),
                     static_cast<unsigned long long>(fuzz::unresolved));
    }
} tally_at_exit;

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    fuzz::input in(data, size);
    fuzz::current = {};
    fuzz::current.parameters = &in;
    if (in.below(2))
        fuzz::one_input<double>(in);
    else
        fuzz::one_input<float>(in);
    fuzz::current.parameters = nullptr;
    return 0;
}
