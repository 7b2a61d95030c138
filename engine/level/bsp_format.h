#pragma once

#include <array>
#include <cstdint>

namespace oblong {

/// The lumps of a level file, in the order of its header.
enum class Lump : std::uint8_t {
    Entities,
    Planes,
    Textures,
    Vertices,
    Visibility,
    Nodes,
    TexInfos,
    Faces,
    Lighting,
    ClipNodes,
    Leaves,
    MarkFaces,
    Edges,
    SurfEdges,
    Models
};
inline constexpr int kLumpCount = 15;

/// Names for error messages.
inline constexpr std::array<const char*, kLumpCount> kLumpNames = {
    "entities", "planes",    "textures", "vertices",  "visibility", "nodes",     "texinfos", "faces",
    "lighting", "clipnodes", "leaves",   "markfaces", "edges",      "surfedges", "models"};

/// The file starts with a version of 4 bytes, then for each lump its offset in the file and its size in bytes (two
/// signed 32-bit numbers). All numbers are little-endian.
inline constexpr int kBspHeaderSize = 4 + kLumpCount * 8;

/// The three formats differ in the widths of indices and boxes. The fields of each record, in order (`index`: 16 bits
/// unsigned, or 32 signed in the wide formats; `box`: 6 numbers, mins then maxs):
///
///     plane     3 float normal, float distance, i32 type
///     vertex    3 float
///     node      i32 plane, 2 child, box, index first_face, index face_count
///     texinfo   4 float s, 4 float t, i32 miptex, i32 flags
///     face      index plane, index side, i32 first_surfedge, index edge_count, index texinfo, 4 u8 style, i32 light
///     clipnode  i32 plane, 2 child
///     leaf      i32 contents, i32 visibility, box, index first_mark, index mark_count, 4 u8 ambient sound
///     markface  index
///     edge      2 index vertex
///     surfedge  i32
///     model     float box, 3 float origin, 4 i32 head node, i32 visible leaves, i32 first_face, i32 face_count
///
/// A child of 16 bits is an index if it is below the number of records, otherwise the value minus 65,536; this allows
/// more than 32,767 clipnodes. A negative child c of a node is leaf -1 - c; that of a clipnode is a leaf's contents.
///
/// textures: i32 count, count i32 offsets from the lump's start (-1: none); at each: 16 bytes of name, u32 width,
/// u32 height, 4 u32 offsets of the mip levels from the texture's start (0: the texels are elsewhere), and the texels.
struct BspFormat {
    std::uint32_t version = 0;
    const char* name = "";
    bool has_wide_indices = false;
    bool has_float_boxes = false;              ///< of nodes and leaves; otherwise signed 16-bit numbers
    std::array<int, kLumpCount> record_sizes;  ///< in bytes; 1 if a lump has no records
};

/// A version from its four letters in the file.
constexpr std::uint32_t version_from_letters(const char (&letters)[5]) {
    std::uint32_t version = 0;
    for (int i = 3; i >= 0; --i) version = version << 8 | static_cast<std::uint8_t>(letters[i]);
    return version;
}

inline constexpr std::array<BspFormat, 3> kBspFormats = {{
    {29, "BSP 29", false, false, {1, 20, 1, 12, 1, 24, 40, 20, 1, 8, 28, 2, 4, 4, 64}},
    {version_from_letters("BSP2"), "BSP2", true, true, {1, 20, 1, 12, 1, 44, 40, 28, 1, 12, 44, 4, 8, 4, 64}},
    {version_from_letters("2PSB"), "2PSB", true, false, {1, 20, 1, 12, 1, 32, 40, 28, 1, 12, 32, 4, 8, 4, 64}},
}};

/// Bits of a texinfo's flags.
inline constexpr std::uint32_t kTexInfoSpecial = 1;  ///< sky or liquid: no lightmap

}  // namespace oblong
