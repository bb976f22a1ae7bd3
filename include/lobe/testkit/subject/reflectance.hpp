// A stranger's Fresnel reflectance before the judge.
#pragma once

#include <lobe/testkit/measure/numbers.hpp>
#include <lobe/testkit/options.hpp>
#include <lobe/testkit/subject/spectrum.hpp>

#include <array>
#include <functional>
#include <type_traits>
#include <utility>

namespace lobe::testkit::detail {

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

/// A stranger's functions, those that exist.
template <class T, std::size_t N>
struct fresnel_functions {
    std::function<std::array<double, N>(T cosine)> at;
    std::function<std::array<double, N>()> average;
};

template <class F>
auto interface_of_fresnel(const F& f) {
    using T = decltype(scalar_of_fresnel<F>());
    constexpr std::size_t N = spectrum<std::remove_cvref_t<decltype(f(T{}))>>::size;
    fresnel_functions<T, N> out;
    out.at = [&f](T cosine) { return as_values<N>(f(cosine)); };
    if constexpr (requires { f.average(); }) out.average = [&f] { return as_values<N>(f.average()); };
    return out;
}

template <class T, std::size_t N>
struct reflectance {
    const fresnel_functions<T, N> raw;
    const options claims;
    T last{};  // where it was asked for
    long not_finite = 0;
    double none = 0;  // the first that is no number
    T none_at{};

    std::array<double, N> at(double cosine) {
        last = static_cast<T>(cosine);
        auto out = raw.at(last);
        for (double& x : out) {
            if (!is_finite(x) && !not_finite++) none = x, none_at = last;
            x = computable(x);
        }
        return out;
    }
};

}  // namespace lobe::testkit::detail
