#pragma once

#include <cstdint>
#include <string>

#include "engine/screen/screen.h"
#include "game/frame_cost.h"

namespace oblong {

/// Text drawn over the picture.
struct Hud {
    std::string message;  ///< shown until message_ends_us
    std::uint64_t message_ends_us = 0;
    CostText cost;  ///< at the bottom
    bool shows_help = false;
};

/// Shows a message from now on, for as long as it takes to read.
void show_message(Hud& hud, std::string message, std::uint64_t now_us);

/// `bottom`: the row above which the cost goes.
void draw_hud(const Hud& hud, std::uint64_t now_us, std::int32_t bottom, TextColours colours, Framebuffer canvas);

}  // namespace oblong
