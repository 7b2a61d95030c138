#pragma once

#include <gtest/gtest.h>

#include <string>

#include "engine/base/input_error.h"

namespace oblong::test {

/// What work that throws an Error says against its input; empty if it throws none. Of an InputError, the default, it is
/// "WHERE: what is wrong".
template <class Error = InputError, class Work>
std::string refusal(Work work) {
    try {
        work();
    } catch (const Error& error) {
        if constexpr (requires { error.where; })
            return error.where + ": " + error.what();
        else
            return error.what();
    }
    return {};
}

/// Where work finds fault with its input, for which it says a reason; empty if it does not.
template <class Work>
std::string place_of_refusal(Work work) {
    try {
        work();
    } catch (const InputError& error) {
        EXPECT_STRNE(error.what(), "");
        return error.where;
    }
    return {};
}

}  // namespace oblong::test
