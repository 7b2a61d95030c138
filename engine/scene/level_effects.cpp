#include "engine/scene/level_effects.h"

#include <algorithm>
#include <set>

#include "engine/base/input_error.h"
#include "engine/base/table.h"
#include "engine/base/text.h"
#include "engine/level/entity_classes.h"
#include "engine/level/left_out.h"
#include "engine/scene/placed_models.h"

namespace oblong {

namespace {

using Warnings = std::vector<std::string>;
using Numbers = std::vector<std::int64_t>;

constexpr std::size_t kMostWarnings = 64;
constexpr int kFirstOwnStyle = 32;  ///< styles below are Quake's

/// By LiquidKind.
constexpr std::array<std::string_view, 4> kAlphaKeys{"wateralpha", "slimealpha", "lavaalpha", "telealpha"};

/// Text from the level, shortened.
std::string in_quotes(std::string_view text) {
    constexpr std::size_t kMost = 60;
    return "'" + std::string(text.substr(0, kMost)) + (text.size() > kMost ? "...'" : "'");
}

void warn(Warnings& warnings, const std::string& text) {
    warnings.push_back(printable(text));
}

void warn_of_value(Warnings& warnings, std::string_view key, std::string_view value, const std::string& expected) {
    warn(warnings, "worldspawn key " + in_quotes(key) + ": " + in_quotes(value) + ", expected " + expected);
}

constexpr bool is_within(std::int64_t value, std::int64_t least, std::int64_t most) {
    return value >= least && value <= most;
}

std::uint8_t channel_of(std::int64_t share_24) {
    return static_cast<std::uint8_t>((share_24 * 255 + (1 << 23)) >> 24);
}

constexpr char kFogForm[] =
    "density r g b [alpha mindist maxdist top fadedepth]: density 0 to 64, colours and alpha 0 to 1, 0 <= mindist < "
    "maxdist, fadedepth above 0, lengths up to 262144";

/// From numbers with 24 fraction bits; none unless each is in its range.
std::optional<LevelFog> fog_of(const Numbers& numbers) {
    constexpr std::int64_t kOne = std::int64_t{1} << LevelFog::Density::kFractionBits, kLongest = kOne << 18;
    const auto number = [&numbers](std::size_t i, std::int64_t otherwise) {
        return i < numbers.size() ? numbers[i] : otherwise;
    };
    const auto length = [](std::int64_t raw) { return convert<World>(LevelFog::Density::from_raw(raw)); };
    const std::int64_t alpha = number(4, kOne), nearest = number(5, 0), farthest = number(6, kLongest);
    const std::int64_t top = number(7, 0), fade_depth = number(8, 128 * kOne);
    const bool is_valid =
        is_within(std::ssize(numbers), 4, 9) && is_within(numbers[0], 0, 64 * kOne) &&
        std::all_of(numbers.begin() + 1, numbers.begin() + 4, [](auto part) { return is_within(part, 0, kOne); }) &&
        is_within(alpha, 0, kOne) && is_within(nearest, 0, kLongest - 1) && is_within(farthest, 1, kLongest) &&
        length(nearest) < length(farthest) && is_within(top, -kLongest, kLongest) &&
        is_within(fade_depth, 1, kLongest) && length(fade_depth) > World{};
    if (!is_valid) return std::nullopt;
    LevelFog fog;
    fog.density = LevelFog::Density::from_raw(numbers[0]);
    fog.colour = {channel_of(numbers[1]), channel_of(numbers[2]), channel_of(numbers[3])};
    fog.alpha_256 = static_cast<std::int32_t>((alpha * 256 + kOne / 2) / kOne);
    fog.nearest = length(nearest);
    if (numbers.size() > 6) fog.farthest = length(farthest);
    fog.has_top = numbers.size() > 7;
    fog.top = length(top);
    fog.fade_depth = length(fade_depth);
    return fog;
}

void read_fog(const std::string& value, LevelEffects& effects) {
    const std::optional<Numbers> numbers = parse_decimals(value, LevelFog::Density::kFractionBits);
    effects.fog = numbers ? fog_of(*numbers) : std::nullopt;
    if (!effects.fog) return warn_of_value(effects.warnings, "fog", value, kFogForm);
    if (effects.fog->density == LevelFog::Density{} || effects.fog->alpha_256 == 0) effects.fog.reset();
}

void read_alpha(LiquidKind kind, const std::string& key, const std::string& value, LevelEffects& effects) {
    const std::optional<std::int64_t> alpha_256 = parse_level_number(value, 8);
    if (!alpha_256 || !is_within(*alpha_256, 0, 256))
        return warn_of_value(effects.warnings, key, value, "an alpha from 0 to 1");
    item(effects.liquid_alpha_256, kind) = static_cast<std::uint16_t>(*alpha_256);
}

std::optional<PaletteCycle> palette_cycle_of(const Numbers& numbers) {
    using Rate = PaletteCycle::Rate;
    if (numbers.size() != 3) return std::nullopt;
    const Rate first = Rate::from_raw(numbers[0]), last = Rate::from_raw(numbers[1]), rate = Rate::from_raw(numbers[2]);
    const bool is_whole = first == Rate::from_int(floor_of(first)) && last == Rate::from_int(floor_of(last));
    if (!is_whole || first < Rate{} || last <= first || last > Rate::from_int(255)) return std::nullopt;
    if (rate == Rate{} || absolute(rate) > Rate::from_int(1000)) return std::nullopt;
    return PaletteCycle{static_cast<std::uint8_t>(floor_of(first)), static_cast<std::uint8_t>(floor_of(last)), rate};
}

void read_palette_cycle(const std::string& key, const std::string& value, LevelEffects& effects) {
    const std::optional<Numbers> numbers = parse_decimals(value, 16);
    const std::optional<PaletteCycle> cycle = numbers ? palette_cycle_of(*numbers) : std::nullopt;
    if (!cycle)
        return warn_of_value(
            effects.warnings, key, value,
            "first last steps_per_second: colours 0 <= first < last <= 255, -1000 to 1000 steps, not 0");
    if (effects.palette_cycles.size() == LevelEffects::kMostPaletteCycles)
        return warn(effects.warnings, "worldspawn key " + in_quotes(key) + ": expected 16 palette cycles at most");
    effects.palette_cycles.push_back(*cycle);
}

void read_sky_fog(const std::string& value, LevelEffects& effects) {
    const std::optional<std::int64_t> share_256 = parse_level_number(value, 8);
    if (!share_256 || *share_256 < 0 || *share_256 > 256)
        return warn_of_value(effects.warnings, "skyfog", value, "a share from 0 to 1");
    effects.sky_fog_256 = static_cast<std::int32_t>(*share_256);
}

/// The kind of liquid whose alpha a key sets, with or without a leading '_'.
std::optional<LiquidKind> kind_of_alpha_key(std::string_view key) {
    if (key.starts_with('_')) key.remove_prefix(1);
    const auto found = std::find(kAlphaKeys.begin(), kAlphaKeys.end(), key);
    if (found == kAlphaKeys.end()) return std::nullopt;
    return static_cast<LiquidKind>(found - kAlphaKeys.begin());
}

void read_world_key(const std::string& key, const std::string& value, LevelEffects& effects) {
    constexpr std::string_view kCycle = "palette_cycle";
    const bool is_cycle = key.starts_with(kCycle) && key.find_first_not_of("0123456789", kCycle.size()) == key.npos;
    if (key == "fog") return read_fog(value, effects);
    if (key == "skyfog" || key == "_skyfog") return read_sky_fog(value, effects);
    if (is_cycle) return read_palette_cycle(key, value, effects);
    if (const auto kind = kind_of_alpha_key(key)) return read_alpha(*kind, key, value, effects);
    const bool is_known = find_entity_key(*find_entity_class("worldspawn"), key) != nullptr;  // read elsewhere
    if (is_known || key.starts_with('_')) return;
    const std::string reason(reason_left_out(key));
    warn(effects.warnings, "worldspawn key " + in_quotes(key) + (reason.empty() ? " is unknown" : ": " + reason));
}

void read_world(const Level& level, LevelEffects& effects) {
    const auto is_world = [](const Entity& entity) { return role_of(entity) == ClassRole::Worldspawn; };
    const auto world = std::find_if(level.entities.begin(), level.entities.end(), is_world);
    if (world == level.entities.end()) return;
    std::set<std::string_view> seen;
    for (const auto& [key, value] : world->pairs)
        if (seen.insert(key).second) read_world_key(key, value, effects);
}

// As in other engines, 0 counts as absent. Of two entities with one model, the last counts.
void read_model_alphas(const Level& level, LevelEffects& effects) {
    for (const Entity& entity : level.entities) {
        const auto model = brush_model_of(entity, level);
        const std::string value = entity.value("alpha");
        if (!model || value.empty()) continue;
        const std::optional<std::int64_t> alpha_256 = parse_level_number(value, 8);
        if (!alpha_256 || !is_within(*alpha_256, 0, 256))
            warn(effects.warnings, "model " + entity.value("model") + ": alpha is " + in_quotes(value) +
                                       ", expected an opacity from 0 to 1");
        else if (*alpha_256 > 0 && *alpha_256 < 256)
            effects.model_alphas.push_back({*model, static_cast<std::int32_t>(*alpha_256)});
    }
}

/// What is wrong with a light's own pattern; empty if nothing.
std::string fault_of_pattern(const std::string& pattern, const std::string& style, const std::string& same_style) {
    if (style.empty()) return "its style is not a number from 32 to 63, expected a style that the game may set";
    if (!is_light_pattern(pattern)) return "expected 1 to 65536 letters from a to z";
    if (!same_style.empty() && same_style != pattern)
        return "style " + style + " has the pattern " + in_quotes(same_style) + " already, expected one";
    return "";
}

std::array<std::string, kLightStyleCount> own_patterns(const Level& level, Warnings& warnings) {
    std::array<std::string, kLightStyleCount> patterns;
    std::string none;
    for (const Entity& entity : level.entities) {
        const std::string pattern = entity.value("pattern");
        if (pattern.empty() || role_of(entity) != ClassRole::Lamp) continue;
        const std::int64_t style = parse_decimal(entity.value("style"), 0).value_or(-1);
        const bool is_own = is_within(style, kFirstOwnStyle, kLightStyleCount - 1);
        std::string& of_style = is_own ? item(patterns, style) : none;
        const std::string fault = fault_of_pattern(pattern, is_own ? std::to_string(style) : "", of_style);
        if (fault.empty())
            of_style = pattern;
        else
            warn(warnings, "light with the pattern " + in_quotes(pattern) + ": " + fault);
    }
    return patterns;
}

void limit_warnings(Warnings& warnings) {
    if (warnings.size() <= kMostWarnings) return;
    const std::size_t more = warnings.size() - kMostWarnings;
    warnings.resize(kMostWarnings);
    warnings.push_back(std::to_string(more) + " more warnings");
}

}  // namespace

LiquidKind liquid_kind_of_texture(std::string_view name) {
    if (name.find("lava") != name.npos) return LiquidKind::Lava;
    if (name.find("slime") != name.npos) return LiquidKind::Slime;
    return name.find("tele") != name.npos ? LiquidKind::Teleporter : LiquidKind::Water;
}

LevelEffects read_level_effects(const Level& level) {
    LevelEffects effects;
    effects.animations = TextureAnimations(level, effects.warnings);
    effects.light_patterns = make_light_patterns(level, own_patterns(level, effects.warnings));
    read_world(level, effects);
    read_model_alphas(level, effects);
    limit_warnings(effects.warnings);
    return effects;
}

}  // namespace oblong
