// A base under a specular lobe: what the lobe leaves to the base, in three couplings and that of a clear coat.
#pragma once

#include <lobe/brdf/microfacet.hpp>
#include <lobe/brdf/sum.hpp>
#include <lobe/fresnel/schlick.hpp>

namespace lobe {

// A coupling is the factor of a base under a specular lobe: the share of its light that it keeps.

namespace detail {

/// 1 - s.
template <class S>
constexpr S rest(const S& s) {
    return S(component_t<S>(1)) - s;
}

/// Is every component below 1? A type of the user's own is trusted.
template <class S>
constexpr bool below_one(const S& s) {
    if constexpr (requires { every([](const auto& x) { return x >= x; }, s); })
        return every([]<class T>(const T& x) { return x < T(1); }, s);
    else
        return true;
}

template <scalar T>
constexpr T cosine_in_unit_interval(const T& c) {
    return smaller(larger(c, T(0)), T(1));
}

}  // namespace detail

/// 1 - F(v.h): what a facet that mirrors v to l lets through. glTF 2.0, appendix B.3; F is that of the specular lobe.
/// Reciprocal, needs no table, and gains energy, because at grazing the lobe reflects far more than F(v.h)
/// of the diffuse light: over a white base, F0 = 0.04, the total albedo is 1.26 at mu = alpha = 0.1, 1.49 at mu = 0.01,
/// alpha = 0.05, and tends to 1.9 as both vanish.
template <class F>
class fresnel_coupling {
public:
    constexpr explicit fresnel_coupling(const F& reflectance) : fresnel_(reflectance) {}

    template <scalar T>
    [[gnu::always_inline]] constexpr auto operator()(const vec3<T>& v, const vec3<T>& l) const {
        return detail::rest(fresnel_(smaller(length(v + l) / T(2), T(1))));
    }

    template <class G>
    constexpr void for_each_crease(const G& g) const {
        detail::for_each_crease(fresnel_, g);
    }

private:
    [[no_unique_address]] F fresnel_;
};

/// 1 - E(v): what the specular lobe, seen from v, does not reflect. E: a callable of the cosine of v,
/// the lobe's directional albedo (from a `dfg_table`: F0 * scale + bias), finite on [0,1];
/// as it knows no azimuth, for isotropic lobes. A white base totals exactly 1, as well as E is known.
/// Not reciprocal: f(v,l)/f(l,v) of the base is (1 - E(v))/(1 - E(l)).
template <class E>
class albedo_coupling {
public:
    constexpr explicit albedo_coupling(const E& directional_albedo_of_lobe) : e(directional_albedo_of_lobe) {}

    template <scalar T>
    constexpr auto operator()(const vec3<T>& v, const vec3<T>&) const {
        return detail::rest(e(detail::cosine_in_unit_interval(v.z)));
    }

private:
    [[no_unique_address]] E e;
};

/// (1 - E(v)) (1 - E(l)) / (1 - E_avg): what passes on the way in and on the way out, scaled so that nothing is lost
/// over a Lambertian base. Kelemen & Szirmay-Kalos 2001, "A Microfacet Based Coupled Specular-Matte BRDF Model with
/// Importance Sampling"; Kulla & Conty 2017, "Revisiting Physically Based Shading at Imageworks".
/// E as for `albedo_coupling`; E_avg = 2 int_0^1 E(mu) mu dmu of the same lobe, below 1. S needs `/` here,
/// once, in the constructor.
/// Reciprocal to the bit if the base is. A white Lambertian base totals exactly 1, as well as E and E_avg are known.
template <class E, class S>
class reciprocal_coupling {
public:
    constexpr reciprocal_coupling(const E& directional_albedo_of_lobe, const S& average_albedo_of_lobe)
        : e(directional_albedo_of_lobe), scale(average_albedo_of_lobe) {
        assert(detail::in_unit_interval(average_albedo_of_lobe) &&
               "reciprocal_coupling: the average albedo must be in [0,1)");
        assert(detail::below_one(average_albedo_of_lobe) && "reciprocal_coupling: the average albedo must be below 1");
        scale = S(component_t<S>(1)) / detail::rest(average_albedo_of_lobe);
    }

    template <scalar T>
    constexpr auto operator()(const vec3<T>& v, const vec3<T>& l) const {
        return detail::rest(e(detail::cosine_in_unit_interval(v.z))) *
               detail::rest(e(detail::cosine_in_unit_interval(l.z))) * scale;
    }

private:
    [[no_unique_address]] E e;
    S scale;
};

/// weight F(n.v): the share of a clear coat of that weight in [0,1]. glTF KHR_materials_clearcoat.
template <class F, scalar T>
class coat_share {
public:
    constexpr coat_share(const F& reflectance, const T& weight) : fresnel_(reflectance), w(weight) {
        assert(detail::in_unit_interval(w) && "coated: the weight must be in [0,1]");
    }

    [[gnu::always_inline]] constexpr auto operator()(const vec3<T>& v, const vec3<T>&) const {
        return fresnel_(detail::cosine_in_unit_interval(v.z)) * w;
    }

private:
    [[no_unique_address]] F fresnel_;
    T w;
};

/// 1 - share(v, l): what a factor leaves to the rest.
template <class Factor>
class complement {
public:
    constexpr explicit complement(const Factor& of) : share(of) {}

    template <scalar T>
    [[gnu::always_inline]] constexpr auto operator()(const vec3<T>& v, const vec3<T>& l) const {
        return detail::rest(share(v, l));
    }
    template <class G>
    constexpr void for_each_crease(const G& g) const {
        detail::for_each_crease(share, g);
    }

private:
    [[no_unique_address]] Factor share;
};

/// f = specular f + coupling(v, l) base f. v, l unit, in tangent space; f in 1/sr; zero below the horizon. The two
/// lobes of a `sum`, which samples them and hands them to quadrature one by one. Either may be a composition itself.
template <brdf Specular, brdf Base, class Coupling>
class layered : public sum<Specular, coupled<Base, Coupling>> {
public:
    constexpr layered(const Specular& specular, const Base& base, const Coupling& share)
        : sum<Specular, coupled<Base, Coupling>>(specular, coupled<Base, Coupling>(base, share)) {}
};

/// A clear coat over any BRDF: base f (1 - w) + w coat f, w = weight F(n.v), F Schlick's with F0 = 0.04, the coat's
/// facets mirrors. glTF KHR_materials_clearcoat (Khronos 2020), "Layering", which takes F at n.v and not at v.h so that
/// the two shares add up to 1.
/// `coat`: the coat's normals, `ggx{a}` or, for the long tail of Burley 2012,
/// `tabulated{gtr{alpha(lerp(0.1, 0.001, gloss)), 1}}`; weight in [0,1]. Both with the masking that belongs to them.
/// Disney's coat is GTR1 masked by a GGX of alpha 0.25, whatever its own width, which is not Smith's: its F = 1 furnace
/// is 0.81, 0.85, 1.14 at mu 1, 0.5, 0.1 (alpha 0.1), and its energy is safe only because it is scaled by F
/// and a weight of 1/4. (`masked_by{gtr{a, 1}, ggx{alpha(0.25)}}` is it, with `smith_separable`.) Not reciprocal.
/// Over a white base, weight 1, the total albedo is at most 1 and at least 0.853 (GGX, alpha 1, mu 0.12):
/// what is missing is what a rough coat's own facets lose by single scattering.
template <brdf Base, normal_density N>
constexpr auto coated(const Base& base, const N& coat, const typename Base::scalar& weight) {
    using T = typename Base::scalar;
    const schlick F{T(4) / T(100)};
    const coat_share share{F, weight};
    return layered{coupled{microfacet{coat, smith_correlated{}, perfect_reflector<T>{}}, share}, base,
                   complement{share}};
}

}  // namespace lobe
