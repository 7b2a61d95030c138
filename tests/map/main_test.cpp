#include <gtest/gtest.h>

#include <filesystem>

#include "engine/io/files.h"
#include "engine/level/bsp_read.h"
#include "engine/pictures/picture.h"
#include "tests/map/map_source.h"
#include "tests/support/programs.h"

namespace oblong::test {
namespace {

namespace fs = std::filesystem;

const std::string kSmallRoom = room({0, 0, 0}, {64, 64, 64}),
                  kStartAlone = entity_at("info_player_start", {32, 32, 28});

std::string with_world_key(const std::string& source, const std::string& key, const std::string& value) {
    return replaced(source, "\"worldspawn\"", "\"worldspawn\"\n\"" + key + "\" \"" + value + "\"");
}

// Runs the program in a folder of a few sources.
class Program : public testing::Test {
  protected:
    void SetUp() override {
        write("good.map", level(kSmallRoom, kStartAlone));
        write("odd.map", level(kSmallRoom, entity_at("light", {32, 32, 32})));
        write("leak.map", level(box({0, 0, 0}, {64, 64, 64}), entity_at("light", {0, 0, 99})));
        write("piece.map", level(box({0, 0, 0}, {64, 64, 64})));
        write("named.map", with_world_key(level(kSmallRoom, kStartAlone), "wad", "t.wad"));
        write("bad.map", "{");
        write("t.wad", wad_bytes({"wall"}));
    }

    void write(const std::string& name, const std::string& text) const {
        fs::create_directories(fs::path(path(name)).parent_path());
        write_file(path(name), text);
    }
    std::string path(const std::string& name) const { return folder_.path(name); }
    std::string text_of(const std::string& name) const { return read_text(path(name)); }

    // The exit code; what is said on standard error goes to `said_`.
    int run(const std::string& arguments) {
        const auto [exit_code, error] =
            run_line("cd '" + folder_.path() + "' && " + program("oblong-map") + " " + arguments, path("out.txt"));
        said_ = error;
        return exit_code;
    }
    // That it ends with this code, and says so.
    void expect(int exit_code, const std::string& arguments, const std::string& part = "") {
        EXPECT_EQ(run(arguments), exit_code) << arguments << said_;
        EXPECT_NE(said_.find(part), std::string::npos) << arguments << said_;
    }
    void expect_kept(const std::string& name, const std::string& arguments, const std::string& part = "") {
        const std::string before = text_of(name);
        expect(2, arguments, part);
        EXPECT_EQ(text_of(name), before) << arguments;
    }
    int faces_of(const std::string& name) const {
        return static_cast<int>(read_bsp(read_file(path(name))).faces.size());
    }

    int files_beginning_with(const std::string& name) const {
        return static_cast<int>(
            std::count_if(fs::directory_iterator(folder_.path()), fs::directory_iterator(),
                          [&](const auto& file) { return file.path().filename().string().starts_with(name); }));
    }

    const TemporaryFolder folder_;
    std::string said_;
};

int count_of(const std::string& text, const std::string& part) {
    int count = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
    return count;
}

TEST_F(Program, WarnsAndWritesALevelUnlessWarningsAreErrors) {
    expect(0, "odd.map -o odd.bsp --wad t.wad");
    EXPECT_EQ(said_,
              "oblong-map: odd.map: line 1: warning: no info_player_start, expected one: the player has no "
              "place to start\n");
    EXPECT_EQ(files_beginning_with("odd.bsp"), 1);
    expect(1, "odd.map -o odder.bsp --strict --wad t.wad", "--strict: 1 warning, expected none");
    EXPECT_EQ(files_beginning_with("odder.bsp"), 0);
    expect(0, "good.map -o good.bsp --strict --wad t.wad");
}

TEST_F(Program, SaysOnStandardOutputWhatItMade) {
    expect(0, "good.map -o good.bsp --prt good.prt --wad t.wad");
    EXPECT_TRUE(text_of("out.txt").starts_with(
        "good.bsp: 6 faces, 2 leaves, 1 models, 0 lightmaps of 0 bytes, 0 portals, at most 6 faces in sight, around "
        "32 32 32; 0 warnings; tree "))
        << text_of("out.txt");
    EXPECT_EQ(text_of("good.prt"), "PRT1\n1\n0\n");
    EXPECT_EQ(said_, "");
}

TEST_F(Program, MakesAPartOfALevelOnlyIfThereIsOne) {
    const std::string command = "good.map -o good.bsp --wad t.wad";
    expect(1, command + " --only light");
    EXPECT_EQ(said_, "oblong-map: good.bsp: --only: there is no such level yet: compile it once without --only\n");
    expect(0, command + " --prt good.prt");
    expect_kept("good.prt", command + " --only light --prt good.prt", "--prt: --only light makes no portals");
    expect(0, command + " --only light");
    EXPECT_EQ(text_of("out.txt").find("portals"), std::string::npos);
    expect(0, command + " --only vis");
    expect(0, command + " --since good.map");
    EXPECT_EQ(text_of("out.txt").find("portals"), std::string::npos);
    expect(1, command + " --since gone.map", "oblong-map: gone.map: open");
    expect(2, command + " --since good.map --only light");
}

TEST_F(Program, ReplacesNoSourceAndNoFileButALevel) {
    for (const std::string option : {"-o ", "-o o.bsp --prt ", "-o o.bsp --reads "})
        expect_kept("good.map", "good.map --wad t.wad " + option + "./good.map",
                    "good.map' is read or written for another option");
    for (const std::string option : {"--prt ", "--reads "})
        expect_kept("t.wad", "named.map -o o.bsp " + option + "./t.wad",
                    "t.wad' is read or written for another option");
    expect_kept("good.map", "--fgd good.map");
    expect_kept("odd.map", "good.map --wad t.wad -o odd.map", "is there and no level");
    write("good.bsp", "");
    for (const char* const arguments : {"--fgd own.fgd", "good.map --wad t.wad -o good.bsp"})
        for (int i = 0; i < 2; ++i) expect(0, arguments);
    // One of two tasks would be left out.
    for (const char* const two : {"good.map --wad t.wad -o o.bsp --fgd new", "--fgd new --install-trenchbroom new",
                                  "good.map --wad t.wad --install-trenchbroom new"}) {
        expect(2, two, "excludes");
        EXPECT_EQ(files_beginning_with("new"), 0);
    }
}

// --help shows one value for each --wad, as no more are taken.
TEST_F(Program, TakesOneWadForEachOption) {
    expect(0, "--wad t.wad --wad t.wad --wad t.wad good.map -o good.bsp");
    expect(0, "--help");
    EXPECT_NE(text_of("out.txt").find("--wad TEXT  "), std::string::npos) << text_of("out.txt");
    EXPECT_NE(text_of("out.txt").find("--dither TEXT=none  "), std::string::npos) << "what it is without";
}

TEST_F(Program, ALevelWithoutALeakRemovesTheWayOut) {
    write("good.pts", "0 0 0\n");
    expect(0, "good.map -o good.bsp --wad t.wad");
    EXPECT_EQ(files_beginning_with("good.pts"), 0);
    expect(0, "good.map -o good.pts --wad t.wad");
    EXPECT_EQ(files_beginning_with("good.pts"), 1) << "the level itself has that name";
}

TEST_F(Program, SaysWhatIsWrongAndWhere) {
    for (const auto& [arguments, place] : {std::pair{"bad.map -o bad.bsp", "bad.map: line 1: "},
                                           {"none.map -o bad.bsp", "none.map: "},
                                           {"good.map -o bad.bsp --wad none.wad", "none.wad: "}}) {
        expect(1, arguments);
        EXPECT_TRUE(said_.starts_with("oblong-map: " + std::string(place))) << said_;
    }
    expect(2, "good.map -o bad.bsp --wad t.wad --dither x");
    EXPECT_EQ(files_beginning_with("bad.bsp"), 0);
}

TEST_F(Program, ALeakWritesTheWayOut) {
    expect(1, "leak.map -o leak.bsp --wad t.wad", "light at 0 0 99");
    EXPECT_NE(said_.find("leak.pts has the path to the void"), std::string::npos) << said_;
    EXPECT_EQ(text_of("leak.pts").substr(0, 7), "0 0 99\n");
    EXPECT_EQ(files_beginning_with("leak.bsp"), 0);
    fs::remove(path("leak.pts"));
    expect(1, "leak.map -o leak.bsp --wad t.wad --fast --strict");
    EXPECT_EQ(files_beginning_with("leak."), 1) << "the source alone";
}

// From the light, which lies over the only brush, all of its six sides may be seen.
TEST_F(Program, ADraftThatLeaksOrEnclosesNothingShowsItsOutside) {
    expect(0, "leak.map -o leak.bsp --wad t.wad --fast", "warning: the level leaks: light at 0 0 99");
    EXPECT_EQ(text_of("leak.pts").substr(0, 7), "0 0 99\n");
    EXPECT_EQ(faces_of("leak.bsp"), 6);
    expect(0, "leak.map -o leak.bsp --wad t.wad --fast --only light");
    EXPECT_EQ(files_beginning_with("leak.pts"), 1);
    expect(1, "piece.map -o piece.bsp --wad t.wad");
    expect(0, "piece.map -o piece.bsp --wad t.wad --fast");
    EXPECT_EQ(faces_of("piece.bsp"), 6);
}

TEST_F(Program, LeavesNoPartOfAFileThatCannotBeWritten) {
    fs::create_directory(path("taken.bsp"));
    expect(1, "good.map -o taken.bsp --wad t.wad", "taken.bsp: write: ");
    EXPECT_EQ(text_of("out.txt"), "") << "nothing was made";
    EXPECT_EQ(files_beginning_with("taken.bsp"), 1) << "the folder that stands in the way";
    expect(1, "bad.map -o no/such/folder.bsp", "folder.bsp: write: ");  // before anything is compiled
}

// A texture is looked for in what the worldspawn names, from the map's folder; --wad takes the key's place.
TEST_F(Program, TexturesComeFromWhatTheWorldspawnNames) {
    const auto named = [&](const std::string& wads, const std::string& options = "") {
        write("named.map", with_world_key(level(kSmallRoom, kStartAlone), "wad", wads));
        return run("named.map -o good.bsp" + options);
    };
    const auto expect_once = [&](const std::string& part) { EXPECT_EQ(count_of(said_, part), 1) << part << said_; };
    write("sub/wall.png", {});
    write_file(path("sub/wall.png"), encode_indexed_png(std::vector<std::uint8_t>(256, 96), 16, 16, {}));
    for (const std::string wads : {"t.wad", "sub;t.wad", "no/such\\folder/t.wad", ""}) {
        EXPECT_EQ(named(wads), 0) << wads << said_;
        EXPECT_EQ(said_.find("texture 'wall' is not in any") != said_.npos, wads.empty()) << said_;
    }
    EXPECT_EQ(named("gone.wad;lost"), 0);
    expect_once("line 3: warning: \"wad\" names 'gone.wad', which is not at ");
    expect_once("\"wad\" names 'lost'");
    expect_once("line 5: warning: texture 'wall' is not in any of the WAD files");
    // One odd picture leaves the others of its folder, and one odd source the others of the list.
    fs::create_directories(path("none"));
    write_file(path("sub/odd.png"), encode_indexed_png(std::vector<std::uint8_t>(480, 96), 30, 16, {}));
    write("odd.wad", "WAD3");
    EXPECT_EQ(named("odd.wad;none;sub"), 0) << said_;
    expect_once("line 3: warning: odd.wad: header: ");
    expect_once("line 3: warning: none: folder: has no pictures");
    expect_once("line 3: warning: sub/odd.png: image: 30x16, expected multiples");
    EXPECT_EQ(said_.find("texture 'wall'"), said_.npos) << said_;
    EXPECT_EQ(named("odd.wad;none;sub", " --wad odd.wad"), 1);
    EXPECT_EQ(named("odd.wad;none;sub", " --wad gone.wad"), 1) << "what one asks for must be there";
    EXPECT_EQ(named("odd.wad;none;sub", " --wad t.wad"), 0) << said_;
}

// Each once, and before an error that comes later.
TEST_F(Program, AllWarningsAreSaidBeforeALeak) {
    write("odd.map", "{\n\"classname\" \"worldspawn\"\n\"wad\" \"gone.wad\"\n\"_dirt\" \"d\"\n" +
                         box({0, 0, 0}, {64, 64, 64}) + "{\n}\n}\n" +
                         entity_at("light", {0, 0, 99}, {{"delay", ""}, {"_color", "#define RED"}}));
    EXPECT_EQ(run("odd.map -o odd.bsp"), 1);
    std::size_t last = 0;
    for (const std::string part :
         {"\"wad\" names 'gone.wad'", "'_dirt' is 'd'", "a brush without sides is left out", "'delay' is ''",
          "'_color' is '#define RED'", "texture 'wall' is not in any", "the level leaks"}) {
        EXPECT_EQ(count_of(said_, part), 1) << part << ", in " << said_;
        last = std::max(last, said_.find(part));
    }
    EXPECT_EQ(count_of(said_, "d, expected 3 decimal"), 0);
    EXPECT_EQ(last, said_.find("the level leaks")) << "the error is last";
}

// Sounds and music are looked for where the game does: below its folder and the level's.
TEST_F(Program, MissingSoundsAndMusicAreNamed) {
    write("game/sounds/song.mod", "");
    write("bell.wav", "");
    write("game/game.json", R"({"title": "t", "levels": ["loud"]})");
    for (const std::string name : {"sounds/song.mod", "bell.wav", "gone.wav", "../t.wad"}) {
        write("loud.map", with_world_key(level(kSmallRoom, kStartAlone), "music", name) +
                              entity("func_door", {{"noise", name}}, box({8, 8, 0}, {16, 16, 16})));
        EXPECT_EQ(run("loud.map -o loud.bsp --wad t.wad --game game"), 0) << said_;
        const int missing = name == "gone.wav" || name == "../t.wad" ? 1 : 0;
        for (const std::string key : {"'music' is '", "'noise' is '"})
            EXPECT_EQ(count_of(said_, key + name + "', but there is no such file"), missing) << said_;
    }
}

TEST_F(Program, APaletteIsReadOnlyIfLightBounces) {
    for (const std::string bounces : {"0", "1"}) {
        write("named.map", with_world_key(level(kSmallRoom), "_bounce", bounces));
        EXPECT_EQ(run("named.map -o good.bsp --wad t.wad --palette gone.lmp"), bounces == "0" ? 0 : 1) << said_;
    }
}

// An external map is looked for from the folder of the map that names it.
TEST_F(Program, MapsOfOtherFilesAreIncluded) {
    const auto naming = [](const std::string& name) { return entity("misc_external_map", {{"_external_map", name}}); };
    const auto run_naming = [&](const std::string& name, const std::string& options = "") {
        write("whole.map", level("", naming(name) + kStartAlone));
        return run("whole.map -o whole.bsp --wad t.wad" + options);
    };
    write("sub/room.map", level("", naming("../walls.map")));
    write("walls.map", level(kSmallRoom));
    EXPECT_EQ(run_naming("sub\\room.map", " --strict"), 0) << said_;
    for (const std::string name : {"gone.map", "sub"}) {
        EXPECT_EQ(run_naming(name), 1);
        EXPECT_EQ(said_.find("oblong-map: whole.map: line 4: \"_external_map\" names '" + name + "', "), 0u) << said_;
    }
    write("walls.map", level("", naming("sub/room.map")));
    EXPECT_EQ(run_naming("walls.map"), 1);
    EXPECT_NE(said_.find("includes itself"), std::string::npos) << said_;
}

// Colours of the last 32 are taken only for textures that may glow.
TEST_F(Program, AFolderOfPicturesIsPackedByItself) {
    Palette other{};
    std::string bytes;
    for (std::size_t i = 0; i < 256; ++i) {
        other.colours[i] = {static_cast<std::uint8_t>(i), static_cast<std::uint8_t>(i), 0};
        bytes += {static_cast<char>(i), static_cast<char>(i), 0};
    }
    other.colours[0].blue = 255;  // not the palette of the game: its indices mean nothing
    write("pictures/palette.lmp", bytes);
    write_file(path("pictures/wall.png"), encode_indexed_png(std::vector<std::uint8_t>(256, 250), 16, 16, other));
    const auto packed = [&](const std::string& options) {
        return run("good.map -o good.bsp --wad pictures" + options);
    };
    const auto first_texel = [&](const std::string& options) {
        EXPECT_EQ(packed(options), 0) << said_;
        return int{read_bsp_textures(read_file(path("good.bsp"))).front().mips[0].front()};
    };
    EXPECT_EQ(first_texel(""), 223);
    EXPECT_EQ(first_texel(" --glow wall"), 250);
    write("own/game.json", R"({"title": "Own", "palette": "colours.lmp", "levels": ["one"]})");
    fs::rename(path("pictures/palette.lmp"), path("own/colours.lmp"));
    EXPECT_EQ(first_texel(" --game own"), 223) << "of the game";
    EXPECT_NE(first_texel(""), 223) << "of the museum, whose colours are others";
    EXPECT_EQ(packed(" --glow wlal"), 2);
    EXPECT_EQ(packed(" --dither ordered"), 2);
    fs::remove(path("pictures/wall.png"));
    EXPECT_EQ(packed(""), 1);
    EXPECT_NE(said_.find("has no pictures"), std::string::npos) << said_;
}

}  // namespace
}  // namespace oblong::test
