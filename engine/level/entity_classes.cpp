#include "engine/level/entity_classes.h"

#include <algorithm>

#include "engine/level/class_keys.h"

namespace oblong {

namespace class_keys {

using enum ClassShape;
using enum ClassRole;

namespace {

constexpr ClassBox kPlayerBox{{-16, -16, -24}, {16, 16, 32}}, kExitBox{{-32, -32, 0}, {32, 32, 64}},
    kCheckpointBox{{-64, -64, -56}, {64, 64, 56}}, kMarkBox{{-8, -8, -8}, {8, 8, 8}},
    kPickupBox{{-16, -16, -24}, {32, 32, 56}}, kMonsterBox{{-32, -32, -24}, {32, 32, 64}},
    kBossBox{{-128, -128, -24}, {128, 128, 256}}, kLastBossBox{{-160, -128, -24}, {160, 128, 256}};

// From Quake's game code (QuakeC: items.qc, misc.qc).
constexpr std::array kTorch{ClassModel{"progs/flame.mdl"}}, kSmallFlame{ClassModel{"progs/flame2.mdl"}},
    kLargeFlame{ClassModel{.file = "progs/flame2.mdl", .frame = 1}};
constexpr std::array kGreenArmour{ClassModel{"progs/armor.mdl"}},
    kYellowArmour{ClassModel{.file = "progs/armor.mdl", .skin = 1}},
    kRedArmour{ClassModel{.file = "progs/armor.mdl", .skin = 2}};
constexpr std::array kShotgun{ClassModel{"progs/g_shot.mdl"}}, kNailgun{ClassModel{"progs/g_nail.mdl"}},
    kSuperNailgun{ClassModel{"progs/g_nail2.mdl"}}, kGrenadeLauncher{ClassModel{"progs/g_rock.mdl"}},
    kRocketLauncher{ClassModel{"progs/g_rock2.mdl"}}, kThunderbolt{ClassModel{"progs/g_light.mdl"}};
constexpr std::array kSilverKeys{ClassModel{"progs/m_s_key.mdl", 0, 1}, ClassModel{"progs/b_s_key.mdl", 0, 2},
                                 ClassModel{"progs/w_s_key.mdl"}},
    kGoldKeys{ClassModel{"progs/m_g_key.mdl", 0, 1}, ClassModel{"progs/b_g_key.mdl", 0, 2},
              ClassModel{"progs/w_g_key.mdl"}};
constexpr std::array kSigils{ClassModel{"progs/end1.mdl", 1}, ClassModel{"progs/end2.mdl", 2},
                             ClassModel{"progs/end3.mdl", 4}, ClassModel{"progs/end4.mdl", 8}};
constexpr std::array kInvulnerability{ClassModel{"progs/invulner.mdl"}}, kSuit{ClassModel{"progs/suit.mdl"}},
    kInvisibility{ClassModel{"progs/invisibl.mdl"}}, kSuperDamage{ClassModel{"progs/quaddama.mdl"}};
constexpr std::array kHealth{ClassModel{"maps/b_bh10.bsp", 1}, ClassModel{"maps/b_bh100.bsp", 2},
                             ClassModel{"maps/b_bh25.bsp"}};
constexpr std::array kShells{ClassModel{"maps/b_shell1.bsp", 1}, ClassModel{"maps/b_shell0.bsp"}},
    kSpikes{ClassModel{"maps/b_nail1.bsp", 1}, ClassModel{"maps/b_nail0.bsp"}},
    kRockets{ClassModel{"maps/b_rock1.bsp", 1}, ClassModel{"maps/b_rock0.bsp"}},
    kCells{ClassModel{"maps/b_batt1.bsp", 1}, ClassModel{"maps/b_batt0.bsp"}};

constexpr std::string_view kLamp = "a light; with `target` or `mangle`, a spotlight",
                           kMonster = "not shown; fires, when the player comes near, what its death would",
                           kPickup = "shown if Quake's models are there; fires when touched",
                           kBox = "not shown; fires when touched", kOpen = "open, so not shown";

constexpr OwnModel kOwnSilverKey{"models/key_silver.obj", 28}, kOwnGoldKey{"models/key_gold.obj", 28},
    kOwnKey{"models/key_glass.obj", 28}, kOwnHealth{"models/health.obj", 16};

constexpr EntityClass point(std::string_view name, ClassRole role, std::string_view does,
                            const decltype(EntityClass::keys)& keys = {}, const ClassBox& box = {}) {
    return {name, Point, role, does, keys, box};
}
constexpr EntityClass brush(std::string_view name, ClassRole role, std::string_view does,
                            const decltype(EntityClass::keys)& keys) {
    return {name, Brush, role, does, keys};
}
constexpr EntityClass sounding(EntityClass row, std::string_view sound) {
    row.sound = sound;
    return row;
}
constexpr EntityClass taken(EntityClass row, std::span<const ClassModel> models, const OwnModel& own,
                            const ClassBox& box = kPlayerBox, std::int32_t over_floor = 24) {
    row.box = box;
    row.models = models;
    row.over_floor = over_floor;
    row.own_model = own;
    return row;
}
constexpr EntityClass lamp(std::string_view name, std::span<const ClassModel> models = {},
                           std::string_view sound = {}) {
    return sounding({name, Point, Lamp, kLamp, {kLight}, kMarkBox, models}, sound);
}
constexpr EntityClass ambience(std::string_view name, std::string_view does, std::string_view sound) {
    return sounding({name, Point, None, does}, sound);
}
constexpr EntityClass monster(std::string_view name, ClassRole role = Monster, const ClassBox& box = kMonsterBox) {
    return {name, Point, role, kMonster, {kTurned, kFires, kOfQuake}, box};
}
constexpr EntityClass pickup(std::string_view name, std::span<const ClassModel> models = {},
                             std::int32_t over_floor = 0) {
    return {name, Point, Pickup, kPickup, {kFires, kOfQuake}, kPickupBox, models, over_floor};
}

// The first match is used, so families come after their members.
constexpr auto kClasses = std::to_array<EntityClass>({
    {"worldspawn", WorldModel, Worldspawn, "the world", {kWorld, kSmooth, kLeastColour}},
    point("info_player_start", Start, "the player's start", {kTurned}, kPlayerBox),
    point("info_player_deathmatch", DeathmatchStart, "the player's start if there is no `info_player_start`", {kTurned},
          kPlayerBox),
    point("info_teleport_destination", TeleportExit, "a teleporter's exit", {kTurned}, kExitBox),
    point("info_checkpoint", Checkpoint, "the player respawns at the last one passed", {kTurned, kCheckpoint},
          kCheckpointBox),
    point("info_intermission", Intermission, "the view after the level's end", {kTurned, kIntermission}),
    point("info_null", None, "what a spotlight or a look points at"),
    point("info_notnull", None, "what a spotlight or a look points at"),
    lamp("light"),
    lamp("light_fluoro"),
    lamp("light_fluorospark"),
    lamp("light_globe"),
    lamp("light_torch_small_walltorch", kTorch, "fire"),
    lamp("light_flame_large_yellow", kLargeFlame, "fire"),
    lamp("light_flame_small_yellow", kSmallFlame, "fire"),
    lamp("light_flame_small_white", kSmallFlame, "fire"),
    lamp("light*"),
    brush("func_group", BrushGroup, "brushes of the world as a group", {kLitBrushes, kWorldShadow}),
    brush("func_detail", Detail, "solid, but does not split the level for visibility", {kLitBrushes, kWorldShadow}),
    brush("func_detail_wall", Detail, "solid, but does not split the level for visibility",
          {kLitBrushes, kWorldShadow}),
    brush("func_detail_fence", Detail, "as `func_detail`; brushes with `{` textures become a `func_wall`",
          {kLitBrushes, kWorldShadow, kInside}),
    brush("func_detail_illusionary", PassableDetail, "becomes a `func_illusionary`", {kMadeOfBrushes}),
    point("misc_external_map", ExternalMap,
          "inserts the brushes of another map source here, without its entities and `wad`", {kExternalMap}, kMarkBox),
    brush("func_wall", PlainWall, "a wall; activation switches its animated textures to their other frames",
          {kMadeOfBrushes}),
    brush("func_illusionary", Passable, "visible, but not solid", {kMadeOfBrushes}),
    brush("func_door", Door, "a door; doors that touch open together",
          {kTurned, kDoor, kFires, kNoise, kMadeOfBrushes}),
    brush("func_door_rotating", TurningDoor, "a door on a hinge; solid only while it is closed",
          {kTurningDoor, kFires, kNoise, kMadeOfBrushes}),
    brush("func_door_secret", SecretDoor, "a secret door: moves back or down, then sideways",
          {kTurned, kSecretDoor, kFires, kNoise, kMadeOfBrushes}),
    brush("func_button", Button, "a button: the player's touch presses it",
          {kTurned, kButton, kFires, kNoise, kMadeOfBrushes}),
    brush("func_plat", Lift, "a lift, drawn at its upper end; with a `targetname` it waits there until activated",
          {kLift, kNoise, kMadeOfBrushes}),
    brush("func_train", Train, "moves along `path_corner`s, with its box's least corner at each",
          {kTrain, kNoise, kMadeOfBrushes}),
    brush("func_rotating", Rotating, "turns about its `origin`, or the centre of its box; not solid; lit as models are",
          {kRotating, kMadeOfBrushes}),
    point("path_corner", None, "a corner of a `func_train`'s path", {kCorner}, kMarkBox),
    brush("trigger_once", TriggerOnce, "fires once when touched; with `angle`, only if the player looks that way",
          {kTurned, kTriggerOnce, kFires, kNoise}),
    brush("trigger_multiple", TriggerMultiple, "fires at each touch", {kTurned, kTriggerMultiple, kFires, kNoise}),
    brush("trigger_secret", TriggerSecret, "counts as a secret", {kTriggerOnce, kSecret, kFires, kNoise}),
    brush("trigger_onlyregistered", TriggerOnlyRegistered, "as `trigger_once`", {kFires, kNoise, kSounds}),
    {"trigger_relay", Either, TriggerRelay, "when activated, activates its targets", {kRelay, kFires, kNoise}},
    {"trigger_counter", Either, TriggerCounter, "fires after a number of activations", {kCounter, kFires, kNoise}},
    brush("trigger_teleport", TriggerTeleport,
          "moves the player to its target; with a `targetname`, only just after activation",
          {kTeleport, kFires, kNoise}),
    brush("trigger_push", TriggerPush, "pushes the player", {kTurned, kPush}),
    brush("trigger_changelevel", TriggerExit, "ends the level", {kExit, kFires, kNoise}),
    brush("trigger_view", TriggerView,
          "fires while the player inside looks its way, and the picture is drawn as its keys say",
          {kTurned, kView, kFires, kNoise}),
    brush("trigger_budget", TriggerView, "fires while the player's picture takes a 486 as long as its keys say",
          {kBudget, kFires, kNoise}),
    brush("trigger_hurt", TriggerHurt, "hurts the player inside, if the world has `health`; activation switches it",
          {kHurt, kFires, kNoise, kOfQuake}),
    {"func_timer", Either, Timer, "fires again and again; activation switches it", {kTimer, kFires, kNoise}},
    brush("trigger_ladder", TriggerLadder,
          "a ladder: jump, or look and walk up or down; with `angle`, only if the player looks that way", {kTurned}),
    brush("func_ladder", TriggerLadder, "as `trigger_ladder`", {kTurned}),
    brush(
        "func_breakable", Breakable,
        "a wall that goes when it is touched, as there are no shots, or with a `targetname` when activated; then fires",
        {kFires, kNoise, kMadeOfBrushes, kOfQuake}),
    point("play_sound_triggered", TriggerRelay, "when activated, plays its `noise` here", {kNoise, kPlayed}),
    point("play_sound", TimedSound, "plays its `noise` here again and again; activation switches it",
          {kNoise, kPlayedAgain, kPlayed}),
    {"event_lightning", Either, Lightning, "Chthon's lightning (Quake's e1m7)", {kFires}},
    taken(point("item_lens", Lens, "a lens to collect; fires when taken", {kFires, kNoise, kLens}), {},
          {"models/lens.obj"}),
    taken(point("item_key1", SilverKey, "the silver key", {kFires, kNoise, kSounds, kKeyModel}), kSilverKeys,
          kOwnSilverKey),
    taken(point("item_key2", GoldKey, "the gold key", {kFires, kNoise, kSounds, kKeyModel}), kGoldKeys, kOwnGoldKey),
    taken(point("item_key_custom", CustomKey, "a key of another name", {kCustomKey, kFires, kNoise, kKeyModel}), {},
          kOwnKey),
    point("misc_rain", Rain, "rain in a box", {kRain}),
    point("misc_dust", Dust, "dust in a box", {kDust}),
    point("misc_sparks", Sparks, "sparks in a box", {kSparks}),
    point("air_bubbles", Bubbles, "rising bubbles", {kBubbles}),
    point("misc_sprite", Billboard, "a texture with holes that always faces the camera", {kSprite}),
    sounding(point("misc_lantern", FlyingLamp, "a sprite with a light that moves in a circle", {kLantern}), "fire"),
    point("misc_model", TriangleModel, "a model of triangles", {kTurned, kModel}),
    ambience("ambient_drip", "sound of dripping", "water"),
    ambience("ambient_drone", "sound of a drone", "teleporter"),
    ambience("ambient_comp_hum", "sound of a hum", "hum"),
    ambience("ambient_flouro_buzz", "sound of a buzz", "hum"),
    ambience("ambient_light_buzz", "sound of a buzz", "hum"),
    ambience("ambient_suck_wind", "sound of wind", "wind"),
    ambience("ambient_swamp1", "sound of a swamp", "slime"),
    ambience("ambient_swamp2", "sound of a swamp", "slime"),
    monster("monster_army"),
    monster("monster_boss", Boss, kBossBox),
    monster("monster_demon1"),
    monster("monster_dog"),
    monster("monster_enforcer"),
    monster("monster_fish"),
    monster("monster_hell_knight"),
    monster("monster_knight"),
    monster("monster_ogre"),
    monster("monster_ogre_marksman"),
    monster("monster_oldone", LastBoss, kLastBossBox),
    monster("monster_shalrath"),
    monster("monster_shambler"),
    monster("monster_tarbaby"),
    monster("monster_wizard"),
    monster("monster_zombie"),
    monster("monster_*"),
    pickup("item_armor1", kGreenArmour),
    pickup("item_armor2", kYellowArmour),
    pickup("item_armorInv", kRedArmour),
    pickup("item_artifact_envirosuit", kSuit, 24),
    pickup("item_artifact_invisibility", kInvisibility, 24),
    pickup("item_artifact_invulnerability", kInvulnerability, 24),
    pickup("item_artifact_super_damage", kSuperDamage, 24),
    pickup("item_cells", kCells),
    taken(point("item_health", Health,
                "gives 25 of the health that the player has lost; where nothing hurts, as `item_spikes`",
                {kHealthItem, kFires, kNoise, kKeyModel, kOfQuake}),
          kHealth, kOwnHealth, kPickupBox, 0),
    pickup("item_rockets", kRockets),
    pickup("item_shells", kShells),
    pickup("item_sigil", kSigils, 24),
    pickup("item_spikes", kSpikes),
    pickup("item_weapon"),
    pickup("item_*"),
    pickup("weapon_grenadelauncher", kGrenadeLauncher),
    pickup("weapon_lightning", kThunderbolt),
    pickup("weapon_nailgun", kNailgun),
    pickup("weapon_rocketlauncher", kRocketLauncher),
    pickup("weapon_supernailgun", kSuperNailgun),
    pickup("weapon_supershotgun", kShotgun),
    pickup("weapon_*"),
    point("misc_explobox", Pickup, kBox, {kFires, kOfQuake}, kPickupBox),
    point("misc_explobox2", Pickup, kBox, {kFires, kOfQuake}, kPickupBox),
    point("misc_explobox*", Pickup, kBox, {kFires, kOfQuake}, kPickupBox),
    brush("func_episodegate", OpenGate, kOpen, {kMadeOfBrushes}),
    brush("func_bossgate", OpenGate, kOpen, {kMadeOfBrushes}),
    brush("func_dm_only", PlainWall, "a wall", {kMadeOfBrushes}),
    brush("func_*", PlainWall, "a wall", {kMadeOfBrushes}),
    brush("trigger_setskill", OtherTrigger, kNoEffect, {kFires, kOfQuake}),
    brush("trigger_monsterjump", OtherTrigger, kNoEffect, {kTurned, kOfQuake}),
    brush("trigger_*", OtherTrigger, kNoEffect, {kFires, kOfQuake}),
    point("info_player_start2", None, kNoEffect, {kTurned}, kPlayerBox),
    point("info_player_coop", None, kNoEffect, {kTurned}, kPlayerBox),
    point("testplayerstart", None, kNoEffect, {kTurned}),
    point("viewthing", None, kNoEffect, {kOfQuake}),
    point("ambient_thunder", None, kNoEffect),
    point("misc_fireball", None, kNoEffect, {kOfQuake}),
    point("misc_teleporttrain", None, kNoEffect, {kFires, kOfQuake}),
    point("misc_noisemaker", None, kNoEffect, {kOfQuake}),
    point("trap_shooter", None, kNoEffect, {kTurned, kFires, kOfQuake}),
    point("trap_spikeshooter", None, kNoEffect, {kTurned, kFires, kOfQuake}),
});

}  // namespace
}  // namespace class_keys

namespace {

using class_keys::kClasses;

bool is_of(const EntityClass& row, std::string_view name) {
    return row.is_family() ? name.starts_with(row.name.substr(0, row.name.size() - 1)) : name == row.name;
}

bool is_numbered(std::string_view row, std::string_view key) {
    if (!row.ends_with('#')) return row == key;
    row.remove_suffix(1);
    return key.starts_with(row) && key.find_first_not_of("0123456789", row.size()) == key.npos;
}

const EntityKey* find_key(std::span<const EntityKey> keys, std::string_view key) {
    const auto found =
        std::find_if(keys.begin(), keys.end(), [key](const EntityKey& row) { return is_numbered(row.name, key); });
    return found == keys.end() ? nullptr : &*found;
}

}  // namespace

std::span<const EntityClass> entity_classes() {
    return kClasses;
}

const EntityClass* find_entity_class(std::string_view class_name) {
    const auto found = std::find_if(kClasses.begin(), kClasses.end(),
                                    [class_name](const EntityClass& row) { return is_of(row, class_name); });
    return found == kClasses.end() ? nullptr : &*found;
}

const ClassModel* find_class_model(const EntityClass& its_class, std::int64_t flags, std::int64_t world_type) {
    const std::span<const ClassModel> models = its_class.models;
    const auto found = std::find_if(models.begin(), models.end(), [&](const ClassModel& each) {
        return (flags & each.spawn_flags) == each.spawn_flags &&
               (each.world_type < 0 || each.world_type == static_cast<std::int32_t>(world_type));
    });
    return found == models.end() ? nullptr : &*found;
}

const EntityKey* find_entity_key(const EntityClass& its_class, std::string_view key) {
    for (const std::span<const EntityKey> keys : its_class.keys)
        if (const EntityKey* found = find_key(keys, key)) return found;
    if (key == "_light" || key == "_skyfog" || (key.starts_with('_') && key.ends_with("alpha")))
        return find_entity_key(its_class, key.substr(1));
    if (key == "_sun_angle" || key == "_sunlight_mangle") return find_entity_key(its_class, "_sun_mangle");
    if (key == "_anglesense") return find_entity_key(its_class, "_anglescale");
    return find_key(keys_of_all(), key);
}

std::span<const EntityKey> keys_of_all() {
    return class_keys::kOfAll;
}

std::string since_text(std::string_view since) {
    return since == kRelease ? "" : " (since " + std::string(since) + ")";
}

std::string_view usual_text(std::string_view class_name, std::string_view key) {
    const EntityClass* const its_class = find_entity_class(class_name);
    const EntityKey* const row = its_class ? find_entity_key(*its_class, key) : nullptr;
    return row ? row->usual : "";
}

}  // namespace oblong
