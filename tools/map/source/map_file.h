#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "tools/map/source/geometry.h"
#include "tools/map/source/light.h"

namespace oblong::map {

/// How a side is lit, by its entity's keys: set_surface_light().
struct SurfaceLight {
    double smooth_degrees = 0;   ///< above 0: lit as if round between faces at smaller angles
    int smooth_group = 0;        ///< but not between those of two groups
    Light least;                 ///< 0 to 255, of a part of the world
    bool ignores_light = false;  ///< there is only the least
    bool has_no_dirt = false;
    bool operator==(const SurfaceLight&) const = default;
};

/// The alignment of a texture on a side in the map source, and its light.
struct TextureFields {
    std::string name;
    bool has_axes = false;      ///< Valve 220: `axes` are given; Standard: they follow from the side's normal
    std::array<Point, 2> axes;  ///< of u and v
    std::array<double, 2> offset{}, scale{1, 1};
    double rotation_degrees = 0;  ///< already in `axes` if those are given
    SurfaceLight light;
    bool operator==(const TextureFields&) const = default;
};

/// A plane through three points, which are clockwise seen from its front.
struct MapSide {
    std::array<Point, 3> points;
    TextureFields texture;
    int line = 0;
    bool operator==(const MapSide&) const = default;
};

struct MapBrush {
    std::vector<MapSide> sides;
    int line = 0;
};

struct MapPair {
    std::string key, value;
    int line = 0;
};

struct MapEntity {
    std::vector<MapPair> pairs;
    std::vector<MapBrush> brushes;
    int line = 0;

    /// The value of the first pair named `key`, or `otherwise`.
    std::string value(std::string_view key, std::string_view otherwise = "") const;
    bool has(std::string_view key) const;
};

class Warnings;

/// Leaves out TrenchBroom's layers that are not to be exported, with all that is in them; of the worldspawn, as in the
/// editor's export, only the brushes. In editor_layers.cpp.
void leave_out_layers(std::vector<MapEntity>& entities);

/// Reads the text of a Quake .map (Standard or Valve 220), throwing InputError with the line of an error. The first
/// entity is the worldspawn. Leaves out the layers that TrenchBroom does not export, and brushes without sides, which
/// are warnings.
std::vector<MapEntity> parse_map(std::string_view text, Warnings* warnings = nullptr);

}  // namespace oblong::map
