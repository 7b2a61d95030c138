#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace oblong {

/// What a scene can call for beside plain lit walls.
enum class Effect : std::uint8_t { Sky, Liquid, BrushModels };
inline constexpr std::array<std::string_view, 3> kEffectNames{"sky", "liquid", "brush_models"};

/// A set of effects.
struct EffectSet {
    std::uint32_t bits = 0;

    static constexpr EffectSet all() { return {(1u << kEffectNames.size()) - 1}; }
    constexpr bool has(Effect effect) const { return (bits >> static_cast<unsigned>(effect) & 1) != 0; }
    constexpr EffectSet with(Effect effect) const { return {bits | 1u << static_cast<unsigned>(effect)}; }
    constexpr EffectSet operator|(EffectSet other) const { return {bits | other.bits}; }
    constexpr EffectSet operator&(EffectSet other) const { return {bits & other.bits}; }
    constexpr bool operator==(const EffectSet&) const = default;
};

/// What one frame draws: plain data, made before it is drawn. An effect that is not on it executes no instruction.
struct FramePlan {
    EffectSet effects;
};

/// The effects that something in sight calls for and that the settings allow.
constexpr FramePlan plan_frame(EffectSet called_for, EffectSet allowed) {
    return {called_for & allowed};
}

}  // namespace oblong
