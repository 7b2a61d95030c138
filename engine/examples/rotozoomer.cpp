// Rotozoomer: a picture turned and scaled over the whole screen. The next column is one step on the picture, the next
// row another step at right angles, so that the inner loop only adds. The row's step is larger by the shape of a pixel,
// so that squares stay square.
#include <oblong.h>

using namespace oblong;

namespace {

constexpr int kSide = 64;

// Its sides are powers of two, so that coordinates wrap with a mask.
Picture texture() {
    Picture picture = Picture::of_size(kSide, kSide);
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x) set_pixel(picture.canvas(), x, y, x ^ y);
    return picture;
}

// A step on the picture, right and down, 65,536 a texel.
struct Step {
    int u, v;
};

void draw(Framebuffer canvas, const Picture& picture, Step column, Step row) {
    const int half_width = canvas.width_px / 2, half_height = canvas.height_px / 2;
    for (int y = 0; y < canvas.height_px; ++y) {
        int u = (y - half_height) * row.u - half_width * column.u,
            v = (y - half_height) * row.v - half_width * column.v;
        for (int x = 0; x < canvas.width_px; ++x, u += column.u, v += column.v) {
            const int texel_u = (u >> 16) & (kSide - 1), texel_v = (v >> 16) & (kSide - 1);
            canvas.row(y)[x] = picture.pixels[static_cast<std::size_t>(texel_v * kSide + texel_u)];
        }
    }
}

}  // namespace

int main() try {
    Window window("Rotozoomer");
    set_ramp(window.palette, 0, kSide - 1, {20, 10, 60}, {255, 220, 120});
    const Picture picture = texture();
    const Ratio pixel = window.mode().pixel();  // 5 wide, 6 high
    do {
        const std::int64_t turn = 30 * 256 + window.time_ms() * 10, breath = window.time_ms() * 16;
        const int texels_256 = 140 + sine_65536(breath) / 600;  // for each column: from a tenth of a texel to one
        const auto along = [&](std::int64_t angle) { return std::int64_t{sine_65536(angle)} * texels_256 / 256; };
        const auto u = static_cast<int>(along(turn + 90 * 256)), v = static_cast<int>(along(turn));
        const auto row = [&](int across) { return static_cast<int>(across * pixel.denominator / pixel.numerator); };
        draw(window.canvas(), picture, {u, v}, {row(-v), row(u)});
    } while (window.show());
} catch (const std::exception& error) {
    return report(error);
}
