/* The judge of BRDFs as a C interface, for C, Rust, C#, Swift, Python and C++ of any standard: lobe_verify. The library
 * is the CMake target lobe_verify (-DLOBE_BUILD_C_INTERFACE=ON); or include <lobe/testkit/c.hpp> in one C++20 file. */
#ifndef LOBE_TESTKIT_C_H
#define LOBE_TESTKIT_C_H

#include <stddef.h>
#include <stdint.h>

#if defined(_WIN32) && defined(LOBE_VERIFY_EXPORTS)
#define LOBE_VERIFY_API __declspec(dllexport)
#elif defined(__GNUC__)
#define LOBE_VERIFY_API __attribute__((visibility("default")))
#else
#define LOBE_VERIFY_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* Directions are in tangent space, n = (0,0,1), unit, pointing away from the surface: three numbers each, one after
 * another. `count` places are asked for at once, from 1 to some 100000, always from the thread that called lobe_verify.
 * A function fills its output, and returns 0; anything else ends that part of the verdict, and is a finding. */

/* f(v,l) cos(theta_l): count * channels numbers, those of one place together; or a density of l in 1/sr: count. */
typedef int (*lobe_function)(void* data, size_t count, const double* v, const double* l, double* out);

/* A direction for each v and u (`numbers` of them a place, in [0,1)): l, weight = f_cos/pdf (channels numbers a place),
 * pdf in 1/sr. A sample that fails has pdf 0 and weight 0. */
typedef int (*lobe_sampler)(void* data, size_t count, const double* v, const double* u, double* l, double* weight,
                            double* pdf);

typedef struct lobe_brdf {
    void* data;          /* handed to the functions as it is */
    int channels;        /* numbers of a spectrum: 1 to 16 */
    int numbers;         /* numbers of u: 2, or 3 where one selects a lobe */
    lobe_function f_cos; /* has to be there; the other two may be NULL */
    lobe_sampler sample;
    lobe_function pdf;
} lobe_brdf;

/* As options of <lobe/testkit/options.hpp>, which explains them. lobe_default_options() fills it; 0 is false. */
typedef struct lobe_options {
    const char* name; /* heads the report: UTF-8, or NULL */
    double tolerance;
    uint64_t seed;
    int thorough;
    int single_precision; /* v, l and u are numbers of float, and as much rounding is forgiven */
    int reciprocal;
    int lossless;
    int isotropic;
    int zero_below;
    int transmits; /* a BSDF, on the whole sphere */
    double eta;
    int radiance;
} lobe_options;

LOBE_VERIFY_API lobe_options lobe_default_options(void);

typedef struct lobe_report lobe_report;

/* The verdict. NULL: the arguments make no sense, or memory is short; lobe_error() says which. `options` may be NULL.
 * No exception leaves it; one that the functions throw is a finding. */
LOBE_VERIFY_API lobe_report* lobe_verify(const lobe_brdf* brdf, const lobe_options* options);

LOBE_VERIFY_API int lobe_passed(const lobe_report* report);
/* Texts live as long as the report. */
LOBE_VERIFY_API const char* lobe_text(const lobe_report* report);
LOBE_VERIFY_API const char* lobe_json(const lobe_report* report);
LOBE_VERIFY_API const char* lobe_junit(const lobe_report* report);
LOBE_VERIFY_API void lobe_free(lobe_report* report); /* NULL: nothing */

/* Why the last lobe_verify of this thread returned NULL. Never NULL itself. */
LOBE_VERIFY_API const char* lobe_error(void);

#ifdef __cplusplus
}
#endif

#endif
