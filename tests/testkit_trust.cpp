// Verdicts that can be trusted: no false alarm on what is right, however its sampler jumps.
#include <lobe/testkit.hpp>

#include "catch.hpp"
#include "strangers.hpp"

#include <random>

namespace {

using namespace strangers;

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

/// What selects a lobe: u.x, u.y, a third number, u.x and then u.y, or each of a few strips of u.x.
enum class selects { by_x, by_y, by_third, nested, unstretched_third, strips };
/// Directions at which nothing is reflected.
enum class guard { none, behind_m, strip, low_light, steep_m, stripes, wedge };
/// What the share of the first lobe does.
enum class share { fixed, fresnel, square };

/// Lobes with shares that may depend on the view. f_cos is their mean, but for a guard.
template <class T>
struct selection_of {
    using scalar = T;
    using V = vec3<T>;
    using drawn = lobe::testkit::sampled_light<T, T>;
    std::vector<material<T>> lobes;
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
    T f_cos(const V& v, const V& l) const {
        if (!above(v, l) || cut(v, l)) return 0;
        T sum = 0;
        for (const auto& m : lobes) sum += m.f_cos(v, l) / T(lobes.size());
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
        const drawn failed{V(0, 0, 1), 0, 0};
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
        }
        const auto s = lobes[i].sample(v, vec2<T>(x, y));
        const T p = s.pdf > 0 ? pdf(v, s.l) : T(0);
        return p > 0 ? drawn{s.l, f_cos(v, s.l) / p, p} : failed;
    }
};
template <class T>
struct of_two : selection_of<T> {
    auto sample(const vec3<T>& v, const vec2<T>& u) const { return this->draw(v, u.x, u.y, T(0)); }
};
template <class T>
struct of_three : selection_of<T> {
    auto sample(const vec3<T>& v, const vec3<T>& u) const { return this->draw(v, u.x, u.y, u.z); }
};

/// One of ever so many right subjects.
template <class T>
lobe::testkit::report verdict_on_subject(unsigned number, std::uint64_t seed) {
    std::mt19937_64 random(number);
    const auto uniform = [&] { return static_cast<T>(double(random() >> 11) * 0x1p-53); };
    const auto one_lobe = [&]() -> material<T> {
        const T a = std::exp(std::log(T(0.03)) * uniform());
        const auto coloured = [&](microfacet<T> b) {
            if (random() % 2) b.F = glass<T>;
            return material<T>(b);
        };
        switch (random() % 7) {
            case 0: return lambert(T(0.9));
            case 1: return coloured(ggx(std::max(a, T(0.03)), draws::all));
            case 2: return coloured(ggx(a, draws::caps));
            case 3: return coloured(ggx(T(1), draws::all));
            case 4: return coloured(ggx(a, std::min(T(1), 3 * a), draws::visible));
            case 5: return coloured(beckmann(std::max(a, T(0.1))));
            default: return coloured(ggx(a, draws::visible));
        }
    };
    selection_of<T> m;
    const std::size_t n = 2 + random() % 3;
    for (std::size_t i = 0; i < n; ++i) {
        T b = uniform();
        if (random() % 3 == 0) b *= T(0.02);
        m.lobes.push_back(one_lobe());
        m.base.push_back(T(0.002) + b);
    }
    m.of_first = static_cast<share>(random() % 3);
    m.how = static_cast<selects>(random() % 6);
    m.without = random() % 2 ? static_cast<guard>(random() % 7) : guard::none;
    m.strips = 1 + static_cast<int>(random() % 9);
    lobe::testkit::options o;
    o.seed = seed;
    o.reciprocal = false;
    o.name = "subject " + std::to_string(number);
    if (m.how == selects::by_third || m.how == selects::unstretched_third)
        return lobe::testkit::verify(of_three<T>{m}, o);
    return lobe::testkit::verify(of_two<T>{m}, o);
}

}  // namespace

TEST_CASE("no false alarm, wherever a sampler jumps", "[testkit]") {
    // Mixtures that select by a number of u, by two, or in strips; shares that move with the view, down to 0.1 %;
    // heavy-tailed weights; light that is cut off. The first eight failed when a rule alone decided: of subjects 0 to
    // 399 they were all.
    for (const unsigned number : {17u, 26u, 67u, 162u, 256u, 292u, 331u, 360u, 1u, 2u, 3u, 4u, 5u, 6u}) {
        const auto r = number % 2 ? verdict_on_subject<float>(number, 1) : verdict_on_subject<double>(number, 1);
        INFO(r);
        CHECK(r.passed());
    }
}
