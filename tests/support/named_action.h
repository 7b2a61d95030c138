#pragma once

#include <stdexcept>
#include <string>

#include "game/input/bindings.h"

namespace oblong::test {

/// The action of a row's name, such as "walk-slowly".
inline Action action_named(const std::string& name) {
    for (const ActionRow& row : all_actions())
        if (row.name == name) return row.action;
    throw std::invalid_argument("no action " + name);
}

}  // namespace oblong::test
