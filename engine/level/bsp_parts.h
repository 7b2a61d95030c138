#pragma once

#include <vector>

#include "engine/level/bsp_file.h"
#include "engine/level/level.h"

namespace oblong {

// The reader's parts: each turns one lump into its piece of the Level and checks all that it says. They depend on the
// counts of other lumps, not on their contents, except where an argument says so.

std::vector<LevelPlane> read_planes(const BspFile& file);
std::vector<FloatBits3> read_vertex_floats(const BspFile& file);
std::vector<Vec3<World>> read_vertices(const BspFile& file);
std::vector<EdgeIndices> read_edges(const BspFile& file);
std::vector<std::int32_t> read_surf_edges(const BspFile& file);

std::vector<MipTexture> read_textures(const BspFile& file);
/// Needs the names of level.textures.
std::vector<TexInfo> read_texinfos(const BspFile& file, const Level& level);
/// Needs edges, surf_edges and texinfos.
std::vector<Face> read_faces(const BspFile& file, const Level& level, const std::vector<FloatBits3>& vertex_floats);

std::vector<std::int32_t> read_mark_faces(const BspFile& file);
std::vector<Node> read_nodes(const BspFile& file);
std::vector<ClipNode> read_clip_nodes(const BspFile& file);
std::vector<Leaf> read_leaves(const BspFile& file);
std::vector<SubModel> read_models(const BspFile& file);

/// A box of six numbers, mins and maxs, in floats or in 16 bits.
LevelBox read_box(LumpReader& in, bool has_floats);
/// Three floats within the world.
Vec3<World> read_world_vector(LumpReader& in);

/// Every node has at most one parent and every way down ends, within kMaxTreeDepth steps.
void check_node_tree(const BspFile& file, const std::vector<Node>& nodes);
/// Every way down ends, within kMaxTreeDepth steps; subtrees may be shared.
void check_clip_nodes(const BspFile& file, const std::vector<ClipNode>& clip_nodes);
/// The packed row of each leaf decodes to the world's number of visible leaves inside the lump.
void check_visibility(const BspFile& file, const Level& level);

/// Deeper trees are refused, so that walking them recursively is safe. Real levels stay below 100.
inline constexpr int kMaxTreeDepth = 1024;

/// A face with a lightmap may be this many texels long: what later engines accept; Quake itself stops at 256.
inline constexpr std::int32_t kMaxLitExtent = 2000;

}  // namespace oblong
