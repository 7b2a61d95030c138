#pragma once

#include <string>
#include <vector>

#include "tests/game/logic_level.h"
#include "tests/support/script.h"

namespace oblong::test {

/// An entity of a toy level by its words: its class, the box of its brush if it has one, and its keys. Values in quotes
/// may have spaces: `func_door 200 -64 0 216 64 128 angle=-1 message="Hm, no"`.
struct EntityText {
    explicit EntityText(const Words& words) : its_class(words.at(0)) {
        for (std::size_t i = 1; i < words.size(); ++i)
            if (const std::size_t sign = words[i].find('='); sign != std::string::npos)
                pairs.emplace_back(words[i].substr(0, sign), words[i].substr(sign + 1));
            else
                numbers.push_back(std::stoi(words[i]));
    }
    Solid box() const {
        return {numbers.at(0), numbers.at(1), numbers.at(2), numbers.at(3), numbers.at(4), numbers.at(5)};
    }

    std::string its_class;
    std::vector<std::int32_t> numbers;
    Pairs pairs;
};

inline void add_entity(ToyLevel& toy, const EntityText& text) {
    Pairs pairs{{"classname", text.its_class}};
    pairs.insert(pairs.end(), text.pairs.begin(), text.pairs.end());
    if (!text.numbers.empty()) {
        pairs.emplace_back("model", "*" + std::to_string(toy.level.models.count()));
        toy.add_model({text.box()});
    }
    toy.add_entity(std::move(pairs));
}

}  // namespace oblong::test
