// evaluate(v, l) is {f_cos, pdf}, and what has the name of a member of a BRDF can be called as one.
#pragma once

#include <lobe/testkit/verdict/comparison.hpp>
#include <lobe/testkit/verdict/property.hpp>

#include <string>

namespace lobe::testkit {

namespace id {
inline constexpr property_id evaluate{"evaluate", "evaluate = {f_cos, pdf}"};
inline constexpr property_id sample_callable{"sample_callable", "sample(v, u) can be called"};
inline constexpr property_id pdf_callable{"pdf_callable", "pdf(v, l) can be called"};
}  // namespace id

namespace detail {

template <class T, std::size_t N>
class evaluate : public brdf_property<T, N> {
public:
    using typename brdf_property<T, N>::pair, typename brdf_property<T, N>::V;
    explicit evaluate(subject<T, N>& judged)
        : brdf_property<T, N>(judged),
          together(id::evaluate, judged.claims.tolerance, "evaluate and the separate functions are two formulas") {}

    void at_pair(const pair& p) override {
        if (!this->b.has_pdf() || !this->b.raw.evaluate) return;
        const auto [f_cos, pdf] = this->b.raw.evaluate(p.v, p.l);
        const place<T> at{.v = p.v, .l = p.l};
        for (std::size_t k = 0; k < N; ++k) together.add(f_cos[k], p.f[k], at, k);
        together.add(pdf, this->b.pdf(p.v, p.l), at, N);
    }

    void report_to(report& r) override {
        together.report_to(r, [&](const place<T>& at, std::size_t k) {
            return 2 * (k == N ? this->b.noise_of_pdf(at) : this->b.noise_of_f(at, k));
        });
    }

private:
    comparison<T> together;
};

/// Members that cannot be called the way the kit calls them: a verdict without them is not the one that was asked for.
template <class T, std::size_t N>
class callable : public brdf_property<T, N> {
public:
    using brdf_property<T, N>::brdf_property;
    void report_to(report& r) override {
        const auto misfit = [&](const property_id& member, const std::string& why) {
            r.add(member, {.passed = false,
                           .expected = 1,
                           .meaning = "the member is there, but not verified: it is not const, " + why +
                                      "; to verify f_cos alone, pass a lambda that calls it"});
        };
        if (this->b.raw.misfit_sample)
            misfit(id::sample_callable,
                   "does not take two vectors of 3 and of 2 or 3 numbers, or does not return l, weight and pdf");
        if (this->b.raw.misfit_pdf)
            misfit(id::pdf_callable, "does not take two vectors of 3 numbers, or does not return a number");
    }
};

}  // namespace detail

}  // namespace lobe::testkit
