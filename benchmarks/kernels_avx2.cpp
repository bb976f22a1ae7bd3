// The same rows for AVX2 with fused multiply-add. CMake builds this file and the models' with -march=x86-64-v3, as a
// library of its own with hidden symbols: in one executable the linker would mix the inline functions of the two
// builds.
#include "rows.hpp"

std::vector<section> avx2_sections() {
    std::vector<section> all = foundation_sections();
    for (section& s : model_sections()) all.push_back(std::move(s));
    return all;
}
