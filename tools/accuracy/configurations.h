#pragma once

#include <span>
#include <string>
#include <vector>

#include "engine/accuracy/accuracy.h"

namespace oblong {

/// What is measured of a setting.
enum class Measure {
    Displacement,  ///< the distance of texels from their exact places on the screen, pixels
    Texels,        ///< the same, texels of mip level 0
    WrongPixels,   ///< the pixels that show a wrong face, without close calls
    EdgePixels,    ///< the pixels that show another face than with exact edges
    CloseCalls,    ///< the close calls that show a wrong face
    FreePixels,    ///< the pixels that no face covers
    LightColour,   ///< the distance of texels' colours from their exactly lit colours
    PixelColour    ///< the distance of pixels from the mean colour of their area
};
inline constexpr std::size_t kMeasureCount = 8;

/// Settings that are measured together; each is a complete Accuracy.
struct Configurations {
    struct Row {
        std::string name;       ///< of the setting, or the preset
        std::size_t index = 0;  ///< into `accuracies`
        std::size_t alone = 0;  ///< if DialRows::is_below_bound, the same with a division for each pixel; else `index`
    };
    struct DialRows {
        const Dial* dial = nullptr;
        Measure measure = Measure::Displacement;
        std::string base;  ///< the values of the other dials
        /// Its displacement is below the default's error bound, which hides it: its own error is measured with a
        /// division for each pixel.
        bool is_below_bound = false;
        std::vector<Row> rows;  ///< from the coarsest to the most exact
    };

    std::vector<Accuracy> accuracies;  ///< all different
    std::size_t default_index = 0;
    std::vector<DialRows> dials;
    std::vector<Row> presets;
    std::vector<Row> frontier;   ///< combinations that a search found (frontier.h)
    std::vector<bool> has_cost;  ///< by accuracy: its cost is reported
};

/// Every setting of these dials with the others at their defaults (for the bound in texels:
/// perspective=bounded-texels), and the presets.
Configurations make_configurations(std::span<const Dial> dials);

/// The index of an accuracy among all, to which it is added if it is new.
std::size_t index_of(const Accuracy& accuracy, Configurations& all);

/// How a dial's settings are measured.
Measure measure_of(const Dial& dial);
/// Whether both settings give the same lit surfaces.
bool has_same_surfaces(const Accuracy& a, const Accuracy& b);

}  // namespace oblong
