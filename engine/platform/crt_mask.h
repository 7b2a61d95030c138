#pragma once

#include <cstdint>
#include <vector>

namespace oblong {

/// The mask of the CRT look: factors for the colours of a picture of `rows` rows, shown in width x height pixels. Each
/// row is dark at its edges (but not if rows are below two pixels high); columns let red, green and blue through in
/// turn. Pixels are ARGB, 255 in a channel is factor 1; rows from top to bottom. Sizes above 0.
std::vector<std::uint32_t> make_crt_mask(std::int32_t width_px, std::int32_t height_px, std::int32_t rows);

}  // namespace oblong
