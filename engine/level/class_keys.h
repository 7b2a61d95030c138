#pragma once

#include <algorithm>
#include <array>

#include "engine/level/entity_classes.h"

namespace oblong::class_keys {

using enum KeyKind;

// The keys of entity_classes.cpp: those of Quake's published game code (QuakeC: "QUAKED" comments), of its level
// compilers and their successors (ericw-tools), and Oblong's.

inline constexpr std::string_view kNoEffect = "";

inline constexpr EntityKey number(std::string_view name, std::string_view usual, std::string_view does) {
    return {name, Numbers, usual, does};
}
inline constexpr EntityKey numbers(std::string_view name, std::uint8_t least, std::uint8_t most, std::string_view usual,
                                   std::string_view does) {
    return {name, Numbers, usual, does, {}, least, most};
}
inline constexpr EntityKey flags(std::span<const KeyValue> values) {
    return {"spawnflags", Flags, "0", "sum of these flags", values};
}
inline constexpr EntityKey within(World least, World most, EntityKey key) {
    key.range = NumberRange{least, most};
    return key;
}
inline constexpr EntityKey within(std::int32_t least, std::int32_t most, const EntityKey& key) {
    return within(World::from_int(least), World::from_int(most), key);
}
inline constexpr EntityKey required(EntityKey key) {
    key.is_required = true;
    return key;
}
template <class Row, std::size_t... Sizes>
constexpr auto joined(const std::array<Row, Sizes>&... groups) {
    std::array<Row, (Sizes + ...)> all;
    auto next = all.begin();
    ((next = std::copy(groups.begin(), groups.end(), next)), ...);
    return all;
}
template <class... Names>
constexpr std::array<EntityKey, sizeof...(Names)> without_effect(Names... names) {
    return {number(names, "", kNoEffect)...};
}
/// Values that say it all.
template <class... Names>
constexpr std::array<KeyValue, sizeof...(Names)> values(Names... names) {
    return {KeyValue{names, ""}...};
}

inline constexpr std::array kFalloffs{KeyValue{"0", "linear"}, KeyValue{"1", "1 / distance"},
                                      KeyValue{"2", "1 / distance squared"}, KeyValue{"3", "constant"},
                                      KeyValue{"5", "1 / distance squared, less bright close by"}};
inline constexpr std::array kStyles{KeyValue{"0", "steady"},
                                    KeyValue{"1", "flickers"},
                                    KeyValue{"2", "slow pulse"},
                                    KeyValue{"3", "candle"},
                                    KeyValue{"4", "fast strobe"},
                                    KeyValue{"5", "gentle pulse"},
                                    KeyValue{"6", "flickers more"},
                                    KeyValue{"7", "second candle"},
                                    KeyValue{"8", "third candle"},
                                    KeyValue{"9", "slow strobe"},
                                    KeyValue{"10", "fluorescent"},
                                    KeyValue{"11", "slow pulse, never dark"},
                                    KeyValue{"32", "own pattern, or switched"}};
inline constexpr std::array kUps{KeyValue{"y", "y"}, KeyValue{"z", "z"}};
inline constexpr std::array kShadings{KeyValue{"flat", "one colour per triangle"},
                                      KeyValue{"gouraud", "interpolated between corners"},
                                      KeyValue{"phong", "a normal per pixel"}};
inline constexpr auto kPresetValues = joined(values("1991", "1994", "1996", "pixel", "bounded", "exact"),
                                             std::array{KeyValue{"other", "dials of its own"}});
inline constexpr auto kProjectionValues = values("square", "display");
inline constexpr auto kDisplayValues = values("display", "square", "fill");
inline constexpr auto kOffOn = values("off", "on");
inline constexpr auto kWireframeValues = values("off", "over", "alone");
inline constexpr auto kZoomValues =
    values("off", "10", "20", "30", "40", "50", "60", "70", "80", "90", "100", "110", "120");
inline constexpr auto kMachineValues = values("386", "486", "pentium", "today");
inline constexpr std::array kNoYes{KeyValue{"0", "no"}, KeyValue{"1", "yes"}};

inline constexpr std::array kSkillFlags{
    KeyValue{"256", "not at easy skill (Quake)"}, KeyValue{"512", "left out (not at normal skill)"},
    KeyValue{"1024", "not at hard skill (Quake)"}, KeyValue{"2048", "not in deathmatch (Quake)"}};
inline constexpr std::array kLightFlags{KeyValue{"1", "starts dark (needs a name)"}};
inline constexpr std::array kDoorFlags{KeyValue{"1", "starts open"},
                                       KeyValue{"4", "does not open with doors that it touches"},
                                       KeyValue{"8", "needs the gold key"}, KeyValue{"16", "needs the silver key"},
                                       KeyValue{"32", "stays until activated again"}};
inline constexpr std::array kTurningDoorFlags{kDoorFlags[1],
                                              kDoorFlags[2],
                                              kDoorFlags[3],
                                              kDoorFlags[4],
                                              KeyValue{"2", "clockwise"},
                                              KeyValue{"64", "about the x axis"},
                                              KeyValue{"128", "about the y axis"}};
inline constexpr std::array kSecretFlags{
    KeyValue{"1", "opens once"}, KeyValue{"2", "moves left first"}, KeyValue{"4", "moves down first"},
    KeyValue{"8", "not opened by shots (Quake)"}, KeyValue{"16", "opens by touch although it has a `targetname`"}};
inline constexpr std::array kLiftFlags{KeyValue{"1", "called from its lower end only"}};
inline constexpr std::array kRotatingFlags{KeyValue{"4", "about the x axis"}, KeyValue{"8", "about the y axis"}};
inline constexpr std::array kTriggerFlags{KeyValue{"1", "not activated by touch"}};
inline constexpr std::array kCounterFlags{KeyValue{"1", "no message with the number left"}};
inline constexpr std::array kPushFlags{KeyValue{"1", "once"}};
inline constexpr std::array kHurtFlags{KeyValue{"1", "starts off"}};
inline constexpr std::array kTimerFlags{KeyValue{"1", "starts on"}};
inline constexpr std::array kHealthFlags{KeyValue{"1", "15"}, KeyValue{"2", "100"}};
inline constexpr std::array kExitFlags{KeyValue{"1", "no intermission (Quake)"}};

inline constexpr EntityKey kSoundsKey{"sounds", Whole, "", kNoEffect};
inline constexpr std::array kSounds{kSoundsKey};

// Keys of every entity.
inline constexpr std::array kOfAll{
    EntityKey{"classname", Text, "", "its class"},
    numbers("origin", 3, 3, "", "position: x y z"),
    EntityKey{"targetname", Name, "", "the name that others target"},
    flags(kSkillFlags),
    numbers("light", 1, 4, "", "an entity with a position shines like a `light` of this brightness"),
};
inline constexpr std::array kTurned{
    number("angle", "0", "degrees from east to north; -1 is up, -2 down"),
    numbers("angles", 3, 3, "", "pitch yaw roll in degrees, in place of `angle`"),
};
inline constexpr std::array kFires{
    EntityKey{"target", Target, "", "the `targetname` of what it activates"},
    EntityKey{"target2", Target, "", "of more that it activates"},
    EntityKey{"killtarget", Target, "", "the `targetname` of what it removes"},
    number("delay", "0", "seconds until it activates its targets"),
    EntityKey{
        "message", Text, "",
        "text shown to the player, in UTF-8; {jump} stands for the key of that action; backslash and p begin a page"},
};
inline constexpr std::array kSmooth{
    number("_phong", "0", "1: light is interpolated across edges, as on a round surface"),
    number("_phong_angle", "89", "largest angle in degrees between faces that `_phong` smooths"),
    number("_phong_group", "0", "`_phong` smooths within groups of one number"),
};
inline constexpr std::array kLeastColour{numbers("_minlight_color", 3, 3, "", "colour of the least light")};
inline constexpr auto kLitBrushes = joined(kSmooth, kLeastColour,
                                           std::array{
                                               number("_minlight", "0", "least light on it, 0 to 255"),
                                               number("_lightignore", "0", "1: no light but the least"),
                                               number("_dirt", "0", "-1: no dirt on it"),
                                           });
// Of what belongs to the world: it always casts shadows.
inline constexpr std::array kWorldShadow{number("_shadow", "", kNoEffect)};
inline constexpr std::array kNoise{
    EntityKey{"noise", Text, "",
              "a FLAC or WAV file in place of the usual sound: path below the game's or the level's folder"},
};
inline constexpr std::array kInside{number("_mirrorinside", "0", "1: its faces are seen from inside, too")};
inline constexpr auto kMadeOfBrushes = joined(kLitBrushes, kInside,
                                              std::array{
                                                  number("_shadow", "0", "1: it casts shadows, from where it begins"),
                                                  number("alpha", "1", "opacity, above 0 to 1"),
                                                  number("dmg", "", kNoEffect),
                                                  kSoundsKey,
                                              });

inline constexpr std::array kWorld{
    EntityKey{"message", Text, "", "the level's title"},
    EntityKey{"music", Text, "", "a tracker module: path below the game's or the level's folder"},
    EntityKey{"wad", Text, "", "WAD files and folders of pictures with its textures, separated by `;`"},
    EntityKey{"worldtype", Whole, "0", "0 to 2: which of Quake's key models are shown"},
    EntityKey{"mapversion", Whole, "", "220: the source is in Valve's format"},
    number("health", "0", "the player's, up to 999; without it nothing hurts"),
    number("angle", "", kNoEffect),
    kSoundsKey,
    numbers("light", 1, 4, "0", "least light everywhere, 0 to 255"),
    number("_minlight", "0", "the same; overrides `light`"),
    number("_sunlight", "0", "brightness of the sun: parallel light from sky faces"),
    number("_sunlight_penumbra", "0", "diameter of the sun in degrees, up to 90: softens edges of its shadows"),
    number("_sunlight2", "0", "brightness of the sky's upper half, as on an overcast day"),
    number("_sunlight3", "0", "the same for the lower half"),
    numbers("_sunlight_color", 3, 3, "", "colour of the sun"),
    numbers("_sunlight2_color", 3, 3, "", "likewise, of the sky's upper half"),
    numbers("_sunlight3_color", 3, 3, "", "likewise, of the lower half"),
    number("_dirt", "0", "1: corners are darker (ambient occlusion), as with `--dirt`"),
    number("_dirtdepth", "128", "distance in units up to which a surface darkens another"),
    number("_dirtscale", "1", "factor of that darkening"),
    number("_dirtgain", "1", "exponent of that darkening"),
    number("_bounce", "0", "how many times light is reflected; `--bounce`: once"),
    number("_bouncescale", "1", "factor of reflected light"),
    number("_bouncecolorscale", "1", "share of a texture's colour in the light that it reflects, 0 to 1"),
    number("_bouncestyled", "0", "1: flickering and switchable light is reflected, too"),
    number("_anglescale", "0.5", "how much slanting light loses, 0 to 1: at 1 it follows Lambert's law"),
    numbers("_sun_mangle", 2, 3, "0 -90 0", "direction of the sun's light: yaw pitch roll; negative pitch is down"),
    numbers("fog", 4, 9, "", "density red green blue [alpha mindist maxdist [top fadedepth]]"),
    number("skyfog", "0.5", "share of fog on the sky, 0 to 1"),
    number("wateralpha", "1", "opacity of liquids without a key of their own, 0 to 1"),
    number("slimealpha", "1", "opacity of liquids with `slime` in their names, 0 to 1"),
    number("lavaalpha", "1", "opacity of liquids with `lava` in their names, 0 to 1"),
    number("telealpha", "1", "opacity of liquids with `tele` in their names, 0 to 1"),
    numbers("palette_cycle#", 3, 3, "", "palette colours that rotate: first last steps_per_second"),
};
inline constexpr std::array kExternalMap{
    required({"_external_map", Text, "", "the map source: path relative to this one"}),
    EntityKey{"_external_map_classname", Text, "func_group",
              "class of the entity made of its brushes; other keys are copied to it"},
    numbers("_external_map_angles", 3, 3, "0 0 0", "rotation: pitch yaw roll; positive pitch is down"),
    number("_external_map_angle", "0", "rotation: yaw only"),
    numbers("_external_map_scale", 1, 3, "1", "scale, or one for each axis"),
};
inline constexpr std::array kLight{
    numbers("light", 1, 4, "300", "brightness, or red green blue brightness; negative subtracts light"),
    number("wait", "1", "factor of the distance: larger fades faster"),
    EntityKey{"delay", Choice, "0", "how light fades with distance", kFalloffs},
    within(0, 63,
           {"style", Whole, "0", "flicker: 0 to 11 are Quake's; 32 to 63 for switched lights or a `pattern`", kStyles}),
    EntityKey{"pattern", Text, "", "brightness of styles 32 to 63: letters a (dark) to z, ten a second"},
    EntityKey{"target", Place, "", "makes it a spotlight that points at this entity"},
    numbers("mangle", 2, 3, "", "makes it a spotlight: yaw pitch roll; negative pitch is down"),
    number("angle", "40", "angle of a spotlight's cone in degrees"),
    number("_softangle", "0", "angle of the cone within which it is at its full"),
    number("_anglescale", "", "the same for this light, in place of the world's"),
    number("_deviance", "0", "radius in units of a ball that shines, for soft edges of shadows"),
    number("_samples", "16", "lights all over that ball, up to 64"),
    numbers("_color", 3, 3, "", "colour, 0 to 255 or 0 to 1"),
    EntityKey{"_surface", Text, "", "a texture: all faces with it emit this light, in place of this entity"},
    number("_surface_offset", "2", "distance in units from those faces to their lights"),
    number("_surface_spotlight", "0", "1: those lights are spotlights that point away from the face"),
    number("radius", "0", "surfaces within this distance cast no shadow in this light, such as the lamp's body"),
    flags(kLightFlags),
};
inline constexpr EntityKey kLenses = number("count", "0", "lenses that the player must have taken"),
                           kKeyName{"keyname", Text, "", "name of a key, as `red key`"},
                           kCrushes = number("dmg", "2", "what it takes of the health of a player in its way");
inline constexpr std::array kDoor{
    kKeyName,
    kLenses,
    kCrushes,
    number("speed", "100", "units a second"),
    number("wait", "3", "seconds until it closes; -1: never"),
    number("lip", "8", "units that stay visible when it is open"),
    number("health", "0", "above 0: opens by touch, as there are no shots"),
    flags(kDoorFlags),
};
inline constexpr std::array kTurningDoor{
    required(numbers("origin", 3, 3, "", "position of the hinge: x y z")),
    kKeyName,
    kLenses,
    kCrushes,
    number("distance", "90", "angle to turn in degrees, up to 360"),
    number("speed", "100", "degrees a second"),
    number("wait", "3", "seconds until it closes; -1: never"),
    number("health", "0", "as in `func_door`"),
    flags(kTurningDoorFlags),
};
inline constexpr std::array kSecretDoor{
    kCrushes,
    number("wait", "5", "seconds until it closes"),
    number("t_width", "", "length of the first move; usually its width"),
    number("t_length", "", "length of the second move; usually its length"),
    number("health", "", kNoEffect),
    number("speed", "", kNoEffect),
    flags(kSecretFlags),
};
inline constexpr std::array kButton{
    number("speed", "40", "units a second"),
    number("wait", "1", "seconds until it is released; -1: never"),
    number("lip", "4", "units that stay visible when it is pressed"),
    number("health", "0", "as in `func_door`"),
    EntityKey{"machine", Choice, "", "a lever: shows pictures at that machine's pace", kMachineValues},
};
inline constexpr std::array kLift{
    number("speed", "150", "units a second"),
    number("height", "", "how far it moves down; usually its height less 8"),
    number("dmg", "1", kCrushes.does),
    flags(kLiftFlags),
};
inline constexpr std::array kTrain{
    required({"target", Place, "", "the first `path_corner`"}),
    kCrushes,
    number("speed", "100", "units a second"),
};
inline constexpr std::array kRotating{
    number("speed", "100", "degrees a second, counter-clockwise seen from above; negative: clockwise"),
    flags(kRotatingFlags),
};
inline constexpr std::array kCorner{
    EntityKey{"target", Place, "", "the next `path_corner`"},
    number("wait", "0", "seconds that a train waits here; -1: until activated"),
};
inline constexpr std::array kTriggerOnce{
    number("health", "0", "above 0: fires when the player comes near, as there are no shots"),
    kLenses,
    number("wait", "", kNoEffect),
    kSoundsKey,
    flags(kTriggerFlags),
};
inline constexpr std::array kSecret{EntityKey{"netname", Text, "", "what the end calls it if it was missed"}};
inline constexpr std::array kTriggerMultiple{
    number("health", "0", "as in `trigger_once`"),
    kLenses,
    number("wait", "0.2", "seconds until it can fire again"),
    kSoundsKey,
    flags(kTriggerFlags),
};
inline constexpr EntityKey kViewWait = number("wait", "-1", "seconds until it can fire again; -1: never");
inline constexpr std::array kView{
    EntityKey{"look_at", Place, "", "looked at, in place of the direction of `angle` or `angles`"},
    number("cone", "10", "degrees that the look may be off that way"),
    EntityKey{"accuracy", Choice, "", "a preset", kPresetValues},
    EntityKey{"projection", Choice, "", "pixels that the picture is drawn for", kProjectionValues},
    EntityKey{"display", Choice, "", "shape in the window", kDisplayValues},
    EntityKey{"isometric", Choice, "", "the isometric view", kOffOn},
    EntityKey{"wireframe", Choice, "", "edges of faces", kWireframeValues},
    EntityKey{"zoom", Choice, "", "degrees of the zoom against dolly", kZoomValues},
    kViewWait,
};
inline constexpr std::array kBudget{
    number("least", "", "thousands of a 486's cycles"),
    number("most", "", "likewise"),
    kViewWait,
};
inline constexpr std::array kCounter{
    number("count", "2", "number of activations"),
    kSoundsKey,
    flags(kCounterFlags),
};
inline constexpr std::array kHurt{
    number("dmg", "5", "what it takes of the player's health each second"),
    flags(kHurtFlags),
};
inline constexpr std::array kTimer{
    number("wait", "1", "seconds between two firings"),
    number("random", "0", "seconds that they may be off"),
    flags(kTimerFlags),
};
inline constexpr auto kPlayed = without_effect("speed", "volume", "impulse");
inline constexpr std::array kPlayedAgain{
    number("delay", "2", "least seconds between two times"),
    number("wait", "20", "most seconds between two times"),
};
inline constexpr std::array kRelay{
    kLenses,
    number("found", "", "plays the sound of the item taken first (1), second (2) ..., none if fewer are"),
};
inline constexpr std::array kTeleport{
    required({"target", Place, "", "the exit, an `info_teleport_destination`"}),
    kSoundsKey,
};
inline constexpr std::array kPush{
    number("speed", "1000", "tenths of units a second"),
    flags(kPushFlags),
};
inline constexpr std::array kExit{
    EntityKey{"map", Text, "", "name of the next level; usually the next in `game.json`, or the end"},
    flags(kExitFlags),
};
inline constexpr EntityKey kItemModel{
    "model", Text, "", "an OBJ or MDL in place of the usual model: path below the level's folder or its parent"};
inline constexpr EntityKey model_scale(std::string_view usual, std::string_view does) {
    return within(World::from_raw(4), World::from_int(4096), number("scale", usual, does));
}
inline constexpr std::array kLens{
    EntityKey{"netname", Text, "", "name of the item in the message that it is missing"},
    EntityKey{"glass", Text, "glass", "material of its glass in `models.mtl`"},
    kItemModel,
    model_scale("9", "units of the level for one of its model's"),
};
inline constexpr std::array kKeyModel{kItemModel, model_scale("12", "units of the level for one of its model's")};
inline constexpr std::array kCustomKey{
    required(kKeyName),
    EntityKey{"glass", Text, "glass", "its material in `models.mtl`"},
};
inline constexpr std::array kHealthItem{flags(kHealthFlags)};
inline constexpr std::array kIntermission{
    numbers("mangle", 3, 3, "", "pitch yaw roll in degrees, in place of `angle`"),
    number("speed", "0", "degrees a second that it turns to the left"),
    number("wait", "0", "seconds before the end's page: half at the player's pace, half at a 386's"),
    EntityKey{"message", Text, "", "text shown to the player"},
};
inline constexpr std::array kCheckpoint{numbers("size", 3, 3, "128 128 112", "size of its box: x y z")};

inline constexpr EntityKey period(std::string_view usual, std::string_view does) {
    return within(World::from_raw(4096 / 20), World::from_int(3600), number("period", usual, does));
}
inline constexpr EntityKey kCount = within(0, 131'072, number("count", "", "number of particles")),
                           kColour = numbers("colour", 1, 2, "", "a palette index, or the first and last of a ramp");
inline constexpr EntityKey with_usual(EntityKey key, std::string_view usual) {
    key.usual = usual;
    return key;
}
inline constexpr std::array<EntityKey, 4> emitter(std::string_view size, std::string_view count,
                                                  std::string_view seconds, std::string_view colours) {
    return {within(1, 65'536, numbers("size", 3, 3, size, "size of its box: x y z")), with_usual(kCount, count),
            period(seconds, "seconds per cycle"), with_usual(kColour, colours)};
}
// Colours are from Quake's palette: greys, browns, fire from light to dark.
inline constexpr std::array kRain = emitter("256 256 256", "400", "0.7", "8 11");
inline constexpr std::array kDust = emitter("256 256 128", "100", "20", "6 9");
inline constexpr std::array kSparks = emitter("64 64 48", "40", "0.9", "111 104");
inline constexpr std::array kBubbles = emitter("32 32 96", "12", "4", "11 13");

inline constexpr EntityKey kSpriteScale =
    within(World::from_raw(4096 / 16), World::from_int(16), number("scale", "1", "scale"));
inline constexpr std::array kSprite{
    required({"texture", Texture, "", "name of the texture"}),
    kSpriteScale,
    within(0, 512, number("shadow", "0", "radius of its shadow on the floor")),
};
inline constexpr std::array kLantern{
    required({"texture", Texture, "", "name of the texture"}),
    kSpriteScale,
    within(0, 4096, number("radius", "64", "radius of its circle")),
    within(0, 2048, number("light", "200", "radius of its light")),
    period("8", "seconds per cycle"),
};
inline constexpr std::array kModel{
    required({"model", Text, "", "its MDL or OBJ file"}),
    EntityKey{"frame", Whole, "0", "first frame"},
    EntityKey{"frames", Whole, "1", "number of frames shown in turn, a tenth of a second each"},
    EntityKey{"skin", Whole, "0", "skin of an MDL"},
    model_scale("1", "scale"),
    EntityKey{"up", Choice, "y", "the OBJ's axis that points up", kUps},
    period("", "seconds per turn about its vertical axis"),
    EntityKey{"shading", Choice, "gouraud", "shading of its triangles", kShadings},
    within(0, 255, {"highlight", Whole, "0", "brightness of a Phong highlight"}),
    within(0, 255, {"least_light", Whole, "0", "least light on it, for what glows"}),
    EntityKey{"dither", Choice, "0", "whether an OBJ's pictures are dithered", kNoYes},
};
// Used by Quake only.
inline constexpr auto kOfQuake =
    joined(without_effect("speed", "height", "dmg", "wait", "health"), kSounds, without_effect("count", "style"),
           std::array{EntityKey{"mdl", Text, "", kNoEffect}, EntityKey{"model", Text, "", kNoEffect},
                      numbers("mangle", 3, 3, "", kNoEffect)});

}  // namespace oblong::class_keys
