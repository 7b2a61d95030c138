#pragma once

#include "engine/methods/pixel_owners.h"

namespace oblong {

/// The z-buffer (Catmull 1974; course notes, "Z-buffering"): faces come in any order, here that of the level's file;
/// each pixel stores the depth of the nearest face so far, and a face takes the pixels at which it is nearer.
///
/// Depths are 1/z at the pixel's centre, from the plane and in steps of 2^-44, not interpolated between corners: faces
/// in one plane have the same depth, bit for bit, and the first of them keeps the pixel. They are clamped to the face's
/// range of z: rounding on the screen extends a face by up to 1/256 pixel, where the depth of a plane seen almost
/// edge-on is arbitrary. `depths` is scratch.
void find_owners_by_z_buffer(const ScannedFaces& scanned, std::vector<InverseZ>& depths, PixelOwners& owners);

/// 1/z of a face at the centre of a pixel, clamped to the face's range.
class FaceDepth {
  public:
    explicit FaceDepth(const ScannedFace& face);
    InverseZ at(std::int32_t column, std::int32_t row) const;

  private:
    LinearQuantity<InverseZ> inverse_z_;
    InverseZ farthest_, nearest_;
};

}  // namespace oblong
