#pragma once

#include <cstdint>
#include <string>

#include "engine/screen/screen.h"
#include "game/text.h"

namespace oblong {

/// What is written over the picture.
struct Hud {
    std::string message;  ///< shown until message_ends_us
    std::uint64_t message_ends_us = 0;
    std::string cost;  ///< a line in the corner; empty: none
    bool shows_help = false;
    bool shows_end = false;
    std::string end_message;  ///< in the place of the usual one
};

/// Shows a message from now on, for as long as it takes to read.
void tell(Hud& hud, std::string message, std::uint64_t now_us);

void draw_hud(const Hud& hud, std::uint64_t now_us, Inks inks, Framebuffer canvas);

}  // namespace oblong
