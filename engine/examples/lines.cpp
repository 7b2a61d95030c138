// Lines and clipping, written out. Above, a line in four ways: with a multiplication for each pixel, with an addition
// (DDA), with Bresenham's integers, and shaded by its distance from pixels (Gupta-Sproull). Below, a triangle clipped
// by each side of a window and filled as a fan. In the texts: the course notes on lines and clipping; Abrash on planes.
#include <oblong.h>

#include <cstdlib>

using namespace oblong;

namespace {

constexpr int kWhite = 63, kGrey = 64, kBlue = 65, kOne = 65536;  // colours: shades up to white; 1 of a row

// Each draws a line of `run` columns to the right and `rise` rows down, rise <= run.
void draw_naive(Framebuffer canvas, int x, int y, int run, int rise) {
    for (int i = 0; i <= run; ++i) set_pixel(canvas, x + i, y + (i * (rise * kOne / run) + kOne / 2) / kOne, kWhite);
}

void draw_dda(Framebuffer canvas, int x, int y, int run, int rise) {
    for (int i = 0, row = kOne / 2; i <= run; ++i, row += rise * kOne / run)
        set_pixel(canvas, x + i, y + row / kOne, kWhite);
}

void draw_bresenham(Framebuffer canvas, int x, int y, int run, int rise) {
    for (int i = 0, error = -run; i <= run; ++i, error += 2 * rise) {
        if (error >= 0) ++y, error -= 2 * run;  // the next row is as near or nearer
        set_pixel(canvas, x + i, y, kWhite);
    }
}

// Two rows share each column's light, by the vertical distance, which is slightly larger than the true one.
void draw_shaded(Framebuffer canvas, int x, int y, int run, int rise) {
    for (int i = 0, row = 0; i <= run; ++i, row += rise * kOne / run)
        for (int at = row / kOne; at < row / kOne + 2; ++at)
            set_pixel(canvas, x + i, y + at, kWhite * (kOne - std::abs(row - at * kOne)) / kOne);
}

// A side of the window as a plane equation; distances are positive inside.
struct Side {
    int a, b, c;
    int distance(PixelPosition p) const { return a * p.column + b * p.row + c; }
};

// The corners inside of a side, and the points where edges cross it.
std::vector<PixelPosition> cut(const std::vector<PixelPosition>& polygon, const Side& side) {
    std::vector<PixelPosition> kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const PixelPosition p = polygon[i], q = polygon[(i + 1) % polygon.size()];
        const int from = side.distance(p), to = side.distance(q), way = from - to;
        if (from >= 0) kept.push_back(p);
        if ((from < 0) != (to < 0))
            kept.push_back({p.column + (q.column - p.column) * from / way, p.row + (q.row - p.row) * from / way});
    }
    return kept;
}

}  // namespace

int main() try {
    Window window("Lines");
    set_ramp(window.palette, 0, kWhite, {12, 14, 30}, {250, 250, 240});
    set_ramp(window.palette, kGrey, kBlue, {110, 110, 120}, {60, 110, 190});
    do {
        const Framebuffer canvas = window.canvas();
        clear(canvas);
        const auto wave = [&](int degrees) { return sine_65536(window.time_ms() * 8 + degrees * 256); };
        for (int x = 10; const auto draw : {draw_naive, draw_dda, draw_bresenham, draw_shaded})
            draw(canvas, x, 8, 66, 33 + wave(0) / 2048), x += 78;
        std::vector<PixelPosition> left;
        for (const int at : {0, 110, 250}) left.push_back({160 + wave(at + 90) / 728, 138 + wave(at) / 874});
        for (const auto& [a, b] : {std::pair(left[0], left[1]), {left[1], left[2]}, {left[2], left[0]}})
            draw_line(canvas, a.column, a.row, b.column, b.row, kGrey);
        for (const Side& side : {Side{1, 0, -110}, {-1, 0, 210}, {0, 1, -105}, {0, -1, 170}}) left = cut(left, side);
        for (std::size_t i = 2; i < left.size(); ++i) fill_triangle(canvas, left[0], left[i - 1], left[i], kBlue);
        draw_rectangle(canvas, 109, 104, 103, 68, kWhite);
    } while (window.show());
} catch (const std::exception& error) {
    return report(error);
}
