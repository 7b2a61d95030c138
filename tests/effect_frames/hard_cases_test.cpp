// Hard cases of effects (tests/hard_cases/README.md): late times, coplanar faces, effects that nothing calls for.

#include <set>

#include "engine/frame/frame_counts.h"
#include "tests/effect_frames/effect_stage.h"
#include "tests/effect_frames/everything.h"

namespace oblong::test {
namespace {

/// A time after which all of the room returns: of sky (16,000 ms), waves (6,400), signs (600 at most), the flickering
/// light (2,500), the lantern (6,000) and particles (whole seconds up to 10).
constexpr std::int64_t kPeriod_ms = 10'080'000;

TEST(Everything, HardCaseT1_ReturnsAfterItsPeriodAlsoBeyond32BitsOfMilliseconds) {
    EffectStage stage = everything(in_tank());
    for (const std::int64_t time_ms : {0, 137, 2'900, 7'777}) {
        const Picture now = stage.draw(time_ms);
        EXPECT_GT(changed_pixels(now, stage.draw(time_ms + 1'111)), 1'000) << "nothing moves";
        for (const int bits : {31, 32, 53}) {
            const std::int64_t before = (std::int64_t{1} << bits) / kPeriod_ms * kPeriod_ms;
            EXPECT_EQ(stage.draw(before + time_ms), now) << bits << " bits";
            EXPECT_EQ(stage.draw(before + kPeriod_ms + time_ms), now) << bits << " bits";
        }
    }
}

/// One millisecond before and after the wrap of a counter of 31 or 32 bits the picture goes on: as much of it changes
/// as in any other 200 ms.
TEST(Everything, HardCaseT1_GoesOnWhereCountersOfMillisecondsWrap) {
    EffectStage stage = everything(in_tank());
    for (const int bits : {31, 32}) {
        const std::int64_t wrap = std::int64_t{1} << bits, same = wrap % kPeriod_ms;
        for (const std::int64_t off : {-200, -1, 0, 1, 200})
            EXPECT_EQ(stage.draw(wrap + off), stage.draw(same + off)) << bits << " bits and " << off;
    }
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

    // Not a mirror, whose own picture calls for what it shows.
    const EffectSet allowed = EffectSet::all().without(Effect::Mirror);
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
