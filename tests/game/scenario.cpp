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
#include "engine/level/bsp_read.h"
#include "game/simulation/collision.h"
#include "game/simulation/game_level.h"
#include "game/simulation/items.h"
#include "tests/game/logic_level.h"
#include "tests/support/folders.h"
#include "tests/support/script.h"

namespace oblong::test {
namespace {

/// "{300+40i}" is 300 + 40 * i.
std::string with_number(std::string word, int i) {
    for (std::size_t end = word.find("i}"); end != std::string::npos; end = word.find("i}")) {
        const std::size_t at = word.rfind('{', end), plus = word.find_first_of("+-", at + 2);
        const int number = std::stoi(word.substr(at + 1)) + i * std::stoi(word.substr(plus));
        word.replace(at, end + 2 - at, std::to_string(number));
    }
    return word;
}

/// An entity's line.
struct EntityLine {
    explicit EntityLine(const Words& words) : its_class(words.at(1)) {
        for (std::size_t i = 2; i < words.size(); ++i) {
            const std::size_t sign = words[i].find('=');
            if (sign == std::string::npos)
                numbers.push_back(std::stoi(words[i]));
            else
                pairs.emplace_back(words[i].substr(0, sign), words[i].substr(sign + 1));
        }
    }
    Solid box() const {
        return {numbers.at(0), numbers.at(1), numbers.at(2), numbers.at(3), numbers.at(4), numbers.at(5)};
    }

    std::string its_class;
    std::vector<std::int32_t> numbers;
    Pairs pairs;
};

/// Perhaps many, "5x" before the class.
void add_entities(Words words, std::vector<EntityLine>& entities) {
    const bool are_many = words.at(1).ends_with('x') && std::isdigit(static_cast<unsigned char>(words[1][0])) != 0;
    const int count = are_many ? std::stoi(words[1]) : 1;
    if (are_many) words.erase(words.begin() + 1);
    for (int i = 0; i < count; ++i) {
        Words numbered = words;
        for (std::string& word : numbered) word = with_number(word, i);
        entities.emplace_back(numbered);
    }
}

ToyLevel level_of(const std::vector<EntityLine>& lines) {
    std::int32_t water_z = -30'000, liquid = contents::kWater;
    const std::map<std::string, std::int32_t> liquids{
        {"water", contents::kWater}, {"slime", contents::kSlime}, {"lava", contents::kLava}};
    std::vector<Solid> world = floor_and({});
    for (const EntityLine& line : lines) {
        if (const auto found = liquids.find(line.its_class); found != liquids.end()) {
            water_z = line.numbers.at(0);
            liquid = found->second;
        }
        if (line.its_class == "no_floor") world.erase(world.begin());
        if (line.its_class == "solid") world.push_back(line.box());
    }
    ToyLevel toy(water_z);
    toy.level.leaves[LeafIndex(2)].contents = liquid;
    if (!lines.empty() && lines[0].its_class.ends_with(".bsp")) {
        toy.level = read_bsp(read_shared_file(lines[0].its_class));
        return toy;
    }
    toy.add_model(world);
    for (const EntityLine& line : lines) {
        if (liquids.contains(line.its_class) || line.its_class == "no_floor" || line.its_class == "solid") continue;
        Pairs pairs{{"classname", line.its_class}};
        pairs.insert(pairs.end(), line.pairs.begin(), line.pairs.end());
        if (!line.numbers.empty()) {
            pairs.emplace_back("model", "*" + std::to_string(toy.level.models.count()));
            toy.add_model({line.box()});
        }
        toy.add_entity(std::move(pairs));
    }
    return toy;
}

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
    return std::any_of(game.level.walls.begin(), game.level.walls.end(),
                       [&](const Wall& wall) { return wall.model == ModelIndex(static_cast<std::int32_t>(model)); });
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

using Number = std::function<double(const LogicGame&, std::size_t which)>;
const std::map<std::string, Number> kNumbers{
    {"x", [](const LogicGame& game, std::size_t) { return game.x(); }},
    {"y", [](const LogicGame& game, std::size_t) { return game.y(); }},
    {"feet", [](const LogicGame& game, std::size_t) { return game.feet(); }},
    {"vx", [](const LogicGame& game, std::size_t) { return units(game.state.player.velocity.x); }},
    {"vy", [](const LogicGame& game, std::size_t) { return units(game.state.player.velocity.y); }},
    {"vz", [](const LogicGame& game, std::size_t) { return units(game.state.player.velocity.z); }},
    {"speed", [](const LogicGame& game, std::size_t) { return units(length_of(game.state.player.velocity)); }},
    {"yaw", [](const LogicGame& game, std::size_t) { return game.state.player.yaw.bam * 360 / 65'536.0; }},
    {"flies", [](const LogicGame& game, std::size_t) { return game.state.player.ground == Player::kNoGround; }},
    {"depth", [](const LogicGame& game, std::size_t) { return static_cast<double>(game.state.player.depth); }},
    {"keys", [](const LogicGame& game, std::size_t) { return game.state.progress.keys; }},
    {"lenses",
     [](const LogicGame& game, std::size_t) { return count_items(game.level, game.state, ItemClass::Lens).taken; }},
    {"health", [](const LogicGame& game, std::size_t) { return game.level.health - game.state.harm.damage; }},
    {"lost", [](const LogicGame& game, std::size_t) { return game.state.is_lost(); }},
    {"secrets", [](const LogicGame& game, std::size_t) { return game.state.progress.found_secrets; }},
    {"ended", [](const LogicGame& game, std::size_t) { return game.state.has_ended; }},
    {"said_at", [](const LogicGame& game, std::size_t) { return static_cast<double>(game.state.message.tick); }},
    {"counted", [](const LogicGame& game, std::size_t) { return counted(game); }},
    {"delayed", [](const LogicGame& game, std::size_t) { return game.state.delayed.size(); }},
    {"active", [](const LogicGame& game, std::size_t) { return game.state.active_movers.size(); }},
    {"arrived", [](const LogicGame& game, std::size_t) { return movers_at_end(game.state); }},
    {"legs", [](const LogicGame& game, std::size_t mover) { return game.level.movers.at(mover).legs.size(); }},
    {"spent", [](const LogicGame& game, std::size_t) { return spent_triggers(game.state); }},
    {"activations", [](const LogicGame& game, std::size_t) { return game.report.activations; }},
    {"touches", [](const LogicGame& game, std::size_t) { return game.report.touches; }},
    {"left_movers", [](const LogicGame& game, std::size_t) { return game.has_left_movers; }},
    {"left_obstacles", [](const LogicGame& game, std::size_t) { return game.report.has_left_obstacles; }},
    {"backlog", [](const LogicGame& game, std::size_t) { return !game.state.backlog.is_empty(); }},
    {"tick", [](const LogicGame& game, std::size_t) { return static_cast<double>(game.state.tick); }},
    {"all_movers", [](const LogicGame& game, std::size_t) { return game.level.movers.size(); }},
    {"all_walls", [](const LogicGame& game, std::size_t) { return game.level.walls.size(); }},
    {"all_triggers", [](const LogicGame& game, std::size_t) { return game.level.triggers.size(); }},
    {"all_items", [](const LogicGame& game, std::size_t) { return game.level.items.size(); }},
    {"all_secrets", [](const LogicGame& game, std::size_t) { return game.level.secrets; }},
    {"travelled", [](const LogicGame& game, std::size_t mover) { return game.travelled(mover); }},
    {"ox", [](const LogicGame& game, std::size_t mover) { return offset(game, mover, &Position::x); }},
    {"oy", [](const LogicGame& game, std::size_t mover) { return offset(game, mover, &Position::y); }},
    {"oz", [](const LogicGame& game, std::size_t mover) { return offset(game, mover, &Position::z); }},
    {"frame",
     [](const LogicGame& game, std::size_t mover) {
         return shows_other_frames(game.level.movers.at(mover), game.state.movers.at(mover));
     }},
    {"z", [](const LogicGame& game, std::size_t) { return units(game.state.player.position.z); }},
    {"opened", [](const LogicGame& game, std::size_t) { return opened(game.state); }},
    {"has_mover", [](const LogicGame& game, std::size_t model) { return mover_of(game, model).has_value(); }},
    {"has_wall", has_wall},
    {"model", [](const LogicGame& game, std::size_t wall) { return game.level.walls.at(wall).model.number(); }},
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

using Text = std::function<std::string(const LogicGame&, std::size_t which)>;
const std::map<std::string, Text> kTexts{
    {"message", [](const LogicGame& game, std::size_t) { return game.message(); }},
    {"status", [](const LogicGame& game, std::size_t) { return status_text(game.level, game.state, true); }},
    {"at_end", [](const LogicGame& game, std::size_t) { return std::string(end_message(game.level, game.state)); }},
    {"next", [](const LogicGame& game, std::size_t) { return std::string(next_map(game.level, game.state)); }},
    {"lenses_count", [](const LogicGame& game, std::size_t) { return goal_of(game.level, game.state).count; }},
    {"lenses_hint", [](const LogicGame& game, std::size_t) { return goal_of(game.level, game.state).hint; }},
    {"lenses_list", [](const LogicGame& game, std::size_t) { return in_a_line(goal_of(game.level, game.state).list); }},
    {"missed", [](const LogicGame& game, std::size_t) { return missed_secrets(game.level, game.state); }},
    {"dark", [](const LogicGame& game, std::size_t) { return dark_styles(game.state.dark_styles); }},
    {"phase", [](const LogicGame& game, std::size_t mover) { return name_in(kPhases, game.phase(mover)); }},
    {"phase_of_model",
     [](const LogicGame& game, std::size_t model) { return name_in(kPhases, game.phase(*mover_of(game, model))); }},
    {"wall", [](const LogicGame& game, std::size_t wall) { return name_in(kWalls, game.state.walls.at(wall)); }},
    {"item", [](const LogicGame& game, std::size_t item) { return name_in(kItems, game.state.items.at(item)); }},
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
    std::vector<EntityLine> entities;
    std::vector<ScriptLine> steps;
    for (const ScriptLine& line : script_lines(scenario.text))
        if (line.text.starts_with('+'))
            add_entities(words_of(line.text), entities);
        else
            steps.push_back(line);
    if (!entities.empty() && entities[0].its_class.ends_with(".bsp")) OBLONG_NEEDS_SHARED_LEVELS();
    Run run(level_of(entities));
    for (const ScriptLine& step : steps) run.do_line(step);
    EXPECT_GT(run.checks(), 0) << "nothing is asked";
}

}  // namespace oblong::test
