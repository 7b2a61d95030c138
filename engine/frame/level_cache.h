#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "engine/effects/sky.h"
#include "engine/effects/things.h"
#include "engine/effects/warp.h"
#include "engine/frame/continued_face.h"
#include "engine/frame/fog_tables.h"
#include "engine/mesh/placed_mesh.h"
#include "engine/scene/face_surface.h"
#include "engine/scene/face_table.h"
#include "engine/scene/level_effects.h"
#include "engine/visibility/box_culler.h"
#include "engine/visibility/brush_models.h"

namespace oblong {

/// What is known of a mesh of the scene until it moves.
struct MeshPlace {
    PlacedMesh placed;
    TurningShape shape;
    PlacedBox any_turn;                       ///< its box for any rotation
    LeafIndex seen_from = LeafIndex::none();  ///< whose visible set was asked last
    bool is_in_set = false;                   ///< whether any_turn is in that set
    std::optional<LevelBox> box;              ///< once asked for
    std::optional<MeshTransform> transform;   ///< once asked for; none: none yet, or it has no inverse
};

/// How translucent faces of one opacity mix with what is behind them.
struct FaceBlend {
    std::int32_t alpha_256 = 0;
    std::unique_ptr<BlendTable> table;  ///< null until a frame needs it
};

/// Data kept from frame to frame for a level and a colormap, made once or on first use. It never changes a picture.
struct LevelCache {
    /// `level` must outlive it.
    LevelCache(const Level& level, const ScreenMode& mode);
    LevelCache(const LevelCache&) = delete;  // its parts refer to each other

    FaceTable faces;
    LevelEffects effects;  ///< set by the level
    Things things;         ///< particles, sprites and lanterns
    FaceSurfaces surfaces;
    BrushModels brush_models;
    std::vector<MeshPlace> mesh_places;          ///< of the scene's meshes; updated when they move
    ContinuedFaces continued_faces;              ///< of torn walls
    std::unique_ptr<LevelFogTables> fog_tables;  ///< null until a frame shows fog
    std::vector<FaceBlend> blends;               ///< one of each opacity, 255 at most
    WarpTables warp{};                           ///< of liquids
    std::int64_t warp_time_ms = -1;              ///< the time of `warp`
    SkyLayers sky_layers;
};

}  // namespace oblong
