#include <gtest/gtest.h>

#include <limits>

#include "tests/level/level_file.h"

namespace oblong::test {

namespace {

/// One wrong number in one lump of the tiny level, which the error names.
struct Damage {
    const char* what;
    Lump lump;
    std::size_t offset;  ///< in the lump
    int size;            ///< bytes
    std::int64_t value;
};

std::int64_t bits_of(float value) {
    return std::bit_cast<std::uint32_t>(value);
}
constexpr float kNan = std::numeric_limits<float>::quiet_NaN(), kInfinity = std::numeric_limits<float>::infinity();

const std::vector<Damage> kDamages = {
    {"NaN in a plane's normal", Lump::Planes, 0, 4, bits_of(kNan)},
    {"infinite normal", Lump::Planes, 8, 4, bits_of(kInfinity)},
    {"normal of length 0", Lump::Planes, 8, 4, bits_of(0)},
    {"normal of length 1.1", Lump::Planes, 8, 4, bits_of(1.1F)},
    {"NaN in a plane's distance", Lump::Planes, 12, 4, bits_of(kNan)},
    {"distance past the world", Lump::Planes, 12, 4, bits_of(1048576.F)},
    {"NaN in a vertex", Lump::Vertices, 4, 4, bits_of(kNan)},
    {"vertex outside the world", Lump::Vertices, 8, 4, bits_of(-524288.F)},
    {"negative count of textures", Lump::Textures, 0, 4, -1},
    {"too many textures", Lump::Textures, 0, 4, 1 << 30},
    {"texture outside the lump", Lump::Textures, 4, 4, 1000},
    {"texture at a negative offset", Lump::Textures, 4, 4, -2},
    {"mip level outside the lump", Lump::Textures, 44, 4, 377},
    {"mip level far outside the lump", Lump::Textures, 32, 4, 0xffffffff},
    {"mip level inside its header", Lump::Textures, 32, 4, 39},
    {"no last mip level, but the first", Lump::Textures, 44, 4, 0},
    {"visible row past the lump", Lump::Visibility, 0, 1, 0},
    {"node's plane", Lump::Nodes, 0, 4, 1},
    {"node's leaf", Lump::Nodes, 4, 2, -3},
    {"node below itself", Lump::Nodes, 6, 2, 0},
    {"node's faces", Lump::Nodes, 22, 2, 2},
    {"texture axis out of its format", Lump::TexInfos, 0, 4, bits_of(256.F)},
    {"texture axis that overflows its format when it is rounded", Lump::TexInfos, 0, 4, bits_of(255.99998F)},
    {"NaN in a texture axis", Lump::TexInfos, 16, 4, bits_of(kNan)},
    {"texture offset out of its format", Lump::TexInfos, 12, 4, bits_of(2e9F)},
    {"texinfo's texture", Lump::TexInfos, 32, 4, 1},
    {"texinfo's texture, negative", Lump::TexInfos, 32, 4, -1},
    {"face's plane", Lump::Faces, 0, 2, 1},
    {"face's first surfedge, negative", Lump::Faces, 4, 4, -1},
    {"face of two edges", Lump::Faces, 8, 2, 2},
    {"face's edges", Lump::Faces, 8, 2, 5},
    {"face's texinfo", Lump::Faces, 10, 2, 1},
    {"face's light past the lump", Lump::Faces, 16, 4, 1},
    {"face's light, negative", Lump::Faces, 16, 4, -2},
    {"second light style past the lump", Lump::Faces, 13, 1, 3},
    {"clipnode's plane", Lump::ClipNodes, 0, 4, -1},
    {"clipnode below itself", Lump::ClipNodes, 4, 2, 0},
    {"clipnode's contents", Lump::ClipNodes, 4, 2, -17},
    {"first leaf not solid", Lump::Leaves, 0, 4, -1},
    {"leaf's contents", Lump::Leaves, 28, 4, 0},
    {"leaf's visibility", Lump::Leaves, 32, 4, 2},
    {"leaf's visibility, negative", Lump::Leaves, 32, 4, -2},
    {"leaf's markfaces", Lump::Leaves, 50, 2, 2},
    {"markface's face", Lump::MarkFaces, 0, 2, 1},
    {"edge's vertex", Lump::Edges, 18, 2, 4},
    {"surfedge's edge", Lump::SurfEdges, 0, 4, 5},
    {"surfedge's edge, backward", Lump::SurfEdges, 0, 4, -5},
    {"surfedge without a negative", Lump::SurfEdges, 0, 4, std::numeric_limits<std::int32_t>::min()},
    {"NaN in a model's box", Lump::Models, 0, 4, bits_of(kNan)},
    {"infinite origin", Lump::Models, 24, 4, bits_of(-kInfinity)},
    {"model's node", Lump::Models, 36, 4, 1},
    {"model's leaf", Lump::Models, 36, 4, -3},
    {"model's clipnode", Lump::Models, 40, 4, 1},
    {"model's visible leaves", Lump::Models, 52, 4, 2},
    {"model's visible leaves, negative", Lump::Models, 52, 4, -1},
    {"model's faces", Lump::Models, 60, 4, 2},
    {"model's faces, overflowing", Lump::Models, 56, 4, 0x7fffffff},
};

std::string fault_in(const Lumps& lumps) {
    return fault_of(join_lumps(29, lumps));
}
std::string fault_with(const Damage& damage, Lumps lumps = make_tiny_lumps()) {
    put_number(lump_of(lumps, damage.lump), damage.offset, damage.size, damage.value);
    return fault_in(lumps);
}
testing::AssertionResult is_in(const char* lump, const std::string& where) {
    if (where.starts_with("lump '" + std::string(lump) + "', offset ")) return testing::AssertionSuccess();
    return testing::AssertionFailure() << "'" << where << "', expected lump " << lump;
}

TEST(BadInput, OneWrongNumberNamesItsLump) {
    for (const Damage& damage : kDamages)
        EXPECT_TRUE(is_in(kLumpNames[static_cast<std::size_t>(damage.lump)], fault_with(damage))) << damage.what;
}

/// Indices are in range, but the face would be invisible, or its texture would lie askew.
TEST(BadInput, AFaceThatIsNotClockwiseOnItsPlaneIsRefused) {
    for (const Damage& damage : {Damage{"the other side", Lump::Faces, 2, 2, 1},
                                 {"a normal down", Lump::Planes, 8, 4, bits_of(-1)},
                                 {"a plane below", Lump::Planes, 12, 4, bits_of(6.5F)},
                                 {"a plane above", Lump::Planes, 12, 4, bits_of(9.5F)},
                                 {"a corner off the plane", Lump::Vertices, 2 * 12 + 8, 4, bits_of(9.5F)}})
        EXPECT_TRUE(is_in("faces", fault_with(damage))) << damage.what;
    Lumps backward = make_tiny_lumps();
    lump_of(backward, Lump::SurfEdges).clear();
    ByteWriter(lump_of(backward, Lump::SurfEdges)).i32(-4).i32(-3).i32(2).i32(-1);
    EXPECT_TRUE(is_in("faces", fault_in(backward)));
    put_number(lump_of(backward, Lump::Faces), 2, 2, 1);
    put_number(lump_of(backward, Lump::Planes), 8, 4, bits_of(-1));
    EXPECT_EQ(fault_with({"a normal down", Lump::Planes, 12, 4, bits_of(-8)}, backward).substr(0, 12), "lump 'faces'")
        << "seen from below again";
}

TEST(BadInput, FacesAsCompilersLeaveThemAreTaken) {
    EXPECT_EQ(fault_with({"a rounded corner", Lump::Vertices, 8, 4, bits_of(8.5F)}), "");
    Lumps narrow = make_tiny_lumps();
    for (const std::size_t corner : {1u, 3u})
        put_number(lump_of(narrow, Lump::Vertices), corner * 12 + 4, 4, bits_of(0.25F));
    EXPECT_EQ(fault_with({"a face too narrow to tell", Lump::Faces, 2, 2, 1}, narrow), "");
    for (const std::size_t corner : {1u, 3u})
        put_number(lump_of(narrow, Lump::Vertices), corner * 12 + 4, 4, bits_of(2.F));
    EXPECT_NE(fault_with({"two units", Lump::Faces, 2, 2, 1}, narrow), "");
}

TEST(BadInput, TreesOfModelsAreTheirOwn) {
    const auto with_model = [](std::int32_t root, Lumps lumps = make_tiny_lumps(), std::int32_t faces = 1) {
        ByteWriter(lump_of(lumps, Lump::Models)).number(36, 0).i32(root).number(16, 0).i32(0).i32(faces);
        return fault_in(lumps);
    };
    EXPECT_EQ(with_model(-1), "") << "a leaf";
    EXPECT_TRUE(is_in("models", with_model(0))) << "the world's tree";
    EXPECT_EQ(with_model(0, make_tiny_lumps(), 0), "") << "without faces, as qbsp writes it";
    Lumps two = make_tiny_lumps();
    ByteWriter(lump_of(two, Lump::Nodes)).i32(0).i16(-1).i16(-1).number(16, 0);
    EXPECT_EQ(with_model(1, two), "");
    put_number(lump_of(two, Lump::Nodes), 6, 2, 1);
    EXPECT_TRUE(is_in("models", with_model(1, two))) << "a node of the world's tree";
    EXPECT_TRUE(is_in("models", fault_with({"the world begins at its second node", Lump::Models, 36, 4, 1}, two)));
    EXPECT_TRUE(is_in("nodes", fault_with({"a node's face of no model", Lump::Models, 60, 4, 0})));
    Lumps planes = make_tiny_lumps();
    ByteWriter(lump_of(planes, Lump::Planes)).f32(0).f32(0).f32(1).f32(9).i32(2);
    EXPECT_TRUE(is_in("nodes", fault_with({"a node's plane", Lump::Nodes, 0, 4, 1}, planes)));
    // The same of a node below the root, which has the face then.
    Bytes& nodes = lump_of(planes, Lump::Nodes);
    nodes.insert(nodes.end(), nodes.begin(), nodes.begin() + 24);
    put_number(nodes, 22, 2, 0);
    put_number(nodes, 4, 2, 1);
    EXPECT_EQ(fault_in(planes), "");
    const std::uint32_t at = number_at(join_lumps(29, planes), 4 + 5 * 8, 4);
    EXPECT_EQ(fault_with({"a lower node's plane", Lump::Nodes, 24, 4, 1}, planes),
              "lump 'nodes', offset " + std::to_string(at + 24));
}

/// Its lit surface would take as much memory as the numbers of the file ask for, 64 GiB for some.
TEST(BadInput, HugeLitFacesAreRefusedInLevelsWithoutLightAsWell) {
    Lumps lumps = make_tiny_lumps();
    lump_of(lumps, Lump::Lighting).clear();
    EXPECT_EQ(fault_in(lumps), "");
    put_number(lump_of(lumps, Lump::TexInfos), 0, 4, bits_of(200.F));  // the face is 32 units wide
    EXPECT_TRUE(is_in("faces", fault_in(lumps)));
}

TEST(BadInput, ErrorTellsTheByteOfTheFile) {
    Lumps lumps = make_tiny_lumps();
    put_number(lump_of(lumps, Lump::Faces), 10, 2, 1);  // the texinfo
    const Bytes file = join_lumps(29, lumps);
    const std::uint32_t faces = number_at(file, 4 + 7 * 8, 4);
    EXPECT_EQ(fault_of(file), "lump 'faces', offset " + std::to_string(faces + 10));
}

TEST(BadInput, NoByteOfALumpIsInTheHeader) {
    for (const int size : {0, 1, 4}) {
        Bytes file = join_lumps(29, make_tiny_lumps());
        const std::size_t place = 4 + 8 * static_cast<std::size_t>(Lump::Lighting);
        put_number(file, place, 4, kBspHeaderSize - 1);
        put_number(file, place + 4, 4, size);
        const std::string fault = refusal([&] { read_bsp(file); });
        EXPECT_EQ(fault.starts_with("lump 'lighting', offset " + std::to_string(place)), size > 0) << fault;
    }
}

TEST(BadInput, ErrorSaysWhichRecordsThereAre) {
    Lumps lumps = make_tiny_lumps();
    put_number(lump_of(lumps, Lump::Faces), 10, 2, 1);  // the texinfo
    const auto said = [&] { return refusal([&] { read_bsp(join_lumps(29, lumps)); }); };
    EXPECT_TRUE(said().ends_with("1, expected 0 to 0")) << said();
    lump_of(lumps, Lump::TexInfos).clear();
    EXPECT_NE(said().find("1, expected none: the file has no "), std::string::npos) << said();
}

TEST(BadInput, BrokenEntitiesAreFound) {
    for (const char* text : {"{", "{ \"key\" }", "{ \"key", "\"classname\" \"worldspawn\"", "{ key \"value\" }", "}"}) {
        Lumps lumps = make_tiny_lumps();
        lump_of(lumps, Lump::Entities).assign(text, text + std::string_view(text).size());
        EXPECT_TRUE(is_in("entities", fault_in(lumps))) << text;
    }
}

TEST(BadInput, CycleOfTwoClipNodesIsFound) {
    Lumps lumps = make_tiny_lumps();
    Bytes& nodes = lump_of(lumps, Lump::ClipNodes);
    nodes.clear();
    ByteWriter(nodes).i32(0).i16(1).i16(-2).i32(0).i16(-1).i16(0);
    EXPECT_TRUE(is_in("clipnodes", fault_in(lumps)));
    put_number(nodes, 14, 2, -1);  // the way back: now a chain
    EXPECT_EQ(fault_in(lumps), "");
}

TEST(BadInput, ClipNodesMayShareASubtreeAndNodesMayNot) {
    Lumps lumps = make_tiny_lumps();
    ByteWriter(lump_of(lumps, Lump::ClipNodes)).i32(0).i16(0).i16(0);
    EXPECT_EQ(fault_in(lumps), "");
    ByteWriter(lump_of(lumps, Lump::Nodes)).i32(0).i16(0).i16(0).number(8, 0).i32(0).i16(0).i16(0);
    EXPECT_TRUE(is_in("nodes", fault_in(lumps)));
}

/// Adds 1,000 copies of a lump's last record, of so many bytes.
template <std::ptrdiff_t kSize, Lump kLump>
void repeat_record(Lumps& lumps) {
    Bytes& records = lump_of(lumps, kLump);
    const Bytes record(records.end() - kSize, records.end());
    for (int i = 0; i < 1000; ++i) records.insert(records.end(), record.begin(), record.end());
}

/// What makes a file of the tiny level that would take far more memory or time than its size.
struct Sharing {
    const char *what, *where;
    void (*spoil)(Lumps&);
};
constexpr Sharing kSharings[] = {
    {"an endlessly deep tree", "lump 'clipnodes'",
     [](Lumps& lumps) {
         Bytes& nodes = lump_of(lumps, Lump::ClipNodes);
         nodes.clear();
         for (int i = 1; i < 5000; ++i) ByteWriter(nodes).i32(0).i16(i).i16(-2);
         ByteWriter(nodes).i32(0).i16(-1).i16(-2);
     }},
    {"textures that share their bytes", "lump 'textures'",
     [](Lumps& lumps) {
         Bytes &textures = lump_of(lumps, Lump::Textures), table;
         ByteWriter(table).i32(100);
         for (int i = 0; i < 100; ++i) ByteWriter(table).i32(4 + 100 * 4);
         textures.erase(textures.begin(), textures.begin() + 8);
         textures.insert(textures.begin(), table.begin(), table.end());
     }},
    {"faces that share their edges", "lump 'faces'", repeat_record<20, Lump::Faces>},
    {"nodes that share their faces", "lump 'nodes'", repeat_record<24, Lump::Nodes>},
    {"leaves that share their markfaces", "lump 'leaves'", repeat_record<28, Lump::Leaves>},
    {"visible rows that overlap", "lump 'visibility'",
     [](Lumps& lumps) {
         constexpr int kLeaves = 1000;  // a row takes 125 bytes, and one starts at every byte
         lump_of(lumps, Lump::Visibility).assign(kLeaves + kLeaves / 8, 0xff);
         ByteWriter leaves(lump_of(lumps, Lump::Leaves));
         for (int i = 1; i < kLeaves; ++i) leaves.i32(contents::kEmpty).i32(i).number(8, 0).i32(0).i32(0).i32(0);
         put_number(lump_of(lumps, Lump::Models), 52, 4, kLeaves);
     }},
    {"a million missing textures", "lump 'textures'",
     [](Lumps& lumps) {
         Bytes& textures = lump_of(lumps, Lump::Textures);
         textures.assign(4 + 4 * 1000000, 0xff);
         put_number(textures, 0, 4, 1000000);
     }},
};

TEST(BadInput, WhatIsSharedOrMissingOverAndOverIsRefused) {
    for (const auto& [what, expected, spoil] : kSharings) {
        Lumps lumps = make_tiny_lumps();
        spoil(lumps);
        const std::string where = fault_in(lumps);
        EXPECT_TRUE(where.starts_with(expected)) << what << ": '" << where << "'";
    }
}

TEST(BadInput, UnknownVersionAndShortFilesNameTheHeader) {
    const Bytes file = join_lumps(30, make_tiny_lumps());
    EXPECT_EQ(fault_of(file), "header, offset 0");
    const auto message_of = [](std::uint32_t version) {
        return refusal([&] { read_bsp(join_lumps(version, make_tiny_lumps())); });
    };
    EXPECT_EQ(message_of(30), "header, offset 0: version 30, expected version 29, BSP2 or 2PSB");
    EXPECT_EQ(message_of(0x5053'4449), "header, offset 0: no level of Quake, expected version 29, BSP2 or 2PSB");
    EXPECT_EQ(fault_of({}), "header, offset 0");
    EXPECT_EQ(fault_of(Bytes(123, 0)), "header, offset 0");
}

class BadRealLevel : public LevelFile {};

TEST_P(BadRealLevel, CutAtALumpsBorderItNamesALump) {
    for (std::size_t lump = 0; lump < kLumpCount; ++lump) {
        const std::size_t start = lump_offset(lump), size = lump_size(lump);
        for (const std::size_t cut : {start, start + size / 2, start + size - 1}) {
            const std::string where = fault_of(Bytes(file_.begin(), file_.begin() + static_cast<std::ptrdiff_t>(cut)));
            EXPECT_TRUE(names_a_lump(where)) << "cut at " << cut << ": '" << where << "'";
        }
    }
}

/// The file with another number in its header.
Bytes with_header(Bytes file, std::size_t offset, std::int64_t value) {
    put_number(file, offset, 4, value);
    return file;
}

TEST_P(BadRealLevel, LumpOutsideTheFileIsNamed) {
    const auto size = static_cast<std::int64_t>(file_.size());
    for (std::size_t lump = 0; lump < kLumpCount; ++lump) {
        const std::size_t place = 4 + lump * 8;
        for (const std::int64_t value :
             {std::int64_t{-1}, std::int64_t{-2147483648}, std::int64_t{2147483647}, size + 1})
            for (const std::size_t field : {place, place + 4})
                EXPECT_TRUE(is_in(kLumpNames[lump], fault_of(with_header(file_, field, value)))) << value;
        EXPECT_TRUE(is_in(kLumpNames[lump], fault_of(with_header(file_, place, kBspHeaderSize - 1))));
    }
}

// A lump moved by a record, or emptied, may by chance hold a valid level: then it is read.
TEST_P(BadRealLevel, LumpMovedOrResizedIsReadOrNamesALump) {
    for (std::size_t lump = 0; lump < kLumpCount; ++lump) {
        const auto offset = static_cast<std::int64_t>(lump_offset(lump)),
                   size = static_cast<std::int64_t>(lump_size(lump));
        const std::int64_t record = kBspFormats[0].record_sizes[lump];
        for (const std::int64_t change : {-record, std::int64_t{-1}, std::int64_t{1}, record})
            for (const auto& [field, value] : {std::pair{4 + lump * 8, offset + change},
                                               {8 + lump * 8, size + change},
                                               {8 + lump * 8, std::int64_t{0}}}) {
                const std::string where = fault_of(with_header(file_, field, value));
                EXPECT_TRUE(where.empty() || names_a_lump(where)) << where;
            }
    }
}

OBLONG_FOR_ALL_LEVELS(BadRealLevel);

}  // namespace

}  // namespace oblong::test
