#pragma once

#include <string_view>

#include "engine/draw/text.h"
#include "game/lab/lab_options.h"

namespace oblong {

/// The first column of the right side.
std::int32_t split_column(const LabOptions& options, std::int32_t width_px);

/// Replaces the right side of the canvas by that of another picture, with a line between them.
void draw_split(const LabOptions& options, Framebuffer right, TextColours colours, Framebuffer canvas);
/// The caption of a split picture, for KeyNames::in(): `left` names the setting at the left; at the right it is exact.
std::string split_text(std::string_view left);

/// The two settings that are flipped, the shown one in brackets, for KeyNames::in().
std::string flip_text(const LabOptions& options, const Accuracy& accuracy, std::uint64_t now_us);

}  // namespace oblong
