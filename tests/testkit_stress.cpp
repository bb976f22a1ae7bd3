// The test kit under stress: thousands of right subjects. Hidden, for it takes most of an hour: run it by its tag.
#include "catch.hpp"
#include "mixtures.hpp"

#include <cstdio>

namespace {

/// How many verdicts of those that follow are false alarms; each is printed.
class alarms {
public:
    void add(const mixtures::report& r, const std::string& name, std::uint64_t set, std::uint64_t seed) {
        ++verdicts;
        if (r.passed()) return;
        ++failed;
        std::printf("%s, set %lu, seed %lu: %s", name.c_str(), static_cast<unsigned long>(set),
                    static_cast<unsigned long>(seed), r.text().c_str());
    }
    int verdicts = 0, failed = 0;
};

}  // namespace

TEST_CASE("stress: no false alarm in 2000 verdicts at the default seed", "[.][stress]") {
    alarms a;
    for (const auto& f : mixtures::families())
        for (std::uint64_t set = 1; set <= 40; ++set) a.add(f.verdict(set, {}), f.name, set, 1);
    std::printf("%d of %d\n", a.failed, a.verdicts);
    CHECK(a.verdicts >= 2000);
    CHECK(a.failed == 0);
}

TEST_CASE("stress: at most one false alarm over 1000 seeds of the hardest ten", "[.][stress]") {
    alarms a;
    mixtures::options o;
    // Those that failed once, on the way to here.
    for (const std::uint64_t set : {17u, 26u, 67u, 162u, 256u, 292u, 331u, 360u, 763u, 31u})
        for (o.seed = 1; o.seed <= 100; ++o.seed)
            a.add(set % 2 ? mixtures::verdict_on_any_selection<float>(set, o)
                          : mixtures::verdict_on_any_selection<double>(set, o),
                  "any selection", set, o.seed);
    std::printf("%d of %d\n", a.failed, a.verdicts);
    CHECK(a.failed <= 1);
}
