// Pairs of numbers that ought to be equal, but for rounding.
#pragma once

#include <lobe/testkit/measure/random.hpp>
#include <lobe/testkit/measure/text.hpp>
#include <lobe/testkit/verdict/diagnosis.hpp>
#include <lobe/testkit/verdict/report.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace lobe::testkit::detail {

/// Up to 2^14 of however many things, evenly spread over them: every second is dropped whenever they are too many.
template <class X>
class thinned {
public:
    void add(const X& x) {
        if (seen++ % stride) return;
        kept.push_back(x);
        if (kept.size() < (1u << 14)) return;
        for (std::size_t i = 0; i < kept.size() / 2; ++i) kept[i] = kept[2 * i];
        kept.resize(kept.size() / 2);
        stride *= 2;
    }
    std::vector<X> kept;

private:
    std::size_t seen = 0, stride = 1;
};

/// Pairs of numbers that ought to be equal. Each pair may differ by `tolerance` (relative) and by four times what
/// rounding does there; the median of all ratios by `tolerance` and what rounding does on average.
template <class T>
class comparison {
public:
    comparison(const property_id& of, double relative, std::string meaning)
        : property(of), tolerance(relative), otherwise(std::move(meaning)) {}

    /// Values at which T begins to lose digits say nothing.
    static constexpr double smallest = 1e6 * static_cast<double>((std::numeric_limits<T>::min)());

    void add(double measured, double expected, const place<T>& at, std::size_t channel = 0) {
        const double size = (std::max)(std::abs(measured), std::abs(expected));
        if (!(size > smallest)) return;
        ++count;
        if (!same(expected, 0)) ratios.add(measured / expected);
        const suspect one{.measured = measured,
                          .expected = expected,
                          .deviation = std::abs(measured - expected) / size,
                          .channel = channel,
                          .at = at};
        if (one.deviation > close.deviation) close = one;
        if (!(one.deviation > tolerance)) return;
        spread.add(one);
        largest.push_back(one);
        if (largest.size() == 4 * worst_kept) keep_largest();
    }

    /// noise(place, channel): what rounding does to the two values there.
    using noise_at = std::function<double(const place<T>& at, std::size_t channel)>;
    void report_to(report& r, const noise_at& noise) {
        if (!count) return;
        // The largest deviations, and as many spread over all: the largest may all be rounding.
        keep_largest();
        std::vector<suspect> looked_at;
        const std::size_t step = std::max<std::size_t>(1, spread.kept.size() / 128);
        for (std::size_t i = 0; i < spread.kept.size(); i += step) looked_at.push_back(spread.kept[i]);
        std::vector<double> noises, sorted;
        const auto relative_noise = [&](const suspect& s) {
            return noise(s.at, s.channel) / (std::max)(std::abs(s.measured), std::abs(s.expected));
        };
        for (const suspect& s : looked_at) noises.push_back(relative_noise(s));
        // At one place a function may round alike whatever is done to it: the noise is at least what three of four
        // places have.
        sorted = noises;
        std::sort(sorted.begin(), sorted.end());
        const double typical = sorted.empty() ? 0 : sorted[sorted.size() / 4];
        for (const suspect& s : largest) looked_at.push_back(s), noises.push_back(relative_noise(s));

        double worst = 0, allowed = 0;
        suspect at = close;
        std::vector<ratio_at> wrong;
        for (std::size_t i = 0; i < looked_at.size(); ++i) {
            const suspect& s = looked_at[i];
            const double size = (std::max)(std::abs(s.measured), std::abs(s.expected));
            const double limit = (tolerance + 4 * (std::max)(noises[i], typical)) * size;
            const double excess = std::abs(s.measured - s.expected) / limit;
            if (excess > 1 && !same(s.expected, 0))
                wrong.push_back({s.measured / s.expected, vec3<double>(s.at.v), vec3<double>(s.at.l)});
            if (excess > worst) worst = excess, allowed = limit, at = s;
        }
        if (worst > 1) {
            r.add(property, {.passed = false,
                             .measured = at.measured,
                             .expected = at.expected,
                             .tolerance = allowed,
                             .input = at.at.text(),
                             .meaning = explain(wrong, otherwise)});
            return;
        }
        if (ratios.kept.size() >= 64) {
            const auto middle = ratios.kept.begin() + static_cast<std::ptrdiff_t>(ratios.kept.size() / 2);
            std::nth_element(ratios.kept.begin(), middle, ratios.kept.end());
            if (std::abs(*middle - 1) > tolerance + typical) {
                r.add(property, {.passed = false,
                                 .measured = *middle,
                                 .expected = 1,
                                 .tolerance = tolerance + typical,
                                 .input = at.at.text(),
                                 .meaning = "the same factor on most values: a constant is wrong",
                                 .suffix = ", median ratio"});
                return;
            }
        }
        r.add(property, {.measured = at.measured,
                         .expected = at.expected,
                         .tolerance = (std::max)(allowed, tolerance * std::abs(at.expected))});
    }

private:
    static constexpr std::size_t worst_kept = 64;

    struct suspect {
        double measured = 0, expected = 0, deviation = 0;
        std::size_t channel = 0;
        place<T> at{};
    };

    void keep_largest() {
        std::sort(largest.begin(), largest.end(),
                  [](const suspect& a, const suspect& b) { return a.deviation > b.deviation; });
        if (largest.size() > worst_kept) largest.resize(worst_kept);
    }

    property_id property;
    double tolerance;
    std::string otherwise;
    long count = 0;
    suspect close{.deviation = -1};
    std::vector<suspect> largest;
    thinned<suspect> spread;
    thinned<double> ratios;
};

}  // namespace lobe::testkit::detail
