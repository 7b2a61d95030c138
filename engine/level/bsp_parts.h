#pragma once

#include "engine/base/table.h"
#include "engine/level/bsp_file.h"
#include "engine/level/level.h"

namespace oblong {

// The parts of the reader: each reads one lump into the Level and checks all its contents. They depend on the counts of
// other lumps, and on their contents only where an argument says so.

Table<LevelPlane> read_planes(const BspFile& file);
Table<FloatBits3, Vertex> read_vertex_floats(const BspFile& file);
Table<Vec3<World>, Vertex> read_vertices(const BspFile& file);
Table<Edge> read_edges(const BspFile& file);
Table<SurfEdge> read_surf_edges(const BspFile& file);

Table<MipTexture> read_textures(const BspFile& file);
/// Uses the names of level.textures.
Table<TexInfo> read_texinfos(const BspFile& file, const Level& level);
/// Uses edges, surf_edges and texinfos.
Table<Face> read_faces(const BspFile& file, const Level& level, const Table<FloatBits3, Vertex>& vertex_floats);

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

/// A box of six numbers, mins and maxs, in floats or 16-bit integers.
LevelBox read_box(LumpReader& in, bool has_floats);
/// Three floats within the world.
Vec3<World> read_world_vector(LumpReader& in);

/// Checks that every node has at most one parent, and every path down ends within kMaxTreeDepth steps.
void check_node_tree(const BspFile& file, const Table<Node>& nodes);
/// Checks that every path down ends within kMaxTreeDepth steps; subtrees may be shared.
void check_clip_nodes(const BspFile& file, const Table<ClipNode>& clip_nodes);
/// Checks that the packed row of each leaf decodes to the world's number of visible leaves, inside the lump.
void check_visibility(const BspFile& file, const Level& level);

/// Deeper trees are rejected, so that recursion is safe. Real levels stay below 100.
inline constexpr int kMaxTreeDepth = 1024;

/// The largest extent of a face with a lightmap, in texels, as in later engines; Quake's limit is 256.
inline constexpr std::int32_t kMaxLitExtent = 2000;

}  // namespace oblong
