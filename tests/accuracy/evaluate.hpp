// Values as the flags of this build make them, and the truth, compiled without any. (A program linked with -ffast-math
// takes denormals for zeros in both: there u < 2^-126 is 0.)
#pragma once

#include <array>
#include <cstddef>

namespace accuracy {

/// A number in the first, or a direction.
using result = std::array<double, 3>;

/// The row's value in float or double from inputs that the type holds exactly.
[[gnu::visibility("default")]] result value_in_float(int row, const double* x);
[[gnu::visibility("default")]] result value_in_double(int row, const double* x);

/// How far it is from the same formula on fifty digits, in the row's unit: infinitely far if it is a NaN. Negative
/// where the truth leaves the type's range and the value does so too.
double error_of_float(int row, const double* x, const result& of);
double error_of_double(int row, const double* x, const result& of);

/// The same for functions of one float, n at a time; the truth is the formula in double.
[[gnu::visibility("default")]] void sweep_values(int function, const float* u, float* values, std::size_t n);
void sweep_errors(int function, const float* u, const float* values, double* errors, std::size_t n);

}  // namespace accuracy
