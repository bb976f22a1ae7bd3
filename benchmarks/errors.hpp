// How far results are from the exact ones.
#pragma once

#include "rows.hpp"

/// Those of element i start at most_components * i.
inline constexpr std::size_t most_components = 9;
/// Remembers those it was last asked for.
const std::vector<real>& exact_results(exact_result exact, const inputs& in);

/// `points_at_1` has a count for its largest and no median. Others go over all elements but those whose exact result
/// has a NaN: there rounding decides what the result is.
error_summary error_of(const metric& m, const std::vector<real>& exact, const inputs& in,
                       const std::vector<float>& result);
