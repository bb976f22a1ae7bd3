// KTX 2.0 (Khronos 2021): header, level index, data format descriptor, key and value data, then levels from the
// smallest.
#include "ktx2.hpp"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <stdexcept>

namespace {

/// Numbers as the file has them, little-endian.
class bytes {
public:
    template <class T>
    bytes& operator<<(T number) {
        for (std::size_t i = 0; i < sizeof(T); ++i)
            data.push_back(static_cast<char>((static_cast<std::uint64_t>(number) >> (8 * i)) & 255));
        return *this;
    }
    void text(const std::string& s) { data.append(s.c_str(), s.size() + 1); }  // with its zero
    void pad(std::size_t to) {
        while (data.size() % to) data.push_back('\0');
    }
    std::size_t size() const { return data.size(); }

    std::string data;
};

/// Khronos Data Format Specification 1.3, chapter 5: one basic block, a sample a channel.
std::string descriptor(int channels) {
    bytes d;
    const auto block = static_cast<std::uint32_t>(24 + 16 * channels);
    d << std::uint32_t{4 + block};
    d << std::uint32_t{0};                                                          // vendor Khronos, basic descriptor
    d << std::uint16_t{2} << static_cast<std::uint16_t>(block);                     // version 1.3, size
    d << std::uint8_t{1} << std::uint8_t{1} << std::uint8_t{1} << std::uint8_t{0};  // RGBSDA, BT.709, linear, straight
    d << std::uint32_t{0};                                                          // blocks of one texel
    d << static_cast<std::uint64_t>(2 * channels);                                  // bytes of plane 0
    for (int i = 0; i < channels; ++i) {
        const int channel = i == 3 ? 15 : i;  // red, green, blue, alpha
        d << static_cast<std::uint16_t>(16 * i) << std::uint8_t{15} << static_cast<std::uint8_t>(0xc0 | channel);
        d << std::uint32_t{0};
        d << std::uint32_t{0xbf800000} << std::uint32_t{0x3f800000};  // -1 and 1, as a float says what it may hold
    }
    return d.data;
}

std::string keys_and_values(bool cube, const std::string& writer) {
    bytes out;
    const auto add = [&](const std::string& key, const std::string& value) {
        out << static_cast<std::uint32_t>(key.size() + value.size() + 2);
        out.text(key);
        out.text(value);
        out.pad(4);
    };
    if (!cube) add("KTXorientation", "rd");
    add("KTXwriter", writer);
    return out.data;
}

}  // namespace

void write_ktx2(const std::filesystem::path& path, const texture& t, const std::string& writer) {
    const std::string format = descriptor(t.channels), notes = keys_and_values(t.cube, writer);
    const std::size_t levels = t.levels.size(), texel = 2 * static_cast<std::size_t>(t.channels);
    const std::size_t index_end = 80 + 24 * levels, data = index_end + format.size() + notes.size();

    // the largest level is first in the index and last in the file
    std::vector<std::size_t> offsets(levels);
    std::size_t end = data;
    for (std::size_t i = levels; i-- > 0;) {
        offsets[i] = (end + texel - 1) / texel * texel;
        end = offsets[i] + 2 * t.levels[i].size();
    }

    bytes file;
    file.data = "\xabKTX 20\xbb\r\n\x1a\n";
    file << std::uint32_t{t.channels == 2 ? 83u : 97u} << std::uint32_t{2};  // vkFormat, typeSize
    file << static_cast<std::uint32_t>(t.width) << static_cast<std::uint32_t>(t.height) << std::uint32_t{0};
    file << std::uint32_t{0} << std::uint32_t{t.cube ? 6u : 1u} << static_cast<std::uint32_t>(levels)
         << std::uint32_t{0};  // no array; faces; levels; not compressed
    file << static_cast<std::uint32_t>(index_end) << static_cast<std::uint32_t>(format.size());
    file << static_cast<std::uint32_t>(index_end + format.size()) << static_cast<std::uint32_t>(notes.size());
    file << std::uint64_t{0} << std::uint64_t{0};  // no global data
    for (std::size_t i = 0; i < levels; ++i) {
        const std::uint64_t length = 2 * t.levels[i].size();
        file << static_cast<std::uint64_t>(offsets[i]) << length << length;
    }
    file.data += format + notes;
    for (std::size_t i = levels; i-- > 0;) {
        file.pad(texel);
        for (const std::uint16_t half : t.levels[i]) file << half;
    }

    std::ofstream out(path, std::ios::binary);
    out.write(file.data.data(), static_cast<std::streamsize>(file.size()));
    out.close();
    if (!out) throw std::runtime_error(path.string() + ": cannot be written: " + std::strerror(errno));
}
