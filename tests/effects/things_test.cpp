// What is read from entities, what is said of bad ones, and what of it a frame computes.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "engine/effects/things_in_view.h"
#include "engine/level/bsp_read.h"
#include "engine/level/entities.h"
#include "engine/visibility/visible_set.h"
#include "tests/support/bsp_writer.h"
#include "tests/support/views.h"

namespace oblong::test {

namespace {

/// The tiny level (solid below z = 8) with these entities.
Level level_with(const std::string& entities) {
    Level level = read_bsp(join_lumps(29, make_tiny_lumps()));
    level.entities = parse_entities(entities, "entities");
    return level;
}

std::string entity(const std::string& class_name, const std::string& more = R"("origin" "16 8 40")") {
    return "{ \"classname\" \"" + class_name + "\" " + more + " }";
}

/// What a frame computes from inside the tiny level.
ThingsInView seen_from(const Level& level, Angle yaw, std::int64_t time_ms = 0) {
    const Things things = read_things(level);
    VisibleSet visible(level);
    visible.see_from(level, LeafIndex(1));
    ThingsInSet in_set;
    in_set.keep_up(things, visible);
    ThingsInView in_view;
    DepthBuffer depth(320, 200);
    const ViewContext view = view_from(point_at(-100, 8, 40), yaw);
    const Sight sight{visible.leaf_set(), view};
    find_particles(in_set, time_ms, sight, in_view, depth);
    EXPECT_EQ(depth.is_wanted(), !in_view.dots.empty());
    find_placed_sprites(in_set, sight, in_view);
    find_sprites(in_set, time_ms, level, sight, in_view, depth);
    EXPECT_EQ(depth.is_wanted(), !in_view.dots.empty() || !in_view.sprites.empty());
    find_shadows(in_view);
    return in_view;
}

}  // namespace

TEST(Things, AnOriginThatDoesNotMoveItsBrushesIsNamed) {
    Level level = level_with("");
    level.models.push_back({});
    const auto said_of = [&](const std::string& class_name, const std::string& more) {
        level.entities = parse_entities(entity(class_name, more), "entities");
        return read_things(level).warnings;
    };
    EXPECT_EQ(
        said_of("func_door", R"("model" "*1" "origin" "64 0 0")"),
        std::vector<std::string>{"entity 0 (func_door): origin is \"64 0 0\", expected none with brushes: they stay "
                                 "where they are in the level"});
    EXPECT_EQ(said_of("func_wall", R"("model" "*1" "origin" "nan 0 0")").size(), 1u);
    EXPECT_TRUE(said_of("func_wall", R"("model" "*1" "origin" "0 -0 0.0")").empty());
    EXPECT_TRUE(said_of("func_rotating", R"("model" "*1" "origin" "64 0 0")").empty()) << "its axis";
    EXPECT_TRUE(said_of("func_door_rotating", R"("model" "*1" "origin" "64 0 0")").empty());
}

TEST(Things, AreReadFromEntities) {
    const Level level = level_with(
        entity("misc_rain", R"("origin" "16 8 40" "size" "20 30 40" "count" "77" "colour" "12" "period" "1.5")") +
        entity("misc_sparks", R"("origin" "16 8 40" "colour" "111 104")") + entity("air_bubbles") +
        entity("info_null") +
        entity("misc_sprite", R"("origin" "16 8 40" "texture" "floor" "scale" "0.5" "shadow" "24")") +
        entity("misc_lantern", R"("origin" "16 8 40" "texture" "floor" "radius" "32" "period" "4" "light" "150")"));
    const Things things = read_things(level);
    EXPECT_TRUE(things.warnings.empty()) << things.warnings.front();
    ASSERT_EQ(things.emitters.size(), 3u);
    const ParticleEmitter& rain = things.emitters[0].emitter;
    EXPECT_EQ(rain.kind, ParticleKind::Rain);
    EXPECT_EQ(rain.middle, point_at(16, 8, 40));
    EXPECT_EQ(rain.half_size, point_at(10, 15, 20));
    EXPECT_EQ(rain.count, 77);
    EXPECT_EQ(rain.first_colour, 12);
    EXPECT_EQ(rain.last_colour, 12);
    EXPECT_EQ(rain.period_ms, 1500);
    EXPECT_EQ(things.emitters[1].emitter.first_colour, 111);
    EXPECT_EQ(things.emitters[1].emitter.last_colour, 104);
    const ParticleEmitter& bubbles = things.emitters[2].emitter;
    EXPECT_EQ(bubbles.middle.z - bubbles.half_size.z, World::from_int(40)) << "they rise from where the entity is";
    ASSERT_EQ(things.sprites.size(), 1u);
    EXPECT_EQ(things.sprites[0].sprite.scale, World::from_raw(2048));
    ASSERT_TRUE(things.sprites[0].floor);
    EXPECT_EQ(things.sprites[0].floor->position, point_at(16, 8, 8));
    ASSERT_EQ(things.lanterns.size(), 1u);
    EXPECT_EQ(things.lanterns[0].lantern.radius, World::from_int(32));
    EXPECT_EQ(things.lanterns[0].lantern.period_ms, 4000);
    EXPECT_EQ(things.lanterns[0].lantern.light_radius, World::from_int(150));
}

TEST(Things, BrushModelsThatAreMissingAreReported) {
    for (const char* missing : {"*1", "*999", "*-1", "*0", "*", "*x"}) {
        const std::string model = std::string("\"model\" \"") + missing + "\"";
        const Things things = read_things(level_with(entity("worldspawn") + entity("func_door", model)));
        ASSERT_EQ(things.warnings.size(), 1u) << missing;
        EXPECT_TRUE(things.warnings[0].starts_with("entity 1 (func_door): model is \"" + std::string(missing) + "\", "))
            << things.warnings[0];
    }
    EXPECT_TRUE(read_things(level_with(entity("misc_model", R"("model" "a.obj")"))).warnings.empty());
}

TEST(Things, BadValuesAreReplacedAndReported) {
    using Texts = std::vector<std::string>;
    const auto sparks_with = [](const std::string& pairs) {
        return read_things(level_with(entity("worldspawn") + entity("misc_sparks", pairs + R"("origin" "16 8 40")")));
    };
    const ParticleEmitter good = sparks_with("").emitters[0].emitter;
    for (const auto& [key, values] : {std::pair{"size", Texts{"0 0 0", "10 -5 10", "nan nan nan", "7", "99999999 1 1"}},
                                      {"count", Texts{"-1", "1e9", "131073", "9999999999999999999999"}},
                                      {"colour", Texts{"256", "-1", "1 2 3", "red"}},
                                      {"period", Texts{"0", "-2", "NaN", "1000000"}}})
        for (const std::string& value : values) {
            const Things things = sparks_with("\"" + std::string(key) + "\" \"" + value + "\" ");
            ASSERT_EQ(things.warnings.size(), 1u) << key << " " << value;
            const std::string said = things.warnings[0];
            EXPECT_NE(said.find("entity 1 (misc_sparks): " + (key + (" is \"" + value)) + "\", expected"), said.npos)
                << said;
            EXPECT_TRUE(key != std::string("period") || said.find("0.05 to 3600") != said.npos) << said;
            ASSERT_EQ(things.emitters.size(), 1u);
            const ParticleEmitter& used = things.emitters[0].emitter;
            EXPECT_EQ(used.half_size, good.half_size);
            EXPECT_EQ(used.count, good.count);
            EXPECT_EQ(used.first_colour, good.first_colour);
            EXPECT_EQ(used.period_ms, good.period_ms);
        }
}

TEST(Things, WithoutAPlaceOrATextureAreLeftOutAndReported) {
    const Things things =
        read_things(level_with(entity("misc_rain", "") + entity("misc_dust", R"("origin" "1 2 x")") +
                               entity("misc_rain", R"("origin" "400000 0 0")") + entity("misc_sprite") +
                               entity("misc_lantern", R"("origin" "0 0 9" "texture" "gone")")));
    EXPECT_TRUE(things.emitters.empty() && things.sprites.empty() && things.lanterns.empty());
    for (const char* part : {"entity 0 (misc_rain)", "entity 1 (misc_dust)", "entity 2 (misc_rain)",
                             "entity 3 (misc_sprite)", "texture is \"gone\""})
        EXPECT_EQ(std::count_if(things.warnings.begin(), things.warnings.end(),
                                [part](const std::string& each) {
                                    return each.find(part) != std::string::npos &&
                                           each.find("left out") != std::string::npos;
                                }),
                  1)
            << part;
}

TEST(Things, HaveLimits) {
    std::string text;
    for (int i = 0; i < 1100; ++i) text += entity("misc_dust", R"("origin" "16 8 40" "count" "1000")");
    for (int i = 0; i < 4100; ++i) text += entity("misc_sprite", R"("origin" "16 8 40" "texture" "floor")");
    for (int i = 0; i < 70; ++i) text += entity("misc_lantern", R"("origin" "16 8 40" "texture" "floor")");
    const Things things = read_things(level_with(text));
    std::int64_t particles = 0;
    for (const PlacedEmitter& each : things.emitters) particles += each.emitter.count;
    EXPECT_EQ(particles, 131072);
    EXPECT_EQ(things.emitters.size(), 132u) << "those without a particle left do not count";
    EXPECT_EQ(things.sprites.size(), 4096u);
    EXPECT_EQ(things.lanterns.size(), 64u);
    EXPECT_EQ(things.warnings.size(), 1100u - 131 + 4 + 6);
}

TEST(Things, OutOfViewAreNotComputed) {
    const Level level = level_with(entity("misc_rain", R"("origin" "16 8 40" "size" "16 16 16" "count" "300")"));
    EXPECT_EQ(seen_from(level, Angle{}).particles_computed, 300);
    EXPECT_GT(seen_from(level, Angle{}).dots.size(), 200u);
    const ThingsInView away = seen_from(level, kHalfTurn);
    EXPECT_EQ(away.particles_computed, 0);
    EXPECT_TRUE(away.dots.empty());
}

TEST(Things, InNoVisibleLeafAreNotComputed) {
    const Level level = level_with(entity("misc_rain", R"("origin" "16 8 -40" "size" "16 16 16")") +
                                   entity("misc_sprite", R"("origin" "16 8 -40" "texture" "floor")"));
    const ThingsInView in_view = seen_from(level, Angle{});
    EXPECT_EQ(in_view.particles_computed, 0) << "they are in the solid below";
    EXPECT_TRUE(in_view.sprites.empty());
}

TEST(Things, SpritesBringTheirShadowsAndLanternsMove) {
    const Level level =
        level_with(entity("misc_sprite", R"("origin" "16 8 72" "texture" "floor" "shadow" "20")") +
                   entity("misc_lantern", R"("origin" "16 8 40" "texture" "floor" "radius" "8" "period" "8")"));
    const ThingsInView now = seen_from(level, Angle{}),
                       later = seen_from(level, Angle{}, 2000 + (std::int64_t{8000} << 32));
    ASSERT_EQ(now.sprites.size(), 2u);
    ASSERT_EQ(later.sprites.size(), 2u);
    EXPECT_EQ(now.sprites[0].position, later.sprites[0].position);
    EXPECT_EQ(now.sprites[1].position, point_at(24, 8, 40));
    EXPECT_EQ(later.sprites[1].position, point_at(16, 16, 40)) << "a quarter turn, and many whole ones";
    ASSERT_EQ(now.shadows.size(), 1u);
    EXPECT_EQ(now.shadows[0].radius, World::from_int(10)) << "64 units up: half";
}

TEST(Lanterns, StayOnTheirCircleAndReturnAfterTheirPeriod) {
    Lantern lantern{point_at(100, 200, 50), World::from_int(64), 3000, {}, TextureIndex(0), World::from_int(1)};
    for (std::int64_t time_ms = 0; time_ms < 3000; time_ms += 7) {
        const Point p = to_point(lantern_at(lantern, time_ms).position);
        const double angle = 2 * M_PI * static_cast<double>(time_ms) / 3000;
        // A step of the angle is 64 * 2 pi / 65,536 units.
        ASSERT_NEAR(p.x, 100 + 64 * std::cos(angle), 0.007);
        ASSERT_NEAR(p.y, 200 + 64 * std::sin(angle), 0.007);
        ASSERT_EQ(p.z, 50);
        ASSERT_EQ(lantern_at(lantern, time_ms + (std::int64_t{3000} << 40)).position,
                  lantern_at(lantern, time_ms).position);
    }
}

}  // namespace oblong::test
