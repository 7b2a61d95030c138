#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <numeric>
#include <set>
#include <sstream>
#include <string>
#include <tuple>
#include <vector>

#include "engine/draw/drawing.h"
#include "engine/frame/passes.h"
#include "game/lab/aspects.h"
#include "game/lab/lab.h"
#include "game/menu/menu_layout.h"
#include "game/view/hud.h"
#include "tests/support/palettes.h"

namespace oblong {
namespace {

constexpr std::uint8_t kGuard = 7, kPicture = 100;

const Palette kPalette = test::grey_palette();
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
        const std::vector<std::uint8_t> guards(as_size(pitch_), kGuard);
        const auto are_guards = [&](std::int32_t x, std::int32_t y, std::int32_t count) {
            return std::memcmp(canvas_.row(y) + x, guards.data(), as_size(count)) == 0;
        };
        for (std::int32_t y = -kBorder_px; y < canvas_.height_px + kBorder_px; ++y) {
            const bool is_beside = y >= 0 && y < canvas_.height_px;
            if (!are_guards(-kBorder_px, y, is_beside ? kBorder_px : pitch_)) return false;
            if (is_beside && !are_guards(canvas_.width_px, y, kBorder_px)) return false;
        }
        return true;
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
    figures.now.frame_ns = {23'456'000, 1'000'000, 29'000'000};
    figures.before.frame_ns = {34'567'000, 30'000'000, 110'000'000};
    figures.events.fill(888);
    figures.errors = ErrorSummary{64'000, 377.36, 377.36, 377.36};
    figures.wrong_faces = 63'999;
    return figures;
}

// Every pass and effect there is, with numbers as long as they get.
CostText long_cost() {
    CostText cost;
    cost.frame = "99999 us +-99%, 999 frames/s, 99 movers";
    cost.background.fill(kPicture);
    for (const std::string_view name : {"walk", "claims"}) cost.passes.push_back({name, 64'000, 9'999'000});
    for (const Pass& pass : kPasses) cost.passes.push_back({pass.name, 64'000, 9'999'000});
    cost.passes.push_back({"other", 0, 9'999'000});
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
    }
    for (options.dial = 0; options.dial < all_dials().size(); ++options.dial)
        for (const bool is_short : {false, true})
            draw_lab_panel(options, long_figures(), panel_colours_of(kPalette, 1), is_short, canvas);
    const std::int32_t bottom =
        ErrorMap(kPalette, ColourScheme::Standard).draw_legend(canvas.height_px, kColours, canvas);
    draw_hud(text, messages, 0, bottom, kColours, ColourTable{}, canvas);
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

using Rows = std::vector<std::string>;

// '#' where a pixel is bright.
Rows bright_rows(Framebuffer canvas) {
    Rows rows;
    for (std::int32_t y = 0; y < canvas.height_px; ++y) {
        const auto width = as_size(canvas.width_px);
        std::string& row = rows.emplace_back(width, ' ');
        const std::string_view pixels(reinterpret_cast<const char*>(canvas.row(y)), width);
        const auto bright = static_cast<char>(kColours.bright);
        for (std::size_t x = pixels.find(bright); x < width; x = pixels.find(bright, x + 1)) row[x] = '#';
    }
    return rows;
}

Rows rows_of_word(std::string_view word, std::int32_t scale) {
    std::int32_t top = 0;
    for_each_dot(word, [&](std::int32_t, std::int32_t row) { top = std::min(top, row); });
    Rows rows(as_size((kGlyphHeight_px - top) * scale), std::string(as_size(text_width_px(word) * scale), ' '));
    for_each_dot(word, [&](std::int32_t column, std::int32_t row) {
        const auto size = as_size(scale), left = as_size(column) * size;
        for (std::size_t y = 0; y < size; ++y) rows[as_size(row - top) * size + y].replace(left, size, size, '#');
    });
    return rows;
}

// Whether a word stands in a canvas, whole: each pixel of its letters bright, and none between them.
bool is_written(std::string_view word, std::int32_t scale, const Rows& canvas) {
    const Rows rows = rows_of_word(word, scale);
    std::size_t row = 0;  // the first one with a bright pixel
    while (rows[row].find('#') == std::string::npos) ++row;
    const std::size_t column = rows[row].find('#'), width = rows[row].size();
    const std::string searched = rows[row].substr(column);
    for (std::size_t top = 0; top + rows.size() <= canvas.size(); ++top)
        for (std::size_t at = canvas[top + row].find(searched, column); at != std::string::npos;
             at = canvas[top + row].find(searched, at + 1)) {
            std::size_t same = 0;
            while (same < rows.size() && canvas[top + same].compare(at - column, width, rows[same]) == 0) ++same;
            if (same == rows.size()) return true;
        }
    return false;
}

void expect_written(const std::string& text, std::int32_t scale, const GuardedCanvas& guarded) {
    const Rows canvas = bright_rows(guarded.canvas());
    std::istringstream words(text);
    for (std::string word; words >> word;)
        EXPECT_TRUE(is_written(word, scale, canvas)) << word << " at scale " << scale << " in "
                                                     << guarded.canvas().width_px << "x" << guarded.canvas().height_px;
    EXPECT_TRUE(guarded.is_border_whole());
}

// All that is written over a picture, at every mode and size of text.
class TextOverPictures : public testing::TestWithParam<std::tuple<CanvasSize, std::int32_t>> {
  protected:
    GuardedCanvas fresh() const { return {size_.width_px, size_.height_px}; }
    TextColours colours() const { return {kColours.bright, kColours.dark, scale_}; }

    const CanvasSize size_ = std::get<0>(GetParam());
    const std::int32_t times_ = std::get<1>(GetParam());
    const std::int32_t scale_ = text_scale_in(size_.width_px, size_.height_px, times_);
};

TEST_P(TextOverPictures, IsAsLargeAsIn320x200) {
    const double by_mode = std::min(size_.width_px / 320.0, size_.height_px / 200.0);
    const bool is_small = size_.width_px < 320;
    EXPECT_GE(scale_, is_small ? 1 : 0.8 * by_mode * times_ * (times_ == 2 ? 0.9 : 1));
    EXPECT_GE(size_.width_px / scale_, 26 * kGlyphAdvance_px);
    EXPECT_GE(size_.height_px / scale_, 9 * kLineHeight_px);
}

TEST_P(TextOverPictures, TheLabIsWholeWhicheverDialIsTurned) {
    LabOptions options;
    for (const bool is_short : {false, true})
        for (options.dial = 0; options.dial<all_dials().size(); options.dial += size_.width_px> 400 ? 5 : 1) {
            const GuardedCanvas guarded = fresh();
            LabFigures figures = long_figures();
            const Dial& dial = all_dials()[options.dial];
            dial.set(figures.now.accuracy, dial.settings[dial.settings.size() / 2].value);
            const std::int32_t top =
                draw_lab_panel(options, figures, panel_colours_of(kPalette, scale_), is_short, guarded.canvas());
            EXPECT_LE(size_.height_px - top, panel_room_px(guarded.canvas(), scale_));
            const bool has_spread = !is_short || size_.width_px / scale_ >= 320;
            if (is_idle(dial, figures.now.accuracy)) continue;  // in another colour
            const bool has_errors = !is_short || size_.height_px / scale_ >= 180;
            expect_written(std::string(dial.caption) + " " + value_text(dial, dial.get(figures.now.accuracy)) +
                               (has_spread ? " now 23456+-60% before 34567 busy" : " now 23456 before 34567") +
                               (has_errors ? " Texels off, px: rms 377, worst 377; wrong face: 63999" : ""),
                           scale_, guarded);
        }
}

// Its pages hold all; beside the lab the frame's time at least, and both leave the picture its part.
TEST_P(TextOverPictures, TheCostOfAFrameIsWholeOnItsPages) {
    for (const bool has_lab : {false, true}) {
        std::set<std::string> seen;
        const CostText cost = long_cost();
        HudText text{{}, {}, &cost};
        for (std::int32_t pages = 1; text.cost_page <= pages; ++text.cost_page) {
            const GuardedCanvas guarded = fresh();
            Messages none;
            const std::int32_t bottom =
                has_lab ? draw_lab_panel({}, long_figures(), panel_colours_of(kPalette, scale_), true, guarded.canvas())
                        : size_.height_px - kTextMargin_px;
            ColourTable same;
            std::iota(same.begin(), same.end(), std::uint8_t{0});
            const HudLayout layout = draw_hud(text, none, 0, bottom, colours(), same, guarded.canvas());
            pages = layout.cost_table.pages;
            expect_written(cost.frame, scale_, guarded);
            EXPECT_LE(size_.height_px - layout.cost.top, panel_room_px(guarded.canvas(), scale_));
            const Rows canvas = bright_rows(guarded.canvas());
            for (const std::vector<PlanLine>& lines : {cost.passes, cost.effects})
                for (const PlanLine& line : lines)
                    if (is_written(line.name, scale_, canvas)) seen.insert(std::string(line.name));
        }
        for (const std::vector<PlanLine>& lines : {cost.passes, cost.effects})
            for (const PlanLine& line : lines)
                EXPECT_TRUE(seen.contains(std::string(line.name)) || (has_lab && size_.height_px / scale_ < 180))
                    << line.name << " at " << size_.width_px << " x" << times_;
    }
}

// As under DOS.
TEST(Overlay, TimesOfManyMillisecondsStandApartFromPixels) {
    const GuardedCanvas guarded(320, 200);
    CostText cost;
    cost.frame = "99999 us";
    cost.passes = {{"claims", 64'000, 9'999'000}, {"walls", 64'000, 25'787'000}};
    Messages none;
    draw_hud(HudText{{}, {}, &cost}, none, 0, 198, kColours, ColourTable{}, guarded.canvas());
    for (const char* const written : {"64000 9999", "64000 26ms"})
        EXPECT_TRUE(is_written(written, 1, bright_rows(guarded.canvas()))) << written;
}

TEST_P(TextOverPictures, MessagesNotesAndCaptionsAreWhole) {
    const HudText text{{"[door, to the left]"}, {"{flip} now [bounded, 3 dials turned] before exact"}, nullptr};
    const std::string told = "ÉÅ Shown with square pixels: sphères 17 % too narrow";
    const GuardedCanvas guarded = fresh();
    Messages messages;
    messages.show(told);
    ColourTable same;
    std::iota(same.begin(), same.end(), std::uint8_t{0});
    draw_hud(text, messages, 0, size_.height_px - kTextMargin_px, colours(), same, guarded.canvas());
    expect_written(told + " " + text.captions[0] + " " + text.notes[0], scale_, guarded);
    const GuardedCanvas map = fresh();
    ErrorMap(kPalette, ColourScheme::Standard).draw_legend(size_.height_px, colours(), map.canvas());
    expect_written("0 1/8 1/4 1/2 1 2 4px", scale_, map);
}

INSTANTIATE_TEST_SUITE_P(
    Modes, TextOverPictures,
    testing::Combine(testing::Values(CanvasSize{160, 100}, CanvasSize{320, 200}, CanvasSize{320, 240},
                                     CanvasSize{480, 270}, CanvasSize{400, 300}, CanvasSize{320, 400},
                                     CanvasSize{640, 400}, CanvasSize{640, 480}, CanvasSize{1280, 800}),
                     testing::Values(1, 2)));

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

}  // namespace
}  // namespace oblong
