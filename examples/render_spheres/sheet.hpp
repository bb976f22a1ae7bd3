#pragma once

#include "../common/font.hpp"
#include "../common/image.hpp"

#include <string>
#include <vector>

/// What a labelled picture holds. The tiles are screen colours, all of one size.
struct sheet {
    struct row {
        std::string label, detail;
        std::vector<image> tiles;
    };
    struct group {
        std::string heading;
        std::vector<row> rows;
    };
    std::string title;
    std::vector<std::string> notes;    // lines under the title
    std::vector<std::string> columns;  // one number a column
    std::string column_title;
    std::vector<group> groups;
    float scale_end = 1;  // the false-colour scale: 0 to this
    std::string scale_title;
};

image drawn(const sheet&, const font&);
