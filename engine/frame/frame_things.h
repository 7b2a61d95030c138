#pragma once

#include <span>
#include <vector>

#include "engine/effects/things_in_view.h"
#include "engine/mesh/placed_mesh.h"

namespace oblong {

/// A visible thing: the dots of an emitter, or a sprite.
struct VisibleThing {
    Vec3<World> middle;
    World lowest_z;                            ///< of its box, or below
    std::size_t first_dot = 0, dot_count = 0;  ///< in ThingsInView::dots
    const ScreenSprite* sprite = nullptr;
    const std::uint8_t* colours = nullptr;  ///< of the sprite: 256
};

/// A mesh that may own pixels.
struct MeshInView {
    const PlacedMesh* placed = nullptr;
    const MeshTransform* transform = nullptr;
    LevelBox box;
    ScreenRectangle box_pixels{};
    InverseDepth nearest_inverse_depth = 0;      ///< of the box
    ScreenRectangle pixels{};                    ///< of the parts that may be visible
    std::size_t first_part = 0, part_count = 0;  ///< in FrameThings::mesh_parts; none: the whole mesh
};

/// What a frame shows besides faces.
struct FrameThings {
    ThingsInView in_view;
    std::vector<VisibleThing> visible;
    std::vector<Shadow> shadows;
    std::vector<MeshInView> meshes;
    std::vector<std::uint32_t> mesh_parts;

    void clear();
    std::span<const std::uint32_t> parts_of(const MeshInView& mesh) const {
        return std::span(mesh_parts).subspan(mesh.first_part, mesh.part_count);
    }
};

}  // namespace oblong
