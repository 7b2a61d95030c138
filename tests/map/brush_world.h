#pragma once

#include <string_view>
#include <vector>

#include "tools/map/source/geometry.h"

/// What a map source says of a level, without any tree: each point and each line of sight is held against every brush.
namespace oblong::test {

class BrushWorld {
  public:
    /// The solid and sky brushes of the worldspawn, func_group and func_detail.
    explicit BrushWorld(std::string_view map_text);

    /// Whether the point is in a brush; with `margin`, or within that of one, roughly (negative: or nearer to the
    /// surface).
    bool is_solid(const map::Point& point, double margin = 0) const;

    /// Whether a line of sight runs through a brush, or within `margin` of it.
    bool is_blocked(const map::Point& from, const map::Point& to, double margin) const;

    /// Around all brushes.
    const map::Box& box() const { return box_; }

  private:
    struct Solid {
        std::vector<map::Plane> sides;  // facing outward
    };
    std::vector<Solid> solids_;
    map::Box box_;
};

}  // namespace oblong::test
