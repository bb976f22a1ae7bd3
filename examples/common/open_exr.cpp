// OpenEXR by its own library. (tinyexr does not know the DWAA and DWAB compression that many published maps use.)
#include "colour.hpp"
#include "map_file.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <set>

#include <ImfChannelList.h>
#include <ImfChromaticities.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputPart.h>
#include <ImfMultiPartInputFile.h>
#include <ImfPartType.h>
#include <ImfRgbaFile.h>
#include <ImfStandardAttributes.h>

namespace {

/// A set of channels that makes a picture: "R", "G", "B" at the top level (the layer ""), "left.diffuse.R" ... in a
/// layer, or Y.
struct picture {
    int part;
    std::string layer;
    std::set<std::string> channels;  // without the layer

    bool is_rgb() const { return channels.contains("R") && channels.contains("G") && channels.contains("B"); }
    bool is_grey() const { return channels.contains("Y"); }
    bool has_chroma() const { return channels.contains("RY") || channels.contains("BY"); }
    std::string full(const std::string& channel) const { return layer.empty() ? channel : layer + "." + channel; }
};

std::vector<picture> pictures_of(int part, const Imf::ChannelList& channels) {
    std::map<std::string, picture> by_layer;
    for (auto c = channels.begin(); c != channels.end(); ++c) {
        const std::string name = c.name();
        const std::size_t dot = name.rfind('.');
        const std::string layer = dot == std::string::npos ? "" : name.substr(0, dot);
        // npos + 1 is 0
        by_layer.try_emplace(layer, picture{part, layer, {}}).first->second.channels.insert(name.substr(dot + 1));
    }
    std::vector<picture> found;
    for (auto& [layer, p] : by_layer) found.push_back(std::move(p));
    return found;
}

std::string listed(const std::set<std::string>& names) {
    std::string all;
    for (const std::string& name : names) all += (all.empty() ? "" : ", ") + name;
    return all;
}

/// The picture at the top level; failing that the one of a layer, if there is only one. Colour goes before luminance.
picture choose(const Imf::MultiPartInputFile& file, std::vector<std::string>& notes) {
    std::vector<picture> top, layers;
    std::set<std::string> channels;
    bool deep = false;
    for (int part = 0; part < file.parts(); ++part) {
        const Imf::Header& header = file.header(part);
        if (header.hasType() && Imf::isDeepData(header.type())) {
            deep = true;
            continue;
        }
        for (picture& p : pictures_of(part, header.channels())) {
            for (const std::string& c : p.channels) channels.insert(p.full(c));
            (p.layer.empty() ? top : layers).push_back(std::move(p));
        }
    }
    const auto part_name = [&](int part) {
        return file.header(part).hasName() ? file.header(part).name() : std::to_string(part + 1);
    };
    for (const auto is_one : {&picture::is_rgb, &picture::is_grey}) {
        std::vector<picture> fit;
        std::ranges::copy_if(top, std::back_inserter(fit), is_one);
        if (fit.size() > 1)
            notes.push_back("several of its parts are pictures; the first is read, \"" + part_name(fit[0].part) + "\"");
        if (!fit.empty()) return fit[0];
    }
    for (const auto is_one : {&picture::is_rgb, &picture::is_grey}) {
        std::vector<picture> fit;
        std::ranges::copy_if(layers, std::back_inserter(fit), is_one);
        std::set<std::string> names;
        for (const picture& p : fit)
            names.insert(file.parts() > 1 ? p.layer + " (part " + part_name(p.part) + ")" : p.layer);
        if (fit.size() > 1) throw problem("has several layers and none at the top level: " + listed(names));
        if (fit.empty()) continue;
        notes.push_back("layer " + *names.begin() + " is read");
        return fit[0];
    }
    if (channels.empty() && deep) throw problem("is a deep image, and these are not read");
    throw problem("has no channels R, G and B, and no Y: only " + listed(channels));
}

void check_sampling(const picture& p, const Imf::ChannelList& channels) {
    for (const std::string name : {"R", "G", "B", "Y"}) {
        if ((name == "Y") == p.is_rgb()) continue;
        const Imf::Channel* c = channels.findChannel(p.full(name));
        if (c->xSampling != 1 || c->ySampling != 1)
            throw problem("has the channel " + p.full(name) + " subsampled, which is not read");
    }
}

/// The pixels of the data window.
image read_pixels(const std::filesystem::path& path, Imf::MultiPartInputFile& file, const picture& p) {
    const Imath::Box2i window = file.header(p.part).dataWindow();
    image data{window.max.x - window.min.x + 1, window.max.y - window.min.y + 1};
    const auto width = static_cast<std::size_t>(data.width);

    if (!p.is_rgb() && p.has_chroma()) {  // luminance and chroma: the library knows how to put these together
        if (file.parts() > 1)
            throw problem("has several parts, and luminance and chroma (Y, RY, BY) are not read from such");
        std::vector<Imf::Rgba> halves(data.pixels.size());
        Imf::RgbaInputFile rgba{path.c_str(), p.layer};
        rgba.setFrameBuffer(&halves[0] - window.min.x - static_cast<std::ptrdiff_t>(width) * window.min.y, 1, width);
        rgba.readPixels(window.min.y, window.max.y);
        std::transform(halves.begin(), halves.end(), data.pixels.begin(), [](const Imf::Rgba& c) {
            return vec3{c.r, c.g, c.b};
        });
        return data;
    }
    Imf::FrameBuffer buffer;
    for (int i = 0; i < (p.is_rgb() ? 3 : 1); ++i) {
        auto* first = reinterpret_cast<char*>(&data.pixels[0][i]);
        const std::string name = p.full(p.is_rgb() ? std::string(1, "RGB"[i]) : "Y");
        buffer.insert(name, Imf::Slice::Make(Imf::FLOAT, first, window, sizeof(vec3), sizeof(vec3) * width));
    }
    Imf::InputPart part{file, p.part};
    part.setFrameBuffer(buffer);
    part.readPixels(window.min.y, window.max.y);
    if (!p.is_rgb())
        for (vec3& c : data.pixels) c = vec3{c.x};
    return data;
}

chromaticities chromaticities_of(const Imf::Header& header) {
    // Rec. 709
    const Imf::Chromaticities file = hasChromaticities(header) ? Imf::chromaticities(header) : Imf::Chromaticities{};
    chromaticities space;
    const Imath::V2f corners[] = {file.red, file.green, file.blue, file.white};
    for (std::size_t i = 0; i < 4; ++i) {
        if (!is_finite(corners[i].x) || !is_finite(corners[i].y)) throw problem("chromaticities must be finite");
        space[i] = {corners[i].x, corners[i].y};
    }
    return space;
}

}  // namespace

// The sphere is the display window. The data window may be a part of it, where all else is 0, or reach beyond it.
map_file read_open_exr(const std::filesystem::path& path) {
    Imf::Header::setMaxImageSize(largest_width, largest_width);  // before it believes an absurd header
    Imf::Header::setMaxTileSize(largest_width, largest_width);
    Imf::MultiPartInputFile file{path.c_str()};
    map_file read;
    const picture chosen = choose(file, read.notes);
    const Imf::Header& header = file.header(chosen.part);
    const Imath::Box2i display = header.displayWindow(), window = header.dataWindow();
    check_shape(1LL + display.max.x - display.min.x, 1LL + display.max.y - display.min.y);
    check_sampling(chosen, header.channels());
    read.to_rec709 = to_rec709(chromaticities_of(header), "chromaticities");
    if (!file.partComplete(chosen.part)) throw problem("is truncated: some of its scan lines or tiles are missing");

    image data = read_pixels(path, file, chosen);
    if (window == display) {
        read.pixels = std::move(data);
        return read;
    }
    read.pixels = {display.max.x - display.min.x + 1, display.max.y - display.min.y + 1};
    for (int y = std::max(window.min.y, display.min.y); y <= std::min(window.max.y, display.max.y); ++y)
        for (int x = std::max(window.min.x, display.min.x); x <= std::min(window.max.x, display.max.x); ++x)
            read.pixels(x - display.min.x, y - display.min.y) = data(x - window.min.x, y - window.min.y);
    return read;
}
