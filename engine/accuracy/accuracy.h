#pragma once

#include <array>
#include <cstdint>
#include <optional>
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
    Exact           ///< a division a pixel
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

/// The dials: each is an approximation whose error and cost can be measured (list: engine/accuracy/dials.h), with its
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
    std::int32_t shades = 64;    ///< steps of light, half of them up to full light: 16, 32 or 64
    bool dithers_light = false;  ///< between two shades, by a pattern of 4x4 texels
    bool operator==(const Accuracy&) const = default;
};

/// The presets (--accuracy): what games of a year could afford, and two that no game could.
enum class Preset { Year1991, Year1994, Year1996, Bounded, Exact };
inline constexpr std::array kPresets = {Preset::Year1991, Preset::Year1994, Preset::Year1996, Preset::Bounded,
                                        Preset::Exact};

/// The dials of a preset.
Accuracy accuracy_of(Preset preset);
/// "1991", "1994", "1996", "bounded", "exact".
std::string_view name_of(Preset preset);
std::optional<Preset> preset_named(std::string_view name);

}  // namespace oblong
