#include "tools/map/tree/bsp_file.h"

#include <algorithm>
#include <cstring>

#include "engine/base/input_error.h"

namespace oblong::map {
namespace {

constexpr int kVersion = 29, kVersion2 = 0x32505342;  // the latter: "BSP2"
constexpr std::size_t kLumpCount = 15;
constexpr std::size_t kMostI16 = 32767, kMostU16 = 65535;

// Little-endian numbers, one after the other. In BSP2 counts and indices have 32 bits, and boxes are floats.
class Lump {
  public:
    Lump(std::string name, bool is_bsp2) : name_(std::move(name)), is_bsp2_(is_bsp2) {}

    void put_u8(int value) { bytes.push_back(static_cast<char>(value)); }
    void put_i16(int value) { is_bsp2_ ? put_i32(value) : put(value, 2, -32768, 32767); }
    void put_u16(int value) { is_bsp2_ ? put_i32(value) : put(value, 2, 0, 65535); }
    void put_i32(int value) { put(value, 4, INT32_MIN, INT32_MAX); }
    void put_float(float value) {
        std::int32_t bits = 0;
        static_assert(sizeof bits == sizeof value);
        std::memcpy(&bits, &value, sizeof bits);
        put_i32(bits);
    }
    void put_floats(const Floats& values) {
        for (const float value : values) put_float(value);
    }
    void put_box(const FileBox& box) {
        for (const int value : box.mins) put_bound(value);
        for (const int value : box.maxs) put_bound(value);
    }

    std::string bytes;

  private:
    void put_bound(int value) {
        check(value, -32768, 32767);
        is_bsp2_ ? put_float(static_cast<float>(value)) : put_i16(value);
    }

    void check(int value, int lowest, int highest) const {
        if (value < lowest || value > highest)
            throw InputError(name_, "the level is too large for the format: " + std::to_string(value) +
                                        ", expected at most " + std::to_string(highest));
    }

    void put(int value, int size, int lowest, int highest) {
        check(value, lowest, highest);
        auto rest = static_cast<std::uint32_t>(value);
        for (int i = 0; i < size; ++i, rest >>= 8) put_u8(static_cast<int>(rest & 255));
    }

    std::string name_;
    bool is_bsp2_;
};

template <class Items, class Put>
std::string lump_of(const char* name, bool is_bsp2, const Items& items, Put put) {
    Lump lump(name, is_bsp2);
    for (const auto& item : items) put(lump, item);
    return std::move(lump.bytes);
}

void put_plane(Lump& lump, const FilePlane& plane) {
    lump.put_floats(plane.normal);
    lump.put_float(plane.distance);
    lump.put_i32(plane.type);
}

void put_node(Lump& lump, const FileNode& node) {
    lump.put_i32(node.plane);
    for (const int child : node.children) lump.put_i16(child);
    lump.put_box(node.box);
    lump.put_u16(node.first_face);
    lump.put_u16(node.face_count);
}

void put_texinfo(Lump& lump, const FileTexInfo& texinfo) {
    for (const auto& axis : texinfo.axes) {
        lump.put_floats(axis.direction);
        lump.put_float(axis.offset);
    }
    lump.put_i32(texinfo.texture);
    lump.put_i32(texinfo.flags);
}

void put_face(Lump& lump, const FileFace& face) {
    lump.put_i16(face.plane);
    lump.put_i16(face.is_back);
    lump.put_i32(face.first_surf_edge);
    lump.put_i16(face.edge_count);
    lump.put_i16(face.texinfo);
    for (const int style : face.styles) lump.put_u8(style);
    lump.put_i32(face.light_offset);
}

void put_clip_node(Lump& lump, const FileClipNode& node) {
    lump.put_i32(node.plane);
    for (const int child : node.children) lump.put_i16(child);
}

void put_leaf(Lump& lump, const FileLeaf& leaf) {
    lump.put_i32(leaf.contents);
    lump.put_i32(leaf.visibility_offset);
    lump.put_box(leaf.box);
    lump.put_u16(leaf.first_mark_face);
    lump.put_u16(leaf.mark_face_count);
    lump.put_i32(0);  // four levels of ambient sound
}

void put_model(Lump& lump, const FileModel& model) {
    lump.put_floats(model.mins);
    lump.put_floats(model.maxs);
    lump.put_floats({});  // the origin
    for (const int head : model.head_nodes) lump.put_i32(head);
    lump.put_i32(model.visible_leaf_count);
    lump.put_i32(model.first_face);
    lump.put_i32(model.face_count);
}

std::string texture_lump(const std::vector<std::string>& textures) {
    Lump lump("lump textures", false);
    lump.put_i32(static_cast<int>(textures.size()));
    std::size_t offset = 4 + 4 * textures.size();
    for (const std::string& texture : textures) {
        lump.put_i32(static_cast<int>(offset));
        offset += texture.size();
    }
    for (const std::string& texture : textures) lump.bytes += texture;
    return std::move(lump.bytes);
}

std::array<std::string, kLumpCount> lumps_of(const BspFile& bsp, bool is_bsp2) {
    const auto lump = [is_bsp2](const char* name, const auto& items, auto put) {
        return lump_of(name, is_bsp2, items, put);
    };
    return {bsp.entities + '\0',
            lump("lump planes", bsp.planes, put_plane),
            texture_lump(bsp.textures),
            lump("lump vertices", bsp.vertices, [](Lump& out, const auto& vertex) { out.put_floats(vertex); }),
            bsp.visibility,
            lump("lump nodes", bsp.nodes, put_node),
            lump("lump texinfos", bsp.texinfos, put_texinfo),
            lump("lump faces", bsp.faces, put_face),
            bsp.lighting,
            lump("lump clip nodes", bsp.clip_nodes, put_clip_node),
            lump("lump leaves", bsp.leaves, put_leaf),
            lump("lump mark faces", bsp.mark_faces, [](Lump& out, int face) { out.put_u16(face); }),
            lump("lump edges", bsp.edges,
                 [](Lump& out, const auto& edge) {
                     out.put_u16(edge[0]);
                     out.put_u16(edge[1]);
                 }),
            lump("lump surface edges", bsp.surf_edges, [](Lump& out, int edge) { out.put_i32(edge); }),
            lump("lump models", bsp.models, put_model)};
}

}  // namespace

std::vector<LumpCount> lump_counts(const BspFile& bsp) {
    const char* const less = "by a smaller level or simpler brushes";
    const char* const uncut = "by 'func_detail' for what hides nothing";
    const char* const larger = "by larger texture scales, or a smaller level";
    return {{"planes", bsp.planes.size(), kMostI16, less},
            {"vertices", bsp.vertices.size(), kMostU16, less},
            {"nodes", bsp.nodes.size(), kMostI16, uncut},
            {"texinfos", bsp.texinfos.size(), kMostI16, "by textures that lie alike"},
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
    header.put_i32(is_bsp2 ? kVersion2 : kVersion);
    std::size_t offset = 4 + 8 * kLumpCount;
    std::string body;
    for (const std::string& lump : lumps) {
        header.put_i32(static_cast<int>(offset + body.size()));
        header.put_i32(static_cast<int>(lump.size()));
        body += lump;
        body.resize((body.size() + 3) / 4 * 4);  // every lump begins at a multiple of 4
    }
    return header.bytes + body;
}

}  // namespace oblong::map
