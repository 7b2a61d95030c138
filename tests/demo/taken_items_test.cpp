#include <gtest/gtest.h>

#include <algorithm>

#include "game/level/load.h"
#include "game/view/game_renderer.h"
#include "tests/support/folders.h"

namespace oblong {
namespace {

/// In the dust room the lens is the only model.
TEST(TakenItems, AreNoPartOfThePictureOrOfItsCost) {
    const GameData data = load_game({"", "", test::build_folder() + "/assets", ""});
    const GameLevel level = make_game_level(data.level);
    GameRenderer renderer(data, level, ScreenMode{});
    GameState state = start_of(level);
    const auto draws_models = [&] {
        const InterpolatedState both{state, state};
        Camera camera;
        camera.eye = world_vector(470, 144, 60);
        camera.yaw = kHalfTurn;
        camera.field_of_view = Degrees::from_int(90);
        renderer.draw({both, camera}, Settings{});
        return renderer.plan().has("models");
    };
    EXPECT_TRUE(draws_models());
    std::ranges::fill(state.items, ItemState::Taken);
    EXPECT_FALSE(draws_models());
}

}  // namespace
}  // namespace oblong
