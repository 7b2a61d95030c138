// Meshes among the faces of small levels: which is nearer against rays in doubles, and what hides, lights and colours
// them.

#include <cmath>
#include <numeric>
#include <random>

#include "engine/accuracy/accuracy.h"
#include "tests/effect_frames/effect_stage.h"
#include "tests/mesh/mesh_picture.h"
#include "tests/support/random.h"
#include "tools/gallery/mesh_scene.h"

namespace oblong::test::models_test {
namespace {

constexpr std::uint8_t kBall = 220;  // no texture's

const Mesh& sphere() {
    static const Mesh mesh = ball_mesh(40, 10, plain_skin(kBall));
    return mesh;
}

PlacedMesh ball_at(const Vec3<World>& position) {
    PlacedMesh placed;
    placed.mesh = &sphere();
    placed.position = position;
    placed.least_light = 256;  // all shades but one of effect_colours() are the same
    return placed;
}

/// A room with a pillar in the middle.
MapText pillared_room(const std::string& entities = "") {
    return room_with(box({-16, -16, 0}, {16, 16, 192}, "other"), entities);
}

Camera before_pillar() {
    return camera_at(point_at(-200, 3, 90), 0, 0);
}

/// How far along the view a ray meets the mesh where it stands; infinite if it does not.
double mesh_distance(const PlacedMesh& placed, const Point& eye, const Point& ray) {
    double nearest = INFINITY;
    const Point middle = to_point(placed.position) - eye, aside = cross(middle, ray);
    if (dot(aside, aside) > 41 * 41 * dot(ray, ray)) return INFINITY;
    for (const MeshTriangle& triangle : placed.mesh->triangles) {
        std::array<Point, 3> corners;
        for (std::size_t i = 0; i < 3; ++i) {
            const Vec3<World> p = placed.mesh->frames[0].vertices[triangle.vertices[i]].position + placed.position;
            corners[i] = to_point(p) - eye;
        }
        const auto& [a, b, c] = corners;
        const double whole = dot(a, cross(b, c));
        const double wa = dot(ray, cross(b, c)) / whole, wb = dot(ray, cross(c, a)) / whole,
                     wc = dot(ray, cross(a, b)) / whole;
        if (wa >= 0 && wb >= 0 && wc >= 0) nearest = std::min(nearest, 1 / (wa + wb + wc));
    }
    return nearest;
}

constexpr double kMargin = 0.02;  // of the rays through a pixel

/// How far along the view the face is that a pixel shows.
double face_distance(const EffectStage& stage, std::size_t pixel, const Point& eye, const Point& ray) {
    const Face* face = stage.face_at(pixel);
    if (!face) return INFINITY;
    const LevelPlane& plane = stage.level.planes[face->plane];
    const Point normal = to_point(plane.normal);
    return (number_of(plane.distance) - dot(normal, eye)) / dot(normal, ray);
}

TEST(Models, AreDrawnWhereTheyAreNearerThanFaces) {
    // Before the pillar, half in it, half behind it, partly in a side wall, and in the floor.
    for (const auto& place : {std::array{-60, 0, 90}, std::array{0, 20, 90}, std::array{60, 30, 80},
                              std::array{40, 230, 90}, std::array{-80, -60, 0}}) {
        const int x = place[0], y = place[1], z = place[2];
        EffectStage stage(pillared_room(), before_pillar());
        stage.meshes = {ball_at(point_at(x, y, z))};
        const Picture picture = stage.draw();
        const Picture bare = stage.draw_without(Effect::Meshes);
        const TrueCamera camera(stage.camera);
        std::int64_t ball = 0, covered = 0;
        for_each_pixel([&](std::int32_t column, std::int32_t row, std::size_t pixel) {
            const auto is_nearer = [&](const Point& ray) {
                return mesh_distance(stage.meshes[0], camera.eye, ray) < face_distance(stage, pixel, camera.eye, ray);
            };
            const std::optional<bool> nearer = at_all_rays(camera, column, row, kMargin, is_nearer);
            if (!nearer) return;
            ASSERT_EQ(picture[pixel], *nearer ? kBall : bare[pixel]) << x << ", " << y << ": " << column << ", " << row;
            ball += *nearer;
            covered +=
                !*nearer && mesh_distance(stage.meshes[0], camera.eye, camera.through_pixel(column, row)) < INFINITY;
        });
        EXPECT_GT(ball, 300) << x << ", " << y;
        if (x == 0 || x == 60) {
            EXPECT_GT(covered, 100) << x << ", " << y;
        }
    }
}

/// A wall across the room, sky above z = 90, from `south` on. From y = 100 it fills the view: the walk enters no leaf
/// behind it.
MapText walled_room(int south) {
    std::string things = entities_of("misc_sparks 180 100 100 size='40 40 90' count=60");
    for (const int x : {-180, 180})
        things += entity_at("misc_sprite", {x, 0, 110}, {{"texture", "{lamp"}, {"scale", "2"}});
    return room_with(box({-16, south, 0}, {16, 256, 90}, "other") + box({-16, south, 90}, {16, 256, 192}, "sky"),
                     things);
}

TEST(Models, BehindTheSkyAreDrawnInFrontOfItAlone) {
    EffectStage stage(walled_room(-200), camera_at(point_at(-100, 100, 90), 0));
    stage.settings.allowed_effects = EffectSet::all().without(Effect::Particles).without(Effect::Sprites);
    stage.work.keep_record();
    stage.meshes = {ball_at(point_at(160, 100, 90))};
    const Picture picture = stage.draw(), bare = stage.draw_without(Effect::Meshes);
    std::int64_t ball = 0, hidden = 0;
    const TrueCamera camera(stage.camera);
    for_each_pixel([&](std::int32_t column, std::int32_t row, std::size_t pixel) {
        const auto meets = [&](const Point& ray) { return mesh_distance(stage.meshes[0], camera.eye, ray) < INFINITY; };
        const std::optional<bool> is_met = at_all_rays(camera, column, row, kMargin, meets);
        if (!is_met) return;
        const bool shows = *is_met && stage.texture_at(pixel) == "sky";
        ASSERT_EQ(picture[pixel], shows ? kBall : bare[pixel]) << column << ", " << row;
        ball += shows;
        hidden += *is_met && !shows;
    });
    EXPECT_GT(ball, 300);
    EXPECT_GT(hidden, 300);
}

/// What is kept of models and things from frame to frame holds for another eye, and for models that moved.
TEST(Models, AreFoundAgainWhereverTheyAndTheEyeMove) {
    std::mt19937 random(1);
    for (const int south : {-200, -256}) {  // with a gap, and without: then neither room is in the other's visible set
        EffectStage stage(walled_room(south), before_pillar());
        const Mesh cube = cube_mesh(30, plain_skin(kBall));
        stage.meshes = {ball_at(point_at(100, 100, 90)), ball_at(point_at(-100, 100, 90))};
        const auto any_place = [&] {
            const int side = random_below(random, 2) == 0 ? -160 : 160;
            return point_at(side, random_below(random, 400) - 200, 60 + random_below(random, 60));
        };
        int seen = 0;
        for (int step = 0; step < 120; ++step) {
            PlacedMesh& moved = stage.meshes[as_size(step % 2)];
            switch (random_below(random, 5)) {
                case 0:
                    moved.position = any_place();
                    break;
                case 1:
                    moved.yaw = moved.yaw + Angle::from_bam(5'000);
                    break;
                case 2:
                    moved.mesh = moved.mesh == &cube ? &sphere() : &cube;
                    break;
                default:
                    stage.camera.eye = any_place();
                    stage.camera.yaw = Angle::from_bam(random_below(random, 65'536));
            }
            ASSERT_EQ(changed_pixels(stage.draw(), stage.draw_afresh()), 0) << south << ", step " << step;
            seen += stage.has(Effect::Meshes);
        }
        EXPECT_GT(seen, 20);
        EXPECT_LT(seen, 110);
    }
}

TEST(Models, BehindAWallAreNotOnThePlan) {
    EffectStage stage(pillared_room(), before_pillar());
    stage.meshes = {ball_at(point_at(60, 0, 90))};
    stage.meshes[0].scale = {Entry::from_raw(1 << 28), Entry::from_raw(1 << 28), Entry::from_raw(1 << 28)};
    const Picture picture = stage.draw();
    EXPECT_FALSE(stage.has(Effect::Meshes));
    EXPECT_FALSE(stage.has("models"));
    stage.meshes.clear();
    EXPECT_EQ(stage.draw(), picture);
    for (const Vec3<World>& place_of_ball : {point_at(-400, 0, 90), point_at(60, 0, 5000), point_at(0, 600, 90)}) {
        stage.meshes = {ball_at(place_of_ball)};
        EXPECT_EQ(stage.draw(), picture);
        EXPECT_FALSE(stage.has("models"));
    }
}

/// A carpet that goes from the eye, a colour for each unit of its length.
TEST(Models, HaveTexelsOutOfPlaceOnlyIfTexturingIsAffine) {
    constexpr int kLength = 200, kHalfWidth = 60, kHeight = 8;
    MeshBuilder builder;
    const auto corner = [&](int x, int y) { return builder.add(point_at(x, y, kHeight), 0.5, x); };
    const std::uint32_t a = corner(0, kHalfWidth), b = corner(kLength, kHalfWidth), c = corner(kLength, -kHalfWidth),
                        d = corner(0, -kHalfWidth);
    builder.triangle(a, b, c);
    builder.triangle(a, c, d);
    std::vector<std::uint8_t> colours(kLength);
    std::iota(colours.begin(), colours.end(), std::uint8_t{0});
    builder.mesh.skins = {{"", 1, kLength, std::move(colours)}};
    EffectStage stage(room_with(""), before_pillar());
    stage.meshes = {placed_at(builder.done())};
    const TrueCamera camera(stage.camera);
    for (const Texturing texturing : {Texturing::Affine, Texturing::Every16, Texturing::Bounded, Texturing::Exact}) {
        stage.settings.accuracy.texturing = texturing;
        const Picture picture = stage.draw();
        double largest = 0;
        std::int64_t pixels = 0;
        for_each_pixel([&](std::int32_t column, std::int32_t row, std::size_t pixel) {
            const Point ray = camera.through_pixel(column, row);
            const Point hit = camera.eye + ray * ((kHeight - camera.eye[2]) / ray[2]);
            if (ray[2] >= 0 || hit[0] < 5 || hit[0] > kLength - 5 || std::abs(hit[1]) > kHalfWidth - 2) return;
            largest = std::max(largest, std::abs(picture[pixel] + 0.5 - hit[0]));
            ++pixels;
        });
        EXPECT_GT(pixels, 1000);
        if (texturing == Texturing::Affine)
            EXPECT_GT(largest, 20);
        else
            EXPECT_LT(largest, 0.6);  // half a texel, and corners rounded to 1/256 pixel
    }
}

TEST(Models, NotAllowedAreNotDrawn) {
    EffectStage stage(pillared_room(), before_pillar());
    const Picture bare = stage.draw();
    stage.meshes = {ball_at(point_at(-60, 0, 90))};
    EXPECT_NE(stage.draw(), bare);
    EXPECT_TRUE(stage.has(Effect::Meshes));
    EXPECT_GT(stage.pixels(Effect::Meshes), 1000);
    EXPECT_EQ(stage.pixels(Effect::Meshes), stage.pixels("models"));
    EXPECT_EQ(stage.draw_without(Effect::Meshes), bare);
}

/// Water that is half seen through, up to z = 60, whose surface the ball breaks.
TEST(Models, StandOutOfTranslucentWater) {
    MapText text = room_with(box({-256, -256, 0}, {256, 256, 60}, "*water"));
    text.world_keys = {{"wateralpha", "0.5"}};
    EffectStage stage(text, camera_at(point_at(-200, 3, 120), 0, 0));
    stage.meshes = {ball_at(point_at(0, 0, 60))};
    const Picture picture = stage.draw(1'000);
    EXPECT_TRUE(stage.has(Effect::Translucency));
    const TrueCamera camera(stage.camera);
    std::int64_t above = 0, below = 0;
    for_each_pixel([&](std::int32_t column, std::int32_t row, std::size_t pixel) {
        const auto meets = [&](const Point& ray) { return mesh_distance(stage.meshes[0], camera.eye, ray) < INFINITY; };
        const auto is_before = [&](const Point& ray) {
            return mesh_distance(stage.meshes[0], camera.eye, ray) < (ray.z < 0 ? -60 / ray.z : INFINITY);
        };
        const auto is_met = at_all_rays(camera, column, row, kMargin, meets),
                   is_above = at_all_rays(camera, column, row, kMargin, is_before);
        if (!is_met || !*is_met || !is_above) return;
        const int colour = picture[pixel];
        if (*is_above) {
            ASSERT_EQ(colour, kBall) << column << ", " << row;
            ++above;
        } else {  // half of the ball's colour, half of the water's
            const int off =
                std::min(std::abs(colour - (kBall + kWater) / 2), std::abs(colour - (kBall + kWaterStripe) / 2));
            ASSERT_LT(off, 4) << column << ", " << row;
            ++below;
        }
    });
    EXPECT_GT(above, 1000);
    EXPECT_GT(below, 1000);
}

TEST(Models, ShowInTheHolesOfAFenceBeforeThem) {
    const MapText text = room_with("", entity("func_wall", {}, box({-4, -256, 0}, {4, 256, 192}, "{bars")));
    EffectStage stage(text, camera_at(point_at(-150, 3, 90), 0, 0));
    for (const int x : {-60, 60}) {
        stage.meshes = {ball_at(point_at(x, 0, 90))};
        const Picture open = stage.draw_without_models();
        const Picture bare = stage.draw_without(Effect::Meshes), picture = stage.draw();
        EXPECT_GT(count_of(open, kBall), 2'000);
        for (std::size_t i = 0; i < picture.size(); ++i) {
            const bool is_ball = open[i] == kBall && (x < 0 || bare[i] != kBars);
            ASSERT_EQ(picture[i], is_ball ? kBall : bare[i]);
        }
    }
}

/// As in a level that ended the program: no span of the fence is left.
TEST(Models, MayHideAllOfAFence) {
    const MapText text = room_with("", entity("func_wall", {}, box({0, -8, 82}, {2, 8, 98}, "{bars")));
    for (const Preset preset : kPresets) {
        EffectStage stage(text, camera_at(point_at(-150, 3, 90), 0, 0));
        stage.settings.accuracy = accuracy_of(preset);
        EXPECT_GT(count_of(stage.draw(), kBars), 0);
        stage.meshes = {ball_at(point_at(-60, 0, 90))};
        EXPECT_EQ(count_of(stage.draw(), kBars), 0);
    }
}

TEST(Models, AreLitByTheFloorBelowAndByWhatMoves) {
    const Mesh plain = ball_mesh(40, 10, plain_skin(8));
    const auto mean_shade = [&](const std::string& light, std::vector<MovingLight> moving) {
        MapText text = pillared_room(entity_at("light", {-60, 0, 150}, {{"light", light}}));
        EffectStage stage(text, before_pillar(), shades_as_colours());
        stage.meshes = {ball_at(point_at(-60, 0, 60))};
        stage.meshes[0].mesh = &plain;
        stage.meshes[0].least_light = 0;
        stage.moving_lights = std::move(moving);
        const Picture with = stage.draw(), without = stage.draw_without(Effect::Meshes);
        double sum = 0, count = 0;
        for (std::size_t i = 0; i < with.size(); ++i)
            if (with[i] != without[i]) sum += with[i], ++count;
        return sum / count;
    };
    const double dim = mean_shade("100", {}), bright = mean_shade("300", {});
    const double torch = mean_shade("100", {{point_at(-150, 0, 90), World::from_int(200), 256}});
    EXPECT_GT(dim, bright + 3);
    EXPECT_GT(dim, torch + 3);
}

/// A ball that is stretched to a pole of 160 units each way from z = 0, with a light beside its upper end.
TEST(Models, AreLitAtTheirFarEnds) {
    Mesh pole = ball_mesh(40, 10, plain_skin(8));
    for (MeshVertex& vertex : pole.frames[0].vertices) vertex.position.z = vertex.position.z * 4;
    set_boxes(pole.frames[0], pole.triangles);
    EffectStage stage({room({-256, -256, -192}, {256, 256, 192}, 16, "wall"),
                       entities_of("info_player_start -100 0 64 + light -60 0 150 light=30"),
                       {}},
                      camera_at(point_at(-200, 0, 0), 0, 0), shades_as_colours());
    stage.meshes = {ball_at(point_at(0, 0, 0))};
    stage.meshes[0].mesh = &pole;
    stage.meshes[0].least_light = 0;
    const Picture dark = stage.draw();
    stage.moving_lights = {{point_at(-40, 0, 150), World::from_int(60), 256}};
    const Picture lit = stage.draw();
    const auto shade_below_top = [](const Picture& picture) {
        return int{picture[std::size_t{15} * kPictureWidth + 160]};
    };
    EXPECT_GT(shade_below_top(dark), shade_below_top(lit) + 3);
}

/// A ball in a room without lightmaps, whose floor has full light: 5/8 of it comes from everywhere, 5/8 from one side.
TEST(Models, HaveFiveEighthsOfTheFloorsLightFromEverywhereAndAsMuchFromAbove) {
    constexpr double kRadius = 40;
    const Mesh plain = ball_mesh(kRadius, 40, plain_skin(8));
    EffectStage stage(room_with(""), camera_at(point_at(-200, 0, 90), 0), shades_as_colours());
    stage.meshes = {ball_at(point_at(0, 0, 90))};
    stage.meshes[0].mesh = &plain;
    stage.meshes[0].least_light = 0;
    const Picture picture = stage.draw();
    const TrueCamera camera(stage.camera);
    const Point middle = to_point(stage.meshes[0].position) - camera.eye,
                toward = Point{2, 1, 4} * (1 / std::sqrt(21.0));
    std::int64_t lit = 0, unlit = 0;
    for_each_pixel([&](std::int32_t column, std::int32_t row, std::size_t pixel) {
        const Point ray = camera.through_pixel(column, row);
        const double along = dot(ray, middle) / dot(ray, ray),
                     inside = kRadius * kRadius - dot(middle - ray * along, middle - ray * along);
        if (inside < 100) return;  // beside the ball, or on its rim
        const Point normal = (ray * (along - std::sqrt(inside / dot(ray, ray))) - middle) * (1 / kRadius);
        const double cosine = dot(normal, toward);
        ASSERT_NEAR(picture[pixel] + 0.5, exact_shade(kFullLight * 5.0 / 8 * (1 + std::max(cosine, 0.0))), 1);
        ++(cosine > 0.1 ? lit : unlit);
    });
    EXPECT_GT(lit, 200);
    EXPECT_GT(unlit, 200);
}

}  // namespace
}  // namespace oblong::test::models_test
