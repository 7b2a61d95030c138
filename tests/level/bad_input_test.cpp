#include <gtest/gtest.h>

#include <limits>

#include "tests/support/levels.h"

namespace oblong {

namespace {

using test::Bytes, test::fault_of, test::lump_label, test::names_a_lump;

/// One wrong number in one lump of the tiny level.
struct Damage {
    const char* what;
    Lump lump;
    std::size_t offset;  ///< in the lump
    int size;            ///< bytes
    std::int64_t value;
    Lump named_lump;  ///< in the error
};

std::int64_t bits_of(float value) {
    return std::bit_cast<std::uint32_t>(value);
}
constexpr float kNan = std::numeric_limits<float>::quiet_NaN(), kInfinity = std::numeric_limits<float>::infinity();

const std::vector<Damage> kDamages = {
    {"NaN in a plane's normal", Lump::Planes, 0, 4, bits_of(kNan), Lump::Planes},
    {"infinite normal", Lump::Planes, 8, 4, bits_of(kInfinity), Lump::Planes},
    {"normal of length 0", Lump::Planes, 8, 4, bits_of(0), Lump::Planes},
    {"normal of length 1.1", Lump::Planes, 8, 4, bits_of(1.1F), Lump::Planes},
    {"NaN in a plane's distance", Lump::Planes, 12, 4, bits_of(kNan), Lump::Planes},
    {"distance past the world", Lump::Planes, 12, 4, bits_of(1048576.F), Lump::Planes},
    {"NaN in a vertex", Lump::Vertices, 4, 4, bits_of(kNan), Lump::Vertices},
    {"vertex outside the world", Lump::Vertices, 8, 4, bits_of(-524288.F), Lump::Vertices},
    {"negative count of textures", Lump::Textures, 0, 4, -1, Lump::Textures},
    {"too many textures", Lump::Textures, 0, 4, 1 << 30, Lump::Textures},
    {"texture outside the lump", Lump::Textures, 4, 4, 1000, Lump::Textures},
    {"texture at a negative offset", Lump::Textures, 4, 4, -2, Lump::Textures},
    {"width not a multiple of 16", Lump::Textures, 24, 4, 17, Lump::Textures},
    {"width 0", Lump::Textures, 24, 4, 0, Lump::Textures},
    {"huge height", Lump::Textures, 28, 4, 0x7ffffff0, Lump::Textures},
    {"mip level outside the lump", Lump::Textures, 44, 4, 377, Lump::Textures},
    {"mip level far outside the lump", Lump::Textures, 32, 4, 0xffffffff, Lump::Textures},
    {"visible row past the lump", Lump::Visibility, 0, 1, 0, Lump::Visibility},
    {"node's plane", Lump::Nodes, 0, 4, 1, Lump::Nodes},
    {"node's leaf", Lump::Nodes, 4, 2, -3, Lump::Nodes},
    {"node below itself", Lump::Nodes, 6, 2, 0, Lump::Nodes},
    {"node's faces", Lump::Nodes, 22, 2, 2, Lump::Nodes},
    {"texture axis out of its format", Lump::TexInfos, 0, 4, bits_of(256.F), Lump::TexInfos},
    {"texture axis that overflows its format when it is rounded", Lump::TexInfos, 0, 4, bits_of(255.99998F),
     Lump::TexInfos},
    {"NaN in a texture axis", Lump::TexInfos, 16, 4, bits_of(kNan), Lump::TexInfos},
    {"texture offset out of its format", Lump::TexInfos, 12, 4, bits_of(2e9F), Lump::TexInfos},
    {"texinfo's texture", Lump::TexInfos, 32, 4, 1, Lump::TexInfos},
    {"texinfo's texture, negative", Lump::TexInfos, 32, 4, -1, Lump::TexInfos},
    {"face's plane", Lump::Faces, 0, 2, 1, Lump::Faces},
    {"face's first surfedge, negative", Lump::Faces, 4, 4, -1, Lump::Faces},
    {"face of two edges", Lump::Faces, 8, 2, 2, Lump::Faces},
    {"face's edges", Lump::Faces, 8, 2, 5, Lump::Faces},
    {"face's texinfo", Lump::Faces, 10, 2, 1, Lump::Faces},
    {"face's light past the lump", Lump::Faces, 16, 4, 1, Lump::Faces},
    {"face's light, negative", Lump::Faces, 16, 4, -2, Lump::Faces},
    {"second light style past the lump", Lump::Faces, 13, 1, 3, Lump::Faces},
    {"clipnode's plane", Lump::ClipNodes, 0, 4, -1, Lump::ClipNodes},
    {"clipnode below itself", Lump::ClipNodes, 4, 2, 0, Lump::ClipNodes},
    {"clipnode's contents", Lump::ClipNodes, 4, 2, -17, Lump::ClipNodes},
    {"first leaf not solid", Lump::Leaves, 0, 4, -1, Lump::Leaves},
    {"leaf's contents", Lump::Leaves, 28, 4, 0, Lump::Leaves},
    {"leaf's visibility", Lump::Leaves, 32, 4, 2, Lump::Leaves},
    {"leaf's visibility, negative", Lump::Leaves, 32, 4, -2, Lump::Leaves},
    {"leaf's markfaces", Lump::Leaves, 50, 2, 2, Lump::Leaves},
    {"markface's face", Lump::MarkFaces, 0, 2, 1, Lump::MarkFaces},
    {"edge's vertex", Lump::Edges, 18, 2, 4, Lump::Edges},
    {"surfedge's edge", Lump::SurfEdges, 0, 4, 5, Lump::SurfEdges},
    {"surfedge's edge, backward", Lump::SurfEdges, 0, 4, -5, Lump::SurfEdges},
    {"surfedge without a negative", Lump::SurfEdges, 0, 4, std::numeric_limits<std::int32_t>::min(), Lump::SurfEdges},
    {"NaN in a model's box", Lump::Models, 0, 4, bits_of(kNan), Lump::Models},
    {"infinite origin", Lump::Models, 24, 4, bits_of(-kInfinity), Lump::Models},
    {"model's node", Lump::Models, 36, 4, 1, Lump::Models},
    {"model's leaf", Lump::Models, 36, 4, -3, Lump::Models},
    {"model's clipnode", Lump::Models, 40, 4, 1, Lump::Models},
    {"model's visible leaves", Lump::Models, 52, 4, 2, Lump::Models},
    {"model's visible leaves, negative", Lump::Models, 52, 4, -1, Lump::Models},
    {"model's faces", Lump::Models, 60, 4, 2, Lump::Models},
    {"model's faces, overflowing", Lump::Models, 56, 4, 0x7fffffff, Lump::Models},
};

TEST(BadInput, OneWrongNumberNamesItsLump) {
    for (const Damage& damage : kDamages) {
        test::Lumps lumps = test::make_tiny_lumps();
        test::put_number(test::lump_of(lumps, damage.lump), damage.offset, damage.size, damage.value);
        const std::string where = fault_of(test::join_lumps(29, lumps));
        EXPECT_TRUE(where.starts_with(lump_label(static_cast<std::size_t>(damage.named_lump)) + ","))
            << damage.what << ": '" << where << "'";
    }
}

/// Its lit surface would take as much memory as the numbers of the file ask for, 64 GiB for some.
TEST(BadInput, HugeLitFacesAreRefusedInLevelsWithoutLightAsWell) {
    test::Lumps lumps = test::make_tiny_lumps();
    test::lump_of(lumps, Lump::Lighting).clear();
    EXPECT_EQ(fault_of(test::join_lumps(29, lumps)), "");
    test::put_number(test::lump_of(lumps, Lump::TexInfos), 0, 4, bits_of(200.F));  // the face is 32 units wide
    EXPECT_TRUE(fault_of(test::join_lumps(29, lumps)).starts_with("lump 'faces', offset "));
}

TEST(BadInput, ErrorTellsTheByteOfTheFile) {
    test::Lumps lumps = test::make_tiny_lumps();
    test::put_number(test::lump_of(lumps, Lump::Faces), 10, 2, 1);  // the texinfo
    const Bytes file = test::join_lumps(29, lumps);
    const std::uint32_t faces = test::number_at(file, 4 + 7 * 8, 4);
    EXPECT_EQ(fault_of(file), "lump 'faces', offset " + std::to_string(faces + 10));
}

TEST(BadInput, BrokenEntitiesAreFound) {
    for (const char* text : {"{", "{ \"key\" }", "{ \"key", "\"classname\" \"worldspawn\"", "{ key \"value\" }", "}"}) {
        test::Lumps lumps = test::make_tiny_lumps();
        test::lump_of(lumps, Lump::Entities).assign(text, text + std::string_view(text).size());
        EXPECT_TRUE(fault_of(test::join_lumps(29, lumps)).starts_with("lump 'entities', offset ")) << text;
    }
}

TEST(BadInput, CycleOfTwoClipNodesIsFound) {
    test::Lumps lumps = test::make_tiny_lumps();
    test::Bytes& nodes = test::lump_of(lumps, Lump::ClipNodes);
    nodes.clear();
    test::ByteWriter(nodes).i32(0).i16(1).i16(-2).i32(0).i16(-1).i16(0);
    EXPECT_TRUE(fault_of(test::join_lumps(29, lumps)).starts_with("lump 'clipnodes'"));
    test::put_number(nodes, 14, 2, -1);  // the way back: now a chain
    EXPECT_EQ(fault_of(test::join_lumps(29, lumps)), "");
}

TEST(BadInput, ClipNodesMayShareASubtreeAndNodesMayNot) {
    test::Lumps lumps = test::make_tiny_lumps();
    test::ByteWriter(test::lump_of(lumps, Lump::ClipNodes)).i32(0).i16(0).i16(0);
    EXPECT_EQ(fault_of(test::join_lumps(29, lumps)), "");
    test::ByteWriter(test::lump_of(lumps, Lump::Nodes)).i32(0).i16(0).i16(0).number(8, 0).i32(0).i16(0).i16(0);
    EXPECT_TRUE(fault_of(test::join_lumps(29, lumps)).starts_with("lump 'nodes'"));
}

/// Files that would take far more memory or time than their size.
TEST(BadInput, WhatIsSharedOrMissingOverAndOverIsRefused) {
    struct Row {
        const char *what, *where;
        void (*spoil)(test::Lumps&);
    };
    const std::vector<Row> rows{{"an endlessly deep tree", "lump 'clipnodes'",
                                 [](test::Lumps& lumps) {
                                     test::Bytes& nodes = test::lump_of(lumps, Lump::ClipNodes);
                                     nodes.clear();
                                     for (int i = 1; i < 5000; ++i) test::ByteWriter(nodes).i32(0).i16(i).i16(-2);
                                     test::ByteWriter(nodes).i32(0).i16(-1).i16(-2);
                                 }},
                                {"textures that share their bytes", "lump 'textures'",
                                 [](test::Lumps& lumps) {
                                     test::Bytes& textures = test::lump_of(lumps, Lump::Textures);
                                     Bytes table;
                                     test::ByteWriter out(table);
                                     out.i32(100);
                                     for (int i = 0; i < 100; ++i) out.i32(4 + 100 * 4);
                                     textures.erase(textures.begin(), textures.begin() + 8);
                                     textures.insert(textures.begin(), table.begin(), table.end());
                                 }},
                                {"faces that share their edges", "lump 'faces'",
                                 [](test::Lumps& lumps) {
                                     test::Bytes& faces = test::lump_of(lumps, Lump::Faces);
                                     const Bytes face = faces;
                                     for (int i = 0; i < 1000; ++i) faces.insert(faces.end(), face.begin(), face.end());
                                 }},
                                {"nodes that share their faces", "lump 'nodes'",
                                 [](test::Lumps& lumps) {
                                     test::Bytes& nodes = test::lump_of(lumps, Lump::Nodes);
                                     const Bytes node = nodes;
                                     for (int i = 0; i < 1000; ++i) nodes.insert(nodes.end(), node.begin(), node.end());
                                 }},
                                {"leaves that share their markfaces", "lump 'leaves'",
                                 [](test::Lumps& lumps) {
                                     test::Bytes& leaves = test::lump_of(lumps, Lump::Leaves);
                                     const Bytes leaf(leaves.end() - 28, leaves.end());
                                     for (int i = 0; i < 1000; ++i)
                                         leaves.insert(leaves.end(), leaf.begin(), leaf.end());
                                 }},
                                {"visible rows that overlap", "lump 'visibility'",
                                 [](test::Lumps& lumps) {
                                     constexpr int kLeaves =
                                         1000;  // a row takes 125 bytes, and one starts at every byte
                                     test::lump_of(lumps, Lump::Visibility).assign(kLeaves + kLeaves / 8, 0xff);
                                     test::ByteWriter leaves(test::lump_of(lumps, Lump::Leaves));
                                     for (int i = 1; i < kLeaves; ++i)
                                         leaves.i32(contents::kEmpty).i32(i).number(8, 0).i32(0).i32(0).i32(0);
                                     test::put_number(test::lump_of(lumps, Lump::Models), 52, 4, kLeaves);
                                 }},
                                {"a million missing textures", "lump 'textures'", [](test::Lumps& lumps) {
                                     test::Bytes& textures = test::lump_of(lumps, Lump::Textures);
                                     textures.assign(4 + 4 * 1000000, 0xff);
                                     test::put_number(textures, 0, 4, 1000000);
                                 }}};
    for (const Row& row : rows) {
        test::Lumps lumps = test::make_tiny_lumps();
        row.spoil(lumps);
        const std::string where = fault_of(test::join_lumps(29, lumps));
        EXPECT_TRUE(where.starts_with(row.where)) << row.what << ": '" << where << "'";
    }
}

TEST(BadInput, UnknownVersionAndShortFilesNameTheHeader) {
    const Bytes file = test::join_lumps(30, test::make_tiny_lumps());
    EXPECT_EQ(fault_of(file), "header, offset 0");
    EXPECT_EQ(fault_of({}), "header, offset 0");
    EXPECT_EQ(fault_of(Bytes(123, 0)), "header, offset 0");
}

class BadRealLevel : public test::OfLevel {
  protected:
    void SetUp() override {
        test::OfLevel::SetUp();
        if (!IsSkipped()) file_ = test::bytes_of_level(GetParam());
    }
    Bytes file_;
};

TEST_P(BadRealLevel, CutAtALumpsBorderItNamesALump) {
    std::vector<std::size_t> borders;
    for (std::size_t lump = 0; lump < kLumpCount; ++lump) {
        const std::size_t start = test::number_at(file_, 4 + lump * 8, 4),
                          size = test::number_at(file_, 8 + lump * 8, 4);
        for (const std::size_t cut : {start, start + size / 2, start + size - 1}) borders.push_back(cut);
    }
    for (const std::size_t cut : borders) {
        const std::string where = fault_of(Bytes(file_.begin(), file_.begin() + static_cast<std::ptrdiff_t>(cut)));
        EXPECT_TRUE(names_a_lump(where)) << "cut at " << cut << ": '" << where << "'";
    }
}

TEST_P(BadRealLevel, LumpOutsideTheFileIsNamed) {
    const auto size = static_cast<std::int64_t>(file_.size());
    for (std::size_t lump = 0; lump < kLumpCount; ++lump) {
        for (const std::int64_t value :
             {std::int64_t{-1}, std::int64_t{-2147483648}, std::int64_t{2147483647}, size + 1}) {
            for (const std::size_t field : {4 + lump * 8, 8 + lump * 8}) {
                Bytes bad = file_;
                test::put_number(bad, field, 4, value);
                EXPECT_TRUE(fault_of(bad).starts_with(lump_label(lump))) << kLumpNames[lump] << ' ' << value;
            }
        }
        Bytes in_header = file_;
        test::put_number(in_header, 4 + lump * 8, 4, kBspHeaderSize - 1);
        EXPECT_TRUE(fault_of(in_header).starts_with(lump_label(lump))) << kLumpNames[lump];
    }
}

// A lump moved by a record, or emptied, may by chance hold a valid level: then it is read.
TEST_P(BadRealLevel, LumpMovedOrResizedIsReadOrNamesALump) {
    for (std::size_t lump = 0; lump < kLumpCount; ++lump) {
        const auto offset = test::number_at(file_, 4 + lump * 8, 4), size = test::number_at(file_, 8 + lump * 8, 4);
        const std::int64_t record = kBspFormats[0].record_sizes[lump];
        for (const std::int64_t change : {-record, std::int64_t{-1}, std::int64_t{1}, record}) {
            Bytes moved = file_, resized = file_, emptied = file_;
            test::put_number(moved, 4 + lump * 8, 4, offset + change);
            test::put_number(resized, 8 + lump * 8, 4, size + change);
            test::put_number(emptied, 8 + lump * 8, 4, 0);
            for (const Bytes& bad : {moved, resized, emptied}) {
                const std::string where = fault_of(bad);
                EXPECT_TRUE(where.empty() || names_a_lump(where)) << where;
            }
        }
    }
}

OBLONG_FOR_ALL_LEVELS(BadRealLevel);

}  // namespace

}  // namespace oblong
