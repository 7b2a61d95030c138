#include "engine/frame/plan.h"

namespace oblong {

FramePlan plan_frame(const Claims& claims) {
    FramePlan plan;
    plan.effects = claims.effects;
    const auto add_if_called_for = [&](Pass pass, FaceList list) {
        if (!claims.list(list).empty()) plan.passes.push_back(pass);
    };
    add_if_called_for(Pass::Walls, FaceList::Walls);
    add_if_called_for(Pass::Flat, FaceList::Flat);
    add_if_called_for(Pass::Liquid, FaceList::Liquid);
    add_if_called_for(Pass::Sky, FaceList::Sky);
    add_if_called_for(Pass::Mirror, FaceList::Mirror);
    if (!claims.things.shadows.empty()) plan.passes.push_back(Pass::Shadows);
    if (!claims.fog_runs.empty()) plan.passes.push_back(Pass::Fog);
    if (!claims.things.meshes.empty()) plan.passes.push_back(Pass::Models);
    if (!claims.list(FaceList::SeeThrough).empty() || !claims.things.owning.empty())
        plan.passes.push_back(Pass::SeeThrough);
    if (claims.is_under_liquid) plan.passes.push_back(Pass::Underwater);
    return plan;
}

}  // namespace oblong
