// trade_report --out FILE [--benchmark_...]: measures every row and writes the report.
#include "models.hpp"
#include "report.hpp"

#include <algorithm>
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

std::vector<kernel> avx2() {
#ifdef BENCH_AVX2
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) return avx2_kernels();
#endif
    return {};
}

using results = std::vector<float>;

results results_of(const kernel& k, const inputs& in) {
    results out(k.components * stride);
    k.loop(in, out.data());
    return out;
}

const kernel* find(const std::vector<kernel>& kernels, const std::string& name) {
    const auto found = std::ranges::find(kernels, name, &kernel::name);
    return found == kernels.end() ? nullptr : &*found;
}

void measure_errors(measurements& measured, const std::vector<section>& sections, const std::vector<kernel>& kernels,
                    const std::vector<kernel>& with_avx2, const inputs& usual, const inputs& extreme) {
    for (const section& s : sections)
        for (const row& r : s.rows) {
            const kernel* k = find(kernels, r.kernel);
            if (!k) throw std::logic_error("no kernel " + r.kernel);
            if (!k->components) continue;
            const kernel* k2 = find(with_avx2, r.kernel);
            for (const auto& [in, errors] : {std::pair{&usual, &measured.usual}, {&extreme, &measured.extreme}}) {
                const results values = results_of(*k, *in), values2 = k2 ? results_of(*k2, *in) : results();
                for (const reference& against : r.references)
                    for (const metric& m : s.metrics) {
                        const error_summary e = error_of(m, against.exact, *in, values.data());
                        (*errors)[r.kernel].push_back(e);
                        if (!k2 || !(e.largest > 0)) continue;
                        const double factor = error_of(m, against.exact, *in, values2.data()).largest / e.largest;
                        if (factor > measured.avx2_factor) {
                            measured.avx2_factor = factor;
                            measured.avx2_worst = s.title + ": " + r.label;
                        }
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

std::map<std::string, timing> measure_times(const std::vector<kernel>& kernels, const std::vector<kernel>& with_avx2, const inputs& usual) {
    const auto arrays = std::make_unique<memory>();
    const inputs& in = arrays->in = usual;
    float* const out = arrays->out.data();
    volatile std::uint32_t zero = 0;
    std::vector<job> jobs;
    for (const kernel& k : kernels) {
        jobs.push_back({k.name + "/one", [&k, &in, &zero] { zero = zero & k.one_at_a_time(in, zero); }});
        if (k.loop_is_timed) jobs.push_back({k.name + "/loop", [&k, &in, out] { k.loop(in, out); }});
    }
    for (const kernel& k : with_avx2)
        if (k.loop_is_timed) jobs.push_back({k.name + "/avx2", [&k, &in, out] { k.loop(in, out); }});
    std::cerr << "Measuring " << jobs.size() << " times: a minute or two on a quiet machine\n";
    return measure(jobs);
}

void run(int argc, char** argv) {
    const arguments options = parse(argc, argv);
    set_benchmark_options(options.benchmark);
    const whole_file file(options.out);

    inputs usual = make_inputs(set::usual), extreme = make_inputs(set::extreme);
    const textbook_table baked = textbook_bake(32, 1024);
    const prebuilt<float> built(0.3f), narrow(1e-4f);
    const prebuilt<real> built_exactly(0.3f), narrow_exactly(1e-4f);
    for (inputs* in : {&usual, &extreme}) {
        in->built = in == &usual ? &built : &narrow;
        in->built_exactly = in == &usual ? &built_exactly : &narrow_exactly;
        in->table = &in->built->dfg;
        in->baked = &baked;
        set_average_albedos(*in);
    }

    std::vector<kernel> kernels = baseline_kernels();
    for (const kernel& k : quadrature_kernels()) kernels.push_back(k);
    const std::vector<kernel> with_avx2 = avx2();
    const std::vector<section> foundation = sections();
    std::vector<section> models;
    for (const model_section& s : all_models()) {
        models.push_back(s.rows);
        kernels.insert(kernels.end(), s.kernels.begin(), s.kernels.end());
    }

    measurements measured;
    measured.avx2 = !with_avx2.empty();
    measure_errors(measured, foundation, kernels, with_avx2, usual, extreme);
    measure_errors(measured, models, kernels, with_avx2, usual, extreme);
    measured.times = measure_times(kernels, with_avx2, usual);
    std::ostringstream report;
    write_report(report, foundation, models, measured);
    file.write(report.str());
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
