// Samples that go where they cannot be right: it explains whatever else is found of them.
#pragma once

#include <lobe/testkit/verdict/property.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>

namespace lobe::testkit::detail {

inline constexpr const char* most_are_lost = "most samples fail or point below the horizon: -l in the place of l (the "
                                             "reflect(i, m) of GLSL and GLM wants i = -v), or light that is "
                                             "transmitted: then say so, options.transmits = true";
inline constexpr const char* seems_to_transmit =
    "it scatters light below the surface, and samples it there: a BSDF has "
    "to say so, `static constexpr bool transmits = true`, or "
    "options.transmits = true";

template <class T, std::size_t N>
class stray_samples : public brdf_property<T, N> {
public:
    using typename brdf_property<T, N>::values, typename brdf_property<T, N>::sample,
        typename brdf_property<T, N>::view;
    using brdf_property<T, N>::brdf_property;

    /// Where the weight is another one: is it that of the direction turned, as by a wrong reflection?
    void at_sample(const sample& one) override {
        const auto is = [&](const values& g) {
            for (std::size_t k = 0; k < N; ++k)
                if (!is_finite(g[k]) || !(std::abs(one.s.weight[k] * one.s.pdf - g[k]) <= 0.02 * g[k])) return false;
            return true;
        };
        if (turned == 1000 || is(one.f)) return;
        ++turned;
        for (std::size_t i = 0; i < std::size(turns); ++i)
            turned_right[i] +=
                is(this->b.raw.f_cos(one.v, {T(turns[i].x) * one.s.l.x, T(turns[i].y) * one.s.l.y, one.s.l.z}));
    }

    void at_view(const view& from) override {
        for (const auto& p : from.some)
            one_direction = (std::max)(
                one_direction, static_cast<double>(std::count(from.some.begin(), from.some.end(), p)) / from.asked);
    }

    /// Explains what is about samples; reports nothing of its own.
    void report_to(report&) override {}
    std::string clue() const {
        if (one_direction > 0.1)
            return percent(one_direction) + " of the samples from one v are one and the same direction: a "
                                            "perfect mirror, or a lobe without width, which no "
                                            "density describes; give it a small roughness, or leave it out";
        if (this->b.seems_to_transmit()) return seems_to_transmit;
        if (this->b.most_samples_are_lost()) return most_are_lost;
        for (std::size_t i = 0; i < std::size(turns); ++i)
            if (turned >= 20 && 10 * turned_right[i] > 9 * turned)
                return std::string("the weights fit l = ") + turns[i].name +
                       " of the samples returned: they are reflected about another axis";
        return "";
    }

private:
    struct axis_change {
        const char* name;
        int x, y;
    };
    static constexpr axis_change turns[] = {{"(-x, -y, z)", -1, -1}, {"(-x, y, z)", -1, 1}, {"(x, -y, z)", 1, -1}};

    double one_direction = 0;  // the largest share of samples from one view that are equal
    long turned = 0, turned_right[std::size(turns)] = {};
};

}  // namespace lobe::testkit::detail
