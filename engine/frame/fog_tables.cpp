#include "engine/frame/fog_tables.h"

#include <utility>

namespace oblong {

LevelFogTables::LevelFogTables(const LevelFog& fog, const Palette& palette)
    : palette_(palette),
      colour_(fog.colour),
      share_256_(fog.alpha_256),
      depths_(
          make_fog_depths(convert<FogDensity>(fog.density), convert<View>(fog.nearest), convert<View>(fog.farthest))) {}

const ColourRow& LevelFogTables::colours(std::int32_t level) {
    ColourRow& row = item(colours_.levels, level);
    if (!std::exchange(item(is_made_, level), true)) row = make_fog_level(palette_, colour_, share_256_, level);
    return row;
}

const FogTable& LevelFogTables::colours_of(std::span<const FogRun> runs) {
    for (const FogRun& run : runs) colours(run.level);
    return colours_;
}

}  // namespace oblong
