// Where two functions differ: by how much, at which input most, and at which share of the places.
#pragma once

#include <lobe/testkit/compare/side_by_side.hpp>
#include <lobe/testkit/verdict/comparison.hpp>
#include <lobe/testkit/verdict/report.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace lobe::testkit::detail {

/// The rows of one function: its values, and the share of the places at which they differ.
struct rows_of_function {
    property_id values, share;
};

template <class T, std::size_t N>
class differences {
public:
    differences(const rows_of_function& of, double relative, side_by_side<T, N> two)
        : both(std::move(two)), rows(of), tolerance(relative),
          pairs(of.values, relative, "a and b are different formulas") {}

    /// `counts`: the place is one of those, evenly spread, of which the share is told.
    void look(const place<T>& at, bool counts) {
        const auto a = both.a(at), b = both.b(at);
        bool differs = false;
        std::size_t channel = 0;
        for (std::size_t k = 0; k < N; ++k) {
            if (!is_finite(a[k]) && !is_finite(b[k])) continue;
            pairs.add(a[k], b[k], at, k);
            const double size = (std::max)(std::abs(a[k]), std::abs(b[k]));
            any |= size > 0;
            if (!(std::abs(a[k] - b[k]) > tolerance * size)) continue;
            differs = true;
            channel = k;
        }
        if (!counts) return;
        ++counted;
        if (!differs) return;
        ++differing;
        suspects.add({at, channel});
    }

    /// input(place): how it reads in the report.
    template <class Input>
    void report_to(report& r, const Input& input) {
        if (!any) {
            r.add(rows.values,
                  {.passed = false, .meaning = "both are 0, or no numbers, everywhere: nothing is compared"});
            return;
        }
        std::vector<where> asked;
        report found("");
        pairs.report_to(found, [&](const place<T>& at, std::size_t k) {
            asked.push_back({at, k});
            return both.noise(at, k);
        });
        for (check c : found.checks()) {
            if (!c.passed) explain(c, asked, input);
            r.add(std::move(c));
        }
        const double share = share_that_differs();
        r.add(rows.share, {.passed = !(share > 0), .measured = share});
    }

private:
    struct where {
        place<T> at{};
        std::size_t channel = 0;
    };

    template <class Input>
    void explain(check& c, const std::vector<where>& asked, const Input& input) const {
        for (const where& w : asked) {
            if (w.at.text() != c.input) continue;
            c.input = input(w.at);
            const double apart = std::abs(c.measured - c.expected);
            if (apart <= 4 * both.noise_of_coarser(w.at, w.channel))
                c.meaning = std::string("cancellation: rounding alone moves the value of ") +
                            (both.a_is_finer ? "b" : "a") +
                            ", in float, by as much, and that of the other, in double, by " +
                            percent(both.noise(w.at, w.channel) / std::abs(c.expected)) + "; right in double";
            break;
        }
        if (!same(c.expected, 0) && is_finite(c.measured / c.expected))
            c.meaning = "a is " + percent(std::abs(c.measured / c.expected - 1)) +
                        (c.measured / c.expected > 1 ? " above" : " below") + " b there; " + c.meaning;
    }

    /// Of those that differ, 128 are asked whether rounding explains it.
    double share_that_differs() const {
        const std::size_t step = std::max<std::size_t>(1, suspects.kept.size() / 128);
        double asked = 0, confirmed = 0;
        for (std::size_t i = 0; i < suspects.kept.size(); i += step) {
            const auto& [at, k] = suspects.kept[i];
            const double a = both.a(at)[k], b = both.b(at)[k], size = (std::max)(std::abs(a), std::abs(b));
            ++asked;
            confirmed += size > comparison<T>::smallest && std::abs(a - b) > tolerance * size + 4 * both.noise(at, k);
        }
        return confirmed > 0 ? static_cast<double>(differing) / static_cast<double>(counted) * confirmed / asked : 0;
    }

    side_by_side<T, N> both;
    rows_of_function rows;
    double tolerance;
    comparison<T> pairs;
    bool any = false;
    long counted = 0, differing = 0;
    thinned<where> suspects;
};

}  // namespace lobe::testkit::detail
