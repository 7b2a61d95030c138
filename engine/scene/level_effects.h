#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/level/level.h"
#include "engine/scene/light_styles.h"
#include "engine/scene/texture_animation.h"
#include "engine/surface/palette.h"

namespace oblong {

/// What a scene may show in addition to lit walls.
enum class Effect : std::uint8_t {
    Sky,
    Liquid,
    BrushModels,
    Fence,
    Translucency,
    AnimatedTextures,
    Styles,
    Lights,
    Fog,
    Particles,
    Sprites,
    Shadows,
    Meshes,
    Mirror,
    Underwater
};
inline constexpr std::size_t kEffectCount = 15;
inline constexpr std::array<std::string_view, kEffectCount> kEffectNames{
    "sky",          "liquid",        "brush_models", "fence",     "translucency", "animated_textures",
    "light_styles", "moving_lights", "fog",          "particles", "sprites",      "shadows",
    "models",       "mirror",        "underwater"};
static_assert(!kEffectNames.back().empty());

/// A set of effects.
struct EffectSet {
    std::uint32_t bits = 0;

    static constexpr EffectSet all() { return {(1u << kEffectCount) - 1}; }
    constexpr bool has(Effect effect) const { return (bits >> static_cast<unsigned>(effect) & 1) != 0; }
    constexpr EffectSet with(Effect effect) const { return {bits | 1u << static_cast<unsigned>(effect)}; }
    constexpr EffectSet without(Effect effect) const { return {bits & ~(1u << static_cast<unsigned>(effect))}; }
    constexpr EffectSet operator|(EffectSet other) const { return {bits | other.bits}; }
    constexpr EffectSet operator&(EffectSet other) const { return {bits & other.bits}; }
    constexpr bool operator==(const EffectSet&) const = default;
};

/// The effects that leave texels and light as they are in the level's file: accuracy is measured with these alone.
inline constexpr EffectSet kStillEffects = EffectSet{}.with(Effect::Sky).with(Effect::Liquid).with(Effect::BrushModels);

/// Fog from worldspawn's key `fog`: "density r g b" as in FitzQuake, or DarkPlaces' form, which appends up to five
/// numbers: alpha, mindist, maxdist, top, fadedepth. Colours and alpha are from 0 to 1.
struct LevelFog {
    using Density = Fixed<std::int64_t, 24>;

    Density density;  ///< above 0, at most 64; at depth z the share of fog is 1 - exp(-(density / 64 z)^2)
    Rgb8 colour;
    std::int32_t alpha_256 = 256;                ///< multiplies the share of fog
    World nearest, farthest = World::highest();  ///< no fog before, no more behind; 0 <= nearest < farthest
    bool has_top = false;                        ///< height fog: none above `top`, full below top - fade_depth
    World top, fade_depth;                       ///< fade_depth above 0
};

/// The kinds of liquids. Texture names with "slime", "lava" or "tele" in them give the last three.
enum class LiquidKind : std::uint8_t { Water, Slime, Lava, Teleporter };
LiquidKind liquid_kind_of_texture(std::string_view name);

/// Palette entries `first` to `last`, rotated one place up at each step. Key `palette_cycle`: "first last
/// steps_per_second".
struct PaletteCycle {
    using Rate = Fixed<std::int64_t, 16>;

    std::uint8_t first = 0, last = 0;  ///< first < last
    Rate steps_per_second;             ///< at most 1,000, not 0; negative: rotates down
    bool operator==(const PaletteCycle&) const = default;
};

/// The opacity of a brush model, from its entity's key `alpha`: 1 to 255 of 256.
struct ModelAlpha {
    ModelIndex model;
    std::int32_t alpha_256 = 256;
};

/// The effects set by a level's entities and texture names, read once.
struct LevelEffects {
    static constexpr std::size_t kMostPaletteCycles = 16;

    std::optional<LevelFog> fog;
    std::int32_t sky_fog_256 = 128;  ///< share of fog over the sky (FitzQuake's key `skyfog`, 0 to 1)
    std::array<std::uint16_t, 4> liquid_alpha_256{256, 256, 256, 256};  ///< by LiquidKind; 256: opaque
    std::vector<ModelAlpha> model_alphas;                               ///< those below 256
    std::vector<PaletteCycle> palette_cycles;
    LightPatterns light_patterns;
    TextureAnimations animations;
    /// Unknown keys of worldspawn, each once, and values that cannot be read. Limited in number; safe to print.
    std::vector<std::string> warnings;
};

LevelEffects read_level_effects(const Level& level);

}  // namespace oblong
