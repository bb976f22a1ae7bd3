// How far results are from the exact ones.
#pragma once

#include "rows.hpp"

struct error_summary {
    double median = 0, largest = 0;
};

/// `points_at_1` has a count for its largest and no median. Others go over all elements but those whose exact result has a NaN: there
/// rounding decides what the result is.
error_summary error_of(const metric& m, exact_result exact, const inputs& in, const float* result);
