#include <algorithm>
#include <cmath>

#include "engine/base/table.h"
#include "tools/demo_level/art/canvas.h"
#include "tools/demo_level/art/textures.h"

namespace oblong::art {
namespace {

constexpr int kFrame = 7;
constexpr Box kCanvasBox{kFrame, kFrame, 64 - 2 * kFrame, 64 - 2 * kFrame};

/// A gilt frame: bright outer and inner lips, a dark hollow between, carved every few texels.
void paint_gilt_frame(Canvas& canvas) {
    constexpr std::array<int, kFrame> kProfile{4, 10, 14, 9, 5, 8, 12};
    for (int inset = 0; inset < kFrame; ++inset) {
        const int size = 64 - 2 * inset;
        canvas.outline({inset, inset, size, size}, {Ramp::Brass, steps(at(kProfile, inset))});
    }
    for (int at = 4; at < 60; at += 6) {
        for (const int edge : {3, 60}) {
            canvas.at(at, edge).level += steps(5);
            canvas.at(edge, at).level += steps(5);
        }
    }
    canvas.bevel({0, 0, 64, 64}, steps(2));
    canvas.lighten({kFrame, kFrame, 64 - 2 * kFrame, 2}, -steps(3));
}

/// Paint laid on in strokes: a little noise on every colour.
Texel stroke(Ramp ramp, int level, int x, int y) {
    return {ramp, level + (hash_255(x / 2, y, 130) - 128) + (hash_255(x, y, 131) - 128) / 2};
}

/// The unit isometric cube whose nearest corner is at x, y: three rhombi of slope 1/2.
void paint_isometric_cube(Canvas& canvas, int x, int y, int size, Ramp ramp) {
    for (int across = -size; across < size; ++across) {
        const int rise = std::abs(across) / 2;
        for (int down = 0; down < size; ++down) {
            canvas.at(x + across, y - rise + down) = stroke(ramp, steps(across < 0 ? 9 : 5), x + across, y + down);
        }
        for (int up = rise; up < size - rise; ++up) {
            canvas.at(x + across, y - up) = stroke(ramp, steps(12), x + across, y - up);
        }
    }
}

}  // namespace

Canvas paint_picture_road() {
    Canvas canvas(64, 64);
    constexpr int kHorizon = 27, kVanishingX = 32;
    canvas.paint(kCanvasBox, [](int column, int row) {
        const int x = column + kFrame, y = row + kFrame, below = y - kHorizon;
        if (below <= 0) return stroke(Ramp::Terracotta, steps(12) + below * 60, x, y);
        const int off_axis = std::abs(x - kVanishingX);
        const bool is_dash = 240 / below % 2 == 0;
        if (off_axis * 12 < below && is_dash) return stroke(Ramp::Ivory, steps(13), x, y);
        if (off_axis * 8 < below * 6) return stroke(Ramp::Violet, steps(4) + below * 20, x, y);
        return stroke(Ramp::Moss, steps(5) + (240 / below % 2) * steps(2), x, y);
    });
    for (int distance = 2; distance < 9; ++distance) {
        const int reach = 64 / distance;
        for (const int side : {-1, 1}) {
            const int x = kVanishingX + side * reach;
            if (x < kFrame || x >= 64 - kFrame) continue;
            canvas.line(x, std::max(kFrame, kHorizon - reach), x, kHorizon + reach / 2, {Ramp::Wood, steps(3)});
            canvas.disc(x, std::max(kFrame + 2, kHorizon - reach), 6 / distance + 1, {Ramp::Verdigris, steps(5)});
        }
    }
    canvas.disc(kVanishingX, kHorizon - 5, 4, {Ramp::Brass, steps(15)});
    paint_gilt_frame(canvas);
    return canvas;
}

Canvas paint_picture_cubes() {
    Canvas canvas(64, 64);
    canvas.paint(kCanvasBox, [](int x, int y) { return stroke(Ramp::Ivory, steps(11), x, y); });
    constexpr int kSize = 11;
    constexpr std::array<Ramp, 3> kHues{Ramp::Red, Ramp::Night, Ramp::Brass};
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column <= row; ++column) {
            const int x = 32 + (2 * column - row) * kSize, y = 20 + row * 14;
            paint_isometric_cube(canvas, x, y, kSize, at(kHues, (row + column) % 3));
        }
    }
    paint_gilt_frame(canvas);
    return canvas;
}

Canvas paint_picture_eye() {
    Canvas canvas(64, 64);
    canvas.paint(kCanvasBox, [](int x, int y) { return stroke(Ramp::Sand, steps(11), x, y); });
    const Texel ink{Ramp::Wood, steps(2)}, ray{Ramp::Red, steps(8)}, glass{Ramp::Water, steps(9)};
    canvas.fill({29, 16, 3, 34}, glass);
    canvas.outline({29, 16, 3, 34}, {Ramp::Water, steps(4)});
    canvas.outline({46, 14, 9, 38}, ink);
    for (const int y : {14, 51}) canvas.line(13, 33, 46, y, ray);
    canvas.disc(13, 33, 4, {Ramp::Ivory, steps(14)});
    canvas.disc(14, 33, 2, {Ramp::Night, steps(6)});
    canvas.line(9, 31, 13, 28, ink);
    canvas.line(13, 28, 17, 31, ink);
    paint_gilt_frame(canvas);
    return canvas;
}

Canvas paint_picture_moon() {
    Canvas canvas(64, 64);
    canvas.paint(kCanvasBox, [](int column, int row) {
        const int x = column + kFrame, y = row + kFrame;
        if (y < 40) return stroke(Ramp::Night, steps(3) + y * 24, x, y);
        const int glitter = std::abs(x - 38) < (y - 36) / 2 && hash_255(x / 3, y, 132) > 110 ? steps(6) : 0;
        return stroke(Ramp::Water, steps(3) + glitter, x, y);
    });
    canvas.disc(38, 22, 8, {Ramp::Ivory, steps(14)});
    canvas.disc(36, 20, 2, {Ramp::Ivory, steps(11)});
    canvas.disc(41, 25, 1, {Ramp::Ivory, steps(11)});
    canvas.fill({14, 26, 7, 14}, {Ramp::Stone, steps(1)});
    canvas.line(14, 26, 17, 20, {Ramp::Stone, steps(1)});
    canvas.line(20, 26, 17, 20, {Ramp::Stone, steps(1)});
    canvas.fill({17, 29, 1, 3}, {Ramp::Brass, steps(14)});
    paint_gilt_frame(canvas);
    return canvas;
}

}  // namespace oblong::art
