// The plan of every camera of the real levels, against what a record of each pixel says.

#include <algorithm>
#include <set>

#include "engine/level/bsp_read.h"
#include "engine/visibility/eye.h"
#include "tests/effect_frames/effect_stage.h"
#include "tests/support/folders.h"
#include "tools/render/camera_list.h"

namespace oblong::test {
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

TEST(PlanOfRealLevels, HardCaseP5_HoldsTheEffectsThatOwnPixelsAndNothingElseInEveryFrame) {
    OBLONG_NEEDS_SHARED_LEVELS();
    int frames = 0, empty = 0;
    for (const std::string name : kRealLevels) {
        const Palette palette = read_palette(read_shared_file("gfx/palette.lmp"));
        EffectStage stage(read_bsp(read_shared_file(name + ".bsp")), {}, make_colormap(palette));
        for (const Camera& camera :
             parse_cameras(read_shared_file("cameras/" + name + ".csv"), Degrees::from_int(90))) {
            stage.camera = camera;
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
        }
    }
    EXPECT_GT(frames, 2'000);
    EXPECT_GT(empty, 100);
    RecordProperty("frames", frames);
    RecordProperty("frames_with_an_empty_plan", empty);
}

}  // namespace
}  // namespace oblong::test
