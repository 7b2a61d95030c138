#include "engine/accuracy/presets.h"

#include "engine/base/table.h"

namespace oblong {

namespace {

Accuracy textured_by(Texturing texturing, std::int32_t subpixel_bits) {
    Accuracy accuracy;
    accuracy.texturing = texturing;
    accuracy.subpixel_bits = subpixel_bits;
    return accuracy;
}

constexpr std::array<std::string_view, kPresets.size()> kNames{"1991", "1994", "1996", "bounded", "exact"};

}  // namespace

Accuracy accuracy_of(Preset preset) {
    switch (preset) {
        case Preset::Year1991:
            return textured_by(Texturing::Affine, 0);
        case Preset::Year1994:
            return textured_by(Texturing::Affine, 8);
        case Preset::Year1996:
            return textured_by(Texturing::Every16, 8);
        case Preset::Bounded:
            break;
        case Preset::Exact:
            return textured_by(Texturing::Exact, 8);
    }
    return {};
}

std::string_view name_of(Preset preset) {
    return at(kNames, preset);
}

std::optional<Preset> preset_named(std::string_view name) {
    for (const Preset preset : kPresets)
        if (name_of(preset) == name) return preset;
    return std::nullopt;
}

}  // namespace oblong
