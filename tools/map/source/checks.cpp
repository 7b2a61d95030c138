#include "tools/map/source/checks.h"

#include <algorithm>
#include <map>

#include "tools/map/light/sources.h"
#include "tools/map/source/contents.h"
#include "tools/map/source/entities.h"

namespace oblong::map {
namespace {

using Names = std::vector<std::string_view>;

// Of Quake's game (its source in QuakeC, "QUAKED" comments) and of level compilers. Whole families end in '_'.
const Names kClasses{"worldspawn",
                     "light",
                     "light_",
                     "func_group",
                     "func_detail",
                     "func_detail_wall",
                     "func_detail_illusionary",
                     "func_detail_fence",
                     "func_wall",
                     "func_door",
                     "func_door_secret",
                     "func_button",
                     "func_plat",
                     "func_train",
                     "func_bossgate",
                     "func_episodegate",
                     "func_illusionary",
                     "func_dm_only",
                     "trigger_multiple",
                     "trigger_once",
                     "trigger_relay",
                     "trigger_secret",
                     "trigger_counter",
                     "trigger_teleport",
                     "trigger_changelevel",
                     "trigger_setskill",
                     "trigger_hurt",
                     "trigger_push",
                     "trigger_monsterjump",
                     "trigger_onlyregistered",
                     "info_player_start",
                     "info_player_start2",
                     "info_player_coop",
                     "info_player_deathmatch",
                     "info_teleport_destination",
                     "info_intermission",
                     "info_null",
                     "info_notnull",
                     "path_corner",
                     "event_lightning",
                     "air_bubbles",
                     "viewthing",
                     "testplayerstart",
                     "item_",
                     "weapon_",
                     "monster_",
                     "ambient_",
                     "misc_",
                     "trap_",
                     "test_"};

// The same for keys, whatever class they belong to.
const Names kKeys{"classname",  "origin",      "angle",       "angles",      "mangle",      "target",     "targetname",
                  "killtarget", "spawnflags",  "model",       "delay",       "wait",        "message",    "sounds",
                  "speed",      "lip",         "dmg",         "health",      "height",      "count",      "style",
                  "light",      "map",         "t_length",    "t_width",     "noise",       "noise1",     "noise2",
                  "noise3",     "noise4",      "netname",     "color",       "wad",         "worldtype",  "gravity",
                  "volume",     "cnt",         "sky",         "fog",         "alpha",       "mapversion", "_light",
                  "_minlight",  "_sunlight",   "_sun_mangle", "_sky",        "_wad",        "_tb_",       "wateralpha",
                  "slimealpha", "lavaalpha",   "telealpha",   "_wateralpha", "_slimealpha", "_lavaalpha", "_telealpha",
                  "size",       "colour",      "period",      "texture",     "scale",       "shadow",     "radius",
                  "pattern",    "frame",       "frames",      "skin",        "up",          "dither",     "shading",
                  "highlight",  "least_light", "glass"};

struct Count {
    std::string_view key, wanted;
    std::size_t least, most;
};

// How many numbers keys of effects take.
const std::vector<Count> kCounts{{"fog", "density red green blue, perhaps alpha mindist maxdist top fadedepth", 4, 9},
                                 {"size", "3 numbers", 3, 3},
                                 {"palette_cycle", "first, last, steps a second", 3, 3}};

// palette_cycle, palette_cycle2 ...
bool is_palette_cycle(std::string_view key) {
    constexpr std::string_view kName = "palette_cycle";
    return key.starts_with(kName) && key.substr(kName.size()).find_first_not_of("0123456789") == std::string_view::npos;
}

// Keys whose value is one number to the light compiler.
const Names kNumbers{"wait", "delay", "style", "_minlight", "_sunlight"};

bool is_one_of(const Names& names, const std::string& word) {
    return std::any_of(names.begin(), names.end(), [&](std::string_view name) {
        return word == name || (name.ends_with('_') && word.starts_with(name));
    });
}

class Checker {
  public:
    void check_class(const MapEntity& entity) {
        const std::string name = entity.value("classname");
        if (name.empty()) {
            add(entity.line, "an entity without a classname, expected one");
        } else if (!is_one_of(kClasses, name)) {
            add(entity.line, "the class '" + name + "' is unknown: the entity is written as it stands");
        }
    }

    void check_key(const MapPair& pair) {
        if (is_one_of(kKeys, pair.key) || is_palette_cycle(pair.key)) return;
        const bool is_for_compilers = pair.key.starts_with('_');
        add(pair.line, "the key '" + pair.key + (is_for_compilers ? "' has no effect here" : "' is unknown"));
    }

    void check_count(const MapPair& pair) {
        const std::size_t words = count_words(pair.value);
        for (const Count& count : kCounts) {
            if (pair.key != count.key && !(count.key == "palette_cycle" && is_palette_cycle(pair.key))) continue;
            if (words < count.least || words > count.most)
                add(pair.line, "'" + pair.key + "' is '" + pair.value + "', expected " + std::string(count.wanted));
        }
    }

    // A sprite is a texture with holes.
    void check_sprite(const MapEntity& entity) {
        const std::string name = entity.value("classname"), texture = entity.value("texture");
        if (name != "misc_sprite" && name != "misc_lantern") return;
        if (!is_fence_texture(texture))
            add(entity.line, "the texture of a " + name + " is '" + texture + "', expected one that begins with '{'");
    }

    void check_light(const MapEntity& entity, const MapPair& pair) {
        const std::size_t words = count_words(pair.value);
        if (pair.key == "delay" && !is_falloff(number_of(entity, "delay", 0))) {
            add(pair.line, "'delay' is '" + pair.value + "', expected 0, 1, 2, 3 or 5: 0 is taken");
        } else if (pair.key == "light" || pair.key == "_light") {
            if (words > 1) add(pair.line, "the colour in '" + pair.key + "' is not kept, only its brightness");
        } else if (words > 1 && is_one_of(kNumbers, pair.key)) {
            add(pair.line, "'" + pair.key + "' is '" + pair.value + "', expected one number: the first is taken");
        }
    }

    void add(int line, const std::string& what) {
        if (known_[what]++ == 0) warnings_.push_back({line, what});
    }

    std::vector<Warning> take() {
        for (Warning& warning : warnings_) {
            const int others = known_[warning.what] - 1;
            if (others > 0) warning.what += " (so " + std::to_string(others) + " more)";
        }
        return std::move(warnings_);
    }

  private:
    std::vector<Warning> warnings_;
    std::map<std::string, int> known_;
};

}  // namespace

std::vector<Warning> find_warnings(const std::vector<MapEntity>& entities) {
    Checker checker;
    bool has_start = false;
    for (const MapEntity& entity : entities) {
        const std::string name = entity.value("classname");
        has_start = has_start || name == "info_player_start";
        checker.check_class(entity);
        checker.check_sprite(entity);
        for (const MapPair& pair : entity.pairs) {
            checker.check_key(pair);
            checker.check_count(pair);
            if (name == "worldspawn" || name.starts_with("light")) checker.check_light(entity, pair);
        }
    }
    if (!has_start) checker.add(entities.front().line, "no info_player_start: nobody can play the level");
    return checker.take();
}

}  // namespace oblong::map
