#include "engine/files/model_classes.h"

#include <algorithm>
#include <array>

#include "engine/level/entities.h"

namespace oblong {
namespace {

/// The first that fits counts. After the game's own code, which id Software has published (QuakeC: items.qc, misc.qc).
constexpr std::array kModelClasses{
    ModelClass{"item_armor1", "progs/armor.mdl", 0, 0, 0},
    ModelClass{"item_armor2", "progs/armor.mdl", 0, 1, 0},
    ModelClass{"item_armorInv", "progs/armor.mdl", 0, 2, 0},
    ModelClass{"weapon_supershotgun", "progs/g_shot.mdl", 0, 0, 0},
    ModelClass{"weapon_nailgun", "progs/g_nail.mdl", 0, 0, 0},
    ModelClass{"weapon_supernailgun", "progs/g_nail2.mdl", 0, 0, 0},
    ModelClass{"weapon_grenadelauncher", "progs/g_rock.mdl", 0, 0, 0},
    ModelClass{"weapon_rocketlauncher", "progs/g_rock2.mdl", 0, 0, 0},
    ModelClass{"weapon_lightning", "progs/g_light.mdl", 0, 0, 0},
    ModelClass{"item_key1", "progs/m_s_key.mdl", 0, 0, 24, 0, 1},
    ModelClass{"item_key1", "progs/b_s_key.mdl", 0, 0, 24, 0, 2},
    ModelClass{"item_key1", "progs/w_s_key.mdl", 0, 0, 24},
    ModelClass{"item_key2", "progs/m_g_key.mdl", 0, 0, 24, 0, 1},
    ModelClass{"item_key2", "progs/b_g_key.mdl", 0, 0, 24, 0, 2},
    ModelClass{"item_key2", "progs/w_g_key.mdl", 0, 0, 24},
    ModelClass{"item_sigil", "progs/end1.mdl", 0, 0, 24, 1},
    ModelClass{"item_sigil", "progs/end2.mdl", 0, 0, 24, 2},
    ModelClass{"item_sigil", "progs/end3.mdl", 0, 0, 24, 4},
    ModelClass{"item_sigil", "progs/end4.mdl", 0, 0, 24, 8},
    ModelClass{"item_artifact_invulnerability", "progs/invulner.mdl", 0, 0, 24},
    ModelClass{"item_artifact_envirosuit", "progs/suit.mdl", 0, 0, 24},
    ModelClass{"item_artifact_invisibility", "progs/invisibl.mdl", 0, 0, 24},
    ModelClass{"item_artifact_super_damage", "progs/quaddama.mdl", 0, 0, 24},
    ModelClass{"item_health", "maps/b_bh10.bsp", 0, 0, 0, 1},
    ModelClass{"item_health", "maps/b_bh100.bsp", 0, 0, 0, 2},
    ModelClass{"item_health", "maps/b_bh25.bsp", 0, 0, 0},
    ModelClass{"item_shells", "maps/b_shell1.bsp", 0, 0, 0, 1},
    ModelClass{"item_shells", "maps/b_shell0.bsp", 0, 0, 0},
    ModelClass{"item_spikes", "maps/b_nail1.bsp", 0, 0, 0, 1},
    ModelClass{"item_spikes", "maps/b_nail0.bsp", 0, 0, 0},
    ModelClass{"item_rockets", "maps/b_rock1.bsp", 0, 0, 0, 1},
    ModelClass{"item_rockets", "maps/b_rock0.bsp", 0, 0, 0},
    ModelClass{"item_cells", "maps/b_batt1.bsp", 0, 0, 0, 1},
    ModelClass{"item_cells", "maps/b_batt0.bsp", 0, 0, 0},
    ModelClass{"light_torch_small_walltorch", "progs/flame.mdl"},
    ModelClass{"light_flame_large_yellow", "progs/flame2.mdl", 1},
    ModelClass{"light_flame_small_yellow", "progs/flame2.mdl"},
    ModelClass{"light_flame_small_white", "progs/flame2.mdl"},
};

}  // namespace

const ModelClass* model_class_of(const Entity& entity, std::int32_t world_type) {
    const std::string name = entity.value("classname");
    const std::int64_t flags = parse_decimal(entity.value("spawnflags"), 0).value_or(0);
    const auto found = std::find_if(kModelClasses.begin(), kModelClasses.end(), [&](const ModelClass& each) {
        return each.name == name && (flags & each.spawn_flags) == each.spawn_flags &&
               (each.world_type < 0 || each.world_type == world_type);
    });
    return found == kModelClasses.end() ? nullptr : &*found;
}

}  // namespace oblong
