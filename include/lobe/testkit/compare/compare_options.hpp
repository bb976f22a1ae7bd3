// What counts as a difference, and how hard to look for one.
#pragma once

#include <lobe/testkit/options.hpp>

#include <cstdint>
#include <string>

namespace lobe::testkit {

struct compare_options {
    testkit::effort effort = effort::quick;
    std::uint64_t seed = 1;
    double tolerance = 1e-4;    // relative difference of two values that counts, beyond rounding
    bool whole_sphere = false;  // values are compared where v or l is below the horizon, too
    std::string name{};         // heads the report
};

namespace detail {

inline options as_options(const compare_options& o) {
    options out;
    out.effort = o.effort;
    out.seed = o.seed;
    out.tolerance = o.tolerance;
    out.name = o.name;
    return out;
}

}  // namespace detail

}  // namespace lobe::testkit
