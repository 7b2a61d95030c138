#pragma once

#include <span>
#include <vector>

#include "engine/effects/things_in_view.h"
#include "engine/mesh/placed_mesh.h"

namespace oblong {

struct FrameContext;
struct ViewScratch;

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

/// Finds the particles, sprites, shadows and meshes that are in view and not wholly hidden by the claimed faces.
void find_things(const FrameContext& frame, ViewScratch& scratch);

/// Draws a thing where nothing is nearer.
void draw_thing(const VisibleThing& thing, const FrameContext& frame, ViewScratch& scratch);

/// Darkens the floors under shadows.
void draw_shadows(const FrameContext& frame, ViewScratch& scratch);

// In mesh_pass.cpp.

/// Finds the meshes that may be visible, and requests depth for them. Meshes are skipped if they are out of view, in no
/// leaf of the visible set, or hidden by nearer faces in their whole rectangle, and in a mirror's view if their origin
/// is behind it.
void find_meshes(const FrameContext& frame, const Sight& sight, ViewScratch& scratch);

/// Removes the meshes before the first one that faces do not wholly hide; all, if there is none. That decides whether
/// the pass runs; draw_meshes() tests the others. Requires depth.
void keep_seen_meshes(const FrameContext& frame, ViewScratch& scratch);

/// Draws the remaining meshes, in the level's light and fog.
void draw_meshes(const FrameContext& frame, ViewScratch& scratch);

/// Draws what does not claim pixels, back to front: see-through faces, in the reverse order of the walk, and things
/// among them. A thing is drawn before the farthest of these faces that is in front of it. In see_through_pass.cpp.
void draw_see_through(const FrameContext& frame, ViewScratch& scratch);

}  // namespace oblong
