#include <algorithm>
#include <map>

#include "engine/level/bsp_read.h"
#include "tests/game/scenario.h"
#include "tests/support/folders.h"
#include "tests/support/toy_text.h"

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

/// Perhaps many, "5x" before the class.
void add_entities(Words words, std::vector<EntityText>& entities) {
    const bool are_many = words.at(1).ends_with('x') && std::isdigit(static_cast<unsigned char>(words[1][0])) != 0;
    const int count = are_many ? std::stoi(words[1]) : 1;
    if (are_many) words.erase(words.begin() + 1);
    for (int i = 0; i < count; ++i) {
        Words numbered(words.begin() + 1, words.end());
        for (std::string& word : numbered) word = with_number(word, i);
        entities.emplace_back(numbered);
    }
}

/// What many scenarios target: a counter of 100, a door far away, a light.
const std::map<std::string, const char*> kUsualTargets{
    {"count", "trigger_counter targetname=count count=100"},
    {"door", "func_door 1000 0 0 1010 100 100 angle=-1 targetname=door wait=-1"},
    {"light", "light targetname=light style=32"}};

/// Adds those of them that are targeted and not there, before all others.
void add_usual_targets(std::vector<EntityText>& entities) {
    for (const auto& [name, text] : kUsualTargets) {
        const auto is_value_of = [&, value = name](const std::string& key) {
            return std::any_of(entities.begin(), entities.end(), [&](const EntityText& line) {
                return std::find(line.pairs.begin(), line.pairs.end(), std::pair(key, value)) != line.pairs.end();
            });
        };
        if ((is_value_of("target") || is_value_of("target2")) && !is_value_of("targetname"))
            entities.insert(entities.begin(), EntityText(words_of(text)));
    }
}

}  // namespace

ToyLevel level_of(const std::vector<Words>& texts) {
    std::vector<EntityText> lines;
    for (const Words& words : texts) add_entities(words, lines);
    add_usual_targets(lines);
    std::int32_t water_z = -30'000, liquid = contents::kWater;
    const std::map<std::string, std::int32_t> liquids{
        {"water", contents::kWater}, {"slime", contents::kSlime}, {"lava", contents::kLava}};
    std::vector<Solid> world = floor_and({});
    for (const EntityText& line : lines) {
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
    for (const EntityText& line : lines) {
        if (liquids.contains(line.its_class) || line.its_class == "no_floor" || line.its_class == "solid") continue;
        add_entity(toy, line);
    }
    return toy;
}

}  // namespace oblong::test
