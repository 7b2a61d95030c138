#include "tools/demo_level/models/models.h"
#include "tools/demo_level/models/turned.h"

namespace oblong::model_source {
namespace {

/// The y axis becomes x: what was turned about y looks along x.
ModelPoint upright(const ModelPoint& p) {
    return {p.y, -p.x, p.z};
}

ModelPoint as_it_is(const ModelPoint& p) {
    return p;
}

}  // namespace

std::string lens_obj() {
    ObjDraft draft("models.mtl");
    draft.use_material("glass");
    add_turned(draft, lens_profile(0.84, 0.22, 3), 16, upright);
    draft.use_material("brass");
    add_ring(draft, {0.82, 1, 0.26}, 16, upright, 3);
    add_turned(draft, {{0.15, -1.2}, {0.17, -1.12}, {0.12, -1.02}, {0.12, -0.97}}, 8, as_it_is);
    draft.use_material("bronze");
    add_turned(draft, {{0.01, -2.2}, {0.13, -2.16}, {0.17, -2.0}, {0.1, -1.2}}, 8, as_it_is);
    return draft.text();
}

std::string key_obj(const std::string& metal) {
    ObjDraft draft("models.mtl");
    draft.use_material(metal);
    add_ring(draft, {0.32, 0.58, 0.2}, 12, [](const ModelPoint& p) {
        const ModelPoint ring = upright(p);
        return ModelPoint{ring.x, ring.y + 0.82, ring.z};
    });
    add_turned(draft, {{0.18, 0.16}, {0.2, 0.22}, {0.18, 0.28}}, 8, as_it_is);
    add_turned(draft, {{0.02, -1.4}, {0.11, -1.38}, {0.11, 0.26}}, 8, as_it_is);
    for (const double y : {-1.2, -0.8}) {  // two teeth of the bit, square bars that stand out along z
        add_turned(draft, {{0.01, 0.1}, {0.12, 0.1}, {0.12, y < -1 ? 0.62 : 0.5}, {0.01, y < -1 ? 0.62 : 0.5}}, 4,
                   [y](const ModelPoint& p) {
                       return ModelPoint{p.x, y - p.z, p.y};
                   });
    }
    return draft.text();
}

}  // namespace oblong::model_source
