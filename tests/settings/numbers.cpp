// Prints every number of everything.hpp; given such a print, compares: `numbers plain.txt` fails where two differ by
// more than rounding.
#include "everything.hpp"

#include <cmath>
#include <fstream>
#include <iostream>
#include <limits>
#include <map>
#include <string>

namespace {

template <class T>
everything::input<T> somewhere() {
    return {{T(0.6f), T(0), T(0.8f)}, {T(0.48f), T(-0.6f), T(0.64f)}, {T(0.3f), T(0.7f)}, T(0.3f), T(0.4f)};
}

}  // namespace

int main(int argc, char** argv) {
    std::map<std::string, double> plain;
    if (argc > 1) {
        std::ifstream file(argv[1]);
        std::string name;
        for (double value; file >> name >> value;) plain[name] = value;
    }
    int wrong = 0;
    const auto look = [&]<class T>(const std::string& name, const T& value) {
        std::cout << name << ' ' << double(value) << '\n';
        // other instructions, other roundings: a few hundred of them go into one number
        const bool same = argc < 2 || (plain.count(name) && std::abs(double(value) - plain[name]) <=
                                                                1000 * double(std::numeric_limits<T>::epsilon()) *
                                                                    (1 + std::abs(plain[name])));
        if (!std::isfinite(value) || !same)
            ++wrong, std::cerr << name << ": " << double(value) << ", not " << plain[name] << '\n';
    };
    std::cout.precision(17);
    everything::for_each(somewhere<float>(), [&](const char* name, float x) { look(std::string(name) + "_float", x); });
    everything::for_each(somewhere<double>(),
                         [&](const char* name, double x) { look(std::string(name) + "_double", x); });
    return wrong;
}
