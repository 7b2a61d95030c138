// The plan of every camera of the real levels, against what a record of each pixel says; and of the demo level from the
// places of its cameras, in 72 directions each: what owns no pixel is hardly worked for.

#include <algorithm>
#include <set>

#include "engine/frame/frame_record.h"
#include "engine/frame/passes.h"
#include "engine/level/bsp_read.h"
#include "engine/models/level_models.h"
#include "engine/surface/palette.h"
#include "engine/visibility/eye.h"
#include "tests/effect_frames/effect_stage.h"
#include "tests/frame/frame_fixture.h"
#include "tests/support/folders.h"
#include "tools/gallery/mesh_scene.h"
#include "tools/render/camera_list.h"

namespace oblong::test::plan_test {
namespace {

/// Whether Quake gives one of a face's light styles a pattern.
bool flickers(const Face& face) {
    return face.light_offset >= 0 && std::any_of(face.styles.begin(), face.styles.end(),
                                                 [](std::uint8_t style) { return style >= 1 && style <= 11; });
}

/// Whether the level has frames 0, 1 ... of this texture's name without a gap; with one it stands still.
bool is_animated(const std::string& name, const Level& level) {
    std::set<char> frames;
    if (!name.starts_with("+")) return false;
    for (const MipTexture& texture : level.textures)
        if (texture.name.starts_with("+") && texture.name.substr(2) == name.substr(2)) frames.insert(texture.name[1]);
    const auto count = static_cast<int>(frames.size());
    return count > 1 && *frames.begin() == '0' && *frames.rbegin() == '0' + count - 1;
}

/// The effects of the faces that own pixels. The real levels call for no fence, fog, thing or mirror.
EffectSet shown_effects(const EffectStage& stage) {
    EffectSet effects;
    const FaceIndex* last = nullptr;
    for (const PixelRecord& pixel : stage.work.record.pixels) {
        if (pixel.face.is_none()) continue;
        if (!pixel.model.is_none()) effects = effects.with(Effect::BrushModels);
        if (last && *last == pixel.face) continue;
        last = &pixel.face;
        const Face& face = stage.level.faces[pixel.face];
        const std::string& name = stage.level.texture_of(face).name;
        if (name.starts_with("sky")) effects = effects.with(Effect::Sky);
        if (name.starts_with("*")) effects = effects.with(Effect::Liquid);
        if (is_animated(name, stage.level)) effects = effects.with(Effect::AnimatedTextures);
        if (!name.starts_with("sky") && !name.starts_with("*") && flickers(face))
            effects = effects.with(Effect::Styles);
    }
    const std::int32_t contents = stage.level.leaves[place_eye(stage.level, stage.camera.eye).leaf].contents;
    const bool is_liquid = contents <= contents::kWater && contents >= contents::kLava;
    return is_liquid ? effects.with(Effect::Underwater) : effects;
}

/// The passes of those effects, in order.
std::vector<std::string_view> passes_of(EffectSet effects, bool has_walls) {
    std::vector<std::string_view> passes;
    if (has_walls) passes.push_back("walls");
    if (effects.has(Effect::Liquid)) passes.push_back("liquid");
    if (effects.has(Effect::Sky)) passes.push_back("sky");
    if (effects.has(Effect::Underwater)) passes.push_back("underwater");
    return passes;
}

std::vector<std::string_view> names_of(const FramePlan& plan) {
    std::vector<std::string_view> names;
    for (std::size_t i = 0; i < kPassCount; ++i)
        if (plan.passes[i]) names.push_back(kPasses[i].name);
    return names;
}

bool shows_wall(const EffectStage& stage) {
    const auto& pixels = stage.work.record.pixels;
    return std::any_of(pixels.begin(), pixels.end(), [&](const PixelRecord& pixel) {
        if (pixel.face.is_none()) return false;
        const std::string& name = stage.level.texture_of(stage.level.faces[pixel.face]).name;
        return !name.starts_with("sky") && !name.starts_with("*");
    });
}

/// Calls check(stage, name) for every camera of the real levels.
template <class Check>
void for_each_camera(Check check) {
    const Palette palette = read_palette(read_shared_file("gfx/palette.lmp"));
    for (const std::string name : kRealLevels) {
        EffectStage stage(read_bsp(read_shared_file(name + ".bsp")), {}, make_colormap(palette));
        for (const Camera& camera :
             parse_cameras(read_shared_file("cameras/" + name + ".csv"), Degrees::from_int(90))) {
            stage.camera = camera;
            stage.settings.allowed_effects = EffectSet::all();
            ASSERT_NO_FATAL_FAILURE(check(stage, name));
        }
    }
}

TEST(PlanOfRealLevels, HardCaseP5_HoldsTheEffectsThatOwnPixelsAndNothingElseInEveryFrame) {
    OBLONG_NEEDS_SHARED_LEVELS();
    int frames = 0, empty = 0;
    for_each_camera([&](EffectStage& stage, const std::string& name) {
        stage.draw(1'234);
        const EffectSet shown = shown_effects(stage);
        ASSERT_EQ(stage.work.plan.effects, shown) << name << " " << frames;
        ASSERT_EQ(names_of(stage.work.plan), passes_of(shown, shows_wall(stage))) << name << " " << frames;
        for (std::size_t i = 0; i < kEffectCount; ++i) {
            const auto effect = static_cast<Effect>(i);
            ASSERT_EQ(stage.pixels(effect) > 0, shown.has(effect)) << name << " " << frames << " " << i;
        }
        ++frames;
        empty += shown == EffectSet{};
    });
    EXPECT_GT(frames, 2'000);
    EXPECT_GT(empty, 100);
    RecordProperty("frames", frames);
    RecordProperty("frames_with_an_empty_plan", empty);
}

TEST(PlanOfRealLevels, GivesTheSamePictureByItsEffectsAlone) {
    OBLONG_NEEDS_SHARED_LEVELS();
    for_each_camera([](EffectStage& stage, const std::string& name) {
        const Picture all = stage.draw(1'234);
        stage.settings.allowed_effects = stage.work.plan.effects;
        ASSERT_EQ(changed_pixels(stage.draw(1'234), all), 0) << name;
    });
}

constexpr int kDirections = 72;

/// What frames did for effects that own no pixel of them, in all.
struct InVain {
    int frames = 0, with_particles = 0, with_depth = 0;
    std::int64_t particles = 0;
};

class DemoAllAround : public testing::Test {
  protected:
    void draw(Camera camera, int direction) {
        camera.yaw = Angle::from_bam(direction * 65536 / kDirections);
        Scene scene = stage_.scene();
        scene.meshes = meshes_;
        draw_frame(scene, camera, stage_.mode, stage_.settings, work_, {stage_.pixels.data(), 320, 200, 320});
    }
    /// Draws all places and every so manieth direction, and calls `check()` for each.
    template <class Check>
    void for_each_view(int step, Check check) {
        place_models(models_, 0, {}, meshes_);
        for (std::size_t place = 0; place < cameras_.size(); ++place)
            for (int direction = 0; direction < kDirections; direction += step) {
                SCOPED_TRACE("camera " + std::to_string(place) + ", direction " + std::to_string(direction));
                work_.count();
                draw(cameras_[place], direction);
                check([&] { draw(cameras_[place], direction); });
            }
    }
    void expect_that_passes_have_pixels() const {
        for (std::size_t i = 0; i < kPassCount; ++i)
            EXPECT_EQ(work_.plan.passes[i], work_.counts.pass_pixels[i] > 0) << kPasses[i].name;
    }
    void add_what_was_in_vain(InVain& sum) const {
        const FrameCounts& counts = work_.counts;
        const bool has_particles = counts.of(Effect::Particles) > 0;
        const bool has_depth = has_particles || counts.of(Effect::Sprites) > 0 || counts.of(Effect::Meshes) > 0;
        ++sum.frames;
        sum.with_particles += !has_particles && counts.stages.particles > 0;
        sum.particles += has_particles ? 0 : counts.stages.particles;
        sum.with_depth += !has_depth && work_.view.depth.is_wanted();
    }

    Stage stage_ = demo_stage();
    LevelModels models_ =
        read_level_models(stage_.level, read_palette(read_file_bytes(build_folder() + "/assets/palette.lmp")),
                          {build_folder() + "/assets/demo.bsp", ""});
    std::vector<Camera> cameras_ = parse_cameras(
        read_file_bytes(source_folder() + std::string("/assets/demo_cameras.csv")), Degrees::from_int(90));
    std::vector<PlacedMesh> meshes_;
    ObservedWorkspace work_{stage_.level, stage_.mode};
};

TEST_F(DemoAllAround, NoPassRunsWithoutPixelsAndLittleIsDoneInVain) {
    InVain sum;
    for_each_view(1, [&](auto) {
        expect_that_passes_have_pixels();
        add_what_was_in_vain(sum);
    });
    EXPECT_EQ(sum.frames, 39 * kDirections);
    EXPECT_LE(sum.with_particles, 122);
    EXPECT_LE(sum.particles, 4'157);
    EXPECT_LE(sum.with_depth, 4);
}

/// As mappers of the time kept r_speeds: the level's aim is 120 and 350.
TEST_F(DemoAllAround, ShowsFewFaces) {
    std::vector<std::int64_t> drawn;
    for_each_view(4, [&](auto) { drawn.push_back(work_.counts.faces_drawn); });
    std::sort(drawn.begin(), drawn.end());
    EXPECT_LE(drawn[drawn.size() / 2], 60);
    EXPECT_LE(drawn[drawn.size() * 99 / 100], 350);
    EXPECT_LE(drawn.back(), 410) << "from the balcony, over the whole courtyard";
}

TEST_F(DemoAllAround, ThePlansEffectsAloneGiveTheSamePicture) {
    int mirrored = 0;
    for_each_view(8, [&](auto draw_again) {
        const Picture all = stage_.pixels;
        stage_.settings.allowed_effects = work_.plan.effects;
        mirrored += work_.plan.effects.has(Effect::Mirror);
        draw_again();
        stage_.settings.allowed_effects = EffectSet::all();
        EXPECT_EQ(changed_pixels(stage_.pixels, all), 0);
    });
    EXPECT_GT(mirrored, 10);
}

/// A clock by which whatever is timed takes time; steps grow, as what is sampled leaves out the time to read the clock.
std::int64_t growing_ns() {
    static std::int64_t now_ns = 0, step_ns = 0;
    return now_ns += ++step_ns;
}

TEST_F(DemoAllAround, EachListedEffectHasPixelsAndTime) {
    EffectSet listed;
    PassTimes times{growing_ns};
    work_.observers.times = &times;
    for_each_view(8, [&](auto) {
        listed = listed | work_.plan.effects;
        for (std::size_t i = 0; i < kEffectCount; ++i) {
            const auto effect = static_cast<Effect>(i);
            if (!work_.plan.effects.has(effect)) continue;
            const std::size_t pass = pass_of(effect);
            EXPECT_GT(work_.counts.of(effect), 0) << kEffectNames[i];
            EXPECT_GT(times.effects_ns[i] + (pass < kPassCount ? times.passes_ns[pass] : 0), 0) << kEffectNames[i];
        }
    });
    EXPECT_EQ(listed, EffectSet::all());
}

/// A view in which only one thing calls for an effect, and no wall.
struct LoneCall {
    std::string name;
    Effect effect;
    MapText text;
    Camera camera;
    bool shows_ball = false, has_torch = false;
};

/// Below a sky without fog, which alone the camera sees.
LoneCall under_sky(const std::string& name, const std::string& entities, bool shows_ball = false) {
    MapText text = room_with(box({-256, -256, 176}, {256, 256, 192}, "sky"), entities);
    text.world_keys = {{"fog", "0.5 0.9 0.9 0.9"}, {"skyfog", "0"}};
    return {name, Effect::Fog, text, camera_at(point_at(-40, 0, 4), 0, -78), shows_ball};
}

const std::vector<LoneCall>& lone_calls() {
    static const std::vector<LoneCall> calls = [] {
        const MapText dim = room_with("", entity_at("light", {0, 0, 16}, {{"light", "60"}, {"style", "10"}}));
        const std::string lamp = entity_at("misc_sprite", {0, 0, 100}, {{"texture", "{lamp"}, {"scale", "2"}});
        const std::string behind = entity_at("misc_sprite", {-200, 30, 90}, {{"texture", "{lamp"}, {"scale", "2"}});
        const std::string mirror = entity("func_wall", {}, box({248, -100, 30}, {254, 100, 160}, "mirror"));
        const Camera up = camera_at(point_at(-100, 0, 64), 0, -20);
        return std::vector<LoneCall>{
            {"a sprite in a mirror", Effect::Sprites, room_with("", mirror + behind), camera_at(point_at(0, 3, 90), 0)},
            {"a model over a flickering floor", Effect::Styles, dim, up, true},
            {"a model in a torch's light", Effect::Lights,
             room_with("", entity_at("light", {0, 0, 120}, {{"light", "60"}})), up, true, true},
            under_sky("a sprite in fog", lamp),
            under_sky("bars in fog", entity("func_wall", {}, box({-60, -60, 100}, {60, 60, 104}, "{bars"))),
            under_sky("a model in fog", "", true)};
    }();
    return calls;
}

TEST(Plan, HoldsWhatOneThingAloneCallsFor) {
    const Mesh ball = ball_mesh(20, 8, plain_skin(60));
    for (const LoneCall& call : lone_calls()) {
        SCOPED_TRACE(call.name);
        const bool is_light = call.effect == Effect::Styles || call.effect == Effect::Lights;
        EffectStage stage(call.text, call.camera, is_light ? shades_as_colours() : effect_colours());
        if (call.has_torch) stage.moving_lights = {{point_at(-40, 0, 110), World::from_int(60), 256}};
        if (call.shows_ball) {
            stage.meshes.emplace_back().mesh = &ball;
            stage.meshes[0].position = point_at(0, 0, 100);
        }
        const Picture all = stage.draw(200);
        EXPECT_TRUE(stage.has(call.effect));
        const std::int64_t owned = stage.pixels(call.effect);
        stage.settings.allowed_effects = stage.work.plan.effects;
        EXPECT_EQ(changed_pixels(stage.draw(200), all), 0);
        const std::int64_t changed = changed_pixels(stage.draw_without(call.effect, 200), all);
        EXPECT_GT(changed, 0) << "the view does not call for the effect";
        EXPECT_LE(changed, owned);
    }
}

}  // namespace
}  // namespace oblong::test::plan_test
