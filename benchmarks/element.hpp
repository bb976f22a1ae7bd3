// One element of the inputs, in float for the kernels and in long double for what they are measured against.
#pragma once

#include "inputs.hpp"

#include <lobe/ndf/abc.hpp>
#include <lobe/ndf/exponential_power.hpp>
#include <lobe/ndf/gtr.hpp>
#include <lobe/ndf/phong.hpp>
#include <lobe/ndf/sgd.hpp>

/// A shape without the table of its area: each area is an integral.
template <class Shape>
struct by_quadrature : Shape {
    explicit by_quadrature(const Shape& shape) : Shape(shape) {}

    template <class T>
    T back(const T& cotangent) const {
        return lobe::detail::back_by_quadrature(static_cast<const Shape&>(*this), cotangent).value;
    }
};

/// What one builds once and not per element: distributions with a table, of one width, and the split-sum table.
/// Exactly: the same distributions without their tables.
template <class T>
struct prebuilt {
    template <class Shape>
    using with_area = std::conditional_t<std::same_as<T, float>, lobe::tabulated_shape<Shape, T>, by_quadrature<Shape>>;
    template <class Shape>
    using tabulated = lobe::radial<with_area<Shape>, lobe::alpha<T>>;

    lobe::radial_profile<with_area<lobe::exponential_power_shape<T>>, T> exponential_power;  // of every width
    tabulated<lobe::phong_shape<T>> phong;
    tabulated<lobe::gtr_shape<T>> gtr_1, gtr_3_2;
    tabulated<lobe::abc_shape<T>> abc;
    tabulated<lobe::sgd_shape<T>> sgd;
    lobe::dfg_table<T, lobe::smith_correlated> dfg, dfg_16, dfg_64;

    explicit prebuilt(float width)
        : exponential_power(with_area<lobe::exponential_power_shape<T>>(lobe::exponential_power_shape<T>(T(0.5f)))),
          phong(one_width(lobe::phong_shape<T>(T(width)), width)),
          gtr_1(one_width(lobe::gtr_shape<T>(T(width), T(1)), width)),
          gtr_3_2(one_width(lobe::gtr_shape<T>(T(width), T(1.5f)), width)),
          abc(one_width(lobe::abc_shape<T>(T(width), T(1.5f)), width)),
          sgd(one_width(lobe::sgd_shape<T>(T(width), T(0.5f)), width)),
          dfg(lobe::bake_dfg<T>(lobe::smith_correlated{}, {.size = 32})),
          dfg_16(lobe::bake_dfg<T>(lobe::smith_correlated{}, {.size = 16})),
          dfg_64(lobe::bake_dfg<T>(lobe::smith_correlated{}, {.size = 64})) {}

private:
    template <class Shape>
    static tabulated<Shape> one_width(const Shape& shape, float width) {
        return {with_area<Shape>(shape), lobe::alpha<T>(T(width))};
    }
};

template <class T>
struct element {
    using scalar = T;
    using vec2 = lobe::vec2<T>;
    using vec3 = lobe::vec3<T>;

    const inputs& in;
    std::size_t i;

    T at(const stream<float>& s) const { return T(s[i]); }
    vec3 at(const stream<float>& x, const stream<float>& y, const stream<float>& z) const {
        return {at(x), at(y), at(z)};
    }
    vec3 at(const parameters::rgb& s) const { return at(s[0], s[1], s[2]); }

    vec3 v() const { return at(in.vx, in.vy, in.vz); }
    vec3 l() const { return at(in.lx, in.ly, in.lz); }
    vec3 m() const { return at(in.mx, in.my, in.mz); }
    vec3 anisotropic_m() const { return at(in.nx, in.ny, in.nz); }
    vec2 u() const { return {at(in.u1), at(in.u2)}; }
    vec3 F0() const { return at(in.r, in.g, in.b); }
    T v_m() const { return at(in.v_m); }
    T a() const { return at(in.a); }
    T turn() const { return at(in.turn); }
    std::uint32_t index() const { return in.index[i]; }
    T fraction() const { return at(in.more.fraction); }
    lobe::alpha<T> alpha() const { return lobe::alpha<T>(a()); }
    lobe::alpha_xy<T> alpha_xy() const { return {at(in.ax), at(in.ay)}; }

    const prebuilt<T>& built() const {
        if constexpr (std::same_as<T, float>)
            return *in.built;
        else
            return *in.built_exactly;
    }
};
