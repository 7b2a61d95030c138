// The order in which the faces of a world come, against rays in doubles. No face claims a pixel here, so that both
// walks run to their ends: the first over what may be seen, the second over everything.
#include "engine/visibility/front_to_back.h"

#include <gtest/gtest.h>

#include <map>

#include "tests/visibility/visibility_fixture.h"

namespace oblong::test::front_to_back_test {

namespace {

/// Of each face its places in the order: in the first walk and the second, or in the second alone.
using Places = std::map<FaceIndex, std::vector<std::size_t>>;

class Walker {
  public:
    explicit Walker(const std::string& name) : level(read_level(name)) {}

    Places walk(const ViewContext& view) {
        visible_.see_from(level, find_leaf(level, level.world(), view.eye));
        Places places;
        std::size_t place = 0;
        FrontToBackWalk walk(level, view, visible_, nullptr, span_buffer_, scratch_);
        VisibleFace face;
        while (walk.next(face)) places[face.face].push_back(place++);
        return places;
    }
    bool hands_out_nothing_when_full(const ViewContext& view) {
        SpanList owned;
        SpanBuffer full(320, 200);
        full.claim_rest(owned);
        FrontToBackWalk walk(level, view, visible_, nullptr, full, scratch_);
        VisibleFace face;
        return !walk.next(face);
    }

    const Level level;
    const FaceTable table = make_face_table(level);

  private:
    VisibleSet visible_{level};
    SpanBuffer span_buffer_{320, 200};
    WalkScratch scratch_{{}, Table<std::uint32_t, Face>(level.faces.size()), 0, LeafSet(level.leaves.size())};
};

ViewContext random_view(const Level& level, std::mt19937& random) {
    return view_from(random_open_point(level, random), random_angle(random),
                     Angle::from_bam(random_below(random, 16384) - 8192));
}

/// Through a random place of the screen, a few pixels from its border.
Point random_ray(const ViewContext& view, std::mt19937& random) {
    const double right = random_between(random, -0.97, 0.97), up = random_between(random, -0.97, 0.97) * 0.75;
    const Basis& axes = view.axes;
    return to_point(axes.right) * right + to_point(axes.up) * up + to_point(axes.forward);
}

struct Hit {
    double distance;
    FaceIndex face;
    bool is_from_front;
};

/// The faces of the world that a ray passes through, nearest first; none where that is in doubt of any.
std::vector<Hit> hits_of(const Table<std::vector<Point>, Face>& outlines, Point eye, Point ray) {
    std::vector<Hit> hits;
    for (const FaceIndex face : outlines.indices()) {
        const Passage passage = pass_through(outlines[face], eye, ray);
        if (passage.meeting == Meeting::Doubtful) return {};
        if (passage.meeting == Meeting::Hit) hits.push_back({passage.along * length(ray), face, passage.is_from_front});
    }
    std::sort(hits.begin(), hits.end(), [](const Hit& a, const Hit& b) { return a.distance < b.distance; });
    return hits;
}

struct Tally {
    int pairs = 0, pairs_of_the_first_walk = 0, views_with_faces_left_out = 0;
};

/// Of the first walk's faces those are compared that face the eye: others come with the far side.
void check_ray(const std::vector<Hit>& hits, const Places& places, Tally& tally) {
    bool is_anything_seen = false;
    for (std::size_t far = 0; far < hits.size(); ++far) {
        ASSERT_TRUE(places.contains(hits[far].face)) << "a face in view was not handed out";
        const std::vector<std::size_t>& far_places = places.at(hits[far].face);
        if (!is_anything_seen && hits[far].is_from_front) {
            EXPECT_EQ(far_places.size(), 2U) << "what is seen comes in the first walk";
            is_anything_seen = true;
        }
        for (std::size_t near = 0; near < far; ++near) {
            if (hits[far].distance - hits[near].distance < 0.1) continue;
            const std::vector<std::size_t>& near_places = places.at(hits[near].face);
            EXPECT_LT(near_places.back(), far_places.back());
            ++tally.pairs;
            if (near_places.size() != 2 || far_places.size() != 2) continue;
            if (!hits[near].is_from_front || !hits[far].is_from_front) continue;
            EXPECT_LT(near_places.front(), far_places.front());
            ++tally.pairs_of_the_first_walk;
        }
    }
}

class FrontToBack : public OfLevel {};

}  // namespace

TEST_P(FrontToBack, OfTwoFacesOnARayTheNearerComesFirstAndNoneComesTwice) {
    Walker walker(GetParam());
    Table<std::vector<Point>, Face> outlines;
    for (const FaceIndex face : walker.level.world().faces)
        outlines.push_back(points_of(walker.level, walker.table.corners_of(face), {}));
    std::mt19937 random(1);
    Tally tally;
    for (int trial = 0; trial < 25 && !HasFatalFailure(); ++trial) {
        const ViewContext view = random_view(walker.level, random);
        const Places places = walker.walk(view);
        for (const auto& [face, at] : places) ASSERT_LE(at.size(), 2U) << face.number() << ": once a walk";
        tally.views_with_faces_left_out += places.size() < outlines.size();
        for (int i = 0; i < 30; ++i)
            check_ray(hits_of(outlines, to_point(view.eye), random_ray(view, random)), places, tally);
    }
    EXPECT_GT(tally.pairs, 1000);
    EXPECT_GT(tally.pairs_of_the_first_walk, 100);
    EXPECT_GT(tally.views_with_faces_left_out, 20) << "what is out of view is not handed out";
}

OBLONG_FOR_ALL_LEVELS(FrontToBack);

TEST(FrontToBackWalk, NothingIsHandedOutWhereNoPixelIsFree) {
    Walker walker("demo");
    std::mt19937 random(2);
    EXPECT_TRUE(walker.hands_out_nothing_when_full(random_view(walker.level, random)));
}

}  // namespace oblong::test::front_to_back_test
