// Queries on a frame: the surface under the crosshair (seed 5's lines and planes), the log by subject and the memory
// (seed 2).

#include "engine/frame/frame_counts.h"
#include "engine/level/side.h"
#include "engine/programs/crosshair.h"
#include "engine/programs/frame_log.h"
#include "tools/gallery/allocations.h"
#include "tools/gallery/sketch.h"

namespace oblong {

namespace {

/// The distance along a ray to its intersection with a face, in double precision; below 0: none.
double distance_in_double(const Level& level, const Face& face, const Vec& eye, const Vec& direction) {
    const LevelPlane& plane = level.planes[face.plane];
    const double sign = face.is_back ? -1 : 1;
    const Vec n = vec_of(plane.normal) * sign;
    const double above = dot(eye, n) - sign * number_of(plane.distance), approach = -dot(direction, n);
    if (above <= 0 || approach <= 0) return -1;
    const double t = above / approach;
    for (const SurfEdge step : level.edges_of(face)) {
        const Edge& edge = level.edges[step.edge()];
        const Vec a = vec_of(level.vertices[step.is_reversed() ? edge.to : edge.from]);
        const Vec b = vec_of(level.vertices[step.is_reversed() ? edge.from : edge.to]);
        if (dot(eye + direction * t - a, cross(b - a, n)) < 0) return -1;
    }
    return t;
}

/// The nearest of all faces along a camera's middle ray.
double nearest_in_double(const Level& level, std::span<const PlacedModel> models, const Camera& camera) {
    const Vec direction = vec_of(view_basis(camera.yaw, camera.pitch, camera.roll).forward);
    double nearest = 1e9;
    const auto look = [&](IndexRange<Face> faces, const Vec& eye) {
        for (const FaceIndex face : faces)
            if (const double t = distance_in_double(level, level.faces[face], eye, direction); t >= 0)
                nearest = std::min(nearest, t);
    };
    look(level.world().faces, vec_of(camera.eye));
    for (const PlacedModel& placed : models) look(level.models[placed.model].faces, vec_of(camera.eye - placed.offset));
    return nearest;
}

Figures draw_picking(const RowInput& input, Canvas& canvas) {
    const Level& level = input.assets.demo_level;
    const Camera camera = camera_at(0, -368, 70, input.values[0], input.values[1]);
    DemoFrame(input, input.mode).draw(camera, canvas);
    const std::vector<PlacedModel> models = models_at_rest(level);
    const auto picked = pick_ahead(level, models, camera);
    draw_crosshair(canvas, input.assets.text);
    draw_lines_above(canvas.height_px - kFooter_px - 2, describe_picked(level, models, picked), input.assets.text,
                     canvas);
    if (!picked) return {{"faces ahead", 0, 0}};
    return {{"distance ahead, by a look at all faces in double", nearest_in_double(level, models, camera),
             picked->distance, 1e-3},
            {"the point's distance from the face's plane", 0,
             plane_distance(level.planes[level.faces[picked->face].plane], picked->world_point), 1e-3, 6},
            {"face, of " + std::to_string(level.faces.size()), picked->face.number()}};
}

/// A frame of the demo level that was drawn for its log.
struct LoggedScene : DemoFrame {
    LoggedScene(const RowInput& input, const Camera& camera, Framebuffer canvas)
        : DemoFrame(input, input.mode), view(first_person_view(camera, settings.accuracy.sine)) {
        draw(view, canvas);
    }

    LoggedFrame frame() const { return {scene, view, mode, settings, work}; }

    ViewSpec view;
};

/// The lines that a log notes of a frame.
std::vector<std::string> noted(LogChannels channels, const LoggedFrame& frame) {
    std::vector<std::string> lines;
    FrameLog(channels, [&lines](const std::string& line) { lines.push_back(line); }).note(frame);
    return lines;
}

Figures draw_log(const RowInput& input, Canvas& canvas) {
    LoggedScene logged(input, camera_at(0, -368, 70, 90, -4), canvas);
    const auto lines = noted(LogChannels::only(static_cast<LogChannel>(input.values[0])), logged.frame());
    recolour_area(canvas, {0, 0, canvas.width_px, canvas.height_px}, darker_colours(input.assets.colormap.palette, 72));
    std::vector<std::string> parts;
    for (const std::string& line : lines)
        for (const std::string_view part : lines_of(line, canvas.width_px - 2 * kTextMargin_px))
            parts.emplace_back(part);
    canvas.column(kTextMargin_px, 3, parts);
    std::int64_t spans_px = pixels_of(logged.work.view.claims.void_spans);
    for (const FaceList list : {FaceList::Walls, FaceList::Flat, FaceList::Liquid, FaceList::Sky, FaceList::Mirror})
        spans_px += pixels_of(logged.work.view.claims, list);
    return {{"pixels of all spans: each one once", std::int64_t{input.mode.width_px} * input.mode.height_px, spans_px},
            {"lines of this kind", std::ssize(lines)},
            {"lines with no channel on", 0, std::ssize(noted({}, logged.frame()))}};
}

std::size_t first_digit_of(const std::string& line) {
    return line.find_first_of("0123456789");
}

double bytes_in(const std::string& memory_line) {
    return std::stod(memory_line.substr(first_digit_of(memory_line)));
}

/// The bytes in the line that begins with this text, which must exist.
double bytes_of(std::string_view what, const LogLines& memory) {
    return bytes_in(
        *std::find_if(memory.begin(), memory.end(), [what](const auto& line) { return line.starts_with(what); }));
}

Figures draw_memory(const RowInput& input, Canvas& canvas) {
    std::optional<LoggedScene> scene;
    const AllocationCount first =
        allocations_of([&] { scene.emplace(input, camera_at(0, -368, 70, input.values[0], -4), canvas); });
    const AllocationCount again = allocations_of([&] { scene->draw(scene->view, canvas); });
    const LogLines lines = memory_lines(scene->frame());
    canvas.fill(kGround);
    std::vector<std::string> labels;
    std::int32_t bars_x = 0, y = kHeader_px + 5;
    double sum = -bytes_in(lines.back());  // the last is all rooms
    for (const std::string& line : lines) {
        labels.push_back(line.substr(0, first_digit_of(line)) + decimal_text(bytes_in(line) / 1024, "%.1f kB"));
        bars_x = std::max(bars_x, kTextMargin_px + text_width_px(labels.back()) + 6);
        sum += bytes_in(line);
    }
    for (std::size_t i = 0; i < lines.size(); ++i, y += kGlyphHeight_px) {
        // A logarithmic scale from half a kilobyte to 16 megabytes.
        const double share = std::log2(std::max(bytes_in(lines[i]) / 512, 1.0)) / 15;
        canvas.box({bars_x, y, static_cast<std::int32_t>(share * (canvas.width_px - bars_x)), kGlyphHeight_px - 2},
                   kBlue);
        canvas.write(kTextMargin_px, y, labels[i]);
    }
    canvas.write(kTextMargin_px, y + 2,
                 std::to_string(first.allocations) + " allocations of " + std::to_string(first.bytes) +
                     " bytes; then " + std::to_string(again.allocations) + " a frame");
    double texels = 0;
    for (const MipTexture& texture : input.assets.demo_level.textures)
        texels += texture.width * texture.height * (1 + 1 / 4.0 + 1 / 16.0 + 1 / 64.0);
    return {{"allocations of a warm frame", 0, again.allocations},
            {"allocations up to the first frame", first.allocations},
            {"their bytes", first.bytes},
            {"bytes of the framebuffer", input.mode.width_px * input.mode.height_px,
             bytes_of("screen: framebuffer", lines), 0, 0},
            {"bytes of textures: four mip levels each", texels, bytes_of("level: textures", lines), 0, 0},
            {"bytes in all", sum, bytes_in(lines.back()), 0, 0}};
}

}  // namespace

std::vector<Row> inspection_rows() {
    std::vector<std::string> channels(kLogChannelNames.begin(), kLogChannelNames.end());
    return {{"picking", draw_picking, {{"yaw, degrees", 0, 350, 10, 90}, {"pitch, degrees", -30, 30, 5, 0}}},
            {"log", draw_log, {{"kind", channels, 3}}},
            {"memory", draw_memory, {{"yaw, degrees", 0, 270, 90, 90}}}};
}

}  // namespace oblong
