#include "font.hpp"

#include <cmath>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include <glm/common.hpp>

namespace {

std::vector<int> code_points(const std::string& utf8) {
    std::vector<int> points;
    for (const char c : utf8) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte < 0x80)
            points.push_back(byte);
        else if (byte >= 0xc0)
            points.push_back(byte & (byte < 0xe0 ? 0x1f : byte < 0xf0 ? 0x0f : 0x07));
        else if (!points.empty())
            points.back() = points.back() << 6 | (byte & 0x3f);
    }
    return points;
}

}  // namespace

font::font(const std::filesystem::path& ttf) {
    std::ifstream file{ttf, std::ios::binary};
    data.assign(std::istreambuf_iterator<char>{file}, {});
    if (data.empty() || !stbtt_InitFont(&info, data.data(), 0))
        throw std::runtime_error(ttf.string() + ": is no font that can be read");
}

float font::width(const std::string& utf8, float size) const {
    int sum = 0;
    for (const int c : code_points(utf8)) {
        int advance = 0, bearing = 0;
        stbtt_GetCodepointHMetrics(&info, c, &advance, &bearing);
        sum += advance;
    }
    return static_cast<float>(sum) * stbtt_ScaleForMappingEmToPixels(&info, size);
}

void font::write(image& page, float x, float y, float size, const vec3& colour, const std::string& utf8) const {
    const float scale = stbtt_ScaleForMappingEmToPixels(&info, size);
    for (const int c : code_points(utf8)) {
        const int left = static_cast<int>(std::floor(x));
        int width = 0, height = 0, dx = 0, dy = 0, advance = 0, bearing = 0;
        unsigned char* glyph = stbtt_GetCodepointBitmapSubpixel(&info, scale, scale, x - static_cast<float>(left), 0, c,
                                                                &width, &height, &dx, &dy);
        for (int j = 0; j < height; ++j)
            for (int i = 0; i < width; ++i) {
                const int px = left + dx + i, py = static_cast<int>(y) + dy + j;
                if (px < 0 || py < 0 || px >= page.width || py >= page.height) continue;
                page(px, py) = mix(page(px, py), colour, static_cast<float>(glyph[j * width + i]) / 255.0f);
            }
        stbtt_FreeBitmap(glyph, nullptr);
        stbtt_GetCodepointHMetrics(&info, c, &advance, &bearing);
        x += static_cast<float>(advance) * scale;
    }
}
