#include <array>
#include <cmath>

#include "tools/demo_level/models/models.h"
#include "tools/demo_level/models/turned.h"

namespace oblong::model_source {
namespace {

constexpr double kMiddle = 2.05;  ///< the height of the globe's middle
constexpr double kTilt = 23.4 / 360 * kTurn;

/// A place in the rings' own axes, whose y is the axis of the world: tilted, and lifted onto the foot.
ModelPoint placed(const ModelPoint& p, double tilt) {
    const double sine = std::sin(tilt), cosine = std::cos(tilt);
    return {p.x * cosine - p.y * sine, p.x * sine + p.y * cosine + kMiddle, p.z};
}

void add_foot(ObjDraft& draft) {
    const std::vector<std::vector<ProfilePoint>> parts = {
        {{0.62, 0}, {0.62, 0.07}},
        {{0.62, 0.07}, {0.6, 0.12}, {0.5, 0.15}, {0.3, 0.18}, {0.17, 0.25}, {0.13, 0.34}},
        {{0.13, 0.34}, {0.19, 0.36}, {0.19, 0.4}, {0.12, 0.42}},
        {{0.12, 0.42}, {0.2, 0.52}, {0.22, 0.6}, {0.18, 0.7}, {0.1, 0.8}, {0.09, 0.9}},
        {{0.09, 0.9}, {0.2, 0.95}, {0.24, 1}, {0.22, 1.04}, {0.02, 1.07}},
    };
    for (const auto& part : parts) add_turned(draft, part, 12, [](const ModelPoint& p) { return p; });
}

}  // namespace

std::string armillary_obj() {
    ObjDraft draft("models.mtl");
    draft.use_material("bronze");
    add_foot(draft);
    draft.use_material("brass");
    const auto tilted = [](const ModelPoint& p) { return placed(p, kTilt); };
    add_ring(draft, {0.93, 1, 0.09}, 20, [](const ModelPoint& p) { return placed({p.x, p.z, -p.y}, 0); });
    add_ring(draft, {0.86, 0.92, 0.09}, 20, tilted);
    add_ring(draft, {0.78, 0.85, 0.2}, 20, [](const ModelPoint& p) { return placed(p, -kTilt / 2); });
    add_turned(draft, {{0.025, -0.92}, {0.025, 0.92}}, 6, tilted);
    draft.use_material("globe");
    add_turned(draft, sphere_profile(0.42, 8), 14, tilted);
    return draft.text();
}

}  // namespace oblong::model_source
