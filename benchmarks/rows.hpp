// What the report compares: sections, their rows, and what each row's result is measured against.
#pragma once

#include "inputs.hpp"

#include <string>
#include <vector>

using real = long double;

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

/// A variant as the measurements see it.
struct kernel {
    std::size_t components;  // of its result
    /// Calls one element after the other, each call waiting for the one before. `zero` is 0 and the compiler does not
    /// know it.
    std::uint32_t (*one_at_a_time)(const inputs&, std::uint32_t zero);
    /// out[k * stride + i] = component k of element i.
    void (*loop)(const inputs&, float* out);
    bool loop_is_timed = true;  // false where a loop would add nothing
};

using exact_result = void (*)(const inputs&, std::size_t i, real* components);

/// What a result is measured against, and what that shows: rounding, or what else the variant leaves out.
struct reference {
    std::string kind;
    exact_result exact;
};

struct error_summary {
    double median = 0, largest = 0;
};

struct row {
    std::string name, label;  // the name: with the section's title
    kernel code;
    std::vector<reference> references;                    // none: only timed
    std::vector<error_summary> usual = {}, extreme = {};  // measured: for each reference those of each metric
};

/// Its title is also the heading of its table in tradeoff.md.in.
struct section {
    std::string title;
    std::vector<metric> metrics;
    std::vector<row> rows;
    std::vector<std::vector<std::string>> extra = {};  // another table, its header first
};

/// The foundation, beside the forms that tutorials print: of each section lobe's row first, the textbook form of the
/// same second, approximations after them.
std::vector<section> foundation_sections();
/// Every model of the library.
std::vector<section> distribution_models();
std::vector<section> brdf_part_models();
std::vector<section> sampler_models();
std::vector<section> glass_models();
std::vector<section> other_models();
std::vector<section> point_set_models();
inline std::vector<section> model_sections() {
    std::vector<section> all;
    for (const auto& models : {distribution_models(), brdf_part_models(), sampler_models(), glass_models(),
                               point_set_models(), other_models()})
        all.insert(all.end(), models.begin(), models.end());
    return all;
}
#ifdef BENCH_AVX2
/// All of them in that order, compiled for AVX2 and without exact results.
__attribute__((visibility("default"))) std::vector<section> avx2_sections();
#endif
