#pragma once

#include <optional>

#include "tools/map/source/textures.h"

namespace oblong::map {

/// Whether the entity's brushes are part of the world: the worldspawn's, and those of func_group and func_detail.
bool belongs_to_world(const MapEntity& entity);

/// Whether its brushes are details, whatever their shape: see Brush::is_detail.
bool is_detail_entity(const MapEntity& entity);

/// The three numbers of the key "origin"; nothing if it is missing. Throws InputError if it is malformed.
std::optional<Point> origin_of(const MapEntity& entity);

/// How many words there are between the blanks of a value.
std::size_t count_words(const std::string& text);

/// The first `count` numbers of a key's value. Throws InputError if there are fewer.
std::vector<double> numbers_of(const MapEntity& entity, std::string_view key, std::size_t count);

/// The number that is the value of a key, or `otherwise` if it is missing. Throws InputError if it is malformed.
double number_of(const MapEntity& entity, std::string_view key, double otherwise);

/// Tells the sides of brushes of the keys "_phong" and "_phong_angle" of their entities.
void set_smoothing(std::vector<MapEntity>& entities);

/// Puts what belongs to the world before all other entities, its details last: in which order an editor writes groups
/// and layers makes no difference to the level. The first entity, the worldspawn, stays; the order is else as it was.
void bring_world_forward(std::vector<MapEntity>& entities);

/// Makes each of the world's brushes with a fence's texture (see is_fence_texture()) an entity of its own, func_wall:
/// it hides nothing, neither from view nor from light, and stops players as before.
void split_off_fences(std::vector<MapEntity>& entities);

/// The textures that misc_sprite and misc_lantern name by their key "texture".
std::vector<TextureUse> shown_textures(const std::vector<MapEntity>& entities);

/// The entities lump: all pairs as written, but those that speak of the source (TrenchBroom's, the format, folders of
/// the worldspawn's WAD files); brush entities get a "model" "*N", N counting from 1. The brushes of a
/// func_detail_illusionary, which stop nobody, become a func_illusionary.
std::string entities_text(const std::vector<MapEntity>& entities);

}  // namespace oblong::map
