#include "tools/map/source/entities.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "engine/base/input_error.h"
#include "engine/base/text.h"
#include "engine/level/entity_classes.h"
#include "tools/map/source/brush.h"

namespace oblong::map {
namespace {

bool is_no_fence(const MapBrush& brush) {
    return std::none_of(brush.sides.begin(), brush.sides.end(),
                        [](const MapSide& side) { return has_holes(side.texture.name); });
}

// Keys only about the source: TrenchBroom's layers and groups, and the format.
bool is_of_source(std::string_view key) {
    return key.starts_with("_tb_") || key == "mapversion";
}

// "a/b.wad;C:\c.wad" as "b.wad;c.wad": a level's bytes do not depend on its source's folder.
std::string without_folders(std::string_view paths) {
    std::string names;
    for (const char letter : paths) {
        if (letter == '/' || letter == '\\')
            names.resize(names.rfind(';') + 1);  // npos + 1 is 0
        else
            names += letter;
    }
    return names;
}

std::string written_value(const MapEntity& entity, const MapPair& pair) {
    if (pair.key == "wad" && role_of(entity) == ClassRole::Worldspawn) return without_folders(pair.value);
    const bool is_detail_to_pass = pair.key == "classname" && role_of(entity) == ClassRole::PassableDetail;
    return is_detail_to_pass ? "func_illusionary" : pair.value;
}

}  // namespace

std::vector<double> numbers_of(const MapEntity& entity, std::string_view key, std::size_t count) {
    const std::string value = entity.value(key);
    std::vector<double> numbers;
    std::string_view rest = value;
    while (numbers.size() < count) {
        constexpr int kFractionBits = 32;
        const std::optional<std::int64_t> raw = parse_level_number(take_word(rest), kFractionBits);
        if (!raw) return {};
        numbers.push_back(std::ldexp(*raw, -kFractionBits));
    }
    return numbers;
}

bool belongs_to_world(const MapEntity& entity) {
    const ClassRole role = role_of(entity);
    return role == ClassRole::Worldspawn || role == ClassRole::BrushGroup || role == ClassRole::Detail;
}

bool is_detail_entity(const MapEntity& entity) {
    return role_of(entity) == ClassRole::Detail;
}

std::optional<Point> origin_of(const MapEntity& entity) {
    const auto numbers = numbers_of(entity, "origin", 3);
    if (numbers.empty()) return std::nullopt;
    return Point{numbers[0], numbers[1], numbers[2]};
}

bool shines_by_surfaces(const MapEntity& entity) {
    return role_of(entity) == ClassRole::Lamp && !entity.value("_surface").empty();
}

double number_of(const MapEntity& entity, std::string_view key, double otherwise) {
    const auto numbers = numbers_of(entity, key, 1);
    return numbers.empty() ? otherwise : numbers.front();
}

void split_off_fences(std::vector<MapEntity>& entities) {
    std::vector<MapEntity> fences;
    for (MapEntity& entity : entities) {
        if (!belongs_to_world(entity)) continue;
        const auto first = std::stable_partition(entity.brushes.begin(), entity.brushes.end(), is_no_fence);
        const std::string mirror = entity.value("_mirrorinside");
        for (auto brush = first; brush != entity.brushes.end(); ++brush) {
            fences.push_back({{{"classname", "func_wall", brush->line}}, {*brush}, brush->line});
            if (!mirror.empty()) fences.back().pairs.push_back({"_mirrorinside", mirror, brush->line});
        }
        entity.brushes.erase(first, entity.brushes.end());
    }
    std::move(fences.begin(), fences.end(), std::back_inserter(entities));
}

std::vector<TextureUse> shown_textures(const std::vector<MapEntity>& entities) {
    std::vector<TextureUse> uses;
    for (const MapEntity& entity : entities) {
        const ClassRole role = role_of(entity);
        if (role != ClassRole::Billboard && role != ClassRole::FlyingLamp) continue;
        for (const MapPair& pair : entity.pairs)
            if (pair.key == "texture") uses.push_back({lower_case(pair.value), pair.line});
    }
    return uses;
}

void bring_world_forward(std::vector<MapEntity>& entities) {
    const auto rank = [](const MapEntity& entity) { return !belongs_to_world(entity) ? 2 : is_detail_entity(entity); };
    std::stable_sort(entities.begin() + 1, entities.end(),
                     [&](const MapEntity& a, const MapEntity& b) { return rank(a) < rank(b); });
}

std::string entities_text(const std::vector<MapEntity>& entities) {
    std::string text;
    int model = 0;
    for (const MapEntity& entity : entities) {
        const bool is_of_world = belongs_to_world(entity), is_group = role_of(entity) == ClassRole::BrushGroup;
        if (is_of_world && (is_group || !entity.brushes.empty()) && &entity != &entities.front()) continue;
        text += "{\n";
        for (const MapPair& pair : entity.pairs)
            if (!is_of_source(pair.key)) text += "\"" + pair.key + "\" \"" + written_value(entity, pair) + "\"\n";
        if (!is_of_world && !entity.brushes.empty()) text += "\"model\" \"*" + std::to_string(++model) + "\"\n";
        text += "}\n";
    }
    return text;
}

}  // namespace oblong::map
