#pragma once

#include <array>
#include <cstdint>

#include "engine/base/table.h"
#include "engine/surface/palette.h"
#include "engine/view/screen.h"

namespace oblong {

/// A small picture of the view at the moment of a save, in the colours shown.
struct Thumbnail {
    static constexpr std::int32_t kWidth_px = 80, kHeight_px = 50;

    std::array<Rgb8, as_size(kWidth_px) * kHeight_px> pixels{};  ///< row by row

    bool operator==(const Thumbnail&) const = default;
};

/// Scales a picture of any mode down: each pixel is the mean of those that it covers.
Thumbnail make_thumbnail(Framebuffer picture, const Palette& palette);

}  // namespace oblong
