// Nothing changes when v and l turn about the normal.
#pragma once

#include <lobe/testkit/verdict/comparison.hpp>
#include <lobe/testkit/verdict/property.hpp>

#include <cmath>

namespace lobe::testkit {

namespace id {
inline constexpr property_id isotropy{"isotropy", "isotropy"};
}

namespace detail {

template <class T, std::size_t N>
class isotropy : public brdf_property<T, N> {
public:
    using typename brdf_property<T, N>::pair, typename brdf_property<T, N>::values, typename brdf_property<T, N>::V;
    explicit isotropy(subject<T, N>& judged)
        : brdf_property<T, N>(judged), random(judged.claims.seed, 3),
          turned(id::isotropy, judged.claims.tolerance,
                 "the value changes when v and l turn about the normal: it is anisotropic, or reads x or y alone") {}

    void at_pair(const pair& p) override {
        if (!this->b.isotropic) return;
        const T angle = static_cast<T>(tau * random());
        const values g = this->b.f_cos(rotated(p.v, angle), rotated(p.l, angle));
        for (std::size_t k = 0; k < N; ++k)
            // the angle is not printed, but needed below
            turned.add(g[k], p.f[k], {.v = p.v, .l = p.l, .u = {angle, T(0), T(0)}}, k);
    }

    /// A guard at grazing may round the other way at either place.
    void report_to(report& r) override {
        turned.report_to(r, [&](const place<T>& at, std::size_t k) {
            const place<T> there{.v = rotated(at.v, at.u.x), .l = rotated(at.l, at.u.x)};
            return this->b.noise_of_f(at, k) + this->b.noise_of_f(there, k);
        });
    }

private:
    static V rotated(const V& w, T turn) {
        const double angle = static_cast<double>(turn), c = std::cos(angle), s = std::sin(angle);
        const double x = static_cast<double>(w.x), y = static_cast<double>(w.y);
        return {static_cast<T>(c * x - s * y), static_cast<T>(s * x + c * y), w.z};
    }

    generator random;
    comparison<T> turned;
};

}  // namespace detail

}  // namespace lobe::testkit
