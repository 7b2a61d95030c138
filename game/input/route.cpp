#include "game/input/route.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string>

#include "engine/base/input_error.h"
#include "engine/base/text.h"
#include "engine/fixed/trig.h"
#include "game/simulation/step.h"

namespace oblong {
namespace {

constexpr std::string_view kHeader = "x,y,z,speed,wait,yaw,pitch,jump", kViewColumn = ",view";
constexpr std::size_t kColumns = 8;  // of numbers
constexpr std::int64_t kPatience_ticks = 40 * kTicksPerSecond;
constexpr std::int32_t kWaypointReach = 16, kReachInPassing = 40;  // world units from a waypoint
constexpr World kLongestMotion = World::from_int(100);             // in a tick: more is a teleporter
constexpr std::int32_t kFeetBelow = 24;                            // Player::position

// How a head turns, 65,536 to the circle per tick: the largest rate, its largest change, and the divisor of the
// remaining angle that gives the wanted rate.
struct Turning {
    std::int32_t fastest, gain, nearness;
};
constexpr Turning kYawTurning{480, 52, 10}, kPitchTurning{160, 17, 10};

using Fields = std::array<std::optional<std::int32_t>, kColumns>;

std::int32_t whole_number(const std::string& field, std::size_t line) {
    constexpr std::int64_t kLargest = kWorldEnd;
    const auto number = parse_decimal(field, 0);
    if (!number || *number > kLargest || *number < -kLargest || field.find('.') != std::string::npos)
        throw InputError(at_line(line), "'" + field + "', expected a whole number within +-32,768");
    return static_cast<std::int32_t>(*number);
}

Fields fields_of(const std::vector<std::string>& texts, std::size_t line) {
    Fields fields;
    for (std::size_t column = 0; column < kColumns; ++column)
        if (!texts[column].empty()) fields[column] = whole_number(texts[column], line);
    return fields;
}

std::int32_t in_range(std::optional<std::int32_t> value, std::int32_t otherwise, std::int32_t most, const char* what,
                      std::size_t line) {
    const std::int32_t number = value.value_or(otherwise);
    if (number >= 0 && number <= most) return number;
    throw InputError(at_line(line),
                     std::string(what) + " is " + std::to_string(number) + ", expected 0 to " + std::to_string(most));
}

// "accuracy=1991 work=900", on top of the waypoint before.
void turn_dials(std::string_view text, Waypoint& waypoint) {
    for (std::string_view word = take_word(text); !word.empty(); word = take_word(text)) {
        const std::size_t equals = std::min(word.find('='), word.size());
        const std::string_view key = word.substr(0, equals), value = word.substr(std::min(equals + 1, word.size()));
        bool is_known = key == "work";
        if (is_known)
            waypoint.work = static_cast<std::uint16_t>(
                in_range(whole_number(std::string(value), waypoint.line), 0, 32'767, "work", waypoint.line));
        for (std::size_t i = 0; i < kViewDials; ++i) {
            const std::optional<std::uint8_t> turned = value_named(all_view_dials()[i], value);
            if (all_view_dials()[i].key != key || !turned) continue;
            waypoint.view[i] = *turned;
            is_known = true;
        }
        if (!is_known)
            throw InputError(at_line(waypoint.line),
                             "'" + std::string(word) + "', expected a dial of trigger_view or work=NUMBER");
    }
}

std::int32_t bam_of(std::int32_t degrees) {
    return static_cast<std::int32_t>(std::int64_t{degrees} * 65'536 / 360);
}

Waypoint waypoint_of(const std::vector<std::string>& texts, std::size_t line) {
    const Fields fields = fields_of(texts, line);
    const auto& [x, y, z, speed, wait, yaw, pitch, jump] = fields;
    if (!x || !y) throw InputError(at_line(line), "no x or no y, expected both");
    Waypoint waypoint;
    waypoint.x = *x;
    waypoint.y = *y;
    waypoint.least_feet = z;
    waypoint.speed_100 = in_range(speed, 50, 100, "speed", line);
    waypoint.wait_ticks = in_range(wait, 0, 600, "wait", line) * static_cast<std::int32_t>(kTicksPerSecond) / 10;
    if (yaw) waypoint.yaw = Angle::from_bam(bam_of(*yaw));
    if (pitch.value_or(0) > 80 || pitch.value_or(0) < -80)
        throw InputError(at_line(line), "pitch is " + std::to_string(*pitch) + ", expected -80 to 80");
    waypoint.pitch = bam_of(pitch.value_or(0));
    waypoint.jumps = in_range(jump, 0, 1, "jump", line) == 1;
    waypoint.line = line;
    return waypoint;
}

// The rate in the next tick, with `error` left to turn.
std::int32_t next_rate(std::int32_t rate, std::int32_t error, const Turning& turning) {
    const std::int32_t wanted = std::clamp(error / turning.nearness, -turning.fastest, turning.fastest);
    return rate + std::clamp(wanted - rate, -turning.gain, turning.gain);
}

// The shorter turn from one direction to another, left positive.
std::int32_t way_between(Angle from, Angle to) {
    return static_cast<std::int16_t>((to - from).bam);
}

// The speed of a visitor who looks away from the way: full up to 6 degrees, 0 from 50 degrees on.
std::int32_t slowed(std::int32_t speed, std::int32_t yaw_error) {
    constexpr std::int32_t kFull = 1092, kNone = 9102;
    return speed * std::clamp(kNone - std::abs(yaw_error), 0, kNone - kFull) / (kNone - kFull);
}

// Makes the input of a visitor who walks from waypoint to waypoint (a teleporter on the way is one), turns smoothly at
// a human's pace, and slows down at corners. Integers only, so that a route is the same walk on every machine.
class RouteWalker {
  public:
    explicit RouteWalker(std::span<const Waypoint> route) : route_(route) {}

    bool is_over() const { return at_ == route_.size(); }
    // True if the next waypoint was not reached within 40 seconds.
    bool is_stuck() const { return !is_over() && ticks_ > kPatience_ticks + waypoint().wait_ticks; }
    const Waypoint& waypoint() const { return route_[at_]; }

    // The input of the tick after a state. Requires !is_over().
    TickInput next(const GameState& state) {
        const Player& player = state.player;
        if (has_arrived(player)) {
            ++at_;
            ticks_ = waited_ = 0;
            is_there_ = false;
            if (is_over()) return {};
        }
        const Waypoint& goal = waypoint();
        const Waypoint& shown = is_there_ || at_ == 0 ? goal : route_[at_ - 1];
        TickInput input;
        input.view = shown.view;
        input.work = shown.work;
        Angle wanted = goal.yaw.value_or(player.yaw);
        if (!is_there_) {
            wanted =
                arctangent2(World::from_int(goal.y) - player.position.y, World::from_int(goal.x) - player.position.x);
            input.forward =
                static_cast<std::int8_t>(slowed(goal.speed_100 * 127 / 100, way_between(player.yaw, wanted)));
        }
        turn(way_between(player.yaw, wanted), goal.pitch - player.pitch, input);
        if (goal.jumps && ticks_ == 0) input.buttons = kJumpButton;
        ++ticks_;
        return input;
    }

  private:
    // True when the stay at the current waypoint is over.
    bool has_arrived(const Player& player) {
        const Waypoint& goal = waypoint();
        const World dx = World::from_int(goal.x) - player.position.x, dy = World::from_int(goal.y) - player.position.y;
        const bool passes = goal.wait_ticks == 0 && !goal.least_feet;
        const World reach = World::from_int(passes ? kReachInPassing : kWaypointReach);
        const bool was_teleported = last_ && length_of(player.position - *last_) > kLongestMotion;
        last_ = player.position;
        is_there_ |= was_teleported || length_of({dx, dy, World{}}) <= reach;
        if (!is_there_) return false;
        const bool is_up = !goal.least_feet || player.position.z >= World::from_int(*goal.least_feet + kFeetBelow);
        return is_up && waited_++ >= goal.wait_ticks;
    }

    void turn(std::int32_t yaw_error, std::int32_t pitch_error, TickInput& input) {
        yaw_rate_ = next_rate(yaw_rate_, yaw_error, kYawTurning);
        pitch_rate_ = next_rate(pitch_rate_, pitch_error, kPitchTurning);
        input.yaw = static_cast<std::int16_t>(yaw_rate_);
        input.pitch = static_cast<std::int16_t>(pitch_rate_);
    }

    std::span<const Waypoint> route_;
    std::size_t at_ = 0;
    std::int64_t ticks_ = 0, waited_ = 0;  // on the way to the waypoint, and at it
    bool is_there_ = false;
    std::optional<Position> last_;                // before the tick
    std::int32_t yaw_rate_ = 0, pitch_rate_ = 0;  // a tick
};

std::string words(const Position& p) {
    return std::to_string(floor_of(p.x)) + " " + std::to_string(floor_of(p.y)) + " " + std::to_string(floor_of(p.z));
}

}  // namespace

std::vector<Waypoint> parse_route(std::span<const std::uint8_t> bytes) {
    std::string text = plain_text({bytes.begin(), bytes.end()});
    std::erase(text, '\r');
    const std::vector<std::string> lines = split(text, "\n");
    const bool has_view = lines[0] == std::string(kHeader) + std::string(kViewColumn);
    if (!has_view && lines[0] != kHeader)
        throw InputError(at_line(1), "'" + lines[0] + "', expected " + std::string(kHeader) + " and perhaps ,view");
    const std::size_t columns = kColumns + has_view;
    std::vector<Waypoint> route;
    for (std::size_t i = 1; i < lines.size(); ++i) {
        if (lines[i].empty()) continue;
        const std::vector<std::string> texts = split(lines[i], ",");
        if (texts.size() != columns)
            throw InputError(at_line(i + 1),
                             std::to_string(texts.size()) + " fields, expected " + std::to_string(columns));
        Waypoint waypoint = waypoint_of(texts, i + 1);
        if (!route.empty()) {
            waypoint.view = route.back().view;
            waypoint.work = route.back().work;
        }
        if (has_view) turn_dials(texts.back(), waypoint);
        route.push_back(waypoint);
    }
    if (route.empty()) throw InputError(at_line(2), "no waypoint, expected at least one");
    return route;
}

Demo walk_route(const GameLevel& level, std::span<const Waypoint> route) {
    GameState state = start_of(level);
    Demo demo;
    demo.start_hash = hash_of(state);
    RouteWalker walker(route);
    while (!state.has_ended) {
        const TickInput input = walker.next(state);
        if (walker.is_over()) break;
        if (walker.is_stuck())
            throw InputError(at_line(walker.waypoint().line),
                             "stuck at " + words(state.player.position) + ", expected to reach " +
                                 std::to_string(walker.waypoint().x) + " " + std::to_string(walker.waypoint().y));
        step(level, state, input);
        demo.ticks.push_back({input, hash_of(state)});
    }
    return demo;
}

}  // namespace oblong
