#pragma once

#include <algorithm>
#include <array>
#include <string_view>

namespace oblong {

/// A key or class of levels for other engines that is left out here; one that ends in '*' stands for all that begin so.
struct LeftOut {
    std::string_view name, reason;
};

inline constexpr std::array kLeftOut{
    LeftOut{"_lightmap_scale", "a face has a sample every 16 texels"},
    LeftOut{"_lmscale", "a face has a sample every 16 texels"},
    LeftOut{"_maxlight", "light has no upper bound but that of a lightmap"},
    LeftOut{"_minlight_dirt", "the least light is never darkened"},
    LeftOut{"_minlight_mottle", "the least light is even"},
    LeftOut{"_minlightMottle", "the least light is even"},
    LeftOut{"_noclipfaces", "liquids that meet keep their faces"},
    LeftOut{"_nofill", "what is outside is filled; a draft that leaks keeps it"},
    LeftOut{"_project_*", "lamps shine evenly: no pictures are projected"},
    LeftOut{"_shadowself", "`_shadow` 1 falls on everything, and on itself"},
    LeftOut{"_shadowworldonly", "`_shadow` 1 falls on everything, and on itself"},
    LeftOut{"_switchableshadow", "shadows stay where a thing begins"},
    LeftOut{"_sun2*", "there is one sun; `_sunlight2` and `_sunlight3` are the sky's light"},
    LeftOut{"_surflight_*", "`_surface` of a `light` makes all faces of a texture shine"},
    LeftOut{"ambient_general", "sounds without an end are the game's: `ambient_drip` and its like"},
    LeftOut{"fog_color", "worldspawn's `fog` has density and colour"},
    LeftOut{"fog_density", "worldspawn's `fog` has density and colour"},
    LeftOut{"func_bob*", "things go from path_corner to path_corner: a `func_train`"},
    LeftOut{"func_rotate_*", "`func_rotating` turns for ever, `func_door_rotating` by an angle"},
    LeftOut{"rotate_object", "`func_rotating` turns for ever, `func_door_rotating` by an angle"},
    LeftOut{"sky", "a sky is a texture of two layers; there are no boxes of six pictures"},
    LeftOut{"skyname", "a sky is a texture of two layers; there are no boxes of six pictures"},
    LeftOut{"target_autosave", "the game saves by itself"},
    LeftOut{"target_items", "the player carries keys alone"},
};

/// The reason of a key or class; empty for others.
constexpr std::string_view reason_left_out(std::string_view name) {
    const auto found = std::find_if(kLeftOut.begin(), kLeftOut.end(), [name](const LeftOut& row) {
        const bool is_family = row.name.ends_with('*');
        return is_family ? name.starts_with(row.name.substr(0, row.name.size() - 1)) : name == row.name;
    });
    return found == kLeftOut.end() ? std::string_view{} : found->reason;
}

}  // namespace oblong
