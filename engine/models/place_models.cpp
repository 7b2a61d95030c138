#include "engine/base/table.h"
#include "engine/models/level_models.h"

namespace oblong {
namespace {

constexpr std::int32_t kSeparateFrame_ms = 100;  ///< Quake's game code goes to the next frame ten times a second

/// The frame at a time; `frames` are shown in turn, and each may be a sequence.
std::uint32_t frame_at(const LevelModel& model, const Mesh& mesh, std::int64_t time_ms) {
    const std::int64_t since = model.frames > 1 ? time_ms / kSeparateFrame_ms % model.frames : 0;
    return shown_at(item(mesh.frame_sequences, model.first_frame + since), time_ms);
}

}  // namespace

void place_models(const LevelModels& models, std::int64_t time_ms, const ShownModels& shown,
                  std::vector<PlacedMesh>& placed) {
    placed.clear();
    for (std::size_t i = 0; i < models.models.size(); ++i) {
        const LevelModel& model = models.models[i];
        if ((!shown.is_gone.empty() && shown.is_gone[i] != 0) || (model.is_door && shown.turned.empty())) continue;
        const Mesh& mesh = *model.placed.mesh;
        PlacedMesh& now = placed.emplace_back(model.placed);
        now.frame = now.next_frame = frame_at(model, mesh, time_ms);
        now.skin = shown_at(item(mesh.skin_sequences, model.skin), time_ms);
        Angle& angle = now.*model.turns;
        if (model.turn_ms != 0) angle = angle + Angle::from_bam(time_ms % model.turn_ms * 65536 / model.turn_ms);
        if (model.is_door) angle = angle + shown.turned[i];
    }
}

}  // namespace oblong
