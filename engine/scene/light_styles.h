#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/level/level.h"

namespace oblong {

/// How much of a scene's flicker and flashes is shown, for photosensitive players. Changes the picture, never the game.
enum class Flashes : std::uint8_t {
    Full,
    Reduced,  ///< no light style changes by more than kReducedChange / 256 within a third of a second
    Off       ///< each light style at its mean brightness
};

inline constexpr int kLightStyleCount = 64;
inline constexpr std::uint16_t kStoredBrightness = 256;  ///< of light as the lightmaps store it

/// Brightness of the light styles, 256: as stored in the lightmaps.
using LightStyles = std::array<std::uint16_t, kLightStyleCount>;

/// All light styles at their stored brightness.
constexpr LightStyles plain_light_styles() {
    LightStyles styles{};
    for (std::uint16_t& style : styles) style = kStoredBrightness;
    return styles;
}

inline constexpr std::int64_t kPatternStepMs = 100;         ///< a letter's time, as in Quake
inline constexpr std::size_t kMostPatternLetters = 65'536;  ///< nearly two hours

/// The largest change of a style within a third of a second if flashes are reduced. WCAG 2.2, success criterion 2.3.1
/// (three flashes): a flash is a pair of opposing changes of a tenth or more of the maximum relative luminance, the
/// darker below 0.8. Luminance follows displayed values to the power of about 2.2, so that up to full light this change
/// is at most 0.08 of the maximum where the darker is below 0.8.
inline constexpr std::int32_t kReducedChange = 10;

/// The brightness that a letter of a pattern stands for: 'a' is dark, 'm' exactly as stored, 'z' 25/12 of that. (Quake
/// multiplies by 22 instead of 21 1/3, so that its 'm', 264, is no plain light.)
constexpr std::uint16_t brightness_of(char letter) {
    return static_cast<std::uint16_t>(((letter - 'a') * kStoredBrightness + 6) / 12);
}

/// Whether a text is a pattern: 1 to kMostPatternLetters letters from a to z.
bool is_light_pattern(std::string_view letters);

/// How the brightness of one style goes, a step of kPatternStepMs each; repeats.
struct StyleSteps {
    std::vector<std::uint16_t> full, reduced;
    std::uint16_t mean = kStoredBrightness;

    /// At a time from 0 on.
    std::uint16_t at(std::int64_t time_ms, Flashes flashes) const;
};

/// The steps of a pattern (is_light_pattern).
StyleSteps make_style_steps(std::string_view letters);

/// The light styles of a level that are not plain.
struct LightPatterns {
    struct Entry {
        std::uint8_t style;  ///< below kLightStyleCount
        StyleSteps steps;
    };
    std::vector<Entry> entries;  ///< each style once, in order; only styles that some lit face has

    bool is_empty() const { return entries.empty(); }
    bool has(std::uint8_t style) const;
    /// Whether one of a face's styles is not plain.
    bool is_called_for_by(const Face& face) const;
};

/// The pattern of one of Quake's styles, 1 to 11; empty for all others, which are plain.
std::string_view quake_light_pattern(int style);

/// The patterns that a level's lit faces use: Quake's for its styles, those of `own` for styles that have one.
LightPatterns make_light_patterns(const Level& level, const std::array<std::string, kLightStyleCount>& own);

/// The light styles at a time from 0 on; a pure function of its arguments, so that a style needs no catching up.
LightStyles light_styles_at(const LightPatterns& patterns, std::int64_t time_ms, Flashes flashes);

/// The light on the nearest lit face of the world straight below a point: the lightmap's sample that holds the place,
/// by the brightness of the face's styles; a lightmap value, 8 fraction bits. What stands there is lit as its floor is
/// (Quake's R_LightPoint). None where no lit face is below, or the level has no light.
std::optional<std::int32_t> light_8_below(const Level& level, const Vec3<World>& from, const LightStyles& styles);

/// The light of the sample that holds a texel of a lit face, counted from the surface's first one: from 0 to its
/// extents.
std::int32_t light_8_of_sample(const Level& level, const Face& face, std::int64_t u, std::int64_t v,
                               const LightStyles& styles);

}  // namespace oblong
