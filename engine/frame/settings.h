#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "engine/accuracy/accuracy.h"
#include "engine/scene/effects.h"
#include "engine/scene/light_styles.h"

namespace oblong {

/// How a frame finds out which face owns which pixel. All but the span buffer are there to be compared with it. What
/// measures depth from an eye has no meaning in a parallel view, which is drawn with the span buffer instead.
enum class HiddenSurfaces : std::uint8_t {
    SpanBuffer,     ///< visibility/span_buffer.h: the engine's
    ZBuffer,        ///< visibility/z_buffer.h
    Painter,        ///< visibility/painter.h: back to front by the tree
    PainterSorted,  ///< by the farthest z of each face: wrong for some scenes
    PainterMean,    ///< by the mean of its nearest and farthest z: wrong for others
    RayCasting      ///< visibility/ray_casting.h
};
inline constexpr std::array<std::string_view, 6> kHiddenSurfaceNames{"span-buffer",    "z-buffer",     "painter",
                                                                     "painter-sorted", "painter-mean", "ray-casting"};

/// Whether a method works in parallel views too.
constexpr bool serves_parallel_views(HiddenSurfaces method) {
    return method == HiddenSurfaces::SpanBuffer || method == HiddenSurfaces::Painter;
}

/// What the player or the developer sets; together with level, camera and time it determines a frame.
struct Settings {
    Accuracy accuracy;
    EffectSet allowed_effects = EffectSet::all();
    Flashes flashes = Flashes::Full;
    std::int32_t brightness_100 = 100;  ///< of the light on lit surfaces, hundredths; up to their brightest shade
    HiddenSurfaces hidden_surfaces = HiddenSurfaces::SpanBuffer;
    bool correct_aspect = true;  ///< false: the projection assumes square pixels (F2 in the game)
    bool operator==(const Settings&) const = default;
};

}  // namespace oblong
