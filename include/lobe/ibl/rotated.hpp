// An environment turned, and its brightest light dimmed: by name, where it is loaded.
#pragma once

#include <lobe/core/spectrum.hpp>
#include <lobe/core/vector.hpp>

namespace lobe {

/// A rotation of the world by its images of the axes: unit and orthogonal.
template <scalar T>
struct rotation {
    vec3<T> x, y, z;

    /// By so many turns about the y axis, which is up: from z to x.
    static constexpr rotation about_up(const T& turns) {
        using std::cos, std::sin;
        const T phi = turns * T(2) * pi<T>(), s = sin(phi), c = cos(phi);
        return {{c, T(0), -s}, {T(0), T(1), T(0)}, {s, T(0), c}};
    }
    constexpr vec3<T> forward(const vec3<T>& w) const { return x * w.x + y * w.y + z * w.z; }
    constexpr vec3<T> back(const vec3<T>& w) const { return {dot(w, x), dot(w, y), dot(w, z)}; }
};

/// The environment, turned. Keeps a reference.
template <scalar T, class Environment>
class rotated {
public:
    constexpr rotated(const Environment& environment, const rotation<T>& by) : still(environment), turn(by) {}
    constexpr auto operator()(const vec3<T>& w) const { return still(turn.back(w)); }

private:
    const Environment& still;
    rotation<T> turn;
};

/// Radiance whose mean of rgb is at most `limit`, its colour kept: what a sun that is sampled too rarely needs. It
/// loses energy; no look-up does it silently.
template <scalar T>
constexpr vec3<T> dimmed(const vec3<T>& radiance, const T& limit) {
    const T mean = (radiance.x + radiance.y + radiance.z) / T(3);
    return radiance * select(mean > limit, limit / select(mean > limit, mean, T(1)), T(1));
}

}  // namespace lobe
