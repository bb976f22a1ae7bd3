// One number a view that ought to be equal to, or at most, another.
#pragma once

#include <lobe/testkit/measure/numbers.hpp>
#include <lobe/testkit/measure/sides.hpp>
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
    double rounding = 0;  // relative, what is allowed for it
    vec3<double> v{};
    std::string input{};
};

enum class relation { equal, at_most };

/// One number a view that ought to be equal to, or at most, another.
class per_view {
public:
    per_view(const property_id& of, std::string meaning, relation how = relation::equal,
             std::string meaning_if_too_small = "")
        : property(of), otherwise(std::move(meaning)), too_small(std::move(meaning_if_too_small)),
          upper_bound(how == relation::at_most) {}

    /// result_of(doubted): where it fails, integrals are asked for a second time, by chance, and both have to fail; but
    /// for integrals with a pole, of which chance knows nothing. Once it is certain of three views, the first opinion
    /// will do.
    void add(const std::function<view_result(bool doubted)>& result_of) {
        view_result one = result_of(false);
        if (excess_of(one) > 1 && wrong.size() < 3) {
            const view_result second = result_of(true);
            const double gross = 0.3 * (std::max)(1.0, std::abs(one.expected));
            const bool has_a_pole = second.allowed > gross && off(one) > gross;
            if (!(excess_of(second) > 1) && !has_a_pole) one = second;
        }
        add(one);
    }
    void add(const view_result& one) {
        const double excess = excess_of(one), cosine = std::abs(one.v.z);
        if (excess > 1) {
            wrong.push_back({.ratio = ratio_of(one.measured, one.expected),
                             .v = upward(one.v),
                             .l = {0, 0, 1},
                             .allowed = one.allowed / (std::max)(1e-30, std::abs(one.expected))});
            lowest_wrong = (std::min)(lowest_wrong, cosine), highest_wrong = (std::max)(highest_wrong, cosine);
            ++(one.v.z < 0 ? wrong_below : wrong_above);
        } else {
            lowest_right = (std::min)(lowest_right, cosine), highest_right = (std::max)(highest_right, cosine);
        }
        below += one.v.z < 0;
        ++count;
        most_rounding = (std::max)(most_rounding, one.rounding);
        if (excess > worst) worst = excess, result = one;
    }
    bool holds() const { return wrong.empty(); }
    void report_to(report& r) const {
        if (!count) return;
        r.add(property, {.passed = holds(),
                         .measured = result.measured,
                         .expected = result.expected,
                         .tolerance = result.allowed,
                         .input = result.input,
                         .meaning = holds() ? "" : clue()});
    }

private:
    std::string clue() const {
        if (below == 0 || below == count || (wrong_above > 0 && wrong_below > 0)) return clue_of_side();
        return (wrong_below ? "from below the surface alone: " : "from above the surface alone: ") + clue_of_side();
    }
    std::string clue_of_side() const {
        const double times = ratio_of(result.measured, result.expected),
                     share = static_cast<double>(wrong.size()) / seen();
        if (lacks_one_over_pi())
            return "the same albedo from everywhere, " + number(times, 3) +
                   ": a missing 1/pi (it is plausible once divided by pi), or an albedo above 1";
        if (std::string factor = wrong_factor(wrong, share); !factor.empty() && (!upper_bound || share > 0.9))
            return factor.starts_with("the same") ? factor + ", or the same number is added to all values" : factor;
        std::string why = result.measured < result.expected && !too_small.empty() ? too_small : otherwise;
        if (most_rounding > 0.01)
            why = "rounding moves it by up to " + percent(most_rounding) +
                  ": a cancellation, 1 - c*c or c*c*(a*a - 1) + 1 (is the same in double right?), or " + why;
        const std::string by = ", by up to " + percent(std::abs(times - 1));
        if (share > 0.9 && least_ratio() > 1.5)
            return number(least_ratio(), 3) + " times and more, from everywhere: a missing 1/pi, 1/2 or 1/4, or " + why;
        if (share > 0.99) return count > 1 ? "from everywhere" + by + ": " + why : why;
        if (highest_wrong < lowest_right)
            return "only at grazing, n.v at most " + number(highest_wrong, 2) + by + ": " + why;
        if (lowest_wrong > highest_right)
            return "only near the normal, n.v at least " + number(lowest_wrong, 2) + by + ": " + why;
        return why;
    }
    /// How many views there are of the sides from which it fails.
    int seen() const { return wrong_above > 0 && wrong_below > 0 ? count : wrong_below > 0 ? below : count - below; }
    double least_ratio() const {
        double least = 1e300;
        for (const ratio_at& r : wrong) least = (std::min)(least, r.ratio);
        return least;
    }
    double off(const view_result& one) const {
        return upper_bound ? one.measured - one.expected : std::abs(one.measured - one.expected);
    }
    double excess_of(const view_result& one) const {
        if (!is_finite(one.measured) || !is_finite(one.expected)) return 1e300;
        return one.allowed > 0 ? off(one) / one.allowed : off(one) > 0 ? 1e300 : 0;
    }
    /// A furnace that may be anything up to 1: pi times an albedo, from every view.
    bool lacks_one_over_pi() const {
        if (!upper_bound || wrong.size() < static_cast<std::size_t>(seen())) return false;
        const auto [low, high] = std::minmax_element(
            wrong.begin(), wrong.end(), [](const ratio_at& a, const ratio_at& b) { return a.ratio < b.ratio; });
        return high->ratio < 1.01 * low->ratio && low->ratio > 1.1 && high->ratio < 1.01 * std::numbers::pi;
    }

    property_id property;
    std::string otherwise, too_small;
    view_result result;
    bool upper_bound;
    double worst = -1e300;
    int count = 0, below = 0, wrong_above = 0, wrong_below = 0;
    std::vector<ratio_at> wrong;
    double most_rounding = 0;
    double lowest_wrong = 1e300, highest_wrong = -1e300, lowest_right = 1e300, highest_right = -1e300;
};

}  // namespace lobe::testkit::detail
