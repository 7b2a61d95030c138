#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "engine/accuracy/accuracy.h"

namespace oblong {

/// The named presets (--accuracy): what games of that year could afford, and two that none could.
enum class Preset { Year1991, Year1994, Year1996, Bounded, Exact };
inline constexpr std::array kPresets = {Preset::Year1991, Preset::Year1994, Preset::Year1996, Preset::Bounded,
                                        Preset::Exact};

/// The dials of a preset.
Accuracy accuracy_of(Preset preset);
/// "1991", "1994", "1996", "bounded", "exact".
std::string_view name_of(Preset preset);
/// The preset of that name, if there is one.
std::optional<Preset> preset_named(std::string_view name);

}  // namespace oblong
