// What is before the faces of a frame, as far as they leave it to be seen, is in leaves that the walk enters.

#include <gtest/gtest.h>

#include <random>
#include <utility>

#include "tests/frame/frame_fixture.h"
#include "tests/support/random.h"
#include "tests/support/views.h"

namespace oblong::test {
namespace {

/// Without models, which hide leaves that are open here, and mirrors, which walk once more.
class LeafCheck {
  public:
    explicit LeafCheck(Stage stage) : stage_(std::move(stage)) { stage_.settings.allowed_effects = {}; }

    void check_views() {
        int passed_over = 0;  // leaves of the visible sets
        for (int trial = 0; trial < 300; ++trial) {
            const Camera camera = random_camera();
            SCOPED_TRACE("trial " + std::to_string(trial));
            stage_.draw(camera, work_);
            check_rays(TrueCamera(camera));
            if (testing::Test::HasFailure()) return;
            for (const LeafIndex leaf : stage_.level.visible_leaves())
                passed_over += work_.view.visible.has_leaf(leaf) && !work_.view.claiming->walk.entered.has(leaf);
        }
        EXPECT_GT(passed_, 100'000);
        EXPECT_GT(passed_over, 1'000);
    }

  private:
    Camera random_camera() {
        const Vec3<World> eye = random_open_point(stage_.level, random_);
        return camera_at(eye, random_between(random_, 0, 360), random_between(random_, -40, 40));
    }
    /// A part of a ray. Whether it ends where it goes on: false at the first face of the world, or a liquid's surface.
    /// Till there all leaves are entered that it passes half a unit of, and none is lower than they are.
    bool check_part(NodeChild at, const Point& from, const Point& to) {
        const Level& level = stage_.level;
        if (at.is_leaf()) {
            if (level.leaves[at.leaf()].contents != contents_ || !work_.view.visible.has_leaf(at.leaf())) return false;
            if (length(to - from) < 0.5) return true;
            ++passed_;
            EXPECT_TRUE(work_.view.claiming->walk.entered.has(at.leaf())) << "leaf " << at.leaf().number();
            EXPECT_GE(std::min(from.z, to.z), number_of(work_.view.claiming->walk.lowest_z) - 1.01);
            return !testing::Test::HasFailure();
        }
        const Node& node = level.nodes[at.node()];
        const LevelPlane& plane = level.planes[node.plane];
        const double before = dot(to_point(plane.normal), from) - number_of(plane.distance);
        const double after = dot(to_point(plane.normal), to) - number_of(plane.distance);
        if ((before > 0) == (after > 0)) return check_part(node.children[before <= 0], from, to);
        const Point middle = from + (to - from) * (before / (before - after));
        return check_part(node.children[before <= 0], from, middle) &&
               check_part(node.children[after <= 0], middle, to);
    }
    void check_rays(const TrueCamera& camera) {
        const NodeChild root = stage_.level.world().root;
        contents_ = stage_.level.leaves[find_leaf(stage_.level, stage_.level.world(), to_world(camera.eye))].contents;
        for (int i = 0; i < 200; ++i) {
            const Point ray = camera.through_pixel(random_below(random_, 320), random_below(random_, 200));
            check_part(root, camera.eye + ray, camera.eye + ray * 10'000);
        }
    }

    Stage stage_;
    FrameWorkspace work_{stage_.level, stage_.mode};
    std::mt19937 random_{7};
    std::int32_t contents_ = 0;  ///< of the eye's leaf
    int passed_ = 0;             ///< leaves by rays
};

class EnteredLeaves : public OfLevel {};

TEST_P(EnteredLeaves, HoldAllThatIsBeforeTheFaces) {
    LeafCheck(stage_named(GetParam())).check_views();
}

OBLONG_FOR_ALL_LEVELS(EnteredLeaves);

}  // namespace
}  // namespace oblong::test
