#include "engine/scene/placed_models.h"

#include <charconv>
#include <string>

#include "engine/level/entity_classes.h"

namespace oblong {

std::vector<PlacedModel> models_at_rest(const Level& level) {
    std::vector<PlacedModel> placed;
    for (const Entity& entity : level.entities) {
        const std::string model = entity.value("model");
        if (!model.starts_with("*") || is_trigger(role_of(entity))) continue;
        std::int32_t index = 0;
        const auto [end, error] = std::from_chars(model.data() + 1, model.data() + model.size(), index);
        if (error != std::errc{} || end != model.data() + model.size()) continue;
        if (index >= 1 && index < level.models.count()) placed.push_back({ModelIndex(index), {}});
    }
    return placed;
}

}  // namespace oblong
