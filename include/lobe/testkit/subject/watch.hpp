// Counts what is never right in the values of a function: not finite, negative, or positive below the horizon; keeps
// the most harmful one.
#pragma once

#include <lobe/testkit/measure/numbers.hpp>
#include <lobe/testkit/measure/rounding.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace lobe::testkit::detail {

template <class T>
bool all_finite(const vec3<T>& w) {
    return is_finite(static_cast<double>(w.x)) && is_finite(static_cast<double>(w.y)) &&
           is_finite(static_cast<double>(w.z));
}

template <class T>
struct watch {
    struct fault {
        long count = 0;  // of calls
        double value = 0;
        place<T> at{};
        int harm = -1;
        long call = 0;

        /// Where it does more harm; there, the larger `size`.
        void add(double x, const place<T>& where, long of_call, double size = 0) {
            if (call != of_call) ++count;
            call = of_call;
            const int here = harm_at(where);
            if (here > harm || (here == harm && size > std::abs(value))) value = x, at = where, harm = here;
        }
    };
    /// 3: an everyday input; 2: grazing; 1: an extreme that an image may still contain; 0: below the horizon.
    static int harm_at(const place<T>& at) {
        double lowest = 1, edge = 1;
        bool denormal = false;
        for (const auto& [has, w] : {std::pair(at.has_v, at.v), {at.has_l, at.l}}) {
            if (!has) continue;
            lowest = (std::min)(lowest, static_cast<double>(at.both_sides ? std::abs(w.z) : w.z));
            for (const T x : {w.x, w.y, w.z})
                denormal |= std::abs(x) > T(0) && std::abs(x) < (std::numeric_limits<T>::min)();
        }
        for (int i = 0; i < at.numbers; ++i)
            edge = (std::min)({edge, static_cast<double>(at.u[i]), 1 - static_cast<double>(at.u[i])});
        if (!(lowest > 0)) return 0;
        if (denormal || lowest < 1e-4 || edge < 1e-6) return 1;
        return lowest < 0.02 ? 2 : 3;
    }
    static constexpr double rounding = 1e-6;  // what float leaves of a difference of numbers near 1

    long calls = 0;
    fault not_finite{}, negative{}, below{};

    /// The value itself where it is a number, else 0. `again(v, l)` asks for it elsewhere: a sign that rounding decides
    /// is no fault.
    template <class Again>
    double see(double x, const place<T>& at, bool must_vanish, const Again& again) {
        const bool by_rounding =
            x < -rounding && negative.count < 100 && is_finite(x) && -x <= 4 * rounding_noise<T>(again, at);
        return by_rounding ? 0 : see(x, at, must_vanish);
    }
    double see(double x, const place<T>& at, bool must_vanish) {
        if (!is_finite(x)) {
            not_finite.add(x, at, calls);
            return 0;
        }
        if (x < -rounding) {
            negative.add(x, at, calls, -x);
        }
        if (must_vanish && !same(x, 0)) {
            below.add(x, at, calls, std::abs(x));
        }
        return computable(x);
    }
};

/// How far the lengths of directions are from 1: the worst.
template <class T>
struct length_watch {
    static constexpr double tolerance = 64 * static_cast<double>(std::numeric_limits<T>::epsilon());
    double worst = 1;
    place<T> at{};

    void see(const vec3<T>& w, const place<T>& where) {
        if (!is_finite(worst)) return;
        const double length = std::hypot(static_cast<double>(w.x), static_cast<double>(w.y), static_cast<double>(w.z));
        if (!is_finite(length) || std::abs(length - 1) > std::abs(worst - 1)) worst = length, at = where;
    }
    bool holds() const { return is_finite(worst) && std::abs(worst - 1) <= tolerance; }
};

}  // namespace lobe::testkit::detail
