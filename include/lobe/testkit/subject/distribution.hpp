// A stranger's distribution of normals before the judge: what is claimed of it, and its functions, watched.
#pragma once

#include <lobe/testkit/measure/budget.hpp>
#include <lobe/testkit/measure/normal_chart.hpp>
#include <lobe/testkit/measure/second_opinion.hpp>
#include <lobe/testkit/options.hpp>
#include <lobe/testkit/subject/watch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <functional>
#include <memory>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace lobe::testkit::detail {

template <class N, class V>
concept has_D = requires(const N n, const V m) {
    n.D(m);
};

template <class V, class N>
    requires has_D<N, V> || requires(const N n, const V m) { n(m); }
auto call_D(const N& n, const V& m) {
    if constexpr (has_D<N, V>)
        return n.D(m);
    else
        return n(m);
}

template <class N, class T>
concept distribution_fits = requires(const N n, const vec3<T> m) {
    static_cast<double>(call_D(n, m));
};

template <class N>
auto scalar_of_distribution() {
    if constexpr (requires { typename N::scalar; })
        return typename N::scalar{};
    else if constexpr (requires(const N n) { call_D(n, vec3<double>{}); })
        return std::conditional_t<std::is_same_v<decltype(call_D(std::declval<const N&>(), vec3<double>{})), float>,
                                  float, double>{};
    else
        return float{};
}

/// A stranger's functions, those that exist; `area` is whichever of projected area, Lambda and G1 there is.
template <class T>
struct distribution_functions {
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
    distribution_functions<T> out;
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
class distribution {
public:
    using V = vec3<T>;

    distribution(distribution_functions<T> judged, const options& claimed)
        : raw(std::move(judged)), claims(claimed), effort(budget_of(claimed.effort)),
          isotropic(claimed.isotropic.value_or(raw.isotropic)),
          area_everywhere(raw.area_everywhere && claimed.area_below) {}

    double D(const V& m) {
        last = {.v = m, .has_l = false, .first = "m"};
        ++of_D.calls;
        const double d = of_D.see(raw.D(m), last, m.z < T(0));
        largest = (std::max)(largest, d);
        return d;
    }
    double area(const V& w) {
        last = {.v = w, .has_l = false};
        ++of_area.calls;
        return of_area.see(raw.area(w), last, false);
    }
    /// The density of normals that samples follow.
    double pdf(const V& m) { return raw.pdf ? computable(raw.pdf(m)) : D(m) * static_cast<double>(m.z); }

    /// A normal, where it is one.
    std::optional<V> sample(const vec2<T>& u) {
        return checked(raw.sample(u), {.u = {u, T(0)}, .has_v = false, .has_l = false, .numbers = 2});
    }
    std::optional<V> sample_visible(const V& v, const vec2<T>& u) {
        return checked(raw.sample_visible(v, u), {.v = v, .u = {u, T(0)}, .has_l = false, .numbers = 2});
    }

    /// int max(0, w.m) D(m) dm, by quadrature.
    doubtable<1> area_by_quadrature(const vec3<double>& w) {
        return over_normals([this, w](const vec3<double>& m) { return (std::max)(0.0, dot(w, m)) * D(V(m)); });
    }
    doubtable<1> over_normals(const std::function<double(const vec3<double>& m)>& f) const {
        const auto over_m = std::make_shared<mesh<1>>(
            [this, f](double x, double y) {
                const auto p = chart(x, y);
                return mesh<1>::values{f(p.l) * p.area};
            },
            8, 16, 1);
        over_m->refine(effort.tolerance / 3, 1, effort.evaluations);
        return doubtable_integral<1>(over_m);
    }

    /// Directions to look from.
    std::vector<V> views(bool below) const {
        std::vector<V> all;
        int i = 0;
        for (const double z : {1.0, 0.9, 0.6, 0.3, 0.1, 0.01, -0.1, -0.5, -0.9})
            if (z > 0 || below) all.push_back(direction<T>(z, golden_angle * i++));
        if (!isotropic)
            for (const double azimuth : {0.0, tau / 4}) all.push_back(direction<T>(0.4, azimuth));
        return all;
    }

    const distribution_functions<T> raw;
    const options claims;
    const budget effort;
    const bool isotropic, area_everywhere;
    const normal_chart chart{};

    watch<T> of_D{}, of_area{};
    length_watch<T> lengths{};
    place<T> last{};
    double largest = 0;

private:
    std::optional<V> checked(const V& m, const place<T>& at) {
        last = at;
        lengths.see(m, at);
        return all_finite(m) && m.z > T(0) ? std::optional<V>(m) : std::nullopt;
    }
};

}  // namespace lobe::testkit::detail
