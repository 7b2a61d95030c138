#include <cstdio>
#include <filesystem>
#include <string>

#include "engine/files/files.h"
#include "engine/files/picture.h"
#include "engine/platform/headless.h"
#include "engine/view/screen.h"
#include "game/input/actions.h"
#include "game/program/program.h"
#include "game/simulation/tick.h"

namespace oblong {
namespace {

namespace fs = std::filesystem;

// Writes 00000.png, 00001.png and so on into a folder.
HeadlessPlatform::FrameSink png_sink(const std::string& folder) {
    make_folder(folder);
    return [folder, frame = 0](Framebuffer picture, const Palette& palette) mutable {
        char name[16];
        std::snprintf(name, sizeof name, "%05d.png", frame++);
        const std::size_t size = pixel_count(picture.width_px, picture.height_px);
        write_file((fs::path(folder) / name).string(),
                   encode_indexed_png({picture.pixels, size}, picture.width_px, picture.height_px, palette));
    };
}

void hold(Action action, bool is_held, PlatformInput& input) {
    input.events.push_back({is_held ? InputEvent::Kind::Press : InputEvent::Kind::Release, scripted(action), 0, 0});
}

// The input of --headless without a demo, in ticks: 2.5 s ahead, a quarter turn to the right, 4 s ahead with a jump, a
// turn to the left.
PlatformInput short_walk(std::int64_t tick) {
    constexpr std::int64_t kTurn = 87, kAhead = 110, kJump = 130, kLook = 250, kRound = 280;
    const std::int64_t at = tick % kRound;
    PlatformInput input;
    hold(Action::Forward, at < kTurn || (at >= kAhead && at < kLook), input);
    hold(Action::TurnRight, at >= kTurn && at < kAhead, input);
    hold(Action::TurnLeft, at >= kLook, input);
    hold(Action::Jump, at == kJump, input);
    return input;
}

// The input of --headless --gallery: a row a picture.
PlatformInput page_through(std::int64_t poll) {
    PlatformInput input;
    if (poll > 0)
        for (const bool is_held : {true, false}) hold(Action::PageDown, is_held, input);
    return input;
}

}  // namespace

std::unique_ptr<Platform> open_headless(const Options& options) {
    const auto script = [&options](std::int64_t poll) {
        if (options.shows_gallery) return page_through(poll);
        return options.replay.empty() ? short_walk(poll) : PlatformInput{};
    };
    return std::make_unique<HeadlessPlatform>(options.headless_frames, kTicksPerSecond, script, png_sink(options.out));
}

}  // namespace oblong
