// Two distributions of normals on one surface.
#pragma once

#include <lobe/ndf/concepts.hpp>

#include <cassert>

namespace lobe {

/// (1 - w) first + w second: of D, of the projected area and of Lambda, which are all linear in the facets,
/// so the masking of the mixture is exactly Smith's. Kulla & Conty 2017, "Revisiting Physically Based
/// Shading at Imageworks". (Adding two BRDFs, each with its own masking, is another model: `sum`.)
/// Where one of them has no area the mixture has none.
/// u.x chooses a component in proportion to its projected area (its weight, for all normals),
/// and is rescaled to [0,1). w in [0,1].
template <normal_density First, normal_density Second>
    requires std::same_as<typename First::scalar, typename Second::scalar>
class mixture {
    using T = typename First::scalar;

public:
    using scalar = T;
    static constexpr bool isotropic = First::isotropic && Second::isotropic;

    constexpr mixture(const First& one, const Second& other, const T& weight_of_second)
        : first(one), second(other), w(weight_of_second) {
        assert(all(w >= T(0)) && all(w <= T(1)) && "mixture: the weight of the second must be in [0,1]");
    }

    // (Inlined by force: docs/design.md.)
    [[gnu::always_inline]] constexpr T D(const vec3<T>& m) const { return mix(first.D(m), second.D(m)); }
    [[gnu::always_inline]] constexpr T
    projected_area(const vec3<T>& v) const requires distribution<First> && distribution<Second> {
        return mix(first.projected_area(v), second.projected_area(v));
    }
    constexpr T lambda(const vec3<T>& v) const requires distribution<First> && distribution<Second> {
        return mix(first.lambda(v), second.lambda(v));
    }

    /// The narrower along each axis.
    constexpr vec2<T> width() const {
        const vec2<T> a = first.width(), b = second.width();
        return {smaller(a.x, b.x), smaller(a.y, b.y)};
    }

    [[gnu::always_inline]] constexpr vec3<T>
    sample(const vec2<T>& u) const requires samplable_density<First> && samplable_density<Second> {
        const chosen c(T(1) - w, u.x);
        return select(c.first, first.sample({c.u, u.y}), second.sample({c.u, u.y}));
    }
    constexpr T pdf(const vec3<T>& m) const { return D(m) * m.z; }

    [[gnu::always_inline]] constexpr vec3<T> sample_visible(const vec3<T>& v, const vec2<T>& u) const requires
        visibly_samplable_distribution<First> && visibly_samplable_distribution<Second> {
        const T a = (T(1) - w) * first.projected_area(v), b = w * second.projected_area(v);
        const chosen c(a / (a + b), u.x);
        return select(c.first, first.sample_visible(v, {c.u, u.y}), second.sample_visible(v, {c.u, u.y}));
    }
    constexpr T pdf_visible(const vec3<T>& v,
                            const vec3<T>& m) const requires distribution<First> && distribution<Second> {
        return larger(dot(v, m), T(0)) * D(m) / projected_area(v);
    }

private:
    constexpr T mix(const T& a, const T& b) const { return (T(1) - w) * a + w * b; }

    /// Chooses the first with probability p and rescales u to [0,1). (The second form rounds to less than 1.)
    struct chosen {
        decltype(std::declval<T>() < std::declval<T>()) first;
        T u;
        constexpr chosen(const T& p, const T& x)
            : first(x < p),
              u(select(first, x / select(first, p, T(1)), T(1) - (T(1) - x) / select(p < T(1), T(1) - p, T(1)))) {}
    };

    [[no_unique_address]] First first;
    [[no_unique_address]] Second second;
    T w;
};

}  // namespace lobe
