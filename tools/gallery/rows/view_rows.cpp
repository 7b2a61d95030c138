// Seeds 2, 3 and 4: cameras, windows, zoom and planes that cut.

#include "engine/frame/frame_record.h"
#include "engine/methods/transforms.h"
#include "tools/gallery/sketch.h"

namespace oblong {

namespace {

/// The views that the lab's text compares: its own, half the window, and a COP ten times as far.
struct LabView {
    const char* name;
    double distance, size;  ///< of the COP before the plane; of the window
};
constexpr std::array<LabView, 3> kLabViews{
    {{"COP 2, window 1", 2, 1}, {"COP 2, window 1/2", 2, 0.5}, {"COP 20, window 1", 20, 1}}};

/// The lab's table of its cube as listed, with the corners in Cube's order: the far face is wrong.
constexpr std::array<Vec, 8> kListedCorners{
    {{150, 150}, {50, 150}, {150, 50}, {50, 50}, {175, 175}, {75, 175}, {175, 75}, {75, 75}}};

std::string pixel_text(const Vec& pixel, const char* format) {
    return decimals_text({pixel.x, pixel.y}, format);
}

/// The lab's table on both sides of its cube: as computed, and as listed.
void write_table(const std::array<Vec, 8>& found, Canvas& canvas) {
    const std::int32_t right = canvas.width_px - 10 * kGlyphAdvance_px - kTextMargin_px;
    std::int32_t y = kHeader_px + 5;
    canvas.write(kTextMargin_px, y, "computed");
    canvas.write(right, y, "the seed's");
    for (std::size_t i = 0; i < found.size(); ++i) {
        const std::string name{i & 1 ? '1' : '0', i & 2 ? '1' : '0', i & 4 ? '1' : '0'},
            listed = pixel_text(kListedCorners[i], "%3.0f"), computed = pixel_text(found[i], "%3.0f");
        y += kLineHeight_px;
        canvas.write(kTextMargin_px, y, name + " " + computed);
        canvas.write(right, y, listed, listed == computed ? kBright : kRed);
    }
}

/// The ratio of the cube's near face to its far face, in the lab's 200x200 pixels.
double near_over_far(const LabView& lab) {
    const ViewContext view = make_view_context(window_view(lab_window(lab.distance, lab.size)), {200, 200, {1, 1}});
    return across({0, 0, 0}, {1, 0, 0}, view) / across({0, 0, 1}, {1, 0, 1}, view);
}

Figures draw_lab_cube(const RowInput& input, Canvas& canvas) {
    const LabView& shows = item(kLabViews, input.values[0]);
    // The window's sides are world coordinates, rounded to 1/4096.
    const double distance = shows.distance, half = shows.size / 2,
                 moved = number_of(world_point(input.number(1) / 10 * shows.size, 0, 0).x);
    const ViewSpec spec = window_view(lab_window(distance, shows.size, moved));
    WireScene scene(canvas, spec);
    const Cube cube{{0, 0, 0}, 1};
    scene.cube(cube);
    const auto on_plane = [&](double u, double v) { return Vec{0.5 - u, 0.5 + v, -2}; };
    scene.outline(std::array{on_plane(moved - half, -half), on_plane(moved - half, half), on_plane(moved + half, half),
                             on_plane(moved + half, -half)},
                  {120, 150, 90});
    scene.axes({0, 0, 0}, 1.3);

    Figures figures;
    for (const LabView& each : kLabViews)
        figures.push_back({std::string("near / far face, ") + each.name, (each.distance + 3) / (each.distance + 2),
                           near_over_far(each), 0.0005, 4});
    std::rotate(figures.begin(), figures.begin() + static_cast<std::ptrdiff_t>(input.values[0]), figures.end());
    // In the lab's 200x200 pixels: u is VUP x VPN, so x grows to the left.
    const ViewContext lab = make_view_context(spec, {200, 200, {1, 1}});
    figures.push_back({"near face, windows wide: D / (D + 2) / window", distance / (distance + 2) / shows.size,
                       across({0, 0, 0}, {1, 0, 0}, lab) / 200, 0.0001, 4});
    const bool is_labs = input.values[0] == 0 && moved == 0;
    std::array<Vec, 8> corners;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vec place = cube.corner(static_cast<int>(i)), found = corners[i] = shown(place, lab);
        const double ahead = distance + place.z + 2, scale = 200 / shows.size;
        const Vec expected{100 + scale * ((0.5 - place.x) * distance / ahead - moved),
                           100 - scale * (place.y - 0.5) * distance / ahead};
        figures.push_back({"(" + triple_text(place, "%.0f", ", ") + ")" +
                               (is_labs ? "; the seed's table: " + pixel_text(kListedCorners[i], "%.0f") : ""),
                           pixel_text(expected, "%.1f"), pixel_text(found, "%.1f"),
                           std::hypot(found.x - expected.x, found.y - expected.y) < 0.01});
    }
    if (is_labs && canvas.width_px >= 320) write_table(corners, canvas);
    return figures;
}

/// The highest point that a plan shows, and the same with each pixel taken at the lowest point of its face within the
/// rounding of corners: on a face almost as steep as a wall this is many units lower.
struct PlanHeights {
    double highest = -1e9, lowest_possible = -1e9;
};

/// Draws a plan of the demo level.
PlanHeights draw_plan(const RowInput& input, const ViewSpec& view, Framebuffer canvas) {
    const Level& level = input.assets.demo_level;
    DemoFrame frame(input, input.mode);
    frame.scene.models = {};
    FrameRecord record;
    frame.work.observers.record = &record;
    frame.draw(view, canvas);
    const double per_column = 2 * number_of(view.window.half_width) / input.mode.width_px;
    const double per_row = per_column * number_of(input.mode.pixel().inverse());
    const double rounded_px = std::ldexp(0.5, -input.settings.accuracy.subpixel_bits);
    PlanHeights heights;
    for (std::int32_t row = 0; row < input.mode.height_px; ++row)
        for (std::int32_t column = 0; column < input.mode.width_px; ++column) {
            const PixelRecord& shows = item(record.pixels, row * canvas.pitch + column);
            if (shows.face.is_none()) continue;
            const LevelPlane& plane = level.planes[level.faces[shows.face].plane];
            const Vec normal = vec_of(plane.normal);
            if (std::abs(normal.z) <= 0.1) continue;
            const double x = number_of(view.eye.x) + (column + 0.5 - input.mode.width_px / 2.0) * per_column;
            const double y = number_of(view.eye.y) - (row + 0.5 - input.mode.height_px / 2.0) * per_row;
            const double height = (number_of(plane.distance) - normal.x * x - normal.y * y) / normal.z;
            const double rise_per_px =
                (std::abs(normal.x) * per_column + std::abs(normal.y) * per_row) / std::abs(normal.z);
            heights.highest = std::max(heights.highest, height);
            heights.lowest_possible = std::max(heights.lowest_possible, height - rounded_px * rise_per_px);
        }
    return heights;
}

Figures draw_front_plane(const RowInput& input, Canvas& canvas) {
    const auto height = static_cast<std::int32_t>(input.values[0]);
    ViewSpec view = orthographic_view(middle_of_demo_level(), side_axes(ViewSide::Top), View::from_int(2300));
    cut_front(view, middle_of_demo_level(), middle_of_demo_level().z - World::from_int(height));
    RowInput with_pixels = input;
    with_pixels.settings.correct_aspect = true;
    const PlanHeights heights = draw_plan(with_pixels, view, canvas);
    const bool is_rounded = input.settings.accuracy.subpixel_bits < Screen::kFractionBits;
    return {
        {"highest place shown", "at most " + std::to_string(height) + (is_rounded ? ", but for rounded corners" : ""),
         decimal_text(heights.highest, "%.1f"), heights.lowest_possible <= height + 0.5},
        {"front plane, units below the reference point", 40 - height}};
}

constexpr double kSphereDistance = 300;

constexpr std::array kZooms{20, 40, 60, 90};  // degrees

/// Before the demo level's sphere: the field of view changes, with or without the compensating move of the eye.
Figures draw_dolly_zoom(const RowInput& input, Canvas& canvas) {
    const bool moves = input.values[1] == 0;
    const int degrees = item(kZooms, input.values[0]);
    const Camera before = camera_at(-112, 352 - 300, 128, 90, 0, 60);
    Camera camera = before;
    camera.field_of_view = Degrees::from_int(degrees);
    if (moves) camera = dolly_zoomed(before, World::from_int(300), camera.field_of_view);
    ViewSpec view = first_person_view(camera);
    if (moves) cut_front(view, before.eye, World::from_int(8));
    DemoFrame(input, input.mode).draw(view, canvas);

    const auto tangent = [](double angle) { return std::tan(angle * std::numbers::pi / 360); };
    const double wide = tangent(degrees), half_px = input.mode.width_px / 2.0;
    const double distance = moves ? kSphereDistance * tangent(60) / wide : kSphereDistance;
    const ViewContext context = make_view_context(view, input.mode);
    const auto size_at = [&](double y) { return across({-162, y, 128}, {-62, y, 128}, context); };
    return {{"100 units at the sphere, columns", half_px * 100 / (distance * wide), size_at(352), 0.1, 2},
            {"the same 200 units behind it", half_px * 100 / ((distance + 200) * wide), size_at(552), 0.1, 2},
            {"behind / there = D / (D + 200)", distance / (distance + 200), size_at(552) / size_at(352), 0.001}};
}

/// A small cross at a pixel.
void draw_cross(const Vec& at, Canvas& canvas) {
    const auto x = static_cast<std::int32_t>(std::floor(at.x)), y = static_cast<std::int32_t>(std::floor(at.y));
    canvas.box({x - 6, y - 1, 13, 3}, kBlack);
    canvas.box({x - 1, y - 6, 3, 13}, kBlack);
    canvas.box({x - 5, y, 11, 1}, kYellow);
    canvas.box({x, y - 5, 1, 11}, kYellow);
}

Figures draw_cameras(const RowInput& input, Canvas& canvas) {
    const bool looks_at = input.values[0] == 0;
    const Vec ahead{std::cos(input.radians(1)), std::sin(input.radians(1))}, sphere{-112, 352, 128};
    const Vec eye = looks_at ? sphere - ahead * 150 + Vec{0, 0, 30} : Vec{-112, 202, 128};
    const Vec target = looks_at ? sphere : eye + ahead * 100;
    ViewSpec view = look_at_view(world_point(eye), world_point(target), Degrees::from_int(90));
    if (!looks_at) view = first_person_view(camera_at(-112, 202, 128, input.values[1], 0));
    DemoFrame(input, input.mode).draw(view, canvas);
    const ViewContext context = make_view_context(view, input.mode);
    const Vec found = shown(target, context), above = shown(target + Vec{0, 0, 20}, context);
    draw_cross(found, canvas);
    const double width = input.mode.width_px, height = input.mode.height_px;
    return {{looks_at ? "the target's column" : "the column of what is straight ahead", width / 2, found.x,
             width / 2000, 2},
            {"its row", height / 2, found.y, width / 2000, 2},
            {"columns from there to what is above it", 0, above.x - found.x, width / 2000, 2}};
}

/// A matrix below its title, in one of two columns and one of two rows.
void write_matrix(int column, int row, const char* title, const Matrix4& matrix, Canvas& canvas) {
    canvas.column(kTextMargin_px + column * (canvas.width_px / 2), 14 + row * 7 * kLineHeight_px,
                  matrix_lines(title, matrix, "%5.2f", "%7.2f"));
}

/// The notes' view matrix as a product, and the product in the other order.
Figures draw_look_at_product(const ViewContext& view, double yaw, Canvas& canvas) {
    const Vec4 eye = homogeneous(view.eye);
    const Matrix4 look_at = homogeneous(rotation_matrix(view.axes)), move = translation({-eye.x, -eye.y, -eye.z});
    const Matrix4 product = look_at * move, reversed = move * look_at;
    write_matrix(0, 0, "Look-at: rows are axes", look_at, canvas);
    write_matrix(1, 0, "Translate: eye to origin", move, canvas);
    write_matrix(0, 1, "Look-at * translate", product, canvas);
    write_matrix(1, 1, "Translate * look-at", reversed, canvas);
    const Vec4 moved = product * eye;
    const double turned = 60 * std::sin(yaw) + 120 * std::cos(yaw);
    return {{"look-at * translate, less the view's: worst entry", 0,
             largest_difference(product * camera_matrix(view.axes, view.eye), Matrix4::identity()), 1e-6, 6},
            {"the eye's distance from the origin after it", 0, length(vec_of(Vec3<Entry>{moved.x, moved.y, moved.z})),
             1e-6, 6},
            {"the eye's x after the other order", turned - 60, (reversed * eye).x, 0.02},
            {"-dot(x, eye)", -turned, product.rows[0][3], 0.02}};
}

/// The matrix of a view, from its axes, and its inverse.
Figures draw_view_matrix(const RowInput& input, Canvas& canvas) {
    const Camera camera = camera_at(60, -120, 70, input.values[1], input.values[2]);
    const ViewContext view = make_view_context(first_person_view(camera), input.mode);
    const double yaw = input.radians(1), pitch = input.radians(2);
    if (input.values[0] == 1) return draw_look_at_product(view, yaw, canvas);
    const Matrix4 to_world = camera_matrix(view.axes, view.eye), to_view_axes = view_matrix(view.axes, view.eye);
    write_matrix(0, 0, "The camera's matrix: columns right, up, forward, eye", to_world, canvas);
    write_matrix(0, 1, "Its inverse, the view's: rows of axes, -axis . eye", to_view_axes, canvas);

    // (160, -20, 90) from the eye is (100, 100, 20); forward and right from the angles.
    const double ahead = (100 * std::cos(yaw) + 100 * std::sin(yaw)) * std::cos(pitch) - 20 * std::sin(pitch),
                 right = 100 * std::sin(yaw) - 100 * std::cos(yaw);
    const Vec4 seen = to_view_axes * homogeneous_of({160, -20, 90});
    return {{"product of both, less the identity: worst entry", 0,
             largest_difference(to_world * to_view_axes, Matrix4::identity()), 1e-6, 6},
            {"(160, -20, 90): x in view, by the angles", right, seen.x, 0.02},
            {"its z", ahead, seen.z, 0.02}};
}

}  // namespace

std::vector<Row> view_rows() {
    return {{"view-window", draw_lab_cube, {choice_of("view", kLabViews), {"window moved, tenths", -5, 5, 1, 0}}},
            {"front-plane", draw_front_plane, {{"height", -50, 400, 50, 50}}},
            {"zoom-dolly",
             draw_dolly_zoom,
             {{"field of view", {"20 degrees", "40 degrees", "60 degrees", "90 degrees"}, 1},
              {"the eye", {"moves against it", "stays"}}}},
            {"cameras", draw_cameras, {{"camera", {"look-at", "first-person"}}, {"yaw", 0, 345, 15, 60}}},
            {"camera-matrix",
             draw_view_matrix,
             {{"matrices", {"a camera's and its inverse", "look-at times translate"}},
              {"yaw", 0, 345, 15, 30},
              {"pitch", -60, 60, 10, 10}}}};
}

}  // namespace oblong
