#pragma once

#include <cstdint>
#include <span>

#include "engine/frame/settings.h"
#include "engine/level/level.h"
#include "engine/mesh/placed_mesh.h"
#include "engine/scene/effects.h"
#include "engine/scene/face_surface.h"
#include "engine/scene/placed_models.h"
#include "engine/surface/colormap.h"
#include "engine/view/projection.h"
#include "engine/view/screen.h"
#include "engine/view/view_spec.h"

namespace oblong {

struct FrameWorkspace;  // engine/frame/workspace.h: scratch and caches, owned by the caller, never part of the picture

/// Everything that a frame shows. Level and colormap are the same in all frames of a workspace, and outlive it.
struct Scene {
    const Level& level;
    const Colormap& colormap;
    std::span<const PlacedModel> models;              ///< each of the level's models at most once
    std::int64_t time_ms = 0;                         ///< 0 or more: what moves by itself is a function of it
    LightStyles light_styles = plain_light_styles();  ///< times what the level's patterns make of them
    std::span<const MovingLight> moving_lights = {};  ///< besides those of the level's lanterns
    std::span<const PlacedMesh> meshes = {};          ///< models made of triangles
};

/// Draws one picture of any view: a pure function of its first four arguments. Every pixel of `out` (whose size is the
/// mode's) is written once. From an eye in the open, faces leave no pixel free; where a level lacks one, the texture of
/// another goes on (torn_pixels.h). From inside a wall or behind the sky all faces that face the eye are drawn, and
/// what none of them covers is colour 0. A view must have no problem_of(); fields of view are bounded by
/// make_projection() and, in modes of few pixels, by make_inverse_projection().
///
/// A parallel view shows all faces toward its direction, wherever they are: of a level seen from outside the rooms,
/// without the walls and ceilings that turn away. It is drawn without effects that have no meaning without an eye. What
/// a parallel view, or one with cuts, leaves free is colour 0.
void draw_frame(const Scene& scene, const ViewSpec& view, const ScreenMode& mode, const Settings& settings,
                FrameWorkspace& work, Framebuffer out);

/// The same as a camera looks.
void draw_frame(const Scene& scene, const Camera& camera, const ScreenMode& mode, const Settings& settings,
                FrameWorkspace& work, Framebuffer out);

}  // namespace oblong
