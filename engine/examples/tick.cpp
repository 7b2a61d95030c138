// A fixed tick: the sun pulls comets 100 times a second, whatever the pictures' rate, so that their ways are the same
// on every machine. A picture shows them between two ticks, or else slow rates would look jerky: 1 chooses 10
// pictures a second, 2 all. A comet's tail is turned away from the sun.
#include <oblong.h>

#include <array>

using namespace oblong;

namespace {

constexpr int kTick_ms = 10, kComets = 12, kInk = 255, kPull = 45'776;

// 65,536ths of a pixel, and of a pixel a tick.
struct Comet {
    std::int64_t x = 0, y = 0, right = 0, up = 0;

    void tick() {
        const std::int64_t distance_256 = integer_root(static_cast<std::uint64_t>(x * x + y * y)) >> 8,
                           cubed = distance_256 * distance_256 * distance_256 >> 16;
        right -= x * kPull / cubed;
        up -= y * kPull / cubed;
        x += right;
        y += up;
    }
};

std::array<Comet, kComets> comets_at_start() {
    std::array<Comet, kComets> comets;
    std::uint64_t seed = 5;
    for (int i = 0; i < kComets; ++i) {
        const std::int64_t far = 40 + 9 * i, speed_256 = (1400 + random_below(600, seed)) / (4 + i / 3),
                           turn_256 = random_below(360 * 256, seed);
        const std::int64_t sine = sine_65536(turn_256), cosine = sine_65536(turn_256 + 90 * 256);
        comets[static_cast<std::size_t>(i)] = {cosine * far, sine * far, -sine * speed_256 / 256,
                                               cosine * speed_256 / 256};
    }
    return comets;
}

// Its head is in the middle.
Picture make_comet() {
    Picture comet = Picture::of_size(49, 9);
    clear(comet.canvas(), kTransparent);
    for (int x = 24; x < 49; ++x)
        fill_rectangle(comet.canvas(), x, 4 - (48 - x) / 10, 1, 1 + (48 - x) / 10 * 2, 250 - x / 2);
    fill_circle(comet.canvas(), {}, 24, 4, 2, 254);
    return comet;
}

}  // namespace

int main() try {
    Window window("Tick");
    const Picture picture = make_comet();
    auto comets = comets_at_start(), before = comets;
    std::int64_t ticked_ms = 0;
    do {
        if (window.was_pressed("1")) window.set_rate(10);
        if (window.was_pressed("2")) window.set_rate(0);
        for (; ticked_ms < window.time_ms(); ticked_ms += kTick_ms) {
            before = comets;
            for (Comet& comet : comets) comet.tick();
        }
        const std::int64_t late_ms = ticked_ms - window.time_ms();  // of the last tick: 0 to less than kTick_ms
        const Framebuffer canvas = window.canvas();
        clear(canvas);
        fill_circle(canvas, window.mode(), 160, 100, 8, 212);
        for (std::size_t i = 0; i < kComets; ++i) {
            const std::int64_t x = comets[i].x + (before[i].x - comets[i].x) * late_ms / kTick_ms,
                               y = comets[i].y + (before[i].y - comets[i].y) * late_ms / kTick_ms;
            draw_turned(canvas, picture, 160 + static_cast<int>(x >> 16), 100 - static_cast<int>(y * 5 / 6 >> 16),
                        direction_256(x, y));
        }
        draw_label(canvas, 6, 188, "1 2: pictures a second; ticks " + std::to_string(ticked_ms / kTick_ms), kInk);
    } while (window.show());
} catch (const std::exception& error) {
    return report(error);
}
