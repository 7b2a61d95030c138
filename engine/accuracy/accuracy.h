#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "engine/fixed/reciprocal.h"
#include "engine/fixed/sine_methods.h"

namespace oblong {

/// How texture coordinates are computed along a span, from the coarsest. All but Exact interpolate linearly between
/// divisions.
enum class Texturing {
    Affine,         ///< a division at the span's first and last pixel
    Every32,        ///< a division every 32 pixels
    Every16,        ///< every 16 (Quake)
    Every8,         ///< every 8
    Bounded,        ///< the longest blocks with an error on the screen below Accuracy::pixel_bound_256
    BoundedTexels,  ///< the longest blocks with an error on the texture below Accuracy::texel_bound_256
    Exact           ///< at each pixel the texel that a division there gives, most of them found without one
};

/// How an edge steps from row to row.
enum class EdgeStepping {
    Accumulated,  ///< adds a slope of 16.16: its rounding error accumulates
    Exact         ///< quotient and remainder, as Bresenham
};

/// How a texel's light is computed from samples 16 texels apart.
enum class LightSampling { Nearest, Interpolated };

/// How often a mip level is chosen.
enum class MipSelection {
    None,  ///< level 0 everywhere
    Face,  ///< by the nearest corner in view (Quake)
    Span   ///< by the nearest pixel of each span
};

/// The dials: each is an approximation whose error and cost can be measured (list: all_dials()), with its
/// default.
struct Accuracy {
    Texturing texturing = Texturing::Bounded;
    std::int32_t pixel_bound_256 = 96;                      ///< 1/256 pixel, 1 to 4,096
    std::int32_t texel_bound_256 = 96;                      ///< 1/256 texel, 1 to 4,096
    ReciprocalMethod reciprocal = ReciprocalMethod::Exact;  ///< of 1/z
    std::int32_t inverse_z_bits = 44;                       ///< fraction bits of 1/z, 12 to 44
    std::int32_t over_z_bits = 30;                          ///< fraction bits of u/z and v/z, 4 to 30
    SineMethod sine = SineMethod::NearestStep;              ///< of the camera's angles
    std::int32_t matrix_bits = 30;                          ///< fraction bits of the view's axes, 6 to 30
    std::int32_t view_bits = 16;                            ///< fraction bits of view positions, 0 to 16
    std::int32_t subpixel_bits = 8;                         ///< fraction bits of screen vertices, 0 (whole pixels) to 8
    EdgeStepping edges = EdgeStepping::Exact;
    bool mends_t_junctions = true;
    MipSelection mip = MipSelection::Face;
    std::int32_t mip_bias = 0;  ///< added to mip levels, -3 to 3: above 0 blurs, below 0 sharpens and flickers
    LightSampling light = LightSampling::Interpolated;
    std::int32_t shades = 64;         ///< steps of light, half of them up to full light: 16, 32 or 64
    bool textures_floors = true;      ///< false: floors and ceilings of faces are of one colour each
    bool dithers_light = false;       ///< between two shades, by a pattern of 4x4 texels
    std::int32_t colour_levels = 32;  ///< steps of red, green and blue in coloured light, 16 to 64; 0: its luminance
    bool operator==(const Accuracy&) const = default;
};

/// The presets (--accuracy): what games of a year did, and three that bound the error, the first of which a 486 draws
/// with fewer instructions than that of 1996.
enum class Preset { Year1991, Year1994, Year1996, Pixel, Bounded, Exact };
inline constexpr std::array kPresets = {Preset::Year1991, Preset::Year1994, Preset::Year1996,
                                        Preset::Pixel,    Preset::Bounded,  Preset::Exact};
inline constexpr std::string_view kPresetNames = "1991, 1994, 1996, pixel, bounded or exact";

/// The dials of a preset.
Accuracy accuracy_of(Preset preset);
/// One of kPresetNames.
std::string_view name_of(Preset preset);
std::optional<Preset> preset_named(std::string_view name);

/// One position of a dial.
struct DialSetting {
    std::string_view name;  ///< as in `--dial NAME=VALUE`
    std::int32_t value;
};

/// One field of Accuracy, with its name and values.
struct Dial {
    std::string_view name;     ///< as in `--dial NAME=VALUE`
    std::string_view caption;  ///< at most 20 characters, for the screen
    std::string_view about;    ///< one or two sentences
    std::string_view unit;     ///< empty if its values have names
    std::string_view read_in;  ///< the file that reads it from Accuracy
    /// Whether another setting changes the work done. If not, a value is only rounded to fewer bits in a wide type: its
    /// error is real, and it saves no time. (Gradients in 32 bits were tried: on an i486 spans were cut with 3 % fewer
    /// instructions, which their setting up cost several times.)
    bool changes_work;
    std::span<const DialSetting> settings;  ///< from the coarsest to the most exact
    /// Numbers from `least` to `greatest`, in steps of 2^-fraction_bits, are valid too, unless both are 0.
    std::int32_t least, greatest;
    int fraction_bits;
    std::int32_t (*get)(const Accuracy&);
    void (*set)(Accuracy&, std::int32_t);
};

/// All dials, in the order of the stages that read them.
std::span<const Dial> all_dials();
/// Null if there is none.
const Dial* dial_named(std::string_view name);

/// The name of a value, or its number: "every16", "0.375".
std::string value_text(const Dial& dial, std::int32_t value);
/// Moves a dial from the setting nearest to its value by `steps` toward the exact end (negative: the coarse end); stops
/// at the ends.
void turn(const Dial& dial, int steps, Accuracy& accuracy);

}  // namespace oblong
