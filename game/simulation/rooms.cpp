#include "game/simulation/rooms.h"

#include <algorithm>
#include <optional>

#include "engine/base/input_error.h"
#include "engine/base/text.h"
#include "game/simulation/collision.h"

namespace oblong {

namespace {

constexpr std::string_view kBehindName = " - ";
constexpr std::int32_t kHighestStep = 40;  // units above the entrance's bottom, where its floor may be

World middle_of(World a, World b) {
    return scaled(a + b, 1, 2);
}

/// The lowest free place above the middle of a box's bottom.
std::optional<Position> place_in(const Box& box, const GameLevel& level, const GameState& state) {
    Position place{middle_of(box.mins.x, box.maxs.x), middle_of(box.mins.y, box.maxs.y), box.mins.z};
    for (std::int32_t up = 24; up <= 24 + kHighestStep; ++up) {
        const Position raised = place + world_vector(0, 0, up);
        if (is_free(level, state, raised)) return raised;
    }
    return std::nullopt;
}

Angle toward_nearest_item(const Position& from, const GameLevel& level) {
    const auto way_to = [&](const Item& item) { return item.position - from; };
    const auto nearest = std::min_element(level.items.begin(), level.items.end(), [&](const Item& a, const Item& b) {
        return length(way_to(a)) < length(way_to(b));
    });
    if (nearest == level.items.end()) return {};
    const Vec3<World> way = way_to(*nearest);
    return arctangent2(way.y, way.x);
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
        state.player.yaw = toward_nearest_item(*place, level);
        state.player.ground = Player::kNoGround;
        return;
    }
    throw InputError("--room", "'" + std::string(name) + "' is no room of this level, expected " +
                                   (names.empty() ? "a level that names its rooms" : names));
}

}  // namespace oblong
