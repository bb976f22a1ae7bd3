#pragma once

#include "bake.hpp"

#include <optional>

#include <lobe/ibl/environment_sampler.hpp>

/// What a reference looks up: the map itself, and its lights to sample, if it has any that are brighter than the rest.
struct reference_map {
    const lobe::latlong<float>& radiance;
    std::optional<lobe::environment_sampler<lobe::latlong<float>>> lights;

    explicit reference_map(const lobe::latlong<float>& environment);
};
