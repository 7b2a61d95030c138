#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace oblong {

/// What a scene may need in addition to lit walls.
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

/// What a frame draws, found before it is drawn: the code of an effect that is not in it does not run.
struct FramePlan {
    EffectSet effects;
};

/// The effects that something in sight needs and the settings allow.
constexpr FramePlan plan_frame(EffectSet called_for, EffectSet allowed) {
    return {called_for & allowed};
}

}  // namespace oblong
