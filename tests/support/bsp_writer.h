#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "engine/level/bsp_file.h"
#include "engine/level/bsp_read.h"
#include "tests/support/refusal.h"

/// Writes level files for tests: by hand, and from the lumps of another file.

namespace oblong::test {

using Bytes = std::vector<std::uint8_t>;

/// The lumps of a file, without their places in it.
using Lumps = std::array<Bytes, kLumpCount>;

inline Bytes& lump_of(Lumps& lumps, Lump lump) {
    return lumps[static_cast<std::size_t>(lump)];
}

inline std::uint32_t number_at(const Bytes& bytes, std::size_t offset, int size) {
    std::uint32_t value = 0;
    for (int i = size; i-- > 0;) value = value << 8 | bytes[offset + static_cast<std::size_t>(i)];
    return value;
}

inline void put_number(Bytes& bytes, std::size_t offset, int size, std::int64_t value) {
    for (int i = 0; i < size; ++i)
        bytes[offset + static_cast<std::size_t>(i)] = static_cast<std::uint8_t>(value >> (8 * i));
}

/// Appends little-endian numbers.
class ByteWriter {
  public:
    explicit ByteWriter(Bytes& bytes) : bytes_(bytes) {}

    ByteWriter& number(int size, std::int64_t value) {
        bytes_.resize(bytes_.size() + static_cast<std::size_t>(size));
        put_number(bytes_, bytes_.size() - static_cast<std::size_t>(size), size, value);
        return *this;
    }
    ByteWriter& u8(std::int64_t value) { return number(1, value); }
    ByteWriter& i16(std::int64_t value) { return number(2, value); }
    ByteWriter& i32(std::int64_t value) { return number(4, value); }
    ByteWriter& f32(float value) { return number(4, std::bit_cast<std::uint32_t>(value)); }
    ByteWriter& text(std::string_view letters) {
        bytes_.insert(bytes_.end(), letters.begin(), letters.end());
        return *this;
    }

  private:
    Bytes& bytes_;
};

/// A file of the lumps, one behind the other.
inline Bytes join_lumps(std::uint32_t version, const Lumps& lumps) {
    Bytes file;
    ByteWriter out(file);
    out.i32(version);
    auto offset = static_cast<std::int64_t>(kBspHeaderSize);
    for (const Bytes& lump : lumps) {
        out.i32(offset).i32(static_cast<std::int64_t>(lump.size()));
        offset += static_cast<std::int64_t>(lump.size());
    }
    for (const Bytes& lump : lumps) file.insert(file.end(), lump.begin(), lump.end());
    return file;
}

/// Appends a lump of later engines behind all others; its place says `size` bytes, `shift` from where they are.
inline void append_extension(Bytes& file, std::string_view name, const Bytes& lump, std::int64_t size,
                             std::int64_t shift = 0, int said_lumps = 1) {
    file.resize((file.size() + 3) / 4 * 4);
    ByteWriter out(file);
    out.text("BSPX").i32(said_lumps).text(name).text(std::string(24 - name.size(), '\0'));
    out.i32(static_cast<std::int64_t>(file.size()) + 8 + shift).i32(size);
    file.insert(file.end(), lump.begin(), lump.end());
}

inline Lumps split_lumps(const Bytes& file) {
    Lumps lumps;
    for (std::size_t i = 0; i < lumps.size(); ++i) {
        const auto start = file.begin() + number_at(file, 4 + i * 8, 4);
        lumps[i].assign(start, start + number_at(file, 8 + i * 8, 4));
    }
    return lumps;
}

/// Rewrites the records of one BSP 29 lump in a wide format. A layout has a letter a field: `4` copies 4 bytes, `u`
/// widens an unsigned number of 2 bytes, `c` widens a child (negative if it is not below the number of records), `b`
/// copies a bound of a box of 2 bytes, or makes it a float.
inline Bytes widen_records(const Bytes& narrow, std::string_view layout, std::size_t record_size, bool float_boxes) {
    Bytes wide;
    ByteWriter out(wide);
    const auto record_count = static_cast<std::int64_t>(narrow.size() / record_size);
    std::size_t in = 0;
    while (in < narrow.size()) {
        for (const char field : layout) {
            const int size = field == '4' ? 4 : 2;
            const std::int64_t value = number_at(narrow, in, size);
            const std::int64_t as_signed = value < 0x8000 ? value : value - 0x10000;
            in += static_cast<std::size_t>(size);
            if (field == 'c')
                out.i32(value < record_count ? value : value - 0x10000);
            else if (field == 'b' && float_boxes)
                out.f32(static_cast<float>(as_signed));
            else
                out.number(field == 'b' ? 2 : 4, value);
        }
    }
    return wide;
}

/// The lumps of a BSP 29 file as those of BSP2 (float boxes) or 2PSB (boxes as they were).
inline Lumps widen_lumps(Lumps lumps, bool float_boxes) {
    const auto widen = [&](Lump which, std::string_view layout, std::size_t record_size) {
        Bytes& lump = lump_of(lumps, which);
        lump = widen_records(lump, layout, record_size, float_boxes);
    };
    widen(Lump::Nodes, "4ccbbbbbbuu", 24);
    widen(Lump::Faces, "uu4uu44", 20);
    widen(Lump::ClipNodes, "4cc", 8);
    widen(Lump::Leaves, "44bbbbbbuu4", 28);
    widen(Lump::MarkFaces, "u", 2);
    widen(Lump::Edges, "uu", 4);
    return lumps;
}

/// Where read_bsp finds fault; empty if it reads a level.
inline std::string fault_of(const Bytes& file) {
    return place_of_refusal([&] { read_bsp(file); });
}

inline std::string lump_label(std::size_t lump) {
    return "lump '" + std::string(kLumpNames[lump]) + "'";
}

inline bool names_a_lump(const std::string& where) {
    for (std::size_t lump = 0; lump < kLumpCount; ++lump)
        if (where.starts_with(lump_label(lump) + ", offset ")) return true;
    return false;
}

/// The smallest level that has one of everything: a floor at z = 8, 32 x 16 units, lit, with empty space above
/// (leaf 1) and solid below (leaf 0). Its texture lies a texel a unit, moved by 4 texels along u.
inline Lumps make_tiny_lumps() {
    Lumps lumps;
    const auto write = [&lumps](Lump lump) { return ByteWriter(lump_of(lumps, lump)); };
    write(Lump::Entities).text("{ \"classname\" \"worldspawn\" }").u8(0);
    write(Lump::Planes).f32(0).f32(0).f32(1).f32(8).i32(2);

    write(Lump::Textures).i32(1).i32(8);
    write(Lump::Textures).text("floor").number(8, 0).number(3, 0).i32(16).i32(16).i32(40).i32(296).i32(360).i32(376);
    lump_of(lumps, Lump::Textures).resize(8 + 40 + 256 + 64 + 16 + 4, 7);

    for (const float x : {0.F, 32.F})
        for (const float y : {0.F, 16.F}) write(Lump::Vertices).f32(x).f32(y).f32(8);
    write(Lump::Visibility).u8(1);
    write(Lump::Nodes).i32(0).i16(-2).i16(-1).i16(0).i16(0).i16(0).i16(32).i16(16).i16(64).i16(0).i16(1);
    write(Lump::TexInfos).f32(1).f32(0).f32(0).f32(4).f32(0).f32(-1).f32(0).f32(0).i32(0).i32(0);
    write(Lump::Faces).i16(0).i16(0).i32(0).i16(4).i16(0).u8(0).u8(255).u8(255).u8(255).i32(0);
    lump_of(lumps, Lump::Lighting).resize((48 / 16 + 1) * (16 / 16 + 1), 100);
    write(Lump::ClipNodes).i32(0).i16(-1).i16(-2);
    write(Lump::Leaves).i32(-2).i32(-1).number(8, 0).i32(0).i16(0).i16(0).i32(0);
    write(Lump::Leaves).i32(-1).i32(0).i16(0).i16(0).i16(8).i16(32).i16(16).i16(64).i16(0).i16(1).i32(0);
    write(Lump::MarkFaces).i16(0);
    // Clockwise seen from above: (0,0) (0,16) (32,16) (32,0). Edge 0 is never used: it has no negative.
    write(Lump::Edges).i16(0).i16(0).i16(0).i16(1).i16(3).i16(1).i16(3).i16(2).i16(2).i16(0);
    write(Lump::SurfEdges).i32(1).i32(-2).i32(3).i32(4);
    write(Lump::Models).f32(0).f32(0).f32(0).f32(32).f32(16).f32(64).f32(0).f32(0).f32(0);
    write(Lump::Models).i32(0).i32(0).i32(0).i32(0).i32(1).i32(0).i32(1);
    return lumps;
}

}  // namespace oblong::test
