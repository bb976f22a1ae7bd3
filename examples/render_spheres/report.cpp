#include "report.hpp"

#include "picture.hpp"
#include "sheet.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <ostream>
#include <sstream>

namespace {

constexpr std::array rows{&sphere::single,    &sphere::fdez_aguera,     &sphere::multiple,
                          &sphere::reference, &sphere::fdez_aguera_off, &sphere::multiple_off};

std::string text(double x, int digits) {
    std::ostringstream out;
    out << std::setprecision(digits) << x;
    return out.str();
}

std::string fixed(double x, int decimals) {
    std::ostringstream out;
    out << std::fixed << std::setprecision(decimals) << x;
    return out.str();
}

}  // namespace

report::report(std::string title_, const baked_light& light, const settings& set)
    : title(std::move(title_)), samples(set.samples), mean_radiance(mean_over_directions(light.pyramid.level(0))) {
    for (const auto& level : light.levels) roughnesses.push_back(level.roughness);
}

void report::add(const material& m, std::vector<sphere> spheres) { results.push_back({m, std::move(spheres)}); }

std::string report::noise() const {
    double sum = 0, largest = 0;
    int count = 0;
    for (const auto& r : results)
        for (const sphere& s : r.spheres) {
            sum += s.noise * s.noise;
            largest = std::max(largest, s.noise);
            ++count;
        }
    return "standard error of a pixel " + text(100 * std::sqrt(sum / count), 2) + " % rms, " + text(100 * largest, 2) +
           " % on the noisiest sphere";
}

void report::print_errors(std::ostream& out) const {
    const auto percent = [&](double x, int width) {
        const bool nothing = std::abs(x) < 0.5e-4;  // 0.00, without a sign
        out << std::setw(width) << fixed(nothing ? 0 : 100 * x, 2);
    };
    out << "\nerrors of energy against the random walk (d), in percent: " << title << "\n"
        << "(d): " << samples << " random walks a pixel, " << noise() << "\n"
        << "                    (a) single scattering      (b) Fdez-Aguera       (c) smith_multiscatter  noise of (d)\n"
        << "         roughness       mean     largest        mean     largest        mean     largest   rms, of a "
           "pixel\n";
    for (const auto& r : results) {
        out << r.of.name << "\n";
        for (std::size_t i = 0; i < r.spheres.size(); ++i) {
            const sphere& s = r.spheres[i];
            out << std::setw(18) << fixed(roughnesses[i], 2);
            percent(s.single_error.mean, 11);
            percent(s.single_error.largest, 12);
            percent(s.fdez_aguera_error.mean, 12);
            percent(s.fdez_aguera_error.largest, 12);
            percent(s.multiple_error.mean, 12);
            percent(s.multiple_error.largest, 12);
            percent(s.noise, 14);
            out << "\n";
        }
    }
    out << "mean: sum of the differences / sum of (d) over a sphere's pixels; largest: of a pixel, / mean of (d)\n"
        << std::flush;
}

/// 1, 2 or 5 times a power of ten, above all differences but the largest hundredth of them.
float report::scale_end() const {
    std::vector<float> all;
    for (const auto& r : results)
        for (const sphere& s : r.spheres)
            for (const auto off : {&sphere::fdez_aguera_off, &sphere::multiple_off})
                for (const vec3& d : (s.*off).pixels) all.push_back(mean_of_channels(d) / mean_radiance);
    const auto high = all.begin() + static_cast<std::ptrdiff_t>(0.99 * static_cast<double>(all.size()));
    std::nth_element(all.begin(), high, all.end());
    const float decade = std::pow(10.0f, std::floor(std::log10(std::max(*high, 1e-6f))));
    for (const float step : {1.0f, 2.0f, 5.0f})
        if (*high <= step * decade) return step * decade;
    return 10 * decade;
}

template <class Screen>
image report::page(const font& face, const std::string& note, const Screen& screen) const {
    sheet s;
    s.title = title;
    s.notes = {"(d): " + std::to_string(samples) + " random walks a pixel (Heitz et al. 2016), " + noise(), note};
    s.column_title = "roughness";
    for (const float r : roughnesses) s.columns.push_back(fixed(r, 2));
    s.scale_end = scale_end();
    s.scale_title = "(e), (f): difference of radiance, mean of r, g and b, in units of the light's mean radiance (" +
                    text(mean_radiance, 3) + ")";

    const float unit = 1 / (s.scale_end * mean_radiance);
    const std::array<const char*, rows.size()> labels{"(a) single scattering",
                                                      "(b) multiple scattering",
                                                      "(c) multiple scattering",
                                                      "(d) random walk",
                                                      "(e) |b − d|",
                                                      "(f) |c − d|"};
    std::array<const char*, rows.size()> details{"split sum",
                                                 "split sum; Fdez-Agüera 2019",
                                                 "split sum; smith_multiscatter",
                                                 "the reference",
                                                 "in false colours",
                                                 "in false colours"};
    for (const auto& r : results) {
        const vec3 f0 = r.of.f0;
        const std::string rgb =
            f0.x == f0.z ? text(f0.x, 2) : "(" + fixed(f0.x, 2) + ", " + fixed(f0.y, 2) + ", " + fixed(f0.z, 2) + ")";
        sheet::group group{r.of.name + ", F0 = " + rgb +
                               (r.of.albedo == vec3{0} ? "" : ", diffuse albedo " + text(r.of.albedo.x, 2)),
                           {}};
        details[0] = r.of.albedo == vec3{0} ? "split sum" : "split sum; kd = 1 − F(n·v)";
        for (std::size_t i = 0; i < rows.size(); ++i) {
            group.rows.push_back({labels[i], details[i], {}});
            for (const sphere& one : r.spheres) {
                image tile = one.*rows[i];
                for (vec3& c : tile.pixels) c = i >= 4 ? false_colour(mean_of_channels(c) * unit) : screen(c);
                group.rows.back().tiles.push_back(std::move(tile));
            }
        }
        s.groups.push_back(std::move(group));
    }
    return drawn(s, face);
}

image report::tone_mapped_page(const font& face) const {
    // a white matte sphere sends back the light's mean radiance, on average over it
    const float exposure = 0.5f / mean_radiance;
    return page(face,
                "(a) to (d): radiance × " + text(exposure, 3) +
                    " (0.5 / mean radiance of the light), ACES filmic curve (Narkowicz 2015), sRGB",
                [&](const vec3& c) { return tone_mapped(c, exposure); });
}

image report::furnace_page(const font& face) const {
    return page(
        face,
        "(a) to (d): radiance × 0.8, sRGB. A sphere that keeps all energy cannot be told from the light behind it.",
        [&](const vec3& c) { return as_it_is(c, 0.8f); });
}

image report::linear() const {
    const int tile = results.front().spheres.front().single.width;
    image all{tile * static_cast<int>(roughnesses.size()), tile * static_cast<int>(rows.size() * results.size())};
    int top = 0;
    for (const auto& r : results)
        for (const auto row : rows) {
            for (std::size_t i = 0; i < r.spheres.size(); ++i)
                paste(all, r.spheres[i].*row, static_cast<int>(i) * tile, top);
            top += tile;
        }
    return all;
}
