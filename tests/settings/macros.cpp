// Every header compiles where other people's macros are defined, and a call of a name that is one of them works in parentheses.
#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cassert>
#include <charconv>
#include <cmath>
#include <concepts>
#include <csignal>
#include <cstdint>
#include <functional>
#include <iomanip>
#include <iostream>
#include <limits>
#include <map>
#include <memory>
#include <numbers>
#include <optional>
#include <random>
#include <sstream>
#include <string>
#include <tuple>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "macros.hpp"

#include <lobe/lobe.hpp>
#include <lobe/testkit.hpp>

int main() {
    const lobe::microfacet gold{lobe::ggx{lobe::alpha{0.3f}}, lobe::smith_correlated{}, lobe::schlick{glm::vec3{1.0f, 0.71f, 0.29f}}};
    return (lobe::testkit::verify)(gold).passed() ? 0 : 1;
}
