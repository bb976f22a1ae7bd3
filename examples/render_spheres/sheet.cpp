#include "sheet.hpp"

#include "../common/picture.hpp"

#include <algorithm>
#include <sstream>

namespace {

const vec3 paper{0.0f}, ink{0.92f}, faint{0.62f};

std::string number(float x) {
    std::ostringstream out;
    out << x;
    return out.str();
}

}  // namespace

image drawn(const sheet& s, const font& face) {
    const image& tile = s.groups.front().rows.front().tiles.front();
    const float size = std::clamp(static_cast<float>(tile.width) * 0.155f, 12.0f, 24.0f);  // of the text
    const float small = 0.85f * size, line = 1.5f * size;
    const int margin = static_cast<int>(1.5f * size), gap = static_cast<int>(0.5f * size);

    // Measure.
    float label_width = 0, notes_width = face.width(s.title, 1.4f * size);
    for (const auto& note : s.notes) notes_width = std::max(notes_width, face.width(note, small));
    int rows = 0;
    for (const auto& group : s.groups)
        for (const auto& row : group.rows) {
            label_width = std::max({label_width, face.width(row.label, size), face.width(row.detail, small)});
            ++rows;
        }
    const int left = margin + static_cast<int>(label_width) + 2 * gap;
    const int top =
        margin + static_cast<int>(2.0f * size + static_cast<float>(s.notes.size()) * 1.4f * small + 2.2f * line);
    const int grid_width = static_cast<int>(s.columns.size()) * tile.width;
    const int heading = static_cast<int>(2.2f * size);
    const int bar_top = top + rows * tile.height + static_cast<int>(s.groups.size()) * heading + margin;
    const int bar_height = static_cast<int>(size);
    const int text_right =
        std::max(margin + static_cast<int>(notes_width), left + static_cast<int>(face.width(s.scale_title, small)));
    const int page_width = std::max(left + grid_width, text_right) + margin;
    image page{page_width, bar_top + bar_height + static_cast<int>(2 * line) + margin};
    std::fill(page.pixels.begin(), page.pixels.end(), paper);

    const auto write = [&](float x, float y, float text_size, const vec3& colour, const std::string& text) {
        face.write(page, x, y, text_size, colour, text);
    };
    const auto centred = [&](float x, float y, float text_size, const vec3& colour, const std::string& text) {
        write(x - face.width(text, text_size) / 2, y, text_size, colour, text);
    };
    const auto x0 = static_cast<float>(margin);

    // Title, notes and the numbers over the columns.
    float y = x0 + 1.2f * size;
    write(x0, y, 1.4f * size, ink, s.title);
    y += 0.4f * size;
    for (const auto& note : s.notes) write(x0, y += 1.4f * small, small, faint, note);
    const float column_line = static_cast<float>(top) - 0.3f * size;
    write(x0, column_line, size, faint, s.column_title);
    for (std::size_t i = 0; i < s.columns.size(); ++i)
        centred(static_cast<float>(left) + (static_cast<float>(i) + 0.5f) * static_cast<float>(tile.width), column_line,
                size, ink, s.columns[i]);

    // The tiles and the words beside them.
    int row_top = top;
    for (const auto& group : s.groups) {
        row_top += heading;
        write(x0, static_cast<float>(row_top) - 0.5f * size, 1.1f * size, ink, group.heading);
        for (const auto& row : group.rows) {
            const float middle = static_cast<float>(row_top) + static_cast<float>(tile.height) / 2;
            write(x0, middle, size, ink, row.label);
            write(x0, middle + 1.4f * small, small, faint, row.detail);
            for (std::size_t i = 0; i < row.tiles.size(); ++i)
                paste(page, row.tiles[i], left + static_cast<int>(i) * tile.width, row_top);
            row_top += tile.height;
        }
    }

    // The scale of the false colours.
    const auto bar_line = static_cast<float>(bar_top + bar_height);
    write(x0, bar_line - 0.15f * size, size, ink, "false colours");
    for (int i = 0; i < grid_width; ++i)
        for (int j = 0; j < bar_height; ++j)
            page(left + i, bar_top + j) = false_colour((static_cast<float>(i) + 0.5f) / static_cast<float>(grid_width));
    constexpr int ticks = 5;
    for (int i = 0; i <= ticks; ++i) {
        const float part = static_cast<float>(i) / ticks,
                    x = static_cast<float>(left) + part * static_cast<float>(grid_width - 1);
        for (int j = 0; j < gap; ++j) page(static_cast<int>(x), bar_top + bar_height + j) = faint;
        centred(x, bar_line + static_cast<float>(gap) + size, small, ink,
                (i == ticks ? "≥ " : "") + number(part * s.scale_end));
    }
    write(static_cast<float>(left), bar_line + static_cast<float>(gap) + size + line, small, faint, s.scale_title);
    return page;
}
