// What a numeric method wants to know of its scalar type.
#pragma once

#include <lobe/core/scalar.hpp>

#include <limits>

namespace lobe::detail {

/// One number, not a pack of them: something that an `if` can look at.
template <class T>
concept one_lane = scalar<T> && requires(const T a) {
    { a < a } -> std::convertible_to<bool>;
};

/// What tables and integrals are computed in: double at least.
template <class T>
using at_least_double = std::conditional_t<std::same_as<T, float>, double, T>;

/// More digits than double has.
template <class T>
inline constexpr bool beyond_double =
    std::numeric_limits<lane_t<T>>::is_specialized&& std::numeric_limits<lane_t<T>>::digits > 64;

/// A number that stands for zero, a cosine for instance: its square times the square
/// of a width (1e-4 in float) is still a number.
template <scalar T>
constexpr T zero_cosine() {
    if constexpr (std::same_as<lane_t<T>, float>)
        return T(0x1p-44f);
    else
        return T(0x1p-490);
}

}  // namespace lobe::detail
