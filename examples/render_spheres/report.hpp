#pragma once

#include "../common/font.hpp"
#include "render.hpp"

#include <iosfwd>
#include <string>
#include <vector>

/// What a way to compute a picture is called.
struct named {
    std::string name, detail;
};

/// The spheres of one light, as a table, as a labelled picture and as a linear one.
class report {
public:
    /// `truth` is what the ways are held against; `walks` a pixel.
    report(std::string title, std::vector<named> ways, named truth, const baked_light&, int walks);

    void add(std::string heading, std::vector<sphere>);

    void print_errors(std::ostream&) const;
    /// Filmic, exposed for the light.
    image tone_mapped_page(const font&) const;
    /// Radiance 1 becomes a light grey and no curve bends the rest.
    image furnace_page(const font&) const;
    /// Radiance, the tiles alone, in the rows of the page.
    image linear() const;

private:
    struct result {
        std::string heading;
        std::vector<sphere> spheres;  // one a roughness
    };
    std::string title;
    std::vector<named> ways;
    named truth;
    std::vector<float> roughnesses;
    int samples;
    float mean_radiance;  // of the light, over the sphere of directions
    std::vector<result> results;

    template <class Screen>
    image page(const font&, const std::string& note, const Screen& screen) const;
    std::string noise() const;
    float scale_end() const;
};
