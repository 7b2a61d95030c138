#pragma once

#include <string>

#include "engine/base/input_error.h"

namespace oblong::test {

/// "WHERE: what is wrong" of work that refuses its input; empty if it does not.
template <class Work>
std::string refusal(Work work) {
    try {
        work();
    } catch (const InputError& error) {
        return error.where + ": " + error.what();
    }
    return {};
}

}  // namespace oblong::test
