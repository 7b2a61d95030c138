#pragma once

#include <cstdint>
#include <span>

#include "engine/accuracy/accuracy.h"
#include "engine/level/level.h"
#include "engine/mesh/placed_mesh.h"
#include "engine/scene/face_surface.h"
#include "engine/scene/level_effects.h"
#include "engine/scene/light_styles.h"
#include "engine/scene/placed_models.h"
#include "engine/surface/colormap.h"

namespace oblong {

/// What the player or the developer sets; with level, camera and time it determines a frame.
struct Settings {
    Accuracy accuracy;
    EffectSet allowed_effects = EffectSet::all();
    Flashes flashes = Flashes::Full;
    std::int32_t brightness_100 = 100;  ///< percent, of the light on lit surfaces; clamped to the brightest shade
    bool correct_aspect = true;         ///< false: the projection assumes square pixels (F2 in the game)
    const Kernels* kernels = &best_kernels();  ///< what draws; others draw the same bytes
    bool operator==(const Settings&) const = default;
};

/// Everything that a frame shows. Level and colormap are the same for all frames of a workspace, and must outlive it.
struct Scene {
    const Level& level;
    const Colormap& colormap;
    std::span<const PlacedModel> models;              ///< each of the level's models at most once
    std::int64_t time_ms = 0;                         ///< >= 0; animations are functions of it
    LightStyles light_styles = plain_light_styles();  ///< multiplied by the level's patterns
    std::span<const MovingLight> moving_lights = {};  ///< in addition to the level's lanterns
    std::span<const PlacedMesh> meshes = {};          ///< triangle models
};

}  // namespace oblong
