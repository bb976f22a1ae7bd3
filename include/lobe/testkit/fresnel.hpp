// The verdict on a Fresnel reflectance: `verify_fresnel(f)`.
#pragma once

#include <lobe/testkit/checks.hpp>

namespace lobe::testkit {

namespace detail {

template <class F, class T>
concept fresnel_fits = requires(const F f, const T cosine) {
    requires is_spectrum<std::remove_cvref_t<decltype(f(cosine))>>;
};

template <class F>
auto scalar_of_fresnel() {
    if constexpr (requires(const F f) { f(1.0); }) {
        using value = std::remove_cvref_t<decltype(std::declval<const F&>()(1.0))>;
        return scalar_of_spectrum<value>{};
    } else {
        return float{};
    }
}

template <class F>
class fresnel_judge {
    using T = decltype(scalar_of_fresnel<F>());
    using value = std::remove_cvref_t<decltype(std::declval<const F&>()(T{}))>;
    static constexpr std::size_t channels = spectrum<value>::size;
    using values = std::array<double, channels>;

public:
    fresnel_judge(const F& judged, const options& o) : f(judged), options_(o) {}

    report verdict() {
        report r = opened(options_);
        if (!r.passed()) return r;
        try {
            range(r);
            shape(r);
            average(r);
        } catch (const std::exception& e) {
            r.add({{"no exception", 1, 0, 0, literal(last), std::string("it threw: ") + e.what()}, false});
        } catch (...) {
            r.add({{"no exception", 1, 0, 0, literal(last), "it threw something that is no std::exception"}, false});
        }
        return r;
    }

private:
    values at(double cosine) {
        last = static_cast<T>(cosine);
        const value s = f(last);
        values out;
        for (std::size_t k = 0; k < channels; ++k) out[k] = spectrum<value>::get(s, k);
        return out;
    }

    void range(report& r) {
        constexpr double rounding = 16 * static_cast<double>(std::numeric_limits<T>::epsilon());
        const int n = options_.effort == effort::quick ? 20000 : 1000000;
        double low = 0, high = 1, not_finite = 0;
        T low_at{}, high_at{}, nan_at{};
        const auto look = [&](double cosine) {
            for (const double x : at(cosine)) {
                if (!std::isfinite(x)) not_finite = x, nan_at = last;
                if (x < low) low = x, low_at = last;
                if (x > high) high = x, high_at = last;
            }
        };
        for (int i = 0; i <= n; ++i) look(double(i) / n);
        for (double x = 1; x > 1e-12; x /= 3) look(x), look(1 - x);
        look(static_cast<double>(std::numeric_limits<T>::denorm_min()));
        const auto where = [](const char*, T x) { return "cosine = " + literal(x); };
        r.add({{"F is finite", not_finite, 0, 0, !equal(not_finite, 0.0) ? where("", nan_at) : "",
                "a 0/0, or the root or power of a negative number"},
               equal(not_finite, 0.0)});
        r.add({{"F is not negative", low, 0, rounding, where("", low_at), "a reflectance is at least 0"}, low >= -rounding});
        r.add({{"F is at most 1", high, 1, rounding, where("", high_at),
                "a reflectance is at most 1: the factor (1 - F0) is missing, or F90 is above 1"},
               high <= 1 + rounding});
    }

    void shape(report& r) {
        const values grazing = at(0), normal = at(1), close = at(1 - 1e-4), further = at(1 - 1e-3);
        constexpr double rounding = 16 * static_cast<double>(std::numeric_limits<T>::epsilon());
        std::size_t k = 0, steep = 0;
        double steepest = -1;
        for (std::size_t i = 0; i < channels; ++i) {
            if (grazing[i] - normal[i] < grazing[k] - normal[k]) k = i;
            // dF/dcos at 1, extrapolated from two steps: the quadratic term, which is there, cancels.
            const double slope = std::abs(10 * (normal[i] - close[i]) / 1e-4 - (normal[i] - further[i]) / 1e-3) / 9;
            if (slope > steepest) {
                steepest = slope;
                steep = i;
            }
        }
        r.add({{"F at grazing is at least F at normal", grazing[k], normal[k], rounding, "cosine = 0 and 1",
                "F falls towards grazing: F0 and F90 are swapped, or the power is of the cosine instead of 1 - cosine"},
               grazing[k] >= normal[k] - rounding});
        if (options_.flat_at_normal) {
            const double allowed = 0.02 + 20 * rounding / 1e-4;
            r.add({{"F is flat at normal incidence", steepest, 0, allowed, "cosine = 1 - 1e-4, channel " + std::to_string(steep),
                    "dF/dcos is 0 there for every bare interface: 1 - cosine^5 in the place of (1 - cosine)^5, or a power too low"},
                   steepest <= allowed});
        }
    }

    void average(report& r) {
        if constexpr (requires { f.average(); }) {
            using average_value = std::remove_cvref_t<decltype(f.average())>;
            mesh<channels> m(
                [&](double x, double) {  // u = x^2 (3 - 2x): both ends magnified
                    const double u = x * x * (3 - 2 * x);
                    values out = at(u);
                    for (double& v : out) v *= 2 * u * 6 * x * (1 - x);
                    return out;
                },
                32, 1, channels);
            m.refine(1e-5, channels, 100000);
            per_view same("average = 2 int F(u) u du", "average() belongs to another function, or lacks the weight of the cosine");
            for (std::size_t k = 0; k < channels; ++k)
                if (m.integral()[k] > 0 || k == 0)
                    same.add(spectrum<average_value>::get(f.average(), spectrum<average_value>::size == 1 ? 0 : k), m.integral()[k],
                             options_.tolerance * m.integral()[k] + m.error()[k], {0, 0, 1}, "channel " + std::to_string(k));
            same.report_to(r);
        }
    }

    const F& f;
    options options_;
    T last{};
};

}  // namespace detail

/// Judges any callable F(cos) of the cosine between the direction and the (micro)normal, a scalar or rgb; `average()`, its cosine-weighted
/// mean 2 int F(u) u du, where it exists.
template <class F>
[[nodiscard]] report verify_fresnel(const F& fresnel, const options& o = {}) {
    constexpr bool returns_a_spectrum = detail::fresnel_fits<F, double> || detail::fresnel_fits<F, float>;
    static_assert(returns_a_spectrum, "F(cosine) returns no spectrum: a number, a GLM vector, what has begin() and end(), or r, g, b");
    if constexpr (returns_a_spectrum)
        return detail::fresnel_judge<F>(fresnel, o).verdict();
    else
        return report(o.name);
}

}  // namespace lobe::testkit
