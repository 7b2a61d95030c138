#include "tools/gallery/sketch.h"

#include <algorithm>
#include <cmath>

#include "engine/draw/font.h"
#include "engine/raster/lines.h"
#include "engine/raster/scan.h"
#include "engine/view/canonical_volume.h"
#include "engine/view/views.h"

namespace oblong {

namespace {

constexpr double kNearest = 0.25, kFarthest = 8192;

/// The mode of a part of a picture, with pixels of the same shape.
ScreenMode mode_of_part(const ScreenMode& mode, Framebuffer part) {
    return {part.width_px, part.height_px, mode.pixel() * Ratio{part.width_px, part.height_px}};
}

Screen screen_of(Entry pixels) {
    return convert<Screen>(convert<ScreenWide>(pixels));
}

PixelPosition pixel_at(const ScreenVertex& vertex, Framebuffer part) {
    return {std::clamp(floor_of(vertex.x), 0, part.width_px - 1),
            std::clamp(floor_of(vertex.y), 0, part.height_px - 1)};
}

}  // namespace

Sketch::Sketch(const RowInput& input, Framebuffer canvas, const Area& area, const SketchEye& from)
    : part_(part_of(canvas, area)), text_(input.assets.text) {
    view_ = make_view_context(look_at_view(from.eye, from.target, Degrees::from_int(from.field_of_view)),
                              mode_of_part(input.mode, part_));
    world_to_volume_ =
        volume_matrix(view_.projection, entry_of(kNearest), entry_of(kFarthest)) * view_matrix(view_.axes, view_.eye);
}

std::vector<ScreenVertex> Sketch::clipped(std::span<const Vec3<World>> corners) const {
    std::vector<Vec4> polygon;
    for (const Vec3<World>& p : corners)
        polygon.push_back(world_to_volume_ * Vec4{convert<Entry>(p.x), convert<Entry>(p.y), convert<Entry>(p.z)});
    std::vector<ScreenVertex> screen;
    for (const Vec4& corner : clip_to_volume(polygon)) {
        const VolumeScreenPoint at = volume_to_screen(corner, part_.width_px, part_.height_px);
        screen.push_back({screen_of(at.x), screen_of(at.y)});
    }
    return screen;
}

void Sketch::line(const Vec3<World>& from, const Vec3<World>& to, std::uint8_t colour) {
    const std::vector<ScreenVertex> ends = clipped(std::array{from, to});
    if (ends.empty()) return;
    // Crossings come twice, once for each way along the edge.
    const auto farthest = [&](const ScreenVertex& a, const ScreenVertex& b) {
        const auto way = [&](const ScreenVertex& v) {
            return std::abs(v.x.raw - ends.front().x.raw) + std::abs(v.y.raw - ends.front().y.raw);
        };
        return way(a) < way(b);
    };
    draw_line(pixel_at(ends.front(), part_), pixel_at(*std::max_element(ends.begin(), ends.end(), farthest), part_),
              {LineMethod::Bresenham, colour}, part_);
}

void Sketch::outline(std::span<const Vec3<World>> corners, std::uint8_t colour) {
    for (std::size_t i = 0; i < corners.size(); ++i) line(corners[i], corners[(i + 1) % corners.size()], colour);
}

void Sketch::polygon(std::span<const Vec3<World>> corners, std::uint8_t colour) {
    std::vector<ScreenVertex> screen = clipped(corners);
    if (screen.size() < 3) return;
    if (doubled_area(screen) < ScreenArea{}) std::reverse(screen.begin(), screen.end());
    ScanlineExtents rows(part_.height_px);
    scan_convex(screen, rows);
    for (std::int32_t y = rows.first; y < rows.end; ++y)
        if (at(rows.left, y) < at(rows.right, y))
            fill_area(part_, {at(rows.left, y), y, at(rows.right, y) - at(rows.left, y), 1}, colour);
}

void Sketch::label(const Vec3<World>& at, std::string_view text, std::uint8_t colour) {
    const std::optional<PlanePoint> place = place_of(at);
    if (!place) return;
    draw_text(part_, static_cast<std::int32_t>(place->x) + 3, static_cast<std::int32_t>(place->y) - 9, text,
              {colour, text_.dark});
}

std::optional<PlanePoint> Sketch::place_of(const Vec3<World>& point) const {
    const Vec4 corner =
        world_to_volume_ * Vec4{convert<Entry>(point.x), convert<Entry>(point.y), convert<Entry>(point.z)};
    if (volume_outcode(corner) != 0) return std::nullopt;
    const VolumeScreenPoint at = volume_to_screen(corner, part_.width_px, part_.height_px);
    return PlanePoint{number_of(at.x), number_of(at.y)};
}

Area scene_area(Framebuffer canvas, std::int32_t width_of_320) {
    return {0, kHeader_px, std::max(canvas.width_px * width_of_320 / 320, 8),
            std::max(canvas.height_px - kHeader_px - kFooter_px, 8)};
}

void draw_column(Framebuffer canvas, std::int32_t x, std::int32_t y, std::span<const std::string> lines,
                 TextColours colours) {
    const auto room = static_cast<std::size_t>(std::max(canvas.height_px - kFooter_px - y, 0) / kLineHeight_px);
    for (std::size_t i = 0; i < std::min(room, lines.size()); ++i) {
        const bool is_cut = i + 1 == room && room < lines.size();
        draw_text(canvas, x, y, is_cut ? "and " + std::to_string(lines.size() - i) + " more" : lines[i], colours);
        y += kLineHeight_px;
    }
}

}  // namespace oblong
