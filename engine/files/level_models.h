#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "engine/files/game_files.h"
#include "engine/level/level.h"
#include "engine/mesh/placed_mesh.h"
#include "engine/surface/palette.h"

namespace oblong {

/// A model of a level, and what of it changes with time.
struct LevelModel {
    PlacedMesh placed;                          ///< at time 0
    std::uint32_t first_frame = 0, frames = 1;  ///< of its mesh's frame sequences: several are a tenth of a second each
    std::uint32_t skin = 0;                     ///< of its mesh's skin sequences
    std::int32_t turn_ms = 0;  ///< for a whole turn, counter-clockwise; below 0: clockwise; 0: it stands
    Angle PlacedMesh::*turns = &PlacedMesh::yaw;  ///< what of `placed` changes then
    bool is_door = false;                         ///< it turns as a game says
    std::size_t entity = 0;                       ///< that it shows, into Level::entities
};

/// The models that a level's entities show: misc_model, brushes that turn, what there is to take (item_lens, keys), and
/// Quake's own classes (entity_classes.h).
struct LevelModels {
    std::vector<std::unique_ptr<const Mesh>> meshes;  ///< one for each file and each way to read it
    std::vector<LevelModel> models;
    std::vector<std::string> warnings;  ///< what is not shown, and why
};

/// Where files of models are looked for: in `named`, in the level's folder, in the one above it; in each by the file's
/// path, and by its name alone there, in `progs` and in `models`; in `game` by the file's path, and in `progs`.
struct ModelFolders {
    std::string level_file;
    std::string named;                ///< empty: nowhere
    std::string own = {};             ///< of Oblong's lens and keys, after all others; empty: nowhere
    const GameFiles* game = nullptr;  ///< with pak files, or null; looked at last

    /// Quake's own classes show nothing where neither is given.
    bool has_quakes_models() const { return !named.empty() || game != nullptr; }
};

inline constexpr std::size_t kMostLevelModels = 4096;

/// Reads the models of a level, each file once. A file that is missing is a warning, one for each that Quake's own
/// classes want. Throws FileError for a file that is broken.
LevelModels read_level_models(const Level& level, const Palette& palette, const ModelFolders& folders);

/// What of a level's models a game has changed; each list is empty, or has an entry for each model.
struct ShownModels {
    std::span<const std::uint8_t> is_gone = {};  ///< not 0: it is not shown
    std::span<const Angle> turned = {};          ///< of doors; empty: they are not shown, as they are brushes at rest
};

/// The models as they are at a time; `placed` is filled anew.
void place_models(const LevelModels& models, std::int64_t time_ms, const ShownModels& shown,
                  std::vector<PlacedMesh>& placed);

}  // namespace oblong
