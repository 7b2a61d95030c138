#pragma once

#include <string_view>

#include "engine/draw/text.h"
#include "game/lab/lab_options.h"

namespace oblong {

/// The column at which the right side begins.
std::int32_t split_column(const LabOptions& options, std::int32_t width_px);

/// Shows the right side of another picture beside the left side of this one, with a line between them.
void draw_split(const LabOptions& options, Framebuffer right, TextColours colours, Framebuffer canvas);
/// What the two sides show, for KeyNames::in(): `left` names the setting there; at the right is the exact one.
std::string split_text(std::string_view left);

/// The two settings that are flipped, that shown in brackets, for KeyNames::in().
std::string flip_text(const LabOptions& options, const Accuracy& accuracy, std::uint64_t now_us);

}  // namespace oblong
