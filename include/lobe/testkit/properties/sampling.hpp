// Samples, their density and their weights belong together, and to f_cos.
#pragma once

#include <lobe/testkit/verdict/comparison.hpp>
#include <lobe/testkit/verdict/density.hpp>
#include <lobe/testkit/verdict/per_view.hpp>
#include <lobe/testkit/verdict/places.hpp>
#include <lobe/testkit/verdict/property.hpp>

#include <algorithm>
#include <memory>
#include <numeric>

namespace lobe::testkit {

namespace id {
inline constexpr property_id pdf_at_most_1{"pdf_at_most_1", "integral of the pdf is at most 1"};
inline constexpr detail::density_ids pdf_of_samples{
    {"pdf_integral", "integral of the pdf = successes", true},
    {"pdf_means", "means of samples = means of the pdf", true},
    {"samples_follow_pdf", "samples follow the pdf (chi-squared)", true}};
inline constexpr property_id pdf_covers_f{"pdf_covers_f", "pdf > 0 where f_cos > 0"};
inline constexpr property_id mean_weight{"mean_weight", "mean weight = furnace", true};
inline constexpr property_id weighted_means{"weighted_means", "weighted means of samples = of f_cos", true};
inline constexpr property_id weight_times_pdf{"weight_times_pdf", "weight * pdf = f_cos", true};
inline constexpr property_id same_pdf{"same_pdf", "pdf(v, sample.l) = sample.pdf", true};
}  // namespace id

namespace detail {

/// The pdf over all directions: at most 1, or, where there are samples, what they follow.
template <class T, std::size_t N>
class density_of_samples : public brdf_property<T, N> {
public:
    using typename brdf_property<T, N>::view, typename brdf_property<T, N>::V;
    explicit density_of_samples(subject<T, N>& judged)
        : brdf_property<T, N>(judged),
          at_most(id::pdf_at_most_1, "it is no density: a factor or a Jacobian is wrong", relation::at_most),
          followed(id::pdf_of_samples, judged.claims, static_cast<int>(views(judged).size())) {}

    void at_view(const view& from) override {
        subject<T, N>& brdf = this->b;
        if (!brdf.has_pdf()) return;
        const auto pdf = [&](const V& v, const V& l) { return brdf.pdf(v, l); };
        if (brdf.has_sample()) {
            const auto moments_of = [&](const vec3<double>& l) { return moments_of_light(from.w, l); };
            followed.add(from.chart, pdf, *from.over_u, moments_of, from.v, from.seed);
            return;
        }
        const auto total = std::make_shared<mesh<1>>(
            [&](double x, double y) {
                const auto p = from.chart(x, y);
                return mesh<1>::values{pdf(from.v, V(p.l)) * p.area};
            },
            from.chart.columns, 16, 1);
        integrate(*total, from.chart, from.w, {}, brdf.effort, 1);
        const auto integral = doubtable_integral<1>(total);
        at_most.add([&](bool doubted) -> view_result {
            const estimate<1>& E = integral(doubted);
            return {.measured = E.value[0],
                    .expected = 1,
                    .allowed = brdf.claims.tolerance + E.error[0],
                    .v = from.w,
                    .input = from.text};
        });
    }

    void report_to(report& r) override {
        at_most.report_to(r);
        if (this->b.has_sample() && this->b.has_pdf()) followed.report_to(r);
    }

private:
    per_view at_most;
    density_check<T> followed;
};

/// The sampler goes where the BRDF reflects, and its weights add up to what is reflected.
template <class T, std::size_t N>
class unbiased : public brdf_property<T, N> {
public:
    using typename brdf_property<T, N>::view;
    using brdf_property<T, N>::brdf_property;

    void at_view(const view& from) override {
        const auto once = from.reflected();
        if (this->b.has_pdf() && std::accumulate(once.value.begin(), once.value.end(), 0.0) > 0)
            covered.add([&](bool doubted) -> view_result {
                const auto E = from.reflected(doubted);
                const double total = std::accumulate(E.value.begin(), E.value.end(), 0.0),
                             error = std::accumulate(E.error.begin(), E.error.end(), 0.0);
                return {.measured = total - E.uncovered,
                        .expected = total,
                        .allowed = this->b.claims.tolerance * total + error,
                        .v = from.w,
                        .input = from.text};
            });
        if (!this->b.has_sample()) return;
        for (std::size_t k = 0; k < N; ++k)
            if (!is_padding<N>(k, once.value[k]))
                mean_weight.add([&](bool doubted) -> view_result {
                    const auto E = from.reflected(doubted), W = from.weighted(doubted);
                    return {.measured = W.value[k],
                            .expected = E.value[k],
                            .allowed = from.allowed * E.value[k] + E.error[k] + W.error[k] + least_that_counts,
                            .v = from.w,
                            .input = from.text};
                });
        if (!(*std::max_element(once.value.begin(), once.value.end()) > 10 * least_that_counts)) return;
        for (std::size_t k = 0; k < 5; ++k)
            means.add([&](bool doubted) -> view_result {
                const auto E = from.reflected(doubted), W = from.weighted(doubted);
                return {.measured = W.moment[k],
                        .expected = E.moment[k],
                        .allowed = from.allowed * E.moment[k < 3 ? k : k - 3] + E.moment_error[k] + W.moment_error[k],
                        .v = from.w,
                        .input = from.text};
            });
    }

    void report_to(report& r) override {
        covered.report_to(r);
        mean_weight.report_to(r);
        means.report_to(r);
    }

private:
    per_view covered{id::pdf_covers_f, "the sampler never goes where the BRDF reflects: that light is lost"};
    per_view mean_weight{id::mean_weight,
                         "the estimator is biased: the weight or the pdf does not belong to the samples"};
    per_view means{id::weighted_means, "the estimator is biased: the samples are wider, narrower, more tilted or more "
                                       "to one side than their weights say"};
};

/// Weight and density of each sample against the functions.
template <class T, std::size_t N>
class weights : public brdf_property<T, N> {
public:
    using typename brdf_property<T, N>::sample;
    explicit weights(subject<T, N>& judged)
        : brdf_property<T, N>(judged), product(id::weight_times_pdf, judged.claims.tolerance,
                                               "the weight of a sample is not f_cos / pdf", judged.scatters.eta),
          same_pdf(id::same_pdf, judged.claims.tolerance,
                   "sample and pdf are two formulas: another width, another measure, or another lobe",
                   judged.scatters.eta) {}

    void at_sample(const sample& one) override {
        for (std::size_t k = 0; k < N; ++k)
            product.add(one.s.weight[k] * one.s.pdf, one.f[k], one.at, k, one.s.weight[k]);
        if (this->b.has_pdf()) same_pdf.add(this->b.pdf(one.v, one.s.l), one.s.pdf, one.at);
    }

    void report_to(report& r) override {
        product.report_to(r, [&](const place<T>& at, std::size_t k) { return 2 * this->b.noise_of_f(at, k); });
        same_pdf.report_to(r, [&](const place<T>& at, std::size_t) { return 2 * this->b.noise_of_pdf(at); });
    }

private:
    comparison<T> product, same_pdf;
};

}  // namespace detail

}  // namespace lobe::testkit
