#include "engine/level/side.h"

#include <gtest/gtest.h>

#include "tests/level/level_file.h"
#include "tests/support/random.h"

namespace oblong::test::side_test {
namespace {

__extension__ typedef __int128 Int128;

/// A float times 2^bits, exactly: a float has 24 bits, so the caller chooses `bits` for all of them to be whole.
Int128 scaled_float(float value, int bits) {
    int exponent = 0;
    const auto mantissa = static_cast<std::int64_t>(std::ldexp(std::frexp(value, &exponent), 24));
    const int shift = exponent - 24 + bits;
    EXPECT_TRUE(mantissa == 0 || shift >= 0) << value << " has bits below 2^-" << bits;
    return mantissa == 0 ? 0 : Int128{mantissa} * (Int128{1} << shift);
}

struct FilePlane {
    float normal[3], distance;
};

float float_at(const Bytes& bytes, std::size_t offset) {
    return std::bit_cast<float>(number_at(bytes, offset, 4));
}

std::vector<FilePlane> file_planes(const Bytes& lump) {
    std::vector<FilePlane> planes;
    for (std::size_t at = 0; at < lump.size(); at += 20)
        planes.push_back(
            {{float_at(lump, at), float_at(lump, at + 4), float_at(lump, at + 8)}, float_at(lump, at + 12)});
    return planes;
}

/// The sign of normal . p - distance over the file's own floats, in whole units of 2^-72.
int exact_side(const FilePlane& plane, Vec3<World> p) {
    const Int128 sum = scaled_float(plane.normal[0], 60) * p.x.raw + scaled_float(plane.normal[1], 60) * p.y.raw +
                       scaled_float(plane.normal[2], 60) * p.z.raw - scaled_float(plane.distance, 72);
    return (sum > 0) - (sum < 0);
}

class RealSides : public LevelFile {
  protected:
    void SetUp() override {
        LevelFile::SetUp();
        if (IsSkipped()) return;
        lumps_ = split_lumps(file_);
        planes_ = file_planes(lump_of(lumps_, Lump::Planes));
    }

    /// Points where sides are in doubt: all vertices, and whole-unit points of the level's box; and others.
    std::vector<Vec3<World>> make_points() const {
        std::mt19937 random(1993);
        std::vector<Vec3<World>> points(level_.vertices.begin(), level_.vertices.end());
        for (int i = 0; i < 3000; ++i) {
            Vec3<World> p = random_point_in(level_.world().box, random);
            points.push_back(p);
            const auto to_whole = [](World part) { return World::from_raw(part.raw & ~0xfff); };
            points.push_back({to_whole(p.x), to_whole(p.y), to_whole(p.z)});
        }
        return points;
    }

    /// The walk down the file's own nodes.
    std::int32_t exact_leaf(Vec3<World> p) {
        const Bytes& nodes = lump_of(lumps_, Lump::Nodes);
        std::int32_t child = 0;
        while (child >= 0) {
            const std::size_t at = static_cast<std::size_t>(child) * 24;
            const bool is_front = exact_side(planes_[number_at(nodes, at, 4)], p) > 0;
            child = static_cast<std::int16_t>(number_at(nodes, at + (is_front ? 4 : 6), 2));
        }
        return -1 - child;
    }

    Lumps lumps_;
    std::vector<FilePlane> planes_;
};

TEST_P(RealSides, LeafOfEveryPointIsThatOfTheExactWalk) {
    for (const Vec3<World>& p : make_points())
        ASSERT_EQ(find_leaf(level_, level_.world(), p).number(), exact_leaf(p))
            << p.x.raw << ' ' << p.y.raw << ' ' << p.z.raw;
}

TEST_P(RealSides, EveryPlaneAgreesWithTheExactSide) {
    const std::vector<Vec3<World>> points = make_points();
    int on_plane = 0;
    for (const PlaneIndex plane : level_.planes.indices()) {
        for (std::size_t j = plane.position() % 37; j < points.size(); j += 37) {
            const int side = exact_side(planes_[plane.position()], points[j]);
            on_plane += side == 0;
            ASSERT_EQ(plane_side(level_.planes[plane], points[j]), side) << "plane " << plane.number();
        }
    }
    EXPECT_GT(on_plane, 100) << "too few points in doubt to show anything";
}

OBLONG_FOR_REAL_LEVELS(RealSides);

/// A plane, through the reader, in a level whose face has another.
LevelPlane read_plane(const FilePlane& plane) {
    Lumps lumps = make_tiny_lumps();
    Bytes& lump = lump_of(lumps, Lump::Planes);
    ByteWriter(lump).f32(plane.normal[0]).f32(plane.normal[1]).f32(plane.normal[2]).f32(plane.distance).i32(3);
    return read_bsp(join_lumps(29, lumps)).planes.back();
}

FilePlane random_plane(std::mt19937& random) {
    std::normal_distribution<double> part;
    const double x = part(random), y = part(random), z = part(random) * (random() % 2 == 0 ? 1 : 1e-6);
    const double length = std::sqrt(x * x + y * y + z * z);
    return {{static_cast<float>(x / length), static_cast<float>(y / length), static_cast<float>(z / length)},
            static_cast<float>(std::uniform_real_distribution<double>(-900000, 900000)(random))};
}

/// `p` moved along z to within an ulp of the plane, if the world reaches that far.
Vec3<World> drop_onto(const FilePlane& plane, Vec3<World> p) {
    const double along_x = plane.normal[0] * (p.x.raw / 4096.), along_y = plane.normal[1] * (p.y.raw / 4096.);
    const double z = (plane.distance - along_x - along_y) / plane.normal[2];
    if (std::abs(z) < 524287) p.z = World::from_raw(static_cast<std::int32_t>(std::floor(z * 4096)));
    return p;
}

// The corners of the world are where sums come nearest to 64 bits, and points next to the plane where they cancel.
TEST(PlaneSide, IsExactInTheWholeWorld) {
    std::mt19937 random(42);
    for (int i = 0; i < 2000; ++i) {
        const FilePlane plane = random_plane(random);
        const LevelPlane level_plane = read_plane(plane);
        for (int j = 0; j < 20; ++j) {
            const Vec3<World> any = random_world(random);
            for (const Vec3<World>& p : {any, drop_onto(plane, any)})
                ASSERT_EQ(plane_side(level_plane, p), exact_side(plane, p));
        }
        const World low = World::lowest(), high = World::highest();
        for (const World cx : {low, high})
            for (const World cy : {low, high})
                for (const World cz : {low, high})
                    ASSERT_EQ(plane_side(level_plane, {cx, cy, cz}), exact_side(plane, {cx, cy, cz}));
    }
}

TEST(PlaneSide, DistanceKeepsItsStatedBound) {
    std::mt19937 random(7);
    for (int i = 0; i < 2000; ++i) {
        const FilePlane plane = random_plane(random);
        const Vec3<World> any = random_world(random);
        const double exact = plane.normal[0] * number_of(any.x) + plane.normal[1] * number_of(any.y) +
                             plane.normal[2] * number_of(any.z) - plane.distance;
        ASSERT_NEAR(number_of(plane_distance(read_plane(plane), any)), exact, std::ldexp(1, -10));
    }
}

}  // namespace
}  // namespace oblong::test::side_test
