// The variants for the processor every x86-64 build assumes (SSE2), or whatever the compiler's default is elsewhere.
#include "kernels.hpp"

std::vector<kernel> baseline_kernels() { return all_kernels(); }
