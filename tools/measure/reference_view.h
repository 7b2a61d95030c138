#pragma once

#include <cmath>
#include <span>
#include <vector>

#include "engine/scene/placed_models.h"
#include "engine/view/projection.h"
#include "engine/view/screen.h"
#include "tools/reference/frame.h"

namespace oblong {

template <class Int, int Frac>
double number_of(Fixed<Int, Frac> value) {
    return std::ldexp(static_cast<double>(value.raw), -Frac);
}

/// What the reference renderer needs to see what the engine sees. `correct_aspect`: Settings::correct_aspect.
reference::View reference_view(const Camera& camera, const ScreenMode& mode, bool correct_aspect = true);
std::vector<reference::PlacedModel> reference_models(std::span<const PlacedModel> models);
reference::Vec reference_vec(const Vec3<World>& world);

}  // namespace oblong
