#pragma once

#include <span>
#include <vector>

#include "tools/reference/rays.h"
#include "tools/reference/view.h"

namespace oblong::reference {

/// A brush model, 1 and up, moved by `offset`.
struct PlacedModel {
    int model = 0;
    Vec offset;
};

/// The contents of a pixel's centre. Without a face, only the flag is valid.
struct Pixel {
    int face = -1;               ///< of the level; -1: none
    int model = -1;              ///< of the face; 0: the world
    int plane = -1;              ///< into Frame::planes
    double z = 0;                ///< depth, units
    double u = 0, v = 0;         ///< texels of mip level 0, not wrapped; undefined for sky
    bool is_close_call = false;  ///< an edge passes very near the centre, or two faces are equally near
};

struct Frame {
    int width_px = 0, height_px = 0;
    std::vector<Pixel> pixels;      ///< rows top to bottom
    std::vector<PlaneView> planes;  ///< of the faces that pixels show

    const Pixel& at(int column, int row) const { return pixels[static_cast<std::size_t>(row * width_px + column)]; }
};

/// The world's faces and those of the models: for each ray the nearest one that faces the eye. `shift` moves all rays
/// from the pixels' centres, by half a pixel at most.
///
/// Which rays a face covers is exact: corners are rounded once, to 2^-20, then integers decide (rays.h). Neighbours
/// share all corners, so that no ray from inside a closed level is missed; a ray through an edge belongs to the face on
/// its right, or below it. Nothing is clipped. Throws std::range_error for corners too far away for that (2^35 units
/// times pixels).
Frame draw(const Level& level, std::span<const PlacedModel> models, const View& view, RayShift shift = {});

/// draw() finds the close calls at equal depth. This also finds those at edges: where another face is `distance`
/// (1/4096 pixel) from the centre, to the right or left and below or above. It takes three times as long.
Frame draw_with_close_calls(const Level& level, std::span<const PlacedModel> models, const View& view,
                            int distance = kRayUnit / 512);

}  // namespace oblong::reference
