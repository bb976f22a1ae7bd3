// Distributions given by one function of the angle from the normal: the rest of their profile is written here, once.
#pragma once

#include <lobe/ndf/stretched.hpp>
#include <lobe/numeric/integrals.hpp>
#include <lobe/numeric/roots.hpp>

#include <cassert>

namespace lobe {

/// What is particular to a distribution of width 1 whose density depends on tau = tan(theta)^2 alone. With f(tau) the
/// density of its slopes, pi int f(tau) dtau = 1:
/// - `D(tau, sec2)` = f(tau) sec2^2, finite where its arguments are: D in 1/sr, sec2 = 1 + tau at width 1;
/// - `survival(tau)` = pi int_tau^inf f: the share of the macrosurface whose facets are steeper;
/// - `tan2(u)`: the tau at which survival is 1 - u;
/// - `as<U>()`: the same in another scalar type, double where T is float.
/// (Of packs it need not have more than D.) A shape whose slopes are bounded, or might as well be, says `max_tan2()`.
/// One that can draw visible normals itself has `sample_visible(v, u)`.
template <class S, class T>
concept radial_shape = requires(const S shape, const T x) {
    { shape.D(x, x) } -> std::same_as<T>;
    { shape.survival(x) } -> std::same_as<T>;
    { shape.tan2(x) } -> std::same_as<T>;
    shape.template as<detail::at_least_double<T>>().survival(detail::at_least_double<T>(1));
};

/// ... whose projected area is known:
/// - `back(a)`: the area of back faces seen at the cotangent a >= 0, over the sine: int_a^inf (x - a) P(x) dx, P the
///   distribution of slopes along one axis. Smith's Lambda is back(a)/a, or `lambda(a)` where that says it better.
/// One whose `back` is an approximation says so, `using approximate_area = void`:
/// visible normals then have no exact density.
template <class S, class T>
concept radial_shape_with_area = requires(const S shape, const T x) {
    { shape.back(x) } -> std::same_as<T>;
};

namespace detail {

/// f(tau), the density of slopes.
template <class Shape, one_lane T>
constexpr T slope_density(const Shape& shape, const T& tau) {
    return shape.D(tau, T(1));
}

/// int g(R) 2 pi f(a^2 + R^2) R dR over R > from: an average over the facets whose slope r is more than `a`,
/// R^2 = r^2 - a^2.
template <one_lane T, class Shape, class G>
constexpr auto average_over_steep(const Shape& shape, const T& a, const T& from, const G& g) {
    using std::sqrt;
    const auto integrand = [&](const T& R) {
        return g(R) * (T(2) * pi<T>() * slope_density(shape, a * a + R * R) * R);
    };
    if constexpr (requires { shape.max_tan2(); }) {
        const T room = larger(T(shape.max_tan2()) - a * a, from * from);
        return integral_between(from, sqrt(room), integrand);
    } else {
        return integral_to_infinity(larger(larger(a, from), T(1)), [&](const T& x) { return integrand(from + x); });
    }
}

/// back(a) by quadrature, and its slope: (1/pi) int (R - a atan(R/a)) and -(1/pi) int atan(R/a) over
/// the facets steeper than a.
template <one_lane T, class Shape>
constexpr value_and_slope<T> back_by_quadrature(const Shape& shape, const T& a) {
    using std::atan2;
    const vec2<T> both = average_over_steep(shape, a, T(0), [&](const T& R) {
        const T angle = atan2(R, a);
        return vec2<T>{R - a * angle, -angle};
    });
    return {both.x / pi<T>(), both.y / pi<T>()};
}

/// A normal visible from v, by inverse CDF, for any radial shape. In polar slopes (r, phi) around v's azimuth visible
/// normals have the density (z + s r cos phi) f(r^2) r where that is positive, z and s the cosine and sine of v: u.x
/// picks r. Below r = |cot| every azimuth is visible and the CDF is closed; above, the share beyond r is an integral,
/// and Newton's method solves for r. u.y then picks phi between the limits +-phi_max, from Kepler's equation
///   z phi + s r sin phi = (2 u.y - 1) (z phi_max + s r sin phi_max).
/// Unit v, also below the horizon; `back` is the area of back faces over s. Scalar types only; 200 to 500 evaluations
/// of D at grazing angles, none from above.
template <class Shape, one_lane T>
constexpr vec3<T> sample_visible_radial(const Shape& shape, const T& back, const vec3<T>& v, const vec2<T>& u) {
    using std::asinh, std::atan2, std::cos, std::log, std::sin, std::sinh, std::sqrt;
    const T z = v.z, s = sqrt(v.x * v.x + v.y * v.y), cot = s > T(0) ? z / s : T(0), a = larger(cot, -cot);
    const T sigma = larger(z, T(0)) + s * back;
    const T steeper = s > T(0) ? shape.survival(a * a) : T(0), gentle = larger(z, T(0)) * (T(1) - steeper);

    T r(0), phi_max = pi<T>();
    if (u.x * sigma < gentle) {
        r = sqrt(shape.tan2(u.x * sigma / z));
    } else {
        // in x = asinh(R), R^2 = r^2 - cot^2: the integrand is smooth near R = 0, and far away the logarithm of the
        // share is nearly a line
        const auto visible = [&](const T& R) { return (z * atan2(R, -cot) + s * R) / pi<T>(); };
        const auto density = [&](const T& x) {
            const T R = sinh(x);
            return visible(R) * (T(2) * pi<T>() * slope_density(shape, a * a + R * R) * R * sqrt(T(1) + R * R));
        };
        const T wanted = larger((T(1) - u.x) * sigma, (std::numeric_limits<T>::min)());
        T known_x(-1), known_share(0), known_slope(0);
        const auto excess = [&](const T& x) {
            // a few short steps from where the share is known cost less than the whole tail
            const T steps = absolute(x - known_x) * larger(T(1), known_slope) * T(4);
            const T share = known_x >= T(0) && steps < T(9)
                                ? known_share - short_integral(known_x, x, static_cast<int>(steps) + 1, density)
                                : average_over_steep(shape, a, T(sinh(x)), visible);
            if (!(share > T(0))) return value_and_slope<T>{T(1), T(1)};
            known_x = x, known_share = share, known_slope = density(x) / share;
            return value_and_slope<T>{log(wanted / share), known_slope};
        };
        T widest(115);
        if constexpr (requires { shape.max_tan2(); }) widest = asinh(sqrt(larger(T(shape.max_tan2()) - a * a, T(0))));
        const T steep = sigma - gentle, most = T(1) - std::numeric_limits<T>::epsilon();
        const T guess = shape.tan2(smaller(T(1) - steeper * (wanted < steep ? wanted / steep : T(1)), most)) - a * a;
        const T R = sinh(root_of_increasing<T>(T(0), widest, asinh(sqrt(larger(guess, T(0)))), excess));
        r = sqrt(a * a + R * R);
        phi_max = atan2(R, -cot);
    }

    const T range = z * phi_max + s * r * sin(phi_max), wanted = (T(2) * u.y - T(1)) * range;
    const T phi = root_of_increasing<T>(-phi_max, phi_max, (T(2) * u.y - T(1)) * phi_max, [&](const T& p) {
        return value_and_slope<T>{z * p + s * r * sin(p) - wanted, z + s * r * cos(p)};
    });
    const T ex = s > T(0) ? v.x / s : T(1), ey = s > T(0) ? v.y / s : T(0);
    return {r * (cos(phi) * ex - sin(phi) * ey), r * (cos(phi) * ey + sin(phi) * ex), T(1)};
}

/// The same, computed in double at least.
template <class Shape, one_lane T>
constexpr vec3<T> sample_visible_by_quadrature(const Shape& shape, const vec3<T>& v, const vec2<T>& u) {
    using W = at_least_double<T>;
    using std::sqrt;
    const T cotangent =
        smaller(larger(v.z, -v.z) / larger(T(sqrt(v.x * v.x + v.y * v.y)), smallest<T>()), largest<T>());
    const vec3<W> wide = normalize(vec3<W>{W(v.x), W(v.y), W(v.z)});
    const vec3<W> m =
        normalize(sample_visible_radial(shape.template as<W>(), W(shape.back(cotangent)), wide, {W(u.x), W(u.y)}));
    return {T(m.x), T(m.y), T(m.z)};
}

}  // namespace detail

/// The profile of a radial shape: what `stretched` asks for.
template <class Shape, scalar T>
class radial_profile {
public:
    constexpr explicit radial_profile(const Shape& of) : shape_(of) {}
    constexpr const Shape& shape() const { return shape_; }

    /// f(tau)/(ax ay cos^4), tau the squared tangent of the unstretched normal. A cosine of zero is one of 2^-490
    /// (2^-44 in float), so that the horizon gets the limit from above.
    template <class Width>
    constexpr T D(const vec3<T>& m, const Width& width) const {
        const T z = larger(absolute(m.z), larger(absolute(m.x), absolute(m.y)) * detail::zero_cosine<T>());
        const vec3<T> s = width.unstretch(vec3<T>{m.x, m.y, z});
        const auto tan2 = [](const vec3<T>& w, const T& cosine) {
            return (w.x * w.x + w.y * w.y) / larger(cosine * cosine, detail::smallest<T>());
        };
        return shape_.D(smaller(tan2(s, s.z), detail::largest<T>() / T(4)), tan2(m, z) + T(1)) /
               (width.x() * width.y());
    }

    /// max(0, z) + back faces.
    constexpr T projected_area(const vec3<T>& w) const requires radial_shape_with_area<Shape, T> {
        using std::sqrt;
        const T s = sqrt(w.x * w.x + w.y * w.y);
        return larger(w.z, T(0)) + s * shape_.back(cotangent(w.z, s));
    }

    constexpr T lambda(const vec3<T>& w) const requires radial_shape_with_area<Shape, T> {
        using std::sqrt;
        const T a = cotangent(w.z, sqrt(w.x * w.x + w.y * w.y));
        T behind;
        if constexpr (requires { shape_.lambda(a); })
            behind = shape_.lambda(a);
        else
            behind = shape_.back(a) / a;
        return select(w.z < T(0), T(-1) - behind, behind);
    }

    constexpr vec3<T> sample(const vec2<T>& u) const requires(requires(const Shape s) { s.tan2(u.x); }) {
        using std::sqrt;
        const T r = sqrt(shape_.tan2(u.x));
        const auto [s, c] = sincos_2pi(u.y);
        return {r * c, r * s, T(1)};
    }

    constexpr vec3<T> sample_visible(const vec3<T>& w, const vec2<T>& u) const
        requires(detail::one_lane<T>&& radial_shape_with_area<Shape, T> &&
                 !requires { typename Shape::approximate_area; }) {
        const vec3<T> v = normalize(w);
        if constexpr (requires { shape_.sample_visible(v, u); })
            return shape_.sample_visible(v, u);
        else
            return detail::sample_visible_by_quadrature(shape_, v, u);
    }

private:
    static constexpr T cotangent(const T& z, const T& s) {
        return smaller(larger(z, -z) / larger(s, detail::smallest<T>()), detail::largest<T>());
    }

    [[no_unique_address]] Shape shape_;

    static_assert(radial_shape<Shape, T> || (!detail::one_lane<T> && requires(const Shape s, const T x) {
                      { s.D(x, x) } -> std::same_as<T>;
                  }));
};

/// A radial shape and the width that stretches it: a density, and a distribution where the shape has an area.
template <class Shape, class Width>
class radial : public stretched<radial_profile<Shape, typename Width::scalar>, Width> {
    using of_width_1 = radial_profile<Shape, typename Width::scalar>;

public:
    constexpr radial(const Shape& shape, const Width& width) : stretched<of_width_1, Width>(of_width_1(shape), width) {}
};

/// A shape without a closed `back`, and a table of it: cubic Hermite between values and slopes at 97 nodes in
/// w = q/(1 + q), q = sqrt(a/scale), from the horizon (w = 0) to the normal (w = 1), where it holds the limits.
template <class Shape, detail::one_lane T>
class tabulated_shape : public Shape {
    static constexpr int panels = 96;

public:
    constexpr explicit tabulated_shape(const Shape& shape) : Shape(shape), scale(), node() {
        using W = detail::at_least_double<T>;
        using std::sqrt;
        const auto wide = shape.template as<W>();
        const W c = W(2) * detail::back_by_quadrature(wide, W(0)).value;
        scale = T(c);
        for (int i = 0; i < panels; ++i) {
            const W w = W(i) / W(panels), q = w / (W(1) - w), cot = c * q * q;
            const W da = W(2) * c * q / ((W(1) - w) * (W(1) - w)) / W(panels);  // of one panel
            const auto exact = detail::back_by_quadrature(wide, cot);
            node[static_cast<std::size_t>(i)] = {T(exact.value), T(exact.slope * da)};
        }
        node[panels] = {T(0), T(0)};
    }

    constexpr T back(const T& cot) const {
        using std::sqrt;
        const T x = (T(1) - T(1) / (T(1) + sqrt(cot / scale))) * T(panels);
        const int i = x < T(panels) ? static_cast<int>(x) : panels - 1;
        const T t = x - T(i), s = T(1) - t;
        const auto &n0 = node[static_cast<std::size_t>(i)], &n1 = node[static_cast<std::size_t>(i) + 1];
        const T cubic = s * s * ((T(1) + T(2) * t) * n0.value + t * n0.slope) +
                        t * t * ((T(1) + T(2) * s) * n1.value - s * n1.slope);
        return larger(cubic, T(0));  // where the area is far below the error
    }

private:
    T scale;
    std::array<detail::value_and_slope<T>, std::size_t(panels) + 1> node;
};

namespace detail {

template <class Density>
using tabulated_shape_of =
    tabulated_shape<std::remove_cvref_t<decltype(std::declval<const Density&>().profile().shape())>,
                    typename Density::scalar>;
template <class Density>
using widths_of = std::remove_cvref_t<decltype(std::declval<const Density&>().widths())>;

}  // namespace detail

/// A density without a closed projected area, and a table of that: `tabulated{gtr{a, 1.0f}}` is a distribution, with
/// visible normals. Build it once, not per pixel: it takes half a millisecond to one, and 0.8 kB in float, 1.6 in
/// double. Scalar types only.
/// Error of a projected area: 3e-6 of the one along the horizon where the slopes span less than four powers of ten, or
/// as the density says: `gtr` and `abc` at alpha = 1e-4 are off by 4e-5.
template <normal_density Density>
    requires requires(const Density d) { d.profile().shape(); }
class tabulated : public radial<detail::tabulated_shape_of<Density>, detail::widths_of<Density>> {
    static_assert(!distribution<Density>, "this distribution has a projected area: it needs no table");
    using table = detail::tabulated_shape_of<Density>;

public:
    constexpr explicit tabulated(const Density& density)
        : radial<table, detail::widths_of<Density>>(table(density.profile().shape()), density.widths()) {}
};

/// A profile that somebody else keeps. What is shape-invariant needs one table for all widths,
/// and each of them a pointer to it:
///   const tabulated table{exponential_power{alpha{1.0f}, p}};
///   const stretched ndf{shared{table.profile()}, alpha{a}};
/// The profile has to outlive it.
template <class Profile>
class shared {
public:
    constexpr explicit shared(const Profile& profile) : p(&profile) {}
    constexpr explicit shared(const Profile&&) = delete;

    template <scalar T, class Width>
    constexpr T D(const vec3<T>& m, const Width& width) const requires(requires(const Profile q) { q.D(m, width); }) {
        return p->D(m, width);
    }
    template <scalar T>
    constexpr T D(const vec3<T>& m) const requires(requires(const Profile q) { q.D(m); }) {
        return p->D(m);
    }
    template <scalar T>
    constexpr T projected_area(const vec3<T>& w) const requires(requires(const Profile q) { q.projected_area(w); }) {
        return p->projected_area(w);
    }
    template <scalar T>
    constexpr T lambda(const vec3<T>& w) const requires(requires(const Profile q) { q.lambda(w); }) {
        return p->lambda(w);
    }
    template <scalar T>
    constexpr vec3<T> sample(const vec2<T>& u) const requires(requires(const Profile q) { q.sample(u); }) {
        return p->sample(u);
    }
    template <scalar T>
    constexpr vec3<T> sample_visible(const vec3<T>& v, const vec2<T>& u) const
        requires(requires(const Profile q) { q.sample_visible(v, u); }) {
        return p->sample_visible(v, u);
    }

private:
    const Profile* p;
};

}  // namespace lobe
