#pragma once

#include <optional>
#include <string_view>

#include "game/simulation/game_level.h"

namespace oblong {

/// The trigger that an entity describes, as Quake's game does: trigger_ once, multiple, secret, onlyregistered,
/// counter, relay, teleport, push, changelevel, and info_checkpoint, event_lightning; nothing for any other entity.
/// Without what concerns other entities: targets, messages, a teleporter's exit.
std::optional<Trigger> trigger_of(const Entity& entity, const Level& bsp);

/// What a secret says that has no message of its own.
inline constexpr std::string_view kSecretMessage = "You found a secret place";

}  // namespace oblong
