#pragma once

#include <vector>

#include "tools/reference/projection.h"

namespace oblong::reference {

/// normal . p >= offset is inside.
struct Plane {
    Vec normal;
    double offset = 0;
};

std::vector<Vec> clip(const std::vector<Vec>& polygon, const Plane& plane);

/// What is left of a convex polygon in viewspace between two depths and the four sides of the view.
std::vector<Vec> clip_to_view(std::vector<Vec> polygon, double near, double far, const Projection& projection);

/// The area of a polygon on the screen, square pixels.
double area(const std::vector<ScreenPoint>& polygon);

/// The same of what is left after clipping.
double visible_area(const std::vector<Vec>& polygon, double near, double far, const Projection& projection);

}  // namespace oblong::reference
