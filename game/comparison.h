#pragma once

#include <string_view>

#include "game/lab_options.h"
#include "tools/common/text.h"

namespace oblong {

/// The column at which the right side begins.
std::int32_t split_column(const LabOptions& options, std::int32_t width_px);

/// Shows the right side of another picture beside the left side of this one, with a line between them.
void draw_split(const LabOptions& options, Framebuffer right, TextColours colours, Framebuffer canvas);
/// Names both sides above the row `bottom`, each cut where it ends. The row above which they end.
std::int32_t draw_split_names(const LabOptions& options, std::string_view left, std::string_view right,
                              std::int32_t bottom, TextColours colours, Framebuffer canvas);

/// Names the two settings that are flipped, that shown in brackets, above the row `bottom`. The row above which it
/// ends.
std::int32_t draw_flip_names(const LabOptions& options, const Accuracy& accuracy, std::uint64_t now_us,
                             std::int32_t bottom, TextColours colours, Framebuffer canvas);

}  // namespace oblong
