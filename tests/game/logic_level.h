#pragma once

#include <string>
#include <utility>
#include <vector>

#include "tests/game/toy_game.h"

namespace oblong::test {

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
