#pragma once

#include <functional>

#include "engine/base/input_error.h"
#include "tools/map/source/changed_part.h"
#include "tools/map/source/checks.h"
#include "tools/map/source/map_file.h"
#include "tools/map/source/textures.h"
#include "tools/map/tree/bsp_file.h"
#include "tools/map/vis/visibility.h"
#include "tools/map/work_sharing.h"

namespace oblong {
struct Palette;
}

namespace oblong::map {

struct CompileOptions {
    bool is_fast = false;   ///< rougher visibility and light, and no separate hull for large bodies
    bool has_dirt = false;  ///< LightOptions
    bool has_bounce = false;
    const Palette* palette = nullptr;
    Warnings* warnings = nullptr;                   ///< collects oddities that do not prevent compilation
    std::function<void()> before_long_passes = {};  ///< called when the warnings so far are to be reported
    Workers* workers = nullptr;                     ///< share the work, without effect on the level
    Progress* progress = nullptr;
    PortalFile* portals = nullptr;  ///< receives the portals
    /// Not null: a draft that leaks is a level without visibility, whose path to the void this receives, with a
    /// warning.
    std::vector<Point>* leak_path = nullptr;
    CompilePart part = CompilePart::All;
    BspFile former = {};  ///< for a part: an earlier result of compile_map() with the same brushes
};

/// An entity is connected with the void around the level: the level leaks or, if the start is sealed, the entity is
/// outside.
class LeakError : public InputError {
  public:
    LeakError(const MapEntity& entity, std::vector<Point> way_out, bool is_start_inside);

    std::vector<Point> path;  ///< from the entity to the void
};

/// Compiles the result of parse_map() with the textures of the WADs. Throws InputError (LeakError), also if the brushes
/// differ from those of the former level.
BspFile compile_map(std::vector<MapEntity> entities, const std::vector<Wad>& wads, const CompileOptions& options);

}  // namespace oblong::map
