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

/// Makes a face translucent. Of more opacities than have a number, the last one counts for all others.
void make_translucent(std::int32_t alpha_256, PreparedFace& face, std::vector<FaceBlend>& blends) {
    constexpr std::size_t kMost = 255;
    auto blend =
        std::find_if(blends.begin(), blends.end(), [&](const FaceBlend& each) { return each.alpha_256 == alpha_256; });
    if (blend == blends.end() && blends.size() < kMost) {
        blends.push_back({alpha_256, nullptr});
        blend = blends.end() - 1;
    }
    face.effects = face.effects.with(Effect::Translucency);
    face.blend = static_cast<std::uint8_t>(std::min<std::ptrdiff_t>(blend - blends.begin() + 1, kMost));
}

void add_model_alphas(const Level& level, const LevelEffects& effects, FaceTable& table,
                      std::vector<FaceBlend>& blends) {
    for (const ModelAlpha& each : effects.model_alphas)
        for (const FaceIndex face : level.models[each.model].faces)
            if (!table[face].effects.has(Effect::Sky)) make_translucent(each.alpha_256, table[face], blends);
}

/// Adds the level's effects on textures and light to faces.
void add_effects(const Level& level, const LevelEffects& effects, const Things& things, FaceTable& table,
                 std::vector<FaceBlend>& blends) {
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
            const std::int32_t alpha_256 = item(effects.liquid_alpha_256, static_cast<int>(kind));
            if (alpha_256 < 256) make_translucent(alpha_256, table[index], blends);
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
    add_effects(level, effects, things, faces, blends);
    add_model_alphas(level, effects, faces, blends);
}

}  // namespace oblong
