#include <algorithm>
#include <array>
#include <string>

#include "engine/base/text.h"
#include "engine/level/entity_classes.h"
#include "engine/scene/pick.h"
#include "game/sound/sound_starts.h"

namespace oblong {
namespace {

struct NamePart {
    std::string_view part;
    Sound step;
};

// Words in names of this project's textures and of Quake's; the first that a name contains counts.
constexpr std::array kNameParts{
    NamePart{"carpet", Sound::StepCarpet}, NamePart{"rug", Sound::StepCarpet},   NamePart{"wood", Sound::StepWood},
    NamePart{"plank", Sound::StepWood},    NamePart{"crate", Sound::StepWood},   NamePart{"wizwood", Sound::StepWood},
    NamePart{"metal", Sound::StepMetal},   NamePart{"iron", Sound::StepMetal},   NamePart{"grate", Sound::StepMetal},
    NamePart{"brass", Sound::StepMetal},   NamePart{"copper", Sound::StepMetal}, NamePart{"bronze", Sound::StepMetal},
    NamePart{"steel", Sound::StepMetal},   NamePart{"cop1_", Sound::StepMetal},  NamePart{"plat_", Sound::StepMetal},
    NamePart{"tech", Sound::StepMetal},    NamePart{"slip", Sound::StepMetal},   NamePart{"sfloor", Sound::StepMetal},
    NamePart{"earth", Sound::StepEarth},   NamePart{"grass", Sound::StepEarth},  NamePart{"ground", Sound::StepEarth},
    NamePart{"dirt", Sound::StepEarth},    NamePart{"mud", Sound::StepEarth},    NamePart{"hedge", Sound::StepEarth},
};

constexpr Vec3<Unit> kDown{Unit{}, Unit{}, -Unit::from_int(1)};

std::string_view first_texture(const Level& bsp, ModelIndex model) {
    for (const FaceIndex face : bsp.models[model].faces) return bsp.texture_of(bsp.faces[face]).name;
    return {};
}

std::string_view texture_below(const GameLevel& level, const GameState& state) {
    if (state.player.ground > 0) return first_texture(*level.bsp, ModelIndex(state.player.ground));
    const auto face = pick_face(*level.bsp, {}, state.player.position, kDown);
    return face ? std::string_view(level.bsp->texture_of(level.bsp->faces[face->face]).name) : std::string_view();
}

}  // namespace

Sound step_sound_of_texture(std::string_view name) {
    const std::string lower = lower_case(name);
    const auto found = std::find_if(kNameParts.begin(), kNameParts.end(),
                                    [&](const NamePart& part) { return lower.find(part.part) != lower.npos; });
    return found == kNameParts.end() ? Sound::StepStone : found->step;
}

Sound step_sound(const GameLevel& level, const GameState& state) {
    if (state.player.depth != Depth::Dry) return Sound::StepWater;
    return step_sound_of_texture(texture_below(level, state));
}

MoverSounds mover_sounds(const Level& bsp, ModelIndex model) {
    const Entity* entity = entity_of(bsp, model);
    const ClassRole role = entity == nullptr ? ClassRole::None : role_of(*entity);
    if (role == ClassRole::Lift) return {Sound::LiftStart, Sound::LiftMove, Sound::LiftStop};
    if (role == ClassRole::Train) return {Sound::TrainStart, Sound::TrainMove, Sound::TrainStop};
    const Sound step = step_sound_of_texture(first_texture(bsp, model));
    if (step == Sound::StepWood) return {Sound::DoorStart, Sound::DoorMove, Sound::DoorStop};
    if (step == Sound::StepMetal) return {Sound::GateStart, Sound::GateMove, Sound::GateStop};
    return {Sound::SlabStart, Sound::SlabMove, Sound::SlabStop};
}

}  // namespace oblong
