#include "engine/effects/particles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "tests/support/views.h"

namespace oblong::test::particles_test {
namespace {

// Particles by the laws that they follow: they return after their period, stay in their box, fall and fly as they say.

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

Particle any_at(const ParticleEmitter& emitter, std::int32_t index, std::uint32_t phase) {
    return particle_at(emitter, index, phase, box_of(emitter)).value();
}

Vec3<World> place(const ParticleEmitter& emitter, std::int32_t index, std::int64_t time_ms) {
    return any_at(emitter, index, phase_at(emitter, time_ms)).position;
}

bool is_within(World position, World middle, World half) {
    return position >= middle - half && position <= middle + half;
}

// Dots against the projection in doubles, and what hides them.

ParticleEmitter cloud(ParticleKind kind, Vec3<World> middle, Vec3<World> half_size, std::int32_t count = 500) {
    return {kind, middle, half_size, count, 10, 10, 1000, 3};
}

std::vector<ParticleDot> dots_of(const ParticleEmitter& emitter, const ViewContext& view, std::int64_t time_ms = 0) {
    std::vector<ParticleDot> dots;
    EXPECT_EQ(append_dots(emitter, time_ms, view, box_of(emitter), dots), emitter.count);
    return dots;
}

bool is_within(const ParticleDot& dot, const ScreenRectangle& all) {
    return dot.first_column >= all.first_column && dot.end_column <= all.end_column && dot.first_row >= all.first_row &&
           dot.end_row <= all.end_row;
}

/// A picture of 320x200 with a wall straight ahead.
class Picture {
  public:
    explicit Picture(std::int32_t wall_z) {
        depth.want({0, 320, 0, 200});
        depth.clear();
        depth.fill(all_rows(), {InverseZ::from_raw((std::int64_t{1} << 44) / wall_z), {}, {}});
    }
    void draw(std::span<const ParticleDot> dots) { draw_dots(dots, depth, {pixels.data(), 320, 200, 320}); }
    std::int64_t count(std::uint8_t colour) const { return std::count(pixels.begin(), pixels.end(), colour); }

    DepthBuffer depth{320, 200};
    std::vector<std::uint8_t> pixels = std::vector<std::uint8_t>(320 * 200);
};

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
        const auto at = [&](std::uint32_t steps) { return any_at(emitter, i, steps * kStep); };
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
            const auto z = [&](std::uint32_t more) { return any_at(emitter, i, (step + more) << 28).position.z.raw; };
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
        for (std::uint32_t step = 0; step < 256; ++step) ++uses[any_at(emitter, i, step << 24).colour];
        for (int colour = 40; colour <= 47; ++colour) EXPECT_NEAR(uses[static_cast<std::size_t>(colour)], 32, 1);
    }
}

TEST(Particles, ARampMayGoDown) {
    ParticleEmitter emitter = emitter_of(ParticleKind::Dust);
    emitter.first_colour = 255;
    emitter.last_colour = 252;
    std::vector<int> uses(256);
    for (std::int32_t i = 0; i < 200; ++i) ++uses[any_at(emitter, i, 0).colour];
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
TEST(ParticleDots, LieWhereTheProjectionPutsThem) {
    const ViewContext view = view_from(point_at(10, 20, 30));
    const ParticleEmitter emitter = cloud(ParticleKind::Bubbles, point_at(300, 20, 30), point_at(200, 100, 60), 2000);
    const std::vector<ParticleDot> dots = dots_of(emitter, view);
    std::size_t next = 0;
    for (std::int32_t i = 0; i < emitter.count; ++i) {
        const Point p = to_point(any_at(emitter, i, 0).position);
        const double z = p.x - 10, x = 160 - 160 * (p.y - 20) / z, y = 100 - 160 / 1.2 * (p.z - 30) / z;
        const double width = std::max(320 / z, 1.), height = std::max(320 / 1.2 / z, 1.);
        if (x < 20 || x > 300 || y < 20 || y > 180) {
            const bool is_its_dot = next < dots.size() && std::abs(dots[next].inverse_depth * z / 0x1p32 - 1) < 1e-5;
            next += is_its_dot;
            continue;
        }
        ASSERT_LT(next, dots.size());
        const ParticleDot& dot = dots[next++];
        EXPECT_NEAR(dot.inverse_depth, 0x1p32 / z, 0x1p32 / z * 1e-5);
        EXPECT_NEAR((dot.first_column + dot.end_column) / 2., x, 0.6);
        EXPECT_NEAR((dot.first_row + dot.end_row) / 2., y, 0.6);
        EXPECT_NEAR(dot.end_column - dot.first_column, width, 0.6);
        EXPECT_NEAR(dot.end_row - dot.first_row, height, 0.6);
    }
    EXPECT_EQ(next, dots.size());
    EXPECT_GT(next, 1000u);
}

TEST(ParticleDots, AreAsWideAsHighOnARealScreen) {
    // Pixels are 1.2 times as high as wide.
    for (const ScreenMode mode : {ScreenMode{320, 200, {4, 3}}, ScreenMode{1280, 800, {4, 3}}}) {
        const ViewContext view = view_from({}, {}, {}, mode);
        const std::vector<ParticleDot> dots = dots_of(cloud(ParticleKind::Bubbles, point_at(20, 0, 0), {}, 1), view);
        ASSERT_EQ(dots.size(), 1u);
        const double width = dots[0].end_column - dots[0].first_column, height = dots[0].end_row - dots[0].first_row;
        EXPECT_NEAR(width, height * 1.2, 1.1);
        EXPECT_GE(width, mode.width_px / 20.0 - 1);
    }
}

TEST(ParticleDots, AreWithinTheScreenAndInFrontOfTheEye) {
    for (const ParticleKind kind : {ParticleKind::Rain, ParticleKind::Bubbles, ParticleKind::Sparks})
        for (std::int32_t turn = 0; turn < 16; ++turn) {
            const ViewContext view = view_from({}, Angle::from_bam(turn * 4096), Angle::from_bam(turn * 1111));
            const auto dots = dots_of(cloud(kind, point_at(3, 2, 1), point_at(60, 60, 60), 3000), view, turn * 10);
            EXPECT_FALSE(dots.empty());
            for (const ParticleDot& dot : dots) {
                ASSERT_TRUE(is_within(dot, {0, 320, 0, 200}));
                ASSERT_TRUE(dot.first_column < dot.end_column && dot.first_row < dot.end_row);
                ASSERT_LE(dot.inverse_depth, 1u << 28) << "nearer than 16 units";
                ASSERT_LE(dot.end_column - dot.first_column, 20);
                ASSERT_LE(dot.end_row - dot.first_row, 50);
            }
        }
}

TEST(ParticleDots, OfHugeBoxesAndNarrowFieldsOfViewAreSound) {
    for (const std::int32_t degrees : {1, 90, 179}) {
        ViewContext view = view_from(point_at(-65000, 300, 0));
        view.projection = make_projection({4096, 4096, {4, 3}}, Degrees::from_int(degrees));
        view.frustum = make_frustum(view.axes, view.projection);
        for (const ParticleKind kind : {ParticleKind::Rain, ParticleKind::Dust, ParticleKind::Sparks})
            for (const ParticleDot& dot :
                 dots_of(cloud(kind, point_at(65536, 65536, -65536), point_at(32768, 32768, 32768)), view))
                ASSERT_TRUE(is_within(dot, {0, 4096, 0, 4096}));
    }
}

TEST(ParticleDots, HideBehindWalls) {
    const ViewContext view = view_from({});
    const auto behind = dots_of(cloud(ParticleKind::Dust, point_at(300, 0, 0), point_at(90, 50, 50)), view);
    const auto before = dots_of(cloud(ParticleKind::Dust, point_at(150, 0, 0), point_at(40, 20, 20)), view);
    Picture picture(200);
    picture.draw(behind);
    EXPECT_EQ(picture.count(10), 0);
    picture.draw(before);
    EXPECT_GT(picture.count(10), 300);
    // Some of a cloud that the wall cuts in two.
    Picture cut(200);
    const auto across = dots_of(cloud(ParticleKind::Dust, point_at(200, 0, 0), point_at(90, 60, 40)), view);
    cut.draw(across);
    const auto is_nearer = [](const ParticleDot& dot) { return dot.inverse_depth >= (1ll << 32) / 200; };
    const auto nearer = std::count_if(across.begin(), across.end(), is_nearer);
    EXPECT_GT(cut.count(10), nearer / 2);
    EXPECT_LT(cut.count(10), nearer * 3 / 2);
}

TEST(ParticleDots, MayBeDrawnInAnyOrder) {
    const ViewContext view = view_from({});
    std::vector<ParticleDot> dots =
        dots_of(cloud(ParticleKind::Bubbles, point_at(80, 0, 0), point_at(40, 30, 30)), view);
    std::sort(dots.begin(), dots.end(), [](const auto& a, const auto& b) { return a.inverse_depth < b.inverse_depth; });
    for (std::size_t i = 0; i < dots.size(); ++i)
        dots[i].colour = static_cast<std::uint8_t>(1 + dots[i].inverse_depth % 255);
    Picture far_first(10000), near_first(10000);
    far_first.draw(dots);
    std::reverse(dots.begin(), dots.end());
    near_first.draw(dots);
    EXPECT_EQ(far_first.pixels, near_first.pixels);
}

/// Whether a place is in one of a box's columns that count.
bool is_in(const ParticleBox& box, const Vec3<World>& p) {
    if (box.columns != box_of({}).columns) {
        for (int number = 0; number < ParticleBox::kColumns; ++number)
            if ((box.columns >> number & 1) != 0 && is_in(box.column(number), p)) return true;
        return false;
    }
    return p.x >= box.mins.x && p.y >= box.mins.y && p.z >= box.mins.z && p.x <= box.maxs.x && p.y <= box.maxs.y &&
           p.z <= box.maxs.z;
}

TEST(ParticleDots, OfABoxAreThoseOfTheParticlesInIt) {
    const ViewContext view = view_from(point_at(10, 20, 30));
    for (const ParticleKind kind : kKinds) {
        const ParticleEmitter emitter = cloud(kind, point_at(300, 20, 30), point_at(100, 60, 40));
        const std::int64_t time_ms = 333;
        std::vector<Vec3<World>> places;
        for (std::int32_t i = 0; i < emitter.count; ++i) places.push_back(place(emitter, i, time_ms));
        // A part along each axis, and one whose border is a particle's place.
        ParticleBox parts[5] = {box_of(emitter), box_of(emitter), box_of(emitter), box_of(emitter), box_of(emitter)};
        parts[0].maxs.x = emitter.middle.x;
        parts[1].mins.y = emitter.middle.y + World::from_int(20);
        parts[2].maxs.z = emitter.middle.z - World::from_int(10);
        parts[3] = {places[7], box_of(emitter).maxs};
        parts[4].columns = 0b1000'0110'0001'1111;
        for (const ParticleBox& part : parts) {
            std::vector<ParticleDot> dots;
            const std::int32_t computed = append_dots(emitter, time_ms, view, part, dots);
            EXPECT_EQ(computed, std::count_if(places.begin(), places.end(),
                                              [&](const Vec3<World>& p) { return is_in(part, p); }));
            EXPECT_GT(computed, 0);
            EXPECT_LT(computed, emitter.count);
            // In the order of all: dots of equal depth hide each other in it.
            auto next = dots.begin();
            for (const ParticleDot& dot : dots_of(emitter, view, time_ms))
                next += next != dots.end() && next->inverse_depth == dot.inverse_depth &&
                        next->first_column == dot.first_column && next->first_row == dot.first_row;
            EXPECT_EQ(next, dots.end());
        }
    }
}

TEST(ParticleDots, ARectangleHoldsThemAll) {
    const auto dots = dots_of(cloud(ParticleKind::Rain, point_at(200, 30, 0), point_at(20, 20, 20)), view_from({}));
    ASSERT_FALSE(dots.empty());
    const ScreenRectangle around = rectangle_around(dots);
    const auto touches = [&](auto of_dot, std::int32_t border) {
        return std::any_of(dots.begin(), dots.end(), [&](const ParticleDot& dot) { return of_dot(dot) == border; });
    };
    for (const ParticleDot& dot : dots) ASSERT_TRUE(is_within(dot, around));
    EXPECT_TRUE(touches([](const auto& dot) { return dot.first_column; }, around.first_column));
    EXPECT_TRUE(touches([](const auto& dot) { return dot.end_row; }, around.end_row));
}
}  // namespace oblong::test::particles_test
