// One number a view that ought to be equal to, or at most, another.
#pragma once

#include <lobe/testkit/verdict/diagnosis.hpp>
#include <lobe/testkit/verdict/report.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace lobe::testkit::detail {

/// What was found from one view, and what ought to be: `allowed` is absolute.
struct view_result {
    double measured = 0, expected = 0, allowed = 0;
    vec3<double> v{};
    std::string input{};
};

enum class relation { equal, at_most };

/// One number a view that ought to be equal to, or at most, another.
class per_view {
public:
    per_view(const property_id& of, std::string meaning, relation how = relation::equal, std::string meaning_if_too_small = "")
        : property(of), otherwise(std::move(meaning)), too_small(std::move(meaning_if_too_small)), upper_bound(how == relation::at_most) {}

    /// result_of(doubted): where it fails, integrals are asked for a second time, by chance, and both have to fail; but for integrals with a
    /// pole, of which chance knows nothing. Once it is certain of three views, the first opinion will do.
    void add(const std::function<view_result(bool doubted)>& result_of) {
        view_result one = result_of(false);
        if (excess_of(one) > 1 && wrong.size() < 3) {
            const view_result second = result_of(true);
            const double gross = 0.3 * std::abs(one.expected);
            const bool has_a_pole = second.allowed > gross && off(one) > gross;
            if (!(excess_of(second) > 1) && !has_a_pole) one = second;
        }
        add(one);
    }
    void add(const view_result& one) {
        const double excess = excess_of(one);
        if (excess > 1) wrong.push_back({one.measured / one.expected, one.v, {0, 0, 1}});
        ++count;
        if (excess > worst) worst = excess, result = one;
    }
    bool holds() const { return wrong.empty(); }
    void report_to(report& r) const {
        if (!count) return;
        std::string meaning;
        if (!holds())
            meaning = lacks_one_over_pi() ? "the same albedo from everywhere, plausible once divided by pi: a missing 1/pi"
                                          : explain(wrong, result.measured < result.expected && !too_small.empty() ? too_small : otherwise);
        r.add(property, {.passed = holds(),
                         .measured = result.measured,
                         .expected = result.expected,
                         .tolerance = result.allowed,
                         .input = result.input,
                         .meaning = std::move(meaning)});
    }

private:
    double off(const view_result& one) const {
        return upper_bound ? one.measured - one.expected : std::abs(one.measured - one.expected);
    }
    double excess_of(const view_result& one) const { return one.allowed > 0 ? off(one) / one.allowed : off(one) > 0 ? 1e300 : 0; }
    /// A furnace that may be anything up to 1: pi times an albedo, from every view.
    bool lacks_one_over_pi() const {
        if (!upper_bound || wrong.size() < static_cast<std::size_t>(count)) return false;
        const auto [low, high] =
            std::minmax_element(wrong.begin(), wrong.end(), [](const ratio_at& a, const ratio_at& b) { return a.ratio < b.ratio; });
        return high->ratio < 1.01 * low->ratio && low->ratio > 1.1 && high->ratio < 1.01 * std::numbers::pi;
    }

    property_id property;
    std::string otherwise, too_small;
    view_result result;
    bool upper_bound;
    double worst = -1e300;
    int count = 0;
    std::vector<ratio_at> wrong;
};

}  // namespace lobe::testkit::detail
