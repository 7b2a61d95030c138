// The four lines against exact rationals, and Gupta and Sproull's distances against doubles.

#include "engine/raster/lines.h"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "engine/raster/line_walks.h"
#include "tests/support/random.h"

namespace oblong::test {
namespace {

constexpr std::array<LineMethod, 4> kMethods{LineMethod::Naive, LineMethod::Dda, LineMethod::Bresenham,
                                             LineMethod::GuptaSproull};

/// Row k shows k + 100 whatever was behind: how much of each pixel was covered.
LineBlends level_blends() {
    LineBlends blends;
    for (std::size_t k = 0; k < blends.size(); ++k) blends[k].fill(static_cast<std::uint8_t>(k + 100));
    return blends;
}

/// A picture with a margin that must stay as it is.
class Picture {
  public:
    Picture(std::int32_t width, std::int32_t height) : width_(width), height_(height), pixels_(size(), kMargin) {
        for (std::int32_t y = 0; y < height; ++y)
            for (std::int32_t x = 0; x < width; ++x) canvas().row(y)[x] = 0;
    }
    Framebuffer canvas() { return {pixels_.data() + 3 * pitch() + 3, width_, height_, pitch()}; }
    std::uint8_t at(std::int32_t x, std::int32_t y) { return canvas().row(y)[x]; }
    bool operator==(const Picture&) const = default;

    bool margin_is_whole() {
        std::int64_t margin = 0, inside = 0;
        for (const std::uint8_t pixel : pixels_) margin += pixel == kMargin;
        for (std::int32_t y = 0; y < height_; ++y)
            for (std::int32_t x = 0; x < width_; ++x) inside += at(x, y) == kMargin;
        return inside == 0 && margin == static_cast<std::int64_t>(size()) - std::int64_t{width_} * height_;
    }
    std::int64_t set_pixels() {
        std::int64_t count = 0;
        for (std::int32_t y = 0; y < height_; ++y)
            for (std::int32_t x = 0; x < width_; ++x) count += at(x, y) != 0;
        return count;
    }

  private:
    static constexpr std::uint8_t kMargin = 255;
    std::int32_t pitch() const { return width_ + 7; }
    std::size_t size() const { return static_cast<std::size_t>(pitch()) * static_cast<std::size_t>(height_ + 6); }

    std::int32_t width_, height_;
    std::vector<std::uint8_t> pixels_;
};

Picture drawn(PixelPosition from, PixelPosition to, LineMethod method, std::int32_t width, std::int32_t height) {
    static const LineBlends kBlends = level_blends();
    Picture picture(width, height);
    draw_line(from, to, {method, 1, &kBlends}, picture.canvas());
    return picture;
}

__extension__ using Wide = __int128;

Wide floored(Wide numerator, Wide denominator) {
    const Wide quotient = numerator / denominator;
    return quotient - (numerator % denominator < 0);
}

/// By definition: for each pixel along the longer axis the nearest one on the other, a tie to the larger.
Picture exact_line(PixelPosition a, PixelPosition b, std::int32_t width, std::int32_t height) {
    Picture picture(width, height);
    Wide dx = Wide{b.column} - a.column, dy = Wide{b.row} - a.row;
    const bool is_steep = (dy < 0 ? -dy : dy) > (dx < 0 ? -dx : dx);
    if (is_steep ? dy < 0 : dx < 0) {
        std::swap(a, b);
        dx = -dx;
        dy = -dy;
    }
    for (std::int32_t i = 0; i < (is_steep ? height : width); ++i) {
        const std::int32_t start = is_steep ? a.row : a.column, end = is_steep ? b.row : b.column;
        if (i < start || i > end) continue;
        const Wide steps = is_steep ? dy : dx, rise = is_steep ? dx : dy, done = Wide{i} - start;
        const Wide climbed = steps == 0 ? 0 : floored(2 * done * rise + steps, 2 * steps);
        const Wide minor = climbed + (is_steep ? a.column : a.row);
        if (minor < 0 || minor >= (is_steep ? width : height)) continue;
        const auto j = static_cast<std::int32_t>(minor);
        picture.canvas().row(is_steep ? i : j)[is_steep ? j : i] = 1;
    }
    return picture;
}

/// Near the canvas, far from it, and at the ends of 32 bits.
PixelPosition any_position(std::mt19937& random) {
    const auto coordinate = [&random]() -> std::int32_t {
        const auto any = static_cast<std::int32_t>(random());
        switch (random() % 3) {
            case 0:
                return random_below(random, 80) - 20;
            case 1:
                return any;
            default:
                return any < 0 ? std::numeric_limits<std::int32_t>::min() : std::numeric_limits<std::int32_t>::max();
        }
    };
    const std::int32_t column = coordinate();
    return {column, coordinate()};
}

PixelPosition position_within(std::int32_t least, std::int32_t end, std::mt19937& random) {
    const std::int32_t column = least + random_below(random, end - least);
    return {column, least + random_below(random, end - least)};
}

TEST(Bresenham, SetsTheNearestPixelsOfEveryShortLine) {
    constexpr std::int32_t kSize = 9;
    for (std::int32_t i = 0; i < kSize * kSize * kSize * kSize; ++i) {
        const PixelPosition from{i % kSize, i / kSize % kSize},
            to{i / (kSize * kSize) % kSize, i / (kSize * kSize * kSize)};
        ASSERT_EQ(drawn(from, to, LineMethod::Bresenham, kSize, kSize), exact_line(from, to, kSize, kSize))
            << from.column << "," << from.row << " to " << to.column << "," << to.row;
    }
}

TEST(Lines, FromAnyPositionToAnyStayInTheCanvasAndAreTheSameFromEitherEnd) {
    std::mt19937 random(1);
    for (int i = 0; i < 1'000; ++i) {
        const PixelPosition from = any_position(random), to = any_position(random);
        for (const LineMethod method : kMethods) {
            Picture picture = drawn(from, to, method, 41, 23);
            ASSERT_TRUE(picture.margin_is_whole()) << i;
            ASSERT_TRUE(picture == drawn(to, from, method, 41, 23)) << i;
            ASSERT_TRUE(method != LineMethod::Bresenham || picture == exact_line(from, to, 41, 23)) << i;
        }
    }
}

TEST(Lines, ClippedAreTheirWholesInTheCanvas) {
    std::mt19937 random(4);
    for (int i = 0; i < 200; ++i) {
        constexpr std::int32_t kReach = 90, kSize = 31;
        const PixelPosition from = position_within(-kReach, kReach, random),
                            to = position_within(-kReach, kReach, random);
        const auto moved = [](PixelPosition p) { return PixelPosition{p.column + kReach, p.row + kReach}; };
        for (const LineMethod method : kMethods) {
            Picture part = drawn(from, to, method, kSize, kSize);
            Picture whole = drawn(moved(from), moved(to), method, 2 * kReach, 2 * kReach);
            for (std::int32_t y = 0; y < kSize; ++y)
                for (std::int32_t x = 0; x < kSize; ++x)
                    ASSERT_EQ(part.at(x, y), whole.at(x + kReach, y + kReach)) << i;
        }
    }
}

TEST(Lines, HaveAPixelAStep) {
    std::mt19937 random(5);
    for (int i = 0; i < 200; ++i) {
        constexpr std::int32_t kSize = 200;
        const PixelPosition from = position_within(0, kSize, random), to = position_within(0, kSize, random);
        const std::int32_t across = std::abs(to.column - from.column), down = std::abs(to.row - from.row);
        ASSERT_EQ(drawn(from, to, LineMethod::Dda, kSize, kSize).set_pixels(), std::max(across, down) + 1);
        ASSERT_EQ(drawn(from, to, LineMethod::Bresenham, kSize, kSize).set_pixels(), std::max(across, down) + 1);
        // Gaps where it is steep.
        ASSERT_EQ(drawn(from, to, LineMethod::Naive, kSize, kSize).set_pixels(), across + 1);
    }
}

TEST(Dda, IsOffByItsRoundedSlopeAtMost) {
    std::mt19937 random(6);
    for (int i = 0; i < 1'000; ++i) {
        const auto size = [&random] { return std::max<std::int64_t>(1, random() >> (1 + random() % 31)); };
        LinePath path;
        path.steps = size();
        path.minor_rise = size() % (path.steps + 1);
        const DdaWalk<std::int64_t> walk(path);
        const std::int64_t step = static_cast<std::int64_t>(random()) % (path.steps + 1);
        const double exact =
            static_cast<double>(step) * static_cast<double>(path.minor_rise) / static_cast<double>(path.steps);
        ASSERT_TRUE(std::abs(static_cast<double>(walk.minor_at(step)) - exact) <=
                    0.5 + std::ldexp(static_cast<double>(step), -17) + 1e-5)
            << i;
    }
}

template <class Walk>
void expect_steps_alike(const LinePath& path) {
    Walk stepped(path);
    for (std::int64_t step = 0; step <= path.steps; ++step, stepped.next()) {
        ASSERT_EQ(stepped.minor(), stepped.minor_at(step)) << step;
        Walk moved(path);
        moved.move_to(step);
        ASSERT_EQ(moved.minor(), stepped.minor()) << step;
    }
}

TEST(LineWalks, AreAtTheSamePlaceWhereverTheyStarted) {
    std::mt19937 random(7);
    for (int i = 0; i < 200; ++i) {
        const LinePath path =
            make_line_path(position_within(-50, 50, random), position_within(-50, 50, random), random() % 2 == 0);
        expect_steps_alike<NaiveWalk<std::int64_t>>(path);
        expect_steps_alike<DdaWalk<std::int64_t>>(path);
        if (std::abs(path.minor_rise) > path.steps) continue;
        expect_steps_alike<BresenhamWalk<std::int64_t>>(path);
        expect_steps_alike<GuptaSproullWalk<std::int64_t>>(path);
    }
}

double distance_from_line(PixelPosition from, PixelPosition to, std::int32_t x, std::int32_t y) {
    const double dx = to.column - from.column, dy = to.row - from.row;
    if (dx == 0 && dy == 0) return std::hypot(x - from.column, y - from.row);
    return std::abs(dx * (y - from.row) - dy * (x - from.column)) / std::hypot(dx, dy);
}

/// Bresenham's pixels and their neighbours along the minor axis have the level of their distance, others none.
TEST(GuptaSproull, CoversThreePixelsAStepByTheirDistance) {
    std::mt19937 random(8);
    for (int i = 0; i < 200; ++i) {
        constexpr std::int32_t kSize = 60;
        const PixelPosition from = position_within(1, kSize - 1, random), to = position_within(1, kSize - 1, random);
        Picture picture = drawn(from, to, LineMethod::GuptaSproull, kSize, kSize),
                nearest = exact_line(from, to, kSize, kSize);
        const bool is_steep = std::abs(to.row - from.row) > std::abs(to.column - from.column);
        for (std::int32_t y = 1; y < kSize - 1; ++y)
            for (std::int32_t x = 1; x < kSize - 1; ++x) {
                const bool is_beside = is_steep ? nearest.at(x - 1, y) || nearest.at(x + 1, y)
                                                : nearest.at(x, y - 1) || nearest.at(x, y + 1);
                const double distance = distance_from_line(from, to, x, y), sixteenths = 16 * distance;
                if (!nearest.at(x, y) && !is_beside) {
                    ASSERT_EQ(picture.at(x, y), 0) << i;
                    continue;
                }
                if (std::abs(sixteenths - std::floor(sixteenths) - 0.5) < 1e-4) continue;  // rounded either way
                const auto entry = static_cast<std::size_t>(std::min(std::lround(sixteenths), 24l));
                ASSERT_EQ(picture.at(x, y), 100 + kLineCoverage_256.at(entry) / 4) << i;
            }
    }
}

/// The volume of a cone of radius and volume 1 over a strip one pixel wide, whose middle is `distance` from its axis.
double cone_over_strip(double distance) {
    constexpr int kParts = 400;
    const double pi = std::acos(-1.0);
    double sum = 0;
    for (int i = 0; i < kParts; ++i)
        for (int j = 0; j < kParts; ++j) {
            const double x = distance - 0.5 + (i + 0.5) / kParts, y = -1 + (j + 0.5) * 2 / kParts;
            sum += std::max(0.0, 1 - std::hypot(x, y));
        }
    return sum * 2 / kParts / kParts * 3 / pi;
}

TEST(GuptaSproull, TableIsTheVolumeOfAConeOverTheLine) {
    for (std::size_t i = 0; i < kLineCoverage_256.size(); ++i)
        EXPECT_NEAR(kLineCoverage_256.at(i), 256 * cone_over_strip(static_cast<double>(i) / 16), 0.505) << i;
}

TEST(GuptaSproull, WithoutBlendsIsBresenham) {
    Picture picture(20, 20);
    draw_line({1, 2}, {18, 11}, {LineMethod::GuptaSproull, 1, nullptr}, picture.canvas());
    EXPECT_EQ(picture, drawn({1, 2}, {18, 11}, LineMethod::Bresenham, 20, 20));
}

}  // namespace
}  // namespace oblong::test
