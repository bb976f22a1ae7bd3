// Normals drawn from a distribution: all of them, and those that a viewer sees.
#pragma once

#include <lobe/testkit/measure/moments.hpp>
#include <lobe/testkit/subject/distribution.hpp>
#include <lobe/testkit/verdict/comparison.hpp>
#include <lobe/testkit/verdict/density.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace lobe::testkit {

namespace id {
inline constexpr property_id pdf_of_normals{"pdf_of_normals", "pdf = D cos(theta)"};
inline constexpr detail::density_ids normals{{"normals_pdf_integral", "integral of the pdf = successes"},
                                             {"normals_pdf_means", "means of normals = means of the pdf"},
                                             {"normals_follow_pdf", "normals follow the pdf (chi-squared)"}};
inline constexpr property_id pdf_of_visible{"pdf_of_visible_normals", "visible pdf = max(0, v.m) D / area"};
inline constexpr detail::density_ids visible_normals{
    {"visible_pdf_integral", "integral of the visible pdf = successes"},
    {"visible_pdf_means", "means of visible normals = means of the visible pdf"},
    {"visible_normals_follow_pdf", "visible normals follow the visible pdf (chi-squared)"}};
}  // namespace id

namespace detail {

inline std::array<double, 5> moments_of_normal(const vec3<double>& m) { return moments(m, m.z); }

template <class T>
vec3<T> random_normal(generator& random) {
    const double tilt = random.log_between(1e-4, 1.5), azimuth = tau * random();
    return direction<T>(std::cos(tilt), azimuth);
}

template <class T>
void all_normals(distribution<T>& n, report& r) {
    using V = vec3<T>;
    if (n.raw.pdf) {
        comparison<T> product(id::pdf_of_normals, n.claims.tolerance,
                              "the density of normals is D cos(theta_m), in 1/sr");
        generator random(n.claims.seed);
        for (int i = 0; i < n.effort.pairs; ++i) {
            const V m = random_normal<T>(random);
            product.add(n.raw.pdf(m), n.D(m) * static_cast<double>(m.z), {.v = m, .has_l = false, .first = "m"});
        }
        product.report_to(r, [&](const place<T>& at, std::size_t) {
            return 2 * rounding_noise<T>([&](const V& m, const V&) { return n.raw.D(m); }, at);
        });
    }
    if (n.raw.sample) {
        density_check<T> density(id::normals, n.claims, 1);
        const expectation<T> over_u([&](const V& u) { return n.sample({u.x, u.y}); }, 2);
        density.add(
            n.chart, [&](const V&, const V& m) { return n.pdf(m); }, over_u, moments_of_normal, {T(0), T(0), T(1)},
            n.claims.seed);
        density.report_to(r);
    }
}

template <class T>
void visible_normals(distribution<T>& n, report& r) {
    using V = vec3<T>;
    if (!n.raw.sample_visible) return;
    const std::vector<V> all = n.views(false);
    density_check<T> density(id::visible_normals, n.claims, static_cast<int>(all.size()));
    comparison<T> product(id::pdf_of_visible, n.claims.tolerance,
                          "the density of visible normals is max(0, v.m) D(m) / projected_area(v), in 1/sr");
    generator random(n.claims.seed);
    const auto facing = [&](const V& v, const V& m) { return (std::max)(0.0, dot(vec3<double>(v), vec3<double>(m))); };
    for (const V& v : all) {
        const double exact = n.area_by_quadrature(normalize(vec3<double>(v)))(false).value[0];
        const auto visible = [&](const V& m) { return facing(v, m) * n.D(m) / exact; };
        if (n.raw.pdf_visible)
            for (int i = 0; i < n.effort.pairs / 8; ++i) {
                const V m = random_normal<T>(random);
                product.add(n.raw.pdf_visible(v, m), visible(m), {.v = v, .l = m});
            }
        const expectation<T> over_u([&](const V& u) { return n.sample_visible(v, {u.x, u.y}); }, 2);
        const auto pdf = [&](const V& from, const V& m) {
            return n.raw.pdf_visible ? computable(n.raw.pdf_visible(from, m)) : visible(m);
        };
        density.add(n.chart, pdf, over_u, moments_of_normal, v, n.claims.seed);
    }
    density.report_to(r);
    product.report_to(r, [&](const place<T>& at, std::size_t) {
        const double area = n.area_by_quadrature(normalize(vec3<double>(at.v)))(false).value[0];
        return 2 * rounding_noise<T>([&](const V& v, const V& m) { return facing(v, m) * n.raw.D(m); }, at) /
               (std::max)(1e-30, area);
    });
}

}  // namespace detail

}  // namespace lobe::testkit
