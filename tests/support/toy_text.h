#pragma once

#include <string>
#include <vector>

#include "tests/game/logic_level.h"
#include "tests/support/script.h"

namespace oblong::test {

/// Adds an entity to a toy level by its words: its class, the box of its brush if it has one, and its keys. Values in
/// quotes may have spaces: `func_door 200 -64 0 216 64 128 angle=-1 message="Hm, no"`.
inline void add_entity(ToyLevel& toy, const Words& words) {
    Pairs pairs{{"classname", words.at(0)}};
    std::vector<std::int32_t> box;
    for (std::size_t i = 1; i < words.size(); ++i)
        if (const std::size_t sign = words[i].find('='); sign != std::string::npos)
            pairs.emplace_back(words[i].substr(0, sign), words[i].substr(sign + 1));
        else
            box.push_back(std::stoi(words[i]));
    if (!box.empty()) {
        pairs.emplace_back("model", "*" + std::to_string(toy.level.models.count()));
        toy.add_model({{box.at(0), box.at(1), box.at(2), box.at(3), box.at(4), box.at(5)}});
    }
    toy.add_entity(std::move(pairs));
}

}  // namespace oblong::test
