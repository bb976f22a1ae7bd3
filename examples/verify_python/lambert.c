/* The judge from C99: a matt surface with its sampler. "lambert ALBEDO" exits with 0 where it passes, else 1.
 * cc -std=c99 -I include lambert.c -llobe_verify -lm */
#include <lobe/testkit/c.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

static const double pi = 3.14159265358979323846;

static int f_cos(void *data, size_t count, const double *v, const double *l, double *out)
{
    const double albedo = *(const double *)data;
    for (size_t i = 0; i < count; ++i)
        out[i] = v[3 * i + 2] > 0 && l[3 * i + 2] > 0 ? albedo / pi * l[3 * i + 2] : 0;
    return 0;
}

static int pdf(void *data, size_t count, const double *v, const double *l, double *out)
{
    (void)data, (void)v;
    for (size_t i = 0; i < count; ++i)
        out[i] = l[3 * i + 2] > 0 ? l[3 * i + 2] / pi : 0;
    return 0;
}

static int sample(void *data, size_t count, const double *v, const double *u, double *l, double *weight, double *density)
{
    const double albedo = *(const double *)data;
    (void)v;
    for (size_t i = 0; i < count; ++i) {
        const double r = sqrt(u[2 * i]), turn = 2 * pi * u[2 * i + 1];
        l[3 * i] = r * cos(turn), l[3 * i + 1] = r * sin(turn), l[3 * i + 2] = sqrt(1 - u[2 * i]);
        weight[i] = albedo;
        density[i] = l[3 * i + 2] / pi;
    }
    return 0;
}

int main(int argc, char **argv)
{
    double albedo = argc > 1 ? atof(argv[1]) : 0.8;
    const lobe_brdf brdf = {&albedo, 1, 2, f_cos, sample, pdf};
    lobe_options options = lobe_default_options();
    options.name = "matt";
    lobe_report *report = lobe_verify(&brdf, &options);
    if (!report) {
        fprintf(stderr, "%s\n", lobe_error());
        return 2;
    }
    const int passed = lobe_passed(report);
    fputs(lobe_text(report), stdout);
    lobe_free(report);
    return passed ? 0 : 1;
}
