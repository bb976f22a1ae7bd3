// Runs the printed functions on a Vulkan device and compares them with lobe in double, beside lobe in float:
// on_device FOLDER-OF-SPIR-V [number of inputs [what the names of functions begin with]]
#include "device.hpp"
#include "inputs.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <iterator>
#include <string_view>

namespace {

using shader_tests::input;

/// Errors of one function, in ULP: the largest, and that which 999 of 1000 results stay below.
struct errors {
    std::vector<double> all;
    int underflows = 0;
    /// A shader's exp may be 0 below 1.2e-38, its smallest normal number: what is that times 1/alpha^2 is then 0 too.
    void add(float found, double exact) {
        if (found == 0 && exact != 0 && std::abs(exact) < 1e-30) {  // house: 1.2e-38/alpha^2, alpha = 1e-4
            ++underflows;
            return;
        }
        const double size = std::max(std::abs(exact), double(std::numeric_limits<float>::min()));
        const double ulp = std::ldexp(1.0, std::max(std::ilogb(size), -126) - 23);
        all.push_back(std::isfinite(found) ? std::abs(found - exact) / ulp : 1e30);
    }
    double below(double share) {
        if (all.empty()) return 0;
        const auto at = all.begin() + static_cast<std::ptrdiff_t>(share * double(all.size() - 1));
        std::nth_element(all.begin(), at, all.end());
        return *at;
    }
};

/// The numbers of a result in double.
struct exact_numbers {
    std::array<double, 7> at;
    std::size_t count = 0;
    void add(double x) { at[count++] = x; }
};

/// Does the shader call what Vulkan allows to be less right than the C library: exp 3 + 2 |x| ULP, log 3 ULP or
/// 2^-21, pow as exp2(y log2 x), sin and cos 2^-11, acos and atan 4096 ULP?
bool approximate(const std::string& path) {
    std::string text;
    for (const char* extension : {".comp", ".hlsl"})
        if (std::ifstream from{path + extension}) text.assign(std::istreambuf_iterator<char>(from), {});
    for (const char* call : {"exp(", "exp2(", "log(", "log2(", "pow(", "sin(", "cos(", "acos(", "atan(", "atan2("})
        if (text.find(call) != std::string::npos) return true;
    return false;
}

input<double> wide(const input<float>& in) {
    return {lobe::vec3<double>(in.v), lobe::vec3<double>(in.l), lobe::vec2<double>(in.u), in.width, in.x};
}

}  // namespace

int main(int count, char** arguments) try {
    const std::string folder = arguments[1];
    const std::size_t wanted = count > 2 ? static_cast<std::size_t>(std::atoll(arguments[2])) : 1000000,
                      inputs = wanted / 64 * 64;
    shader_tests::device gpu(inputs * 10 * sizeof(float), inputs * 7 * sizeof(float));
    std::vector<input<float>> in;
    std::vector<float> flat;
    shader_tests::random_inputs random;
    for (std::size_t i = 0; i < inputs; ++i) {
        const input<float> one = random();
        in.push_back(one);
        for (const float x : {one.v.x, one.v.y, one.v.z, one.l.x, one.l.y, one.l.z, one.u.x, one.u.y, one.width, one.x})
            flat.push_back(x);
    }
    gpu.load(flat);
    std::printf(
        "%s, %zu inputs; errors in ULP against double, 999 of 1000 and the largest\n%-34s %10s %10s %12s %12s\n",
        gpu.name.c_str(), inputs, "", "device", "CPU", "device max", "CPU max");
    int failed = 0;
    const std::string_view only = count > 3 ? arguments[3] : "";
    shader_tests::for_each_function([&](const char* name, const auto& f) {
        if (!std::string_view(name).starts_with(only)) return;
        const float* found = gpu.run(folder + "/" + name + ".spv", static_cast<std::uint32_t>(inputs / 64));
        errors device, cpu;
        for (std::size_t i = 0; i < inputs; ++i) {
            exact_numbers exact;
            shader_tests::collect(f(wide(in[i])), exact);
            const auto here = shader_tests::numbers_of(f(in[i]));
            for (std::size_t k = 0; k < exact.count; ++k) {
                if (!std::isfinite(exact.at[k]) || std::abs(exact.at[k]) > std::numeric_limits<float>::max()) continue;
                cpu.add(here.at[k], exact.at[k]);
                device.add(found[7 * i + k], exact.at[k]);
            }
        }
        const double d = device.below(0.999), c = cpu.below(0.999);
        // Half of what calls these is near the C library. What cancels, and so is off by more than 20 ULP on the CPU,
        // may be off by twice that: a division is allowed 2.5 ULP instead of 0.5.
        const bool other = approximate(folder + "/" + name);
        const bool good = other ? device.below(0.5) <= cpu.below(0.5) + 32 : d <= c + 3 + (c > 20 ? c : 0);
        failed += !good;
        if (device.underflows > cpu.underflows)
            std::printf("%34s %d of %zu results below 1e-30 are 0\n", "", device.underflows - cpu.underflows, inputs);
        std::printf("%-34s %10.4g %10.4g %12.4g %12.4g%s\n", name, d, c, device.below(1), cpu.below(1),
                    !good   ? "  WRONG"
                    : other ? "  exp, log, pow, acos or atan"
                            : "");
    });
    std::printf("%d functions are off by more than 3 ULP beyond float on the CPU\n", failed);
    return failed > 0;
} catch (const std::exception& error) {
    std::fprintf(stderr, "SKIPPED: %s\n", error.what());
    return 77;
}
