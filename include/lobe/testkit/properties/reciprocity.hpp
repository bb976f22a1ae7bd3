// f(v,l) = f(l,v).
#pragma once

#include <lobe/testkit/verdict/comparison.hpp>
#include <lobe/testkit/verdict/property.hpp>

#include <cmath>

namespace lobe::testkit {

namespace id {
inline constexpr property_id reciprocity{"reciprocity", "reciprocity"};
}

namespace detail {

template <class T, std::size_t N>
class reciprocity : public brdf_property<T, N> {
public:
    using typename brdf_property<T, N>::pair, typename brdf_property<T, N>::values, typename brdf_property<T, N>::V;
    explicit reciprocity(subject<T, N>& judged)
        : brdf_property<T, N>(judged),
          both(id::reciprocity, judged.claims.tolerance, judged.scatters.both ? why_of_both_sides : why,
               judged.scatters.eta * judged.scatters.eta) {}

    /// f_cos(v,l) cos(theta_v) is f times both cosines; across an interface, f_radiance(v,l)/eta_v^2 is symmetric.
    /// (The clue's index is squared: a factor that is missing is missing on both sides of the equation, upside down.)
    void at_pair(const pair& p) override {
        if (!this->b.claims.reciprocal) return;
        const values g = this->b.f_cos(p.l, p.v);
        for (std::size_t k = 0; k < N; ++k)
            both.add(p.f[k] * scale(p.v, p.l), g[k] * scale(p.l, p.v), {.v = p.v, .l = p.l}, k);
    }

    void report_to(report& r) override {
        both.report_to(r, [&](const place<T>& at, std::size_t k) {
            const auto with_cosine = [&](const V& v, const V& l) { return this->b.raw.f_cos(v, l)[k] * scale(v, l); };
            return rounding_noise<T>(with_cosine, at) +
                   rounding_noise<T>([&](const V& v, const V& l) { return with_cosine(l, v); }, at);
        });
    }

private:
    double scale(const V& v, const V& l) const {
        return std::abs(static_cast<double>(v.z)) * this->b.scatters.reciprocal(v, l);
    }

    static constexpr const char* why =
        "f(v,l) is not f(l,v): a Fresnel term of n.v or n.l instead of v.h, a masking of one direction "
        "only, or a diffuse weight that looks "
        "at one side (if that is meant: options.reciprocal = false)";
    static constexpr const char* why_of_both_sides =
        "f_radiance(v,l)/eta_v^2 is not f_radiance(l,v)/eta_l^2: a factor of one side, a half vector that is not that "
        "of the way back, a Fresnel term or masking of n.v or n.l (if that is meant: options.reciprocal = false)";
    comparison<T> both;
};

}  // namespace detail

}  // namespace lobe::testkit
