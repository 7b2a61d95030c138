#include <gtest/gtest.h>

#include "engine/level/trace.h"
#include "tests/level/level_file.h"

namespace oblong::test {
namespace {

class RealLevel : public LevelFile {};

// Lump numbers and record sizes as the format's description has them, not as the engine does.
TEST_P(RealLevel, HoldsEveryRecordOfTheFile) {
    EXPECT_EQ(level_.planes.size() * 20, lump_size(1));
    EXPECT_EQ(level_.vertices.size() * 12, lump_size(3));
    EXPECT_EQ(level_.visibility.size(), lump_size(4));
    EXPECT_EQ(level_.nodes.size() * 24, lump_size(5));
    EXPECT_EQ(level_.texinfos.size() * 40, lump_size(6));
    EXPECT_EQ(level_.faces.size() * 20, lump_size(7));
    EXPECT_EQ(level_.lighting.size(), lump_size(8));
    EXPECT_EQ(level_.clip_nodes.size() * 8, lump_size(9));
    EXPECT_EQ(level_.leaves.size() * 28, lump_size(10));
    EXPECT_EQ(level_.mark_faces.size() * 2, lump_size(11));
    EXPECT_EQ(level_.edges.size() * 4, lump_size(12));
    EXPECT_EQ(level_.surf_edges.size() * 4, lump_size(13));
    EXPECT_EQ(level_.models.size() * 64, lump_size(14));
    EXPECT_EQ(level_.textures.size(), number_at(file_, lump_offset(2), 4));
    EXPECT_EQ(level_.entities.at(0).value("classname"), "worldspawn");
}

// By the corners of their faces; a model may have brushes without faces (of the texture "skip", say) beyond them.
TEST_P(RealLevel, BoxesOfModelsJustHoldTheirFaces) {
    int exact = 0, all = 0;
    for (const SubModel& model : level_.models) {
        if (&model == &level_.world()) continue;
        LevelBox faces{{99999, 99999, 99999}, {-99999, -99999, -99999}};
        for (const FaceIndex face : model.faces) {
            for (const SurfEdge edge : level_.edges_of(level_.faces[face])) {
                const Point p = to_point(level_.vertices[level_.start_of(edge)]);
                for (std::size_t axis = 0; axis < 3; ++axis) {
                    faces.mins[axis] = std::min(faces.mins[axis], static_cast<LevelNumber>(std::floor(p[axis])));
                    faces.maxs[axis] = std::max(faces.maxs[axis], static_cast<LevelNumber>(std::ceil(p[axis])));
                }
            }
        }
        if (model.faces.count == 0) continue;
        ++all;
        exact += faces.mins == model.box.mins && faces.maxs == model.box.maxs ? 1 : 0;
    }
    EXPECT_EQ(exact, all);
}

// The light compiler wrote the samples of each face behind those of the face before, from a multiple of 4 bytes on:
// with extents too small or too large by one cell, there would be larger gaps or overlaps.
TEST_P(RealLevel, LightmapsOfTheExtentsTileTheLightingLump) {
    std::vector<std::pair<std::int64_t, std::int64_t>> ranges;
    for (const Face& face : level_.faces) {
        if (face.light_offset < 0) continue;
        const auto maps = std::find(face.styles.begin(), face.styles.end(), 255) - face.styles.begin();
        const std::int64_t samples = (face.texel_extent_u / 16 + 1) * (face.texel_extent_v / 16 + 1);
        ranges.emplace_back(face.light_offset, face.light_offset + maps * samples);
    }
    std::sort(ranges.begin(), ranges.end());
    ASSERT_FALSE(ranges.empty());
    for (std::size_t i = 1; i < ranges.size(); ++i) {
        const std::int64_t gap = ranges[i].first - ranges[i - 1].second;
        EXPECT_TRUE(gap >= 0 && gap < 4) << "gap of " << gap << " before byte " << ranges[i].first;
    }
    EXPECT_EQ(ranges.back().second, static_cast<std::int64_t>(level_.lighting.size()));
}

// Only shapes of records differ between the formats: a level written in each must be the same level.
TEST_P(RealLevel, IsTheSameInBsp2And2Psb) {
    const Lumps lumps = split_lumps(file_);
    EXPECT_EQ(level_, read_bsp(join_lumps(version_from_letters("BSP2"), widen_lumps(lumps, true))));
    EXPECT_EQ(level_, read_bsp(join_lumps(version_from_letters("2PSB"), widen_lumps(lumps, false))));
}

/// A row of the visibility lump, unpacked bit by bit.
std::vector<bool> unpack_row(const std::vector<std::uint8_t>& packed, std::size_t at, std::size_t leaf_count) {
    std::vector<bool> bits;
    for (; bits.size() < leaf_count; ++at) {
        const std::uint8_t byte = packed[at];
        if (byte == 0) bits.insert(bits.end(), 8u * packed[++at], false);
        for (int bit = 0; byte != 0 && bit < 8; ++bit) bits.push_back((byte >> bit & 1) != 0);
    }
    return bits;
}

TEST_P(RealLevel, VisibleSetsAreThoseOfTheFile) {
    const auto leaf_count = static_cast<std::size_t>(level_.world().visible_leaf_count);
    std::vector<std::uint8_t> visible(visible_set_size(level_));
    for (const LeafIndex leaf : level_.visible_leaves()) {
        const std::int32_t start = level_.leaves[leaf].visibility_offset;
        ASSERT_GE(start, 0);
        const auto expected = unpack_row(level_.visibility, static_cast<std::size_t>(start), leaf_count);
        unpack_visible_set(level_, leaf, visible);
        for (const LeafIndex other : level_.visible_leaves())
            ASSERT_EQ(is_in_set(visible, other), expected[other.position() - 1])
                << leaf.number() << ' ' << other.number();
    }
}

TEST_P(RealLevel, FromOutsideEveryLeafIsVisible) {
    std::vector<std::uint8_t> visible(visible_set_size(level_));
    unpack_visible_set(level_, kSolidOutside, visible);
    for (const LeafIndex leaf : level_.visible_leaves()) ASSERT_TRUE(is_in_set(visible, leaf));
    EXPECT_FALSE(is_in_set(visible, kSolidOutside));
    EXPECT_FALSE(is_in_set(visible, LeafIndex(level_.world().visible_leaf_count + 1)));
}

OBLONG_FOR_REAL_LEVELS(RealLevel);

class RealTrace : public LevelFile {
  protected:
    const SubModel& world() const { return level_.world(); }
    Vec3<World> random_point() { return random_point_in(world().box, random_); }

    /// Calls check(hull, from, to) for random ways that start outside solid, short ones and long ones.
    template <class Check>
    void for_random_ways(int count, Check check) {
        for (const Hull hull : {Hull::Point, Hull::Player, Hull::Large}) {
            for (int i = 0; i < count;) {
                const Vec3<World> from = random_point();
                if (hull_contents(level_, world(), hull, from) == contents::kSolid) continue;
                const Vec3<World> far = random_point(), way = far - from;
                const std::int32_t divisor = 1 << (i % 6);
                const auto shorten = [divisor](World part) { return World::from_raw(part.raw / divisor); };
                check(hull, from, from + Vec3<World>{shorten(way.x), shorten(way.y), shorten(way.z)});
                ++i;
            }
        }
    }

    std::mt19937 random_{3};
};

TEST_P(RealTrace, ContentsOfThePointHullAreThoseOfTheLeaf) {
    for (int i = 0; i < 5000; ++i) {
        const Vec3<World> p = random_point();
        const Leaf& leaf = level_.leaves[find_leaf(level_, world(), p)];
        ASSERT_EQ(hull_contents(level_, world(), Hull::Point, p), leaf.contents);
    }
}

TEST_P(RealTrace, NeverEndsInSolidAndStaysOnItsWay) {
    int hits = 0;
    for_random_ways(4000, [&](Hull hull, Vec3<World> from, Vec3<World> to) {
        const TraceResult result = trace_hull(level_, world(), hull, from, to);
        hits += result.is_hit;
        ASSERT_FALSE(result.starts_solid);
        ASSERT_NE(hull_contents(level_, world(), hull, result.end), contents::kSolid);
        const double fraction = result.fraction.raw * 0x1p-30;
        ASSERT_TRUE(fraction >= 0 && fraction <= 1);
        ASSERT_LE(length(to_point(result.end) - along(to_point(from), to_point(to), fraction)), 0.01);
        ASSERT_TRUE(result.is_hit || result.end == to);
    });
    EXPECT_GT(hits, 4000);
}

// No wall is passed, however thin.
TEST_P(RealTrace, PassesThroughNothingSolid) {
    int solid = 0;
    for_random_ways(1000, [&](Hull hull, Vec3<World> from, Vec3<World> to) {
        const TraceResult result = trace_hull(level_, world(), hull, from, to);
        for (int i = 1; i < 64; ++i) {
            const Vec3<World> p = to_world(along(to_point(from), to_point(result.end), i / 64.));
            solid += hull_contents(level_, world(), hull, p) == contents::kSolid;
        }
    });
    EXPECT_EQ(solid, 0);
}

TEST_P(RealTrace, StoppedItSlidesAlongThePlaneAndGoesBack) {
    for_random_ways(2000, [&](Hull hull, Vec3<World> from, Vec3<World> to) {
        const TraceResult result = trace_hull(level_, world(), hull, from, to);
        if (!result.is_hit) return;
        const Point way = to_point(to) - to_point(from), n = to_point(result.normal);
        ASSERT_LT(dot(way, n), 0) << "the normal faces the body";
        const Point slide = to_point(result.end) + way - n * dot(way, n);
        const TraceResult slid = trace_hull(level_, world(), hull, result.end, to_world(slide));
        ASSERT_FALSE(slid.starts_solid);
        ASSERT_NE(hull_contents(level_, world(), hull, slid.end), contents::kSolid);
        ASSERT_FALSE(trace_hull(level_, world(), hull, result.end, from).starts_solid);
    });
}

// A way that is free is free backwards too, but for ways that pass an edge closer than the 1/32 unit kept.
TEST_P(RealTrace, FreeWaysAreFreeBackwards) {
    int free = 0, blocked_backwards = 0;
    for_random_ways(3000, [&](Hull hull, Vec3<World> from, Vec3<World> to) {
        if (trace_hull(level_, world(), hull, from, to).is_hit) return;
        ++free;
        blocked_backwards += trace_hull(level_, world(), hull, to, from).is_hit;
    });
    EXPECT_GT(free, 500);
    EXPECT_LE(blocked_backwards, free / 1000);
}

OBLONG_FOR_REAL_LEVELS(RealTrace);

}  // namespace
}  // namespace oblong::test
