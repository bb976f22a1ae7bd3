// What clang's CUDA mode needs to check a program without an installed CUDA: the keywords, and declarations of the
// device's C functions, before <cmath> takes those of the host. (With -nocudainc -nocudalib -fsyntax-only: nothing is
// linked.)
#pragma once

#define __device__ __attribute__((device))
#define __global__ __attribute__((global))
#define __host__ __attribute__((host))

#include <stdlib.h>

// clang-format off
#define DEVICE_FUNCTIONS(F) \
    F(acos) F(acosh) F(asin) F(asinh) F(atan) F(atanh) F(cbrt) F(ceil) F(cos) F(cosh) F(erf) F(erfc) \
    F(exp) F(exp2) F(expm1) F(floor) F(lgamma) F(log) F(log10) F(log1p) F(log2) F(sin) F(sinh) F(sqrt) \
    F(tan) F(tanh) F(tgamma)
// clang-format on
#define DECLARE(name) __device__ double name(double) noexcept;
DEVICE_FUNCTIONS(DECLARE)
__device__ double atan2(double, double) noexcept;
__device__ double fmod(double, double) noexcept;
__device__ double pow(double, double) noexcept;
__device__ void __assert_fail(const char*, const char*, unsigned, const char*) noexcept;
#undef DECLARE
#undef DEVICE_FUNCTIONS

struct thread_index {
    unsigned x;
};
extern const __device__ thread_index threadIdx;
