#include "engine/scene/placed_models.h"

#include <charconv>
#include <string>

#include "engine/level/entity_classes.h"

namespace oblong {

std::optional<ModelIndex> brush_model_of(const Entity& entity, const Level& level) {
    const std::string name = entity.value("model");
    if (name.size() < 2 || name[0] != '*') return {};
    std::int32_t model = 0;
    const auto [end, error] = std::from_chars(name.data() + 1, name.data() + name.size(), model);
    const bool is_number = error == std::errc{} && end == name.data() + name.size();
    const bool is_there = model >= 1 && model < level.models.count();
    return is_number && is_there ? std::optional(ModelIndex(model)) : std::nullopt;
}

std::vector<PlacedModel> models_at_rest(const Level& level) {
    std::vector<PlacedModel> placed;
    for (const Entity& entity : level.entities) {
        const ClassRole role = role_of(entity);
        if (is_trigger(role) || role == ClassRole::Rotating) continue;
        if (const auto model = brush_model_of(entity, level)) placed.push_back({*model, {}});
    }
    return placed;
}

}  // namespace oblong
