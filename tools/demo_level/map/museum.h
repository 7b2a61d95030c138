#pragma once

#include "tools/demo_level/map/draft.h"

namespace oblong::map_source {

/// The demo level: a museum of perspective at night. One function a place, in the order of a visit; x is east, y north.
///
///                     accuracy ------ distance ---.
///                        |                        |
///                     passage   colonnade       tower (end)
///                        |          |
///                   forced persp. --+-- courtyard, canal ---- balcony -- lift
///                                            |                 |          |
///                          aspect -- gallery (vanishing point) |      any plane
///                             |              |   |             |          |
///                          entrance (start)  |   '------- axonometry -----'
///                                            |
///                                dust --- light hall --- workshop
Draft make_museum();

void build_entrance(Draft& draft);
void build_aspect_room(Draft& draft);
void build_gallery(Draft& draft);
void build_light_hall(Draft& draft);
void build_dust_room(Draft& draft);
void build_workshop(Draft& draft);
void build_axonometry_room(Draft& draft);
void build_plane_room(Draft& draft);
void build_lift(Draft& draft);
void build_courtyard(Draft& draft);
void build_canal(Draft& draft);
void build_balcony(Draft& draft);
void build_colonnade(Draft& draft);
void build_rain_court(Draft& draft);
/// Its fog, as the world's key "fog": it lies in the garden alone, which is deeper than all other rooms.
std::string fog_of_garden();
void build_fog_garden(Draft& draft);
void build_tower(Draft& draft);
void build_forced_perspective(Draft& draft);
void build_passages(Draft& draft);
void build_accuracy_room(Draft& draft);

}  // namespace oblong::map_source
