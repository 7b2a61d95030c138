#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>

#include "engine/base/little_endian.h"
#include "engine/base/table.h"
#include "engine/level/bsp_floats.h"
#include "engine/level/level.h"

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

/// Throws an InputError for an error in a lump; `file_offset` is where the wrong field starts in the file.
[[noreturn]] void fail_in_lump(Lump lump, std::int64_t file_offset, const std::string& what_is_wrong);

/// "plane 9, expected 0 to 7", or "plane 9, expected none: the file has no plane".
std::string describe_bad_index(const char* what, std::int64_t index, std::int64_t count);

struct LumpRange {
    std::int32_t offset = 0, size = 0;  ///< bytes in the file
};

/// A level file with checked version and lump table.
struct BspFile {
    std::span<const std::uint8_t> bytes;
    BspFormat format;
    std::array<LumpRange, kLumpCount> lumps;

    LumpRange range(Lump lump) const { return item(lumps, lump); }
    std::span<const std::uint8_t> lump_bytes(Lump lump) const;
    /// The number of records in the lump (bytes if it has no records).
    std::int32_t count(Lump lump) const { return range(lump).size / item(format.record_sizes, lump); }
};

/// Checks the version, and that every lump is behind the header, inside the file, and holds whole records.
BspFile open_bsp(std::span<const std::uint8_t> bytes);

/// Reads the little-endian numbers of a lump in sequence, on any machine. Throws InputError at the lump's end.
class LumpReader {
  public:
    LumpReader(const BspFile& file, Lump lump)
        : bytes_(file.lump_bytes(lump)), file_offset_(file.range(lump).offset), lump_(lump), format_(file.format) {}

    std::int64_t size() const { return static_cast<std::int64_t>(bytes_.size()); }
    /// Continues at this byte of the lump, which may be its end.
    void seek(std::int64_t lump_offset);
    std::span<const std::uint8_t> read_bytes(std::int64_t size) { return {take(size), as_size(size)}; }
    void skip(std::int64_t size) { read_bytes(size); }

    std::uint8_t read_u8() { return take(1)[0]; }
    std::uint32_t read_u16() {
        const std::uint8_t* const two = take(2);
        return std::uint32_t{two[0]} | std::uint32_t{two[1]} << 8;
    }
    std::int32_t read_i16() {
        const auto value = static_cast<std::int32_t>(read_u16());
        return value < 0x8000 ? value : value - 0x10000;
    }
    std::uint32_t read_u32() { return little_endian_u32(take(4)); }
    std::int32_t read_i32() { return static_cast<std::int32_t>(read_u32()); }
    FloatBits read_float() { return FloatBits{read_u32()}; }

    /// An index or count of the format's width.
    std::int32_t read_index() { return format_.has_wide_indices ? read_i32() : static_cast<std::int32_t>(read_u16()); }
    /// A child in a tree of `record_count` nodes: an index, or negative.
    std::int32_t read_child(std::int32_t record_count);

    /// Throws unless 0 <= index < count; `what` names the records.
    std::int32_t check_index(std::int32_t index, std::int32_t count, const char* what) const {
        if (index < 0 || index >= count) fail(describe_bad_index(what, index, count));
        return index;
    }
    /// Throws unless [first, first + size) is in [0, count).
    void check_extent(std::int64_t first, std::int64_t size, std::int64_t count, const char* what) const;
    template <class Record>
    IndexRange<Record> check_range(std::int32_t first, std::int32_t size, std::int64_t count, const char* what) const {
        check_extent(first, size, count, what);
        return {Index<Record>(first), size};
    }
    /// The float read last, in fixed point: value * 2^fraction_bits, rounded to nearest. Throws unless |value| < limit.
    std::int64_t check_fixed(FloatBits value, int fraction_bits, std::int32_t limit, const char* what) const;
    std::int64_t read_fixed(int fraction_bits, std::int32_t limit, const char* what) {
        return check_fixed(read_float(), fraction_bits, limit, what);
    }

    /// Throws an InputError that names the lump and the offset of the field read last.
    [[noreturn]] void fail(const std::string& what_is_wrong) const;

  private:
    const std::uint8_t* take(std::int64_t size_wanted) {
        field_ = position_;
        if (size_wanted < 0 || size_wanted > size() - position_) fail_to_take(size_wanted);
        position_ += size_wanted;
        return bytes_.data() + field_;
    }
    [[noreturn]] void fail_to_take(std::int64_t size_wanted) const;

    std::span<const std::uint8_t> bytes_;
    std::int64_t file_offset_ = 0, position_ = 0, field_ = 0;
    Lump lump_;
    BspFormat format_;
};

// The parts of the reader: each reads one lump into the Level and checks all its contents. They depend on the counts of
// other lumps, and on their contents only where an argument says so.

Table<LevelPlane> read_planes(const BspFile& file);
Table<FloatBits3, Vertex> read_vertex_floats(const BspFile& file);
Table<Vec3<World>, Vertex> read_vertices(const BspFile& file);
Table<Edge> read_edges(const BspFile& file);
Table<SurfEdge> read_surf_edges(const BspFile& file);

Table<MipTexture> read_textures(const BspFile& file);
/// The lump RGBLIGHTING of later engines' files: "BSPX" and a list of lumps behind all others (name in 24 bytes,
/// offset, size). Empty without it, and if it has other samples than the lump 'lighting' (some compilers make finer
/// ones).
std::vector<std::uint8_t> read_coloured_lighting(const BspFile& file);
/// Uses the names of level.textures.
Table<TexInfo> read_texinfos(const BspFile& file, const Level& level);
/// Uses edges, surf_edges and texinfos.
Table<Face> read_faces(const BspFile& file, const Level& level, const Table<FloatBits3, Vertex>& vertex_floats);
/// Faces that the file flags as unlit are lit all the same if it has light for one of their texinfo, as in Quake, which
/// asks only for the texture's name.
void light_flagged_faces(Level& level);

Table<FaceIndex, MarkFace> read_mark_faces(const BspFile& file);
Table<Node> read_nodes(const BspFile& file);
Table<ClipNode> read_clip_nodes(const BspFile& file);
Table<Leaf> read_leaves(const BspFile& file);
Table<SubModel> read_models(const BspFile& file);

/// All records of a lump, each read by read_one(in).
template <class RecordTable, class ReadOne>
RecordTable read_records(const BspFile& file, Lump lump, ReadOne read_one) {
    LumpReader in(file, lump);
    RecordTable records;
    records.reserve(as_size(file.count(lump)));
    for (std::int32_t i = 0; i < file.count(lump); ++i) records.push_back(read_one(in));
    return records;
}

/// An index into another lump's records. Throws unless the record exists; `what` names the records.
template <class Record>
Index<Record> check_index(const LumpReader& in, std::int32_t number, const BspFile& file, Lump lump, const char* what) {
    return Index<Record>(in.check_index(number, file.count(lump), what));
}

/// Three floats within the world.
Vec3<World> read_world_vector(LumpReader& in);

/// Deeper trees are rejected, so that recursion is safe. Real levels stay below 100.
inline constexpr int kMaxTreeDepth = 1024;

/// The largest extent of a face with a lightmap, in texels, as in later engines; Quake's limit is 256.
inline constexpr std::int32_t kMaxLitExtent = 2000;

}  // namespace oblong
