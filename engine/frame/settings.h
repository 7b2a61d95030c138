#pragma once

#include <optional>
#include <string_view>

#include "engine/raster/accuracy.h"
#include "engine/scene/effects.h"

namespace oblong {

/// The named presets (--accuracy): what games of that year could afford, and two that none could.
enum class Preset { Year1991, Year1994, Year1996, Bounded, Exact };

/// The dials of a preset.
Accuracy accuracy_of(Preset preset);
/// "1991", "1994", "1996", "bounded", "exact".
std::string_view name_of(Preset preset);
/// The preset of that name, if there is one.
std::optional<Preset> preset_named(std::string_view name);

/// What the player or the developer sets; together with level, camera and time it determines a frame.
struct Settings {
    Accuracy accuracy;
    EffectSet allowed_effects = EffectSet::all();
    bool correct_aspect = true;  ///< false: the projection assumes square pixels (F2 in the game)
};

}  // namespace oblong
