// Compiled once for each set of flags.
#include "evaluate.hpp"
#include "rows.hpp"

namespace accuracy {

namespace {

template <class T>
result evaluated(int row, const double* x) {
    static const auto all = rows<T>();
    const auto& r = all[static_cast<std::size_t>(row)];
    T in[8];
    for (int i = 0; i < 8; ++i) in[i] = static_cast<T>(x[i]);
    if (!r.direction) return {static_cast<double>(r.value(in))};
    const vec3<double> w(r.direction(in));
    return {w.x, w.y, w.z};
}

}  // namespace

result value_in_float(int row, const double* x) { return evaluated<float>(row, x); }
result value_in_double(int row, const double* x) { return evaluated<double>(row, x); }

void sweep_values(int function, const float* u, float* values, std::size_t n) {
    const auto f = functions_of_one_number<float>()[static_cast<std::size_t>(function)].value;
    for (std::size_t i = 0; i < n; ++i) values[i] = f(u + i);
}

}  // namespace accuracy
