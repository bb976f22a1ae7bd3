// Derivatives for inverse rendering: a dual of any scalar type is a lobe::scalar, so a dual of the number that records
// gives the shader of df/dalpha and df/dF0. Nothing of lobe/shader knows of it.
#pragma once

#include <lobe/lobe.hpp>

#include <cmath>
#include <concepts>
#include <limits>

namespace shader_tests {

/// x and dx/dp; (a b)' = a' b + a b', and so on. Comparisons are of the values.
template <class T>
struct dual {
    using value_type = float;
    T value, slope;

    dual() = default;
    template <class N>
        requires std::is_arithmetic_v<N>
    explicit dual(N x) : value(static_cast<T>(x)), slope(T(0)) {}
    dual(const T& x, const T& dx) : value(x), slope(dx) {}

    friend dual operator-(const dual& a) { return {-a.value, -a.slope}; }
    friend dual operator+(const dual& a, const dual& b) { return {a.value + b.value, a.slope + b.slope}; }
    friend dual operator-(const dual& a, const dual& b) { return {a.value - b.value, a.slope - b.slope}; }
    friend dual operator*(const dual& a, const dual& b) {
        return {a.value * b.value, a.slope * b.value + a.value * b.slope};
    }
    friend dual operator/(const dual& a, const dual& b) {
        const T q = a.value / b.value;
        return {q, (a.slope - q * b.slope) / b.value};
    }
    dual& operator+=(const dual& b) { return *this = *this + b; }
    dual& operator-=(const dual& b) { return *this = *this - b; }
    dual& operator*=(const dual& b) { return *this = *this * b; }
    dual& operator/=(const dual& b) { return *this = *this / b; }

    friend auto operator<(const dual& a, const dual& b) { return a.value < b.value; }
    friend auto operator>(const dual& a, const dual& b) { return a.value > b.value; }
    friend auto operator<=(const dual& a, const dual& b) { return a.value <= b.value; }
    friend auto operator>=(const dual& a, const dual& b) { return a.value >= b.value; }
    friend auto operator==(const dual& a, const dual& b) { return lobe::equal(a.value, b.value); }

    friend dual sqrt(const dual& x) {
        using std::sqrt;
        const T root = sqrt(x.value);
        return {root, x.slope / (T(2) * root)};
    }
    friend dual abs(const dual& x) {
        using lobe::select;
        return select(x.value < T(0), -x, x);
    }
    template <class Mask>
        requires(!std::same_as<Mask, bool>)  // lobe has that
    friend dual select(const Mask& m, const dual& a, const dual& b) {
        using lobe::select;
        return {select(m, a.value, b.value), select(m, a.slope, b.slope)};
    }
};

/// f cos of GGX, correlated Smith, Schlick, and what it changes by with alpha, with F0.
template <class T>
lobe::vec3<T> value_and_slopes(const lobe::vec3<T>& v, const lobe::vec3<T>& l, const T& width, const T& F0) {
    using D = dual<T>;
    const auto f_cos = [&](const D& a, const D& F) {
        const auto wide = [](const lobe::vec3<T>& w) {
            return lobe::vec3<D>(D(w.x, T(0)), D(w.y, T(0)), D(w.z, T(0)));
        };
        return lobe::microfacet{lobe::ggx{lobe::alpha<D>(a)}, lobe::smith_correlated{}, lobe::schlick{F}}.f_cos(
            wide(v), wide(l));
    };
    const D by_alpha = f_cos({width, T(1)}, {F0, T(0)}), by_F0 = f_cos({width, T(0)}, {F0, T(1)});
    return {by_alpha.value, by_alpha.slope, by_F0.slope};
}

}  // namespace shader_tests
