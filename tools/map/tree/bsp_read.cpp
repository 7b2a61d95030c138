#include "engine/level/bsp_read.h"

#include <cstdint>
#include <cstring>

#include "engine/base/input_error.h"
#include "tools/map/tree/bsp_file.h"
#include "tools/map/tree/bsp_rows.h"

namespace oblong::map {
namespace {

// Little-endian numbers of a lump, one after the other; its offsets and sizes have been checked.
class LumpReader {
  public:
    LumpReader(const std::string& file, std::size_t lump, bool is_bsp2) : is_bsp2_(is_bsp2) {
        LumpReader header(file, 4 + 8 * lump);
        const std::size_t offset = header.size(), length = header.size();
        bytes_ = std::string_view(file).substr(offset, length);
    }

    bool is_end() const { return at_ >= bytes_.size(); }
    std::string_view bytes() const { return bytes_; }

    void u8(std::uint8_t& value) { value = static_cast<std::uint8_t>(bytes_[at_++]); }
    void i32(int& value) { value = static_cast<int>(bits(4)); }
    void u16(int& value) { value = is_bsp2_ ? static_cast<int>(bits(4)) : static_cast<int>(bits(2)); }
    void i16(int& value) {
        u16(value);
        if (!is_bsp2_) value = static_cast<std::int16_t>(value);
    }
    void number(float& value) {
        const std::uint32_t all = bits(4);
        std::memcpy(&value, &all, sizeof value);
    }
    void floats(Floats& values) {
        for (float& value : values) number(value);
    }
    void box(FileBox& box) {
        for (auto* corner : {&box.mins, &box.maxs})
            for (int& value : *corner) read_bound(value);
    }
    void unused_i32(int count) { at_ += 4 * static_cast<std::size_t>(count); }
    std::size_t size() { return bits(4); }

  private:
    LumpReader(const std::string& file, std::size_t at) : is_bsp2_(false), bytes_(file), at_(at) {}

    void read_bound(int& value) {
        if (!is_bsp2_) return i16(value);
        float bound = 0;
        number(bound);
        value = static_cast<int>(bound);
    }
    std::uint32_t bits(unsigned count) {
        std::uint32_t value = 0;
        for (unsigned i = 0; i < count; ++i)
            value |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes_[at_++])) << (8 * i);
        return value;
    }

    bool is_bsp2_;
    std::string_view bytes_;
    std::size_t at_ = 0;
};

std::vector<std::string> read_textures(LumpReader lump) {
    std::vector<std::size_t> offsets;
    for (std::size_t left = lump.size(); left > 0; --left) offsets.push_back(lump.size());
    offsets.push_back(lump.bytes().size());
    std::vector<std::string> textures;
    for (std::size_t i = 0; i + 1 < offsets.size() && offsets[i] <= offsets[i + 1]; ++i)
        textures.emplace_back(lump.bytes().substr(offsets[i], offsets[i + 1] - offsets[i]));
    return textures;
}

}  // namespace

BspFile from_bytes(const std::string& bytes) {
    read_bsp({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});  // checks all that is read here
    const bool is_bsp2 = bytes.starts_with("BSP2");
    const auto lump = [&](std::size_t index) { return LumpReader(bytes, index, is_bsp2); };
    BspFile bsp;
    bsp.entities = lump(0).bytes();
    bsp.entities.resize(std::min(bsp.entities.find('\0'), bsp.entities.size()));
    bsp.textures = read_textures(lump(2));
    bsp.visibility = lump(4).bytes();
    bsp.lighting = lump(8).bytes();
    visit_rows(bsp, [&](std::size_t place, const char*, auto& rows, auto fields) {
        for (LumpReader in = lump(place); !in.is_end();) fields(in, rows.emplace_back());
    });
    if (to_bytes(bsp) != bytes)
        throw InputError("file", "another program made this level, expected one of oblong-map (or no --only)");
    return bsp;
}

}  // namespace oblong::map
