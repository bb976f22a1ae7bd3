// Asked twice, a function answers twice the same.
#pragma once

#include <lobe/testkit/verdict/property.hpp>

#include <cmath>

namespace lobe::testkit {

namespace id {
inline constexpr property_id steady{"steady", "the same input, the same value"};
}

namespace detail {

template <class T, std::size_t N>
class steady : public brdf_property<T, N> {
public:
    using typename brdf_property<T, N>::pair, typename brdf_property<T, N>::values;
    explicit steady(subject<T, N>& judged) : brdf_property<T, N>(judged), random(judged.claims.seed) {}

    void at_pair(const pair& p) override {
        if (asked++ >= 256) return;
        const brdf_functions<T, N>& f = this->b.raw;
        const vec3<T> u = random_u<T>(random, f.numbers);
        bool all_same = alike(f.f_cos(p.v, p.l), p.f) && (!f.pdf || alike(f.pdf(p.v, p.l), f.pdf(p.v, p.l)));
        if (all_same && f.sample) {
            const auto one = this->b.sample(p.v, u), two = this->b.sample(p.v, u);
            all_same = same(one.pdf, two.pdf) && one.weight == two.weight && (!one.ok || one.l == two.l);
        }
        if (!all_same && !unsteady++) at = {.v = p.v, .l = p.l, .u = u, .numbers = f.numbers};
    }

    void report_to(report& r) override {
        r.add(id::steady, {.passed = unsteady == 0,
                           .measured = static_cast<double>(unsteady),
                           .input = unsteady ? at.text() : "",
                           .meaning = "a random generator inside: all randomness comes from u"});
    }

private:
    static bool alike(double a, double b) { return same(a, b) || (std::isnan(a) && std::isnan(b)); }
    static bool alike(const values& a, const values& b) {
        for (std::size_t k = 0; k < N; ++k)
            if (!alike(a[k], b[k])) return false;
        return true;
    }

    generator random;
    long asked = 0, unsteady = 0;
    place<T> at{};
};

}  // namespace detail

}  // namespace lobe::testkit
