// The values of a stranger's function as doubles: of a number, a GLM vector, anything with a size that [] reads, or r,
// g, b.
#pragma once

#include <lobe/core/vector.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <tuple>
#include <type_traits>

namespace lobe::testkit::detail {

/// The number that a spectrum consists of, and how many: of a number, a GLM vector, anything with a size that [] reads,
/// or r, g, b.
template <class S>
concept has_size = requires(const S s) {
    std::tuple_size<S>::value;
    static_cast<double>(s[0]);
};
template <class S>
concept has_iterators = requires(const S s) {
    static_cast<double>(*s.begin());
    s.end() - s.begin();
};
template <class S>
concept has_rgb = requires(const S s) {
    static_cast<double>(s.r);
    static_cast<double>(s.g);
    static_cast<double>(s.b);
};

template <class S>
struct spectrum;
template <class S>
    requires std::is_arithmetic_v<S>
struct spectrum<S> {
    using scalar = S;
    static constexpr std::size_t size = 1;
    static double get(const S& s, std::size_t) { return static_cast<double>(s); }
};
template <glm::length_t N, class T, glm::qualifier Q>
struct spectrum<glm::vec<N, T, Q>> {
    using scalar = T;
    static constexpr std::size_t size = static_cast<std::size_t>(N);
    static double get(const glm::vec<N, T, Q>& s, std::size_t i) {
        return static_cast<double>(s[static_cast<glm::length_t>(i)]);
    }
};
template <has_size S>
struct spectrum<S> {
    using scalar = std::remove_cvref_t<decltype(std::declval<const S&>()[0])>;
    static constexpr std::size_t size = std::tuple_size<S>::value;
    static double get(const S& s, std::size_t i) { return static_cast<double>(s[i]); }
};
template <has_iterators S>
    requires(!has_size<S>)
struct spectrum<S> {
    using scalar = std::remove_cvref_t<decltype(*std::declval<const S&>().begin())>;
    static constexpr std::size_t size = 16;  // its own size is known at run time only
    static double get(const S& s, std::size_t i) {
        const auto count = static_cast<std::size_t>(s.end() - s.begin());
        return i < count ? static_cast<double>(*(s.begin() + static_cast<std::ptrdiff_t>(i))) : 0;
    }
};
template <has_rgb S>
    requires(!has_size<S> && !has_iterators<S>)
struct spectrum<S> {
    using scalar = std::remove_cvref_t<decltype(std::declval<const S&>().r)>;
    static constexpr std::size_t size = 3;
    static double get(const S& s, std::size_t i) { return static_cast<double>(i == 0 ? s.r : i == 1 ? s.g : s.b); }
};

template <class S>
concept is_spectrum = requires {
    typename spectrum<S>::scalar;
};
/// Whether it is float or double that S is computed in.
template <class S>
using scalar_of_spectrum = std::conditional_t<std::is_same_v<typename spectrum<S>::scalar, float>, float, double>;

/// The most numbers that a spectrum of run-time size had, on this thread.
inline thread_local std::size_t longest_spectrum = 0;

template <std::size_t N, class S>
std::array<double, N> as_values(const S& s) {
    std::array<double, N> out;
    if constexpr (has_iterators<S> && !has_size<S>)
        longest_spectrum = (std::max)(longest_spectrum, static_cast<std::size_t>(s.end() - s.begin()));
    for (std::size_t i = 0; i < N; ++i) out[i] = spectrum<S>::get(s, spectrum<S>::size == 1 ? 0 : i);
    return out;
}

}  // namespace lobe::testkit::detail
