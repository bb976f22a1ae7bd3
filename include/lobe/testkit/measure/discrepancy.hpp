// How unevenly points lie in the square, and numbers in [0,1).
#pragma once

#include <lobe/core/vector.hpp>

#include <algorithm>
#include <vector>

namespace lobe::testkit::detail {

/// The mean square over all boxes [0,x) of (share of the points in the box - its area). Warnock 1972, O(n^2).
inline double squared_l2_star_discrepancy(const std::vector<vec2<double>>& p) {
    const double n = static_cast<double>(p.size());
    double single = 0, pairs = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
        single += (1 - p[i].x * p[i].x) * (1 - p[i].y * p[i].y) / 4;
        pairs += (1 - p[i].x) * (1 - p[i].y);
        for (std::size_t j = 0; j < i; ++j)
            pairs += 2 * (1 - (std::max)(p[i].x, p[j].x)) * (1 - (std::max)(p[i].y, p[j].y));
    }
    return 1.0 / 9 - 2 * single / n + pairs / (n * n);
}

/// The largest difference between the share of points below x and x.
inline double star_discrepancy(std::vector<double> x) {
    std::sort(x.begin(), x.end());
    const double n = static_cast<double>(x.size());
    double worst = 0;
    for (std::size_t i = 0; i < x.size(); ++i)
        worst = (std::max)({worst, x[i] - static_cast<double>(i) / n, (static_cast<double>(i) + 1) / n - x[i]});
    return worst;
}

}  // namespace lobe::testkit::detail
