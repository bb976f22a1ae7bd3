// A rough interface between two transparent media: reflection and refraction.
#pragma once

#include <lobe/bsdf/concepts.hpp>
#include <lobe/bsdf/masking.hpp>
#include <lobe/bsdf/refraction.hpp>

#include <cassert>

namespace lobe {

/// Walter, Marschner, Li, Torrance 2007, "Microfacet Models for Refraction through Rough Surfaces", in 1/sr:
///   reflection   f = F D G2 / (4 |v.n| |l.n|)                                                  (eq. 20)
///   refraction   f = (1 - F) D G2 |v.m| |l.m| / (|v.n| |l.n| (v.m + n l.m)^2) times 1 for radiance, n^2 for importance
/// (eq. 21), n = eta_l/eta_v, F of Fresnel's equations. `eta`: index below the surface over index above.
/// v, l unit, anywhere on the sphere; 0 where either is on the horizon (`horizon`). Any distribution; samples want its
/// visible normals. Masking: `smith_joint`, `smith_joint_exact`, `smith_product`. The reflection is to rounding
/// `microfacet{ndf, masking, dielectric{eta}}`, from above `evaluate` to the bit, `f` and `f_cos` to rounding.
///
/// With d = v + l, h = d + (n - 1) l, K = (sign of n - 1) |h| and Q = |d|^2/2, the half vector is m = -h/K,
///   v.m = (n - 1 - n Q)/K,  g = -n l.m = n (n - 1 + Q)/K:
/// nothing is normalised, and nothing cancels as n nears 1, where refraction becomes a delta function;
/// at n = 1, f is 0, and samples go straight through.
/// Error of f_cos and pdf for v and l as they are given: reflection as `microfacet`; refraction 32 ULP times
/// 1 + 1/(|K| alpha), and the error of the masking, where v.m, g and m.z are above 0.1. What rounding v and l to T does
/// is as much, so no formula of v and l has a smaller one: keep what `sample` returns rather than ask `f` again.
/// Samples: l unit to 1e-6 in float, on Snell's law for the facet to 1e-6; any alpha from 1e-4 and any angle.
template <distribution N, interface_masking<N> M, transport Transport = radiance_transport>
class rough_dielectric : exact_vectors<rough_dielectric<N, M, Transport>> {
    using T = typename N::scalar;
    using exact = exact_vectors<rough_dielectric>;

public:
    using scalar = T;
    using spectrum = T;
    using exact::f, exact::f_cos, exact::pdf, exact::evaluate, exact::sample;
    using transports = Transport;
    static constexpr bool isotropic = N::isotropic, transmits = true;

    constexpr rough_dielectric(const N& distribution_of_normals, const M& masking_model, const T& eta,
                               const Transport& = {})
        : ndf(distribution_of_normals), shadow(masking_model), above(side::above(eta)), below(side::below(eta)) {
        assert(all(eta > T(0)) && all(detail::finite(T(eta * eta))) &&
               "rough_dielectric: eta must be above 0 and its square finite");
    }

    // (Inlined by force, all of it: docs/design.md.)
    [[gnu::always_inline]] constexpr T f(const vec3<T>& v, const vec3<T>& l) const {
        const facet h(*this, v, l);
        const T sv = detail::area_above(ndf, h.v);
        return amount(h, sv) * smaller(quotient(h.valid, ndf.D(h.m), denominator(h, sv)), detail::largest<T>());
    }

    /// f |cos(theta_l)|.
    [[gnu::always_inline]] constexpr T f_cos(const vec3<T>& v, const vec3<T>& l) const {
        const facet h(*this, v, l);
        const T sv = detail::area_above(ndf, h.v);
        return amount(h, sv) * quotient(h.valid, ndf.D(h.m) * h.l.z, denominator(h, sv));
    }

    [[gnu::always_inline]] constexpr T pdf(const vec3<T>& v, const vec3<T>& l) const {
        const facet h(*this, v, l);
        return probability(h) * quotient(h.valid, ndf.D(h.m), detail::area_above(ndf, h.v) * h.jacobian);
    }

    /// f_cos and pdf together, sharing their work: for multiple importance sampling.
    [[gnu::always_inline]] constexpr evaluation<T, T> evaluate(const vec3<T>& v, const vec3<T>& l) const {
        const facet h(*this, v, l);
        const T sv = detail::area_above(ndf, h.v), D = ndf.D(h.m);
        return {amount(h, sv) * quotient(h.valid, D * h.l.z, denominator(h, sv)),
                probability(h) * quotient(h.valid, D, sv * h.jacobian)};
    }

    /// u in [0,1)^3: u.x and u.y draw a visible normal m, which reflects if u.z < F(v.m), else refracts.
    /// Weight: G2/G1(v), at most 1; of refraction for radiance times (eta_v/eta_l)^2.
    /// Fails where the facet sends v to the wrong side.
    [[gnu::always_inline]] constexpr direction_sample<T, T>
    sample(const vec3<T>& v, const vec3<T>& u) const requires visibly_samplable_distribution<N> {
        const auto from_below = v.z < T(0);
        const vec3<T> w = upward(v);
        const side at = side::choose(from_below, below, above);
        const vec3<T> m = ndf.sample_visible(w, vec2<T>{u.x, u.y});
        const T c = smaller(larger(dot(w, m), horizon<T>()), T(1)), F = at.reflectance(c);
        const auto through = at.cross(c);
        const auto reflects = u.z < F;
        const vec3<T> l = select(reflects, reflect(w, m), at.refracted(w, m, through.K));
        const vec3<T> up{l.x, l.y, select(reflects, l.z, -l.z)};

        const T sv = detail::area_above(ndf, w), lz = larger(up.z, T(0));
        const vec3<T> lit{l.x, l.y, lz};
        const T sl = detail::area_above(ndf, lit);
        const T chosen = select(reflects, F, at.transmittance(c, through.g) * c * through.g * at.n) * ndf.D(upward(m));
        const T spread = larger(sv * select(reflects, T(4), through.K * through.K), detail::smallest<T>());
        const auto valid = above_horizon(w, up) && chosen > detail::smallest<T>();  // a Gaussian tail may underflow
        const T weight =
            select(reflects, lz * sv, shadow.correlation(ndf, w, lit, sv, sl) * Transport::scale(at.n) * lz);
        return {select(valid, vec3<T>{l.x, l.y, select(from_below, -l.z, l.z)}, vec3<T>{T(0), T(0), T(1)}),
                quotient(valid, weight, select(reflects, shadow.denominator(ndf, w, lit, sv), sl)),
                select(valid, smaller(chosen / spread, detail::largest<T>()), T(0))};
    }

    constexpr vec2<T> width() const { return ndf.width(); }
    constexpr const N& normals() const { return ndf; }
    constexpr const M& masking() const { return shadow; }
    /// Index below the surface over index above.
    constexpr T relative_index() const { return above.n; }

private:
    using side = detail::dielectric_side<T>;

    static constexpr vec3<T> upward(const vec3<T>& w) { return {w.x, w.y, absolute(w.z)}; }

    template <class X>
    using mask_of = std::remove_cvref_t<decltype(std::declval<X>() > std::declval<X>())>;

    /// The facet that sends v to l, seen from v's side: there v is above, and l too, mirrored if it is refracted.
    struct facet {
        side at;
        vec3<T> v, l, m;  // m: of any length, up where the facet faces v
        mask_of<T> reflects{}, valid{};
        T c{}, g{};    // v.m and, of refraction, -n l.m
        T jacobian{};  // 4 or K^2, which with what `probability` holds make 1/(4 v.m) or n g/K^2, dm/dl

        [[gnu::always_inline]] constexpr facet(const rough_dielectric& b, const vec3<T>& view, const vec3<T>& light)
            : at(side::choose(view.z < T(0), b.below, b.above)), v(upward(view)), l(upward(light)) {
            const T lz = select(view.z < T(0), -light.z, light.z);
            reflects = lz > T(0);
            const vec3<T> d{v.x + l.x, v.y + l.y, v.z + lz};
            const T shift = select(reflects, T(0), at.excess);
            const vec3<T> h{d.x + shift * l.x, d.y + shift * l.y, d.z + shift * lz};
            const T size = length(h), Q = dot(d, d) / T(2);
            const T toward_v = select(at.excess < T(0), T(1), T(-1)), sign = select(reflects, T(1), toward_v);
            m = {sign * h.x, sign * h.y, sign * h.z};
            const T K = -sign * size, over_K = quotient(size > T(0), T(1), K);
            const T v_m = (at.excess - at.n * Q) * over_K, l_m = at.n * (at.excess + Q) * over_K;
            const T room = select(reflects, size, smaller(v_m, l_m));
            valid = smaller(smaller(v.z, l.z), room) > horizon<T>();  // one comparison: a mask of masks stays scalar
            c = select(reflects, smaller(size / T(2), T(1)), select(valid, v_m, T(1)));
            g = select(valid, l_m, T(1));
            jacobian = select(reflects, T(4), K * K);
        }
    };

    /// What of `sample`'s density is not D/(sv jacobian).
    [[gnu::always_inline]] constexpr T probability(const facet& h) const {
        return select(h.reflects, h.at.reflectance(h.c), h.at.transmittance(h.c, h.g) * h.c * h.g * h.at.n);
    }
    /// What of f is not D/denominator.
    [[gnu::always_inline]] constexpr T amount(const facet& h, const T& sv) const {
        return probability(h) *
               select(h.reflects, T(1),
                      shadow.correlation(ndf, h.v, h.l, sv, detail::area_above(ndf, h.l)) * Transport::scale(h.at.n));
    }
    [[gnu::always_inline]] constexpr T denominator(const facet& h, const T& sv) const {
        return h.jacobian *
               select(h.reflects, shadow.denominator(ndf, h.v, h.l, sv), sv * detail::area_above(ndf, h.l));
    }

    [[no_unique_address]] N ndf;
    [[no_unique_address]] M shadow;
    side above, below;
};

}  // namespace lobe
