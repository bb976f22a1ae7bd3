// The report itself, from times and errors.
#pragma once

#include "errors.hpp"
#include "kernel.hpp"
#include "measure.hpp"

#include <map>
#include <ostream>
#include <string>

struct measurements {
    std::map<std::string, timing> times;  // by job: the kernel's name and "/one", "/loop" or "/avx2"
    /// By kernel: the errors of its row, for each reference those of each metric, for the usual and the extreme inputs.
    std::map<std::string, std::vector<error_summary>> usual, extreme;
    double avx2_factor = 0;  // the largest ratio of an error of the AVX2 build to that of the baseline, ...
    std::string avx2_worst;  // ... and whose
    bool avx2 = false;
};

/// `foundation`: lobe's rows beside the textbook's. `models`: every model of the library.
void write_report(std::ostream& out, const std::vector<section>& foundation, const std::vector<section>& models,
                  const measurements& measured);
