// How much an effort is worth.
#pragma once

#include <lobe/testkit/options.hpp>

namespace lobe::testkit::detail {

struct budget {
    int views, pairs, strata;  // strata^2 samples a view
    long evaluations;          // of one integral, at most
    double tolerance;          // of one integral, relative
};
inline budget budget_of(effort e) {
    return e == effort::quick
               ? budget{.views = 9, .pairs = 4096, .strata = 96, .evaluations = 24000, .tolerance = 3e-4}
               : budget{.views = 32, .pairs = 100000, .strata = 384, .evaluations = 200000, .tolerance = 5e-5};
}

/// Of a furnace, or of a share of samples: less than this is neither lost nor gained.
inline constexpr double least_that_counts = 1e-4;

}  // namespace lobe::testkit::detail
