// Asked twice, a function answers twice the same.
#pragma once

#include <lobe/testkit/verdict/property.hpp>

namespace lobe::testkit {

namespace id {
inline constexpr property_id steady{"steady", "the same input, the same value"};
}

namespace detail {

template <class T, std::size_t N>
class steady : public brdf_property<T, N> {
public:
    using typename brdf_property<T, N>::pair;
    explicit steady(subject<T, N>& judged) : brdf_property<T, N>(judged), random(judged.claims.seed, 1) {}

    void at_pair(const pair& p) override {
        if (asked++ >= 256) return;
        subject<T, N>& f = this->b;
        const vec3<T> u = random_u<T>(random, f.raw.numbers);
        bool all_same = f.f_cos(p.v, p.l) == p.f && (!f.has_pdf() || same(f.pdf(p.v, p.l), f.pdf(p.v, p.l)));
        if (all_same && f.has_sample()) {
            const auto one = f.sample(p.v, u), two = f.sample(p.v, u);
            all_same = same(one.pdf, two.pdf) && one.weight == two.weight && (!one.ok || one.l == two.l);
        }
        if (!all_same && !unsteady++) at = {.v = p.v, .l = p.l, .u = u, .numbers = f.raw.numbers};
    }

    void report_to(report& r) override {
        r.add(id::steady, {.passed = unsteady == 0,
                           .measured = static_cast<double>(unsteady),
                           .input = unsteady ? at.text() : "",
                           .meaning = "a random generator inside: all randomness comes from u"});
    }

private:
    generator random;
    long asked = 0, unsteady = 0;
    place<T> at{};
};

}  // namespace detail

}  // namespace lobe::testkit
