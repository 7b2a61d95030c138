#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "engine/effects/fog.h"
#include "engine/frame/fog_tables.h"
#include "engine/scene/level_effects.h"
#include "engine/surface/colormap.h"
#include "engine/visibility/front_to_back.h"

namespace oblong {

struct FrameContext;
struct ViewScratch;

/// The fog in this view, if the level has fog and the settings allow it.
FrameFog make_frame_fog(const FrameContext& frame);

/// Whether the eye and everything visible, which is not lower than `lowest_z`, are certainly above the fog's top.
bool is_clear(World lowest_z, const FrameFog& fog, const Vec3<World>& eye);

/// False if all these pixels of a face are certainly clear: without fog, or if they and the eye are above its top.
bool may_have_fog(const VisibleFace& face, std::span<const Span> spans, const FrameContext& frame);

/// Appends the runs of a face's spans, including clear ones.
void append_runs(std::span<const Span> spans, const LinearQuantity<InverseZ>& inverse_z, const FrameFog& fog,
                 std::vector<FogRun>& runs);

/// The colours of a thing at a pixel and depth. `runs` is scratch.
const ColourRow& fog_colours(std::int32_t column, std::int32_t row, InverseZ inverse_z, const FrameFog& fog,
                             std::vector<FogRun>& runs);

/// Finds the pixels of opaque faces and sky in fog. Height fog leaves the sky clear.
void find_fog(const FrameContext& frame, ViewScratch& scratch);

}  // namespace oblong
