#include "engine/level/entity_classes.h"

#include <algorithm>

namespace oblong {

namespace {

using enum KeyKind;
using enum ClassShape;

// Classes and keys are those of Quake's game code, which id Software has published (QuakeC: "QUAKED" comments), of its
// level compilers and their successors (ericw-tools), and Oblong's own.

constexpr std::string_view kNoEffect = "";

constexpr EntityKey number(std::string_view name, std::string_view usual, std::string_view does) {
    return {name, Numbers, usual, does};
}
constexpr EntityKey numbers(std::string_view name, std::uint8_t least, std::uint8_t most, std::string_view usual,
                            std::string_view does) {
    return {name, Numbers, usual, does, {}, least, most};
}
constexpr EntityKey flags(std::span<const KeyValue> values) {
    return {"spawnflags", Flags, "0", "sum of its flags", values};
}
constexpr EntityKey required(EntityKey key) {
    key.is_required = true;
    return key;
}

constexpr std::array kFalloffs{KeyValue{"0", "linear"}, KeyValue{"1", "1 / distance"},
                               KeyValue{"2", "1 / distance squared"}, KeyValue{"3", "not at all"},
                               KeyValue{"5", "1 / distance squared, softer near by"}};
constexpr std::array kUps{KeyValue{"y", "y"}, KeyValue{"z", "z"}};
constexpr std::array kShadings{KeyValue{"flat", "a colour a triangle"}, KeyValue{"gouraud", "between corners"},
                               KeyValue{"phong", "a normal a pixel"}};
constexpr std::array kNoYes{KeyValue{"0", "no"}, KeyValue{"1", "yes"}};

constexpr std::array kSkillFlags{KeyValue{"256", "not at easy skill (Quake)"}, KeyValue{"512", "left out"},
                                 KeyValue{"1024", "not at hard skill (Quake)"},
                                 KeyValue{"2048", "not in deathmatch (Quake)"}};
constexpr std::array kLightFlags{KeyValue{"1", "starts dark (needs a name)"}};
constexpr std::array kDoorFlags{KeyValue{"1", "starts open"}, KeyValue{"4", "does not open with doors that it touches"},
                                KeyValue{"8", "needs the gold key"}, KeyValue{"16", "needs the silver key"},
                                KeyValue{"32", "stays until activated again"}};
constexpr std::array kSecretFlags{KeyValue{"1", "opens once"}, KeyValue{"2", "first to the left"},
                                  KeyValue{"4", "first down"}, KeyValue{"8", "not by shots (Quake)"},
                                  KeyValue{"16", "by a touch though it has a name"}};
constexpr std::array kLiftFlags{KeyValue{"1", "only who stands low calls it"}};
constexpr std::array kTriggerFlags{KeyValue{"1", "not by touch"}};
constexpr std::array kCounterFlags{KeyValue{"1", "does not say how many are left"}};
constexpr std::array kPushFlags{KeyValue{"1", "once"}};
constexpr std::array kExitFlags{KeyValue{"1", "no intermission (Quake)"}};

// What every entity may have.
constexpr std::array kOfAll{
    EntityKey{"classname", Text, "", "its class"},
    numbers("origin", 3, 3, "", "its place: x y z"),
    EntityKey{"targetname", Name, "", "the name that others target"},
    flags(kSkillFlags),
    numbers("light", 1, 4, "", "of what has a place: it shines as a `light` does"),
};
constexpr std::array kTurned{
    number("angle", "0", "degrees from east to north; -1 is up, -2 down"),
    numbers("angles", 3, 3, "", "pitch yaw roll in degrees, in place of `angle`"),
};
constexpr std::array kFires{
    EntityKey{"target", Target, "", "what it activates"},
    EntityKey{"killtarget", Target, "", "what it removes"},
    number("delay", "0", "seconds before it does"),
    EntityKey{"message", Text, "", "text that is shown; {jump} is the key of an action"},
};
constexpr std::array kMadeOfBrushes{
    number("_minlight", "0", "its least light, 0 to 255"),
    number("dmg", "", kNoEffect),
    EntityKey{"sounds", Whole, "", kNoEffect},
};

constexpr std::array kWorld{
    EntityKey{"message", Text, "", "the level's title"},
    EntityKey{"wad", Text, "", "WAD files for the editor; `oblong-map` takes `--wad`"},
    EntityKey{"worldtype", Whole, "0", "0 to 2: how keys look (Quake's models)"},
    EntityKey{"mapversion", Whole, "", "220: the source is in Valve's format"},
    EntityKey{"sounds", Whole, "", kNoEffect},
    numbers("light", 1, 4, "0", "least light everywhere, 0 to 255"),
    number("_minlight", "0", "the same, and wins over `light`"),
    number("_sunlight", "0", "light that comes from the sky"),
    numbers("_sun_mangle", 2, 3, "0 -90 0", "where that shines: yaw pitch roll, pitch negative is down"),
    numbers("fog", 4, 9, "", "density red green blue [alpha mindist maxdist [top fadedepth]]"),
    number("skyfog", "0.5", "share of the fog on the sky, 0 to 1"),
    number("wateralpha", "1", "0 to 1: of liquids but those below"),
    number("slimealpha", "1", "0 to 1: of liquids with `slime` in their names"),
    number("lavaalpha", "1", "0 to 1: of liquids with `lava` in their names"),
    number("telealpha", "1", "0 to 1: of liquids with `tele` in their names"),
    numbers("palette_cycle#", 3, 3, "", "colours that take turns: first last steps_per_second"),
};
constexpr std::array kLight{
    numbers("light", 1, 4, "300", "brightness; negative takes light away; of a colour only the brightness counts"),
    number("wait", "1", "how fast it fades: a factor of the distance"),
    EntityKey{"delay", Choice, "0", "how it fades", kFalloffs},
    EntityKey{"style", Whole, "0", "flicker: 0 to 11 Quake's, 32 to 63 to be switched or with a `pattern`"},
    EntityKey{"pattern", Text, "", "letters a (dark) to z, ten a second, of a style from 32 on"},
    EntityKey{"target", Place, "", "makes it a spotlight that points there"},
    numbers("mangle", 2, 3, "", "makes it a spotlight: yaw pitch roll, pitch negative is down"),
    number("angle", "40", "degrees of a spotlight's cone"),
    number("radius", "0", "what is as near as this throws no shadow in its light: the body of a lamp"),
    flags(kLightFlags),
};
constexpr std::array kDoor{
    number("speed", "100", "units a second"),
    number("wait", "3", "seconds that it stays open; -1: for ever"),
    number("lip", "8", "units of it that stay in sight when it is open"),
    number("health", "0", "above 0: a touch opens it, as a shot would"),
    flags(kDoorFlags),
};
constexpr std::array kSecretDoor{
    number("wait", "5", "seconds that it stays open"),
    number("t_width", "", "how far it goes first; its own width else"),
    number("t_length", "", "how far then; its own length else"),
    number("health", "", kNoEffect),
    number("speed", "", kNoEffect),
    flags(kSecretFlags),
};
constexpr std::array kButton{
    number("speed", "40", "units a second"),
    number("wait", "1", "seconds that it stays pressed; -1: for ever"),
    number("lip", "4", "units of it that stay in sight"),
    number("health", "0", "as of a `func_door`"),
};
constexpr std::array kLift{
    number("speed", "150", "units a second"),
    number("height", "", "how far down; its own height less 8 else"),
    flags(kLiftFlags),
};
constexpr std::array kTrain{
    required({"target", Place, "", "the first `path_corner`"}),
    number("speed", "100", "units a second"),
};
constexpr std::array kCorner{
    EntityKey{"target", Place, "", "the next `path_corner`"},
    number("wait", "0", "seconds that a train stays; -1: until it is activated"),
};
constexpr std::array kTriggerOnce{
    number("health", "0", "above 0: worked as if it were shot, by who comes near"),
    number("wait", "", kNoEffect),
    EntityKey{"sounds", Whole, "", kNoEffect},
    flags(kTriggerFlags),
};
constexpr std::array kTriggerMultiple{
    number("health", "0", "as of a `trigger_once`"),
    number("wait", "0.2", "seconds before it works again"),
    EntityKey{"sounds", Whole, "", kNoEffect},
    flags(kTriggerFlags),
};
constexpr std::array kCounter{
    number("count", "2", "how many activations it takes"),
    EntityKey{"sounds", Whole, "", kNoEffect},
    flags(kCounterFlags),
};
constexpr std::array kTeleport{
    required({"target", Place, "", "its exit"}),
    EntityKey{"sounds", Whole, "", kNoEffect},
};
constexpr std::array kPush{
    number("speed", "1000", "tenths of units a second"),
    flags(kPushFlags),
};
constexpr std::array kExit{
    required({"map", Text, "", "the next level's name"}),
    flags(kExitFlags),
};
constexpr std::array kSounds{EntityKey{"sounds", Whole, "", kNoEffect}};
constexpr std::array kLens{
    EntityKey{"netname", Text, "", "what the player is told that is missing"},
    EntityKey{"glass", Text, "glass", "its glass: a material of `models.mtl`"},
};
constexpr std::array kCheckpoint{numbers("size", 3, 3, "128 128 112", "of the box in which one passes it")};

constexpr EntityKey kCount = number("count", "", "how many particles"),
                    kColour = numbers("colour", 1, 2, "", "a colour of the palette, or a ramp's two ends");
constexpr EntityKey with_usual(EntityKey key, std::string_view usual) {
    key.usual = usual;
    return key;
}
constexpr std::array<EntityKey, 4> emitter(std::string_view size, std::string_view count, std::string_view period,
                                           std::string_view colours) {
    return {numbers("size", 3, 3, size, "of its box"), with_usual(kCount, count),
            number("period", period, "seconds of a round"), with_usual(kColour, colours)};
}
// Colours are those of Quake's palette: greys, browns, fire from light to dark.
constexpr std::array kRain = emitter("256 256 256", "400", "0.7", "8 11");
constexpr std::array kDust = emitter("256 256 128", "100", "20", "6 9");
constexpr std::array kSparks = emitter("64 64 48", "40", "0.9", "111 104");
constexpr std::array kBubbles = emitter("32 32 96", "12", "4", "11 13");

constexpr std::array kSprite{
    required({"texture", Texture, "", "its texture"}),
    number("scale", "1", "how large, 1/16 to 16"),
    number("shadow", "0", "radius of a shadow on the floor"),
};
constexpr std::array kLantern{
    required({"texture", Texture, "", "its texture"}),
    number("scale", "1", "how large, 1/16 to 16"),
    number("radius", "64", "of the circle that it goes in"),
    number("light", "200", "how far it shines"),
    number("period", "8", "seconds of a round"),
};
constexpr std::array kModel{
    required({"model", Text, "", "its file, MDL or OBJ"}),
    EntityKey{"frame", Whole, "0", "first frame"},
    EntityKey{"frames", Whole, "1", "how many are shown in turn, a tenth of a second each"},
    EntityKey{"skin", Whole, "0", "skin of an MDL"},
    number("scale", "1", "how many times as large"),
    EntityKey{"up", Choice, "y", "the axis that is up in an OBJ", kUps},
    number("period", "", "seconds for a whole turn"),
    EntityKey{"shading", Choice, "gouraud", "how its triangles are shaded", kShadings},
    EntityKey{"highlight", Whole, "0", "0 to 255: of a Phong highlight"},
    EntityKey{"least_light", Whole, "0", "0 to 255: of what glows by itself"},
    EntityKey{"dither", Choice, "0", "dithered PNGs of an OBJ", kNoYes},
};
// Of Quake's game alone.
constexpr std::array kOfQuake{
    number("speed", "", kNoEffect),         number("height", "", kNoEffect),
    number("dmg", "", kNoEffect),           number("wait", "", kNoEffect),
    number("health", "", kNoEffect),        EntityKey{"sounds", Whole, "", kNoEffect},
    number("count", "", kNoEffect),         number("style", "", kNoEffect),
    EntityKey{"mdl", Text, "", kNoEffect},  EntityKey{"model", Text, "", kNoEffect},
    numbers("mangle", 3, 3, "", kNoEffect),
};

// The first that fits counts, so that families come after their members.
constexpr std::array kClasses{
    EntityClass{"worldspawn", Worldspawn, "the world", {kWorld}},
    EntityClass{"info_player_start", Point, "where the player comes in", {kTurned}},
    EntityClass{"info_player_deathmatch", Point, "taken where there is no `info_player_start`", {kTurned}},
    EntityClass{"info_teleport_destination", Point, "a teleporter's exit", {kTurned}},
    EntityClass{
        "info_checkpoint", Point, "the respawn button leads back to the one passed last", {kTurned, kCheckpoint}},
    EntityClass{"info_null", Point, "what a spotlight points at", {}},
    EntityClass{"info_notnull", Point, "the same", {}},
    EntityClass{"light", Point, "light; with `target` or `mangle` a spotlight", {kLight}},
    EntityClass{
        "light_", Point, "the same: Quake's torches and lamps, with its models where they are at hand", {kLight}},
    EntityClass{"func_group", Brush, "brushes of the world, grouped", {}},
    EntityClass{"func_detail", Brush, "solid, but hides nothing: it does not cut the level", {}},
    EntityClass{"func_detail_wall", Brush, "the same", {}},
    EntityClass{"func_detail_fence", Brush, "the same; brushes with `{` textures become a `func_wall`", {}},
    EntityClass{"func_detail_illusionary", Brush, "becomes a `func_illusionary`", {}},
    EntityClass{
        "func_wall", Brush, "a wall; shows the other frames of its textures when it is activated", {kMadeOfBrushes}},
    EntityClass{"func_illusionary", Brush, "is seen and stops nobody", {kMadeOfBrushes}},
    EntityClass{"func_door", Brush, "a door; those that touch open together", {kTurned, kDoor, kFires, kMadeOfBrushes}},
    EntityClass{
        "func_door_secret", Brush, "goes back or down, then sideways", {kTurned, kSecretDoor, kFires, kMadeOfBrushes}},
    EntityClass{"func_button", Brush, "activates when it is touched", {kTurned, kButton, kFires, kMadeOfBrushes}},
    EntityClass{"func_plat",
                Brush,
                "a lift, drawn at its upper end; with a name it waits there until activated",
                {kLift, kMadeOfBrushes}},
    EntityClass{"func_train",
                Brush,
                "goes from `path_corner` to `path_corner` by the low corner of its box",
                {kTrain, kMadeOfBrushes}},
    EntityClass{"path_corner", Point, "a corner of a train's way", {kCorner}},
    EntityClass{"trigger_once",
                Brush,
                "fires once; with an angle only for who looks that way",
                {kTurned, kTriggerOnce, kFires}},
    EntityClass{"trigger_multiple", Brush, "fires again and again", {kTurned, kTriggerMultiple, kFires}},
    EntityClass{"trigger_secret", Brush, "counts as a secret", {kTriggerOnce, kFires}},
    EntityClass{"trigger_onlyregistered", Brush, "as `trigger_once`", {kFires, kSounds}},
    EntityClass{"trigger_relay", Either, "passes an activation on", {kFires}},
    EntityClass{"trigger_counter", Either, "fires when it was activated often enough", {kCounter, kFires}},
    EntityClass{"trigger_teleport",
                Brush,
                "takes the player to its target; with a name only just after activation",
                {kTeleport, kFires}},
    EntityClass{"trigger_push", Brush, "pushes the player", {kTurned, kPush}},
    EntityClass{"trigger_changelevel", Brush, "the level's end", {kExit, kFires}},
    EntityClass{"event_lightning", Either, "Chthon's lightning (Quake's e1m7)", {kFires}},
    EntityClass{"item_lens", Point, "a lens; fires when it is taken", {kFires, kLens}},
    EntityClass{"item_key1", Point, "the silver key", {kFires, kSounds}},
    EntityClass{"item_key2", Point, "the gold key", {kFires, kSounds}},
    EntityClass{"misc_rain", Point, "rain in a box", {kRain}},
    EntityClass{"misc_dust", Point, "dust in a box", {kDust}},
    EntityClass{"misc_sparks", Point, "sparks in a box", {kSparks}},
    EntityClass{"air_bubbles", Point, "bubbles that rise from here", {kBubbles}},
    EntityClass{"misc_sprite", Point, "a texture with holes that turns to the eye", {kSprite}},
    EntityClass{"misc_lantern", Point, "a sprite with a light, which goes in a circle", {kLantern}},
    EntityClass{"misc_model", Point, "a model of triangles", {kTurned, kModel}},
    EntityClass{"ambient_drip", Point, "sound of dripping", {}},
    EntityClass{"ambient_drone", Point, "drone", {}},
    EntityClass{"ambient_comp_hum", Point, "hum", {}},
    EntityClass{"ambient_flouro_buzz", Point, "buzz", {}},
    EntityClass{"ambient_light_buzz", Point, "buzz", {}},
    EntityClass{"ambient_suck_wind", Point, "wind", {}},
    EntityClass{"ambient_swamp1", Point, "sound of a swamp", {}},
    EntityClass{"ambient_swamp2", Point, "sound of a swamp", {}},
    EntityClass{
        "monster_", Point, "not there, but fires where it is met what its death would", {kTurned, kFires, kOfQuake}},
    EntityClass{"item_", Point, "seen with Quake's models; fires when it is touched", {kFires, kOfQuake}},
    EntityClass{"weapon_", Point, "the same", {kFires, kOfQuake}},
    EntityClass{"misc_explobox", Point, "not there, but fires when it is touched", {kFires, kOfQuake}},
    EntityClass{"misc_explobox2", Point, "the same", {kFires, kOfQuake}},
    EntityClass{"func_episodegate", Brush, "open: not there", {kMadeOfBrushes}},
    EntityClass{"func_bossgate", Brush, "open: not there", {kMadeOfBrushes}},
    EntityClass{"func_dm_only", Brush, "a wall", {kMadeOfBrushes}},
    EntityClass{"trigger_hurt", Brush, kNoEffect, {kOfQuake}},
    EntityClass{"trigger_setskill", Brush, kNoEffect, {kFires, kOfQuake}},
    EntityClass{"trigger_monsterjump", Brush, kNoEffect, {kTurned, kOfQuake}},
    EntityClass{"info_player_start2", Point, kNoEffect, {kTurned}},
    EntityClass{"info_player_coop", Point, kNoEffect, {kTurned}},
    EntityClass{"info_intermission", Point, kNoEffect, {kTurned, kOfQuake}},
    EntityClass{"testplayerstart", Point, kNoEffect, {kTurned}},
    EntityClass{"viewthing", Point, kNoEffect, {kOfQuake}},
    EntityClass{"misc_fireball", Point, kNoEffect, {kOfQuake}},
    EntityClass{"misc_teleporttrain", Point, kNoEffect, {kFires, kOfQuake}},
    EntityClass{"misc_noisemaker", Point, kNoEffect, {kOfQuake}},
    EntityClass{"trap_", Point, kNoEffect, {kTurned, kFires, kOfQuake}},
    EntityClass{"test_", Either, kNoEffect, {kFires, kOfQuake}},
};

bool is_of_family(std::string_view family, std::string_view name) {
    return name == family || (family.ends_with('_') && name.starts_with(family) && name.size() > family.size());
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
    const auto found = std::find_if(kClasses.begin(), kClasses.end(), [class_name](const EntityClass& row) {
        return is_of_family(row.name, class_name);
    });
    return found == kClasses.end() ? nullptr : &*found;
}

const EntityKey* find_entity_key(const EntityClass& its_class, std::string_view key) {
    for (const std::span<const EntityKey> keys : its_class.keys)
        if (const EntityKey* found = find_key(keys, key)) return found;
    if (key == "_light" || (key.starts_with('_') && key.ends_with("alpha")))
        return find_entity_key(its_class, key.substr(1));
    return find_key(keys_of_all(), key);
}

std::span<const EntityKey> keys_of_all() {
    return kOfAll;
}

std::string_view usual_text(std::string_view class_name, std::string_view key) {
    const EntityClass* const its_class = find_entity_class(class_name);
    const EntityKey* const row = its_class ? find_entity_key(*its_class, key) : nullptr;
    return row ? row->usual : "";
}

}  // namespace oblong
