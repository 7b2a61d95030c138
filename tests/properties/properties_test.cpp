#include <gtest/gtest.h>

#include "engine/methods/polygons.h"
#include "tests/frame/frame_fixture.h"
#include "tests/properties/any_view.h"

namespace oblong::test {
namespace {

// Projection never turns the order of points round.

__extension__ using Int128 = __int128;

/// Of a field of view that leaves what is on the screen within 64 z of the middle, as project_axis() says.
Projection any_lens() {
    return any_projection(1, 179);
}

/// From next to the eye to the far end of the world, evenly over its powers of two.
std::int64_t any_depth_16() {
    return *rc::gen::inRange<std::int64_t>(4, 8) << *rc::gen::inRange(0, 29);
}

/// Between -limit and limit.
std::int64_t within(std::int64_t limit) {
    return *rc::gen::inRange<std::int64_t>(-limit, limit + 1);
}

ScreenPosition shown(const Projection& projection, std::int64_t x_16, std::int64_t y_16, std::int64_t z_16) {
    return project({View::from_raw(x_16), View::from_raw(y_16), View::from_raw(z_16)}, projection);
}

RC_GTEST_PROP(PropertyProjection, FartherToTheRightIsNeverFartherLeftAndHigherNeverLower, ()) {
    const Projection projection = any_lens();
    const std::int64_t z_16 = any_depth_16();
    // Pairs that lie together as often as pairs anywhere in view.
    const std::int64_t low = within(63 * z_16), step = *rc::gen::element<std::int64_t>(1, 16, z_16 / 256, z_16);
    const auto before = shown(projection, low, low, z_16), after = shown(projection, low + step, low + step, z_16);
    RC_ASSERT(before.x <= after.x);
    RC_ASSERT(before.y >= after.y);
}

RC_GTEST_PROP(PropertyProjection, FartherAwayIsNeverFartherFromTheCentre, ()) {
    const Projection projection = any_lens();
    const std::int64_t z_16 = any_depth_16();
    const std::int64_t farther_16 = z_16 + *rc::gen::element<std::int64_t>(1, 16, z_16 / 256, z_16);
    const std::int64_t x_16 = std::abs(within(64 * z_16)), y_16 = std::abs(within(64 * z_16));
    const auto near = shown(projection, x_16, y_16, z_16), far = shown(projection, x_16, y_16, farther_16);
    RC_ASSERT(near.x >= far.x && far.x >= projection.x.centre);
    RC_ASSERT(near.y <= far.y && far.y <= projection.y.centre);
    const auto near_left = shown(projection, -x_16, -y_16, z_16),
               far_left = shown(projection, -x_16, -y_16, farther_16);
    RC_ASSERT(near_left.x <= far_left.x && far_left.x <= projection.x.centre);
    RC_ASSERT(near_left.y >= far_left.y && far_left.y >= projection.y.centre);
}

/// Points that lie close to `view_16`, in their order from left to right, and the same on the other side of the middle.
void expect_order_around(const Projection& projection, std::int64_t view_16, std::int64_t z_16) {
    std::int64_t at_16 = view_16 - 80;
    for (int step = 0; step < 80; ++step) {
        const std::int64_t next_16 = at_16 + *rc::gen::inRange<std::int64_t>(0, 5);
        RC_ASSERT(shown(projection, at_16, 0, z_16).x <= shown(projection, next_16, 0, z_16).x);
        RC_ASSERT(shown(projection, -at_16, 0, z_16).x >= shown(projection, -next_16, 0, z_16).x);
        RC_ASSERT(shown(projection, 0, at_16, z_16).y >= shown(projection, 0, next_16, z_16).y);
        RC_ASSERT(shown(projection, 0, -at_16, z_16).y <= shown(projection, 0, -next_16, z_16).y);
        at_16 = next_16;
    }
}

RC_GTEST_PROP(PropertyProjection, ItNeverStepsBackWhereItsMultiplierBecomesExact, ()) {
    const Projection projection = any_lens();
    const std::int64_t z_16 = any_depth_16();
    expect_order_around(projection, 64 * z_16, z_16);
}

RC_GTEST_PROP(PropertyProjection, ItDoesNotStepBackThoughItsMultiplierWasRoundedUpAsFarAsCanBe, ()) {
    // What is at 64 z then lies on a half of 1/256 pixel by the rounded multiplier, and before it by the exact one.
    Projection projection = any_lens();
    const std::int64_t coarse_16 = 4 * *rc::gen::inRange<std::int64_t>(1, 1 << 25) + 2;
    projection.x.coarse = projection.y.coarse = CoarseMultiplier::from_raw(coarse_16);
    projection.x.multiplier = projection.y.multiplier = Multiplier::from_raw(coarse_16 * 65536 - 32768);
    projection.x.fast_limit = projection.y.fast_limit = View::from_raw((std::int64_t{1} << 61) / (coarse_16 + 1));
    const std::int64_t z_16 = any_depth_16();
    expect_order_around(projection, 64 * z_16, z_16);
}

RC_GTEST_PROP(PropertyProjection, ItNeverStepsBackWhereItsProductBecomesWide, ()) {
    const Projection projection = any_lens();
    const std::int64_t z_16 = any_depth_16();
    for (const ProjectionAxis& axis : {projection.x, projection.y})
        expect_order_around(projection, axis.fast_limit.raw, std::max(z_16, axis.fast_limit.raw / 64));
}

RC_GTEST_PROP(PropertyProjection, BeyondTheChangeItIsWithinItsBound, ()) {
    const Projection projection = any_lens();
    const std::int64_t z_16 = any_depth_16();
    const std::int64_t x_16 = z_16 * *rc::gen::inRange<std::int64_t>(60, 70) + within(z_16);
    // |256 (x - centre) z 2^24 - multiplier x 2^32| in units of 2^-32 pixel times z: half of 1/256 pixel, and 64 2^-17.
    const auto offset_8 = static_cast<Int128>(shown(projection, x_16, 0, z_16).x.raw - projection.x.centre.raw);
    const Int128 error_32 = offset_8 * z_16 * (1 << 24) - static_cast<Int128>(projection.x.multiplier.raw) * x_16;
    const Int128 bound_32 =
        static_cast<Int128>(z_16) * ((1 << 23) + (std::int64_t{64} << 15) + (std::int64_t{8} << 15));
    RC_ASSERT(error_32 <= bound_32 && error_32 >= -bound_32);
}

// Closed surfaces clipped to the four sides of random views. One plane at a time: HardCaseC1 to HardCaseC3.

using ViewPoint = Vec3<View>;

/// As a frame clips: to the sides that the polygon's own corners are outside of.
std::vector<ClipVertex> clipped_as_in_a_frame(const Frustum& frustum, const std::vector<ViewPoint>& corners) {
    ClipScratch scratch;
    unsigned any_outside = 0, all_outside = 0xff;
    for (const ViewPoint& corner : corners) {
        const std::uint8_t outcode = outcode_of(frustum, corner);
        any_outside |= outcode;
        all_outside &= outcode;
        scratch.polygon.push_back({corner, 0, outcode, 0});
    }
    if (all_outside != 0) return {};
    if (any_outside != 0) clip_polygon(frustum, any_outside, scratch);
    return scratch.polygon;
}

/// An edge of a clipped polygon: where it begins and ends, and the borders that both ends are on.
using ClippedEdge = std::array<ViewPoint, 2>;

bool has_edge(const std::vector<ClipVertex>& polygon, const ClippedEdge& edge) {
    for (std::size_t i = 0; i < polygon.size(); ++i)
        if (polygon[i].position == edge[0] && polygon[(i + 1) % polygon.size()].position == edge[1]) return true;
    return false;
}

/// The edges within the view: those that clipping did not lay on a border.
std::vector<ClippedEdge> inner_edges(const std::vector<ClipVertex>& polygon) {
    std::vector<ClippedEdge> edges;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const ClipVertex &from = polygon[i], &to = polygon[(i + 1) % polygon.size()];
        if ((from.borders & to.borders) == 0 && from.position != to.position)
            edges.push_back({from.position, to.position});
    }
    return edges;
}

/// A tetrahedron is closed: clipped face by face, near the eye where positions are coarse, each edge in view is still
/// walked once forth and once back, bit for bit.
RC_GTEST_PROP(PropertyClip, ClosedSurfacesStayClosedWithinTheView, ()) {
    const Frustum frustum = frustum_of(any_projection(10, 170));  // any that the engine takes
    const std::int64_t size_16 = *rc::gen::element<std::int64_t>(3, 8, 40, 900, 65'536, 20'000'000);
    const auto any_corner = [&] {
        const auto along = [&] { return View::from_raw(*rc::gen::inRange(-size_16, size_16 + 1)); };
        return ViewPoint{along(), along(), along()};
    };
    const ViewPoint a = any_corner(), b = any_corner(), c = any_corner(), d = any_corner();
    std::vector<std::vector<ClipVertex>> faces;
    for (const std::vector<ViewPoint>& corners : {std::vector{a, b, c}, {a, c, d}, {a, d, b}, {b, d, c}})
        faces.push_back(clipped_as_in_a_frame(frustum, corners));
    for (const auto& face : faces)
        for (const ClippedEdge& edge : inner_edges(face)) {
            const auto is_its_back = [&](const auto& other) { return has_edge(other, {edge[1], edge[0]}); };
            RC_ASSERT(std::any_of(faces.begin(), faces.end(), is_its_back));
        }
}

// Textures repeat: what is shifted by whole textures has the same bytes. Spans far from the texture's origin:
// HardCaseX5; below zero: HardCaseX6.

/// The level with each texture moved along its faces by its own number of whole textures.
Level shifted_by_whole_textures(Level level) {
    Table<std::array<std::int32_t, 2>, TexInfo> shifts;
    for (TexInfo& texinfo : level.texinfos) {
        const MipTexture& texture = level.textures[texinfo.texture];
        const std::int32_t by_u = *rc::gen::inRange(-20, 21) * texture.width,
                           by_v = *rc::gen::inRange(-20, 21) * texture.height;
        texinfo.s_offset += Texel::from_int(by_u);
        texinfo.t_offset += Texel::from_int(by_v);
        shifts.push_back({by_u, by_v});
    }
    for (Face& face : level.faces) {
        const auto& [by_u, by_v] = shifts[face.texinfo];
        face.texel_min_u += by_u;
        face.texel_min_v += by_v;
    }
    return level;
}

std::vector<std::uint8_t> picture_of(Stage& stage, const Camera& camera) {
    FrameWorkspace work(stage.level, stage.mode);
    stage.draw(camera, work);
    return stage.pixels;
}

TEST(PropertyTexture, FramesOfTheDemoLevelAreTheSameWithTexturesShiftedByWholeTextures) {
    Stage stage = demo_stage();
    Stage shifted = demo_stage();
    const std::vector<Vec3<World>> places = entity_origins(stage.level);
    ASSERT_FALSE(places.empty());
    EXPECT_TRUE(rc::check([&] {
        shifted.level = shifted_by_whole_textures(stage.level);
        Camera camera;
        camera.eye = *rc::gen::elementOf(places);
        camera.yaw = Angle::from_bam(*rc::gen::arbitrary<std::uint16_t>());
        camera.pitch = Angle::from_bam(*rc::gen::inRange(-8'000, 8'000));
        RC_ASSERT(picture_of(shifted, camera) == picture_of(stage, camera));
    }));
}

}  // namespace
}  // namespace oblong::test
