#pragma once

#include <map>

#include "tools/map/brush.h"

namespace oblong::map {

struct TexturedPiece {
    int texinfo = -1;
    Winding winding;
};

/// Finds which brush side's texture covers which part of a polygon on its plane.
class Texturing {
  public:
    Texturing(const std::vector<Brush>& brushes, const PlaneList& planes);

    /// Cuts `winding` into the parts that the sides facing `facing` of brushes of `filling` cover, later brushes
    /// first. What none covers (slivers, by rounding) gets the texture of the nearest such brush.
    std::vector<TexturedPiece> cover(const Winding& winding, PlaneSide facing, int filling) const;

  private:
    struct Owner {
        const Brush* brush;
        const BrushSide* side;
    };

    int nearest_texinfo(const Winding& winding, PlaneSide facing, int filling) const;

    const std::vector<Brush>& brushes_;
    const PlaneList& planes_;
    std::map<PlaneSide, std::vector<Owner>> owners_;  // later brushes first
};

}  // namespace oblong::map
