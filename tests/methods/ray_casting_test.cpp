#include <gtest/gtest.h>

#include "engine/methods/lines.h"
#include "engine/methods/pixel_owners.h"
#include "engine/view/projection.h"
#include "tests/support/random.h"

namespace oblong::test {
namespace {

constexpr ScreenMode kMode{64, 40, {4, 3}};

/// Polygons before an eye at the origin that looks along +x, with y to the left and z up.
class Scene {
  public:
    void add(std::span<const Point> corners, bool is_seen_through = false) {
        std::vector<Vec3<World>> world;
        for (const Point& corner : corners) world.push_back(to_world(corner));
        ScannedFace face;
        face.is_seen_through = is_seen_through;
        face.normal = normalised(cross(world[2] - world[0], world[1] - world[0]));
        face.eye_distance = distance_to_plane({}, plane_through(world[0], face.normal));
        add_face(face, ScanlineExtents(kMode.height_px), kMode.width_px, world, {}, scanned_);
    }

    PixelOwners cast() const {
        PixelOwners owners;
        owners.start(kMode.width_px, kMode.height_px);
        RayTargets targets;
        const Projection projection = make_projection(kMode, Degrees::from_int(90));
        find_owners_by_rays(scanned_, make_view_directions(view_basis({}, {}, {}), projection), targets, owners);
        return owners;
    }

  private:
    ScannedFaces scanned_;
};

std::array<Point, 4> square(double x, double half, double left = 0) {
    return {{{x, left + half, half}, {x, left - half, half}, {x, left - half, -half}, {x, left + half, -half}}};
}

TEST(RayCasting, PassesFacesThatFaceAwayAndThoseBehindTheEye) {
    Scene scene;
    auto turned = square(50, 30);
    std::reverse(turned.begin(), turned.end());
    scene.add(turned);
    auto behind = square(-50, 30);
    scene.add(behind);
    std::reverse(behind.begin(), behind.end());
    scene.add(behind);
    for (const std::int32_t owner : scene.cast().faces) EXPECT_EQ(owner, PixelOwners::kNone);
}

TEST(RayCasting, SeesThroughFacesBeforeTheNearest) {
    Scene scene;
    scene.add(square(100, 90));
    scene.add(square(50, 10), true);
    scene.add(square(150, 10), true);
    const PixelOwners owners = scene.cast();
    EXPECT_EQ(owners.row(20)[32], 0);
    ASSERT_FALSE(owners.seen.empty());
    for (const OwnedRun& run : owners.seen) EXPECT_EQ(run.face, 1);
}

TEST(RayCasting, LeavesNoPixelBetweenTrianglesThatShareAnEdge) {
    std::mt19937 random(4);
    const auto between = [&](double low, double high) { return random_between(random, low, high); };
    for (int i = 0; i < 200; ++i) {
        // A square that fills the view, cut into four at a point of it.
        const auto corners = square(10, 40);
        const Point middle{10, between(-9, 9), between(-9, 9)};
        Scene scene;
        for (std::size_t k = 0; k < 4; ++k) scene.add(std::array{corners[k], corners[(k + 1) % 4], middle});
        for (const std::int32_t owner : scene.cast().faces) ASSERT_NE(owner, PixelOwners::kNone) << i;
    }
}

}  // namespace
}  // namespace oblong::test
