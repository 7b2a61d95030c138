#pragma once

#include <gtest/gtest.h>

#include "engine/frame/passes.h"
#include "tests/frame/frame_fixture.h"

namespace oblong::test {

/// Where and how a picture was wrong, in words a camera file takes.
inline std::string describe(const Camera& camera, std::int64_t never, std::int64_t twice) {
    const auto units = [](World w) { return std::to_string(static_cast<double>(w.raw) / 4096); };
    const auto degrees = [](Angle a) { return std::to_string(a.bam * 360.0 / 65536); };
    return units(camera.eye.x) + "," + units(camera.eye.y) + "," + units(camera.eye.z) + "," + degrees(camera.yaw) +
           "," + degrees(camera.pitch) + "," + degrees(camera.roll) + ": never " + std::to_string(never) + ", twice " +
           std::to_string(twice);
}

inline std::string first_wrong_pixels(const Stage& stage, const FrameCounts& counts) {
    std::string text = " at";
    int shown = 0;
    for (std::size_t i = 0; i < counts.writes.size() && shown < 8; ++i) {
        if (counts.writes[i] == 1) continue;
        const auto width = static_cast<std::size_t>(stage.mode.width_px);
        text += " (" + std::to_string(i % width) + "," + std::to_string(i / width) + ")";
        ++shown;
    }
    return text;
}

inline void expect_each_pixel_once(Stage& stage, const Camera& camera, ObservedWorkspace& work) {
    stage.draw(camera, work);
    std::int64_t never = 0, twice = 0;
    std::int64_t owned = 0;
    for (std::size_t i = 0; i < kPassCount; ++i)
        if (kPasses[i].owns_pixels) owned += work.counts.pass_pixels[i];
    EXPECT_EQ(owned, std::ssize(work.counts.writes)) << "pixels of the passes that own theirs";
    for (const std::uint8_t writes : work.counts.writes) {
        never += writes == 0;
        twice += writes > 1;
    }
    if (never != 0 || twice != 0)
        ADD_FAILURE() << describe(camera, never, twice) << first_wrong_pixels(stage, work.counts);
}

/// A workspace that counts.
inline std::unique_ptr<ObservedWorkspace> counting_workspace(const Stage& stage) {
    auto work = std::make_unique<ObservedWorkspace>(stage.level, stage.mode);
    work->count();
    return work;
}

/// The places of entities that are in the open.
inline std::vector<Vec3<World>> open_origins(const Level& level) {
    std::vector<Vec3<World>> points = entity_origins(level);
    std::erase_if(points, [&](const Vec3<World>& p) { return !is_open(level, p); });
    return points;
}

}  // namespace oblong::test
