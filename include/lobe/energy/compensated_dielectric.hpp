// A rough interface that keeps all its light: what a second and later facet returns, added to `rough_dielectric`.
#pragma once

#include <lobe/bsdf/rough_dielectric.hpp>
#include <lobe/energy/interface_albedo.hpp>
#include <lobe/energy/interface_walk.hpp>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <random>
#include <utility>
#include <vector>

namespace lobe {

/// How an `interface_energy` is built: nodes in the cosine, and random walks for each, on both sides.
struct interface_energy_options {
    int nodes = 48, walks = 1 << 14;
};

namespace detail {

/// The light that goes one way from the second facet on, M(mu) in [0,1], at nodes of y = sqrt(mu); read linearly.
/// With its average, and a map of [0,1) to cosines that follows it: of each piece between nodes the share of
/// 2 int M mu dmu is kept, and inside a piece mu^2 is spread evenly.
template <scalar T>
class later_light {
    std::vector<T> values, shares, up_to;  // M at the nodes; of each piece, and before it

public:
    T average{};

    static T cosine(std::size_t k, std::size_t pieces) { return T(k * k) / T(pieces * pieces); }

    later_light() = default;
    explicit later_light(std::vector<T> at_nodes) : values(std::move(at_nodes)) {
        const T h = T(1) / T(values.size() - 1);
        for (std::size_t k = 0; k + 1 < values.size(); ++k) {
            // int 4 M y^3 dy, M linear from one node to the next
            const T y = T(k) * h, z = y + h, y4 = y * y * y * y, z4 = z * z * z * z;
            const T fourth = z4 - y4, fifth = T(4) / T(5) * (z4 * z - y4 * y);
            up_to.push_back(average);
            shares.push_back((values[k] * (z * fourth - fifth) + values[k + 1] * (fifth - y * fourth)) / h);
            average += shares.back();
        }
    }

    T operator()(const T& mu) const {
        const auto [k, t] = piece(mu);
        return values[k] + (values[k + 1] - values[k]) * t;
    }

    /// In 1/sr, of a direction at the cosine mu.
    T pdf(const T& mu) const {
        const std::size_t k = piece(mu).first;
        return average > T(0) ? shares[k] / average / spread(k) * mu * inv_pi<T>() : T(0);
    }
    /// A cosine, u in [0,1).
    T sample(const T& u) const {
        const T at = u * average;
        const auto k =
            static_cast<std::size_t>(std::upper_bound(up_to.begin() + 1, up_to.end(), at) - up_to.begin()) - 1;
        const T t = shares[k] > T(0) ? smaller((at - up_to[k]) / shares[k], T(1)) : T(0),
                from = cosine(k, shares.size());
        return std::sqrt(from * from + spread(k) * t);
    }

private:
    std::pair<std::size_t, T> piece(const T& mu) const {
        const T at = std::sqrt(smaller(mu, T(1))) * T(shares.size());
        const std::size_t k = (std::min)(static_cast<std::size_t>(at), shares.size() - 1);
        return {k, at - T(k)};
    }
    /// Of mu^2.
    T spread(std::size_t k) const {
        const T from = cosine(k, shares.size()), to = cosine(k + 1, shares.size());
        return (to - from) * (to + from);
    }
};

}  // namespace detail

/// What a rough interface returns from its second facet on, at each cosine, from both sides: `same`, to the side that
/// the light came from, and `other`. Their sum is 1 - R - T of the interface by quadrature;
/// how they share it, the random walk says. Isotropic interfaces. Built once, in 0.3 s; whoever uses it keeps it.
template <scalar T>
class interface_energy {
    using later_light = detail::later_light<T>;

public:
    struct side {
        later_light same, other;
    };

    template <refracting_bsdf B>
        requires(B::isotropic&& std::same_as<typename B::scalar, T>)
    explicit interface_energy(const B& glass, const interface_energy_options& how = {}) {
        const T eta = glass.relative_index();
        later down = walked(glass, false, how), up = walked(glass, true, how);
        above = side{later_light(down.same), later_light(down.other)};
        // Light that crosses, over all directions, is by reciprocity eta^2 times as much from above, where it is walked
        // with less noise.
        for (int pass = 0; pass < 4; ++pass) {
            below = side{later_light(up.same), later_light(up.other)};
            const T wanted = above.other.average / (eta * eta), found = below.other.average;
            for (std::size_t k = 0; k < up.same.size() && found > T(0); ++k) {
                const T lost = up.same[k] + up.other[k];
                up.other[k] = smaller(up.other[k] * (wanted / found), lost);
                up.same[k] = lost - up.other[k];
            }
        }
    }

    side above, below;

private:
    struct later {
        std::vector<T> same, other;
    };

    template <class B>
    static later walked(const B& glass, bool from_below, const interface_energy_options& how) {
        assert(how.nodes >= 2 && how.walks >= 1 && "interface_energy: at least two nodes and one walk");
        const interface_walk walk{glass.normals(), glass.relative_index()};
        const T n = from_below ? T(1) / glass.relative_index() : glass.relative_index();
        later light;
        for (int k = 0; k < how.nodes; ++k) {
            const T mu = later_light::cosine(static_cast<std::size_t>(k), static_cast<std::size_t>(how.nodes - 1));
            const vec3<T> v = detail::view_at(larger(mu, detail::constant<T>(0x1p-20)));  // for the horizon itself
            const vec3<T> w{v.x, v.y, from_below ? -v.z : v.z};
            const auto first = directional_albedo(glass, w.z, {.order = 24});
            const T crossed = first.transmitted / B::transports::scale(n);
            const T lost = larger(T(1) - first.reflected - crossed, T(0));
            std::mt19937_64 engine(static_cast<std::uint64_t>(2 * k) + from_below);
            const auto uniform = [&] { return static_cast<T>(static_cast<double>(engine() >> 12) * 0x1p-52); };
            int back = 0, through = 0;
            for (int i = 0; i < how.walks; ++i) {
                const auto path = walk.sample(w, uniform);
                if (path.order > 1) ++((path.l.z < T(0)) == from_below ? back : through);
            }
            const T share = back + through > 0 ? T(back) / T(back + through) : T(0);
            light.same.push_back(lost * share);
            light.other.push_back(lost - lost * share);
        }
        return light;
    }
};
template <refracting_bsdf B>
interface_energy(const B&) -> interface_energy<typename B::scalar>;
template <refracting_bsdf B>
interface_energy(const B&, interface_energy_options) -> interface_energy<typename B::scalar>;

/// `rough_dielectric` and what its later facets return, spread as Kulla & Conty 2017 spread it:
/// with M_R, M_T of the side of v, primes for that of l, averages 2 int M mu dmu,
///   f = f_1 + M_R(v) M_R(l) / (pi M_R,avg)  on v's side,  f_1 + M_T(v) M'_T(l) / (pi M'_T,avg)  on the other
/// (importance transport; radiance over n^2). R + T = 1, and what each side gets is the walk's. Generalised reciprocity
/// is kept, because it holds of what crosses: M_T,avg = n^2 M'_T,avg.
/// Isotropic. Keeps a reference to the energy, which has to outlive it. Scalar types only.
/// Error, alpha in [0.01,1], eta in [1.05,2.5], cosines from 0.01, both sides: of R + T 0.0025, of R and T against the
/// walk 0.008. The directions of later light are the walk's on average only.
/// Weights: 26 at most (eta 1.05, alpha 1); variance at most 0.6 of the mean squared.
template <distribution N, interface_masking<N> M, transport Transport>
    requires(N::isotropic)
class compensated_dielectric : exact_vectors<compensated_dielectric<N, M, Transport>> {
    using T = typename N::scalar;
    using exact = exact_vectors<compensated_dielectric>;

public:
    using scalar = T;
    using spectrum = T;
    using exact::f, exact::f_cos, exact::pdf, exact::evaluate, exact::sample;
    static constexpr bool isotropic = true, transmits = true;

    compensated_dielectric(const rough_dielectric<N, M, Transport>& glass, const interface_energy<T>& energy)
        : first(glass), later(&energy) {}
    compensated_dielectric(const rough_dielectric<N, M, Transport>&, const interface_energy<T>&&) = delete;

    T f(const vec3<T>& v, const vec3<T>& l) const { return first.f(v, l) + from(v).f(l); }
    T f_cos(const vec3<T>& v, const vec3<T>& l) const { return first.f_cos(v, l) + from(v).f(l) * absolute(l.z); }
    T pdf(const vec3<T>& v, const vec3<T>& l) const {
        const view later_facets = from(v);
        return later_facets.not_sampled() * first.pdf(v, l) + later_facets.pdf(l);
    }
    evaluation<T, T> evaluate(const vec3<T>& v, const vec3<T>& l) const {
        const view later_facets = from(v);
        const auto e = first.evaluate(v, l);
        return {e.f_cos + later_facets.f(l) * absolute(l.z), later_facets.not_sampled() * e.pdf + later_facets.pdf(l)};
    }

    /// u in [0,1)^3: u.z chooses the first facet, or the later ones in proportion to their light.
    direction_sample<T, T> sample(const vec3<T>& v, const vec3<T>& u) const {
        const view later_facets = from(v);
        const T p = later_facets.not_sampled();
        if (u.z < p) {
            const auto s =
                first.sample(v, vec3<T>{u.x, u.y, smaller(u.z / p, T(1) - std::numeric_limits<T>::epsilon() / T(2))});
            if (!(s.pdf > T(0))) return s;
            const T density = p * s.pdf + later_facets.pdf(s.l);
            return {s.l, (s.weight * s.pdf + later_facets.f(s.l) * absolute(s.l.z)) / density, density};
        }
        const vec3<T> l = later_facets.sample(u, (u.z - p) / (T(1) - p));
        const auto e = evaluate(v, l);
        if (!(e.pdf > T(0))) return {{T(0), T(0), T(1)}, T(0), T(0)};
        return {l, e.f_cos / e.pdf, e.pdf};
    }

    constexpr vec2<T> width() const { return first.width(); }
    constexpr const rough_dielectric<N, M, Transport>& first_facet() const { return first; }

private:
    using side = typename interface_energy<T>::side;

    /// The later facets as v sees them.
    struct view {
        const side &here, &there;
        bool visible, below;
        T same, other, crossing, scale;  // M_R(v), M_T(v), the average of M'_T, of radiance

        T f(const vec3<T>& l) const {
            const T mu = absolute(l.z);
            if (!visible || !(mu > horizon<T>())) return T(0);
            if ((l.z < T(0)) == below) return over(same * here.same(mu), here.same.average);
            return over(other * there.other(mu) * scale, crossing);
        }
        /// Times the probability that the later facets are sampled.
        T pdf(const vec3<T>& l) const {
            const T mu = absolute(l.z);
            if (!visible || !(mu > horizon<T>())) return T(0);
            return (l.z < T(0)) == below ? same * here.same.pdf(mu) : other * there.other.pdf(mu);
        }
        T not_sampled() const { return T(1) - (same + other); }
        vec3<T> sample(const vec3<T>& u, const T& which) const {
            const bool back = which * (same + other) < same;
            const T mu = larger(back ? here.same.sample(u.x) : there.other.sample(u.x), T(2) * horizon<T>());
            const auto [sine, cosine] = sincos_2pi(u.y);
            const T r = std::sqrt((T(1) - mu) * (T(1) + mu));
            return {r * cosine, r * sine, back == below ? -mu : mu};
        }

    private:
        static T over(const T& light, const T& average) {
            return average > T(0) ? light / average * inv_pi<T>() : T(0);
        }
    };
    view from(const vec3<T>& v) const {
        const bool below = v.z < T(0);
        const side &here = below ? later->below : later->above, &there = below ? later->above : later->below;
        const T mu = absolute(v.z), eta = first.relative_index(), n = below ? T(1) / eta : eta;
        const T crossing = later->below.other.average * (below ? eta * eta : T(1));
        return {here, there, mu > horizon<T>(), below, here.same(mu), here.other(mu), crossing, Transport::scale(n)};
    }

    rough_dielectric<N, M, Transport> first;
    const interface_energy<T>* later;
};

}  // namespace lobe
