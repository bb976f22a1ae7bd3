// A variant as the measurements see it.
#pragma once

#include "inputs.hpp"

#include <string>
#include <vector>

struct kernel {
    std::string name;
    std::size_t components;  // of its result; 0 where there is nothing to compare
    /// Calls one element after the other, each call waiting for the one before. `zero` is 0 and the compiler does not know it.
    std::uint32_t (*one_at_a_time)(const inputs&, std::uint32_t zero);
    /// out[k * stride + i] = component k of element i.
    void (*loop)(const inputs&, float* out);
    bool loop_is_timed = true;  // false where a loop would add nothing
};

std::vector<kernel> baseline_kernels();
std::vector<kernel> quadrature_kernels();
textbook_table textbook_bake(int size, std::uint32_t samples);
#ifdef BENCH_AVX2
__attribute__((visibility("default"))) std::vector<kernel> avx2_kernels();
#endif
