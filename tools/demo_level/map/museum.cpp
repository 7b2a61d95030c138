#include "tools/demo_level/map/museum.h"

#include "tools/demo_level/map/exhibits.h"

namespace oblong::map_source {

Draft make_museum() {
    Draft draft({{"message", "A museum of perspective at night"},
                 {"wad", "demo.wad"},
                 {"wateralpha", "0.7"},
                 {"fog", fog_of_garden()},
                 {"palette_cycle", "240 243 6"},  // Ramp::Magenta: the workshop's neon sign
                 {"_minlight", "28"},
                 {"_sunlight", "90"},
                 {"_sun_mangle", "125 -38 0"}});
    build_entrance(draft);
    build_aspect_room(draft);
    build_gallery(draft);
    build_light_hall(draft);
    build_dust_room(draft);
    build_workshop(draft);
    build_axonometry_room(draft);
    build_plane_room(draft);
    build_lift(draft);
    build_courtyard(draft);
    build_canal(draft);
    build_balcony(draft);
    build_colonnade(draft);
    build_rain_court(draft);
    build_fog_garden(draft);
    build_tower(draft);
    build_forced_perspective(draft);
    build_passages(draft);
    build_accuracy_room(draft);
    add_lens_counter(draft);
    return draft;
}

}  // namespace oblong::map_source
