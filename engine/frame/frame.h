#pragma once

#include "engine/frame/scene.h"
#include "engine/view/projection.h"
#include "engine/view/screen.h"
#include "engine/view/views.h"

namespace oblong {

struct FrameWorkspace;  // engine/frame/workspace.h: the caller's scratch and caches; they never change the picture

/// Draws a picture of any view: a pure function of its first four arguments. Faces, sky and uncovered pixels write
/// every pixel of `out` (of the mode's size) exactly once. From an eye in the open, faces leave no pixel free; where a
/// level lacks a face, the texture of another is continued (torn_pixels.h). From inside a wall or behind the sky, all
/// faces that face the eye are drawn, and uncovered pixels are colour 0. Requires a view in which
/// problem_of() (view/views.h) finds nothing for this mode.
///
/// A parallel view shows all faces that face its direction: rooms seen from outside, without the walls and ceilings
/// that face away. Effects that need an eye are omitted. Uncovered pixels of a parallel view, or of one with cuts, are
/// colour 0.
void draw_frame(const Scene& scene, const ViewSpec& view, const ScreenMode& mode, const Settings& settings,
                FrameWorkspace& work, Framebuffer out);

/// The same for a camera.
void draw_frame(const Scene& scene, const Camera& camera, const ScreenMode& mode, const Settings& settings,
                FrameWorkspace& work, Framebuffer out);

}  // namespace oblong
