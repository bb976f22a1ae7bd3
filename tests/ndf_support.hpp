// What the tests of distributions share: one list of all of them, and integrals over normals that know nothing of their
// code.
#pragma once

#include "support.hpp"

#include <lobe/energy/quadrature.hpp>
#include <lobe/ndf/abc.hpp>
#include <lobe/ndf/beckmann.hpp>
#include <lobe/ndf/blinn_phong.hpp>
#include <lobe/ndf/exponential_power.hpp>
#include <lobe/ndf/ggx.hpp>
#include <lobe/ndf/gtr.hpp>
#include <lobe/ndf/masked_by.hpp>
#include <lobe/ndf/mixture.hpp>
#include <lobe/ndf/phong.hpp>
#include <lobe/ndf/sgd.hpp>
#include <lobe/ndf/sggx.hpp>
#include <lobe/ndf/student_t.hpp>

constexpr double half_pi = 1.5707963267948966;

/// The stated error of a projected area: of closed forms, absolute; of tables, in units of the area seen along the
/// horizon; of exponential power's, which falls abruptly for large p; of Phong's, whose slopes end abruptly.
constexpr double closed_error = 1e-8, table_error = 3e-6, exponential_power_table_error = 4e-6,
                 phong_table_error = 3e-5;

template <class N>
double allowed_area_error(const N& ndf, double stated) {
    const double x = ndf.projected_area({1, 0, 0}), y = ndf.projected_area({0, 1, 0});
    return stated == closed_error ? closed_error : stated * std::max(x, y);
}

/// visit(name, distribution, stated error of its projected area) for every distribution of width a.
template <class Visit>
void every_isotropic(double a, const Visit& visit) {
    const lobe::alpha<double> width{a};
    const auto name = [](const char* of, double shape) { return std::string(of) + ' ' + std::to_string(shape); };
    visit("ggx", lobe::ggx{width}, closed_error);
    visit("beckmann", lobe::beckmann{width}, closed_error);
    for (double g : {1.6, 1.75, 2.0, 3.0, 10.0, 40.0})
        visit(name("student_t", g), lobe::student_t{width, g}, closed_error);
    for (double g : {1.75, 3.0, 8.0}) visit(name("hyper_cauchy", g), lobe::hyper_cauchy{width, g}, closed_error);
    for (double p : {0.25, 0.5, 1.0, 2.0, 4.0})
        visit(name("exponential_power", p), lobe::tabulated{lobe::exponential_power{width, p}},
              exponential_power_table_error);
    visit("blinn_phong", lobe::blinn_phong{width}, closed_error);
    for (double g : {0.5, 1.0, 1.5, 2.0, 3.0, 5.0})
        visit(name("gtr", g), lobe::tabulated{lobe::gtr{width, g}}, table_error);
    for (double c : {0.5, 1.0, 2.0, 3.0, 10.0})
        visit(name("abc", c), lobe::tabulated{lobe::abc{width, c}}, table_error);
    for (double p : {0.0, 0.5, 1.0, 2.0, 4.0}) visit(name("sgd", p), lobe::tabulated{lobe::sgd{width, p}}, table_error);
    visit("phong", lobe::tabulated{lobe::phong{width}}, phong_table_error);
    visit("mixture", lobe::mixture{lobe::ggx{width}, lobe::beckmann{lobe::alpha{a / 2}}, 0.3}, closed_error);
}

/// ... and every one that has two widths.
template <class Visit>
void every_anisotropic(double ax, double ay, const Visit& visit) {
    const lobe::alpha_xy<double> width{ax, ay};
    visit("ggx", lobe::ggx{width}, closed_error);
    visit("beckmann", lobe::beckmann{width}, closed_error);
    for (double g : {1.75, 3.0}) visit("student_t", lobe::student_t{width, g}, closed_error);
    visit("hyper_cauchy", lobe::hyper_cauchy{width, 2.5}, closed_error);
    for (double p : {0.5, 2.0})
        visit("exponential_power", lobe::tabulated{lobe::exponential_power{width, p}}, exponential_power_table_error);
    visit("mixture", lobe::mixture{lobe::beckmann{width}, lobe::ggx{lobe::alpha_xy{ay, ax}}, 0.3}, closed_error);
}

/// The area of the facets that face away from w, per unit of macrosurface: int max(0, -w.m) D(m) dm, by its definition.
/// Slopes r (wx cos phi, wy sin phi) with w.m = 0 at one r for each phi, from which on the facets face away (w.z > 0):
/// from there the trapezoid rule after r = r0 + exp((pi/2) sinh t), out to r = 1e48; the azimuths crowd towards those
/// where r0 turns infinite.
template <class N>
double area_facing_away(const N& ndf, double wx, double wy, const lobe::vec3<double>& w) {
    const lobe::gauss_legendre<double> rule(40);
    const double px = wx * w.x, py = wy * w.y, p = std::hypot(px, py);
    constexpr int steps = 400;
    double total = 0;
    for (int half = 0; half < 2; ++half)
        for (std::size_t k = 0; k < rule.x.size(); ++k) {
            const double x = rule.x[k], delta = half_pi * x * x * x, d_phi = rule.w[k] * 3 * half_pi * x * x;
            const double along = -std::sin(delta), across = half ? -std::cos(delta) : std::cos(delta);
            const double dx = wx * (along * px - across * py) / p, dy = wy * (along * py + across * px) / p;
            const double slope = -(dx * w.x + dy * w.y), low = w.z / slope;
            for (int i = 0; i < steps; ++i) {
                const double h = 8.5 / steps, t = -3.5 + (i + 0.5) * h, e = std::exp(half_pi * std::sinh(t)),
                             r = low + e;
                const double z = 1 / std::sqrt(1 + r * r * (dx * dx + dy * dy));
                const double dm = wx * wy * r * z * z * z * half_pi * std::cosh(t) * h * e * d_phi;
                total += e * slope * z * ndf.D({r * dx * z, r * dy * z, z}) * dm;  // -w.m = (r - low) slope z
            }
        }
    return total;
}

/// |d map / d u|, the area that a map from the square to directions gives to a unit of it, by Richardson-extrapolated
/// central differences.
/// Error:
/// (4e-4/distance)^6 to whatever is not smooth, as the edges of the square are.
template <class Map>
double jacobian(const Map& map, const lobe::vec2<double>& u) {
    const auto derivative = [&](const lobe::vec2<double>& step) {
        const auto central = [&](double h) { return (map(u + h * step) - map(u - h * step)) / (2 * h); };
        const auto twice = [&](double h) { return (4.0 * central(h / 2) - central(h)) / 3.0; };
        return (16.0 * twice(2e-4) - twice(4e-4)) / 15.0;
    };
    return lobe::length(lobe::cross(derivative({1, 0}), derivative({0, 1})));
}
