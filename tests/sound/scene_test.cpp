#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "game/sound/captions.h"
#include "game/sound/sound_scene.h"
#include "tests/game/logic_level.h"
#include "tests/sound/walled_level.h"

namespace oblong::test {
namespace {

// Plays a game and notes what begins in each tick.
struct HeardGame {
    explicit HeardGame(ToyLevel toy, std::int32_t height = 0) : game(std::move(toy), height), scene(game.level) {}
    /// The last entity but the player's start has a sound of its own, of half a second.
    HeardGame(ToyLevel toy, std::int32_t height, const std::string& caption)
        : own(own_of_last(toy)), game(std::move(toy), height), scene(game.level, &own), captions({}, {caption}) {}

    static LevelSounds own_of_last(const ToyLevel& toy) {
        LevelSounds sounds;
        sounds.by_entity.assign(toy.level.entities.size() + 1, LevelSounds::kNone);
        sounds.by_entity[toy.level.entities.size() - 1] = 0;
        sounds.sounds = {{"own.wav", "", {1000, std::vector<std::int16_t>(500)}}};
        return sounds;
    }

    void play(int ticks, const TickInput& input) {
        for (int i = 0; i < ticks; ++i) {
            const GameState before = game.state;
            const TickReport report = step(game.level, game.state, input);
            scene.note_tick(before, game.state, report, game.state.tick % listens_each == 0);
            captions.note_tick(scene.audible().sounds);
            for (const std::string& line : captions.lines()) lines.insert(line);
            for (const AudibleSound& sound : scene.audible().sounds) note(sound);
        }
    }
    void note(const AudibleSound& sound) {
        if (sound.own != LevelSounds::kNone)
            own_begun += serials.insert(sound.serial).second;
        else if (sound.serial == 0 || serials.insert(sound.serial).second)
            begun.push_back(sound.sound);
    }
    int count(Sound sound) const { return static_cast<int>(std::count(begun.begin(), begun.end(), sound)); }

    LevelSounds own;
    int own_begun = 0;
    std::int64_t listens_each = 1;  ///< as many ticks as a picture takes
    ToyGame game;
    SoundScene scene;
    Captions captions;
    std::vector<Sound> begun;  // loops: in each tick
    std::set<std::uint32_t> serials;
    std::set<std::string> lines;
};

ToyLevel plain() {
    ToyLevel toy;
    return toy.add_model(floor_and({}));
}

ToyLevel with_door(const char* class_name = "func_door") {
    ToyLevel toy = plain();
    toy.add_model({{200, -64, 0, 216, 64, 128}});
    return toy.add_entity({{"classname", class_name}, {"model", "*1"}, {"angle", "-1"}, {"wait", "1"}});
}

// Each is held against the others, so that they are bounded.
TEST(Starts, OfVeryManyMoversAreAFew) {
    LogicLevel source;
    source.add("trigger_once", {-50, -50, 0, 50, 50, 64}, {{"target", "d"}});
    for (int i = 0; i < 400; ++i)
        source.add("func_door", {i * 50 - 10'000, 500, 0, i * 50 - 9990, 510, 10},
                   {{"angle", "-1"}, {"targetname", "d"}, {"spawnflags", "4"}});
    LogicGame game(source);
    SoundStarts starts(game.level);
    std::size_t most = 0;
    for (int tick = 0; tick < 5; ++tick) {
        const GameState before = game.state;
        const TickReport report = step(game.level, game.state, kStand);
        std::vector<SoundSource> sources;
        starts.note_tick(before, game.state, report, sources);
        most = std::max(most, sources.size());
    }
    EXPECT_EQ(most, SoundStarts::kMost);
}

TEST(Steps, FollowTheWay) {
    HeardGame heard(plain());
    heard.play(35, kStand);
    EXPECT_TRUE(heard.begun.empty());
    heard.play(105, kAhead);
    EXPECT_NEAR(heard.count(Sound::StepStone), heard.game.x() / 104, 1);
    const int steps = heard.count(Sound::StepStone);
    heard.play(35, kStand);
    EXPECT_LE(heard.count(Sound::StepStone), steps + 1);  // slides to a halt
}

TEST(Steps, AreNamedOnceInALongWalk) {
    HeardGame heard(plain());
    int shown = 0;
    for (int i = 0; i < 170; ++i) {
        const bool was_shown = !heard.captions.lines().empty();
        heard.play(1, kAhead);
        shown += !was_shown && !heard.captions.lines().empty();
    }
    EXPECT_EQ(shown, 1);
    EXPECT_TRUE(heard.captions.lines().empty()) << "the caption ends though the steps go on";
    EXPECT_EQ(heard.lines, std::set<std::string>{"footsteps on stone"});
}

TEST(Steps, KnowTheirGroundByTheNameOfItsTexture) {
    EXPECT_EQ(step_sound_of_texture("wood_planks"), Sound::StepWood);
    EXPECT_EQ(step_sound_of_texture("iron_grate"), Sound::StepMetal);
    EXPECT_EQ(step_sound_of_texture("{grate"), Sound::StepMetal);
    EXPECT_EQ(step_sound_of_texture("earth"), Sound::StepEarth);
    EXPECT_EQ(step_sound_of_texture("carpet"), Sound::StepCarpet);
    EXPECT_EQ(step_sound_of_texture("stone_floor"), Sound::StepStone);
    EXPECT_EQ(step_sound_of_texture("GROUND1_6"), Sound::StepEarth);
    EXPECT_EQ(step_sound_of_texture(""), Sound::StepStone);
}

TEST(Landing, IsHeardAfterAFallAndNotAfterAStep) {
    HeardGame high(plain(), 200);
    high.play(70, kStand);
    EXPECT_EQ(high.count(Sound::Land), 1);
    HeardGame low(plain(), 10);
    low.play(70, kStand);
    EXPECT_EQ(low.count(Sound::Land), 0);
}

// What begins while nobody listens goes on.
TEST(Hearing, MissesNothingWherePicturesTakeTicks) {
    for (const std::int64_t ticks : {1, 5}) {
        HeardGame heard(plain(), 200);
        heard.listens_each = ticks;
        heard.play(70, kStand);
        EXPECT_EQ(heard.count(Sound::Land), 1);
        heard.play(105, kAhead);
        EXPECT_NEAR(heard.count(Sound::StepStone), heard.game.x() / 104, 1);
    }
}

TEST(Movers, StartMoveAndStop) {
    HeardGame heard(with_door());
    heard.play(60, kAhead);  // near: it opens
    heard.play(300, kStand);
    EXPECT_GE(heard.count(Sound::SlabStart), 1);
    EXPECT_EQ(heard.count(Sound::SlabStart), heard.count(Sound::SlabStop));
    EXPECT_GT(heard.count(Sound::SlabMove), 30);
    EXPECT_TRUE(heard.scene.audible().sounds.empty());
    EXPECT_EQ(heard.lines.count("heavy door, ahead") + heard.lines.count("heavy door"), 1u);
}

TEST(Movers, ThatTurnSoundAsThoseThatMove) {
    HeardGame heard(with_door("func_door_rotating"));
    heard.play(60, kAhead);
    heard.play(300, kStand);
    EXPECT_EQ(heard.count(Sound::SlabStart), 2);
    EXPECT_EQ(heard.count(Sound::SlabStop), 2);
    EXPECT_NEAR(heard.count(Sound::SlabMove), 2 * 0.9 * kTicksPerSecond, 4) << "90 degrees, 100 a second";
}

TEST(Movers, SoundAsTheirKind) {
    HeardGame lift(with_door("func_plat"));
    EXPECT_EQ(mover_sounds(*lift.game.level.bsp, ModelIndex(1)).move, Sound::LiftMove);
    HeardGame train(with_door("func_train"));
    EXPECT_EQ(mover_sounds(*train.game.level.bsp, ModelIndex(1)).move, Sound::TrainMove);
}

TEST(Movers, AtRestCostNothing) {
    HeardGame heard(with_door());
    heard.play(10, kStand);
    EXPECT_EQ(heard.scene.audible().traces, 0);
    EXPECT_TRUE(heard.scene.audible().sounds.empty());
}

TEST(Water, IsHeardInOutAndUnder) {
    ToyLevel toy(100);
    toy.add_model({{-2048, -2048, -264, 2048, 2048, -200}});
    HeardGame heard(std::move(toy), 130);
    heard.play(40, kStand);
    EXPECT_EQ(heard.count(Sound::WaterIn), 1);
    EXPECT_EQ(heard.game.state.player.depth, Depth::Eyes);
    EXPECT_GT(heard.count(Sound::UnderWater), 0);
    heard.play(70, kAhead);
    EXPECT_GT(heard.count(Sound::Swim), 0);
    EXPECT_EQ(heard.count(Sound::StepStone), 0);
}

TEST(Items, Ring) {
    ToyLevel toy = plain();
    toy.add_entity({{"classname", "item_lens"}, {"origin", "120 0 24"}});
    toy.add_entity({{"classname", "item_key1"}, {"origin", "320 0 24"}});
    HeardGame heard(std::move(toy));
    heard.play(120, kAhead);
    EXPECT_EQ(heard.count(Sound::Lens), 1);
    EXPECT_EQ(heard.count(Sound::Key), 1);
    EXPECT_EQ(heard.count(Sound::Message), 0);  // one sound for one event
    EXPECT_EQ(heard.lines.count("a lens rings"), 1u);
}

TEST(Ambience, IsHeardWhereItIsAndNamedWhenItBegins) {
    ToyLevel toy = plain();
    toy.add_entity({{"classname", "light_torch_small_walltorch"}, {"origin", "600 100 40"}});
    HeardGame heard(std::move(toy));
    heard.play(20, kStand);
    EXPECT_TRUE(heard.begun.empty());
    heard.play(70, kAhead);
    EXPECT_GT(heard.count(Sound::Fire), 0);
    EXPECT_EQ(heard.lines.count("a flame, ahead"), 1u);
}

TEST(Captions, SayFromWhere) {
    EXPECT_EQ(caption_of(row_of(Sound::DoorStart).caption, Direction::Left), "door, to the left");
    EXPECT_EQ(caption_of(row_of(Sound::Wind).caption, Direction::Here), "wind");
    EXPECT_EQ(caption_of(row_of(Sound::MenuMove).caption, Direction::Left), "");
}

TEST(Captions, AreFewAndEnd) {
    Captions captions;
    std::vector<AudibleSound> sounds;
    for (std::uint32_t i = 0; i < 6; ++i)
        sounds.push_back({static_cast<Sound>(static_cast<std::uint32_t>(Sound::DoorStart) + 3 * i),
                          0,
                          i + 1,
                          {90, 90, false},
                          Direction::Here});
    captions.note_tick(sounds);
    EXPECT_EQ(captions.lines().size(), Captions::kMostLines);
    for (int i = 0; i < 104; ++i) captions.note_tick(sounds);
    EXPECT_EQ(captions.lines().size(), Captions::kMostLines);
    captions.note_tick(sounds);
    EXPECT_TRUE(captions.lines().empty());
}

// What a level's entities sound like by their key "noise".
TEST(OwnSounds, OfADoorAreHeardAsItBeginsInPlaceOfAllItsOwn) {
    HeardGame heard(with_door(), 0, "it creaks");
    heard.play(60, kAhead);
    heard.play(300, kStand);
    EXPECT_GE(heard.own_begun, 2) << "there and back";
    EXPECT_EQ(heard.count(Sound::SlabStart) + heard.count(Sound::SlabMove) + heard.count(Sound::SlabStop), 0);
    EXPECT_EQ(heard.lines.count("it creaks, ahead") + heard.lines.count("it creaks"), 1u);
}

TEST(OwnSounds, WithoutACaptionHaveThatOfWhatTheyReplace) {
    HeardGame heard(with_door(), 0, "");
    heard.play(60, kAhead);
    EXPECT_EQ(heard.lines.count("heavy door, ahead") + heard.lines.count("heavy door"), 1u);
}

TEST(OwnSounds, LastAsLongAsTheirSamples) {
    HeardGame heard(with_door(), 0, "x");
    const auto is_heard = [&] {
        const auto& sounds = heard.scene.audible().sounds;
        return std::any_of(sounds.begin(), sounds.end(),
                           [](const auto& sound) { return sound.own != LevelSounds::kNone; });
    };
    for (int tick = 0; tick < 60 && !is_heard(); ++tick) heard.play(1, kAhead);
    int ticks = 0;
    for (; ticks < 60 && is_heard(); ++ticks) heard.play(1, kStand);
    EXPECT_NEAR(ticks, 0.5 * kTicksPerSecond, 1);
}

ToyLevel with_trigger(const std::string& class_name, std::vector<std::pair<std::string, std::string>> pairs) {
    ToyLevel toy = plain();
    toy.add_model({{200, -64, 0, 240, 64, 128}});
    pairs.insert(pairs.begin(), {{"classname", class_name}, {"model", "*1"}});
    return toy.add_entity(std::move(pairs));
}

TEST(OwnSounds, OfATriggerAreHeardEachTimeItFires) {
    HeardGame once(with_trigger("trigger_once", {{"message", "Hm"}}), 0, "");
    once.play(100, kAhead);
    EXPECT_EQ(once.own_begun, 1);
    EXPECT_EQ(once.count(Sound::Message), 0) << "in its place";
    HeardGame again(with_trigger("trigger_multiple", {{"wait", "0.1"}}), 0, "");
    again.play(100, kAhead);
    EXPECT_GE(again.own_begun, 2);
    HeardGame exit(with_trigger("trigger_changelevel", {}), 0, "");
    exit.play(100, kAhead);
    EXPECT_EQ(exit.own_begun, 1);
    EXPECT_EQ(exit.count(Sound::LevelEnd), 0);
}

TEST(SoundScene, WhoIsHurtHearsItAndWhoDiesHearsNoEnd) {
    ToyLevel toy = plain();
    toy.add_model({{200, -64, 0, 240, 64, 128}});
    toy.add_entity({{"classname", "worldspawn"}, {"health", "50"}});
    toy.add_entity({{"classname", "trigger_hurt"}, {"model", "*1"}, {"dmg", "25"}});
    HeardGame heard(std::move(toy));
    heard.play(45, kAhead);
    EXPECT_EQ(heard.game.state.harm.damage, 25);
    EXPECT_EQ(heard.count(Sound::Hurt), 1);
    heard.game.state.player.position = world_vector(220, 0, 24);
    heard.game.state.player.velocity = {};
    heard.play(40, kStand);
    EXPECT_TRUE(heard.game.state.is_lost());
    EXPECT_EQ(heard.count(Sound::Hurt), 2);
    EXPECT_EQ(heard.count(Sound::LevelEnd), 0);
}

// However it is fired: one that fires once, a relay, a counter, by what the player walks into.
TEST(OwnSounds, OfATriggerAreHeardWhereAnotherFiresIt) {
    using Pairs = std::vector<std::pair<std::string, std::string>>;
    const std::pair<std::string, std::string> name{"targetname", "next"};
    for (const auto& [fired, times] :
         {std::pair<Pairs, int>{{{"classname", "trigger_once"}, {"model", "*2"}, name}, 1},
          {{{"classname", "trigger_once"}, {"model", "*2"}, name, {"spawnflags", "1"}, {"delay", "60"}}, 1},
          {{{"classname", "trigger_relay"}, name}, 2},
          {{{"classname", "trigger_counter"}, name, {"count", "2"}}, 1},
          {{{"classname", "trigger_counter"}, name, {"count", "3"}}, 0}}) {
        ToyLevel toy = plain();
        toy.add_model({{100, -64, 0, 102, 64, 128}}).add_model({{-600, 900, 0, -580, 940, 128}});
        toy.add_model({{200, -64, 0, 202, 64, 128}});
        toy.add_entity({{"classname", "trigger_once"}, {"model", "*1"}, {"target", "next"}});
        toy.add_entity({{"classname", "trigger_once"}, {"model", "*3"}, {"target", "next"}});
        HeardGame heard(toy.add_entity(fired), 0, "");
        heard.play(150, kAhead);
        ASSERT_GT(heard.game.x(), 300) << "through both";
        EXPECT_EQ(heard.own_begun, times) << fired.front().second;
    }
}

// Quieter with the distance, from its side, and not beyond 900 units; a relay is heard everywhere.
TEST(OwnSounds, OfAPlaceAreHeardFromThere) {
    const auto levels_from = [](const char* class_name, const char* origin) {
        ToyLevel toy = with_trigger("trigger_once", {{"target", "next"}});
        toy.add_entity({{"classname", class_name}, {"targetname", "next"}, {"origin", origin}});
        HeardGame heard(std::move(toy), 0, "");
        VoiceLevels loudest;
        for (int tick = 0; tick < 60; ++tick) {
            heard.play(1, kAhead);
            for (const AudibleSound& sound : heard.scene.audible().sounds)
                if (sound.own != LevelSounds::kNone && sound.levels.left_256 > loudest.left_256) loudest = sound.levels;
        }
        return loudest;
    };
    const VoiceLevels near = levels_from("play_sound_triggered", "200 200 46"),
                      far = levels_from("play_sound_triggered", "200 700 46"),
                      relay = levels_from("trigger_relay", "200 2000 46");
    EXPECT_GT(near.left_256, 2 * near.right_256);
    EXPECT_GT(near.left_256, 2 * far.left_256);
    EXPECT_GT(far.left_256, 0);
    EXPECT_EQ(levels_from("play_sound_triggered", "200 1500 46").left_256, 0);
    EXPECT_EQ(relay.left_256, relay.right_256);
    EXPECT_GT(relay.left_256, 0);
}

// A relay with `found` plays the sound of an item by its number in the order of taking.
TEST(OwnSounds, OfItemsAreHeardInTheOrderFound) {
    for (const bool is_first : {false, true})
        for (const int found : {1, 2, 3}) {
            ToyLevel toy = plain();
            toy.add_model({{300, -64, 0, 320, 64, 128}});
            toy.add_entity({{"classname", "trigger_once"}, {"model", "*1"}, {"target", "tune"}});
            toy.add_entity({{"classname", "trigger_relay"}, {"targetname", "tune"}, {"found", std::to_string(found)}});
            toy.add_entity({{"classname", "item_lens"}, {"origin", is_first ? "180 0 24" : "90 0 24"}});
            toy.add_entity({{"classname", "item_lens"}, {"origin", is_first ? "90 0 24" : "180 0 24"}});
            HeardGame heard(std::move(toy), 0, "");
            heard.play(150, kAhead);
            ASSERT_GT(heard.game.x(), 320) << "through all";
            EXPECT_EQ(heard.own_begun, 1 + (found == (is_first ? 1 : 2))) << found << is_first;
        }
}

TEST(OwnSounds, OfATriggerThatIsRemovedAreNotHeard) {
    ToyLevel toy = plain();
    toy.add_model({{100, -64, 0, 120, 64, 128}}).add_model({{600, -64, 0, 640, 64, 128}});
    toy.add_entity({{"classname", "trigger_once"}, {"model", "*1"}, {"killtarget", "gone"}});
    toy.add_entity({{"classname", "trigger_once"}, {"model", "*2"}, {"targetname", "gone"}});
    HeardGame heard(std::move(toy), 0, "");
    heard.play(150, kAhead);
    ASSERT_GT(heard.game.x(), 700) << "through both";
    EXPECT_EQ(heard.own_begun, 0);
}

TEST(OwnSounds, OfATeleporterReplaceItsSound) {
    for (const char* caption : {"", "you fly"}) {
        ToyLevel toy = with_trigger("info_null", {});
        toy.level.entities.pop_back();
        toy.add_entity({{"classname", "info_teleport_destination"}, {"targetname", "there"}, {"origin", "-500 0 30"}});
        toy.add_entity({{"classname", "trigger_teleport"}, {"model", "*1"}, {"target", "there"}});
        HeardGame heard(std::move(toy), 0, caption);
        for (int tick = 0; tick < 60 && heard.game.x() > -100; ++tick) heard.play(1, kAhead);
        EXPECT_LT(heard.game.x(), -100);
        EXPECT_EQ(heard.own_begun, 1);
        EXPECT_EQ(heard.count(Sound::Teleport), 0);
    }
}

}  // namespace
}  // namespace oblong::test
