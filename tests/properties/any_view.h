#pragma once

#include <rapidcheck/gtest.h>

#include "engine/methods/transforms.h"
#include "engine/view/clip.h"
#include "engine/view/project.h"

namespace oblong::test {

/// Of any mode, and a field of view from `least` degrees to below `end`.
inline Projection any_projection(int least, int end) {
    const ScreenMode mode{*rc::gen::inRange(16, 2'048), *rc::gen::inRange(16, 2'048)};
    return make_projection(mode, Degrees::from_int(*rc::gen::inRange(least, end)));
}
inline Frustum frustum_of(const Projection& projection) {
    return make_frustum(y_up_basis({}, {}, {}), projection);
}

}  // namespace oblong::test
