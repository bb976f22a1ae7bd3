// The parts of a BRDF, chosen at run time, so that every masking meets every Fresnel without a type for each pair.
#pragma once

#include "input.hpp"

#include <lobe/lobe.hpp>

#include <variant>

namespace fuzz {

template <class T>
lobe::vec3<T> colour(input& in, const char* name) {
    const T red = in.keep(name, share<T>(in)), green = in.keep(name, share<T>(in));
    return {red, green, in.keep(name, share<T>(in))};
}

template <class T>
lobe::vec3<T> numbers(input& in, const char* name, double low, double high) {
    const T x = in.keep(name, between<T>(in, low, high)), y = in.keep(name, between<T>(in, low, high));
    return {x, y, in.keep(name, between<T>(in, low, high))};
}

template <class T>
class any_fresnel {
    using S = lobe::vec3<T>;
    using choice =
        std::variant<lobe::schlick<S>, lobe::schlick<S, S>, lobe::schlick_gaussian<S>, lobe::schlick_roughness<S>,
                     lobe::dielectric<S>, lobe::conductor<S>, lobe::f82_tint<S>, lobe::perfect_reflector<S>>;

public:
    explicit any_fresnel(input& in) : one(chosen(in)) {}
    template <std::same_as<T> U>
    S operator()(const U& c) const {
        return std::visit([&](const auto& f) -> S { return f(c); }, one);
    }
    S average() const {
        return std::visit([](const auto& f) -> S { return f.average(); }, one);
    }

    /// Is the cosine c so near to total internal reflection that rounding it decides about F? The slope of F is
    /// infinite there; g^2 = eta^2 - 1 + c^2 is off by 24 u, and what a conductor absorbs rounds the corner off by 2
    /// eta k.
    bool critical(const T& c, int i) const {
        const auto near = [&](const T& eta, const T& k) {
            const T g2 = (eta - T(1)) * (eta + T(1)) + c * c;
            return eta < T(1) && std::abs(g2) + T(2) * eta * k <= T(256) * std::numeric_limits<T>::epsilon();
        };
        if (const auto* glass = std::get_if<lobe::dielectric<S>>(&one)) return near(glass->relative_index()[i], T(0));
        if (const auto* metal = std::get_if<lobe::conductor<S>>(&one))
            return near(metal->index()[i], metal->extinction()[i]);
        return false;
    }

private:
    static choice chosen(input& in) {
        switch (in.keep("fresnel", in.below(8))) {
            case 0: return lobe::schlick<S>{colour<T>(in, "F0")};
            case 1: {
                const S F0 = colour<T>(in, "F0");
                return lobe::schlick<S, S>{F0, colour<T>(in, "F90")};
            }
            case 2: return lobe::schlick_gaussian<S>{colour<T>(in, "F0")};
            case 3: {
                const S F0 = colour<T>(in, "F0");
                return lobe::schlick_roughness<S>{F0, in.keep("roughness", share<T>(in))};
            }
            case 4: {
                S eta = in.below(2) ? numbers<T>(in, "eta", 0.3, 10) : numbers<T>(in, "eta", 1e-3, 1e3);
                if (in.below(8) == 0) eta.x = T(1);
                return lobe::dielectric<S>{eta};
            }
            case 5: {
                const S eta = in.below(2) ? numbers<T>(in, "eta", 0.3, 10) : numbers<T>(in, "eta", 0.002, 1e9);
                S k = numbers<T>(in, "k", 1e-6, 1e9);
                if (in.below(4) == 0) k.x = T(0);
                return lobe::conductor<S>{eta, k};
            }
            case 6: {
                const S F0 = colour<T>(in, "F0");
                return lobe::f82_tint<S>{F0, colour<T>(in, "tint")};
            }
            default: return lobe::perfect_reflector<S>{};
        }
    }

    choice one;
};

template <class T>
class any_masking : public lobe::masking_functions<any_masking<T>> {
public:
    any_masking(input& in, const T& alpha)
        : kind(in.keep("masking", in.below(6))),
          schlick(lobe::schlick_k<T>(in.below(4) ? alpha / T(2) : in.keep("k", share<T>(in)))) {}

    using lobe::masking_functions<any_masking>::denominator;
    template <lobe::distribution N>
    T denominator(const N& ndf, const lobe::vec3<T>& v, const lobe::vec3<T>& l, const T& sv) const {
        if (kind == 0) return lobe::smith_separable{}.denominator(ndf, v, l, sv);
        if (kind == 1) return lobe::smith_direction_correlated{}.denominator(ndf, v, l, sv);
        if (kind == 2) return lobe::v_cavity{}.denominator(ndf, v, l, sv);
        if (kind == 3) return schlick.denominator(ndf, v, l, sv);
        if constexpr (N::isotropic)
            if (kind == 4 && ndf.width().x <= T(1)) return lobe::smith_hammon{}.denominator(ndf, v, l, sv);
        return lobe::smith_correlated{}.denominator(ndf, v, l, sv);
    }

    /// G2 <= G1 of the distribution's own Smith masking. (Hammon's is GGX's.)
    bool within_smith(bool of_ggx) const { return kind == 0 || kind == 1 || kind == 5 || (of_ggx && kind == 4); }

private:
    std::uint64_t kind;
    lobe::schlick_ggx<T> schlick;
};

template <class T>
lobe::alpha<T> isotropic(input& in, double narrowest, double widest) {
    return lobe::alpha<T>(in.keep("alpha", between<T>(in, narrowest, widest)));
}

template <class T>
lobe::alpha_xy<T> anisotropic(input& in, double narrowest, double widest) {
    const T x = in.keep("alpha x", between<T>(in, narrowest, widest));
    return {x, in.below(4) ? in.keep("alpha y", between<T>(in, narrowest, widest)) : x};
}

}  // namespace fuzz
