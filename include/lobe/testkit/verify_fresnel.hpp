// The verdict on a Fresnel reflectance: `verify_fresnel(f)`.
#pragma once

#include <lobe/testkit/properties/reflectance.hpp>
#include <lobe/testkit/verdict/attempt.hpp>
#include <lobe/testkit/verdict/last_words.hpp>

namespace lobe::testkit {

namespace detail {

template <class T, std::size_t N>
report verdict_on(const fresnel_functions<T, N>& functions, const options& o) {
    report r = opened(o);
    if (!r.passed()) return r;
    reflectance<T, N> f{.raw = functions, .claims = o};
    longest_spectrum = 0;
    last_words words([&](line& out) {
        out << "cosine = ";
        write_literal(out, f.last);
    });
    attempt(
        r, [&] { return literal(f.last); },
        [&] {
            for (const auto& property : {range<T, N>, shape<T, N>, average<T, N>})
                property(f, r), words.so_far = r.text();
        });
    report_length(r, longest_spectrum);
    return r;
}

}  // namespace detail

/// Judges any callable F(cos) of the cosine between the direction and the (micro)normal, a scalar or rgb; `average()`,
/// its cosine-weighted mean 2 int F(u) u du, where it exists.
template <class F>
[[nodiscard]] report verify_fresnel(const F& fresnel, const options& o = {}) {
    constexpr bool returns_a_spectrum = detail::fresnel_fits<F, double> || detail::fresnel_fits<F, float>;
    static_assert(returns_a_spectrum,
                  "F(cosine) returns no spectrum: a number, a GLM vector, what has begin() and end(), or r, g, b");
    if constexpr (returns_a_spectrum)
        return detail::verdict_on(detail::interface_of_fresnel(fresnel), o);
    else
        return report(o.name);
}

}  // namespace lobe::testkit
