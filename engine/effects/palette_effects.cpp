#include "engine/effects/palette_effects.h"

#include <algorithm>
#include <span>

#include "engine/base/table.h"
#include "engine/fixed/power.h"
#include "engine/visibility/eye.h"

namespace oblong {

namespace {

/// By how many places a cycle's colours are rotated up. Whole rounds are removed first, so that the product fits at any
/// time.
std::int64_t cycle_shift(const PaletteCycle& cycle, std::int64_t time_ms) {
    constexpr std::int64_t kStep = std::int64_t{1000} << PaletteCycle::Rate::kFractionBits;
    const std::int64_t count = cycle.last - cycle.first + 1, round = count * kStep;
    const std::int64_t steps =
        time_ms % round * floor_of<PaletteCycle::Rate::kFractionBits>(cycle.steps_per_second) % round / kStep;
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

std::vector<PaletteCycle> shown_cycles(const std::vector<PaletteCycle>& cycles, Flashes flashes) {
    if (flashes == Flashes::Off) return {};
    std::vector<PaletteCycle> shown = cycles;
    if (flashes == Flashes::Reduced)
        for (PaletteCycle& cycle : shown)
            cycle.steps_per_second = std::clamp(cycle.steps_per_second, -kReducedCycleRate, kReducedCycleRate);
    return shown;
}

const MipTexture* texture_of(LiquidKind kind, const Level& level) {
    for (const MipTexture& texture : level.textures)
        if (texture.name.starts_with('*') && !texture.mips[3].empty() && liquid_kind_of_texture(texture.name) == kind)
            return &texture;
    return nullptr;
}

Rgb8 mean_colour(std::span<const std::uint8_t> texels, const Palette& palette) {
    std::size_t red = 0, green = 0, blue = 0;
    for (const std::uint8_t texel : texels) {
        const Rgb8 colour = palette.colours[texel];
        red += colour.red, green += colour.green, blue += colour.blue;
    }
    const auto mean = [&](std::size_t sum) { return static_cast<std::uint8_t>(sum / texels.size()); };
    return {mean(red), mean(green), mean(blue)};
}

/// IEC 61966-2-1: 12.92 L below 0.0031308, 1.055 L^(1/2.4) - 0.055 above.
std::uint8_t srgb_of(std::uint64_t light_30) {
    constexpr std::uint64_t kOne_30 = 1u << 30;
    light_30 = std::min(light_30, kOne_30);
    const std::uint64_t shown_30 =
        light_30 * 10'000'000 < kOne_30 * 31'308
            ? light_30 * 1292 / 100
            : (power_30(static_cast<std::uint32_t>(light_30), 5, 12) * std::uint64_t{1055} - kOne_30 * 55) / 1000;
    return static_cast<std::uint8_t>((shown_30 * 255 + (1u << 29)) >> 30);
}

}  // namespace

Tint liquid_tint(std::int32_t contents, const Level& level, const Palette& palette) {
    const auto tint = [&](LiquidKind kind, const Tint& quakes) {
        const MipTexture* const texture = texture_of(kind, level);
        return texture ? Tint{mean_colour(texture->mips[3], palette), quakes.share_256} : quakes;
    };
    switch (contents) {
        case contents::kWater:
            return tint(LiquidKind::Water, {{130, 80, 50}, 128});
        case contents::kSlime:
            return tint(LiquidKind::Slime, {{0, 25, 5}, 150});
        case contents::kLava:
            return tint(LiquidKind::Lava, {{255, 80, 0}, 150});
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
        item(table, value) = static_cast<std::uint8_t>((shown_30 * 255 + (1 << 29)) >> 30);
    }
    return table;
}

GammaTable make_tube_table() {
    constexpr std::uint32_t kOne_30 = 1u << 30, kBlack_30 = kOne_30 / 100 * kTubeBlack_per_cent;
    const std::uint32_t lift_30 = power_30(kBlack_30, 5, 12);
    GammaTable table{};
    for (std::uint64_t value = 0; value < 256; ++value) {
        const std::uint64_t volts_30 = lift_30 + (kOne_30 - lift_30) * value / 255;
        const std::uint64_t light_30 =
            std::max(power_30(static_cast<std::uint32_t>(volts_30), 12, 5), kBlack_30) - kBlack_30;
        item(table, value) = srgb_of((light_30 << 30) / (kOne_30 - kBlack_30));
    }
    return table;
}

PaletteEffects palette_effects_at(const Level& level, const LevelEffects& effects, const Palette& palette,
                                  const Vec3<World>& eye, Flashes flashes) {
    PaletteEffects shown;
    shown.cycles = shown_cycles(effects.palette_cycles, flashes);
    shown.liquid = liquid_tint(level.leaves[place_eye(level, eye).leaf].contents, level, palette);
    return shown;
}

Palette apply_palette_effects(const Palette& palette, const PaletteEffects& effects, std::int64_t time_ms) {
    Palette shown = palette;
    for (const PaletteCycle& cycle : effects.cycles) apply_cycle(cycle, time_ms, shown);
    apply_tint(effects.liquid, shown);
    apply_tint(effects.flash, shown);
    if (const auto& gamma = effects.gamma)
        for (Rgb8& to : shown.colours) to = {(*gamma)[to.red], (*gamma)[to.green], (*gamma)[to.blue]};
    return shown;
}

}  // namespace oblong
