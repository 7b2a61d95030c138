#pragma once

#include <cstdint>
#include <vector>

namespace oblong {

/// The look of a tube: what the colours of a picture of `rows` rows, shown in width x height pixels, are multiplied by.
/// Each row is dark at its borders (not where rows are below two pixels high), and columns take turns to let red, green
/// and blue through. Pixels are ARGB, 255 in a channel leaves it as it is; rows from top to bottom. Sizes above 0.
std::vector<std::uint32_t> make_crt_mask(std::int32_t width_px, std::int32_t height_px, std::int32_t rows);

}  // namespace oblong
