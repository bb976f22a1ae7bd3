// The report itself, from times and errors.
#pragma once

#include "measure.hpp"
#include "rows.hpp"

#include <map>
#include <string>
#include <vector>

struct measurements {
    std::map<std::string, timing> times;  // by job: the row's name and "/one", "/loop" or "/avx2"
    // the largest ratio of an error of the AVX2 build to that of the baseline, ...
    double avx2_factor = 0;
    std::string avx2_worst;  // ... and whose
    bool avx2 = false;
};

/// `layout`: the text of tradeoff.md.in. `foundation`: lobe's rows beside the textbook's. `models`: every model of the
/// library. Throws std::runtime_error where the layout and the sections do not fit each other.
std::string report(const std::string& layout, const std::vector<section>& foundation,
                   const std::vector<section>& models, const measurements& measured);
