// Three ways to fill a triangle against the rule in exact integers, and weights against their definition.

#include "engine/methods/triangles.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <limits>

#include "tests/support/reference_polygons.h"

namespace oblong::test::triangles_test {
namespace {

constexpr std::array<TriangleMethod, 3> kMethods{TriangleMethod::FlatParts, TriangleMethod::EdgeWalking,
                                                 TriangleMethod::EdgeFunctions};
constexpr std::int32_t kWidth = 37, kHeight = 23;
constexpr ScreenRectangle kScreen{0, kWidth, 0, kHeight};

constexpr ScreenVertex vertex(std::int32_t x_256, std::int32_t y_256) {
    return {Screen::from_raw(x_256), Screen::from_raw(y_256)};
}

/// How often each pixel was covered.
using Picture = std::vector<int>;

Picture scanned(const ScreenTriangle& triangle, TriangleMethod method,
                EdgeRowKernel kernel = best_kernels().inside_edges, const ScreenRectangle& part = kScreen) {
    TriangleScanner scanner(method, part, kernel);
    std::vector<Span> spans;
    scanner.scan(triangle, spans);
    Picture picture(kWidth * kHeight);
    for (const Span& span : spans)
        for (std::int32_t x = span.first; x < span.end; ++x) ++picture.at(as_size(span.y * kWidth + x));
    return picture;
}

Picture exact(const ScreenTriangle& triangle) {
    reference::CoverageMap map{kWidth, kHeight, Picture(kWidth * kHeight)};
    const auto corner = [&](std::size_t i) { return reference::GridPoint{triangle[i].x.raw, triangle[i].y.raw}; };
    reference::add_triangle({corner(0), corner(1), corner(2)}, map);
    return map.counts;
}

/// On and around the screen, often on pixel centres, borders and each other's rows; or anywhere in range.
ScreenVertex any_vertex() {
    const auto coordinate = [] {
        return *rc::gen::oneOf(
            rc::gen::inRange<std::int32_t>(-10 * 256, 50 * 256),
            rc::gen::map(rc::gen::inRange<std::int32_t>(-4, 44), [](std::int32_t pixel) { return pixel * 128; }),
            rc::gen::map(rc::gen::inRange<std::int32_t>(-2, 30), [](std::int32_t pixel) { return pixel * 256 + 128; }),
            rc::gen::inRange<std::int32_t>(-5'000 * 256, 5'000 * 256),
            rc::gen::inRange<std::int32_t>(-kLargestScreen.raw, kLargestScreen.raw + 1));
    };
    return vertex(coordinate(), coordinate());
}

ScreenTriangle any_triangle() {
    ScreenTriangle triangle{any_vertex(), any_vertex(), any_vertex()};
    if (*rc::gen::inRange(0, 8) == 0) triangle[2].y = triangle[1].y;
    if (*rc::gen::inRange(0, 8) == 0) triangle[1].x = triangle[0].x;
    if (*rc::gen::inRange(0, 16) == 0) triangle[2] = triangle[0];
    return triangle;
}

RC_GTEST_PROP(Triangles, CoverWhatTheRuleSaysByEveryMethod, ()) {
    const ScreenTriangle triangle = any_triangle();
    const Picture expected = exact(triangle);
    for (const TriangleMethod method : kMethods) RC_ASSERT(scanned(triangle, method) == expected);
    RC_ASSERT(scanned(triangle, TriangleMethod::EdgeFunctions, inside_edges_plain) == expected);
}

RC_GTEST_PROP(Triangles, CoverTheSameInBandsOfRows, ()) {
    const ScreenTriangle triangle = any_triangle();
    const auto cut = *rc::gen::inRange<std::int32_t>(0, kHeight + 1),
               across = *rc::gen::inRange<std::int32_t>(0, kWidth + 1);
    const Picture whole = scanned(triangle, TriangleMethod::EdgeWalking);
    for (const TriangleMethod method : kMethods) {
        Picture sum(kWidth * kHeight);
        for (const ScreenRectangle& part :
             {ScreenRectangle{0, across, 0, cut}, {across, kWidth, 0, cut}, {0, kWidth, cut, kHeight}}) {
            const Picture of_part = scanned(triangle, method, best_kernels().inside_edges, part);
            std::transform(sum.begin(), sum.end(), of_part.begin(), sum.begin(), std::plus<>());
        }
        RC_ASSERT(sum == whole);
    }
}

RC_GTEST_PROP(Triangles, OfAnyCoordinatesAreThoseOfClampedOnes, ()) {
    const auto any = [] { return *rc::gen::arbitrary<std::int32_t>(); };
    const ScreenTriangle wild{vertex(any(), any()), vertex(any(), any()),
                              vertex(std::numeric_limits<std::int32_t>::min(), any())};
    ScreenTriangle tame = wild;
    for (ScreenVertex& v : tame)
        v = {std::clamp(v.x, -kLargestScreen, kLargestScreen), std::clamp(v.y, -kLargestScreen, kLargestScreen)};
    for (const TriangleMethod method : kMethods) RC_ASSERT(scanned(wild, method) == exact(tame));
    const BarycentricWeights weights = barycentric_weights(wild, wild[0]);
    RC_ASSERT(weights.a == weights.whole);
    quantity_over(wild, {CornerQuantity::highest(), CornerQuantity::lowest(), CornerQuantity::ulp()});
}

__extension__ using Wide = __int128;

RC_GTEST_PROP(BarycentricWeights, AddUpAndFindThePlaceAgain, ()) {
    const ScreenTriangle triangle = any_triangle();
    const ScreenVertex place = any_vertex();
    const BarycentricWeights w = barycentric_weights(triangle, place);
    RC_ASSERT(w.a + w.b + w.c == w.whole);
    const auto mixed = [&](auto coordinate) {
        return Wide{w.a.raw} * coordinate(triangle[0]) + Wide{w.b.raw} * coordinate(triangle[1]) +
               Wide{w.c.raw} * coordinate(triangle[2]);
    };
    RC_ASSERT(mixed([](ScreenVertex v) { return v.x.raw; }) == Wide{w.whole.raw} * place.x.raw);
    RC_ASSERT(mixed([](ScreenVertex v) { return v.y.raw; }) == Wide{w.whole.raw} * place.y.raw);
}

RC_GTEST_PROP(QuantityOver, IsTheCornersMixedByTheirWeights, ()) {
    const auto near = [] { return vertex(*rc::gen::inRange(0, 40 * 256), *rc::gen::inRange(0, 25 * 256)); };
    const ScreenTriangle triangle{near(), near(), near()};
    std::array<CornerQuantity, 3> values;
    for (CornerQuantity& value : values)
        value = CornerQuantity::from_raw(*rc::gen::inRange<std::int64_t>(0, std::int64_t{1} << 40));
    const auto number = [](auto fixed) { return static_cast<long double>(fixed.raw); };
    const LinearQuantity<CornerQuantity> quantity = quantity_over(triangle, values);
    const Picture picture = exact(triangle);
    for (std::int32_t y = 0; y < kHeight; ++y)
        for (std::int32_t x = 0; x < kWidth; ++x) {
            if (item(picture, y * kWidth + x) == 0) continue;
            const BarycentricWeights w = barycentric_weights(triangle, vertex(x * 256 + 128, y * 256 + 128));
            const long double expected =
                (number(w.a) * number(values[0]) + number(w.b) * number(values[1]) + number(w.c) * number(values[2])) /
                number(w.whole);
            RC_ASSERT(std::abs(number(quantity.at(x, y)) - expected) <= 1.5L * (1 + kWidth + kHeight) + 1);
        }
}

TEST(QuantityOver, OfATriangleWithoutAreaIsNothing) {
    const auto quantity =
        quantity_over({vertex(0, 0), vertex(256, 256), vertex(512, 512)}, {CornerQuantity::from_int(1), {}, {}});
    EXPECT_EQ(quantity.per_column, CornerQuantity{});
    EXPECT_EQ(quantity.at(5, 5), CornerQuantity{});
}

}  // namespace
}  // namespace oblong::test::triangles_test
