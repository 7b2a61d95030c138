#include <set>

#include "engine/frame/frame_counts.h"
#include "engine/io/files.h"
#include "engine/platform/worker_threads.h"
#include "tests/effect_frames/effect_stage.h"
#include "tests/support/folders.h"
#include "tools/gallery/mesh_scene.h"

namespace oblong::test {
namespace {

/// A level's entities do not name meshes here: they are placed.
const Mesh& small_ball() {
    static const Mesh mesh = ball_mesh(24, 8, checkered_skin(64, 16, 80));
    return mesh;
}

std::vector<PlacedMesh> small_ball_at(const Vec3<World>& position) {
    PlacedMesh placed;
    placed.mesh = &small_ball();
    placed.position = position;
    return {placed};
}

EffectStage everything(const Camera& camera) {
    const std::filesystem::path assets = std::filesystem::path(test::build_folder()) / "assets";
    const std::string source = read_text(test::source_folder() + "/tools/effect_costs/all_effects.map");
    const std::vector<map::Wad> wads{map::Wad(read_text((assets / "demo.wad").string()))};
    return {engine_level(map::compile_map(map::parse_map(source), wads, {true})), camera,
            make_colormap(read_palette(read_file_bytes(assets / "palette.lmp"))), small_ball_at(point_at(60, 40, 60))};
}

Camera in_tank() {
    return camera_at(point_at(-310, 0, 120), 0, 8);
}

Camera before_tank() {
    return camera_at(point_at(-280, 0, 120), 0, 8);
}

// A room that calls for every effect at once (tools/effect_costs/all_effects.map), in which nothing depends on what was
// drawn before, and each effect can be left out.

TEST(Everything, OwnsPixelsInOneFrame) {
    EffectStage stage = everything(in_tank());
    stage.draw(2'900);
    EXPECT_EQ(stage.work.plan.effects, EffectSet::all());
    for (std::size_t i = 0; i < kEffectCount; ++i)
        EXPECT_GT(stage.pixels(static_cast<Effect>(i)), 0) << kEffectNames[i];
}

TEST(Everything, IsTheSameInAUsedWorkspace) {
    EffectStage stage = everything(in_tank());
    const std::array cameras{in_tank(), before_tank(), camera_at(point_at(300, -200, 90), 135, 10),
                             camera_at(point_at(-310, 60, 40), -20), camera_at(point_at(200, 200, 60), 200, 20)};
    std::int64_t time_ms = 0;
    for (int i = 0; i < 40; ++i) {
        stage.camera = cameras[static_cast<std::size_t>(i) % cameras.size()];
        ASSERT_EQ(stage.draw(time_ms), stage.draw_afresh(time_ms)) << "frame " << i << " at " << time_ms << " ms";
        time_ms = i % 3 == 2 ? time_ms / 2 : time_ms * 3 + 137;
    }
    EXPECT_GT(time_ms, std::int64_t{1} << 20);
}

TEST(Everything, IsTheSameByAnyNumberOfThreads) {
    EffectStage stage = everything(in_tank());
    const MovingLight torch{point_at(-250, 0, 120), World::from_int(200)};
    for (const int threads : {2, 3, 8}) {
        WorkerThreads workers(threads);
        FrameWorkspace shared(stage.level, {}, &workers);
        for (int i = 0; i < 20; ++i) {
            stage.camera = i % 2 ? in_tank() : camera_at(point_at(300, -200, 90), 135, 10);
            stage.moving_lights.assign(i % 5 / 2, torch);
            stage.settings.allowed_effects = i % 7 ? EffectSet::all() : EffectSet{};
            ASSERT_EQ(stage.draw_in(shared, i * 137), stage.draw_afresh(i * 137)) << "frame " << i;
        }
    }
}

TEST(Everything, IsTheSameByTheKernelsOfEachInstructionSet) {
    EffectStage stage = everything(in_tank());
    for (const Preset preset : kPresets)
        for (const Camera& camera : {in_tank(), camera_at(point_at(300, -200, 90), 135, 10)}) {
            stage.camera = camera;
            stage.settings.accuracy = accuracy_of(preset);
            stage.settings.kernels = find_kernels("plain");
            const Picture plain = stage.draw_afresh(2'900);
            for (const Kernels& kernels : all_kernels()) {
                stage.settings.kernels = &kernels;
                EXPECT_EQ(changed_pixels(stage.draw_afresh(2'900), plain), 0)
                    << kernels.name << ", " << name_of(preset);
            }
        }
}

/// What is left out changes no more pixels than it owned: those that it needs it for, or that it covers. Mirrors show
/// the other effects, and waves move them, so that these two stand apart.
TEST(Everything, LeftOutChangesNoPixelElsewhere) {
    EffectStage stage = everything(before_tank());
    for (std::size_t i = 0; i < kEffectCount; ++i) {
        const auto effect = static_cast<Effect>(i);
        if (effect == Effect::Underwater) continue;
        SCOPED_TRACE(kEffectNames[i]);
        stage.settings.allowed_effects = EffectSet::all();
        if (effect != Effect::Mirror) stage.settings.allowed_effects = EffectSet::all().without(Effect::Mirror);
        const Picture with = stage.draw(2'900);
        const std::int64_t owned = stage.pixels(effect);
        const Picture without = stage.draw_without(effect, 2'900);
        EXPECT_FALSE(stage.has(effect));
        EXPECT_LE(changed_pixels(with, without), owned);
        if (stage.settings.allowed_effects.has(effect) && effect != Effect::Translucency) {
            EXPECT_GT(changed_pixels(with, without), 0);
        }
    }
}

// Hard cases of effects (tests/hard_cases/README.md): late times, coplanar faces, effects that nothing calls for.

/// A time after which all of the room returns: of sky (16,000 ms), waves (6,400), signs (600 at most), the flickering
/// light (2,500), the lantern (6,000) and particles (whole seconds up to 10).
constexpr std::int64_t kPeriod_ms = 10'080'000;

TEST(Everything, HardCaseT1_ReturnsAfterItsPeriodAlsoBeyond32BitsOfMilliseconds) {
    EffectStage stage = everything(in_tank());
    const auto expect_as_in_the_first = [&](std::int64_t time_ms) {
        EXPECT_EQ(stage.draw(time_ms), stage.draw(time_ms % kPeriod_ms)) << time_ms;
    };
    for (const std::int64_t time_ms : {0, 137, 2'900, 7'777}) {
        EXPECT_GT(changed_pixels(stage.draw(time_ms), stage.draw(time_ms + 1'111)), 1'000) << "nothing moves";
        for (const int bits : {31, 32, 53})
            for (const int periods : {0, 1})
                expect_as_in_the_first(((std::int64_t{1} << bits) / kPeriod_ms + periods) * kPeriod_ms + time_ms);
    }
    // Where a counter of milliseconds wraps, the picture goes on.
    for (const int bits : {31, 32})
        for (const int off : {-200, -1, 0, 1, 200}) expect_as_in_the_first((std::int64_t{1} << bits) + off);
}

/// A wall at x = 128, of brushes of which one is an entity: their faces lie in one plane, and one of them covers part
/// of the other.
TEST(Coplanar, HardCaseE11_TheFaceOfAModelInTheWallsPlaneIsShownAlikeFromEverywhere) {
    const MapText text = room_with(box({128, -200, 0}, {144, 200, 160}),
                                   entity("func_wall", {}, box({128, -60, 40}, {140, 60, 120}, "other")));
    EffectStage stage(text, camera_at(point_at(-100, 0, 64), 0));
    std::set<std::uint8_t> shown;
    int looks = 0;
    for (int x = -150; x <= 100; x += 50)
        for (int y = -60; y <= 60; y += 24)
            for (int z = 40; z <= 140; z += 33, ++looks) {
                stage.camera = camera_at(point_at(x + 0.25, y + 0.5, z), y / 4.0, (z - 80) / 6.0);
                const Picture picture = stage.draw();
                // What is at the model's place: its middle and points near its corners, by the record of the plane.
                for (std::size_t i = 0; i < picture.size(); ++i) {
                    const Face* const face = stage.face_at(i);
                    if (face && stage.work.record.pixels[i].model == PlacedIndex(0)) shown.insert(picture[i]);
                }
                EXPECT_EQ(stage.draw_afresh(), picture);
                EXPECT_GT(count_of(picture, kOther), 0) << x << ' ' << y << ' ' << z;
                EXPECT_EQ(count_of(picture, kOther), stage.pixels(Effect::BrushModels)) << "the wall shows through";
            }
    EXPECT_EQ(shown, std::set<std::uint8_t>{kOther});
    EXPECT_GT(looks, 100);
}

/// All that a frame counts, in which an effect that ran would show.
std::vector<std::int64_t> counts_of(const EffectStage& stage) {
    std::vector<std::int64_t> counts;
    for (const NamedCount& count : named_counts(stage.work.counts)) counts.push_back(count.count);
    counts.insert(counts.end(), stage.work.counts.effect_pixels.begin(), stage.work.counts.effect_pixels.end());
    counts.insert(counts.end(), stage.work.counts.pass_pixels.begin(), stage.work.counts.pass_pixels.end());
    return counts;
}

/// Where a frame's plan holds no effect, forbidding it changes no count of any stage: it was never asked for.
TEST(Plan, HardCaseP5_EffectsThatTheFrameDoesNotCallForTakeNoOperation) {
    MapText plain;
    plain.brushes = room({-256, -256, 0}, {256, 256, 192});
    plain.entities = entity_at("info_player_start", {0, 0, 64}) + entity_at("light", {0, 0, 120});
    EffectStage empty(plain, camera_at(point_at(0, 0, 64), 30));
    empty.draw(2'900);  // lights its surfaces
    empty.draw(2'900);
    EXPECT_EQ(empty.work.plan.effects, EffectSet{});
    const std::vector<std::int64_t> all_allowed = counts_of(empty);
    empty.settings.allowed_effects = EffectSet{};
    empty.draw(2'900);
    EXPECT_EQ(counts_of(empty), all_allowed);

    const EffectSet allowed = EffectSet::all();
    EffectStage stage = everything(in_tank());
    std::set<std::size_t> sizes;
    for (int yaw = 0; yaw < 360; yaw += 30) {
        stage.camera = camera_at(point_at(300, -200, 90), yaw, yaw % 60 - 30);
        stage.settings.allowed_effects = allowed;
        stage.draw(2'900);  // lights its surfaces
        const Picture with = stage.draw(2'900);
        const std::vector<std::int64_t> counts = counts_of(stage);
        std::size_t uncalled = 0;
        const EffectSet called = stage.work.plan.effects;
        for (std::size_t i = 0; i < kEffectCount; ++i) {
            const auto effect = static_cast<Effect>(i);
            if (called.has(effect) || !allowed.has(effect)) continue;
            SCOPED_TRACE(std::string(kEffectNames[i]) + " at " + std::to_string(yaw));
            ++uncalled;
            EXPECT_EQ(stage.pixels(effect), 0);
            stage.settings.allowed_effects = allowed.without(effect);
            stage.draw(2'900);
            EXPECT_EQ(changed_pixels(stage.draw(2'900), with), 0);
            EXPECT_EQ(counts_of(stage), counts);
        }
        sizes.insert(uncalled);
    }
    EXPECT_GT(sizes.size(), 2u) << "all frames call for the same";
}

}  // namespace
}  // namespace oblong::test
