#include <gtest/gtest.h>

#include "tools/gallery/program/gallery_screen.h"

namespace oblong {
namespace {

Figures draw_nothing(const RowInput&, Canvas&) {
    return {};
}

class GalleryKeys : public testing::Test {
  protected:
    void press(std::initializer_list<Action> commands) {
        for (const Action command : commands) apply(command, rows_, {1600, 1200}, view_options_, state_);
    }
    std::int64_t value(std::size_t parameter) const { return state_.values[state_.row][parameter]; }

    const std::vector<Row> rows_{{"a", draw_nothing, {{"colour", {"red", "green", "blue"}, 1}, {"size", -4, 10, 2, 0}}},
                                 {"b", draw_nothing, {}},
                                 {"c", draw_nothing, {{"angle", 0, 90, 15, 45}}}};
    ViewOptions view_options_;
    GalleryState state_ = start_of_gallery(rows_);
};

TEST_F(GalleryKeys, PagesGoRoundInBothDirections) {
    press({Action::PageUp});
    EXPECT_EQ(state_.row, 2u);
    press({Action::PageDown, Action::PageDown});
    EXPECT_EQ(state_.row, 1u);
}

TEST_F(GalleryKeys, ChoicesGoRoundAndNumbersStopAtTheirEnds) {
    EXPECT_EQ(value(0), 1);
    press({Action::DialFiner, Action::DialFiner});
    EXPECT_EQ(value(0), 0);
    press({Action::DialCoarser});
    EXPECT_EQ(value(0), 2);
    press({Action::DialDown, Action::DialCoarser, Action::DialCoarser, Action::DialCoarser});
    EXPECT_EQ(value(1), -4);
    for (int i = 0; i < 20; ++i) press({Action::DialFiner});
    EXPECT_EQ(value(1), 10);
}

TEST_F(GalleryKeys, RowsKeepTheirValuesAndTheFirstParameterIsChosenAgain) {
    press({Action::DialDown, Action::DialFiner, Action::PageDown, Action::DialFiner, Action::PageUp});
    EXPECT_EQ(state_.chosen, 0u);
    EXPECT_EQ(value(0), 1);
    EXPECT_EQ(value(1), 2);
}

TEST_F(GalleryKeys, AspectAndAccuracyAreChangedAsInTheGame) {
    EXPECT_NE(apply(Action::ProjectionAspect, rows_, {1600, 1200}, view_options_, state_), "");
    EXPECT_FALSE(view_options_.preferences.corrects_projection);
    press({Action::AccuracyTier});
    EXPECT_NE(view_options_.preferences.preset, Preset::Bounded);
    const ViewOptions before = view_options_;
    press({Action::LabPanel, Action::FourAspects, Action::Torch});
    EXPECT_EQ(view_options_.shows_four_aspects, before.shows_four_aspects) << "keys of the game alone do nothing";
    EXPECT_EQ(view_options_.has_torch, before.has_torch);
}

}  // namespace
}  // namespace oblong
