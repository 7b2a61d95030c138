// A recorded demo, played back and hashed. Each picture is a tick of 1/70 second and depends only on the moves before
// it, so that the same moves give the same pictures on every machine. Their checksums are printed; one different pixel
// changes one, and so does another accuracy: 1991, 1994, 1996, pixel, bounded or exact.
//
// Usage: example_demo [ASSETS [ACCURACY]]
#include <oblong.h>

#include <cstdio>

using namespace oblong;

namespace {

constexpr std::int64_t kRate_hz = 70, kTicksALetter = 15, kHashedTicks = 50;
// The keys held, a letter for 15 ticks: w ahead, l and r to turn left and right.
constexpr std::string_view kMoves = "wwwwwwwwwwwwwrrrrwwwwwwwwwwwww";

Pose after_move(const LevelScene& level, Pose eye, char move) {
    if (move == 'l') eye.yaw_256 += 384;
    if (move == 'r') eye.yaw_256 -= 384;
    return level.walked(eye, moved(eye, move == 'w' ? 4 * 256 : 0, 0, -4 * 256));
}

}  // namespace

int main(int argc, char** argv) try {
    const std::string assets = argc > 1 ? argv[1] : "build/assets";
    std::printf("Oblong %s\n", version());
    Window window("Demo");
    LevelScene level(assets + "/demo.bsp", load_palette(assets + "/palette.lmp"), window.mode());
    if (argc > 2) level.set_accuracy(argv[2]);
    Pose eye = level.start();
    std::int64_t tick = 0;
    do {
        const std::int64_t time_ms = tick * 1000 / kRate_hz;
        level.draw(eye, time_ms, window.canvas());
        window.palette = level.palette_at(eye, time_ms);
        if (tick % kHashedTicks == 0) std::printf("%4d %08x\n", static_cast<int>(tick), checksum(window.canvas()));
        const auto letter = static_cast<std::size_t>(tick++ / kTicksALetter);
        if (letter < kMoves.size())
            eye = after_move(level, eye, kMoves[letter]);
        else
            window.close();
    } while (window.show());
} catch (const std::exception& error) {
    return report(error);
}
