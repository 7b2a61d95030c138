// Frames of parallel, off-centre and cut views of levels. The reference is a ray through the middle of a pixel, in
// doubles and from closed forms, against every face of the world.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "engine/frame/frame_record.h"
#include "engine/view/views.h"
#include "tests/frame/frame_fixture.h"
#include "tests/support/random.h"
#include "tests/support/views.h"

namespace oblong::test::view_frames_test {

namespace {

/// A face of the world, in doubles; normal . p = distance.
struct TrueFace {
    FaceIndex index;
    Point normal;
    double distance;
    std::vector<Point> corners;
};

std::vector<TrueFace> true_faces(const Level& level, const FaceTable& table) {
    std::vector<TrueFace> faces;
    for (const FaceIndex index : level.world().faces) {
        const Face& face = level.faces[index];
        const LevelPlane& plane = level.planes[face.plane];
        TrueFace& made = faces.emplace_back();
        made.index = index;
        made.normal = to_point(face.is_back ? -plane.normal : plane.normal);
        made.distance = number_of(plane.distance) * (face.is_back ? -1 : 1);
        for (const VertexIndex corner : table.corners_of(index))
            made.corners.push_back(to_point(level.vertices[corner]));
    }
    return faces;
}

struct Ray {
    Point from, along;
    double start;  ///< what is nearer is not shown
};

/// What a view should be: the axes of its plane, the way of the ray through its middle, and half its width: in units,
/// or at a depth of one.
struct TrueView {
    bool is_parallel = true;
    Point eye, right, up, middle;
    double half_width = 1;

    Ray through(double x_px, double y_px) const {
        const double x = (x_px - 160) / 160 * half_width, y = (100 - y_px) / 100 * 0.75 * half_width;
        const Point across = right * x + up * y;
        if (is_parallel) return {eye + across, middle, -std::numeric_limits<double>::infinity()};
        return {eye, middle + across, 0};
    }
};

bool is_kept(const ViewSpec& view, const Point& p) {
    for (const ViewCut& cut : view.cuts)
        if (dot(to_point(cut.normal), p) < number_of(cut.distance)) return false;
    return true;
}

bool contains(const TrueFace& face, const Point& p) {
    for (std::size_t i = 0; i < face.corners.size(); ++i) {
        const Point &a = face.corners[i], &b = face.corners[(i + 1) % face.corners.size()];
        if (dot(cross(b - a, p - a), face.normal) > 0) return false;  // clockwise
    }
    return true;
}

struct Hit {
    const TrueFace* face = nullptr;
    Point at{};

    bool operator==(const Hit& other) const { return face == other.face; }
};

Hit first_hit(const std::vector<TrueFace>& faces, const Ray& ray, const ViewSpec& view) {
    Hit hit;
    double nearest = std::numeric_limits<double>::infinity();
    for (const TrueFace& face : faces) {
        const double facing = dot(face.normal, ray.along);
        if (facing >= 0) continue;
        const double way = (face.distance - dot(face.normal, ray.from)) / facing;
        if (way <= ray.start || way >= nearest) continue;
        const Point at = ray.from + ray.along * way;
        if (!is_kept(view, at) || !contains(face, at)) continue;
        nearest = way;
        hit = {&face, at};
    }
    return hit;
}

struct Tally {
    int faces = 0, voids = 0, doubtful = 0, texels = 0;
    double texel_error = 0;
};

double texel(const Vec3<TexelAxis>& axis, Texel offset, const Point& p) {
    return dot(to_point(axis), p) + number_of(offset);
}

class ViewFrames {
  public:
    explicit ViewFrames(Stage& stage)
        : stage_(stage), work_(stage.level, stage.mode), faces_(true_faces(stage.level, work_.cache.faces)) {
        stage.models.clear();
        stage.settings.allowed_effects = EffectSet{}.with(Effect::Sky).with(Effect::Liquid);
    }

    void check(const ViewSpec& view, const TrueView& truth, int pixels, std::mt19937& random, Tally& tally) {
        ASSERT_FALSE(problem_of(view, stage_.mode)) << *problem_of(view, stage_.mode);
        draw(view);
        for (int i = 0; i < pixels; ++i) {
            const int column = random_below(random, 320), row = random_below(random, 200);
            const auto hit =
                at_all_rays(truth, column, row, 1 / 64.0, [&](const Ray& ray) { return first_hit(faces_, ray, view); });
            if (hit)
                compare(*hit, work_.record.pixels[static_cast<std::size_t>(row * 320 + column)], column, row, tally);
            else
                ++tally.doubtful;
        }
    }

  private:
    void draw(const ViewSpec& view) {
        work_.count();
        work_.keep_record();
        std::fill(stage_.pixels.begin(), stage_.pixels.end(), std::uint8_t{77});
        draw_frame(stage_.scene(), view, stage_.mode, stage_.settings, work_, {stage_.pixels.data(), 320, 200, 320});
        for (std::size_t i = 0; i < stage_.pixels.size(); ++i) {
            ASSERT_LE(work_.counts.writes[i], 1);
            if (view.is_parallel || !view.cuts.empty()) {
                ASSERT_TRUE(work_.counts.writes[i] == 1 || stage_.pixels[i] == 0);
            }
        }
    }

    void compare(const Hit& hit, const PixelRecord& pixel, int column, int row, Tally& tally) {
        if (!hit.face) {
            ++tally.voids;
            EXPECT_TRUE(pixel.face.is_none()) << column << ", " << row;
            return;
        }
        ++tally.faces;
        ASSERT_EQ(pixel.face, hit.face->index) << column << ", " << row;
        if (pixel.mip < 0) return;
        const TexInfo& info = stage_.level.texinfos[stage_.level.faces[pixel.face].texinfo];
        ++tally.texels;
        const double u = std::abs(number_of(pixel.u) - texel(info.s, info.s_offset, hit.at));
        const double v = std::abs(number_of(pixel.v) - texel(info.t, info.t_offset, hit.at));
        tally.texel_error = std::max({tally.texel_error, u, v});
    }

    Stage& stage_;
    ObservedWorkspace work_;
    std::vector<TrueFace> faces_;
};

struct ParallelCase {
    Basis axes;
    Point right, up, ahead;
    double shear_x = 0, shear_y = 0;  ///< the ray's way right and up for each unit ahead
};

const double kHalf = std::sqrt(0.5), kThird = std::sqrt(1 / 3.0), kSixth = std::sqrt(1 / 6.0);

std::vector<ParallelCase> parallel_cases() {
    return {{side_axes(ViewSide::Front), {1, 0, 0}, {0, 0, 1}, {0, 1, 0}},
            {side_axes(ViewSide::Top), {1, 0, 0}, {0, 1, 0}, {0, 0, -1}},
            {side_axes(ViewSide::Side), {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}},
            {axonometric_axes(Axonometry::Isometric),
             {kHalf, -kHalf, 0},
             {kSixth, kSixth, 2 * kSixth},
             {kThird, kThird, -kThird}},
            {side_axes(ViewSide::Front), {1, 0, 0}, {0, 0, 1}, {0, 1, 0}, -kHalf, -kHalf},
            {side_axes(ViewSide::Top), {1, 0, 0}, {0, 1, 0}, {0, 0, -1}, -0.25, 0.4}};
}

/// A parallel view of a case, its middle at a place, cut or not.
void check_parallel(ViewFrames& frames, const ParallelCase& which, const Vec3<World>& centre, int width, bool is_cut,
                    std::mt19937& random, Tally& tally) {
    ViewSpec view = orthographic_view(centre, which.axes, View::from_int(width));
    view.shear_x = fixed_of<Unit>(which.shear_x);
    view.shear_y = fixed_of<Unit>(which.shear_y);
    if (is_cut) cut_front(view, centre, World::from_raw(-37));
    const Point middle = which.ahead + which.right * which.shear_x + which.up * which.shear_y;
    frames.check(view, {true, to_point(centre), which.right, which.up, middle, width / 2.0}, 40, random, tally);
}

void check_parallel_views(Stage& stage, int places) {
    ViewFrames frames(stage);
    std::mt19937 random(9);
    Tally tally;
    for (int i = 0; i < places; ++i)
        for (const ParallelCase& which : parallel_cases()) {
            const int width = 24 << random() % 8;
            check_parallel(frames, which, random_open_point(stage.level, random), width, i % 2 == 1, random, tally);
            if (testing::Test::HasFatalFailure()) return;
        }
    EXPECT_GT(tally.faces, 10 * tally.doubtful);
    EXPECT_GT(tally.texels, 300);
    EXPECT_GT(tally.voids, 100);
    EXPECT_LT(tally.texel_error, 0.03);
}

Tally check_windows(Stage& stage, int places, bool is_cut) {
    ViewFrames frames(stage);
    std::mt19937 random(10);
    Tally tally;
    for (int i = 0; i < places && !testing::Test::HasFatalFailure(); ++i) {
        Camera camera;
        camera.eye = random_open_point(stage.level, random);
        camera.yaw = random_angle(random);
        camera.pitch = Angle::from_bam(random_below(random, 20000) - 10000);
        ViewSpec view = first_person_view(camera);
        view.shear_x = fixed_of<Unit>(random_between(random, -0.7, 0.7));
        view.shear_y = fixed_of<Unit>(random_between(random, -0.7, 0.7));
        if (is_cut) cut_front(view, camera.eye, World::from_int(32 << random() % 4));
        if (is_cut) cut_back(view, camera.eye, World::from_int(512));
        const Point right = to_point(view.axes.right), up = to_point(view.axes.up);
        const Point middle =
            to_point(view.axes.forward) + right * number_of(view.shear_x) + up * number_of(view.shear_y);
        frames.check(view, {false, to_point(camera.eye), right, up, middle, 1}, 40, random, tally);
    }
    return tally;
}

class ViewFramesOfLevels : public OfLevel {};
class ParallelFrames : public OfLevel {};

}  // namespace

TEST_P(ParallelFrames, ShowWhatRaysMeet) {
    Stage stage = stage_named(GetParam());
    check_parallel_views(stage, is_demo() ? 6 : 12);
}

OBLONG_FOR_ALL_LEVELS(ParallelFrames);

TEST_P(ViewFramesOfLevels, OffCentreOnesShowWhatRaysMeet) {
    Stage stage = real_stage(GetParam());
    const Tally tally = check_windows(stage, 60, false);
    EXPECT_GT(tally.faces, 1000);
    EXPECT_EQ(tally.voids, 0);
}

TEST_P(ViewFramesOfLevels, CutOnesShowWhatIsBetweenTheirPlanes) {
    Stage stage = real_stage(GetParam());
    const Tally tally = check_windows(stage, 60, true);
    EXPECT_GT(tally.faces, 500);
    EXPECT_GT(tally.voids, 100);
}

OBLONG_FOR_REAL_LEVELS(ViewFramesOfLevels);

}  // namespace oblong::test::view_frames_test
