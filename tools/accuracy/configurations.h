#pragma once

#include <span>
#include <string>
#include <vector>

#include "engine/accuracy/accuracy.h"
#include "engine/accuracy/dials.h"

namespace oblong {

/// What a dial's settings are measured by.
enum class Measure {
    Displacement,  ///< how far texels are from their places on the screen
    WrongPixels,   ///< how many pixels show another face
    EdgePixels,    ///< how many pixels show another face than with exact edges
    FreePixels,    ///< how many pixels no face covers
    LightColour,   ///< how far the colours of texels are from those the light gives them
    PixelColour    ///< how far pixels are from the mean colour of what they cover
};

/// Settings that are measured together: each a whole Accuracy.
struct Configurations {
    struct Row {
        std::string name;       ///< of the setting, or the preset
        std::size_t index = 0;  ///< into `accuracies`
        std::size_t alone = 0;  ///< the same with a division a pixel, where DialRows::is_below_bound; else `index`
    };
    struct DialRows {
        const Dial* dial = nullptr;
        Measure measure = Measure::Displacement;
        std::string base;  ///< what the other dials stand at
        /// What it adds to the displacement is below what the default's bound lets pass, which therefore hides it: its
        /// own error shows around a division a pixel.
        bool is_below_bound = false;
        std::vector<Row> rows;  ///< from the coarsest to the most exact
    };

    std::vector<Accuracy> accuracies;  ///< all different
    std::size_t default_index = 0;
    std::vector<DialRows> dials;
    std::vector<Row> presets;
    std::vector<bool> is_timed;    ///< by accuracy: it runs other code than the default does
    std::vector<bool> is_counted;  ///< by accuracy: its cost is asked for
};

/// Every setting of these dials around the default, the bound in texels around perspective=bounded-texels, and the
/// presets.
Configurations make_configurations(std::span<const Dial> dials);

inline constexpr std::size_t kMeasureCount = 6;

Measure measure_of(const Dial& dial);
/// What lit surfaces depend on.
bool has_same_surfaces(const Accuracy& a, const Accuracy& b);

}  // namespace oblong
