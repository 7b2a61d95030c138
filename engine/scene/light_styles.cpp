#include "engine/scene/light_styles.h"

#include <algorithm>
#include <numeric>

#include "engine/base/table.h"
#include "engine/fixed/arithmetic.h"
#include "engine/level/side.h"

namespace oblong {

namespace {

/// Steps that may begin within a third of a second.
constexpr std::size_t kStepsOfChange = 4;
/// Reduced styles are averaged over a second: a strobe becomes its mean, a slow pulse stays.
constexpr std::size_t kAveragedSteps = 10;

/// For each value the sum of `steps` values from there on; values repeat.
std::vector<std::int32_t> sums_ahead(const std::vector<std::uint16_t>& values, std::size_t steps) {
    std::vector<std::int32_t> sums;
    std::int32_t sum = 0;
    for (std::size_t i = 0; i < steps; ++i) sum += values[i % values.size()];
    for (std::size_t i = 0; i < values.size(); ++i) {
        sums.push_back(sum);
        sum += values[(i + steps) % values.size()] - values[i];
    }
    return sums;
}

std::int32_t most_change(const std::vector<std::int32_t>& values, std::size_t steps) {
    std::int32_t most = 0;
    for (std::size_t i = 0; i < values.size(); ++i)
        for (std::size_t step = 1; step <= steps; ++step)
            most = std::max(most, std::abs(values[(i + step) % values.size()] - values[i]));
    return most;
}

/// Averages, then scales all differences from the mean so that no change is too large. kReducedChange - 1 leaves room
/// for rounding.
std::vector<std::uint16_t> reduced_steps(const std::vector<std::uint16_t>& full, std::int32_t mean) {
    constexpr std::int64_t kMost = (kReducedChange - 1) * static_cast<std::int64_t>(kAveragedSteps);
    const std::vector<std::int32_t> sums = sums_ahead(full, kAveragedSteps);
    const std::int64_t change = std::max<std::int64_t>(most_change(sums, kStepsOfChange), kMost);
    std::vector<std::uint16_t> reduced;
    for (const std::int32_t sum : sums) {
        const std::int64_t away = sum - std::int64_t{mean} * static_cast<std::int64_t>(kAveragedSteps);
        const std::int64_t limited = away * kMost / change / static_cast<std::int64_t>(kAveragedSteps);
        reduced.push_back(static_cast<std::uint16_t>(mean + limited));
    }
    return reduced;
}

std::array<bool, kLightStyleCount> styles_in_use(const Level& level) {
    std::array<bool, kLightStyleCount> in_use{};
    for (const Face& face : level.faces) {
        if (face.light_offset < 0) continue;
        for (const std::uint8_t style : face.used_styles()) item(in_use, style % kLightStyleCount) = true;
    }
    return in_use;
}

}  // namespace

bool is_light_pattern(std::string_view letters) {
    return !letters.empty() && letters.size() <= kMostPatternLetters &&
           std::all_of(letters.begin(), letters.end(), [](char letter) { return letter >= 'a' && letter <= 'z'; });
}

std::uint16_t StyleSteps::at(std::int64_t time_ms, Flashes flashes) const {
    if (flashes == Flashes::Off || full.empty()) return mean;
    const std::vector<std::uint16_t>& steps = flashes == Flashes::Full ? full : reduced;
    return item(steps, static_cast<std::uint64_t>(time_ms / kPatternStepMs) % steps.size());
}

StyleSteps make_style_steps(std::string_view letters) {
    StyleSteps steps;
    for (const char letter : letters) steps.full.push_back(brightness_of(letter));
    const std::int64_t sum = std::accumulate(steps.full.begin(), steps.full.end(), std::int64_t{0});
    const std::int64_t count = std::ssize(steps.full);
    steps.mean = static_cast<std::uint16_t>((sum * 2 + count) / (count * 2));
    steps.reduced = reduced_steps(steps.full, steps.mean);
    return steps;
}

bool LightPatterns::has(std::uint8_t style) const {
    return std::any_of(entries.begin(), entries.end(), [style](const Entry& entry) { return entry.style == style; });
}

bool LightPatterns::is_called_for_by(const Face& face) const {
    if (face.light_offset < 0) return false;
    const auto styles = face.used_styles();
    return std::any_of(styles.begin(), styles.end(),
                       [this](std::uint8_t style) { return has(style % kLightStyleCount); });
}

std::string_view quake_light_pattern(int style) {
    // From Quake's world.qc. Style 0 is "m": plain.
    constexpr std::array<std::string_view, 12> kPatterns{"",
                                                         "mmnmmommommnonmmonqnmmo",
                                                         "abcdefghijklmnopqrstuvwxyzyxwvutsrqponmlkjihgfedcba",
                                                         "mmmmmaaaaammmmmaaaaaabcdefgabcdefg",
                                                         "mamamamamama",
                                                         "jklmnopqrstuvwxyzyxwvutsrqponmlkj",
                                                         "nmonqnmomnmomomno",
                                                         "mmmaaaabcdefgmmmmaaaammmaamm",
                                                         "mmmaaammmaaammmabcdefaaaammmmabcdefmmmaaaa",
                                                         "aaaaaaaazzzzzzzz",
                                                         "mmamammmmammamamaaamammma",
                                                         "abcdefghijklmnopqrrqponmlkjihgfedcba"};
    return style >= 0 && style < std::ssize(kPatterns) ? item(kPatterns, style) : std::string_view{};
}

LightPatterns make_light_patterns(const Level& level, const std::array<std::string, kLightStyleCount>& own) {
    LightPatterns patterns;
    const std::array<bool, kLightStyleCount> in_use = styles_in_use(level);
    for (int style = 0; style < kLightStyleCount; ++style) {
        const std::string_view letters = item(own, style).empty() ? quake_light_pattern(style) : item(own, style);
        const bool is_plain = letters.find_first_not_of('m') == std::string_view::npos;
        if (is_plain || !item(in_use, style)) continue;
        patterns.entries.push_back({static_cast<std::uint8_t>(style), make_style_steps(letters)});
    }
    return patterns;
}

LightStyles light_styles_at(const LightPatterns& patterns, std::int64_t time_ms, Flashes flashes) {
    LightStyles styles = plain_light_styles();
    for (const LightPatterns::Entry& entry : patterns.entries)
        item(styles, entry.style) = entry.steps.at(time_ms, flashes);
    return styles;
}

namespace {

constexpr World kLowest = World::from_int(-524'287);

/// The light of a face's sample at a point of its plane; none outside the face's extents.
std::optional<std::int32_t> light_8_on(const Level& level, const Face& face, const Vec3<World>& p,
                                       const LightStyles& styles) {
    const TexInfo& texinfo = level.texinfos[face.texinfo];
    if (texinfo.material != Material::Lit) return std::nullopt;
    const std::int64_t u = floor_of(texel_along(texinfo.s, p) + texinfo.s_offset) - face.texel_min_u,
                       v = floor_of(texel_along(texinfo.t, p) + texinfo.t_offset) - face.texel_min_v;
    if (u < 0 || v < 0 || u > face.texel_extent_u || v > face.texel_extent_v) return std::nullopt;
    return light_8_of_sample(level, face, u, v, styles);
}

/// Of the first of a node's faces whose extents hold `p`.
std::optional<LightAt> light_at(const Level& level, NodeIndex node, const Vec3<World>& p, const LightStyles& styles) {
    for (const FaceIndex face : level.nodes[node].faces)
        if (const auto light_8 = light_8_on(level, level.faces[face], p, styles)) return LightAt{face, *light_8};
    return std::nullopt;
}

}  // namespace

std::int32_t light_8_of_sample(const Level& level, const Face& face, std::int64_t u, std::int64_t v,
                               const LightStyles& styles, std::optional<int> channel) {
    std::int32_t sum_8 = 0;
    if (face.light_offset < 0) return sum_8;
    const std::int64_t columns = face.sample_columns(), rows = face.sample_rows();
    std::int64_t sample = face.light_offset + v / 16 * columns + u / 16;
    for (const std::uint8_t style : face.used_styles()) {
        const std::uint8_t light =
            channel ? item(level.coloured_lighting, 3 * sample + *channel) : item(level.lighting, sample);
        sum_8 += light * styles[style % styles.size()];
        sample += columns * rows;
    }
    return sum_8;
}

std::optional<LightAt> light_below(const Level& level, const Vec3<World>& from, const LightStyles& styles) {
    if (level.lighting.empty()) return std::nullopt;
    std::optional<LightAt> light;
    walk_line(level, level.world().root, from, {from.x, from.y, kLowest}, {},
              [&](LeafIndex, std::optional<NodeIndex> entered, const Vec3<World>& place) {
                  if (entered) light = light_at(level, *entered, place, styles);
                  return light.has_value();
              });
    return light;
}

}  // namespace oblong
