#include "engine/reference/level.h"

#include <gtest/gtest.h>

#include "engine/reference/edge_mender.h"
#include "tests/support/bsp_writer.h"
#include "tests/support/refusal.h"

namespace oblong::reference::level_test {
namespace {

using test::join_lumps;
using test::Lumps;
using test::make_tiny_lumps;

void expect_tiny_level(const reference::Level& level) {
    ASSERT_EQ(level.faces.size(), 1u);
    const reference::Face& face = level.faces[0];
    EXPECT_EQ(face.corners, (std::vector<int>{0, 1, 3, 2}));
    EXPECT_EQ(level.vertex(3).x, 32);
    EXPECT_EQ(level.vertex(3).y, 16);
    EXPECT_EQ(level.vertex(3).z, 8);
    EXPECT_EQ(face.plane.normal.z, 1);
    EXPECT_EQ(face.plane.offset, 8);
    EXPECT_EQ(level.texinfo_of(face).s_offset, 4);
    EXPECT_EQ(level.texinfo_of(face).t.y, -1);
    EXPECT_EQ(level.texture_of(face).name, "floor");
    EXPECT_EQ(level.texture_of(face).texels, std::vector<std::uint8_t>(256, 7));
    EXPECT_EQ(face.material, reference::Material::Lit);
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
    expect_tiny_level(reference::read_level(join_lumps(29, make_tiny_lumps())));
    expect_tiny_level(
        reference::read_level(join_lumps(kBspFormats[1].version, test::widen_lumps(make_tiny_lumps(), true))));
    expect_tiny_level(
        reference::read_level(join_lumps(kBspFormats[2].version, test::widen_lumps(make_tiny_lumps(), false))));
}

TEST(ReferenceLevel, AFaceOnThePlanesBackIsTurned) {
    Lumps lumps = make_tiny_lumps();
    test::put_number(test::lump_of(lumps, Lump::Faces), 2, 2, 1);
    const reference::Level level = reference::read_level(join_lumps(29, lumps));
    EXPECT_EQ(level.faces[0].plane.normal.z, -1);
    EXPECT_EQ(level.faces[0].plane.offset, -8);
}

TEST(ReferenceLevel, LightSamplesAreCountedInFloatsAsTheLightCompilersDo) {
    // u from 16 + 2^-19 to 48 + 2^-19, which as a float is 48: no sample at 64.
    Lumps lumps = make_tiny_lumps();
    test::put_number(test::lump_of(lumps, Lump::TexInfos), 12, 4, std::bit_cast<std::int32_t>(16 + 0x1p-19F));
    const reference::Level level = reference::read_level(join_lumps(29, lumps));
    EXPECT_EQ(level.faces[0].first_u, 16);
    EXPECT_EQ(level.faces[0].light_columns, 3);
}

TEST(ReferenceLevel, MaterialsGoByNameAndFlag) {
    const auto material = [](std::string_view name, int flags, int light_offset = 0) {
        Lumps lumps = make_tiny_lumps();
        for (std::size_t i = 0; i < name.size(); ++i)
            test::lump_of(lumps, Lump::Textures)[8 + i] = static_cast<std::uint8_t>(name[i]);
        test::put_number(test::lump_of(lumps, Lump::TexInfos), 36, 4, flags);
        test::put_number(test::lump_of(lumps, Lump::Faces), 16, 4, light_offset);
        return reference::read_level(join_lumps(29, lumps)).faces[0].material;
    };
    EXPECT_EQ(material("floor", 0), reference::Material::Lit);
    EXPECT_EQ(material("floor", 1), reference::Material::Lit);
    EXPECT_EQ(material("floor", 1, -1), reference::Material::Unlit);
    EXPECT_EQ(material("*lava", 0), reference::Material::Liquid);
    EXPECT_EQ(material("sky12", 1), reference::Material::Sky);
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
        Lumps lumps = make_tiny_lumps();
        test::put_number(test::lump_of(lumps, lie.lump), lie.offset, lie.size, lie.value);
        const std::string said =
            test::refusal<std::runtime_error>([&] { reference::read_level(join_lumps(29, lumps)); });
        EXPECT_NE(said.find(std::string("lump '") + lie.named + "'"), std::string::npos) << lie.offset << ": " << said;
    }
}

TEST(ReferenceLevel, EveryCutFileIsAnErrorOrALevel) {
    const test::Bytes whole = join_lumps(29, make_tiny_lumps());
    for (std::size_t size = 0; size < whole.size(); ++size)  // the models, which every reader needs, come last
        EXPECT_THROW(reference::read_level({whole.data(), size}), std::runtime_error) << size;
    EXPECT_THROW(reference::read_level(join_lumps(30, make_tiny_lumps())), std::runtime_error);
}

TEST(ReferenceTJunctions, VerticesOnAnEdgeBecomeCornersOfBothSides) {
    const std::vector<reference::Vec> vertices{{0, 0, 0},  {0, 100, 0}, {1e-5, 70, 0}, {0, 30, -1e-5},
                                               {1, 50, 0}, {50, 50, 0}, {0, 120, 0},   {0, 10, 0}};
    const reference::EdgeMender mender(vertices, {0, 1, 2, 3, 4, 5, 6});
    EXPECT_EQ(mender.mended({0, 1, 5}), (std::vector<int>{0, 3, 2, 1, 5}));
    EXPECT_EQ(mender.mended({1, 0, 5}), (std::vector<int>{1, 2, 3, 0, 5}));
}

}  // namespace
}  // namespace oblong::reference::level_test
