#include "engine/reference/level.h"

#include <gtest/gtest.h>

#include "engine/reference/edge_mender.h"
#include "tests/support/bsp_writer.h"

namespace oblong::reference::level_test {
namespace {

using namespace test;

/// The tiny level's lumps with another number in one of them.
Lumps tiny_with(Lump lump, std::size_t offset, int size, std::int64_t number, Lumps lumps = make_tiny_lumps()) {
    put_number(lump_of(lumps, lump), offset, size, number);
    return lumps;
}

void expect_tiny_level(const Level& level) {
    ASSERT_EQ(level.faces.size(), 1u);
    const Face& face = level.faces[0];
    EXPECT_EQ(face.corners, (std::vector<int>{0, 1, 3, 2}));
    EXPECT_EQ(level.vertex(3), (Vec{32, 16, 8}));
    EXPECT_EQ(face.plane.normal.z, 1);
    EXPECT_EQ(face.plane.offset, 8);
    EXPECT_EQ(level.texinfo_of(face).s_offset, 4);
    EXPECT_EQ(level.texinfo_of(face).t.y, -1);
    EXPECT_EQ(level.texture_of(face).name, "floor");
    EXPECT_EQ(level.texture_of(face).texels, std::vector<std::uint8_t>(256, 7));
    EXPECT_EQ(face.material, Material::Lit);
    EXPECT_EQ(face.style_count(), 1);
    // u from 4 to 36, v from -16 to 0.
    EXPECT_EQ(face.first_u, 0);
    EXPECT_EQ(face.light_columns, 4);
    EXPECT_EQ(face.first_v, -16);
    EXPECT_EQ(face.light_rows, 2);
    ASSERT_EQ(level.models.size(), 1u);
    EXPECT_EQ(level.models[0].face_count, 1);
    EXPECT_EQ(level.models[0].maxs.x, 32);
}

TEST(ReferenceLevel, IsReadFromAllThreeFormats) {
    const Lumps lumps = make_tiny_lumps();
    expect_tiny_level(read_level(join_lumps(29, lumps)));
    expect_tiny_level(read_level(join_lumps(kBspFormats[1].version, widen_lumps(lumps, true))));
    expect_tiny_level(read_level(join_lumps(kBspFormats[2].version, widen_lumps(lumps, false))));
}

TEST(ReferenceLevel, AFaceOnThePlanesBackIsTurned) {
    const Level level = read_level(join_lumps(29, tiny_with(Lump::Faces, 2, 2, 1)));
    EXPECT_EQ(level.faces[0].plane.normal.z, -1);
    EXPECT_EQ(level.faces[0].plane.offset, -8);
}

TEST(ReferenceLevel, LightSamplesAreCountedInFloatsAsTheLightCompilersDo) {
    // u from 16 + 2^-19 to 48 + 2^-19, which as a float is 48: no sample at 64.
    const auto offset = std::bit_cast<std::int32_t>(16 + 0x1p-19F);
    const Level level = read_level(join_lumps(29, tiny_with(Lump::TexInfos, 12, 4, offset)));
    EXPECT_EQ(level.faces[0].first_u, 16);
    EXPECT_EQ(level.faces[0].light_columns, 3);
}

TEST(ReferenceLevel, MaterialsGoByNameAndFlag) {
    const auto material = [](std::string_view name, int flags, int light_offset = 0) {
        Lumps lumps = tiny_with(Lump::TexInfos, 36, 4, flags, tiny_with(Lump::Faces, 16, 4, light_offset));
        std::copy(name.begin(), name.end(), lump_of(lumps, Lump::Textures).begin() + 8);
        return read_level(join_lumps(29, lumps)).faces[0].material;
    };
    EXPECT_EQ(material("floor", 0), Material::Lit);
    EXPECT_EQ(material("floor", 1), Material::Lit);
    EXPECT_EQ(material("floor", 1, -1), Material::Unlit);
    EXPECT_EQ(material("*lava", 0), Material::Liquid);
    EXPECT_EQ(material("sky12", 1), Material::Sky);
}

TEST(ReferenceLevel, WhatTheFileDoesNotHoldIsAnErrorThatNamesTheLump) {
    struct Lie {
        Lump lump;
        std::size_t offset;
        int size, value;
        const char* named;
    };
    for (const Lie& lie : {Lie{Lump::Faces, 0, 2, 1, "faces"}, Lie{Lump::Faces, 4, 4, 1, "faces"},
                           Lie{Lump::Faces, 4, 4, -1, "faces"}, Lie{Lump::Faces, 10, 2, 1, "faces"},
                           Lie{Lump::Faces, 16, 4, 1, "faces"}, Lie{Lump::SurfEdges, 0, 4, 5, "surfedges"},
                           Lie{Lump::SurfEdges, 0, 4, -5, "surfedges"}, Lie{Lump::Edges, 4, 2, 4, "edges"},
                           Lie{Lump::TexInfos, 32, 4, 1, "texinfos"}, Lie{Lump::TexInfos, 0, 4, 0x7f800000, "texinfos"},
                           Lie{Lump::Textures, 4, 4, 9999, "textures"}, Lie{Lump::Textures, 24, 4, 32, "textures"},
                           Lie{Lump::Models, 60, 4, 2, "models"}, Lie{Lump::Models, 56, 4, 1, "models"}}) {
        const Bytes file = join_lumps(29, tiny_with(lie.lump, lie.offset, lie.size, lie.value));
        const std::string said = refusal<std::runtime_error>([&] { read_level(file); });
        EXPECT_NE(said.find(std::string("lump '") + lie.named + "'"), std::string::npos) << lie.offset << ": " << said;
    }
}

TEST(ReferenceLevel, EveryCutFileIsAnErrorOrALevel) {
    const Bytes whole = join_lumps(29, make_tiny_lumps());
    for (std::size_t size = 0; size < whole.size(); ++size)  // the models, which every reader needs, come last
        EXPECT_THROW(read_level({whole.data(), size}), std::runtime_error) << size;
    EXPECT_THROW(read_level(join_lumps(30, make_tiny_lumps())), std::runtime_error);
}

TEST(ReferenceTJunctions, VerticesOnAnEdgeBecomeCornersOfBothSides) {
    const std::vector<Vec> vertices{{0, 0, 0},  {0, 100, 0}, {1e-5, 70, 0}, {0, 30, -1e-5},
                                    {1, 50, 0}, {50, 50, 0}, {0, 120, 0},   {0, 10, 0}};
    const EdgeMender mender(vertices, {0, 1, 2, 3, 4, 5, 6});
    EXPECT_EQ(mender.mended({0, 1, 5}), (std::vector<int>{0, 3, 2, 1, 5}));
    EXPECT_EQ(mender.mended({1, 0, 5}), (std::vector<int>{1, 2, 3, 0, 5}));
}

}  // namespace
}  // namespace oblong::reference::level_test
