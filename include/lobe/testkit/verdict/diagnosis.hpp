// What a wrong ratio usually means: factors that are lost or applied twice leave their mark on every value.
#pragma once

#include <lobe/core/vector.hpp>
#include <lobe/testkit/measure/text.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace lobe::testkit::detail {

/// measured / expected, and where.
struct ratio_at {
    double ratio;
    vec3<double> v, l;
};

inline std::string explain(std::vector<ratio_at> ratios, const std::string& otherwise) {
    struct clue {
        double (*factor)(const vec3<double>& v, const vec3<double>& l);
        const char* meaning;
    };
    using D = const vec3<double>&;
    constexpr double pi = std::numbers::pi;
    static const clue clues[] = {
        {[](D, D) { return pi; }, "pi times too large: a missing 1/pi"},
        {[](D, D) { return 1 / pi; }, "pi times too small: 1/pi is applied twice, or one is too many"},
        {[](D, D) { return 2.0; }, "2 times too large: a factor 1/2 is missing"},
        {[](D, D) { return 0.5; }, "2 times too small: a factor 2 is missing"},
        {[](D, D) { return 4.0; }, "4 times too large: the 1/4 of the reflection, 1/(4 v.m), is missing"},
        {[](D, D) { return 0.25; }, "4 times too small: the 1/4 of the reflection, 1/(4 v.m), is applied twice"},
        {[](D, D) { return 2 * pi; }, "2 pi times too large: the density of the azimuth, 1/(2 pi), is missing"},
        {[](D, D) { return 1 / (2 * pi); },
         "2 pi times too small: the density of the azimuth, 1/(2 pi), is applied twice"},
        {[](D, D l) { return l.z; },
         "cos(theta_l) times the expected: that cosine is applied twice, or missing on the other side"},
        {[](D, D l) { return 1 / l.z; },
         "1/cos(theta_l) times the expected: that cosine is missing, or divided by twice"},
        {[](D, D l) { return 2 * l.z; },
         "2 cos(theta_l) times the expected: cosine-weighted directions are taken for uniform ones, or the reverse"},
        {[](D, D l) { return 0.5 / l.z; }, "1/(2 cos(theta_l)) times the expected: cosine-weighted directions are "
                                           "taken for uniform ones, or the reverse"},
        {[](D v, D) { return v.z; }, "cos(theta_v) times the expected: that cosine is applied once too often"},
        {[](D v, D) { return 1 / v.z; }, "1/cos(theta_v) times the expected: that cosine is missing"},
        {[](D v, D l) { return v.z / l.z; },
         "cos(theta_v)/cos(theta_l) times the expected: the function is symmetric as it is, so it lacks cos(theta_l)"},
        {[](D v, D l) { return l.z / v.z; },
         "cos(theta_l)/cos(theta_v) times the expected: cos(theta_l) is applied twice"},
        {[](D v, D l) { return length(v + l) / 2; },
         "v.m times the expected: the v.m of the Jacobian 1/(4 v.m) is applied once too often, or missing"},
        {[](D v, D l) { return 2 / length(v + l); },
         "1/(v.m) times the expected: the v.m of the Jacobian 1/(4 v.m) is missing, or applied twice"},
        {[](D v, D l) { return 2 * length(v + l); },
         "4 v.m times the expected: the density of m was not turned into one of l (divide by 4 v.m)"},
        {[](D v, D l) { return 0.5 / length(v + l); }, "1/(4 v.m) times the expected: that Jacobian is applied twice"},
        {[](D v, D l) { return (v.z + l.z) / length(v + l); },
         "cos(theta_m) times the expected: that cosine is applied once too often"},
        {[](D v, D l) { return length(v + l) / (v.z + l.z); },
         "1/cos(theta_m) times the expected: the density of normals is D cos(theta_m), that cosine is missing"},
    };
    if (ratios.size() < 3) return otherwise;
    for (const clue& c : clues) {
        std::size_t agree = 0, telling = 0;
        for (const ratio_at& r : ratios) {
            const double factor = c.factor(r.v, r.l);
            agree += std::abs(r.ratio / factor - 1) < 0.01;
            telling += std::abs(factor - 1) > 0.03;
        }
        if (10 * agree >= 9 * ratios.size() && 2 * telling > ratios.size()) return c.meaning;
    }
    std::sort(ratios.begin(), ratios.end(), [](const ratio_at& a, const ratio_at& b) { return a.ratio < b.ratio; });
    const double low = ratios[ratios.size() / 10].ratio, middle = ratios[ratios.size() / 2].ratio,
                 high = ratios[ratios.size() * 9 / 10].ratio;
    if (high - low < 0.01 * std::abs(middle) && std::abs(middle - 1) > 1e-4)
        return "the same factor " + number(middle) + " wherever it fails: a constant is wrong";
    return otherwise;
}

}  // namespace lobe::testkit::detail
