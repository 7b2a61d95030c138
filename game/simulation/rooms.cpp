#include "game/simulation/rooms.h"

#include <algorithm>
#include <optional>

#include "engine/base/input_error.h"
#include "engine/base/text.h"
#include "game/simulation/collision.h"

namespace oblong {

namespace {

constexpr std::string_view kBehindName = " - ";

World middle_of(World a, World b) {
    return scaled(a + b, 1, 2);
}

/// A free place at a floor, in a box's middle or beside it, as over a lift's shaft.
std::optional<Position> place_in(const Box& box, const GameLevel& level, const GameState& state) {
    constexpr std::int32_t kHighestStep = 40, kBeside = 96;
    const Position middle{middle_of(box.mins.x, box.maxs.x), middle_of(box.mins.y, box.maxs.y), box.mins.z};
    for (const auto& [east, north] : {std::pair{0, 0}, {kBeside, 0}, {-kBeside, 0}, {0, kBeside}, {0, -kBeside}})
        for (std::int32_t up = 24; up <= 24 + kHighestStep; ++up) {
            const Position place = middle + world_vector(east, north, up);
            if (is_free(level, state, place) &&
                move_box(level, state, place, place - world_vector(0, 0, kHighestStep)).has_hit)
                return place;
        }
    return std::nullopt;
}

/// The item that has the room's name, or else the nearest one; null: there is none.
const Item* item_of(const Room& room, const Position& from, const GameLevel& level) {
    const Item* nearest = nullptr;
    for (const Item& item : level.items) {
        const std::string name = lower_case(level.bsp->entities[item.entity].value("netname"));
        if (name.starts_with(room.name) || name.starts_with("the " + room.name)) return &item;
        if (!nearest || length(item.position - from) < length(nearest->position - from)) nearest = &item;
    }
    return nearest;
}

}  // namespace

std::vector<Room> rooms_of(const GameLevel& level) {
    std::vector<Room> rooms;
    for (const Trigger& trigger : level.triggers) {
        if (!trigger.box || trigger.fires.message == kNoMessage) continue;
        const std::string& message = item(level.messages, trigger.fires.message);
        const std::size_t end = message.find(kBehindName);
        if (end != message.npos) rooms.push_back({lower_case(message.substr(0, end)), *trigger.box});
    }
    return rooms;
}

void enter_room(std::string_view name, const GameLevel& level, GameState& state) {
    std::string wanted = lower_case(name);
    std::replace(wanted.begin(), wanted.end(), '-', ' ');
    std::string names;
    for (const Room& room : rooms_of(level)) {
        names += (names.empty() ? "" : ", ") + room.name;
        if (room.name != wanted) continue;
        const std::optional<Position> place = place_in(room.entrance, level, state);
        if (!place) throw InputError("--room", "no place to stand at the entrance of '" + room.name + "'");
        state.player.position = *place;
        if (const Item* const item = item_of(room, *place, level)) {
            const Vec3<World> way = item->position - *place;
            state.player.yaw = arctangent2(way.y, way.x);
        }
        state.player.ground = Player::kNoGround;
        return;
    }
    throw InputError("--room", "'" + std::string(name) + "' is no room of this level, expected " +
                                   (names.empty() ? "a level that names its rooms" : names));
}

}  // namespace oblong
