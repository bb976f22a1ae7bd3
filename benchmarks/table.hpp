// A Markdown table whose columns line up in the file, too.
#pragma once

#include <algorithm>
#include <ostream>
#include <string>
#include <vector>

class table {
public:
    /// The first `left` columns are text, aligned left; the others are numbers, aligned right.
    table(std::vector<std::string> header, std::size_t left) : lines{std::move(header)}, text(left) {}

    void add(std::vector<std::string> line) { lines.push_back(std::move(line)); }

    friend std::ostream& operator<<(std::ostream& out, const table& t) {
        std::vector<std::size_t> width(t.lines[0].size(), 3);
        for (const auto& line : t.lines)
            for (std::size_t k = 0; k < line.size(); ++k) width[k] = std::max(width[k], line[k].size());
        for (std::size_t n = 0; n < t.lines.size(); ++n) {
            for (std::size_t k = 0; k < width.size(); ++k) {
                const std::string space(width[k] - t.lines[n][k].size(), ' ');
                out << "| " << (k < t.text ? t.lines[n][k] + space : space + t.lines[n][k]) << ' ';
            }
            out << "|\n";
            if (n) continue;
            for (std::size_t k = 0; k < width.size(); ++k)
                out << (k < t.text ? "|:" + std::string(width[k] + 1, '-')
                                   : '|' + std::string(width[k] + 1, '-') + ':');
            out << "|\n";
        }
        return out;
    }

private:
    std::vector<std::vector<std::string>> lines;
    std::size_t text;
};
