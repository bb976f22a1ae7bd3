// The same variants for AVX2 with fused multiply-add. CMake builds this file with -march=x86-64-v3, as a library of its own with
// hidden symbols: in one executable the linker would mix the inline functions of the two builds.
#include "kernels.hpp"
#include "models.hpp"

std::vector<kernel> avx2_kernels() {
    std::vector<kernel> all = all_kernels();
    for (const model_section& s : all_models()) all.insert(all.end(), s.kernels.begin(), s.kernels.end());
    return all;
}
