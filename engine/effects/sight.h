#pragma once

#include <cstdint>

#include "engine/raster/depth.h"
#include "engine/view/outline.h"
#include "engine/visibility/box_culler.h"

namespace oblong {

/// Where a thing is known to be hidden: nowhere; everywhere but over the sky, which hides nothing; or everywhere.
enum class Hidden : std::uint8_t { Perhaps, ExceptOverSky, Everywhere };

/// What faces leave open to a thing.
class Cover {
  public:
    virtual ~Cover() = default;
    /// Begins a thing: whether at a pixel of a rectangle that holds it no face is nearer than this depth.
    virtual bool begin(const ScreenRectangle& pixels, InverseDepth nearest, Hidden hidden) = 0;
    /// The same of a part of the thing, which is nowhere nearer and not outside the rectangle.
    virtual bool shows(const ScreenOutline& outline, InverseDepth nearest) const = 0;
    /// The same; later questions are only of what is inside the outline and not nearer. Takes longer.
    virtual bool narrow(const ScreenOutline& outline, InverseDepth nearest) = 0;
};

/// The visibility tests of a frame.
struct Sight {
    const LeafSet& leaves;  ///< things in none of them are not visible
    const ViewContext& view;
    const ScreenRectangle* drawn_part = nullptr;  ///< the part of the screen that is drawn; null: all
    Cover* cover = nullptr;                       ///< or null
    /// More leaves, or null: a thing in one of these, but in none of `leaves`, is visible in front of the sky alone.
    const LeafSet* leaves_over_sky = nullptr;
    BoxCuller culler{view.frustum, view.eye};

    Hidden hidden(const PlacedBox& place) const {
        if (culler.sides_crossed(place.box, kAllSides) == kOutside) return Hidden::Everywhere;
        if (reaches(place, leaves)) return Hidden::Perhaps;
        return leaves_over_sky && reaches(place, *leaves_over_sky) ? Hidden::ExceptOverSky : Hidden::Everywhere;
    }
    /// Begins a thing in a box.
    bool may_show(const PlacedBox& place) const {
        const Hidden found = hidden(place);
        return found != Hidden::Everywhere &&
               may_show(rectangle_of(place.box, view), nearest_inverse_depth_of(place.box, view), found);
    }
    /// Begins a thing in a rectangle.
    bool may_show(const ScreenRectangle& pixels, InverseDepth nearest, Hidden hidden = Hidden::Perhaps) const {
        return !cover || cover->begin(pixels, nearest, hidden);
    }
    // Of a part of the thing begun last.
    bool may_show_part(const LevelBox& box) const {
        if (culler.sides_crossed(box, kAllSides) == kOutside) return false;
        const InverseDepth nearest = nearest_inverse_depth_of(box, view);
        return may_show_part(rectangle_of(box, view), nearest) &&
               (!cover || cover->shows(outline_of(box, view), nearest));
    }
    bool may_show_part(const ScreenOutline& outline, InverseDepth nearest) const {
        return !cover || cover->shows(outline, nearest);
    }
    bool may_show_part(const ScreenRectangle& pixels, InverseDepth nearest) const {
        return may_show_part(ScreenOutline{pixels}, nearest);
    }
    /// The same; the later questions are of this part.
    bool narrow(const LevelBox& box) const {
        return !cover || cover->narrow(outline_of(box, view), nearest_inverse_depth_of(box, view));
    }
};

}  // namespace oblong
