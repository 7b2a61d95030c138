#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

#include "engine/io/game_files.h"
#include "game/level/level_search.h"
#include "game/level/load.h"
#include "tests/mesh_files/mdl_writer.h"
#include "tests/support/bsp_writer.h"
#include "tests/support/folders.h"
#include "tests/support/refusal.h"

namespace oblong::test {
namespace {

struct PakFile {
    std::string name;
    Bytes data;
};

/// A pak file: header, the files' data, directory; as id's tools write it.
Bytes write_pak(const std::vector<PakFile>& files) {
    std::int32_t size = 12;
    for (const PakFile& file : files) size += static_cast<std::int32_t>(file.data.size());
    Bytes bytes;
    ByteWriter out(bytes);
    out.text("PACK").i32(size).i32(static_cast<std::int32_t>(64 * files.size()));
    for (const PakFile& file : files) bytes.insert(bytes.end(), file.data.begin(), file.data.end());
    std::int32_t offset = 12;
    for (const PakFile& file : files) {
        out.text(file.name);
        bytes.resize(bytes.size() + 56 - file.name.size());
        out.i32(offset).i32(static_cast<std::int32_t>(file.data.size()));
        offset += static_cast<std::int32_t>(file.data.size());
    }
    return bytes;
}

// "a.txt" at 12, "maps/b.bsp" at 15, the directory at 20 to 148.
const Bytes kPak = write_pak({{"a.txt", {1, 2, 3}}, {"maps/b.bsp", {4, 5, 6, 7, 8}}});

std::vector<PakEntry> read(const Bytes& bytes) {
    const PakHeader header = read_pak_header(bytes, bytes.size());
    const auto directory = std::span(bytes).subspan(header.directory_offset, header.directory_length);
    return read_pak_directory(directory, header, bytes.size());
}

std::string fault_of(const Bytes& bytes) {
    return refusal([&] { read(bytes); });
}

// Of the pak with another number at an offset.
std::string fault_with(std::size_t offset, std::uint32_t number) {
    Bytes bytes = kPak;
    put_number(bytes, offset, 4, number);
    return fault_of(bytes);
}

TEST(Pak, IsReadAsItWasWritten) {
    const std::vector<PakEntry> entries = read(kPak);
    ASSERT_EQ(entries.size(), 2u);
    EXPECT_EQ(entries[0].name, "a.txt");
    EXPECT_EQ(entries[0].offset, 12u);
    EXPECT_EQ(entries[0].length, 3u);
    EXPECT_EQ(entries[1].name, "maps/b.bsp");
    EXPECT_EQ(entries[1].offset, 15u);
    EXPECT_EQ(entries[1].length, 5u);
    EXPECT_TRUE(read(write_pak({})).empty());
}

TEST(Pak, EachCutAndEachLieOfTheHeaderIsNamed) {
    for (std::size_t size = 0; size < kPak.size(); ++size)
        EXPECT_NE(fault_of(Bytes(kPak.begin(), kPak.begin() + static_cast<std::ptrdiff_t>(size))), "") << size;
    EXPECT_EQ(fault_with(0, 0x4b434151), "offset 0: no pak file: expected 'PACK' and 8 more bytes");
    EXPECT_EQ(fault_with(4, 21),
              "offset 4: a directory of 128 bytes at 21, expected it behind the header in a file of 148");
    EXPECT_EQ(fault_with(4, 0),
              "offset 4: a directory of 128 bytes at 0, expected it behind the header in a file of 148");
    EXPECT_NE(fault_with(4, 0xffffffff), "");
    EXPECT_EQ(fault_with(8, 127), "offset 8: a directory of 127 bytes, expected a multiple of 64");
    EXPECT_NE(fault_with(8, 0xffffffc0), "");
}

TEST(Pak, EachLieOfTheDirectoryIsNamed) {
    EXPECT_EQ(fault_with(20 + 60, 200), "offset 76: a.txt has 200 bytes from 12 on, expected them in the file's 148");
    EXPECT_NE(fault_with(20 + 60, 0xffffffff), "");
    EXPECT_NE(fault_with(20 + 56, 0xffffffff), "");
    EXPECT_EQ(fault_with(20 + 60, 4), "offset 84: data from 15 on, where other data is, expected it apart");
    EXPECT_EQ(fault_with(20 + 56, 11), "offset 20: data from 11 on, where other data is, expected it apart");
    EXPECT_EQ(fault_with(84 + 56, 30), "offset 84: data from 30 on, where other data is, expected it apart");
    EXPECT_EQ(fault_with(84, 0), "offset 84: an entry without a name, expected one");
    Bytes endless = kPak;
    std::fill_n(endless.begin() + 20, 56, std::uint8_t{'x'});
    EXPECT_EQ(fault_of(endless), "offset 20: a name without an end, expected a zero byte among its 56");
    Bytes same = kPak;
    put_number(same, 84 + 56, 4, 12);
    put_number(same, 84 + 60, 4, 3);
    EXPECT_EQ(fault_of(same), "") << "two names of the same data";
}

Bytes level_with(const std::string& entities) {
    Lumps lumps = make_tiny_lumps();
    Bytes& text = lump_of(lumps, Lump::Entities);
    const std::string whole = "{ \"classname\" \"worldspawn\" }" + entities;
    text.assign(whole.begin(), whole.end());
    text.push_back(0);
    return join_lumps(29, lumps);
}

Bytes palette_of(std::uint8_t grey) {
    return Bytes(768, grey);
}

// A game with two pak files; a level, e1m2, stands beside them too.
class Game : public ::testing::Test {
  protected:
    Game() {
        for (const char* below : {"game", "game/maps", "game/gfx", "mine"}) make_folder(folder_.path(below));
        folder_.write("game/pak0.pak", write_pak({{"gfx/palette.lmp", palette_of(40)},
                                                  {"maps/b_shell0.bsp", level_with("")},
                                                  {"maps/e1m1.bsp", level_with("{ \"zero\" \"\" }")},
                                                  {"maps/e1m2.bsp", level_with("")},
                                                  {"maps/e1m3.bsp", level_with("{ \"old\" \"\" }")},
                                                  {"progs/w_s_key.mdl", model()}}));
        folder_.write("game/pak1.pak", write_pak({{"maps/e1m3.bsp", level_with("{ \"new\" \"\" }")}}));
        folder_.write("game/maps/e1m2.bsp", level_with("{ \"loose\" \"\" }"));
        folder_.write("mine/e1m9.bsp", level_with(""));
        places_.game_folders = {folder_.path("game")};
    }
    static Bytes model() { return write_mdl(tetrahedron_model()); }

    TemporaryFolder folder_;
    LevelPlaces places_;
};

TEST_F(Game, ALevelIsFoundBesideThenInMapsThenInTheLastPakFile) {
    EXPECT_EQ(find_level("e1m1", places_), folder_.path("game/pak0.pak/maps/e1m1.bsp"));
    EXPECT_EQ(find_level("e1m2", places_), folder_.path("game/maps/e1m2.bsp"));
    EXPECT_EQ(find_level("e1m3", places_), folder_.path("game/pak1.pak/maps/e1m3.bsp"));
    EXPECT_EQ(find_level("e1m9", places_), std::nullopt);
    places_.beside = folder_.path("mine/start.bsp");
    EXPECT_EQ(find_level("e1m9", places_), folder_.path("mine/e1m9.bsp"));
    places_.beside = folder_.path("game/pak0.pak/maps/e1m1.bsp");
    EXPECT_EQ(find_level("e1m3", places_), folder_.path("game/pak1.pak/maps/e1m3.bsp"));
}

TEST_F(Game, APakFileInCapitalsIsFoundAndReadAsOneInSmallLetters) {
    std::filesystem::rename(folder_.path("game/pak0.pak"), folder_.path("game/PAK0.PAK"));
    std::filesystem::rename(folder_.path("game/pak1.pak"), folder_.path("game/Pak1.pak"));
    EXPECT_TRUE(GameFiles(places_.game_folders).has_paks());
    EXPECT_EQ(find_level("e1m1", places_), folder_.path("game/PAK0.PAK/maps/e1m1.bsp"));
    EXPECT_EQ(find_level("e1m3", places_), folder_.path("game/Pak1.pak/maps/e1m3.bsp"));
    EXPECT_EQ(read_game_file(folder_.path("game/PAK0.PAK/gfx/palette.lmp")), palette_of(40));
    folder_.write("game/pak0.pak", write_pak({{"maps/e1m1.bsp", level_with("")}}));
    EXPECT_EQ(find_level("e1m1", places_), folder_.path("game/pak0.pak/maps/e1m1.bsp")) << "not the other one's";
}

TEST_F(Game, AFolderWithAPakFilesNameIsNone) {
    make_folder(folder_.path("game/pak2.pak"));
    EXPECT_EQ(find_level("e1m1", places_), folder_.path("game/pak0.pak/maps/e1m1.bsp"));
}

TEST_F(Game, QuakesFolderIsFoundInAnyCase) {
    namespace fs = std::filesystem;
    const fs::path before = fs::current_path();
    for (const std::string id1 : {"id1", "ID1", "Id1", "iD1"}) {
        const std::string below = "of_" + id1 + "/" + id1;
        for (const std::string& folder : {"of_" + id1, below, below + "/MAPS"}) make_folder(folder_.path(folder));
        fs::copy(folder_.path("game/pak0.pak"), folder_.path(below + "/PAK0.PAK"));
        folder_.write(below + "/MAPS/E1M4.BSP", level_with(""));
        fs::current_path(folder_.path("of_" + id1));
        EXPECT_EQ(find_level("e1m1", {"", game_folders_of("")}), id1 + "/PAK0.PAK/maps/e1m1.bsp");
        EXPECT_EQ(find_level("e1m4", {"", game_folders_of("")}), id1 + "/MAPS/E1M4.BSP");
        fs::current_path(before);
    }
}

TEST_F(Game, ANameLeadsToNoOtherFolder) {
    for (const char* name : {"", "../mine/e1m9", "maps/e1m1", "..", ".hidden", "a\\b"})
        EXPECT_EQ(find_level(name, places_), std::nullopt) << name;
    EXPECT_THROW(find_named_level("../mine/e1m9", places_), FileError);
}

TEST_F(Game, AMissingLevelIsNamedWithAllPlacesWhereItWasLookedFor) {
    places_.beside = folder_.path("mine/start.bsp");
    const std::string text = refusal<FileError>([&] { find_named_level("e1m8", places_); });
    for (const std::string& part : {std::string("e1m8.bsp: "), folder_.path("mine"), std::string(" maps,"),
                                    folder_.path("game/maps"), "pak files in " + folder_.path("game")})
        EXPECT_NE(text.find(part), std::string::npos) << text;
}

TEST_F(Game, AllLevelsAreListedOnceTheDemoLevelFirst) {
    folder_.write("game/maps/mine-draft.bsp", "");
    const LevelList list = list_levels(places_);
    EXPECT_TRUE(list.problems.empty());
    ASSERT_GE(list.levels.size(), 4u);
    EXPECT_EQ(list.levels[0].name, "demo");
    EXPECT_EQ(list.levels[0].file, "");
    std::vector<ListedLevel> others;
    for (const ListedLevel& level : list.levels)
        if (level.file.starts_with(folder_.path())) others.push_back(level);
    ASSERT_EQ(others.size(), 3u) << "no boxes of ammunition, no drafts";
    EXPECT_EQ(others[0].file, folder_.path("game/maps/e1m2.bsp"));
    EXPECT_EQ(others[1].file, folder_.path("game/pak0.pak/maps/e1m1.bsp"));
    EXPECT_EQ(others[2].file, folder_.path("game/pak1.pak/maps/e1m3.bsp"));
    EXPECT_EQ(others[2].name, "e1m3");
}

TEST_F(Game, ABrokenPakFileIsNamedAndItsLevelsAreNotListed) {
    const std::string broken = folder_.write("game/pak1.pak", "PACK");
    const LevelList list = list_levels(places_);
    ASSERT_EQ(list.problems.size(), 1u);
    EXPECT_TRUE(list.problems[0].starts_with(broken + ": offset 0: ")) << list.problems[0];
    EXPECT_EQ(find_level("e1m2", places_), folder_.path("game/maps/e1m2.bsp")) << "not looked into";
    EXPECT_THROW(find_level("e1m1", places_), FileError);
}

TEST_F(Game, ALevelOutOfAPakFileComesWithPaletteAndModels) {
    folder_.write("game/pak1.pak",
                  write_pak({{"maps/e1m4.bsp", level_with("{ \"classname\" \"item_key1\" \"origin\" \"9 9 40\" }"
                                                          "{ \"classname\" \"item_key1\" \"origin\" \"5 5 40\" "
                                                          "\"spawnflags\" \"512\" }")}}));
    const std::string file = find_named_level("e1m4", places_);
    const GameData data = load_game({file, "", folder_.path("mine"), ""});
    EXPECT_EQ(data.level_file, file);
    EXPECT_EQ(data.level.entities.size(), 3u);
    EXPECT_EQ(data.palette.colours[7].green, 40);
    ASSERT_EQ(data.models.models.size(), 1u) << "the other is not there at normal skill";
    EXPECT_EQ(data.models.models[0].entity, 1u);
}

TEST_F(Game, ALoosePaletteComesBeforeThoseOfPakFiles) {
    folder_.write("game/gfx/palette.lmp", palette_of(9));
    EXPECT_EQ(load_game({find_named_level("e1m1", places_), "", folder_.path("mine"), ""}).palette.colours[7].green, 9);
    EXPECT_EQ(load_game({find_named_level("e1m2", places_), "", folder_.path("mine"), ""}).palette.colours[7].green, 9)
        << "in the folder above";
}

Bytes lit_file(int colours) {
    Bytes bytes;
    ByteWriter(bytes).text("QLIT").i32(1);
    bytes.resize(bytes.size() + static_cast<std::size_t>(colours), 9);
    return bytes;
}

TEST_F(Game, ColoursOfLightAreReadFromAFileBesideTheLevelIfItIsOfThatLevel) {
    folder_.write("game/gfx/palette.lmp", palette_of(9));
    folder_.write("game/maps/e1m2.lit", lit_file(24));
    folder_.write("game/pak1.pak", write_pak({{"maps/e1m3.bsp", level_with("")}, {"maps/e1m3.lit", lit_file(24)}}));
    for (const char* level : {"e1m2", "e1m3"}) {
        const GameData data = load_game({find_named_level(level, places_), "", folder_.path("mine"), ""});
        EXPECT_EQ(data.level.coloured_lighting, Bytes(24, 9)) << level << " has eight samples";
    }
    folder_.write("game/maps/e1m2.lit", lit_file(21));
    const std::string file = find_named_level("e1m2", places_);
    Level level = load_game({file, "", folder_.path("mine"), ""}).level;
    EXPECT_TRUE(level.coloured_lighting.empty());
    const std::vector<std::string> warnings = read_lit_file_beside(file, level);
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_EQ(warnings[0],
              "e1m2.lit: offset 8: 21 bytes of colours, expected 24, three for each light sample of the level: all "
              "light is white");
    folder_.write("game/maps/e1m2.lit", lit_file(24));
    level.coloured_lighting.assign(24, 1);
    EXPECT_TRUE(read_lit_file_beside(file, level).empty());
    EXPECT_EQ(level.coloured_lighting, Bytes(24, 1)) << "a level's own are kept";
}

TEST_F(Game, AFaultInALevelOfAPakFileIsNamedByItsPath) {
    const Bytes broken(40, 7);
    folder_.write("game/pak0.pak", write_pak({{"maps/bad.bsp", broken}}));
    const std::string file = find_named_level("bad", places_);
    const std::string said = refusal<FileError>([&] { load_game({file, "", folder_.path("mine"), ""}); });
    EXPECT_TRUE(said.starts_with(file + ": ")) << said;
    EXPECT_THROW(read_game_file(folder_.path("game/pak0.pak/maps/none.bsp")), FileError);
}

}  // namespace
}  // namespace oblong::test
