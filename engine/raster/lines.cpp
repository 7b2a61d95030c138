#include "engine/raster/lines.h"

#include <algorithm>

#include "engine/raster/line_walks.h"

namespace oblong {

namespace {

/// A canvas along the axes of a line.
struct LineCanvas {
    std::uint8_t* pixels;
    std::int64_t major_size, minor_size, major_pitch, minor_pitch;
};

LineCanvas along(const LinePath& path, Framebuffer canvas) {
    if (path.is_steep) return {canvas.pixels, canvas.height_px, canvas.width_px, canvas.pitch, 1};
    return {canvas.pixels, canvas.width_px, canvas.height_px, 1, canvas.pitch};
}

struct StepRange {
    std::int64_t first, end;
};

/// The first step at which the walk is at `minor` or past it, in its direction of climb; by bisection.
template <class Walk>
std::int64_t first_step_at(std::int64_t minor, const LinePath& path, const Walk& walk, StepRange among) {
    while (among.first < among.end) {
        const std::int64_t middle = among.first + (among.end - among.first) / 2;
        const std::int64_t there = walk.minor_at(middle);
        const bool is_past = path.minor_rise < 0 ? there <= minor : there >= minor;
        (is_past ? among.end : among.first) = is_past ? middle : middle + 1;
    }
    return among.first;
}

/// The steps at which the walk is in the canvas, or within `margin` pixels of it along the minor axis.
template <class Walk>
StepRange steps_inside(const LinePath& path, const Walk& walk, const LineCanvas& canvas, std::int64_t margin) {
    StepRange steps{std::max<std::int64_t>(-path.major, 0), std::min(canvas.major_size - path.major, path.steps + 1)};
    const std::int64_t least = -margin, most = canvas.minor_size - 1 + margin;
    const bool falls = path.minor_rise < 0;
    steps.first = first_step_at(falls ? most : least, path, walk, steps);
    steps.end = first_step_at(falls ? least - 1 : most + 1, path, walk, steps);
    return steps;
}

/// The framebuffer index of a walk's pixel, updated by additions.
class PixelIndex {
  public:
    PixelIndex(const LineCanvas& canvas, std::int64_t major, std::int64_t minor)
        : canvas_(canvas), minor_(minor), index_(major * canvas.major_pitch + minor * canvas.minor_pitch) {}

    std::int64_t at_minor(std::int64_t minor) {
        for (; minor_ < minor; ++minor_) index_ += canvas_.minor_pitch;
        for (; minor_ > minor; --minor_) index_ -= canvas_.minor_pitch;
        return index_;
    }
    void next_major() { index_ += canvas_.major_pitch; }

  private:
    const LineCanvas& canvas_;
    std::int64_t minor_, index_;
};

template <class Walk>
void draw_solid(const LinePath& path, std::uint8_t colour, Framebuffer out) {
    const LineCanvas canvas = along(path, out);
    Walk walk(path);
    const StepRange steps = steps_inside(path, walk, canvas, 0);
    if (steps.first >= steps.end) return;
    walk.move_to(steps.first);
    PixelIndex index(canvas, path.major + steps.first, walk.minor());
    for (std::int64_t step = steps.first; step < steps.end; ++step, walk.next(), index.next_major())
        canvas.pixels[index.at_minor(walk.minor())] = colour;
}

void blend_pixel(std::uint8_t& pixel, std::int64_t distance_60, const LineBlends& blends) {
    const std::int32_t covered_256 = GuptaSproullWalk<std::int64_t>::coverage_256(distance_60);
    pixel = item(item(blends, covered_256 / 4), pixel);
}

void draw_blended(const LinePath& path, const LineBlends& blends, Framebuffer out) {
    const LineCanvas canvas = along(path, out);
    GuptaSproullWalk<std::int64_t> walk(path);
    const StepRange steps = steps_inside(path, walk, canvas, 1);
    if (steps.first >= steps.end) return;
    walk.move_to(steps.first);
    PixelIndex index(canvas, path.major + steps.first, walk.minor());
    for (std::int64_t step = steps.first; step < steps.end; ++step, walk.next(), index.next_major()) {
        const auto neighbours = walk.neighbours();
        std::int64_t minor = walk.minor() - 1, pixel = index.at_minor(walk.minor()) - canvas.minor_pitch;
        for (const std::int64_t distance_60 : neighbours.distance_60) {
            if (minor >= 0 && minor < canvas.minor_size) blend_pixel(canvas.pixels[pixel], distance_60, blends);
            ++minor;
            pixel += canvas.minor_pitch;
        }
    }
}

}  // namespace

void draw_line(PixelPosition from, PixelPosition to, const LineStyle& style, Framebuffer canvas) {
    const LinePath path = make_line_path(from, to, style.method == LineMethod::Naive);
    if (style.method == LineMethod::Naive) return draw_solid<NaiveWalk<std::int64_t>>(path, style.colour, canvas);
    if (style.method == LineMethod::Dda) return draw_solid<DdaWalk<std::int64_t>>(path, style.colour, canvas);
    if (style.method == LineMethod::GuptaSproull && style.blends) return draw_blended(path, *style.blends, canvas);
    draw_solid<BresenhamWalk<std::int64_t>>(path, style.colour, canvas);
}

}  // namespace oblong
