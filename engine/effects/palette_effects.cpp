#include "engine/effects/palette_effects.h"

#include <algorithm>
#include <string>
#include <string_view>

#include "engine/base/input_error.h"
#include "engine/base/table.h"
#include "engine/fixed/power.h"
#include "engine/level/entities.h"

namespace oblong {

namespace {

/// A whole number from 0 to 255.
std::optional<std::int32_t> palette_index(std::string_view text) {
    const std::optional<std::int64_t> number_16 = parse_decimal(text, 16);
    if (!number_16 || (*number_16 & 0xffff) != 0 || *number_16 < 0 || *number_16 > 255 << 16) return std::nullopt;
    return static_cast<std::int32_t>(*number_16 >> 16);
}

std::optional<PaletteCycle> parse_palette_cycle(std::string_view text) {
    const std::optional<std::int32_t> from = palette_index(take_word(text)), to = palette_index(take_word(text));
    const std::optional<std::int64_t> rate_16 = parse_decimal(take_word(text), 16);
    if (!from || !to || *from >= *to || !rate_16 || !take_word(text).empty()) return std::nullopt;
    if (*rate_16 < -(kMostCycleSteps << 16) || *rate_16 > kMostCycleSteps << 16) return std::nullopt;
    return PaletteCycle{*from, *to, static_cast<std::int32_t>(*rate_16)};
}

/// How many places up the colours of a cycle are. Whole rounds are left out first, for the product to fit at any time.
std::int64_t cycle_shift(const PaletteCycle& cycle, std::int64_t time_ms) {
    constexpr std::int64_t kStep = std::int64_t{1000} << 16;
    const std::int64_t count = cycle.last - cycle.first + 1, round = count * kStep;
    const std::int64_t steps = time_ms % round * cycle.steps_per_second_16 % round / kStep;
    return steps < 0 ? steps + count : steps;
}

void apply_cycle(const PaletteCycle& cycle, std::int64_t time_ms, Palette& palette) {
    const auto first = palette.colours.begin() + cycle.first, end = palette.colours.begin() + cycle.last + 1;
    std::rotate(first, end - static_cast<std::ptrdiff_t>(cycle_shift(cycle, time_ms)), end);
}

void apply_tint(const Tint& tint, Palette& palette) {
    if (tint.share_256 == 0) return;
    const auto mixed = [&](std::int32_t from, std::int32_t to) {
        return static_cast<std::uint8_t>((from * (256 - tint.share_256) + to * tint.share_256) >> 8);
    };
    for (Rgb8& colour : palette.colours)
        colour = {mixed(colour.red, tint.colour.red), mixed(colour.green, tint.colour.green),
                  mixed(colour.blue, tint.colour.blue)};
}

void apply_gamma(const GammaTable& gamma, Palette& palette) {
    for (Rgb8& colour : palette.colours) colour = {gamma[colour.red], gamma[colour.green], gamma[colour.blue]};
}

}  // namespace

std::vector<PaletteCycle> read_palette_cycles(const Entity& worldspawn) {
    std::vector<PaletteCycle> cycles;
    for (int number = 1; number <= kMostPaletteCycles; ++number) {
        const std::string key = "palette_cycle" + (number == 1 ? "" : std::to_string(number));
        const std::string text = worldspawn.value(key);
        if (text.empty()) continue;
        const std::optional<PaletteCycle> cycle = parse_palette_cycle(text);
        if (!cycle)
            throw InputError("worldspawn, key " + key, "'" + text +
                                                           "', expected FIRST LAST STEPS_PER_SECOND: two palette "
                                                           "indices, 0 <= FIRST < LAST <= 255, and -100 to 100");
        cycles.push_back(*cycle);
    }
    return cycles;
}

Tint liquid_tint(std::int32_t contents) {
    switch (contents) {
        case contents::kWater:
            return {{130, 80, 50}, 128};
        case contents::kSlime:
            return {{0, 25, 5}, 150};
        case contents::kLava:
            return {{255, 80, 0}, 150};
        default:
            return {};
    }
}

Tint faded(const Tint& tint, std::int64_t elapsed_ms, std::int64_t duration_ms) {
    const std::int64_t left_ms = duration_ms - std::min(elapsed_ms, duration_ms);
    return {tint.colour, static_cast<std::int32_t>(tint.share_256 * left_ms / duration_ms)};
}

GammaTable make_gamma_table(std::int32_t gamma_100) {
    GammaTable table{};
    for (std::uint32_t value = 0; value < 256; ++value) {
        const std::uint64_t shown_30 = power_30(static_cast<std::uint32_t>((std::uint64_t{value} << 30) / 255), 100,
                                                static_cast<std::uint32_t>(gamma_100));
        at(table, value) = static_cast<std::uint8_t>((shown_30 * 255 + (1 << 29)) >> 30);
    }
    return table;
}

bool PaletteEffects::is_plain() const {
    return cycles.empty() && liquid.share_256 == 0 && damage.share_256 == 0 && pickup.share_256 == 0 &&
           fade.share_256 == 0 && !gamma;
}

Palette apply_palette_effects(const Palette& palette, const PaletteEffects& effects, std::int64_t time_ms) {
    Palette shown = palette;
    for (const PaletteCycle& cycle : effects.cycles) apply_cycle(cycle, time_ms, shown);
    for (const Tint& tint : {effects.liquid, effects.damage, effects.pickup, effects.fade}) apply_tint(tint, shown);
    if (effects.gamma) apply_gamma(*effects.gamma, shown);
    return shown;
}

}  // namespace oblong
