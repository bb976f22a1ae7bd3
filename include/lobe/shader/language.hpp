// The differences between shading languages, as a table; each language is one of these in a file of its own.
#pragma once

#include <lobe/shader/tape.hpp>

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace lobe::shader {

/// What is written, with $words for what is put in.
struct language {
    std::string name, extension;
    std::string number, vector_2, vector_3, truth;  // types
    std::string suffix;                             // of a literal
    std::string declaration;                        // $type $name $value
    std::string parameter;                          // $type $name
    std::string function;                           // $type $name $parameters
    std::string member;                             // $type $name
    std::string choice;                             // $mask $a $b
    std::string returned;                           // $type $value, of a struct: its members' values
    std::string splat;                              // $type $value: a vector of equal components
    std::string pair;                               // $type $x $y: an element of a table
    std::string table;                              // $type $array $name $size $pairs
    std::string structure_end;
    std::string preamble;                           // on top of a file
    std::string end;                                // below it
    std::vector<std::pair<op, std::string>> calls;  // functions of another name than C's
    std::vector<op> missing;                        // functions of C's that the language lacks
    std::vector<std::string_view> reserved;         // words that are no names, of those that an author might choose
};

namespace detail {

/// `text` with $words replaced.
inline std::string filled(std::string_view text, const std::vector<std::pair<std::string_view, std::string>>& words) {
    std::string result;
    for (std::size_t i = 0; i < text.size();) {
        if (text[i] != '$') {
            result += text[i++];
            continue;
        }
        std::size_t end = i + 1;
        while (end < text.size() && ((text[end] >= 'a' && text[end] <= 'z') || text[end] == '_')) ++end;
        for (const auto& [word, value] : words)
            if (word == text.substr(i + 1, end - i - 1)) result += value;
        i = end;
    }
    return result;
}

}  // namespace detail

}  // namespace lobe::shader
