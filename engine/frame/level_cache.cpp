#include "engine/frame/level_cache.h"

#include <algorithm>

namespace oblong {

namespace {

/// Whether all corners of a face are at or above this height.
bool is_above(World height, FaceIndex face, const Level& level, const FaceTable& table) {
    const std::span<const VertexIndex> corners = table.corners_of(face);
    return std::all_of(corners.begin(), corners.end(),
                       [&](VertexIndex corner) { return level.vertices[corner].z >= height; });
}

/// Whether a lantern's light may touch a face; with a unit for what rounds its circle.
bool is_near(const Lantern& lantern, FaceIndex face, const Level& level, const FaceTable& table) {
    const World strays = lantern.radius + World::from_int(1);
    return may_touch({lantern.middle, lantern.light_radius}, strays, level, face, table);
}

/// Adds the level's effects on textures and light to faces.
void add_effects(const Level& level, const LevelEffects& effects, const Things& things, FaceTable& table) {
    for (const FaceIndex index : level.faces.indices()) {
        table[index].is_near_lantern =
            std::any_of(things.lanterns.begin(), things.lanterns.end(),
                        [&](const PlacedLantern& placed) { return is_near(placed.lantern, index, level, table); });
        const Face& face = level.faces[index];
        table[index].is_above_fog =
            effects.fog && effects.fog->has_top && is_above(effects.fog->top, index, level, table);
        EffectSet& needs = table[index].effects;
        if (needs.has(Effect::Sky)) continue;
        if (effects.animations.is_animated(level.texinfos[face.texinfo].texture))
            needs = needs.with(Effect::AnimatedTextures);
        if (needs.has(Effect::Liquid)) {
            const LiquidKind kind = liquid_kind_of_texture(level.texture_of(face).name);
            if (item(effects.liquid_alpha_256, static_cast<int>(kind)) < 256) needs = needs.with(Effect::Translucency);
        } else if (effects.light_patterns.is_called_for_by(face)) {
            needs = needs.with(Effect::Styles);
        }
    }
}

}  // namespace

LevelCache::LevelCache(const Level& level, const ScreenMode& mode)
    : faces(make_face_table(level)),
      effects(read_level_effects(level)),
      things(read_things(level)),
      surfaces(level, faces, mode),
      brush_models(level) {
    add_effects(level, effects, things, faces);
}

}  // namespace oblong
