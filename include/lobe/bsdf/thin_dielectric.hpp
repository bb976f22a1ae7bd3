// A pane: two parallel interfaces in one, with all reflections between them.
#pragma once

#include <lobe/brdf/microfacet.hpp>
#include <lobe/bsdf/smooth_dielectric.hpp>
#include <lobe/fresnel/schlick.hpp>

namespace lobe {

/// The reflectance of a pane, a callable of the cosine: with R of one face, R + T R T + T R^3 T + ... = 2R/(1 + R), and
/// `transmittance` (1 - R)/(1 + R). Light that is not coherent, a pane that absorbs nothing.
template <scalar T>
class pane {
    detail::dielectric_side<T> face;

public:
    /// Index of the pane over that of what is around it.
    constexpr explicit pane(const T& eta) : face(detail::dielectric_side<T>::above(eta)) {
        assert(all(eta > T(0)) && all(detail::finite(T(eta * eta))) &&
               "pane: eta must be above 0 and its square finite");
    }
    constexpr T operator()(const T& c) const {
        const T R = face.reflectance(c);
        return T(2) * R / (T(1) + R);
    }
    constexpr T transmittance(const T& c) const {
        const T cosine = larger(c, horizon<T>());
        return face.transmittance(cosine, face.cross(cosine).g) / (T(1) + face.reflectance(c));
    }
};

/// A smooth pane: a window. Reflects, or goes straight through, the same from both sides.
/// `eta`: index of the pane over that of what is around it.
template <scalar T>
class thin_dielectric {
    pane<T> both_faces;

public:
    using scalar = T;
    using spectrum = T;
    static constexpr bool transmits = true;

    constexpr explicit thin_dielectric(const T& eta) : both_faces(eta) {}

    /// u in [0,1): reflects if u < 2R/(1 + R). Weight 1.
    constexpr discrete_sample<T, T> sample(const vec3<T>& v, const T& u) const {
        const T c = smaller(absolute(v.z), T(1)), R = both_faces(c);
        const auto reflects = u < R;
        return detail::chosen_if(absolute(v.z) > horizon<T>(),
                                 select(reflects, vec3<T>{-v.x, -v.y, v.z}, vec3<T>{-v.x, -v.y, -v.z}), T(1),
                                 select(reflects, R, both_faces.transmittance(c)));
    }
};

/// A rough pane: reflects as `microfacet` does with the reflectance of a pane, and lets the rest through into the same
/// lobe mirrored to the other side, as glTF's KHR_materials_transmission has it: blur without displacement. Reciprocal;
/// loses what single scattering loses. From both sides. `eta` as in `thin_dielectric`.
template <distribution N, masking<N> M>
class rough_thin_dielectric : exact_vectors<rough_thin_dielectric<N, M>> {
    using T = typename N::scalar;
    using exact = exact_vectors<rough_thin_dielectric>;

public:
    using scalar = T;
    using spectrum = T;
    using exact::f, exact::f_cos, exact::pdf, exact::evaluate, exact::sample;
    static constexpr bool isotropic = N::isotropic, transmits = true;

    constexpr rough_thin_dielectric(const N& ndf, const M& shadow, const T& eta)
        : lobe(ndf, shadow, {}), both_faces(eta) {}

    // (Inlined by force, as microfacet's are: docs/design.md.)
    [[gnu::always_inline]] constexpr T f(const vec3<T>& v, const vec3<T>& l) const {
        return lobe.f(upward(v), upward(l)) * share(v, l);
    }
    [[gnu::always_inline]] constexpr T f_cos(const vec3<T>& v, const vec3<T>& l) const {
        return lobe.f_cos(upward(v), upward(l)) * share(v, l);
    }
    [[gnu::always_inline]] constexpr T pdf(const vec3<T>& v, const vec3<T>& l) const {
        return lobe.pdf(upward(v), upward(l)) * share(v, l);
    }
    [[gnu::always_inline]] constexpr evaluation<T, T> evaluate(const vec3<T>& v, const vec3<T>& l) const {
        const auto e = lobe.evaluate(upward(v), upward(l));
        const T part = share(v, l);
        return {e.f_cos * part, e.pdf * part};
    }

    /// u in [0,1)^3: u.x and u.y draw a visible normal, u.z < 2R/(1 + R) reflects. Weight: G2/G1(v).
    [[gnu::always_inline]] constexpr direction_sample<T, T>
    sample(const vec3<T>& v, const vec3<T>& u) const requires visibly_samplable_distribution<N> {
        const vec3<T> w = upward(v);
        const auto s = lobe.sample(w, vec2<T>{u.x, u.y});
        const T c = smaller(length(w + s.l) / T(2), T(1)), R = both_faces(c);
        const auto reflects = u.z < R;
        const auto up = select(reflects, v.z, -v.z) > T(0);
        const T sampled = s.pdf * select(reflects, R, both_faces.transmittance(c));
        const auto valid = sampled > T(0);
        return {select(valid, vec3<T>{s.l.x, s.l.y, select(up, s.l.z, -s.l.z)}, vec3<T>{T(0), T(0), T(1)}),
                select(valid, s.weight, T(0)), sampled};
    }

    constexpr vec2<T> width() const { return lobe.width(); }

private:
    static constexpr vec3<T> upward(const vec3<T>& w) { return {w.x, w.y, absolute(w.z)}; }

    /// What the pane reflects, or lets through, at the facet between v and l, mirrored.
    [[gnu::always_inline]] constexpr T share(const vec3<T>& v, const vec3<T>& l) const {
        const T c = smaller(length(upward(v) + upward(l)) / T(2), T(1));
        const T across = select(v.z < T(0), -l.z, l.z);
        return select(across > T(0), both_faces(c), both_faces.transmittance(c));
    }

    microfacet<N, M, perfect_reflector<T>> lobe;
    pane<T> both_faces;
};

}  // namespace lobe
