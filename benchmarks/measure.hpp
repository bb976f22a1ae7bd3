// Times by Google Benchmark: medians over repetitions whose order is shuffled, so that a drift of the machine's speed
// cancels.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

struct job {
    std::string name;
    std::function<void()> work;  // one pass over the arrays
};

struct timing {
    double ns;      // a pass, median
    double spread;  // distance of the quartiles over the median
};

/// Google Benchmark's own arguments (--benchmark_...). Throws std::runtime_error for one that it does not know.
void set_benchmark_options(const std::vector<std::string>& arguments);

std::map<std::string, timing> measure(const std::vector<job>& jobs);
