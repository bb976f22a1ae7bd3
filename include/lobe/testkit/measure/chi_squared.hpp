// Do counts follow the expected ones? Pearson's chi-squared with merged bins.
#pragma once

#include <lobe/core/cpp20.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace lobe::testkit::detail {

/// The probability that a chi-squared variable of k degrees of freedom exceeds x. Wilson & Hilferty 1931; k >= 5.
inline double chi_squared_tail(double x, double k) {
    const double z = (std::cbrt(x / k) - (1 - 2 / (9 * k))) / std::sqrt(2 / (9 * k));
    return std::erfc(z / std::sqrt(2.0)) / 2;
}

struct bin {
    double expected, observed;
    double variance = 0;  // of what is expected, itself found by chance
};

/// Neighbouring bins merged until each expects `at_least`.
inline std::vector<bin> merged(const std::vector<bin>& bins, double at_least) {
    std::vector<bin> out;
    bin sum{0, 0};
    for (const bin& b : bins) {
        sum.expected += b.expected;
        sum.observed += b.observed;
        sum.variance += b.variance;
        if (sum.expected >= at_least) {
            out.push_back(sum);
            sum = {0, 0};
        }
    }
    if (out.empty() || sum.expected >= at_least) {
        out.push_back(sum);
    } else {
        out.back().expected += sum.expected;
        out.back().observed += sum.observed;
        out.back().variance += sum.variance;
    }
    return out;
}

/// The probability of counts as far from the expected as these. 1 where there are too few bins to tell.
inline double chi_squared_probability(const std::vector<bin>& bins) {
    if (bins.size() < 6) return 1;
    double sum = 0;
    for (const bin& b : bins) sum += (b.observed - b.expected) * (b.observed - b.expected) / (b.expected + b.variance);
    return chi_squared_tail(sum, static_cast<double>(bins.size() - 1));
}

}  // namespace lobe::testkit::detail
