#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "engine/level/level.h"
#include "engine/scene/placed_models.h"
#include "engine/view/projection.h"
#include "tools/reference/level.h"

namespace oblong {

/// A level as the engine and as the reference read it, and the cameras whose frames are measured.
struct MeasuredLevel {
    std::string name;
    std::string about;  ///< what is hard in it; empty for a level that a user named
    Level level;
    reference::Level exact;
    std::vector<PlacedModel> models;
    std::vector<Camera> cameras;
};

/// From the bytes of a level file. Eyes are moved clear of planes first, as frames do it (engine/visibility/eye.h), so
/// that both see from the same place. Throws InputError.
MeasuredLevel make_measured_level(const std::string& name, const std::string& about, std::span<const std::uint8_t> file,
                                  std::vector<Camera> cameras);

}  // namespace oblong
