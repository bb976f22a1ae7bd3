// What the report compares: sections, their rows, and what each row's result is measured against.
#pragma once

#include "truth.hpp"

#include <string>
#include <vector>

enum class unit_of_error {
    relative,     // |x - exact| / |exact|
    absolute,     // |x - exact|
    weight,       // |x - exact| / max(1, |exact|)
    direction,    // |x - exact| as vectors, in units of alpha
    points_at_1,  // how many elements have a component that is not below 1
};

/// An error over the components [first, first + size) of a result: the largest of them.
struct metric {
    const char* of;
    unit_of_error unit;
    std::size_t first, size;
};

using exact_result = void (*)(const inputs&, std::size_t i, truth::real* components);

/// What a result is measured against, and what that shows: rounding, or what else the variant leaves out.
struct reference {
    std::string kind;
    exact_result exact;
};

struct row {
    std::string kernel, label;
    std::vector<reference> references;
};

struct section {
    std::string title, note;
    std::vector<metric> metrics;
    std::vector<row> rows;  // of the foundation: lobe's first, the textbook form of the same second, approximations after them
    std::vector<std::vector<std::string>> extra = {};  // another table, its header first
};

/// The foundation, beside the forms that tutorials print.
std::vector<section> sections();
