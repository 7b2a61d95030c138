#pragma once

#include <memory>

#include "engine/platform/platform.h"
#include "game/options/options.h"

namespace oblong {

/// The platform of --headless: as many pictures as it says, a tick each, written as PNGs into the folder of --out. Its
/// input is a short walk, or the replayed demo. The options outlive it.
std::unique_ptr<Platform> open_headless(const Options& options);

}  // namespace oblong
