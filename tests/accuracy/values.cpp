// Compiled once for each set of flags.
#include "evaluate.hpp"
#include "rows.hpp"

namespace accuracy {

namespace {

template <class T>
double value(int row, const double* x) {
    static const auto all = rows<T>();
    T in[8];
    for (int i = 0; i < 8; ++i) in[i] = static_cast<T>(x[i]);
    return static_cast<double>(all[static_cast<std::size_t>(row)].value(in));
}

}  // namespace

double value_in_float(int row, const double* x) { return value<float>(row, x); }
double value_in_double(int row, const double* x) { return value<double>(row, x); }

void sweep_values(int function, const float* u, float* values, std::size_t n) {
    const auto f = functions_of_one_number<float>()[static_cast<std::size_t>(function)].value;
    for (std::size_t i = 0; i < n; ++i) values[i] = f(u + i);
}

}  // namespace accuracy
