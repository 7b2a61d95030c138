#include <map>
#include <utility>

#include "tools/map/source/map_file.h"

namespace oblong::map {
namespace {

// TrenchBroom's layers and groups: the entities with a `_tb_id`. An entity names its layer, or its group, which may be
// in another one; what names none is in the layer of the worldspawn.
class EditorLayers {
  public:
    explicit EditorLayers(const std::vector<MapEntity>& entities) : default_(entities.front()) {
        for (const MapEntity& entity : entities)
            if (entity.has("_tb_id")) by_id_[{entity.value("_tb_type"), entity.value("_tb_id")}] = &entity;
    }

    bool is_left_out(const MapEntity& entity) const {
        const MapEntity* at = &entity;
        for (std::size_t step = 0; step <= by_id_.size() && at != nullptr; ++step) {
            if (at->value("_tb_type") == "_tb_layer" || at == &default_) return at->value(kOmits) == "1";
            at = holder_of(*at);
        }
        return false;
    }

  private:
    static constexpr std::string_view kOmits = "_tb_layer_omit_from_export";

    const MapEntity* holder_of(const MapEntity& entity) const {
        for (const std::string type : {"_tb_layer", "_tb_group"})
            if (const auto found = by_id_.find({type, entity.value(type)}); found != by_id_.end()) return found->second;
        return &default_;
    }

    const MapEntity& default_;
    std::map<std::pair<std::string, std::string>, const MapEntity*> by_id_;  // type, id
};

}  // namespace

void leave_out_layers(std::vector<MapEntity>& entities) {
    const EditorLayers layers(entities);
    std::vector<bool> left_out;
    for (const MapEntity& entity : entities) left_out.push_back(layers.is_left_out(entity));
    if (left_out.front()) entities.front().brushes.clear();
    std::size_t kept = 1;
    for (std::size_t i = 1; i < entities.size(); ++i)
        if (!left_out[i]) std::swap(entities[kept++], entities[i]);
    entities.resize(kept);
}

}  // namespace oblong::map
