#include "engine/accuracy/accuracy.h"

#include "engine/base/table.h"

namespace oblong {

namespace {

/// Whole pixels, short tables, and additions instead of divisions.
Accuracy of_1991() {
    Accuracy accuracy;
    accuracy.texturing = Texturing::Affine;
    accuracy.subpixel_bits = 0;
    accuracy.edges = EdgeStepping::Accumulated;
    accuracy.reciprocal = ReciprocalMethod::Table256;
    accuracy.sine = SineMethod::Lerp256;
    return accuracy;
}

Accuracy textured_by(Texturing texturing) {
    Accuracy accuracy;
    accuracy.texturing = texturing;
    return accuracy;
}

constexpr std::array<std::string_view, kPresets.size()> kNames{"1991", "1994", "1996", "bounded", "exact"};

}  // namespace

Accuracy accuracy_of(Preset preset) {
    switch (preset) {
        case Preset::Year1991:
            return of_1991();
        case Preset::Year1994:
            return textured_by(Texturing::Affine);
        case Preset::Year1996:
            return textured_by(Texturing::Every16);
        case Preset::Bounded:
            break;
        case Preset::Exact:
            return textured_by(Texturing::Exact);
    }
    return {};
}

std::string_view name_of(Preset preset) {
    return item(kNames, preset);
}

std::optional<Preset> preset_named(std::string_view name) {
    for (const Preset preset : kPresets)
        if (name_of(preset) == name) return preset;
    return std::nullopt;
}

}  // namespace oblong
