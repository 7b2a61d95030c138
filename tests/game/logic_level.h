#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "engine/level/level.h"
#include "game/simulation/step.h"

namespace oblong::test {

/// Corners of a solid box, in whole units.
struct Solid {
    std::int32_t min_x, min_y, min_z, max_x, max_y, max_z;
};

/// Adds a plane across an axis.
inline PlaneIndex add_plane(Level& level, std::uint8_t axis, std::int32_t distance) {
    LevelPlane plane;
    plane.axis = axis;
    (axis == 0 ? plane.normal.x : axis == 1 ? plane.normal.y : plane.normal.z) = Unit::from_int(1);
    plane.distance = PlaneDistance::from_int(distance);
    level.planes.push_back(plane);
    return PlaneIndex(level.planes.count() - 1);
}

/// A tiny level of solid boxes for the player to bump into: hull 1 is a chain of boxes grown by the player's, hull 0 is
/// empty, but for water below `water_z`.
class ToyLevel {
  public:
    explicit ToyLevel(std::int32_t water_z = -30'000) {
        level.leaves.resize(3);
        level.leaves[LeafIndex(0)].contents = contents::kSolid;
        level.leaves[LeafIndex(1)].contents = contents::kEmpty;
        level.leaves[LeafIndex(2)].contents = contents::kWater;
        Node surface;
        surface.plane = add_plane(level, 2, water_z);
        surface.children = {NodeChild(LeafIndex(1)), NodeChild(LeafIndex(2))};
        level.nodes.push_back(surface);
    }

    /// Adds a model of these boxes: the first is the world, the others are entities' "*1", "*2" and so on.
    ToyLevel& add_model(const std::vector<Solid>& solids) {
        SubModel model;
        model.clip_roots[0] = chain(solids);
        const Solid& box = solids.front();
        model.box = {{box.min_x, box.min_y, box.min_z}, {box.max_x, box.max_y, box.max_z}};
        level.models.push_back(model);
        return *this;
    }

    ToyLevel& add_entity(std::vector<std::pair<std::string, std::string>> pairs) {
        level.entities.push_back({std::move(pairs)});
        return *this;
    }

    Level level;

  private:
    // Six planes of a box: outside any of them is the next box's chain, inside all is solid.
    ClipChild chain(const std::vector<Solid>& solids) {
        ClipChild next(contents::kEmpty);
        for (const Solid& s : solids) {
            ClipChild inside(contents::kSolid);
            const auto cut = [&](std::uint8_t axis, std::int32_t distance, bool solid_is_front) {
                ClipNode node;
                node.plane = add_plane(level, axis, distance);
                node.children = {solid_is_front ? inside : next, solid_is_front ? next : inside};
                level.clip_nodes.push_back(node);
                inside = ClipChild(ClipNodeIndex(level.clip_nodes.count() - 1));
            };
            cut(0, s.min_x - 16, true), cut(0, s.max_x + 16, false);
            cut(1, s.min_y - 16, true), cut(1, s.max_y + 16, false);
            cut(2, s.min_z - 32, true), cut(2, s.max_z + 24, false);
            next = inside;
        }
        return next;
    }
};

/// A floor at z = 0, 4096 units square, and what stands on it.
inline std::vector<Solid> floor_and(std::vector<Solid> others) {
    others.insert(others.begin(), {-2048, -2048, -64, 2048, 2048, 0});
    return others;
}

/// A game in a toy level whose player starts with feet at (0, 0, `height`), looking along +x.
struct ToyGame {
    explicit ToyGame(ToyLevel toy_level, std::int32_t height = 0) : toy(std::move(toy_level)) {
        toy.add_entity({{"classname", "info_player_start"}, {"origin", "0 0 " + std::to_string(24 + height)}});
        level = make_game_level(toy.level);
        state = start_of(level);
    }
    ToyGame(const ToyGame&) = delete;  // `level` points into `toy`

    void play(int ticks, const TickInput& input) {
        for (int i = 0; i < ticks; ++i) {
            report = step(level, state, input);
            has_left_work |= !report.left().empty();
            has_left_movers |= report.has_left_movers;
        }
    }
    double x() const { return state.player.position.x.raw / 4096.0; }
    double y() const { return state.player.position.y.raw / 4096.0; }
    double feet() const { return state.player.position.z.raw / 4096.0 - 24; }
    double travelled(std::size_t mover) const { return state.movers[mover].travelled.raw / 4096.0; }

    ToyLevel toy;
    GameLevel level;
    GameState state;
    TickReport report;                                    ///< of the last tick of play()
    bool has_left_work = false, has_left_movers = false;  ///< in any tick of it
};

inline constexpr TickInput kStand{}, kAhead{127, 0, 0, 0, 0}, kJump{0, 0, 0, 0, kJumpButton};

/// Runs ahead or askew, turns and jumps, at random.
class RandomRun {
  public:
    TickInput next() {
        TickInput input = kAhead;
        if (random_() % 8 == 0) input.right = 127;
        if (random_() % 20 == 0) input.yaw = static_cast<std::int16_t>(random_());
        if (random_() % 12 == 0) input.buttons = kJumpButton;
        return input;
    }

  private:
    std::mt19937 random_{1};
};

using Pairs = std::vector<std::pair<std::string, std::string>>;

/// A toy level of some blocks to which brush and point entities are added one by one. The player starts at the middle
/// of a floor that is 4096 units square, and looks along +x.
class LogicLevel {
  public:
    explicit LogicLevel(std::vector<Solid> blocks = {}) { toy_.add_model(floor_and(std::move(blocks))); }

    /// A brush entity of one box.
    LogicLevel& add(const std::string& its_class, const Solid& box, Pairs pairs = {}) {
        toy_.add_model({box});
        pairs.insert(pairs.begin(), {"classname", its_class});
        pairs.emplace_back("model", "*" + std::to_string(++models_));
        toy_.add_entity(std::move(pairs));
        return *this;
    }
    /// A point entity.
    LogicLevel& add(const std::string& its_class, Pairs pairs) {
        pairs.insert(pairs.begin(), {"classname", its_class});
        toy_.add_entity(std::move(pairs));
        return *this;
    }
    ToyLevel take() { return std::move(toy_); }

  private:
    ToyLevel toy_;
    int models_ = 0;
};

/// A game in such a level, with words for what its tests ask.
struct LogicGame : ToyGame {
    explicit LogicGame(LogicLevel& source) : ToyGame(source.take()) {}
    explicit LogicGame(ToyLevel of_toys) : ToyGame(std::move(of_toys)) {}

    /// Puts the player somewhere, feet on the floor unless they are said to be higher, and plays a tick.
    void stand_at(std::int32_t x, std::int32_t y, std::int32_t feet_z = 0) {
        put_at(x, y, feet_z);
        play(1, kStand);
    }
    void put_at(std::int32_t x, std::int32_t y, std::int32_t feet_z = 0) {
        state.player.position = world_vector(x, y, feet_z + 24);
        state.player.velocity = {};
    }
    /// Far from everything.
    void wait(int ticks) {
        put_at(-1900, -1900);
        play(ticks, kStand);
    }
    MoverState::Phase phase(std::size_t mover) const { return state.movers.at(mover).phase; }
    bool has_left(std::size_t mover) const { return phase(mover) != MoverState::Phase::AtStart; }
    /// The message that was shown last; empty if none was.
    std::string message() const {
        return state.message.shown < 0 ? "" : level.messages.at(static_cast<std::size_t>(state.message.shown));
    }
};

}  // namespace oblong::test
