// Other interfaces as the one that `verify` takes: functions apart, without the cosine, in world space.
#pragma once

#include <lobe/core/frame.hpp>
#include <lobe/testkit/subject/spectrum.hpp>

#include <array>
#include <type_traits>
#include <utility>

namespace lobe::testkit {

/// A BRDF made of functions: `functions{f_cos}`, `functions{f_cos, sample}`, `functions{f_cos, sample, pdf}`;
/// `no_sample` where there is none.
struct no_sample {};

namespace detail {

template <class Sample>
struct sampling_part {
    Sample draw;
    template <class V, class U>
    auto sample(const V& v, const U& u) const -> decltype(draw(v, u)) {
        return draw(v, u);
    }
};
template <class Pdf>
struct density_part {
    Pdf density;
    template <class V>
    auto pdf(const V& v, const V& l) const -> decltype(density(v, l)) {
        return density(v, l);
    }
};
// Without a function, without the name of one.
template <>
struct sampling_part<no_sample> {
    no_sample none;
};
template <>
struct density_part<no_sample> {
    no_sample none;
};

}  // namespace detail

template <class F, class Sample = no_sample, class Pdf = no_sample>
struct functions : detail::sampling_part<Sample>, detail::density_part<Pdf> {
    F f;

    explicit functions(F f_cos_of, Sample sample_of = {}, Pdf pdf_of = {})
        : detail::sampling_part<Sample>{std::move(sample_of)}, detail::density_part<Pdf>{std::move(pdf_of)},
          f(std::move(f_cos_of)) {}

    template <class V>
    auto f_cos(const V& v, const V& l) const -> decltype(f(v, l)) {
        return f(v, l);
    }
};

/// What such a `sample` returns: the light direction, f_cos/pdf, the density in 1/sr. A failed sample has pdf 0.
template <class S, class T>
struct sampled_light {
    vec3<T> l;
    S weight;
    T pdf;
};

/// f(v,l) without the cosine as f_cos(v,l) = f cos(theta_l), zero below the horizon: the numbers of the spectrum, which
/// need not know how to multiply. The type of the vectors is that of the call.
template <class F>
auto with_cosine(F f) {
    return [f = std::move(f)]<class T>(const vec3<T>& v, const vec3<T>& l) requires requires { f(v, l); }
    {
        using S = std::remove_cvref_t<decltype(f(v, l))>;
        if constexpr (detail::is_spectrum<S>) {  // else `verify` says so
            using number = detail::scalar_of_spectrum<S>;
            std::array<number, detail::spectrum<S>::size> out{};
            if (!(l.z > T(0) && v.z > T(0))) return out;
            const S s = f(v, l);
            for (std::size_t i = 0; i < out.size(); ++i)
                out[i] = static_cast<number>(detail::spectrum<S>::get(s, i)) * static_cast<number>(l.z);
            return out;
        }
    };
}

/// The order in which a function takes its directions.
enum class argument { n, v, l };

/// A function of world-space directions as one of tangent space: `in_world<argument::n, argument::l, argument::v>(f)`
/// calls f(n, l, v). The frame is fixed and oblique, so that no axis is special and n is not (0,0,1). `V` is the
/// function's own vector type.
template <argument... Order, class F>
auto in_world(F f) {
    return [f = std::move(f)]<class T>(const vec3<T>& v, const vec3<T>& l) requires requires(const vec3<T> w) {
        f((static_cast<void>(Order), w)...);
    }
    {
        const frame<T> at(normalize(vec3<T>(T(0.36), T(-0.48), T(0.8))));
        const vec3<T> world_v = at.to_world(v), world_l = at.to_world(l);
        const auto pick = [&](argument which) {
            return which == argument::n ? at.n : which == argument::v ? world_v : world_l;
        };
        return f(pick(Order)...);
    };
}

}  // namespace lobe::testkit
