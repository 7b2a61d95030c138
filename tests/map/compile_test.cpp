#include <gtest/gtest.h>

#include <random>

#include "engine/level/trace.h"
#include "engine/scene/placed_models.h"
#include "engine/view/views.h"
#include "tests/map/bsp_checks.h"
#include "tests/map/map_source.h"
#include "tools/map/source/geometry.h"
#include "tools/render/renderer.h"

namespace oblong::test::compile_test {
namespace {

// Cameras at random points of a box that are open, in random directions.
std::vector<Camera> open_cameras(const map::BspFile& bsp, const map::Box& around, int count, std::mt19937& random) {
    std::vector<Camera> cameras;
    for (int tries = 0; tries < 100 * count && static_cast<int>(cameras.size()) < count; ++tries) {
        const Point eye{random_between(random, around.mins.x, around.maxs.x),
                        random_between(random, around.mins.y, around.maxs.y),
                        random_between(random, around.mins.z, around.maxs.z)};
        if (contents_at(bsp, 0, 0, eye) != contents::kEmpty) continue;
        Camera& camera = cameras.emplace_back();
        camera.eye = to_world(eye);
        camera.yaw = Angle::from_bam(random());
        camera.pitch = Angle::from_bam(static_cast<std::int64_t>(random_between(random, -16000, 16000)));
    }
    return cameras;
}

// Pixels that are drawn twice, or not at all, over all cameras.
std::int64_t faulty_pixels(const map::BspFile& bsp, const std::vector<Camera>& cameras) {
    const Level level = engine_level(bsp);
    const Colormap colormap = make_colormap(read_palette(std::vector<std::uint8_t>(768, 32)));
    const auto models = models_at_rest(level);
    std::vector<ViewSpec> views;
    for (const Camera& camera : cameras) views.push_back(first_person_view(camera));
    std::int64_t faulty = 0;
    FrameWorkspace work(level, {});
    EXPECT_EQ(work.cache.faces.torn_edges, 0u);
    for (const FrameReport& frame : render_views({{level, colormap, models}, {}, {}, views}, work, [](auto, auto) {}))
        faulty += frame.pixels_never + frame.pixels_twice;
    return faulty;
}

void expect_whole_pictures(const std::string& source, const map::Box& around, std::mt19937& random) {
    const auto bsp = compile(source, {true});
    const auto cameras = open_cameras(bsp, around, 60, random);
    ASSERT_EQ(cameras.size(), 60u);
    EXPECT_EQ(faulty_pixels(bsp, cameras), 0);
}

TEST(Compile, PicturesFromInsideHaveNoHoles) {
    const map::Box around{{-256, -256, 0}, {256, 256, 256}};
    std::mt19937 random(21);
    for (const int count : {1, 8, 20}) {
        std::string brushes = room({-256, -256, 0}, {256, 256, 256}), details;
        for (int i = 0; i < count; ++i) {
            const TurnedBox box{
                {random_between(random, -240, 240), random_between(random, -240, 240), random_between(random, 16, 240)},
                {random_between(random, 0.25, 60), random_between(random, 0.25, 60), random_between(random, 0.25, 60)},
                random_frame(random)};
            (i % 2 == 0 ? brushes : details) += box.text(i % 4 < 2 ? kStandardTail : kValveTail);
        }
        const std::string ball_and_water =
            ball({100, 100, 90}, 60, 8, 12, "other") + box({-256, -256, 0}, {256, 0, 24}, "*water");
        expect_whole_pictures(level(brushes + ball_and_water, entity("func_detail", {}, details)), around, random);
    }
}

TEST(Compile, ADraftStopsPlayersWhereTheLevelDoes) {
    const std::string hall = level(room({-256, -256, 0}, {256, 256, 256}) + prism({-100, 0, 0}, 60, 256, 6) +
                                   box({40, -256, 0}, {72, 100, 256}));
    const auto full = compile(hall), draft = compile(hall, {.is_fast = true});
    std::mt19937 random(24);
    const auto across = [&] { return random_between(random, -290, 290); };
    int open = 0;
    for (int i = 0; i < 5000; ++i) {
        const Point point{across(), across(), random_between(random, -30, 290)};
        const int expected = contents_at(full, 0, 1, point);
        ASSERT_EQ(contents_at(draft, 0, 1, point), expected) << point.x << ' ' << point.y << ' ' << point.z;
        open += expected == contents::kEmpty ? 1 : 0;
    }
    EXPECT_GT(open, 500);
}

// Wherever a player may stand in a heap of turned boxes, no step in any direction ends within a wall.
TEST(Compile, StepsEndInTheOpen) {
    std::mt19937 random(23);
    std::string brushes = room({-256, -256, 0}, {256, 256, 256});
    for (int i = 0; i < 16; ++i) {
        const double x = random_between(random, -240, 240), y = random_between(random, -240, 240);
        brushes += TurnedBox{{x, y, random_between(random, 0, 100)}, {30, 20, 10}, random_frame(random)}.text();
    }
    const Level level = engine_level(compile(test::level(brushes), {true}));
    int standing = 0;
    for (int i = 0; i < 2000; ++i) {
        const auto at = [&] { return random_between(random, -256, 256); };
        const auto from = to_world({at(), at(), random_between(random, 24, 220)});
        if (hull_contents(level, level.world(), Hull::Player, from) != contents::kEmpty) continue;
        ++standing;
        const TraceResult trace = trace_hull(level, level.world(), Hull::Player, from,
                                             to_world({at(), at(), random_between(random, 0, 256)}));
        EXPECT_EQ(hull_contents(level, level.world(), Hull::Player, trace.end), contents::kEmpty);
        EXPECT_EQ(hull_contents(level, level.world(), Hull::Point, trace.end), contents::kEmpty);
    }
    EXPECT_GT(standing, 500);
}

TEST(Compile, ErrorsSayWhatIsWrong) {
    expect_complaint(level(plain_room().substr(0, plain_room().rfind('{'))), "the level encloses no space");
    expect_complaint(level(box({0, 0, 0}, {64, 64, 64})), "the level encloses no space");
    expect_complaint(level(room({0, 0, 0}, {128, 128, 128}, 16, "skip"), entity_at("info_player_start", {64, 64, 24})),
                     "no face of the level is drawn");
    expect_complaint(level(replaced(plain_room(), "0 0 0 1 1", "0 0 0 0.0039 -1"), lights_of_plain_room()),
                     "line 4: texture 'wall' has more than 255 texels a unit");
    EXPECT_EQ(complaint_of(level(replaced(plain_room(), "0 0 0 1 1", "0 0 0 0.004 -8"), lights_of_plain_room())),
              "none");
    const std::string cube = box({100, 100, 50}, {110, 110, 60});
    expect_complaint(level(plain_room() + "{\n" + cube.substr(cube.find('\n', 2) + 1), lights_of_plain_room()),
                     "expected a closed convex solid");
}

}  // namespace
}  // namespace oblong::test::compile_test
