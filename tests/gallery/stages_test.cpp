// The row that stops the pipeline after each stage: what one stage counts, the next one draws.

#include "tests/gallery/gallery_fixture.h"
#include "tools/gallery/rows.h"

namespace oblong::test {
namespace {

using PipelineRow = GalleryTest;

constexpr std::int64_t kStages = 11, kSpans = 9, kPixels = 10;

/// The pixels of the scene, left of the numbers, that are not of the background's colour (that of the corner).
std::int64_t drawn_pixels(const std::vector<std::uint8_t>& pixels, std::int32_t pitch, std::int32_t border) {
    const auto pixel = [&](std::int32_t x, std::int32_t y) {
        return pixels[static_cast<std::size_t>((y + border) * pitch + x + border)];
    };
    std::int64_t count = 0;
    for (std::int32_t y = kHeader_px; y < 200 - kFooter_px; ++y)
        for (std::int32_t x = 0; x < 188; ++x) count += pixel(x, y) != pixel(187, 200 - kFooter_px - 1);
    return count;
}

std::int64_t span_pixels_of(const RowPage& page) {
    const auto found = std::find_if(page.figures.begin(), page.figures.end(),
                                    [](const Figure& figure) { return figure.name == "pixels of all spans"; });
    return found == page.figures.end() ? -1 : std::stoll(found->found);
}

TEST_F(PipelineRow, PixelsAreThoseOfTheSpansEachOnce) {
    const Row row = stage_rows().front();
    for (const std::int64_t yaw : {0, 20, 60})
        for (const std::int64_t left : {-10, -3, 0, 5, 10}) {
            const Drawn drawn = draw(row, {kPixels, yaw, left});
            EXPECT_GT(span_pixels_of(drawn.page), 1000);
            EXPECT_EQ(drawn_pixels(drawn.pixels, 320 + 2 * kBorder_px, kBorder_px), span_pixels_of(drawn.page))
                << yaw << " " << left;
        }
}

TEST_F(PipelineRow, EveryStageHasAPictureOfItsOwn) {
    const Row row = stage_rows().front();
    ASSERT_EQ(row.parameters[0].most, kStages - 1);
    for (std::int64_t stage = 0; stage + 1 < kStages; ++stage)
        EXPECT_NE(draw(row, {stage, 30, 7}).pixels, draw(row, {stage + 1, 30, 7}).pixels) << stage;
}

/// Every second row is left out, so that one span is told from the next.
TEST_F(PipelineRow, SpansAreHalfOfThePixels) {
    const Drawn drawn = draw(stage_rows().front(), {kSpans, 30, 7});
    const double half = static_cast<double>(span_pixels_of(drawn.page)) / 2;
    EXPECT_NEAR(static_cast<double>(drawn_pixels(drawn.pixels, 320 + 2 * kBorder_px, kBorder_px)), half, 120);
}

}  // namespace
}  // namespace oblong::test
