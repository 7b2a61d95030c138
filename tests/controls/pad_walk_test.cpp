#include <SDL.h>
#include <gtest/gtest.h>

#include "engine/files/files.h"
#include "engine/level/bsp_read.h"
#include "engine/platform/sdl/input.h"
#include "game/input/input_mapper.h"
#include "game/input/tick_input_source.h"
#include "game/simulation/step.h"
#include "tests/controls/pad_pilot.h"
#include "tests/support/folders.h"

namespace oblong {
namespace {

// Whoever has nothing but a gamepad gets through the demo level: the recorded walk, made of a pad's events.
TEST(PadWalk, TheWholeWalkOfTheDemoLevelIsPlayedByAGamepadAlone) {
    SDL_SetHint(SDL_HINT_VIDEODRIVER, "dummy");
    SDL_SetHint(SDL_HINT_JOYSTICK_ALLOW_BACKGROUND_EVENTS, "1");
    ASSERT_EQ(SDL_Init(SDL_INIT_VIDEO), 0) << SDL_GetError();
    SDL_Window* window = SDL_CreateWindow("test", 0, 0, 640, 480, 0);
    {
        const Level level = read_bsp(read_file(test::build_folder() + "/assets/demo.bsp"));
        const GameLevel game_level = make_game_level(level);
        const Demo walk = decode_demo(read_file(test::build_folder() + "/assets/walk.demo"));
        SdlInput input(window);
        test::VirtualPad pad;
        test::PadPilot pilot(pad);
        const Bindings bindings = default_bindings();
        InputMapper mapper(bindings);
        mapper.take(input.poll(), 0);
        LiveInput live;
        GameState state = start_of(game_level);
        for (const DemoTick& tick : walk.ticks) {
            pilot.steer(tick.input);
            live.gather(mapper.take(input.poll(), SDL_GetTicks64()));
            const TickInput played = live.next();
            ASSERT_EQ(played, tick.input) << "tick " << state.tick << ": " << int{played.forward} << ' '
                                          << int{played.right} << ' ' << played.yaw << ' ' << played.pitch;
            step(game_level, state, played);
        }
        EXPECT_EQ(hash_of(state), walk.ticks.back().state_hash);
        EXPECT_TRUE(state.has_ended);
    }
    SDL_DestroyWindow(window);
    SDL_Quit();
}

}  // namespace
}  // namespace oblong
