// Where to look at a BRDF: extremes, pairs of directions over all scales, views.
#pragma once

#include <lobe/testkit/measure/light_chart.hpp>
#include <lobe/testkit/measure/random.hpp>
#include <lobe/testkit/subject/subject.hpp>

#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace lobe::testkit::detail {

template <class T>
vec3<T> mirrored(const vec3<T>& w) {
    return {w.x, w.y, -w.z};
}
template <class T>
vec3<T> unit(const vec3<double>& w) {
    return vec3<T>(normalize(w));
}

/// Every value is watched; here only the places are chosen. note(): what was found is to be kept.
template <class T, std::size_t N, class Note>
void sweep(subject<T, N>& b, const Note& note) {
    using V = vec3<T>;
    std::vector<V> w;
    for (const double z : {1.0, 1 - 1e-7, 0.999, 0.7, 0.3, 0.1, 1e-2, 1e-3, 1e-4, 1e-6, 0.0, -1e-6, -0.3, -1.0})
        for (const double azimuth : {0.0, 1.0, tau / 4, tau / 2, -2.0}) w.push_back(direction<T>(z, azimuth));
    const T tiny = std::numeric_limits<T>::denorm_min() * T(100);
    w.push_back({tiny, T(0), T(1)});
    w.push_back({-tiny, tiny, T(1)});
    const std::size_t usual = w.size();
    w.push_back({T(1), T(0), std::sqrt((std::numeric_limits<T>::min)())});  // a light nearly on the horizon
    const auto look = [&](const V& v, const V& l) {
        b.f_cos(v, l);
        if (b.has_pdf()) b.pdf(v, l);
    };
    for (std::size_t i = 0; i < usual; ++i) {
        note();
        for (const V& l : w) look(w[i], l);
        look(w[i], -w[i]);
        for (double step = 1e-8; step < 0.3; step *= 10)  // near the mirror direction, and near v itself
            for (const double side : {-1.0, 1.0}) {
                const V mirror{-w[i].x, -w[i].y, w[i].z};
                look(w[i], unit<T>(vec3<double>(mirror) + vec3<double>(side * step, step / 2, 0)));
                look(w[i], unit<T>(vec3<double>(w[i]) + vec3<double>(side * step, -step / 2, 0)));
            }
    }
    if (!b.has_sample()) return;
    const T last = T(1) - std::numeric_limits<T>::epsilon() / T(2);
    const T edges[] = {T(0),   tiny,    static_cast<T>(1e-6),           T(0.25),
                       T(0.5), T(0.75), T(1) - static_cast<T>(0x1p-24), last};
    const std::vector<T> third = b.raw.numbers == 3 ? std::vector<T>{T(0), T(0.5), last} : std::vector<T>{T(0)};
    note();
    for (std::size_t i = 0; i < usual; ++i)
        for (const T x : edges)
            for (const T y : edges)
                for (const T z : third)
                    if (b.scatters.judged(w[i])) b.sample(w[i], {x, y, z});
}

/// Of a BSDF, each on either side; light on the other side as if v came straight through a smooth interface.
/// One in three: two independent directions; else l mirrored at a normal of any slope from 1e-4 to 10. One in four near
/// grazing.
template <class T>
std::pair<vec3<T>, vec3<T>> random_pair(generator& random, int i, const sides& of) {
    const bool below = of.both && random() < 0.5, crosses = of.both && random() < 0.5;
    const auto placed = [&](const vec3<T>& v, const vec3<T>& l) {
        return std::pair(below ? mirrored(v) : v, below != crosses ? mirrored(l) : l);
    };
    const double z = i % 4 == 3 ? random.log_between(1e-6, 1e-1) : random(), azimuth = tau * random();
    const vec3<T> v = direction<T>(z, azimuth);
    if (i % 3 == 0) {
        const double cosine = i % 8 == 0 ? random.log_between(1e-6, 1) : random();
        return placed(v, direction<T>(cosine, tau * random()));
    }
    const double slope = random.log_between(1e-4, 10), turn = tau * random();
    const vec3<double> w = crosses ? straight_through(vec3<double>(v), below ? 1 / of.eta : of.eta) : vec3<double>(v),
                       m = normalize(vec3<double>(slope * std::cos(turn), slope * std::sin(turn), 1));
    return placed(v, unit<T>(2 * dot(w, m) * m - w));
}

/// What the properties will ask for of such pairs, and of samples seen from their v.
template <class T, std::size_t N>
void ask_pairs(subject<T, N>& b, int first, int end, generator random, generator random_of_u) {
    for (int i = first; i < end; ++i) {
        const auto [v, l] = random_pair<T>(random, i, b.scatters);
        if (!b.scatters.judged(v) || !b.scatters.judged(l)) continue;
        b.f_cos(v, l);
        if (b.claims.reciprocal) b.f_cos(l, v);
        if (!b.has_sample()) continue;
        const auto s = b.sample(v, random_u<T>(random_of_u, b.raw.numbers));
        if (!s.ok) continue;
        b.f_cos(v, s.l);
        if (b.has_pdf()) b.pdf(v, s.l);
    }
}

/// From the normal to cos = 0.01, moved by the seed within their gaps, and, unless the subject is isotropic, along both
/// axes; of a BSDF, from both sides.
template <class T, std::size_t N>
std::vector<vec3<T>> views(const subject<T, N>& b) {
    generator random(b.claims.seed);
    std::vector<vec3<T>> all{direction<T>(1, 0), direction<T>(0.01, golden_angle)};
    const int inner = b.effort.views - 2;
    for (int i = 0; i < inner; ++i) {
        const double t = (i + random()) / inner;  // closer to each other near grazing
        all.push_back(direction<T>(0.02 + 0.97 * t * (0.4 + 0.6 * t), golden_angle * (i + 2)));
    }
    if (!b.isotropic)
        for (const double mu : {0.7, 0.15})
            for (const double azimuth : {0.0, tau / 4}) all.push_back(direction<T>(mu, azimuth));
    if (!b.scatters.both) return all;
    for (std::size_t i = 0, n = all.size(); i < n; ++i) all.push_back(mirrored(all[i]));
    return all;
}

}  // namespace lobe::testkit::detail
