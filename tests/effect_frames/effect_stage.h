#pragma once

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

#include "engine/frame/frame.h"
#include "tests/map/map_source.h"
#include "tests/support/observed_workspace.h"
#include "tests/support/views.h"

/// Frames of small levels that call for effects, compiled on the spot.
namespace oblong::test {

/// Colours of the textures that compile_effects() knows. Colour i is a grey of i of 255 up to 223.
inline constexpr std::uint8_t kWall = 16, kFloor = 48, kOther = 80, kWater = 120, kWaterStripe = 160, kSlime = 200,
                              kLava = 224, kSign0 = 90, kSign1 = 92, kSign2 = 94, kSignOn = 96, kBars = 110,
                              kLamp = 210, kMirror = 9, kHole = 255;
/// The shadows' row of effect_colours().
inline constexpr int kShadowShade = Colormap::kOwnShade + 12;

struct MapText {
    std::string brushes, entities;
    std::vector<std::array<std::string, 2>> world_keys;
};

inline Point place_of(const Whole& p) {
    return {p[0] + 0.0, p[1] + 0.0, p[2] + 0.0};
}

/// A room of 512 x 512 x 192 units with these in it, and a start west of its middle.
inline MapText room_with(const std::string& brushes, const std::string& entities = "",
                         std::string_view walls = "wall") {
    return {room({-256, -256, 0}, {256, 256, 192}, 16, walls) + brushes,
            entities + entity_at("info_player_start", {-100, 0, 64}),
            {}};
}

/// With wall, floor, other, *water (striped), *slime, *lava, sky, +0sign to +2sign, +asign, {bars (striped with holes),
/// {lamp and mirror; a start where `MapText::entities` has none.
Level compile_effects(const MapText& text);

/// The palette of greys; every shade is the colour itself, but in shadows half of it up to 223.
Colormap effect_colours();
/// The same palette; a surface shows the number of its shade.
Colormap shades_as_colours();

using Picture = std::vector<std::uint8_t>;
inline constexpr int kPictureWidth = 320, kPictureHeight = 200, kPicturePixels = kPictureWidth * kPictureHeight;

/// A level, and what draws it at 320x200.
class EffectStage {
  public:
    EffectStage(Level its_level, const Camera& its_camera, Colormap colours = effect_colours(),
                std::vector<PlacedMesh> its_meshes = {});
    EffectStage(const MapText& text, const Camera& its_camera, Colormap colours = effect_colours())
        : EffectStage(compile_effects(text), its_camera, std::move(colours)) {}
    EffectStage(const EffectStage&) = delete;  // the workspace refers to the level

    /// In `work`, which keeps what the frames before left there.
    Picture draw(std::int64_t time_ms = 0) { return draw_in(work, time_ms); }
    Picture draw_afresh(std::int64_t time_ms = 0) const;
    Picture draw_in(FrameWorkspace& in, std::int64_t time_ms) const;
    Picture draw_without(Effect effect, std::int64_t time_ms = 0);
    Picture draw_without_models();
    /// Of the frame drawn last, in `work`.
    bool has(Effect effect) const { return work.plan.effects.has(effect); }
    bool has(std::string_view pass) const;
    std::int64_t pixels(Effect effect) const { return work.counts.of(effect); }
    std::int64_t pixels(std::string_view pass) const;
    /// The face that a pixel showed, behind what is seen through; none: the void.
    const Face* face_at(std::size_t pixel) const;
    const std::string& texture_at(std::size_t pixel) const;

    Level level;
    Colormap colormap;
    std::vector<PlacedModel> models;
    std::vector<MovingLight> moving_lights;
    std::vector<PlacedMesh> meshes;
    Settings settings;
    Camera camera;
    ObservedWorkspace work;
};

/// How many pixels differ.
std::int64_t changed_pixels(const Picture& a, const Picture& b);
std::int64_t count_of(const Picture& picture, std::uint8_t colour);
/// How many have a colour on the left half, and on the right one.
std::array<std::int64_t, 2> counts_by_side(const Picture& picture, std::uint8_t colour);
/// Whether pixels differ only where the frame drawn last showed a texture.
testing::AssertionResult differ_on(const EffectStage& stage, const std::string& texture, const Picture& a,
                                   const Picture& b);
/// Calls `visit(column, row, pixel)`.
void for_each_pixel(auto visit) {
    for (std::int32_t row = 0; row < kPictureHeight; ++row)
        for (std::int32_t column = 0; column < kPictureWidth; ++column)
            visit(column, row, static_cast<std::size_t>(row * kPictureWidth + column));
}
/// Each reading is a nanosecond later than the last.
inline std::int64_t ticking_ns() {
    static std::int64_t now_ns = 0;
    return ++now_ns;
}

}  // namespace oblong::test
