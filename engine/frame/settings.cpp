#include "engine/frame/settings.h"

#include <array>

#include "engine/base/table.h"

namespace oblong {

namespace {

struct NamedPreset {
    Preset preset;
    std::string_view name;
    Accuracy accuracy;
};

constexpr std::array<NamedPreset, 5> kPresets{{
    {Preset::Year1991, "1991", {Texturing::Affine, 96, 0}},
    {Preset::Year1994, "1994", {Texturing::Affine, 96, 8}},
    {Preset::Year1996, "1996", {Texturing::Every16, 96, 8}},
    {Preset::Bounded, "bounded", {Texturing::Bounded, 96, 8}},
    {Preset::Exact, "exact", {Texturing::Exact, 96, 8}},
}};

const NamedPreset& entry_of(Preset preset) {
    return at(kPresets, preset);
}

}  // namespace

Accuracy accuracy_of(Preset preset) {
    return entry_of(preset).accuracy;
}

std::string_view name_of(Preset preset) {
    return entry_of(preset).name;
}

std::optional<Preset> preset_named(std::string_view name) {
    for (const NamedPreset& entry : kPresets)
        if (entry.name == name) return entry.preset;
    return std::nullopt;
}

}  // namespace oblong
