// Particles by the laws that they follow: they return after their period, stay in their box, fall and fly as they say.
#include "engine/effects/particles.h"

#include <gtest/gtest.h>

#include <array>
#include <random>
#include <vector>

#include "tests/support/views.h"

namespace oblong::test {

namespace {

constexpr std::array kKinds{ParticleKind::Rain, ParticleKind::Dust, ParticleKind::Sparks, ParticleKind::Bubbles};

ParticleEmitter emitter_of(ParticleKind kind) {
    ParticleEmitter emitter;
    emitter.kind = kind;
    emitter.middle = point_at(1000, -2000, 300);
    emitter.half_size = point_at(100, 50, 80);
    emitter.count = 200;
    emitter.first_colour = 40;
    emitter.last_colour = 47;
    emitter.period_ms = 1700;
    emitter.seed = 5;
    return emitter;
}

Vec3<World> place(const ParticleEmitter& emitter, std::int32_t index, std::int64_t time_ms) {
    return particle_at(emitter, index, phase_at(emitter, time_ms)).position;
}

bool is_within(World position, World middle, World half) {
    return position >= middle - half && position <= middle + half;
}

}  // namespace

TEST(Particles, ReturnAfterTheirPeriodAtAnyTime) {
    std::mt19937_64 random(1);
    for (const ParticleKind kind : kKinds) {
        const ParticleEmitter emitter = emitter_of(kind);
        int moved = 0;
        for (std::int32_t i = 0; i < emitter.count; ++i) {
            const auto time_ms = static_cast<std::int64_t>(random() % 1700);
            const Vec3<World> first = place(emitter, i, time_ms);
            moved += first != place(emitter, i, time_ms + 500);
            for (const std::int64_t periods : {std::int64_t{1}, std::int64_t{1} << 32, std::int64_t{1} << 51})
                EXPECT_EQ(place(emitter, i, time_ms + periods * 1700), first) << i;
        }
        EXPECT_EQ(moved, emitter.count);
    }
}

TEST(Particles, NeverLeaveTheirBoxAndUseAllOfIt) {
    std::mt19937_64 random(2);
    for (const ParticleKind kind : kKinds) {
        const ParticleEmitter emitter = emitter_of(kind);
        const Vec3<World> half = emitter.half_size, middle = emitter.middle;
        World widest, highest;
        for (int trial = 0; trial < 20000; ++trial) {
            const auto index = static_cast<std::int32_t>(random() % 200);
            const Vec3<World> p = place(emitter, index, static_cast<std::int64_t>(random() >> 2));
            ASSERT_TRUE(is_within(p.x, middle.x, half.x) && is_within(p.y, middle.y, half.y) &&
                        is_within(p.z, middle.z, half.z));
            widest = std::max(widest, absolute(p.x - middle.x));
            highest = std::max(highest, absolute(p.z - middle.z));
        }
        EXPECT_GT(widest, World::from_int(85));
        EXPECT_GT(highest, World::from_int(70));
    }
}

TEST(Particles, ABoxWithoutSizeHoldsThemAll) {
    for (const ParticleKind kind : kKinds) {
        ParticleEmitter emitter = emitter_of(kind);
        emitter.half_size = {};
        for (std::int32_t i = 0; i < emitter.count; ++i) EXPECT_EQ(place(emitter, i, 77 * i), emitter.middle);
    }
}

TEST(Particles, DropsFallStraightAndEvenly) {
    const ParticleEmitter emitter = emitter_of(ParticleKind::Rain);
    int falls = 0;
    for (std::int32_t i = 0; i < emitter.count; ++i) {
        constexpr std::uint32_t kStep = 1u << 24;
        const auto at = [&](std::uint32_t steps) { return particle_at(emitter, i, steps * kStep); };
        if (!at(0).is_streak || !at(3).is_streak || at(3).position.z > at(0).position.z) continue;
        ++falls;
        EXPECT_EQ(at(0).position.x, at(3).position.x);
        EXPECT_EQ(at(0).position.y, at(3).position.y);
        // 160 units in 7/8 of 256 steps.
        const World fall = at(0).position.z - at(3).position.z;
        EXPECT_NEAR(fall.raw, 3 * 160 * 4096 / 224, 8);
    }
    EXPECT_GT(falls, 150);
}

TEST(Particles, SparksFlyOnParabolasFromTheMiddle) {
    const ParticleEmitter emitter = emitter_of(ParticleKind::Sparks);
    for (std::int32_t i = 0; i < emitter.count; ++i) {
        // The second difference of the height of a parabola is the same all along; where the spark starts anew it is
        // not.
        std::vector<std::int32_t> second;
        for (std::uint32_t step = 0; step < 16; ++step) {
            const auto z = [&](std::uint32_t more) {
                return particle_at(emitter, i, (step + more) << 28).position.z.raw;
            };
            second.push_back(z(2) - 2 * z(1) + z(0));
        }
        std::sort(second.begin(), second.end());
        EXPECT_LT(second[6], 0) << "it falls";
        EXPECT_LE(second[12] - second[2], 12) << "but for rounding, all except the two across its start";
    }
}

TEST(Particles, SparksGoThroughTheRampAsTheyAge) {
    const ParticleEmitter emitter = emitter_of(ParticleKind::Sparks);
    for (std::int32_t i = 0; i < 50; ++i) {
        std::vector<int> uses(256);
        for (std::uint32_t step = 0; step < 256; ++step) ++uses[particle_at(emitter, i, step << 24).colour];
        for (int colour = 40; colour <= 47; ++colour) EXPECT_NEAR(uses[static_cast<std::size_t>(colour)], 32, 1);
    }
}

TEST(Particles, ARampMayGoDown) {
    ParticleEmitter emitter = emitter_of(ParticleKind::Dust);
    emitter.first_colour = 255;
    emitter.last_colour = 252;
    std::vector<int> uses(256);
    for (std::int32_t i = 0; i < 200; ++i) ++uses[particle_at(emitter, i, 0).colour];
    EXPECT_EQ(uses[252] + uses[253] + uses[254] + uses[255], 200);
    EXPECT_GT(uses[252], 20);
}

TEST(Particles, AnotherSeedPutsThemElsewhere) {
    ParticleEmitter other = emitter_of(ParticleKind::Dust);
    ++other.seed;
    int same = 0;
    for (std::int32_t i = 0; i < 200; ++i) same += place(emitter_of(ParticleKind::Dust), i, 0) == place(other, i, 0);
    EXPECT_EQ(same, 0);
}

}  // namespace oblong::test
