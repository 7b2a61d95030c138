#include "game/sound/audible.h"

#include <algorithm>
#include <array>

#include "engine/base/table.h"
#include "engine/fixed/root.h"
#include "engine/fixed/trig.h"
#include "engine/level/trace.h"
#include "game/simulation/collision.h"
#include "game/simulation/step.h"

namespace oblong {
namespace {

constexpr std::int64_t kOne_16 = 1 << 16;
constexpr std::int64_t kMostPan_16 = kOne_16 * 7 / 8;  // so that the far ear always hears something
constexpr World kNear = World::from_int(96);           // nearer than this, panning is reduced
constexpr World kInReach = World::from_int(32);        // nearer than this, nothing can be in between
constexpr std::int32_t kSurfaceRise = 32;  // a liquid is heard from above its surface, over the edge of its basin
constexpr std::int32_t kBlockedGain_256 = 140,
                       kBlockedWind_256 = 40;  // wind has no single source: faint indoors
constexpr std::int32_t kFaintest_256 = 3;      // the sum of both sides below which a sound gets no voice

Position nearest_point(const Box& box, const Position& to) {
    return {std::clamp(to.x, box.mins.x, box.maxs.x), std::clamp(to.y, box.mins.y, box.maxs.y),
            std::clamp(to.z, box.mins.z, box.maxs.z)};
}

std::int64_t root_of_16(std::int64_t value_16) {
    return integer_root(static_cast<std::uint64_t>(value_16) * kOne_16);
}

// The component of a direction vector along a horizontal direction, -1 to 1; less for near sources.
std::int64_t part_along_16(const Vec3<World>& way, World distance, Angle direction) {
    const World along = component_along(way, {cosine(direction), sine(direction), Unit{}});
    const std::int64_t part = convert<WorldWide>(along) * kOne_16 / convert<WorldWide>(std::max(distance, kNear));
    return std::clamp(part, -kOne_16, kOne_16);
}

Direction direction_to(const SoundSource& source, const Listener& listener) {
    if (row_of(source.sound).range == 0) return Direction::Here;
    const Vec3<World> way = nearest_point(source.box, listener.ear) - listener.ear;
    if (length_of(way) < kNear) return Direction::Here;
    const World ahead = component_along(way, {cosine(listener.yaw), sine(listener.yaw), Unit{}});
    const Angle to_right = listener.yaw - kQuarterTurn;
    const World right = component_along(way, {cosine(to_right), sine(to_right), Unit{}});
    if (absolute(right) > absolute(ahead)) return right > World{} ? Direction::Right : Direction::Left;
    return ahead >= World{} ? Direction::Ahead : Direction::Behind;
}

bool is_liquid(Sound sound) {
    return sound == Sound::Water || sound == Sound::Slime || sound == Sound::Lava;
}

// The middle of a liquid, above its surface: its nearest point may be hidden by the edge of its basin.
Position over_middle(const Box& box, const Position& ear) {
    const Position middle = box.mins + scaled(box.size(), 1, 2);
    return {middle.x, middle.y, std::min(box.maxs.z + World::from_int(kSurfaceRise), ear.z)};
}

// The places of a source from which it may be heard: the nearest point, and of an area then places near its corners,
// nearest first.
std::vector<Position> places_of(const SoundSource& source, const Position& ear) {
    const Box& box = source.box;
    std::vector<Position> found;
    found.reserve(kMostLinesOfASource);
    found.push_back(is_liquid(source.sound) ? over_middle(box, ear) : nearest_point(box, ear));
    if (box.mins == box.maxs) return found;
    for (const auto& [x, y] : {std::pair{1, 1}, {1, 7}, {7, 1}, {7, 7}})
        found.push_back(
            {box.mins.x + scaled(box.size(), x, 8).x, box.mins.y + scaled(box.size(), y, 8).y, found.front().z});
    std::stable_sort(found.begin() + 1, found.end(),
                     [&](const auto& a, const auto& b) { return length_of(a - ear) < length_of(b - ear); });
    return found;
}

std::int32_t loudness(const VoiceLevels& levels) {
    return levels.left_256 + levels.right_256;
}

struct Heard {
    const SoundSource* source;
    VoiceLevels levels;
};

constexpr auto is_louder = [](const auto& a, const auto& b) { return loudness(a.levels) > loudness(b.levels); };

class Hearing {
  public:
    Hearing(const GameLevel& level, const GameState& state, const Listener& listener, HeardFrom& heard_from)
        : level_(level), state_(state), listener_(listener), heard_from_(heard_from) {}

    void add(const Heard& heard) {
        const SoundSource& source = *heard.source;
        AudibleSound sound{
            source.sound, source.variant, source.serial, levels_of(heard), direction_to(source, listener_), source.own};
        sound.levels.is_muffled |= listener_.is_under_water && source.sound != Sound::UnderWater;
        audible_.sounds.push_back(sound);
    }

    // Adds the sources of one loop: the loudest one gives the direction and muffling, the others can raise the level of
    // each side.
    void add_loop(std::span<Heard> sources) {
        std::stable_sort(sources.begin(), sources.end(), is_louder);
        const std::size_t count = std::min(sources.size(), kMostSourcesOfALoop), first = audible_.sounds.size();
        for (std::size_t i = 0; i < count; ++i) add(sources[i]);
        const auto all = std::span(audible_.sounds).subspan(first);
        AudibleSound loop = *std::min_element(all.begin(), all.end(), is_louder);
        for (const AudibleSound& one : all) {
            loop.levels.left_256 = std::max(loop.levels.left_256, one.levels.left_256);
            loop.levels.right_256 = std::max(loop.levels.right_256, one.levels.right_256);
        }
        audible_.sounds.resize(first);
        audible_.sounds.push_back(loop);
    }

    Audible result() && {
        std::erase_if(audible_.sounds, [](const auto& sound) { return loudness(sound.levels) < kFaintest_256; });
        std::stable_sort(audible_.sounds.begin(), audible_.sounds.end(), is_louder);
        if (audible_.sounds.size() > kMostAudible) audible_.sounds.resize(kMostAudible);
        return std::move(audible_);
    }

  private:
    // The line ends 4 units before the source.
    bool is_in_sight(const SoundSource& source, const Position& place) {
        const Vec3<World> way = place - listener_.ear;
        const World distance = length_of(way);
        if (distance <= kInReach) return true;
        ++audible_.traces;
        const Position end = listener_.ear + scaled(way, distance - World::from_int(4), distance);
        return is_clear(level_, state_, listener_.ear, end, source.model);
    }

    // The first place in sight; their count if there is none.
    std::size_t place_in_sight(const SoundSource& source, const std::vector<Position>& found) {
        const bool is_loop = source.serial == 0;
        if (is_loop)
            if (const auto known = heard_from_.place_of(source)) return *known;
        std::size_t place = 0;
        while (place < found.size() && !is_in_sight(source, found[place])) ++place;
        if (is_loop) heard_from_.note(source, place);
        return place;
    }

    // The levels from that place.
    VoiceLevels levels_of(const Heard& heard) {
        const SoundSource& source = *heard.source;
        if (row_of(source.sound).range == 0) return heard.levels;
        const std::vector<Position> found = places_of(source, listener_.ear);
        const std::size_t place = place_in_sight(source, found);
        if (place == 0) return heard.levels;
        if (place < found.size()) {
            SoundSource part = source;
            part.box = {found[place], found[place]};
            return levels_at(part, listener_);
        }
        VoiceLevels levels = heard.levels.times_256(source.sound == Sound::Wind ? kBlockedWind_256 : kBlockedGain_256);
        levels.is_muffled = true;
        return levels;
    }

    const GameLevel& level_;
    const GameState& state_;
    const Listener& listener_;
    HeardFrom& heard_from_;
    Audible audible_;
};

bool stops_line(const Level& bsp, ModelIndex model, const Position& from, const Position& to) {
    const TraceResult result = trace_hull(bsp, bsp.models[model], Hull::Point, from, to);
    return result.is_hit || result.is_all_solid;
}

// Whether a model has holes all around; what shows nothing is none.
bool is_fence(const GameLevel& level, ModelIndex model) {
    const IndexRange<Face> faces = level.model(model).faces;
    for (const FaceIndex face : faces)
        if (!has_holes(level.bsp->texture_of(level.bsp->faces[face]).name)) return false;
    return faces.count > 0;
}

}  // namespace

void HeardFrom::start() {
    ++time_;
    std::erase_if(known_, [this](const Known& known) { return time_ - known.time >= kTimes; });
}

std::optional<std::size_t> HeardFrom::place_of(const SoundSource& source) const {
    for (const Known& known : known_)
        if (known.sound == source.sound && known.box.mins == source.box.mins && known.box.maxs == source.box.maxs)
            return known.place;
    return {};
}

void HeardFrom::note(const SoundSource& source, std::size_t place) {
    known_.push_back({source.sound, source.box, place, time_});
}

Listener listener_of(const Player& player) {
    return {player.position + world_vector(0, 0, kEyeHeight), player.yaw, player.depth == Depth::Eyes};
}

VoiceLevels levels_at(const SoundSource& source, const Listener& listener) {
    const SoundRow& row = row_of(source.sound);
    if (row.range == 0) return {row.gain_256, row.gain_256, false};
    const Vec3<World> way = nearest_point(source.box, listener.ear) - listener.ear;
    const World distance = length_of(way), range = World::from_int(row.range);
    if (distance >= range) return {};
    const std::int64_t nearness_16 = kOne_16 - convert<WorldWide>(distance) * kOne_16 / convert<WorldWide>(range);
    const std::int64_t gain_16 = nearness_16 * nearness_16 / kOne_16 * row.gain_256 / 256;
    const std::int64_t pan_16 = part_along_16(way, distance, listener.yaw - kQuarterTurn) * kMostPan_16 / kOne_16;
    const auto level = [&](std::int64_t share_16) {
        return static_cast<std::int32_t>(gain_16 * root_of_16(share_16) / kOne_16 * 256 / kOne_16);
    };
    return {level((kOne_16 - pan_16) / 2), level((kOne_16 + pan_16) / 2), false};
}

bool is_clear(const GameLevel& level, const GameState& state, const Position& from, const Position& to,
              ModelIndex except) {
    if (stops_line(*level.bsp, kWorldModel, from, to)) return false;
    const Box line = Box{from, from}.united({to, to});
    for (const std::uint32_t i : level.boxes.obstacles.part_overlapping(line).numbers) {
        const std::optional<Obstacle> obstacle = obstacle_of(level, state, i);
        if (!obstacle || obstacle->model == except) continue;
        const auto& [model, offset] = *obstacle;
        if (!obstacle_box(level, model, offset).overlaps(line)) continue;
        if (!is_fence(level, model) && stops_line(*level.bsp, model, from - offset, to - offset)) return false;
    }
    return true;
}

Audible audible_sounds(const GameLevel& level, const GameState& state, const Listener& listener,
                       std::span<const SoundSource> sources, HeardFrom& heard_from) {
    std::array<std::vector<Heard>, kSoundCount> loops;
    Hearing hearing(level, state, listener, heard_from);
    for (const SoundSource& source : sources) {
        const Heard heard{&source, levels_at(source, listener)};
        if (loudness(heard.levels) < kFaintest_256) continue;
        if (row_of(source.sound).is_loop())
            item(loops, source.sound).push_back(heard);
        else
            hearing.add(heard);
    }
    for (std::vector<Heard>& loop : loops)
        if (!loop.empty()) hearing.add_loop(loop);
    return std::move(hearing).result();
}

}  // namespace oblong
