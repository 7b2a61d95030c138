#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "engine/files/files.h"
#include "engine/level/bsp_read.h"
#include "engine/level/pvs.h"
#include "engine/level/side.h"
#include "tests/map/brush_world.h"
#include "tests/map/bsp_checks.h"
#include "tests/map/map_source.h"
#include "tests/support/folders.h"

namespace oblong::test {
namespace {

// Lines of sight nearer to a brush than this are not judged.
constexpr double kMargin = 1.0 / 32;

Level as_engine_level(const std::string& bytes) {
    return read_bsp({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
}

// Pairs of points that see each other, found from the brushes alone; what of the level's sets denies it is counted.
struct Witness {
    int seen = 0, denied = 0;
};

class Sight {
  public:
    Sight(const std::string& map_text, const std::string& bsp_bytes)
        : brushes_(map_text), level_(as_engine_level(bsp_bytes)), visible_(visible_set_size(level_)) {}

    // Half of the pairs lie anywhere, half near each other's height: those see farther.
    Witness test(int pairs, unsigned seed) {
        std::mt19937 random(seed);
        Witness witness;
        for (int i = 0; i < pairs; ++i) {
            const Point from = random_point(random);
            Point to = random_point(random);
            if (i % 2 == 0) to.z = from.z + (to.z - from.z) / 16;
            const LeafIndex here = open_leaf(from), there = open_leaf(to);
            if (here == kSolidOutside || there == kSolidOutside || brushes_.is_blocked(from, to, kMargin)) continue;
            ++witness.seen;
            if (!sees(here, there) || !sees(there, here)) ++witness.denied;
        }
        return witness;
    }

  private:
    Point random_point(std::mt19937& random) const {
        const auto between = [&](double low, double high) {
            return low + (high - low) * static_cast<double>(random()) / 4294967296.0;
        };
        const map::Box& box = brushes_.box();
        return {between(box.mins.x, box.maxs.x), between(box.mins.y, box.maxs.y), between(box.mins.z, box.maxs.z)};
    }

    // The leaf at a point, 0 in brushes and outside of the level.
    LeafIndex open_leaf(const Point& point) const {
        const auto to_world = [](double units) {
            return World::from_raw(static_cast<std::int32_t>(std::lround(units * (1 << World::kFractionBits))));
        };
        const LeafIndex leaf =
            find_leaf(level_, level_.world(), {to_world(point.x), to_world(point.y), to_world(point.z)});
        const std::int32_t filling = level_.leaves[leaf].contents;
        return filling == contents::kSolid || filling == contents::kSky ? kSolidOutside : leaf;
    }

    bool sees(LeafIndex from, LeafIndex to) {
        unpack_visible_set(level_, from, visible_);
        return is_in_set(visible_, to);
    }

    BrushWorld brushes_;
    Level level_;
    std::vector<std::uint8_t> visible_;
};

// Three walls of a corridor along x, each with a slit 16 wide across all its height; slit i from y = slits[i] on.
std::string corridor_of_slits(const std::array<int, 3>& slits) {
    std::string walls = room({0, 0, 0}, {1024, 512, 128});
    for (int i = 0; i < 3; ++i) {
        const int x = 256 * (i + 1), y = slits[static_cast<std::size_t>(i)];
        walls += box({x - 8, 0, 0}, {x + 8, y, 128}) + box({x - 8, y + 16, 0}, {x + 8, 512, 128});
    }
    return walls;
}

// The slits are lines of 16 by 16 units: what passes the outer two passes y 248 to 264 in the middle.
TEST(Sight, ThreeSlitsLetThroughWhatPassesAllOfThem) {
    for (const auto& [middle_slit, is_seen] : {std::pair{248, true}, {216, false}, {280, false}, {32, false}}) {
        const auto bsp = compile(level(corridor_of_slits({32, middle_slit, 464})));
        const int west = leaf_at(bsp, {100, 40, 64}), east = leaf_at(bsp, {924, 472, 64});
        EXPECT_EQ(visible_leaves(bsp, west)[static_cast<std::size_t>(east)], is_seen) << middle_slit;
        EXPECT_EQ(visible_leaves(bsp, east)[static_cast<std::size_t>(west)], is_seen) << middle_slit;
    }
}

TEST(Sight, LinesThatMeetNoBrushAreInTheSets) {
    std::mt19937 random(5);
    const auto at = [&](int low, int high) {
        return low + static_cast<int>(random() % static_cast<unsigned>(high - low));
    };
    for (int i = 0; i < 8; ++i) {
        std::string brushes = room({-512, -512, 0}, {512, 512, 256});
        for (int k = 0; k < 4 + i; ++k) {
            const Whole low{at(-512, 400), at(-512, 400), at(0, 2) * 96};
            brushes += box(low, {low[0] + at(16, 400), low[1] + at(16, 400), low[2] + at(16, 160)});
            brushes += prism({at(-450, 450), at(-450, 450), 0}, at(24, 90), at(40, 256), at(3, 8));
        }
        const std::string text = level(brushes);
        const Witness witness = Sight(text, map::to_bytes(compile(text))).test(4000, static_cast<unsigned>(i));
        EXPECT_GT(witness.seen, 100) << i;
        EXPECT_EQ(witness.denied, 0) << "of " << witness.seen << " in scene " << i;
    }
}

TEST(Sight, LinesOfTheDemoLevelAreInTheSets) {
    Sight sight(read_text(test::source_folder() + "/assets/demo.map"),
                read_text(test::build_folder() + "/assets/demo.bsp"));
    const Witness witness = sight.test(400000, 9);
    EXPECT_GT(witness.seen, 5000);
    EXPECT_EQ(witness.denied, 0) << "of " << witness.seen;
}

}  // namespace
}  // namespace oblong::test
