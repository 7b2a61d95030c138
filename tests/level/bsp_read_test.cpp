#include "engine/level/bsp_read.h"

#include <gtest/gtest.h>

#include <limits>

#include "engine/base/text.h"
#include "tests/support/levels.h"

namespace oblong::test {

namespace {

Level read_tiny(const Lumps& lumps = make_tiny_lumps()) {
    return read_bsp(join_lumps(29, lumps));
}

/// The tiny level's lumps, or others, with other numbers of 4 bytes.
Lumps tiny_with(Lump lump, std::initializer_list<std::pair<std::size_t, std::int64_t>> numbers,
                Lumps lumps = make_tiny_lumps()) {
    for (const auto& [offset, number] : numbers) put_number(lump_of(lumps, lump), offset, 4, number);
    return lumps;
}

TEST(TinyLevel, FaceCoversItsTexels) {
    const Level level = read_tiny();
    ASSERT_EQ(level.faces.size(), 1u);
    const Face& face = level.faces.front();
    // u = x + 4 runs from 4 to 36: cells 0 to 48. v = -y runs from -16 to 0: one cell.
    EXPECT_EQ(face.texel_min_u, 0);
    EXPECT_EQ(face.texel_extent_u, 48);
    EXPECT_EQ(face.texel_min_v, -16);
    EXPECT_EQ(face.texel_extent_v, 16);
    EXPECT_EQ(face.light_offset, 0);
}

TEST(TinyLevel, NumbersAreInTheFormatsOfTheEngine) {
    const Level level = read_tiny();
    EXPECT_EQ(level.vertices[VertexIndex(3)], point_at(32, 16, 8));
    EXPECT_EQ(level.planes.front().normal.z, Unit::from_int(1));
    EXPECT_EQ(level.planes.front().distance, PlaneDistance::from_int(8));
    EXPECT_EQ(level.planes.front().axis, 2);
    EXPECT_EQ(level.texinfos.front().s.x, TexelAxis::from_int(1));
    EXPECT_EQ(level.texinfos.front().s_offset, Texel::from_int(4));
    EXPECT_EQ(level.textures.front().name, "floor");
    EXPECT_EQ(level.textures.front().mips[3].size(), 4u);
}

TEST(TinyLevel, PointOnThePlaneBelongsToItsBack) {
    const Level level = read_tiny();
    Vec3<World> p = point_at(1, 1, 8);
    EXPECT_EQ(find_leaf(level, level.world(), p), kSolidOutside);
    p.z += World::ulp();
    EXPECT_EQ(find_leaf(level, level.world(), p), LeafIndex(1));
}

/// The tiny level of eight light samples with a lump of this name, size and offset from its place behind its list.
Bytes with_extension(std::string_view name, int size, int shift = 0, int lumps = 1) {
    Bytes file = join_lumps(29, make_tiny_lumps()), colours;
    for (int i = 0; i < 24; ++i) ByteWriter(colours).u8(10 * i);
    append_extension(file, name, colours, size, shift, lumps);
    return file;
}

TEST(TinyLevel, ColoursOfItsLightAreBehindTheOtherLumps) {
    const auto colours_of = [](const Bytes& file) { return read_bsp(file).coloured_lighting; };
    const auto colours = colours_of(with_extension("RGBLIGHTING", 24));
    ASSERT_EQ(colours.size(), 3 * read_tiny().lighting.size());
    for (std::size_t i = 0; i < colours.size(); ++i) EXPECT_EQ(colours[i], 10 * i);
    EXPECT_TRUE(colours_of(with_extension("RGBLIGHTINGS", 24)).empty()) << "another lump";
    EXPECT_TRUE(colours_of(with_extension("RGBLIGHTING", 21)).empty()) << "of other samples";
    EXPECT_TRUE(read_tiny().coloured_lighting.empty());
    for (const auto& [size, shift, lumps] :
         {std::array{24, 1, 1}, {25, 0, 1}, {-1, 0, 1}, {24, -1000, 1}, {24, 0, 9}}) {
        const Bytes file = with_extension("RGBLIGHTING", size, shift, lumps);
        const std::string said = refusal([&] { read_bsp(file); });
        EXPECT_NE(said.find("BSPX"), std::string::npos) << said;
        EXPECT_NE(said.find("expected an end within the"), std::string::npos) << said;
    }
}

TEST(TinyLevel, ColoursOfItsLightMayBeInAFileBesideIt) {
    Level level = read_tiny();
    const auto file = [](int version, int colours) {
        Bytes bytes;
        ByteWriter out(bytes);
        out.text("QLIT").i32(version);
        for (int i = 0; i < colours; ++i) out.u8(5 * i);
        return bytes;
    };
    read_lit_file(file(1, 24), level);
    ASSERT_EQ(level.coloured_lighting.size(), 24u);
    EXPECT_EQ(level.coloured_lighting[23], 115);
    for (const auto& wrong : {std::pair{file(2, 24), "version 1"},
                              {Bytes{'Q', 'L', 'I'}, "version 1"},
                              {file(1, 23), "23 bytes of colours, expected 24"}})
        EXPECT_NE(refusal([&] { read_lit_file(wrong.first, level); }).find(wrong.second), std::string::npos)
            << wrong.second;
}

TEST(TinyLevel, IsTheSameInAllFormats) {
    const Lumps lumps = make_tiny_lumps();
    EXPECT_EQ(read_tiny(), read_bsp(join_lumps(version_from_letters("BSP2"), widen_lumps(lumps, true))));
    EXPECT_EQ(read_tiny(), read_bsp(join_lumps(version_from_letters("2PSB"), widen_lumps(lumps, false))));
}

/// Bounds of 2^20 are taken: compilers write such for empty nodes.
TEST(TinyLevel, BoxesOfNodesAndLeavesEndWithTheWorld) {
    const auto low = std::bit_cast<std::int32_t>(-1048576.F), high = std::bit_cast<std::int32_t>(1048576.F);
    const Lumps wide = widen_lumps(make_tiny_lumps(), true),
                lumps = tiny_with(Lump::Leaves, {{64, high}, {68, high}, {72, high}},
                                  tiny_with(Lump::Nodes, {{12, low}, {16, low}, {20, low}}, wide));
    const Level level = read_bsp(join_lumps(version_from_letters("BSP2"), lumps));
    EXPECT_EQ(level.nodes.front().box.mins, (std::array{-524287, -524287, -524287}));
    EXPECT_EQ(level.leaves[LeafIndex(1)].box.maxs, (std::array{524287, 524287, 524287}));
}

TEST(TinyLevel, MissingTextureBecomesACheckerboard) {
    const Level level = read_tiny(tiny_with(Lump::Textures, {{4, -1}}));
    ASSERT_EQ(level.textures.size(), 1u);
    const MipTexture& texture = level.textures.front();
    EXPECT_TRUE(texture.is_missing);
    for (std::size_t mip = 0; mip < 4; ++mip)
        EXPECT_EQ(texture.mips[mip].size(), static_cast<std::size_t>((texture.width >> mip) * (texture.height >> mip)));
    EXPECT_NE(texture.mips[0][0], texture.mips[0][8]);
    EXPECT_EQ(texture.mips[0][0], texture.mips[0][16]);
}

TEST(TinyLevel, TextureWhoseTexelsAreElsewhereKeepsItsName) {
    const Level level = read_tiny(tiny_with(Lump::Textures, {{32, 0}, {36, 0}, {40, 0}, {44, 0}}));
    EXPECT_TRUE(level.textures.front().is_missing);
    EXPECT_EQ(level.textures.front().name, "floor");
}

// 0 as ericw-tools writes for a missing one, 24 as in LibreQuake, and sizes on which other readers stop.
TEST(TinyLevel, ATextureOfASizeThatCannotBeDrawnBecomesACheckerboard) {
    for (const std::uint32_t size : {0u, 1u, 8u, 24u, 100u, 16400u, 0x80000000u, 0xffffffffu})
        for (const std::size_t side : {24u, 28u}) {
            const Level level = read_tiny(tiny_with(Lump::Textures, {{side, size}}));
            EXPECT_TRUE(level.textures.front().is_missing) << size;
            EXPECT_EQ(level.textures.front().width, 64) << size;
            ASSERT_EQ(texture_warnings(level).size(), 1u) << size;
            EXPECT_TRUE(texture_warnings(level)[0].starts_with("texture 'floor' is shown as a checkerboard")) << size;
        }
    EXPECT_TRUE(texture_warnings(read_tiny()).empty());
}

// 16 bits hold both: indices up to the number of clipnodes, and contents near 65,536.
TEST(TinyLevel, MoreThan32767ClipNodesAreToldFromContents) {
    constexpr std::int32_t kCount = 40000;
    Lumps lumps = make_tiny_lumps();
    Bytes& nodes = lump_of(lumps, Lump::ClipNodes);
    nodes.clear();
    const auto child = [](std::int32_t index) { return index < kCount ? index : contents::kWater; };
    const auto is_child = [](ClipChild found, std::int32_t expected) {
        return found == (expected < 0 ? ClipChild(expected) : ClipChild(ClipNodeIndex(expected)));
    };
    for (std::int32_t i = 0; i < kCount; ++i) ByteWriter(nodes).i32(0).i16(child(2 * i + 1)).i16(child(2 * i + 2));
    const Level level = read_tiny(lumps);
    for (std::int32_t i = 0; i < kCount; ++i) {
        const auto& children = level.clip_nodes[ClipNodeIndex(i)].children;
        ASSERT_TRUE(is_child(children[0], child(2 * i + 1))) << i;
        ASSERT_TRUE(is_child(children[1], child(2 * i + 2))) << i;
    }
}

TEST(TinyLevel, MaterialsGoByNameOrFlag) {
    for (const auto& [name, material] :
         {std::pair{"*lava", Material::Liquid}, {"sky1", Material::Sky}, {"floor", Material::Lit}}) {
        Lumps lumps = make_tiny_lumps();
        Bytes& textures = lump_of(lumps, Lump::Textures);
        std::fill_n(textures.begin() + 8, 16, std::uint8_t{0});
        std::copy_n(name, std::string_view(name).size(), textures.begin() + 8);
        const Level level = read_tiny(lumps);
        EXPECT_EQ(level.texinfos.front().material, material) << name;
        EXPECT_EQ(level.sky.is_none(), material != Material::Sky) << name;
    }
    const Lumps flagged = tiny_with(Lump::TexInfos, {{36, 1}});
    EXPECT_EQ(read_tiny(flagged).texinfos.front().material, Material::Lit) << "only a name makes a liquid";
    EXPECT_EQ(read_tiny(flagged).faces.front().light_offset, read_tiny().faces.front().light_offset);
    const Lumps dark = tiny_with(Lump::Faces, {{16, -1}}, flagged);
    EXPECT_EQ(read_tiny(dark).texinfos.front().material, Material::Unlit) << "no face has light";
    const Lumps wide = tiny_with(Lump::TexInfos, {{0, std::bit_cast<std::int32_t>(200.F)}}, flagged);
    EXPECT_GT(read_tiny(wide).faces.front().texel_extent_u, 2000) << "a lit one would be refused";
}

TEST(TinyLevel, WithoutLightOrVisibilityThereAreNoOffsets) {
    Lumps lumps = make_tiny_lumps();
    lump_of(lumps, Lump::Lighting).clear();
    lump_of(lumps, Lump::Visibility).clear();
    const Level level = read_tiny(lumps);
    EXPECT_EQ(level.faces.front().light_offset, -1);
    EXPECT_EQ(level.leaves[LeafIndex(1)].visibility_offset, -1);
}

TEST(Entities, PairsComeInTheirOrder) {
    const auto entities = parse_entities("{ \"a\" \"1\"\n\"b\" \"2 3\" }\r\n{}\t{\"c\"\"\"} // the end", "text");
    ASSERT_EQ(entities.size(), 3u);
    ASSERT_EQ(entities[0].pairs.size(), 2u);
    EXPECT_EQ(entities[0].pairs[1].first, "b");
    EXPECT_EQ(entities[0].pairs[1].second, "2 3");
    EXPECT_TRUE(entities[1].pairs.empty());
    EXPECT_EQ(entities[2].value("c", "other"), "");
}

TEST(Entities, FirstOfEqualKeysCountsACommentInAQuoteIsTextAndAZeroEndsIt) {
    using namespace std::string_view_literals;
    const auto entities = parse_entities("{ \"a\" \"1\" \"a\" \"2\" \"music\" \"a//b\" }\0{"sv, "text");
    ASSERT_EQ(entities.size(), 1u);
    EXPECT_EQ(entities[0].value("a"), "1");
    EXPECT_EQ(entities[0].value("b", "otherwise"), "otherwise");
    EXPECT_EQ(entities[0].value("music"), "a//b");
    EXPECT_TRUE(parse_entities("", "text").empty());
}

TEST(Entities, QuotesBehindBackslashesAreText) {
    const auto entities = parse_entities("{\"say\" \"a \\\"b\\\" c\"\n\"path\" \"C:\\\"\n}{\"a\" \"b\\\\\"}", "text");
    ASSERT_EQ(entities.size(), 2u);
    EXPECT_EQ(entities[0].value("say"), R"(a \"b\" c)");
    EXPECT_EQ(entities[0].value("path"), R"(C:\)") << "the last quote of a line ends the text";
    EXPECT_EQ(entities[1].value("a"), R"(b\\)");
}

TEST(Entities, FaultsTellTheirOffset) {
    for (const auto& fault :
         {std::pair{"x", 100}, {"{ \"key\" }", 108}, {"{ \"key\" \"val", 108}, {"{ \"a\" \"b\"", 109}})
        EXPECT_EQ(place_of_refusal([&] { parse_entities(fault.first, "maps", 100); }),
                  "maps, offset " + std::to_string(fault.second))
            << fault.first;
}

TEST(Decimal, RoundsToNearest) {
    EXPECT_EQ(parse_decimal("12.5", 12), 12 * 4096 + 2048);
    EXPECT_EQ(parse_decimal("-12.5", 12), -12 * 4096 - 2048);
    EXPECT_EQ(parse_decimal("+.25", 12), 1024);
    EXPECT_EQ(parse_decimal("7.", 0), 7);
    EXPECT_EQ(parse_decimal("0.5", 0), 1);
    EXPECT_EQ(parse_decimal("0.00012", 12), 0);   // 0.49 of a step
    EXPECT_EQ(parse_decimal("0.000123", 12), 1);  // 0.504
    EXPECT_EQ(parse_decimal("-0.000123", 12), -1);
    EXPECT_EQ(parse_decimal("2147483647.999999999", 16), std::int64_t{2147483648} * 65536);
    // 10^-9 is 4.29 steps of 2^-32
    EXPECT_EQ(parse_decimal("-2147483647.999999999", 32), -(std::numeric_limits<std::int64_t>::max() - 3));
}

TEST(Decimal, RefusesWhatIsNoNumber) {
    for (const char* text :
         {"", "-", ".", "+.", "1e3", "nan", "1 ", " 1", "1.2.3", "--1", "2147483648", "99999999999999999999"})
        EXPECT_FALSE(parse_decimal(text, 12).has_value()) << text;
}

TEST(WorldVector, TakesThreeNumbersThatFit) {
    const auto origin = parse_world_vector("  -16 0.5\t524287.9 ");
    ASSERT_TRUE(origin.has_value());
    EXPECT_EQ(origin->x, World::from_int(-16));
    EXPECT_EQ(origin->y.raw, 2048);
    EXPECT_EQ(origin->z.raw, 524287 * 4096 + 3686);  // 0.9 * 4,096 = 3,686.4
    for (const char* text : {"", "1 2", "1 2 3 4", "1 2 x", "1 2 524288", "-524289 0 0"})
        EXPECT_FALSE(parse_world_vector(text).has_value()) << text;
    EXPECT_TRUE(parse_world_vector("-524288 0 0").has_value());
}

}  // namespace

}  // namespace oblong::test
