// What a wrong ratio usually means: factors that are lost or applied twice leave their mark on every value.
#pragma once

#include <lobe/core/vector.hpp>
#include <lobe/testkit/measure/numbers.hpp>
#include <lobe/testkit/measure/text.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace lobe::testkit::detail {

/// measured / expected, where, and how far from 1 it may be there.
struct ratio_at {
    double ratio = 1;
    vec3<double> v{}, l{};
    double allowed = 0, expected = 0;
    double n = 1;     // index of l over index of v
    double rest = 0;  // of a product, what is measured over its known part: of weight * pdf, the pdf
};
inline double ratio_of(double measured, double expected) {
    return std::abs(expected) > 1e-100 * std::abs(measured) ? measured / expected : measured < 0 ? -1e100 : 1e100;
}

/// The factor that is wrong: if all `looked_at` fail (or nearly all: 9 of 10), and by one and the same factor, or by
/// one that is known. A factor that is there in a few places only is no constant. Empty where there is none.
inline std::string wrong_factor(const std::vector<ratio_at>& ratios, double share_that_fails) {
    struct clue {
        double (*factor)(const vec3<double>& v, const vec3<double>& l);
        const char* meaning;
    };
    using D = const vec3<double>&;
    constexpr double pi = std::numbers::pi;
    static const clue clues[] = {
        {[](D, D) { return pi; }, "pi times too large: a missing 1/pi"},
        {[](D, D) { return 1 / pi; }, "pi times too small: 1/pi is applied twice, or one is too many"},
        {[](D, D) { return 2.0; }, "2 times too large: a factor 1/2 is missing"},
        {[](D, D) { return 0.5; }, "2 times too small: a factor 2 is missing"},
        {[](D, D) { return 4.0; }, "4 times too large: the 1/4 of the reflection, 1/(4 v.m), is missing"},
        {[](D, D) { return 0.25; }, "4 times too small: the 1/4 of the reflection, 1/(4 v.m), is applied twice"},
        {[](D, D) { return 2 * pi; }, "2 pi times too large: the density of the azimuth, 1/(2 pi), is missing"},
        {[](D, D) { return 1 / (2 * pi); },
         "2 pi times too small: the density of the azimuth, 1/(2 pi), is applied twice"},
        {[](D, D l) { return l.z; },
         "cos(theta_l) times the expected: that cosine is applied twice, or missing on the other side"},
        {[](D, D l) { return 1 / l.z; },
         "1/cos(theta_l) times the expected: that cosine is missing, or divided by twice"},
        {[](D, D l) { return 2 * l.z; },
         "2 cos(theta_l) times the expected: cosine-weighted directions are taken for uniform ones, or the reverse"},
        {[](D, D l) { return 0.5 / l.z; }, "1/(2 cos(theta_l)) times the expected: cosine-weighted directions are "
                                           "taken for uniform ones, or the reverse"},
        {[](D v, D) { return v.z; }, "cos(theta_v) times the expected: that cosine is applied once too often"},
        {[](D v, D) { return 1 / v.z; }, "1/cos(theta_v) times the expected: that cosine is missing"},
        {[](D v, D l) { return v.z / l.z; },
         "cos(theta_v)/cos(theta_l) times the expected: the function is symmetric as it is, so it lacks cos(theta_l)"},
        {[](D v, D l) { return l.z / v.z; },
         "cos(theta_l)/cos(theta_v) times the expected: cos(theta_l) is applied twice"},
        {[](D v, D l) { return length(v + l) / 2; },
         "v.m times the expected: the v.m of the Jacobian 1/(4 v.m) is applied once too often, or missing"},
        {[](D v, D l) { return 2 / length(v + l); },
         "1/(v.m) times the expected: the v.m of the Jacobian 1/(4 v.m) is missing, or applied twice"},
        {[](D v, D l) { return 2 * length(v + l); },
         "4 v.m times the expected: the density of m was not turned into one of l (divide by 4 v.m)"},
        {[](D v, D l) { return 0.5 / length(v + l); }, "1/(4 v.m) times the expected: that Jacobian is applied twice"},
        {[](D v, D l) { return (v.z + l.z) / length(v + l); },
         "cos(theta_m) times the expected: that cosine is applied once too often"},
        {[](D v, D l) { return length(v + l) / (v.z + l.z); },
         "1/cos(theta_m) times the expected: the density of normals is D cos(theta_m), that cosine is missing"},
    };
    if (ratios.size() < 3) return "";
    for (const clue& c : clues) {
        std::size_t agree = 0, telling = 0;
        for (const ratio_at& r : ratios) {
            const double factor = c.factor(r.v, r.l);
            agree += std::abs(r.ratio / factor - 1) < 0.01;
            telling += std::abs(factor - 1) > 0.03;
        }
        if (10 * agree >= 9 * ratios.size() && 2 * telling > ratios.size())
            return std::string(c.meaning) + (share_that_fails > 0.5
                                                 ? std::string()
                                                 : ", at " + percent(share_that_fails) + " of the places looked at");
    }
    // 1 and something, with what may be off anyway: a factor of 1.012 is the same as 1.0122, not as 1.003.
    std::vector<double> sorted;
    double loose = 0;
    for (const ratio_at& r : ratios) sorted.push_back(r.ratio), loose = (std::max)(loose, r.allowed);
    std::sort(sorted.begin(), sorted.end());
    const std::size_t n = sorted.size();
    const double low = sorted[n / 10], middle = sorted[n / 2], high = sorted[n - 1 - n / 10];
    const double same_within =
        (std::max)(0.01 * std::abs(middle - 1), (std::min)(0.25 * std::abs(middle - 1), loose / 4));
    if (high - low > same_within) return "";
    if (share_that_fails > 0.9) return "the same factor " + number(middle) + " wherever it fails: a constant is wrong";
    return "the same factor " + number(middle) + ", at " + percent(share_that_fails) +
           " of the places looked at: a constant of one part, or within one range of directions";
}

/// A power of the relative index that is there once too often, or missing, wherever it fails. Empty where there is
/// none.
inline std::string wrong_power_of_index(const std::vector<ratio_at>& ratios) {
    struct clue {
        double power;
        const char* meaning;
    };
    static constexpr clue clues[] = {
        {2, "(eta_l/eta_v)^2 times the expected: (eta_v/eta_l)^2, which radiance is scaled by, is missing, or is there "
            "and not meant (options.radiance, options.eta)"},
        {-2, "(eta_v/eta_l)^2 times the expected: that factor of radiance is applied twice, or of the Jacobian of the "
             "refracted half vector one too many"},
        {4, "(eta_l/eta_v)^4 times the expected: (eta_v/eta_l)^2, which radiance is scaled by, is upside down"},
        {-4, "(eta_v/eta_l)^4 times the expected: (eta_v/eta_l)^2, which radiance is scaled by, is upside down"},
        {1, "eta_l/eta_v times the expected: an index is missing, or one too many"},
        {-1, "eta_v/eta_l times the expected: an index is missing, or one too many"},
    };
    if (ratios.size() < 3) return "";
    for (const clue& c : clues) {
        std::size_t agree = 0, telling = 0;
        for (const ratio_at& r : ratios) {
            const double factor = std::exp(c.power * std::log(r.n));
            agree += std::abs(r.ratio / factor - 1) < 0.01;
            telling += std::abs(factor - 1) > 0.03;
        }
        if (10 * agree >= 9 * ratios.size() && 2 * telling > ratios.size()) return c.meaning;
    }
    return "";
}

/// An epsilon that is added to something, in a denominator or in a factor, shows: it is the same at all places. Empty
/// where there is none.
inline std::string added_epsilon(const std::vector<ratio_at>& ratios) {
    using R = const ratio_at&;
    // (x + epsilon)/x, or x/(x - epsilon) for a negative one
    static constexpr auto of = [](R r, double x) { return r.ratio > 1 ? (r.ratio - 1) * x : (1 - 1 / r.ratio) * x; };
    struct suspicion {
        double (*epsilon)(R);
        double (*to)(R);  // it varies, else a constant is wrong
        const char *if_positive, *if_negative;
    };
    static const suspicion all[] = {
        {[](R r) { return of(r, r.v.z * r.l.z); }, [](R r) { return r.v.z * r.l.z; },
         "n.v n.l, in a factor on the left, or a denominator on the right",
         "n.v n.l, in a denominator on the left, or a factor on the right"},
        {[](R r) { return of(r, r.v.z); }, [](R r) { return r.v.z; },
         "n.v, in a factor on the left, or a denominator on the right",
         "n.v, in a denominator on the left, or a factor on the right"},
        {[](R r) { return of(r, r.l.z); }, [](R r) { return r.l.z; },
         "n.l, in a factor on the left, or a denominator on the right",
         "n.l, in a denominator on the left, or a factor on the right"},
        {[](R r) { return of(r, length(r.v + r.l) / 2); }, [](R r) { return length(r.v + r.l) / 2; },
         "v.m, in a factor on the left, or a denominator on the right",
         "v.m, in a denominator on the left, or a factor on the right"},
        {[](R r) { return of(r, r.rest); }, [](R r) { return r.rest; }, "the pdf of a sample",
         "the pdf that a sample's weight is divided by"},
        {[](R r) { return (r.ratio - 1) * r.expected; }, [](R r) { return r.expected; }, "the left", "the right"},
        // f(v,l)/f(l,v) = (n.v + epsilon)/n.v n.l/(n.l + epsilon), or its inverse
        {[](R r) {
             const bool inverse = (r.ratio < 1) == (r.v.z < r.l.z);
             const double q = inverse ? r.ratio : 1 / r.ratio;
             return (inverse ? -1 : 1) * r.v.z * r.l.z * (1 - q) / (q * r.l.z - r.v.z);
         },
         [](R r) { return (std::min)(r.v.z, r.l.z); }, "n.v in a factor, or to n.l in a denominator",
         "n.v in a denominator, or to n.l in a factor"},
    };
    if (ratios.size() < 8) return "";
    std::string out;
    double least_spread = 0.1;
    for (const suspicion& s : all) {
        std::vector<double> epsilon, to;
        for (const ratio_at& r : ratios) epsilon.push_back(computable(s.epsilon(r))), to.push_back(s.to(r));
        std::sort(epsilon.begin(), epsilon.end());
        const auto [least, most] = std::minmax_element(to.begin(), to.end());
        const std::size_t n = ratios.size();
        const double middle = epsilon[n / 2], spread = (epsilon[n - 1 - n / 10] - epsilon[n / 10]) / std::abs(middle);
        if (!(*least > 0) || !(*most > 3 * *least) || !(spread < least_spread)) continue;
        least_spread = spread;
        out = "as if " + number(std::abs(middle), 2) + " were added to " + (middle > 0 ? s.if_positive : s.if_negative);
    }
    return out;
}

}  // namespace lobe::testkit::detail
