#pragma once

#include <array>
#include <bitset>
#include <cstdint>
#include <string_view>

#include "engine/scene/effects.h"

namespace oblong {

struct Claims;
struct FrameContext;
struct FrameCounts;
struct ViewScratch;

/// A step of a frame that writes pixels.
struct Pass {
    std::string_view name;
    bool owns_pixels;                                           ///< false: changes what others have drawn before
    bool (*has_work)(const Claims&);                            ///< a pass without work does not run
    std::int64_t (*pixels)(const Claims&, const FrameCounts&);  ///< that it has drawn, of a frame that is counted
    void (*run)(const FrameContext& frame, ViewScratch& scratch);
};

/// All passes, in the order in which they run: those that own their pixels first.
inline constexpr std::size_t kPassCount = 11;
extern const std::array<Pass, kPassCount> kPasses;

/// The passes that a frame runs: those to which something was claimed.
struct FramePlan {
    std::bitset<kPassCount> passes;  ///< by their numbers in kPasses
    EffectSet effects;               ///< those that own pixels

    /// Whether the pass of this name runs; false if there is none.
    bool has(std::string_view pass) const;
};

/// The plan for these claims.
FramePlan plan_frame(const Claims& claims);
/// Runs the passes of a plan.
void run_passes(const FramePlan& plan, const FrameContext& frame, ViewScratch& scratch);

}  // namespace oblong
