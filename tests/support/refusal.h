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

/// That nothing but the whole is read: of each shorter prefix, down to none and up to `behind` bytes less, something is
/// said (`said_of`: the text for some bytes).
template <class Bytes, class Said>
void expect_no_prefix_is_read(const Bytes& whole, Said said_of, std::size_t behind = 0) {
    EXPECT_EQ(said_of(whole), "");
    for (std::size_t size = 0; size + behind < whole.size(); ++size)
        ASSERT_NE(said_of(Bytes(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size))), "") << size;
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
