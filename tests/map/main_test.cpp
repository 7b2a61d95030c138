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

class Program : public testing::Test {
  protected:
    void SetUp() override {
        write_file(path("good.map"),
                   level(room({0, 0, 0}, {64, 64, 64}), entity_at("info_player_start", {32, 32, 28})));
        write_file(path("odd.map"), level(room({0, 0, 0}, {64, 64, 64}), entity_at("light", {32, 32, 32})));
        write_file(path("leak.map"), level(box({0, 0, 0}, {64, 64, 64}), entity_at("light", {0, 0, 99})));
        write_file(path("bad.map"), "{");
        write_file(path("t.wad"), wad_bytes({"wall"}));
    }

    std::string path(const std::string& name) const { return folder_.path(name); }

    // The exit code; what is said on standard error goes to `said_`.
    int run(const std::string& arguments) {
        const auto [exit_code, error] = run_line(program("oblong-map") + " " + arguments, path("out.txt"));
        said_ = error;
        return exit_code;
    }

    static int count_of(const std::string& text, const std::string& part) {
        int count = 0;
        for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
        return count;
    }

    int files_beginning_with(const std::string& name) const {
        int count = 0;
        for (const auto& file : fs::directory_iterator(folder_.path()))
            count += file.path().filename().string().starts_with(name) ? 1 : 0;
        return count;
    }

    const TemporaryFolder folder_;
    std::string said_;
};

TEST_F(Program, WarnsAndWritesALevel) {
    EXPECT_EQ(run(path("odd.map") + " -o " + path("odd.bsp") + " --wad " + path("t.wad")), 0);
    EXPECT_EQ(said_, "oblong-map: " + path("odd.map") +
                         ": line 1: warning: no info_player_start, expected one: the player has no place to start\n");
    EXPECT_EQ(files_beginning_with("odd.bsp"), 1);
}

TEST_F(Program, WarningsAreErrorsWithStrict) {
    EXPECT_EQ(run(path("odd.map") + " -o " + path("odd.bsp") + " --strict --wad " + path("t.wad")), 1);
    EXPECT_NE(said_.find("--strict: 1 warning, expected none"), std::string::npos) << said_;
    EXPECT_EQ(files_beginning_with("odd.bsp"), 0);
    EXPECT_EQ(run(path("good.map") + " -o " + path("good.bsp") + " --strict --wad " + path("t.wad")), 0) << said_;
}

TEST_F(Program, SaysOnStandardOutputWhatItMade) {
    EXPECT_EQ(
        run(path("good.map") + " -o " + path("good.bsp") + " --prt " + path("good.prt") + " --wad " + path("t.wad")),
        0);
    const std::string said = read_text(path("out.txt"));
    EXPECT_EQ(said.find(path("good.bsp") + ": 6 faces, 2 leaves, 1 models, 0 lightmaps of 0 bytes, 0 portals, at "
                                           "most 6 faces in sight, around 32 32 32; 0 warnings; tree "),
              0u)
        << said;
    EXPECT_EQ(read_text(path("good.prt")), "PRT1\n1\n0\n");
    EXPECT_EQ(said_, "");
}

// A texture is looked for in what the worldspawn names, from the map's folder; --wad takes the key's place.
TEST_F(Program, TexturesComeFromWhatTheWorldspawnNames) {
    const std::string start = entity_at("info_player_start", {32, 32, 28});
    const auto source = [&](const std::string& wads) {
        return replaced(level(room({0, 0, 0}, {64, 64, 64}), start), "\"classname\" \"worldspawn\"",
                        "\"classname\" \"worldspawn\"\n\"wad\" \"" + wads + "\"");
    };
    fs::create_directories(path("sub"));
    const std::string out = " -o " + path("good.bsp");
    for (const std::string wads : {"t.wad", "sub;t.wad", "no/such\\folder/t.wad", ""}) {
        write_file(path("sub/wall.png"), encode_indexed_png(std::vector<std::uint8_t>(256, 96), 16, 16, {}));
        write_file(path("named.map"), source(wads));
        EXPECT_EQ(run(path("named.map") + out), 0) << wads << said_;
        EXPECT_EQ(said_.find("texture 'wall' is not in any") != said_.npos, wads.empty()) << said_;
    }
    write_file(path("named.map"), source("gone.wad;lost"));
    EXPECT_EQ(run(path("named.map") + out), 0);
    for (const std::string part :
         {"line 3: warning: \"wad\" names 'gone.wad', which is not at ", "\"wad\" names 'lost'",
          "line 5: warning: texture 'wall' is not in any of the WAD files"})
        EXPECT_EQ(count_of(said_, part), 1) << part << ", in " << said_;
    // One odd picture leaves the others of its folder, and one odd source the others of the list.
    fs::create_directories(path("none"));
    write_file(path("sub/odd.png"), encode_indexed_png(std::vector<std::uint8_t>(480, 96), 30, 16, {}));
    write_file(path("odd.wad"), std::string("WAD3"));
    write_file(path("named.map"), source("odd.wad;none;sub"));
    EXPECT_EQ(run(path("named.map") + out), 0) << said_;
    for (const std::string& part : {"line 3: warning: " + path("odd.wad") + ": header: ",
                                    "line 3: warning: " + path("none") + ": folder: has no pictures",
                                    "line 3: warning: " + path("sub/odd.png") + ": image: 30x16, expected multiples"})
        EXPECT_EQ(count_of(said_, part), 1) << part << ", in " << said_;
    EXPECT_EQ(said_.find("texture 'wall'"), said_.npos) << said_;
    EXPECT_EQ(run(path("named.map") + out + " --wad " + path("odd.wad")), 1);
    EXPECT_EQ(run(path("named.map") + out + " --wad " + path("gone.wad")), 1) << "what one asks for must be there";
    EXPECT_EQ(run(path("named.map") + out + " --wad " + path("t.wad")), 0) << said_;
}

// Each once, and before an error that comes later.
TEST_F(Program, AllWarningsAreSaidBeforeALeak) {
    write_file(path("odd.map"), "{\n\"classname\" \"worldspawn\"\n\"wad\" \"gone.wad\"\n\"_dirt\" \"d\"\n" +
                                    box({0, 0, 0}, {64, 64, 64}) + "{\n}\n}\n" +
                                    entity_at("light", {0, 0, 99}, {{"delay", ""}, {"_color", "#define RED"}}));
    EXPECT_EQ(run(path("odd.map") + " -o " + path("odd.bsp")), 1);
    std::size_t last = 0;
    for (const std::string part :
         {"\"wad\" names 'gone.wad'", "'_dirt' is 'd'", "a brush without sides is left out", "'delay' is ''",
          "'_color' is '#define RED'", "texture 'wall' is not in any", "the level leaks"}) {
        EXPECT_EQ(count_of(said_, part), 1) << part << ", in " << said_;
        EXPECT_EQ(count_of(said_, "d, expected 3 decimal"), 0);
        last = std::max(last, said_.find(part));
    }
    EXPECT_EQ(last, said_.find("the level leaks")) << "the error is last";
}

// Sounds and music are looked for where the game does: below its folder and the level's.
TEST_F(Program, MissingSoundsAndMusicAreNamed) {
    fs::create_directories(path("game/sounds"));
    const std::string walls = room({0, 0, 0}, {64, 64, 64});
    write_file(path("game/sounds/song.mod"), "");
    write_file(path("bell.wav"), "");
    for (const std::string name : {"sounds/song.mod", "bell.wav", "gone.wav", "../t.wad"}) {
        write_file(path("loud.map"), entity("worldspawn", {{"music", name}}, walls) +
                                         entity_at("info_player_start", {32, 32, 28}) +
                                         entity("func_door", {{"noise", name}}, box({8, 8, 0}, {16, 16, 16})));
        const std::string command = path("loud.map") + " -o " + path("loud.bsp") + " --wad " + path("t.wad");
        write_file(path("game/game.json"), R"({"title": "t", "levels": ["loud"]})");
        EXPECT_EQ(run(command + " --game " + path("game")), 0) << said_;
        const int missing = name == "gone.wav" || name == "../t.wad" ? 1 : 0;
        for (const std::string key : {"'music' is '", "'noise' is '"})
            EXPECT_EQ(count_of(said_, key + name + "', but there is no such file"), missing) << said_;
    }
}

TEST_F(Program, APaletteIsReadOnlyIfLightBounces) {
    for (const std::string bounces : {"0", "1"}) {
        write_file(path("named.map"), replaced(level(room({0, 0, 0}, {64, 64, 64})), "\"classname\" \"worldspawn\"",
                                               "\"classname\" \"worldspawn\"\n\"_bounce\" \"" + bounces + "\""));
        const std::string command = path("named.map") + " -o " + path("good.bsp") + " --wad " + path("t.wad");
        EXPECT_EQ(run(command + " --palette " + path("gone.lmp")), bounces == "0" ? 0 : 1) << said_;
    }
}

// An external map is looked for from the folder of the map that names it.
TEST_F(Program, MapsOfOtherFilesAreIncluded) {
    const auto naming = [](const std::string& name) { return entity("misc_external_map", {{"_external_map", name}}); };
    const std::string start = entity_at("info_player_start", {32, 32, 28});
    fs::create_directories(path("sub"));
    write_file(path("sub/room.map"), level("", naming("../walls.map")));
    write_file(path("walls.map"), level(room({0, 0, 0}, {64, 64, 64})));
    const std::string command = path("whole.map") + " -o " + path("whole.bsp") + " --wad " + path("t.wad");
    write_file(path("whole.map"), level("", naming("sub\\room.map") + start));
    EXPECT_EQ(run(command + " --strict"), 0) << said_;
    for (const std::string name : {"gone.map", "sub"}) {
        write_file(path("whole.map"), level("", naming(name) + start));
        EXPECT_EQ(run(command), 1);
        EXPECT_EQ(said_.find("oblong-map: " + path("whole.map") + ": line 4: \"_external_map\" names '" + name + "', "),
                  0u)
            << said_;
    }
    write_file(path("walls.map"), level("", naming("sub/room.map")));
    write_file(path("whole.map"), level("", naming("walls.map") + start));
    EXPECT_EQ(run(command), 1);
    EXPECT_NE(said_.find("includes itself"), std::string::npos) << said_;
}

// Colours of the last 32 are taken only for textures that may glow.
TEST_F(Program, AFolderOfPicturesIsPackedByItself) {
    Palette palette{};
    for (std::size_t i = 0; i < 256; ++i)
        palette.colours[i] = {static_cast<std::uint8_t>(i), static_cast<std::uint8_t>(i), 0};
    Palette other = palette;
    other.colours[0].blue = 255;  // not the palette of the game: its indices mean nothing
    fs::create_directories(path("pictures"));
    std::string bytes;
    for (const Rgb8& colour : palette.colours)
        bytes += {static_cast<char>(colour.red), static_cast<char>(colour.green), static_cast<char>(colour.blue)};
    write_file(path("pictures/palette.lmp"), bytes);
    write_file(path("pictures/wall.png"), encode_indexed_png(std::vector<std::uint8_t>(256, 250), 16, 16, other));
    const std::string command = path("good.map") + " -o " + path("good.bsp") + " --wad " + path("pictures");
    const auto first_texel = [&] {
        const auto file = read_file(path("good.bsp"));
        return int{read_bsp_textures(file).front().mips[0].front()};
    };
    EXPECT_EQ(run(command), 0) << said_;
    EXPECT_EQ(first_texel(), 223);
    EXPECT_EQ(run(command + " --glow wall"), 0) << said_;
    EXPECT_EQ(first_texel(), 250);
    fs::create_directories(path("own"));
    fs::rename(path("pictures/palette.lmp"), path("own/colours.lmp"));
    write_file(path("own/game.json"), R"({"title": "Own", "palette": "colours.lmp", "levels": ["one"]})");
    EXPECT_EQ(run(command + " --game " + path("own")), 0) << said_;
    EXPECT_EQ(first_texel(), 223) << "of the game";
    EXPECT_EQ(run(command), 0) << said_;
    EXPECT_NE(first_texel(), 223) << "of the museum, whose colours are others";
    EXPECT_EQ(run(command + " --glow wlal"), 2);
    EXPECT_EQ(run(command + " --dither ordered"), 2);
    fs::remove(path("pictures/wall.png"));
    EXPECT_EQ(run(command), 1);
    EXPECT_NE(said_.find("has no pictures"), std::string::npos) << said_;
}

TEST_F(Program, MakesAPartOfALevelOnlyIfThereIsOne) {
    const std::string command = path("good.map") + " -o " + path("good.bsp") + " --wad " + path("t.wad");
    EXPECT_EQ(run(command + " --only light"), 1);
    EXPECT_EQ(said_, "oblong-map: " + path("good.bsp") +
                         ": --only: there is no such level yet: compile it once without --only\n");
    EXPECT_EQ(run(command + " --prt " + path("good.prt")), 0) << said_;
    const std::string portals = read_text(path("good.prt"));
    EXPECT_EQ(run(command + " --only light --prt " + path("good.prt")), 2);
    EXPECT_NE(said_.find("--prt: --only light makes no portals"), std::string::npos) << said_;
    EXPECT_EQ(read_text(path("good.prt")), portals);
    EXPECT_EQ(run(command + " --only light"), 0) << said_;
    EXPECT_EQ(read_text(path("out.txt")).find("portals"), std::string::npos);
    EXPECT_EQ(run(command + " --only vis"), 0) << said_;
    EXPECT_EQ(run(command + " --since " + path("good.map")), 0) << said_;
    EXPECT_EQ(read_text(path("out.txt")).find("portals"), std::string::npos);
    EXPECT_EQ(run(command + " --since " + path("gone.map")), 1);
    EXPECT_EQ(said_.rfind("oblong-map: " + path("gone.map") + ": open", 0), 0u) << said_;
    EXPECT_EQ(run(command + " --since " + path("good.map") + " --only light"), 2);
}

TEST_F(Program, ReplacesNoSourceAndNoFileButALevel) {
    const std::string source = read_text(path("good.map"));
    for (const char* option : {" -o ", " -o o.bsp --prt ", " -o o.bsp --reads "}) {
        EXPECT_EQ(run(path("good.map") + option + path("./good.map") + " --wad " + path("t.wad")), 2);
        EXPECT_NE(said_.find("good.map' is read or written for another option"), std::string::npos) << said_;
        EXPECT_EQ(read_text(path("good.map")), source) << option;
    }
    const std::string wad = read_text(path("t.wad"));
    write_file(path("named.map"), replaced(source, "\"worldspawn\"", "\"worldspawn\"\n\"wad\" \"t.wad\""));
    for (const char* option : {" --prt ", " --reads "}) {
        EXPECT_EQ(run(path("named.map") + " -o " + path("o.bsp") + option + path("./t.wad")), 2);
        EXPECT_NE(said_.find("t.wad' is read or written for another option"), std::string::npos) << said_;
        EXPECT_EQ(read_text(path("t.wad")), wad) << option;
    }
    EXPECT_EQ(run("--fgd " + path("good.map")), 2);
    EXPECT_EQ(read_text(path("good.map")), source);
    for (int i = 0; i < 2; ++i) EXPECT_EQ(run("--fgd " + path("own.fgd")), 0) << said_;
    const std::string other = read_text(path("odd.map")), command = path("good.map") + " --wad " + path("t.wad");
    EXPECT_EQ(run(command + " -o " + path("odd.map")), 2);
    EXPECT_NE(said_.find("is there and no level"), std::string::npos) << said_;
    EXPECT_EQ(read_text(path("odd.map")), other);
    const std::string fgd = " --fgd " + path("new"), editor = " --install-trenchbroom " + path("new");
    for (const std::string& two : {command + " -o " + path("o.bsp") + fgd, command + editor, fgd + editor}) {
        EXPECT_EQ(run(two), 2) << "one of two tasks would be left out";
        EXPECT_NE(said_.find("excludes"), std::string::npos) << said_;
        EXPECT_FALSE(std::filesystem::exists(path("new")));
    }
    write_file(path("good.bsp"), "");
    for (int i = 0; i < 2; ++i) EXPECT_EQ(run(command + " -o " + path("good.bsp")), 0) << said_;
}

// --help shows one value for each --wad, as no more are taken.
TEST_F(Program, TakesOneWadForEachOption) {
    const std::string wad = " --wad " + path("t.wad");
    EXPECT_EQ(run(wad + wad + wad + " " + path("good.map") + " -o " + path("good.bsp")), 0) << said_;
    EXPECT_EQ(run("--help"), 0);
    EXPECT_NE(read_text(path("out.txt")).find("--wad TEXT  "), std::string::npos) << read_text(path("out.txt"));
    EXPECT_NE(read_text(path("out.txt")).find("--dither TEXT=none  "), std::string::npos) << "what it is without";
}

TEST_F(Program, ALevelWithoutALeakRemovesTheWayOut) {
    write_file(path("good.pts"), "0 0 0\n");
    EXPECT_EQ(run(path("good.map") + " -o " + path("good.bsp") + " --wad " + path("t.wad")), 0) << said_;
    EXPECT_EQ(files_beginning_with("good.pts"), 0);
    EXPECT_EQ(run(path("good.map") + " -o " + path("good.pts") + " --wad " + path("t.wad")), 0) << said_;
    EXPECT_EQ(files_beginning_with("good.pts"), 1) << "the level itself has that name";
}

TEST_F(Program, SaysWhatIsWrongAndWhere) {
    EXPECT_EQ(run(path("bad.map") + " -o " + path("bad.bsp")), 1);
    EXPECT_EQ(said_.find("oblong-map: " + path("bad.map") + ": line 1: "), 0u) << said_;
    EXPECT_EQ(run(path("none.map") + " -o " + path("bad.bsp")), 1);
    EXPECT_EQ(said_.find("oblong-map: " + path("none.map") + ": "), 0u) << said_;
    EXPECT_EQ(run(path("good.map") + " -o " + path("bad.bsp") + " --wad " + path("t.wad") + " --dither x"), 2);
    EXPECT_EQ(run(path("good.map") + " -o " + path("bad.bsp") + " --wad " + path("none.wad")), 1);
    EXPECT_EQ(said_.find("oblong-map: " + path("none.wad") + ": "), 0u) << said_;
    EXPECT_EQ(files_beginning_with("bad.bsp"), 0);
}

TEST_F(Program, ALeakWritesTheWayOut) {
    EXPECT_EQ(run(path("leak.map") + " -o " + path("leak.bsp") + " --wad " + path("t.wad")), 1);
    EXPECT_NE(said_.find("light at 0 0 99"), std::string::npos) << said_;
    EXPECT_NE(said_.find(path("leak.pts") + " has the path to the void"), std::string::npos) << said_;
    EXPECT_EQ(read_text(path("leak.pts")).substr(0, 7), "0 0 99\n");
    EXPECT_EQ(files_beginning_with("leak.bsp"), 0);
    fs::remove(path("leak.pts"));
    EXPECT_EQ(run(path("leak.map") + " -o " + path("leak.bsp") + " --wad " + path("t.wad") + " --fast --strict"), 1);
    EXPECT_EQ(files_beginning_with("leak."), 1) << "the source alone";
}

// From the light, which lies over the only brush, all of its six sides may be seen.
TEST_F(Program, ADraftThatLeaksIsALevelWithItsOutside) {
    EXPECT_EQ(run(path("leak.map") + " -o " + path("leak.bsp") + " --wad " + path("t.wad") + " --fast"), 0);
    EXPECT_NE(said_.find("warning: the level leaks: light at 0 0 99"), std::string::npos) << said_;
    EXPECT_EQ(read_text(path("leak.pts")).substr(0, 7), "0 0 99\n");
    EXPECT_EQ(read_bsp(read_file(path("leak.bsp"))).faces.size(), 6u);
    EXPECT_EQ(run(path("leak.map") + " -o " + path("leak.bsp") + " --wad " + path("t.wad") + " --fast --only light"),
              0);
    EXPECT_EQ(files_beginning_with("leak.pts"), 1);
}

TEST_F(Program, ADraftOfBrushesThatEncloseNothingShowsThem) {
    write_file(path("piece.map"), level(box({0, 0, 0}, {64, 64, 64})));
    EXPECT_EQ(run(path("piece.map") + " -o " + path("piece.bsp") + " --wad " + path("t.wad")), 1);
    EXPECT_EQ(run(path("piece.map") + " -o " + path("piece.bsp") + " --wad " + path("t.wad") + " --fast"), 0) << said_;
    EXPECT_EQ(read_bsp(read_file(path("piece.bsp"))).faces.size(), 6u);
}

TEST_F(Program, LeavesNoPartOfAFileThatCannotBeWritten) {
    fs::create_directory(path("taken.bsp"));
    EXPECT_EQ(run(path("good.map") + " -o " + path("taken.bsp") + " --wad " + path("t.wad")), 1);
    EXPECT_NE(said_.find("taken.bsp: write: "), std::string::npos) << said_;
    EXPECT_EQ(read_text(path("out.txt")), "") << "nothing was made";
    EXPECT_EQ(files_beginning_with("taken.bsp"), 1) << "the folder that stands in the way";
    EXPECT_EQ(run(path("bad.map") + " -o " + path("no/such/folder.bsp")), 1);
    EXPECT_NE(said_.find("folder.bsp: write: "), std::string::npos) << "before anything is compiled: " << said_;
}

}  // namespace
}  // namespace oblong::test
