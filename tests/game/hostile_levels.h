#pragma once

#include <array>

#include "tests/game/logic_level.h"

namespace oblong::test {

/// A level made to let a tick do much work, as large as levels may be. The player starts at 0, 0, 0.
struct HostileLevel {
    const char* name;
    LogicLevel (*make)();
    bool is_too_much = true;  ///< something is left for later within a second
};

inline constexpr Solid kAtStart{-50, -50, 0, 50, 50, 64};
inline constexpr int kManyModels = static_cast<int>(kMostMovers), kManyPoints = 20'000;

inline LogicLevel set_off(const Pairs& pairs) {
    LogicLevel level;
    level.add("trigger_multiple", kAtStart, pairs);
    return level;
}

inline LogicLevel models_in_one_place(const std::string& its_class, const Solid& box, const Pairs& pairs,
                                      const char* target = "") {
    LogicLevel level = set_off({{"target", target}, {"wait", "0.1"}});
    for (int i = 0; i < kManyModels; ++i) level.add(its_class, box, pairs);
    return level;
}

inline LogicLevel points(const std::string& its_class, const Pairs& pairs) {
    LogicLevel level = set_off({{"target", "a"}, {"wait", "0.1"}});
    level.add("trigger_relay", {{"targetname", "a"}});
    for (int i = 0; i < kManyPoints; ++i) level.add(its_class, pairs);
    return level;
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
    for (int i = 0; i < kManyModels; ++i)
        level.add("func_door", {900, 900, 0, 910, 910, 10}, {{"targetname", "b"}, {"spawnflags", "4"}});
    return level;
}

inline LogicLevel relays_that_open_a_group() {
    LogicLevel level = models_in_one_place("func_door", {900, 900, 0, 910, 910, 10}, {{"targetname", "b"}}, "a");
    for (int i = 0; i < kManyPoints; ++i) level.add("trigger_relay", {{"targetname", "a"}, {"target", "b"}});
    return level;
}

inline LogicLevel counters() {
    LogicLevel level = points("trigger_counter", {{"targetname", "a"}, {"target", "a"}, {"count", "1000000"}});
    level.add("trigger_relay", {{"targetname", "a"}, {"target", "a"}});
    return level;
}

inline constexpr std::array kHostileLevels{
    HostileLevel{"RelaysThatTargetThemselves",
                 [] {
                     return points("trigger_relay", {{"targetname", "a"}, {"target", "a"}});
                 }},
    HostileLevel{"RelaysWithDelay",
                 [] {
                     LogicLevel level = set_off({{"target", "a"}, {"wait", "0.1"}});
                     for (int i = 0; i < 300; ++i)
                         level.add(
                             "trigger_relay",
                             {{"targetname", "a"}, {"target", "a"}, {"delay", "0." + std::to_string(3 + i % 60)}});
                     return level;
                 }},
    HostileLevel{"CountersThatTargetThemselves", counters},
    HostileLevel{"DoorsAroundThePlayer",
                 [] {
                     return models_in_one_place("func_door", kAtStart, {{"spawnflags", "4"}, {"angle", "0"}});
                 }},
    HostileLevel{"OneGroupOfDoorsAroundThePlayer",
                 [] {
                     return models_in_one_place("func_door", kAtStart, {{"angle", "0"}});
                 }},
    HostileLevel{"DoorsThatMeetThePlayer",
                 [] {
                     return models_in_one_place(
                         "func_door", {40, -50, 0, 50, 50, 64},
                         {{"spawnflags", "4"}, {"angle", "180"}, {"lip", "-50"}, {"wait", "0.1"}});
                 }},
    HostileLevel{"DoorsThatWantAKey",
                 [] {
                     return models_in_one_place("func_door", kAtStart, {{"spawnflags", "20"}, {"angle", "0"}});
                 }},
    HostileLevel{"SecretDoors",
                 [] {
                     return models_in_one_place("func_door_secret", kAtStart, {{"angle", "0"}});
                 }},
    HostileLevel{"Buttons",
                 [] {
                     return models_in_one_place("func_button", kAtStart,
                                                {{"angle", "0"}, {"target", "a"}, {"targetname", "a"}}, "a");
                 }},
    HostileLevel{"Lifts",
                 [] {
                     return models_in_one_place("func_plat", kAtStart, {{"height", "60"}});
                 }},
    HostileLevel{"LiftsFarAway",
                 [] {
                     return models_in_one_place("func_plat", {900, 900, 0, 910, 910, 10},
                                                {{"height", "60"}, {"targetname", "a"}}, "a");
                 }},
    HostileLevel{"Walls",
                 [] {
                     return models_in_one_place("func_wall", kAtStart, {{"targetname", "a"}}, "a");
                 }},
    HostileLevel{"TrainsWithoutAWay", trains},
    HostileLevel{"TrainsThroughTheLevel", far_trains},
    HostileLevel{"Teleporters", teleporters},
    HostileLevel{"Pushes",
                 [] {
                     return models_in_one_place("trigger_push", kAtStart, {{"angle", "-1"}});
                 }},
    HostileLevel{"TriggersInOnePlace",
                 [] {
                     return models_in_one_place("trigger_multiple", kAtStart, {{"wait", "0.01"}, {"target", "a"}});
                 }},
    HostileLevel{"Items",
                 [] {
                     return points("item_lens", {{"origin", "0 0 24"}, {"target", "a"}});
                 }},
    HostileLevel{"KillersOfMany", killers_of_many},
    HostileLevel{"RelaysThatOpenAGroup", relays_that_open_a_group},
    HostileLevel{"MonstersThatAreMet",
                 [] {
                     return points("monster_ogre", {{"origin", "0 0 24"}, {"target", "a"}});
                 }},
};

}  // namespace oblong::test
