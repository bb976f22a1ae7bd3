// The fuzzer's target without a fuzzer, for every compiler: the files of a corpus, then hashed inputs.
// lobe_fuzz_replay CORPUS [INPUTS]
#include "input.hpp"
#include "invariants.hpp"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

int main(int argc, char** argv) {
    if (argc < 2) {
        std::fprintf(stderr, "usage: %s CORPUS [INPUTS]\n", argv[0]);
        return 2;
    }
    std::size_t files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(argv[1])) {
        std::ifstream file(entry.path(), std::ios::binary);
        const std::vector<char> bytes{std::istreambuf_iterator<char>(file), {}};
        LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
        ++files;
    }
    if (files == 0) {
        std::fprintf(stderr, "no corpus in %s\n", argv[1]);
        return 1;
    }
    const std::uint64_t inputs = argc > 2 ? std::stoull(argv[2]) : 4000;
    for (std::uint64_t i = 0; i < inputs; ++i) {
        const std::uint64_t hash = fuzz::mixed(i + 1);
        std::uint8_t bytes[8];
        std::memcpy(bytes, &hash, 8);
        LLVMFuzzerTestOneInput(bytes, 8);
    }
    if (20 * fuzz::unresolved > fuzz::evaluations) {
        std::fprintf(stderr, "one comparison in twenty evaluations left to rounding: nothing is tested\n");
        return 1;
    }
    std::printf("%zu files, %llu hashed inputs\n", files, static_cast<unsigned long long>(inputs));
}
