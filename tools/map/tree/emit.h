#pragma once

#include <cstdint>
#include <unordered_map>

#include "tools/map/tree/bsp_file.h"
#include "tools/map/tree/mesh.h"

namespace oblong::map {

/// Numbers compiled models for the file, the world first.
class Emitter {
  public:
    Emitter(BspFile& bsp, const PlaneList& planes);

    /// Appends a model with its planes, vertices, edges, faces, nodes, leaves and hulls. Returns, for each
    /// leaf of the model's tree, its index in the file (0 for solid leaves).
    std::vector<int> add_model(const CompiledModel& model);

    /// After the level has its textures.
    void add_texinfos(const std::vector<TexInfo>& texinfos);

  private:
    struct Numbering;

    int plane_index(int plane);
    void add_face(const Surface& surface, int first_vertex);
    int surf_edge(int from, int to);
    void mark_faces(const CompiledModel& model, Numbering& numbering);
    int add_child(const CompiledModel& model, int child, Numbering& numbering, Box& box);
    int add_node(const CompiledModel& model, int child, Numbering& numbering, Box& box);
    int add_leaf(const TreeLeaf& leaf, const std::vector<int>& faces);
    int add_clip_child(const Tree& hull, int child);

    BspFile& bsp_;
    const PlaneList& planes_;
    std::vector<int> plane_indices_;
    std::unordered_map<std::uint64_t, int> open_edges_;  // used by only one face so far, by both vertices
};

}  // namespace oblong::map
