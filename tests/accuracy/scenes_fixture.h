#pragma once

#include "engine/io/files.h"
#include "tests/support/folders.h"
#include "tools/accuracy/measured_level.h"
#include "tools/accuracy/report.h"

namespace oblong::test {

/// The hard scenes with their colours.
struct Scenes {
    Palette palette = read_palette(read_file(source_folder() + "/assets/palette.lmp"));
    Colormap colormap = make_colormap(palette);
    std::vector<MeasuredLevel> levels;

    explicit Scenes(std::size_t most_cameras) : levels(make_hard_scenes(palette, most_cameras)) {}

    const MeasuredLevel& named(std::string_view name) const {
        return *std::find_if(levels.begin(), levels.end(), [&](const auto& level) { return level.name == name; });
    }
    MeasuredPlace place(std::string_view name) const { return {named(name), palette, colormap}; }
};

inline Accuracy textured_by(Texturing texturing) {
    Accuracy accuracy;
    accuracy.texturing = texturing;
    return accuracy;
}

}  // namespace oblong::test
