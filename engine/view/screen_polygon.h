#pragma once

#include <cstdint>
#include <span>
#include <utility>

#include "engine/base/scratch.h"
#include "engine/base/table.h"
#include "engine/view/clip.h"
#include "engine/view/view_context.h"

namespace oblong {

using VertexIndex = Index<struct Vertex>;  ///< of the level's vertices

/// A vertex of the level in one frame's view.
struct CachedVertex : ClipVertex {
    std::uint32_t frame = 0;  ///< in which this was computed
};

/// The level's vertices in viewspace and, if they are inside the view, on the screen; each computed once a frame, on
/// first use.
class VertexCache {
  public:
    /// `world_vertices` must outlive it.
    explicit VertexCache(const Table<Vec3<World>, Vertex>& world_vertices)
        : world_(world_vertices), vertices_(world_vertices.size()) {}

    void start_frame() { ++frame_; }

    /// Memory used.
    std::size_t bytes() const { return vertices_.size() * sizeof(CachedVertex); }

    struct Counts {
        std::int64_t transformed = 0, projected = 0;
    };
    /// The vertices computed in this frame. Slow, reads all vertices; for counted frames only.
    Counts count() const {
        Counts counts;
        for (const CachedVertex& vertex : vertices_) {
            if (vertex.frame != frame_) continue;
            ++counts.transformed;
            counts.projected += vertex.is_projected;
        }
        return counts;
    }

    template <bool AdjustsPositions>
    CachedVertex& get(VertexIndex index, const ViewContext& view) {
        CachedVertex& vertex = vertices_[index];
        if (vertex.frame == frame_) return vertex;
        vertex.is_projected = place_vertex<AdjustsPositions>(world_[index], view, vertex);
        vertex.undecided = 0;
        vertex.frame = frame_;
        return vertex;
    }

  private:
    const Table<Vec3<World>, Vertex>& world_;
    Table<CachedVertex, Vertex> vertices_;
    std::uint32_t frame_ = 0;
};

/// A transformed, clipped and projected polygon, with scratch.
struct ScreenPolygon {
    std::span<const ScreenVertex> vertices;
    bool is_clipped = false;  ///< some of its corners are not from the vertex cache

    PolygonClipper clipper;
    Scratch<ClipVertex> own;          ///< corners that are not from the vertex cache
    Scratch<ScreenVertex> projected;  ///< the storage of `vertices`

    /// The nearest and the farthest z of the part in view.
    std::pair<View, View> z_range() const;
};

/// Transforms, clips and projects a face of the level, given its vertices' indices, clockwise seen from its front.
/// False if it is outside the view.
bool project_face(std::span<const VertexIndex> corner_indices, const ViewContext& view, VertexCache& vertices,
                  ScreenPolygon& polygon);

/// The same for any polygon in the world.
bool project_polygon(std::span<const Vec3<World>> corners, const ViewContext& view, ScreenPolygon& polygon);

}  // namespace oblong
