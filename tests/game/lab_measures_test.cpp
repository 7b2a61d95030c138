#include "game/lab/lab_measures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "engine/accuracy/accuracy.h"
#include "game/level/load.h"
#include "game/simulation/step.h"
#include "tests/support/folders.h"

namespace oblong {
namespace {

// Each reading is 1 us later than the last, and 1 us more than that.
std::int64_t now_ns = 0, step_ns = 0;
std::int64_t slower_and_slower() {
    return now_ns += step_ns += 1000;
}
std::int64_t by_steps() {
    return now_ns += 1000;
}
// Now and then another program has the processor for a while: by a linear congruential generator.
std::int64_t interrupted() {
    step_ns = (step_ns * 1'103'515'245 + 12'345) % (std::int64_t{1} << 31);
    return now_ns += step_ns % 7 == 0 ? step_ns >> 8 : 700 + step_ns % 300;
}
std::int64_t standing() {
    return 0;
}

class LabMeasure : public testing::Test {
  protected:
    void SetUp() override {
        const std::string assets = test::build_folder() + "/assets";
        data_ = load_game({"", "", assets, ""});
        level_ = make_game_level(data_.level);
        state_ = start_of(level_);
        renderer_.emplace(data_, level_, ScreenMode{});
        meter_ = open_reference_meter(data_.level_file, level_);
    }
    GameView view() const {
        const InterpolatedState state{state_, state_};
        return {state, camera_at(state, {}, Degrees::from_int(90)), false, other_};
    }
    static Settings settings_of(const Accuracy& accuracy) {
        Settings settings;
        settings.accuracy = accuracy;
        return settings;
    }
    void round(const Accuracy& now, const Accuracy& before) {
        for (int turn = 0; turn < static_cast<int>(kPresets.size()) + 6; ++turn)
            measures_.measure(view(), settings_of(now), before, *renderer_, *meter_, data_.palette);
    }
    ErrorSummary errors_of(const Accuracy& accuracy) {
        return summarize_pixels(meter_->measure(view(), settings_of(accuracy), *renderer_));
    }

    GameData data_;
    GameLevel level_;
    GameState state_;
    std::optional<GameRenderer> renderer_;
    std::unique_ptr<ErrorMeter> meter_;
    LabMeasures measures_{standing};
    std::optional<ViewSpec> other_;
};

TEST_F(LabMeasure, ARoundMeasuresEverythingOnce) {
    const Accuracy now, before = accuracy_of(Preset::Exact);
    round(now, before);
    const LabFigures& figures = measures_.figures();
    ASSERT_TRUE(figures.now.frame_ns && figures.before.frame_ns);
    for (const TimedSetting& preset : figures.presets) EXPECT_EQ(preset.times.renderings().count(), 1u);
    EXPECT_GT(cost_of(figures.events, Currency::Instructions), 100'000);
    ASSERT_TRUE(figures.errors);
    EXPECT_GT(figures.errors->count, 60'000);
    EXPECT_LE(figures.errors->max, 0.42);  // bounded by 3/8 pixel
}

TEST_F(LabMeasure, WrongFacesAreCountedWhereThePlayerStands) {
    const Accuracy exact = accuracy_of(Preset::Exact), coarse = accuracy_of(Preset::Year1991);
    const auto counted = [&](const Accuracy& now) {
        round(now, exact);
        return measures_.figures().wrong_faces;
    };
    EXPECT_FALSE(counted(exact)) << "the view may be moving";
    EXPECT_EQ(counted(exact), 0);
    const std::int64_t wrong = counted(coarse).value_or(0);
    EXPECT_GT(wrong, 20);
    EXPECT_LT(wrong, 3000);
    state_.player.yaw = state_.player.yaw + degrees_to_angle(Degrees::from_int(1));
    EXPECT_FALSE(counted(coarse));
}

// Scales in another room, behind the player, settle at that time.
TEST_F(LabMeasure, WrongFacesAreCountedWhateverMovesOutOfSight) {
    const Accuracy exact = accuracy_of(Preset::Exact);
    const auto wait = [&](int ticks) {
        const std::vector<PlacedModel> before = placed_models(level_, {state_, state_});
        for (int tick = 0; tick < ticks; ++tick) step(level_, state_, {});
        return placed_models(level_, {state_, state_}) != before;
    };
    state_.player.yaw = state_.player.yaw + degrees_to_angle(Degrees::from_int(180));
    wait(516);
    round(exact, exact);
    for (int i = 0; i < 3; ++i) {
        ASSERT_TRUE(wait(12)) << "nothing moves";
        round(exact, exact);
        EXPECT_EQ(measures_.figures().wrong_faces, 0) << i;
    }
}

TEST_F(LabMeasure, TimesStayWithTheirSettings) {
    Accuracy first, second = first;
    second.shades = 32;
    round(first, accuracy_of(Preset::Exact));
    round(second, first);
    EXPECT_EQ(measures_.figures().now.times.renderings().count(), 1u);
    EXPECT_EQ(measures_.figures().before.times.renderings().count(), 2u);  // those of when it was the setting now
    round(first, second);
    EXPECT_EQ(measures_.figures().now.times.renderings().count(), 3u);
    EXPECT_EQ(measures_.figures().before.times.renderings().count(), 2u);
}

TEST_F(LabMeasure, TimesAreOfTheViewThatIsShown) {
    ViewTimes times(standing);
    for (int i = 0; i < 3; ++i) times.time(view(), {}, *renderer_);
    EXPECT_EQ(times.renderings().count(), 3u);
    Settings other;
    other.accuracy.shades = 32;
    times.time(view(), other, *renderer_);
    EXPECT_EQ(times.renderings().count(), 1u);
    state_.player.yaw = state_.player.yaw + degrees_to_angle(Degrees::from_int(1));
    times.time(view(), other, *renderer_);
    EXPECT_EQ(times.renderings().count(), 1u);
}

// Whatever the clock says, the lines of a frame are the frame: here it runs slower and slower, so that no two
// renderings, and no two readings within one, are alike.
TEST_F(LabMeasure, TheLinesOfAFrameAreInOrderAndHaveTimes) {
    now_ns = step_ns = 0;
    ViewTimes times(slower_and_slower);
    for (int i = 0; i < 9; ++i) times.time(view(), {}, *renderer_);
    const FrameCounts counts = renderer_->draw_and_count(view(), {});
    std::vector<std::string_view> names;
    for (const PlanLine& line : times.renderings().pass_lines(renderer_->plan(), counts)) {
        names.push_back(line.name);
        EXPECT_GT(line.nanoseconds, 0) << line.name;
        EXPECT_LE(line.low_ns, line.nanoseconds) << line.name;
        EXPECT_GE(line.high_ns, line.nanoseconds) << line.name;
    }
    ASSERT_GE(names.size(), 4u);
    EXPECT_EQ(names[0], "walk");
    EXPECT_EQ(names[1], "claims");
    EXPECT_EQ(names[2], "walls");
    EXPECT_EQ(names.back(), "other");
}

// Medians of the parts do not add up to the frame's, and what they leave for "other" may be less than nothing.
TEST_F(LabMeasure, LinesAddUpToTheFrameAndNoneIsNegative) {
    for (step_ns = 1; step_ns < 400; step_ns += 37) {
        ViewTimes times(interrupted);
        const std::int64_t seed = step_ns;
        for (int i = 0; i < 8; ++i) times.time(view(), {}, *renderer_);
        double sum_ns = 0;
        for (const PlanLine& line :
             times.renderings().pass_lines(renderer_->plan(), renderer_->draw_and_count(view(), {}))) {
            sum_ns += line.nanoseconds;
            EXPECT_GE(line.nanoseconds, 0) << line.name << " " << seed;
        }
        EXPECT_NEAR(sum_ns, times.renderings().frame_ns().median, 1);
        step_ns = seed;
    }
}

// Between any two readings of this clock lies 1 us. No line's own is what lies before the first reading of brush
// models, which are made ready first, between their two, before the claims, before each pass, and behind the last one;
// nor what lies before and between the two readings of each search for things: particles, places of sprites, sprites,
// models, shadows, models that are seen, things in fog.
TEST_F(LabMeasure, NoTimeOfAFrameIsLostOrCountedTwice) {
    now_ns = 0;
    ViewTimes times(by_steps);
    times.time(view(), {}, *renderer_);
    const std::vector<PlanLine> lines =
        times.renderings().pass_lines(renderer_->plan(), renderer_->draw_and_count(view(), {}));
    const auto passes = static_cast<double>(renderer_->plan().passes.count());
    ASSERT_EQ(lines.size(), 3 + renderer_->plan().passes.count());
    EXPECT_EQ(lines.back().nanoseconds, 1000 * (4 + passes + 2 * 7));
}

TEST_F(LabMeasure, ErrorsAreThoseOfTheSetting) {
    // Along the walls: straight at one, every setting is right.
    state_.player.yaw = state_.player.yaw + degrees_to_angle(Degrees::from_int(45));
    EXPECT_LT(errors_of(accuracy_of(Preset::Exact)).max, 0.05);
    EXPECT_GT(errors_of(accuracy_of(Preset::Year1994)).max, 1);
    EXPECT_GT(errors_of(accuracy_of(Preset::Year1991)).rms, errors_of(accuracy_of(Preset::Bounded)).rms);
}

TEST_F(LabMeasure, ColoursAreOffByTheDialsOfColourAlone) {
    const std::set<std::string_view> of_colour{"light", "shades", "dither", "mip", "mip-bias", "floors"};
    for (const Dial& dial : all_dials()) {
        Accuracy turned = accuracy_of(Preset::Exact);
        const std::int32_t exact = dial.get(turned);
        dial.set(turned,
                 dial.settings.front().value == exact ? dial.settings.back().value : dial.settings.front().value);
        round(turned, {});
        const ErrorSummary errors = measures_.figures().colour_errors.value();
        EXPECT_EQ(errors.count > 0, of_colour.count(dial.name) > 0) << dial.name;
        EXPECT_EQ(errors.max > 0, errors.count > 0) << dial.name;
    }
}

TEST(ColourErrors, AreRgbDistancesWherePicturesDiffer) {
    Palette palette;
    palette.colours[1] = {3, 4, 0};
    palette.colours[2] = {0, 0, 12};
    const std::vector<std::uint8_t> shown{0, 1, 1, 2}, exact{0, 0, 1, 1};
    const ErrorSummary errors = colour_errors(shown, exact, palette);
    EXPECT_EQ(errors.count, 2);
    EXPECT_NEAR(errors.rms, std::sqrt((25 + 169) / 2.0), 1e-5);
    EXPECT_NEAR(errors.max, 13, 1e-5);
}

TEST_F(LabMeasure, SaysWhyThereAreNoErrors) {
    meter_ = open_reference_meter("/no/such.bsp", level_);
    round({}, {});
    EXPECT_FALSE(measures_.figures().errors);
    EXPECT_NE(measures_.figures().problem.find("/no/such.bsp"), std::string::npos) << measures_.figures().problem;
}

// The reference sees by the player's eye: the errors of another view's texels would be those between the two views.
TEST_F(LabMeasure, AnotherViewThanThePlayersHasNoErrors) {
    round({}, {});
    ASSERT_TRUE(measures_.figures().errors);
    other_ = orthographic_view(view().camera.eye, axonometric_axes(Axonometry::Isometric), View::from_int(1024));
    round({}, {});
    EXPECT_FALSE(measures_.figures().errors);
    EXPECT_EQ(measures_.figures().problem, "only the player's own view is measured");
    EXPECT_TRUE(meter_->measure(view(), {}, *renderer_).empty());
}

}  // namespace
}  // namespace oblong
