#include <algorithm>

#include "engine/draw/font.h"
#include "tools/demo_level/art/canvas.h"
#include "tools/demo_level/art/textures.h"

namespace oblong::art {
namespace {

/// A dark blue board in a rounded brass frame.
void paint_board(Canvas& canvas) {
    const NoiseField field{canvas.width(), canvas.height(), 120};
    canvas.paint(canvas.whole(), [&](int x, int y) {
        return Texel{Ramp::Night, steps(2) + fractal_noise(field, x, y, 16) / 3 + (hash_255(x, y, 121) - 128) / 2};
    });
    const Box whole = canvas.whole();
    for (const auto& [inset, level] : {std::pair{0, 5}, {1, 11}, {2, 14}, {3, 8}, {4, 3}}) {
        const Box frame{inset, inset, whole.width - 2 * inset, whole.height - 2 * inset};
        canvas.outline(frame, {Ramp::Brass, steps(level)});
    }
    for (const int x : {2, whole.width - 4}) {
        for (const int y : {2, whole.height - 4}) canvas.fill({x, y, 2, 2}, {Ramp::Brass, steps(15)});
    }
}

/// `scale` times as large as the font, a gap of one texel (scaled) between letters.
int text_width(std::string_view text, int scale) {
    return (static_cast<int>(text.size()) * kGlyphAdvance_px - 1) * scale;
}

void draw_text(Canvas& canvas, std::string_view text, int x, int y, int scale, Texel texel) {
    for (const char letter : text) {
        for (int row = 0; row < kGlyphHeight_px; ++row)
            for (int column = 0; column < kGlyphWidth_px; ++column)
                if (is_drawn(glyph_of(letter), row, column))
                    canvas.fill({x + column * scale, y + row * scale, scale, scale}, texel);
        x += kGlyphAdvance_px * scale;
    }
}

/// Letters with a shadow below and right.
void engrave(Canvas& canvas, std::string_view text, int y, int scale, Texel ink) {
    const int x = (canvas.width() - text_width(text, scale)) / 2;
    draw_text(canvas, text, x + 1, y + 1, scale, {Ramp::Night, steps(0)});
    draw_text(canvas, text, x, y, scale, ink);
}

}  // namespace

Canvas paint_sign(std::string_view first, std::string_view second) {
    constexpr int kScale = 2, kMargin = 18, kLine = 18;
    const int text = std::max(text_width(first, kScale), text_width(second, kScale));
    Canvas canvas((text + kMargin + 15) / 16 * 16, second.empty() ? 32 : 48);
    paint_board(canvas);
    const Texel gold{Ramp::Brass, steps(14)};
    const int y = second.empty() ? 9 : 7;
    engrave(canvas, first, y, kScale, gold);
    engrave(canvas, second, y + kLine, kScale, gold);
    return canvas;
}

Canvas paint_title(std::string_view text) {
    Canvas canvas(128, 32);
    paint_board(canvas);
    engrave(canvas, text, 6, 3, {Ramp::Flame, steps(5)});
    const int x = (canvas.width() - text_width(text, 3)) / 2;
    for (int row = 6; row < 14; ++row) {
        for (int column = x; column < canvas.width() - 8; ++column) {
            Texel& texel = canvas.at(column, row);
            if (texel.ramp == Ramp::Flame) texel.level = steps(6);
        }
    }
    return canvas;
}

Canvas paint_exit_sign(int frame) {
    Canvas canvas(112, 32);
    paint_board(canvas);
    draw_text(canvas, "EXIT", 12, 9, 2, {Ramp::Green, steps(2)});
    for (int arrow = 0; arrow < kExitFrames - 1; ++arrow) {
        draw_text(canvas, ">", 64 + arrow * 13, 9, 2, {Ramp::Green, steps(arrow == frame ? 3 : 0)});
    }
    return canvas;
}

}  // namespace oblong::art
