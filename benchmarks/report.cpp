#include "report.hpp"

#include "table.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <optional>
#include <set>
#include <sstream>
#include <stdexcept>

namespace {

std::string formatted(const char* format, double x) {
    char text[32];
    std::snprintf(text, sizeof text, format, x);
    return text;
}

/// Three digits, no exponent.
std::string nanoseconds(std::optional<double> ns) {
    if (!ns) return "";
    return formatted(*ns < 10 ? "%.2f" : *ns < 100 ? "%.1f" : "%.0f", *ns);
}
std::string error(double e) {
    if (std::isnan(e)) return "";
    return e == std::floor(e) ? formatted("%.0f", e) : formatted("%.1e", e);
}
std::string ratio(std::optional<double> r) { return r ? formatted("%.2f", *r) : ""; }

std::string processor() {
    std::ifstream info("/proc/cpuinfo");
    for (std::string line; std::getline(info, line);)
        if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
    return "unknown";
}

const std::string compiler =
#ifdef __clang__
    "clang++ " + std::to_string(__clang_major__) + "." + std::to_string(__clang_minor__);
#else
    std::string("g++ ") + __VERSION__;
#endif

/// What the places of the template are filled with.
using contents = std::map<std::string, std::optional<std::string>>;

/// The template with every @place@ filled; `@table@` is that of the heading above it. A line with a place that has
/// nothing is left out.
std::string filled(const std::string& text, const contents& values) {
    std::istringstream lines(text);
    std::string all, title;
    std::set<std::string> used;
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("## ")) title = line.substr(3);
        bool whole = true;
        for (std::size_t from = 0; (from = line.find('@', from)) != std::string::npos;) {
            const std::size_t to = line.find('@', from + 1);
            if (to == std::string::npos) throw std::runtime_error("the template has half a place: " + line);
            std::string place = line.substr(from + 1, to - from - 1);
            if (place == "table") place = title;
            const auto found = values.find(place);
            if (found == values.end())
                throw std::runtime_error("the template has a place that nothing fills: " + place);
            used.insert(place);
            whole &= found->second.has_value();
            const std::string with = found->second.value_or("");
            line.replace(from, to + 1 - from, with);
            from += with.size();
        }
        if (whole) all += line + '\n';
    }
    for (const auto& [place, value] : values)
        if (!used.contains(place)) throw std::runtime_error("the template has no place for: " + place);
    return all;
}

std::string text_of(const table& t) {
    std::ostringstream text;
    text << t;
    std::string all = text.str();
    all.pop_back();  // the template has the end of the line
    return all;
}

/// GitHub's links to headings.
std::string links(const std::vector<section>& sections) {
    std::string all;
    for (const section& s : sections) {
        std::string anchor;
        for (const char c : s.title)
            if (std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '-')
                anchor += static_cast<char>(std::tolower(c));
            else if (c == ' ')
                anchor += '-';
        all += (all.empty() ? "[" : " | [") + s.title + "](#" + anchor + ')';
    }
    return all;
}

class writer {
public:
    writer(const std::vector<section>& of_foundation, const std::vector<section>& of_models,
           const measurements& results)
        : foundation(of_foundation), models(of_models), measured(results) {}

    contents all() const {
        contents values{{"processor", processor()},
                        {"compiler", compiler},
                        {"flags", BENCH_FLAGS},
                        {"count", std::to_string(count)},
                        {"links to the foundation", links(foundation)},
                        {"links to the models", links(models)},
                        {"summary", summary()},
                        {"ns of a call", nanoseconds(time("nothing", "/one"))},
                        {"ns of a number", nanoseconds(time("nothing", "/loop"))},
                        {"typical spread", spread(0.5)},
                        {"worst spread", spread(1)},
                        {"AVX2 factor", {}},
                        {"AVX2 worst", {}}};
        for (const auto* sections : {&foundation, &models})
            for (const section& s : *sections) values[s.title] = of(s);
        compare(values, "one at a time", "/one");
        compare(values, "loop", "/loop");
        compare(values, "AVX2", "/avx2");
        if (measured.avx2) {
            values["AVX2 factor"] = formatted("%.2g", measured.avx2_factor);
            values["AVX2 worst"] = measured.avx2_worst;
        }
        return values;
    }

private:
    std::optional<double> time(const std::string& name, const char* how) const {
        const auto found = measured.times.find(name + how);
        if (found == measured.times.end()) return {};
        return found->second.ns / static_cast<double>(count);
    }

    /// lobe's time over that of the textbook form of the same.
    std::optional<double> time_ratio(const section& s, const char* how) const {
        const auto lobe = time(s.rows[0].name, how), textbook = time(s.rows[1].name, how);
        if (!lobe || !textbook) return {};
        return *lobe / *textbook;
    }

    /// How steady the machine was: a quantile of the rows' spreads, in percent.
    std::string spread(double q) const {
        std::vector<double> spreads;
        for (const auto& [name, t] : measured.times) spreads.push_back(t.spread);
        if (spreads.empty()) return "";
        std::ranges::sort(spreads);
        return formatted("%.0f",
                         100 * spreads[std::min(spreads.size() - 1,
                                                static_cast<std::size_t>(q * static_cast<double>(spreads.size())))]);
    }

    std::string summary() const {
        std::vector<std::string> header{"quantity", "one at a time", "loop"};
        if (measured.avx2) header.push_back("loop, AVX2");
        for (const char* title : {"error, lobe", "textbook", "extreme, lobe", "textbook"}) header.push_back(title);
        table t(header, 1);
        for (const section& s : foundation) {
            std::vector<std::string> line{s.title, ratio(time_ratio(s, "/one")), ratio(time_ratio(s, "/loop"))};
            if (measured.avx2) line.push_back(ratio(time_ratio(s, "/avx2")));
            for (const auto errors : {&row::usual, &row::extreme})
                for (const std::size_t n : {0u, 1u})
                    line.push_back((s.rows[n].*errors).empty() ? "" : error((s.rows[n].*errors)[0].largest));
            t.add(line);
        }
        return text_of(t);
    }

    /// In how many sections lobe is faster than the textbook, and where it is slower.
    void compare(contents& values, const std::string& where, const char* how) const {
        int of = 0, faster = 0;
        std::string slower;
        for (const section& s : foundation) {
            const auto r = time_ratio(s, how);
            if (!r) continue;
            ++of;
            faster += *r < 1;
            if (*r > 1.1) slower += (slower.empty() ? "" : "; ") + s.title + " (" + ratio(r) + ')';
        }
        auto& sections = values["faster, " + where];
        if (of) sections = std::to_string(faster) + " of " + std::to_string(of);
        values["slower, " + where] = slower.empty() ? "none" : slower;
    }

    std::string of(const section& s) const {
        std::vector<std::string> header{"variant", "error of", "one at a time, ns", "loop, ns"};
        if (measured.avx2) header.push_back("loop AVX2, ns");
        for (const char* title : {"median error", "largest", "extreme: median", "largest"}) header.push_back(title);
        table t(header, 2);
        for (const row& r : s.rows)
            for (std::size_t m = 0; m == 0 || m < r.usual.size(); ++m) {
                const auto first = [&](const std::string& text) { return m ? std::string() : text; };
                std::string error_of;
                if (!r.usual.empty()) {
                    const metric& measure = s.metrics[m % s.metrics.size()];
                    error_of = measure.of;
                    if (measure.unit != unit_of_error::points_at_1)
                        error_of += ": " + r.references[m / s.metrics.size()].kind;
                }
                std::vector<std::string> line{first(r.label), error_of, first(nanoseconds(time(r.name, "/one"))),
                                              first(nanoseconds(time(r.name, "/loop")))};
                if (measured.avx2) line.push_back(first(nanoseconds(time(r.name, "/avx2"))));
                for (const auto errors : {&row::usual, &row::extreme}) {
                    line.push_back((r.*errors).empty() ? "" : error((r.*errors)[m].median));
                    line.push_back((r.*errors).empty() ? "" : error((r.*errors)[m].largest));
                }
                t.add(line);
            }
        if (s.extra.empty()) return text_of(t);
        table more(s.extra[0], 1);
        for (std::size_t n = 1; n < s.extra.size(); ++n) more.add(s.extra[n]);
        return text_of(t) + "\n\n" + text_of(more);
    }

    const std::vector<section>& foundation;
    const std::vector<section>& models;
    const measurements& measured;
};

}  // namespace

std::string report(const std::string& layout, const std::vector<section>& foundation,
                   const std::vector<section>& models, const measurements& measured) {
    return filled(layout, writer(foundation, models, measured).all());
}
