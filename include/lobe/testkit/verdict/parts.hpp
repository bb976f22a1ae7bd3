// The parts of a BSDF, and which of them fail.
#pragma once

#include <lobe/testkit/measure/text.hpp>

#include <array>
#include <cstddef>
#include <string>

namespace lobe::testkit::detail {

/// Reflection from above, from below, refraction from above, from below: how many places were looked at, how many
/// deviate, and whether one is wrong.
class parts {
public:
    template <class T>
    void see(const place<T>& at) {
        ++all[index_of(at)].seen;
    }
    template <class T>
    void deviates(const place<T>& at) {
        ++all[index_of(at)].deviating;
    }
    template <class T>
    void is_wrong(const place<T>& at) {
        all[index_of(at)].wrong = true;
    }

    /// Of the parts that are wrong, how much deviates.
    double share() const {
        long seen = 0, deviating = 0;
        for (const part& p : all)
            if (p.wrong) seen += p.seen, deviating += p.deviating;
        return seen ? static_cast<double>(deviating) / static_cast<double>(seen) : 0;
    }

    /// Which are wrong, where others are right: "of refraction alone, from below alone: ".
    std::string text() const {
        const auto wrong = [&](std::size_t a, std::size_t b) { return all[a].wrong || all[b].wrong; };
        const auto seen = [&](std::size_t a, std::size_t b) { return all[a].seen + all[b].seen > 0; };
        std::string out;
        if (!wrong(2, 3) && seen(2, 3)) out = "of reflection alone";
        if (!wrong(0, 1) && seen(0, 1)) out = "of refraction alone";
        const std::string comma = out.empty() ? "" : ", ";
        if (!wrong(1, 3) && seen(1, 3)) out += comma + "from above alone";
        if (!wrong(0, 2) && seen(0, 2)) out += comma + "from below alone";
        return out.empty() ? out : out + ": ";
    }

private:
    struct part {
        long seen = 0, deviating = 0;
        bool wrong = false;
    };
    template <class T>
    static std::size_t index_of(const place<T>& at) {
        if (!at.has_l) return 0;
        return (at.v.z < T(0) ? 1u : 0u) + ((at.v.z < T(0)) != (at.l.z < T(0)) ? 2u : 0u);
    }
    std::array<part, 4> all{};
};

}  // namespace lobe::testkit::detail
