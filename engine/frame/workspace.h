#pragma once

#include <memory>

#include "engine/frame/frame_counts.h"
#include "engine/frame/frame_record.h"
#include "engine/frame/level_cache.h"
#include "engine/frame/observers.h"
#include "engine/frame/shared_drawing.h"
#include "engine/frame/view_scratch.h"

namespace oblong {

/// Caches and scratch for frames of one level with one colormap in one mode. They never change a picture.
struct FrameWorkspace {
    /// `level` and `workers` must outlive it. `workers` share the drawing; null: one thread draws.
    FrameWorkspace(const Level& level, const ScreenMode& mode, Workers* workers = nullptr)
        : cache(level, mode), view(level, cache.faces, mode) {
        if (workers && workers->count() > 1) shared = std::make_unique<SharedDrawing>(*workers, mode.width_px);
    }

    LevelCache cache;
    ViewScratch view;                       ///< of the eye's view; contains that of mirrors
    std::unique_ptr<SharedDrawing> shared;  ///< null: one thread draws
    FramePlan plan;                         ///< of the last frame
    FrameObservers observers;               ///< of the next frames
    FaceClaimer* claimer = nullptr;         ///< claims pixels; null: claim_faces()
};

}  // namespace oblong
