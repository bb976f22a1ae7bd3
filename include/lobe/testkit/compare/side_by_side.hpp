// Two functions of the same place, in one type: the coarser of theirs.
#pragma once

#include <lobe/testkit/measure/rounding.hpp>

#include <array>
#include <functional>
#include <type_traits>

namespace lobe::testkit::detail {

/// The type in which both can be asked: every float is a double.
template <class A, class B>
using coarser = std::conditional_t<std::is_same_v<A, float> || std::is_same_v<B, float>, float, double>;

template <class T, std::size_t N>
struct side_by_side {
    using values = std::array<double, N>;
    using function = std::function<values(const place<T>& at)>;
    function a, b;
    bool a_is_finer = false, b_is_finer = false;  // it computes in double, and T is float

    /// How far the values may be apart by rounding. One that computes in double moves by what rounding of the input
    /// does, which is all that the other one is forgiven: whatever more it loses is its own cancellation.
    double noise(const place<T>& at, std::size_t k) const {
        return a_is_finer ? of(a, at, k) : b_is_finer ? of(b, at, k) : of(a, at, k) + of(b, at, k);
    }
    /// What the coarser of the two loses by itself, where they are not alike.
    double noise_of_coarser(const place<T>& at, std::size_t k) const {
        return a_is_finer ? of(b, at, k) : b_is_finer ? of(a, at, k) : 0;
    }

private:
    static double of(const function& f, const place<T>& at, std::size_t k) {
        const auto value = [&](const vec3<T>& v, const vec3<T>& l) {
            place<T> moved = at;
            moved.v = v, moved.l = l;
            return f(moved)[k];
        };
        return rounding_noise<T>(value, at);
    }
};

}  // namespace lobe::testkit::detail
