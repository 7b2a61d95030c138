// The methods of hidden-surface removal, held against each other on the same scenes: small random worlds, a door,
// glass.

#include "engine/methods/hidden_surfaces.h"

#include "engine/frame/frame_record.h"
#include "engine/level/bsp_read.h"
#include "engine/level/side.h"
#include "engine/platform/worker_threads.h"
#include "tests/effect_frames/effect_stage.h"
#include "tests/support/folders.h"
#include "tools/render/camera_list.h"

namespace oblong::test {
namespace {

/// A face of a stage in doubles.
struct TrueFace {
    Point normal;
    double distance = 0;
    std::vector<Point> corners;

    TrueFace(const EffectStage& stage, const PixelRecord& record) {
        const Face& face = stage.level.faces[record.face];
        const Point offset = record.model.is_none() ? Point{} : to_point(stage.models[record.model.position()].offset);
        for (const SurfEdge step : stage.level.edges_of(face))
            corners.push_back(to_point(stage.level.vertices[stage.level.start_of(step)]) + offset);
        for (std::size_t i = 0; i < corners.size(); ++i)
            normal = normal + cross(corners[i] - corners[0], corners[(i + 1) % corners.size()] - corners[0]);
        distance = dot(normal, corners[0]);
    }
    double depth(const TrueCamera& view, double x, double y) const {
        return (distance - dot(normal, view.eye)) / dot(normal, view.through(x, y));
    }
    /// How far a point of the screen is from the line of the nearest edge, pixels.
    double pixels_to_edge(const TrueCamera& view, double x, double y) const {
        double nearest = 1e9;
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const Point line = cross(corners[i] - view.eye, corners[(i + 1) % corners.size()] - view.eye);
            const double a = dot(line, view.right) / view.kAcross, b = dot(line, view.up) / view.kDown;
            nearest = std::min(nearest, std::abs(dot(line, view.through(x, y))) / std::hypot(a, b));
        }
        return nearest;
    }
};

/// A corner on the screen is rounded by up to 1/512 pixel and computed within 1/2,048; clipped ones are rounded before.
constexpr double kSnap_px = 1. / 256;

/// Whether two faces are equally deep within kSnap_px of a point of the screen.
bool may_be_equally_deep(const TrueFace& a, const TrueFace& b, const TrueCamera& view, double x, double y) {
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
        const Vec3<World> eye = point_at(random_between(random, -240, 240), random_between(random, -240, 240),
                                         random_between(random, 16, 240));
        if (level.leaves[find_leaf(level, level.world(), eye)].contents == contents::kEmpty)
            return camera_at(eye, random_between(random, 0, 360), random_between(random, -40, 40));
    }
}

/// A picture, which face each of its pixels shows, and what that took.
struct Drawn {
    Picture picture;
    std::vector<PixelRecord> records;
    HiddenSurfaceCounts counts;
};
Drawn draw_by(HiddenSurfaces method, EffectStage& stage) {
    HiddenSurfaceMethod by(method);
    stage.work.claimer = &by;
    Drawn drawn{stage.draw(), {}, by.counts()};
    stage.work.claimer = nullptr;
    drawn.records = stage.work.record.pixels;
    return drawn;
}
bool is_same(const PixelRecord& a, const PixelRecord& b) {
    return a.face == b.face && a.model == b.model;
}

/// A pixel at which a method shows another face than the span buffer.
struct Difference {
    TrueFace expected, found;
    TrueCamera view;
    double x, y;

    bool is_tie() const { return may_be_equally_deep(expected, found, view, x, y); }
    double pixels_to_edge() const {
        return std::min(expected.pixels_to_edge(view, x, y), found.pixels_to_edge(view, x, y));
    }
};

std::vector<Difference> differences_of(HiddenSurfaces method, const Camera& camera, EffectStage& stage) {
    stage.camera = camera;
    const Drawn expected = draw_by(HiddenSurfaces::SpanBuffer, stage), found = draw_by(method, stage);
    std::vector<Difference> differences;
    for (int pixel = 0; pixel < kPicturePixels; ++pixel) {
        const PixelRecord &a = item(expected.records, pixel), &b = item(found.records, pixel);
        if (is_same(a, b)) continue;
        differences.push_back({TrueFace(stage, a), TrueFace(stage, b), TrueCamera(camera), pixel % kPictureWidth + 0.5,
                               pixel / kPictureWidth + 0.5});
    }
    return differences;
}

/// Runs of pixels beside or below each other: an edge along a row or a column within rounding differs all along.
std::size_t runs_of(const std::vector<Difference>& differences) {
    const auto differs_at = [&](double x, double y) {
        return std::any_of(differences.begin(), differences.end(),
                           [&](const Difference& each) { return each.x == x && each.y == y; });
    };
    return static_cast<std::size_t>(std::count_if(differences.begin(), differences.end(), [&](const Difference& each) {
        return !differs_at(each.x - 1, each.y) && !differs_at(each.x, each.y - 1);
    }));
}

/// The demo level: sky, liquids, doors, mirrors, and faces that are seen through.
struct DemoStage {
    const std::filesystem::path assets = std::filesystem::path(build_folder()) / "assets";
    EffectStage stage{read_bsp(read_file_bytes(assets / "demo.bsp")), {}};

    std::vector<Camera> cameras(std::size_t every) const {
        const auto list = read_file_bytes(std::filesystem::path(source_folder()) / "assets" / "demo_cameras.csv");
        const std::vector<Camera> all = parse_cameras(list, Degrees::from_int(90));
        std::vector<Camera> chosen;
        for (std::size_t i = 0; i < all.size(); i += every) chosen.push_back(all[i]);
        return chosen;
    }
};

/// Of the demo level, 0, and random worlds.
class HiddenSurfacesOf : public testing::TestWithParam<unsigned> {
  protected:
    void for_each_camera(std::size_t every_of_demo, auto check) {
        if (GetParam() == 0) {
            DemoStage demo;
            for (const Camera& camera : demo.cameras(every_of_demo)) check(camera, demo.stage);
            return;
        }
        std::mt19937 random(GetParam());
        EffectStage stage(random_world(random), {});
        for (int i = 0; i < 4; ++i) check(random_camera(stage.level, random), stage);
    }
};

TEST_P(HiddenSurfacesOf, ThePainterByTheTreeDrawsTheSamePictureAsTheSpanBuffer) {
    for_each_camera(1, [](const Camera& camera, EffectStage& stage) {
        stage.camera = camera;
        const Picture expected = draw_by(HiddenSurfaces::SpanBuffer, stage).picture;
        EXPECT_EQ(changed_pixels(expected, draw_by(HiddenSurfaces::Painter, stage).picture), 0);
    });
}

TEST_P(HiddenSurfacesOf, TheZBufferDiffersOnlyWhereTwoFacesAreEquallyDeep) {
    for_each_camera(1, [](const Camera& camera, EffectStage& stage) {
        const std::vector<Difference> differences = differences_of(HiddenSurfaces::ZBuffer, camera, stage);
        EXPECT_LE(differences.size(), 4u);
        for (const Difference& each : differences) EXPECT_TRUE(each.is_tie()) << each.x << " " << each.y;
    });
}

TEST_P(HiddenSurfacesOf, RaysDifferOnlyWithinTheRoundingOfAnEdge) {
    const std::size_t most_runs = GetParam() == 0 ? 20 : 8;
    for_each_camera(13, [&](const Camera& camera, EffectStage& stage) {
        const std::vector<Difference> differences = differences_of(HiddenSurfaces::RayCasting, camera, stage);
        EXPECT_LE(runs_of(differences), most_runs);
        for (const Difference& each : differences)
            EXPECT_TRUE(each.pixels_to_edge() < kSnap_px || each.is_tie())
                << each.x << " " << each.y << ": " << each.pixels_to_edge();
    });
}

INSTANTIATE_TEST_SUITE_P(Worlds, HiddenSurfacesOf, testing::Range(0u, 6u));

class DemoFrames : public testing::Test, protected DemoStage {};

TEST_F(DemoFrames, ThePainterSortedByOneDepthAFaceIsWrong) {
    stage.camera = cameras(1)[18];  // down the hall over lava
    const Picture right = draw_by(HiddenSurfaces::SpanBuffer, stage).picture;
    for (const HiddenSurfaces method : {HiddenSurfaces::PainterSorted, HiddenSurfaces::PainterMean}) {
        const Drawn sorted = draw_by(method, stage);
        EXPECT_GT(changed_pixels(right, sorted.picture), 1000);
        EXPECT_GT(sorted.counts.order_comparisons, 0);
    }
}

TEST_F(DemoFrames, OfSeveralThreadsAreThoseOfOne) {
    WorkerThreads workers(3);
    FrameWorkspace shared(stage.level, {}, &workers);
    for (const HiddenSurfaces method : {HiddenSurfaces::ZBuffer, HiddenSurfaces::Painter}) {
        HiddenSurfaceMethod by(method);
        shared.claimer = &by;
        for (const Camera& camera : cameras(9)) {
            stage.camera = camera;
            EXPECT_EQ(stage.draw_in(shared, 0), draw_by(method, stage).picture);
        }
    }
}

}  // namespace
}  // namespace oblong::test
