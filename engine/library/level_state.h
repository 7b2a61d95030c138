#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/text.h"
#include "engine/frame/frame.h"
#include "engine/frame/workspace.h"
#include "engine/level/bsp_read.h"
#include "engine/library/conversions.h"
#include "engine/library/level_walk.h"
#include "engine/models/level_models.h"

namespace oblong {

/// Of a body's eye above its origin (Quake's).
inline constexpr World kEyeAboveOrigin = World::from_int(22);

/// Its key "origin", or the middle of the world.
Vec3<World> entity_origin(const Entity& entity);
/// Its key "angles" or "angle".
std::int32_t entity_yaw_256(const Entity& entity);

/// The brushes of an entity, where they are now.
struct EntityBrushes {
    PlacedModel placed;
    std::int32_t entity = 0;
    bool is_solid = false, is_door = false;  ///< a door that turns
    bool is_hidden = false, is_open = false;
};

struct LevelScene::State {
    State(const File& bsp_file, const Palette& its_palette, const ScreenMode& its_mode)
        : file(bsp_file.name),
          mode(checked(its_mode)),
          level(read_parsed(bsp_file, read_bsp)),
          colormap(make_colormap(its_palette)),
          models(read_level_models(level, its_palette, {file, ""})),
          turned(models.models.size()),
          is_model_hidden(models.models.size()),
          work(std::make_unique<FrameWorkspace>(level, mode)) {}

    [[noreturn]] void refuse(std::int32_t entity_number, const std::string& what) const {
        throw FileError(file, "entity " + std::to_string(entity_number), what);
    }
    const Entity& entity(std::int32_t number) const {
        if (number < 0 || as_size(number) >= level.entities.size())
            refuse(number, "is not there, expected " + (level.entities.empty()
                                                            ? "none: the level has no entities"
                                                            : bounds_text(0, std::ssize(level.entities) - 1)));
        return item(level.entities, number);
    }
    ModelIndex brushes_of(std::int32_t number) const {
        const std::optional<ModelIndex> model = brush_model_of(entity(number), level);
        if (!model) refuse(number, "has no brushes, expected a door or its like");
        return *model;
    }
    /// The index in `models` of the model of a turning door.
    std::optional<std::size_t> turning_door(std::int32_t number) const {
        for (std::size_t i = 0; i < models.models.size(); ++i)
            if (models.models[i].is_door && models.models[i].entity == as_size(number)) return i;
        return {};
    }
    Surroundings surroundings() const { return {level, solid}; }
    /// Lists what is seen and what is solid.
    void list_brushes();

    std::string file;
    ScreenMode mode;
    Level level;
    Colormap colormap;
    LevelModels models;
    std::vector<Angle> turned;                  // of turning doors, in the order of `models`
    std::vector<std::uint8_t> is_model_hidden;  // in that order
    std::vector<EntityBrushes> brushes;         // of all entities, but for triggers
    std::vector<PlacedModel> seen, solid;       // of these; turning doors are seen as models
    std::vector<PlacedMesh> shown;              // in the next picture
    std::vector<std::size_t> shown_sprites;     // of these, those that turn to the eye
    std::vector<std::shared_ptr<const Mesh>> shown_meshes;
    Settings settings;
    std::unique_ptr<FrameWorkspace> work;  // of the level and the mode above
    std::vector<std::string> warnings;
};

}  // namespace oblong
