#pragma once

#include "scene.hpp"

#include <lobe/ibl/environment_sampler.hpp>

/// Where light comes from, seen from a point, and the density of that choice, 1/sr; 0: no light was found.
struct light_sample {
    vec3 direction;
    float distance;
    vec3 radiance;
    float pdf;
};

/// Draws directions to the environment, to spheres and to triangles that emit. Keeps a reference to the scene.
class light_sampler {
public:
    explicit light_sampler(const scene&);
    light_sample sample(const vec3& point, const vec3& u) const;
    /// The density with which `sample` draws this direction to what the ray hits there; nothing: the environment.
    float pdf(const vec3& point, const vec3& direction, const std::optional<hit>&) const;

private:
    struct emitter {
        bool is_sphere;
        std::size_t primitive;
    };
    float probability(std::size_t i) const {
        return (up_to[i] - (i ? up_to[i - 1] : 0)) / up_to.back() * (1 - of_environment);
    }

    const scene& s;
    lobe::environment_sampler<lobe::latlong<float>> environment;
    std::vector<emitter> emitters;
    std::vector<float> up_to;  // sums of their power
    std::vector<std::size_t> of_sphere, of_triangle;
    float of_environment;  // its share of the samples
};
