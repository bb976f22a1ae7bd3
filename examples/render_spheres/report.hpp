#pragma once

#include "font.hpp"
#include "render.hpp"

#include <iosfwd>
#include <string>
#include <vector>

/// The spheres of one light, as a table, as a labelled picture and as a linear one.
class report {
public:
    report(std::string title, const baked_light&, const settings&);

    void add(const material&, std::vector<sphere>);

    void print_errors(std::ostream&) const;
    /// Filmic, exposed for the light.
    image tone_mapped_page(const font&) const;
    /// Radiance 1 becomes a light grey and no curve bends the rest.
    image furnace_page(const font&) const;
    /// Radiance, the tiles alone: for each material the rows a, b, c and |b - c|.
    image linear() const;

private:
    struct result {
        material of;
        std::vector<sphere> spheres;  // one a roughness
    };
    std::string title;
    std::vector<float> roughnesses;
    int samples;
    float mean_radiance;  // of the light, over the sphere of directions
    std::vector<result> results;

    template <class Screen>
    image page(const font&, const std::string& note, const Screen& screen) const;
    std::string noise() const;
    float scale_end() const;
};
