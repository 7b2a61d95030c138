#include "tools/map/tree/bsp_read.h"

#include <cstdint>
#include <cstring>

#include "engine/base/input_error.h"
#include "engine/level/bsp_read.h"

namespace oblong::map {
namespace {

// Little-endian numbers of a lump, one after the other; its offsets and sizes have been checked.
class LumpReader {
  public:
    LumpReader(const std::string& file, std::size_t lump, bool is_bsp2) : is_bsp2_(is_bsp2) {
        LumpReader header(file, 4 + 8 * lump);
        const auto offset = static_cast<std::size_t>(header.i32());
        bytes_ = std::string_view(file).substr(offset, static_cast<std::size_t>(header.i32()));
    }

    bool is_end() const { return at_ >= bytes_.size(); }
    std::string_view bytes() const { return bytes_; }

    int u8() { return static_cast<unsigned char>(bytes_[at_++]); }
    int i32() {
        std::uint32_t value = 0;
        for (unsigned i = 0; i < 4; ++i) value |= static_cast<std::uint32_t>(u8()) << (8 * i);
        return static_cast<int>(value);
    }
    int u16() {
        if (is_bsp2_) return i32();
        const int low = u8();
        return low + 256 * u8();
    }
    int i16() { return is_bsp2_ ? i32() : static_cast<std::int16_t>(u16()); }
    float number() {
        const int bits = i32();
        float value = 0;
        std::memcpy(&value, &bits, sizeof value);
        return value;
    }
    Floats floats() {
        const float x = number(), y = number();
        return {x, y, number()};
    }
    FileBox box() {
        FileBox box;
        for (auto* corner : {&box.mins, &box.maxs})
            for (int& value : *corner) value = is_bsp2_ ? static_cast<int>(number()) : i16();
        return box;
    }

  private:
    LumpReader(const std::string& file, std::size_t at) : is_bsp2_(false), bytes_(file), at_(at) {}

    bool is_bsp2_;
    std::string_view bytes_;
    std::size_t at_ = 0;
};

template <class Item, class Read>
void read_all(LumpReader lump, std::vector<Item>& items, Read read) {
    while (!lump.is_end()) items.push_back(read(lump));
}

FileNode read_node(LumpReader& in) {
    FileNode node;
    node.plane = in.i32();
    for (int& child : node.children) child = in.i16();
    node.box = in.box();
    node.first_face = in.u16();
    node.face_count = in.u16();
    return node;
}

FileTexInfo read_texinfo(LumpReader& in) {
    FileTexInfo texinfo;
    for (FileTexAxis& axis : texinfo.axes) {
        axis.direction = in.floats();
        axis.offset = in.number();
    }
    texinfo.texture = in.i32();
    texinfo.flags = in.i32();
    return texinfo;
}

FileFace read_face(LumpReader& in) {
    FileFace face;
    face.plane = in.i16();
    face.is_back = in.i16();
    face.first_surf_edge = in.i32();
    face.edge_count = in.i16();
    face.texinfo = in.i16();
    for (std::uint8_t& style : face.styles) style = static_cast<std::uint8_t>(in.u8());
    face.light_offset = in.i32();
    return face;
}

FileLeaf read_leaf(LumpReader& in) {
    FileLeaf leaf;
    leaf.contents = in.i32();
    leaf.visibility_offset = in.i32();
    leaf.box = in.box();
    leaf.first_mark_face = in.u16();
    leaf.mark_face_count = in.u16();
    in.i32();
    return leaf;
}

FileModel read_model(LumpReader& in) {
    FileModel model;
    model.mins = in.floats();
    model.maxs = in.floats();
    in.floats();
    for (int& head : model.head_nodes) head = in.i32();
    model.visible_leaf_count = in.i32();
    model.first_face = in.i32();
    model.face_count = in.i32();
    return model;
}

std::vector<std::string> read_textures(LumpReader lump) {
    std::vector<std::size_t> offsets;
    for (int left = lump.i32(); left > 0; --left) offsets.push_back(static_cast<std::uint32_t>(lump.i32()));
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
    read_all(lump(1), bsp.planes, [](LumpReader& in) {
        const Floats normal = in.floats();
        const float distance = in.number();
        return FilePlane{normal, distance, in.i32()};
    });
    bsp.textures = read_textures(lump(2));
    read_all(lump(3), bsp.vertices, [](LumpReader& in) { return in.floats(); });
    bsp.visibility = lump(4).bytes();
    read_all(lump(5), bsp.nodes, read_node);
    read_all(lump(6), bsp.texinfos, read_texinfo);
    read_all(lump(7), bsp.faces, read_face);
    bsp.lighting = lump(8).bytes();
    read_all(lump(9), bsp.clip_nodes, [](LumpReader& in) {
        FileClipNode node;
        node.plane = in.i32();
        for (int& child : node.children) child = in.i16();
        return node;
    });
    read_all(lump(10), bsp.leaves, read_leaf);
    read_all(lump(11), bsp.mark_faces, [](LumpReader& in) { return in.u16(); });
    read_all(lump(12), bsp.edges, [](LumpReader& in) {
        const int from = in.u16();
        return std::array{from, in.u16()};
    });
    read_all(lump(13), bsp.surf_edges, [](LumpReader& in) { return in.i32(); });
    read_all(lump(14), bsp.models, read_model);
    if (to_bytes(bsp) != bytes)
        throw InputError("file", "another program made this level, expected one of oblong-map (or no --only)");
    return bsp;
}

}  // namespace oblong::map
