// What faces hide is not computed: not a particle, not the depth of a pixel.

#include "engine/view/views.h"
#include "tests/effect_frames/effect_stage.h"

namespace oblong::test {
namespace {

struct HiddenThing {
    const char* name;
    const char* entity;
};

/// A room that a wall, 64 units wide and as high as the room, stands in; behind it one thing.
MapText room_with_hidden(const HiddenThing& thing) {
    return room_with(box({-16, -32, 0}, {16, 32, 192}, "other"), thing.entity);
}

constexpr HiddenThing kThings[]{
    {"rain", "{ \"classname\" \"misc_rain\" \"origin\" \"60 0 90\" \"size\" \"16 16 80\" \"count\" \"200\" }\n"},
    {"sprite", "{ \"classname\" \"misc_sprite\" \"origin\" \"60 0 90\" \"texture\" \"{lamp\" \"scale\" \"0.25\" }\n"},
};

class HiddenThings : public testing::TestWithParam<HiddenThing> {};

TEST_P(HiddenThings, AreComputedOnlyFromWhereTheyMayShow) {
    EffectStage stage(room_with_hidden(GetParam()), camera_at(point_at(-150, 0, 90), 0));
    const bool is_rain = std::string_view(GetParam().name) == "rain";
    const auto is_computed = [&] { return stage.work.view.depth.is_wanted(); };
    stage.draw();
    EXPECT_FALSE(is_computed());
    EXPECT_EQ(stage.work.counts.stages.particles, 0);
    stage.camera = camera_at(point_at(-150, 200, 90), -45);  // past the wall
    stage.draw();
    EXPECT_TRUE(is_computed());
    EXPECT_EQ(stage.work.counts.stages.particles, is_rain ? 200 : 0);
    EXPECT_GT(stage.pixels(Effect::Particles) + stage.pixels(Effect::Sprites), 0);
    stage.camera = camera_at(point_at(120, 0, 90), 180);  // the wall is behind them
    stage.draw();
    EXPECT_TRUE(is_computed());
}

INSTANTIATE_TEST_SUITE_P(Of, HiddenThings, testing::ValuesIn(kThings),
                         [](const auto& each) { return std::string(each.param.name); });

/// From eyes all around: where it is left out, each dot that it would have lies on pixels of the wall before it.
TEST(RainBehindAWall, IsLeftOutWhereTheWallHidesAllOfItsDots) {
    EffectStage stage(room_with_hidden(kThings[0]), camera_at(point_at(-150, 0, 90), 0));
    int hidden = 0, shown = 0;
    for (int y = -240; y <= 240; y += 4) {
        stage.camera = camera_at(point_at(-150, y, 90), -y / 5.0);
        stage.draw();
        const bool is_computed = stage.work.counts.stages.particles > 0;
        (is_computed ? shown : hidden) += 1;
        if (is_computed) continue;
        ThingsInView in_view;
        DepthBuffer none(kPictureWidth, kPictureHeight);
        const ViewContext view = make_view_context(first_person_view(stage.camera), ScreenMode{}, {});
        find_particles(stage.work.cache.things, 0, Sight{stage.work.view.visible.leaf_set(), view}, in_view, none);
        ASSERT_FALSE(in_view.dots.empty());
        for (const ParticleDot& dot : in_view.dots)
            for (std::int32_t row = dot.first_row; row < dot.end_row; ++row)
                for (std::int32_t column = dot.first_column; column < dot.end_column; ++column) {
                    const auto pixel = static_cast<std::size_t>(row * kPictureWidth + column);
                    ASSERT_EQ(stage.texture_at(pixel), "other") << "y " << y << ", pixel " << column << " " << row;
                }
    }
    EXPECT_GT(hidden, 5);
    EXPECT_GT(shown, 50);
}

}  // namespace
}  // namespace oblong::test
