#include <cmath>

#include "tools/demo_level/models/models.h"
#include "tools/demo_level/models/turned.h"

namespace oblong::model_source {
namespace {

constexpr int kLenses = 12;

ModelPoint tilted(const ModelPoint& p, double angle) {
    const double sine = std::sin(angle), cosine = std::cos(angle);
    return {p.x * cosine - p.y * sine, p.x * sine + p.y * cosine, p.z};
}

ModelPoint turned_about_y(const ModelPoint& p, double angle) {
    const double sine = std::sin(angle), cosine = std::cos(angle);
    return {p.x * cosine + p.z * sine, p.y, p.z * cosine - p.x * sine};
}

/// A lens that looks to the middle from its place on the ring.
struct Seat {
    double angle, radius;

    ModelPoint operator()(const ModelPoint& p) const {
        return turned_about_y({p.y + 1, -p.x + radius + 0.05, p.z}, angle);
    }
};

}  // namespace

std::string orrery_sun_obj() {
    ObjDraft draft("models.mtl");
    draft.use_material("sun");
    add_turned(draft, sphere_profile(0.24, 7), 14, [](const ModelPoint& p) { return p; });
    draft.use_material("brass");
    for (const auto& [radius, angle] : {std::pair{0.6, 0.41}, {0.5, -0.7}, {0.4, 1.35}}) {
        add_ring(draft, {radius - 0.05, radius, 0.07}, 24, [angle](const ModelPoint& p) { return tilted(p, angle); });
    }
    add_turned(draft, {{0.015, -0.6}, {0.015, 0.6}}, 6, [](const ModelPoint& p) { return tilted(p, 0.41); });
    return draft.text();
}

std::string orrery_lenses_obj() {
    constexpr double kRadius = 0.17;
    ObjDraft draft("models.mtl");
    draft.use_material("brass");
    add_ring(draft, {0.95, 1.02, 0.05}, 36, [](const ModelPoint& p) { return p; });
    for (int i = 0; i < kLenses; ++i)
        add_ring(draft, {0.83 * kRadius, kRadius, 0.05}, 10, Seat{kTurn * i / kLenses, kRadius}, 3);
    draft.use_material("spectrum");
    for (int i = 0; i < kLenses; ++i) {
        draft.use_columns(i / double{kLenses}, (i + 1) / double{kLenses});
        add_turned(draft, lens_profile(0.84 * kRadius, 0.05, 2), 10, Seat{kTurn * i / kLenses, kRadius});
    }
    return draft.text();
}

std::string orrery_stand_obj() {
    ObjDraft draft("models.mtl");
    draft.use_material("bronze");
    const std::vector<std::vector<ProfilePoint>> parts = {
        {{0.36, -1.55}, {0.36, -1.5}},
        {{0.36, -1.5}, {0.32, -1.47}, {0.18, -1.43}, {0.1, -1.36}, {0.06, -1.2}},
        {{0.06, -1.2}, {0.1, -1.17}, {0.1, -1.13}, {0.05, -1.1}, {0.03, -0.24}}};
    for (const auto& part : parts) add_turned(draft, part, 12, [](const ModelPoint& p) { return p; });
    return draft.text();
}

}  // namespace oblong::model_source
