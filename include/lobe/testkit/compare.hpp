// Are two implementations equal, where not, and by how much energy: `compare(a, b)`, `compare_distribution(a, b)`,
// `compare_fresnel(a, b)`. What is lost breaks no law of a BRDF: only a comparison sees it.
#pragma once

#include <lobe/testkit/compare/of_brdf.hpp>
#include <lobe/testkit/compare/of_distribution.hpp>
#include <lobe/testkit/compare/of_fresnel.hpp>

#include <algorithm>
#include <cstddef>

namespace lobe::testkit {

/// Compares two BRDFs of any type that `verify` takes, in float or double each: `a` is the one in question (measured),
/// `b` the reference (expected). f_cos at pairs of directions of all scales and its energy seen from a few views; pdf,
/// where both have one. A spectrum of one number is compared with each of the other's.
/// Values may differ by `tolerance`, relative, and by what rounding does there.
template <class A, class B>
[[nodiscard]] report compare(const A& a, const B& b, const compare_options& o = {}) {
    return detail::compared(detail::interface_of(a), detail::interface_of(b), o);
}

/// The same for two distributions of normals: D, and the projected area, Lambda or G1 where both have one of them.
template <class A, class B>
[[nodiscard]] report compare_distribution(const A& a, const B& b, const compare_options& o = {}) {
    return detail::compared(detail::interface_of_distribution(a), detail::interface_of_distribution(b), o);
}

/// The same for two Fresnel reflectances, functions of the cosine.
template <class A, class B>
[[nodiscard]] report compare_fresnel(const A& a, const B& b, const compare_options& o = {}) {
    return detail::compared(detail::interface_of_fresnel(a), detail::interface_of_fresnel(b), o);
}

}  // namespace lobe::testkit
