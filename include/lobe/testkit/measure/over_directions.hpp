// An integral over the directions of a chart: where a mesh has to be fine before it can be trusted.
#pragma once

#include <lobe/testkit/measure/budget.hpp>
#include <lobe/testkit/measure/mesh.hpp>

#include <lobe/core/vector.hpp>

#include <array>
#include <vector>

namespace lobe::testkit::detail {

/// Where a few of the samples lie in a chart.
using hints = std::vector<std::array<double, 2>>;

/// Refines about the fixed direction, where light may come back, about the normal, and where samples crowd; then until
/// the error is small.
template <std::size_t N, class Chart>
void integrate(mesh<N>& m, const Chart& chart, const vec3<double>& fixed, const hints& crowded, const budget& b,
               std::size_t colours) {
    for (const vec3<double>& w : {fixed, vec3<double>{0, 0, 1}}) {
        for (const auto& peak : {chart.find(w), chart.find(chart.whole_sphere ? -w : w)})
            m.refine_at(peak[0], peak[1], 4);
    }
    m.refine_crowded(crowded, 24, 12);
    m.refine(b.tolerance, colours, b.evaluations);
}

}  // namespace lobe::testkit::detail
