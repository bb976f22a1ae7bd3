// The prefiltered environment of the split sum.
#pragma once

#include <lobe/core/frame.hpp>
#include <lobe/core/spectrum.hpp>
#include <lobe/ibl/cube.hpp>
#include <lobe/ndf/ggx.hpp>
#include <lobe/sampling/points.hpp>
#include <lobe/sampling/sample_mean.hpp>

#include <cassert>
#include <type_traits>
#include <vector>

namespace lobe {

/// The radiance that a GGX lobe seen head on collects around r: V = N = R, weighted with the cosine to r,
///   LD = sum L(l) (r.l) / sum (r.l),  l = reflect(r, m),  m by inverse CDF, pdf(l) = D(m)/4.
/// Karis 2013, "Real Shading in Unreal Engine 4"; it equals int D L (r.l) dl / int D (r.l) dl.
/// `environment`: any callable from a unit world direction to a radiance. One that also takes a solid angle in sr gets
/// the one of the sample, 4/(count pdf), and should return the mean over it: filtered importance sampling (Colbert &
/// Krivanek 2007, GPU Gems 3, chapter 20, with their bias of one level): far fewer samples, for a blur of that size.
/// r: unit, world space; count >= 1; alpha <= 1, where the first half vector at least reflects upwards.
/// Error: that of `count` Hammersley points; none for a constant environment.
template <scalar T, class Environment>
constexpr auto prefiltered_radiance(const Environment& environment, const vec3<T>& r, const alpha<T>& a,
                                    std::uint32_t count) {
    using S = std::decay_t<decltype(environment(r))>;
    using WS = detail::wide_t<S>;
    using W = detail::wide_t<T>;
    assert(count > 0 && "prefiltered_radiance: count must be above 0");
    const ggx<T> normals{a};
    const frame<T> at(r);
    WS total(W(0));
    W weights(0);
    for (std::uint32_t i = 0; i < count; ++i) {
        const vec3<T> m = normals.sample(hammersley<T>(i, count));
        const vec3<T> l = reflect(vec3<T>{T(0), T(0), T(1)}, m);
        const T weight = larger(l.z, T(0));
        if constexpr (std::is_invocable_v<const Environment&, const vec3<T>&, const T&>)
            total = total + WS(environment(at.to_world(l), T(16) / (T(count) * normals.D(m)))) * W(weight);
        else
            total = total + WS(environment(at.to_world(l))) * W(weight);
        weights += W(weight);
    }
    return S(total * (W(1) / weights));
}

/// The samples of `prefiltered_radiance` for one width, made once for all directions of a map: directions around
/// (0,0,1), weights, and the level of the pyramid that each reads.
template <scalar T>
class prefilter_samples {
public:
    /// count >= 1 samples, of which those that reflect downwards are left out; alpha <= 1.
    prefilter_samples(const cube_pyramid<T>& environment, const alpha<T>& a, std::uint32_t count) {
        assert(count > 0 && "prefilter_samples: count must be above 0");
        const ggx<T> normals{a};
        using W = detail::wide_t<T>;
        W total(0);
        for (std::uint32_t i = 0; i < count; ++i) {
            const vec3<T> m = normals.sample(hammersley<T>(i, count));
            const vec3<T> l = reflect(vec3<T>{T(0), T(0), T(1)}, m);
            if (!(l.z > T(0))) continue;
            taps.push_back({l, l.z, environment.level_of(T(16) / (T(count) * normals.D(m)))});
            total += W(l.z);
        }
        for (tap& t : taps) t.weight = T(W(t.weight) / total);
    }

    /// The prefiltered radiance around r, unit. A constant environment comes back as it is, to rounding.
    vec3<T> operator()(const cube_pyramid<T>& environment, const vec3<T>& r) const {
        const frame<T> at(r);
        vec3<T> total(T(0));
        for (const tap& t : taps) total += environment.at_level(at.to_world(t.l), t.level) * t.weight;
        return total;
    }
    /// ... and how much the samples differ: sqrt(sum w^2 (L - LD)^2), of the mean of rgb. Of random samples it would be
    /// the standard error; these are spread evenly, and err less.
    sampled<vec3<T>> estimate(const cube_pyramid<T>& environment, const vec3<T>& r) const {
        using std::sqrt;
        const frame<T> at(r);
        vec3<T> total(T(0));
        T squares(0), cross(0), weights(0);
        for (const tap& t : taps) {
            const vec3<T> L = environment.at_level(at.to_world(t.l), t.level);
            const T mean = (L.x + L.y + L.z) / T(3), w2 = t.weight * t.weight;
            total += L * t.weight;
            squares += w2 * mean * mean;
            cross += w2 * mean;
            weights += w2;
        }
        const T mean = (total.x + total.y + total.z) / T(3);
        const T variance = larger(squares - T(2) * mean * cross + mean * mean * weights, T(0));
        return {total, vec3<T>(sqrt(variance))};
    }

private:
    struct tap {
        vec3<T> l;
        T weight, level;
    };
    std::vector<tap> taps;
};

/// Roughness of a level of a prefiltered chain: even steps from 0, the image itself, to 1 at the last, as most engines
/// have them.
template <scalar T>
constexpr T roughness_of_level(const T& level, int levels) {
    return level / T(levels - 1);
}
template <scalar T>
constexpr T level_of_roughness(const T& roughness, int levels) {
    return roughness * T(levels - 1);
}

/// A prefiltered environment: cubes from the image itself at roughness 0 to roughness 1, each half as wide.
template <scalar T>
class prefiltered_chain {
public:
    explicit prefiltered_chain(std::vector<cube<T>> from_smooth_to_rough) : levels(std::move(from_smooth_to_rough)) {
        assert(!levels.empty() && "prefiltered_chain: at least one level");
    }

    /// Radiance around r for a roughness in [0,1], interpolated between levels.
    vec3<T> operator()(const vec3<T>& r, const T& roughness) const {
        const int count = static_cast<int>(levels.size());
        const T at = smaller(larger(T(0), level_of_roughness(roughness, count)), T(count - 1));
        const auto low = static_cast<std::size_t>(at), high = (std::min)(low + 1, levels.size() - 1);
        const T t = at - T(static_cast<int>(low));
        return levels[low](r) * (T(1) - t) + levels[high](r) * t;
    }

    const cube<T>& level(std::size_t i) const { return levels[i]; }
    std::size_t size() const { return levels.size(); }

private:
    std::vector<cube<T>> levels;
};

struct prefilter_options {
    int smallest = 8;            // the last level's size
    std::uint32_t count = 1024;  // samples a texel
    double tolerance = 0;  // where samples differ by more than this part of their mean, 16 times as many; 0: never
};

/// Makes the chain of an environment: its image, then level by level for its roughness, half as wide each, down to
/// `smallest`. `for_each_row(rows, g)`: calls g(row) for each of so many rows, in any order, perhaps on many threads.
template <scalar T, class ForEachRow>
prefiltered_chain<T> prefilter(const cube_pyramid<T>& environment, const prefilter_options& options,
                               const ForEachRow& for_each_row) {
    assert(options.smallest > 0 && options.count > 0 && "prefilter: size and count must be above 0");
    std::vector<cube<T>> levels{environment.level(0)};
    int count = 1;
    while ((environment.level(0).size() >> count) >= options.smallest) ++count;
    for (int level = 1; level < count; ++level) {
        const int size = environment.level(0).size() >> level;
        const auto a = alpha<T>::from_roughness(roughness_of_level(T(level), count));
        const prefilter_samples<T> samples(environment, a, options.count);
        const prefilter_samples<T> more(environment, a, options.tolerance > 0 ? 16 * options.count : 1);
        const auto filtered = [&](const vec3<T>& r) {
            if (!(options.tolerance > 0)) return samples(environment, r);
            const sampled<vec3<T>> e = samples.estimate(environment, r);
            const T mean = (e.value.x + e.value.y + e.value.z) / T(3);
            return e.standard_error.x > T(options.tolerance) * mean ? more(environment, r) : e.value;
        };
        std::vector<vec3<T>> pixels(6 * static_cast<std::size_t>(size) * static_cast<std::size_t>(size));
        for_each_row(6 * size, [&](int row) {
            for (int column = 0; column < size; ++column) {
                const vec2<T> uv{(T(column) + T(0.5f)) / T(size), (T(row % size) + T(0.5f)) / T(size)};
                pixels[static_cast<std::size_t>(row) * static_cast<std::size_t>(size) +
                       static_cast<std::size_t>(column)] = filtered(cube_direction(row / size, uv));
            }
        });
        levels.push_back(cube<T>(size, pixels));
    }
    return prefiltered_chain<T>(std::move(levels));
}
template <scalar T>
prefiltered_chain<T> prefilter(const cube_pyramid<T>& environment, const prefilter_options& options = {}) {
    return prefilter(environment, options, [](int rows, const auto& g) {
        for (int row = 0; row < rows; ++row) g(row);
    });
}

}  // namespace lobe
