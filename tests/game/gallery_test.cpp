#include "game/program/gallery.h"

#include <gtest/gtest.h>

namespace oblong {
namespace {

RowPage draw_nothing(const RowInput&, Framebuffer) {
    return {};
}

class GalleryKeys : public testing::Test {
  protected:
    void press(std::initializer_list<Command> commands) {
        for (const Command command : commands) apply(command, rows_, {1600, 1200}, view_options_, state_);
    }
    std::int64_t value(std::size_t parameter) const { return state_.values[state_.row][parameter]; }

    const std::vector<Row> rows_{{"a",
                                  "A",
                                  "1",
                                  "",
                                  "",
                                  {choice_parameter("colour", {"red", "green", "blue"}, 1), {"size", -4, 10, 2, 0}},
                                  draw_nothing},
                                 {"b", "B", "2", "", "", {}, draw_nothing},
                                 {"c", "C", "3", "", "", {{"angle", 0, 90, 15, 45}}, draw_nothing}};
    ViewOptions view_options_;
    GalleryState state_ = start_of_gallery(rows_);
};

TEST_F(GalleryKeys, PagesGoRoundInBothDirections) {
    press({Command::PageUp});
    EXPECT_EQ(state_.row, 2u);
    press({Command::PageDown, Command::PageDown});
    EXPECT_EQ(state_.row, 1u);
}

TEST_F(GalleryKeys, ChoicesGoRoundAndNumbersStopAtTheirEnds) {
    EXPECT_EQ(value(0), 1);
    press({Command::DialFiner, Command::DialFiner});
    EXPECT_EQ(value(0), 0);
    press({Command::DialCoarser});
    EXPECT_EQ(value(0), 2);
    press({Command::DialDown, Command::DialCoarser, Command::DialCoarser, Command::DialCoarser});
    EXPECT_EQ(value(1), -4);
    for (int i = 0; i < 20; ++i) press({Command::DialFiner});
    EXPECT_EQ(value(1), 10);
}

TEST_F(GalleryKeys, RowsKeepTheirValuesAndTheFirstParameterIsChosenAgain) {
    press({Command::DialDown, Command::DialFiner, Command::PageDown, Command::DialFiner, Command::PageUp});
    EXPECT_EQ(state_.chosen, 0u);
    EXPECT_EQ(value(0), 1);
    EXPECT_EQ(value(1), 2);
}

TEST_F(GalleryKeys, AspectAndAccuracyAreChangedAsInTheGame) {
    EXPECT_NE(apply(Command::ProjectionAspect, rows_, {1600, 1200}, view_options_, state_), "");
    EXPECT_FALSE(view_options_.preferences.corrects_projection);
    press({Command::AccuracyTier});
    EXPECT_NE(view_options_.preferences.preset, Preset::Bounded);
    const ViewOptions before = view_options_;
    press({Command::LabPanel, Command::FourAspects, Command::Torch});
    EXPECT_EQ(view_options_.shows_four_aspects, before.shows_four_aspects) << "keys of the game alone do nothing";
    EXPECT_EQ(view_options_.has_torch, before.has_torch);
}

}  // namespace
}  // namespace oblong
