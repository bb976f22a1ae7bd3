// Counts what is never right in the values of a function: not finite, negative, or positive below the horizon; keeps
// the first, or worst.
#pragma once

#include <lobe/testkit/measure/rounding.hpp>

#include <cmath>
#include <limits>

namespace lobe::testkit::detail {

template <class T>
struct watch {
    struct fault {
        long count = 0;
        double value = 0;
        place<T> at{};
    };
    static constexpr double rounding = 1e-6;  // what float leaves of a difference of numbers near 1

    long calls = 0;
    fault not_finite{}, negative{}, below{};

    /// The value itself where it is a number, else 0. `again(v, l)` asks for it elsewhere: a sign that rounding decides
    /// is no fault.
    template <class Again>
    double see(double x, const place<T>& at, bool must_vanish, const Again& again) {
        const bool by_rounding =
            x < -rounding && negative.count < 100 && std::isfinite(x) && -x <= 4 * rounding_noise<T>(again, at);
        return by_rounding ? 0 : see(x, at, must_vanish);
    }
    double see(double x, const place<T>& at, bool must_vanish) {
        if (!std::isfinite(x)) {
            if (!not_finite.count++) not_finite.value = x, not_finite.at = at;
            return 0;
        }
        if (x < -rounding) {
            ++negative.count;
            if (x < negative.value) negative.value = x, negative.at = at;
        }
        if (must_vanish && !same(x, 0)) {
            ++below.count;
            if (std::abs(x) > std::abs(below.value)) below.value = x, below.at = at;
        }
        return x;
    }
};

/// How far the lengths of directions are from 1: the worst.
template <class T>
struct length_watch {
    static constexpr double tolerance = 64 * static_cast<double>(std::numeric_limits<T>::epsilon());
    double worst = 1;
    place<T> at{};

    double see(const vec3<T>& w, const place<T>& where) {
        const double length = std::hypot(static_cast<double>(w.x), static_cast<double>(w.y), static_cast<double>(w.z));
        if (!(std::abs(length - 1) <= std::abs(worst - 1))) worst = length, at = where;
        return length;
    }
    bool holds() const { return std::abs(worst - 1) <= tolerance; }
};

}  // namespace lobe::testkit::detail
