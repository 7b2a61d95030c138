#include "tests/game/scenario.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <sstream>
#include <stdexcept>

#include "engine/fixed/trig.h"
#include "game/simulation/collision.h"
#include "game/simulation/game_level.h"
#include "game/simulation/items.h"
#include "tests/support/folders.h"

namespace oblong::test {
namespace {

const std::map<std::string, TickInput> kInputs{
    {"ahead", kAhead}, {"back", {-127, 0, 0, 0, 0}},          {"askew", {127, 127, 0, 0, 0}},
    {"jump", kJump},   {"leap", {127, 0, 0, 0, kJumpButton}}, {"respawn", {0, 0, 0, 0, kRespawnButton}}};

double units(World value) {
    return value.raw / 4096.0;
}
double offset(const LogicGame& game, std::size_t mover, World Position::*axis) {
    return units(offset_of(game.level.movers.at(mover), game.state.movers.at(mover)).*axis);
}
/// How often what counts down from 100 was counted.
double counted(const LogicGame& game) {
    for (std::size_t i = 0; i < game.level.triggers.size(); ++i)
        if (game.level.triggers[i].kind == TriggerKind::Counter) return 100 - game.state.triggers.at(i).left;
    throw std::invalid_argument("no counter");
}

/// The mover of a brush model; none if it has none.
std::optional<std::size_t> mover_of(const LogicGame& game, std::size_t model) {
    for (std::size_t i = 0; i < game.level.movers.size(); ++i)
        if (game.level.movers[i].model == ModelIndex(static_cast<std::int32_t>(model))) return i;
    return {};
}
bool has_wall(const LogicGame& game, std::size_t model) {
    const std::vector<ModelIndex>& walls = game.level.walls;
    return std::find(walls.begin(), walls.end(), ModelIndex(static_cast<std::int32_t>(model))) != walls.end();
}
std::ptrdiff_t opened(const GameState& state) {
    return std::count_if(state.triggers.begin(), state.triggers.end(),
                         [](const TriggerState& trigger) { return trigger.open_until > 0; });
}

std::ptrdiff_t movers_at_end(const GameState& state) {
    return std::count_if(state.movers.begin(), state.movers.end(),
                         [](const MoverState& mover) { return mover.phase == MoverState::Phase::AtEnd; });
}
/// Triggers that never fire again.
std::ptrdiff_t spent_triggers(const GameState& state) {
    return std::count_if(state.triggers.begin(), state.triggers.end(),
                         [](const TriggerState& trigger) { return trigger.ready_tick == TriggerState::kNever; });
}

using Game = const LogicGame&;
using Number = std::function<double(Game, std::size_t which)>;
const std::map<std::string, Number> kNumbers{
    {"x", [](Game game, std::size_t) { return game.x(); }},
    {"y", [](Game game, std::size_t) { return game.y(); }},
    {"feet", [](Game game, std::size_t) { return game.feet(); }},
    {"vx", [](Game game, std::size_t) { return units(game.state.player.velocity.x); }},
    {"vy", [](Game game, std::size_t) { return units(game.state.player.velocity.y); }},
    {"vz", [](Game game, std::size_t) { return units(game.state.player.velocity.z); }},
    {"speed", [](Game game, std::size_t) { return units(length_of(game.state.player.velocity)); }},
    {"yaw", [](Game game, std::size_t) { return game.state.player.yaw.bam * 360 / 65'536.0; }},
    {"flies", [](Game game, std::size_t) { return game.state.player.ground == Player::kNoGround; }},
    {"depth", [](Game game, std::size_t) { return static_cast<double>(game.state.player.depth); }},
    {"keys", [](Game game, std::size_t) { return game.state.progress.keys; }},
    {"lenses", [](Game game, std::size_t) { return count_items(game.level, game.state, ItemClass::Lens).taken; }},
    {"health", [](Game game, std::size_t) { return game.level.health - game.state.harm.damage; }},
    {"lost", [](Game game, std::size_t) { return game.state.is_lost(); }},
    {"secrets", [](Game game, std::size_t) { return game.state.progress.found_secrets; }},
    {"ended", [](Game game, std::size_t) { return game.state.has_ended; }},
    {"said_at", [](Game game, std::size_t) { return static_cast<double>(game.state.message.tick); }},
    {"counted", [](Game game, std::size_t) { return counted(game); }},
    {"delayed", [](Game game, std::size_t) { return game.state.delayed.size(); }},
    {"active", [](Game game, std::size_t) { return game.state.active_movers.size(); }},
    {"arrived", [](Game game, std::size_t) { return movers_at_end(game.state); }},
    {"legs", [](Game game, std::size_t mover) { return game.level.movers.at(mover).legs.size(); }},
    {"spent", [](Game game, std::size_t) { return spent_triggers(game.state); }},
    {"activations", [](Game game, std::size_t) { return game.report.activations; }},
    {"touches", [](Game game, std::size_t) { return game.report.touches; }},
    {"left_movers", [](Game game, std::size_t) { return game.has_left_movers; }},
    {"left_obstacles", [](Game game, std::size_t) { return game.report.has_left_obstacles; }},
    {"backlog", [](Game game, std::size_t) { return !game.state.backlog.is_empty(); }},
    {"tick", [](Game game, std::size_t) { return static_cast<double>(game.state.tick); }},
    {"all_movers", [](Game game, std::size_t) { return game.level.movers.size(); }},
    {"all_walls", [](Game game, std::size_t) { return game.level.walls.size(); }},
    {"all_triggers", [](Game game, std::size_t) { return game.level.triggers.size(); }},
    {"all_items", [](Game game, std::size_t) { return game.level.items.size(); }},
    {"all_secrets", [](Game game, std::size_t) { return game.level.secrets; }},
    {"travelled", [](Game game, std::size_t mover) { return game.travelled(mover); }},
    {"ox", [](Game game, std::size_t mover) { return offset(game, mover, &Position::x); }},
    {"oy", [](Game game, std::size_t mover) { return offset(game, mover, &Position::y); }},
    {"oz", [](Game game, std::size_t mover) { return offset(game, mover, &Position::z); }},
    {"frame",
     [](Game game, std::size_t mover) {
         return shows_other_frames(game.level.movers.at(mover), game.state.movers.at(mover));
     }},
    {"z", [](Game game, std::size_t) { return units(game.state.player.position.z); }},
    {"opened", [](Game game, std::size_t) { return opened(game.state); }},
    {"has_mover", [](Game game, std::size_t model) { return mover_of(game, model).has_value(); }},
    {"has_wall", has_wall},
    {"model", [](Game game, std::size_t wall) { return game.level.walls.at(wall).number(); }},
};

constexpr const char* kPhases[] = {"start", "leaving", "end", "returning", "removed"};
constexpr const char* kWalls[] = {"there", "other", "removed"};
constexpr const char* kItems[] = {"there", "taken", "removed"};

template <class Enum>
std::string name_in(std::span<const char* const> names, Enum value) {
    return names[static_cast<std::size_t>(value)];
}

/// The numbers of the styles of lights that are out.
std::string dark_styles(std::uint64_t bits) {
    Words numbers;
    for (int style = 0; style < 64; ++style)
        if (bits >> style & 1) numbers.push_back(std::to_string(style));
    return joined(numbers);
}

std::string in_a_line(std::string text) {
    std::replace(text.begin(), text.end(), '\n', '/');
    return text;
}

using Text = std::function<std::string(Game, std::size_t which)>;
const std::map<std::string, Text> kTexts{
    {"message", [](Game game, std::size_t) { return game.message(); }},
    {"status", [](Game game, std::size_t) { return status_text(game.level, game.state, true); }},
    {"at_end", [](Game game, std::size_t) { return std::string(end_message(game.level, game.state)); }},
    {"next", [](Game game, std::size_t) { return std::string(next_map(game.level, game.state)); }},
    {"lenses_count", [](Game game, std::size_t) { return goal_of(game.level, game.state).count; }},
    {"lenses_hint", [](Game game, std::size_t) { return goal_of(game.level, game.state).hint; }},
    {"lenses_list", [](Game game, std::size_t) { return in_a_line(goal_of(game.level, game.state).list); }},
    {"missed", [](Game game, std::size_t) { return missed_secrets(game.level, game.state); }},
    {"dark", [](Game game, std::size_t) { return dark_styles(game.state.dark_styles); }},
    {"phase", [](Game game, std::size_t mover) { return name_in(kPhases, game.phase(mover)); }},
    {"phase_of_model",
     [](Game game, std::size_t model) { return name_in(kPhases, game.phase(*mover_of(game, model))); }},
    {"wall", [](Game game, std::size_t wall) { return name_in(kWalls, game.state.walls.at(wall)); }},
    {"item", [](Game game, std::size_t item) { return name_in(kItems, game.state.items.at(item)); }},
};

/// "phase12" as "phase" and 12.
struct Name {
    explicit Name(const std::string& text) : word(text.substr(0, text.find_last_not_of("0123456789") + 1)) {
        if (word.size() < text.size()) which = std::stoul(text.substr(word.size()));
    }
    std::string word;
    std::size_t which = 0;
};

class Run {
  public:
    explicit Run(ToyLevel level) : game_(std::move(level)) {}

    void do_line(const ScriptLine& line) {
        SCOPED_TRACE(line.text);
        for (const Words& action : line.actions) act(action, line.checks);
        check_all(line.checks);
        EXPECT_EQ(find_inconsistency(game_.level, game_.state), "");
        EXPECT_FALSE(game_.has_left_work && !may_be_late_);
    }
    int checks() const { return checks_; }

  private:
    void act(const Words& words, const std::vector<Words>& checks) {
        const auto number = [&](std::size_t i) { return i < words.size() ? std::stoi(words[i]) : 0; };
        const auto input = [&](std::size_t i) {
            TickInput chosen = i < words.size() ? kInputs.at(words[i]) : kStand;
            chosen.view = picture_.view;
            chosen.work = picture_.work;
            return chosen;
        };
        const std::string& verb = words[0];
        may_be_late_ |= verb == "may_be_late";
        if (verb == "at" || verb == "stand") game_.put_at(number(1), number(2), number(3));
        if (verb == "stand")
            game_.play(1, input(words.size()));
        else if (verb == "picture")
            for (std::size_t i = 1; i < words.size(); ++i) draw_by(words[i]);
        else if (verb == "wait")
            game_.wait(number(1));
        else if (verb == "play")
            game_.play(number(1), input(2));
        else if (verb == "look") {
            game_.state.player.yaw = degrees_to_angle(Degrees::from_int(number(1)));
            game_.state.player.pitch = number(2) * 65'536 / 360;
        } else if (verb == "activate")
            Activations(game_.level, game_.state).activate({EntityRef::Kind::Mover, which(words)});
        else if (verb == "untouchable")
            game_.level.movers.at(which(words)).touch.box.reset();
        else if (verb == "each")
            for (int tick = 0; tick < number(1) && !testing::Test::HasFailure(); ++tick) {
                game_.play(1, input(2));
                check_all(checks);
            }
        else if (verb != "at" && verb != "may_be_late")
            throw std::invalid_argument("no such verb: " + verb);
    }
    /// "accuracy=1991" or "work=900".
    void draw_by(const std::string& word) {
        const std::size_t equals = word.find('=');
        const std::string key = word.substr(0, equals), value = word.substr(equals + 1);
        if (key == "work") picture_.work = static_cast<std::uint16_t>(std::stoi(value));
        for (std::size_t i = 0; i < kViewDials; ++i)
            if (all_view_dials()[i].key == key) picture_.view[i] = value_named(all_view_dials()[i], value).value();
    }
    static std::uint32_t which(const Words& words) { return static_cast<std::uint32_t>(std::stoul(words.at(1))); }

    void check_all(const std::vector<Words>& checks) {
        for (const Words& words : checks) {
            ++checks_;
            if (words.at(0) == "free" || words.at(0) == "solid") {
                const Position place =
                    world_vector(std::stoi(words.at(1)), std::stoi(words.at(2)), std::stoi(words.at(3)));
                EXPECT_EQ(is_free(game_.level, game_.state, place), words[0] == "free") << joined(words);
            } else if (words[0] == "near") {
                const double off = std::hypot(game_.x() - std::stoi(words.at(1)), game_.y() - std::stoi(words.at(2)),
                                              game_.feet() - std::stoi(words.at(3)));
                EXPECT_LT(off, 40) << joined(words);
            } else if (const Name name(words.at(0)); kTexts.contains(name.word)) {
                const std::string found = kTexts.at(name.word)(game_, name.which);
                EXPECT_EQ(found == words.at(2), words.at(1) == "=") << joined(words) << ": is " << found;
            } else {
                check_number(words);
            }
        }
    }
    void check_number(const Words& words) const {
        const double found = value(words.at(0)), wanted = value(words.at(2));
        const double tolerance = words.size() > 3 && words[3] == "+-" ? std::stod(words.at(4)) : 0;
        const std::map<std::string, bool> holds{{"=", std::abs(found - wanted) <= tolerance},
                                                {"!=", found != wanted},
                                                {"<", found < wanted},
                                                {">", found > wanted},
                                                {"<=", found <= wanted},
                                                {">=", found >= wanted}};
        EXPECT_TRUE(holds.at(words.at(1))) << joined(words) << ": is " << found << " at tick " << game_.state.tick;
    }
    /// A sum of numbers and names.
    double value(const std::string& sum) const {
        double value = 0;
        std::istringstream terms(sum);
        for (std::string term; std::getline(terms, term, '+');) {
            const bool is_number = std::isdigit(static_cast<unsigned char>(term.at(0))) != 0 || term[0] == '-';
            const Name name(term);
            value += is_number ? std::stod(term) : kNumbers.at(name.word)(game_, name.which);
        }
        return value;
    }

    LogicGame game_;
    TickInput picture_;  ///< its view and work
    int checks_ = 0;
    bool may_be_late_ = false;
};

}  // namespace

void play(const Scenario& scenario) {
    std::vector<Words> entities;
    std::vector<ScriptLine> steps;
    for (const ScriptLine& line : script_lines(scenario.text))
        if (line.text.starts_with('+'))
            entities.push_back(words_of(line.text));
        else
            steps.push_back(line);
    if (!entities.empty() && entities[0].at(1).ends_with(".bsp")) OBLONG_NEEDS_SHARED_LEVELS();
    Run run(level_of(entities));
    for (const ScriptLine& step : steps) run.do_line(step);
    EXPECT_GT(run.checks(), 0) << "nothing is asked";
}

}  // namespace oblong::test
