#pragma once

#include <cstdint>
#include <optional>

#include "game/simulation/game_level.h"
#include "game/simulation/state.h"

namespace oblong {

/// A solid model at its current place.
struct Obstacle {
    ModelIndex model;
    Vec3<World> offset;
};

/// The obstacle of a number in LevelBoxes::obstacles; nothing for one that is removed, or for a door that is not shut.
std::optional<Obstacle> obstacle_of(const GameLevel& level, const GameState& state, std::uint32_t number);

/// True where the player might meet in a tick more models than BoxTree::kMostFound: only the first ones are solid.
bool has_too_many_obstacles(const GameLevel& level, const Position& position);

/// The end of the player's box on a straight path.
struct Contact {
    Position end;           ///< where it stops, clear of what it hit
    bool has_hit = false;   ///< it stops before the line's end
    Vec3<Unit> normal;      ///< of what it hit, towards the player
    ModelIndex model;       ///< that it hit
    bool is_stuck = false;  ///< the whole line is inside something solid
};

/// Moves the player's box through the world and all brush models where they are now (hull 1).
Contact move_box(const GameLevel& level, const GameState& state, const Position& from, const Position& to);

/// True where the player's box at a position touches nothing solid.
bool is_free(const GameLevel& level, const GameState& state, const Position& position);

/// False where a model at an offset is too far from a box to touch it.
bool may_touch(const GameLevel& level, ModelIndex model, const Vec3<World>& offset, const Box& box);

/// For a player inside a brush model: the nearest free position along an axis that does not lead through the world's
/// walls. At most kMostWaysOut positions are tried, nearest first.
inline constexpr std::size_t kMostWaysOut = 48;
struct WayOut {
    bool is_inside_model = false;
    std::optional<Position> position;
};
WayOut find_way_out(const GameLevel& level, const GameState& state, const Position& from);

/// `from`, or where it is solid in the world, the nearest free place within 256 units in 26 directions; `from` if there
/// is none.
Position free_place_near(const GameLevel& level, const Position& from);

/// The contents of the world at a point (contents::kEmpty and so on).
std::int32_t contents_at(const GameLevel& level, const Position& point);

/// The least z of the normal of a surface that can be stood upon: up to 45.6 degrees, Quake's 0.7.
inline constexpr Unit kGroundNormalZ = Unit::from_raw(751'619'277);
inline constexpr std::int32_t kStepHeight = 18;

/// A player's position and velocity.
struct Motion {
    Position position;
    Velocity velocity;
};

/// Straight motion for a tick, which slides along what it hits, up to four times.
Motion slide_move(const GameLevel& level, const GameState& state, const Motion& motion);

/// The same for a walking player: climbs steps of up to kStepHeight if that leads further.
Motion step_slide_move(const GameLevel& level, const GameState& state, const Motion& motion);

/// The ground within `reach` units below a position: where the box stands, and the model. Contact::has_hit is false if
/// there is none, or if it is too steep.
Contact find_ground(const GameLevel& level, const GameState& state, const Position& position, World reach);

}  // namespace oblong
