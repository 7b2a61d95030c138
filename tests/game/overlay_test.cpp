#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <vector>

#include "game/aspect_guide.h"
#include "game/comparison.h"
#include "game/error_map.h"
#include "game/hud.h"
#include "game/lab_panel.h"

namespace oblong {
namespace {

constexpr std::uint8_t kGuard = 7, kPicture = 100;

Palette grey_palette() {
    Palette palette;
    for (int i = 0; i < 256; ++i) {
        const auto level = static_cast<std::uint8_t>(i);
        palette.colours[static_cast<std::size_t>(i)] = {level, level, level};
    }
    return palette;
}
const Palette kPalette = grey_palette();
const TextColours kColours = text_colours_of(kPalette);

// A canvas of one colour with a border around it that nothing may touch.
class GuardedCanvas {
  public:
    static constexpr std::int32_t kBorder_px = 40;

    GuardedCanvas(std::int32_t width, std::int32_t height)
        : pitch_(width + 2 * kBorder_px), pixels_(pixel_count(pitch_, height + 2 * kBorder_px), kGuard) {
        canvas_ = {pixels_.data() + kBorder_px * pitch_ + kBorder_px, width, height, pitch_};
        for (std::int32_t y = 0; y < height; ++y) std::fill_n(canvas_.row(y), width, kPicture);
    }

    Framebuffer canvas() const { return canvas_; }
    bool is_border_whole() const {
        std::size_t guards = 0;
        for (const std::uint8_t pixel : pixels_) guards += pixel == kGuard;
        for (std::int32_t y = 0; y < canvas_.height_px; ++y)
            guards -= static_cast<std::size_t>(std::count(canvas_.row(y), canvas_.row(y) + canvas_.width_px, kGuard));
        return guards == pixels_.size() - pixel_count(canvas_.width_px, canvas_.height_px);
    }
    // The box of the pixels of which `is_drawn` holds.
    template <class IsDrawn>
    Area box_of(IsDrawn is_drawn) const {
        std::int32_t left = canvas_.width_px, right = 0, top = canvas_.height_px, bottom = 0;
        for (std::int32_t y = 0; y < canvas_.height_px; ++y)
            for (std::int32_t x = 0; x < canvas_.width_px; ++x) {
                if (!is_drawn(canvas_.row(y)[x])) continue;
                left = std::min(left, x), right = std::max(right, x + 1);
                top = std::min(top, y), bottom = std::max(bottom, y + 1);
            }
        return {left, top, right - left, bottom - top};
    }

  private:
    std::int32_t pitch_;
    std::vector<std::uint8_t> pixels_;
    Framebuffer canvas_;
};

// All figures as long as they get.
LabFigures long_figures() {
    LabFigures figures;
    for (std::size_t i = 0; i < kPresets.size(); ++i)
        figures.presets[i].frame_ns = {12'345'000, 12'000'000, 13'000'000};
    figures.now.accuracy.reciprocal = ReciprocalMethod::Table1024Newton;
    figures.now.accuracy.texturing = Texturing::BoundedTexels;
    figures.now.frame_ns = {23'456'000, 20'000'000, 29'000'000};
    figures.before.frame_ns = {34'567'000, 30'000'000, 39'000'000};
    figures.operations.adds[Width::Bits32] = figures.operations.multiplications[Width::Bits64] =
        figures.operations.divisions[Width::Bits64] = figures.operations.lookups = 888'888;
    figures.frame_rates = {888, 888, 888};
    figures.errors = ErrorSummary{64'000, 377.36, 377.36, 377.36};
    return figures;
}

// Every pass and effect there is, with numbers as long as they get.
CostText long_cost() {
    CostText cost;
    cost.frame = "99999 us a frame, 999 frames a second";
    cost.background.fill(kPicture);
    for (const std::string_view name : kPassNames) cost.passes.push_back({name, 64'000, 9'999'000});
    for (const std::string_view name : kEffectNames) cost.effects.push_back({name, 64'000, 9'999'000});
    return cost;
}

void draw_everything(const ScreenMode& mode, const GuardedCanvas& guarded) {
    const Framebuffer canvas = guarded.canvas();
    LabOptions options;
    options.flips = options.splits = true;
    const CostText cost = long_cost();
    const HudText text{{"[door]"}, {"a wall"}, &cost};
    Messages messages;
    messages.show(std::string(200, 'm'));
    draw_aspect_guide(mode, kColours, canvas);
    for (const std::int32_t split : {0, 1, 32'768, 65'535, 65'536}) {
        options.split_16 = split;
        draw_split(options, canvas, kColours, canvas);
        draw_split_names(options, "bounded, 3 dials turned", "exact", canvas.height_px, kColours, canvas);
    }
    for (options.dial = 0; options.dial < all_dials().size(); ++options.dial)
        draw_lab_panel(options, long_figures(), panel_colours_of(kPalette), canvas);
    const std::int32_t bottom =
        ErrorMap(kPalette, ColourScheme::Standard).draw_legend(canvas.height_px, kColours, canvas);
    draw_hud(text, messages, 0, draw_flip_names(options, {}, 0, bottom, kColours, canvas), kColours, ColourTable{},
             canvas);
}

TEST(Overlay, StaysInTheCanvas) {
    for (const ScreenMode& mode :
         {ScreenMode{8, 8, {4, 3}}, ScreenMode{8, 400, {4, 3}}, ScreenMode{640, 8, {4, 3}}, ScreenMode{64, 48, {4, 3}},
          ScreenMode{160, 100, {4, 3}}, ScreenMode{320, 200, {4, 3}}, ScreenMode{321, 201, {16, 9}},
          ScreenMode{640, 200, {4, 3}}, ScreenMode{640, 400, {4, 3}}}) {
        const GuardedCanvas guarded(mode.width_px, mode.height_px);
        draw_everything(mode, guarded);
        EXPECT_TRUE(guarded.is_border_whole()) << mode.width_px << "x" << mode.height_px;
    }
}

TEST(Overlay, ThePanelsTextFits320Columns) {
    const GuardedCanvas guarded(640, 400);
    LabOptions options;
    for (options.dial = 0; options.dial < all_dials().size(); ++options.dial) {
        draw_lab_panel(options, long_figures(), panel_colours_of(kPalette), guarded.canvas());
        const Area text = guarded.box_of([](std::uint8_t colour) { return colour == kColours.bright; });
        EXPECT_LE(text.x + text.width, 319) << all_dials()[options.dial].caption;  // and a column for the shadow
    }
    EXPECT_LE(lab_panel_rows(guarded.canvas()), 110);  // half of the view stays open
}

TEST(Overlay, ThePlanFits320x200InTwoColumns) {
    const GuardedCanvas guarded(640, 200);
    CostText cost = long_cost();
    draw_cost(cost, 200 - kTextMargin_px, kColours, guarded.canvas());
    const Area all = guarded.box_of([](std::uint8_t colour) { return colour != kPicture; });
    EXPECT_LE(all.x + all.width, 320);
    EXPECT_GE(all.y, 20);  // messages stay free
    const GuardedCanvas left(640, 200);
    cost.effects.clear();
    draw_cost(cost, 200 - kTextMargin_px, kColours, left.canvas());
    for (std::int32_t y = 0; y < 180; ++y)
        for (std::int32_t x = 148; x < 320; ++x) ASSERT_EQ(left.canvas().row(y)[x], kPicture) << x << ", " << y;
}

TEST(Overlay, CountsAreShort) {
    EXPECT_EQ(short_count(0), "0");
    EXPECT_EQ(short_count(999), "999");
    EXPECT_EQ(short_count(1000), "1.0k");
    EXPECT_EQ(short_count(9949), "9.9k");
    EXPECT_EQ(short_count(9950), "10k");
    EXPECT_EQ(short_count(999'499), "999k");
    EXPECT_EQ(short_count(999'500), "1.0M");
    EXPECT_EQ(short_count(123'456'789), "123M");
}

TEST(Split, ShowsTheOtherPictureRightOfTheLine) {
    std::vector<std::uint8_t> ours(40, 1), other(40, 2);
    LabOptions options;
    options.split_16 = 65'536 * 3 / 10;
    draw_split(options, {other.data(), 10, 4, 10}, kColours, {ours.data(), 10, 4, 10});
    const std::uint8_t b = kColours.bright, d = kColours.dark;
    for (int y = 0; y < 4; ++y)
        EXPECT_EQ(std::vector<std::uint8_t>(ours.begin() + 10 * y, ours.begin() + 10 * y + 10),
                  (std::vector<std::uint8_t>{1, d, b, 2, 2, 2, 2, 2, 2, 2}));
}

TEST(ErrorMap, HasABandForEachDoubling) {
    EXPECT_EQ(ErrorMap::band_of(-1), 0u);
    EXPECT_EQ(ErrorMap::band_of(0.124F), 0u);
    EXPECT_EQ(ErrorMap::band_of(0.125F), 1u);
    EXPECT_EQ(ErrorMap::band_of(0.999F), 3u);
    EXPECT_EQ(ErrorMap::band_of(1), 4u);
    EXPECT_EQ(ErrorMap::band_of(4), ErrorMap::kBands - 1);
    EXPECT_EQ(ErrorMap::band_of(std::numeric_limits<float>::infinity()), ErrorMap::kBands - 1);
}

// A palette of the map's own hues, so that each band has another colour; dark and bright pixels stay apart.
TEST(ErrorMap, ColoursByBandAndBrightness) {
    Palette palette;
    for (int i = 0; i < 256; ++i) {
        const auto channel = [](int bits) { return static_cast<std::uint8_t>(bits * 255 / 7); };
        palette.colours[static_cast<std::size_t>(i)] = {channel(i >> 5), channel(i >> 2 & 7), channel((i & 3) * 7 / 3)};
    }
    const std::uint8_t dark = 0, bright = 255;
    std::vector<std::uint8_t> pixels;
    std::vector<TexelError> errors;
    for (const float pixels_off : {0.F, 0.2F, 0.3F, 0.6F, 1.5F, 3.F, 9.F})
        for (const std::uint8_t colour : {dark, bright}) {
            pixels.push_back(colour);
            errors.push_back({pixels_off, 0});
        }
    ErrorMap(palette, ColourScheme::Standard).draw(errors, {pixels.data(), 14, 1, 14});
    for (std::size_t band = 0; band < ErrorMap::kBands; ++band) {
        EXPECT_LE(luminance_1000(palette.colours[pixels[2 * band]]),
                  luminance_1000(palette.colours[pixels[2 * band + 1]]));
        for (std::size_t other = 0; other < band; ++other) EXPECT_NE(pixels[2 * band + 1], pixels[2 * other + 1]);
    }
}

}  // namespace
}  // namespace oblong
