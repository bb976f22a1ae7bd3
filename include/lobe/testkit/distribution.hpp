// The verdict on a distribution of normals: `verify_distribution(ndf)`.
#pragma once

#include <lobe/testkit/checks.hpp>

namespace lobe::testkit {

namespace detail {

/// The hemisphere of normals as the unit square: theta = (pi/2) x^4, phi = 2 pi y.
struct normal_chart {
    struct point {
        vec3<double> l;
        double area;  // in sr a unit of the square
    };
    point operator()(double x, double y) const {
        const double theta = tau / 4 * x * x * x * x, phi = tau * y, s = std::sin(theta);
        return {{s * std::cos(phi), s * std::sin(phi), std::cos(theta)}, s * tau * x * x * x * tau};
    }
    std::array<double, 2> find(const vec3<double>& m) const {
        const double turn = std::atan2(m.y, m.x) / tau;
        const double theta = std::atan2(std::hypot(m.x, m.y), m.z);
        return {(std::min)(1.0, std::sqrt(std::sqrt(theta / (tau / 4)))), turn - std::floor(turn)};
    }
};

template <class N, class V>
concept has_D = requires(const N n, const V m) {
    n.D(m);
};

template <class V, class N>
auto call_D(const N& n, const V& m) {
    if constexpr (has_D<N, V>)
        return n.D(m);
    else
        return n(m);
}

template <class N>
auto scalar_of_distribution() {
    if constexpr (requires { typename N::scalar; })
        return typename N::scalar{};
    else if constexpr (requires(const N n) { call_D(n, vec3<double>{}); })
        return std::conditional_t<std::is_same_v<decltype(call_D(std::declval<const N&>(), vec3<double>{})), float>, float, double>{};
    else
        return float{};
}

/// A stranger's functions, those that exist; `area` is whichever of projected area, Lambda and G1 there is.
template <class T>
struct distribution_interface {
    using V = vec3<T>;
    std::function<double(const V&)> D, area, lambda, pdf;
    std::function<V(const vec2<T>& u)> sample;
    std::function<V(const V& v, const vec2<T>& u)> sample_visible;
    std::function<double(const V& v, const V& m)> pdf_visible;
    bool area_everywhere = false, isotropic = false;
};

template <class N>
auto interface_of_distribution(const N& n) {
    using T = decltype(scalar_of_distribution<N>());
    using V = vec3<T>;
    using U = vec2<T>;
    distribution_interface<T> out;
    out.D = [&n](const V& m) { return static_cast<double>(call_D(n, m)); };
    if constexpr (requires(const V w) { n.lambda(w); }) {
        out.lambda = [&n](const V& w) { return static_cast<double>(n.lambda(w)); };
        out.area = [&n](const V& w) { return static_cast<double>(w.z) * (1 + static_cast<double>(n.lambda(w))); };
    } else if constexpr (requires(const V w) { n.G1(w); }) {
        out.area = [&n](const V& w) { return static_cast<double>(w.z) / static_cast<double>(n.G1(w)); };
    }
    if constexpr (requires(const V w) { n.projected_area(w); }) {
        out.area = [&n](const V& w) { return static_cast<double>(n.projected_area(w)); };
        out.area_everywhere = true;
    }
    if constexpr (requires(const V m) { n.pdf(m); }) out.pdf = [&n](const V& m) { return n.pdf(m); };
    if constexpr (requires(const U u) { n.sample(u); }) out.sample = [&n](const U& u) { return V(n.sample(u)); };
    if constexpr (requires(const V v, const U u) { n.sample_visible(v, u); })
        out.sample_visible = [&n](const V& v, const U& u) { return V(n.sample_visible(v, u)); };
    if constexpr (requires(const V v) { n.pdf_visible(v, v); })
        out.pdf_visible = [&n](const V& v, const V& m) { return static_cast<double>(n.pdf_visible(v, m)); };
    if constexpr (requires {
                      { N::isotropic } -> std::convertible_to<bool>;
                  })
        out.isotropic = N::isotropic;
    return out;
}

template <class T>
class distribution_judge {
    using V = vec3<T>;

public:
    distribution_judge(distribution_interface<T> judged, const options& o)
        : n(std::move(judged)), options_(o), budget_(budget_of(o.effort)), isotropic(o.isotropic.value_or(n.isotropic)) {
        if (!o.area_below) n.area_everywhere = false;
    }

    report verdict() {
        report all = opened(options_);
        if (!all.passed()) return all;
        attempt([&] { sweep(); });
        attempt([&] { normalisation(); });
        attempt([&] { areas(); });
        attempt([&] { all_normals(); });
        attempt([&] { visible_normals(); });
        all.add({{"D is not always 0", largest, largest, 0, "", "D returned 0 for every normal: nothing can be verified"}, largest > 0});
        of_D.report_to(all);
        if (n.area) of_area.report_to(all, false);
        if (n.sample || n.sample_visible) {
            const bool unit = std::abs(worst_length - 1) <= unit_tolerance;
            all.add({{"sampled normals are unit", worst_length, 1, unit_tolerance, unit ? "" : length_place.text(),
                      "a normal that is not normalised, or the root of a negative number"},
                     unit});
        }
        for (const check& c : r.checks()) all.add(c);
        return all;
    }

private:
    double D(const V& m) {
        last = {m, {}, {}, false, false, "m"};
        ++of_D.calls;
        const double d = of_D.see(n.D(m), last, m.z < T(0));
        largest = (std::max)(largest, d);
        return d;
    }

    double area(const V& w) {
        last = {w, {}, {}, false};
        ++of_area.calls;
        return of_area.see(n.area(w), last, false);
    }

    void sweep() {
        for (const double azimuth : {0.0, 1.0, tau / 4, tau / 2, -2.0}) {
            for (const double z : {1.0, 1 - 1e-7, 0.999, 0.7, 0.3, 0.1, 1e-2, 1e-4, 1e-6, 0.0, -1e-6, -0.3, -1.0}) {
                D(direction<T>(z, azimuth));
                if (n.area && (z > 0 || n.area_everywhere)) area(direction<T>(z, azimuth));
            }
            for (double tilt = 1e-8; tilt < 0.3; tilt *= 10)
                D(V(std::sin(tilt) * std::cos(azimuth), std::sin(tilt) * std::sin(azimuth), std::cos(tilt)));
        }
        D(V{std::numeric_limits<T>::denorm_min(), T(0), T(1)});
        for (const double x : edges)
            for (const double y : edges) {
                const vec2<T> u{below_one<T>(x), below_one<T>(y)};
                if (n.sample) draw(u);
                if (n.sample_visible)
                    for (const double z : {1.0, 0.5, 1e-2, 1e-6}) draw_visible(direction<T>(z, 1.0), u);
            }
    }

    void normalisation() {
        per_view unit_area(
            "integral of D cos(theta) = 1",
            "the projected areas of the normals do not add up to the surface: a constant is wrong, a power is lost, or the cosine is");
        mesh<1> over_m(
            [&](double x, double y) {
                const auto p = chart(x, y);
                return mesh<1>::values{D(V(p.l)) * p.l.z * p.area};
            },
            8, 16, 1);
        over_m.refine(budget_.tolerance / 3, 1, budget_.evaluations);
        unit_area.add(over_m.integral()[0], 1, options_.tolerance + over_m.error()[0], {0, 0, 1}, "");
        unit_area.report_to(r);
        if (!isotropic) return;
        comparison<T> turned("isotropy", options_.tolerance,
                             "D changes when m turns about the normal: it is anisotropic, or reads x or y alone");
        generator random(options_.seed);
        for (int i = 0; i < budget_.pairs; ++i) {
            const double tilt = random.log_between(1e-4, 1.5), a = tau * random(), b = tau * random();
            const V m = direction<T>(std::cos(tilt), a), other = direction<T>(std::cos(tilt), b);
            turned.add(D(other), D(m), {m, other, {}, true, false, "m"});
        }
        turned.report_to(r, [&](const place<T>& at, std::size_t) {
            return rounding_noise([&](const V& one, const V&) { return D(one); }, at) +
                   rounding_noise([&](const V&, const V& two) { return D(two); }, at);
        });
    }

    /// int max(0, w.m) D(m) dm, by quadrature.
    std::array<double, 2> area_by_quadrature(const vec3<double>& w) {
        mesh<1> over_m(
            [&](double x, double y) {
                const auto p = chart(x, y);
                return mesh<1>::values{(std::max)(0.0, dot(w, p.l)) * D(V(p.l)) * p.area};
            },
            8, 16, 1);
        over_m.refine(budget_.tolerance / 3, 1, budget_.evaluations);
        return {over_m.integral()[0], over_m.error()[0]};
    }

    void areas() {
        if (n.area) {
            per_view identity(
                "projected area = integral of max(0, v.m) D",
                "the masking belongs to another distribution or width, or is an approximation (then ask for a larger tolerance)");
            for (const V& v : views(n.area_everywhere)) {
                const auto [exact, error] = area_by_quadrature(normalize(vec3<double>(v)));
                // Below the horizon the area is what rounding leaves of the area above: relative to |cos|, too.
                const double size = (std::max)(exact, std::abs(static_cast<double>(v.z)) * 1e-3);
                identity.add(area(v), exact, options_.tolerance * size + error, vec3<double>(v), literal("v", v));
            }
            identity.report_to(r);
        }
        if (n.area && n.lambda) {
            comparison<T> both("projected area = cos (1 + Lambda)", options_.tolerance,
                               "the two are formulas of different widths or models");
            for (const V& v : views(false)) both.add(static_cast<double>(v.z) * (1 + n.lambda(v)), area(v), {v, {}, {}, false});
            both.report_to(
                r, [&](const place<T>& at, std::size_t) { return 2 * rounding_noise([&](const V& v, const V&) { return area(v); }, at); });
        }
    }

    std::optional<V> draw(const vec2<T>& u) { return checked(n.sample(u), {{}, {}, u, false, true}); }
    std::optional<V> draw_visible(const V& v, const vec2<T>& u) { return checked(n.sample_visible(v, u), {v, {}, u, false, true}); }
    std::optional<V> checked(const V& m, const place<T>& at) {
        last = at;
        const double size = std::hypot(static_cast<double>(m.x), static_cast<double>(m.y), static_cast<double>(m.z));
        if (!(std::abs(size - 1) <= std::abs(worst_length - 1))) worst_length = size, length_place = at;
        return std::isfinite(size) && m.z > T(0) ? std::optional<V>(m) : std::nullopt;
    }

    static std::array<double, 5> numbers(const vec3<double>& m) { return moments(m, m.z); }

    void all_normals() {
        if (n.pdf) {
            comparison<T> product("pdf = D cos(theta)", options_.tolerance, "the density of normals is D cos(theta_m), in 1/sr");
            generator random(options_.seed);
            for (int i = 0; i < budget_.pairs; ++i) {
                const V m = direction<T>(std::cos(random.log_between(1e-4, 1.5)), tau * random());
                product.add(n.pdf(m), D(m) * static_cast<double>(m.z), {m, {}, {}, false, false, "m"});
            }
            product.report_to(
                r, [&](const place<T>& at, std::size_t) { return 2 * rounding_noise([&](const V& m, const V&) { return D(m); }, at); });
        }
        if (n.sample) {
            density_check<T> density("the pdf", "normals", options_, 1);
            const auto pdf = [&](const V&, const V& m) { return n.pdf ? n.pdf(m) : D(m) * static_cast<double>(m.z); };
            density.add(
                chart, pdf, [&](const vec2<T>& u) { return draw(u); }, numbers, {T(0), T(0), T(1)}, options_.seed);
            density.report_to(r);
        }
    }

    void visible_normals() {
        if (n.sample_visible) {
            const std::vector<V> all = views(false);
            density_check<T> density("the visible pdf", "visible normals", options_, static_cast<int>(all.size()));
            comparison<T> product("visible pdf = max(0, v.m) D / area", options_.tolerance,
                                  "the density of visible normals is max(0, v.m) D(m) / projected_area(v), in 1/sr");
            generator random(options_.seed);
            for (const V& v : all) {
                const double exact = area_by_quadrature(normalize(vec3<double>(v)))[0];
                const auto visible = [&](const V& m) { return (std::max)(0.0, dot(vec3<double>(v), vec3<double>(m))) * D(m) / exact; };
                const auto pdf = [&](const V& from, const V& m) { return n.pdf_visible ? n.pdf_visible(from, m) : visible(m); };
                if (n.pdf_visible)
                    for (int i = 0; i < budget_.pairs / 8; ++i) {
                        const V m = direction<T>(std::cos(random.log_between(1e-4, 1.5)), tau * random());
                        product.add(pdf(v, m), visible(m), {v, m});
                    }
                density.add(
                    chart, pdf, [&](const vec2<T>& u) { return draw_visible(v, u); }, numbers, v, options_.seed);
            }
            density.report_to(r);
            product.report_to(r, [&](const place<T>& at, std::size_t) {
                return 2 *
                       rounding_noise([&](const V& v, const V& m) { return (std::max)(0.0, dot(vec3<double>(v), vec3<double>(m))) * D(m); },
                                      at) /
                       (std::max)(1e-30, area_by_quadrature(normalize(vec3<double>(at.v)))[0]);
            });
        }
    }

    std::vector<V> views(bool below) const {
        std::vector<V> all;
        int i = 0;
        for (const double z : {1.0, 0.9, 0.6, 0.3, 0.1, 0.01, -0.1, -0.5, -0.9})
            if (z > 0 || below) all.push_back(direction<T>(z, golden_angle * i++));
        if (!isotropic)
            for (const double azimuth : {0.0, tau / 4}) all.push_back(direction<T>(0.4, azimuth));
        return all;
    }

    template <class F>
    void attempt(const F& f) {
        try {
            f();
        } catch (const std::exception& e) {
            r.add({{"no exception", 1, 0, 0, last.text(), std::string("it threw: ") + e.what()}, false});
        } catch (...) {
            r.add({{"no exception", 1, 0, 0, last.text(), "it threw something that is no std::exception"}, false});
        }
    }

    static constexpr std::array<double, 5> edges{0, 1e-6, 0.25, 0.5, 1 - 0x1p-24};
    static constexpr double unit_tolerance = 64 * static_cast<double>(std::numeric_limits<T>::epsilon());

    distribution_interface<T> n;
    options options_;
    budget budget_;
    bool isotropic;
    normal_chart chart;
    watch<T> of_D{"D"}, of_area{"the projected area"};
    place<T> last{}, length_place{};
    double largest = 0, worst_length = 1;
    report r{""};
};

}  // namespace detail

/// Judges any type with `D(m)`, or a function of m that returns it: the density of normals in 1/sr, m unit, in tangent space. Verified
/// where they exist: one of `projected_area(w)`, `lambda(w)`, `G1(w)` (Smith); `sample(u)` and `pdf(m)`; `sample_visible(v, u)` and
/// `pdf_visible(v, m)`.
template <class N>
[[nodiscard]] report verify_distribution(const N& ndf, const options& o = {}) {
    return detail::distribution_judge(detail::interface_of_distribution(ndf), o).verdict();
}

}  // namespace lobe::testkit
