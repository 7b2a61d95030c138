#pragma once

#include <memory>

#include "engine/platform/platform.h"
#include "game/options/options.h"

namespace oblong {

/// What --headless plays on: as many pictures as it says, a tick each, written as PNGs into the folder of --out; its
/// input is a short walk, or what is replayed. The options outlive it.
std::unique_ptr<Platform> open_headless(const Options& options);

}  // namespace oblong
