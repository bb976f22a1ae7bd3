// The number that records what is done to it, and its masks.
#pragma once

#include <lobe/core/scalar.hpp>
#include <lobe/shader/tape.hpp>

#include <cmath>
#include <stdexcept>
#include <string>
#include <type_traits>

namespace lobe::shader {

class mask;

/// A `lobe::scalar` of 32 bits, either a constant or a node of a tape. Constants fold where IEEE arithmetic leaves no
/// choice, so no bit changes: + - * / sqrt, comparisons; exp, log and the like by the C library's function, as a float
/// would. Of what is left, x*1, x/1, x - 0, x*-1, -(-x), x/2^k and the choice between equal things become simpler.
class real {
public:
    using value_type = float;  // lobe takes its constants from it: horizon, pi, the polynomials of sincos_2pi

    constexpr real() = default;
    template <class N>
        requires std::is_arithmetic_v<N>
    constexpr explicit real(N x) : at(nullptr), value(static_cast<float>(x)) {}
    constexpr explicit real(const node* recorded)
        : at(recorded->what == op::number ? nullptr : recorded), value(at ? 0.0f : value_of(recorded)) {}

    // clang-format off
    explicit operator int() const = delete;  // "scalar types only": an index cannot be recorded, take a table, a fit
    // clang-format on

    constexpr bool constant() const { return !at; }
    constexpr float number() const { return value; }
    constexpr const node* recorded() const { return at; }
    const node* node_of(tape& owner) const { return at ? at : owner.number(value); }

    friend constexpr real operator-(const real& a) {
        if (a.constant()) return real(-a.value);
        if (a.at->what == op::neg) return real(a.at->arguments[0]);
        return record(op::neg, a);
    }
    friend constexpr real operator+(const real& a, const real& b) {
        return both_constant(a, b) ? real(a.value + b.value) : record(op::add, a, b);
    }
    friend constexpr real operator-(const real& a, const real& b) {
        if (both_constant(a, b)) return real(a.value - b.value);
        return b.is(0.0f) ? a : record(op::sub, a, b);
    }
    friend constexpr real operator*(const real& a, const real& b) {
        if (both_constant(a, b)) return real(a.value * b.value);
        if (b.is(1.0f)) return a;
        if (a.is(1.0f)) return b;
        if (b.is(-1.0f)) return -a;
        if (a.is(-1.0f)) return -b;
        return record(op::mul, a, b);
    }
    friend constexpr real operator/(const real& a, const real& b) {
        if (both_constant(a, b)) return real(a.value / b.value);
        if (b.is(1.0f)) return a;
        return b.power_of_two() ? a * real(1.0f / b.value) : record(op::div, a, b);
    }
    constexpr real& operator+=(const real& b) { return *this = *this + b; }
    constexpr real& operator-=(const real& b) { return *this = *this - b; }
    constexpr real& operator*=(const real& b) { return *this = *this * b; }
    constexpr real& operator/=(const real& b) { return *this = *this / b; }

    friend constexpr mask operator<(const real& a, const real& b);
    friend constexpr mask operator>(const real& a, const real& b);
    friend constexpr mask operator<=(const real& a, const real& b);
    friend constexpr mask operator>=(const real& a, const real& b);
    friend constexpr mask operator==(const real& a, const real& b);
    friend constexpr real select(const mask& m, const real& a, const real& b);

    friend constexpr real abs(const real& x) {
        return of(op::abs, x, [](float f) { return std::abs(f); });
    }
    friend constexpr real sqrt(const real& x) {
        return of(op::sqrt, x, [](float f) { return std::sqrt(f); });
    }
    friend constexpr real exp(const real& x) {
        return of(op::exp, x, [](float f) { return std::exp(f); });
    }
    friend constexpr real exp2(const real& x) {
        return of(op::exp2, x, [](float f) { return std::exp2(f); });
    }
    friend constexpr real expm1(const real& x) {
        return of(op::expm1, x, [](float f) { return std::expm1(f); });
    }
    friend constexpr real log(const real& x) {
        return of(op::log, x, [](float f) { return std::log(f); });
    }
    friend constexpr real log2(const real& x) {
        return of(op::log2, x, [](float f) { return std::log2(f); });
    }
    friend constexpr real log1p(const real& x) {
        return of(op::log1p, x, [](float f) { return std::log1p(f); });
    }
    friend constexpr real sin(const real& x) {
        return of(op::sin, x, [](float f) { return std::sin(f); });
    }
    friend constexpr real cos(const real& x) {
        return of(op::cos, x, [](float f) { return std::cos(f); });
    }
    friend constexpr real tanh(const real& x) {
        return of(op::tanh, x, [](float f) { return std::tanh(f); });
    }
    friend constexpr real acos(const real& x) {
        return of(op::acos, x, [](float f) { return std::acos(f); });
    }
    friend constexpr real erfc(const real& x) {
        return of(op::erfc, x, [](float f) { return std::erfc(f); });
    }
    friend constexpr real floor(const real& x) {
        return of(op::floor, x, [](float f) { return std::floor(f); });
    }
    friend real pow(const real& a, const real& b) {
        using std::pow;
        return both_constant(a, b) ? real(pow(a.value, b.value)) : record(op::pow, a, b);
    }
    friend constexpr real atan2(const real& a, const real& b) {
        return both_constant(a, b) ? real(std::atan2(a.value, b.value)) : record(op::atan2, a, b);
    }
    /// No shading language has it: of a constant alone.
    friend constexpr real tgamma(const real& x) {
        if (!x.constant())
            throw std::invalid_argument(
                "no shading language has the gamma function: record with a number there, not a parameter");
        return real(std::tgamma(x.value));
    }

private:
    constexpr bool is(float x) const {
        return constant() && std::bit_cast<std::uint32_t>(value) == std::bit_cast<std::uint32_t>(x);
    }
    constexpr bool power_of_two() const {
        return constant() && value != 0 && (std::bit_cast<std::uint32_t>(value) & 0x7fffffu) == 0 &&
               value >= 0x1p-100f && value <= 0x1p100f;
    }
    static constexpr bool both_constant(const real& a, const real& b) { return a.constant() && b.constant(); }

    static real record(op what, const real& a) { return real(a.at->owner->record(what, {a.at})); }
    static real record(op what, const real& a, const real& b) { return real(recorded(what, a, b)); }
    static const node* recorded(op what, const real& a, const real& b) {
        tape& owner = *(a.at ? a : b).at->owner;
        return owner.record(what, {a.node_of(owner), b.node_of(owner)});
    }
    template <class F>
    static constexpr real of(op what, const real& x, const F& f) {
        return x.constant() ? real(f(x.value)) : record(what, x);
    }
    template <class F>
    static constexpr mask compared(op what, const real& a, const real& b, const F& f);

    const node* at;  // not initialised here: GLM's unions want a trivial constructor
    float value;
};

/// What a comparison of `real` gives: known, or a node.
class mask {
public:
    constexpr mask() = default;
    constexpr explicit mask(bool known) : value(known) {}
    constexpr explicit mask(const node* recorded) : at(recorded) {}

    constexpr bool constant() const { return !at; }
    constexpr bool known() const { return value; }
    constexpr const node* recorded() const { return at; }

    // clang-format off
    explicit operator bool() const = delete;  // "scalar types only": a branch cannot be recorded, take a table or a fit
    // clang-format on

    friend constexpr mask operator!(const mask& a) {
        return a.constant() ? mask(!a.value) : mask(a.at->owner->record(op::no, {a.at}));
    }
    friend constexpr mask operator&&(const mask& a, const mask& b) {
        if (a.constant()) return a.value ? b : a;
        if (b.constant()) return b.value ? a : b;
        return a.at == b.at ? a : mask(a.at->owner->record(op::both, {a.at, b.at}));
    }
    friend constexpr mask operator||(const mask& a, const mask& b) {
        if (a.constant()) return a.value ? a : b;
        if (b.constant()) return b.value ? b : a;
        return a.at == b.at ? a : mask(a.at->owner->record(op::either, {a.at, b.at}));
    }

    /// For preconditions: those of constants are checked, those of what is not known yet are the caller's.
    friend constexpr bool all(const mask& a) { return a.at || a.value; }

private:
    const node* at = nullptr;
    bool value = false;
};

template <class F>
constexpr mask real::compared(op what, const real& a, const real& b, const F& f) {
    return both_constant(a, b) ? mask(bool(f(a.value, b.value))) : mask(recorded(what, a, b));
}
constexpr mask operator<(const real& a, const real& b) {
    if (!a.constant() && a.recorded()->what == op::abs && b.constant() && b.number() <= 0) return mask(false);
    return real::compared(op::less, a, b, [](float x, float y) { return x < y; });
}
constexpr mask operator>(const real& a, const real& b) {
    return real::compared(op::greater, a, b, [](float x, float y) { return x > y; });
}
constexpr mask operator<=(const real& a, const real& b) {
    return real::compared(op::less_equal, a, b, [](float x, float y) { return x <= y; });
}
constexpr mask operator>=(const real& a, const real& b) {
    return real::compared(op::greater_equal, a, b, [](float x, float y) { return x >= y; });
}
constexpr mask operator==(const real& a, const real& b) {
    return real::compared(op::equal, a, b, [](float x, float y) { return lobe::equal(x, y); });
}

namespace detail {

/// What x is where `m` holds: the first of a choice on the same mask, also of a choice that is divided by. (`quotient`
/// keeps CPUs from dividing by zero where the quotient is not taken. No GPU traps.)
inline const node* where(const node* m, const node* x) {
    if (x->what == op::select && x->arguments[0] == m) return x->arguments[1];
    if (x->what == op::div) {
        const node* by = x->arguments[1];
        if (by->what == op::select && by->arguments[0] == m)
            return (real(x->arguments[0]) / real(by->arguments[1])).node_of(*x->owner);
    }
    return x;
}

}  // namespace detail

/// `a < b ? b : a` and `b < a ? b : a` are `max` and `min`, as GLSL defines them.
constexpr real select(const mask& m, const real& a, const real& b) {
    if (m.constant()) return m.known() ? a : b;
    const node* which = m.recorded();
    tape& owner = *which->owner;
    const node* first = detail::where(which, a.node_of(owner));
    const node* second = b.node_of(owner);
    if (second->what == op::select && second->arguments[0] == which) second = second->arguments[2];
    if (first == second) return a;
    if (which->what == op::less) {
        const auto& [x, y, none] = which->arguments;
        if (first == y && second == x) return real(owner.record(op::max, {x, y}));
        if (first == x && second == y) return real(owner.record(op::min, {y, x}));
    }
    return real(owner.record(op::select, {which, first, second}));
}

/// The author's name for an intermediate value: `const auto a = named("alpha", r * r);`. It names the variable of the
/// printed function.
inline real named(const char* name, const real& x) {
    if (!x.constant()) x.recorded()->owner->name(x.recorded(), name);
    return x;
}

}  // namespace lobe::shader
