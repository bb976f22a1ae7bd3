#pragma once

#include "image.hpp"

#include <filesystem>
#include <string>
#include <vector>

#include <stb_truetype.h>

class font {
public:
    explicit font(const std::filesystem::path& ttf);

    float width(const std::string& utf8, float size) const;
    /// Writes on `page` from x rightwards on the baseline y.
    void write(image& page, float x, float y, float size, const vec3& colour, const std::string& utf8) const;

private:
    std::vector<unsigned char> data;
    stbtt_fontinfo info{};
};
