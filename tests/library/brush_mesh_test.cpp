#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "engine/models/turning_brushes.h"
#include "tests/map/map_source.h"
#include "tools/map/source/textures.h"

namespace oblong::test {
namespace {

using Point = std::array<double, 3>;

Point point_of(const Vec3<World>& place) {
    return {place.x.raw / 4096.0, place.y.raw / 4096.0, place.z.raw / 4096.0};
}

double product(const Vec3<TexelAxis>& axis, const Point& p) {
    constexpr double kOne = 1 << TexelAxis::kFractionBits;
    return (axis.x.raw * p[0] + axis.y.raw * p[1] + axis.z.raw * p[2]) / kOne;
}

// The face of a model on whose plane a place lies.
FaceIndex face_at(const Level& level, const SubModel& model, const Point& place) {
    for (const FaceIndex face : model.faces) {
        const LevelPlane& plane = level.planes[level.faces[face].plane];
        const Point distances{plane.normal.x.raw * place[0], plane.normal.y.raw * place[1],
                              plane.normal.z.raw * place[2]};
        const double distance = (distances[0] + distances[1] + distances[2]) / Unit::from_int(1).raw -
                                static_cast<double>(plane.distance.raw) / PlaneDistance::from_int(1).raw;
        if (std::abs(distance) < 0.01) return face;
    }
    ADD_FAILURE() << "no face";
    return model.faces.first;
}

// A beam with stripes of two texels, about its middle, (1, 5, 100).
TEST(BrushMesh, IsClosedFacesOutwardAndShowsTheTexelsOfTheLevel) {
    const std::string text = level(room({-256, -256, 0}, {256, 256, 256}),
                                   entity_at("info_player_start", {-100, 0, 24}) + entity_at("light", {0, 0, 200}) +
                                       entity("func_rotating", {}, box({-59, -10, 83}, {61, 20, 117}, "stripes")));
    const std::vector<map::Wad> wads{
        map::Wad(wad_bytes(std::vector<StripedTexture>{{"wall", 1, 1}, {"stripes", 5, 9}}))};
    const Level level = engine_level(map::compile_map(map::parse_map(text), wads, {true}));
    const SubModel& model = level.models[ModelIndex(1)];
    EXPECT_EQ(point_of(middle_of(model.box)), (Point{1, 5, 100}));
    std::int64_t texels_left = 100'000;
    const Mesh mesh = make_brush_mesh(level, ModelIndex(1), middle_of(model.box), texels_left);
    std::size_t texels = 0;
    for (const Skin& skin : mesh.skins) texels += skin.texels.size();
    EXPECT_EQ(texels_left + static_cast<std::int64_t>(texels), 100'000);
    for (const Skin& skin : make_brush_mesh(level, ModelIndex(1), {}, texels_left = 0).skins)
        EXPECT_EQ(skin.texels.size(), 1u) << "none are left";
    const std::vector<MeshVertex>& vertices = mesh.frames.at(0).vertices;
    EXPECT_EQ(point_of(mesh.frames[0].maxs), (Point{60, 15, 17}));
    double area = 0;
    int first_colour = 0;
    for (const MeshTriangle& triangle : mesh.triangles) {
        std::array<Point, 3> corners;
        for (std::size_t i = 0; i < 3; ++i) corners[i] = point_of(vertices.at(triangle.vertices[i]).position);
        Point a, b;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            a[axis] = corners[2][axis] - corners[0][axis];
            b[axis] = corners[1][axis] - corners[0][axis];
        }
        const Point normal{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
        area += std::hypot(normal[0], normal[1], normal[2]) / 2;
        EXPECT_GT(normal[0] * corners[0][0] + normal[1] * corners[0][1] + normal[2] * corners[0][2], 0) << "outward";
        // A place inside, in the mesh and in the level.
        constexpr std::array<double, 3> kWeights{0.31, 0.29, 0.4};
        Point place{1, 5, 100};
        double u = 0, v = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            for (std::size_t axis = 0; axis < 3; ++axis) place[axis] += kWeights[i] * corners[i][axis];
            u += kWeights[i] * static_cast<double>(mesh.texels.at(triangle.vertices[i]).u.raw) / 65'536;
            v += kWeights[i] * static_cast<double>(mesh.texels.at(triangle.vertices[i]).v.raw) / 65'536;
        }
        const Skin& skin = mesh.skins.at(triangle.skin);
        ASSERT_EQ(skin.texels.size(), as_size(skin.width) * as_size(skin.height));
        const auto texel = skin.texels.at(as_size(v) * as_size(skin.width) + as_size(u));
        const TexInfo& texinfo = level.texinfos[level.faces[face_at(level, model, place)].texinfo];
        const double of_level = product(texinfo.s, place) + static_cast<double>(texinfo.s_offset.raw) / 65'536;
        const int stripe = static_cast<int>(std::floor(of_level / 2)) & 1;
        EXPECT_NEAR(std::remainder(u - of_level, 1), 0, 0.001);
        EXPECT_EQ(texel, stripe == 0 ? 5 : 9) << place[0] << ", " << place[1] << ", " << place[2];
        first_colour += texel == 5;
    }
    EXPECT_NEAR(area, 2 * (120 * 30 + 120 * 34 + 30 * 34), 0.5);
    EXPECT_GT(first_colour, 0);
    EXPECT_LT(first_colour, static_cast<int>(mesh.triangles.size()));
}

}  // namespace
}  // namespace oblong::test
