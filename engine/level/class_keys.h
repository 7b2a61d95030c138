#pragma once

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
    return {"spawnflags", Flags, "0", "sum of its flags", values};
}
inline constexpr EntityKey required(EntityKey key) {
    key.is_required = true;
    return key;
}

inline constexpr std::array kFalloffs{KeyValue{"0", "linear"}, KeyValue{"1", "1 / distance"},
                                      KeyValue{"2", "1 / distance squared"}, KeyValue{"3", "not at all"},
                                      KeyValue{"5", "1 / distance squared, softer near by"}};
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
                                    KeyValue{"32", "its own pattern, or switched"}};
inline constexpr std::array kUps{KeyValue{"y", "y"}, KeyValue{"z", "z"}};
inline constexpr std::array kShadings{KeyValue{"flat", "a colour a triangle"}, KeyValue{"gouraud", "between corners"},
                                      KeyValue{"phong", "a normal a pixel"}};
inline constexpr std::array kNoYes{KeyValue{"0", "no"}, KeyValue{"1", "yes"}};

inline constexpr std::array kSkillFlags{KeyValue{"256", "not at easy skill (Quake)"}, KeyValue{"512", "left out"},
                                        KeyValue{"1024", "not at hard skill (Quake)"},
                                        KeyValue{"2048", "not in deathmatch (Quake)"}};
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
inline constexpr std::array kSecretFlags{KeyValue{"1", "opens once"}, KeyValue{"2", "first to the left"},
                                         KeyValue{"4", "first down"}, KeyValue{"8", "not by shots (Quake)"},
                                         KeyValue{"16", "by a touch though it has a name"}};
inline constexpr std::array kLiftFlags{KeyValue{"1", "only who stands low calls it"}};
inline constexpr std::array kRotatingFlags{KeyValue{"4", "about the x axis"}, KeyValue{"8", "about the y axis"}};
inline constexpr std::array kTriggerFlags{KeyValue{"1", "not by touch"}};
inline constexpr std::array kCounterFlags{KeyValue{"1", "does not say how many are left"}};
inline constexpr std::array kPushFlags{KeyValue{"1", "once"}};
inline constexpr std::array kExitFlags{KeyValue{"1", "no intermission (Quake)"}};

// Keys of every entity.
inline constexpr std::array kOfAll{
    EntityKey{"classname", Text, "", "its class"},
    numbers("origin", 3, 3, "", "its place: x y z"),
    EntityKey{"targetname", Name, "", "the name that others target"},
    flags(kSkillFlags),
    numbers("light", 1, 4, "", "of what has a place: it shines as a `light` does"),
};
inline constexpr std::array kTurned{
    number("angle", "0", "degrees from east to north; -1 is up, -2 down"),
    numbers("angles", 3, 3, "", "pitch yaw roll in degrees, in place of `angle`"),
};
inline constexpr std::array kFires{
    EntityKey{"target", Target, "", "what it activates"},
    EntityKey{"killtarget", Target, "", "what it removes"},
    number("delay", "0", "seconds before it does"),
    EntityKey{"message", Text, "", "text that is shown; {jump} is the key of an action"},
};
inline constexpr std::array kSmooth{
    number("_phong", "0", "1: is lit as if it were round"),
    number("_phong_angle", "89", "degrees between faces up to which it is"),
};
inline constexpr std::array kNoise{
    EntityKey{"noise", Text, "", "a FLAC or WAV file heard instead: its path below the game's folder or the level's"},
};
inline constexpr std::array kMadeOfBrushes{
    kSmooth[0],
    kSmooth[1],
    number("_minlight", "0", "its least light, 0 to 255"),
    number("dmg", "", kNoEffect),
    EntityKey{"sounds", Whole, "", kNoEffect},
};

inline constexpr std::array kWorld{
    EntityKey{"message", Text, "", "the level's title"},
    EntityKey{"music", Text, "", "a tracker module: its path below the game's folder or the level's"},
    EntityKey{"wad", Text, "", "its textures: WAD files and folders of pictures, `;` between two"},
    EntityKey{"worldtype", Whole, "0", "0 to 2: how keys look (Quake's models)"},
    EntityKey{"mapversion", Whole, "", "220: the source is in Valve's format"},
    number("angle", "", kNoEffect),
    EntityKey{"sounds", Whole, "", kNoEffect},
    numbers("light", 1, 4, "0", "least light everywhere, 0 to 255"),
    number("_minlight", "0", "the same, and wins over `light`"),
    number("_sunlight", "0", "light that comes from the sky"),
    number("_sunlight2", "0", "light from all of the sky above the horizon, as of an overcast day"),
    number("_sunlight3", "0", "the same from below the horizon"),
    number("_dirt", "0", "1: corners are darker; `--dirt` does the same"),
    number("_dirtdepth", "128", "units from which on a surface darkens another"),
    number("_dirtscale", "1", "a factor of that darkness"),
    number("_dirtgain", "1", "an exponent of it"),
    number("_bounce", "0", "how many times light goes on from surface to surface; `--bounce`: once"),
    number("_bouncescale", "1", "a factor of that light"),
    numbers("_sun_mangle", 2, 3, "0 -90 0", "where that shines: yaw pitch roll, pitch negative is down"),
    numbers("fog", 4, 9, "", "density red green blue [alpha mindist maxdist [top fadedepth]]"),
    number("skyfog", "0.5", "share of the fog on the sky, 0 to 1"),
    number("wateralpha", "1", "0 to 1: of liquids but those below"),
    number("slimealpha", "1", "0 to 1: of liquids with `slime` in their names"),
    number("lavaalpha", "1", "0 to 1: of liquids with `lava` in their names"),
    number("telealpha", "1", "0 to 1: of liquids with `tele` in their names"),
    numbers("palette_cycle#", 3, 3, "", "colours that take turns: first last steps_per_second"),
};
inline constexpr std::array kExternalMap{
    required({"_external_map", Text, "", "the map source: its path from the folder of this one"}),
    EntityKey{"_external_map_classname", Text, "func_group",
              "the class of which its brushes become one entity, with all other keys"},
    numbers("_external_map_angles", 3, 3, "0 0 0", "turns it: pitch yaw roll, pitch positive is down"),
    number("_external_map_angle", "0", "turns it: yaw alone"),
    numbers("_external_map_scale", 1, 3, "1", "a factor of its size, or one for each axis"),
};
inline constexpr std::array kLight{
    numbers("light", 1, 4, "300", "brightness; negative takes light away; of a colour only the brightness counts"),
    number("wait", "1", "how fast it fades: a factor of the distance"),
    EntityKey{"delay", Choice, "0", "how it fades", kFalloffs},
    EntityKey{"style", Whole, "0", "flicker: 0 to 11 Quake's, 32 to 63 to be switched or with a `pattern`", kStyles},
    EntityKey{"pattern", Text, "", "letters a (dark) to z, ten a second, of a style from 32 on"},
    EntityKey{"target", Place, "", "makes it a spotlight that points there"},
    numbers("mangle", 2, 3, "", "makes it a spotlight: yaw pitch roll, pitch negative is down"),
    number("angle", "40", "degrees of a spotlight's cone"),
    numbers("_color", 3, 3, "", "its colour, 0 to 255 or 0 to 1: by its luminance, as a level has shades only"),
    EntityKey{"_surface", Text, "", "a texture: all faces with it shine like this, in place of the light itself"},
    number("_surface_offset", "2", "units from those faces to their lights"),
    number("_surface_spotlight", "0", "1: these are spotlights that point away from the face"),
    number("radius", "0", "what is as near as this throws no shadow in its light: the body of a lamp"),
    flags(kLightFlags),
};
inline constexpr std::array kDoor{
    number("speed", "100", "units a second"),
    number("wait", "3", "seconds that it stays open; -1: for ever"),
    number("lip", "8", "units of it that stay in sight when it is open"),
    number("health", "0", "above 0: a touch opens it, as a shot would"),
    flags(kDoorFlags),
};
inline constexpr std::array kTurningDoor{
    required(numbers("origin", 3, 3, "", "its hinge: x y z")),
    number("distance", "90", "degrees that it turns, up to 360"),
    number("speed", "100", "degrees a second"),
    number("wait", "3", "seconds that it stays open; -1: for ever"),
    number("health", "0", "as of a `func_door`"),
    flags(kTurningDoorFlags),
};
inline constexpr std::array kSecretDoor{
    number("wait", "5", "seconds that it stays open"),
    number("t_width", "", "how far it goes first; its own width else"),
    number("t_length", "", "how far then; its own length else"),
    number("health", "", kNoEffect),
    number("speed", "", kNoEffect),
    flags(kSecretFlags),
};
inline constexpr std::array kButton{
    number("speed", "40", "units a second"),
    number("wait", "1", "seconds that it stays pressed; -1: for ever"),
    number("lip", "4", "units of it that stay in sight"),
    number("health", "0", "as of a `func_door`"),
};
inline constexpr std::array kLift{
    number("speed", "150", "units a second"),
    number("height", "", "how far down; its own height less 8 else"),
    flags(kLiftFlags),
};
inline constexpr std::array kTrain{
    required({"target", Place, "", "the first `path_corner`"}),
    number("speed", "100", "units a second"),
};
inline constexpr std::array kRotating{
    number("speed", "100", "degrees a second, counter-clockwise seen from above; negative: clockwise"),
    flags(kRotatingFlags),
};
inline constexpr std::array kCorner{
    EntityKey{"target", Place, "", "the next `path_corner`"},
    number("wait", "0", "seconds that a train stays; -1: until it is activated"),
};
inline constexpr std::array kTriggerOnce{
    number("health", "0", "above 0: worked as if it were shot, by who comes near"),
    number("wait", "", kNoEffect),
    EntityKey{"sounds", Whole, "", kNoEffect},
    flags(kTriggerFlags),
};
inline constexpr std::array kTriggerMultiple{
    number("health", "0", "as of a `trigger_once`"),
    number("wait", "0.2", "seconds before it works again"),
    EntityKey{"sounds", Whole, "", kNoEffect},
    flags(kTriggerFlags),
};
inline constexpr std::array kCounter{
    number("count", "2", "how many activations it takes"),
    EntityKey{"sounds", Whole, "", kNoEffect},
    flags(kCounterFlags),
};
inline constexpr std::array kTeleport{
    required({"target", Place, "", "its exit"}),
    EntityKey{"sounds", Whole, "", kNoEffect},
};
inline constexpr std::array kPush{
    number("speed", "1000", "tenths of units a second"),
    flags(kPushFlags),
};
inline constexpr std::array kExit{
    EntityKey{"map", Text, "", "the next level's name; without: the next one of `game.json`, or the end"},
    flags(kExitFlags),
};
inline constexpr std::array kSounds{EntityKey{"sounds", Whole, "", kNoEffect}};
inline constexpr std::array kLens{
    EntityKey{"netname", Text, "", "what the player is told that is missing"},
    EntityKey{"glass", Text, "glass", "its glass: a material of `models.mtl`"},
    EntityKey{"model", Text, "", "an OBJ or MDL shown instead: its path below the level's folder or the one above"},
};
inline constexpr std::array kCheckpoint{numbers("size", 3, 3, "128 128 112", "of the box in which one passes it")};

inline constexpr EntityKey kCount = number("count", "", "how many particles"),
                           kColour = numbers("colour", 1, 2, "", "a colour of the palette, or a ramp's two ends");
inline constexpr EntityKey with_usual(EntityKey key, std::string_view usual) {
    key.usual = usual;
    return key;
}
inline constexpr std::array<EntityKey, 4> emitter(std::string_view size, std::string_view count,
                                                  std::string_view period, std::string_view colours) {
    return {numbers("size", 3, 3, size, "of its box"), with_usual(kCount, count),
            number("period", period, "seconds of a round"), with_usual(kColour, colours)};
}
// Colours are from Quake's palette: greys, browns, fire from light to dark.
inline constexpr std::array kRain = emitter("256 256 256", "400", "0.7", "8 11");
inline constexpr std::array kDust = emitter("256 256 128", "100", "20", "6 9");
inline constexpr std::array kSparks = emitter("64 64 48", "40", "0.9", "111 104");
inline constexpr std::array kBubbles = emitter("32 32 96", "12", "4", "11 13");

inline constexpr std::array kSprite{
    required({"texture", Texture, "", "its texture"}),
    number("scale", "1", "how large, 1/16 to 16"),
    number("shadow", "0", "radius of a shadow on the floor"),
};
inline constexpr std::array kLantern{
    required({"texture", Texture, "", "its texture"}),
    number("scale", "1", "how large, 1/16 to 16"),
    number("radius", "64", "of the circle that it goes in"),
    number("light", "200", "how far it shines"),
    number("period", "8", "seconds of a round"),
};
inline constexpr std::array kModel{
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
// Used by Quake only.
inline constexpr std::array kOfQuake{
    number("speed", "", kNoEffect),         number("height", "", kNoEffect),
    number("dmg", "", kNoEffect),           number("wait", "", kNoEffect),
    number("health", "", kNoEffect),        EntityKey{"sounds", Whole, "", kNoEffect},
    number("count", "", kNoEffect),         number("style", "", kNoEffect),
    EntityKey{"mdl", Text, "", kNoEffect},  EntityKey{"model", Text, "", kNoEffect},
    numbers("mangle", 3, 3, "", kNoEffect),
};

}  // namespace oblong::class_keys
