#include <gtest/gtest.h>

#include <limits>

#include "engine/mesh/mesh.h"
#include "tests/mesh_files/mdl_writer.h"
#include "tests/support/folders.h"
#include "tests/support/point.h"

namespace oblong::test {
namespace {

/// Six times the volume that the triangles enclose: positive if they run clockwise as seen from outside.
double volume_6(const Mesh& mesh, const MeshFrame& frame) {
    double sum = 0;
    for (const MeshTriangle& triangle : mesh.triangles) {
        const auto corner = [&](std::size_t i) { return to_point(frame.vertices[triangle.vertices[i]].position); };
        sum -= dot(corner(0), cross(corner(1), corner(2)));
    }
    return sum;
}

std::string fault_of(const MdlFile& file) {
    const std::string said = refusal([&] { read_mdl(file); });
    if (said.empty()) return said;
    EXPECT_NE(said.find("expected"), std::string::npos) << said;
    return said.substr(0, said.find(": "));
}

TEST(MdlRead, ATetrahedronHasItsFramesSkinsAndTimes) {
    const Mesh mesh = read_mdl(write_mdl(tetrahedron_model()));
    ASSERT_EQ(mesh.frames.size(), 3u);
    ASSERT_EQ(mesh.skins.size(), 3u);
    EXPECT_EQ(mesh.triangles.size(), 4u);
    EXPECT_EQ(mesh.frames[0].name, "stand1");
    EXPECT_EQ(mesh.skins[2].texels, std::vector<std::uint8_t>(32, 9));
    ASSERT_EQ(mesh.frame_sequences.size(), 2u);
    EXPECT_EQ(mesh.frame_sequences[1].ends_ms, (std::vector<std::int32_t>{100, 300}));
    ASSERT_EQ(mesh.skin_sequences.size(), 2u);
    EXPECT_EQ(mesh.skin_sequences[1].ends_ms, (std::vector<std::int32_t>{500, 750}));
    EXPECT_EQ(mesh.frames[2].maxs, point_at(50, 50, 50));
    EXPECT_NEAR(volume_6(mesh, mesh.frames[0]), 1e6, 1e-3);
}

TEST(MdlRead, FramesOfAGroupTakeTurnsByTime) {
    const Mesh mesh = read_mdl(write_mdl(tetrahedron_model()));
    const auto shown = [&](std::int64_t time_ms) { return shown_at(mesh.frame_sequences[1], time_ms); };
    EXPECT_EQ(shown_at(mesh.frame_sequences[0], 12345), 0u);
    for (const std::int64_t time_ms : {std::int64_t{0}, std::int64_t{300}, (std::int64_t{1} << 62) / 300 * 300}) {
        EXPECT_EQ(shown(time_ms), 1u) << time_ms;
        EXPECT_EQ(shown(time_ms + 99), 1u) << time_ms;
        EXPECT_EQ(shown(time_ms + 100), 2u) << time_ms;
        EXPECT_EQ(shown(time_ms - 1), 2u) << time_ms;
    }
}

TEST(MdlRead, NormalsPointOutwardAndWeighTrianglesByTheirArea) {
    const Mesh mesh = read_mdl(write_mdl(tetrahedron_model()));
    const Vec3<Unit> corner = mesh.frames[0].vertices[0].normal;
    for (const Unit part : {corner.x, corner.y, corner.z}) EXPECT_NEAR(number_of(part), -1 / std::sqrt(3), 1e-8);
    // At the x leg's end: two right-angled triangles, -y and -z, and the large one (1, 1, 1): (1, 0, 0) in sum.
    const Vec3<Unit> leg = mesh.frames[0].vertices[1].normal;
    EXPECT_NEAR(number_of(leg.x), 1, 1e-8);
    EXPECT_NEAR(number_of(leg.y), 0, 1e-8);
}

TEST(MdlRead, AVertexOnTheSeamIsAnotherOneOnTheBackHalf) {
    const Mesh mesh = read_mdl(write_mdl(tetrahedron_model()));
    ASSERT_EQ(mesh.texels.size(), 5u);
    EXPECT_EQ(mesh.triangles[3].vertices, (std::array<std::uint32_t, 3>{4, 3, 2}));
    EXPECT_EQ(mesh.triangles[0].vertices, (std::array<std::uint32_t, 3>{0, 1, 2}));
    EXPECT_EQ(number_of(mesh.texels[1].u), 2.5);
    EXPECT_EQ(number_of(mesh.texels[4].u), 6.5);  // half of the width of 8 further
    EXPECT_EQ(number_of(mesh.texels[4].v), 1.5);
    for (const MeshFrame& frame : mesh.frames) {
        ASSERT_EQ(frame.vertices.size(), 5u);
        EXPECT_EQ(frame.vertices[4].position, frame.vertices[1].position);
        EXPECT_EQ(frame.vertices[4].normal, frame.vertices[1].normal);
    }
}

TEST(MdlRead, PlacesBesideTheSkinArePutOntoItsBorder) {
    MdlModel model = tetrahedron_model();
    model.places[0] = {0, 8, -3};
    const Mesh mesh = read_mdl(write_mdl(model));
    EXPECT_EQ(number_of(mesh.texels[0].u), 7.5);
    EXPECT_EQ(number_of(mesh.texels[0].v), 0.5);
}

TEST(MdlRead, AScaleIsAppliedBeforeRounding) {
    MdlModel model = tetrahedron_model();
    model.scale = {0.0001F, 0.001F, 0.001F};
    model.origin = {0, -0.3F, 0};
    const Mesh mesh = read_mdl(write_mdl(model), World::from_int(1000));
    EXPECT_NEAR(number_of(mesh.frames[0].vertices[1].position.x), 100 * double{0.0001F} * 1000, 1.0 / 8192);
    EXPECT_NEAR(number_of(mesh.frames[0].vertices[0].position.y), double{-0.3F} * 1000, 1.0 / 8192);
}

MdlFile tetrahedron_with(std::size_t offset, std::int64_t number) {
    MdlFile file = write_mdl(tetrahedron_model());
    put_number(file, offset, 4, number);
    return file;
}

TEST(MdlRead, LyingCountsAreRefusedAtTheirPlace) {
    ASSERT_EQ(fault_of(write_mdl(tetrahedron_model())), "");
    for (const std::size_t offset :
         {kMdlVersion, kMdlSkins, kMdlSkinWidth, kMdlSkinHeight, kMdlVertices, kMdlTriangles, kMdlFrames})
        for (const std::int64_t count :
             {std::int64_t{0}, std::int64_t{-1}, std::int64_t{1} << 30, std::int64_t{1} << 31})
            EXPECT_EQ(fault_of(tetrahedron_with(offset, count)), "header, offset " + std::to_string(offset)) << count;
    EXPECT_EQ(refusal([&] { read_mdl(tetrahedron_with(kMdlVersion, 7)); }), "header, offset 4: version 7, expected 6");
    for (const auto& [offset, count] : {std::pair{kMdlVertices, 5},
                                        {kMdlTriangles, 5},
                                        {kMdlFrames, 3},
                                        {kMdlSkins, 3},
                                        {kMdlTriangles, 1 << 20},
                                        {kMdlVertices, 1 << 20}})
        EXPECT_NE(fault_of(tetrahedron_with(offset, count)), "") << offset << " " << count;
}

TEST(MdlRead, NumbersThatAreNoneOrTooLargeAreRefused) {
    constexpr float kNan = std::numeric_limits<float>::quiet_NaN(), kInfinity = std::numeric_limits<float>::infinity();
    for (std::size_t offset = kMdlScale; offset < kMdlOrigin + 12; offset += 4)
        for (const float value : {kNan, kInfinity, -kInfinity, 1e30F, -32768.F})
            EXPECT_EQ(fault_of(tetrahedron_with(offset, std::bit_cast<std::uint32_t>(value))),
                      "header, offset " + std::to_string(offset))
                << value;
    MdlModel model = tetrahedron_model();
    model.scale = {1000, 1, 1};  // 100 steps: 100,000 units
    EXPECT_TRUE(fault_of(write_mdl(model)).starts_with("frame 0, offset "));
}

TEST(MdlRead, TimesThatDoNotRiseAreRefused) {
    for (const std::vector<float>& times : {std::vector<float>{0.F, 0.1F},
                                            {-1.F, 0.1F},
                                            {0.2F, 0.1F},
                                            {0.1F, 1e9F},
                                            {0.1F, std::numeric_limits<float>::quiet_NaN()}}) {
        MdlModel model = tetrahedron_model();
        model.frames[1].times = times;
        EXPECT_TRUE(fault_of(write_mdl(model)).starts_with("frame 1, offset ")) << times[0] << " " << times[1];
    }
}

TEST(MdlRead, IndicesThatLeadNowhereAreRefused) {
    for (const std::int32_t vertex : {-1, 4, 1 << 30}) {
        MdlModel model = tetrahedron_model();
        model.triangles[2].b = vertex;
        EXPECT_TRUE(fault_of(write_mdl(model)).starts_with("triangles, offset ")) << vertex;
    }
    MdlModel model = tetrahedron_model();
    model.places[2].s = 17;  // of a width of 8
    EXPECT_TRUE(fault_of(write_mdl(model)).starts_with("skin places, offset "));
}

TEST(MdlRead, AFileCutAnywhereIsRefused) {
    const MdlFile good = write_mdl(tetrahedron_model());
    for (std::size_t size = 0; size < good.size(); ++size)
        EXPECT_NE(fault_of({good.begin(), good.begin() + static_cast<std::ptrdiff_t>(size)}), "") << size;
}

/// Whatever is read has no index out of range and boxes that hold.
void expect_sound(const Mesh& mesh) {
    ASSERT_FALSE(mesh.frames.empty());
    ASSERT_FALSE(mesh.skins.empty());
    for (const MeshFrame& frame : mesh.frames) ASSERT_EQ(frame.vertices.size(), mesh.texels.size());
    for (const MeshTriangle& triangle : mesh.triangles)
        for (const std::uint32_t vertex : triangle.vertices) ASSERT_LT(vertex, mesh.texels.size());
    for (const Skin& skin : mesh.skins)
        ASSERT_EQ(skin.texels.size(), static_cast<std::size_t>(skin.width * skin.height));
    for (const MeshTexel& texel : mesh.texels) {
        ASSERT_TRUE(floor_of(texel.u) >= 0 && floor_of(texel.u) < mesh.skins[0].width);
        ASSERT_TRUE(floor_of(texel.v) >= 0 && floor_of(texel.v) < mesh.skins[0].height);
    }
    for (const MeshSequence& sequence : mesh.frame_sequences)
        for (const std::int64_t time_ms : {0, 77, 1000000}) ASSERT_LT(shown_at(sequence, time_ms), mesh.frames.size());
}

TEST(MdlRead, AMillionTrianglesAreRead) {
    MdlModel model = tetrahedron_model();
    model.triangles.assign(1'000'000, model.triangles[0]);
    EXPECT_EQ(read_mdl(write_mdl(model)).triangles.size(), 1'000'000u);
}

/// The counts as the header has them, and what is known of the models: their sizes in units.
TEST(RealModels, HaveTheCountsOfTheirHeaders) {
    OBLONG_NEEDS_SHARED_LEVELS();
    for (const std::string name : {"armor", "b_batt0", "b_g_key"}) {
        const std::vector<std::uint8_t> file = read_shared_file("models/" + name + ".mdl");
        ASSERT_GT(file.size(), kMdlHeaderSize) << name;
        const auto field = [&](std::size_t offset) { return file[offset] + 256u * file[offset + 1]; };
        const Mesh mesh = read_mdl(file);
        EXPECT_EQ(mesh.skins.size(), field(kMdlSkins)) << name;
        EXPECT_EQ(mesh.triangles.size(), field(kMdlTriangles)) << name;
        EXPECT_EQ(mesh.texels.size(), field(kMdlVertices)) << name;  // none is on the seam
        EXPECT_EQ(mesh.frames.size(), field(kMdlFrames)) << name;
        EXPECT_EQ(mesh.skins[0].width, 256) << name;
        EXPECT_EQ(mesh.turns, name == "armor");
        expect_sound(mesh);
        EXPECT_GT(volume_6(mesh, mesh.frames[0]), 0) << name << ": triangles run clockwise";
    }
}

}  // namespace
}  // namespace oblong::test
