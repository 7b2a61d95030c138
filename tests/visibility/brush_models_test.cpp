// Brush models cut into the leaves of the world: against points of their faces, and rays, in doubles.
#include "engine/visibility/brush_models.h"

#include <gtest/gtest.h>

#include <functional>
#include <set>

#include "engine/view/screen_polygon.h"
#include "tests/visibility/visibility_fixture.h"

namespace oblong::test::brush_models_test {

namespace {

/// A random point of a convex polygon.
Point point_in(std::span<const Point> corners, std::mt19937& random) {
    std::uniform_real_distribution<double> part(0, 1);
    const std::size_t fan = 1 + random() % (corners.size() - 2);
    double a = part(random), b = part(random);
    if (a + b > 1) a = 1 - a, b = 1 - b;
    return along(along(corners[0], corners[fan], a), along(corners[0], corners[fan + 1], a), b / std::max(a + b, 1e-9));
}

/// The leaf that holds a point and all that is near it; none if it takes more than one.
LeafIndex leaf_around(const Level& level, Point p) {
    constexpr double kNear = 1.0 / 64;
    LeafIndex leaf = LeafIndex::none();
    for (int corner = 0; corner < 8; ++corner) {
        const auto off = [&](int bit) { return corner >> bit & 1 ? kNear : -kNear; };
        const LeafIndex here = find_leaf(level, level.world(), to_world({p.x + off(0), p.y + off(1), p.z + off(2)}));
        if (!leaf.is_none() && here != leaf) return LeafIndex::none();
        leaf = here;
    }
    return leaf;
}

/// Whether a point of a polygon's plane is inside it (1), outside (-1) or near its border (0).
int is_inside(std::span<const Point> corners, Point p) {
    const Point normal = doubled_area(corners);
    int verdict = 1;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Point edge = corners[(i + 1) % corners.size()] - corners[i];
        if (length(edge) < 1e-6) continue;
        const double distance = dot(cross(edge, p - corners[i]), normal) / (length(edge) * length(normal));
        if (distance < -1.0 / 256) return -1;
        if (distance < 1.0 / 256) verdict = 0;
    }
    return verdict;
}

std::vector<Point> corners_of(const ModelCut& cut, const Fragment& fragment) {
    std::vector<Point> corners;
    for (std::uint32_t i = 0; i < fragment.corner_count; ++i)
        corners.push_back(to_point(cut.corners[fragment.first_corner + i]));
    return corners;
}

struct Tally {
    int in_open = 0, in_solid = 0;
};

/// Asks points of one face of a model: each is in one fragment, that of its leaf; in none where the world is solid.
void check_points(const Level& level, const ModelCut& cut, FaceIndex face, std::span<const Point> outline,
                  std::mt19937& random, Tally& tally) {
    for (int i = 0; i < 20; ++i) {
        const Point p = point_in(outline, random);
        const LeafIndex leaf = leaf_around(level, p);
        int holding = 0;
        bool in_doubt = leaf.is_none();
        for (const Fragment& fragment : cut.fragments) {
            if (fragment.face != face || in_doubt) continue;
            const std::vector<Point> corners = corners_of(cut, fragment);
            const int verdict = is_inside(corners, p);
            in_doubt |= verdict == 0;
            if (verdict <= 0) continue;
            ++holding;
            EXPECT_EQ(fragment.leaf, leaf);
        }
        if (in_doubt) continue;
        const bool is_solid = level.leaves[leaf].contents == contents::kSolid;
        ++(is_solid ? tally.in_solid : tally.in_open);
        ASSERT_EQ(holding, is_solid ? 0 : 1) << "face " << face.number() << " at " << p.x << ", " << p.y << ", " << p.z;
    }
}

std::vector<PlacedModel> moved_by(std::vector<PlacedModel> models, Vec3<World> by) {
    for (PlacedModel& model : models) model.offset = model.offset + by;
    return models;
}

/// The leaves that one model alone of `placed` is in: what shares a leaf is cut by each other as well.
std::vector<LeafIndex> leaves_of_one_model(const Level& level, const FaceTable& table,
                                           std::span<const PlacedModel> placed) {
    Table<std::set<const PlacedModel*>, Leaf> owners(level.leaves.size());
    for (const PlacedModel& model : placed)
        for (const Fragment& fragment : cut_model(level, model, {}, table).fragments)
            owners[fragment.leaf].insert(&model);
    std::vector<LeafIndex> leaves;
    for (const LeafIndex leaf : owners.indices())
        if (owners[leaf].size() == 1) leaves.push_back(leaf);
    return leaves;
}

/// The parts in a leaf that face the eye, as a view in all directions shows them.
std::span<const Fragment* const> all_facing(BrushModels& models, LeafIndex leaf, const Level& level, Vec3<World> eye) {
    const BoxCuller nothing(Frustum{}, {});
    const std::function<bool(const LevelBox&)> is_free = [](const LevelBox&) { return true; };
    return models.front_to_back_in(leaf, {level, {eye}, nothing, is_free});
}

/// Of each fragment in some leaves its model, and where its corners are kept.
std::vector<std::pair<PlacedIndex, const Vec3<World>*>> kept_corners(BrushModels& models,
                                                                     std::span<const LeafIndex> leaves,
                                                                     const Level& level, Vec3<World> eye) {
    std::vector<std::pair<PlacedIndex, const Vec3<World>*>> kept;
    for (const LeafIndex leaf : leaves)
        for (const Fragment* fragment : all_facing(models, leaf, level, eye))
            kept.emplace_back(fragment->placed, models.corners_of(*fragment).data());
    return kept;
}

Point middle_of(std::span<const Point> corners) {
    Point middle;
    for (const Point& p : corners) middle = middle + p * (1.0 / static_cast<double>(corners.size()));
    return middle;
}

struct OrderTally {
    int fragments = 0, pairs = 0;
};

/// A ray to the middle of each part: what it passes through of the parts before it, of the same model, is nearer.
void check_order(const BrushModels& models, std::span<const Fragment* const> fragments, Point eye, OrderTally& tally) {
    std::vector<std::vector<Point>> outlines;
    for (std::size_t i = 0; i < fragments.size(); ++i) {
        std::vector<Point>& outline = outlines.emplace_back();
        for (const Vec3<World>& corner : models.corners_of(*fragments[i])) outline.push_back(to_point(corner));
        // Clockwise from the front: the normal by the corners' order points away from the eye.
        EXPECT_GT(dot(doubled_area(outline), outline[0] - eye), 0);
        ++tally.fragments;
        const Point ray = middle_of(outline) - eye;
        for (std::size_t before = 0; before < i; ++before) {
            const Passage passage = pass_through(outlines[before], eye, ray);
            if (passage.meeting != Meeting::Hit || fragments[before]->placed != fragments[i]->placed) continue;
            EXPECT_LT(passage.along, 1 + 1e-6) << "behind, but handed out before";
            ++tally.pairs;
        }
    }
}

class BrushModel : public OfLevel {};

}  // namespace

TEST_P(BrushModel, FragmentsCoverEachFaceOnceWhereTheWorldIsOpen) {
    const Level level = read_level(GetParam());
    const FaceTable table = make_face_table(level);
    std::mt19937 random(1);
    Tally tally;
    const Vec3<World> off{World::from_raw(50'000), World::from_raw(-31'111), World::from_raw(123'457)};
    for (const std::vector<PlacedModel>& models : {models_at_rest(level), moved_by(models_at_rest(level), off)})
        for (const PlacedModel& placed : models) {
            const ModelCut cut = cut_model(level, placed, {}, table);
            for (const FaceIndex face : level.models[placed.model].faces) {
                if (HasFatalFailure()) return;
                const std::vector<Point> outline = points_of(level, table.corners_of(face), placed.offset);
                check_points(level, cut, face, outline, random, tally);
            }
        }
    EXPECT_GT(tally.in_open, 300);
    EXPECT_GT(tally.in_solid, 30);
}

TEST_P(BrushModel, FragmentsOfALeafFaceTheEyeAndOneModelsComeFrontToBack) {
    const Level level = read_level(GetParam());
    const FaceTable table = make_face_table(level);
    BrushModels models(level);
    std::mt19937 random(2);
    OrderTally tally;
    for (int trial = 0; trial < 60; ++trial) {
        models.start_frame(level, models_at_rest(level), table);
        const Vec3<World> eye = random_open_point(level, random);
        for (const LeafIndex leaf : level.leaves.indices())
            check_order(models, all_facing(models, leaf, level, eye), to_point(eye), tally);
    }
    EXPECT_GT(tally.fragments, 300);
    // The demo level's models are convex: no two parts of one that face the eye are on a ray.
    EXPECT_GT(tally.pairs, is_demo() ? -1 : 100);
}

TEST_P(BrushModel, OnlyWhatHasMovedIsCutAgain) {
    const Level level = read_level(GetParam());
    const FaceTable table = make_face_table(level);
    std::mt19937 random(3);
    const Vec3<World> eye = random_open_point(level, random);
    const std::vector<PlacedModel> at_rest = models_at_rest(level);
    ASSERT_GE(at_rest.size(), 2U);
    std::vector<PlacedModel> moved = at_rest;
    moved[0].offset.z = moved[0].offset.z + World::from_int(3);
    std::vector<PlacedModel> all = at_rest;
    all.push_back(moved[0]);
    const std::vector<LeafIndex> leaves = leaves_of_one_model(level, table, all);

    BrushModels models(level);
    models.start_frame(level, at_rest, table);
    const auto at_first = kept_corners(models, leaves, level, eye);
    EXPECT_FALSE(at_first.empty());
    models.start_frame(level, at_rest, table);
    EXPECT_EQ(kept_corners(models, leaves, level, eye), at_first);
    models.start_frame(level, moved, table);
    auto others_at_first = at_first, others = kept_corners(models, leaves, level, eye);
    const auto is_moved = [](const auto& kept) { return kept.first == PlacedIndex(0); };
    std::erase_if(others_at_first, is_moved);
    std::erase_if(others, is_moved);
    EXPECT_FALSE(others.empty());
    EXPECT_EQ(others, others_at_first);
}

TEST_P(BrushModel, OneThatIsOnlySwitchedIsNotCutAgain) {
    const Level level = read_level(GetParam());
    const FaceTable table = make_face_table(level);
    std::vector<PlacedModel> placed = models_at_rest(level);
    const Fragment fragment = cut_model(level, placed[0], PlacedIndex(0), table).fragments[0];
    BrushModels models(level);
    models.start_frame(level, placed, table);
    const Vec3<World>* const corners = models.corners_of(fragment).data();
    placed[0].is_switched = true;
    models.start_frame(level, placed, table);
    EXPECT_TRUE(models.is_switched(fragment));
    EXPECT_EQ(models.corners_of(fragment).data(), corners);
    placed[0].offset.z = placed[0].offset.z + World::ulp();
    models.start_frame(level, placed, table);
    EXPECT_NE(models.corners_of(fragment).data(), corners);
}

// At a fraction of a unit its box is rounded outward, by less than a unit.
TEST_P(BrushModel, IsAskedForWithABoxAroundAllOfIt) {
    Level level = read_level(GetParam());
    for (SubModel& model : level.models) model.box = {{-1, -2, -3}, {4, 5, 6}};
    const FaceTable table = make_face_table(level);
    const Vec3<World> by{World::ulp(), World{} - World::ulp(), World::from_int(1)};
    std::vector<PlacedModel> placed = models_at_rest(level);
    for (PlacedModel& model : placed) model.offset = by;
    BrushModels models(level);
    models.start_frame(level, placed, table);
    int asked = 0;
    const std::function<bool(const LevelBox&)> is_free = [&](const LevelBox& box) {
        ++asked;
        EXPECT_EQ(box.mins, (std::array<LevelNumber, 3>{-1, -3, -2}));
        EXPECT_EQ(box.maxs, (std::array<LevelNumber, 3>{5, 5, 8}));
        return false;
    };
    for (const LeafIndex leaf : level.leaves.indices())
        models.front_to_back_in(leaf, {level, {by}, BoxCuller(Frustum{}, {}), is_free});
    EXPECT_GT(asked, 0);
}

TEST_P(BrushModel, OnlyPartsOutsideTheViewAreLeftOut) {
    const Level level = read_level(GetParam());
    const FaceTable table = make_face_table(level);
    BrushModels models(level);
    ScreenPolygon polygon;
    std::mt19937 random(4);
    int kept = 0, left_out = 0, left_out_of_models_in_view = 0;
    const std::function<bool(const LevelBox&)> is_free = [](const LevelBox&) { return true; };
    for (int trial = 0; trial < 120; ++trial) {
        const ViewContext view = view_from(random_open_point(level, random), Angle::from_bam(random()));
        const BoxCuller culler(view.frustum, view.eye);
        std::vector<PlacedModel> placed = models_at_rest(level);
        for (PlacedModel& model : placed) model.offset.z = World::from_raw(random_below(random, 1 << 20));
        std::set<const Fragment*> in_view;
        std::set<PlacedIndex> models_in_view;
        models.start_frame(level, placed, table);
        for (const LeafIndex leaf : level.leaves.indices())
            for (const Fragment* part : models.front_to_back_in(leaf, {level, view.viewpoint, culler, is_free})) {
                in_view.insert(part);
                models_in_view.insert(part->placed);
            }
        kept += static_cast<int>(in_view.size());
        models.start_frame(level, placed, table);
        for (const LeafIndex leaf : level.leaves.indices())
            for (const Fragment* part : all_facing(models, leaf, level, view.eye)) {
                if (in_view.contains(part)) continue;
                EXPECT_FALSE(project_polygon(models.corners_of(*part), view, polygon));
                ++left_out;
                left_out_of_models_in_view += models_in_view.contains(part->placed);
            }
    }
    EXPECT_GT(kept, 100);
    EXPECT_GT(left_out, 100);
    if (is_demo()) return;  // its models are convex
    EXPECT_GT(left_out_of_models_in_view, 10);
}

OBLONG_FOR_LEVELS(BrushModel, testing::Values("demo", "e1m7", "end"));

}  // namespace oblong::test::brush_models_test
