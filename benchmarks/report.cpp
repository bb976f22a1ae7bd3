#include "report.hpp"

#include "table.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <optional>

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

class writer {
public:
    writer(std::ostream& stream, const std::vector<section>& of_foundation, const std::vector<section>& of_models, const measurements& results)
        : out(stream), foundation(of_foundation), models(of_models), measured(results) {}

    void write() const {
        out << "# The trade report: error beside every time\n\n";
        how_to_read();
        contents();
        summary();
        for (const section& s : foundation) write(s);
        for (const section& s : models) write(s);
        what_was_measured();
    }

private:
    std::optional<double> time(const row& r, const char* how) const {
        const auto found = measured.times.find(r.kernel + how);
        if (found == measured.times.end()) return {};
        return found->second.ns / static_cast<double>(count);
    }

    /// lobe's time over that of the textbook form of the same.
    std::optional<double> time_ratio(const section& s, const char* how) const {
        const auto lobe = time(s.rows[0], how), textbook = time(s.rows[1], how);
        if (!lobe || !textbook) return {};
        return *lobe / *textbook;
    }

    const std::vector<error_summary>& errors(const std::map<std::string, std::vector<error_summary>>& of, const row& r) const {
        static const std::vector<error_summary> none;
        const auto found = of.find(r.kernel);
        return found == of.end() ? none : found->second;
    }

    void how_to_read() const {
        out << "Each row is one way to compute a quantity in float, with what it costs and how wrong it is on the same inputs. "
               "**One at a time** is latency: a call that is not inlined and waits for the result of the call before it. "
               "**Loop** is an element of a plain loop over arrays, which the compiler is free to vectorise, for SSE2, the baseline of "
               "x86-64, and for AVX2. **Error** is the distance from the exact quantity, relative unless the section says otherwise, "
               "its median and its largest value, and once more for **extreme** inputs; `rounding` marks a formula that is exact on "
               "paper, so that all its error is float's, `from` a model that a row approximates, and any other word says what else is in the error "
               "of that row.\n\n"
               "Processor: "
            << processor() << ". Compiler: " << compiler << ", `" << BENCH_FLAGS << "`, for AVX2 also `-march=x86-64-v3`. "
            << "`bash benchmarks/run.sh` writes this file; do not edit it.\n\n";
    }

    /// GitHub's links to headings.
    static std::string link(const std::string& title) {
        std::string anchor;
        for (const char c : title)
            if (std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '-')
                anchor += static_cast<char>(std::tolower(c));
            else if (c == ' ')
                anchor += '-';
        return '[' + title + "](#" + anchor + ')';
    }

    void contents() const {
        const auto list = [&](const char* of, const std::vector<section>& part) {
            out << "- " << of << ": ";
            for (const section& s : part) out << (&s == part.data() ? "" : " | ") << link(s.title);
            out << '\n';
        };
        out << "- " << link(summary_title) << '\n';
        list("Beside the textbook", foundation);
        list("Every model", models);
        out << "- " << link(last_title) << "\n\n";
    }

    void what_was_measured() const {
        const row nothing{"nothing", "", {}};
        out << "## " << last_title << "\n\n"
               "Inputs: "
            << count
            << " elements from a fixed seed. Alpha is evenly spread in the logarithm over [1e-3, 1], the cosine of the view drawn evenly "
               "from "
               "[0.01, 1]; half vectors are where GGX of that alpha has them, near its peak, and seen by v; l is their reflection of v, "
               "its "
               "cosine at least 0.01. Extreme inputs have alpha = 1e-4 instead (anisotropic: 1e-4 by [1e-4, 1]); for sequences, indices up "
               "to "
               "2^32 - 1, an eighth of them with their low 25 bits set, instead of the points of a set of "
            << count
            << "; for sine and cosine, turns within 1e-3 after a multiple of 1/4 instead of anywhere. "
               "Parameters of models, a metallic, a weight, the roughness of a diffuse base, are anywhere in [0,1), lengths of mean normals in "
               "[0.8,1], slopes and derivatives within 0.2. v and l are rounded to float, and "
               "what is "
               "exact is the quantity at the rounded inputs, in long double, "
               "for models the same formula.\n\n"
               "Errors are those of the SSE2 loop. Times are medians, over repetitions in shuffled order, of processor time, in ns an "
               "element. "
               "One at a time, each contains the "
            << nanoseconds(time(nothing, "/one"))
            << " ns that it takes to call, read one number and derive the next index from it; in a loop reading and writing one "
            << "number takes " << nanoseconds(time(nothing, "/loop")) << " ns. " << spread() << '\n';
    }

    /// How steady the machine was.
    std::string spread() const {
        std::vector<double> spreads;
        for (const auto& [name, t] : measured.times) spreads.push_back(t.spread);
        if (spreads.empty()) return "";
        std::ranges::sort(spreads);
        return "The middle half of a row's repetitions spans " + formatted("%.0f", 100 * spreads[spreads.size() / 2]) +
               " % of its median, typically, and at worst " + formatted("%.0f", 100 * spreads.back()) + " %.";
    }

    void summary() const {
        out << "## " << summary_title << "\n\n"
               "Time: lobe's over the textbook's, below 1 where lobe is faster. Error: the largest of the first quantity of the "
               "section.\n\n";
        std::vector<std::string> header{"quantity", "one at a time", "loop"};
        if (measured.avx2) header.push_back("loop, AVX2");
        for (const char* title : {"error, lobe", "textbook", "extreme, lobe", "textbook"}) header.push_back(title);
        table t(header, 1);
        for (const section& s : foundation) {
            std::vector<std::string> line{s.title, ratio(time_ratio(s, "/one")), ratio(time_ratio(s, "/loop"))};
            if (measured.avx2) line.push_back(ratio(time_ratio(s, "/avx2")));
            for (const auto* of : {&measured.usual, &measured.extreme})
                for (const row& r : {s.rows[0], s.rows[1]}) line.push_back(errors(*of, r).empty() ? "" : error(errors(*of, r)[0].largest));
            t.add(line);
        }
        out << t << '\n';
        count_wins("one at a time", "/one");
        count_wins("in a loop", "/loop");
        if (measured.avx2) {
            count_wins("in a loop with AVX2", "/avx2");
            out << "- Compiling for AVX2, which contracts products and sums, multiplies the largest error of a row by up to "
                << formatted("%.2g", measured.avx2_factor) << " (" << measured.avx2_worst << ").\n";
        }
        out << '\n';
    }

    void count_wins(const char* where, const char* how) const {
        int of = 0, faster = 0;
        std::string slower;
        for (const section& s : foundation) {
            const auto r = time_ratio(s, how);
            if (!r) continue;
            ++of;
            faster += *r < 1;
            if (*r > 1.1) slower += (slower.empty() ? "" : "; ") + s.title + " (" + ratio(r) + ')';
        }
        if (!of) return;
        out << "- Timed " << where << ", lobe is faster than the textbook form in " << faster << " of " << of
            << " sections; more than 10 % slower in: " << (slower.empty() ? "none" : slower) << ".\n";
    }

    void write(const section& s) const {
        out << "## " << s.title << "\n\n" << s.note << (s.note.empty() ? "" : "\n\n");
        std::vector<std::string> header{"variant", "error of", "one at a time, ns", "loop, ns"};
        if (measured.avx2) header.push_back("loop AVX2, ns");
        for (const char* title : {"median error", "largest", "extreme: median", "largest"}) header.push_back(title);
        table t(header, 2);
        for (const row& r : s.rows) {
            const auto& usual = errors(measured.usual, r);
            const auto& extreme = errors(measured.extreme, r);
            for (std::size_t m = 0; m == 0 || m < usual.size(); ++m) {
                const auto first = [&](const std::string& text) { return m ? std::string() : text; };
                std::string of;
                if (!usual.empty()) {
                    const metric& measure = s.metrics[m % s.metrics.size()];
                    of = measure.of;
                    if (measure.unit != unit_of_error::points_at_1) of += ": " + r.references[m / s.metrics.size()].kind;
                }
                std::vector<std::string> line{first(r.label), of, first(nanoseconds(time(r, "/one"))),
                                              first(nanoseconds(time(r, "/loop")))};
                if (measured.avx2) line.push_back(first(nanoseconds(time(r, "/avx2"))));
                for (const auto* e : {&usual, &extreme}) {
                    line.push_back(e->empty() ? "" : error((*e)[m].median));
                    line.push_back(e->empty() ? "" : error((*e)[m].largest));
                }
                t.add(line);
            }
        }
        out << t << '\n';
        if (s.extra.empty()) return;
        table more(s.extra[0], 1);
        for (std::size_t n = 1; n < s.extra.size(); ++n) more.add(s.extra[n]);
        out << more << '\n';
    }

    const std::string summary_title = "Summary: lobe beside the textbook form of the same", last_title = "What was measured";
    std::ostream& out;
    const std::vector<section>& foundation;
    const std::vector<section>& models;
    const measurements& measured;
};

}  // namespace

void write_report(std::ostream& out, const std::vector<section>& foundation, const std::vector<section>& models, const measurements& measured) {
    writer(out, foundation, models, measured).write();
}
