#pragma once

#include <string>
#include <vector>

#include "tools/demo_level/art/textures.h"

namespace oblong::model_source {

/// A text file of assets/models.
struct ModelFile {
    std::string name, text;
};

/// All models of the demo level, as OBJ files, and their one file of materials.
std::vector<ModelFile> all_model_files();

/// What they are painted with.
std::vector<art::NamedCanvas> paint_all_skins();

/// An armillary sphere: a celestial globe in rings of brass, on a turned foot. Its outermost ring has the radius 1, the
/// foot stands on y = 0.
std::string armillary_obj();

/// A lens in a ring of brass, with a handle: what there is to find in each exhibit. The ring has the radius 1 and its
/// middle in the origin; the handle ends at y = -2.2.
std::string lens_obj();

/// A key, its shaft upright, in a metal: 2.8 high, its middle in the origin.
std::string key_obj(const std::string& metal);

/// Three parts of an orrery about the origin, y up, that turn at different speeds: a sun in rings of brass, of radius
/// 0.6; a ring of radius 1 that carries a lens in each of the exhibits' twelve colours; what both rest on, from
/// y = -1.55 on.
std::string orrery_sun_obj();
std::string orrery_lenses_obj();
std::string orrery_stand_obj();

}  // namespace oblong::model_source
