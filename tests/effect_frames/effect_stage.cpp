#include "tests/effect_frames/effect_stage.h"

#include <algorithm>
#include <stdexcept>

#include "engine/frame/passes.h"
#include "tests/support/palettes.h"
#include "tools/map/compile.h"

namespace oblong::test {

namespace {

const std::vector<StripedTexture>& textures() {
    static const std::vector<StripedTexture> all = {
        {"wall", kWall, kWall},          {"floor", kFloor, kFloor},
        {"other", kOther, kOther},       {"*water", kWater, kWaterStripe, 64, 64},
        {"*slime", kSlime, kSlime},      {"*lava", kLava, kLava},
        {"sky", 1, 5, 256, 128},         {"+0sign", kSign0, kSign0},
        {"+1sign", kSign1, kSign1},      {"+2sign", kSign2, kSign2},
        {"+asign", kSignOn, kSignOn},    {"{bars", kBars, kHole, 64, 64},
        {"{lamp", kLamp, kLamp, 32, 32}, {"mirror", kMirror, kMirror},
    };
    return all;
}

Palette greys() {
    Palette palette = grey_palette();
    for (std::size_t i = kFirstFullbright; i < 256; ++i) palette.colours[i] = {static_cast<std::uint8_t>(i), 0, 0};
    return palette;
}

std::size_t number_of(std::string_view pass) {
    const auto found =
        std::find_if(kPasses.begin(), kPasses.end(), [pass](const Pass& one) { return one.name == pass; });
    if (found == kPasses.end()) throw std::logic_error("no pass " + std::string(pass));
    return static_cast<std::size_t>(found - kPasses.begin());
}

}  // namespace

Level compile_effects(const MapText& text) {
    std::string source = entity("worldspawn", text.world_keys, text.brushes) + text.entities;
    if (text.entities.find("info_player_start") == std::string::npos)
        source += entity_at("info_player_start", {0, 0, 64});
    const std::vector<map::Wad> wads{map::Wad(wad_bytes(textures()))};
    return engine_level(map::compile_map(map::parse_map(source), wads, {true}));
}

Colormap effect_colours() {
    Colormap map = unshaded();
    map.palette = greys();
    for (std::size_t i = 0; i < kFirstFullbright; ++i) map.shades[kShadowShade][i] = static_cast<std::uint8_t>(i / 2);
    return map;
}

Colormap shades_as_colours() {
    Colormap map = numbered_shades();
    map.palette = greys();
    return map;
}

EffectStage::EffectStage(Level its_level, const Camera& its_camera, Colormap colours,
                         std::vector<PlacedMesh> its_meshes)
    : level(std::move(its_level)),
      colormap(std::move(colours)),
      models(models_at_rest(level)),
      meshes(std::move(its_meshes)),
      camera(its_camera),
      work(level, {}) {
    work.count();
    work.keep_record();
}

Picture EffectStage::draw_in(FrameWorkspace& in, std::int64_t time_ms) const {
    Picture picture(kPicturePixels, 0x5a);
    Scene scene{level, colormap, models};
    scene.time_ms = time_ms;
    scene.moving_lights = moving_lights;
    scene.meshes = meshes;
    draw_frame(scene, camera, {}, settings, in, {picture.data(), kPictureWidth, kPictureHeight, kPictureWidth});
    return picture;
}

Picture EffectStage::draw_afresh(std::int64_t time_ms) const {
    FrameWorkspace fresh(level, {});
    return draw_in(fresh, time_ms);
}

Picture EffectStage::draw_without(Effect effect, std::int64_t time_ms) {
    const EffectSet allowed = settings.allowed_effects;
    settings.allowed_effects = allowed.without(effect);
    Picture picture = draw(time_ms);
    settings.allowed_effects = allowed;
    return picture;
}

Picture EffectStage::draw_without_models() {
    const std::vector<PlacedModel> placed = std::exchange(models, {});
    Picture picture = draw();
    models = placed;
    return picture;
}

bool EffectStage::has(std::string_view pass) const {
    return work.plan.passes[number_of(pass)];
}

std::int64_t EffectStage::pixels(std::string_view pass) const {
    return work.counts.pass_pixels[number_of(pass)];
}

const Face* EffectStage::face_at(std::size_t pixel) const {
    const FaceIndex face = work.record.pixels[pixel].face;
    return face.is_none() ? nullptr : &level.faces[face];
}

const std::string& EffectStage::texture_at(std::size_t pixel) const {
    static const std::string none;
    const Face* const face = face_at(pixel);
    return face ? level.texture_of(*face).name : none;
}

std::int64_t changed_pixels(const Picture& a, const Picture& b) {
    std::int64_t changed = 0;
    for (std::size_t i = 0; i < a.size(); ++i) changed += a[i] != b[i];
    return changed;
}

std::int64_t count_of(const Picture& picture, std::uint8_t colour) {
    return std::count(picture.begin(), picture.end(), colour);
}

std::array<std::int64_t, 2> counts_by_side(const Picture& picture, std::uint8_t colour) {
    std::array<std::int64_t, 2> counts{};
    for (std::size_t i = 0; i < picture.size(); ++i)
        counts[i % kPictureWidth < kPictureWidth / 2 ? 0 : 1] += picture[i] == colour;
    return counts;
}

testing::AssertionResult differ_on(const EffectStage& stage, const std::string& texture, const Picture& a,
                                   const Picture& b) {
    for (std::size_t i = 0; i < a.size(); ++i)
        if (a[i] != b[i] && stage.texture_at(i) != texture)
            return testing::AssertionFailure() << "pixel " << i << " is of '" << stage.texture_at(i) << "'";
    return testing::AssertionSuccess();
}

}  // namespace oblong::test
