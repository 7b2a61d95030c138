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

/// Fog as the key `fog` of worldspawn asks for: "density r g b", as in FitzQuake, or DarkPlaces' longer form, whose
/// further numbers alpha, mindist, maxdist, top, fadedepth may be left out from the end. Colours and alpha are from 0
/// to 1.
struct LevelFog {
    using Density = Fixed<std::int64_t, 24>;

    Density density;  ///< above 0, 64 at most; at depth z the share of fog is 1 - exp(-(density / 64 z)^2)
    Rgb8 colour;
    std::int32_t alpha_256 = 256;                ///< the share of fog is multiplied by it
    World nearest, farthest = World::highest();  ///< none before, no more behind; 0 <= nearest < farthest
    bool has_top = false;                        ///< height fog: none above `top`, all from top - fade_depth down
    World top, fade_depth;                       ///< fade_depth above 0
};

/// The kinds of liquids, by texture names: those with "slime", "lava" or "tele" in them, and all others.
enum class LiquidKind : std::uint8_t { Water, Slime, Lava, Teleporter };
LiquidKind liquid_kind_of_texture(std::string_view name);

/// Colours `first` to `last` that move round in their places: `last` to `first` and all others one place up at each
/// step. `palette_cycle` "first last steps_per_second".
struct PaletteCycle {
    using Rate = Fixed<std::int64_t, 16>;

    std::uint8_t first = 0, last = 0;  ///< first < last
    Rate steps_per_second;             ///< up to 1,000, not 0; negative: one place down
    bool operator==(const PaletteCycle&) const = default;
};

/// What a level calls for by its entities and texture names, read once.
struct LevelEffects {
    static constexpr std::size_t kMostPaletteCycles = 16;

    std::optional<LevelFog> fog;
    std::int32_t sky_fog_256 = 128;  ///< how much of the fog lies over the sky (FitzQuake's key `skyfog`, 0 to 1)
    std::array<std::uint16_t, 4> liquid_alpha_256{256, 256, 256, 256};  ///< by LiquidKind; 256: opaque
    std::vector<PaletteCycle> palette_cycles;
    LightPatterns light_patterns;
    TextureAnimations animations;
    /// What is not obeyed: unknown keys of worldspawn, each once, and values that cannot be read. At most some dozens;
    /// safe to print.
    std::vector<std::string> warnings;
};

LevelEffects read_level_effects(const Level& level);

}  // namespace oblong
