// What seed 3 (the course notes) says of triangles on the screen, with the values as corrected.

#include <gtest/gtest.h>

#include <array>
#include <optional>

#include "engine/math/vec.h"
#include "engine/methods/triangles.h"
#include "engine/raster/scan.h"
#include "engine/raster/texture_blocks.h"
#include "tests/seeds/seed_values.h"

namespace oblong::test {
namespace {

/// The weights of a triangle's corners at a point, in sixteenths: signed areas over that of (0, 0), (4, 0), (0, 4).
std::array<std::int64_t, 3> weights_16(std::int32_t x, std::int32_t y) {
    const Vec3<Whole> a = whole(0, 0, 0), b = whole(4, 0, 0), c = whole(0, 4, 0), p = whole(x, y, 0);
    return {cross(b - p, c - p).z.raw, cross(c - p, a - p).z.raw, cross(a - p, b - p).z.raw};
}

TEST(SeedN4, WeightsAreSignedAreasAndAddUpTo1) {
    EXPECT_EQ(cross(whole(4, 0, 0), whole(0, 4, 0)).z.raw, 16);
    EXPECT_EQ(weights_16(1, 1), (std::array<std::int64_t, 3>{8, 4, 4}));
    const auto outside = weights_16(5, 5);
    EXPECT_EQ(outside, (std::array<std::int64_t, 3>{-24, 20, 20}));
    EXPECT_EQ(outside[0] + outside[1] + outside[2], 16);
    EXPECT_EQ(std::abs(outside[0]) + std::abs(outside[1]) + std::abs(outside[2]), 4 * 16) << "norms lose the sign";
}

/// An edge from z = 1 at column 64 to z = 3 at column 192 of row 96, the texture's 64 texels along it.
TextureGradients receding_edge() {
    constexpr ScreenMode kSquarePixels{256, 192, {4, 3}};
    const Projection projection = make_projection(kSquarePixels, Degrees::from_int(90));
    // In 1/256 of z: a half-pixel is 1.
    const auto corner = [](int x_256, int y_256, int z, std::int64_t u) {
        const auto at = [z](int per_256) { return Fixed<std::int32_t, 14>::from_raw(per_256 * z * 64); };
        return TexturedCorner{{at(x_256), at(y_256), at(256)}, Texel::from_int(u), {}};
    };
    const auto gradients = make_triangle_gradients(
        {corner(-127, -1, 1, 0), corner(129, -1, 3, 64), corner(0, -129, 2, 0)}, projection, {128, 96});
    return gradients.value();
}

double middle_of_edge(Texturing texturing) {
    const TextureGradients gradients = receding_edge();
    Accuracy accuracy;
    accuracy.texturing = texturing;
    const BlockRule rule = make_block_rule(accuracy);
    const auto thresholds = make_block_thresholds(rule, gradients.inverse_z.per_column);
    constexpr Span kEdge{96, 64, 193};
    BlockList blocks(kEdge.end - kEdge.first);
    block_cutter(accuracy)({&kEdge, 1}, 256, {gradients, make_texel_limits(64, 64, 512), thresholds}, blocks);
    std::int32_t column = kEdge.first;
    for (const TexelBlock& block : blocks.waiting()) {
        if (128 < column + block.count)
            return static_cast<double>(block.u_16 + std::int64_t{128 - column} * block.u_step_16) / 65536 / 64;
        column += block.count;
    }
    return -1;
}

TEST(SeedN5, MiddleOfAnEdgeFromZ1ToZ3ShowsAQuarterOfTheTexture) {
    const TexelPosition middle = texel_at(receding_edge(), make_texel_limits(64, 64, 0), 128, 96);
    EXPECT_NEAR(middle.u_16 / 65536.0 / 64, 1.0 / 4, 1e-3);
    EXPECT_NEAR(middle_of_edge(Texturing::Exact), 1.0 / 4, 1e-3);
    EXPECT_NEAR(middle_of_edge(Texturing::Affine), 1.0 / 2, 5e-3) << "the notes' weights on the screen";
}

std::vector<ScreenVertex> pixels_16(std::initializer_list<std::array<std::int32_t, 2>> corners) {
    std::vector<ScreenVertex> vertices;
    for (const auto& [x, y] : corners) vertices.push_back({Screen::from_raw(x * 16), Screen::from_raw(y * 16)});
    return vertices;
}

/// The columns of a row that a polygon covers.
std::optional<std::pair<std::int32_t, std::int32_t>> columns_of(const std::vector<ScreenVertex>& polygon,
                                                                std::int32_t row) {
    ScanlineExtents rows(16);
    scan_convex(polygon, rows);
    const auto at = static_cast<std::size_t>(row);
    if (row < rows.first || row >= rows.end || rows.left[at] >= rows.right[at]) return std::nullopt;
    return std::pair{rows.left[at], rows.right[at]};
}

using Columns = std::pair<std::int32_t, std::int32_t>;

TEST(SeedN11, TriangleOwnsBothItsLeftEdgesAndNotItsRightOne) {
    // Corners on the centres of pixels (8, 0), (8, 8), (0, 4): the edges meet every second row's centres.
    const auto triangle = pixels_16({{136, 8}, {136, 136}, {8, 72}});
    for (const std::int32_t off_middle : {0, 1, 2, 3}) {
        EXPECT_EQ(columns_of(triangle, 4 - off_middle), (Columns{2 * off_middle, 8}));
        EXPECT_EQ(columns_of(triangle, 4 + off_middle), (Columns{2 * off_middle, 8}));
    }
    EXPECT_FALSE(columns_of(triangle, 0)) << "its corner lies on the right edge too";
    EXPECT_FALSE(columns_of(triangle, 8));
}

TEST(SeedN11, TopEdgeIsOwnedAndBottomEdgeIsNot) {
    const auto pointing_down = pixels_16({{8, 40}, {136, 40}, {72, 104}}),
               pointing_up = pixels_16({{72, 40}, {136, 104}, {8, 104}});
    EXPECT_EQ(columns_of(pointing_down, 2), (Columns{0, 8}));
    EXPECT_EQ(columns_of(pointing_up, 5), (Columns{1, 7})) << "inside: on no edge but the left";
    EXPECT_FALSE(columns_of(pointing_up, 6)) << "the bottom edge";
}

TEST(SeedN12, SignIsPositiveForClockwiseTrianglesWithYDownAlone) {
    const auto clockwise = pixels_16({{0, 0}, {160, 0}, {0, 160}}), other_way = pixels_16({{0, 0}, {0, 160}, {160, 0}}),
               y_up = pixels_16({{0, 0}, {160, 0}, {0, -160}});
    EXPECT_EQ(doubled_area(clockwise).raw, 2560 * 2560);
    EXPECT_EQ(doubled_area(other_way).raw, -2560 * 2560);
    EXPECT_EQ(doubled_area(y_up).raw, -2560 * 2560);
}

TEST(SeedN13, FanOfAPentagonHasThreeTrianglesThatCoverItOnce) {
    const auto pentagon = pixels_16({{100, 5}, {230, 70}, {200, 210}, {60, 230}, {10, 90}});
    std::int64_t area = 0, triangle_count = 0;
    std::array<std::int32_t, 16> covered{};
    for (std::size_t i = 0; i + 2 < pentagon.size(); ++i, ++triangle_count) {
        const std::vector<ScreenVertex> triangle{pentagon[0], pentagon[i + 1], pentagon[i + 2]};
        EXPECT_GT(doubled_area(triangle).raw, 0);
        area += doubled_area(triangle).raw;
        for (std::int32_t row = 0; row < 16; ++row)
            if (const auto columns = columns_of(triangle, row))
                covered[static_cast<std::size_t>(row)] += columns->second - columns->first;
    }
    EXPECT_EQ(triangle_count, 3);
    EXPECT_EQ(area, doubled_area(pentagon).raw);
    for (std::int32_t row = 0; row < 16; ++row) {
        const auto whole_row = columns_of(pentagon, row).value_or(Columns{});
        EXPECT_EQ(covered[static_cast<std::size_t>(row)], whole_row.second - whole_row.first) << row;
    }
}

}  // namespace
}  // namespace oblong::test
