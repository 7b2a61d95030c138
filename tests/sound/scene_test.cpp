#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>

#include "game/sound/captions.h"
#include "game/sound/sound_scene.h"
#include "tests/sound/walled_level.h"
#include "tests/support/script_checks.h"
#include "tests/support/toy_text.h"

namespace oblong::test {
namespace {

/// A level and what its player hears, in lines of text:
///
///     + func_door 200 -64 0 216 64 128      an entity, as toy_text.h has it; `door` is a usual one
///     own "it creaks"                       the last one has a sound of half a second, with this caption
///     water 100; fall 130                   water up to here on a deep floor; the player starts so high
///     listen 5                              hears after each fifth tick alone, as where pictures take so long
///     ahead 60; stand 300; at 220 0 24      ticks of walking or standing; a place to stand at
///     : slab_start = 2, traces = 0          how often a sound began in this line (loops: its ticks), and numbers
///     : said "heavy door"            a caption that was shown
class HeardGame {
  public:
    explicit HeardGame(const std::string& text) {
        std::int32_t height = 0, water_z = -30'000;
        std::vector<Words> entities;
        for (const ScriptLine& line : script_lines(text))
            for (const Words& words : line.actions) {
                if (words[0] == "+") entities.emplace_back(words.begin() + 1, words.end());
                if (words[0] == "door") entities.push_back(words_of("func_door 200 -64 0 216 64 128 angle=-1 wait=1"));
                if (words[0] == "own") own_of(entities.size() - 1, words.size() > 1 ? words[1] : "");
                if (words[0] == "fall") height = std::stoi(words.at(1));
                if (words[0] == "water") water_z = std::stoi(words.at(1));
                if (words[0] == "listen") listens_each_ = std::stoi(words.at(1));
            }
        ToyLevel toy(water_z);
        toy.add_model(water_z > 0 ? std::vector<Solid>{{-2048, -2048, -264, 2048, 2048, -200}} : floor_and({}));
        for (const Words& entity : entities) add_entity(toy, EntityText(entity));
        own_.by_entity.resize(entities.size() + 1, LevelSounds::kNone);  // the last is the player's start
        game = std::make_unique<ToyGame>(std::move(toy), height);
        scene = std::make_unique<SoundScene>(game->level, own_.sounds.empty() ? nullptr : &own_);
    }
    void run(const ScriptLine& line) {
        begun_.clear(), own_begun = 0;
        for (const Words& words : line.actions) {
            if (words[0] == "ahead" || words[0] == "stand")
                play(std::stoi(words.at(1)), words[0] == "ahead" ? kAhead : kStand);
            if (words[0] != "at") continue;
            Player& player = game->state.player;
            player.position = world_vector(std::stoi(words.at(1)), std::stoi(words.at(2)), std::stoi(words.at(3)));
            player.velocity = {};
        }
        for (const Words& words : line.checks)
            if (words[0] == "said")
                EXPECT_TRUE(named_.contains(words.at(1))) << words[1];
            else
                EXPECT_TRUE(holds(words, number(words[0])));
    }
    void play(int ticks, const TickInput& input) {
        for (int i = 0; i < ticks; ++i) {
            const GameState before = game->state;
            const TickReport report = step(game->level, game->state, input);
            scene->note_tick(before, game->state, report, game->state.tick % listens_each_ == 0);
            const bool was_shown = !captions_.lines().empty();
            captions_.note_tick(scene->audible().sounds);
            shown_ += !was_shown && !captions_.lines().empty();
            for (const std::string& line : captions_.lines()) named_.insert(line);
            for (const AudibleSound& sound : scene->audible().sounds) note(sound);
        }
    }

    std::unique_ptr<ToyGame> game;
    std::unique_ptr<SoundScene> scene;
    int own_begun = 0;

  private:
    void own_of(std::size_t entity, const std::string& caption) {
        own_.by_entity.assign(entity + 1, LevelSounds::kNone);
        own_.by_entity.back() = 0;
        own_.sounds = {{"own.wav", "", {1000, std::vector<std::int16_t>(500)}}};
        captions_ = Captions({}, {caption});
    }
    void note(const AudibleSound& sound) {
        const bool is_own = sound.own != LevelSounds::kNone;
        if (is_own && first_own_ == 0) first_own_ = sound.serial;
        own_ticks_ += is_own && sound.serial == first_own_;
        if (sound.serial != 0 && !serials_.insert(sound.serial).second) return;
        own_begun += is_own;
        if (!is_own) begun_.push_back(sound.sound);
    }
    double number(const std::string& name) const {
        const auto count = [&](Sound sound) {
            return static_cast<int>(std::count(begun_.begin(), begun_.end(), sound));
        };
        if (name == "own") return own_begun;
        if (name == "own_ticks") return own_ticks_;  // of the first one
        if (name == "all") return static_cast<int>(begun_.size());
        if (name == "x") return game->x();
        if (name == "missed_steps") return game->x() / 104 - count(Sound::StepStone);
        if (name == "missed_stops") return count(Sound::SlabStart) - count(Sound::SlabStop);
        if (name == "heard") return static_cast<int>(scene->audible().sounds.size());
        if (name == "traces") return scene->audible().traces;
        if (name == "times_shown") return shown_;  // how often a caption came where none was
        if (name == "shown") return static_cast<int>(captions_.lines().size());
        if (name == "captions") return static_cast<int>(named_.size());
        if (name == "damage") return game->state.harm.damage;
        if (name == "lost") return game->state.is_lost();
        if (name == "depth") return static_cast<int>(game->state.player.depth);
        return count(find_sound(name).value());
    }

    LevelSounds own_;
    Captions captions_;
    std::int64_t listens_each_ = 1;
    int own_ticks_ = 0, shown_ = 0;
    std::vector<Sound> begun_;
    std::uint32_t first_own_ = 0;
    std::set<std::uint32_t> serials_;
    std::set<std::string> named_;
};

constexpr Script kHeard[] = {
    {"StepsFollowTheWay", R"(
        stand 35: all = 0
        ahead 105: missed_steps = 0 +- 1
        stand 35: step_stone < 2        # slides to a halt
    )"},
    // The caption ends though the steps go on.
    {"StepsAreNamedOnceInALongWalk",
     "ahead 170: times_shown = 1, shown = 0, captions = 1, said \"footsteps on stone\""},
    {"LandingIsHeardAfterAFall", "fall 200; stand 70: land = 1 \n ahead 105: missed_steps = 0 +- 1"},
    {"LandingIsNotHeardAfterAStep", "fall 10; stand 70: land = 0"},
    // What begins while nobody listens goes on.
    {"NothingIsMissedWherePicturesTakeTicks",
     "listen 5; fall 200; stand 70: land = 1 \n ahead 105: missed_steps = 0 +- 1"},
    // It opens as the player comes near.
    {"MoversStartMoveAndStop", R"(
        door; ahead 60; stand 300: slab_start > 0, missed_stops = 0, slab_move > 30, heard = 0, said "heavy door"
    )"},
    {"MoversThatTurnSoundAsThoseThatMove", R"(
        + func_door_rotating 200 -64 0 216 64 128 angle=-1 wait=1
        ahead 60; stand 300: slab_start = 2, slab_stop = 2, slab_move = 63 +- 4     # twice 90 degrees, 100 a second
    )"},
    {"MoversAtRestCostNothing", "door; stand 10: traces = 0, heard = 0"},
    {"WaterIsHeardInAndUnder", R"(
        water 100; fall 130; stand 40: water_in = 1, depth = 3, under_water > 0
        ahead 70: swim > 0, step_stone = 0
    )"},
    // One sound for one event.
    {"ItemsRing", R"(
        + item_lens origin="120 0 24"; + item_key1 origin="320 0 24"
        ahead 120: lens = 1, key = 1, message = 0, said "a lens rings"
    )"},
    {"AmbienceIsHeardWhereItIsAndNamedWhenItBegins", R"(
        + light_torch_small_walltorch origin="600 100 40"; stand 20: all = 0
        ahead 70: fire > 0, said "a flame, ahead"
    )"},
    // What a level's entities sound like by their key "noise".
    {"OwnSoundsOfADoorAreHeardAsItBeginsInPlaceOfAllItsOwn", R"(
        door; own "it creaks"
        ahead 60; stand 300: own > 1, slab_start = 0, slab_move = 0, slab_stop = 0, said "it creaks"
    )"},
    {"OwnSoundsWithoutACaptionHaveThatOfWhatTheyReplace", "door; own; ahead 60: said \"heavy door\""},
    {"OwnSoundsLastAsLongAsTheirSamples", "door; own x; ahead 60: own > 0, own_ticks = 17.5 +- 1"},
    {"OwnSoundsOfATriggerAreHeardInPlaceOfItsMessage",
     "+ trigger_once 200 -64 0 240 64 128 message=Hm; own; ahead 100: own = 1, message = 0"},
    {"OwnSoundsOfATriggerAreHeardEachTimeItFires",
     "+ trigger_multiple 200 -64 0 240 64 128 wait=0.1; own; ahead 100: own > 1"},
    {"OwnSoundsOfTheEndAreHeardInItsPlace",
     "+ trigger_changelevel 200 -64 0 240 64 128; own; ahead 100: own = 1, level_end = 0"},
    {"OwnSoundsOfATriggerThatIsRemovedAreNotHeard", R"(
        + trigger_once 100 -64 0 120 64 128 killtarget=gone; + trigger_once 600 -64 0 640 64 128 targetname=gone
        own; ahead 150: x > 700, own = 0     # through both
    )"},
    {"OwnSoundsOfATeleporterReplaceItsSound", R"(
        + info_teleport_destination targetname=there origin="-500 0 30"
        + trigger_teleport 200 -64 0 240 64 128 target=there; own; ahead 50: x < -100, own = 1, teleport = 0
    )"},
    {"OwnSoundsOfATeleporterWithACaptionReplaceItToo", R"(
        + info_teleport_destination targetname=there origin="-500 0 30"
        + trigger_teleport 200 -64 0 240 64 128 target=there; own "you fly"; ahead 50: x < -100, own = 1, teleport = 0
    )"},
    {"WhoIsHurtHearsItAndWhoDiesHearsNoEnd", R"(
        + worldspawn health=50; + trigger_hurt 200 -64 0 240 64 128 dmg=25; ahead 45: damage = 25, hurt = 1
        at 220 0 24; stand 40: lost = 1, hurt = 1, level_end = 0
    )"},
};
void hear(const Script& script) {
    HeardGame heard(script.text);
    for (const ScriptLine& line : script_lines(script.text)) {
        SCOPED_TRACE(line.text);
        heard.run(line);
    }
}
OBLONG_SCRIPTS(Heard, kHeard, hear);

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

TEST(Steps, KnowTheirGroundByTheNameOfItsTexture) {
    for (const auto& [texture, sound] : {std::pair{"wood_planks", Sound::StepWood},
                                         {"iron_grate", Sound::StepMetal},
                                         {"{grate", Sound::StepMetal},
                                         {"earth", Sound::StepEarth},
                                         {"carpet", Sound::StepCarpet},
                                         {"stone_floor", Sound::StepStone},
                                         {"GROUND1_6", Sound::StepEarth},
                                         {"", Sound::StepStone}})
        EXPECT_EQ(step_sound_of_texture(texture), sound) << texture;
}

TEST(Movers, SoundAsTheirKind) {
    for (const auto& [its_class, sound] : {std::pair{"func_plat", Sound::LiftMove}, {"func_train", Sound::TrainMove}}) {
        const HeardGame heard("+ " + std::string(its_class) + " 200 -64 0 216 64 128");
        EXPECT_EQ(mover_sounds(*heard.game->level.bsp, ModelIndex(1)).move, sound) << its_class;
    }
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

// However it is fired: one that fires once, a relay, a counter, by what the player walks into.
TEST(OwnSounds, OfATriggerAreHeardWhereAnotherFiresIt) {
    const std::string near = "+ trigger_once 100 -64 0 102 64 128 target=next; ",
                      far = "+ trigger_once 200 -64 0 202 64 128 target=next; ";
    for (const auto& [fired, times] : {std::pair{"trigger_once -600 900 0 -580 940 128", 1},
                                       {"trigger_once -600 900 0 -580 940 128 spawnflags=1 delay=60", 1},
                                       {"trigger_relay", 2},
                                       {"trigger_counter count=2", 1},
                                       {"trigger_counter count=3", 0}}) {
        HeardGame heard(near + far + "+ " + fired + " targetname=next; own");
        heard.play(150, kAhead);
        ASSERT_GT(heard.game->x(), 300) << "through both";
        EXPECT_EQ(heard.own_begun, times) << fired;
    }
}

// Quieter with the distance, from its side, and not beyond 900 units; a relay is heard everywhere.
TEST(OwnSounds, OfAPlaceAreHeardFromThere) {
    const auto levels_from = [](const std::string& entity) {
        HeardGame heard("+ trigger_once 200 -64 0 240 64 128 target=next; + " + entity + " targetname=next; own");
        VoiceLevels loudest;
        for (int tick = 0; tick < 60; ++tick) {
            heard.play(1, kAhead);
            for (const AudibleSound& sound : heard.scene->audible().sounds)
                if (sound.own != LevelSounds::kNone && sound.levels.left_256 > loudest.left_256) loudest = sound.levels;
        }
        return loudest;
    };
    const VoiceLevels near = levels_from("play_sound_triggered origin=\"200 200 46\""),
                      far = levels_from("play_sound_triggered origin=\"200 700 46\""),
                      relay = levels_from("trigger_relay origin=\"200 2000 46\"");
    EXPECT_GT(near.left_256, 2 * near.right_256);
    EXPECT_GT(near.left_256, 2 * far.left_256);
    EXPECT_GT(far.left_256, 0);
    EXPECT_EQ(levels_from("play_sound_triggered origin=\"200 1500 46\"").left_256, 0);
    EXPECT_EQ(relay.left_256, relay.right_256);
    EXPECT_GT(relay.left_256, 0);
}

// A relay with `found` plays the sound of an item by its number in the order of taking.
TEST(OwnSounds, OfItemsAreHeardInTheOrderFound) {
    for (const bool is_first : {false, true})
        for (const int found : {1, 2, 3}) {
            const std::string near = "+ item_lens origin=\"90 0 24\"; ", far = "+ item_lens origin=\"180 0 24\"; ";
            HeardGame heard("+ trigger_once 300 -64 0 320 64 128 target=tune; + trigger_relay targetname=tune found=" +
                            std::to_string(found) + "; " + (is_first ? far + near : near + far) + "own");
            heard.play(150, kAhead);
            ASSERT_GT(heard.game->x(), 320) << "through all";
            EXPECT_EQ(heard.own_begun, 1 + (found == (is_first ? 1 : 2))) << found << is_first;
        }
}

}  // namespace
}  // namespace oblong::test
