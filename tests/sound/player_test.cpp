#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "engine/io/files.h"
#include "engine/sound/sound.h"
#include "game/sound/game_sound.h"
#include "tests/sound/walled_level.h"
#include "tests/support/folders.h"
#include "tests/support/programs.h"

namespace oblong::test {
namespace {

/// Plays nothing, and remembers what it was asked for.
class RecordedOutput final : public SoundOutput {
  public:
    struct Voice {
        SoundNumber sound;
        bool is_loop;
        VoiceLevels levels;
    };

    SoundNumber add_sound(std::span<const std::int16_t>, std::int32_t) override { return sounds++; }
    VoiceNumber start(SoundNumber sound, bool is_loop, const VoiceLevels& levels) override {
        voices[++starts] = {sound, is_loop, levels};
        return starts;
    }
    bool is_playing(VoiceNumber voice) const override { return voices.contains(voice); }
    void adjust(VoiceNumber voice, const VoiceLevels& levels) override {
        ++adjusts;
        voices.at(voice).levels = levels;
    }
    void stop(VoiceNumber voice) override { voices.erase(voice); }
    void hold_voices(bool now_held) override { are_held = now_held; }
    void play_music(std::span<const std::uint8_t> file, std::int32_t volume_256) override {
        music_size = file.size();
        music_volume_256 = volume_256;
    }
    void set_music_volume(std::int32_t volume_256) override { music_volume_256 = volume_256; }
    void stop_music() override { music_size = 0; }

    SoundNumber sounds = 0;
    VoiceNumber starts = 0;
    int adjusts = 0;
    std::map<VoiceNumber, Voice> voices;
    bool are_held = false;
    std::size_t music_size = 0;
    std::int32_t music_volume_256 = 0;
};

const std::string kAssets = build_folder() + "/assets", kSounds = kAssets + "/sounds",
                  kTitleMusic = kAssets + "/music/title.mod";

AudibleSound heard(Sound sound, std::uint32_t serial, std::int32_t level_256) {
    return {sound, 0, serial, {level_256, level_256, false}, Direction::Here};
}

TEST(SoundPlayer, StartsChangesAndStopsByDifferences) {
    RecordedOutput output;
    SoundPlayer player(output, {kSounds});
    EXPECT_GT(output.sounds, 50);
    const std::vector<AudibleSound> both{heard(Sound::Wind, 0, 100), heard(Sound::Button, 7, 200)};
    player.play(both, 256);
    ASSERT_EQ(output.voices.size(), 2u);
    player.play(both, 256);
    EXPECT_EQ(output.starts, 2);
    EXPECT_EQ(output.adjusts, 0);
    player.play(both, 128);
    EXPECT_EQ(output.adjusts, 2);
    EXPECT_EQ(output.voices.begin()->second.levels.left_256, 50);
    player.play(std::span(both).first(1), 128);
    ASSERT_EQ(output.voices.size(), 1u);
    EXPECT_TRUE(output.voices.begin()->second.is_loop);
    player.play({}, 128);
    EXPECT_TRUE(output.voices.empty());
}

TEST(SoundPlayer, GivesNoVoiceToWhatHasNoVolume) {
    RecordedOutput output;
    SoundPlayer player(output, {kSounds});
    const std::vector<AudibleSound> faint{heard(Sound::Wind, 0, 1)};
    player.play(faint, 100);
    player.play_once(Sound::MenuMove, 0);
    EXPECT_EQ(output.starts, 0);
}

// A game's sound whose output a test can look at while it is open.
struct TestSound {
    explicit TestSound(const std::string& assets = kAssets)
        : sound(
              [this] {
                  auto output = std::make_unique<RecordedOutput>();
                  last = output.get();
                  ++opened;
                  return output;
              },
              assets) {}

    RecordedOutput* last = nullptr;
    int opened = 0;
    GameSound sound;
};

constexpr SoundSettings kOn{100, 80, 60, false}, kOff{0, 80, 60, false};

TEST(GameSound, OpensNothingWithoutVolume) {
    TestSound test;
    test.sound.set(kOff);
    test.sound.set({100, 0, 0, false});
    test.sound.play(Sound::MenuMove);
    test.sound.play_music(kTitleMusic);
    EXPECT_EQ(test.opened, 0);
    test.sound.set(kOn);
    EXPECT_EQ(test.opened, 1);
    EXPECT_GT(test.last->music_size, 50'000u);  // which was asked for before
}

TEST(GameSound, IsSilentAndSaysSoOnceWhereThereIsNoDevice) {
    int tries = 0;
    GameSound sound(
        [&]() -> std::unique_ptr<SoundOutput> {
            ++tries;
            throw std::runtime_error("no sound: none here");
        },
        kAssets);
    testing::internal::CaptureStderr();
    sound.set(kOn);
    sound.set(kOff);
    sound.set(kOn);
    sound.play(Sound::MenuMove);
    sound.play_music(kTitleMusic);
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "oblong: no sound: none here\n");
    EXPECT_EQ(tries, 1);
}

TEST(GameSound, IsSilentWhereItsFilesAreMissing) {
    testing::internal::CaptureStderr();
    TestSound test("nowhere");
    test.sound.set(kOn);
    test.sound.play(Sound::MenuMove);
    EXPECT_NE(testing::internal::GetCapturedStderr().find("nowhere/sounds/step_stone1.flac"), std::string::npos);
}

// A walk, heard by these settings.
struct WalkedSound : TestSound {
    explicit WalkedSound(const SoundSettings& settings) {
        sound.set(settings);
        sound.enter(&game.level);
    }
    void walk(int ticks) {
        for (int i = 0; i < ticks; ++i) {
            const GameState before = game.state;
            const TickReport report = step(game.level, game.state, kAhead);
            sound.note_tick(before, game.state, report);
        }
    }
    ToyGame game{with_wall()};
};

TEST(GameSound, PlaysAWalkAndHoldsItInAMenu) {
    WalkedSound test(kOn);
    test.walk(35);
    EXPECT_GT(test.last->starts, 0);
    test.sound.play_music(kTitleMusic);
    const std::int32_t loud_256 = test.last->music_volume_256;
    test.sound.hold(true);
    EXPECT_TRUE(test.last->are_held);
    EXPECT_EQ(test.last->music_volume_256, loud_256 / 2);
    test.sound.hold(false);
    EXPECT_FALSE(test.last->are_held);
    test.sound.enter(nullptr);
    EXPECT_TRUE(test.sound.captions().empty());
}

TEST(GameSound, WritesCaptionsWithoutADevice) {
    WalkedSound test({0, 80, 60, true});
    test.walk(20);
    EXPECT_EQ(test.opened, 0);
    EXPECT_EQ(test.sound.captions(), std::vector<std::string>{"footsteps on stone"});
}

TEST(GameSound, StopsWhatPlaysWhereSoundsAreTurnedOff) {
    WalkedSound test(kOn);
    test.walk(12);
    ASSERT_FALSE(test.last->voices.empty());
    test.sound.set({100, 0, 60, false});
    EXPECT_TRUE(test.last->voices.empty());
    test.sound.set(kOn);
    test.walk(12);
    ASSERT_FALSE(test.last->voices.empty());
    test.sound.set({100, 0, 60, true});
    EXPECT_TRUE(test.last->voices.empty()) << "captions go on, sounds don't";
}

struct Played : Outcome {
    std::vector<std::uint8_t> played;  ///< what SDL's driver "disk" wrote instead of playing it
};

// The game for some seconds, in a window that nobody sees, until it is asked to end.
Played run_game_for(int seconds, const std::string& driver, const std::string& arguments) {
    const TemporaryFolder folder;
    const std::string line = "SDL_VIDEODRIVER=dummy SDL_AUDIODRIVER=" + driver + " SDL_DISKAUDIOFILE='" +
                             folder.path("played") + "' " + at_home_in(folder.path()) +
                             "timeout --preserve-status -s TERM " + std::to_string(seconds) + " " + program("oblong") +
                             " --frame-cap 20 --window 320x240 " + arguments;
    return {run_line(line), read_file_bytes(folder.path("played"))};
}

// For longer and longer, where a busy machine has not played enough of it by then: up to four minutes at a time.
Played run_game(const std::string& driver, std::size_t least_played_bytes, const std::string& arguments) {
    Played outcome;
    for (int seconds = 2; seconds < 300; seconds *= 5) {
        outcome = run_game_for(seconds, driver, arguments);
        if (outcome.exit_code == 0 && outcome.played.size() >= least_played_bytes) break;
    }
    return outcome;
}

double loudness(const std::vector<std::uint8_t>& bytes) {
    double sum = 0;
    for (std::size_t i = 0; i + 1 < bytes.size(); i += 2)
        sum += std::pow(static_cast<std::int16_t>(bytes[i] | bytes[i + 1] << 8), 2);
    return std::sqrt(sum / static_cast<double>(bytes.size() / 2));
}

TEST(ProgramSound, GoesOnInSilenceWhereThereIsNoDevice) {
    const Played outcome = run_game("nonsense", 0, "--title");
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_EQ(outcome.error, "oblong: no sound: Audio target 'nonsense' not available\n");
}

TEST(ProgramSound, PlaysMusicOnTheTitle) {
    const Played outcome = run_game("disk", 44'100, "--title");
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_GE(outcome.played.size(), 44'100u);
    EXPECT_GT(loudness(outcome.played), 100);
}

TEST(ProgramSound, OpensNoDeviceAtVolume0) {
    const Played outcome = run_game("disk", 0, "--title --volume 0");
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_TRUE(outcome.played.empty());
    EXPECT_EQ(outcome.error, "");
}

}  // namespace
}  // namespace oblong::test
