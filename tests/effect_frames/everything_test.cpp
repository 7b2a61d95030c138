// A room that calls for every effect at once (tools/effect_costs/all_effects.map), in which nothing depends on what was
// drawn before, and each effect can be left out.

#include "tests/effect_frames/everything.h"

#include "engine/platform/worker_threads.h"

namespace oblong::test {
namespace {

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

TEST(Everything, LaterThan32BitsOfMillisecondsIsTheSameInAUsedWorkspace) {
    EffectStage stage = everything(in_tank());
    for (const std::int64_t time_ms : {std::int64_t{1} << 32, (std::int64_t{1} << 32) + 50, std::int64_t{1} << 53})
        ASSERT_EQ(stage.draw(time_ms), stage.draw_afresh(time_ms)) << time_ms;
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

}  // namespace
}  // namespace oblong::test
