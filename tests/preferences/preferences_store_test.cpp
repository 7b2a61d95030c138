#include "game/options/preferences_store.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>
#include <filesystem>

#include "engine/io/files.h"
#include "tests/preferences/named.h"
#include "tests/support/folders.h"

namespace oblong {
namespace {

namespace fs = std::filesystem;

class OptionsFile : public testing::Test {
  protected:
    std::string text() const { return read_text(file_); }
    static Preferences with_volume(std::int32_t volume_100) {
        Preferences preferences;
        preferences.volume_100 = volume_100;
        return preferences;
    }

    const test::TemporaryFolder temporary_;
    const fs::path folder_ = temporary_.path();
    const std::string file_ = (folder_ / "deep" / "er" / "oblong.cfg").string();
};

TEST_F(OptionsFile, IsMadeWhenSomethingHasChanged) {
    PreferencesStore store(file_);
    EXPECT_EQ(store.kept(), Preferences{});
    EXPECT_EQ(store.save(Preferences{}), "");
    EXPECT_FALSE(fs::exists(file_));
    EXPECT_EQ(store.save(with_volume(40)), "");
    EXPECT_EQ(PreferencesStore(file_).kept(), with_volume(40));
    EXPECT_TRUE(PreferencesStore(file_).faults().empty());
}

TEST_F(OptionsFile, KeepsEverythingThatAMenuChanges) {
    const Preferences changed = test::all_changed();
    for (const Preference& row : all_preferences()) EXPECT_NE(row.shown(changed), row.shown(Preferences{})) << row.name;
    PreferencesStore(file_).save(changed);
    EXPECT_EQ(PreferencesStore(file_).kept(), changed);
    EXPECT_TRUE(PreferencesStore(file_).faults().empty());
    PreferencesStore again(file_);
    again.save(Preferences{});
    EXPECT_EQ(PreferencesStore(file_).kept(), Preferences{});
}

TEST_F(OptionsFile, IsNotWrittenAgainWhereNothingHasChanged) {
    PreferencesStore store(file_);
    store.save(with_volume(40));
    write_file(file_, "volume = 45\nby = hand\n");
    EXPECT_EQ(store.save(with_volume(40)), "");
    EXPECT_EQ(text(), "volume = 45\nby = hand\n");
    store.save(with_volume(50));
    EXPECT_EQ(text(), "volume = 50\nby = hand\n") << "what was edited during the game stays";
}

// The command line wins, and is not written.
TEST_F(OptionsFile, KeepsWhatIsChangedInTheGameAlone) {
    write_file((folder_ / "a.cfg").string(), "volume = 30\n# mine\nbrightness = 2\n");
    PreferencesStore store((folder_ / "a.cfg").string());
    Preferences now = store.kept();
    now.volume_100 = 90;
    now.set_light({now.light().brightness_100, 150});
    store.begin_with(now);
    EXPECT_EQ(store.save(now), "");
    EXPECT_EQ(read_text((folder_ / "a.cfg").string()), "volume = 30\n# mine\nbrightness = 2\n");
    now.set_light({280, now.light().gamma_100});
    store.save(now);
    EXPECT_EQ(read_text((folder_ / "a.cfg").string()), "volume = 30\n# mine\nbrightness = 2.8\n");
    now.volume_100 = 80;
    store.save(now);
    EXPECT_EQ(read_text((folder_ / "a.cfg").string()), "volume = 80\n# mine\nbrightness = 2.8\n");
}

// The dials of the file go with the preset that a key chooses.
TEST_F(OptionsFile, WritesTheDialsThatAPresetTurns) {
    write_file((folder_ / "a.cfg").string(), "dial-perspective = every8\n");
    PreferencesStore store((folder_ / "a.cfg").string());
    Preferences now = store.kept();
    test::preference_named("accuracy").parse(now, "1994");
    store.save(now);
    EXPECT_EQ(PreferencesStore((folder_ / "a.cfg").string()).kept(), now);
    EXPECT_EQ(read_text((folder_ / "a.cfg").string()).rfind("dial-perspective = preset\n", 0), 0u);
}

TEST_F(OptionsFile, IsWrittenOnceChangesHaveSettled) {
    PreferencesStore store(file_);
    for (std::uint64_t now_us = 0; now_us < 5'000'000; now_us += 100'000) {
        const auto volume = static_cast<std::int32_t>(std::min<std::uint64_t>(now_us / 100'000, 30));
        EXPECT_EQ(store.save_when_settled(with_volume(volume), now_us), "");
        EXPECT_EQ(fs::exists(file_), now_us >= 4'000'000) << now_us;
    }
    EXPECT_EQ(PreferencesStore(file_).kept(), with_volume(30));
}

TEST_F(OptionsFile, ThatCannotBeReadIsNamedAndLeftAlone) {
    const std::string binary = (folder_ / "binary.cfg").string(), huge = (folder_ / "huge.cfg").string();
    write_file(binary, std::string(500, '\1'));
    write_file(huge, std::string(300 * 1024, '\n') + "volume = 1\n");
    for (const std::string& file :
         {binary, huge, folder_.string(), test::device_for_writing(folder_.string(), "zero")}) {
        const bool is_file = fs::is_regular_file(file);
        const std::string before = is_file ? read_text(file) : "";
        PreferencesStore store(file);
        ASSERT_EQ(store.faults().size(), 1u) << file;
        EXPECT_EQ(store.faults().front().rfind(file + ": ", 0), 0u) << store.faults().front();
        EXPECT_EQ(store.save(test::all_changed()), "");
        EXPECT_EQ(is_file ? read_text(file) : "", before);
    }
}

TEST_F(OptionsFile, NamesItsBrokenLines) {
    const std::string file = (folder_ / "a.cfg").string();
    write_file(file, "volume = 30\nfov = x\n");
    const PreferencesStore store(file);
    EXPECT_EQ(store.faults(), std::vector{file + ": line 2: fov: 'x', expected 1 to 179 degrees"});
    EXPECT_EQ(store.kept(), with_volume(30));
}

TEST_F(OptionsFile, WithoutANameIsNeitherReadNorWritten) {
    PreferencesStore store;
    EXPECT_EQ(store.save(test::all_changed()), "");
    EXPECT_TRUE(store.faults().empty());
}

// As on a full disk: a file can't grow beyond a limit.
class FullDisk {
  public:
    explicit FullDisk(rlim_t limit_bytes) {
        std::signal(SIGXFSZ, SIG_IGN);
        getrlimit(RLIMIT_FSIZE, &before_);
        const rlimit limit{limit_bytes, before_.rlim_max};
        setrlimit(RLIMIT_FSIZE, &limit);
    }
    ~FullDisk() { setrlimit(RLIMIT_FSIZE, &before_); }
    FullDisk(const FullDisk&) = delete;

  private:
    rlimit before_{};
};

TEST_F(OptionsFile, AFullDiskLosesNothing) {
    const std::string file = (folder_ / "a.cfg").string(), written = "# mine\nvolume = 30\n";
    write_file(file, written);
    PreferencesStore store(file);
    for (const rlim_t limit : {rlim_t{0}, rlim_t{10}, rlim_t{18}}) {
        const FullDisk full(limit);
        const auto volume = static_cast<std::int32_t>(40 + limit);
        EXPECT_EQ(store.save(with_volume(volume)).rfind(file + ": write: ", 0), 0u) << limit;
        EXPECT_EQ(read_text(file), written);
        EXPECT_EQ(std::distance(fs::directory_iterator(folder_), {}), 1) << "nothing is left beside it";
    }
    EXPECT_EQ(store.save(with_volume(50)), "");
    EXPECT_EQ(read_text(file), "# mine\nvolume = 50\n") << "with room again, what was not written is";
}

TEST_F(OptionsFile, AFolderThatCannotBeMadeIsAMessage) {
    write_file((folder_ / "in-the-way").string(), "");
    const std::string file = (folder_ / "in-the-way" / "oblong.cfg").string();
    PreferencesStore store(file);
    EXPECT_NE(store.save(with_volume(50)), "");
}

}  // namespace
}  // namespace oblong
