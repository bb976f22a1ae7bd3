// The words of the command line, and the word that was probably meant.
#pragma once

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

namespace emit {

/// What a word stands for: where it is from, what it needs.
struct word {
    std::string name, about;
};

/// A mistake of the user's: one line, exit status 2.
struct mistake : std::invalid_argument {
    using std::invalid_argument::invalid_argument;
};

/// Insertions, deletions and replacements from a to b.
inline std::size_t distance(const std::string& a, const std::string& b) {
    std::vector<std::size_t> row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t replaced = diagonal + (a[i - 1] != b[j - 1]);
            diagonal = row[j];
            row[j] = std::min({row[j] + 1, row[j - 1] + 1, replaced});
        }
    }
    return row[b.size()];
}

inline std::string nearest(const std::string& to, const std::vector<std::string>& words) {
    return *std::min_element(words.begin(), words.end(),
                             [&](const auto& a, const auto& b) { return distance(to, a) < distance(to, b); });
}

[[noreturn]] inline void refuse(const std::string& what, const std::string& written,
                                const std::vector<std::string>& words) {
    throw mistake("no " + what + " '" + written + "': did you mean '" + nearest(written, words) +
                  "'? (--list names all)");
}

}  // namespace emit
