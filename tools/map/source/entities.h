#pragma once

#include <optional>

#include "tools/map/source/textures.h"

namespace oblong::map {

/// Whether the entity's brushes are part of the world: the worldspawn's, and those of func_group and func_detail.
bool belongs_to_world(const MapEntity& entity);

/// Whether its brushes are details (Brush::is_detail) regardless of their shape.
bool is_detail_entity(const MapEntity& entity);

/// The three numbers of the key "origin"; nothing if it is missing or malformed.
std::optional<Point> origin_of(const MapEntity& entity);

/// Whether it is a light that all faces of a texture emit in its place, which may be anywhere.
bool shines_by_surfaces(const MapEntity& entity);

/// The first `count` numbers of a key's value; none if there are fewer, which is a warning of find_warnings().
std::vector<double> numbers_of(const MapEntity& entity, std::string_view key, std::size_t count);

/// The number that is the value of a key, or `otherwise` if it is missing or malformed.
double number_of(const MapEntity& entity, std::string_view key, double otherwise);

/// Moves the world's entities before all others, details last, so that the level does not depend on the order in which
/// an editor writes groups and layers. The first entity, the worldspawn, stays; the order is otherwise unchanged.
void bring_world_forward(std::vector<MapEntity>& entities);

/// Makes each of the world's brushes with a texture that has_holes() a separate entity, func_wall: it
/// blocks neither views nor light, but still players.
void split_off_fences(std::vector<MapEntity>& entities);

/// The textures in the keys "texture" of misc_sprite and misc_lantern.
std::vector<TextureUse> shown_textures(const std::vector<MapEntity>& entities);

/// The entities lump: all pairs as written, except those about the source (TrenchBroom's, the format, folders of the
/// worldspawn's WAD files); brush entities get a "model" "*N", N counting from 1. The brushes of a
/// func_detail_illusionary, which do not stop players, become a func_illusionary.
std::string entities_text(const std::vector<MapEntity>& entities);

}  // namespace oblong::map
