#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "engine/base/table.h"
#include "tools/demo_level/art/canvas.h"
#include "tools/demo_level/art/textures.h"

namespace oblong::art {
namespace {

int distance_256(int dx, int dy) {
    return static_cast<int>(std::lround(256 * std::hypot(dx, dy)));
}

/// One leaf of a fern: an arc from the pot that falls to a side, broader in its middle.
void paint_frond(Canvas& canvas, int reach, int rise, int seed) {
    constexpr int kParts = 40, kFootX = 24, kFootY = 44;
    for (int part = 0; part <= kParts; ++part) {
        const int x = kFootX + reach * part / kParts;
        const int y = kFootY - rise * 4 * part * (kParts * 3 / 2 - part) / (kParts * kParts * 9 / 4);
        const int half = 1 + (part > 8 && part < 34);
        for (int side = -half; side <= half; ++side) {
            if (hash_255(part, side, seed) < 50 && side != 0) continue;
            canvas.at(x, y + side) = {Ramp::Moss, steps(9 - 3 * std::abs(side)) + part * 60};
        }
    }
}

/// A zigzag from top to bottom, as drawn on what carries a current.
void paint_bolt(Canvas& canvas, int dx, Texel texel) {
    constexpr std::array<std::array<int, 2>, 4> kCorners{{{38, 8}, {24, 34}, {38, 32}, {24, 57}}};
    for (std::size_t i = 0; i + 1 < kCorners.size(); ++i) {
        const auto &from = kCorners[i], &to = kCorners[i + 1];
        for (int wide = -2; wide <= 2; ++wide)
            canvas.line(from[0] + dx + wide, from[1], to[0] + dx + wide, to[1], texel);
    }
}

}  // namespace

Canvas paint_teleport() {
    Canvas canvas(64, 64);
    const NoiseField slow{64, 64, 130}, fast{64, 64, 131};
    canvas.paint(canvas.whole(), [&](int x, int y) {
        const int swell = value_noise(slow, x, y, 32) + value_noise(fast, x, y, 8) / 3;
        const int band = std::max(0, 24 - std::abs(swell % 64)) * 90;
        if (hash_255(x, y, 132) > 252) return Texel{Ramp::Ice, steps(6)};
        return Texel{Ramp::Violet, steps(3) + band};
    });
    return canvas;
}

Canvas paint_mirror() {
    Canvas canvas(64, 64);
    canvas.paint(canvas.whole(), [](int x, int y) {
        const int gleam = std::max(0, 12 - std::abs((x + y) % 64 - 30)) * 40;
        return Texel{Ramp::Stone, steps(8) - y * 16 + gleam};
    });
    return canvas;
}

Canvas paint_lantern() {
    Canvas canvas(32, 32);
    canvas.fill(canvas.whole(), kHole);
    canvas.paint({9, 9, 14, 16}, [](int x, int y) {
        return Texel{Ramp::Flame, steps(7) - distance_256(2 * x - 13, 2 * y - 18) / 5};
    });
    canvas.outline({8, 8, 16, 18}, {Ramp::Brass, steps(9)});
    for (const int x : {13, 18}) canvas.fill({x, 9, 1, 16}, {Ramp::Brass, steps(6)});
    for (int row = 0; row < 4; ++row)
        canvas.fill({12 - row, 4 + row, 8 + 2 * row, 1}, {Ramp::Brass, steps(13 - 2 * row)});
    canvas.fill({10, 26, 12, 2}, {Ramp::Brass, steps(7)});
    canvas.outline({14, 0, 4, 5}, {Ramp::Brass, steps(10)});
    return canvas;
}

Canvas paint_fern() {
    Canvas canvas(48, 64);
    canvas.fill(canvas.whole(), kHole);
    for (const auto& [reach, rise] : {std::pair{-20, 14}, {20, 15}, {-15, 26}, {16, 28}, {-8, 36}, {7, 38}, {0, 40}}) {
        paint_frond(canvas, reach, rise, 140 + reach);
    }
    for (int row = 0; row < 20; ++row) {
        const int half = row < 3 ? 11 : 9 - row / 5;
        canvas.paint({24 - half, 44 + row, 2 * half, 1}, [&](int x, int) {
            return Texel{Ramp::Terracotta, steps(11) - std::abs(x - half / 2) * 90 - (row == 3 ? steps(3) : 0)};
        });
    }
    return canvas;
}

Canvas paint_neon() {
    constexpr int kWidth = 128, kHeight = 32, kPart = 4, kPhases = 4;
    Canvas canvas = paint_sign("WORKSHOP");
    Canvas neon(kWidth, kHeight);
    neon.paint(neon.whole(), [&](int x, int y) {
        const Texel texel = x < canvas.width() ? canvas.at(x, y) : Texel{};
        return texel.ramp == Ramp::Brass && x > 6 && x < canvas.width() - 6 && y > 6 && y < 26
                   ? texel
                   : Texel{Ramp::Night, steps(1)};
    });
    // Dots around the edge, each in one of the colours that take turns.
    const int around = 2 * (kWidth + kHeight) / kPart;
    for (int dot = 0; dot < around; ++dot) {
        int at = dot * kPart, x = 0, y = 0;
        if (at < kWidth)
            x = at;
        else if ((at -= kWidth) < kHeight)
            x = kWidth - 3, y = at;
        else if ((at -= kHeight) < kWidth)
            x = kWidth - 4 - at, y = kHeight - 3;
        else
            y = kHeight - 4 - (at - kWidth);
        neon.fill({x, y, 3, 3}, {Ramp::Magenta, steps(dot % kPhases)});
    }
    return neon;
}

Canvas paint_volt(int frame) {
    Canvas canvas(64, 64);
    canvas.paint(canvas.whole(), [](int x, int y) { return Texel{Ramp::Stone, steps(3) + hash_255(x / 5, y, 141)}; });
    canvas.bevel(canvas.whole(), steps(4));
    canvas.outline({3, 3, 58, 58}, {Ramp::Brass, steps(9)});
    paint_bolt(canvas, 2, {Ramp::Night, steps(1)});
    constexpr std::array<int, kVoltFrames> kGlow{1, 2, 3, 2};
    paint_bolt(canvas, 0, {Ramp::Cyan, steps(at(kGlow, frame))});
    return canvas;
}

Canvas paint_lamp_dead() {
    Canvas canvas = paint_lamp();
    for (int y = 0; y < canvas.height(); ++y) {
        for (int x = 0; x < canvas.width(); ++x) {
            Texel& texel = canvas.at(x, y);
            if (texel.ramp == Ramp::Flame) texel = {Ramp::Stone, steps(1) + hash_255(x, y, 142)};
        }
    }
    canvas.line(12, 4, 17, 15, {Ramp::Stone, steps(11)});
    canvas.line(17, 15, 9, 27, {Ramp::Stone, steps(9)});
    return canvas;
}

Canvas paint_lens_windows(bool is_lit) {
    Canvas canvas(192, 16);
    canvas.paint(canvas.whole(), [&](int x, int y) {
        const int across = 2 * (x % 16) - 15, down = 2 * y - 15, distance = across * across + down * down;
        if (distance > 15 * 15) return Texel{Ramp::Stone, steps(2)};
        if (distance > 11 * 11) return Texel{Ramp::Brass, steps(distance > 13 * 13 ? 6 : 9)};
        if (!is_lit) return Texel{Ramp::Stone, steps(across + down < -10 ? 4 : 2)};
        const Ramp ramp = at(kLensRamps, x / 16);
        const int last = place_of(ramp).count - 1;
        return Texel{ramp, steps(last) - steps(last) / 2 * distance / (11 * 11)};
    });
    return canvas;
}

}  // namespace oblong::art
