#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "engine/io/game_files.h"
#include "engine/level/level.h"
#include "engine/mesh/placed_mesh.h"
#include "engine/surface/palette.h"

namespace oblong {

/// A model of a level, and its changes with time.
struct LevelModel {
    PlacedMesh placed;  ///< at time 0
    std::uint32_t first_frame = 0,
                  frames = 1;  ///< of its mesh's frame sequences; several are shown for a tenth of a second each
    std::uint32_t skin = 0;    ///< of its mesh's skin sequences
    std::int32_t turn_ms = 0;  ///< for a whole turn, counter-clockwise; below 0: clockwise; 0: none
    Angle PlacedMesh::*turns = &PlacedMesh::yaw;  ///< the angle of `placed` that turns
    bool is_door = false;                         ///< turned by the game
    std::size_t entity = 0;                       ///< its entity, into Level::entities
};

/// The models that a level's entities show: misc_model, turning brushes, items (item_lens, keys), and Quake's own
/// classes (entity_classes.h).
struct LevelModels {
    std::vector<std::unique_ptr<const Mesh>> meshes;  ///< one for each file and each set of reading options
    std::vector<LevelModel> models;
    std::vector<std::string> warnings;  ///< of models that are not shown
};

/// Where files of models are searched: in `named`, in the level's folder, in the folder above, in `games`; in each by
/// the file's path, then by its name alone there, in `progs` and in `models`; in `game` by the file's path, and in
/// `progs`.
struct ModelFolders {
    std::string level_file;
    std::string named;                ///< empty: none
    std::string own = {};             ///< of Oblong's lens and keys, searched after the others; empty: none
    const GameFiles* game = nullptr;  ///< with pak files, or null; searched last
    std::vector<std::string> games = {};
};

inline constexpr std::size_t kMostLevelModels = 4096;

/// Reads the models of a level, each file once at each scale, up to 128 MB in all. A missing file is a warning; for
/// Quake's own classes, one for each file. Throws FileError for a broken file, or if `named` is no folder.
LevelModels read_level_models(const Level& level, const Palette& palette, const ModelFolders& folders);

/// The game's changes of a level's models; each list is empty, or has an entry for each model.
struct ShownModels {
    std::span<const std::uint8_t> is_gone = {};  ///< not 0: not shown
    std::span<const Angle> turned = {};          ///< of doors; empty: doors are not shown as models
};

/// Fills `placed` with the models at a time.
void place_models(const LevelModels& models, std::int64_t time_ms, const ShownModels& shown,
                  std::vector<PlacedMesh>& placed);

}  // namespace oblong
