// Pairs of numbers that ought to be equal, but for rounding.
#pragma once

#include <lobe/testkit/measure/numbers.hpp>
#include <lobe/testkit/measure/random.hpp>
#include <lobe/testkit/measure/sides.hpp>
#include <lobe/testkit/measure/text.hpp>
#include <lobe/testkit/verdict/diagnosis.hpp>
#include <lobe/testkit/verdict/parts.hpp>
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
    /// `eta`: of a BSDF, index below the surface over index above.
    comparison(const property_id& of, double relative, std::string meaning, double eta = 1)
        : property(of), tolerance(relative), otherwise(std::move(meaning)), both_sides{.both = true, .eta = eta} {}

    /// Values at which T begins to lose digits say nothing.
    static constexpr double smallest = 1e6 * static_cast<double>((std::numeric_limits<T>::min)());

    /// `part`: what the two are a product of, if that being one and the same number wherever they differ is a clue: it
    /// is clamped.
    void add(double measured, double expected, const place<T>& at, std::size_t channel = 0, double part = 0) {
        if (!is_finite(measured) || !is_finite(expected)) {
            if (!none++) none_at = at, none_value = is_finite(measured) ? expected : measured;
            return;
        }
        const double size = (std::max)(std::abs(measured), std::abs(expected));
        if (!(size > smallest)) return;
        ++count;
        of_bsdf.see(at);
        lowest_cosines.add(lowest_cosine(at));
        if (!same(expected, 0)) ratios.add(ratio_of(measured, expected));
        const suspect one{.measured = measured,
                          .expected = expected,
                          .deviation = std::abs(measured - expected) / size,
                          .part = part,
                          .channel = channel,
                          .at = at};
        if (one.deviation > close.deviation) close = one;
        if (!(one.deviation > tolerance)) return;
        of_bsdf.deviates(at);
        spread.add(one);
        largest.push_back(one);
        if (largest.size() == 4 * worst_kept) keep_largest();
    }

    /// noise(place, channel): what rounding does to the two values there.
    using noise_at = std::function<double(const place<T>& at, std::size_t channel)>;
    void report_to(report& r, const noise_at& noise) {
        if (none) {
            r.add(property, {.passed = false,
                             .measured = none_value,
                             .input = none_at.text(),
                             .meaning = "one of the two is NaN or infinite, and the other is not"});
            return;
        }
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
        rehearse([&] {
            for (const std::vector<suspect>* some : {&looked_at, &largest})
                for (const suspect& s : *some) relative_noise(s);
        });
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
        std::vector<suspect> wrong_ones;
        for (std::size_t i = 0; i < looked_at.size(); ++i) {
            const suspect& s = looked_at[i];
            const double size = (std::max)(std::abs(s.measured), std::abs(s.expected));
            const double limit = (tolerance + 4 * (std::max)(noises[i], typical)) * size;
            const double excess = std::abs(s.measured - s.expected) / limit;
            if (excess > 1) {
                wrong_ones.push_back(s);
                wrong.push_back({.ratio = ratio_of(s.measured, s.expected),
                                 .v = upward(vec3<double>(s.at.v)),
                                 .l = upward(vec3<double>(s.at.l)),
                                 .allowed = limit / size,
                                 .expected = s.expected,
                                 .n = both_sides.index(s.at.v, s.at.l),
                                 .rest = same(s.part, 0) ? 0 : s.measured / s.part});
            }
            if (excess > worst) worst = excess, allowed = limit, at = s;
        }
        if (worst > 1) {
            r.add(property, {.passed = false,
                             .measured = at.measured,
                             .expected = at.expected,
                             .tolerance = allowed,
                             .input = at.at.text(),
                             .meaning = clue(wrong, wrong_ones, typical)});
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
        double measured = 0, expected = 0, deviation = 0, part = 0;
        std::size_t channel = 0;
        place<T> at{};
    };

    static double lowest_cosine(const place<T>& at) {
        const auto cosine = [&](const vec3<T>& w) { return std::abs(static_cast<double>(w.z)); };
        return (std::min)(at.has_v ? cosine(at.v) : 1.0, at.has_l ? cosine(at.l) : 1.0);
    }

    /// From what was measured: a factor, a clamp, a floor, how much of all places is concerned.
    std::string clue(const std::vector<ratio_at>& wrong, const std::vector<suspect>& ones, double typical) {
        for (const suspect& s : ones) of_bsdf.is_wrong(s.at);
        return of_bsdf.text() + clue_of_parts(wrong, ones, typical);
    }
    std::string clue_of_parts(const std::vector<ratio_at>& wrong, const std::vector<suspect>& ones,
                              double typical) const {
        const double share = of_bsdf.share();
        if (std::string power = wrong_power_of_index(wrong); !power.empty()) return power;
        if (std::string factor = wrong_factor(wrong, share); !factor.empty()) return factor;
        if (std::string epsilon = added_epsilon(wrong); !epsilon.empty()) return epsilon;
        std::size_t clamped = 0;
        double below = 0;
        for (const suspect& s : ones) {
            clamped += !same(s.part, 0) && std::abs(s.part - ones.front().part) < 1e-6 * std::abs(s.part);
            below = (std::max)(below, lowest_cosine(s.at));
        }
        if (ones.size() >= 8 && 10 * clamped >= 9 * ones.size())
            return otherwise + ": it is " + number(ones.front().part) + " wherever that fails, a clamp";
        std::size_t above = 0;
        for (const double c : lowest_cosines.kept) above += c > below;
        const bool far_above = 3 * above > lowest_cosines.kept.size();
        if (far_above && below < 0.1 && ones.size() >= 3)
            return "only where n.v or n.l is below " + number(below, 2) + " (" + percent(below) +
                   " of all directions): a floor of a cosine, max(n.v, epsilon), or an epsilon added to one" +
                   (below < 2e-3 ? "" : "; else " + otherwise);
        if (typical > 0.01 || (typical > tolerance && share < 0.5))
            return otherwise + "; rounding moves the value by " + percent(typical) +
                   " there: a cancellation, 1 - c*c or c*c*(a*a - 1) + 1?";
        return otherwise + ", at " + percent(share) + " of the places looked at";
    }

    void keep_largest() {
        std::sort(largest.begin(), largest.end(),
                  [](const suspect& a, const suspect& b) { return a.deviation > b.deviation; });
        if (largest.size() > worst_kept) largest.resize(worst_kept);
    }

    property_id property;
    double tolerance;
    std::string otherwise;
    sides both_sides;
    parts of_bsdf;
    long count = 0, none = 0;
    place<T> none_at{};
    double none_value = 0;
    thinned<double> lowest_cosines;
    suspect close{.deviation = -1};
    std::vector<suspect> largest;
    thinned<suspect> spread;
    thinned<double> ratios;
};

}  // namespace lobe::testkit::detail
