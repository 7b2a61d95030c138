#include "game/sound/audible.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/sound/walled_level.h"

namespace oblong::test {
namespace {

SoundSource source_at(Sound sound, int x, int y, int z = 46, std::uint32_t serial = 0) {
    const Position at = world_vector(x, y, z);
    return {sound, 0, {at, at}, serial, kWorldModel};
}

const Listener kListener{world_vector(0, 0, 46), Angle{}, false};  // looks along +x: right is -y

// In a box, from z = 20 to 220.
SoundSource area_at(Sound sound, int x, int y, int to_x, int to_y) {
    SoundSource area = source_at(sound, x, y, 20);
    area.box.maxs = world_vector(to_x, to_y, 220);
    return area;
}

Listener listener_at(int x, int y) {
    return {world_vector(x, y, 46), Angle{}, false};
}

Audible audible_now(const ToyGame& game, const std::vector<SoundSource>& sources,
                    const Listener& listener = kListener) {
    HeardFrom nowhere;
    return audible_sounds(game.level, game.state, listener, sources, nowhere);
}

// (1 - d / range)^2 of the gain, to the sides with constant power.
void expect_levels(const SoundSource& source, const Listener& listener) {
    const double x = (source.box.mins.x.raw - listener.ear.x.raw) / 4096.0;
    const double y = (source.box.mins.y.raw - listener.ear.y.raw) / 4096.0;
    const double z = (source.box.mins.z.raw - listener.ear.z.raw) / 4096.0;
    const double yaw = listener.yaw.bam * M_PI / 32'768, distance = std::sqrt(x * x + y * y + z * z);
    const SoundRow& row = row_of(source.sound);
    const double gain = distance >= row.range ? 0 : std::pow(1 - distance / row.range, 2) * row.gain_256;
    const double right = (x * std::sin(yaw) - y * std::cos(yaw)) / std::max(distance, 96.0) * 7 / 8;
    const VoiceLevels levels = levels_at(source, listener);
    EXPECT_NEAR(levels.left_256, gain * std::sqrt((1 - right) / 2), 1.5) << x << " " << y << " " << z;
    EXPECT_NEAR(levels.right_256, gain * std::sqrt((1 + right) / 2), 1.5) << x << " " << y << " " << z;
}

TEST(Levels, FallWithDistanceAndTurnWithTheListener) {
    for (int x = -900; x <= 900; x += 150)
        for (int y = -900; y <= 900; y += 150)
            for (int turn = 0; turn < 65'536; turn += 9'000)
                expect_levels(source_at(Sound::SlabStart, x, y, 46 + x / 3),
                              {world_vector(3, -7, 46), Angle::from_bam(turn), false});
}

TEST(Levels, OfABoxAreThoseOfItsNearestPoint) {
    SoundSource canal = source_at(Sound::Water, 100, -5'000);
    canal.box.maxs = world_vector(300, 5'000, 46);
    EXPECT_EQ(levels_at(canal, kListener), levels_at(source_at(Sound::Water, 100, 0), kListener));
}

TEST(Audible, LeavesOutWhatIsOutOfRangeAndTracesNothingForIt) {
    const ToyGame game(with_wall());
    const Audible audible = audible_now(game, {source_at(Sound::Hum, -170, 0), source_at(Sound::Wind, -2'000, 0)});
    EXPECT_TRUE(audible.sounds.empty());
    EXPECT_EQ(audible.traces, 0);
}

TEST(Audible, IsMuffledAndSofterBehindAWall) {
    const ToyGame game(with_wall());
    const Audible behind = audible_now(game, {source_at(Sound::GateStart, 300, 0, 46, 1)}),
                  before = audible_now(game, {source_at(Sound::GateStart, -300, 0, 46, 1)});
    ASSERT_EQ(behind.sounds.size(), 1u);
    ASSERT_EQ(before.sounds.size(), 1u);
    EXPECT_TRUE(behind.sounds[0].levels.is_muffled);
    EXPECT_FALSE(before.sounds[0].levels.is_muffled);
    EXPECT_LT(behind.sounds[0].levels.left_256, before.sounds[0].levels.left_256);
    EXPECT_EQ(behind.traces, 1);
    EXPECT_EQ(behind.sounds[0].direction, Direction::Ahead);
    EXPECT_EQ(before.sounds[0].direction, Direction::Behind);
}

/// Past a column, a step of 4 units each: what comes from all over an area goes round it.
TEST(Audible, AnAreaIsNeitherMuffledNorMuchSofterBehindAColumn) {
    const ToyGame game(with_column());
    for (const Sound sound : {Sound::Rain, Sound::Wind, Sound::Water, Sound::Lava}) {
        double before_db = 0;
        for (int y = -80; y <= 80; y += 4) {
            const Audible audible = audible_now(game, {area_at(sound, 80, -100, 280, 100)}, listener_at(20, y));
            ASSERT_EQ(audible.sounds.size(), 1u);
            const VoiceLevels levels = audible.sounds[0].levels;
            EXPECT_FALSE(levels.is_muffled) << y;
            if (y == 4) {
                EXPECT_GT(levels.left_256, levels.right_256) << "the nearest place in sight is on the left";
            }
            const double db = 20 * std::log10(std::hypot(levels.left_256, levels.right_256));
            EXPECT_NEAR(db, y > -80 ? before_db : db, 2.5) << y;
            before_db = db;
            EXPECT_LE(audible.traces, static_cast<int>(kMostLinesOfASource));
        }
    }
    // The column does stand between: a sound of one place is behind it.
    const Audible one = audible_now(game, {source_at(Sound::Fire, 120, 0)}, listener_at(20, 0));
    EXPECT_TRUE(one.sounds[0].levels.is_muffled);
}

TEST(Audible, AnAreaBehindAWallIsMuffled) {
    const ToyGame game(with_wall());
    const Audible audible = audible_now(game, {area_at(Sound::Rain, 140, -100, 340, 100)});
    ASSERT_EQ(audible.sounds.size(), 1u);
    EXPECT_TRUE(audible.sounds[0].levels.is_muffled);
    EXPECT_EQ(audible.traces, static_cast<int>(kMostLinesOfASource));
}

/// What is heard of an area and of a place as one passes a column: by lines of at most four times ago.
TEST(Audible, OfLoopsThatAreKnownNoLinesAreTracedForFourTicks) {
    const ToyGame game(with_column());
    const std::vector<SoundSource> sources{area_at(Sound::Rain, 80, -100, 280, 100), source_at(Sound::Fire, 120, 0)};
    HeardFrom heard_from;
    std::int32_t traces = 0, all_traces = 0;
    bool is_muffled = false, has_changed = false;
    for (int tick = 0; tick < 80; ++tick) {
        const Listener ear = listener_at(20, 2 * tick - 80);
        heard_from.start();
        const Audible audible = audible_sounds(game.level, game.state, ear, sources, heard_from);
        const Audible now = audible_now(game, sources, ear);
        ASSERT_EQ(audible.sounds.size(), now.sounds.size());
        EXPECT_EQ(audible.traces == 0, tick % 4 != 0) << tick;
        for (std::size_t i = 0; tick % 4 == 0 && i < now.sounds.size(); ++i)
            EXPECT_EQ(audible.sounds[i].levels, now.sounds[i].levels) << tick;
        traces += audible.traces;
        all_traces += now.traces;
        for (const AudibleSound& sound : now.sounds) {
            if (sound.sound != Sound::Fire) continue;
            has_changed |= tick > 0 && sound.levels.is_muffled != is_muffled;
            is_muffled = sound.levels.is_muffled;
        }
    }
    EXPECT_TRUE(has_changed) << "the column comes between";
    EXPECT_LT(3 * traces, all_traces);
}

TEST(Audible, SoundsThatBeginAreTracedAtEachTick) {
    const ToyGame game(with_wall());
    const std::vector<SoundSource> one{source_at(Sound::GateStart, -300, 0, 46, 1)};
    HeardFrom heard_from;
    for (int tick = 0; tick < 8; ++tick) {
        heard_from.start();
        EXPECT_EQ(audible_sounds(game.level, game.state, kListener, one, heard_from).traces, 1) << tick;
    }
}

TEST(Audible, IsMuffledUnderWaterAllOfIt) {
    const ToyGame game(with_wall());
    Listener diver = kListener;
    diver.is_under_water = true;
    for (const AudibleSound& sound :
         audible_now(game, {source_at(Sound::GateStart, -300, 0, 46, 1), source_at(Sound::UnderWater, 0, 0)}, diver)
             .sounds)
        EXPECT_EQ(sound.levels.is_muffled, sound.sound != Sound::UnderWater);
}

TEST(Audible, OneVoiceForALoopHoweverManySound) {
    const ToyGame game(with_wall());
    std::vector<SoundSource> sources;
    for (int i = 0; i < 50; ++i) sources.push_back(source_at(Sound::Water, -100 - i, i % 2 == 0 ? 200 : -200));
    const Audible audible = audible_now(game, sources);
    ASSERT_EQ(audible.sounds.size(), 1u);
    EXPECT_LE(audible.traces, static_cast<int>(kMostSourcesOfALoop * kMostLinesOfASource));
    const VoiceLevels levels = audible.sounds[0].levels;
    EXPECT_NEAR(levels.left_256, levels.right_256, 2);  // each ear hears those on its side
}

TEST(Audible, HasNoMoreThanItsMostAndKeepsTheLoudest) {
    const ToyGame game(with_wall());
    std::vector<SoundSource> sources;
    for (int i = 0; i < 60; ++i)
        sources.push_back(source_at(Sound::GateStop, -10 * i, 0, 46, 1 + static_cast<std::uint32_t>(i)));
    const Audible audible = audible_now(game, sources);
    ASSERT_EQ(audible.sounds.size(), kMostAudible);
    for (const AudibleSound& sound : audible.sounds) EXPECT_LE(sound.serial, kMostAudible + 8);
}

// Of a slab across the line of sight.
ToyLevel with_shut_door() {
    ToyLevel toy;
    toy.add_model(floor_and({})).add_model({{200, -64, 0, 216, 64, 128}});
    toy.add_entity({{"classname", "func_door"}, {"model", "*1"}, {"angle", "-1"}});
    // The door's tree for lines: solid below the node's plane, wherever the line is.
    Node slab;
    slab.plane = PlaneIndex(0);
    slab.children = {NodeChild(LeafIndex(0)), NodeChild(LeafIndex(0))};
    toy.level.nodes.push_back(slab);
    toy.level.models[ModelIndex(1)].root = NodeChild(NodeIndex(1));
    return toy;
}

TEST(Audible, AShutDoorIsInTheWayOfOthersButNotOfItself) {
    const ToyGame game(with_shut_door());
    const Position far = world_vector(400, 0, 46), aside = world_vector(-400, 0, 46);
    EXPECT_FALSE(is_clear(game.level, game.state, kListener.ear, far, kWorldModel));
    EXPECT_TRUE(is_clear(game.level, game.state, kListener.ear, far, ModelIndex(1)));
    EXPECT_TRUE(is_clear(game.level, game.state, kListener.ear, aside, kWorldModel));
}

TEST(Audible, BarsAreNotInTheWayIfTheyHaveHolesAllAround) {
    for (const bool is_all_bars : {true, false}) {
        ToyLevel toy = with_shut_door();
        for (const char* name : {"{bars", "stone"}) {
            MipTexture texture;
            texture.name = name;
            toy.level.textures.push_back(texture);
        }
        IndexRange<Face>& faces = toy.level.models[ModelIndex(1)].faces;
        faces = {FaceIndex(static_cast<std::uint32_t>(toy.level.faces.count())), 2};
        for (const bool is_stone : {false, !is_all_bars}) {
            TexInfo mapping;
            mapping.texture = TextureIndex(is_stone ? 1 : 0);
            toy.level.texinfos.push_back(mapping);
            Face face;
            face.texinfo = TexInfoIndex(static_cast<std::uint32_t>(toy.level.texinfos.count() - 1));
            toy.level.faces.push_back(face);
        }
        const ToyGame game(std::move(toy));
        EXPECT_EQ(is_clear(game.level, game.state, kListener.ear, world_vector(400, 0, 46), kWorldModel), is_all_bars);
    }
}

}  // namespace
}  // namespace oblong::test
