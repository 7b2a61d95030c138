#include <algorithm>
#include <utility>

#include "engine/base/input_error.h"
#include "engine/base/text.h"
#include "game/simulation/entity_specs.h"
#include "game/simulation/level_builder.h"

namespace oblong {
namespace {

constexpr std::size_t kMostKeys = 31;

}  // namespace

// The target of a name; a new one if the name has none yet.
Target& LevelBuilder::target_named(const std::string& its_name) {
    const auto [found, is_new] = target_of_.emplace(its_name, static_cast<TargetIndex>(level_.targets.size()));
    if (is_new) level_.targets.emplace_back();
    return item(level_.targets, found->second);
}

// Registers the last of `count` things of a kind under an entity's targetname.
void LevelBuilder::name(const Entity& entity, EntityRef::Kind kind, std::size_t count) {
    if (const std::string its_name = entity.value("targetname"); !its_name.empty())
        target_named(its_name).entities.push_back({kind, static_cast<std::uint32_t>(count - 1)});
}

TargetIndex LevelBuilder::target_of(const Entity& entity, const char* key) const {
    const auto found = target_of_.find(entity.value(key));
    return found == target_of_.end() ? kNoTarget : found->second;
}

// What has two targets activates a third one, of the first's entities and then of the second's, which is made once.
// Beyond a million entities in all of these, second targets are left out.
TargetIndex LevelBuilder::both_targets_of(const Entity& entity) {
    const TargetIndex first = target_of(entity, "target"), second = target_of(entity, "target2");
    if (first == kNoTarget || second == kNoTarget) return std::max(first, second);
    const auto [found, is_new] =
        both_of_.emplace(std::pair(first, second), static_cast<TargetIndex>(level_.targets.size()));
    if (!is_new) return found->second;
    Target both = item(level_.targets, first);
    const Target& other = item(level_.targets, second);
    constexpr std::size_t kMost = std::size_t{1} << 20;
    targets_of_both_ += both.entities.size() + other.entities.size();
    if (targets_of_both_ > kMost) return found->second = first;
    both.entities.insert(both.entities.end(), other.entities.begin(), other.entities.end());
    both.light_styles ^= other.light_styles;
    level_.targets.push_back(std::move(both));
    return found->second;
}

// Needs all names, so it is called after all entities are added.
Firing LevelBuilder::firing_of(const Entity& entity, std::string_view usual_message) {
    Firing firing;
    firing.target = both_targets_of(entity);
    firing.removed = target_of(entity, "killtarget");
    firing.delay_ticks = std::max(0, ticks_of(entity, "delay"));
    std::string text = level_text(entity.value("message"));
    firing.message = message(text.empty() ? std::string(usual_message) : std::move(text));
    return firing;
}

// The bit of a key's name; a new one if no key or door had it yet, 0 for an empty one.
std::uint32_t LevelBuilder::key_named(const std::string& its_name) {
    const std::string name = level_text(its_name);
    if (name.empty()) return 0;
    std::vector<std::string>& names = level_.key_names;
    const auto found = std::find(names.begin(), names.end(), name);
    const auto bit = found - names.begin();
    if (found == names.end()) names.push_back(name);
    if (names.size() > kMostKeys) throw InputError("entities", "more than 31 names of keys, expected no more");
    return std::uint32_t{1} << bit;
}

// Equal messages are stored once. As in Quake, backslash n is a new line; backslash p begins a page.
MessageIndex LevelBuilder::message(std::string text) {
    if (text.empty()) return kNoMessage;
    for (const auto& [written, meant] : {std::pair{"\\n", '\n'}, {"\\p", kNewPage}})
        for (std::size_t at = text.find(written); at != std::string::npos; at = text.find(written, at))
            text.replace(at, 2, 1, meant);
    const auto [found, is_new] = message_of_.emplace(text, static_cast<MessageIndex>(level_.messages.size()));
    if (is_new) level_.messages.push_back(std::move(text));
    return found->second;
}

}  // namespace oblong
