// Star field: perspective is one division. A star's screen position is its position in space times a multiplier,
// divided by its distance; there are two multipliers, since pixels are taller than wide. In the texts: Muratori on
// aspect ratios and on the field of view; Princeton's "Perspective Projection".
#include <oblong.h>

#include <vector>

using namespace oblong;

namespace {

constexpr int kFarthest = 1024, kStars = 700, kColours = 64;

struct Star {
    int right, up, distance;
};

std::vector<Star> scattered() {
    std::uint64_t random = 1;
    const auto place = [&] { return random_below(2 * kFarthest, random) - kFarthest; };
    std::vector<Star> stars;
    for (int i = 0; i < kStars; ++i) stars.push_back({place(), place(), random_below(kFarthest, random)});
    return stars;
}

// Half the columns for a star as far to the right as away: 90 degrees across.
PixelPosition on_screen(const Star& star, int distance, const ScreenMode& mode) {
    const auto [width, height] = mode.pixel();
    const int across = mode.width_px / 2, down = static_cast<int>(across * width / height);
    return {mode.width_px / 2 + star.right * across / distance, mode.height_px / 2 - star.up * down / distance};
}

}  // namespace

int main() try {
    Window window("Star field");
    set_ramp(window.palette, 0, kColours - 1, {20, 20, 50}, {255, 255, 255});
    const std::vector<Star> stars = scattered();
    do {
        clear(window.canvas());
        const std::int64_t flown = window.time_ms() * 256 / 1000;
        for (const Star& star : stars) {
            // A star that is passed returns from afar.
            const int distance =
                static_cast<int>((star.distance + 1'000'000 * std::int64_t{kFarthest} - flown) % kFarthest);
            const PixelPosition now = on_screen(star, distance + 1, window.mode()),
                                before = on_screen(star, distance + 9, window.mode());
            const int brightness = (kFarthest - 1 - distance) * kColours / kFarthest;
            draw_line(window.canvas(), before.column, before.row, now.column, now.row, brightness);
        }
    } while (window.show());
} catch (const std::exception& error) {
    return report(error);
}
