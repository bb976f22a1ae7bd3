// What several tests need: reference tables, errors in ULP, random numbers and directions, death by assert.
#pragma once

#include <lobe/core/vector.hpp>

#include <cmath>
#include <cstdint>
#include <fstream>
#include <initializer_list>
#include <limits>
#include <random>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <csignal>
#include <sys/wait.h>
#include <unistd.h>

/// The numbers of tests/reference/NAME: comments and the header line are skipped, and so is a name in the first column.
inline std::vector<std::vector<double>> reference_table(const std::string& name) {
    std::ifstream file(std::string(LOBE_REFERENCE_DIR) + "/" + name);
    if (!file) throw std::runtime_error("no reference table " + name);
    std::vector<std::vector<double>> rows;
    bool header = true;
    for (std::string line; std::getline(file, line);) {
        if (line.empty() || line[0] == '#') continue;
        if (header) {
            header = false;
            continue;
        }
        std::vector<double> row;
        std::istringstream cells(line);
        for (std::string cell; std::getline(cells, cell, ',');) row.push_back(std::strtod(cell.c_str(), nullptr));
        rows.push_back(row);
    }
    if (rows.empty()) throw std::runtime_error("empty reference table " + name);
    return rows;
}

/// The larger, the smaller; a NaN if one is. (std::max(worst, NaN) is worst, and an error that is a NaN would pass.)
template <class T>
T larger(T a, T b) {
    return a < b || b != b ? b : a;
}
template <class T>
T smaller(T a, T b) {
    return b < a || b != b ? b : a;
}
template <class T>
T larger(std::initializer_list<T> values) {
    T largest = *values.begin();
    for (const T& value : values) largest = larger(largest, value);
    return largest;
}

/// |value - exact| in units of the last place of T at `exact`.
template <class T, class Exact>
double ulp_error(T value, Exact exact) {
    int exponent = 0;
    std::frexp(static_cast<double>(exact), &exponent);
    const double last_place =
        std::ldexp(1.0, std::max(exponent - std::numeric_limits<T>::digits,
                                 std::numeric_limits<T>::min_exponent - std::numeric_limits<T>::digits));
    return static_cast<double>(std::abs(static_cast<Exact>(value) - exact)) / last_place;
}

/// Uniform numbers in [0,1) from a fixed seed.
class random_numbers {
public:
    explicit random_numbers(std::uint64_t seed) : engine(seed) {}
    double operator()() { return static_cast<double>(engine() >> 11) * 0x1p-53; }
    double between(double low, double high) { return low + (high - low) * (*this)(); }
    /// Evenly spread in the logarithm.
    double log_between(double low, double high) { return std::exp(between(std::log(low), std::log(high))); }
    /// Any direction of the sphere. (Not inlined: GCC 12 drops the rounding to float of a pair that is turned into
    /// double again.)
    template <class T = double>
    [[gnu::noinline]] lobe::vec3<T> direction() {
        const double z = between(-1, 1), phi = between(0, 6.283185307179586), r = std::sqrt((1 - z) * (1 + z));
        return {static_cast<T>(r * std::cos(phi)), static_cast<T>(r * std::sin(phi)), static_cast<T>(z)};
    }
    /// A direction above the horizon whose cosine is as likely to be tiny as large.
    template <class T = double>
    [[gnu::noinline]] lobe::vec3<T> grazing_direction(double smallest_cosine) {
        const double z = log_between(smallest_cosine, 1), phi = between(0, 6.283185307179586),
                     r = std::sqrt((1 - z) * (1 + z));
        return {static_cast<T>(r * std::cos(phi)), static_cast<T>(r * std::sin(phi)), static_cast<T>(z)};
    }

private:
    std::mt19937_64 engine;
};

/// Does f() end in an assert?
template <class F>
bool aborts(F f) {
    const pid_t child = fork();
    if (child == 0) {
        std::signal(SIGABRT, SIG_DFL);  // not Catch's handler
        if (!std::freopen("/dev/null", "w", stderr)) _exit(2);
        f();
        _exit(0);
    }
    int status = 0;
    waitpid(child, &status, 0);
    return WIFSIGNALED(status) && WTERMSIG(status) == SIGABRT;
}
