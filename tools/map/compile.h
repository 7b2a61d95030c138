#pragma once

#include "engine/base/input_error.h"
#include "tools/map/source/checks.h"
#include "tools/map/source/map_file.h"
#include "tools/map/source/textures.h"
#include "tools/map/tree/bsp_file.h"
#include "tools/map/vis/portal_file.h"
#include "tools/map/work_sharing.h"

namespace oblong {
struct Palette;
}

namespace oblong::map {

/// What is made anew; the rest is taken from a former level.
enum class CompilePart { All, Entities, Light, Visibility };

struct CompileOptions {
    bool is_fast = false;   ///< rougher visibility and light, and no hull of its own for large bodies
    bool has_dirt = false;  ///< LightOptions
    bool has_bounce = false;
    const Palette* palette = nullptr;
    Warnings* warnings = nullptr;  ///< collects what is odd, but compiled all the same
    Workers* workers = nullptr;    ///< share in the work; the level does not depend on them
    CompileProgress* progress = nullptr;
    PortalFile* portals = nullptr;  ///< receives them
    CompilePart part = CompilePart::All;
    BspFile former = {};  ///< unless all is made: what compile_map() made of a source with the same brushes
};

/// An entity of the level is open to the void around it: it leaks there or, where the start is sealed, it is outside.
class LeakError : public InputError {
  public:
    LeakError(const MapEntity& entity, std::vector<Point> way_out, bool is_start_inside);

    std::vector<Point> path;  ///< from the entity to the void
};

/// Compiles what parse_map() read with the textures of the WADs. Throws InputError (LeakError); also where the former
/// level shows that the brushes have changed.
BspFile compile_map(std::vector<MapEntity> entities, const std::vector<Wad>& wads, const CompileOptions& options);

/// A path as text, one point a line: "x y z".
std::string points_text(const std::vector<Point>& path);

}  // namespace oblong::map
