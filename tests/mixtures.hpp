// Right subjects that are hard to judge: mixtures whose samplers jump anywhere, light with edges anywhere, heavy tails.
#pragma once

#include <lobe/testkit.hpp>

#include "strangers.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace mixtures {

using namespace strangers;
using lobe::testkit::options;
using lobe::testkit::report;

// Stretched to [0,1) again.
template <class T>
T rest(T x, T a, T b) {
    return std::min((x - a) / (b - a), T(1) - std::numeric_limits<T>::epsilon() / 2);
}
template <class T>
T glass(T c) {
    c = std::clamp(c, T(0), T(1));
    const T g = std::sqrt(T(1.25) + c * c), A = (g - c) / (g + c), B = (c * (g + c) - 1) / (c * (g - c) + 1);
    return A * A * (1 + B * B) / 2;
}

/// What selects a lobe: u.x, u.y, a third number, u.x and then u.y, a third number whose rest then shifts u.x, or each
/// of a few strips of u.x.
enum class selects { by_x, by_y, by_third, nested, shifting_third, strips };
/// Directions at which nothing is reflected.
enum class guard { none, behind_m, strip, low_light, steep_m, stripes, wedge };
/// What the share of the first lobe does.
enum class share { fixed, fresnel, square };

/// Lobes with shares that may depend on the view. f_cos is their mean, each in its colour, but for a guard.
template <class T, class S = T>
struct selection_of {
    using scalar = T;
    using V = vec3<T>;
    using drawn = lobe::testkit::sampled_light<S, T>;
    std::vector<material<T>> lobes;
    std::vector<S> colours;
    std::vector<T> base;
    share of_first = share::fixed;
    selects how = selects::by_x;
    guard without = guard::none;
    int strips = 1;

    std::vector<T> shares(const V& v) const {
        std::vector<T> w = base;
        T sum = 0;
        for (const T x : w) sum += x;
        for (T& x : w) x /= sum;
        if (of_first == share::fixed) return w;
        const T F = of_first == share::fresnel ? glass(v.z) : T(0.02) + T(0.9) * v.z * v.z;
        sum = 1 - w[0];
        w[0] = F;
        for (std::size_t i = 1; i < w.size(); ++i) w[i] *= (1 - F) / sum;
        return w;
    }
    bool cut(const V& v, const V& l) const {
        const V h = glm::normalize(v + l);
        switch (without) {
            case guard::none: return false;
            case guard::behind_m: return glm::dot(v, h) <= 0 || h.z <= 0;
            case guard::strip: return std::abs(l.x) < T(0.03);
            case guard::low_light: return l.z < T(0.01);
            case guard::steep_m: return h.z < T(0.35);
            case guard::stripes: return std::sin(T(25) * h.x) > T(0.6);
            case guard::wedge: return std::abs(std::atan2(h.y, h.x) - T(0.7)) < T(0.05);
        }
        return false;
    }
    S f_cos(const V& v, const V& l) const {
        S sum(0);
        if (!above(v, l) || cut(v, l)) return sum;
        for (std::size_t i = 0; i < lobes.size(); ++i) sum += colours[i] * (lobes[i].f_cos(v, l) / T(lobes.size()));
        return sum;
    }
    T pdf(const V& v, const V& l) const {
        if (!above(v, l)) return 0;
        const auto w = shares(v);
        T sum = 0;
        for (std::size_t i = 0; i < lobes.size(); ++i) sum += w[i] * lobes[i].pdf(v, l);
        return sum;
    }
    drawn draw(const V& v, T x, T y, T third) const {
        const drawn failed{V(0, 0, 1), S(0), 0};
        if (!(v.z > 0)) return failed;
        const auto w = shares(v);
        std::size_t i = 0;
        const auto pick = [&](T& t) {
            T a = 0, all = 0;
            for (std::size_t k = i; k < w.size(); ++k) all += w[k];
            while (i + 1 < w.size() && t >= a + w[i] / all) a += w[i++] / all;
            t = rest(t, a, i + 1 == w.size() ? T(1) : a + w[i] / all);
        };
        if (how == selects::nested && x < w[0]) {
            x = rest(x, T(0), w[0]);
        } else if (how == selects::nested) {
            x = rest(x, w[0], T(1));
            i = 1;
            pick(y);
        } else if (how == selects::strips) {
            const T k = std::floor(x * T(strips));
            T s = x * T(strips) - k;
            pick(s);
            x = std::min((k + s) / T(strips), T(1) - std::numeric_limits<T>::epsilon() / 2);
        } else {
            pick(how == selects::by_x ? x : how == selects::by_y ? y : third);
            if (how == selects::shifting_third) x = rest(x + third - std::floor(x + third), T(0), T(1));
        }
        const auto s = lobes[i].sample(v, vec2<T>(x, y));
        const T p = s.pdf > 0 ? pdf(v, s.l) : T(0);
        return p > 0 ? drawn{s.l, f_cos(v, s.l) / p, p} : failed;
    }
};
template <class T, class S = T>
struct of_two : selection_of<T, S> {
    auto sample(const vec3<T>& v, const vec2<T>& u) const { return this->draw(v, u.x, u.y, T(0)); }
};
template <class T, class S = T>
struct of_three : selection_of<T, S> {
    auto sample(const vec3<T>& v, const vec3<T>& u) const { return this->draw(v, u.x, u.y, u.z); }
};

/// Numbers of one set of parameters.
template <class T>
class parameters {
public:
    explicit parameters(std::uint64_t set) : random(set) {}
    T operator()() { return static_cast<T>(double(random() >> 11) * 0x1p-53); }
    std::size_t one_of(std::size_t n) { return random() % n; }
    T between(T low, T high) { return low * std::exp(std::log(high / low) * (*this)()); }

private:
    std::mt19937_64 random;
};

template <class T>
material<T> any_lobe(parameters<T>& p) {
    const T a = p.between(T(1), T(0.03));
    const auto coloured = [&](microfacet<T> b) {
        if (p.one_of(2)) b.F = glass<T>;
        return material<T>(b);
    };
    switch (p.one_of(7)) {
        case 0: return lambert(T(0.9));
        case 1: return coloured(ggx(std::max(a, T(0.03)), draws::all));
        case 2: return coloured(ggx(a, draws::caps));
        case 3: return coloured(ggx(T(1), draws::all));
        case 4: return coloured(ggx(a, std::min(T(1), 3 * a), draws::visible));
        case 5: return coloured(beckmann(std::max(a, T(0.1))));
        default: return coloured(ggx(a, draws::visible));
    }
}

template <class T, class S = T>
selection_of<T, S> any_selection(parameters<T>& p) {
    selection_of<T, S> m;
    for (std::size_t i = 0, n = 2 + p.one_of(3); i < n; ++i) {
        T b = p();
        if (p.one_of(3) == 0) b *= T(0.02);
        m.lobes.push_back(any_lobe(p));
        m.colours.push_back(S(1));
        m.base.push_back(T(0.002) + b);
    }
    m.of_first = static_cast<share>(p.one_of(3));
    m.how = static_cast<selects>(p.one_of(6));
    m.without = p.one_of(2) ? static_cast<guard>(p.one_of(7)) : guard::none;
    m.strips = 1 + static_cast<int>(p.one_of(9));
    return m;
}

template <class T, class S>
report verdict_on_selection(const selection_of<T, S>& m, options o) {
    // |l.x| and l.z alone are not the same with v and l changed round
    o.reciprocal = m.without != guard::strip && m.without != guard::low_light;
    if (m.how == selects::by_third || m.how == selects::shifting_third)
        return lobe::testkit::verify(of_three<T, S>{m}, o);
    return lobe::testkit::verify(of_two<T, S>{m}, o);
}

/// One of ever so many.
template <class T>
report verdict_on_any_selection(std::uint64_t set, options o) {
    parameters<T> p(set);
    return verdict_on_selection(any_selection<T>(p), o);
}

/// Lambert over GGX by D cos; one number selects, and is stretched to the azimuth.
template <class T>
struct azimuth_after_selection {
    using scalar = T;
    using V = vec3<T>;
    static constexpr bool isotropic = true;
    T a;
    bool by_third = false;
    using drawn = lobe::testkit::sampled_light<T, T>;
    T f_cos(const V& v, const V& l) const {
        if (!above(v, l)) return 0;
        const V h = glm::normalize(v + l);
        return (1 - glass(v.z)) * l.z / pi<T> +
               glass(glm::dot(v, h)) * ggx_D(h, a) * ggx_G1(v, a, a) * ggx_G1(l, a, a) / (4 * v.z);
    }
    T pdf(const V& v, const V& l) const {
        if (!above(v, l)) return 0;
        const V h = glm::normalize(v + l);
        const T p = glass(v.z);
        return (1 - p) * l.z / pi<T> + p * ggx_D(h, a) * h.z / (4 * glm::dot(v, h));
    }
    drawn draw(const V& v, T select, T azimuth, T radius) const {
        const drawn failed{V(0, 0, 1), 0, 0};
        if (!(v.z > 0)) return failed;
        const T p = glass(v.z);
        const bool mirrors = select < p;
        if (!by_third) azimuth = mirrors ? rest(select, T(0), p) : rest(select, p, T(1));
        const V m = mirrors ? ggx_sample(vec2<T>(radius, azimuth), a, a) : V(0),
                l = mirrors ? 2 * glm::dot(v, m) * m - v : cosine_hemisphere(vec2<T>(radius, azimuth));
        const T q = glm::dot(v, m) < 0 ? 0 : pdf(v, l);
        return q > 0 ? drawn{l, f_cos(v, l) / q, q} : failed;
    }
};
template <class T>
struct azimuth_after_two : azimuth_after_selection<T> {
    auto sample(const vec3<T>& v, const vec2<T>& u) const { return this->draw(v, u.x, u.x, u.y); }
};
template <class T>
struct azimuth_after_three : azimuth_after_selection<T> {
    auto sample(const vec3<T>& v, const vec3<T>& u) const { return this->draw(v, u.z, u.x, u.y); }
};

/// Lambert whose light, or whose samples, have an edge anywhere in the square of its numbers: a line, a circle, a
/// strip.
template <class T>
struct with_an_edge {
    using scalar = T;
    using V = vec3<T>;
    enum { line, circle, strip } edge = line;
    vec2<T> at{T(0.5), T(0.5)};
    T size = T(0.1), turn = 0;
    T beyond = 0;  // of the light; 0: no samples, either
    using drawn = lobe::testkit::sampled_light<T, T>;

    T tone(const V& l) const {
        const T azimuth = std::atan2(l.y, l.x) / (2 * pi<T>);
        const vec2<T> u{1 - l.z * l.z, azimuth < 0 ? azimuth + 1 : azimuth};
        const T across = (u.x - at.x) * std::cos(turn) + (u.y - at.y) * std::sin(turn);
        const bool out = edge == line     ? across > 0
                         : edge == circle ? glm::dot(u - at, u - at) < size * size
                                          : std::abs(across) < size / 10;
        return out ? beyond : T(0.9);
    }
    T f_cos(const V& v, const V& l) const { return above(v, l) ? tone(l) * l.z / pi<T> : T(0); }
    T pdf(const V& v, const V& l) const { return above(v, l) && tone(l) > 0 ? l.z / pi<T> : T(0); }
    drawn sample(const V& v, const vec2<T>& u) const {
        const V l = cosine_hemisphere(u);
        const T p = pdf(v, l);
        return p > 0 ? drawn{l, tone(l), p} : drawn{V(0, 0, 1), 0, 0};
    }
};

/// Shirley & Chiu 1997: the square to the disk, with edges along its diagonals; mirrored in each quadrant, or turned.
template <class T>
material<T> lambert_by_disk(int fold) {
    material<T> m = lambert(T(0.9));
    m.sample = [fold](const vec3<T>& v, const vec2<T>& u) {
        typename material<T>::drawn s;
        if (!(v.z > 0)) return s;
        T x = u.x, y = u.y;
        if (fold > 0) x = x * T(fold) - std::floor(x * T(fold));
        const T a = 2 * x - 1, b = 2 * y - 1;
        const bool wide = std::abs(a) > std::abs(b);
        const T r = wide ? a : b, phi = wide ? pi<T> / 4 * b / a : pi<T> / 2 - (b != 0 ? pi<T> / 4 * a / b : T(0));
        s.l = {r * std::cos(phi), r * std::sin(phi), std::sqrt(std::max(T(0), 1 - r * r))};
        s.pdf = s.l.z / pi<T>;
        s.weight = s.pdf > 0 ? T(0.9) : T(0);
        return s;
    };
    return m;
}

/// Numbers are wasted: those below `from` fail.
template <class T>
material<T> wasteful(material<T> m, T from) {
    m.sample = [m, from](const vec3<T>& v, const vec2<T>& u) {
        if (u.y < from) return typename material<T>::drawn{};
        auto s = m.sample(v, {u.x, rest(u.y, from, T(1))});
        s.pdf *= 1 - from;
        s.weight /= 1 - from;
        return s;
    };
    m.pdf = [pdf = m.pdf, from](const vec3<T>& v, const vec3<T>& l) { return (1 - from) * pdf(v, l); };
    return m;
}

struct family {
    std::string name;
    std::function<report(std::uint64_t set, options)> verdict;
};

template <class T>
void add_families(std::vector<family>& all, const std::string& scalar) {
    const auto add = [&](const std::string& name, std::function<report(parameters<T>&, options)> verdict) {
        all.push_back({name + ", " + scalar, [verdict](std::uint64_t set, const options& o) {
                           parameters<T> p(set);
                           return verdict(p, o);
                       }});
    };
    const char* by[] = {"u.x", "u.y", "a third", "u.x and u.y", "a third that shifts u.x", "strips of u.x"};
    const char* shares[] = {"fixed", "Fresnel of n.v", "square of n.v"};
    for (const std::size_t how : {0u, 1u, 2u, 3u, 4u, 5u})
        for (const std::size_t of_first : {0u, 1u, 2u})
            add(std::string("selected by ") + by[how] + ", shares " + shares[of_first],
                [how, of_first](parameters<T>& p, const options& o) {
                    auto m = any_selection<T>(p);
                    m.how = static_cast<selects>(how), m.of_first = static_cast<share>(of_first);
                    return verdict_on_selection(m, o);
                });
    add("thin strips", [](parameters<T>& p, const options& o) {
        auto m = any_selection<T>(p);
        for (T& b : m.base)
            if (p.one_of(2)) b = p.between(T(5e-4), T(5e-3));
        return verdict_on_selection(m, o);
    });
    add("coloured", [](parameters<T>& p, const options& o) {
        auto m = any_selection<T, vec3<T>>(p);
        for (auto& c : m.colours) c = {p(), p(), p()};
        return verdict_on_selection(m, o);
    });
    add("azimuth after selection", [](parameters<T>& p, const options& o) {
        options one_way = o;
        one_way.reciprocal = false;
        return lobe::testkit::verify(azimuth_after_two<T>{{p.between(T(0.04), T(1))}}, one_way);
    });
    add("azimuth beside a third", [](parameters<T>& p, const options& o) {
        options one_way = o;
        one_way.reciprocal = false;
        return lobe::testkit::verify(azimuth_after_three<T>{{p.between(T(0.04), T(1)), true}}, one_way);
    });
    for (const bool samples : {false, true})
        add(samples ? "samples with an edge" : "light with an edge", [samples](parameters<T>& p, const options& o) {
            with_an_edge<T> m;
            using edges = decltype(m.edge);
            m.edge = static_cast<edges>(p.one_of(3));
            m.at = {p(), p()};
            m.size = p.between(T(0.02), T(0.5)), m.turn = 2 * pi<T> * p();
            m.beyond = samples ? T(0) : T(0.2) * p() + T(0.01);
            options one_way = o;
            one_way.reciprocal = false;
            return lobe::testkit::verify(m, one_way);
        });
    add("a disk, folded", [](parameters<T>& p, const options& o) {
        return lobe::testkit::verify(lambert_by_disk<T>(static_cast<int>(p.one_of(5))), o);
    });
    add("numbers wasted", [](parameters<T>& p, const options& o) {
        const material<T> m = any_lobe(p);
        return lobe::testkit::verify(wasteful(m, T(0.9) * p()), o);
    });
    add("one lobe, isotropic, guarded", [](parameters<T>& p, options o) {
        o.isotropic = true;
        const T a = p.between(T(0.03), T(1));
        material<T> m = ggx(a, static_cast<draws>(p.one_of(3)));
        m.f_cos = [f = m.f_cos](const vec3<T>& v, const vec3<T>& l) {
            if (!above(v, l)) return T(0);
            const vec3<T> h = glm::normalize(v + l);
            return glm::dot(v, h) <= 0 || glm::dot(l, h) <= 0 ? T(0) : f(v, l);
        };
        return lobe::testkit::verify(m, o);
    });
}

/// Fifty-four kinds of right subjects; 40 sets of parameters each are a stress.
inline std::vector<family> families() {
    std::vector<family> all;
    add_families<float>(all, "float");
    add_families<double>(all, "double");
    return all;
}

}  // namespace mixtures
