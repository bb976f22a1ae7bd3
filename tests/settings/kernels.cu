// A kernel for every function of everything.hpp. With HOST_ONLY: for those that are not to be called from one, each of
// which is an error.
// With CLANG: checked by clang's CUDA mode, without an installed CUDA. With HOLE: one that a check has to find.
#ifdef CLANG
#include "cuda_by_clang.hpp"
#endif
#include "everything.hpp"

namespace everything {

#ifdef HOST_ONLY
#define EVERYTHING_CALL(name, ...)                                                                                     \
    __global__ void name##_kernel(const input<float>* inputs, float* out) {                                            \
        using namespace lobe;                                                                                          \
        using T = float;                                                                                               \
        const input<T>& in = *inputs;                                                                                  \
        *out = __VA_ARGS__;                                                                                            \
    }
#include "host_only.inc"
#else
#define EVERYTHING_CALL(name, ...)                                                                                     \
    extern "C" __global__ void name##_float(const input<float>* in, float* out) {                                      \
        out[threadIdx.x] = name(in[threadIdx.x]);                                                                      \
    }                                                                                                                  \
    extern "C" __global__ void name##_double(const input<double>* in, double* out) {                                   \
        out[threadIdx.x] = name(in[threadIdx.x]);                                                                      \
    }
#include "everything.inc"
#endif

#ifdef HOLE
template <class T>
T host_only(const T& x) {
    return x + x;
}
template <class T>
constexpr T hole(const input<T>& in) {
    return host_only(in.x);
}
extern "C" __global__ void hole_float(const input<float>* in, float* out) { out[threadIdx.x] = hole(in[threadIdx.x]); }
#endif

}  // namespace everything
