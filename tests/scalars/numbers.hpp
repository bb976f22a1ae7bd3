// Two numbers of the tests' own: an archetype with no more than formulas may use, and a number with its derivative.
#pragma once

#include <cmath>

namespace scalars {

/// What `lobe::scalar` asks for, the rest of an order, the functions that formulas find by ADL, and what GLM's vectors
/// are written with. Nothing converts to it or from it silently; what uses another operation does not compile.
class archetype {
public:
    constexpr archetype() = default;  // GLM's vectors have a default constructor
    constexpr explicit archetype(double x) : value(x) {}
    constexpr explicit operator double() const { return value; }  // for the tests: nothing in lobe calls it

    friend constexpr archetype operator-(const archetype& a) { return archetype(-a.value); }
    friend constexpr archetype operator+(const archetype& a, const archetype& b) {
        return archetype(a.value + b.value);
    }
    friend constexpr archetype operator-(const archetype& a, const archetype& b) {
        return archetype(a.value - b.value);
    }
    friend constexpr archetype operator*(const archetype& a, const archetype& b) {
        return archetype(a.value * b.value);
    }
    friend constexpr archetype operator/(const archetype& a, const archetype& b) {
        return archetype(a.value / b.value);
    }
    constexpr archetype& operator+=(const archetype& b) { return *this = *this + b; }
    constexpr archetype& operator-=(const archetype& b) { return *this = *this - b; }
    constexpr archetype& operator*=(const archetype& b) { return *this = *this * b; }
    constexpr archetype& operator/=(const archetype& b) { return *this = *this / b; }
    friend constexpr bool operator<(const archetype& a, const archetype& b) { return a.value < b.value; }
    friend constexpr bool operator>(const archetype& a, const archetype& b) { return a.value > b.value; }
    // the rest of an order: `in_unit_interval`, which asserts call, is written with it
    friend constexpr bool operator<=(const archetype& a, const archetype& b) { return a.value <= b.value; }
    friend constexpr bool operator>=(const archetype& a, const archetype& b) { return a.value >= b.value; }

    friend archetype sqrt(const archetype& a) { return archetype(std::sqrt(a.value)); }
    friend archetype sin(const archetype& a) { return archetype(std::sin(a.value)); }
    friend archetype cos(const archetype& a) { return archetype(std::cos(a.value)); }
    friend archetype exp(const archetype& a) { return archetype(std::exp(a.value)); }
    friend archetype log1p(const archetype& a) { return archetype(std::log1p(a.value)); }
    friend archetype erfc(const archetype& a) { return archetype(std::erfc(a.value)); }

private:
    double value = 0;
};

/// A number and its derivative.
struct dual {
    double value = 0, slope = 0;
    dual() = default;
    explicit dual(double x, double dx = 0) : value(x), slope(dx) {}
    explicit operator double() const { return value; }
    friend dual operator-(dual a) { return dual(-a.value, -a.slope); }
    friend dual operator+(dual a, dual b) { return dual(a.value + b.value, a.slope + b.slope); }
    friend dual operator-(dual a, dual b) { return dual(a.value - b.value, a.slope - b.slope); }
    friend dual operator*(dual a, dual b) { return dual(a.value * b.value, a.slope * b.value + a.value * b.slope); }
    friend dual operator/(dual a, dual b) {
        return dual(a.value / b.value, (a.slope - a.value / b.value * b.slope) / b.value);
    }
    dual& operator+=(dual b) { return *this = *this + b; }
    dual& operator-=(dual b) { return *this = *this - b; }
    dual& operator*=(dual b) { return *this = *this * b; }
    dual& operator/=(dual b) { return *this = *this / b; }
    friend bool operator<(dual a, dual b) { return a.value < b.value; }
    friend bool operator>(dual a, dual b) { return a.value > b.value; }
    friend bool operator<=(dual a, dual b) { return a.value <= b.value; }
    friend bool operator>=(dual a, dual b) { return a.value >= b.value; }
    friend dual sqrt(dual a) {
        const double r = std::sqrt(a.value);
        return dual(r, a.slope / (2 * r));
    }
    friend dual sin(dual a) { return dual(std::sin(a.value), a.slope * std::cos(a.value)); }
    friend dual cos(dual a) { return dual(std::cos(a.value), -a.slope * std::sin(a.value)); }
    friend dual exp(dual a) { return dual(std::exp(a.value), a.slope * std::exp(a.value)); }
    friend dual log1p(dual a) { return dual(std::log1p(a.value), a.slope / (1 + a.value)); }
    friend dual erfc(dual a) {
        const double root_pi = 1.772453850905516;
        return dual(std::erfc(a.value), -2 / root_pi * std::exp(-a.value * a.value) * a.slope);
    }
};

}  // namespace scalars
