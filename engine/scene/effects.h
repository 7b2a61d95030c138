#pragma once

#include <array>
#include <cstdint>
#include <string_view>

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

}  // namespace oblong
