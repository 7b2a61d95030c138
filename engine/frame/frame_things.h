#pragma once

#include <span>
#include <vector>

#include "engine/effects/things_in_view.h"
#include "engine/mesh/placed_mesh.h"

namespace oblong {

struct FrameContext;
struct ViewScratch;

/// The dots of an emitter, or a sprite, that owns pixels.
struct OwningThing {
    Vec3<World> middle;
    World lowest;                              ///< or lower
    std::size_t first_dot = 0, dot_count = 0;  ///< in ThingsInView::dots
    const ScreenSprite* sprite = nullptr;
    const std::uint8_t* colours = nullptr;  ///< of the sprite: 256 of them
};

/// A mesh that may own pixels, within these.
struct MeshInView {
    const PlacedMesh* placed = nullptr;
    LevelBox box;
    ScreenRectangle box_pixels{};
    InverseDepth nearest_depth = 0;              ///< of the box
    ScreenRectangle pixels{};                    ///< of the parts that may show
    std::size_t first_part = 0, part_count = 0;  ///< in FrameThings::mesh_parts; none: all of it
};

/// What a frame shows beside its faces.
struct FrameThings {
    ThingsInView in_view;
    std::vector<OwningThing> owning;
    std::vector<Shadow> shadows;
    std::vector<MeshInView> meshes;
    std::vector<std::uint32_t> mesh_parts;

    void clear();
    std::span<const std::uint32_t> parts_of(const MeshInView& mesh) const {
        return std::span(mesh_parts).subspan(mesh.first_part, mesh.part_count);
    }
};

/// Finds the particles, sprites, shadows and meshes that own pixels of the frame whose faces are claimed: what is in
/// view, and not wholly behind faces.
void find_things(const FrameContext& frame, ViewScratch& scratch);

/// Draws one of them where no face is nearer.
void draw_thing(const OwningThing& thing, const FrameContext& frame, ViewScratch& scratch);

/// Darkens the pixels of floors that shadows fall on.
void draw_shadows(const FrameContext& frame, ViewScratch& scratch);

}  // namespace oblong
