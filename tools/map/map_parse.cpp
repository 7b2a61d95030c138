#include "tools/map/map_parse.h"

#include <algorithm>

#include "engine/base/input_error.h"
#include "tools/map/map_tokens.h"

namespace oblong::map {
namespace {

Point take_point(MapTokens& tokens) {
    tokens.expect("(", "before a point");
    const double x = tokens.take_number("x");
    const double y = tokens.take_number("y");
    const double z = tokens.take_number("z");
    tokens.expect(")", "after a point");
    return {x, y, z};
}

// [ x y z offset ], Valve 220.
void take_axis(MapTokens& tokens, Point& axis, double& offset) {
    tokens.expect("[", "before a texture axis");
    axis.x = tokens.take_number("a texture axis");
    axis.y = tokens.take_number("a texture axis");
    axis.z = tokens.take_number("a texture axis");
    offset = tokens.take_number("a texture offset");
    tokens.expect("]", "after a texture axis");
}

std::string lowered(std::string name) {
    for (char& letter : name) {
        if (letter >= 'A' && letter <= 'Z') letter = static_cast<char>(letter - 'A' + 'a');
    }
    return name;
}

TextureFields take_texture(MapTokens& tokens) {
    TextureFields texture;
    const MapToken name = tokens.take();
    if (name.is_end || name.text.empty()) tokens.fail(name, "a texture's name");
    texture.name = lowered(name.text);
    texture.has_axes = tokens.peek().is("[");
    if (texture.has_axes) {
        take_axis(tokens, texture.axes[0], texture.offset[0]);
        take_axis(tokens, texture.axes[1], texture.offset[1]);
    } else {
        texture.offset[0] = tokens.take_number("a texture offset");
        texture.offset[1] = tokens.take_number("a texture offset");
    }
    texture.rotation_degrees = tokens.take_number("a texture rotation");
    for (double& scale : texture.scale) {
        scale = tokens.take_number("a texture scale");
        if (scale == 0) scale = 1;  // what editors mean by it
    }
    return texture;
}

MapSide take_side(MapTokens& tokens) {
    MapSide side;
    side.line = tokens.peek().line;
    for (Point& point : side.points) point = take_point(tokens);
    const Point normal = cross(side.points[0] - side.points[1], side.points[2] - side.points[1]);
    if (length(normal) < 1e-6)
        throw InputError("line " + std::to_string(side.line),
                         "the three points of a plane lie on one line, expected a triangle");
    side.texture = take_texture(tokens);
    // Some editors append Quake 2's three numbers.
    while (!tokens.peek().is_end && tokens.peek().line == side.line && !tokens.peek().is("}")) tokens.take();
    return side;
}

MapBrush take_brush(MapTokens& tokens) {
    MapBrush brush;
    brush.line = tokens.peek().line;
    tokens.expect("{", "before a brush");
    while (!tokens.peek().is("}")) {
        if (!tokens.peek().is("(")) tokens.fail(tokens.peek(), "'(' of a brush's side or '}' after it");
        brush.sides.push_back(take_side(tokens));
    }
    tokens.expect("}", "after a brush");
    return brush;
}

void take_pair(MapTokens& tokens, MapEntity& entity) {
    const MapToken key = tokens.take();
    const MapToken value = tokens.take();
    if (!value.is_quoted) tokens.fail(value, "a value in quotes for the key \"" + key.text + "\"");
    entity.pairs.emplace_back(key.text, value.text);
}

MapEntity take_entity(MapTokens& tokens) {
    MapEntity entity;
    entity.line = tokens.peek().line;
    tokens.expect("{", "before an entity");
    while (!tokens.peek().is("}")) {
        if (tokens.peek().is_quoted) {
            take_pair(tokens, entity);
        } else if (tokens.peek().is("{")) {
            entity.brushes.push_back(take_brush(tokens));
        } else {
            tokens.fail(tokens.peek(), "a key in quotes, '{' of a brush or '}' after the entity");
        }
    }
    tokens.expect("}", "after an entity");
    return entity;
}

}  // namespace

std::string MapEntity::value(std::string_view key, std::string_view otherwise) const {
    for (const auto& [name, value] : pairs) {
        if (name == key) return value;
    }
    return std::string(otherwise);
}

bool MapEntity::has(std::string_view key) const {
    return std::any_of(pairs.begin(), pairs.end(), [&](const auto& pair) { return pair.first == key; });
}

std::vector<MapEntity> parse_map(std::string_view text) {
    constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
    if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
    MapTokens tokens(text);
    std::vector<MapEntity> entities;
    while (!tokens.peek().is_end) entities.push_back(take_entity(tokens));
    if (entities.empty() || entities[0].value("classname") != "worldspawn")
        throw InputError("line 1", "the first entity is no worldspawn, expected one that holds the world's brushes");
    return entities;
}

}  // namespace oblong::map
