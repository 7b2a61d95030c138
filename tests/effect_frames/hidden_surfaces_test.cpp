// The methods of hidden-surface removal, held against each other on the same scenes: small random worlds, a door,
// glass.

#include "engine/frame/hidden_surfaces.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/level/side.h"
#include "tests/effect_frames/effect_stage.h"

namespace oblong::test {
namespace {

map::Point point_of(const Vec3<World>& p) {
    return {p.x.raw / 4096., p.y.raw / 4096., p.z.raw / 4096.};
}

/// A camera in doubles, independent of the engine's.
struct TrueView {
    map::Point eye, right, up, forward;
    double multiplier_x = 160, multiplier_y = 400 / 3.;  // 90 degrees across at 320x200 on 4:3

    explicit TrueView(const Camera& camera) {
        const auto radians = [](Angle angle) { return angle.bam * 2 * std::numbers::pi / 65536; };
        const double yaw = radians(camera.yaw), pitch = radians(camera.pitch);
        eye = point_of(camera.eye);
        forward = {std::cos(pitch) * std::cos(yaw), std::cos(pitch) * std::sin(yaw), -std::sin(pitch)};
        right = {std::sin(yaw), -std::cos(yaw), 0};
        up = map::cross(right, forward);
    }

    map::Point ray(double x, double y) const {
        return forward + map::scaled(right, (x - 160) / multiplier_x) + map::scaled(up, (100 - y) / multiplier_y);
    }
};

/// A face of a stage in doubles.
struct TrueFace {
    map::Point normal;
    double distance = 0;
    std::vector<map::Point> corners;

    TrueFace(const EffectStage& stage, const PixelRecord& record) {
        const Face& face = stage.level.faces[record.face];
        const map::Point offset =
            record.model.is_none() ? map::Point{} : point_of(stage.models[record.model.position()].offset);
        for (const SurfEdge step : stage.level.edges_of(face))
            corners.push_back(point_of(stage.level.vertices[stage.level.start_of(step)]) + offset);
        for (std::size_t i = 0; i < corners.size(); ++i)
            normal = normal + map::cross(corners[i] - corners[0], corners[(i + 1) % corners.size()] - corners[0]);
        distance = map::dot(normal, corners[0]);
    }
    double depth(const TrueView& view, double x, double y) const {
        return (distance - map::dot(normal, view.eye)) / map::dot(normal, view.ray(x, y));
    }
    /// How far a point of the screen is from the line of the nearest edge, pixels.
    double pixels_to_edge(const TrueView& view, double x, double y) const {
        double nearest = 1e9;
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const map::Point line = map::cross(corners[i] - view.eye, corners[(i + 1) % corners.size()] - view.eye);
            const double a = map::dot(line, view.right) / view.multiplier_x,
                         b = map::dot(line, view.up) / view.multiplier_y;
            nearest = std::min(nearest, std::abs(map::dot(line, view.ray(x, y))) / std::hypot(a, b));
        }
        return nearest;
    }
};

/// A corner on the screen is rounded by up to 1/512 pixel and computed within 1/2,048; clipped ones are rounded before.
constexpr double kSnap_px = 1. / 256;

/// Whether two faces are equally deep within kSnap_px of a point of the screen.
bool may_be_equally_deep(const TrueFace& a, const TrueFace& b, const TrueView& view, double x, double y) {
    double least = 1e9, most = -1e9;
    for (const double dx : {-kSnap_px, kSnap_px})
        for (const double dy : {-kSnap_px, kSnap_px}) {
            const double difference = 1 / a.depth(view, x + dx, y + dy) - 1 / b.depth(view, x + dx, y + dy);
            least = std::min(least, difference);
            most = std::max(most, difference);
        }
    return least <= 1e-12 && most >= -1e-12;
}

std::string random_brushes(std::mt19937& random, int count) {
    std::string brushes;
    for (int i = 0; i < count; ++i) {
        TurnedBox box;
        box.centre = {random_between(random, -200, 200), random_between(random, -200, 200),
                      random_between(random, 40, 216)};
        for (double& half : box.half) half = random_between(random, 4, 60);
        box.frame = random_frame(random);
        brushes += i % 3 == 0 ? prism({static_cast<int>(box.centre.x), static_cast<int>(box.centre.y), 0}, 20 + i,
                                      60 + 8 * i, 5 + i % 4)
                              : box.text();
    }
    return brushes;
}

/// A room with things in it at random; a part of them is a brush model.
MapText random_world(std::mt19937& random) {
    MapText text;
    text.brushes = room({-256, -256, 0}, {256, 256, 256}) + random_brushes(random, 9);
    text.entities = entity_at("info_player_start", {0, 0, 240}) + entity("func_wall", {}, random_brushes(random, 2)) +
                    entity("func_wall", {}, box({-40, 100, 0}, {40, 116, 96}, "other"));
    return text;
}

Camera random_camera(const Level& level, std::mt19937& random) {
    while (true) {
        const Vec3<World> eye = place(random_between(random, -240, 240), random_between(random, -240, 240),
                                      random_between(random, 16, 240));
        if (level.leaves[find_leaf(level, level.world(), eye)].contents == contents::kEmpty)
            return camera_at(eye, random_between(random, 0, 360), random_between(random, -40, 40));
    }
}

/// A picture and which face each of its pixels shows.
struct Drawn {
    Picture picture;
    std::vector<PixelRecord> records;
};
Drawn draw_by(HiddenSurfaces method, EffectStage& stage) {
    stage.settings.hidden_surfaces = method;
    Drawn drawn{stage.draw(), {}};
    drawn.records = stage.work.record->pixels;
    return drawn;
}
bool is_same(const PixelRecord& a, const PixelRecord& b) {
    return a.face == b.face && a.model == b.model;
}

class RandomWorlds : public testing::TestWithParam<unsigned> {
  protected:
    RandomWorlds() : random(GetParam()), stage(random_world(random), {}) {}

    /// Calls check(a, b, view, x, y) for each pixel at which a method shows another face than the span buffer.
    int for_each_difference(HiddenSurfaces method, auto check) {
        int differences = 0;
        for (int i = 0; i < 4; ++i) {
            stage.camera = random_camera(stage.level, random);
            const Drawn expected = draw_by(HiddenSurfaces::SpanBuffer, stage), found = draw_by(method, stage);
            const TrueView view(stage.camera);
            for (int pixel = 0; pixel < kPicturePixels; ++pixel) {
                const PixelRecord &a = at(expected.records, pixel), &b = at(found.records, pixel);
                if (is_same(a, b)) continue;
                ++differences;
                check(TrueFace(stage, a), TrueFace(stage, b), view, pixel % 320 + 0.5, pixel / 320 + 0.5);
            }
        }
        return differences;
    }

    std::mt19937 random;
    EffectStage stage;
};

TEST_P(RandomWorlds, ThePainterByTheTreeDrawsTheSamePictureAsTheSpanBuffer) {
    for (int i = 0; i < 4; ++i) {
        stage.camera = random_camera(stage.level, random);
        const Picture expected = draw_by(HiddenSurfaces::SpanBuffer, stage).picture;
        EXPECT_EQ(changed_pixels(expected, draw_by(HiddenSurfaces::Painter, stage).picture), 0) << i;
    }
}

TEST_P(RandomWorlds, TheZBufferDiffersOnlyWhereTwoFacesAreEquallyDeep) {
    const int differences = for_each_difference(
        HiddenSurfaces::ZBuffer, [](const TrueFace& a, const TrueFace& b, const TrueView& view, double x, double y) {
            EXPECT_TRUE(may_be_equally_deep(a, b, view, x, y)) << x << " " << y;
        });
    RecordProperty("differences", differences);
    EXPECT_LT(differences, 4 * kPicturePixels / 5000);
}

TEST_P(RandomWorlds, RaysDifferOnlyWithinTheRoundingOfAnEdge) {
    const int differences = for_each_difference(
        HiddenSurfaces::RayCasting, [](const TrueFace& a, const TrueFace& b, const TrueView& view, double x, double y) {
            const double away = std::min(a.pixels_to_edge(view, x, y), b.pixels_to_edge(view, x, y));
            EXPECT_TRUE(away < kSnap_px || may_be_equally_deep(a, b, view, x, y)) << x << " " << y << ": " << away;
        });
    RecordProperty("differences", differences);
    EXPECT_LT(differences, 4 * kPicturePixels / 1000);
}

INSTANTIATE_TEST_SUITE_P(Worlds, RandomWorlds, testing::Range(1u, 7u));

}  // namespace
}  // namespace oblong::test
