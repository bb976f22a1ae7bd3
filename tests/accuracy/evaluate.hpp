// Values as the flags of this build make them, and the truth, which no flag touches.
#pragma once

#include <cstddef>

namespace accuracy {

/// The row's value in float or double from inputs that the type holds exactly.
double value_in_float(int row, const double* x);
double value_in_double(int row, const double* x);

/// How far it is from the same formula on fifty digits: in units of the last place of the type, at the truth or at 1.
double error_of_float(int row, const double* x, double value);
double error_of_double(int row, const double* x, double value);

/// The same for functions of one float, n at a time; the truth is the formula in double.
void sweep_values(int function, const float* u, float* values, std::size_t n);
void sweep_errors(int function, const float* u, const float* values, double* errors, std::size_t n);

}  // namespace accuracy
