#include "measure.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <stdexcept>

namespace {

/// The value below which the fraction q of them lies.
double quantile(std::vector<double>& values, double q) {
    const auto at = values.begin() + static_cast<std::ptrdiff_t>(q * static_cast<double>(values.size() - 1) + 0.5);
    std::nth_element(values.begin(), at, values.end());
    return *at;
}

class collector : public benchmark::BenchmarkReporter {
public:
    bool ReportContext(const Context&) override { return true; }

    void ReportRuns(const std::vector<Run>& runs) override {
        for (const Run& run : runs)
            if (run.run_type == Run::RT_Iteration)
                samples[run.run_name.function_name].push_back(run.GetAdjustedCPUTime());
    }

    std::map<std::string, timing> timings() {
        std::map<std::string, timing> result;
        for (auto& [name, values] : samples) {
            const double median = quantile(values, 0.5);
            result[name] = {median, (quantile(values, 0.75) - quantile(values, 0.25)) / median};
        }
        return result;
    }

private:
    std::map<std::string, std::vector<double>> samples;
};

}  // namespace

void set_benchmark_options(const std::vector<std::string>& arguments) {
    static std::vector<std::string> all{"trade_report", "--benchmark_enable_random_interleaving=true",
                                        "--benchmark_repetitions=11",
                                        "--benchmark_min_time=0.008"};  // static: the library keeps a pointer
    all.insert(all.end(), arguments.begin(), arguments.end());
    std::vector<char*> argv;
    for (std::string& argument : all) argv.push_back(argument.data());
    int argc = static_cast<int>(argv.size());
    benchmark::Initialize(&argc, argv.data());
    if (argc > 1) throw std::runtime_error(std::string("unknown argument ") + argv[1]);
}

std::map<std::string, timing> measure(const std::vector<job>& jobs) {
    for (const job& j : jobs)
        benchmark::RegisterBenchmark(j.name.c_str(), [&work = j.work](benchmark::State& state) {
            for (auto _ : state) {
                work();
                benchmark::ClobberMemory();
            }
        });
    collector results;
    benchmark::RunSpecifiedBenchmarks(&results);
    return results.timings();
}
