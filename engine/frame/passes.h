#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "engine/frame/frame_plan.h"
#include "engine/scene/level_effects.h"

namespace oblong {

struct Claims;
struct FrameContext;
struct FrameCounts;
struct ViewScratch;

/// A step of a frame that writes pixels.
struct Pass {
    std::string_view name;
    bool owns_pixels;                                           ///< false: changes pixels drawn by earlier passes
    bool (*has_work)(const Claims&);                            ///< if false, the pass does not run
    std::int64_t (*pixels)(const Claims&, const FrameCounts&);  ///< drawn, in a counted frame
    void (*run)(const FrameContext& frame, ViewScratch& scratch);
};

/// All passes in the order in which they run; those that own pixels come first.
extern const std::array<Pass, kPassCount> kPasses;

/// The pass that draws nothing but an effect, by index in kPasses; kPassCount: none.
std::size_t pass_of(Effect effect);

FramePlan plan_frame(const Claims& claims);
void run_passes(const FramePlan& plan, const FrameContext& frame, ViewScratch& scratch);

}  // namespace oblong
