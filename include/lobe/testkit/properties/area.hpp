// The projected area of the microsurface is that of its normals.
#pragma once

#include <lobe/testkit/subject/distribution.hpp>
#include <lobe/testkit/verdict/comparison.hpp>
#include <lobe/testkit/verdict/per_view.hpp>

#include <algorithm>
#include <cmath>

namespace lobe::testkit {

namespace id {
inline constexpr property_id area_of_normals{"area_of_normals", "projected area = integral of max(0, v.m) D"};
inline constexpr property_id area_by_lambda{"area_by_lambda", "projected area = cos (1 + Lambda)"};
}  // namespace id

namespace detail {

template <class T>
void areas(distribution<T>& n, report& r) {
    using V = vec3<T>;
    if (!n.raw.area) return;
    per_view identity(id::area_of_normals, "the masking belongs to another distribution or width, or is an "
                                           "approximation (then ask for a larger tolerance)");
    for (const V& v : n.views(n.area_everywhere)) {
        const auto exact = n.area_by_quadrature(normalize(vec3<double>(v)));
        identity.add([&](bool doubted) -> view_result {
            // Below the horizon the area is what rounding leaves of the area above: relative to |cos|, too.
            const auto [value, error] = exact(doubted);
            const double size = (std::max)(value[0], std::abs(static_cast<double>(v.z)) * 1e-3);
            return {.measured = n.area(v),
                    .expected = value[0],
                    .allowed = n.claims.tolerance * size + error[0],
                    .v = vec3<double>(v),
                    .input = literal("v", v)};
        });
    }
    identity.report_to(r);
    if (!n.raw.lambda) return;
    comparison<T> both(id::area_by_lambda, n.claims.tolerance, "the two are formulas of different widths or models");
    for (const V& v : n.views(false))
        both.add(n.area(v), static_cast<double>(v.z) * (1 + n.raw.lambda(v)), {.v = v, .has_l = false});
    both.report_to(r, [&](const place<T>& at, std::size_t) {
        return 2 * rounding_noise<T>([&](const V& v, const V&) { return n.raw.area(v); }, at);
    });
}

}  // namespace detail

}  // namespace lobe::testkit
