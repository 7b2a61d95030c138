#include "tests/fuzz/common/played_level.h"

#include <algorithm>
#include <map>
#include <memory>

#include "engine/base/little_endian.h"
#include "engine/frame/frame.h"
#include "engine/frame/frame_counts.h"
#include "engine/frame/workspace.h"
#include "engine/io/files.h"
#include "engine/level/bsp_read.h"
#include "game/saves/saved_game.h"
#include "game/simulation/game_level.h"
#include "game/simulation/step.h"
#include "tests/map/map_source.h"
#include "tests/support/folders.h"
#include "tests/support/palettes.h"

namespace oblong::fuzz {
namespace {

constexpr std::int32_t kWidth = 64, kHeight = 40;

const Colormap& colours() {
    static const Colormap all = make_colormap(greys());
    return all;
}

std::vector<PlacedModel> placed_models(const GameLevel& level, const GameState& state) {
    std::vector<PlacedModel> models = models_at_rest(*level.bsp);
    for (PlacedModel& placed : models)
        for (std::size_t i = 0; i < level.movers.size(); ++i)
            if (level.movers[i].model == placed.model) placed.offset = offset_of(level.movers[i], state.movers[i]);
    return models;
}

Camera eye_of(const GameState& state) {
    Camera camera;
    camera.eye = state.player.position;
    camera.eye.z += World::from_int(kEyeHeight);
    camera.yaw = state.player.yaw;
    camera.pitch = Angle::from_bam(state.player.pitch);
    return camera;
}

// Counting must change nothing, nor what the picture before has left.
void draw_twice(const Scene& scene, const Camera& camera, FrameWorkspace& work) {
    const ScreenMode mode{kWidth, kHeight};
    std::vector<std::uint8_t> counted(kWidth * kHeight, 0x5a), plain(kWidth * kHeight, 0xa5);
    FrameCounts counts;
    work.observers.counts = &counts;
    draw_frame(scene, camera, mode, {}, work, {counted.data(), kWidth, kHeight, kWidth});
    const bool is_once =
        std::all_of(counts.writes.begin(), counts.writes.end(), [](std::uint8_t writes) { return writes <= 1; });
    expect(is_once, "every pixel of one face at most");
    work.observers.counts = nullptr;
    draw_frame(scene, camera, mode, {}, work, {plain.data(), kWidth, kHeight, kWidth});
    expect(counted == plain, "the same picture when it is drawn again");
}

// Blends take longer to make than all that is drawn by them, and depend on the share alone: those of one input are
// handed to the next.
void exchange_blends(std::map<std::int32_t, std::unique_ptr<BlendTable>>& of_share, LevelCache& cache) {
    for (FaceBlend& blend : cache.blends) std::swap(of_share[blend.alpha_256], blend.table);
}

}  // namespace

const Palette& greys() {
    static const Palette all = test::grey_palette();
    return all;
}

void check_state(const GameLevel& level, const GameState& state) {
    const std::string error = find_inconsistency(level, state);
    expect(error.empty(), "a state that a save may hold, not " + error);
    Bytes bytes;
    append_state(bytes, state);
    LittleEndianReader reader(bytes);
    const GameState read = read_state(reader);
    expect(read == state && hash_of(read) == hash_of(state), "the state that was saved");
}

void play(const GameLevel& level, GameState& state, int ticks, std::uint64_t seed) {
    std::minstd_rand random(static_cast<std::uint32_t>(seed | 1));
    TickInput input;
    for (int tick = 0; tick < ticks; ++tick) {
        if (tick % 8 == 0)
            input = {static_cast<std::int8_t>(below(255, random)), static_cast<std::int8_t>(below(255, random)),
                     static_cast<std::int16_t>(random() % 2048), static_cast<std::int16_t>(random() % 256),
                     static_cast<std::uint8_t>(below(8, random) % 4)};
        input.forward = std::max<std::int8_t>(input.forward, -127);
        input.right = std::max<std::int8_t>(input.right, -127);
        step(level, state, input);
    }
}

void play_and_draw(const Level& bsp, std::uint64_t seed) {
    const GameLevel level = make_game_level(bsp);
    GameState state = start_of(level);
    FrameWorkspace work(bsp, {kWidth, kHeight});
    static std::map<std::int32_t, std::unique_ptr<BlendTable>> blends;
    exchange_blends(blends, work.cache);
    for (const int ticks : {0, 24}) {
        play(level, state, ticks, seed);
        check_state(level, state);
        const std::vector<PlacedModel> models = placed_models(level, state);
        Scene scene{bsp, colours(), models};
        scene.time_ms = state.tick * 1000 / kTicksPerSecond;
        draw_twice(scene, eye_of(state), work);
    }
    exchange_blends(blends, work.cache);
}

const Level& stage_level() {
    static const Level level = [] {
        const std::string text = read_text(test::source_folder() + "/tests/fuzz/corpus/maps/stage.map");
        const std::string bytes = map::to_bytes(test::compile(text, {true}));
        return read_bsp({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
    }();
    return level;
}

void draw_in_stage(const Mesh& mesh, std::uint64_t seed) {
    static const GameLevel level = make_game_level(stage_level());
    static FrameWorkspace work(stage_level(), {kWidth, kHeight});
    static const std::vector<PlacedModel> models = models_at_rest(stage_level());
    std::minstd_rand random(static_cast<std::uint32_t>(seed | 1));
    PlacedMesh placed;
    placed.mesh = &mesh;
    placed.frame = static_cast<std::uint32_t>(below(4, random));
    placed.next_frame = static_cast<std::uint32_t>(below(4, random));
    placed.blend_256 = static_cast<std::int32_t>(below(257, random));
    placed.yaw = Angle::from_bam(static_cast<std::int64_t>(random()));
    placed.shading = static_cast<Shading>(below(3, random));
    const Camera camera = eye_of(start_of(level));
    placed.position = camera.eye + Vec3<World>{World::from_int(40), World::from_int(0), World::from_int(0)};
    Scene scene{stage_level(), colours(), models};
    scene.meshes = {&placed, 1};
    draw_twice(scene, camera, work);
}

}  // namespace oblong::fuzz
