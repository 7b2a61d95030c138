#include "tools/map/tree/bsp_file.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <limits>

#include "engine/base/input_error.h"
#include "engine/base/little_endian.h"
#include "engine/base/table.h"
#include "engine/level/bsp_read.h"
#include "tools/map/tree/bsp_rows.h"

namespace oblong::map {
namespace {

constexpr int kVersion = 29, kVersion2 = 0x32505342;  // the latter: "BSP2"
constexpr std::size_t kLumpCount = 15;
constexpr std::size_t kMostI16 = 32767, kMostU16 = 65535;

// Little-endian numbers, one after the other. In BSP2 counts and indices have 32 bits, and boxes are floats.
class Lump {
  public:
    Lump(std::string name, bool is_bsp2) : name_(std::move(name)), is_bsp2_(is_bsp2) {}

    void u8(int value) { put<std::uint8_t>(value); }
    void i16(int value) { is_bsp2_ ? i32(value) : put<std::int16_t>(value); }
    void u16(int value) { is_bsp2_ ? i32(value) : put<std::uint16_t>(value); }
    void i32(int value) { put<std::int32_t>(value); }
    void number(float value) {
        std::int32_t bits = 0;
        static_assert(sizeof bits == sizeof value);
        std::memcpy(&bits, &value, sizeof bits);
        i32(bits);
    }
    void floats(const Floats& values) {
        for (const float value : values) number(value);
    }
    void unused_i32(int count) {
        for (int i = 0; i < count; ++i) i32(0);
    }
    void box(const FileBox& box) {
        for (const int value : box.mins) put_bound(value);
        for (const int value : box.maxs) put_bound(value);
    }

    std::string bytes() const { return {bytes_.begin(), bytes_.end()}; }

  private:
    void put_bound(int value) {
        check<std::int16_t>(value);
        is_bsp2_ ? number(static_cast<float>(value)) : i16(value);
    }

    template <class Int>
    void check(int value) const {
        constexpr int kLeast = std::numeric_limits<Int>::min(), kMost = std::numeric_limits<Int>::max();
        if (value < kLeast || value > kMost)
            throw InputError(name_, "the level is too large for the file format: " + std::to_string(value) +
                                        ", expected at most " + std::to_string(kMost));
    }

    template <class Int>
    void put(int value) {
        check<Int>(value);
        append_little_endian(bytes_, static_cast<Int>(value));
    }

    std::string name_;
    bool is_bsp2_;
    std::vector<std::uint8_t> bytes_;
};

std::string texture_lump(const std::vector<std::string>& textures) {
    Lump lump("lump textures", false);
    lump.i32(static_cast<int>(textures.size()));
    std::size_t offset = 4 + 4 * textures.size();
    for (const std::string& texture : textures) {
        lump.i32(static_cast<int>(offset));
        offset += texture.size();
    }
    std::string bytes = lump.bytes();
    for (const std::string& texture : textures) bytes += texture;
    return bytes;
}

std::array<std::string, kLumpCount> lumps_of(const BspFile& bsp, bool is_bsp2) {
    std::array<std::string, kLumpCount> lumps;
    lumps[0] = bsp.entities + '\0';
    lumps[2] = texture_lump(bsp.textures);
    lumps[4] = bsp.visibility;
    lumps[8] = bsp.lighting;
    visit_rows(bsp, [&](std::size_t place, const char* name, const auto& rows, auto fields) {
        Lump lump(name, is_bsp2);
        for (const auto& row : rows) fields(lump, row);
        item(lumps, place) = lump.bytes();
    });
    return lumps;
}

constexpr std::string_view kExtension{"BSPX\1\0\0\0RGBLIGHTING\0\0\0\0\0\0\0\0\0\0\0\0\0", 32};

// One lump behind all others, as engines since Quake's have it: its name in 24 bytes, offset and size.
std::string coloured_light_lump(const BspFile& bsp, std::size_t offset) {
    Lump place("lump RGBLIGHTING", false);
    place.i32(static_cast<int>(offset + kExtension.size() + 8));
    place.i32(static_cast<int>(bsp.coloured_lighting.size()));
    return std::string(kExtension) + place.bytes() + bsp.coloured_lighting;
}

// Little-endian numbers of a lump, one after the other; its offsets and sizes have been checked.
class LumpReader {
  public:
    LumpReader(std::span<const std::uint8_t> bytes, bool is_bsp2) : in_(bytes), is_bsp2_(is_bsp2) {}

    bool is_end() const { return in_.rest() == 0; }

    void u8(std::uint8_t& value) { value = in_.next<std::uint8_t>(); }
    void i32(int& value) { value = in_.next<std::int32_t>(); }
    void u16(int& value) { value = is_bsp2_ ? in_.next<std::int32_t>() : in_.next<std::uint16_t>(); }
    void i16(int& value) { value = is_bsp2_ ? in_.next<std::int32_t>() : in_.next<std::int16_t>(); }
    void number(float& value) {
        const auto bits = in_.next<std::uint32_t>();
        std::memcpy(&value, &bits, sizeof value);
    }
    void floats(Floats& values) {
        for (float& value : values) number(value);
    }
    void box(FileBox& box) {
        for (auto* corner : {&box.mins, &box.maxs})
            for (int& value : *corner) read_bound(value);
    }
    void unused_i32(int count) { in_.take(4 * as_size(count)); }

  private:
    void read_bound(int& value) {
        if (!is_bsp2_) return i16(value);
        float bound = 0;
        number(bound);
        value = static_cast<int>(bound);
    }

    LittleEndianReader in_;
    bool is_bsp2_;
};

void check_own(bool is_own) {
    if (!is_own) throw InputError("file", "another program made this level, expected one of oblong-map (or no --only)");
}

std::string text_of(std::span<const std::uint8_t> bytes) {
    return {bytes.begin(), bytes.end()};
}

std::vector<std::string> read_textures(std::span<const std::uint8_t> lump) {
    LittleEndianReader in(lump);
    std::vector<std::size_t> offsets(in.next<std::uint32_t>());
    for (std::size_t& offset : offsets) offset = in.next<std::uint32_t>();
    offsets.push_back(lump.size());
    std::vector<std::string> textures;
    for (std::size_t i = 0; i + 1 < offsets.size() && offsets[i] <= offsets[i + 1] && offsets[i] < lump.size(); ++i)
        textures.push_back(text_of(lump.subspan(offsets[i], offsets[i + 1] - offsets[i])));
    return textures;
}

}  // namespace

std::vector<int> vertices_at(const BspFile& bsp, const FileFace& face) {
    std::vector<int> corners;
    for (int i = 0; i < face.edge_count; ++i) {
        const int edge = item(bsp.surf_edges, face.first_surf_edge + i);
        corners.push_back(item(bsp.edges, std::abs(edge))[edge < 0 ? 1 : 0]);
    }
    return corners;
}

std::vector<LumpCount> lump_counts(const BspFile& bsp) {
    const char* const less = "by a smaller level or simpler brushes";
    const char* const uncut = "by 'func_detail' for what hides nothing";
    const char* const larger = "by larger texture scales, or a smaller level";
    return {{"planes", bsp.planes.size(), kMostI16, less},
            {"vertices", bsp.vertices.size(), kMostU16, less},
            {"nodes", bsp.nodes.size(), kMostI16, uncut},
            {"texinfos", bsp.texinfos.size(), kMostI16, "by aligning textures the same way"},
            {"faces", bsp.faces.size(), kMostU16, larger},
            {"clip nodes", bsp.clip_nodes.size(), kMostI16, "by 'clip' brushes around fine shapes"},
            {"leaves", bsp.leaves.size(), kMostI16, uncut},
            {"mark faces", bsp.mark_faces.size(), kMostU16, larger}};
}

bool needs_bsp2(const BspFile& bsp) {
    const std::vector<LumpCount> counts = lump_counts(bsp);
    return std::any_of(counts.begin(), counts.end(), [](const LumpCount& lump) { return lump.count > lump.most; });
}

std::string summary_of(const BspFile& bsp) {
    const auto lit =
        std::count_if(bsp.faces.begin(), bsp.faces.end(), [](const FileFace& face) { return face.light_offset >= 0; });
    std::string text = std::to_string(bsp.faces.size()) + " faces, " + std::to_string(bsp.leaves.size()) + " leaves, " +
                       std::to_string(bsp.models.size()) + " models, " + std::to_string(lit) + " lightmaps of " +
                       std::to_string(bsp.lighting.size()) + " bytes";
    for (const LumpCount& lump : lump_counts(bsp))
        if (lump.count > lump.most / 2)
            text += ", " + std::to_string(lump.count) + " of " + std::to_string(lump.most) + " " + lump.name;
    return text + (needs_bsp2(bsp) ? ", so BSP2" : "");
}

void check_size(const BspFile& bsp) {
    lumps_of(bsp, needs_bsp2(bsp));
}

std::string to_bytes(const BspFile& bsp) {
    const bool is_bsp2 = needs_bsp2(bsp);
    const auto lumps = lumps_of(bsp, is_bsp2);
    Lump header("header", is_bsp2);
    header.i32(is_bsp2 ? kVersion2 : kVersion);
    std::size_t offset = 4 + 8 * kLumpCount;
    std::string body;
    for (const std::string& lump : lumps) {
        header.i32(static_cast<int>(offset + body.size()));
        header.i32(static_cast<int>(lump.size()));
        body += lump;
        body.resize((body.size() + 3) / 4 * 4);  // every lump begins at a multiple of 4
    }
    if (!bsp.coloured_lighting.empty()) body += coloured_light_lump(bsp, offset + body.size());
    return header.bytes() + body;
}

BspFile from_bytes(const std::string& bytes) {
    const std::span file(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
    read_bsp(file);  // checks all that is read here
    const auto version = static_cast<int>(little_endian_u32(file.data()));
    check_own(version == kVersion || version == kVersion2);
    const auto lump = [&](std::size_t index) {
        LittleEndianReader header(file, 4 + 8 * index);
        const auto offset = header.next<std::uint32_t>(), length = header.next<std::uint32_t>();
        return file.subspan(offset, length);
    };
    BspFile bsp;
    bsp.entities = text_of(lump(0));
    bsp.entities.resize(std::min(bsp.entities.find('\0'), bsp.entities.size()));
    bsp.textures = read_textures(lump(2));
    bsp.visibility = text_of(lump(4));
    bsp.lighting = text_of(lump(8));
    if (const auto extension = bytes.find(kExtension); extension != std::string::npos)
        bsp.coloured_lighting = bytes.substr(extension + kExtension.size() + 8);
    visit_rows(bsp, [&](std::size_t place, const char*, auto& rows, auto fields) {
        for (LumpReader in(lump(place), version == kVersion2); !in.is_end();) fields(in, rows.emplace_back());
    });
    check_own(to_bytes(bsp) == bytes);
    return bsp;
}

}  // namespace oblong::map
