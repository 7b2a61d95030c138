#pragma once

#include <memory>

#include "engine/frame/frame_counts.h"
#include "engine/frame/frame_record.h"
#include "engine/frame/level_cache.h"
#include "engine/frame/observers.h"
#include "engine/frame/shared_drawing.h"
#include "engine/frame/view_scratch.h"

namespace oblong {

/// The memory with which frames of one level are drawn, with one colormap in one mode. A new workspace draws the same
/// bytes.
struct FrameWorkspace {
    /// The level outlives it, and so do `workers`, which share the drawing; null: one thread draws.
    FrameWorkspace(const Level& level, const ScreenMode& mode, Workers* workers = nullptr)
        : cache(level, mode), view(level, cache.faces, mode) {
        if (workers && workers->count() > 1) shared = std::make_unique<SharedDrawing>(*workers, mode.width_px);
    }

    LevelCache cache;
    ViewScratch view;                       ///< of the eye's view; mirrors have their own in it
    std::unique_ptr<SharedDrawing> shared;  ///< null: one thread draws
    FramePlan plan;                         ///< of the frame drawn last
    FrameObservers observers;               ///< of the frames to come
    FaceClaimer* claimer = nullptr;         ///< finds out which face owns which pixel; null: claim_faces()
};

}  // namespace oblong
