// f(v,l) = f(l,v).
#pragma once

#include <lobe/testkit/verdict/comparison.hpp>
#include <lobe/testkit/verdict/property.hpp>

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
        : brdf_property<T, N>(judged), both(id::reciprocity, judged.claims.tolerance, why) {}

    /// f_cos(v,l) cos(theta_v) is f times both cosines.
    void at_pair(const pair& p) override {
        if (!this->b.claims.reciprocal) return;
        const values g = this->b.f_cos(p.l, p.v);
        for (std::size_t k = 0; k < N; ++k)
            both.add(p.f[k] * static_cast<double>(p.v.z), g[k] * static_cast<double>(p.l.z), {.v = p.v, .l = p.l}, k);
    }

    void report_to(report& r) override {
        both.report_to(r, [&](const place<T>& at, std::size_t k) {
            const auto with_cosine = [&](const V& v, const V& l) {
                return this->b.raw.f_cos(v, l)[k] * static_cast<double>(v.z);
            };
            return rounding_noise<T>(with_cosine, at) +
                   rounding_noise<T>([&](const V& v, const V& l) { return with_cosine(l, v); }, at);
        });
    }

private:
    static constexpr const char* why =
        "f(v,l) is not f(l,v): a Fresnel term of n.v or n.l instead of v.h, a masking of one direction "
        "only, or a diffuse weight that looks "
        "at one side (if that is meant: options.reciprocal = false)";
    comparison<T> both;
};

}  // namespace detail

}  // namespace lobe::testkit
