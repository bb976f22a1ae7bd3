// A stranger's BRDF before the judge: what is claimed of it, and its functions, each value of which is watched.
#pragma once

#include <lobe/testkit/measure/budget.hpp>
#include <lobe/testkit/measure/rehearse.hpp>
#include <lobe/testkit/options.hpp>
#include <lobe/testkit/subject/brdf.hpp>
#include <lobe/testkit/subject/watch.hpp>

#include <algorithm>
#include <utility>

namespace lobe::testkit::detail {

template <class T, std::size_t N>
class subject {
public:
    using V = vec3<T>;
    using values = std::array<double, N>;

    subject(brdf_functions<T, N> judged, const options& claimed)
        : raw(std::move(judged)), claims(claimed), effort(budget_of(claimed.effort)),
          isotropic(claimed.isotropic.value_or(raw.isotropic)), scatters{.both =
                                                                             claimed.transmits.value_or(raw.sides.both),
                                                                         .eta = claimed.eta.value_or(raw.sides.eta),
                                                                         .radiance = claimed.radiance.value_or(
                                                                             raw.sides.radiance)} {}

    bool has_pdf() const { return static_cast<bool>(raw.pdf); }
    bool has_sample() const { return static_cast<bool>(raw.sample); }
    /// It scatters below, and samples there, without a word.
    bool seems_to_transmit() const { return of_f.below.count > 0 && of_sample.below.count > 0; }
    bool most_samples_are_lost() const { return lost_samples > 4 * good_samples; }

    values f_cos(const V& v, const V& l) {
        if (rehearsing()) return raw.f_cos(v, l);
        last = {.v = v, .l = l, .both_sides = scatters.both};
        values out = raw.f_cos(v, l);
        const bool vanish = !scatters.both && (l.z < 0 && v.z > 0 ? true : claims.zero_below && v.z < 0);
        ++of_f.calls;
        for (std::size_t i = 0; i < N; ++i) {
            out[i] = of_f.see(out[i], last, vanish, [&](const V& a, const V& c) { return raw.f_cos(a, c)[i]; });
            largest = (std::max)(largest, std::abs(out[i]));
        }
        return out;
    }

    double pdf(const V& v, const V& l) {
        if (rehearsing()) return raw.pdf(v, l);
        last = {.v = v, .l = l, .both_sides = scatters.both};
        ++of_pdf.calls;
        return of_pdf.see(raw.pdf(v, l), last, false, raw.pdf);
    }

    drawn<T, N> sample(const V& v, const V& u) {
        last = {.v = v, .u = u, .has_l = false, .both_sides = scatters.both, .numbers = raw.numbers};
        drawn<T, N> s = raw.sample(v, u);
        if (rehearsing()) {
            s.ok = s.pdf > 0 && scatters.judged(s.l);
            return s;
        }
        ++of_sample.calls;
        s.pdf = of_sample.see(s.pdf, last, false);
        bool carries_light = false;
        for (double& w : s.weight) {
            w = of_sample.see(w, last, false);
            carries_light |= !same(w, 0);
        }
        if (s.pdf > 0) {  // a failed sample may carry any l
            for (const T x : {s.l.x, s.l.y, s.l.z}) of_sample.see(static_cast<double>(std::abs(x)), last, false);
            lengths.see(s.l, last);
            if (!all_finite(s.l)) s.l = V(0);
            if (!scatters.judged(s.l) && carries_light)
                of_sample.below.add(s.weight[0], last, of_sample.calls, std::abs(s.weight[0]));
        } else if (carries_light) {
            if (!light_without_pdf++) light_place = last;
        }
        s.ok = s.pdf > 0 && scatters.judged(s.l);
        if (scatters.judged(v)) ++(s.ok ? good_samples : lost_samples);
        if (!s.ok) s.weight = {};
        return s;
    }

    /// All channels together, unwatched.
    double total(const V& v, const V& l) const {
        double sum = 0;
        for (const double f : raw.f_cos(v, l)) sum += f;
        return sum;
    }

    /// What rounding does to a value there.
    double noise_of_f(const place<T>& at, std::size_t channel) const {
        return rounding_noise<T>([&](const V& v, const V& l) { return raw.f_cos(v, l)[channel]; }, at);
    }
    double noise_of_pdf(const place<T>& at) const { return rounding_noise<T>(raw.pdf, at); }

    const brdf_functions<T, N> raw;
    const options claims;
    const budget effort;
    const bool isotropic;
    const sides scatters;

    watch<T> of_f{}, of_pdf{}, of_sample{};
    length_watch<T> lengths{};
    place<T> last{}, light_place{};
    double largest = 0;
    long light_without_pdf = 0, good_samples = 0, lost_samples = 0;
};

}  // namespace lobe::testkit::detail
