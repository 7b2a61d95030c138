// A map of tiles, larger than the screen, that scrolls by pixels: only the tiles in view are drawn. A palette is made
// of the pictures' own colours. Arrow keys move the view; it moves by itself until one is pressed.
//
// Usage: example_tiles [ASSETS]
#include <oblong.h>

#include <algorithm>
#include <array>
#include <string>

using namespace oblong;

namespace {

constexpr int kTile = 16, kColumns = 96, kRows = 24;
constexpr int kMetal = 8;  // rows of a picture, which a tile repeats
constexpr int kSky = 240;  // colours from here on are a ramp

// 0: air; others: tiles. Hills are sums of waves, with caves in them.
struct Map {
    std::array<std::uint8_t, kColumns * kRows> tiles{};

    explicit Map(std::uint64_t seed) {
        for (int x = 0; x < kColumns; ++x) {
            const int top = 12 + sine_65536(x * 4500) * 4 / 65536 + sine_65536(x * 13'000) * 2 / 65536;
            for (int y = 0; y < kRows; ++y) {
                const bool is_cave = y > top + 2 && sine_65536(x * 9000 + y * 5000) + sine_65536(y * 17'000) > 50'000;
                const int depth = y - top;
                const int ore = random_below(12, seed) == 0 ? 3 : 2;
                if (depth >= 0 && !is_cave) at(x, y) = static_cast<std::uint8_t>(depth == 0 ? 1 : ore);
            }
        }
    }
    std::uint8_t& at(int x, int y) { return tiles[static_cast<std::size_t>(y * kColumns + x)]; }
};

void draw_map(Framebuffer canvas, Map& map, const Picture& tiles, int left, int top) {
    for (int y = top / kTile; y * kTile < top + canvas.height_px; ++y)
        for (int x = left / kTile; x * kTile < left + canvas.width_px; ++x)
            if (const int tile = map.at(x, y); tile != 0)
                draw_part(canvas, tiles, {(tile - 1) * kTile, 0, kTile, kTile}, x * kTile - left, y * kTile - top);
}

}  // namespace

int main(int argc, char** argv) try {
    const std::string models = std::string(argc > 1 ? argv[1] : "build/assets") + "/models/";
    Window window("Tiles");
    set_from_pictures(window.palette, 0, kSky - 1, {models + "globe.png", models + "bronze.png", models + "gold.png"});
    set_ramp(window.palette, kSky, 254, {70, 110, 190}, {230, 220, 190});
    Picture tiles = Picture::of_size(3 * kTile, kTile);
    for (int i = 0; const char* name : {"globe.png", "bronze.png", "gold.png"}) {
        const Picture metal = load_picture(models + name, window.palette);
        for (int row = 0; row < kTile; row += kMetal)
            draw_part(tiles.canvas(), metal, {16, 0, kTile, kMetal}, i * kTile, row);
        ++i;
    }
    Map map(1);
    std::int64_t shown_ms = 0;
    int left_256 = 0, top_256 = 90 * 256;
    bool is_steered = false;
    do {
        const int passed_ms = static_cast<int>(std::min<std::int64_t>(window.time_ms() - shown_ms, 100));
        shown_ms = window.time_ms();
        const int right = window.is_down("Right") - window.is_down("Left"),
                  down = window.is_down("Down") - window.is_down("Up");
        is_steered |= right != 0 || down != 0;
        left_256 += (is_steered ? right * 40 : 15) * passed_ms;
        left_256 = std::clamp(left_256, 0, (kColumns * kTile - window.mode().width_px) * 256);
        top_256 = std::clamp(top_256 + down * 40 * passed_ms, 0, (kRows * kTile - window.mode().height_px) * 256);
        const Framebuffer canvas = window.canvas();
        for (int y = 0; y < canvas.height_px; ++y)
            fill_rectangle(canvas, 0, y, canvas.width_px, 1, kSky + y * 15 / canvas.height_px);
        draw_map(canvas, map, tiles, left_256 / 256, top_256 / 256);
    } while (window.show());
} catch (const std::exception& error) {
    return report(error);
}
