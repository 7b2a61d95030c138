#pragma once

#include <functional>
#include <vector>

#include "tests/game/logic_level.h"

namespace oblong::test {

using MakeLevel = std::function<LogicLevel()>;

/// A level made to let a tick do much work, as large as levels may be. The player starts at 0, 0, 0.
struct HostileLevel {
    const char* name;
    MakeLevel make;
    bool is_too_much = true;  ///< something is left for later within a second
};

inline constexpr Solid kAtStart{-50, -50, 0, 50, 50, 64};
inline constexpr int kManyModels = static_cast<int>(kMostMovers), kManyPoints = 20'000;

inline LogicLevel set_off(const Pairs& pairs) {
    LogicLevel level;
    level.add("trigger_multiple", kAtStart, pairs);
    return level;
}

inline constexpr Solid kFarAway{900, 900, 0, 910, 910, 10};

/// As many brush entities as there may be, and a trigger that activates their target again and again.
inline MakeLevel models(const char* its_class, const Pairs& pairs, const char* target = "", Solid box = kAtStart) {
    return [=] {
        LogicLevel level = set_off({{"target", target}, {"wait", "0.1"}});
        for (int i = 0; i < kManyModels; ++i) level.add(its_class, box, pairs);
        return level;
    };
}

inline MakeLevel points(const char* its_class, const Pairs& pairs) {
    return [=] {
        LogicLevel level = set_off({{"target", "a"}, {"wait", "0.1"}});
        level.add("trigger_relay", {{"targetname", "a"}});
        for (int i = 0; i < kManyPoints; ++i) level.add(its_class, pairs);
        return level;
    };
}

inline LogicLevel trains() {
    LogicLevel level;
    level.add("path_corner", {{"targetname", "p"}, {"target", "p"}, {"origin", "-50 -50 0"}});
    for (int i = 0; i < kManyModels; ++i) level.add("func_train", kAtStart, {{"target", "p"}});
    return level;
}

// Each goes through the player's place on a way through the whole level.
inline LogicLevel far_trains() {
    LogicLevel level;
    level.add("path_corner", {{"targetname", "p"}, {"target", "q"}, {"origin", "-2000 -2000 0"}});
    level.add("path_corner", {{"targetname", "q"}, {"target", "p"}, {"origin", "2000 2000 500"}});
    for (int i = 0; i < kManyModels; ++i)
        level.add("func_train", kAtStart, {{"target", "p"}, {"speed", std::to_string(1 + i % 3000)}});
    return level;
}

// All lead to the place that they are in.
inline LogicLevel teleporters() {
    LogicLevel level;
    level.add("info_teleport_destination", {{"targetname", "here"}, {"origin", "0 0 0"}});
    for (int i = 0; i < kManyPoints; ++i) level.add("trigger_teleport", kAtStart, {{"target", "here"}});
    return level;
}

inline LogicLevel killers_of_many() {
    LogicLevel level = set_off({{"target", "a"}, {"wait", "0.1"}});
    for (int i = 0; i < kManyPoints; ++i) level.add("trigger_relay", {{"targetname", "a"}, {"killtarget", "b"}});
    for (int i = 0; i < kManyModels; ++i) level.add("func_door", kFarAway, {{"targetname", "b"}, {"spawnflags", "4"}});
    return level;
}

inline LogicLevel relays_that_open_a_group() {
    LogicLevel level = models("func_door", {{"targetname", "b"}}, "a", kFarAway)();
    for (int i = 0; i < kManyPoints; ++i) level.add("trigger_relay", {{"targetname", "a"}, {"target", "b"}});
    return level;
}

inline LogicLevel counters() {
    LogicLevel level = points("trigger_counter", {{"targetname", "a"}, {"target", "a"}, {"count", "1000000"}})();
    level.add("trigger_relay", {{"targetname", "a"}, {"target", "a"}});
    return level;
}

inline LogicLevel relays_with_delay() {
    LogicLevel level = set_off({{"target", "a"}, {"wait", "0.1"}});
    for (int i = 0; i < 300; ++i)
        level.add("trigger_relay",
                  {{"targetname", "a"}, {"target", "a"}, {"delay", "0." + std::to_string(3 + i % 60)}});
    return level;
}

inline const std::vector<HostileLevel> kHostileLevels{
    {"RelaysThatTargetThemselves", points("trigger_relay", {{"targetname", "a"}, {"target", "a"}})},
    {"RelaysWithDelay", relays_with_delay},
    {"CountersThatTargetThemselves", counters},
    {"DoorsAroundThePlayer", models("func_door", {{"spawnflags", "4"}, {"angle", "0"}})},
    {"OneGroupOfDoorsAroundThePlayer", models("func_door", {{"angle", "0"}})},
    {"DoorsThatMeetThePlayer",
     models("func_door", {{"spawnflags", "4"}, {"angle", "180"}, {"lip", "-50"}, {"wait", "0.1"}}, "",
            {40, -50, 0, 50, 50, 64})},
    {"DoorsThatWantAKey", models("func_door", {{"spawnflags", "20"}, {"angle", "0"}})},
    {"SecretDoors", models("func_door_secret", {{"angle", "0"}})},
    {"Buttons", models("func_button", {{"angle", "0"}, {"target", "a"}, {"targetname", "a"}}, "a")},
    {"Lifts", models("func_plat", {{"height", "60"}})},
    {"LiftsFarAway", models("func_plat", {{"height", "60"}, {"targetname", "a"}}, "a", kFarAway)},
    {"Walls", models("func_wall", {{"targetname", "a"}}, "a")},
    {"TrainsWithoutAWay", trains},
    {"TrainsThroughTheLevel", far_trains},
    {"Teleporters", teleporters},
    {"Pushes", models("trigger_push", {{"angle", "-1"}})},
    {"TriggersInOnePlace", models("trigger_multiple", {{"wait", "0.01"}, {"target", "a"}})},
    {"Items", points("item_lens", {{"origin", "0 0 24"}, {"target", "a"}})},
    {"KillersOfMany", killers_of_many},
    {"RelaysThatOpenAGroup", relays_that_open_a_group},
    {"MonstersThatAreMet", points("monster_ogre", {{"origin", "0 0 24"}, {"target", "a"}})},
};

}  // namespace oblong::test
