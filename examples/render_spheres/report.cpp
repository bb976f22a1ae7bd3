#include "report.hpp"

#include "../common/maps.hpp"
#include "../common/picture.hpp"
#include "sheet.hpp"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <ostream>
#include <sstream>
#include <utility>

namespace {

/// The pictures of a sphere in the order of the page's rows.
std::vector<const image*> pictures(const sphere& s) {
    std::vector<const image*> all;
    for (const image& way : s.ways) all.push_back(&way);
    all.push_back(&s.reference);
    for (const image& off : s.off) all.push_back(&off);
    return all;
}

/// (a), (b), (c) ...
std::string letter(std::size_t k) { return std::string("(") + static_cast<char>('a' + k) + ")"; }

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

report::report(std::string title_, std::vector<named> ways_, named truth_, const baked_light& light, int walks)
    : title(std::move(title_)), ways(std::move(ways_)), truth(std::move(truth_)), samples(walks),
      mean_radiance(mean_over_directions(light.pyramid.level(0))) {
    for (const auto& level : light.levels) roughnesses.push_back(level.roughness);
}

void report::add(std::string heading, std::vector<sphere> spheres) {
    results.push_back({std::move(heading), std::move(spheres)});
}

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
    const std::string last = letter(ways.size());
    out << "\nerrors of energy against " << last << ", " << truth.name << ", in percent: " << title << "\n"
        << last << ": " << samples << " walks a pixel, " << noise() << "\n"
        << std::setw(18) << "";
    for (std::size_t k = 0; k < ways.size(); ++k) out << std::setw(23) << letter(k) + " " + ways[k].name.substr(0, 18);
    out << std::setw(14) << "noise"
        << "\n"
        << std::setw(18) << "roughness";
    for (std::size_t k = 0; k < ways.size(); ++k) out << std::setw(11) << "mean" << std::setw(12) << "largest";
    out << std::setw(14) << "rms, a pixel"
        << "\n";
    for (const auto& r : results) {
        out << r.heading << "\n";
        for (std::size_t i = 0; i < r.spheres.size(); ++i) {
            const sphere& s = r.spheres[i];
            out << std::setw(18) << fixed(roughnesses[i], 2);
            for (const error_of_energy& error : s.errors) {
                percent(error.mean, 11);
                percent(error.largest, 12);
            }
            percent(s.noise, 14);
            out << "\n";
        }
    }
    out << "mean: sum of the differences / sum of " << last
        << " over a sphere's pixels; largest: of a pixel, / mean of " << last << "\n"
        << std::flush;
}

/// 1, 2 or 5 times a power of ten, above all differences but the largest hundredth of them.
float report::scale_end() const {
    std::vector<float> all;
    for (const auto& r : results)
        for (const sphere& s : r.spheres)
            for (const image& off : s.off)
                for (const vec3& d : off.pixels) all.push_back(mean_of_channels(d) / mean_radiance);
    const auto high = all.begin() + static_cast<std::ptrdiff_t>(0.99 * static_cast<double>(all.size()));
    std::nth_element(all.begin(), high, all.end());
    const float decade = std::pow(10.0f, std::floor(std::log10(std::max(*high, 1e-6f))));
    for (const float step : {1.0f, 2.0f, 5.0f})
        if (*high <= step * decade) return step * decade;
    return 10 * decade;
}

template <class Screen>
image report::page(const font& face, const std::string& note, const Screen& screen) const {
    const std::size_t shown = ways.size() + 1;  // then what the last two ways miss
    sheet s;
    s.title = title;
    s.notes = {letter(ways.size()) + ": " + std::to_string(samples) + " walks a pixel (Heitz et al. 2016), " + noise(),
               note};
    s.column_title = "roughness";
    for (const float r : roughnesses) s.columns.push_back(fixed(r, 2));
    s.scale_end = scale_end();
    s.scale_title = letter(shown) + ", " + letter(shown + 1) +
                    ": difference of radiance, mean of r, g and b, in units of the light's mean radiance (" +
                    text(mean_radiance, 3) + ")";

    const float unit = 1 / (s.scale_end * mean_radiance);
    std::vector<named> rows = ways;
    rows.push_back(truth);
    for (std::size_t k = ways.size() - 2; k < ways.size(); ++k)
        rows.push_back(
            {std::string("|") + static_cast<char>('a' + k) + " − " + static_cast<char>('a' + ways.size()) + "|",
             "in false colours"});
    for (const auto& r : results) {
        sheet::group group{r.heading, {}};
        for (std::size_t i = 0; i < rows.size(); ++i) {
            group.rows.push_back({letter(i) + " " + rows[i].name, rows[i].detail, {}});
            for (const sphere& one : r.spheres) {
                image tile = *pictures(one)[i];
                for (vec3& c : tile.pixels) c = i >= shown ? false_colour(mean_of_channels(c) * unit) : screen(c);
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
                "(a) to " + letter(ways.size()) + ": radiance × " + text(exposure, 3) +
                    " (0.5 / mean radiance of the light), ACES filmic curve (Narkowicz 2015), sRGB",
                [&](const vec3& c) { return tone_mapped(c, exposure); });
}

image report::furnace_page(const font& face) const {
    return page(face,
                "(a) to " + letter(ways.size()) +
                    ": radiance × 0.8, sRGB. A sphere that keeps all energy cannot be told from the light behind it.",
                [&](const vec3& c) { return as_it_is(c, 0.8f); });
}

image report::linear() const {
    const sphere& any = results.front().spheres.front();
    const int tile = any.reference.width;
    const std::size_t rows = pictures(any).size() * results.size();
    image all{tile * static_cast<int>(roughnesses.size()), tile * static_cast<int>(rows)};
    for (std::size_t g = 0; g < results.size(); ++g)
        for (std::size_t i = 0; i < results[g].spheres.size(); ++i) {
            const auto column = pictures(results[g].spheres[i]);
            for (std::size_t k = 0; k < column.size(); ++k)
                paste(all, *column[k], static_cast<int>(i) * tile, static_cast<int>(g * column.size() + k) * tile);
        }
    return all;
}
