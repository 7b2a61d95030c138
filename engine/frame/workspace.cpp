#include "engine/frame/workspace.h"

#include <algorithm>

namespace oblong {

namespace {

/// Adds to faces what their level says of their textures and light.
void add_effects(const Level& level, const LevelEffects& effects, FaceTable& table) {
    for (const FaceIndex index : level.faces.indices()) {
        const Face& face = level.faces[index];
        EffectSet& needs = table.faces[index].effects;
        if (needs.has(Effect::Sky)) continue;
        if (effects.animations.is_animated(level.texinfos[face.texinfo].texture))
            needs = needs.with(Effect::AnimatedTextures);
        if (needs.has(Effect::Liquid)) {
            const LiquidKind kind = liquid_kind_of_texture(level.texture_of(face).name);
            if (at(effects.liquid_alpha_256, static_cast<int>(kind)) < 256) needs = needs.with(Effect::Translucency);
        } else if (effects.light_patterns.is_called_for_by(face)) {
            needs = needs.with(Effect::Styles);
        }
    }
}

}  // namespace

FrameWorkspace::FrameWorkspace(const Level& level, const ScreenMode& mode, Workers* workers)
    : faces(make_face_table(level)),
      vertices(level.vertices),
      visible(level),
      span_buffer(mode.width_px, mode.height_px),
      rows(mode.height_px),
      span_scratch(mode.width_px),
      surfaces(level, faces, mode.width_px),
      brush_models(level),
      effects(read_level_effects(level)),
      things(read_things(level)),
      depth(mode.width_px, mode.height_px),
      shadows(mode.height_px),
      mirror{{}, {}, {}, DepthBuffer(mode.width_px, mode.height_px), nullptr} {
    add_effects(level, effects, faces);
    if (workers && workers->count() > 1) shared = std::make_unique<SharedDrawing>(*workers, mode.width_px);
    walk.face_marks.resize(level.faces.size());
    walk.steps.reserve(level.nodes.size());
    claims.spans.room_for(static_cast<std::size_t>(mode.height_px) * 16);
    polygon.clipper.reserve(faces.most_corners + kClipPlaneCount);
    polygon.projected.take(faces.most_corners + kClipPlaneCount);
}

}  // namespace oblong
