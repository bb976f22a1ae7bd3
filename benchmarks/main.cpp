// trade_report --out FILE [--benchmark_...]: measures every row and writes the report.
#include "element.hpp"
#include "errors.hpp"
#include "make_kernel.hpp"
#include "report.hpp"
#include "textbook.hpp"

#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <memory>
#include <sstream>
#include <stdexcept>

namespace {

/// A file that appears whole or not at all.
class whole_file {
public:
    /// Says at once, not after minutes of measuring, that it cannot be written.
    explicit whole_file(const std::string& path) : name(path), draft(path + ".part") {
        if (std::filesystem::is_directory(name)) fail("it is a directory");
        save("");
        std::filesystem::remove(draft);
    }

    void write(const std::string& text) const {
        save(text);
        std::error_code error;
        std::filesystem::rename(draft, name, error);
        if (error) fail(error.message());
    }

private:
    void save(const std::string& text) const {
        std::ofstream file(draft);
        file << text;
        file.close();
        if (!file) fail(std::strerror(errno));
    }
    [[noreturn]] void fail(const std::string& reason) const {
        std::error_code ignored;
        std::filesystem::remove(draft, ignored);
        throw std::runtime_error("cannot write " + name + ": " + reason);
    }

    std::string name, draft;
};

struct arguments {
    std::string out;
    std::vector<std::string> benchmark;
};

arguments parse(int argc, char** argv) {
    arguments a;
    for (int i = 1; i < argc; ++i) {
        const std::string argument = argv[i];
        if (argument == "--out" && i + 1 < argc)
            a.out = argv[++i];
        else if (argument.starts_with("--out="))
            a.out = argument.substr(6);
        else
            a.benchmark.push_back(argument);
    }
    if (a.out.empty()) throw std::runtime_error("no output: trade_report --out FILE [--benchmark_...]");
    return a;
}

std::string text_of(const std::string& path) {
    std::ifstream file(path);
    std::ostringstream text;
    text << file.rdbuf();
    if (!file) throw std::runtime_error("cannot read " + path);
    return text.str();
}

/// The rows for AVX2, where this processor has it.
std::vector<section> avx2() {
#ifdef BENCH_AVX2
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) return avx2_sections();
#endif
    return {};
}

/// Reads one number: what the call or the loop itself costs.
struct nothing {
    [[gnu::always_inline]] static result<1> at(const inputs& in, std::size_t i) { return {in.vx[i]}; }
};

std::vector<float> results_of(const kernel& k, const inputs& in) {
    std::vector<float> out(k.components * stride);
    k.loop(in, out.data());
    return out;
}

/// `part`: all sections. `with_avx2`: the same, or none.
void measure_errors(measurements& measured, const std::vector<section*>& part, const std::vector<section>& with_avx2,
                    const inputs& in, std::vector<error_summary> row::*errors) {
    for (std::size_t n = 0; n < part.size(); ++n)
        for (std::size_t k = 0; k < part[n]->rows.size(); ++k) {
            row& r = part[n]->rows[k];
            if (r.references.empty()) continue;
            const auto values = results_of(r.code, in);
            const auto values2 = with_avx2.empty() ? values : results_of(with_avx2[n].rows[k].code, in);
            for (const reference& against : r.references)
                for (const metric& m : part[n]->metrics) {
                    const std::vector<real>& exact = exact_results(against.exact, in);
                    const error_summary e = error_of(m, exact, in, values);
                    (r.*errors).push_back(e);
                    if (!(e.largest > 0)) continue;
                    const double factor = error_of(m, exact, in, values2).largest / e.largest;
                    if (factor > measured.avx2_factor) {
                        measured.avx2_factor = factor;
                        measured.avx2_worst = r.name;
                    }
                }
        }
}

/// The inputs and room for results, always at the same distance: modulo 4 KiB, results are far ahead of all inputs.
struct alignas(4096) memory {
    inputs in;
    alignas(4096) std::array<float, 640> apart{};
    std::array<float, 8 * stride> out{};
};

std::map<std::string, timing> measure_times(const std::vector<section*>& part, const std::vector<section>& with_avx2,
                                            const inputs& usual) {
    const auto arrays = std::make_unique<memory>();
    const inputs& in = arrays->in = usual;
    float* const out = arrays->out.data();
    volatile std::uint32_t zero = 0;
    std::vector<job> jobs;
    const auto add = [&](const std::string& name, const kernel& k) {
        jobs.push_back({name + "/one", [&k, &in, &zero] { zero = zero & k.one_at_a_time(in, zero); }});
        if (k.loop_is_timed) jobs.push_back({name + "/loop", [&k, &in, out] { k.loop(in, out); }});
    };
    const kernel of_nothing = kernel_of<nothing>();
    add("nothing", of_nothing);
    for (const section* s : part)
        for (const row& r : s->rows) add(r.name, r.code);
    for (const section& s : with_avx2)
        for (const row& r : s.rows)
            if (r.code.loop_is_timed) jobs.push_back({r.name + "/avx2", [&k = r.code, &in, out] { k.loop(in, out); }});
    std::cerr << "Measuring " << jobs.size() << " times: a minute or two on a quiet machine\n";
    return measure(jobs);
}

void run(int argc, char** argv) {
    const arguments options = parse(argc, argv);
    set_benchmark_options(options.benchmark);
    const whole_file file(options.out);

    std::vector<section> foundation = foundation_sections(), models = model_sections();
    const std::vector<section> with_avx2 = avx2();
    std::vector<section*> all;
    for (auto* part : {&foundation, &models})
        for (section& s : *part) all.push_back(&s);
    measurements measured;
    measured.avx2 = !with_avx2.empty();
    const std::string layout = text_of(BENCH_LAYOUT);
    report(layout, foundation, models, measured);  // says at once, not after minutes of measuring, what does not fit

    inputs usual = make_inputs(set::usual), extreme = make_inputs(set::extreme);
    const textbook_table baked = textbook::bake(32, 1024);
    const prebuilt<float> built(0.3f), narrow(1e-4f);
    const prebuilt<real> built_exactly(0.3f), narrow_exactly(1e-4f);
    for (inputs* in : {&usual, &extreme}) {
        in->built = in == &usual ? &built : &narrow;
        in->built_exactly = in == &usual ? &built_exactly : &narrow_exactly;
        in->baked = &baked;
        set_average_albedos(*in);
    }

    measure_errors(measured, all, with_avx2, usual, &row::usual);
    measure_errors(measured, all, with_avx2, extreme, &row::extreme);
    measured.times = measure_times(all, with_avx2, usual);
    file.write(report(layout, foundation, models, measured));
    std::cout << "Wrote " << options.out << '\n';
}

}  // namespace

int main(int argc, char** argv) {
    try {
        run(argc, argv);
    } catch (const std::exception& error) {
        std::cerr << "trade_report: " << error.what() << '\n';
        return 1;
    }
}
