#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/level/level.h"

namespace oblong {

/// How much of the flicker and flashes is shown, for photosensitive players. Changes the picture only, not the game.
enum class Flashes : std::uint8_t {
    Full,
    Reduced,  ///< no light style changes by more than kReducedChange / 256 within a third of a second
    Off       ///< each light style at its mean brightness
};

inline constexpr int kLightStyleCount = 64;
inline constexpr std::uint16_t kStoredBrightness = 256;  ///< light as stored in the lightmaps

/// Brightness of each light style; 256: as stored in the lightmaps.
using LightStyles = std::array<std::uint16_t, kLightStyleCount>;

/// All light styles at their stored brightness.
constexpr LightStyles plain_light_styles() {
    LightStyles styles{};
    for (std::uint16_t& style : styles) style = kStoredBrightness;
    return styles;
}

inline constexpr std::int64_t kPatternStepMs = 100;         ///< duration of a letter, as in Quake
inline constexpr std::size_t kMostPatternLetters = 65'536;  ///< nearly two hours

/// The largest change of a style within a third of a second if flashes are reduced. WCAG 2.2, success criterion 2.3.1
/// (three flashes): a flash is a pair of opposing changes of a tenth or more of the maximum relative luminance, the
/// darker below 0.8. Luminance is about the displayed value to the power of 2.2. So this change is at most 0.08 of the
/// maximum where the darker is below 0.8.
inline constexpr std::int32_t kReducedChange = 10;

/// The brightness of a pattern's letter: 'a' is dark, 'm' as stored, 'z' 25/12 of that. (Quake multiplies by 22 instead
/// of 21 1/3, so its 'm' is 264.)
constexpr std::uint16_t brightness_of(char letter) {
    return static_cast<std::uint16_t>(((letter - 'a') * kStoredBrightness + 6) / 12);
}

/// Whether a text is a pattern: 1 to kMostPatternLetters letters from a to z.
bool is_light_pattern(std::string_view letters);

/// The brightness of one style over time, in steps of kPatternStepMs; repeats.
struct StyleSteps {
    std::vector<std::uint16_t> full, reduced;
    std::uint16_t mean = kStoredBrightness;

    /// time_ms >= 0.
    std::uint16_t at(std::int64_t time_ms, Flashes flashes) const;
};

/// The steps of a pattern (is_light_pattern).
StyleSteps make_style_steps(std::string_view letters);

/// The light styles of a level that change over time or differ from the stored brightness.
struct LightPatterns {
    struct Entry {
        std::uint8_t style;  ///< below kLightStyleCount
        StyleSteps steps;
    };
    std::vector<Entry> entries;  ///< each style once, in order; only styles used by a lit face

    bool has(std::uint8_t style) const;
    /// Whether one of a face's styles is among the entries.
    bool is_called_for_by(const Face& face) const;
};

/// The pattern of Quake's style 1 to 11; empty for all others, which are plain.
std::string_view quake_light_pattern(int style);

/// The patterns that a level's lit faces use: that of `own` if not empty, else Quake's.
LightPatterns make_light_patterns(const Level& level, const std::array<std::string, kLightStyleCount>& own);

/// The light styles at time_ms >= 0.
LightStyles light_styles_at(const LightPatterns& patterns, std::int64_t time_ms, Flashes flashes);

/// The light of a lit face at one place: the lightmap sample there, times the brightness of the face's styles, with 8
/// fraction bits.
struct LightAt {
    FaceIndex face;
    std::int32_t light_8;
};
/// On the nearest lit face of the world straight below a point. Models are lit like the floor below them (Quake's
/// R_LightPoint). None if no lit face is below or the level has no lightmaps.
std::optional<LightAt> light_below(const Level& level, const Vec3<World>& from, const LightStyles& styles);

/// The light of the sample that holds texel (u, v) of a lit face, counted from the surface's first: 0 to its extents.
/// `channel`: of coloured light, 0 to 2 for red, green or blue; none: its luminance.
std::int32_t light_8_of_sample(const Level& level, const Face& face, std::int64_t u, std::int64_t v,
                               const LightStyles& styles, std::optional<int> channel = std::nullopt);

}  // namespace oblong
