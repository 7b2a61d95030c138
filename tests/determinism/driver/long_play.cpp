// Plays a level for long with inputs by chance, without a window, and prints the hash of the state and of a picture
// after every 10,000th tick, a line each: the same in every build.
//   long_play PALETTE LEVEL.bsp TICKS
// Every other minute the player comes in at another item. A level that ends begins again. Fails where walking and
// jumping do not move the player for half a minute, or where the heap grows.
#include <algorithm>
#include <cinttypes>
#include <cstdio>
#ifdef __GLIBC__
#include <malloc.h>
#endif

#include "engine/base/checksum.h"
#include "engine/frame/frame.h"
#include "engine/frame/workspace.h"
#include "engine/io/files.h"
#include "engine/level/bsp_read.h"
#include "engine/programs/arguments.h"
#include "engine/scene/placed_models.h"
#include "game/simulation/collision.h"
#include "game/simulation/step.h"

namespace {

using namespace oblong;

constexpr std::int64_t kMinute = 60 * kTicksPerSecond;
constexpr std::int64_t kReportTicks = 10'000;
constexpr std::int64_t kHeldTicks = kMinute / 2;
constexpr std::int64_t kHeldUnits = 8;  ///< along each axis
constexpr std::int64_t kMostGrowth = 64 * 1024;

/// xorshift: the same numbers with every library.
struct Chance {
    std::uint64_t state = 0x9e3779b97f4a7c15;

    int below(int end) {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        return static_cast<int>((state >> 33) % static_cast<std::uint64_t>(end));
    }
};

/// Walks for up to three seconds, mostly ahead, turning as it goes; then some other way.
class Walker {
  public:
    TickInput next(Chance& chance) {
        if (left_-- == 0) turn(chance);
        TickInput input = input_;
        if (chance.below(20) == 0) input.buttons = kJumpButton;
        return input;
    }

  private:
    void turn(Chance& chance) {
        left_ = 10 + chance.below(3 * static_cast<int>(kTicksPerSecond));
        input_.forward = static_cast<std::int8_t>(chance.below(4) == 0 ? chance.below(255) - 127 : 127);
        input_.right = static_cast<std::int8_t>(chance.below(3) == 0 ? chance.below(255) - 127 : 0);
        input_.yaw = static_cast<std::int16_t>(chance.below(2001) - 1000);
        input_.pitch = static_cast<std::int16_t>(chance.below(401) - 200);
    }

    TickInput input_;
    int left_ = 0;
};

/// How long the player has been within kHeldUnits of a place.
class Whereabouts {
  public:
    bool is_held(const Position& at, std::int64_t tick) {
        const auto is_far = [](World a, World b) {
            return std::abs(std::int64_t{a.raw} - b.raw) > World::from_int(kHeldUnits).raw;
        };
        if (is_far(at.x, place_.x) || is_far(at.y, place_.y) || is_far(at.z, place_.z)) {
            place_ = at;
            since_ = tick;
        }
        return tick - since_ > kHeldTicks;
    }

  private:
    Position place_;
    std::int64_t since_ = 0;
};

std::string place_text(const Position& at) {
    const auto units = [](World w) { return std::to_string(w.raw / World::from_int(1).raw); };
    return units(at.x) + " " + units(at.y) + " " + units(at.z);
}

/// Bytes that are allocated; 0 where the library does not tell.
std::int64_t heap_bytes() {
#ifdef __GLIBC__
    const struct mallinfo2 info = mallinfo2();
    return static_cast<std::int64_t>(info.uordblks + info.hblkhd);
#else
    return 0;
#endif
}

class Painter {
  public:
    Painter(const Level& level, const Colormap& colormap) : level_(level), colormap_(colormap), pixels_(320 * 200) {}

    std::uint64_t picture_hash(const GameLevel& game, const GameState& state) {
        std::vector<PlacedModel> models = models_at_rest(level_);
        for (PlacedModel& placed : models)
            for (std::size_t i = 0; i < game.movers.size(); ++i)
                if (game.movers[i].model == placed.model) placed.offset = offset_of(game.movers[i], state.movers[i]);
        Camera camera;
        camera.eye = state.player.position;
        camera.eye.z += World::from_int(kEyeHeight);
        camera.yaw = state.player.yaw;
        camera.pitch = Angle::from_bam(state.player.pitch);
        const Scene scene{level_, colormap_, models, state.tick * 1000 / kTicksPerSecond};
        FrameWorkspace work(level_, mode_);  // anew: one that is kept has room for the most that it has drawn
        draw_frame(scene, camera, mode_, {}, work, {pixels_.data(), mode_.width_px, mode_.height_px, mode_.width_px});
        return fnv1a_of(pixels_);
    }

  private:
    const Level& level_;
    const Colormap& colormap_;
    ScreenMode mode_{320, 200};
    std::vector<std::uint8_t> pixels_;
};

/// Where the player comes in next: at an item, if there is room.
void move_respawn(const GameLevel& level, GameState& state, Chance& chance) {
    if (level.items.empty()) return;
    const Item& item = level.items[static_cast<std::size_t>(chance.below(static_cast<int>(level.items.size())))];
    const Position at = free_place_near(level, item.position);
    if (is_free(level, state, at)) state.progress.respawn.position = at;
}

void play(const std::string& palette_path, const std::string& level_path, std::int64_t ticks) {
    const Level bsp = read_parsed(level_path, read_bsp);
    const GameLevel level = make_game_level(bsp);
    const Colormap colormap = make_colormap(read_parsed(palette_path, read_palette));
    Painter painter(bsp, colormap);
    GameState state = start_of(level);
    Chance chance;
    Walker walker;
    Whereabouts whereabouts;
    std::int64_t ends = 0, early_heap = 0;
    for (std::int64_t tick = 1; tick <= ticks; ++tick) {
        TickInput input = walker.next(chance);
        if (tick % (2 * kMinute) == 0) {
            move_respawn(level, state, chance);
            input.buttons = kRespawnButton;
        }
        step(level, state, input);
        if (whereabouts.is_held(state.player.position, tick))
            throw FileError(level_path, "tick " + std::to_string(tick),
                            "the player is held at " + place_text(state.player.position) + ", expected a way to walk");
        if (state.has_ended) {
            state = start_of(level);
            ++ends;
        }
        if (tick % kReportTicks != 0) continue;
        std::printf("%" PRId64 " %016" PRIx64 " %016" PRIx64 "\n", tick, hash_of(state),
                    painter.picture_hash(level, state));
        if (tick <= ticks / 2) early_heap = std::max(early_heap, heap_bytes());
    }
    std::fprintf(stderr,
                 "%s: %" PRId64 " ticks, ended %" PRId64 " times, heap %" PRId64 " bytes in the first half, %" PRId64
                 " now\n",
                 level_path.c_str(), ticks, ends, early_heap, heap_bytes());
    if (heap_bytes() > early_heap + kMostGrowth) throw FileError(level_path, "heap", "it grows");
}

}  // namespace

int main(int argc, char** argv) {
    return run_program("long_play", [&] {
        if (argc != 4) throw UsageError("expected PALETTE LEVEL.bsp TICKS");
        play(argv[1], argv[2], std::stoll(argv[3]));
    });
}
